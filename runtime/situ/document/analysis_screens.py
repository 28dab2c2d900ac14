"""Screens: components off the screen, and components in each other's way.

What is claimed, up to a hair (half a percent of the screen):

- *off the screen* is what can be touched, and a text with words, where a part of it lies
  outside; a picture, a movie or a panel (a text without words) where none of it lies inside,
  for a picture may run over the edge.
- of two components that overlap, the upper one is *in the way* where the lower one can be
  touched, whatever the upper one is, since a touch goes to what lies on top; where the lower one
  is a text with words and the upper one covers it (has a ``fill``, is a picture or a movie or can
  be touched); where both have words of their own, for texts of nothing but data may take turns;
  and where it covers the whole of a picture, a movie or a panel. So a picture or a panel beneath
  others is as it should be.

What lies above what: later components of a screen above earlier ones, ``always`` above the
state's screen, outer files above inner ones, wherever a screen is shown or kept. A picture is
not looked through.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from situ.document import names, words
from situ.document.analysis_active import Active, Layer, Layers, Run
from situ.document.analysis_search import Search
from situ.document.finding import Place
from situ.document.mend import written
from situ.document.problem import Change, Mend
from situ.document.rbd import Button, Component, Image, Input, List, Movie, Text

HAIR = 0.5
"""Percent of the screen: less than this is no overlap and not off the screen."""


Edges = tuple[float, float, float, float]
"""Left, top, right, bottom, in percent of the screen."""


class Box(NamedTuple):
    """A component as it lies there. file, place: of its document.

    words, touch: whether it is read, or touched. always: whether it has words whatever the data
    are. covers: whether what lies below is not seen.
    """

    left: float
    top: float
    right: float
    bottom: float
    words: bool
    always: bool
    touch: bool
    covers: bool
    component: Component
    file: str
    place: Place

    @property
    def screen(self) -> Place:
        """What tells the screen that it is on from others."""
        return (self.file, *self.place[:-1])


def search_screens(search: Search, runs: list[Run]) -> None:
    """Tells of components that are off the screen or in each other's way."""
    boxes = _Boxes(search)
    for run in runs:
        search.go_on()
        for active in run.actives.values():
            level = active.levels[-1]
            own: Layers = ()
            screen = level.state.screen
            if screen is not None and not screen.is_empty:
                own = (Layer(level.file, ("state", level.state.no), screen),)
            boxes.judge((*own, *active.above))
        for layers in _kept(run):
            boxes.judge(layers)
    boxes.tell()


def _kept(run: Run) -> Iterator[Layers]:
    """The screens that states keep, with the screens of ``always`` above them there."""
    keeping: dict[tuple[str, ...], list[Active]] = {}
    above: dict[tuple[str, ...], Layers] = {}
    own: set[tuple[str, ...]] = set()
    for active in run.actives.values():
        layers = active.above
        key = tuple(layer.file for layer in layers)
        if active.state.screen is not None:
            own.add(key)
        elif layers:
            keeping.setdefault(key, []).append(active)
            above[key] = layers
    # Where ``always`` is the same everywhere, what is kept lies as it lay.
    if not keeping or len(own | set(keeping)) == 1:
        return
    before: dict[str, list[Active]] = {}
    for active in run.actives.values():
        for _, _, targets in run.ways(active):
            for target in targets:
                if target.state.screen is None:
                    before.setdefault(target.path, []).append(active)
    for key, several in keeping.items():
        seen = {one.path for one in several}
        waiting = list(several)
        while waiting:
            for one in before.get(waiting.pop().path, ()):
                if one.path in seen:
                    continue
                seen.add(one.path)
                screen = one.state.screen
                if screen is None:
                    waiting.append(one)
                elif not screen.is_empty:
                    place = ("state", one.state.no)
                    yield (Layer(one.levels[-1].file, place, screen), *above[key])


