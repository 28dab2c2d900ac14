"""The screen designer: a robot's screen to scale, changed with mouse and keys."""
