"""The help: its texts, its window, F1, and the tutorial."""
