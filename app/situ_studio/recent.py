"""The projects that were open lately, as the settings keep them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from PySide6.QtCore import QSettings

MOST = 8


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
