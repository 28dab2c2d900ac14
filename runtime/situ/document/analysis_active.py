"""Which states are active together: an application with its parts, as it runs.

An innermost state stands with all states around it, the outermost first. Ways are taken as they
are written: whether a ``when`` can hold is not asked, nor whether a state is reached. ``#back``
leads to each state from which a way leads here.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from situ.document.analysis_search import Search
from situ.document.finding import Place
from situ.document.project import Project
from situ.document.rbd import (
    AGAIN,
    BACK,
    RESUMED,
    Always,
    Application,
    Event,
    Screen,
    State,
    Timeout,
)

MOST = 20_000
"""Innermost states that are looked at; parts in parts can make any number of them."""


class Level(NamedTuple):
    """One of the states that are active together. prefix: of the paths of its file's states."""

    file: str
    application: Application
    state: State
    prefix: str

    @property
    def path(self) -> str:
        return self.prefix + self.state.no

    @property
    def always(self) -> Always | None:
        return self.application.always_in(self.state)


class Layer(NamedTuple):
    """A screen, and where it stands: its file, and its state or ``always`` in it."""

    file: str
    holder: Place
    screen: Screen


Layers = tuple[Layer, ...]
"""Screens above each other, the upper ones later."""


class Active(NamedTuple):
    """An innermost state with those around it. is_known: it has no part that is missing.

    holders: what its events stand in, in the order tried. above: the screens of ``always``
    over its own, the innermost file's first.
    """

    levels: tuple[Level, ...]
    is_known: bool
    holders: tuple[Always | State, ...]
    above: Layers

    @property
    def path(self) -> str:
        return self.levels[-1].path

    @property
    def state(self) -> State:
        return self.levels[-1].state


class Endless(Exception):
    """Parts lead in a circle, which is an error that ``check`` tells."""


class TooMany(Exception):
    """There are more innermost states than are looked at."""


def runs_of(search: Search) -> list[Run]:
    """The applications of a project as they run; none where they cannot all be looked at."""
    runs: list[Run] = []
    for file, application in search.project.applications.items():
        search.go_on()
        try:
            runs.append(Run(search.project, file, application))
        except Endless:
            return []
        except TooMany:
            what = "what its screens show and its states expect"
            search.undecided(file, what, application.aside, ())
            return []
    return runs


