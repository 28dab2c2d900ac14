"""Plain words for places and values: for headings, undo steps and summaries."""

from __future__ import annotations

import re
from typing import Any

from situ.document import rbd, spds
from situ.document import words as said
from situ.document.drawing import Drawn, Note
from situ_studio import kinds, places
from situ_studio.edit import Document, Place


def state_words(document: Document, no: str) -> str:
    """``6 show names``, or the number alone."""
    state = document.state(no) if isinstance(document, rbd.Application) else None
    return f"{no} {state.name}".strip() if state is not None else no


def leads_to(document: Document, next_: str | None) -> str:
    """Where an event leads, in words."""
    if next_ is None:
        return "stays"
    if next_ == rbd.AGAIN:
        return "anew"
    if next_ == rbd.BACK:
        return "back"
    return state_words(document, next_)


def member_words(value: Any) -> str:
    """One member of a list: ``event clickNo``, ``speech``, ``button no``."""
    kind = kinds.kind_of(value)
    title = kind.title.lower() if kind is not None else type(value).__name__.lower()
    if isinstance(value, rbd.Event):
        return f"event {value.name}" if value.name else "unnamed event"
    if isinstance(value, rbd.Component):
        return f"{title} {value.id}"
    return title


def drawn_words(value: Drawn) -> str:
    """A note's first line or a frame's title; what it is where it has none."""
    text = value.text if isinstance(value, Note) else value.title
    return text.partition("\n")[0] or ("Note" if isinstance(value, Note) else "Frame")


def place_words(document: Document, place: Place) -> str:
    """A place in words, from the inside out: ``event clickNo of state 6``."""
    if not place:
        return "the modules" if not hasattr(document, "name") else document.name
    if place[0] == "always":
        outer, inner = "Always", place[1:]
    elif place[0] == "state":
        outer, inner = f"state {place[1]}", place[2:]
    elif place[0] in places.DRAWN:
        value = places.get(document, place)
        title = drawn_words(value) if value is not None else ""
        return f"the frame {title}" if place[0] == "frame" else "a note"
    else:
        outer, inner = f"{place[0]} {place[1] if len(place) > 1 else ''}".strip(), place[2:]
    if not inner:
        return outer
    value = places.get(document, place)
    if inner == ("screen",):
        return f"the screen of {outer}"
    if value is None:
        return outer
    found = member_words(value)
    parent = places.get(document, place[:-2])
    if isinstance(parent, rbd.Event):
        found = f"{found} in {member_words(parent)}"
    return f"{found} of {outer}"


def change_words(document: Document, place: Place, attribute: str, label: str) -> str:
    """The name of the step that changes one attribute of what stands at ``place``."""
    where = place_words(document, place)
    if attribute == "name" and place:
        return f"Rename {where}"
    return f"Change {label.lower()} of {where}"


def title(document: Document, place: Place) -> tuple[str, str, str, str]:
    """Heading of a place: icon, the colour's token, its name, and what it is (for the pill)."""
    value = places.get(document, place)
    kind = kinds.kind_of(value)
    if kind is None:
        return "info", "text2", "", ""
    icon, tint = kind.icon, str(kind.tint)
    if isinstance(value, Drawn):
        return icon, tint, drawn_words(value), kind.title
    if isinstance(value, rbd.State):
        assert isinstance(document, rbd.Application)
        if document.start_no == value.no:
            icon, tint = "start", "start"
        return icon, tint, value.name or f"state {value.no}", f"State {value.no}"
    if isinstance(value, rbd.Event):
        return icon, tint, value.name or "at once", f"Event of {_owner(place)}"
    if isinstance(value, rbd.Component):
        name = kind.summary(value).split(" → ")[0] or value.id
        return icon, tint, name, f"{kind.title} of {_owner(place)}"
    if isinstance(value, rbd.Action | rbd.Screen | rbd.Timeout):
        return icon, tint, kind.title, _owner(place).capitalize()
    if isinstance(value, spds.Situation):
        assert isinstance(document, spds.Spds)
        number = document.situations.index(value) + 1
        return icon, tint, value.name, f"Situation {number} of {len(document.situations)}"
    if isinstance(value, rbd.Always):
        return icon, tint, kind.title, "Part of every state"
    name = getattr(value, "name", None) or getattr(value, "tag", None) or kind.title
    return icon, tint, name, kind.title


def _owner(place: Place) -> str:
    return "Always" if place[0] == "always" else f"state {place[1]}"


def _raised(part: Any) -> list[str]:
    """The events that the screen and the actions of a state raise."""
    raised: list[str | None] = []
    if part.screen is not None:
        for component in part.screen.components:
            raised += [getattr(component, "event", None), getattr(component, "done", None)]
        raised.append(part.screen.touched)
    for action in getattr(part, "actions", ()):
        raised += [action.done, action.failed]
    return [name for name in raised if name]


def sent_next(part: Any) -> str | None:
    """The event that one more button sends: one without a name of its own that nothing raises yet.

    Somebody who first drew the way and then the button means that they belong together.
    """
    raised = _raised(part)
    for event in part.events:
        if event.name and event.name not in raised and re.fullmatch(r"event\d+", event.name):
            return str(event.name)
    return None


def expected_next(part: Any) -> str:
    """A name for one more event: of a button or action that the state does not expect yet."""
    known = {e.name for e in part.events}
    for name in _raised(part):
        if name not in known:
            return name
    number = len(part.events) + 1
    while f"event{number}" in known:
        number += 1
    return f"event{number}"


def situation_words(script: spds.Spds, situation: spds.Situation) -> str:
    """A situation in two or three sentences."""
    index = script.situations.index(situation)
    if situation.condition is None or not situation.condition.children:
        first = "This always holds."
    else:
        first = f"This holds while {said.condition(situation.condition)}."
    stays = ""
    if situation.dwell is not None:
        stays = f" Once current it stays for {situation.dwell:g} s at least."
    if situation.limit is not None:
        stays = f" Once current it ends after {situation.limit:g} s at the latest."
    before = [s.name for s in script.situations[:index]]
    order = (
        f" {said.listed(before)} go{'es' if len(before) == 1 else ''} first."
        if before
        else (" It goes before all others.")
    )
    every = sorted(script.priorities(situation).items(), key=lambda pair: -pair[1])
    who = (
        f" {said.listed([m for m, _ in every])} may move the robot, in this order."
        if every
        else (" Nothing may move the robot.")
    )
    return f"{first}{stays}{order}{who}"
