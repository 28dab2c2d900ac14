"""Conditions kept up to date by tag: tests, ``within`` and ``for`` (formats.md, *Conditions*).

A condition is judged when one of its tags was written or the end of one of its
``within`` or ``for`` fell due, never by looking at all of them.
"""

from __future__ import annotations

from collections import defaultdict, deque
from collections.abc import Callable

from msgspec import Struct

from situ.decide.board import Board, prefixes
from situ.decide.step import TEST, Step, duration
from situ.decide.values import compile_test, read
from situ.document.condition import Condition, Group, Test

Watcher = Callable[[int | None], None]
"""Told, with the cause, that a condition may have changed."""


class Held(Struct):
    """Since when a test with ``for`` has held without a break, and what began it."""

    since: int
    cause: int | None


class ConditionsState(Struct):
    """By number of the test: the holding of tests with ``for``; armed ends of ``within``."""

    held: dict[int, Held] = {}
    armed: dict[int, int] = {}


class Leaf:
    """One test of one condition, compiled."""

    __slots__ = ("flag", "hold", "name", "number", "source", "test", "text", "within")

    def __init__(self, number: int, source: Test) -> None:
        self.number = number
        self.source = source
        self.name = source.tag
        self.test, _ = compile_test(source.test, source.value)
        self.text = source.value
        # The commonest test of all: ``is="true"``.
        wanted = read(source.value) if source.test == "is" else None
        self.flag = wanted if isinstance(wanted, bool) else None
        self.within = None if source.within is None else duration(source.within)
        self.hold = None if source.hold is None else duration(source.hold)


Compiled = Callable[[], bool]

Seen = set[str] | None
"""Gets the tags that are looked at, where somebody listens to them himself."""


