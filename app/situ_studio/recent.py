"""What was used lately, as the settings keep it: projects, and commands."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from PySide6.QtCore import QSettings

MOST = 8
COMMANDS = "commands_used"


def recent(settings: QSettings) -> list[str]:
    """Their folders, the last one first; those too that are not there any more."""
    found: Any = settings.value("recent", [])
    return [found] if isinstance(found, str) else list(found or [])


def remember(settings: QSettings, path: Path) -> None:
    """It was open last."""
    there = str(path.resolve())
    every = [there, *(p for p in recent(settings) if p != there)]
    settings.setValue("recent", every[:MOST])


def forget(settings: QSettings, path: str) -> None:
    settings.setValue("recent", [p for p in recent(settings) if p != path])


def commands(settings: QSettings) -> list[str]:
    """The ids of the commands that were used lately, the last one first."""
    found: Any = settings.value(COMMANDS, [])
    return [found] if isinstance(found, str) else list(found or [])


def used(settings: QSettings, id: str) -> None:
    """This command was used last."""
    every = [id, *(one for one in commands(settings) if one != id)]
    settings.setValue(COMMANDS, every[:MOST])
