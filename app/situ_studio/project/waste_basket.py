"""The system's waste basket: from there a person gets a file back that was deleted here."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QFile


def thrown_away(file: Path) -> bool:
    """Puts a file into the waste basket; False, and it stays, where the system has none for it."""
    return QFile(str(file)).moveToTrash()
