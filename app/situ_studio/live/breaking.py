"""Where breakpoints stand: what a selected place means, and what was set in a project before. No Qt
but for its settings.
"""

from __future__ import annotations

from typing import Any

import msgspec
from PySide6.QtCore import QSettings

from situ.document import when_text
from situ.document.condition import Condition
from situ.document.project import Project
from situ_studio.commands.context_menus import context_of
from situ_studio.edits import places
from situ_studio.edits.edit import Document, Place
from situ_studio.live.views import runs_of

Point = dict[str, Any]
"""A breakpoint as the tag ``debugger.breakpoints`` has it; what is None is left out."""

WHERE = ("application", "state", "from", "to", "situation")
KEPT = "breakpoints"
"""Where the settings keep them: by the project's folder."""
MOST = 50
"""Projects of which they are kept."""


def point_of(one: Point) -> Point:
    """Where a breakpoint stands, without who set it and what must hold."""
    return {key: one[key] for key in WHERE if one.get(key) is not None}


def condition_of(one: Point) -> Condition | None:
    """What must hold where it pauses; None: it pauses always."""
    found = when_text.read(one["when"]) if one.get("when") else None
    return found if isinstance(found, Condition) else None


def points_at(project: Project, file: str, document: Document, place: Place) -> list[Point]:
    """What a selected place of a document means: of a part in each state that runs it."""
    if place[:1] == ("situation",) and len(place) == 2:
        return [{"situation": place[1]}]
    if place[:1] != ("state",):
        return []
    runs = runs_of(project).get(file, ())
    if len(place) == 2:
        return [{"application": name, "state": before + place[1]} for name, before in runs]
    if context_of((place,)) != "exit":
        return []
    to = getattr(places.get(document, place), "next", None)
    found = []
    for name, before in runs:
        point = {"application": name, "from": before + place[1]}
        found.append(point if not to or to.startswith("#") else {**point, "to": before + to})
    return found


def everywhere(project: Project, point: Point) -> list[Point]:
    """The breakpoint's place in every state that runs its part, itself too; of one that is in no
    part itself only.
    """
    path = point.get("state") or point.get("from") or ""
    before = path.rpartition("/")[0]
    if not before:
        return [point]
    before += "/"
    application = point["application"]
    for runs in runs_of(project).values():
        if (application, before) in runs:
            return [_moved(point, before, name, there) for name, there in runs]
    return [point]


def _moved(point: Point, before: str, application: str, there: str) -> Point:
    paths: Point = {
        key: there + point[key].removeprefix(before)
        for key in ("state", "from", "to")
        if key in point
    }
    return {**point, **paths, "application": application}


class KeptBreakpoints:
    """What a person has set in each project, on whichever robot; in the studio's settings."""

    def __init__(self, settings: QSettings) -> None:
        self._settings = settings

    def of(self, root: str) -> list[Point]:
        return self._every().get(root, [])

    def add(self, root: str, point: Point) -> None:
        """In place of one that stands there. point: with its ``when``, if it has one."""
        others = [one for one in self.of(root) if point_of(one) != point_of(point)]
        self._keep(root, [*others, point])

    def remove(self, root: str, point: Point) -> None:
        self._keep(root, [one for one in self.of(root) if point_of(one) != point_of(point)])

    def clear(self, root: str) -> None:
        self._keep(root, [])

    def _every(self) -> dict[str, list[Point]]:
        text = self._settings.value(KEPT, "")
        try:
            return msgspec.json.decode(str(text), type=dict[str, list[Point]]) if text else {}
        except msgspec.MsgspecError:
            return {}

    def _keep(self, root: str, points: list[Point]) -> None:
        every = {one: kept for one, kept in self._every().items() if one != root}
        if points:
            every[root] = points
        kept = dict(list(every.items())[-MOST:])
        self._settings.setValue(KEPT, msgspec.json.encode(kept).decode())
