"""Actions that end at once: ``set``, ``add``, ``append``, ``take``, ``clear``, ``message``.

formats.md, *Actions*: each is traced, writes its data, and ends.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from situ.decide import trace
from situ.decide.effects import Begin
from situ.decide.values import is_number, template
from situ.decide.world import World, untraced
from situ.document import names
from situ.document.rbd import Action, Add, Append, Clear, Message, Set, Take

LARGEST = 2**63
"""Whole numbers beyond this are no values: not every reader of JSON can hold them."""

QUICK = (Set, Add, Append, Take, Clear, Message)


class _Quick:
    """One such action while it is carried out."""

    def __init__(self, world: World, application: str, state: str, where: str, cause: int | None):
        self.world = world
        self.application = application
        self.state = state
        self.where = where
        self.cause = cause

    def value(self, text: str) -> Any:
        look = self.world.board.look
        filled = template(text)
        for name in filled.missing(look) if filled.names else ():
            self.world.step.warn(self.cause, f"{name} has no value", self.where)
        return filled.value(look)

    def begin(self, action: str, **fields: Any) -> int:
        return self.world.step.trace(
            trace.Action, self.cause, self.application, self.state, action, None, **fields
        )

    def write(self, tags: dict[str, Any], cause: int) -> None:
        self.world.write(tags, self.application, cause)

    def warn(self, cause: int, message: str) -> None:
        self.world.step.warn(cause, message, self.where)


def perform(
    world: World, application: str, state: str, where: str, action: Action, cause: int | None
) -> int:
    """Carries it out and traces it; gives the seq of its ``finished`` event."""
    one = _Quick(world, application, state, where, cause)
    seq = _PERFORMERS[type(action)](one, action)
    return world.step.trace(
        trace.Finished, seq, application, action.element, None, True, result=None
    )


def _set(one: _Quick, action: Set) -> int:
    value = one.value(action.text)
    seq = one.begin("set", tag=action.tag, value=value)
    one.write({action.tag: value}, seq)
    return seq


def _add(one: _Quick, action: Add) -> int:
    value = one.value(action.text)
    seq = one.begin("add", tag=action.tag, value=value)
    before = one.world.board.look(action.tag)
    if is_number(value) and (before is None or is_number(before)):
        total = (before or 0) + value
        if abs(total) < LARGEST if isinstance(total, int) else math.isfinite(total):
            one.write({action.tag: total}, seq)
        else:
            one.warn(seq, f"add makes {action.tag} too large a number; it stays {before!r}")
    else:
        one.warn(seq, f"add needs numbers: {action.tag} is {before!r}, to add is {value!r}")
    return seq


def _append(one: _Quick, action: Append) -> int:
    value = one.value(action.text)
    seq = one.begin("append", tag=action.tag, value=value)
    before = one.world.board.look(action.tag)
    if before is None or isinstance(before, list):
        one.write({action.tag: [*(before or ()), value]}, seq)
    else:
        one.warn(seq, f"append needs a list: {action.tag} is {before!r}")
    return seq


def _take(one: _Quick, action: Take) -> int:
    seq = one.begin("take", source=action.source, tag=action.tag)
    entries = one.world.board.look(action.source)
    if not isinstance(entries, list) or not entries:
        one.write({action.tag: None}, seq)
        return seq
    place = one.world.random.randrange(len(entries)) if action.order == "random" else 0
    rest = [*entries[:place], *entries[place + 1 :]]
    one.write({action.source: rest, action.tag: entries[place]}, seq)
    return seq


def _clear(one: _Quick, action: Clear) -> int:
    seq = one.begin("clear", tag=action.tag)
    gone = [
        tag
        for tag, _ in one.world.board.entries(action.tag)
        if not names.is_reserved(tag) and not untraced(tag)
    ]
    one.write(dict.fromkeys(gone), seq)
    return seq


def _message(one: _Quick, action: Message) -> int:
    value: Any
    if action.params:
        value = {param.name: one.value(param.text) for param in action.params}
    else:
        value = one.value(action.text) if action.text.strip() else None
    topic = template(action.topic).text(one.world.board.look)
    seq = one.begin("message", topic=topic, value=value)
    one.world.step.effects.append(
        Begin(
            one.world.next_id(), one.application, "message", None, {"topic": topic, "value": value}
        )
    )
    return seq


_PERFORMERS: dict[type[Action], Callable[[_Quick, Any], int]] = {
    Set: _set,
    Add: _add,
    Append: _append,
    Take: _take,
    Clear: _clear,
    Message: _message,
}
