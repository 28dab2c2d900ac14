"""Livelocks: ways that go on for ever within one step (formats.md, *Time and steps*).

What is claimed: there are values with which an application, as long as it holds its
resources, takes more than a hundred events on end, each without a name or raised by an action
that ends at once, in a state that is reached. Nothing from outside comes between, so values
stay what they are but for what the actions on the way write. A constant is followed
exactly; where a guard on the way asks for something written from other values (``add``,
``take``, a reference) the loop is told as ``undecided``. Not looked for: applications that keep
each other busy by way of the blackboard or of situations, and what happens inside parts. What
only goes ``#back`` ends when the stack is used up, and is none.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from msgspec import Struct

from situ.document import words
from situ.document.analysis_search import Search
from situ.document.analysis_ways import Candidate, Way, Ways
from situ.document.analysis_written import QUICK, Written, entered_state, now, write
from situ.document.finding import Place
from situ.document.rbd import (
    AGAIN,
    BACK,
    Action,
    Event,
    Launch,
    Robot,
    Service,
    Sound,
    Speech,
    State,
)
from situ.document.satisfy import Node

LIVELOCK = 100
"""More events than this in one step are a livelock."""

ENOUGH = 3
"""Loops that are told of one beginning."""

MOST = 3_000
"""Situations of the machine that are looked at, for one application."""

_SLOW = (Speech, Sound, Robot, Service, Launch)


class _Config(Struct, frozen=True, eq=False):
    """The machine between two events. depth: of the stack, counted from where the path began;
    known: what was pushed since. sure: nothing unknown was asked for on the way.
    """

    no: str
    queue: tuple[str, ...]
    written: Written
    known: tuple[str, ...] = ()
    depth: int = 0
    sure: bool = True

    def key(self) -> tuple[Any, ...]:
        return self.no, self.queue, tuple(sorted(self.written.items()))


class _Step(Struct, frozen=True, eq=False):
    """A config on the path, and the event that was taken in it (None: dropped)."""

    config: _Config
    event: Event | None
    place: Place


class _Spent(Exception):
    """Too much was looked at."""


def search_loops(search: Search, ways: Ways, reached: set[str]) -> None:
    """Tells the livelocks of an application: all, or in a very large tangle some of them."""
    loops = _Loops(search, ways, reached)
    try:
        loops.run()
    except _Spent:
        loops.tell()
        if loops.told:
            return
        application = ways.application
        what = "whether its states can go round for ever without waiting"
        search.undecided(ways.file, what, application.aside, ())


class _Loops:
    def __init__(self, search: Search, ways: Ways, reached: set[str]) -> None:
        self.search = search
        self.ways = ways
        self.reached = reached
        self.states = {state.no: state for state in ways.application.states}
        self.order = {no: at for at, no in enumerate(self.states)}
        self.entered_from = _entered_from(ways, reached)
        self.safe: set[str] = set()
        self.left = MOST
        self.told: set[frozenset[Any]] = set()
        self.loops: list[list[_Step]] = []
        self.rests: set[str] = set()
        self.waiting: list[str] = []

    def run(self) -> None:
        """From the start state on: from each state in which the application can wait, by all
        that may come from outside, to where it can wait next.
        """
        start = self.ways.application.start_no
        assert start is not None
        self._follow(self._entered(_Config("", (), {}), start, ()), [])
        while self.waiting:
            no = self.waiting.pop()
            # Whatever is written while it waits.
            if self._has_unnamed(no) and not self._follow(_Config(no, (), {}), []):
                self.safe.add(no)
            for way in self.ways.of[no]:
                if way.event is None or way.event.name is not None or self._is_part(no):
                    self._enter_by(way)

    def _enter_by(self, way: Way) -> None:
        actions = way.event.actions if way.event is not None else ()
        config = _Config(way.source, (), {})
        if way.next is None:
            if raises(actions):
                self._follow(self._did(config, actions), list(way.when))
            return
        for target, known, depth in self._leads(config, way.next):
            if raises(actions) or self._is_busy(target):
                before = _Config(way.source, (), {}, known, depth)
                self._follow(self._entered(before, target, actions), list(way.when))
            else:
                self._rest(target)

    def _follow(self, config: _Config, when: list[Node]) -> bool:
        """Tells the loops that begin with a config, and gives whether there are any."""
        self.loops = []
        self._explore(config, when, [])
        found = bool(self.loops)
        self.tell()
        return found

    def _rest(self, no: str) -> None:
        """The application can wait in this state."""
        if no not in self.rests:
            self.rests.add(no)
            self.waiting.append(no)

    def _is_busy(self, no: str) -> bool:
        """Whether something may follow at once where this state is entered."""
        return self._has_unnamed(no) or raises(self.states[no].actions)

    def _has_unnamed(self, no: str) -> bool:
        if self._is_part(no):
            return False
        return any(w.event is not None and w.event.name is None for w in self.ways.of[no])

    def _is_part(self, no: str) -> bool:
        return self.states[no].flow is not None

    # -- one event after the other -----------------------------------------------

    def _explore(self, config: _Config, when: list[Node], path: list[_Step]) -> None:
        """Follows every way to go on at once; ``when``: the moments at which it comes to this."""
        if len(self.loops) >= ENOUGH:
            return
        self.left -= 1
        if self.left <= 0:
            raise _Spent
        if not self.left % 200:
            self.search.go_on()
        state = self.states[config.no]
        if config.depth < -len(self.states):
            return
        if state.flow is not None or (not config.queue and config.no in self.safe):
            self._rest(config.no)
            return
        key = config.key()
        for at, step in enumerate(path):
            if step.config.key() == key and self._is_kept(path[at:], config):
                self.loops.append([*path[at:], _Step(config, None, ())])
                return
        if len(path) > LIVELOCK:
            self.loops.append([*path[-4:], _Step(config, None, ())])
            return
        sure = config.sure
        still = list(when)
        for candidate in self._candidates(state, None):
            guard, known = now(config.written, candidate.guard)
            if guard is not None and self._may(*still, guard):
                step = _Step(config, candidate.event, candidate.place)
                self._take(config, candidate.event, [*still, guard], path, step, sure and known)
            not_, also_known = now(config.written, self.search.moment.opposite(candidate.guard))
            if not_ is None:
                return
            sure = sure and also_known
            still.append(not_)
        if not self._may(*still):
            return
        if not config.queue:
            self._rest(config.no)
            return
        name, rest = config.queue[0], config.queue[1:]
        config = _Config(config.no, rest, config.written, config.known, config.depth, sure)
        for candidate in self._candidates(state, name):
            guard, known = now(config.written, candidate.guard)
            if guard is not None and self._may(*still, guard):
                waits = _Config(
                    config.no, (name, *rest), config.written, config.known, config.depth
                )
                step = _Step(waits, candidate.event, candidate.place)
                self._take(config, candidate.event, [*still, guard], path, step, sure and known)
            not_, also_known = now(config.written, self.search.moment.opposite(candidate.guard))
            if not_ is None:
                return
            sure = sure and also_known
            still.append(not_)
        if self._may(*still):
            step = _Step(_Config(config.no, (name, *rest), config.written), None, ())
            dropped = _Config(config.no, rest, config.written, config.known, config.depth, sure)
            self._explore(dropped, still, [*path, step])

    def _take(
        self,
        config: _Config,
        event: Event,
        when: list[Node],
        path: list[_Step],
        step: _Step,
        sure: bool,
    ) -> None:
        config = _Config(config.no, config.queue, config.written, config.known, config.depth, sure)
        if event.next is None:
            self._explore(self._did(config, event.actions), when, [*path, step])
            return
        for target, known, depth in self._leads(config, event.next):
            before = _Config(config.no, config.queue, config.written, known, depth, sure)
            self._explore(self._entered(before, target, event.actions), when, [*path, step])

    def _candidates(self, state: State, name: str | None) -> Iterator[Candidate]:
        in_start = state.no == self.ways.application.start_no
        for one in self.ways.candidates(state):
            if one.event.name != name or (in_start and one.event.next == BACK):
                continue
            if name is not None or one.event.next is not None:
                yield one

    def _may(self, *when: Node) -> bool:
        return self.search.possible(*when) is not False

    def _is_kept(self, segment: list[_Step], config: _Config) -> bool:
        """Whether going round does not use up the stack."""
        lowest = segment[0].config.depth
        return all(step.config.depth >= lowest for step in segment) and config.depth >= lowest

    def _leads(self, config: _Config, to: str) -> Iterator[tuple[str, tuple[str, ...], int]]:
        """Where a ``next`` leads, with the stack then."""
        if to == AGAIN:
            yield config.no, config.known, config.depth
        elif to == BACK:
            if config.known:
                yield config.known[-1], config.known[:-1], config.depth - 1
                return
            for source in self.entered_from.get(config.no, ()):
                yield source, (), config.depth - 1
        else:
            yield to, (*config.known, config.no), config.depth + 1

    def _entered(self, config: _Config, no: str, actions: tuple[Action, ...]) -> _Config:
        """What is after the actions of an event and the entry of a state."""
        after = self._did(config, actions)
        state = self.states[no]
        written = dict(after.written)
        entered_state(self.search.moment.variables, written, self.ways.application.name, no)
        entered = _Config(no, after.queue, written, after.known, after.depth, after.sure)
        return self._did(entered, state.actions)

    def _did(self, config: _Config, actions: tuple[Action, ...]) -> _Config:
        """What is after those of some actions that end at once."""
        variables = self.search.moment.variables
        written = dict(config.written)
        queue = list(config.queue)
        for action in actions:
            if isinstance(action, QUICK):
                write(variables, written, action)
                if action.done is not None:
                    queue.append(action.done)
            elif isinstance(action, _SLOW) and action.wait:
                break
        return _Config(config.no, tuple(queue), written, config.known, config.depth, config.sure)

    # -- telling ------------------------------------------------------------------

    def tell(self) -> None:
        """Tells the loops found from one beginning."""
        for loop in self.loops:
            steps = loop[:-1]
            round_ = frozenset((step.config.no, step.place) for step in steps)
            sure = loop[-1].config.sure
            if round_ not in self.told:
                self.told.add(round_)
                self._tell_loop(steps, sure)

    def _tell_loop(self, steps: list[_Step], sure: bool) -> None:
        first = min((step.config.no for step in steps), key=self.order.__getitem__)
        state = self.states[first]
        place: Place = ("state", first)
        aside = state.aside
        for step in steps:
            if step.config.no == first and step.event is not None and step.place[0] == "state":
                place, aside = step.place, step.event.aside
                break
        if not sure:
            what = "whether this can go round for ever without waiting"
            self.search.undecided(self.ways.file, what, aside, place)
            return
        several = list(dict.fromkeys(step.config.no for step in steps))
        taken = list(dict.fromkeys(_called(s.event, s.place) for s in steps if s.event is not None))
        if len(several) == 1:
            who = f"The state {words.state(state)} can begin again and again"
        else:
            listed = words.listed(words.state(self.states[no]) for no in several)
            who = f"The states {listed} can lead to each other for ever"
        message = (
            f"{who} without waiting ({words.listed(taken)}): let a condition fail once "
            "it was followed, or wait for a timeout or for an event from outside"
        )
        self.search.warn(self.ways.file, "livelock", message, aside, place)


def _entered_from(ways: Ways, reached: set[str]) -> dict[str, list[str]]:
    """By state, those from which it is entered."""
    into: dict[str, set[str]] = {}
    for no in reached:
        for way in ways.of[no]:
            if way.next != AGAIN:
                for target in ways.targets(way):
                    into.setdefault(target, set()).add(way.source)
    return {no: sorted(sources) for no, sources in into.items()}


def _called(event: Event, place: Place) -> str:
    return words.event(event) + (" of every state" if place[0] == "always" else "")


def raises(actions: Iterable[Action]) -> bool:
    """Whether some action that is begun at once ends at once, and raises something."""
    for action in actions:
        if isinstance(action, QUICK) and action.done is not None:
            return True
        if isinstance(action, _SLOW) and action.wait:
            return False
    return False
