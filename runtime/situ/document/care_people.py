"""Care with whoever stands there: that they find back, and that nobody else learns of them."""

from __future__ import annotations

from collections.abc import Iterator

from situ.document import names, words
from situ.document.analysis_data import shown_names
from situ.document.analysis_search import Search
from situ.document.care_every import home
from situ.document.care_mend import puts
from situ.document.care_speech import literal
from situ.document.care_ways import Way, backward, few, forward, may_be_part, serves, sources
from situ.document.datatypes import shown
from situ.document.project import Project
from situ.document.rbd import Application, Component, Input, Screen, Speech, State, Timeout
from situ.document.spoken import estimate

PATIENCE = 10
"""Seconds that people wait before they turn to something else (Nielsen, *Usability Engineering*,
1993, 5.5).
"""

AWAY = 60
"""Seconds after which the mend of ``private-stays`` takes a screen away."""


# -- finding back ------------------------------------------------------------------


def only_waiting(search: Search, file: str, application: Application, along: list[Way]) -> None:
    """``no-way-back-by-hand``: from a state that is reached, the start state or an end can be
    reached, but only by waiting more than ``PATIENCE`` seconds, after the speech, for a timeout.

    What an event from elsewhere does counts as a way. Told once an application; of applications
    in which a person can do anything at all; in parts nothing is said: what holds them may serve.
    """
    start = application.start_no
    if start is None or may_be_part(search, file) or not any(w.by == "hand" for w in along):
        return
    leaving = {way.source for way in along}
    ends = {start, *(s.no for s in application.states if s.final or s.no not in leaving)}
    long = {state.no for state in application.states if _waits(application, state) > PATIENCE}
    short = [way for way in along if way.by != "time" or way.source not in long]
    back = backward(ends, short)
    caught = (forward([start], along) & backward(ends, along)) - back
    lost = [state for state in application.states if state.no in caught]
    if not lost:
        return
    message = (
        f"From {few(lost)} nobody comes back to the start but by waiting for a timeout: add a "
        "button or a phrase that leads back, best a Home button in every state"
    )
    mend = home(search, file, application, lost)
    search.warn(file, "no-way-back-by-hand", message, lost[0].aside, ("state", lost[0].no), mend)


def _waits(application: Application, state: State) -> float:
    """Seconds of a state's timeout after what is said."""
    timeout = serves(application, state)
    if timeout is None:
        return 0
    texts = [literal(one.text) for one in state.actions if isinstance(one, Speech)]
    said = 0 if timeout.idle else sum(estimate(text) for text in texts if text)
    return timeout.seconds - said


# -- private data ------------------------------------------------------------------


def private_data(search: Search, along: dict[str, list[Way]]) -> None:
    """Private data (``[privacy]``) where anyone passes. Nobody has shown that they are there in a
    start state, after an idle timeout, and in the states to which no hand leads from these:

    ``private-spoken``: a speech there has a private value; ``private-shown``: a component there,
    or the screen kept there from before. ``private-stays``: a screen with private values that a
    person has called up, in a state of an application which nothing but a hand leaves.

    A name is private that a private tag begins. A pin is not shown. The start state of a part
    counts where its holder does, and so does what its end leads to where that end counts. A screen
    is not kept in states that leave by themselves, nor in the ends of parts.
    """
    project = search.project
    if not project.private:
        return
    files = project.flows
    alone = _alone(project, along)
    for file, application in files.items():
        by_itself = {way.source for way in along[file] if way.by == "itself"}
        not_by_hand = {way.source for way in along[file] if way.by != "hand"}
        told: set[tuple[str, ...]] = set()
        for state in application.states:
            if state.no in alone[file]:
                _spoken(search, file, state)
                _shown(search, file, application, state, told)
                if state.no not in by_itself:
                    _keeps(search, file, application, state, along[file])
            elif file in project.applications and state.no not in not_by_hand:
                _stays(search, file, application, state)


def _alone(project: Project, along: dict[str, list[Way]]) -> dict[str, set[str]]:
    """File to the states in which nobody need be there."""
    files = project.flows
    starts: dict[str, set[str]] = {file: set() for file in files}
    for file, application in files.items():
        if file in project.applications and application.start_no is not None:
            starts[file].add(application.start_no)
        served = {state.no: serves(application, state) for state in application.states}
        idle = {no for no, timeout in served.items() if timeout is not None and timeout.idle}
        starts[file] |= {w.target for w in along[file] if w.by == "time" and w.source in idle}
    parts = {file: [s for s in one.states if s.flow in files] for file, one in files.items()}
    held = {file: {holder.no for holder in some} for file, some in parts.items()}
    # Where a part ends depends on who has done something in it: see below.
    free = {
        file: [
            way
            for way in some
            if way.by not in ("hand", "elsewhere")
            and not (way.by == "itself" and way.source in held[file])
        ]
        for file, some in along.items()
    }
    while True:
        known = sum(map(len, starts.values()))
        found = {file: forward(starts[file], free[file]) for file in files}
        for file, holders in parts.items():
            for holder in holders:
                assert holder.flow is not None
                part = files[holder.flow]
                if holder.no in found[file] and part.start_no is not None:
                    starts[holder.flow].add(part.start_no)
                ends = {one.no for one in part.states if one.is_end} & found[holder.flow]
                starts[file] |= {target for end in ends for target in _after(holder, end)}
        if known == sum(map(len, starts.values())):
            return found


