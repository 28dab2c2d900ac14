"""*Dissolve a part*: its states stand in its place again, the reverse of ``make_part``.

The state at which the part begins gets the number of the state that ran it; the others keep theirs
where they are free. What led to an end of the part leads to where the part's end led. The project
then gives the same actions at the same times, but for what ``situ.document.part`` names.
"""

from __future__ import annotations

from collections.abc import Mapping

from msgspec.structs import replace

from situ.document.part import NoPart, called, refuse_ways_back
from situ.document.project import Project
from situ.document.rbd import AGAIN, BACK, Application, Event, State


def dissolve(project: Project, file: str, no: str) -> Project:
    """The project with the part that state ``no`` of ``file`` runs dissolved into ``file``.

    The part's file stays in the project: others may run it. NoPart, with one line for the user,
    where its states can not stand alone.
    """
    source = project.flows[file]
    holder = source.state(no)
    part = project.flow(holder.flow) if holder is not None and holder.flow is not None else None
    if holder is None or part is None or not part.states:
        raise NoPart("Select a state that runs a part first.")
    if part.always is not None:
        raise NoPart(
            f"{part.name} has something in every state, which the states around would get too: "
            "put it into its states first."
        )
    ends = _ends(part, holder)
    inside = tuple(state for state in part.states if state.no not in ends)
    numbers = _numbers(source, inside, holder.no, part.start_no or "")
    shared = tuple(e for e in holder.events if not _is_end(e))
    for event in shared:
        if event.next in (BACK, AGAIN):
            raise NoPart(
                f"In {called(holder)} {event.name or 'an event'} leads to {event.next}, which "
                "would be another state then: lead it to a state first."
            )
    made = tuple(_brought(state, holder, ends, numbers, shared) for state in inside)
    made = _placed(made, holder)
    _refuse_inner_ends(project, file, made)
    at = source.states.index(holder)
    states = (*source.states[:at], *made, *source.states[at + 1 :])
    start = source.start
    if start is None and states[0].no != source.start_no:
        start = source.start_no
    after = replace(source, states=states, start=start)
    refuse_ways_back(after, made, holder.no)
    kind = "parts" if file in project.parts else "applications"
    return replace(project, **{kind: {**getattr(project, kind), file: after}})


def _is_end(event: Event) -> bool:
    return event.name is not None and (event.name == "done" or event.name.startswith("done."))


def _ends(part: Application, holder: State) -> dict[str, Event]:
    """The ends of the part that only lead on, with what the state around does then."""
    found: dict[str, Event] = {}
    for state in part.states:
        if not state.is_end:
            continue
        taken = [e for e in holder.events if e.name == f"done.{state.no}"]
        taken = taken or [e for e in holder.events if e.name == "done"]
        if not taken:
            continue
        if len(taken) > 1 or taken[0].when is not None or taken[0].next in (None, BACK, AGAIN):
            raise NoPart(
                f"What follows {called(state)} depends on more than the end of the part: let "
                f"{taken[0].name} lead to one state, without a condition, first."
            )
        if state.actions or state.screen is not None or state.events or state.timeout is not None:
            raise NoPart(
                f"{called(state)} of the part says or does something and then ends it: let an "
                "empty state after it be the end first."
            )
        if state.no == part.start_no:
            raise NoPart(f"{called(state)} of the part begins and ends it: there is nothing in it.")
        found[state.no] = taken[0]
    return found


def _numbers(
    source: Application, inside: tuple[State, ...], first: str, begin: str
) -> dict[str, str]:
    """The new number of each state of the part."""
    taken = {state.no for state in source.states}
    found: dict[str, str] = {begin: first}
    for state in inside:
        if state.no == begin:
            continue
        no, number = state.no, 1
        while no in taken:
            number += 1
            no = f"{state.no}-{number}"
        taken.add(no)
        found[state.no] = no
    return found


def _brought(
    state: State,
    holder: State,
    ends: Mapping[str, Event],
    numbers: Mapping[str, str],
    shared: tuple[Event, ...],
) -> State:
    def event(value: Event) -> Event:
        if value.next is not None and value.next in ends:
            done = ends[value.next]
            return replace(value, next=done.next, actions=(*value.actions, *done.actions))
        return replace(value, next=numbers.get(value.next or "", value.next))

    events = tuple(event(one) for one in state.events)
    timeout = state.timeout
    if timeout is not None and timeout.next is not None and timeout.next in ends:
        done = ends[timeout.next]
        if done.actions:
            raise NoPart(
                f"The timeout of {called(state)} ends the part, and {done.name} does something "
                "on the way, which a timeout can not: let that state do it first."
            )
        timeout = replace(timeout, next=done.next)
    elif timeout is not None:
        timeout = replace(timeout, next=numbers.get(timeout.next or "", timeout.next))
    return replace(
        state,
        no=numbers[state.no],
        always=holder.always,
        timeout=timeout,
        events=(*events, *shared),
    )


def _placed(made: tuple[State, ...], holder: State) -> tuple[State, ...]:
    """Cards as they lay in the part, the first one where the part's card was."""
    first = next(state for state in made if state.no == holder.no).aside.position
    at = holder.aside.position
    if first is None or at is None:
        return made
    return tuple(
        replace(state, aside=state.aside.at(spot[0] + at[0] - first[0], spot[1] + at[1] - first[1]))
        if (spot := state.aside.position) is not None
        else state
        for state in made
    )


def _refuse_inner_ends(project: Project, file: str, made: tuple[State, ...]) -> None:
    """An end that nobody waited for would end the part around."""
    end = next((state for state in made if state.is_end), None)
    runs = [a.name for a in project.flows.values() for s in a.states if s.flow == file]
    if end is not None and runs:
        raise NoPart(
            f"{called(end)} would be an end for which {runs[0]} waits: lead it to a state first."
        )
