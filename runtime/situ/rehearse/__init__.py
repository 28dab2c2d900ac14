"""Rehearsing without a robot: scenarios and virtual time. Pure but for reading files."""
