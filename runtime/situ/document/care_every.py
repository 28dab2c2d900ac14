"""What one click adds to every state: a button in a place that is free on all screens, with its
event; where no screen has room, or there is none, a phrase.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count

from msgspec.structs import replace

from situ.document.analysis_data import events, screens
from situ.document.analysis_search import Search
from situ.document.mend import change, of, put_in
from situ.document.problem import Change, Mend
from situ.document.rbd import (
    Action,
    Always,
    Application,
    Button,
    Component,
    Event,
    Image,
    Movie,
    Repeat,
    Say,
    Screen,
    State,
    Text,
)

SIZES = ((18.0, 12.0), (14.0, 10.0), (10.0, 9.5))
"""Width and height of a button, the best first: none below ``care_screen.TARGET``."""

WORDS = {"ja": {"Home": "ホーム", "Repeat": "もう一度"}}
"""What stands on a button, and is said, in projects that are not written in English."""

EDGE, STEP = 3, 2
"""Percent between a button and the screen's edge, and from one place that is tried to the next."""


def home(search: Search, file: str, application: Application, lacking: list[State]) -> Mend | None:
    """A way to the start by hand. None where one of those that lack it takes nothing of always."""
    return _adds(search, file, application, lacking, "Home", application.start_no, ())


def repeat(
    search: Search, file: str, application: Application, lacking: list[State]
) -> Mend | None:
    """A way to hear again what was said. None as for ``home``."""
    return _adds(search, file, application, lacking, "Repeat", None, (Repeat(),))


def _adds(
    search: Search,
    file: str,
    application: Application,
    lacking: list[State],
    called: str,
    target: str | None,
    actions: tuple[Action, ...],
) -> Mend | None:
    if of(search.project, file) is not application or not all(one.always for one in lacking):
        return None
    taken = {e.name or "" for one in search.project.flows.values() for e, _ in events(one)}
    event = Event(name=_another(f"click{called}", taken), next=target, actions=actions)
    language = next(iter(search.project.languages), "en")
    text = WORDS.get(language, {}).get(called, called)
    every = list(screens(application))
    spot = _free(list(_around(search, file, application)), called == "Home") if every else None
    if spot is None:
        event = replace(event, says=(Say(text.lower()),))
        said = f"Let people say “{text.lower()}” in every state"
        return search.mend(file, said, *_into(application, event, None))
    ids = {component.id for screen, _ in every for component in screen.components}
    x, y, width, height = spot
    button = Button(
        id=_another(called.lower(), ids),
        x=x,
        y=y,
        width=width,
        height=height,
        event=event.name,
        text=text,
    )
    said = f"Add a {text} button to every state"
    return search.mend(file, said, *_into(application, event, button))


def _into(application: Application, event: Event, button: Button | None) -> Iterator[Change]:
    always = application.always
    screen = Screen(components=(button,)) if button is not None else None
    if always is None:
        yield change((), application, "always", Always(screen=screen, events=(event,)))
        return
    yield put_in(("always", "events", len(always.events)), event)
    if button is not None and always.screen is not None:
        yield put_in(("always", "screen", "components", len(always.screen.components)), button)
    elif screen is not None:
        yield change(("always",), always, "screen", screen)


def _around(search: Search, file: str, application: Application) -> Iterator[Component]:
    """What may be shown together with what this file's always has, and may not be covered."""
    project = search.project
    shown = [screen for screen, _ in screens(application)]
    if any(state.flow is not None for state in application.states):
        shown += [screen for one in project.parts.values() for screen, _ in screens(one)]
    if file in project.parts:
        outer = (one.always for one in project.flows.values())
        shown += [one.screen for one in outer if one is not None and one.screen is not None]
    for screen in shown:
        for one in screen.components:
            # A picture or a panel may lie beneath.
            if not (isinstance(one, (Image, Movie)) or (isinstance(one, Text) and not one.text)):
                yield one


def _free(components: list[Component], left: bool) -> tuple[float, float, float, float] | None:
    """x, y, width and height of a place that covers none, as near as can be to an upper corner."""
    for width, height in SIZES:
        across = range(EDGE, int(100 - EDGE - width) + 1, STEP)
        for y in range(EDGE, int(100 - EDGE - height) + 1, STEP):
            for x in across if left else reversed(across):
                if not any(
                    x < one.x + one.width
                    and one.x < x + width
                    and y < one.y + one.height
                    and one.y < y + height
                    for one in components
                ):
                    return float(x), float(y), width, height
    return None


def _another(name: str, taken: set[str]) -> str:
    """The name, with a number where it is taken."""
    return (
        name
        if name not in taken
        else next(f"{name}{n}" for n in count(2) if f"{name}{n}" not in taken)
    )
