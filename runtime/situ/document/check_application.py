"""What is wrong inside one application (formats.md, *RBD*)."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from difflib import get_close_matches
from itertools import count

from situ.document import names
from situ.document.aside import Aside
from situ.document.check_values import check_values
from situ.document.datatypes import shown
from situ.document.finding import Files, Findings, Place
from situ.document.mend import change, put_in, take_out
from situ.document.place import Path
from situ.document.problem import Change, Mend
from situ.document.project import Project
from situ.document.rbd import (
    AGAIN,
    BACK,
    VISIBLE_ACTIONS,
    Action,
    Add,
    Append,
    Application,
    Button,
    Clear,
    Event,
    Image,
    Input,
    Launch,
    List,
    Message,
    Movie,
    Repeat,
    Robot,
    Screen,
    Service,
    Set,
    Sound,
    Speech,
    State,
    Take,
    Timeout,
    resource_of,
)

_URL = re.compile(r"https?://\S|board:[^/\s]+/\S|media:\S", re.IGNORECASE)
MOST_LOOKED_FOR = 30
"""Targets that are no states and for which the nearest state is looked for, in one application."""

_ELSEWHERE = re.compile(r"https?://|data:", re.IGNORECASE)


USUAL = ("screen", "speech")
"""The resources that most applications use sooner or later."""


def to_declare(project: Project, application: Application) -> tuple[str, ...]:
    """With which resources an application is declared: those that it uses, and the usual ones
    while it uses none, so that its first speech or screen is no error.
    """
    return tuple(sorted(one for one in used_resources(project, application) if one)) or USUAL


def used_resources(project: Project, application: Application) -> dict[str, Aside]:
    """What the states of an application ask for, parts included, and one value that does.

    ``<screen/>`` gives the screen back and uses none, unless ``always`` has a screen.
    """
    used: dict[str, Aside] = {}
    seen: set[str] = set()
    waiting = [application]
    while waiting:
        one = waiting.pop()
        for screen in (s.screen for s in (one.always, *one.states) if s is not None):
            if screen is not None and not screen.is_empty:
                used.setdefault("screen", screen.aside if one is application else Aside())
        for state in one.states:
            for action in state.actions:
                resource = resource_of(action)
                if resource is not None:
                    used.setdefault(resource, action.aside if one is application else Aside())
            if state.flow is not None and state.flow not in seen:
                seen.add(state.flow)
                part = project.flow(state.flow)
                if part is not None:
                    waiting.append(part)
    return used


def check_application(
    found: Findings, application: Application, project: Project, files: Files
) -> None:
    """Tells what is wrong inside an application; nothing about other files but those it names."""
    check_values(found, application)
    _Check(found, application, project, files).run()


class _Check:
    def __init__(
        self, found: Findings, application: Application, project: Project, files: Files
    ) -> None:
        self.found = found
        self.application = application
        self.project = project
        self.files = files
        self.numbers = {state.no for state in application.states}
        self.targets = {None, AGAIN, BACK, *self.numbers}
        self.free = 1
        self.named: dict[str | None, str] = {}
        self.near: dict[str, str | None] = {}
        self.own = f"module/{application.name}/"

    def run(self) -> None:
        application, error = self.application, self.found.error
        if not application.states:
            said = "The application has no state: add one"
            mend = Mend(self.found.file, "Add a state", (put_in(("states", 0), State("1")),))
            error("no-state", said, application.aside, mend=mend)
        elif application.start is not None and application.start not in self.numbers:
            said = (
                f"The application starts in state {shown(application.start)}, which does not "
                f"exist{self.states()}"
            )
            first = self.nearest(application.start) or application.states[0].no
            made = self.mend(
                f"Start in state {shown(first)}", change((), application, "start", first)
            )
            error("dangling-start", said, application.aside, mend=made)
        always = application.always
        if always is not None:
            self.timeout(always.timeout, ("always", "timeout"), ("always", "timeout"))
            self.screen(always.screen, ("always", "screen"), ("always", "screen"), set())
            for index, event in enumerate(always.events):
                at = ("always", "events", index)
                self.event(event, ("always", "event", str(index)), at)
        shown_always: set[str] = set()
        if always is not None and always.screen is not None:
            shown_always = {one.id for one in always.screen.components}
        seen: set[str] = set()
        parts = {state.no for state in application.states if state.flow is not None}
        for index, state in enumerate(application.states):
            path: Path = ("states", index)
            if state.no in seen:
                said = f"There are two states {shown(state.no)}: give this one another no"
                error(
                    "double-state", said, state.aside, ("state", state.no), self.number(state, path)
                )
            seen.add(state.no)
            if state.no.rpartition("/")[0] in parts:
                said = (
                    f"{shown(state.no)} is the number of a state inside the part: give this one "
                    "another no"
                )
                error(
                    "double-state", said, state.aside, ("state", state.no), self.number(state, path)
                )
            self.state(state, path, shown_always if state.always else set())

    def mend(self, words: str, *changes: Change) -> Mend:
        return Mend(self.found.file, words, changes)

    def states(self) -> str:
        some = [state.no[:40] for state in self.application.states[:6]]
        more = ", …" if len(self.application.states) > len(some) else ""
        return f"; the states are {', '.join(some)}{more}"

    def nearest(self, meant: str) -> str | None:
        """The state that ``meant`` is the name of, or else nearly the number of.

        Looking through all numbers takes long, so that it is not done for too many.
        """
        if not self.named:
            self.named = {state.name: state.no for state in reversed(self.application.states)}
        if meant in self.named:
            return self.named[meant]
        if meant not in self.near and len(self.near) < MOST_LOOKED_FOR:
            close = get_close_matches(meant[:40], sorted(self.numbers), n=1)
            self.near[meant] = close[0] if close else None
        return self.near.get(meant)

    def number(self, state: State, path: Path) -> Mend:
        """A number that no state has yet."""
        free = self.free = next(n for n in count(self.free) if str(n) not in self.numbers)
        return self.mend(f"Give it the number {free}", change(path, state, "no", str(free)))

    def state(self, state: State, path: Path, always: set[str]) -> None:
        # Places are made only where there may be something to tell.
        place = ("state", state.no)
        if state.timeout is not None and state.timeout.next not in self.targets:
            self.timeout(state.timeout, (*place, "timeout"), (*path, "timeout"))
        if state.screen is not None:
            self.screen(state.screen, (*place, "screen"), (*path, "screen"), always)
        for index, action in enumerate(state.actions):
            if isinstance(action, (Speech, Robot, Launch)):
                continue
            self.action(action, (*place, "action", str(index)), (*path, "actions", index))
            if isinstance(action, Repeat):
                said = (
                    "Saying again cannot stand among a state's actions: put it into an event that "
                    "leads nowhere, or take it out"
                )
                at = (*place, "action", str(index))
                self.misplaced(said, action, at, (*path, "actions", index))
        for index, event in enumerate(state.events):
            if event.name is None or event.actions or event.next not in self.targets:
                self.event(event, (*place, "event", str(index)), (*path, "events", index))
        if state.flow is not None:
            self.flow(state, state.flow, place)

    def flow(self, state: State, file: str, place: Place) -> None:
        error = self.found.error
        for there, name in (
            (state.timeout, "timeout"),
            (state.screen, "screen"),
            (state.actions, "actions"),
        ):
            if there:
                said = (
                    f"A state that runs a part has no {name} of its own: "
                    "move it into a state beside it, or into the part"
                )
                error("flow-with-content", said, state.aside, place)
        aside = state.aside.part("flow")
        if file in self.project.parts or file in self.project.applications or not file.strip():
            return
        if not self.files.inside(file):
            said = f"The part {shown(file)} leads out of the project: its files lie in its folder"
            error("path-outside", said, aside, place)
        elif not self.files.has(file):
            said = f"There is no file {shown(file)} for this part: add it, or name another"
            error("missing-file", said, aside, place)
        else:
            said = (
                f"{shown(file)} cannot be run as a part: it must be an application that can be read"
            )
            error("wrong-document", said, aside, place)

    def next(self, held: Event | Timeout, place: Place, path: Path) -> None:
        target = held.next
        if target is None or target in self.targets:
            return
        who = "timeout"
        if isinstance(held, Event):
            who = f"event {shown(held.name)}" if held.name is not None else "unnamed event"
        said = f"The {who} leads to state {shown(target)}, which does not exist{self.states()}"
        near = self.nearest(target)
        made = near and self.mend(f"Lead to state {shown(near)}", change(path, held, "next", near))
        self.found.error("dangling-next", said, held.aside, place, made or None)

    def misplaced(self, said: str, repeat: Repeat, place: Place, path: Path) -> None:
        made = self.mend("Take out what says it again", take_out(path, repeat))
        self.found.error("misplaced-repeat", said, repeat.aside, place, made)

    def timeout(self, timeout: Timeout | None, place: Place, path: Path) -> None:
        if timeout is not None:
            self.next(timeout, place, path)

    def screen(self, screen: Screen | None, place: Place, path: Path, always: set[str]) -> None:
        if screen is None:
            return
        if screen.background is not None and re.search(r"[./]", screen.background):
            self.media(screen.background, screen.aside, place)
        seen: set[str] = set()
        for index, component in enumerate(screen.components):
            at = (*place, component.id)
            if component.id in seen or component.id in always:
                where = (
                    "on this screen" if component.id in seen else "here and in what every state has"
                )
                said = f"There are two components {shown(component.id)} {where}: rename one"
                free = another(component.id, {one.id for one in screen.components} | always)
                rename = change((*path, "components", index), component, "id", free)
                made = self.mend(f"Call it {shown(free)}", rename)
                self.found.error("double-component", said, component.aside, at, made)
            seen.add(component.id)
            if isinstance(component, (Image, Movie)):
                self.media(component.src, component.aside, at)
            if isinstance(component, (Button, Input, List)) and component.tag is not None:
                self.writes(component.tag, component.aside, at)

    def event(self, event: Event, place: Place, path: Path) -> None:
        error = self.found.error
        self.next(event, place, path)
        if event.name is None:
            if event.next is None:
                said = (
                    "An event without a name is taken as soon as its condition holds: let it lead "
                    "to a state"
                )
                error("event-without-next", said, event.aside, place)
            if event.says:
                said = "What people say raises an event by its name: give this event a name"
                error("say-without-name", said, event.says[0].aside, (*place, "say", "0"))
        for index, action in enumerate(event.actions):
            at = (*place, "action", str(index))
            self.action(action, at, (*path, "actions", index))
            if isinstance(action, VISIBLE_ACTIONS):
                said = (
                    f"A {action.element} action cannot stand in an event: what the robot visibly "
                    "does belongs to a state; move it to the state to which the event leads"
                )
                made = self.move(event, action, (*path, "actions", index))
                error("visible-action", said, action.aside, at, made)
            elif isinstance(action, Repeat) and event.next is not None:
                said = (
                    "Only an event that leads nowhere can say again: take that out, or let the "
                    "event lead nowhere"
                )
                self.misplaced(said, action, at, (*path, "actions", index))

    def move(self, event: Event, action: Action, path: Path) -> Mend | None:
        """To put an action of an event before those of the state to which that leads."""
        states = self.application.states
        at = next((i for i, one in enumerate(states) if one.no == event.next), None)
        if at is None or states[at].flow is not None:
            return None
        inside = put_in(("states", at, "actions", 0), action)
        return self.mend(f"Move it to state {shown(states[at].no)}", take_out(path, action), inside)

    def action(self, action: Action, place: Place, path: Path) -> None:
        if isinstance(action, Sound):
            self.media(action.src, action.aside, place)
        elif isinstance(action, Service):
            self.service(action, place)
        elif isinstance(action, (Set, Add, Append)):
            self.writes(action.tag, action.aside, place)
        elif isinstance(action, Take):
            self.writes(action.tag, action.aside, place)
            self.writes(action.source, action.aside, place)
        elif isinstance(action, Clear):
            if names.is_reserved(action.tag):
                said = (
                    "What the robot itself keeps is never cleared, so clearing "
                    f"{shown(action.tag)} has no effect: take it out, or name a tag of your own"
                )
                made = self.mend("Take it out", take_out(path, action))
                self.found.warning("reserved-tag", said, action.aside, place, made)
        elif isinstance(action, Message) and action.params and action.text:
            said = (
                "A message with values sends these, so its text is never sent: take one of them out"
            )
            made = self.mend("Take the text out", change(path, action, "text", ""))
            self.found.warning("text-and-params", said, action.aside, place, made)

    def service(self, service: Service, place: Place) -> None:
        for index, result in enumerate(service.results):
            self.writes(result.tag, result.aside, (*place, "result", str(index)))
        url = service.url
        if not url or (url.startswith("{") and names.references(url)):
            return
        if _URL.match(url) is None:
            said = (
                f"The address of a service cannot be {shown(url)}: begin with http://, https://, "
                "board:module/request, media: or a reference"
            )
            self.found.error("bad-url", said, service.aside, place)
        elif url.lower().startswith("media:"):
            self.media(url[6:], service.aside, place)

    def writes(self, tag: str, aside: Aside, place: Place) -> None:
        if names.is_reserved(tag) and not tag.startswith(self.own):
            said = f"{shown(tag)} is written by the robot itself only: choose another tag"
            self.found.error("reserved-tag", said, aside, place)

    def media(self, src: str, aside: Aside, place: Place) -> None:
        if not _is_file(src):
            return
        file = f"{self.project.media}/{src}" if self.project.media is not None else src
        if not self.files.inside(src) or not self.files.inside(file):
            said = f"{shown(src)} leads out of the project: its media lie inside its folder"
            self.found.error("path-outside", said, aside, place)
        elif self.project.toml is not None and not self.files.has(file):
            where = (
                f"in {self.project.media}" if self.project.media is not None else "in the project"
            )
            said = f"There is no file {shown(src)} {where}: add it, or name another"
            self.found.error("missing-media", said, aside, place)


def media_of(application: Application) -> Iterator[str]:
    """The files that an application shows, plays and reads, but for those that a value names."""
    screens = [one.screen for one in (application.always, *application.states) if one is not None]
    events = [e for one in (application.always, *application.states) if one for e in one.events]
    for screen in screens:
        if screen is not None:
            named = [one.src for one in screen.components if isinstance(one, (Image, Movie))]
            yield from (one for one in (*named, screen.background) if one and _is_file(one))
    held = [a for state in application.states for a in state.actions]
    for action in (*held, *(a for event in events for a in event.actions)):
        if isinstance(action, Sound) and _is_file(action.src):
            yield action.src
        elif isinstance(action, Service) and action.url.lower().startswith("media:"):
            yield action.url[6:]


def another(name: str, known: Collection[str]) -> str:
    """A name like ``name`` that is not among ``known``: with the next free number behind it."""
    return next(f"{name}-{n}" for n in count(2) if f"{name}-{n}" not in known)


def _is_file(src: str) -> bool:
    return bool(src.strip()) and not _ELSEWHERE.match(src) and not names.references(src)
