"""An application made ready to run: states, candidates and what they use, looked up once.

With its parts it becomes one set of innermost states, each named by its path (``5/q``).
An innermost state knows all states around it: level 0 is the application's own state, the
next level that of the part which this one runs, and so on. A candidate and a timeout carry
the level at which they are defined, and their ``next`` names a state of that level's file.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, ClassVar

from msgspec import Struct

from situ.decide.conditions import Compiled, Conditions
from situ.decide.screens import ScreenProgram
from situ.decide.step import duration
from situ.document.rbd import (
    BACK,
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
    resource_of,
)

if TYPE_CHECKING:
    from situ.decide.way import Way

Watcher = Callable[[int, int | None], None]
"""Told that an unnamed candidate (its key) may have come to hold by time, and what caused that."""


Lookup = Callable[[str], Application | None]
"""The application of a file that a ``flow`` names."""


class Ended(Action, frozen=True, kw_only=True):
    """What stands behind the actions of an end state of a part: it raises ``done.x``.

    holder: the path of the state that holds the part; nobody else may take the event.
    """

    element: ClassVar[str] = "ended"
    name: str
    holder: str


class Level(Struct, frozen=True):
    """One of the states that are active together: in which file's run, and as which path.

    prefix: of the paths of this file's states (``5/``). start: the path of its start state.
    """

    no: str
    path: str
    prefix: str
    start: str


class Candidate:
    """One expected event of a state or of ``always``, ready to be judged.

    key: tells it from all others of its application. level: at which it is defined. back: whether
    it goes back, which needs a state to go back to. tags: of an unnamed one, those that its
    guard looks at. when: the guard as written.
    """

    __slots__ = (
        "actions", "back", "guard", "key", "level", "name", "next", "says", "tags", "when",
    )  # fmt: skip

    def __init__(
        self,
        key: int,
        level: int,
        source: Event,
        actions: list[int],
        guard: Compiled | None,
        tags: set[str],
    ) -> None:
        self.key = key
        self.level = level
        self.name = source.name
        self.next = source.next
        self.back = source.next == BACK
        self.says = [say.text for say in source.says]
        self.actions = actions
        self.guard = guard
        self.when = source.when
        self.tags = tags


class StateProgram:
    """One innermost state with what ``always`` and the states around it add to it.

    no: its path. levels: itself and the states around it, the outermost first.
    actions: keys of its actions on entry. ended: by level, the key of what says that this
    state was its part's end, or None. named (by name), unnamed: candidates in the
    order in which they are tried; waits: keys of the unnamed, looks: the same by the tag that
    they look at; heard: those with phrases.
    always: the screens of ``always`` above its own, the innermost file's first; ``shared``
    is the same for the same screens, 0 for none.
    timeout (µs), next and idle: of the timeout that serves, defined at level ``timeout_level``.
    uses, may_use: resources but for the screen. goes_back: whether anything goes back from here.
    ways: of the candidates taken here before, by key: the short way, None where there is none.
    """

    __slots__ = (
        "actions", "always", "ended", "goes_back", "heard", "idle", "levels", "looks", "may_use",
        "named", "next", "no", "screen", "shared", "source", "timeout", "timeout_level", "unnamed",
        "uses", "waits", "ways",
    )  # fmt: skip

    def __init__(self, source: State, around: list[_Around], shared: int) -> None:
        self.source = source
        self.levels = tuple(one.level for one in around)
        self.no = self.levels[-1].path
        self.screen = None if source.screen is None else ScreenProgram(source.screen)
        self.shared = shared
        self.always: tuple[ScreenProgram, ...] = ()
        timeout: Timeout | None = source.timeout
        self.timeout_level = len(around) - 1
        if timeout is None:
            for number in reversed(range(len(around))):
                always = around[number].always
                if always is not None and always.timeout is not None:
                    timeout, self.timeout_level = always.timeout, number
                    break
        self.timeout = None if timeout is None else duration(timeout.seconds)
        self.next = None if timeout is None else timeout.next
        self.goes_back = self.next == BACK
        self.idle = timeout is not None and timeout.idle
        self.actions: list[int] = []
        self.ended = [one.ended for one in around]
        self.named: dict[str, list[Candidate]] = {}
        self.heard: list[Candidate] = []
        self.unnamed: list[Candidate] = []
        self.waits: set[int] = set()
        self.looks: dict[str, list[int]] = {}
        self.uses: set[str] = set()
        self.may_use: set[str] = set()
        self.ways: dict[int, Way | None] = {}
        for action in source.actions:
            resource = resource_of(action)
            if resource is not None:
                (self.may_use if is_optional(action) else self.uses).add(resource)
        for one in reversed(around):
            for candidate in one.candidates:
                self._add(candidate)

    def _add(self, candidate: Candidate) -> None:
        self.goes_back = self.goes_back or candidate.back
        if candidate.name is None:
            self.unnamed.append(candidate)
            self.waits.add(candidate.key)
            for tag in candidate.tags:
                self.looks.setdefault(tag, []).append(candidate.key)
            return
        self.named.setdefault(candidate.name, []).append(candidate)
        if candidate.says:
            self.heard.append(candidate)


class _Around(Struct, frozen=True):
    """A level of a state while it is compiled. always: of its file, unless left out."""

    level: Level
    always: Always | None
    candidates: list[Candidate]
    ended: int | None


class Program:
    """One application with its parts, compiled against a robot's conditions.

    actions: every action of the application by key (its place in this list). states: the
    innermost states by their paths. innermost: the path of any state to that of the
    innermost state entered with it. shared: the distinct sequences of screens of ``always``.
    has_screens, has_phrases: whether any state has; goes_back: whether any ``next`` does.
    """

    def __init__(
        self, source: Application, conditions: Conditions, watcher: Watcher, lookup: Lookup
    ) -> None:
        self.source = source
        self.name = source.name
        self.actions: list[Action] = []
        self.states: dict[str, StateProgram] = {}
        self.innermost: dict[str, str] = {}
        self.shared: list[tuple[ScreenProgram, ...]] = [()]
        self._numbers: dict[tuple[int, ...], int] = {(): 0}
        self._candidates = 0
        self._conditions = conditions
        self._watcher = watcher
        self._lookup = lookup
        self._screens: dict[int, ScreenProgram] = {}
        self.start = self.innermost[self._file(source, "", [])]
        states = self.states.values()
        self.has_screens = any(one.screen is not None or one.shared for one in states)
        self.has_phrases = any(one.heard for one in states)
        self.goes_back = any(one.goes_back for one in states)

    def _file(self, source: Application, prefix: str, around: list[_Around]) -> str:
        """Compiles one run of a file; gives the path of its start state."""
        start = prefix + (source.start_no or "")
        always, level = source.always, len(around)
        shared = [self._candidate(e, level) for e in always.events] if always is not None else []
        for state in source.states:
            path = prefix + state.no
            own = [self._candidate(event, level) for event in state.events]
            ended = None
            if around and state.is_end:
                ended = self._key(Ended(name=f"done.{state.no}", holder=around[-1].level.path))
            here = _Around(
                Level(state.no, path, prefix, start),
                always if state.always else None,
                [*own, *(shared if state.always else ())],
                ended,
            )
            part = self._lookup(state.flow) if state.flow is not None else None
            if part is None:
                self._state(state, [*around, here])
                self.innermost[path] = path
            else:
                inner = self._file(part, f"{path}/", [*around, here])
                self.innermost[path] = self.innermost[inner]
        return start

    def _state(self, state: State, around: list[_Around]) -> None:
        above = [
            one.always.screen
            for one in reversed(around)
            if one.always is not None
            and one.always.screen is not None
            and not one.always.screen.is_empty
        ]
        screens = tuple(self._screen(screen) for screen in above)
        number = self._numbers.setdefault(tuple(map(id, screens)), len(self.shared))
        if number == len(self.shared):
            self.shared.append(screens)
        program = StateProgram(state, around, number)
        program.always = screens
        program.actions = [self._key(action) for action in state.actions]
        self.states[program.no] = program

    def _screen(self, source: Screen) -> ScreenProgram:
        # By identity, kept alive by the application: a part that runs twice shows one screen.
        return self._screens.setdefault(id(source), ScreenProgram(source))

    def _candidate(self, event: Event, level: int) -> Candidate:
        self._candidates += 1
        key, guard, watcher = self._candidates, None, self._watcher
        tags: set[str] = set()
        if event.when is not None:
            watch = None if event.name is not None else lambda cause: watcher(key, cause)
            guard = self._conditions.compile(event.when, watch, tags)
        actions = [self._key(action) for action in event.actions]
        return Candidate(key, level, event, actions, guard, tags)

    def _key(self, action: Action) -> int:
        self.actions.append(action)
        return len(self.actions) - 1


def is_optional(action: Action) -> bool:
    return isinstance(action, (Speech, Sound, Robot)) and action.optional


NAMES = {"service": "name", "robot": "command", "launch": "program"}


def name_of(action: Action) -> str | None:
    """An action's name in the trace: a service's name, a robot's command, a launch's program."""
    field = NAMES.get(action.element)
    return None if field is None else str(getattr(action, field))
