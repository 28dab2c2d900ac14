"""The panels round the canvas: one a file."""
