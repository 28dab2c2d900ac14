"""The views that a document has, and what a window shows of them."""
