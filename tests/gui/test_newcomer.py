"""A person who never saw the studio builds an application from nothing, by mouse and keys only.

What these tests can do a person can: nothing of the studio is called to edit anything.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import shiboken6
from PySide6.QtCore import QEvent, QPoint, QPointF, QRect, Qt, QTimer
from PySide6.QtGui import QAccessible, QColor, QInputMethodEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QApplication,
    QComboBox,
    QFileDialog,
    QLineEdit,
    QMenu,
    QWidget,
)

from situ_studio.window.dialogs import Dialogs

CONTROL = Qt.KeyboardModifier.ControlModifier
NONE = Qt.KeyboardModifier.NoModifier
LEFT = Qt.MouseButton.LeftButton
TRIES = 2000
"""Turns of the event loop in which a question has to come."""

Start = Callable[..., Any]


class Newcomer:
    """Looks at the window, presses what is seen, types."""

    def __init__(self, used: Any) -> None:
        self.used = used
        self.window = used.window

    @property
    def application(self) -> Any:
        return next(iter(self.used.session.project.applications.values()))

    @property
    def form(self) -> Any:
        return self.window.inspector.form

    @property
    def canvas(self) -> Any:
        return self.window.current_view.canvas

    def press(self, kind: str) -> None:
        """A press in the palette."""
        self.used.click(self.window.palette_.item(kind))

    def write(self, text: str, end: Qt.Key = Qt.Key.Key_Return) -> None:
        """Types where the cursor is: nothing needs to be clicked first."""
        focus = QApplication.focusWidget()
        assert focus is not None
        assert self.window.inspector.isAncestorOf(focus), f"the cursor is in {focus}"
        self.used.type(text)
        self.used.key(end)

    def spot(self, uid: str, at: QPointF) -> QPoint:
        """A pixel of the canvas, at a point of a card."""
        found: QPoint = self.canvas.viewer.mapFromScene(
            self.canvas.graph.nodes[uid].view.scenePos() + at
        )
        return found

    def click_card(self, no: str) -> None:
        port = self.canvas.viewer.viewport()
        at = self.spot(no, QPointF(20, 44))
        assert port.rect().contains(at), f"card {no} can not be seen"
        QTest.mouseClick(port, LEFT, pos=at)
        self.used.settle()

    def drag_new(self, source: str, target: str) -> None:
        """Drags from the plus of a selected card onto another card."""
        self.click_card(source)
        port = self.canvas.viewer.viewport()
        node = self.canvas.graph.nodes[source]
        start = self.canvas.viewer.mapFromScene(node.port("out", "new").view.centre())
        end = self.spot(target, QPointF(88, 60))
        QTest.mouseMove(port, start)
        QTest.mousePress(port, LEFT, pos=start)
        for part in range(1, 6):
            QTest.mouseMove(port, start + (end - start) * (part / 5))
        QTest.mouseRelease(port, LEFT, pos=end)
        self.used.settle()


class Person:
    """Sees what is on the screen, by its words; has a mouse and a keyboard, and nothing else.

    What a thing is called is asked of the accessible tree, as of a screen reader: no method, no
    value of the studio is used.
    """

    def __init__(self, window: QWidget) -> None:
        self.window = window

    def settle(self) -> None:
        for _ in range(3):
            QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
            QApplication.processEvents()
        if QApplication.activePopupWidget() is None and not self.window.isActiveWindow():
            # The offscreen platform activates nothing again when a dialog has closed.
            self.window.activateWindow()
            QApplication.processEvents()

    # -- looking -----------------------------------------------------------------------

    def _called(self, widget: QWidget) -> set[str]:
        interface = QAccessible.queryAccessibleInterface(widget)
        return {interface.text(QAccessible.Text.Name), widget.accessibleName()}

    def widget(self, name: str, kind: type[QWidget] = QWidget) -> QWidget:
        """What is seen and called so, the first as one reads."""
        every = [w for w in QApplication.allWidgets() if w.isVisible() and isinstance(w, kind)]
        found = [w for w in every if w.window().isVisible() and name in self._called(w)]
        found = [w for w in found if not w.visibleRegion().isEmpty()]
        found.sort(key=lambda w: w.mapToGlobal(QPoint()).toTuple()[::-1])
        assert found, f"nothing is called {name!r}"
        return found[0]

    def drawn(self, name: str) -> QRect:
        """Where a part of the drawing is, on the screen."""
        waiting = [QAccessible.queryAccessibleInterface(self.widget("Drawing"))]
        while waiting:
            part = waiting.pop(0)
            if part.text(QAccessible.Text.Name) == name:
                assert not part.state().offscreen, f"{name} can not be seen"
                return QRect(part.rect())
            waiting += [part.child(i) for i in range(part.childCount())]
        raise AssertionError(f"nothing drawn is called {name!r}")

    # -- the mouse ----------------------------------------------------------------------

    def _at(self, spot: QPoint) -> tuple[QWidget, QPoint]:
        widget = self.window.childAt(self.window.mapFromGlobal(spot))
        assert widget is not None, f"nothing is at {spot}"
        return widget, widget.mapFromGlobal(spot)

    def click_at(self, spot: QPoint) -> None:
        widget, at = self._at(spot)
        QTest.mouseMove(widget, at)
        QTest.mousePress(widget, LEFT, pos=at)
        # What a menu that it opened has made of the form may have deleted it.
        if shiboken6.isValid(widget):
            QTest.mouseRelease(widget, LEFT, pos=at)
        self.settle()

    def click(self, name: str, kind: type[QWidget] = QWidget) -> None:
        widget = self.widget(name, kind)
        self.click_at(widget.mapToGlobal(widget.rect().center()))

    def click_card(self, name: str) -> None:
        self.click_at(self.drawn(name).topLeft() + QPoint(20, 16))

    def drag_new(self, source: str, target: str) -> None:
        """From the plus of a card, which is seen while it is selected, onto another card."""
        self.click_card(source)
        start, end = self.plus(source), self.drawn(target).center()
        widget, at = self._at(start)
        QTest.mouseMove(widget, at)
        QTest.mousePress(widget, LEFT, pos=at)
        for part in range(1, 6):
            QTest.mouseMove(widget, at + (end - start) * (part / 5))
        QTest.mouseRelease(widget, LEFT, pos=at + (end - start))
        self.settle()

    def plus(self, card: str) -> QPoint:
        """The blue ring with a plus in it, on the right edge of a card that is selected."""
        area = self.drawn(card)
        screen = self.window.grab().toImage()
        corner = self.window.mapToGlobal(QPoint())
        accent = QColor("#2D5BD0")
        ringed = []
        for y in range(area.top() + 36, area.bottom() + 10):
            row = [
                screen.pixelColor(QPoint(x, y) - corner)
                for x in range(area.right() - 7, area.right() + 8)
            ]
            if sum(_near(pixel, accent) for pixel in row) >= 5:
                ringed.append(y)
        assert ringed, f"{card} has no plus"
        # Ways of a selected card are as blue: the plus is below them.
        lowest = ringed[-1:]
        while lowest[0] - 1 in ringed:
            lowest.insert(0, lowest[0] - 1)
        return QPoint(area.right(), lowest[len(lowest) // 2])

    # -- the keyboard -------------------------------------------------------------------

    def type(self, text: str, end: Qt.Key | None = Qt.Key.Key_Return) -> None:
        """Where the cursor is."""
        focus = QApplication.focusWidget()
        assert focus is not None, "nothing has the focus"
        QTest.keyClicks(focus, text)
        if end is not None:
            self.key(end)

    def key(self, key: Qt.Key, held: Qt.KeyboardModifier = NONE) -> None:
        QTest.keyClick(QApplication.focusWidget() or self.window, key, held)
        self.settle()

    def write_into(self, name: str, text: str) -> None:
        """Over what stands in the field of that name."""
        self.click(name, QLineEdit)
        self.key(Qt.Key.Key_A, CONTROL)
        self.type(text)

    def pick(self, box: str, choice: str) -> None:
        """From a box's list, with the arrow keys."""
        self.click(box, QComboBox)
        view = QApplication.focusWidget()
        assert isinstance(view, QAbstractItemView), f"{box} opened no list"
        self.key(Qt.Key.Key_Home)
        for _ in range(view.model().rowCount()):
            if view.currentIndex().data() == choice:
                break
            self.key(Qt.Key.Key_Down)
        assert view.currentIndex().data() == choice, f"no {choice!r} in {box}"
        self.key(Qt.Key.Key_Return)

    def answer(self, text: str) -> None:
        """Writes into the question that comes next."""

        def write(tries: int) -> None:
            asked = QApplication.activeModalWidget()
            if asked is None or not asked.isVisible():
                assert tries, f"nobody asked for {text!r}"
                QTimer.singleShot(0, lambda: write(tries - 1))
                return
            field = asked.findChild(QLineEdit)
            assert field is not None
            QTest.keyClick(field, Qt.Key.Key_A, CONTROL)
            QTest.keyClicks(field, text)
            QTest.keyClick(field, Qt.Key.Key_Return)

        QTimer.singleShot(0, lambda: write(TRIES))

    def menu(self, name: str, entry: str) -> None:
        """Presses a button that opens a menu and goes to an entry by the arrow keys."""
        self.choose_in_menu(entry, lambda: self.click(name))

    def choose_in_menu(self, entry: str, opened: Callable[[], None]) -> None:
        """By the arrow keys, in the menu that is open until ``opened`` comes back."""

        def choose(tries: int) -> None:
            menu = QApplication.activePopupWidget()
            if not isinstance(menu, QMenu):
                assert tries, f"no menu with {entry!r} opened"
                QTimer.singleShot(0, lambda: choose(tries - 1))
                return
            for _ in range(20):
                QTest.keyClick(menu, Qt.Key.Key_Down)
                if menu.activeAction() is not None and menu.activeAction().text() == entry:
                    QTest.keyClick(menu, Qt.Key.Key_Return)
                    return
            menu.close()
            raise AssertionError(f"no {entry!r} in the menu")

        QTimer.singleShot(0, lambda: choose(TRIES))
        opened()


