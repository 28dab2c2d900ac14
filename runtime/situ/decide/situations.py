"""Situation observation (seed 000, 5.2; formats.md, *SPDS*): which situation is current."""

from __future__ import annotations

import heapq

from msgspec import Struct

from situ.decide import trace
from situ.decide.board import Board, Listener, prefixes
from situ.decide.conditions import Compiled, Conditions, Watcher
from situ.decide.flips import Flips
from situ.decide.step import HOLD, Step, Timer, duration
from situ.document.condition import Condition, Group, Test
from situ.document.spds import Situation, Spds

_NEVER = (0, None)
"""A name that was not written."""


class Observation(Struct):
    """What is known of one situation.

    condition, until: their truth as last judged. kept: since it became current it
    holds by ``dwell``, ``until`` or ``limit``, whatever its condition; dwelt: that was
    counted once since it began to hold. spent: ended by ``until`` or ``limit``; it waits
    for its condition to be false once. listed: stands among the candidates. begin_cause,
    end_cause: what lets it begin, what ended it.
    """

    condition: bool
    until: bool = False
    kept: bool = False
    dwelt: bool = False
    spent: bool = False
    listed: bool = False
    token: int = 0
    current_seq: int | None = None
    begin_cause: int | None = None
    end_cause: int | None = None


class SituationsState(Struct):
    """stale: situations to be judged, with what their condition was told last; untils: what
    their until was. told: names written since they were judged last: which was it in the order
    of writing, and its cause.
    """

    observations: list[Observation] = []
    current: int | None = None
    stale: dict[int, int | None] = {}
    untils: dict[int, int | None] = {}
    told: dict[str, tuple[int, int | None]] = {}
    writes: int = 0
    candidates: list[int] = []


