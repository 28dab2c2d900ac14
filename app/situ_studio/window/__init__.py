"""The main window and its parts; what all windows have in common."""
