"""Pictures of cards: what is kept looks as what is painted, and no more is kept than may be."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QImage, QPainter
from PySide6.QtWidgets import QApplication

from situ.document.rbd import Application
from situ_studio.canvas.live import LiveView
from situ_studio.canvas.pictures import Pictures
from situ_studio.canvas.style import Look
from situ_studio.looks import theme

Apart = Callable[[QImage, QImage], int]

ROOM = QRectF(-6, -6, 60, 40)


class Drawn:
    """Draws lines, a text and a round corner, and counts how often."""

    def __init__(self) -> None:
        self.times = 0

    def __call__(self, painter: QPainter) -> None:
        self.times += 1
        painter.setPen(QColor("navy"))
        painter.setBrush(QColor("khaki"))
        painter.drawRoundedRect(QRectF(0, 0, 40, 24), 8, 8)
        painter.drawText(QPointF(4, 16), "Ask")


def painted(
    pictures: Pictures, draw: Drawn, ratio: float, zoom: float, at: QPointF, state: object = ()
) -> QImage:
    """A screen of that device pixel ratio with one card, its corner at ``at``."""
    screen = QImage(200, 160, QImage.Format.Format_ARGB32_Premultiplied)
    screen.fill(QColor("white"))
    screen.setDevicePixelRatio(ratio)
    painter = QPainter(screen)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
    painter.translate(at)
    painter.scale(zoom, zoom)
    before = painter.worldTransform()
    pictures.paint(painter, "1", draw, state, ROOM, draw)
    assert painter.worldTransform() == before
    painter.end()
    return screen


@pytest.mark.parametrize("ratio", [1.0, 1.25, 1.5, 2.0])
@pytest.mark.parametrize("zoom", [0.8, 1.0, 1.7])
def test_a_kept_picture_is_what_is_painted(
    qt: QApplication, farthest: Apart, ratio: float, zoom: float
) -> None:
    pictures, draw = Pictures(), Drawn()
    at = QPointF(12, 8) / ratio
    first, made, kept = (painted(pictures, draw, ratio, zoom, at) for _ in range(3))
    assert draw.times == 2
    # Two layers that cover a px in part are rounded twice.
    assert farthest(first, made) <= 2
    assert kept == made
    assert farthest(first, painted(Pictures(), draw, ratio, zoom, QPointF())) > 50


def test_a_card_between_two_px_lies_on_the_nearest(qt: QApplication) -> None:
    pictures, draw = Pictures(), Drawn()
    for _ in range(2):
        whole = painted(pictures, draw, 1.0, 1.0, QPointF(12, 8))
    assert painted(pictures, draw, 1.0, 1.0, QPointF(12.4, 7.6)) == whole
    assert draw.times == 2


def test_another_value_state_or_zoom_is_painted_anew(qt: QApplication) -> None:
    pictures, draw, other = Pictures(), Drawn(), Drawn()
    for _ in range(2):
        painted(pictures, draw, 1.0, 1.0, QPointF())
    painted(pictures, other, 1.0, 1.0, QPointF())
    assert other.times == 1
    painted(pictures, other, 1.0, 1.0, QPointF(), "hovered")
    assert other.times == 2
    painted(pictures, other, 1.0, 1.1, QPointF(), "hovered")
    assert other.times == 3


def test_zooming_keeps_nothing(qt: QApplication) -> None:
    pictures, draw = Pictures(), Drawn()
    for step in range(5):
        painted(pictures, draw, 1.0, 1.0 + step / 10, QPointF())
    assert pictures.bytes == 0


def test_what_was_not_painted_for_longest_goes(qt: QApplication) -> None:
    one = 4 * 60 * 40
    pictures, draws = Pictures(most=2 * one), {name: Drawn() for name in "abc"}
    screen = QImage(200, 160, QImage.Format.Format_ARGB32_Premultiplied)

    def show(name: str) -> None:
        painter = QPainter(screen)
        pictures.paint(painter, name, draws[name], (), ROOM, draws[name])
        painter.end()

    for name in ("a", "a", "b", "b", "a", "c", "c"):
        show(name)
    assert pictures.bytes == 2 * one
    times = {name: draw.times for name, draw in draws.items()}
    show("a")
    show("c")
    assert {name: draw.times for name, draw in draws.items()} == times
    show("b")
    assert draws["b"].times == times["b"] + 1


def test_a_canvas_looks_the_same_from_its_pictures(
    desk: Callable[..., Any], small: Application, farthest: Apart
) -> None:
    """Selected, hovered, in use by a robot, in another theme: never what was before."""
    one, other = desk(small, size=(640, 420)), desk(small, size=(640, 420))

    def looks(canvas: Any) -> QImage:
        image: QImage = canvas.viewer.viewport().grab().toImage()
        return image.convertToFormat(QImage.Format.Format_RGB32)

    def same() -> None:
        for _ in range(3):
            kept = looks(one.canvas)
        other.canvas.look.pictures = Pictures()
        assert farthest(kept, looks(other.canvas)) <= 2

    same()
    assert one.canvas.look.pictures.bytes > 0
    before = looks(one.canvas)
    changes: tuple[Callable[[Any], object], ...] = (
        lambda c: c.select([("state", "1")]),
        lambda c: c.select([("state", "2", "event", "0")]),
        lambda c: c.graph.nodes["1"].view.hover("0"),
        lambda c: c.set_theme(theme.DARK),
        lambda c: c.set_live(LiveView(active=frozenset({"2"}), counts={"1": 3})),
        lambda c: c.set_live(LiveView(active=frozenset({"1"}), breakpoints=frozenset({"2"}))),
        lambda c: c.set_live(LiveView(active=frozenset({"2"}), counts={"1": 4, "2": 1})),
        lambda c: c.set_live(None),
        lambda c: c.show_document(
            replace(c.document, states=(replace(c.document.states[0], name="other"),))
        ),
    )
    for change in changes:
        change(one.canvas)
        change(other.canvas)
        same()
        assert farthest(before, looks(one.canvas)) > 50
        before = looks(one.canvas)


def test_what_a_robot_did_is_painted_over_cards_that_stay_as_they_are(
    desk: Callable[..., Any], small: Application
) -> None:
    canvas = desk(small, size=(640, 420)).canvas
    pictures, card = canvas.look.pictures, canvas.graph.nodes["1"].view

    def looks(count: int) -> QImage:
        canvas.set_live(LiveView(active=frozenset({"2"}), counts={"1": count}))
        image: QImage = canvas.viewer.viewport().grab().toImage()
        return image

    before = [looks(1) for _ in range(3)][-1]
    kept = pictures._kept[card.uid].picture.cacheKey()
    assert looks(2) != before
    assert pictures._kept[card.uid].picture.cacheKey() == kept
    assert looks(1) == before


def test_a_picture_for_print_is_made_of_lines(qt: QApplication) -> None:
    """Nothing is kept where no widget is painted."""
    from situ_studio.canvas.cards import CardItem
    from situ_studio.canvas.picture import Card

    look = Look(theme.LIGHT)
    item = CardItem()
    item.look = look
    item.show_face(Card(uid="1", place=("state", "1"), kind="state", no="1", name="a", x=0, y=0))
    screen = QImage(300, 200, QImage.Format.Format_ARGB32_Premultiplied)
    painter = QPainter(screen)
    for _ in range(3):
        item.paint(painter, None)  # type: ignore[arg-type]
    painter.end()
    assert look.pictures.bytes == 0
