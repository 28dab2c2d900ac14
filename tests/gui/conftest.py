"""One QApplication, a studio in a window, hands that use it, and nothing of Qt left behind."""

from __future__ import annotations

import gc
import shutil
import weakref
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
import shiboken6
from PySide6.QtCore import (
    QEvent,
    QMessageLogContext,
    QModelIndex,
    QPoint,
    QSettings,
    Qt,
    QTimer,
    QtMsgType,
    SignalInstance,
    qInstallMessageHandler,
)
from PySide6.QtGui import QAccessible
from PySide6.QtPrintSupport import QPrinter
from PySide6.QtTest import QSignalSpy, QTest
from PySide6.QtWidgets import QAbstractItemView, QApplication, QWidget

from situ.resources import example
from situ_studio import main
from situ_studio.export.export_dialog import Export
from situ_studio.live.connecting_dialog import Chosen
from situ_studio.looks.application import application
from situ_studio.window import status
from situ_studio.window.main_window import MainWindow
from situ_studio.wording.language import Speaking

PATIENCE = 20_000
"""Milliseconds that a signal gets to come."""
LEFT = Qt.MouseButton.LeftButton
CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier

# What the offscreen platform can not do is no fault of ours.
_KNOWN = ("This plugin does not support", "QFont::setPixelSize")


@pytest.fixture(scope="session")
def qt() -> Iterator[QApplication]:
    """The one QApplication, as the studio makes it."""
    made = application()
    yield made
    # The offscreen platform would let go of what was copied after Python's end, and crash.
    made.clipboard().clear()


@pytest.fixture(autouse=True, scope="module")
def nothing_is_frozen_for_long() -> Iterator[None]:
    """What the fixtures of a module leave is found at its end."""
    yield
    gc.unfreeze()
    gc.collect()


_timers: weakref.WeakSet[QTimer] = weakref.WeakSet()
"""Those of earlier tests that are still there: what is shared by several may have some."""


@pytest.fixture(autouse=True)
def nothing_of_qt_left(qt: QApplication) -> Iterator[None]:
    """A test that makes Qt warn, or leaves a window or a running timer, fails."""
    said: list[str] = []

    def handler(kind: QtMsgType, where: QMessageLogContext, text: str) -> None:
        serious = kind not in (QtMsgType.QtDebugMsg, QtMsgType.QtInfoMsg)
        if serious and not text.startswith(_KNOWN):
            said.append(text)

    before = {id(w) for w in QApplication.topLevelWidgets()}
    old = qInstallMessageHandler(handler)
    # What is there already need not be looked through: that takes longer than many a test.
    gc.freeze()
    yield
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    QApplication.processEvents()
    gc.collect()
    qInstallMessageHandler(old)
    assert not said, f"Qt warned: {said}"
    windows = [w for w in QApplication.topLevelWidgets() if id(w) not in before]
    assert not windows, f"windows left: {windows}"
    _timers.update(o for o in gc.get_objects() if type(o) is QTimer)
    timers = [o for o in _timers if shiboken6.isValid(o) and o.isActive()]
    assert not timers, f"timers still run: {timers}, of {[t.parent() for t in timers]}"


