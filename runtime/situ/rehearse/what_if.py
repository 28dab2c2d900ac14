"""What if: which situation is current and who holds what, for values and requests as given.

The decide core's own situations, conditions and priorities, over a blackboard of its own. Every
value was set long ago and has just been set again, so that ``within`` and ``for`` both hold where
the value is right; nothing was current before, so no ``dwell``, ``until`` or ``limit`` keeps a
situation, and none has ended.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from msgspec import Struct

from situ.decide.all_ask import Holding, Requests, who_holds
from situ.decide.board import Board
from situ.decide.conditions import Conditions
from situ.decide.situations import Situations
from situ.decide.step import Step, duration
from situ.document.condition import Condition, Group, Test
from situ.document.spds import Spds
from situ.rehearse.scenario import WRITER


class Answer(Struct, frozen=True):
    """situation: the current one, None where none holds. holds: those whose condition holds, in
    precedence. holdings: by resource, of those that somebody asks for.
    """

    situation: str | None
    holds: tuple[str, ...]
    holdings: dict[str, Holding]


class Judged(Struct, frozen=True):
    """Positions among the situations: of the current one, and of those whose condition holds. They
    depend on conditions and values alone.
    """

    current: int | None
    holds: tuple[int, ...]


def what_if(script: Spds, values: Mapping[str, Any], asking: Mapping[str, Iterable[str]]) -> Answer:
    """values: name to value, None for a missing one. asking: module to what it asks for, in the
    order in which they ask. ``script`` has no errors in its conditions.
    """
    return answer(script, judge(script, values), asking)


def judge(script: Spds, values: Mapping[str, Any]) -> Judged:
    """Which situation is current, and whose conditions hold."""
    step, board = Step(), Board()
    conditions = Conditions(board, step)
    situations = Situations(script, conditions, board, step)
    conditions.start()
    longest = max((test.hold or 0.0 for test in tests(script)), default=0.0)
    for now in (0, duration(longest) if longest else 1):
        step.now = now
        for name, value in values.items():
            board.write(name, value, WRITER, now, None)
        for name in values:
            board.tell(name, None)
    situations.observe()
    seen = enumerate(situations.state.observations)
    return Judged(situations.state.current, tuple(at for at, one in seen if one.condition))


def answer(script: Spds, judged: Judged, asking: Mapping[str, Iterable[str]]) -> Answer:
    """The answer for the situations of ``script``, as they were judged."""
    current = script.situations[judged.current] if judged.current is not None else None
    priorities = script.priorities(current) if current is not None else {}
    return Answer(
        current.name if current is not None else None,
        tuple(script.situations[at].name for at in judged.holds),
        who_holds(Requests(asking), priorities),
    )


def tests(script: Spds) -> Iterator[Test]:
    """Every test of the script's conditions, ``until`` included, in document order."""
    for situation in script.situations:
        for condition in (situation.condition, situation.until):
            yield from _tests(condition)


def _tests(node: Condition | Group | None) -> Iterator[Test]:
    for child in node.children if node is not None else ():
        if isinstance(child, Test):
            yield child
        else:
            yield from _tests(child)
