"""The tags of the time of day, which the runtime keeps (formats.md, *Blackboard*)."""

from __future__ import annotations

from datetime import datetime

CLOCK = "clock."
TIME, DATE, WEEKDAY = "clock.time", "clock.date", "clock.weekday"
_WEEKDAYS = ("monday", "tuesday", "wednesday", "thursday", "friday", "saturday", "sunday")


def tags_at(local: datetime) -> dict[str, str]:
    """What stands at them at a time of the robot's own time zone."""
    return {
        TIME: f"{local:%H:%M}",
        DATE: f"{local:%Y-%m-%d}",
        WEEKDAY: _WEEKDAYS[local.weekday()],
    }