class _Boxes:
    """Most components are in nobody's way: they are looked at as bare edges first."""

    def __init__(self, search: Search) -> None:
        self._search = search
        self._edges: dict[tuple[str, Place], list[Edges]] = {}
        self._judged: set[tuple[tuple[str, Place], tuple[str, Place]]] = set()
        self._off: list[Box] = []
        self._covered: dict[tuple[str, Place], tuple[Box, list[Box]]] = {}

    def judge(self, layers: Layers) -> None:
        """Looks at each screen and each two that lie above each other, once."""
        for number, layer in enumerate(layers):
            for upper in layers[number:]:
                key = (layer[:2], upper[:2])
                if key in self._judged:
                    continue
                self._judged.add(key)
                lower = self._of(layer)
                above = self._of(upper)
                for at, one in enumerate(lower):
                    self._look(layer, at, one, upper, above, at + 1 if upper is layer else 0)

    def tell(self) -> None:
        for box in self._off:
            self._tell_off(box)
        for box, uppers in self._covered.values():
            self._tell_covered(box, uppers)

    def _of(self, layer: Layer) -> list[Edges]:
        found = self._edges.get(layer[:2])
        if found is None:
            found = self._edges[layer[:2]] = []
            for one in layer.screen.components:
                left, top, right, bottom = one.x, one.y, one.x + one.width, one.y + one.height
                found.append((left, top, right, bottom))
                if left < -HAIR or top < -HAIR or right > 100 + HAIR or bottom > 100 + HAIR:
                    box = _box(layer, one)
                    if _is_off(box):
                        self._off.append(box)
        return found

    def _look(
        self, layer: Layer, at: int, one: Edges, upper: Layer, above: list[Edges], first: int
    ) -> None:
        """Looks at one component and those above it, from a first one on."""
        left, top, right, bottom = one[0] + HAIR, one[1] + HAIR, one[2] - HAIR, one[3] - HAIR
        for number in range(first, len(above)):
            other = above[number]
            if other[0] < right and other[2] > left and other[1] < bottom and other[3] > top:
                box = _box(layer, layer.screen.components[at])
                cover = _box(upper, upper.screen.components[number])
                if in_the_way(box, cover):
                    self._covered.setdefault((box.file, box.place), (box, []))[1].append(cover)

    def _tell_off(self, box: Box) -> None:
        one = box.component
        message = (
            f"{_called(box)} lies outside the screen, which is 100 wide and 100 high: "
            "move it in, or make it smaller"
        )
        self._search.warn(box.file, "off-screen", message, one.aside, box.place, self._into(box))

    def _into(self, box: Box) -> Mend | None:
        one = box.component
        width, height = min(one.width, 100.0), min(one.height, 100.0)
        wanted = {
            "x": min(max(one.x, 0.0), 100.0 - width),
            "y": min(max(one.y, 0.0), 100.0 - height),
            "width": width,
            "height": height,
        }
        changes = [
            self._search.put(box.file, box.place, field, round(value, 4))
            for field, value in wanted.items()
            if value != getattr(one, field)
        ]
        return self._search.mend(box.file, f"Move {words.quoted(one.id)} in", *changes)

    def _tell_covered(self, box: Box, uppers: list[Box]) -> None:
        ids = words.listed([words.quoted(one.component.id) for one in uppers[:3]])
        if len(uppers) > 3:
            ids += f" and {len(uppers) - 3} more"
        # Whole sentences, for translators.
        if box.touch:
            one = f"{ids} lies over it, and a touch there does not reach it"
            many = f"{ids} lie over it, and a touch there does not reach it"
        elif box.words:
            one = f"{ids} lies over it, so it cannot be read"
            many = f"{ids} lie over it, so it cannot be read"
        else:
            one = f"{ids} lies over the whole of it, so it is never seen"
            many = f"{ids} lie over the whole of it, so it is never seen"
        why = one if len(uppers) == 1 else many
        outside = next((upper for upper in uppers if upper.screen != box.screen), None)
        if outside is not None and outside.file == box.file:
            why = f"{why} (part of every state, and above what a state itself shows)"
        elif outside is not None:
            of = outside.file
            why = f"{why} (part of every state of {of}, and above what a state itself shows)"
        message = f"{_called(box)} is covered: {why}; move them apart, or take one away"
        self._search.warn(
            box.file,
            "covered-component",
            message,
            box.component.aside,
            box.place,
            self._beneath(box, uppers),
        )

    def _beneath(self, box: Box, uppers: list[Box]) -> Mend | None:
        """A picture or a panel of the same screen is put beneath what it covers, where it then
        is in nobody's way.
        """
        upper = uppers[0]
        if len(uppers) > 1 or upper.touch or upper.words or upper.screen != box.screen:
            return None
        if in_the_way(upper, box):
            return None
        path = self._search.path(box.file, upper.place)
        to = self._search.path(box.file, box.place)[-1]
        change = Change(path, "move", str(to), written(upper.component))
        said = f"Put {words.quoted(upper.component.id)} beneath {words.quoted(box.component.id)}"
        return self._search.mend(box.file, said, change)


def _box(layer: Layer, one: Component) -> Box:
    touch = isinstance(one, (Button, Input, List))
    has_words = isinstance(one, Text) and bool(one.text.strip())
    return Box(
        one.x,
        one.y,
        one.x + one.width,
        one.y + one.height,
        has_words,
        has_words and _has_own_words(one),
        touch,
        touch or isinstance(one, (Image, Movie)) or one.fill not in (None, "", "transparent"),
        one,
        layer.file,
        (*layer.holder, "screen", one.id),
    )


def _has_own_words(one: Component) -> bool:
    text = one.text if isinstance(one, Text) else ""
    return "{" not in text or any(literal.strip() for literal, _ in names.split(text))


def in_the_way(lower: Box, upper: Box) -> bool:
    """Whether the upper one of two that overlap is in the way of the lower one."""
    if lower.touch:
        return True
    if lower.words:
        return upper.covers or (lower.always and upper.always)
    return (
        lower.covers
        and upper.covers
        and upper.left <= lower.left + HAIR
        and upper.top <= lower.top + HAIR
        and upper.right >= lower.right - HAIR
        and upper.bottom >= lower.bottom - HAIR
    )


def _is_off(box: Box) -> bool:
    """Whether one that lies outside in part is off the screen."""
    return (
        box.touch
        or box.words
        or (
            box.covers
            and (
                box.right <= HAIR
                or box.bottom <= HAIR
                or box.left >= 100 - HAIR
                or box.top >= 100 - HAIR
            )
        )
    )


def _called(box: Box) -> str:
    return f"The {box.component.element} {words.quoted(box.component.id)}"