class Situations:
    """The situation observation service of one robot."""

    def __init__(self, spds: Spds, conditions: Conditions, board: Board, step: Step) -> None:
        self.spds = spds
        self._step = step
        self._board = board
        self._sources = spds.situations
        self.priorities = spds.every_priorities()
        self._conditions: list[Compiled | None] = []
        self._untils: list[Compiled | None] = []
        self._flips: dict[str, Flips] = {}
        self._names: list[list[str]] = []
        self.state = SituationsState()
        # Of a new version while its situations are judged for the first time: its cause, and the
        # name of the situation that was current and is gone.
        self._because: int | None = None
        self._gone: str | None = None
        for number, source in enumerate(self._sources):
            stale, until = self._watchers(number)
            tests = plain(source.condition)
            for test in tests:
                self._follow(test.tag).add(test, number)
            self._names.append(list({test.tag: test for test in tests}))
            watcher = None if tests else stale
            self._conditions.append(
                None if source.condition is None else conditions.compile(source.condition, watcher)
            )
            self._untils.append(
                None if source.until is None else conditions.compile(source.until, until)
            )
            self.state.observations.append(Observation(condition=source.condition is None))
            self.state.stale[number] = None

    def _watchers(self, number: int) -> tuple[Watcher, Watcher]:
        """Those of a situation's condition and of its until: each has its own cause."""

        def stale(cause: int | None) -> None:
            self.state.stale[number] = cause

        def until(cause: int | None) -> None:
            self.state.untils[number] = cause
            self.state.stale.setdefault(number, None)

        return stale, until

    def _follow(self, name: str) -> Flips:
        found = self._flips.get(name)
        if found is None:
            found = self._flips[name] = Flips(name, self._board.look)
            self._board.listen(prefixes(name), self._written(found, name))
        return found

    def _written(self, flips: Flips, name: str) -> Listener:
        def written(tag: str, cause: int | None) -> None:
            state = self.state
            state.writes += 1
            state.told[name] = (state.writes, cause)
            for number in flips.changed():
                state.stale[number] = None

        return written

    def restore(self, state: SituationsState) -> None:
        """Goes on from a state of the same script; the board has been restored before."""
        self.state = state
        self._look()

    def _look(self) -> None:
        """What the names have now is what their tests changed from next."""
        for name, flips in self._flips.items():
            flips.value = self._board.look(name)

    def carry(self, old: Situations, timers: list[Timer]) -> dict[int, int]:
        """Goes on in place of ``old``, whose live timers are given: a situation of the same name
        stays current, ended or kept as it was, its dwell or limit counted on under the new length.
        All that is new or changed is to be judged. Gives new numbers by old ones.
        """
        before = {source.name: number for number, source in enumerate(old._sources)}
        moved: dict[int, int] = {}
        for number, source in enumerate(self._sources):
            was = before.get(source.name)
            if was is None:
                continue
            moved[was] = number
            former, seen = old._sources[was], old.state.observations[was]
            self.state.observations[number] = seen
            if (former.condition, former.until) == (source.condition, source.until):
                self.state.stale.pop(number)
            if former.condition != source.condition:
                seen.condition, seen.spent = source.condition is None, False
            if source.until is None:
                seen.until = False
            self._count_on(number, was, former, timers)
        self.state.stale |= {moved[n]: told for n, told in old.state.stale.items() if n in moved}
        at = old.state.current
        self.state.current = None if at is None else moved.get(at)
        self._gone = None if at is None or at in moved else old._sources[at].name
        for number, seen in enumerate(self.state.observations):
            seen.listed = self._holds(number)
            if seen.listed:
                self.state.candidates.append(number)
        self._look()
        return moved

    def _count_on(self, number: int, was: int, former: Situation, timers: list[Timer]) -> None:
        """A situation that is kept by ``dwell``, ``until`` or ``limit`` is so by the new ones."""
        source, seen = self._sources[number], self.state.observations[number]
        if not seen.kept or _keeps(former) == _keeps(source):
            return
        old_length, length = _length(former), _length(source)
        owner, now = f"situation:{was}", self._step.now
        due = next((t.due for t in timers if (t.owner, t.token) == (owner, seen.token)), None)
        seen.token += 1
        if length is not None:
            began = now if due is None or old_length is None else due - duration(old_length)
            end = max(now, began + duration(length))
            self._step.at(end, HOLD, f"situation:{number}", seen.token)
        elif source.until is None:
            seen.kept = seen.dwelt = False

    def judge_anew(self, because: int) -> int | None:
        """``observe`` where the script itself is another; ``because`` is the cause of all of it."""
        self._because = because
        chosen = self.observe()
        self._because, self._gone = None, None
        return chosen

    @property
    def current(self) -> Situation | None:
        at = self.state.current
        return None if at is None else self._sources[at]

    def granted(self) -> dict[str, int]:
        """Module to priority in the current situation."""
        at = self.state.current
        return {} if at is None else self.priorities[at]

    def observe(self) -> int | None:
        """Judges what changed; traces conditions and, where it changed, the situation.

        Gives the seq of the ``situation`` event, None where the current one stays.
        """
        state = self.state
        if state.stale or state.current is None or self._because is not None:
            stale = sorted(state.stale.items())
            state.stale.clear()
            for number, cause in stale:
                self._judge(number, cause)
            chosen = self._choose()
        else:
            chosen = None
        state.told.clear()
        return chosen

    def is_live(self, number: int, token: int) -> bool:
        """Whether a timer of the situation still means something."""
        seen = self.state.observations[number]
        return seen.kept and seen.token == token

    def due(self, number: int) -> None:
        """The end of a ``dwell`` or ``limit`` that still counts; ``observe`` then follows."""
        seen = self.state.observations[number]
        seen.end_cause = seen.current_seq
        source = self._sources[number]
        if source.dwell is not None:
            seen.kept = False
        else:
            self._end(number)
        self._offer(number)

    # ------------------------------------------------------------------------

    def _judge(self, number: int, cause: int | None) -> None:
        source, seen = self._sources[number], self.state.observations[number]
        condition, until = self._conditions[number], self._untils[number]
        if condition is not None:
            holds = condition()
            if holds != seen.condition:
                seen.condition = holds
                if self._names[number]:
                    cause = self._last_told(self._names[number])
                if self._because is not None:
                    cause = self._because
                seen.begin_cause = self._step.trace(trace.Condition, cause, source.name, holds)
                if not holds:
                    seen.spent = False
                    if not seen.kept:
                        seen.end_cause = seen.begin_cause
        if until is not None:
            cause = self.state.untils.pop(number, None)
            was, seen.until = seen.until, until()
            if was and not seen.until:
                seen.begin_cause = cause
            if seen.until and seen.kept:
                seen.end_cause = cause
                self._end(number)
        self._offer(number)

    def _last_told(self, names: list[str]) -> int | None:
        """The cause of the last write that a condition of these names was told."""
        told = self.state.told
        if len(names) == 1:
            return told.get(names[0], _NEVER)[1]
        return max(told.get(name, _NEVER) for name in names)[1]

    def _end(self, number: int) -> None:
        """Ended by ``until`` or ``limit``: not again before its condition was false once."""
        seen = self.state.observations[number]
        seen.kept = False
        seen.spent = seen.condition

    def _holds(self, number: int) -> bool:
        seen = self.state.observations[number]
        return seen.kept or (seen.condition and not seen.spent and not seen.until)

    def _offer(self, number: int) -> None:
        seen = self.state.observations[number]
        if self._holds(number):
            if not seen.listed:
                seen.listed = True
                heapq.heappush(self.state.candidates, number)
        else:
            # It no longer holds: when it begins again its dwell is counted anew.
            seen.dwelt = False
            if number == self.state.current:
                self.state.stale.setdefault(number, None)

    def _choose(self) -> int | None:
        state = self.state
        while state.candidates and not self._holds(state.candidates[0]):
            state.observations[heapq.heappop(state.candidates)].listed = False
        first = state.candidates[0] if state.candidates else None
        state.stale.clear()
        if first == state.current:
            return None
        before, now = state.current, first
        state.current = first
        cause = self._because if self._because is not None else self._cause(before, now)
        left = self._name(before) if before is not None else self._gone
        seq = self._step.trace(trace.Situation, cause, left, self._name(now))
        if now is not None:
            self._begin(now, seq)
        return seq

    def _begin(self, number: int, seq: int) -> None:
        source, seen = self._sources[number], self.state.observations[number]
        if _keeps(source) == _NOTHING or seen.kept or seen.dwelt:
            return
        seen.kept, seen.dwelt, seen.current_seq = True, True, seq
        length = _length(source)
        if length is not None:
            seen.token += 1
            due = self._step.now + duration(length)
            self._step.at(due, HOLD, f"situation:{number}", seen.token)

    def _cause(self, before: int | None, now: int | None) -> int | None:
        """What began the new one if it stands first, else what ended the old one."""
        seen = self.state.observations
        if before is None:
            return seen[now].begin_cause if now is not None else None
        if now is not None and now < before:
            return seen[now].begin_cause
        return seen[before].end_cause

    def _name(self, number: int | None) -> str | None:
        return None if number is None else self._sources[number].name


_NOTHING = (None, None, False)


def _keeps(source: Situation) -> tuple[float | None, float | None, bool]:
    """What keeps it whatever its condition: dwell, limit, and whether there is an until."""
    return source.dwell, source.limit, source.until is not None


def _length(source: Situation) -> float | None:
    """How long it is kept at the least (dwell) or at the most (limit), in seconds."""
    return source.dwell if source.dwell is not None else source.limit


def plain(condition: Condition | None) -> list[Test]:
    """The tests of a condition where each depends on one value alone; none where time counts."""
    tests: list[Test] = []
    waiting = list(condition.children) if condition is not None else []
    while waiting:
        node = waiting.pop()
        if isinstance(node, Group):
            waiting += node.children
        elif node.within is not None or node.hold is not None:
            return []
        else:
            tests.append(node)
    return tests
