"""A project's files on disk: opened, saved, kept for recovery, renamed, changed by others."""
