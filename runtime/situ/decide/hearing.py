"""What people may say to an application now, and which event they mean by it."""

from __future__ import annotations

from collections.abc import Iterable

from situ.decide.machine import Machine
from situ.decide.program import Candidate
from situ.decide.texts import translator
from situ.decide.values import template
from situ.decide.world import World
from situ.document.texts import heard_as


def phrases(world: World, machine: Machine) -> list[str]:
    """What a person may say to it now; nothing while it does not listen."""
    return [text for text, _ in _expected(world, machine)]


def event_for(world: World, machine: Machine, heard: str) -> str | None:
    """The event that an utterance means to it."""
    for text, name in _expected(world, machine):
        if heard_as(text) == heard_as(heard):
            return name
    return None


def said(world: World, candidates: Iterable[Candidate]) -> list[tuple[str, str]]:
    """The phrases of named candidates, each with its event: in the robot's language, filled in."""
    board = world.board
    translate = translator(world.project, board)
    return [
        (template(translate(phrase, None)).text(board.look), one.name)
        for one in candidates
        for phrase in one.says
        if one.name is not None
    ]


def _expected(world: World, machine: Machine) -> list[tuple[str, str]]:
    state, heard = machine.state, machine.here.heard
    if state.suspended or not state.begun or not heard or not machine.actions.hears():
        return []
    return said(world, heard)
