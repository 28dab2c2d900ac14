"""Right-angled routes for all pipes of a drawing: spread in corridors, joined, folded, labelled.

Measures are those of mockups/tokens.md, *Pipes*; lengths are scene units. Pure:
no Qt types, no clock, and the same input gives the same routes. The way of one
pipe is ``ways.py``'s, its label's place ``labels.py``'s.
"""

from __future__ import annotations

import heapq
from collections.abc import Generator, Iterable, Iterator, Mapping, Sequence
from functools import lru_cache

from msgspec import Struct
from msgspec.structs import replace

from situ_studio.canvas.labels import Labels
from situ_studio.canvas.space import Box, Pipe, PipeId, Point, length
from situ_studio.canvas.ways import Ways

__all__ = ["Box", "Pipe", "Point", "Route", "Router"]

BURDEN = 965.0
"""A pipe that is more in the way than this is folded."""
MANY = 300
"""From so many pipes on, crossings are not counted and no pipe is routed twice."""
LONG = 450.0
"""No way that is shorter is folded."""


class Route(Struct, frozen=True):
    """points: the corners; empty for a folded pipe. label: centre of the label, if it fits,
    room: its width there, less than was asked for where it has to be shortened.

    joint: where the pipe meets another one to the same card, a dot. trunk: the
    pipe whose label names this one too.
    """

    points: tuple[Point, ...] = ()
    label: Point | None = None
    room: float = 0.0
    joint: Point | None = None
    trunk: PipeId | None = None
    folded: bool = False


_Drawing = tuple[tuple[tuple[str, Box], ...], tuple[Pipe, ...], frozenset[PipeId]]


