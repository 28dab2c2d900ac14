"""Who draws by hand: pulls pipes, writes into forms by the keyboard, and counts what it takes."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import shiboken6
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QInputMethodEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractItemView,
    QApplication,
    QComboBox,
    QLineEdit,
    QWidget,
)
from tests.gui.test_newcomer import CONTROL, LEFT, NONE, Person

from situ_studio.canvas.test_editor import TestEditor


class Draughtsman(Person):
    """Knows where on a card one pulls, and where the ground is free.

    gestures: how many clicks, drags, keys and texts it took; a text is one.
    """

    window: Any

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self.gestures = 0

    @contextmanager
    def counts(self, gestures: int) -> Iterator[None]:
        """What is done inside is so many gestures, however it is done."""
        before = self.gestures
        yield
        self.gestures = before + gestures

    def hears(self) -> QWidget:
        """As of a system: while a list of words is open the keys are the list's."""
        popup = QApplication.activePopupWidget()
        if isinstance(popup, QAbstractItemView) and shiboken6.isValid(popup):
            return popup
        return QApplication.focusWidget() or self.window

    def key(self, key: Qt.Key, held: Qt.KeyboardModifier = NONE) -> None:
        self.gestures += 1
        QTest.keyClick(self.hears(), key, held)
        self.settle()

    def type(self, text: str, end: Qt.Key | None = Qt.Key.Key_Return) -> None:
        self.gestures += 1
        for letters in re.findall(r"[ -~]|[^ -~]+", text):
            if letters.isascii():
                QTest.keyClicks(self.hears(), letters)
            else:
                # No key has it: it comes through an input method.
                done = QInputMethodEvent()
                done.setCommitString(letters)
                QApplication.sendEvent(self.hears(), done)
        self.settle()
        if end is not None:
            self.key(end)

    # -- the mouse ----------------------------------------------------------------------

    def click_at(self, spot: QPoint) -> None:
        self.gestures += 1
        super().click_at(spot)

    def drag(self, start: QPoint, end: QPoint) -> None:
        self.gestures += 1
        widget, at = self._at(start)
        way = QPointF(end - start)
        QTest.mouseMove(widget, at)
        QTest.mousePress(widget, LEFT, pos=at)
        for part in range(1, 6):
            QTest.mouseMove(widget, at + (way * (part / 5)).toPoint())
        QTest.mouseRelease(widget, LEFT, pos=at + (end - start))
        self.settle()

    def out(self, card: str) -> QPoint:
        """Where a pipe begins: the middle of its right edge."""
        area = self.drawn(card)
        return QPoint(area.right(), area.center().y())

    def pull(self, source: str, target: str) -> None:
        area = self.drawn(target)
        self.drag(self.out(source), area.topLeft() + QPoint(60, 20))

    def pull_to_ground(self, source: str, above: str, typed: str) -> None:
        """Between two columns, a little above a situation; what is typed is taken."""
        spot = self.drawn(above).topLeft() + QPoint(-14, -6)
        self.drag(self.out(source), spot)
        self.type(typed)

    def twice(self, spot: QPoint) -> None:
        self.gestures += 1
        widget, at = self._at(spot)
        QTest.mouseClick(widget, LEFT, pos=at)
        QTest.mouseDClick(widget, LEFT, pos=at)
        self.settle()

    def twice_on(self, part: str) -> None:
        self.twice(self.drawn(part).center())

    # -- commands and conditions --------------------------------------------------------

    def run(self, command: str) -> None:
        """A command by its name, in the field that finds anything."""
        self.key(Qt.Key.Key_K, CONTROL)
        self.type(command)

    def test(self, row: str, test: str = "", **fields: str) -> None:
        """Writes into the fields of a line of a condition; Enter closes them."""
        self.twice_on(row)
        editor = self.widget("Test", TestEditor)
        if test:
            box = editor.findChildren(QComboBox)[0]
            self.click_at(box.mapToGlobal(box.rect().center()))
            self.choose(test)
        for name, text in fields.items():
            inside = editor.findChildren(QLineEdit)
            field = next(one for one in inside if one.accessibleName().lower() == name)
            self.click_at(field.mapToGlobal(field.rect().center()))
            self.key(Qt.Key.Key_A, CONTROL)
            self.type(text, None)
        self.key(Qt.Key.Key_Return)

    def choose(self, wanted: str) -> None:
        """From the list that is open, with the arrow keys."""
        view = QApplication.focusWidget()
        assert isinstance(view, QAbstractItemView)
        self.key(Qt.Key.Key_Home)
        while view.currentIndex().data() != wanted:
            self.key(Qt.Key.Key_Down)
        self.key(Qt.Key.Key_Return)

    def note(self, card: str, text: str) -> None:
        self.click_card(card or "stopped")
        if not card:
            self.key(Qt.Key.Key_Escape)
        self.run("Situation: Note")
        self.type(text)

    def priority(self, situation: str, module: str, number: int) -> None:
        """The number is typed at once: with its first figure the pill takes it."""
        self.pull(situation, module)
        first, rest = str(number)[0], str(number)[1:]
        self.type(first, None)
        self.type(rest)
