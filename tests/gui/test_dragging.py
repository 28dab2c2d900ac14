"""Buttons that are dragged: a press and a move carry something, a click carries nothing."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from PySide6.QtCore import QMimeData, QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QApplication

from situ_studio import kinds
from situ_studio.looks.theme import LIGHT
from situ_studio.panels.palette import PaletteItem
from situ_studio.screens.tag_chips import TAG, TagChip
from situ_studio.screens.template_tiles import TemplateTile
from situ_studio.screens.templates import TEMPLATE, templates
from situ_studio.widgets import dragging

LEFT, RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton
BUTTONS: dict[str, Callable[[], QAbstractButton]] = {
    kinds.MIME: lambda: PaletteItem(LIGHT, kinds.TEXT),
    TAG: lambda: TagChip(LIGHT, "user.name"),
    TEMPLATE: lambda: TemplateTile(LIGHT, templates()["list"], False),
}


class Drag:
    """Qt's, but for the loop in which a hand moves on."""

    begun: list[QMimeData]

    def __init__(self, source: QAbstractButton) -> None:
        self._data = QMimeData()

    def setMimeData(self, data: QMimeData) -> None:
        self._data = data

    def setPixmap(self, picture: Any) -> None:
        assert not picture.isNull()

    def exec(self, action: Qt.DropAction) -> None:
        assert action == Qt.DropAction.CopyAction
        self.begun.append(self._data)


@pytest.fixture
def begun(qt: QApplication, monkeypatch: pytest.MonkeyPatch) -> list[QMimeData]:
    Drag.begun = []
    monkeypatch.setattr(dragging, "QDrag", Drag)
    return Drag.begun


@pytest.mark.parametrize("carried", BUTTONS)
def test_a_press_and_a_move_carry_what_the_button_stands_for(
    carried: str, begun: list[QMimeData]
) -> None:
    button = BUTTONS[carried]()
    button.show()
    QTest.mousePress(button, LEFT, pos=QPoint(4, 4))
    QTest.mouseMove(button, QPoint(5, 5))
    assert begun == []
    QTest.mouseMove(button, QPoint(40, 10))
    assert [data.hasFormat(carried) for data in begun] == [True]
    assert not button.isDown()
    QTest.mouseMove(button, QPoint(4, 4))
    QTest.mouseRelease(button, LEFT)
    assert len(begun) == 1
    button.deleteLater()


@pytest.mark.parametrize("carried", BUTTONS)
def test_after_a_click_no_other_move_begins_a_drag(carried: str, begun: list[QMimeData]) -> None:
    button = BUTTONS[carried]()
    clicks = []
    button.clicked.connect(lambda: clicks.append(1))
    button.show()
    QTest.mouseClick(button, LEFT, pos=QPoint(4, 4))
    QTest.mousePress(button, RIGHT, pos=QPoint(4, 4))
    QTest.mouseMove(button, QPoint(40, 10))
    QTest.mouseRelease(button, RIGHT)
    assert (clicks, begun) == ([1], [])
    button.deleteLater()
