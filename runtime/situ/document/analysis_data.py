"""Data: who writes which tag of a project, who uses it, and what is known of its values."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any

from situ.document import names
from situ.document.aside import Aside
from situ.document.check_application import used_resources
from situ.document.condition import Condition, Group, Test
from situ.document.finding import Place
from situ.document.project import Project
from situ.document.rbd import (
    Action,
    Add,
    Always,
    Append,
    Application,
    Button,
    Component,
    Event,
    Image,
    Input,
    Launch,
    List,
    Message,
    Movie,
    Param,
    Robot,
    Screen,
    Service,
    Set,
    Sound,
    Speech,
    State,
    Take,
    Text,
)
from situ.document.value_sets import (
    ANY,
    BOOLEAN,
    LIST,
    NOTHING_EVER,
    NUMBER,
    OBJECT,
    TEXT,
    Domain,
    refers,
)
from situ.document.values import is_number, read

CLOCK = ("clock.time", "clock.date", "clock.weekday")
BOARD = "board:"
"""How the address of a module's service begins."""
_TIMES = tuple(f"{hour:02}:{minute:02}" for hour in range(24) for minute in range(60))
_APPLICATION = ("", "state", "name", "suspended")
_SERVICE = {"ok": BOOLEAN, "status": NUMBER, "error": TEXT}

Use = tuple[str, Aside, Place]
"""A name whose value is tested, shown, spoken or sent, and where."""


