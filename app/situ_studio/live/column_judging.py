"""Which tests of a condition hold at a moment, judged by the robot's own conditions. No Qt."""

from __future__ import annotations

from situ.decide.board import Board
from situ.decide.conditions import Conditions
from situ.decide.step import Step, microseconds
from situ.document.condition import Condition, Group, Test
from situ_studio.live.moment import Entry, Moment


class Judging:
    """Of one condition, part by part."""

    def __init__(self, condition: Condition) -> None:
        self.condition = condition
        self._board, self._clock = Board(), Step()
        compiled = Conditions(self._board, self._clock)
        self._parts = [
            None if _counts(part) else compiled.compile(Condition(children=(part,)), None)
            for part in condition.children
        ]
        self._told: dict[str, Entry] = {}

    def holds(self, moment: Moment, t: float) -> list[bool | None]:
        """Each part of it at ``t`` seconds; None: it has a ``for``, which no moment alone tells."""
        board, told = self._board, self._told
        for tag in told.keys() - moment.board.keys():
            board.write(tag, None, "", 0, None)
            del told[tag]
        for tag, entry in moment.board.items():
            if told.get(tag) is not entry:
                told[tag] = entry
                board.write(tag, entry.value, "", microseconds(entry.t), None)
        self._clock.begin(microseconds(t))
        return [None if part is None else part() for part in self._parts]


def _counts(part: Test | Group) -> bool:
    if isinstance(part, Group):
        return any(map(_counts, part.children))
    return part.hold is not None
