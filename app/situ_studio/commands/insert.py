"""Inserting a new thing of a kind: by a drop, a palette button or the Insert menu."""

from __future__ import annotations

from typing import Any

from msgspec.structs import replace

from situ.document import drawing, modules, rbd, spds
from situ.document.condition import Condition
from situ_studio import kinds
from situ_studio.canvas.script_conditions import test_of
from situ_studio.edits import changes, places, words
from situ_studio.edits.edit import Document, Place
from situ_studio.kinds import Kind
from situ_studio.screens import placing
from situ_studio.wording.language import tr, translated

ABOVE = 176.0
"""How far above the others the card *In every state* is put."""


class NotHere(ValueError):
    """A thing of this kind can not be put there; the text says what to select first."""


def insert(document: Document, kind: Kind, at: Place) -> tuple[Document, Place, str]:
    """The document with a new thing of ``kind`` at or in ``at``, its place, and the step's name.

    Where there can be but one and it is there already: its place, and no step ("").
    Raises NotHere, with a line for the user.
    """
    if isinstance(document, rbd.Application):
        return _into_application(document, kind, at)
    if isinstance(document, spds.Spds):
        return _into_script(document, kind, at)
    name = _free(kind.name.replace("information", "module"), {m.name for m in document.modules})
    made = modules.Module(name=name)
    after = places.change(document, (), modules=(*document.modules, made))
    return after, ("module", name), tr("Add module {0}").format(name)


def _into_application(
    document: rbd.Application, kind: Kind, at: Place
) -> tuple[Document, Place, str]:
    if kind is kinds.STATE:
        no = changes.free_number(document)
        after = places.change(document, (), states=(*document.states, kind.make(no)))
        return after, ("state", no), tr("Add state {0}").format(no)
    if kind is kinds.ALWAYS:
        return _always(document)
    if kind.name in places.DRAWN:
        return _drawn(document, kind)
    root = places.root(at)
    part: Any = places.get(document, root) if root else None
    called = translated(kind.title).lower()
    if part is None:
        raise NotHere(tr("Select a state first, then add the {0}.").format(called))
    where = words.place_words(document, root)
    here = where[:1].upper() + where[1:]
    text = tr("Add {0} to {1}").format(called, where)
    if kind is kinds.EVENT:
        made = kind.make(words.expected_next(part))
        after = places.change(document, root, events=(*part.events, made))
        return after, (*root, "event", str(len(part.events))), text
    event = at[: len(root) + 2]
    inside = places.get(document, event)
    on_the_way = isinstance(inside, rbd.Event) and kind in kinds.EVENT_ACTIONS
    if isinstance(part, rbd.State) and part.flow is not None and not on_the_way:
        told = tr("{0} runs {1}: add the {2} there.")
        raise NotHere(told.format(here, part.flow, called))
    if kind is kinds.TIMEOUT:
        if part.timeout is not None:
            raise NotHere(tr("{0} has a timeout already.").format(here))
        return places.change(document, root, timeout=kind.make("")), root, text
    if kind in kinds.COMPONENTS:
        screen = part.screen or rbd.Screen()
        name = _free(kind.name, {c.id for c in screen.components}, first=True)
        new = kind.make(name)
        if isinstance(new, rbd.Button):
            new = replace(new, event=words.sent_next(part) or new.event)
        above = document.always_in(part) if isinstance(part, rbd.State) else None
        there = (one.screen for one in (part, above) if one is not None and one.screen is not None)
        taken = [placing.box_of(one) for shown in there for one in shown.components]
        # Answers stand beside each other, all else below what is there.
        answers = isinstance(new, rbd.Button)
        free = placing.in_free_room(placing.box_of(new), taken, answers)
        new = replace(new, **free._asdict())
        screen = replace(screen, components=(*screen.components, new))
        return places.change(document, root, screen=screen), (*root, "screen", name), text
    made = kind.make("")
    if on_the_way:
        after = places.change(document, event, actions=(*inside.actions, made))
        return after, (*event, "action", str(len(inside.actions))), text
    if not isinstance(part, rbd.State):
        raise NotHere(tr("Actions belong to states and events: select one of them first."))
    after = places.change(document, root, actions=(*part.actions, made))
    return after, (*root, "action", str(len(part.actions))), text


