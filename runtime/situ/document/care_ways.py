"""The ways of an application as a person meets them: what a hand does, and what time does.

Guards are taken to hold, so there is never less of a way here than the robot has.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Literal

from msgspec import Struct

from situ.document import words
from situ.document.analysis_data import events, holders, screens
from situ.document.analysis_search import Search
from situ.document.project import Project
from situ.document.rbd import (
    BACK,
    TIMED_OUT,
    Action,
    Always,
    Application,
    Button,
    Event,
    Input,
    List,
    Movie,
    Screen,
    State,
    Timeout,
)

By = Literal["hand", "time", "itself", "outside", "elsewhere"]


class Way(Struct, frozen=True, eq=False):
    """From a state to a state.

    by: ``hand``: a person touches, enters, chooses or says something; ``time``: a timeout;
    ``itself``: something that runs in the state has ended, or nothing is waited for;
    ``outside``: a condition, or an event that nothing in the project raises; ``elsewhere``: an
    event that something raises, but not in this state.
    """

    source: str
    target: str
    by: By


def may_be_part(search: Search, file: str) -> bool:
    """Whether another file holds this one, or may: one that is read alone and has an end."""
    if search.whole:
        return file in search.project.parts
    application = search.project.flow(file)
    return application is not None and any(state.is_end for state in application.states)


def handed(project: Project) -> set[str]:
    """The events that what is shown or said can raise, anywhere in the project: a part's events
    may come from a screen outside of it.
    """
    found: set[str] = set()
    for application in project.flows.values():
        for screen, _ in screens(application):
            if screen.touched is not None:
                found.add(screen.touched)
            for component in screen.components:
                if isinstance(component, (Button, Input, List)) and component.event is not None:
                    found.add(component.event)
        for event, _ in events(application):
            if event.says and event.name is not None:
                found.add(event.name)
    return found


def expected(application: Application, state: State) -> Iterator[Event]:
    """The events that a state expects, its own first."""
    yield from state.events
    always = application.always_in(state)
    if always is not None:
        yield from always.events


def serves(application: Application, state: State) -> Timeout | None:
    """The timeout that serves in a state."""
    if state.timeout is not None:
        return state.timeout
    always = application.always_in(state)
    return always.timeout if always is not None else None


def every_way(project: Project) -> dict[str, list[Way]]:
    """File to the ways of its application."""
    by_hand = handed(project)
    raised = {name for one in project.flows.values() for name in _raised(one)}
    return {file: _ways(one, by_hand, raised) for file, one in project.flows.items()}


def _ways(application: Application, by_hand: set[str], raised: set[str]) -> list[Way]:
    """Every way between different states; ``#back`` leads to wherever a state is entered from."""
    numbers = {state.no for state in application.states}
    found: list[Way] = []
    backs: list[tuple[str, By]] = []
    always = application.always if application.always is not None else Always()
    shared = set(_raised_by(always.screen, _held(always)))
    for state in application.states:
        own = set(_raised_by(state.screen, [*state.actions, *_held(state)]))
        own |= shared if state.always else set()
        part = state.flow is not None
        nexts: list[tuple[str | None, By]] = [
            (event.next, _by(event, by_hand, own, raised, part))
            for event in expected(application, state)
        ]
        timeout = serves(application, state)
        if timeout is not None:
            nexts.append((timeout.next, _TIME))
        for target, by in nexts:
            if target == BACK:
                backs.append((state.no, by))
            elif target in numbers and target != state.no and target is not None:
                found.append(Way(state.no, target, by))
    into = sources(found)
    for no, by in backs:
        found += [Way(no, source, by) for source in sorted(into.get(no, ()))]
    return found


_TIME: By = "time"


def _by(event: Event, by_hand: set[str], own: set[str], raised: set[str], part: bool) -> By:
    if event.name is None:
        return "itself" if event.when is None else "outside"
    if event.name in by_hand:
        return "hand"
    if event.name == TIMED_OUT:
        return "time"
    if event.name == "done" or event.name.startswith("done."):
        # A part that ends raises it; what else does raises it as any other.
        return "itself" if part or event.name in own else "elsewhere"
    if event.name in own:
        return "itself"
    return "elsewhere" if event.name in raised else "outside"


def _raised(application: Application) -> Iterator[str]:
    """The events that the actions and movies of an application raise."""
    for holder, _ in holders(application):
        own = holder.actions if isinstance(holder, State) else ()
        yield from _raised_by(holder.screen, [*own, *_held(holder)])


def _held(holder: Always | State) -> list[Action]:
    return [action for event in holder.events for action in event.actions]


def _raised_by(screen: Screen | None, held: Iterable[Action]) -> Iterator[str]:
    for action in held:
        yield from (name for name in (action.done, action.failed) if name is not None)
    for one in screen.components if screen is not None else ():
        if isinstance(one, Movie):
            yield from (name for name in (one.done, one.failed) if name is not None)


def sources(along: Iterable[Way]) -> dict[str, set[str]]:
    """By number of a state, those from which a way leads there."""
    found: dict[str, set[str]] = {}
    for way in along:
        found.setdefault(way.target, set()).add(way.source)
    return found


def forward(starts: Iterable[str], along: Iterable[Way]) -> set[str]:
    """The states to which ways lead, the first ones included."""
    out: dict[str, list[str]] = {}
    for way in along:
        out.setdefault(way.source, []).append(way.target)
    reached = set(starts)
    waiting = list(reached)
    while waiting:
        for target in out.get(waiting.pop(), ()):
            if target not in reached:
                reached.add(target)
                waiting.append(target)
    return reached


def backward(ends: Iterable[str], along: Iterable[Way]) -> set[str]:
    """The states from which ways lead to these, they included."""
    return forward(ends, [Way(way.target, way.source, way.by) for way in along])


def few(states: Sequence[State]) -> str:
    """The first states in words, and how many more there are."""
    named = [words.state(state) for state in states]
    told = words.listed([*named[:4], f"{len(named) - 4} more"] if len(named) > 5 else named)
    return f"the states {told}" if len(named) > 1 else f"the state {told}"
