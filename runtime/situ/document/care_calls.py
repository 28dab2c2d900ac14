"""Care with calls for help: that they get out while the robot is busy with something else."""

from __future__ import annotations

import re
from collections.abc import Iterator

from msgspec import Struct

from situ.document.analysis_search import Search
from situ.document.aside import Aside
from situ.document.care_ways import Way, sources
from situ.document.datatypes import shown
from situ.document.finding import Place
from situ.document.project import Project
from situ.document.rbd import (
    Action,
    Always,
    Application,
    Message,
    Robot,
    Screen,
    Service,
    Sound,
    Speech,
)

CALLING = frozenset(("alarm", "alert", "call", "carer", "emergency", "help", "nurse", "sos"))
"""A message or a service calls a person where one of these words is in its topic or its name."""

_WORD = re.compile(r"[A-Z]?[a-z]+|[A-Z]+")


class Call(Struct, frozen=True, eq=False):
    """A place from which somebody is called; ``held``: the situation and what suspends it there;
    None where nothing does.
    """

    topic: str
    file: str
    aside: Aside
    place: Place
    held: str | None


def suspended_calls(search: Search, along: dict[str, list[Way]]) -> None:
    """``suspended-call``: a person is called, but only from where a situation can suspend it.

    A suspended application starts no action and hears no event. It can be suspended where it
    uses a resource (a screen it surely keeps is one) and a situation gives it no priority, or
    gives another module that declared such a resource the same or a higher one. Calls of one
    topic or name are one call: one sure way is enough. Nothing is said without a script.
    """
    calls: dict[str, list[Call]] = {}
    if search.project.spds is None:
        return
    for call in _calls(search.project, along):
        calls.setdefault(call.topic, []).append(call)
    for topic, made in calls.items():
        if any(call.held is None for call in made):
            continue
        message = (
            f"The call {shown(topic)} may wait: {made[0].held}, and then nothing is sent; send it "
            "(too) from an application that uses neither screen nor speech nor robot"
        )
        search.warn(made[0].file, "suspended-call", message, made[0].aside, made[0].place)


def _calls(project: Project, along: dict[str, list[Way]]) -> Iterator[Call]:
    for file, application in project.applications.items():
        suspends = _Suspends(project, application)
        waiting: list[tuple[str, Application, frozenset[str]]] = [(file, application, frozenset())]
        seen = {file}
        while waiting:
            at, one, outer = waiting.pop()
            always = one.always if one.always is not None else Always()
            kept = _keeps(one, along[at])
            shared: list[str | None] = []
            for state in one.states:
                own = outer | _used(always.screen if state.always else None, ())
                uses = own | _used(state.screen, state.actions)
                uses |= {"screen"} if state.no in kept else set()
                held = suspends.by(uses)
                place: Place = ("state", state.no)
                yield from _sent(at, state.actions, (*place, "action"), held)
                for index, event in enumerate(state.events):
                    yield from _sent(
                        at, event.actions, (*place, "event", str(index), "action"), held
                    )
                if state.always:
                    shared.append(held)
                part = project.flow(state.flow) if state.flow is not None else None
                if part is not None and state.flow is not None and state.flow not in seen:
                    seen.add(state.flow)
                    waiting.append((state.flow, part, own))
            held = None if None in shared or not shared else shared[0]
            for index, event in enumerate(always.events):
                yield from _sent(at, event.actions, ("always", "event", str(index), "action"), held)


def _sent(file: str, actions: tuple[Action, ...], place: Place, held: str | None) -> Iterator[Call]:
    for index, action in enumerate(actions):
        named = action.topic if isinstance(action, Message) else ""
        named = action.name if isinstance(action, Service) else named
        if CALLING & {word.lower() for word in _WORD.findall(named)}:
            yield Call(named, file, action.aside, (*place, str(index)), held)


def _used(screen: Screen | None, actions: tuple[Action, ...]) -> frozenset[str]:
    """The resources that a state cannot be without."""
    used = set()
    if screen is not None and not screen.is_empty:
        used.add("screen")
    for action in actions:
        if isinstance(action, (Speech, Sound)) and not action.optional:
            used.add("speech")
        elif isinstance(action, Robot) and not action.optional:
            used.add(action.resource)
    return frozenset(used)


def _keeps(application: Application, along: list[Way]) -> set[str]:
    """The states without a screen that surely keep one: whatever leads to them has one."""
    into = sources(along)
    bare = {s.no for s in application.states if s.screen is None and s.flow is None}
    has = {s.no for s in application.states if _used(s.screen, ())}
    start = application.start_no
    kept = {no for no in bare if no != start and into.get(no)}
    while True:
        left = {no for no in kept if into[no] <= has | kept}
        if left == kept:
            return kept
        kept = left


class _Suspends:
    """The situations of a project, as one of its applications meets them."""

    def __init__(self, project: Project, application: Application) -> None:
        assert project.spds is not None
        self._name = application.name
        self._project = project
        self._situations = [(s.name, project.spds.priorities(s)) for s in project.spds.situations]
        self._by: dict[frozenset[str], str | None] = {}

    def by(self, uses: frozenset[str]) -> str | None:
        """What can take one of these resources away, in words."""
        if uses not in self._by:
            self._by[uses] = self._find(uses) if uses else None
        return self._by[uses]

    def _find(self, uses: frozenset[str]) -> str | None:
        for name, priorities in self._situations:
            own = priorities.get(self._name)
            if own is None:
                return f"in the situation {shown(name)} {shown(self._name)} has no priority"
            for module, priority in priorities.items():
                if module != self._name and priority >= own:
                    taken = uses & set(self._project.resources(module) or ())
                    if taken:
                        return (
                            f"in the situation {shown(name)} {shown(module)} may have "
                            f"{sorted(taken)[0]}"
                        )
        return None
