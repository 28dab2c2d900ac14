"""What is dropped on an application's canvas from the palette."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from PySide6.QtCore import QMimeData, QPointF, Qt
from PySide6.QtGui import (
    QDragEnterEvent,
    QDragMoveEvent,
    QDropEvent,
)
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from situ.document.rbd import Application, Speech
from situ_studio.kinds import MIME

Make = Callable[..., Any]
Check = Callable[[Any], None]


@pytest.fixture
def made(desk: Make, small: Application) -> Any:
    return desk(small)


def drop(made: Any, kind: str, spot: QPointF) -> None:
    viewer = made.canvas.viewer
    data = QMimeData()
    data.setData(MIME, kind.encode())
    at = made.hand.pixel(spot)
    left, none = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    copy = Qt.DropAction.CopyAction
    enter = QDragEnterEvent(at, copy, data, left, none)
    QApplication.sendEvent(viewer.viewport(), enter)
    assert enter.isAccepted()
    QApplication.sendEvent(viewer.viewport(), QDragMoveEvent(at, copy, data, left, none))
    QApplication.sendEvent(viewer.viewport(), QDropEvent(QPointF(at), copy, data, left, none))
    made.hand.settle()


def test_a_state_dropped_on_the_ground(made: Any, check: Check) -> None:
    drop(made, "state", QPointF(600, 520))
    assert made.edits == ["Add state 6"]
    assert made.document.states[-1].aside.position == (512, 464)
    check(made)


def test_a_state_dropped_on_a_pipe_is_inserted(made: Any, check: Check) -> None:
    drop(made, "state", made.hand.on_pipe(made.hand.pipe("2", "0")))
    assert made.edits == ["Insert state 6"]
    assert made.document.states[1].events[0].next == "6"
    assert made.document.state("6").events[0].next == "3"
    check(made)


def test_a_drawing_with_next_to_nothing_says_what_to_do_first(desk: Make) -> None:
    made = desk(Application(name="new"))
    advice = made.canvas.advice
    assert advice.isVisible()
    assert "Drag State" in advice.text()
    # What lies under the words is dropped on as if they were not there.
    drop(made, "state", made.canvas.viewer.mapToScene(advice.geometry().center()))
    assert made.edits == ["Add state 1"]
    assert "drag the plus" in advice.text()
    assert not advice.geometry().intersects(made.canvas.zoom_bar.geometry())
    made.hand.drag(made.hand.exit("1", "new"), QPointF(200, 100))
    QTest.keyClick(made.canvas.menu.field, Qt.Key.Key_Return)
    made.hand.settle()
    assert len(made.document.states) == 2
    assert not advice.isVisible()


def test_an_action_dropped_on_a_card_is_its(made: Any, check: Check) -> None:
    drop(made, "speech", made.hand.body("5"))
    assert isinstance(made.document.states[4].actions[0], Speech)
    assert len(made.edits) == 1
    check(made)


def test_an_action_dropped_on_the_ground_says_what_to_do(made: Any) -> None:
    said: list[str] = []
    made.canvas.status.connect(said.append)
    drop(made, "speech", QPointF(600, 520))
    assert made.edits == []
    assert len(said) == 1
