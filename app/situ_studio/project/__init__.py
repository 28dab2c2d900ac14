"""The open project: its documents, its undo stack, what its folder holds. One session a project."""
