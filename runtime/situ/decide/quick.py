"""Actions that end at once: ``set``, ``add``, ``append``, ``take``, ``clear``, ``message``.

formats.md, *Actions*: each is traced, writes its data, and ends. Each is made ready once,
so that carrying it out looks nothing up that is known before.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from situ.decide import trace
from situ.decide.board import Entry
from situ.decide.effects import Begin, Changed
from situ.decide.filling import Filling
from situ.decide.values import is_number, template
from situ.decide.world import World, refusal, untraced
from situ.document import names
from situ.document.rbd import Action, Add, Append, Clear, Message, Set, Take

LARGEST = 2**63
"""Whole numbers beyond this are no values: not every reader of JSON can hold them."""

QUICK = (Set, Add, Append, Take, Clear, Message)

Perform = Callable[[str, int | None], int]
"""(state it belongs to, cause) -> the seq of its ``finished`` event."""


def ready(world: World, application: str, action: Action) -> Perform:
    """One of ``QUICK``, made ready to be carried out in ``application``."""
    if isinstance(action, Set) and not (refusal(action.tag, application) or untraced(action.tag)):
        return _set_at_once(world, application, action)
    carry = _CARRIERS[type(action)]
    quick, step, element = _Quick(world, application), world.step, action.element

    def perform(state: str, cause: int | None) -> int:
        seq = carry(quick, action, state, cause)
        return step.trace(trace.Finished, seq, application, element, None, True, None)

    return perform


def _set_at_once(world: World, application: str, action: Set) -> Perform:
    """The commonest action, all on one spot; without a call where its value is a constant."""
    tag, step, board = action.tag, world.step, world.board
    filled, filling = template(action.text), Filling(world, application)
    constant = None if filled.names else filled.value(board.look)
    varies = bool(filled.names) or isinstance(constant, (list, dict))

    def perform(state: str, cause: int | None) -> int:
        held = filling.value(action.text, state, cause) if varies else constant
        seq, now, seconds = step.seq + 1, step.now, step.seconds
        events = step.events
        events.append(
            trace.Action(seq, seconds, cause, application, state, "set", None, tag=tag, value=held)
        )
        last = seq + 1
        # As ``World.write`` of one tag.
        old = board.state.get(tag)
        if old is None:
            version = 0 if held is None else 1
        else:
            version = 0 if held is None and old.value is None else old.version + 1
        if version:
            events.append(trace.Data(last, seconds, seq, tag, held, application, version))
            board.state[tag] = Entry(held, version, application, now, last)
            step.effects.append(Changed(tag, held, version, application, now))
            if tag in board.listeners:
                board.tell(tag, last)
            last += 1
        step.seq = last
        events.append(trace.Finished(last, seconds, seq, application, "set", None, True, None))
        return last

    return perform


class _Quick:
    """What the others need of their application; ``state`` and ``cause`` as in ``Perform``."""

    def __init__(self, world: World, application: str) -> None:
        self.world = world
        self.application = application
        filling = Filling(world, application)
        self.value, self._where = filling.value, filling.where

    def begin(self, state: str, cause: int | None, action: str, **fields: Any) -> int:
        return self.world.step.trace(
            trace.Action, cause, self.application, state, action, None, **fields
        )

    def write(self, tags: dict[str, Any], cause: int) -> None:
        self.world.write(tags, self.application, cause)

    def warn(self, state: str, cause: int, message: str) -> None:
        self.world.step.warn(cause, message, self._where(state))


def _set(one: _Quick, action: Set, state: str, cause: int | None) -> int:
    value = one.value(action.text, state, cause)
    seq = one.begin(state, cause, "set", tag=action.tag, value=value)
    one.write({action.tag: value}, seq)
    return seq


def _add(one: _Quick, action: Add, state: str, cause: int | None) -> int:
    value = one.value(action.text, state, cause)
    seq = one.begin(state, cause, "add", tag=action.tag, value=value)
    before = one.world.board.look(action.tag)
    if is_number(value) and (before is None or is_number(before)):
        total = (before or 0) + value
        if abs(total) < LARGEST if isinstance(total, int) else math.isfinite(total):
            one.write({action.tag: total}, seq)
        else:
            one.warn(state, seq, f"add makes {action.tag} too large a number; it stays {before!r}")
    else:
        one.warn(state, seq, f"add needs numbers: {action.tag} is {before!r}, to add is {value!r}")
    return seq


def _append(one: _Quick, action: Append, state: str, cause: int | None) -> int:
    value = one.value(action.text, state, cause)
    seq = one.begin(state, cause, "append", tag=action.tag, value=value)
    before = one.world.board.look(action.tag)
    if before is None or isinstance(before, list):
        one.write({action.tag: [*(before or ()), value]}, seq)
    else:
        one.warn(state, seq, f"append needs a list: {action.tag} is {before!r}")
    return seq


def _take(one: _Quick, action: Take, state: str, cause: int | None) -> int:
    seq = one.begin(state, cause, "take", source=action.source, tag=action.tag)
    entries = one.world.board.look(action.source)
    if not isinstance(entries, list) or not entries:
        one.write({action.tag: None}, seq)
        return seq
    place = one.world.random.randrange(len(entries)) if action.order == "random" else 0
    rest = [*entries[:place], *entries[place + 1 :]]
    one.write({action.source: rest, action.tag: entries[place]}, seq)
    return seq


def _clear(one: _Quick, action: Clear, state: str, cause: int | None) -> int:
    seq = one.begin(state, cause, "clear", tag=action.tag)
    gone = [
        tag
        for tag, _ in one.world.board.entries(action.tag)
        if not names.is_reserved(tag) and not untraced(tag)
    ]
    one.write(dict.fromkeys(gone), seq)
    return seq


def _message(one: _Quick, action: Message, state: str, cause: int | None) -> int:
    value: Any
    if action.params:
        value = {param.name: one.value(param.text, state, cause) for param in action.params}
    else:
        value = one.value(action.text, state, cause) if action.text.strip() else None
    topic = template(action.topic).text(one.world.board.look)
    seq = one.begin(state, cause, "message", topic=topic, value=value)
    one.world.step.effects.append(
        Begin(
            one.world.next_id(), one.application, "message", None, {"topic": topic, "value": value}
        )
    )
    return seq


_CARRIERS: dict[type[Action], Callable[[_Quick, Any, str, int | None], int]] = {
    Set: _set,
    Add: _add,
    Append: _append,
    Take: _take,
    Clear: _clear,
    Message: _message,
}
