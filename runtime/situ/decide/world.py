"""What all applications of one robot share: the board and its writers, the step, authority."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping
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
KEPT_TAGS = ("situation", "listen")


def untraced(tag: str) -> bool:
    """Whether a write of this tag stands in no trace: the runtime itself keeps it."""
    return tag in KEPT_TAGS or tag.startswith((*KEPT, "clock."))


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

    def __init__(self, project: Project, priorities: Callable[[], Mapping[str, int]]) -> None:
        self.project = project
        self.step = Step()
        self.board = Board()
        self.conditions = Conditions(self.board, self.step)
        self.priorities = Priorities(self.step, self.keep, priorities)
        self.state = WorldState()
        self.random = random.Random(0)
        self.auto_finish: int | None = None

    def keep(self, tag: str, value: Any, writer: str, cause: int | None) -> None:
        """Writes what the runtime itself keeps; it stands in no trace."""
        entry = self.board.write(tag, value, writer, self.step.now)
        if entry is not None:
            entry.cause = cause
            self.step.effects.append(Changed(tag, value, entry.version, writer, self.step.now))
            self.board.tell({tag: cause})

    def write(self, tags: Mapping[str, Any], writer: str, cause: int | None) -> int | None:
        """One write of several tags, each traced; gives the seq of the last (None: no change).

        What the writer may not set is refused with an ``error`` and left as it is.
        """
        told: dict[str, int | None] = {}
        last: int | None = None
        for tag, value in tags.items():
            refused = refusal(tag, writer)
            if refused is not None:
                self.step.error(cause, refused, writer)
                continue
            entry = self.board.write(tag, value, writer, self.step.now)
            if entry is None:
                continue
            seq = cause
            if not untraced(tag):
                seq = last = self.step.trace(trace.Data, cause, tag, value, writer, entry.version)
            entry.cause = told[tag] = seq
            self.step.effects.append(Changed(tag, value, entry.version, writer, self.step.now))
        self.board.tell(told)
        return last

    def restore(self, entries: Mapping[str, tuple[Any, int, str]]) -> None:
        """What durable tags held in the run before, as one write: versions count on, writers stay.

        A deleted one (value None) stands in no trace: nothing changes by it.
        """
        told: dict[str, int | None] = {}
        for tag in sorted(entries):
            value, version, writer = entries[tag]
            entry = Entry(value, version, writer, self.step.now, None)
            self.board.state[tag] = entry
            if value is not None:
                seq = self.step.trace(trace.Data, None, tag, value, writer, version)
                entry.cause = told[tag] = seq
                self.step.effects.append(Changed(tag, value, version, writer, self.step.now))
        self.board.tell(told)

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
