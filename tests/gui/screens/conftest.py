"""The screen beside the graph in use, by mouse and keys."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QMimeData, QPoint, QPointF, Qt
from PySide6.QtGui import QDragEnterEvent, QDropEvent, QMouseEvent
from PySide6.QtTest import QTest

from situ_studio.kinds import MIME

LEFT = Qt.MouseButton.LeftButton
NONE = Qt.KeyboardModifier.NoModifier
FILE = "reception.rbd.xml"

Start = Callable[..., Any]
Copy = Callable[[str], Path]


class Table:
    """The sheet of state 11 and what stands on it."""

    def __init__(self, used: Any) -> None:
        self.used = used
        used.click(used.window.tabs.views.button("split"))
        used.select("state", "11")
        self.sheet = used.window.beside.sheet

    @property
    def document(self) -> Any:
        return self.used.session.document(FILE)

    @property
    def components(self) -> Any:
        return self.document.state("11").screen.components

    def component(self, id: str) -> Any:
        return next(c for c in self.components if c.id == id)

    def middle(self, id: str) -> QPoint:
        c = self.component(id)
        return self.at(c.x + c.width / 2, c.y + c.height / 2)

    def at(self, x: float, y: float) -> QPoint:
        return QPoint(round(self.sheet.width() * x / 100), round(self.sheet.height() * y / 100))

    def drag(self, start: QPoint, by: QPoint, held: Qt.KeyboardModifier = NONE) -> None:
        """Presses, moves in three steps and lets go."""
        QTest.mousePress(self.sheet, LEFT, held, start)
        for part in (1, 2, 3):
            self.sheet_move(start + by * part / 3, held)
        QTest.mouseRelease(self.sheet, LEFT, held, start + by)
        self.used.settle()

    def drop(self, kind: str, at: QPoint) -> bool:
        """Drags a kind from the palette there; whether the sheet took it."""
        data = QMimeData()
        data.setData(MIME, kind.encode())
        copy = Qt.DropAction.CopyAction
        enter = QDragEnterEvent(at, copy, data, LEFT, NONE)
        QCoreApplication.sendEvent(self.sheet, enter)
        if enter.isAccepted():
            QCoreApplication.sendEvent(self.sheet, QDropEvent(QPointF(at), copy, data, LEFT, NONE))
        self.used.settle()
        return enter.isAccepted()

    def click(self, *id: str, held: Qt.KeyboardModifier = NONE) -> None:
        """Clicks the middle of each of these."""
        for one in id:
            QTest.mouseClick(self.sheet, LEFT, held, self.middle(one))
            self.used.settle()

    def sheet_move(self, at: QPoint, held: Qt.KeyboardModifier) -> None:
        # QTest.mouseMove holds neither a button nor a key.
        where = QPointF(at)
        event = QMouseEvent(
            QEvent.Type.MouseMove, where, self.sheet.mapToGlobal(where), LEFT, LEFT, held
        )
        QCoreApplication.sendEvent(self.sheet, event)


@pytest.fixture
def table(studio: Start, project: Copy) -> Table:
    return Table(studio(project("reception")))
