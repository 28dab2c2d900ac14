"""What ran at a moment of the run that is looked at: the robot's own documents, not the open ones.

A recording has those that ran in it, a rehearsal those that it was begun with and took in; a robot
is asked for its own, at first and after each deploy.
"""

from __future__ import annotations

from bisect import bisect_right
from typing import TYPE_CHECKING

from msgspec import Struct

from situ.document import folder
from situ.document.project import Project

if TYPE_CHECKING:
    from situ_studio.rehearsing.course import Course
    from situ_studio.window.main_window import MainWindow

KEPT = 8
"""Versions that are kept read."""


class Ran(Struct, frozen=True):
    """project: to be asked; own: whether it is the robot's, else the open one stands in for it.

    differs: it is the robot's, and not what is open.
    """

    project: Project
    own: bool
    differs: bool = False


class WhatRan:
    """Of one window."""

    def __init__(self, window: MainWindow) -> None:
        self._window = window
        self._read: list[tuple[dict[str, str], Project | None]] = []

    @property
    def course(self) -> Course | None:
        """The rehearsal that is looked at; None where that is a robot or a recording."""
        running = self._window.rehearsing.running
        log = self._window.robot.follower.viewing.log
        return running.course if running is not None and log is running.course.log else None

    def project(self, t: float) -> Project | None:
        """As ``at``, without comparing it with what is open."""
        return self._project(t) or self._window.session.project

    def at(self, t: float) -> Ran | None:
        """What ran then; None where no project is open."""
        mine = self._window.session.project
        if mine is None:
            return None
        own = self._project(t)
        if own is None:
            return Ran(mine, False)
        return Ran(own, True, differs=not _alike(own, mine))

    def _project(self, t: float) -> Project | None:
        """Where it is known."""
        robot, course = self._window.robot, self.course
        log = robot.follower.viewing.log
        turns = log.lanes.deployed
        turned = bisect_right(turns, t, key=lambda one: one.t)
        now = turns[turned - 1] if turned else None
        if course is not None:
            return course.version(0 if now is None else now.version)
        recording = robot.recording
        if recording is not None and log is recording.log:
            if recording.ran is not None:
                return recording.ran
            files = recording.files if now is None else recording.versions.get(now.version)
            return self._of(files) if files else None
        if log is not robot.link.log:
            return None
        begins = 0 if now is None else now.seq
        ends = turns[turned].seq if turned < len(turns) else log.seq + 1
        asked = [files for seq, files in robot.link.known if begins <= seq < max(ends, begins + 1)]
        return self._of(asked[-1]) if asked else None

    def _of(self, files: dict[str, str]) -> Project | None:
        for known, project in self._read:
            if known is files:
                return project
        project, _ = folder.load_texts(files)
        self._read = [*self._read[1 - KEPT :], (files, project)]
        return project


def _alike(one: Project, other: Project) -> bool:
    """Whether their documents are: what only an editor needs does not count."""
    return (
        one.applications == other.applications
        and one.parts == other.parts
        and one.spds == other.spds
        and one.modules == other.modules
    )
