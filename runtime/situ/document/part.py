"""*Make a part*: some states of an application become an application of their own.

formats.md, *Parts*. One state stays in their place and runs it. It keeps the number of the state
at which the part begins, so what led there leads to it. What led out of the part leads to an end
of the part with the number of its target, and from ``done.NUMBER`` on as before; the actions on
such a way are done there, after the part was left. The states inside keep their numbers.

The project then gives the same actions at the same times, but for two things that the ends bring
with them: another event that waits at the very moment at which the part is left is judged by the
end (as in every part), and at the end the application gives back, within the step, the resources
that the next state may ask for again.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator

from msgspec.structs import replace

from situ.document import codec, drawing, words
from situ.document.aside import NOTHING
from situ.document.project import Project
from situ.document.rbd import (
    AGAIN,
    BACK,
    Action,
    Always,
    Application,
    Event,
    State,
    Timeout,
)

COLUMN, ROW = 230.0, 144.0
"""How far right of the part's last card its ends stand, and below each other, in scene units."""


class NoPart(ValueError):
    """These states can not be made a part; the text says why and how to mend it."""

    def __init__(self, text: str) -> None:
        super().__init__(text[:1].upper() + text[1:])


def make_part(
    project: Project, file: str, numbers: Collection[str], name: str, part_file: str
) -> Project:
    """The project with these states of the application ``file`` as a part of it.

    name: of the part and of the state that runs it. part_file: a file that the project does not
    have yet. NoPart, with one line for the user, where the states can not be taken out alone.
    """
    source = project.flows[file]
    for no in numbers:
        source = drawing.kept(source, no)
    inside = tuple(state for state in source.states if state.no in set(numbers))
    begin = _begin(project, file, inside)
    stem = part_file.rpartition("/")[2].partition(".")[0]
    part, done = _taken_out(source, inside, begin, stem)
    first = next(state for state in inside if state.no == begin)
    at = first.aside.position
    holder = State(
        no=begin,
        name=name,
        flow=part_file,
        always=first.always,
        final=not done and any(state.final for state in inside),
        events=done,
        aside=NOTHING.at(*at) if at is not None else NOTHING,
    )
    within = {state.no for state in inside}
    rest = tuple(
        holder if state.no == begin else state
        for state in source.states
        if state.no == begin or state.no not in within
    )
    after = replace(source, states=rest)
    parts = {**project.parts, part_file: part}
    if file in project.parts:
        return replace(project, parts={**parts, file: after})
    return replace(project, applications={**project.applications, file: after}, parts=parts)


def part_file_of(file: str, name: str, taken: Collection[str]) -> str:
    """A free file name for a part called ``name``, beside the application's own file."""
    folder, slash, _ = file.rpartition("/")
    stem = "-".join(re.findall(r"\w+", name.casefold())) or "part"
    found, number = f"{folder}{slash}{stem}.rbd.xml", 1
    while found in taken:
        number += 1
        found = f"{folder}{slash}{stem}-{number}.rbd.xml"
    return found


# -- what can be taken out -----------------------------------------------------------


def _begin(project: Project, file: str, inside: tuple[State, ...]) -> str:
    """The state at which the part begins; NoPart where these states are no part."""
    source = project.flows[file]
    if not inside:
        raise NoPart("Select the states that the part shall have first.")
    within = {state.no for state in inside}
    if len(within) < len(inside):
        raise NoPart("Two of these states have one number: give each its own first.")
    always = {state.always for state in inside}
    if len(always) > 1:
        left_out = next(state for state in inside if not state.always)
        raise NoPart(
            f"{called(left_out)} leaves out what every state has, and others do not: "
            "select them apart, or make them alike."
        )
    entries = [no for no in dict.fromkeys(_ways_in(source, within)) if no and no in within]
    if len(entries) > 1:
        listed = " and ".join(called(source.state(no)) for no in entries[:2])
        raise NoPart(
            f"A part begins in one state, but ways from outside lead to {listed}: "
            "select more or fewer states, or lead them all to one."
        )
    begin = entries[0] if entries else inside[0].no
    refuse_ways_back(source, inside, begin)
    _refuse_ends(project, file, inside)
    name = re.escape(f"application/{source.name}".encode())
    every = [*project.flows.values(), *([project.spds] if project.spds is not None else [])]
    if any(re.search(name + rb"(?![\w-])", codec.write(document)) for document in every):
        raise NoPart(
            f"What application/{source.name} says is used, and it would call these states "
            f"{begin}/…: take that out first."
        )
    return begin