class Run:
    """One application with its parts: ``actives``, by path, and the ways between them.

    can_suspend: whether anybody can take resources away from it. Raises Endless,
    TooMany.
    """

    def __init__(self, project: Project, file: str, application: Application) -> None:
        self.actives: dict[str, Active] = {}
        self.can_suspend = project.spds is not None
        self._project = project
        self._innermost: dict[str, Active] = {}
        self._names: dict[int, frozenset[str | None]] = {}
        self._ever: frozenset[str | None] | None = None
        self._is_known = True
        self._into: dict[int, dict[str, list[str]]] = {}
        around = Active((), True, (), ())
        self.start = self._file(file, application, "", around, frozenset((id(application),)))

    def expects(self, active: Active, name: str) -> bool:
        """Whether an event of that name is expected there, by the state or one around it."""
        if not active.is_known:
            return True
        return any(name in self._expected(holder) for holder in active.holders)

    def ever_expects(self, name: str) -> bool:
        """Whether an event of that name is expected in any state."""
        if self._ever is None:
            every = {id(holder): holder for one in self.actives.values() for holder in one.holders}
            self._ever = frozenset().union(*(self._expected(one) for one in every.values()))
            self._is_known = all(active.is_known for active in self.actives.values())
        return name in self._ever or not self._is_known

    def expected(self, active: Active) -> set[str]:
        """The names of the events that are expected there."""
        found = [self._expected(holder) for holder in active.holders]
        return {name for names in found for name in names if name is not None}

    def timeout(self, active: Active) -> tuple[Timeout, Always | State, int] | None:
        """The timeout that serves, what it stands in, and its level."""
        if active.state.timeout is not None:
            return active.state.timeout, active.state, len(active.levels) - 1
        for number in reversed(range(len(active.levels))):
            always = active.levels[number].always
            if always is not None and always.timeout is not None:
                return always.timeout, always, number
        return None

    def events(self, active: Active) -> Iterator[tuple[int, Event]]:
        """What is expected there, in the order tried, with its level."""
        for number in reversed(range(len(active.levels))):
            level = active.levels[number]
            for event in level.state.events:
                yield number, event
            always = level.always
            for event in always.events if always is not None else ():
                yield number, event

    def targets(self, level: Level, to: str) -> list[Active]:
        """The innermost states to which a ``next`` of a level leads."""
        if to == BACK:
            numbers = self._sources(level.application).get(level.state.no, [])
        else:
            numbers = [level.state.no if to == AGAIN else to]
        found = (self._innermost.get(level.prefix + no) for no in numbers)
        return [one for one in found if one is not None]

    def ways(self, active: Active) -> Iterator[tuple[str | None, bool, list[Active]]]:
        """Where events and the timeout lead: name of the event, whether it is the timeout.

        An event is passed over where an earlier one of its name is always taken first.
        """
        closed: set[str] = set()
        for number, event in self.events(active):
            if event.name is not None and event.name in closed:
                continue
            if event.name is not None and event.when is None and event.next != BACK:
                closed.add(event.name)
            if event.next is not None:
                yield event.name, False, self.targets(active.levels[number], event.next)
        serves = self.timeout(active)
        if serves is not None and serves[0].next is not None:
            yield None, True, self.targets(active.levels[serves[2]], serves[0].next)

    def after(self, actives: Iterable[Active], names: frozenset[str | None]) -> list[Active]:
        """These, and where ways lead on from them by events of those names (None: unnamed)."""
        found = {one.path: one for one in actives}
        waiting = list(found.values())
        while waiting:
            for name, is_timeout, targets in self.ways(waiting.pop()):
                for target in targets if name in names and not is_timeout else ():
                    if target.path not in found:
                        found[target.path] = target
                        waiting.append(target)
        return list(found.values())

    def keeping(self, actives: Iterable[Active]) -> list[Active]:
        """These, and where what they show is kept, as states have no screen.

        Entered suspended and left by ``resumed``, a state never shows its own screen.
        """
        found: dict[str, Active] = {}
        passed: set[str] = set()
        waiting = [(one, True) for one in actives]
        while waiting:
            here, is_shown = waiting.pop()
            seen: dict[str, Active] | set[str] = found if is_shown else passed
            if here.path in seen:
                continue
            if is_shown:
                found[here.path] = here
            else:
                passed.add(here.path)
            for name, _, targets in self.ways(here):
                if is_shown or name == RESUMED:
                    for target in targets:
                        keeps = target.state.screen is None
                        if keeps or self.can_suspend:
                            waiting.append((target, keeps))
        return list(found.values())

    # ------------------------------------------------------------------------

    def _expected(self, holder: Always | State) -> frozenset[str | None]:
        found = self._names.get(id(holder))
        if found is None:
            found = frozenset(event.name for event in holder.events)
            self._names[id(holder)] = found
        return found

    def _file(
        self,
        file: str,
        application: Application,
        prefix: str,
        around: Active,
        within: frozenset[int],
    ) -> Active | None:
        always = application.always
        shared: tuple[Always, ...] = (always,) if always is not None else ()
        above = around.above
        if always is not None and always.screen is not None and not always.screen.is_empty:
            above = (Layer(file, ("always",), always.screen), *above)
        for state in application.states:
            path = prefix + state.no
            if path in self._innermost:
                continue
            levels = (*around.levels, Level(file, application, state, prefix))
            part = self._project.flow(state.flow) if state.flow is not None else None
            holders = (state, *(shared if state.always else ()), *around.holders)
            lies = above if state.always else around.above
            found = Active(levels, state.flow is None, holders, lies)
            if part is not None and state.flow is not None:
                if id(part) in within:
                    raise Endless
                more = within | {id(part)}
                inner = self._file(state.flow, part, f"{path}/", found, more)
                found = inner if inner is not None else found
            if found.path == path:
                self.actives[path] = found
                if len(self.actives) > MOST:
                    raise TooMany
            self._innermost[path] = found
        return self._innermost.get(prefix + (application.start_no or ""))

    def _sources(self, application: Application) -> dict[str, list[str]]:
        """By number of a state, those from which a way leads there, ``#back`` aside."""
        found = self._into.get(id(application))
        if found is not None:
            return found
        found = self._into[id(application)] = {}
        for state in application.states:
            shared = application.always_in(state)
            events = (*state.events, *(shared.events if shared is not None else ()))
            nexts = {event.next for event in events}
            # Inside a part that of its own file may serve, or this one: either may lead on.
            timeouts = (state.timeout, shared.timeout if shared is not None else None)
            nexts.update(one.next for one in timeouts if one is not None)
            for no in nexts - {None, AGAIN, BACK}:
                assert no is not None
                found.setdefault(no, []).append(state.no)
        return found
