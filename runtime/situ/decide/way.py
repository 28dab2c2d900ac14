"""The short way from one state to another, where all that it does is known beforehand.

Most events of a large flow only compute and move on: no part is entered or left, the screen
stays as it is, the same resources are asked for, and every action ends at once. Such a way is
worked out when it is first gone, and then gone without looking any of that up again. It gives
the events and effects of the long way (``Machine._move``), in its order.
"""

from __future__ import annotations

from typing import Any

from situ.decide.actions import Actions
from situ.decide.program import Candidate, Program, StateProgram
from situ.decide.quick import QUICK, Perform
from situ.document.rbd import AGAIN, BACK


class Way:
    """target: the state entered; stays: it is the one that is left. back: whether the one that
    is left goes onto the stack of states to go back to; starts: whether that is emptied.
    leaving: what the event does; entering: what the state does. published: what then stands
    at ``application/<name>``.
    """

    __slots__ = (
        "back", "entering", "event", "leaving", "published", "source", "starts", "stays", "target",
    )  # fmt: skip

    def __init__(
        self,
        source: StateProgram,
        target: StateProgram,
        taken: Candidate,
        leaving: tuple[Perform, ...],
        entering: tuple[Perform, ...],
        goes_back: bool,
    ) -> None:
        self.source = source.no
        self.target = target
        self.stays = source is target
        self.back = taken.next != AGAIN and goes_back
        self.event = taken.name
        self.leaving = leaving
        self.entering = entering
        level = target.levels[0]
        self.starts = level.path == level.start
        self.published: dict[str, Any] = published(target, suspended=False)


def published(state: StateProgram, suspended: bool) -> dict[str, Any]:
    """What stands at ``application/<name>`` in a state."""
    return {"state": state.no, "name": state.source.name, "suspended": suspended}


def find(program: Program, actions: Actions, here: StateProgram, taken: Candidate) -> Way | None:
    """The short way of a candidate that is taken in ``here``; None where there is none."""
    if taken.next is None or taken.next == BACK or len(here.levels) > 1:
        return None
    level = here.levels[0]
    path = level.path if taken.next == AGAIN else level.prefix + taken.next
    target = program.states.get(path)
    # A target that is no innermost state runs a part.
    if (
        target is None
        or target.screen is not None
        or (target.shared, target.uses, target.may_use) != (here.shared, here.uses, here.may_use)
        or not all(isinstance(program.actions[k], QUICK) for k in taken.actions + target.actions)
    ):
        return None
    return Way(
        here,
        target,
        taken,
        tuple(actions.performer(key) for key in taken.actions),
        tuple(actions.performer(key) for key in target.actions),
        program.goes_back,
    )
