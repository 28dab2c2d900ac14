"""Where a robot is, told on the blackboard as the bundled adapters tell it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

EVERY = 0.5
"""Seconds between two reports of where the robot is, while it moves."""


class Reports:
    """Reports what has changed since the last report, to the hundredth.

    When the robot first moves, all: on the blackboard may stand where it was before it was
    started anew.
    """

    def __init__(self, report: Callable[[dict[str, Any]], None]) -> None:
        self._report = report
        self._reported: dict[str, float] = {}

    def tell(self, places: Mapping[str, float]) -> None:
        """places: what is now, by tag."""
        tags = {tag: round(number, 2) + 0.0 for tag, number in places.items()}  # a zero has no sign
        changed = {tag: number for tag, number in tags.items() if self._reported.get(tag) != number}
        if changed and (self._reported or any(tags.values())):
            self._reported.update(changed)
            self._report(changed)