class Answers:
    """The person at the dialogs: answers are put in before, a question without one fails."""

    def __init__(self) -> None:
        self.waiting: dict[str, list[Any]] = {}
        self.told: list[str] = []
        self.details_told: list[tuple[str, str]] = []
        self.conflicts: list[Any] = []
        """What differed, each time that it was asked about."""

    def put(self, question: str, answer: Any) -> None:
        self.waiting.setdefault(question, []).append(answer)

    def _take(self, question: str) -> Any:
        assert self.waiting.get(question), f"nobody knew what to answer to {question!r}"
        return self.waiting[question].pop(0)

    def project(self, start: str) -> Any:
        return self._take("project")

    def new_folder(self, start: str, title: str) -> Any:
        return self._take("new_folder")

    def name(self, title: str, label: str, usual: str) -> Any:
        return self._take("name")

    def robot(self, usual: str) -> Any:
        """The robot at the address that was put in."""
        endpoint = self._take("robot")
        return Chosen(endpoint) if isinstance(endpoint, str) else endpoint

    def raising(self, offered: Any, usual: str, known: Any) -> Any:
        return self._take("raising")

    def setting(self, vocabulary: Any, now: Any) -> Any:
        return self._take("setting")

    def part(self, known: list[str]) -> Any:
        return self._take("part")

    def unsaved(self, files: list[str]) -> Any:
        return self._take("unsaved")

    def conflict(self, found: Any) -> Any:
        self.conflicts.append(found)
        return self._take("conflict")

    def recording(self) -> Any:
        return self._take("recording")

    def recording_to(self, usual: str) -> Any:
        return self._take("recording_to")

    def field_recordings(self) -> Any:
        return self._take("field_recordings")

    def field_folder(self) -> Any:
        return self._take("field_folder")

    def usage_file(self, usual: str) -> Any:
        return self._take("usage_file")

    def picture_file(self, usual: str) -> Any:
        return self._take("picture_file")

    def translations_from(self) -> Any:
        return self._take("translations_from")

    def translations_to(self, usual: str) -> Any:
        return self._take("translations_to")

    def media_file(self, endings: tuple[str, ...]) -> Any:
        return self._take("media_file")

    def export(self, name: str, areas: Any) -> Any:
        """What was put in: what of the drawing, and the scale."""
        what, scale = self._take("export")
        assert what in areas, f"{what!r} is not offered, but {list(areas)}"
        return Export(what, scale)

    def preview(self, printer: QPrinter, paint: Any) -> bool:
        """The person prints into the PDF that was put in."""
        printer.setOutputFormat(QPrinter.OutputFormat.PdfFormat)
        printer.setOutputFileName(str(self._take("preview")))
        paint(printer)
        return True

    def printer(self, printer: QPrinter) -> bool:
        """The person chooses the PDF that was put in, or None: does not print."""
        out = self._take("printer")
        if out is not None:
            printer.setOutputFormat(QPrinter.OutputFormat.PdfFormat)
            printer.setOutputFileName(str(out))
        return out is not None

    def where(self, name: str) -> Any:
        return self._take("where")

    def details(self, title: str, words: str, details: str, unfolded: bool = False) -> None:
        self.details_told.append((words, details))

    def tell(self, text: str) -> None:
        self.told.append(text)


