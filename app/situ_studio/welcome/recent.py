"""What was used lately, as the settings keep it: projects, and commands."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path
from typing import Any

from PySide6.QtCore import QDate, QLocale, QSettings

from situ_studio.wording.language import tr

MOST = 8
TIMES = "recent_times"
COMMANDS = "commands_used"


def recent(settings: QSettings) -> list[str]:
    """Their folders, the last one first; those too that are not there any more."""
    found: Any = settings.value("recent", [])
    return [found] if isinstance(found, str) else list(found or [])


def opened(settings: QSettings) -> dict[str, datetime]:
    """When each of them was opened last, as far as that is known."""
    kept: Any = settings.value(TIMES, {})
    found = {}
    for path, text in (kept or {}).items():
        try:
            found[path] = datetime.fromisoformat(text)
        except (TypeError, ValueError):
            continue
    return found


def remember(settings: QSettings, path: Path, at: datetime) -> None:
    """It was open last. at: when that was."""
    there = str(path.resolve())
    every = [there, *(p for p in recent(settings) if p != there)][:MOST]
    settings.setValue("recent", every)
    times = opened(settings) | {there: at}
    settings.setValue(TIMES, {p: times[p].isoformat() for p in every if p in times})


def forget(settings: QSettings, path: str) -> None:
    settings.setValue("recent", [p for p in recent(settings) if p != path])


def move(settings: QSettings, path: str, to: Path) -> None:
    """The project lies in another folder now."""
    there = str(to.resolve())
    every = [there if p == path else p for p in recent(settings)]
    settings.setValue("recent", list(dict.fromkeys(every)))


def ago(at: datetime, now: datetime) -> str:
    """How long ago that was, in words; the date where it is more than a week."""
    seconds = (now - at).total_seconds()
    minutes, hours, days = int(seconds // 60), int(seconds // 3600), (now.date() - at.date()).days
    if minutes < 1:
        return tr("just now")
    if hours < 1:
        return tr("a minute ago") if minutes == 1 else tr("{0} minutes ago").format(minutes)
    if days < 1 or hours < 6:
        return tr("an hour ago") if hours == 1 else tr("{0} hours ago").format(hours)
    if days < 7:
        return tr("yesterday") if days == 1 else tr("{0} days ago").format(days)
    return QLocale().toString(QDate(at.year, at.month, at.day), QLocale.FormatType.ShortFormat)


def commands(settings: QSettings) -> list[str]:
    """The ids of the commands that were used lately, the last one first."""
    found: Any = settings.value(COMMANDS, [])
    return [found] if isinstance(found, str) else list(found or [])


def used(settings: QSettings, id: str) -> None:
    """This command was used last."""
    every = [id, *(one for one in commands(settings) if one != id)]
    settings.setValue(COMMANDS, every[:MOST])