def _near(one: QColor, other: QColor) -> bool:
    apart = one.red() - other.red(), one.green() - other.green(), one.blue() - other.blue()
    return all(abs(by) < 60 for by in apart)


def situ(*arguments: str) -> subprocess.CompletedProcess[str]:
    """The command ``situ``, in a process of its own."""
    return subprocess.run(
        [sys.executable, "-m", "situ", *arguments], capture_output=True, text=True, check=False
    )


def test_a_newcomer_builds_an_application_that_runs(
    studio: Start, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """From the welcome page: three states, two screens, a guarded transition and a timeout."""
    window = studio().window
    window.dialogs = Dialogs(window)
    # The desktop's own question, in most places a program of its own.
    monkeypatch.setattr(QFileDialog, "getExistingDirectory", lambda *_: str(tmp_path))
    me = Person(window)
    me.answer("Robot Nurse")
    me.click("New project")
    folder = tmp_path / "robot-nurse"
    me.click_card("1 start")

    # Two states more; each is named where the cursor is.
    me.click("State", QAbstractButton)
    me.type("ask")
    me.click("State", QAbstractButton)
    me.type("thank")

    # The second one asks, by voice and on its screen.
    me.click_card("2 ask")
    me.click("Speech", QAbstractButton)
    me.type("How are you today?", Qt.Key.Key_Tab)
    me.click("Text", QAbstractButton)
    me.type("How are you?", Qt.Key.Key_Tab)
    me.click("Button", QAbstractButton)
    me.type("Fine")

    # The third one has a screen too, and ends.
    me.click_card("3 thank")
    me.click("Text", QAbstractButton)
    me.type("Thank you", Qt.Key.Key_Tab)
    me.click_card("3 thank")
    me.click("It may end here")

    # The ways: from a plus to a card. The way from the question is its button's.
    me.drag_new("1 start", "2 ask")
    me.drag_new("2 ask", "3 thank")

    # The first way is taken only while the ward is open.
    me.click_card("1 start")
    me.click("Set value", QAbstractButton)
    me.type("ward", Qt.Key.Key_Tab)
    me.type("open")
    me.click_card("1 start")
    me.click_at(me.drawn("event1 leads to 2 ask").center())
    me.write_into("Event", "humanDetected")
    me.menu("Add a test", "A test")
    me.type("ward", Qt.Key.Key_Tab)
    me.pick("Test", "is")
    me.write_into("Value", "open")

    # Who has not understood hears it again.
    me.click_card("2 ask")
    me.click("Event", QAbstractButton)
    me.type("again")
    me.click("Add a phrase")
    me.type("pardon")
    me.menu("Add", "Say again")

    # Nobody answers: back to the start.
    me.click_card("2 ask")
    me.click("Timeout", QAbstractButton)
    me.type("20")
    me.pick("The timeout leads to", "1 start")

    # Nothing is wrong, and it is saved.
    me.widget("0 errors")
    me.widget("0 warnings")
    me.key(Qt.Key.Key_S, CONTROL)
    assert not window.windowTitle().startswith("robot-nurse*")
    window.close()

    # What was drawn is what the robot does.
    checked = situ("check", str(folder))
    assert (checked.returncode, checked.stderr) == (0, "")
    text = (folder / "robot-nurse.rbd.xml").read_text(encoding="utf-8")
    button = re.search(r'<button id="(\w+)"', text)
    assert button is not None
    script = tmp_path / "visit.jsonl"
    lines: list[dict[str, Any]] = [
        {"at": 1, "set": {"ward": "closed"}},
        {"at": 2, "event": "humanDetected"},
        {"at": 3, "set": {"ward": "open"}},
        {"at": 4, "event": "humanDetected"},
        {"at": 4, "expect": {"kind": "enter", "state": "2"}},
        {"at": 24, "expect": {"kind": "enter", "state": "1"}},
        {"at": 25, "event": "humanDetected"},
        {"at": 26, "use": {"component": button[1]}},
        {"at": 26, "expect": {"kind": "enter", "state": "3"}},
    ]
    script.write_text("".join(json.dumps(line) + "\n" for line in lines), encoding="utf-8")
    played = situ("simulate", str(folder), "--script", str(script))
    assert played.returncode == 0, played.stderr
    trace = [json.loads(line) for line in played.stdout.splitlines()]
    entered = [event["state"] for event in trace if event["kind"] == "enter"]
    assert entered == ["1", "2", "1", "2", "3"]


def test_a_way_drawn_before_its_button_is_the_button_s(studio: Start, tmp_path: Path) -> None:
    used = studio()
    me = Newcomer(used)
    used.answers.put("name", "way-first")
    used.answers.put("new_folder", str(tmp_path))
    used.click(used.window.welcome.new)
    me.press("state")
    me.drag_new("1", "2")
    me.click_card("1")
    me.press("button")
    me.write("Go on")
    start = me.application.state("1")
    assert start.screen.components[-1].event == start.events[0].name


def test_from_the_welcome_page_there_is_a_way_back(studio: Start, tmp_path: Path) -> None:
    used = studio()
    assert used.window.welcome.back is None
    used.answers.put("name", "p")
    used.answers.put("new_folder", str(tmp_path))
    used.click(used.window.welcome.new)
    me = Newcomer(used)
    me.press("state")
    used.window.docks["palette"].hide()
    used.window.actions_.actions["welcome"].trigger()
    used.settle()
    assert not used.window.docks["project"].isVisible()
    used.click(used.window.welcome.back)
    assert used.window.docks["project"].isVisible()
    assert not used.window.docks["palette"].isVisible()
    assert used.window.current_file == "p.rbd.xml"
    assert used.session.undo_text is not None
    used.window.actions_.actions["welcome"].trigger()
    used.settle()
    used.key(Qt.Key.Key_Escape)
    assert used.window.current_file == "p.rbd.xml"


def test_what_is_refused_says_why_where_it_is_seen(studio: Start, tmp_path: Path) -> None:
    used = studio()
    used.answers.put("name", "p")
    used.answers.put("new_folder", str(tmp_path))
    used.click(used.window.welcome.new)
    Newcomer(used).press("state")
    used.fill(used.window.inspector.form.field("no"), "1")
    assert used.window.status.said.text() == "1 is taken already."


def test_names_are_written_in_japanese(studio: Start, tmp_path: Path) -> None:
    used = studio()
    used.answers.put("name", "p")
    used.answers.put("new_folder", str(tmp_path))
    used.click(used.window.welcome.new)
    me = Newcomer(used)
    me.press("state")
    field = QApplication.focusWidget()
    assert field is not None
    # What is still being composed is no edit.
    QApplication.sendEvent(field, QInputMethodEvent("あいさつ", []))
    used.settle()
    assert me.application.state("2").name == "state 2"
    done = QInputMethodEvent()
    done.setCommitString("挨拶")
    QApplication.sendEvent(field, done)
    used.key(Qt.Key.Key_Return)
    assert me.application.state("2").name == "挨拶"
    used.key(Qt.Key.Key_S, CONTROL)
    assert "挨拶" in (tmp_path / "p" / "p.rbd.xml").read_text(encoding="utf-8")


def test_a_state_drawn_on_empty_ground_is_named_by_typing(studio: Start, tmp_path: Path) -> None:
    used = studio()
    used.answers.put("name", "p")
    used.answers.put("new_folder", str(tmp_path))
    used.click(used.window.welcome.new)
    me = Newcomer(used)
    me.click_card("1")
    port = me.canvas.viewer.viewport()
    start = me.canvas.viewer.mapFromScene(
        me.canvas.graph.nodes["1"].port("out", "new").view.centre()
    )
    QTest.mousePress(port, LEFT, pos=start)
    for part in range(1, 6):
        QTest.mouseMove(port, start + QPoint(80, 30) * (part / 5))
    QTest.mouseRelease(port, LEFT, pos=start + QPoint(80, 30))
    used.settle()
    used.type("state")
    used.key(Qt.Key.Key_Return)
    me.write("measuring")
    assert me.application.state("2").name == "measuring"
    assert me.application.state("1").events[-1].next == "2"


def test_searching_for_nothing_says_so(studio: Start) -> None:
    used = studio()
    used.key(Qt.Key.Key_K, CONTROL)
    used.type("zzzz")
    assert used.window.finder.nothing.isVisible()
    used.key(Qt.Key.Key_Escape)
