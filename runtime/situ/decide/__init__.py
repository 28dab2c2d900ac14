"""The whole robot's decisions as one deterministic object without I/O (architecture, idea 2)."""