class Data:
    """Who writes what in a project."""

    def __init__(self, project: Project) -> None:
        self._project = project
        self._applications = {a.name: a for a in project.applications.values()}
        self.written: set[str] = set(project.tags)
        """Tags that something in the project writes."""
        self.asks_modules = False
        """Whether a service is a module's."""
        self._kinds: dict[str, set[str]] = {}
        self._services: set[str] = set()
        self._known: dict[str, bool] = {}
        script = project.spds
        self._observed = {one.tag for one in script.observe} if script is not None else set()
        for tag, value in project.tags.items():
            self._wrote(tag, kind_of(value))
        for application in project.flows.values():
            for action in actions(application):
                self._action(action)
            for screen, _ in screens(application):
                for component in screen.components:
                    self._component(component)
        self._types = self._declared()
        for topic in (project.mqtt.incoming if project.mqtt is not None else {}).values():
            if topic.startswith("tag:"):
                self._wrote(topic[4:], None)
        for setting in project.settings:
            self._wrote(setting.tag, None)

    def is_written(self, name: str) -> bool:
        """Whether anything writes what a name can stand for; the runtime too."""
        found = self._known.get(name)
        if found is None:
            found = self._known[name] = self._is_kept(name) or _begins(name, self.written)
        return found

    def is_observed(self, name: str) -> bool:
        """Whether the script looks at what a name can stand for: modules write it, then."""
        return _begins(name, self._observed)

    def domain(self, name: str) -> Domain:
        """What is known of a name's values: its declared type, and what the runtime keeps."""
        if self._project.toml is not None:
            kept = self._kept(name)
            if kept is not None:
                return kept
        if name == "clock.time":
            return Domain(frozenset((TEXT,)), _TIMES)
        declared = self._types.get(name)
        if declared is None or not self._kinds.get(name, {declared}) <= {declared}:
            return ANY
        return Domain(frozenset((declared,)))

    # ------------------------------------------------------------------------

    def _is_kept(self, name: str) -> bool:
        """Whether the runtime itself writes it, or a module below its own root."""
        root, _, rest = name.partition("/")
        who, _, field = rest.partition(".")
        if root == "application":
            return who in self._applications and field in _APPLICATION
        if root == "service":
            return who in self._services and (not field or field in _SERVICE)
        if root == "module" and rest:
            owner = who.partition("/")[0]
            return owner in self._applications or owner in self._project.declared()
        if root == "robot" and rest:
            return who in self._resources
        word, _, field = name.partition(".")
        if word == "clock":
            return name in CLOCK
        if word == "situation":
            kept = field.partition(".")[0] in ("", "name", "priorities")
            return self._project.spds_file is not None and kept
        # A recogniser is no part of a project: it comes with the robot.
        return word in ("listen", "heard")

    @cached_property
    def _resources(self) -> set[str]:
        """Everything that somebody may hold."""
        found = {one for several in self._project.declared().values() for one in several}
        for application in self._applications.values():
            found.update(used_resources(self._project, application))
        return found

    def _kept(self, name: str) -> Domain | None:
        """The values of what the runtime keeps, where all applications are known."""
        if name == "situation.name":
            script = self._project.spds
            found = [one.name for one in script.situations] if script is not None else []
            return Domain(frozenset((TEXT,)), tuple(found)) if found else NOTHING_EVER
        root, _, rest = name.partition("/")
        who, _, field = rest.partition(".")
        if root == "application":
            application = self._applications.get(who)
            if application is None:
                return NOTHING_EVER
            if field == "suspended":
                return Domain(frozenset((BOOLEAN,)))
            if field == "state" and not any(s.flow is not None for s in application.states):
                return Domain(frozenset((TEXT,)), tuple(s.no for s in application.states))
        elif root == "service":
            if who not in self._services:
                return NOTHING_EVER
            if field in _SERVICE:
                return Domain(frozenset((_SERVICE[field],)))
        return None

    def _wrote(self, tag: str, kind: str | None) -> None:
        """A write of a value of this kind; None: of any."""
        self.written.add(tag)
        self._kinds.setdefault(tag, set()).add(kind if kind is not None else "any")

    def _action(self, action: Action) -> None:
        if isinstance(action, Set):
            self._wrote(action.tag, written_kind(action.text))
        elif isinstance(action, Add):
            self._wrote(action.tag, NUMBER)
        elif isinstance(action, Append):
            self._wrote(action.tag, LIST)
        elif isinstance(action, Take):
            self._wrote(action.tag, None)
        elif isinstance(action, Service):
            self._services.add(action.name)
            self.asks_modules = self.asks_modules or action.url.lower().startswith(BOARD)
            for result in action.results:
                self._wrote(result.tag, None)

    def _component(self, component: Component) -> None:
        if isinstance(component, Button) and component.tag is not None:
            self._wrote(component.tag, written_kind(component.value or ""))
        elif isinstance(component, Input) and component.tag:
            self._wrote(component.tag, NUMBER if component.kind == "number" else TEXT)
        elif isinstance(component, List) and component.tag is not None:
            self._wrote(component.tag, None)

    def _declared(self) -> dict[str, str]:
        """Tag to its declared type; what contradicts itself has none."""
        found: dict[str, set[str]] = {}
        modules = self._project.modules.modules if self._project.modules is not None else ()
        for module in modules:
            for data in module.provides:
                self.written.add(data.data)
                if data.type is not None:
                    found.setdefault(data.data, set()).add(data.type)
        for observed in self._project.spds.observe if self._project.spds is not None else ():
            if observed.type is not None:
                found.setdefault(observed.tag, set()).add(observed.type)
        return {tag: next(iter(types)) for tag, types in found.items() if len(types) == 1}


def references(text: str) -> tuple[str, ...]:
    """The names in a text; most texts have none."""
    return names.references(text) if "{" in text else ()


def _begins(name: str, tags: set[str]) -> bool:
    """Whether a name is one of the tags, or one of them begins it."""
    end = len(name)
    while end > 0:
        if name[:end] in tags:
            return True
        end = name.rfind(".", 0, end)
    return False


def kind_of(value: Any) -> str | None:
    """The type of a value; None for a missing one."""
    if isinstance(value, bool):
        return BOOLEAN
    if is_number(value):
        return NUMBER
    kinds = ((str, TEXT), (list, LIST), (dict, OBJECT))
    return next((kind for type_, kind in kinds if isinstance(value, type_)), None)