def _ways_in(source: Application, within: set[str]) -> Iterator[str | None]:
    """Where ways from outside the part, and the start, lead; several times perhaps."""
    yield source.start_no
    for state in source.states:
        if state.no not in within:
            yield from _targets(state)
    if source.always is not None:
        yield from _targets(source.always)


def refuse_ways_back(source: Application, inside: tuple[State, ...], begin: str) -> None:
    """A part has ways back of its own: none may lead into it, out of it, or through its door."""
    first = next(state for state in inside if state.no == begin)
    if BACK in _targets(first):
        raise NoPart(
            f"{called(first)} leads back to the state before, which would be outside the part: "
            "lead it to a state first."
        )
    shared = source.always_in(inside[0])
    if shared is not None:
        for special, said in ((BACK, "back to the state before"), (AGAIN, "to the state anew")):
            if special in _targets(shared):
                raise NoPart(
                    f"What every state has leads {said}, which would be the whole part: "
                    "lead it to a state, or leave it out of these states first."
                )
    within = {state.no for state in inside}
    alone = within == {begin}
    common = _targets(shared) if shared is not None else []
    leaving = [to for state in inside for to in _targets(state) if state.no != begin]
    for no in dict.fromkeys([*leaving, *([] if alone else common)]):
        target = source.state(no)
        if target is None or no in within:
            continue
        always = source.always_in(target)
        if BACK in _targets(target) or (always is not None and BACK in _targets(always)):
            raise NoPart(
                f"{called(target)} leads back to the state before, which would be the beginning "
                "of the part: lead it to a state first, or select it too."
            )


def _refuse_ends(project: Project, file: str, inside: tuple[State, ...]) -> None:
    """The ends of a part are told to who runs it; one further in would not be."""
    source = project.flows[file]
    end = next((state for state in inside if state.is_end), None)
    if end is None:
        return
    runs = [a.name for a in project.flows.values() for s in a.states if s.flow == file]
    if runs:
        raise NoPart(
            f"{called(end)} is an end of {source.name}, for which {runs[0]} waits: "
            "leave it out of the selection."
        )
    shared = source.always_in(end)
    for event in shared.events if shared is not None else ():
        if event.name is not None and event.name in ("done", f"done.{end.no}"):
            raise NoPart(
                f"Every state expects {event.name}, which the end {called(end)} of the part "
                "would be: leave it out of the selection."
            )


def _targets(value: State | Always) -> list[str]:
    """Every ``next`` of a state or of ``always``."""
    found = [event.next for event in value.events if event.next is not None]
    if value.timeout is not None and value.timeout.next is not None:
        found.append(value.timeout.next)
    return found


def called(state: State | None) -> str:
    assert state is not None
    return f"state {words.state(state)}"


# -- taking it out -------------------------------------------------------------------


def _taken_out(
    source: Application, inside: tuple[State, ...], begin: str, name: str
) -> tuple[Application, tuple[Event, ...]]:
    """The part with an end for each way out, and what the state that runs it expects."""
    within = {state.no for state in inside}
    ends: dict[tuple[str, tuple[Action, ...]], str] = {}
    taken = set(within)

    def end_of(to: str, actions: tuple[Action, ...]) -> str:
        if (to, actions) not in ends:
            no, number = to, 1
            while no in taken:
                number += 1
                no = f"{to}-{number}"
            taken.add(no)
            ends[to, actions] = no
        return ends[to, actions]

    def leads_out(to: str | None) -> bool:
        return to is not None and to not in within and to not in (BACK, AGAIN)

    def event(value: Event) -> Event:
        if value.next is None or not leads_out(value.next):
            return value
        return replace(value, next=end_of(value.next, value.actions), actions=())

    def timeout(value: Timeout | None) -> Timeout | None:
        if value is None or value.next is None or not leads_out(value.next):
            return value
        return replace(value, next=end_of(value.next, ()))

    states = tuple(
        replace(
            state,
            # What leaves out all that every state has, is the part as a whole.
            always=True,
            events=tuple(event(one) for one in state.events),
            timeout=timeout(state.timeout),
        )
        for state in inside
    )
    spots = [at for state in inside if (at := state.aside.position) is not None]
    made: list[State] = []
    for (to, _), no in ends.items():
        target = source.state(to)
        aside = NOTHING
        if spots:
            right, top = max(x for x, _ in spots), min(y for _, y in spots)
            aside = NOTHING.at(right + COLUMN, top + ROW * len(made))
        called = target.name if target is not None else ""
        made.append(State(no=no, name=called, final=True, aside=aside))
    done = tuple(
        Event(name=f"done.{no}", next=to, actions=actions) for (to, actions), no in ends.items()
    )
    start = begin if states[0].no != begin else None
    return Application(name=name, start=start, states=(*states, *made)), done
