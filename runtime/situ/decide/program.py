"""An application made ready to run: states, candidates and what they use, looked up once."""

from __future__ import annotations

from collections.abc import Callable

from situ.decide.conditions import Compiled, Conditions
from situ.decide.step import duration
from situ.document.rbd import (
    Action,
    Always,
    Application,
    Event,
    Robot,
    Screen,
    Sound,
    Speech,
    State,
    Timeout,
)

Watcher = Callable[[int, int | None], None]
"""Told that an unnamed candidate (its key) may have come to hold, and what caused that."""


class Candidate:
    """One expected event of a state or of ``always``, ready to be judged.

    key: tells it from all others of its application.
    """

    __slots__ = ("actions", "guard", "key", "name", "next", "says")

    def __init__(self, key: int, source: Event, actions: list[int], guard: Compiled | None) -> None:
        self.key = key
        self.name = source.name
        self.next = source.next
        self.says = [say.text for say in source.says]
        self.actions = actions
        self.guard = guard


class StateProgram:
    """One state with what ``always`` adds to it.

    actions: keys of its actions on entry. named (by name), unnamed: candidates in the
    order in which they are tried; waits: keys of the unnamed; heard: those with phrases.
    uses, may_use: resources but for the screen.
    """

    __slots__ = (
        "actions", "always", "heard", "idle", "may_use", "named", "next", "no", "screen",
        "source", "timeout", "unnamed", "uses", "waits",
    )  # fmt: skip

    def __init__(self, source: State, always: Always | None) -> None:
        self.source = source
        self.no = source.no
        self.screen = source.screen
        self.always = always.screen if always is not None else None
        timeout: Timeout | None = source.timeout
        if timeout is None and always is not None:
            timeout = always.timeout
        self.timeout = None if timeout is None else duration(timeout.seconds)
        self.next = None if timeout is None else timeout.next
        self.idle = timeout is not None and timeout.idle
        self.actions: list[int] = []
        self.named: dict[str, list[Candidate]] = {}
        self.heard: list[Candidate] = []
        self.unnamed: list[Candidate] = []
        self.waits: set[int] = set()
        self.uses: set[str] = set()
        self.may_use: set[str] = set()
        for action in source.actions:
            resource = resource_of(action)
            if resource is not None:
                (self.may_use if is_optional(action) else self.uses).add(resource)

    def add(self, candidate: Candidate) -> None:
        if candidate.name is None:
            self.unnamed.append(candidate)
            self.waits.add(candidate.key)
            return
        self.named.setdefault(candidate.name, []).append(candidate)
        if candidate.says:
            self.heard.append(candidate)


class Program:
    """One application, compiled against a robot's conditions.

    actions: every action of the application by key (its place in this list).
    """

    def __init__(
        self,
        source: Application,
        conditions: Conditions,
        watcher: Watcher,
    ) -> None:
        self.source = source
        self.name = source.name
        self.start = source.start_no or ""
        self.actions: list[Action] = []
        self.states: dict[str, StateProgram] = {}
        self._candidates = 0
        always = source.always
        shared = [self._candidate(e, conditions, watcher) for e in always.events] if always else []
        for state in source.states:
            program = StateProgram(state, always if state.always else None)
            program.actions = [self._key(action) for action in state.actions]
            own = [self._candidate(event, conditions, watcher) for event in state.events]
            for candidate in [*own, *(shared if state.always else ())]:
                program.add(candidate)
            self.states[state.no] = program

    def _candidate(self, event: Event, conditions: Conditions, watcher: Watcher) -> Candidate:
        self._candidates += 1
        key, guard = self._candidates, None
        if event.when is not None:
            watch = None if event.name is not None else lambda cause: watcher(key, cause)
            guard = conditions.compile(event.when, watch)
        return Candidate(key, event, [self._key(action) for action in event.actions], guard)

    def _key(self, action: Action) -> int:
        self.actions.append(action)
        return len(self.actions) - 1


def resource_of(action: Action) -> str | None:
    """The resource that an action uses; None for those that use none."""
    if isinstance(action, (Speech, Sound)):
        return "speech"
    return action.resource if isinstance(action, Robot) else None


def is_optional(action: Action) -> bool:
    return isinstance(action, (Speech, Sound, Robot)) and action.optional


def shows_nothing(screen: Screen | None) -> bool:
    """Whether a screen is absent or ``<screen/>``."""
    return screen is None or not (screen.components or screen.background or screen.touched)


NAMES = {"service": "name", "robot": "command", "launch": "program"}


def name_of(action: Action) -> str | None:
    """An action's name in the trace: a service's name, a robot's command, a launch's program."""
    field = NAMES.get(action.element)
    return None if field is None else str(getattr(action, field))
