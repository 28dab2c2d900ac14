"""Events that a screen, an action or a timeout raises where no state expects them.

What is claimed: what a component, an action or a timeout raises is *unexpected* where it is in
no state that may then be current an expected event: of that state, of ``always``, or of a state
around it. Those states are

- for a component, ``touched`` and the end of a movie: the states that show it, also those
  that keep it, and, where it writes a tag, those to which unnamed events lead from there;
- for an action that uses a resource, and for a timeout without ``next``: the states that have
  it (behind an action that is waited for, what it sets may have led on by unnamed events);
- for any other action: the state that it belongs to, and those to which unnamed events,
  ``resumed`` and the robot's own events lead from there, as these may be judged before it; with
  ``keep`` all states.

Ways are taken as written, whether or not a ``when`` can hold: a way too many, nothing false.
"""

from __future__ import annotations

from collections.abc import Iterator
from difflib import get_close_matches
from typing import NamedTuple

from situ.document import words
from situ.document.analysis_active import Active, Level, Run
from situ.document.analysis_search import Search
from situ.document.finding import Place
from situ.document.mend import written
from situ.document.problem import Change, Mend
from situ.document.rbd import (
    RESUMED,
    TIMED_OUT,
    Action,
    Always,
    Button,
    Component,
    Event,
    Input,
    Launch,
    List,
    Movie,
    Repeat,
    Robot,
    Screen,
    Service,
    Sound,
    Speech,
    State,
    Timeout,
)

HERE, WAITED, SHOWN, WRITES, SOON, ANYWHERE = range(6)
"""In which states an event may be judged, from those that have what raises it."""


Key = tuple[str, Place, str]
"""What tells raisers from each other: file, place and field. Two states may hold the very same
value, so that it does not.
"""


class Raiser(NamedTuple):
    """What raises an event. field: with the event's name; reach: HERE, …, ANYWHERE."""

    file: str
    place: Place
    value: Component | Screen | Action | Timeout
    field: str
    name: str
    reach: int


def search_expected(search: Search, runs: list[Run]) -> None:
    """Tells of every event that is raised where no state expects it."""
    _Expected(search, runs).tell()


