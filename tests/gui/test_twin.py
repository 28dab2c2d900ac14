"""The outline twin: what the drawing's gestures do, done there with keys only."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractItemView, QApplication

from situ.document.rbd import Application

CONTROL = Qt.KeyboardModifier.ControlModifier
ALT = Qt.KeyboardModifier.AltModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
UP, DOWN, RIGHT, HOME = Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_Right, Qt.Key.Key_Home
ENTER, TAB, ESCAPE = Qt.Key.Key_Return, Qt.Key.Key_Tab, Qt.Key.Key_Escape
FILE = "reception.rbd.xml"

Start = Callable[..., Any]
Copy = Callable[[str], Path]


class Typist:
    """Uses the outline with keys only."""

    def __init__(self, used: Any) -> None:
        self.used = used
        self.key = used.key
        self.type = used.type
        used.window.show_mode("outline")
        used.settle()

    @property
    def tree(self) -> Any:
        return self.used.window.current_view.twin.tree

    @property
    def document(self) -> Application:
        found: Application = self.used.window.current_document
        return found

    def state(self, no: str) -> Any:
        return self.document.state(no)

    def to_outline(self) -> None:
        """F6 until the outline has the focus."""
        for _ in range(12):
            if QApplication.focusWidget() is self.tree:
                return
            self.key(Qt.Key.Key_F6)
        raise AssertionError(f"F6 does not lead to the outline: {QApplication.focusWidget()}")

    def row(self) -> list[str]:
        index = self.tree.currentIndex()
        return [index.siblingAtColumn(c).data() for c in range(4)]

    def down_to(self, *words: str) -> None:
        """From the first row down, opening what is closed, to a row that begins with these."""
        self.to_outline()
        self.key(HOME)
        for _ in range(300):
            if tuple(self.row()[: len(words)]) == words:
                return
            before = self.tree.currentIndex()
            if self.tree.model().hasChildren(before) and not self.tree.isExpanded(before):
                self.key(RIGHT)
            self.key(DOWN)
            if self.tree.currentIndex() == before:
                break
        raise AssertionError(f"no row {words}")

    def command(self, words: str) -> None:
        self.key(Qt.Key.Key_K, CONTROL)
        self.type(words)
        self.key(ENTER)

    def pick(self, words: str) -> None:
        """From the list of the choice that is edited."""
        popup = QApplication.activePopupWidget()
        assert popup is not None, f"no list is open, {QApplication.focusWidget()}"
        view = QApplication.focusWidget()
        assert isinstance(view, QAbstractItemView)
        rows = [view.model().index(r, 0).data() for r in range(view.model().rowCount())]
        while view.currentIndex().row() != rows.index(words):
            self.key(DOWN if view.currentIndex().row() < rows.index(words) else UP)
        self.key(ENTER)


@pytest.fixture
def typist(studio: Start, project: Copy) -> Typist:
    return Typist(studio(project("reception")))


def test_a_state_with_an_event_and_a_timeout_is_added_and_led_on(typist: Typist) -> None:
    typist.command("State")
    typist.type("farewell")
    typist.key(ENTER)
    typist.command("Event")
    typist.type("goodbye")
    typist.key(ENTER)
    typist.command("Timeout")
    typist.type("21")
    typist.key(ENTER)
    state = typist.document.states[-1]
    assert (state.name, state.events[0].name) == ("farewell", "goodbye")

    typist.down_to(state.no, "farewell")
    typist.down_to("Event", "goodbye")
    typist.key(ENTER)
    typist.key(TAB)
    typist.pick("11 main menu")
    assert typist.state(state.no).events[0].next == "11"

    typist.down_to("Timeout", "21 s")
    typist.key(ENTER)
    typist.type("120")
    typist.key(TAB)
    typist.pick("1 start")
    timeout = typist.state(state.no).timeout
    assert (timeout.seconds, timeout.next) == (120.0, "1")


def test_tab_in_a_cell_goes_on_to_the_next_one_of_its_row(typist: Typist) -> None:
    typist.down_to("Event", "clickContinue")
    typist.key(ENTER)
    typist.key(Qt.Key.Key_A, CONTROL)
    typist.type("goOn")
    typist.key(TAB)
    typist.pick("7 search names")
    event = typist.state("2").events[0]
    assert (event.name, event.next) == ("goOn", "7")
    assert QApplication.focusWidget() is typist.tree
    assert typist.row()[:3] == ["Event", "goOn", "7 search names"]


def test_escape_in_the_list_of_states_changes_nothing(typist: Typist) -> None:
    before = typist.document
    typist.down_to("Event", "clickContinue")
    typist.key(ENTER)
    typist.key(TAB)
    typist.key(DOWN)
    typist.key(ESCAPE)
    typist.key(ESCAPE)
    assert typist.document is before
    assert QApplication.focusWidget() is typist.tree


def test_a_state_is_renamed_and_renumbered(typist: Typist) -> None:
    typist.down_to("2", "intro")
    typist.key(ENTER)
    typist.key(Qt.Key.Key_A, CONTROL)
    typist.type("welcome")
    typist.key(Qt.Key.Key_Backtab, SHIFT)
    typist.key(Qt.Key.Key_A, CONTROL)
    typist.type("22")
    typist.key(ENTER)
    assert typist.state("22").name == "welcome"
    assert typist.state("1").events[0].next == "22"


def test_rows_move_among_their_own(typist: Typist) -> None:
    names = [e.name for e in typist.state("7").events]
    typist.down_to("7", "search names")
    typist.down_to("Event", "returnedWithNoNames")
    typist.key(UP, ALT)
    assert [e.name for e in typist.state("7").events] == [names[1], names[0], *names[2:]]
    assert typist.row()[1] == "returnedWithNoNames"
    typist.key(UP, ALT)
    assert [e.name for e in typist.state("7").events] == [names[1], names[0], *names[2:]]
    typist.key(DOWN, ALT)
    assert [e.name for e in typist.state("7").events] == names
    assert typist.used.session.undo_text == "Move event returnedWithNoNames of state 7"
    typist.down_to("2", "intro")
    typist.key(UP, ALT)
    assert [s.no for s in typist.document.states[:2]] == ["2", "1"]
    assert typist.document.start_no == "1"


def test_a_row_goes_and_comes_back(typist: Typist) -> None:
    before = typist.document
    typist.down_to("14", "no user")
    typist.key(Qt.Key.Key_Delete)
    assert typist.state("14") is None
    assert all(e.next != "14" for s in typist.document.states for e in s.events)
    typist.key(Qt.Key.Key_Z, CONTROL)
    assert typist.document is before


def test_a_guard_is_a_row_that_opens_its_form_and_can_go(typist: Typist) -> None:
    typist.down_to("Only if")
    assert "human.distance below 1.5" in typist.row()[1]
    typist.key(ENTER)
    assert typist.used.window.inspector.place == ("state", "1", "event", "2")
    assert typist.used.window.inspector.isAncestorOf(QApplication.focusWidget())
    typist.down_to("Only if")
    typist.key(Qt.Key.Key_Delete)
    assert typist.state("1").events[2].when is None


def test_enter_on_an_action_without_text_opens_its_form(typist: Typist) -> None:
    typist.down_to("Robot", "head nod")
    typist.key(ENTER)
    assert typist.used.window.inspector.place == ("state", "2", "action", "1")
    assert typist.used.window.inspector.isAncestorOf(QApplication.focusWidget())


def test_an_action_is_added_where_the_row_is(typist: Typist) -> None:
    typist.down_to("Event", "clickContinue")
    typist.command("Set value")
    assert [type(a).__name__ for a in typist.state("2").events[0].actions] == ["Set"]


def test_drawing_and_outline_share_the_selection(typist: Typist) -> None:
    window = typist.used.window
    typist.down_to("9", "save profile")
    assert window.current_view.selected == (("state", "9"),)
    typist.key(Qt.Key.Key_1, CONTROL)
    assert window.current_view.canvas.selection() == (("state", "9"),)
    typist.key(TAB)
    assert window.current_view.canvas.selection() == (("state", "10"),)
    typist.key(Qt.Key.Key_2, CONTROL)
    assert typist.row()[:2] == ["10", "greeting"]