class Studio:
    """A window in use. Everything goes through real mouse and key events."""

    def __init__(self, window: MainWindow) -> None:
        self.window = window
        self.answers = Answers()
        window.dialogs = self.answers  # type: ignore[assignment]

    @property
    def session(self) -> Any:
        return self.window.session

    def settle(self) -> None:
        """Everything that is due now is done: layout, deferred deletes, zero timers."""
        for _ in range(3):
            QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
            QApplication.processEvents()
        if self.window.isVisible() and not self.window.isActiveWindow():
            # The offscreen platform activates nothing again when a popup has closed.
            self.window.activateWindow()
            QApplication.processEvents()

    def select(self, *place: str) -> None:
        """Selects a place of the current document, as a click elsewhere would."""
        self.window.select(place)
        self.settle()

    def click(self, widget: QWidget, at: QPoint | None = None) -> None:
        assert widget.isVisible(), f"{widget} can not be seen"
        spot = at if at is not None else widget.rect().center()
        QTest.mousePress(widget, LEFT, pos=spot)
        # What a menu that it opened has made of the form may have deleted it.
        if shiboken6.isValid(widget):
            QTest.mouseRelease(widget, LEFT, pos=spot)
        self.settle()

    def click_row(self, view: QAbstractItemView, index: QModelIndex, double: bool = False) -> None:
        """Clicks a row of a list or tree at the beginning of its text."""
        view.scrollTo(index)
        rect = view.visualRect(index)
        at = QPoint(rect.left() + 30, rect.center().y())
        press = QTest.mouseDClick if double else QTest.mouseClick
        QTest.mouseClick(view.viewport(), LEFT, pos=at)
        if double:
            press(view.viewport(), LEFT, pos=at)
        self.settle()

    def key(self, key: Qt.Key, held: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier) -> None:
        """A key to whatever has the focus."""
        QTest.keyClick(QApplication.focusWidget() or self.window, key, held)
        self.settle()

    def type(self, text: str) -> None:
        """Text to whatever has the focus."""
        widget = QApplication.focusWidget()
        assert widget is not None, "nothing has the focus"
        QTest.keyClicks(widget, text)
        self.settle()

    def fill(self, field: QWidget, text: str, end: Qt.Key = Qt.Key.Key_Return) -> None:
        """Clicks into a field, writes over what is in it, and ends with a key."""
        self.click(field, QPoint(12, field.height() // 2))
        self.key(Qt.Key.Key_A, CONTROL)
        self.key(Qt.Key.Key_Delete)
        self.type(text)
        self.key(end)

    def row_with(self, view: QAbstractItemView, text: str, column: int = 0) -> QModelIndex:
        """The first row, at any depth, whose cell has this text."""
        model = view.model()
        waiting = [QModelIndex()]
        while waiting:
            parent = waiting.pop(0)
            for row in range(model.rowCount(parent)):
                index = model.index(row, column, parent)
                if index.data() == text:
                    return index
                waiting.append(model.index(row, 0, parent))
        raise AssertionError(f"no row {text!r}")

    def choose(self, combo: Any, text: str) -> None:
        """Chooses an entry of a combo box by keys."""
        combo.setFocus()
        assert combo.hasFocus()
        wanted = combo.findText(text)
        assert wanted >= 0, f"no {text!r} in {[combo.itemText(i) for i in range(combo.count())]}"
        while combo.currentIndex() != wanted:
            self.key(Qt.Key.Key_Down if combo.currentIndex() < wanted else Qt.Key.Key_Up)


@pytest.fixture
def settings(tmp_path: Path) -> QSettings:
    """The settings of a person who starts the studio for the first time."""
    return QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat)


@pytest.fixture
def studio(qt: QApplication, settings: QSettings) -> Iterator[Callable[..., Studio]]:
    """``studio(path)``: a shown window of 1280 × 800, light, with that project."""

    def start(path: Path | None = None, theme: str = "light") -> Studio:
        window = main.create_window(path, settings, theme)
        window.resize(1280, 800)
        window.show()
        window.activateWindow()
        assert QTest.qWaitForWindowExposed(window)
        made = Studio(window)
        made.settle()
        return made

    with pytest.MonkeyPatch.context() as patience:
        # What is said in passing is still there when a slow machine comes to look at it.
        patience.setattr(status, "SAID_FOR", 60 * PATIENCE)
        yield start
    # A window may have been made anew, or have opened another.
    for window in [w for w in QApplication.topLevelWidgets() if isinstance(w, MainWindow)]:
        window.may_leave = lambda: True  # type: ignore[method-assign]
        window.close()
        window.deleteLater()
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    QApplication.processEvents()
    speaking = qt.findChild(Speaking)
    if speaking is not None:
        # Tests without a window read what is told in English.
        speaking.use("en")


@pytest.fixture
def project(tmp_path: Path) -> Callable[[str], Path]:
    """``project(name)``: a copy of an example."""

    def copy(name: str) -> Path:
        target = tmp_path / name
        shutil.copytree(example(name), target)
        return target

    return copy


@pytest.fixture
def listening() -> Iterator[None]:
    """An assistive program listens."""
    QAccessible.setActive(True)
    yield
    QAccessible.setActive(False)


@pytest.fixture
def comes() -> Callable[[SignalInstance], None]:
    """``comes(signal)``: waits until it has come; fails where it does not."""

    def wait(signal: SignalInstance) -> None:
        spy = QSignalSpy(signal)
        assert spy.count() or spy.wait(PATIENCE), f"{signal} did not come"

    return wait
