"""A matrix in a shown window, a hand that uses it, and the history of its document."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import pytest
from PySide6.QtCore import QAbstractItemModel, QEvent, QPoint, Qt
from PySide6.QtTest import QAbstractItemModelTester, QTest
from PySide6.QtWidgets import QApplication, QWidget

from situ.document import codec, folder
from situ.document.check import check
from situ.document.project import Project
from situ.document.spds import Spds
from situ.resources import example
from situ_studio.looks import theme
from situ_studio.matrix.table import Area
from situ_studio.matrix.view import MatrixView
from situ_studio.views.table import Setting

NONE = Qt.KeyboardModifier.NoModifier
LEFT = Qt.MouseButton.LeftButton


def read(text: str) -> Spds:
    """A script from its XML."""
    found, problems = codec.read(text.encode(), "s.spds.xml")
    assert isinstance(found, Spds), problems
    return found


TIED = read(
    """<spds name="tied">
  <modules>
    <module name="nod" resources="head"/>
    <module name="chase" resources="head"/>
    <module name="idle" resources="base"/>
  </modules>
  <situation name="asked" extends="all">
    <condition><data tag="asked" is="true"/></condition>
    <module name="nod" priority="20"/>
  </situation>
  <situation name="quiet" extends="all">
    <condition><data tag="quiet" is="true"/></condition>
    <module name="chase" priority="none"/>
  </situation>
  <situation name="all"><module name="chase" priority="20"/></situation>
</spds>"""
)
"""A tie, something taken away, and a module that never wins."""


class Desk:
    """What the window is to a matrix: it keeps every value, and shows it."""

    def __init__(self, view: MatrixView, project: Project) -> None:
        self.view, self.project = view, project
        self.done: list[Spds] = []
        self.undone: list[Spds] = []
        self.steps: list[str] = []
        self.said: list[str] = []
        self.chosen: list[Any] = []
        view.edited.connect(self._on_edited)
        view.status.connect(self.said.append)
        view.selection_changed.connect(self.chosen.append)

    @property
    def document(self) -> Spds:
        return self.done[-1]

    @property
    def table(self) -> Any:
        return self.view.table

    def open(self, document: Spds, problems: bool = False) -> None:
        self.done, self.undone, self.steps = [document], [], []
        self._show(problems)

    def _on_edited(self, document: Spds, text: str) -> None:
        assert text
        self.done.append(document)
        self.undone = []
        self.steps.append(text)
        self._show()

    def _show(self, problems: bool = False) -> None:
        found = check(self.of(self.document)) if problems else []
        self.view.show_document(self.document, found)
        self.settle()

    def of(self, document: Spds) -> Project:
        return Project(root=".", name="p", spds=document, spds_file="s.spds.xml")

    def undo(self) -> None:
        self.undone.append(self.done.pop())
        self._show()

    def redo(self) -> None:
        self.done.append(self.undone.pop())
        self._show()

    def settle(self) -> None:
        for _ in range(2):
            QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
            QApplication.processEvents()

    # -- using it -----------------------------------------------------------------------

    def at(self, situation: str, module: str) -> tuple[int, int]:
        grid = self.view.model.grid
        assert grid is not None
        return grid.row(situation), grid.modules.index(module)

    def point(self, row: int, column: int) -> QPoint:
        index = self.view.model.index(row, column)
        self.table.scrollTo(index)
        middle: QPoint = self.table.visualRect(index).center()
        return middle

    def click(self, situation: str, module: str, held: Qt.KeyboardModifier = NONE) -> None:
        spot = self.point(*self.at(situation, module))
        QTest.mouseClick(self.table.viewport(), LEFT, held, spot)
        self.settle()

    def drag(self, widget: QWidget, start: QPoint, end: QPoint) -> None:
        QTest.mousePress(widget, LEFT, NONE, start)
        for part in (1, 2, 3):
            QTest.mouseMove(widget, start + (end - start) * (part / 3))
        QTest.mouseRelease(widget, LEFT, NONE, end)
        self.settle()

    def key(self, key: Qt.Key, held: Qt.KeyboardModifier = NONE) -> None:
        QTest.keyClick(QApplication.focusWidget() or self.table, key, held)
        self.settle()

    def type(self, text: str) -> None:
        for letter in text:
            # The first one opens an editor, which has the focus then.
            QTest.keyClicks(QApplication.focusWidget() or self.table, letter)
        self.settle()

    def area(self) -> Area | None:
        found: Area | None = self.table.area
        return found

    def text(self, situation: str, column: str) -> str:
        """What a cell says; of a resource, who holds it."""
        model, grid = self.view.model, self.view.model.grid
        assert grid is not None
        at = (*grid.modules, *grid.resources).index(column)
        return str(model.index(grid.row(situation), at).data())

    def said_of(self, situation: str, column: str, role: Qt.ItemDataRole) -> str:
        model, grid = self.view.model, self.view.model.grid
        assert grid is not None
        at = (*grid.modules, *grid.resources).index(column)
        return str(model.index(grid.row(situation), at).data(role) or "")


@pytest.fixture
def conversation() -> Project:
    project, _ = folder.load(example("conversation"))
    assert project is not None
    return project


@pytest.fixture
def desk(qt: QApplication, conversation: Project) -> Iterator[Callable[..., Desk]]:
    """``desk(script)``: a shown matrix of 900 × 420 of it; the example conversation's unless given.

    Qt's own tester follows its model.
    """
    made: list[Any] = []

    def make(script: Spds | None = None, problems: bool = False) -> Desk:
        project = conversation if script is None else None
        view = MatrixView(Setting(script or TIED, theme.LIGHT, None, lambda: project))
        strict = QAbstractItemModelTester.FailureReportingMode.Warning
        model: QAbstractItemModel = view.model
        made.extend((view, QAbstractItemModelTester(model, strict)))
        view.resize(900, 420)
        view.show()
        view.activateWindow()
        assert QTest.qWaitForWindowExposed(view)
        found = Desk(view, conversation)
        assert conversation.spds is not None
        found.open(script or conversation.spds, problems)
        view.table.setFocus()
        found.settle()
        return found

    yield make
    for one in made:
        if isinstance(one, QWidget):
            one.close()
        one.deleteLater()
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    QApplication.processEvents()
