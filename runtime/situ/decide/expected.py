"""What the applications expect now, for a person who plays what the robot can not hear or see."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct

from situ.decide.hearing import said
from situ.decide.machine import Machine
from situ.decide.program import Candidate
from situ.decide.texts import translator
from situ.decide.values import template
from situ.decide.world import World
from situ.document import words
from situ.document.rbd import Action, Speech


class ExpectedEvent(Struct, frozen=True):
    """An event that the state takes, by name.

    says: what a person may say for it, in the robot's language. holds: whether it would be
    taken now. when: in words, under which conditions, one for each that has one.
    """

    name: str
    says: tuple[str, ...]
    holds: bool
    when: tuple[str, ...]


class Expectation(Struct, frozen=True):
    """One application in its state: its path (``5/q``) and its name, which may be empty.

    time: µs, when what stands at ``application/<name>`` last changed. suspended: it takes
    nothing until it holds its resources again. paused: by the debugger; what comes waits.
    speeches: what the state says, in the robot's language, filled in.
    """

    state: str
    name: str
    time: int
    suspended: bool
    paused: bool
    events: tuple[ExpectedEvent, ...]
    speeches: tuple[str, ...] = ()


def expected(world: World, machines: Sequence[Machine]) -> dict[str, Expectation]:
    """What each application expects, by its name, in the project's order; nothing changes by it.

    Unnamed events, which come by what stands on the blackboard, are not among them.
    """

    def event(machine: Machine, name: str, candidates: Sequence[Candidate]) -> ExpectedEvent:
        phrases = dict.fromkeys(text for text, _ in said(world, candidates))
        conditions = [words.condition(one.when) for one in candidates if one.when is not None]
        holds = machine.first(candidates) is not None
        return ExpectedEvent(name, tuple(phrases), holds, tuple(dict.fromkeys(conditions)))

    def speeches(actions: Sequence[Action]) -> tuple[str, ...]:
        texts = (
            template(translator(world.project, world.board, one.lang)(one.text, None))
            for one in actions
            if isinstance(one, Speech)
        )
        return tuple(dict.fromkeys(text.text(world.board.look) for text in texts))

    told = {}
    for machine in machines:
        here, entry = machine.here, world.board.get(f"application/{machine.name}")
        told[machine.name] = Expectation(
            state=here.no,
            name=here.source.name,
            time=entry.time if entry is not None else 0,
            suspended=machine.state.suspended,
            paused=machine.paused,
            events=tuple(event(machine, *named) for named in here.named.items()),
            speeches=speeches(here.source.actions),
        )
    return told