def _always(document: rbd.Application) -> tuple[Document, Place, str]:
    """What is part of every state: one card, above all others."""
    if document.always is not None:
        return document, ("always",), ""
    made = kinds.ALWAYS.make("")
    corner = _corner(document)
    if corner is not None:
        made = replace(made, aside=made.aside.at(corner[0], corner[1] - ABOVE))
    text = tr("Add {0}").format(translated(kinds.ALWAYS.title))
    return places.change(document, (), always=made), ("always",), text


def _corner(document: rbd.Application) -> tuple[float, float] | None:
    """The upper left corner of all states that have a place."""
    spots = [at for state in document.states if (at := state.aside.position) is not None]
    return (min(x for x, _ in spots), min(y for _, y in spots)) if spots else None


def _drawn(document: rbd.Application, kind: Kind) -> tuple[Document, Place, str]:
    """A note or a frame above all cards, where nothing is in its way."""
    made = kind.make(kind.title)
    corner = _corner(document)
    if corner is not None:
        made = replace(made, x=corner[0], y=corner[1] - made.height - 24)
    count = sum(1 for one in drawing.drawn(document) if type(one) is type(made))
    text = tr("Add {0}").format(translated(kind.title).lower())
    return drawing.add(document, made), (kind.name, str(count)), text


def _into_script(document: spds.Spds, kind: Kind, at: Place) -> tuple[Document, Place, str]:
    if kind is kinds.DATA:
        tag = _free("data", {o.tag for o in document.observe})
        after = places.change(document, (), observe=(*document.observe, kind.make(tag)))
        return after, ("data", tag), tr("Add data {0}").format(tag)
    if kind is kinds.MODULE:
        name = _free("module", {m.name for m in document.modules})
        # What it may move is not known, but of a resource that is selected it is.
        chosen = (at[1],) if at[:1] == ("resource",) and len(at) == 2 else ()
        declared = replace(kind.make(name), resources=chosen)
        after = places.change(document, (), modules=(*document.modules, declared))
        return after, ("module", name), tr("Add module {0}").format(name)
    if kind is kinds.CONDITION:
        owner = places.get(document, at[:2])
        if not isinstance(owner, spds.Situation):
            raise NotHere(tr("Select a situation first, then add the condition."))
        test = test_of(document, document.observe[0].tag if document.observe else "data")
        old = owner.condition or Condition()
        new = replace(old, children=(*old.children, test))
        after = places.change(document, at[:2], condition=new)
        place = (*at[:2], "condition", str(len(old.children)))
        where = words.place_words(document, at[:2])
        return after, place, tr("Add condition to {0}").format(where)
    name = _free("situation", {s.name for s in document.situations})
    every = list(document.situations)
    index = max(0, len(every) - 1)
    if at[:1] == ("situation",):
        index = next((i for i, s in enumerate(every) if s.name == at[1]), index)
    made = spds.Situation(name=name)
    if every:
        # Only the last one may hold always, and a new one stands before it.
        tag = document.observe[0].tag if document.observe else "data"
        if at[:1] == ("data",):
            tag = at[1]
        made = spds.Situation(name=name, condition=Condition((test_of(document, tag),)))
    every.insert(index, made)
    after = places.change(document, (), situations=tuple(every))
    return after, ("situation", name), tr("Add situation {0}").format(name)


def _free(word: str, taken: set[str], first: bool = False) -> str:
    """``word``, or with the first number that is free; ``first``: always with a number."""
    if not first and word not in taken:
        return word
    number = 1 if first else 2
    while f"{word}{number}" in taken:
        number += 1
    return f"{word}{number}"