class Router:
    """Routes of one drawing.

    ``route`` does all of it, ``routing`` in slices, ``change`` what a few changes
    ask for. drawn: ids that are never folded because somebody asked to see them.
    """

    def __init__(self) -> None:
        self.routes: dict[PipeId, Route] = {}
        self.drawn: set[PipeId] = set()
        self._ways = Ways({})
        self._labels = Labels(self._ways)
        self._groups: dict[tuple[str, str], list[Pipe]] = {}
        self._pipes: dict[PipeId, Pipe] = {}
        self._folded: set[PipeId] = set()
        # Of these, those that no way led round the cards for: another place may have one.
        self._without: set[PipeId] = set()
        self._paths: dict[PipeId, tuple[Point, ...]] = {}
        # What was asked for last, and whether only its routes are known: see ``_catch_up``.
        self._asked: _Drawing = ((), (), frozenset())
        self._is_behind = False

    def route(self, boxes: Mapping[str, Box], pipes: Iterable[Pipe]) -> dict[PipeId, Route]:
        """The route of every pipe, by id; at once where this process has routed the same lately,
        as for a second window or view, or before an undo.
        """
        self._asked = tuple(boxes.items()), tuple(pipes), frozenset(self.drawn)
        known = _known(*self._asked)
        self._is_behind = bool(known)
        if known:
            self.routes = dict(known)
            return self.routes
        for _ in self.routing(boxes, self._asked[1]):
            pass
        known.update(self.routes)
        return self.routes

    def routing(self, boxes: Mapping[str, Box], pipes: Iterable[Pipe]) -> Iterator[None]:
        """Does what ``route`` does and yields now and then; ``routes`` holds when it has ended."""
        self._is_behind = False
        self._pipes = {p.id: p for p in pipes}
        careful = len(self._pipes) <= MANY
        self._ways = Ways({}, careful)
        self._labels = Labels(self._ways)
        self._paths, self._folded, self._without = {}, set(), set()
        self._groups = {}
        for name, box in boxes.items():
            self._ways.space.put(name, box)
            yield
        for pipe in self._pipes.values():
            self._groups.setdefault((pipe.source, pipe.target), []).append(pipe)
        yield
        trunks = []
        for group in self._groups.values():
            trunks.append(self._trunk(group))
            yield
        trunks.sort(key=_effort)
        for pipe in trunks:
            yield
            if self._folds_at_once(pipe):
                self._fold(pipe)
            elif self._is_too_far(pipe):
                self._fold_for_now(pipe)
        for pipe in trunks:
            if pipe.id not in self._folded:
                yield
                self._put_or_fold(pipe)
        if careful:
            yield from self._again(trunks)
        yield from self._fold_long(trunks)
        if careful:
            # What is folded made room, and its chip takes some.
            yield from self._again(trunks)
        self.routes = {}
        for pipe in trunks:
            self._finish_ways(pipe)
            yield
        # Sorting is steady: of those of one height the order is the same as before.
        for pipe in sorted(trunks, key=lambda p: -p.height):
            self._finish_label(pipe)
            yield

    def change(
        self, boxes: Mapping[str, Box | None], pipes: Mapping[PipeId, Pipe | None]
    ) -> set[PipeId]:
        """Cards that are elsewhere now or gone, pipes that are new, different or gone.

        They are routed anew, and so are the pipes that ran where a card is now;
        the others stay as they are, and what is folded stays folded. Returns the
        ids whose route is another one.
        """
        steps = self.changing(boxes, pipes)
        while True:
            try:
                next(steps)
            except StopIteration as done:
                changed: set[PipeId] = done.value
                return changed

    def changing(
        self, boxes: Mapping[str, Box | None], pipes: Mapping[PipeId, Pipe | None]
    ) -> Generator[None, None, set[PipeId]]:
        """The same, a pipe at a time; to be ended before anything else is asked for."""
        if self._is_behind:
            self._catch_up()
        pipes = {
            id: pipe
            for id, pipe in pipes.items()
            if self._pipes.get(id) != pipe or (id in self.drawn and id in self._folded)
        }
        touched = set(pipes)
        for name, box in boxes.items():
            self._ways.space.put(name, box)
            if box is not None:
                near = self._ways.through(box) | self._labels.on(box)
                touched |= {p for p in near if name not in self._ends(p)}
        keys: set[tuple[str, str]] = set()
        for id in touched:
            for known in (self._pipes.get(id), pipes.get(id)):
                if known is not None:
                    keys.add((known.source, known.target))
        folded: set[tuple[str, str]] = set()
        before: dict[PipeId, Route] = {}
        for key in keys:
            for pipe in self._groups.get(key, ()):
                if pipe.id in self._folded and pipe.id not in self._without:
                    folded.add(key)
                self._erase(pipe, before)
        for id, new in pipes.items():
            old = self._pipes.pop(id, None)
            if old is not None:
                self._groups[old.source, old.target].remove(old)
            if new is not None:
                self._pipes[id] = new
                self._groups.setdefault((new.source, new.target), []).append(new)
        trunks = []
        for key in keys:
            if self._groups.get(key):
                trunks.append(self._trunk(self._groups[key]))
            else:
                self._groups.pop(key, None)
        trunks.sort(key=_effort)
        for pipe in trunks:
            if (
                (pipe.source, pipe.target) in folded and pipe.id not in self.drawn
            ) or self._folds_at_once(pipe):
                self._fold(pipe)
            elif self._is_too_far(pipe):
                self._fold_for_now(pipe)
        for pipe in trunks:
            if pipe.id not in self._folded:
                self._put_or_fold(pipe)
                yield
        for pipe in trunks:
            self._finish_ways(pipe)
        yield
        covered: set[PipeId] = set()
        for key in keys:
            for pipe in self._groups.get(key, ()):
                covered |= self._labels.under(self.routes[pipe.id].points)
        for id in covered:
            # A label of another pipe makes way.
            before.setdefault(id, self.routes[id])
            self._labels.take_up(id)
            self.routes[id] = replace(self.routes[id], label=None, room=0.0)
        for pipe in [*trunks, *(self._pipes[id] for id in sorted(covered))]:
            self._finish_label(pipe)
            yield
        now = {p.id for key in keys for p in self._groups.get(key, ())} | covered
        return {id for id in now if before.get(id) != self.routes[id]}

    def _catch_up(self) -> None:
        """A change needs to know where the others run: what was known is routed after all."""
        boxes, pipes, drawn = self._asked
        self.drawn, now = set(drawn), self.drawn
        for _ in self.routing(dict(boxes), pipes):
            pass
        self.drawn = now

    def _ends(self, id: PipeId) -> tuple[str, ...]:
        pipe = self._pipes.get(id)
        return (pipe.source, pipe.target) if pipe is not None else ()

    def _erase(self, pipe: Pipe, before: dict[PipeId, Route]) -> None:
        """As if it had never been routed."""
        route = self.routes.pop(pipe.id, None)
        if route is not None:
            before[pipe.id] = route
        points = self._paths.pop(pipe.id, None)
        if points is not None:
            self._ways.rub_out(pipe, points)
        if pipe.id in self._folded:
            self._folded.discard(pipe.id)
            self._without.discard(pipe.id)
            self._ways.drop_chip(pipe)
        self._labels.forget(pipe.id)

    def _trunk(self, group: Sequence[Pipe]) -> Pipe:
        """The pipe of a group (one source, one target) that the others join: the first event."""
        trunk = min(group, key=lambda p: (p.timeout, p.start[1]))
        self._ways.joining.pop(trunk.id, None)
        if len(group) > 1:
            exits = [p.start[1] for p in group]
            self._ways.joining[trunk.id] = min(exits), max(exits)
        return trunk

    # -- ways and folding --------------------------------------------------------------

    def _put_or_fold(self, pipe: Pipe) -> None:
        """Draws the pipe, or folds it where it would be folded for its length in the end."""
        if not self._may_fold(pipe):
            self._put(pipe, self._ways.find(pipe))
            return
        way = self._ways.find_within(pipe, 2 * (BURDEN - _upwards(pipe)))
        if way is not None:
            self._put(pipe, way)
        elif _apart(pipe) > LONG or not self._ways.is_shut(pipe):
            self._fold_for_now(pipe)
        else:
            # Cards that touch or overlap, as while one is dragged: as long as it stands there.
            self._put(pipe, self._ways.straight(pipe))

    def _may_fold(self, pipe: Pipe) -> bool:
        return pipe.fold and pipe.id not in self.drawn and pipe.source != pipe.target

    def _put(self, pipe: Pipe, points: tuple[Point, ...]) -> None:
        self._paths[pipe.id] = points
        self._ways.draw(pipe, points)

    def _again(self, trunks: Sequence[Pipe]) -> Iterator[None]:
        """Each pipe that is in another's way once more, now that all are known."""
        ways = self._ways
        for _ in range(2):
            better = False
            for pipe in trunks:
                old = self._paths.get(pipe.id)
                if old is None or len(old) < 3:
                    continue
                before = ways.cost(pipe, old)
                if before - length(old) - 14.0 * (len(old) - 2) < 2.0:
                    continue
                yield
                ways.rub_out(pipe, old)
                new = ways.find(pipe)
                if ways.cost(pipe, new) >= before - 0.5:
                    new = old
                better = better or new is not old
                self._put(pipe, new)
            if not better:
                break

    def _folds_at_once(self, pipe: Pipe) -> bool:
        """Timeouts that lead back are folded before anything is drawn: they only take room."""
        if not self._may_fold(pipe):
            return False
        (x1, y1), (x2, y2) = pipe.start, pipe.end
        return pipe.folded or (pipe.timeout and (x2 < x1 or y2 < y1 - 60))

    def _is_too_far(self, pipe: Pipe) -> bool:
        """Whether any way would be folded in the end."""
        far = _apart(pipe) > LONG and 0.5 * _apart(pipe) + _upwards(pipe) > BURDEN
        return far and self._may_fold(pipe)

    def _fold_for_now(self, pipe: Pipe) -> None:
        """Elsewhere it may have a way."""
        self._without.add(pipe.id)
        self._fold(pipe)

    def _fold_long(self, trunks: Sequence[Pipe]) -> Iterator[None]:
        """What would cross the drawing: the worst first, for the others are the better for it."""
        heavy: list[tuple[float, int, Pipe]] = []
        for pipe in trunks:
            points = self._paths.get(pipe.id)
            if points is None or not self._may_fold(pipe) or length(points) <= LONG:
                continue
            burden = self._burden(pipe)
            if burden > BURDEN:
                heavy.append((-burden, len(heavy), pipe))
            yield
        heapq.heapify(heavy)
        while heavy:
            before, rank, pipe = heavy[0]
            burden = self._burden(pipe)
            if BURDEN < burden < -before:
                # Others that crossed it are folded by now, so another may be the worst.
                heapq.heapreplace(heavy, (-burden, rank, pipe))
                continue
            heapq.heappop(heavy)
            if burden > BURDEN:
                self._ways.rub_out(pipe, self._paths.pop(pipe.id))
                self._fold(pipe)
            yield

    def _burden(self, pipe: Pipe) -> float:
        """How much a pipe is in the way of the drawing."""
        points = self._paths[pipe.id]
        crossings = self._ways.crossings(pipe, points) if self._ways.careful else 0
        return 120.0 * crossings + 0.5 * length(points) + _upwards(pipe)

    def _fold(self, pipe: Pipe) -> None:
        self._folded.add(pipe.id)
        self._ways.put_chip(pipe)

    # -- joints and labels -----------------------------------------------------------------

    def _finish_ways(self, trunk: Pipe) -> None:
        """The routes of a group: its trunk's way, and what joins it."""
        folded = trunk.id in self._folded
        route = Route(points=self._paths.get(trunk.id, ()), folded=folded)
        self.routes[trunk.id] = self._met(trunk, route)
        for pipe in self._groups[trunk.source, trunk.target]:
            if pipe.id != trunk.id:
                self.routes[pipe.id] = self._join(pipe, trunk, route)

    def _join(self, pipe: Pipe, trunk: Pipe, route: Route) -> Route:
        """A further exit to the same card runs into the trunk at a dot, if nothing is between."""
        if route.folded:
            return Route(folded=True, trunk=trunk.id)
        (x, y), points = pipe.start, route.points
        if len(points) == 2:
            lane, height = self._ways.beside(pipe, points[0][1], points[1][0]), points[0][1]
        else:
            lane, height = points[1][0], points[1][1]
            low, high = sorted((height, points[2][1]))
            height = y if low <= y <= high else height
        way: tuple[Point, ...] = ((x, y), (lane, y), (lane, height))
        if height == y:
            way = way[:2]
        if not self._ways.free(way, pipe.source):
            way = self._ways.find(pipe)
            self._put(pipe, way)
            return Route(points=way)
        self._labels.put_stub(pipe, way)
        return Route(points=way, joint=way[-1], trunk=trunk.id)

    def _met(self, pipe: Pipe, route: Route) -> Route:
        """With a dot where the pipe runs into the way of another card's pipe to the same card."""
        if len(route.points) < 4 or pipe.source == pipe.target:
            return route
        for x, y in route.points[2:-1]:
            if abs(x - pipe.end[0]) + abs(y - pipe.end[1]) < 30:
                continue
            for line in self._ways.level.between(y, y, x - 0.1, x + 0.1):
                if (
                    line.target == pipe.goal
                    and line.pipe != pipe.id
                    and line.low + 1 < x < line.high - 1
                ):
                    return replace(route, joint=(x, y))
        return route

    def _finish_label(self, pipe: Pipe) -> None:
        route = self.routes[pipe.id]
        if route.folded or not pipe.width:
            return
        found = self._labels.place(pipe, route.points)
        if found is not None:
            self.routes[pipe.id] = replace(route, label=found[0], room=found[1])


@lru_cache(maxsize=64)
def _known(
    boxes: tuple[tuple[str, Box], ...], pipes: tuple[Pipe, ...], drawn: frozenset[PipeId]
) -> dict[PipeId, Route]:
    """The routes of that drawing: empty until they have been put in."""
    return {}


def _upwards(pipe: Pipe) -> float:
    """How much more a pipe is in the way that leads up."""
    return 380.0 if pipe.end[1] < pipe.start[1] - 60 else 0.0


def _apart(pipe: Pipe) -> float:
    """No way is shorter."""
    return abs(pipe.end[0] - pipe.start[0]) + abs(pipe.end[1] - pipe.start[1])


def _effort(pipe: Pipe) -> tuple[float, ...]:
    """Short ways first: they take the inner lanes. Of one card's, the one nearest to its goal."""
    (x1, y1), (x2, y2) = pipe.start, pipe.end
    if pipe.source == pipe.target:
        # Loops have no choice.
        return (-1.0, y1, x1, y2, x2)
    back = 400.0 if x2 < x1 else 0.0
    return (
        round((abs(x2 - x1) + abs(y2 - y1) + back) / 40),
        -y1 if y2 > y1 else y1,
        x1,
        y2,
        x2,
    )