class Conditions:
    """All conditions of a robot: they share the following of ``for`` from the start."""

    def __init__(self, board: Board, step: Step) -> None:
        self.state = ConditionsState()
        self._board = board
        self._step = step
        self._leaves: list[Leaf] = []
        self._watchers: dict[int, list[Watcher]] = {}

    def compile(
        self, condition: Condition, watcher: Watcher | None, tags: set[str] | None = None
    ) -> Compiled:
        """A callable that judges it now. ``watcher`` hears when its truth may have changed,
        by a write or by time; None: nobody needs to (a guard is judged when its event comes).

        Where ``tags`` are given, those that it looks at are added to them, and ``watcher`` hears
        of time only: who has many conditions listens to writes once for all of them.
        """
        return self._all(condition.children, watcher, tags)

    def start(self) -> None:
        """Time 0: tests with ``for`` that hold before anything was set begin to count."""
        for leaf in self._leaves:
            if leaf.hold is not None:
                self._follow(leaf, None)

    def carry(self, old: Conditions, cause: int) -> dict[int, int]:
        """Goes on in place of ``old``: a test that stood there keeps its clocks, however its
        condition was moved; one that is new counts from now, and from ``cause``. Gives the new
        numbers of the tests that are there still, by their old ones: for their timers.
        """
        there: defaultdict[tuple[Test, bool], deque[int]] = defaultdict(deque)
        followed: dict[tuple[str, str, str], Held | None] = {}
        for leaf in old._leaves:
            there[leaf.source, leaf.number in old._watchers].append(leaf.number)
            if leaf.hold is not None:
                followed[_what(leaf)] = old.state.held.get(leaf.number)
        moved: dict[int, int] = {}
        for leaf in self._leaves:
            watched = leaf.number in self._watchers
            same = there[leaf.source, watched]
            if leaf.hold is not None:
                self._hold_on(leaf, followed, cause, watched and not same)
            if same:
                was = same.popleft()
                moved[was] = leaf.number
                if was in old.state.armed:
                    self.state.armed[leaf.number] = old.state.armed[was]
            elif watched and leaf.within is not None:
                entry = self._board.last_set(leaf.name)
                if entry is not None and entry.time + leaf.within > self._step.now:
                    self._arm(leaf, entry.time)
        return moved

    def _hold_on(
        self, leaf: Leaf, followed: dict[tuple[str, str, str], Held | None], cause: int, rings: bool
    ) -> None:
        """A test with ``for`` goes on as it was ``followed``, under another ``for`` too."""
        assert leaf.hold is not None
        if _what(leaf) in followed:
            held = followed[_what(leaf)]
        elif leaf.test(self._board.look(leaf.name), self._board.look):
            held = Held(self._step.now, cause)
        else:
            held = None
        if held is not None:
            self.state.held[leaf.number] = held
            if rings and held.since + leaf.hold > self._step.now:
                self._step.at(held.since + leaf.hold, TEST, f"test:{leaf.number}", 1)

    def due(self, number: int, token: int) -> None:
        """The end of a ``within`` or ``for`` of a test: its watchers judge anew."""
        leaf = self._leaves[number]
        if token:  # the end of a ``for``
            held = self.state.held.get(number)
            if (
                held is not None
                and leaf.hold is not None
                and held.since + leaf.hold == self._step.now
            ):
                self._tell(number, held.cause)
            return
        self.state.armed.pop(number, None)
        entry = self._board.last_set(leaf.name)
        if entry is None or leaf.within is None:
            return
        if entry.time + leaf.within > self._step.now:
            self._arm(leaf, entry.time)
        else:
            self._tell(number, entry.cause)

    def _tell(self, number: int, cause: int | None) -> None:
        for watcher in self._watchers.get(number, ()):
            watcher(cause)

    # -- compiling -----------------------------------------------------------

    def _all(
        self, children: tuple[Test | Group, ...], watcher: Watcher | None, seen: Seen
    ) -> Compiled:
        parts = [self._one(child, watcher, seen) for child in children]
        if len(parts) == 1:
            return parts[0]
        return lambda: all(part() for part in parts)

    def _one(self, node: Test | Group, watcher: Watcher | None, seen: Seen) -> Compiled:
        if isinstance(node, Test):
            return self._leaf(node, watcher, seen)
        if node.kind == "all":
            return self._all(node.children, watcher, seen)
        parts = [self._one(child, watcher, seen) for child in node.children]
        if node.kind == "any":
            return lambda: any(part() for part in parts)
        return lambda: not any(part() for part in parts)

    def _leaf(self, source: Test, watcher: Watcher | None, seen: Seen) -> Compiled:
        leaf = Leaf(len(self._leaves), source)
        self._leaves.append(leaf)
        _, referred = compile_test(source.test, source.value)
        tags = [tag for name in (leaf.name, *referred) for tag in prefixes(name)]
        if leaf.hold is not None:
            self._board.listen(tags, lambda tag, cause: self._follow(leaf, cause))
        if watcher is not None:
            if leaf.within is not None:
                self._board.listen(
                    prefixes(leaf.name), lambda tag, cause: self._arm(leaf, self._step.now)
                )
            self._watchers.setdefault(leaf.number, []).append(watcher)
            if seen is not None:
                seen.update(tags)
            else:
                self._board.listen(tags, lambda tag, cause: watcher(cause))
        return self._judge(leaf)

    def _judge(self, leaf: Leaf) -> Compiled:
        board, step, test, name = self._board, self._step, leaf.test, leaf.name
        if leaf.within is None and leaf.hold is None:
            return self._judge_now(leaf)

        def holds() -> bool:
            if leaf.within is not None:
                entry = board.last_set(name)
                if entry is None or step.now >= entry.time + leaf.within:
                    return False
            if leaf.hold is not None:
                held = self.state.held.get(leaf.number)
                return held is not None and step.now >= held.since + leaf.hold
            return test(board.look(name), board.look)

        return holds

    def _judge_now(self, leaf: Leaf) -> Compiled:
        board, test, name = self._board, leaf.test, leaf.name
        look = board.look
        if "." in name:
            return lambda: test(look(name), look)
        # A single word is a tag or nothing.
        if leaf.flag is not None:
            flag, text = leaf.flag, leaf.text

            def is_flag() -> bool:
                entry = board.state.get(name)
                return entry is not None and (entry.value is flag or entry.value == text)

            return is_flag

        def holds() -> bool:
            entry = board.state.get(name)
            return test(None if entry is None else entry.value, look)

        return holds

    # -- time ----------------------------------------------------------------

    def _follow(self, leaf: Leaf, cause: int | None) -> None:
        """A write that the ``for`` of this test may break or begin."""
        held = self.state.held
        if not leaf.test(self._board.look(leaf.name), self._board.look):
            held.pop(leaf.number, None)
        elif leaf.number not in held and leaf.hold is not None:
            held[leaf.number] = Held(self._step.now, cause)
            if leaf.number in self._watchers:
                self._step.at(self._step.now + leaf.hold, TEST, f"test:{leaf.number}", 1)

    def _arm(self, leaf: Leaf, written: int) -> None:
        """One timer a test serves however often its tag is set: it is set on when it rings."""
        if leaf.within is not None and leaf.number not in self.state.armed:
            self.state.armed[leaf.number] = written + leaf.within
            self._step.at(written + leaf.within, TEST, f"test:{leaf.number}", 0)


def _what(leaf: Leaf) -> tuple[str, str, str]:
    """What a ``for`` follows, however long."""
    return leaf.name, leaf.source.test, leaf.text