def _after(holder: State, end: str) -> Iterator[str]:
    """Where the end of a part leads the state that holds it: by its own event, else by ``done``."""
    nexts = {event.name: event.next for event in reversed(holder.events)}
    target = nexts.get(f"done.{end}", nexts.get("done"))
    if target is not None:
        yield target


def _spoken(search: Search, file: str, state: State) -> None:
    for index, action in enumerate(state.actions):
        if not isinstance(action, Speech):
            continue
        secret = private_among(search.project, names.references(action.text))
        if secret is not None:
            message = (
                f"{shown(secret)} is private, and this says it before anybody has shown that they "
                "are there: say it after they have touched or said something"
            )
            place = ("state", state.no, "action", str(index))
            search.warn(file, "private-spoken", message, action.aside, place)


def _shown(
    search: Search,
    file: str,
    application: Application,
    state: State,
    told: set[tuple[str, ...]],
) -> None:
    """``told``: places of components of ``always`` that were told with another state."""
    for component, place in _on(application, state):
        secret = private_among(search.project, _names(component))
        if secret is not None and place not in told:
            told.add(place)
            message = (
                f"{shown(secret)} is private, and this shows it where anyone passes: show it after "
                "somebody has touched or said something"
            )
            search.warn(file, "private-shown", message, component.aside, place)


def _keeps(
    search: Search, file: str, application: Application, state: State, along: list[Way]
) -> None:
    is_left = state.is_end and file in search.project.parts
    if state.screen is not None or state.flow is not None or is_left:
        return
    for holder in _kept(application, state, along):
        assert holder.screen is not None
        for component in holder.screen.components:
            secret = private_among(search.project, _names(component))
            if secret is not None:
                message = (
                    f"This keeps the screen of {words.state(holder)}, with {shown(secret)}, where "
                    "anyone passes: give it a screen of its own, or an empty one"
                )
                place = ("state", state.no)
                search.warn(file, "private-shown", message, state.aside, place)
                return


def _stays(search: Search, file: str, application: Application, state: State) -> None:
    own = state.screen.components if state.screen is not None else ()
    secrets = (private_among(search.project, _names(component)) for component in own)
    secret = next((one for one in secrets if one is not None), None)
    if secret is None:
        return
    message = (
        f"This shows {shown(secret)}, which is private, until a hand takes it away, to anyone who "
        "comes after: add a timeout that leads to the start"
    )
    mend = None
    if serves(application, state) is None:
        away = Timeout(float(AWAY), application.start_no, True)
        said = f"Go to the start {AWAY} s after the last touch"
        mend = puts(search, file, ("state", state.no), state, said, timeout=away)
    place = ("state", state.no, "screen")
    assert state.screen is not None
    search.warn(file, "private-stays", message, state.screen.aside, place, mend)


def _on(application: Application, state: State) -> Iterator[tuple[Component, tuple[str, ...]]]:
    """The components of a state, those of ``always`` too."""
    layers: list[tuple[Screen | None, tuple[str, ...]]] = [(state.screen, ("state", state.no))]
    always = application.always_in(state)
    if always is not None:
        layers.append((always.screen, ("always",)))
    for screen, place in layers:
        for component in screen.components if screen is not None else ():
            yield component, (*place, "screen", component.id)


def _kept(application: Application, state: State, along: list[Way]) -> Iterator[State]:
    """The states whose own screen may still be shown in one that has none."""
    of = {one.no: one for one in application.states}
    into = sources(along)
    seen = {state.no}
    waiting = [state.no]
    while waiting:
        no = waiting.pop()
        for source in sorted(into.get(no, set()) - seen):
            seen.add(source)
            before = of[source]
            if before.screen is not None:
                yield before
            elif before.flow is None:
                waiting.append(source)


def _names(component: Component) -> Iterator[str]:
    yield from shown_names(component)
    if isinstance(component, Input) and component.kind != "pin":
        yield component.tag


def private_among(project: Project, used: Iterator[str] | tuple[str, ...]) -> str | None:
    """The first of these names that is private: that a private tag begins."""
    for name in used:
        parts = name.split(".")
        for count in range(1, len(parts) + 1):
            tag = ".".join(parts[:count])
            if any(names.matches(pattern, tag) for pattern in project.private):
                return name
    return None
