"""Drawings outside of the window: as SVG, PDF and PNG, and on paper."""