def written_kind(text: str) -> str | None:
    """The type of what a text writes (``set``); None where that depends on values, or deletes."""
    if names.only_reference(text) is not None:
        return None
    return kind_of(read(text.strip()))


# -- what an application has -----------------------------------------------------


def screens(application: Application) -> Iterator[tuple[Screen, Place]]:
    """Every screen with its place, that of ``always`` first."""
    if application.always is not None and application.always.screen is not None:
        yield application.always.screen, ("always", "screen")
    for state in application.states:
        if state.screen is not None:
            yield state.screen, ("state", state.no, "screen")


def holders(application: Application) -> Iterator[tuple[Always | State, Place]]:
    """What has events, a screen and a timeout: ``always`` and the states."""
    if application.always is not None:
        yield application.always, ("always",)
    for state in application.states:
        yield state, ("state", state.no)


def events(application: Application) -> Iterator[tuple[Event, Place]]:
    """Every expected event of an application with its place."""
    for holder, place in holders(application):
        for index, event in enumerate(holder.events):
            yield event, (*place, "event", str(index))


def placed_actions(application: Application) -> Iterator[tuple[Action, Place]]:
    """Every action with its place, those of events too."""
    for state in application.states:
        for index, action in enumerate(state.actions):
            yield action, ("state", state.no, "action", str(index))
    for event, place in events(application):
        for index, action in enumerate(event.actions):
            yield action, (*place, "action", str(index))


def actions(application: Application) -> Iterator[Action]:
    """Every action, those of events too."""
    for action, _ in placed_actions(application):
        yield action


def tested(condition: Condition | Group, place: Place) -> Iterator[tuple[Test, Place]]:
    """Every test of a condition with its place."""
    for index, child in enumerate(condition.children):
        at = (*place, str(index))
        if isinstance(child, Test):
            yield child, at
        else:
            yield from tested(child, at)


def uses(application: Application) -> Iterator[Use]:
    """Every name that an application tests, shows, speaks or sends; not what an ``input`` shows."""
    for screen, place in screens(application):
        for name in references(screen.background or ""):
            yield name, screen.aside, place
        for component in screen.components:
            at = (*place, component.id)
            for name in shown_names(component):
                yield name, component.aside, at
            if isinstance(component, Button):
                for name in references(component.value or ""):
                    yield name, component.aside, at
    for holder, place in holders(application):
        for index, event in enumerate(holder.events):
            if event.when is not None:
                when = (*place, "event", str(index), "when")
                for test, at in tested(event.when, when):
                    yield from _test_uses(test, at)
            for number, say in enumerate(event.says):
                for name in references(say.text):
                    yield name, say.aside, (*place, "event", str(index), "say", str(number))
    for action, place in placed_actions(application):
        for text, aside in _templates(action):
            for name in references(text):
                yield name, aside, place
        if isinstance(action, Take):
            yield action.source, action.aside, place


def _test_uses(test: Test, place: Place) -> Iterator[Use]:
    yield test.tag, test.aside, place
    other = refers(test)
    if other is not None:
        yield other, test.aside, place


def shown_names(component: Component) -> Iterator[str]:
    """The names whose values a component shows, but for what is typed into an input."""
    if isinstance(component, (Text, Button)):
        yield from references(component.text)
    elif isinstance(component, (Image, Movie)):
        yield from references(component.src)
    elif isinstance(component, List):
        yield component.items
        for name in references(component.label):
            if name != "item" and not name.startswith("item."):
                yield name


def _templates(action: Action) -> Iterator[tuple[str, Aside]]:
    if isinstance(action, (Speech, Set, Add, Append)):
        yield action.text, action.aside
    elif isinstance(action, Sound):
        yield action.src, action.aside
    elif isinstance(action, Service):
        yield action.url, action.aside
    elif isinstance(action, Message):
        yield action.topic, action.aside
        if not action.params:
            yield action.text, action.aside
    params: tuple[Param, ...] = ()
    if isinstance(action, (Service, Message, Launch, Robot)):
        params = action.params
    for param in params:
        yield param.text, param.aside