class _Expected:
    def __init__(self, search: Search, runs: list[Run]) -> None:
        self._search = search
        self._fine: set[Key] = set()
        self._open: dict[Key, tuple[Raiser, list[tuple[Run, list[Active]]]]] = {}
        self._settled: set[str] = set()
        self._own: dict[int, frozenset[str | None]] = {}
        for run in runs:
            search.go_on()
            _touches(self, run)
            for active in run.actives.values():
                self._active(run, active)

    def tell(self) -> None:
        for key, (raiser, found) in self._open.items():
            if key in self._fine:
                continue
            self._search.go_on()
            reached = found
            somewhere = any(run.ever_expects(raiser.name) for run, _ in found)
            if somewhere:
                # The states to which it may lead are looked at only where that can matter.
                reached = [(run, self._reach(run, raiser.reach, actives)) for run, actives in found]
            judged = [(run, one) for run, several in reached for one in several]
            if not any(run.expects(one, raiser.name) for run, one in judged):
                self._tell(raiser, judged, found[0][1][0], somewhere)

    def fine(self, run: Run, key: Key, name: str, actives: list[Active]) -> bool:
        """Whether an event that is raised in one of these states is expected there."""
        if key in self._fine:
            return True
        for active in actives:
            if run.expects(active, name):
                self._fine.add(key)
                return True
        return not actives

    def open(self, run: Run, raiser: Raiser, actives: list[Active]) -> None:
        """An event is raised in these states, none of which expects it."""
        key = (raiser.file, raiser.place, raiser.field)
        found = self._open.setdefault(key, (raiser, []))[1]
        if not found or found[-1][0] is not run:
            found.append((run, []))
        found[-1][1].extend(actives)

    # -- what raises ---------------------------------------------------------------

    def _active(self, run: Run, active: Active) -> None:
        """All that may raise an event in one innermost state, but for touches of screens."""
        here = active.levels[-1]
        place: Place = ("state", here.state.no)
        self._screen(run, active, here.file, here.state.screen, place)
        waits = False
        for index, action in enumerate(here.state.actions):
            waits = waits or action.wait
            if action.done is not None or action.failed is not None:
                at = (*place, "action", str(index))
                self._action(run, [active], here.file, at, action, waits)
        serves = run.timeout(active)
        if serves is not None and serves[0].next is None:
            timeout, holder, number = serves
            file = active.levels[number].file
            own = (*place, "timeout")
            where: Place = ("always", "timeout") if isinstance(holder, Always) else own
            if not self.fine(run, (file, where, "next"), TIMED_OUT, [active]):
                self.open(run, Raiser(file, where, timeout, "next", TIMED_OUT, HERE), [active])
        for level in active.levels:
            self._events(run, active, level, level.state, ("state", level.state.no))
            always = level.always
            if always is not None and level.file not in self._settled:
                events = self._events(run, active, level, always, ("always",))
                screen = self._screen(run, active, level.file, always.screen, ("always",))
                if events and screen:
                    self._settled.add(level.file)

    def _screen(
        self, run: Run, active: Active, file: str, screen: Screen | None, place: Place
    ) -> bool:
        """Whether all that a screen's components raise is expected."""
        settled = True
        raised = [
            (component, field, name)
            for component in (screen.components if screen is not None else ())
            for field in (("done", "failed") if isinstance(component, Movie) else ("event",))
            if (name := getattr(component, field, None)) is not None
        ]
        for component, field, name in raised:
            at = (*place, "screen", component.id)
            if self.fine(run, (file, at, field), name, [active]):
                continue
            writes = isinstance(component, (Button, Input, List)) and component.tag
            reach = WRITES if writes else SHOWN
            if place[0] == "always":
                # It is shown where it is part of the state, and kept nowhere else.
                reach = WAITED if writes else HERE
            self.open(run, Raiser(file, at, component, field, name, reach), [active])
            settled = False
        return settled

    def _events(
        self, run: Run, active: Active, level: Level, holder: Always | State, place: Place
    ) -> bool:
        """Whether all that the actions of events raise is expected."""
        settled = True
        for index, event in enumerate(holder.events):
            if not event.actions:
                continue
            actives = [active] if event.next is None else run.targets(level, event.next)
            for number, action in enumerate(event.actions):
                at = (*place, "event", str(index), "action", str(number))
                if not self._action(run, actives, level.file, at, action, waits=True):
                    settled = False
        return settled

    def _action(
        self, run: Run, actives: list[Active], file: str, at: Place, action: Action, waits: bool
    ) -> bool:
        if isinstance(action, Repeat):
            return True
        settled = True
        # What ends at once ends well.
        ends = isinstance(action, (Speech, Robot, Sound, Service, Launch))
        for field in ("done", "failed") if ends else ("done",):
            name = getattr(action, field)
            if name is None or self.fine(run, (file, at, field), name, actives):
                continue
            reach = SOON
            if isinstance(action, (Speech, Robot, Sound)):
                reach = WAITED if waits else HERE
            elif isinstance(action, (Service, Launch)) and action.keep:
                reach = ANYWHERE
            self.open(run, Raiser(file, at, action, field, name, reach), actives)
            settled = False
        return settled

    # -- where it may be judged ------------------------------------------------------

    def _reach(self, run: Run, reach: int, actives: list[Active]) -> list[Active]:
        if reach in (SHOWN, WRITES):
            actives = run.keeping(actives)
        if reach in (WRITES, WAITED):
            actives = run.after(actives, frozenset((None,)))
        elif reach == SOON:
            actives = run.after(actives, self._robots_own(run))
        elif reach == ANYWHERE:
            return list(run.actives.values())
        paths = {one.path for one in actives}
        return [one for path, one in run.actives.items() if path in paths]

    def _robots_own(self, run: Run) -> frozenset[str | None]:
        """The events that can be judged before one that was raised: None for the unnamed."""
        found = self._own.get(id(run))
        if found is None:
            own: set[str | None] = {None, RESUMED, TIMED_OUT, "done"}
            for active in run.actives.values():
                for level in active.levels:
                    own.add(f"done.{level.state.no}")
                own.update(_raised_names(active))
            found = self._own[id(run)] = frozenset(own)
        return found

    # -- telling ---------------------------------------------------------------------

    def _tell(
        self, raiser: Raiser, reached: list[tuple[Run, Active]], first: Active, somewhere: bool
    ) -> None:
        search, name = self._search, raiser.name
        paths = list(dict.fromkeys(active.path for _, active in reached))
        why = f"the state {words.quoted(paths[0])} does not expect it"
        if not somewhere:
            why = "no state expects it"
        elif len(paths) > 1:
            more = [words.quoted(path) for path in paths[:3]]
            if len(paths) > 3:
                more.append(f"{len(paths) - 3} more")
            why = f"none of the states {words.listed(more)} expects it"
        expected = {one for run, active in reached for one in run.expected(active)}
        near = get_close_matches(name, sorted(expected), n=1, cutoff=0.8)
        mend: Mend | None
        if near and not isinstance(raiser.value, Timeout):
            do = f"did you mean {words.quoted(near[0])}?"
            change = search.put(raiser.file, raiser.place, raiser.field, near[0])
            mend = search.mend(raiser.file, f"Raise {words.quoted(near[0])} instead", change)
        else:
            do = "add an expected event of this name there, or raise another"
            if isinstance(raiser.value, Timeout):
                do = "let the timeout lead to a state, or add an expected event of this name"
            mend = self._add(raiser, first)
        message = f"{_what(raiser)} raises {words.quoted(name)}, but {why}: {do}"
        search.warn(
            raiser.file, "unexpected-event", message, raiser.value.aside, raiser.place, mend
        )

    def _add(self, raiser: Raiser, active: Active) -> Mend | None:
        """An event that is expected, and for the time being does nothing."""
        level = next(one for one in active.levels if one.file == raiser.file)
        place: Place = ("always",)
        holder: Always | State | None = level.application.always
        if raiser.place[0] != "always" or holder is None:
            place, holder = ("state", level.state.no), level.state
        path = (*self._search.path(raiser.file, place), "events", len(holder.events))
        where = "every state" if place == ("always",) else f"state {words.state(level.state)}"
        said = f"Expect {words.quoted(raiser.name)} in {where}"
        return self._search.mend(
            raiser.file, said, Change(path, "insert", written(Event(name=raiser.name)))
        )


