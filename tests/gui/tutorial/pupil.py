"""Who follows the tutorial: does what a step says, counts it, and has pictures taken on the way."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtGui import QInputMethodEvent, QPainter
from PySide6.QtTest import QSignalSpy, QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QPlainTextEdit,
    QTreeView,
    QWidget,
)
from tests.gui.drawing.draughtsman import Draughtsman
from tests.gui.test_looks import without_mouse
from tests.gui.test_newcomer import CONTROL
from tests.gui.tutorial.in_japanese import TEXTS, WORDS
from tests.gui.tutorial.small import keep

from situ_studio.rehearsing.robot_screen import RobotScreen
from situ_studio.screens.sheet import Sheet

PATIENCE = 20_000
"""Milliseconds that all scenarios get."""


class Pupil(Draughtsman):
    """``written``: what the tutorial has to say for a person to do the same: each text that was
    typed and each name that was pressed, in the current step; ``looked``: its pictures.

    language: of the studio, and of the tutorial. other: the one that the robot learns.
    """

    def __init__(self, window: Any, pictures: Path | None, language: str) -> None:
        super().__init__(window)
        self.other = "en" if language == "ja" else "ja"
        self._words: Mapping[str, str] = WORDS if language == "ja" else {}
        self.written: list[str] = []
        self.looked: list[str] = []
        self._pictures = pictures
        self._seconds = 0.0
        window.rehearsing.clock = lambda: self._seconds

    def look(self, name: str) -> None:
        """Here the tutorial has a picture."""
        self.looked.append(name)
        if self._pictures is not None:
            # What the next frames of a rehearsal would bring is in the picture.
            self.window.robot.follower.refresh()
            self.window.moment.column.draw()
            self.settle()
            without_mouse(self)  # type: ignore[arg-type]
            picture, asking = self.window.grab(), QApplication.activeModalWidget()
            if asking is not None:
                painter = QPainter(picture)
                area = asking.rect()
                area.moveCenter(self.window.rect().center())
                painter.fillRect(area, asking.palette().window())
                painter.drawPixmap(area, asking.grab())
                painter.end()
            keep(picture.toImage(), self._pictures / f"{name}.png")

    @contextmanager
    def _counts(self, gestures: int, *words: str) -> Iterator[None]:
        """What is done inside is so many gestures, however it is done."""
        written = list(self.written)
        with self.counts(gestures):
            yield
        self.written = [*written, *words]

    def settle(self) -> None:
        asking = QApplication.activeModalWidget()
        if asking is None:
            super().settle()
            return
        asking.activateWindow()
        QApplication.processEvents()

    # -- counted ------------------------------------------------------------------------

    def here(self, word: str) -> str:
        """What the English tutorial says, as this one does."""
        return self._words.get(word, word)

    def there(self, text: str) -> str:
        """What the robot says, in its other language."""
        return TEXTS[text] if self.other == "ja" else text

    def widget(self, name: str, kind: type[QWidget] = QWidget) -> QWidget:
        return super().widget(self.here(name), kind)

    def drawn(self, name: str) -> QRect:
        return super().drawn(self.here(name))

    def drag_new(self, source: str, target: str) -> None:
        with self._counts(2):
            self.click_card(source)
            self.drag(self.plus(source), self.drawn(target).center())

    def click(self, name: str, kind: type[QWidget] = QWidget) -> None:
        self.written.append(self.here(name))
        super().click(name, kind)

    def press(self, name: str) -> None:
        """A button, where others are called so too."""
        self.click(name, QAbstractButton)

    def type(self, text: str, end: Qt.Key | None = Qt.Key.Key_Return) -> None:
        text = self.here(text)
        with self._counts(1, text):
            for letters in re.findall(r"[ -~]|[^ -~]+", text):
                if letters.isascii():
                    QTest.keyClicks(self.hears(), letters)
                else:
                    self._commit(letters)
                self.settle()
            if end is not None:
                self.key(end)

    def compose(self, text: str) -> None:
        """Through an input method, as Japanese is typed."""
        with self._counts(1, text):
            self._commit(text)
            self.key(Qt.Key.Key_Return)

    def _commit(self, text: str) -> None:
        done = QInputMethodEvent()
        done.setCommitString(text)
        QApplication.sendEvent(self.hears(), done)

    def write_into(self, name: str, text: str) -> None:
        with self._counts(3, self.here(name), self.here(text)):
            super().write_into(name, text)

    def write_over(self, name: str, text: str) -> None:
        """The same, in a field of several lines."""
        with self._counts(3, self.here(name), self.here(text)):
            self.click(name, QPlainTextEdit)
            self.key(Qt.Key.Key_A, CONTROL)
            self.type(text, Qt.Key.Key_Tab)

    def pick(self, box: str, choice: str) -> None:
        choice = self.here(choice)
        with self._counts(2, choice):
            super().pick(box, choice)

    def menu(self, name: str, entry: str) -> None:
        entry = self.here(entry)
        with self._counts(2, self.here(name), entry):
            super().menu(name, entry)

    def answer(self, text: str) -> None:
        self.gestures += 1
        self.written.append(text)
        super().answer(text)

    def run(self, command: str) -> None:
        with self._counts(2, self.here(command)):
            super().run(command)

    def follow(self, card: str, by: QPoint, name: str) -> None:
        """From the plus of a card to empty ground, where a new state begins."""
        self.click_card(card)
        start = self.plus(card)
        self.drag(start, start + by)
        self.type("state")
        self.type(name)

    # -- places -------------------------------------------------------------------------

    def on_sheet(self, x: int, y: int) -> QPoint:
        """In percent of the screen that is drawn."""
        sheet = self.widget("Screen", Sheet)
        return sheet.mapToGlobal(QPoint(sheet.width() * x // 100, sheet.height() * y // 100))

    def open_in_tree(self, name: str, which: int = 0) -> None:
        """A row of the project tree, of those that are called so."""
        name = self.here(name)
        tree = self.widget("Project", QTreeView)
        assert isinstance(tree, QTreeView)
        how = Qt.MatchFlag.MatchExactly | Qt.MatchFlag.MatchRecursive
        first, shown = tree.model().index(0, 0), Qt.ItemDataRole.DisplayRole
        index = tree.model().match(first, shown, name, -1, how)[which]
        self.click_at(tree.viewport().mapToGlobal(tree.visualRect(index).center()))
        self.written.append(name)

    def tick(self, name: str) -> None:
        """The box of what is chosen or not, at its left edge."""
        self.written.append(name)
        flag = self.widget(name, QAbstractButton)
        self.click_at(flag.mapToGlobal(QPoint(8, flag.height() // 2)))

    # -- the rehearsal ------------------------------------------------------------------

    def touch(self, words: str) -> None:
        """What has these words on the screen of the rehearsed robot."""
        words = self.here(words)
        shown = self.widget("The robot's screen", RobotScreen)
        assert isinstance(shown, RobotScreen)
        target = next(one for one in shown.targets if one.words == words)
        self.click_at(shown.mapToGlobal(shown.place_of(target).toPoint()))
        self.written.append(words)

    def wait(self, seconds: float) -> None:
        """The rehearsal goes on; nobody does anything."""
        running = self.window.rehearsing.running
        for _ in range(round(seconds / 0.25)):
            self._seconds += 0.25
            running.catch_up()
        self.settle()

    def wait_for_scenarios(self) -> None:
        run = self.window.scenarios.run_
        if len(run.ran) < len(run.files):
            assert QSignalSpy(run.ended).wait(PATIENCE)
        self.settle()
