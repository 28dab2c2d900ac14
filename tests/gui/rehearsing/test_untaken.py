"""What no scenario came through is told from the rest on the drawings, by more than its colour."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QImage
from tests.gui.rehearsing.test_scenarios import ran


class Drawn:
    """The drawing as it is seen now."""

    def __init__(self, used: Any) -> None:
        used.settle()
        self.canvas = used.window.current_view.canvas
        self._viewer = self.canvas.viewer
        self.picture: QImage = self._viewer.viewport().grab().toImage()
        self._ground = self.canvas.look["canvas"].rgb()

    def _at(self, x: float, y: float) -> int:
        at = QPointF(self._viewer.mapFromScene(QPointF(x, y))) * self.picture.devicePixelRatio()
        assert self.picture.rect().contains(at.toPoint()), "not in the picture"
        return self.picture.pixel(at.toPoint())

    def inked(self, a: tuple[float, float], b: tuple[float, float]) -> float:
        """How much of a line lies on something that is painted."""
        count = round(abs(b[0] - a[0]) + abs(b[1] - a[1]))
        spots = [
            (a[0] + (b[0] - a[0]) * n / count, a[1] + (b[1] - a[1]) * n / count)
            for n in range(count)
        ]
        # A line may be between two px.
        return sum(
            any(self._at(x, y + d) != self._ground for d in (-0.5, 0.5)) for x, y in spots
        ) / len(spots)

    def edge(self, no: str) -> float:
        """How much of the lower half of a card's left edge is painted in another colour than what
        lies beside it, inside and outside.
        """
        card = next(n.view for n in self.canvas.graph.nodes.values() if n.view.face.no == no)
        left, top, high = card.scenePos().x(), card.scenePos().y(), card.face.height
        heights = [top + high * 0.8 - n for n in range(round(high * 0.3))]
        dark = [min(self._grey(left + d, y) for d in (-0.5, 0.5)) for y in heights]
        light = [max(self._grey(left + d, y) for d in (-0.5, 0.5)) for y in heights]
        return float(max(max(dark) - min(dark), max(light) - min(light)))

    def _grey(self, x: float, y: float) -> int:
        pixel = self._at(x, y)
        return (pixel >> 8) & 0xFF

    def cut(self, area: QRectF) -> QImage:
        ratio = self.picture.devicePixelRatio()
        box = self._viewer.mapFromScene(area).boundingRect()
        whole = QRectF(QPointF(box.topLeft()) * ratio, QPointF(box.bottomRight()) * ratio)
        return self.picture.copy(whole.toRect())


def pipes(canvas: Any) -> list[Any]:
    every = (canvas.graph.pipe(id) for id in canvas.graph.links)
    return [pipe for pipe in every if pipe is not None]


def told(pipe: Any) -> QRectF:
    """Where it stands that nobody left by this exit."""
    beside = pipe.untaken_at_exit()
    if beside is not None:
        return QRectF(beside.x(), beside.y() - 6, 16, 12)
    every = [pipe, *pipe._siblings()]
    return next((a for a in (one.untaken_area() for one in every) if not a.isEmpty()), QRectF())


@pytest.mark.parametrize(("name", "theme"), [("conversation", "light"), ("reception", "dark")])
def test_each_way_and_state_that_nobody_came_through_says_so_timeouts_too(
    studio: Callable[..., Any], project: Callable[[str], Path], name: str, theme: str
) -> None:
    root = project(name)
    for file in (root / "scenarios").glob("*.jsonl"):
        file.unlink()
    # Nobody does anything: of all states there is only the first.
    (root / "scenarios" / "nobody.jsonl").write_text('{"at":2,"end":true}\n')
    used = studio(root, theme=theme)
    used.window.resize(1800, 1200)
    panel = used.window.scenarios.panel
    ran(used, panel.run)
    canvas = used.window.current_view.canvas
    bare = Drawn(used)
    assert all(told(pipe).isEmpty() for pipe in pipes(canvas))
    used.click(panel.paint)
    counts = canvas.look.live.counts
    assert {no for no, times in counts.items() if times} == {"1"}
    every = pipes(canvas)
    assert any(pipe.link.exit == "timeout" for pipe in every)
    drawn = Drawn(used)
    seen = canvas.viewer.mapToScene(canvas.viewer.viewport().rect()).boundingRect()
    lines = 0
    for pipe in every:
        if pipe.link.source not in counts:
            # Of every state: nobody counts it.
            continue
        area = told(pipe)
        assert not area.isEmpty(), pipe.link
        if seen.contains(area):
            assert drawn.cut(area) != bare.cut(area), pipe.link
        stretch = max(
            pairwise(pipe.route.points), key=lambda ab: abs(ab[1][0] - ab[0][0]), default=None
        )
        if stretch is None or pipe.route.folded:
            continue
        (ax, ay), (bx, by) = stretch
        if abs(bx - ax) < 60 or not (
            seen.contains(QPointF(ax, ay)) and seen.contains(QPointF(bx, by))
        ):
            continue
        # From behind the corners, and before the sign in the middle.
        a, b = (ax + (bx - ax) * 0.15, ay), (ax + (bx - ax) * 0.35, by)
        # A name leaves a gap, and a timeout's are dashes.
        if bare.inked(a, b) > 0.9:
            lines += 1
            assert drawn.inked(a, b) < 0.8
    assert lines
    # Cards: the edge of one that was never entered is dotted.
    assert drawn.edge("2") > 20 > drawn.edge("1")
    assert bare.edge("2") < 20


def test_an_exit_whose_line_is_another_ones_too_that_was_taken_says_so_itself(
    studio: Callable[..., Any], project: Callable[[str], Path]
) -> None:
    used = studio(project("conversation"))
    panel = used.window.scenarios.panel
    ran(used, panel.run)
    used.click(panel.paint)
    canvas = used.window.current_view.canvas
    ways = canvas.look.live.transitions
    by_link = {(pipe.link.source, pipe.link.exit): pipe for pipe in pipes(canvas)}
    taken = {way for way in by_link if ways[way]}
    # All that garden leads to is goodbye.
    of_garden = {way for way in by_link if way[0] == "5"}
    assert of_garden & taken
    assert of_garden - taken
    for way, pipe in by_link.items():
        assert told(pipe).isEmpty() == (way in taken), way
    assert all(by_link[way].untaken_at_exit() is not None for way in of_garden - taken)
