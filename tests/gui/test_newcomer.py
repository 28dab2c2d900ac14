"""A person who never saw the studio builds an application from nothing, by mouse and keys only.

No method of the window is called to edit anything: what this test can do a person can.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt, QTimer
from PySide6.QtGui import QInputMethodEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu, QWidget

from situ import cli

CONTROL = Qt.KeyboardModifier.ControlModifier
LEFT = Qt.MouseButton.LeftButton

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

    def choose_in_menu(self, button: QWidget, text: str) -> None:
        """Opens a button's menu and goes to an entry by the arrow keys."""

        def choose() -> None:
            menu = QApplication.activePopupWidget()
            assert isinstance(menu, QMenu)
            for _ in range(20):
                QTest.keyClick(menu, Qt.Key.Key_Down)
                if menu.activeAction() is not None and menu.activeAction().text() == text:
                    QTest.keyClick(menu, Qt.Key.Key_Return)
                    return
            menu.close()
            raise AssertionError(f"no {text!r} in the menu")

        QTimer.singleShot(0, choose)
        self.used.click(button)


def test_a_newcomer_builds_an_application_that_runs(
    studio: Start, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    used = studio()
    me = Newcomer(used)
    # A new project, under a name as people write it.
    used.answers.put("name", "Robot Nurse")
    used.answers.put("new_folder", str(tmp_path))
    used.click(used.window.welcome.new)
    folder = tmp_path / "robot-nurse"
    assert used.answers.told == []
    assert (folder / "situ.toml").exists()
    assert [s.no for s in me.application.states] == ["1"]

    # Two states more; each is named where the cursor is.
    me.press("state")
    me.write("ask")
    me.press("state")
    me.write("thank")
    assert [s.name for s in me.application.states] == ["start", "ask", "thank"]

    # The second one asks, by voice and on its screen.
    me.click_card("2")
    me.press("speech")
    me.write("How are you today?", Qt.Key.Key_Tab)
    me.press("text")
    me.write("How are you?", Qt.Key.Key_Tab)
    me.press("button")
    me.write("Fine")
    ask = me.application.state("2")
    assert ask.actions[0].text == "How are you today?"
    assert [c.text for c in ask.screen.components] == ["How are you?", "Fine"]

    # The third one has a screen too, and ends.
    me.click_card("3")
    me.press("text")
    me.write("Thank you", Qt.Key.Key_Tab)
    me.click_card("3")
    used.click(me.form.field("final"))
    assert me.application.state("3").final

    # The ways: from a plus to a card. The way from the question is its button's.
    me.drag_new("1", "2")
    me.drag_new("2", "3")
    assert [(e.name, e.next) for e in me.application.state("2").events] == [
        (ask.screen.components[1].event, "3")
    ]

    # The first way is taken only while somebody is near.
    me.click_card("1")
    rows = me.form.section("events").rows
    used.click(rows.row(0))
    used.fill(me.form.field("name"), "humanDetected")
    when = me.form.section("when")
    me.choose_in_menu(when.findChild(QWidget, "add test"), "A test")
    me.write("human.distance", Qt.Key.Key_Tab)
    box = when.condition.box(0)
    used.choose(box.test, "below")
    used.fill(box.value, "1.5")

    # Nobody answers: back to the start.
    me.click_card("2")
    me.press("timeout")
    me.write("20")
    used.choose(me.form._timeout.next, "1 start")

    # Nothing is wrong, and it is saved.
    assert [str(p) for p in used.session.problems if p.severity == "error"] == []
    used.click(used.window.toolbar.widgetForAction(used.window.actions_.actions["save"]))
    assert used.session.dirty == []
    used.window.close()

    # What was drawn is what the robot does.
    assert cli.main(["check", str(folder)]) == 0
    script = tmp_path / "visit.jsonl"
    lines: list[dict[str, Any]] = [
        {"at": 1, "set": {"human.distance": 3}},
        {"at": 2, "event": "humanDetected"},
        {"at": 3, "set": {"human.distance": 1}},
        {"at": 4, "event": "humanDetected"},
        {"at": 4, "expect": {"kind": "enter", "state": "2"}},
        {"at": 24, "expect": {"kind": "enter", "state": "1"}},
        {"at": 25, "event": "humanDetected"},
        {"at": 26, "use": {"component": ask.screen.components[1].id}},
        {"at": 26, "expect": {"kind": "enter", "state": "3"}},
    ]
    script.write_text("".join(json.dumps(line) + "\n" for line in lines), encoding="utf-8")
    capsys.readouterr()
    assert cli.main(["simulate", str(folder), "--script", str(script)]) == 0, capsys.readouterr()
    entered = [
        (event["t"], event["state"])
        for event in map(json.loads, capsys.readouterr().out.splitlines())
        if event["kind"] == "enter"
    ]
    assert [state for _, state in entered] == ["1", "2", "1", "2", "3"]


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


def test_searching_for_nothing_says_so(studio: Start) -> None:
    used = studio()
    used.key(Qt.Key.Key_K, CONTROL)
    used.type("zzzz")
    assert used.window.finder.nothing.isVisible()
    used.key(Qt.Key.Key_Escape)
