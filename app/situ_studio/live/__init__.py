"""A connected robot: the link, the log of its trace, and what both mean for the views."""
