"""What is seen of a drawing: zoom, the ground that is moved, the overview."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QEvent, QEventLoop, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from situ.document.rbd import Application
from situ_studio.looks import theme

Make = Callable[..., Any]


@pytest.fixture
def made(desk: Make, small: Application) -> Any:
    return desk(small)


def test_the_wheel_zooms_at_the_cursor(made: Any) -> None:
    hand, canvas = made.hand, made.canvas
    spot = QPointF(300, 200)
    at = hand.pixel(spot)
    hand.wheel(spot, 240)
    assert canvas.zoom() == pytest.approx(1.0015**240, rel=0.01)
    there = canvas.viewer.mapToScene(at)
    assert abs(there.x() - spot.x()) < 2
    assert abs(there.y() - spot.y()) < 2


def test_zoom_has_ends(made: Any) -> None:
    made.canvas.set_zoom(100)
    assert made.canvas.zoom() == 4.0
    made.canvas.set_zoom(0)
    assert made.canvas.zoom() == 0.04


def test_zoom_to_fit_shows_everything(made: Any) -> None:
    canvas = made.canvas
    canvas.set_zoom(3)
    canvas.zoom_to_fit()
    assert canvas.zoom() <= 1
    assert len(canvas.cards_in_view()) == 6


def test_a_large_drawing_opens_readable_at_its_start(desk: Make, small: Application) -> None:
    """A small one opens whole, wherever its start is."""
    away = tuple(
        replace(s, aside=s.aside.at(*at))
        for s, at in zip(
            small.states, ((4000, 2600), (0, 0), (230, 0), (460, 0), (690, 0)), strict=True
        )
    )
    canvas = desk(replace(small, states=away)).canvas
    canvas.zoom_to_begin()
    assert canvas.zoom() == 0.8
    assert canvas.cards_in_view() == ["1"]
    near = desk(small, size=(1280, 800)).canvas
    near.zoom_to_begin()
    assert len(near.cards_in_view()) == 6
    assert near.zoom() >= 0.75


def test_zoom_to_places_brings_them_into_view(made: Any) -> None:
    canvas = made.canvas
    canvas.viewer._set_viewer_pan(5000, 5000)
    canvas.zoom_to([("state", "4", "event", "0")])
    assert "4" in canvas.cards_in_view()
    assert canvas.zoom() == 1.0


def test_the_middle_button_and_space_move_the_ground(made: Any) -> None:
    hand, canvas = made.hand, made.canvas
    spot = QPointF(300, 20)

    def drag(button: Qt.MouseButton) -> None:
        port = canvas.viewer.viewport()
        for kind, at in (
            (QEvent.Type.MouseButtonPress, QPoint(200, 200)),
            (QEvent.Type.MouseMove, QPoint(250, 230)),
            (QEvent.Type.MouseButtonRelease, QPoint(250, 230)),
        ):
            held = Qt.MouseButton.NoButton if kind == QEvent.Type.MouseButtonRelease else button
            where = QPointF(port.mapToGlobal(at))
            event = QMouseEvent(
                kind, QPointF(at), where, button, held, Qt.KeyboardModifier.NoModifier
            )
            QApplication.sendEvent(port, event)

    before = hand.pixel(spot)
    drag(Qt.MouseButton.MiddleButton)
    assert hand.pixel(spot) - before == QPoint(50, 30)
    QTest.keyPress(canvas.viewer, Qt.Key.Key_Space)
    drag(Qt.MouseButton.LeftButton)
    QTest.keyRelease(canvas.viewer, Qt.Key.Key_Space)
    assert hand.pixel(spot) - before == QPoint(100, 60)
    assert made.edits == []


def test_resizing_keeps_zoom_and_corner(made: Any) -> None:
    canvas = made.canvas
    corner = canvas.viewer._scene_range.topLeft()
    canvas.resize(800, 600)
    QApplication.processEvents()
    assert canvas.zoom() == 1.0
    assert canvas.viewer._scene_range.topLeft() == corner


def test_the_overview_follows_what_moves_and_what_is_selected_and_a_press_goes_there(
    made: Any,
) -> None:
    canvas, hand = made.canvas, made.hand
    canvas.resize(620, 580)
    QApplication.processEvents()
    canvas.viewer.look_at(QPointF(460, 250))
    overview = canvas.minimap
    seen = [overview.grab().toImage()]
    assert overview.isVisible()

    def changed() -> bool:
        seen.append(overview.grab().toImage())
        return bool(seen[-1] != seen[-2])

    hand.click(hand.header("2"))
    assert changed()
    hand.drag(hand.header("2"), hand.header("2") + QPointF(0, 200))
    assert changed()
    made.undo()
    assert changed()
    canvas.set_theme(theme.DARK)
    assert changed()
    before = canvas.viewer.seen()
    QTest.mouseClick(overview, Qt.MouseButton.LeftButton, pos=QPoint(4, 33))
    assert canvas.viewer.seen().left() < before.left()
    assert changed()
    assert not changed()


def test_the_overview_of_very_many_cards_follows_a_little_later(
    made: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    canvas, hand = made.canvas, made.hand
    canvas.resize(620, 580)
    QApplication.processEvents()
    canvas.viewer.look_at(QPointF(460, 250))
    overview = canvas.minimap
    monkeypatch.setattr("situ_studio.canvas.overlay.MANY", 1)
    before = overview._drawn()[0].toImage()
    hand.click(hand.header("2"))
    assert overview._drawn()[0].toImage() == before
    while overview._drawn()[0].toImage() == before:
        QApplication.processEvents(QEventLoop.ProcessEventsFlag.WaitForMoreEvents)
