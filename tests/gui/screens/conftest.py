"""A sheet in use by mouse and keys: in the studio, and alone, which is much faster."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QMimeData, QPoint, QPointF, Qt
from PySide6.QtGui import QDragEnterEvent, QDropEvent, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QVBoxLayout, QWidget

from situ.document import codec
from situ.document.rbd import Application
from situ.resources import example
from situ_studio.kinds import MIME
from situ_studio.looks.theme import LIGHT
from situ_studio.screens.sheet import Sheet
from situ_studio.screens.state_screen import StateScreen

LEFT = Qt.MouseButton.LeftButton
NONE = Qt.KeyboardModifier.NoModifier
FILE = "reception.rbd.xml"

Start = Callable[..., Any]
Copy = Callable[[str], Path]


class Hands:
    """What a person does on the sheet of state 11."""

    sheet: Sheet

    @property
    def document(self) -> Any:
        raise NotImplementedError

    def settle(self) -> None:
        raise NotImplementedError

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
        self.settle()

    def drop(self, kind: str, at: QPoint) -> bool:
        """Drags a kind from the palette there; whether the sheet took it."""
        data = QMimeData()
        data.setData(MIME, kind.encode())
        copy = Qt.DropAction.CopyAction
        enter = QDragEnterEvent(at, copy, data, LEFT, NONE)
        QCoreApplication.sendEvent(self.sheet, enter)
        if enter.isAccepted():
            QCoreApplication.sendEvent(self.sheet, QDropEvent(QPointF(at), copy, data, LEFT, NONE))
        self.settle()
        return enter.isAccepted()

    def click(self, *id: str, held: Qt.KeyboardModifier = NONE) -> None:
        """Clicks the middle of each of these."""
        for one in id:
            QTest.mouseClick(self.sheet, LEFT, held, self.middle(one))
            self.settle()

    def sheet_move(self, at: QPoint, held: Qt.KeyboardModifier) -> None:
        # QTest.mouseMove holds neither a button nor a key.
        where = QPointF(at)
        event = QMouseEvent(
            QEvent.Type.MouseMove, where, self.sheet.mapToGlobal(where), LEFT, LEFT, held
        )
        QCoreApplication.sendEvent(self.sheet, event)


class Table(Hands):
    """The sheet beside the graph of the studio."""

    def __init__(self, used: Any) -> None:
        self.used = used
        used.click(used.window.tabs.views.button("split"))
        used.select("state", "11")
        self.sheet = used.window.beside.sheet

    @property
    def document(self) -> Any:
        return self.used.session.document(FILE)

    def settle(self) -> None:
        self.used.settle()


class Page(Hands):
    """A sheet in a window of its own. Every edit is kept: ``steps`` are their names."""

    def __init__(self, application: Application, media: Path) -> None:
        self.window = QWidget()
        self.window.resize(640, 460)
        self.sheet = Sheet(LIGHT)
        # What Tab goes on to.
        self.next = QWidget()
        self.next.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        column = QVBoxLayout(self.window)
        column.addWidget(self.sheet)
        column.addWidget(self.next)
        self.shown = StateScreen(self.sheet, LIGHT, lambda: media, self.window)
        self.shown.edited.connect(self._on_edited)
        self.shown.selection_changed.connect(self._on_selected)
        self.documents: list[Any] = [application]
        self.steps: list[str] = []
        self.selected: tuple[Any, ...] = ()
        self.window.show()
        self.window.activateWindow()
        assert QTest.qWaitForWindowExposed(self.window)
        self.show_document(application)
        self.select("11")

    @property
    def document(self) -> Any:
        return self.documents[-1]

    def select(self, no: str) -> None:
        self._on_selected((("state", no),))
        self.settle()

    def commit(self, after: Application) -> None:
        """Somebody else makes a change, which is no step here."""
        self.documents = [after]
        self.show_document(after)

    def undo(self) -> None:
        self.documents.pop()
        self.steps.pop()
        self.show_document(self.document)

    def show_document(self, application: Application) -> None:
        self.shown.show_document(application)
        self.shown.select(self.selected)

    def _on_edited(self, after: Application, text: str) -> None:
        self.documents.append(after)
        self.steps.append(text)
        self.show_document(after)

    def _on_selected(self, selected: tuple[Any, ...]) -> None:
        self.selected = selected
        self.shown.select(selected)

    def settle(self) -> None:
        QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        QApplication.processEvents()
        if not self.window.isActiveWindow():
            # The offscreen platform activates nothing again when a popup has closed.
            self.window.activateWindow()
            QApplication.processEvents()

    def key(self, key: Qt.Key, held: Qt.KeyboardModifier = NONE) -> None:
        """A key to whatever has the focus."""
        focus = QApplication.focusWidget()
        assert focus is not None, "nothing has the focus"
        QTest.keyClick(focus, key, held)
        self.settle()

    def type(self, text: str) -> None:
        """Each letter to whatever has the focus then."""
        for letter in text:
            focus = QApplication.focusWidget()
            assert focus is not None, "nothing has the focus"
            QTest.keyClicks(focus, letter)
        self.settle()


@pytest.fixture
def table(studio: Start, project: Copy) -> Table:
    return Table(studio(project("reception")))


@pytest.fixture(scope="session")
def reception() -> Application:
    read, _ = codec.read((example("reception") / FILE).read_bytes(), FILE)
    assert isinstance(read, Application)
    return read


@pytest.fixture
def page(qt: QApplication, reception: Application) -> Iterator[Page]:
    made = Page(reception, Path(str(example("reception") / "media")))
    made.settle()
    yield made
    made.window.close()
    made.window.deleteLater()
