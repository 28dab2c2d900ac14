"""What all applications of one robot share: the board and its writers, the step, authority."""

from __future__ import annotations

import random
from collections.abc import Mapping
from typing import Any

from msgspec import Struct

from situ.decide import trace
from situ.decide.board import Board, Entry
from situ.decide.conditions import Conditions
from situ.decide.effects import Changed
from situ.decide.priorities import RUNTIME, Priorities
from situ.decide.step import Step
from situ.document.project import Project

KEPT = ("robot/", "module/", "application/")
BREAKPOINTS = "debugger.breakpoints"
PAUSED = "debugger.paused"
KEPT_TAGS = ("situation", "listen", BREAKPOINTS, PAUSED)
_UNTRACED = (*KEPT, "clock.")


def untraced(tag: str) -> bool:
    """Whether a write of this tag stands in no trace: the runtime itself keeps it."""
    return tag in KEPT_TAGS or tag.startswith(_UNTRACED)


def refusal(tag: str, writer: str) -> str | None:
    """Why this writer may not set the tag, and what to do; None where it may."""
    if "/" not in tag and tag not in KEPT_TAGS:
        return None
    if tag.startswith(f"module/{writer}/"):
        return None
    if tag.startswith("robot/"):
        return f"{tag} may not be set: only the priority management writes there; use a command"
    if tag.startswith("module/"):
        return f"{tag} belongs to another module than {writer}; set a tag of your own"
    if tag in KEPT_TAGS or tag.startswith("application/"):
        return f"{tag} is kept by the runtime; set a tag of your own"
    return None


class WorldState(Struct):
    """raised: how many events have been raised; ids: of actions. random: its whole state."""

    raised: int = 0
    ids: int = 0
    random: tuple[Any, ...] = ()


class World:
    """The blackboard with its rules of writing, and the services that applications use."""

    def __init__(self, project: Project) -> None:
        self.project = project
        self.step = Step()
        self.board = Board()
        self.conditions = Conditions(self.board, self.step)
        self.priorities = Priorities(self.step, self.keep)
        self.state = WorldState()
        self.random = random.Random(0)
        self.auto_finish: int | None = None

    def deploy(self, project: Project) -> None:
        """Goes on with another project: blackboard, time and authority stay, conditions and
        listeners are to be made anew.
        """
        self.project = project
        self.board.listeners.clear()
        self.conditions = Conditions(self.board, self.step)

    def keep(self, tag: str, value: Any, writer: str, cause: int | None) -> None:
        """Writes what the runtime itself keeps; it stands in no trace."""
        now = self.step.now
        version = self.board.write(tag, value, writer, now, cause)
        if version:
            self.step.effects.append(Changed(tag, value, version, writer, now))
            self.board.tell(tag, cause)

    def write(self, tags: Mapping[str, Any], writer: str, cause: int | None) -> None:
        """One write of several tags, each traced; all are written before anybody is told.

        What the writer may not set is refused with an ``error`` and left as it is.
        """
        step, told = self.step, []
        for tag, value in tags.items():
            refused = refusal(tag, writer)
            if refused is not None:
                step.error(cause, refused, writer)
                continue
            seq = cause if untraced(tag) else step.seq + 1
            version = self.board.write(tag, value, writer, step.now, seq)
            if version:
                if seq is not cause:
                    step.trace(trace.Data, cause, tag, value, writer, version)
                told.append((tag, seq))
                step.effects.append(Changed(tag, value, version, writer, step.now))
        for tag, seq in told:
            self.board.tell(tag, seq)

    def restore(self, entries: Mapping[str, tuple[Any, int, str]]) -> None:
        """What durable tags held in the run before, as one write: versions count on, writers stay.

        A deleted one (value None) stands in no trace: nothing changes by it.
        """
        step, told = self.step, []
        for tag in sorted(entries):
            value, version, writer = entries[tag]
            entry = self.board.state[tag] = Entry(value, version, writer, step.now, None)
            if value is not None:
                entry.cause = step.trace(trace.Data, None, tag, value, writer, version)
                told.append((tag, entry.cause))
                step.effects.append(Changed(tag, value, version, writer, step.now))
        for tag, seq in told:
            self.board.tell(tag, seq)

    def keep_if_new(self, tag: str, value: Any, cause: int | None) -> None:
        """``keep`` where the value differs from what stands there."""
        entry = self.board.get(tag)
        if entry is None or entry.value != value:
            self.keep(tag, value, RUNTIME, cause)

    def next_id(self) -> int:
        self.state.ids += 1
        return self.state.ids

    def next_raise(self) -> int:
        self.state.raised += 1
        return self.state.raised