def _touches(found: _Expected, run: Run) -> None:
    """Touches on no component: the state's own screen, a kept one too, goes before ``always``."""
    bare: set[str] | None = None
    for active in run.actives.values():
        here, screen = active.levels[-1], active.state.screen
        if screen is not None and screen.touched is not None:
            own: Place = ("state", here.state.no, "screen")
            raiser = Raiser(here.file, own, screen, "touched", screen.touched, SHOWN)
            if not found.fine(run, (here.file, own, "touched"), screen.touched, [active]):
                found.open(run, raiser, [active])
            continue
        layer = next((one for one in active.above if one.screen.touched is not None), None)
        if layer is None:
            continue
        if screen is None:
            bare = _bare(run) if bare is None else bare
            if active.path not in bare:
                continue
        above = layer.screen
        assert above.touched is not None
        at = (*layer.holder, "screen")
        if not found.fine(run, (layer.file, at, "touched"), above.touched, [active]):
            raiser = Raiser(layer.file, at, above, "touched", above.touched, HERE)
            found.open(run, raiser, [active])


def _bare(run: Run) -> set[str]:
    """The states in which the state's own or kept screen may be one without ``touched``."""
    sources = [
        one
        for one in run.actives.values()
        if one.state.screen is not None and not one.state.screen.touched
    ]
    if run.start is not None and run.start.state.screen is None:
        sources.append(run.start)
    return {one.path for one in run.keeping(sources)}


def _raised_names(active: Active) -> Iterator[str]:
    """The names of the events that actions and movies of an innermost state raise."""
    levels = active.levels
    holders = [one for level in levels for one in (level.state, level.always) if one is not None]
    actions = [*active.state.actions]
    for holder in holders:
        for event in holder.events:
            actions += event.actions
        for component in holder.screen.components if holder.screen is not None else ():
            if isinstance(component, Movie):
                yield from (name for name in (component.done, component.failed) if name is not None)
    for action in actions:
        yield from (name for name in (action.done, action.failed) if name is not None)


def _what(raiser: Raiser) -> str:
    value = raiser.value
    if isinstance(value, Screen):
        return "A touch on this screen"
    if isinstance(value, Timeout):
        return "This timeout, which leads to no state,"
    if raiser.field == "event":
        return f"This {value.element}"
    return f"The {'failure' if raiser.field == 'failed' else 'end'} of this {value.element}"
