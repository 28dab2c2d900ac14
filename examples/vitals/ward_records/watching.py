"""What the robot's camera sees while it is with somebody who has fallen, for the nurse's page.

Nothing is kept: a picture is replaced by the next one, and gone when none comes any more.
"""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime, timedelta

from msgspec import Struct

KINDS = ("image/jpeg", "image/png", "image/svg+xml")

GONE, WATCHED = timedelta(seconds=10), timedelta(seconds=4)
"""So long after the last picture there is none; so long after the last look nobody looks."""


class Picture(Struct, frozen=True):
    """kind: its media type, one of ``KINDS``."""

    kind: str
    content: bytes


class _View(Struct):
    picture: Picture
    at: datetime
    looked: datetime | None = None
    ended: bool = False


class Watching:
    """By room."""

    def __init__(self, now: Callable[[], datetime]) -> None:
        self._now = now
        self._views: dict[str, _View] = {}

    def show(self, room: str, picture: Picture) -> dict[str, bool]:
        """From the robot. ``watched``: a nurse looks; ``ended``: she has ended it, told once."""
        view, now = self._view(room), self._now()
        if view is None:
            view = self._views[room] = _View(picture, now)
        view.picture, view.at = picture, now
        if view.ended:
            del self._views[room]
        watched = view.looked is not None and _is_fresh(now - view.looked, WATCHED)
        return {"watched": watched and not view.ended, "ended": view.ended}

    def look(self, room: str) -> Picture | None:
        """By a nurse."""
        view = self._view(room)
        if view is None:
            return None
        view.looked = self._now()
        return view.picture

    def end(self, room: str) -> None:
        """Help is there: the robot may go."""
        view = self._view(room)
        if view is not None:
            view.ended = True

    def rooms(self) -> list[str]:
        """Where there is something to be seen."""
        self._forget()
        return sorted(self._views)

    def _view(self, room: str) -> _View | None:
        self._forget()
        return self._views.get(room)

    def _forget(self) -> None:
        now = self._now()
        self._views = {
            room: view for room, view in self._views.items() if _is_fresh(now - view.at, GONE)
        }


def _is_fresh(age: timedelta, most: timedelta) -> bool:
    # Younger than nothing: the clock was set back.
    return timedelta(0) <= age < most
