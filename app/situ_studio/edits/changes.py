"""Changes that touch more than one place of a document: names that others refer to."""

from __future__ import annotations

from typing import Any

from msgspec.structs import replace

from situ.document import drawing, rbd
from situ.document.condition import Condition, Group, Test
from situ.document.modules import Module, Modules
from situ.document.rbd import Always, Application, Event, State, Timeout
from situ.document.spds import Declaration, Observed, Situation, Spds
from situ_studio.edits import button_names, places
from situ_studio.edits.edit import Document, Place
from situ_studio.wording.language import tr

_NAMES: dict[type, str] = {
    State: "no",
    Situation: "name",
    Declaration: "name",
    Observed: "tag",
    Module: "name",
    **dict.fromkeys((rbd.Text, rbd.Button, rbd.Image, rbd.Movie, rbd.Input, rbd.List), "id"),
}
"""The attribute that names a value, and so is the last word of its place."""


def set_field(
    document: Document, place: Place, attribute: str, value: Any
) -> tuple[Document, Place]:
    """The document with one attribute of the value at ``place`` changed, and its place then.

    A new name is followed everywhere, a new button's words by its name. ValueError, with a line
    for the user, where it is taken.
    """
    old = places.get(document, place)
    if isinstance(old, rbd.Button) and attribute == "text" and isinstance(document, Application):
        return button_names.with_words(document, place, value)
    if attribute != _NAMES.get(type(old)):
        return places.change(document, place, **{attribute: value}), place
    moved = (*place[:-1], value)
    if places.get(document, moved) is not None:
        raise ValueError(tr("{0} is taken already.").format(value))
    before = getattr(old, attribute)
    if isinstance(old, State) and isinstance(document, Application):
        return renumber(document, before, value), moved
    if isinstance(document, Modules):
        return rename_entry(document, before, value), moved
    if isinstance(document, Spds):
        if isinstance(old, Situation):
            return rename_situation(document, before, value), moved
        if isinstance(old, Declaration):
            return rename_module(document, before, value), moved
        return rename_data(document, before, value), moved
    return places.change(document, place, **{attribute: value}), moved


def remove(document: Document, every: tuple[Place, ...]) -> Document:
    """The document without what stands at these places; what leads to a removed state goes too."""
    # From the back, so that positions stay right.
    for place in sorted(every, key=lambda p: [int(w) if w.isdigit() else 0 for w in p])[::-1]:
        if places.get(document, place) is None:
            continue
        if len(place) == 2 and place[0] == "state" and isinstance(document, Application):
            document = remove_state(document, place[1])
        else:
            document = places.put(document, place, None)
    return document


def renumber(application: Application, old: str, new: str) -> Application:
    """State ``old`` gets the number ``new``, and everything that leads to it follows."""

    def timeout(value: Timeout | None) -> Timeout | None:
        return replace(value, next=new) if value is not None and value.next == old else value

    def events(every: tuple[Event, ...]) -> tuple[Event, ...]:
        if not any(e.next == old for e in every):
            return every
        return tuple(replace(e, next=new) if e.next == old else e for e in every)

    def part(value: Any) -> Any:
        after, leaving = events(value.events), timeout(value.timeout)
        if after is value.events and leaving is value.timeout:
            return value
        return replace(value, events=after, timeout=leaving)

    states: list[State] = []
    for state in application.states:
        moved = part(state)
        states.append(replace(moved, no=new) if state.no == old else moved)
    always: Always | None = part(application.always) if application.always is not None else None
    start = new if application.start == old else application.start
    return replace(application, states=tuple(states), always=always, start=start)


def free_number(application: Application) -> str:
    """The number after the highest that is one."""
    numbers = [int(s.no) for s in application.states if s.no.isdigit()]
    return str(max(numbers, default=0) + 1)


def rename_situation(script: Spds, old: str, new: str) -> Spds:
    """Situation ``old`` is called ``new``, also where others take over from it."""
    return replace(
        script,
        situations=tuple(
            replace(
                s,
                name=new if s.name == old else s.name,
                extends=new if s.extends == old else s.extends,
            )
            if old in (s.name, s.extends)
            else s
            for s in script.situations
        ),
    )


def rename_module(script: Spds, old: str, new: str) -> Spds:
    """Module ``old`` is called ``new``, also where it has a priority."""
    return replace(
        script,
        modules=tuple(replace(m, name=new) if m.name == old else m for m in script.modules),
        situations=tuple(
            replace(
                s,
                entries=tuple(replace(e, module=new) if e.module == old else e for e in s.entries),
            )
            if any(e.module == old for e in s.entries)
            else s
            for s in script.situations
        ),
    )


def rename_entry(information: Modules, old: str, new: str) -> Modules:
    """Module ``old`` is called ``new``, also where another requires it."""
    return replace(
        information,
        modules=tuple(
            replace(
                m,
                name=new if m.name == old else m.name,
                requires=tuple(
                    replace(r, module=new) if r.module == old else r for r in m.requires
                ),
            )
            for m in information.modules
        ),
    )


def rename_data(script: Spds, old: str, new: str) -> Spds:
    """The observed tag ``old`` is called ``new``, also in every condition."""

    def child(value: Test | Group) -> Test | Group:
        if isinstance(value, Test):
            return replace(value, tag=new) if value.tag == old else value
        return replace(value, children=tuple(child(c) for c in value.children))

    def condition(value: Condition | None) -> Condition | None:
        if value is None:
            return None
        return replace(value, children=tuple(child(c) for c in value.children))

    return replace(
        script,
        observe=tuple(replace(o, tag=new) if o.tag == old else o for o in script.observe),
        situations=tuple(
            replace(s, condition=condition(s.condition), until=condition(s.until))
            for s in script.situations
        ),
    )


def remove_state(application: Application, no: str) -> Application:
    """Without state ``no``, and without the events and timeouts that led to it.

    Notes and frames that stand before it in the file stay. The start falls to the first state that
    is left, where it was ``no``.
    """

    def part(value: Any) -> Any:
        kept = tuple(e for e in value.events if e.next != no)
        leaving = value.timeout
        if leaving is not None and leaving.next == no:
            leaving = None
        if len(kept) == len(value.events) and leaving is value.timeout:
            return value
        return replace(value, events=kept, timeout=leaving)

    application = drawing.kept(application, no)
    states = tuple(part(s) for s in application.states if s.no != no)
    always = part(application.always) if application.always is not None else None
    start = application.start if application.start != no else None
    return replace(application, states=states, always=always, start=start)
