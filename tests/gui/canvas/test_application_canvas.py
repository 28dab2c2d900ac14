"""What a hand can do on an application's canvas, each by real events."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QEvent, QEventLoop, QMimeData, QPoint, QPointF, Qt
from PySide6.QtGui import (
    QDragEnterEvent,
    QDragMoveEvent,
    QDropEvent,
    QGuiApplication,
    QImage,
    QMouseEvent,
)
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from situ.document.aside import NOTHING
from situ.document.problem import Problem
from situ.document.rbd import Application, Event, Speech, State
from situ_studio import theme
from situ_studio.canvas.live import LiveView, Taken
from situ_studio.kinds import MIME

CONTROL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
ALT = Qt.KeyboardModifier.AltModifier
Make = Callable[..., Any]
Check = Callable[[Any], None]


@pytest.fixture
def made(desk: Make, small: Application) -> Any:
    return desk(small)


# -- cards ---------------------------------------------------------------------------


def test_dragging_a_card_is_one_move_on_the_grid(made: Any, check: Check) -> None:
    hand = made.hand
    hand.drag(hand.header("2"), hand.header("2") + QPointF(101, 83))
    assert made.edits == ["Move state 2"]
    assert made.document.states[1].aside.position == (328, 80)
    check(made)


def test_selected_cards_move_together(made: Any, check: Check) -> None:
    hand = made.hand
    hand.click(hand.header("1"))
    hand.click(hand.header("2"), CONTROL)
    assert made.canvas.selection() == (("state", "1"), ("state", "2"))
    hand.drag(hand.header("2"), hand.header("2") + QPointF(0, 40))
    assert made.edits == ["Move 2 cards"]
    check(made)


def test_a_trembling_click_moves_nothing(made: Any) -> None:
    hand = made.hand
    hand.press(hand.header("2"))
    hand.move(hand.header("2") + QPointF(3, 2))
    hand.release(hand.header("2") + QPointF(3, 2))
    assert made.edits == []
    assert made.canvas.selection() == (("state", "2"),)


def test_escape_in_a_drag_puts_the_card_back(made: Any, check: Check) -> None:
    hand = made.hand
    start = hand.header("2")
    hand.press(start)
    for step in (20, 40, 60):
        hand.move(start + QPointF(step, step))
    assert hand.card("2").y() != 0
    hand.key(Qt.Key.Key_Escape)
    hand.release(start + QPointF(60, 60))
    assert made.edits == []
    check(made)


def test_pipes_follow_a_card_while_it_is_dragged(made: Any) -> None:
    hand = made.hand
    start = hand.header("3")
    before = hand.pipe("2", "0").route.points
    hand.press(start)
    for step in (20, 40, 60):
        hand.move(start + QPointF(0, step))
    hand.settle()
    during = hand.pipe("2", "0").route.points
    assert during != before
    assert during[-1][1] == hand.card("3").y() + 63
    hand.release(start + QPointF(0, 60))


def test_a_rubber_band_takes_cards_and_the_pipes_between_them(made: Any) -> None:
    hand = made.hand
    hand.drag(QPointF(-30, -30), QPointF(440, 150))
    places = set(made.canvas.selection())
    assert {("state", "1"), ("state", "2"), ("state", "1", "event", "0")} <= places
    assert ("state", "2", "event", "0") not in places


def test_double_click_renames_in_place(made: Any, check: Check) -> None:
    hand = made.hand
    hand.double_click(hand.header("2"))
    editor = made.canvas._editor
    assert editor.text() == "look"
    hand.type(editor, "search names")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    hand.settle()
    assert made.edits == ["Rename state 2 to search names"]
    check(made)


def test_escape_and_an_unchanged_name_rename_nothing(made: Any) -> None:
    hand = made.hand
    for key, text in ((Qt.Key.Key_Escape, "other"), (Qt.Key.Key_Return, "look")):
        hand.click(hand.header("2"))
        hand.key(Qt.Key.Key_F2)
        editor = made.canvas._editor
        editor.setText(text)
        QTest.keyClick(editor, key)
        hand.settle()
        assert made.canvas._editor is None
    assert made.edits == []


def test_tab_renames_the_next_card(made: Any) -> None:
    hand = made.hand
    made.canvas.select([("state", "2")])
    hand.key(Qt.Key.Key_Return)
    hand.type(made.canvas._editor, "two")
    QTest.keyClick(made.canvas._editor, Qt.Key.Key_Tab)
    hand.settle()
    assert made.edits == ["Rename state 2 to two"]
    assert made.canvas._editor.key == "3"
    made.canvas._editor.close_editor()


def test_a_double_click_elsewhere_opens_the_state(made: Any) -> None:
    opened: list[Any] = []
    made.canvas.activated.connect(opened.append)
    made.hand.double_click(made.hand.body("3"))
    assert opened == [("state", "3")]


def test_the_document_changed_while_a_name_is_edited(made: Any, small: Application) -> None:
    made.hand.double_click(made.hand.header("2"))
    made.change(replace(small, states=small.states[:1]))
    assert made.canvas._editor is None
    assert made.edits == []


# -- pipes ----------------------------------------------------------------------------


def test_from_exit_to_card_connects(made: Any, check: Check) -> None:
    hand = made.hand
    hand.drag(hand.exit("1", "0"), hand.body("4"))
    assert made.edits == ["Lead touched of state 1 to 4 no user"]
    assert made.document.states[0].events[0].next == "4"
    check(made)


def test_from_exit_to_its_own_card_is_a_loop_but_not_by_accident(made: Any, check: Check) -> None:
    hand = made.hand
    hand.drag(hand.exit("4", "0"), hand.exit("4", "0") + QPointF(-14, 4))
    assert made.edits == []
    hand.drag(hand.exit("4", "0"), hand.body("4"))
    assert made.document.states[3].events[0].next == "4"
    check(made)


def test_the_plus_makes_a_new_event(made: Any, check: Check) -> None:
    hand = made.hand
    hand.drag(hand.exit("5", "new"), hand.body("1"))
    assert made.edits == ["Add event1 of state 5 to 1 start"]
    assert made.document.states[4].events == (Event(name="event1", next="1"),)
    check(made)


def test_a_pipe_pulled_to_another_card_leads_there(made: Any, check: Check) -> None:
    hand = made.hand
    hand.drag(hand.on_pipe(hand.pipe("2", "0")), hand.body("5"))
    assert made.edits == ["Lead returned of state 2 to 5 end"]
    check(made)


def test_a_click_on_a_pipe_selects_its_event_and_takes_nothing_off(made: Any, check: Check) -> None:
    hand = made.hand
    hand.click(hand.on_pipe(hand.pipe("2", "0")))
    assert made.canvas.selection() == (("state", "2", "event", "0"),)
    assert made.edits == []
    check(made)


def test_a_click_on_an_exit_selects_its_event(made: Any) -> None:
    hand = made.hand
    hand.click(hand.exit("2", "timeout"))
    assert made.canvas.selection() == (("state", "2", "timeout"),)
    hand.click(hand.exit("3", "2"))
    assert made.canvas.selection() == (("state", "3", "event", "2"),)
    assert hand.card("3").row == "2"


def test_a_second_click_on_a_row_selects_its_event(made: Any) -> None:
    hand = made.hand
    row = hand.card("3").scenePos() + QPointF(150, 63 + 36)
    hand.click(row)
    assert made.canvas.selection() == (("state", "3"),)
    hand.click(row)
    assert made.canvas.selection() == (("state", "3", "event", "2"),)


def test_delete_takes_the_selected_event(made: Any, check: Check) -> None:
    hand = made.hand
    hand.click(hand.on_pipe(hand.pipe("2", "0")))
    hand.key(Qt.Key.Key_Delete)
    assert made.edits == ["Delete returned of state 2"]
    check(made)


def test_escape_puts_a_pulled_pipe_back(made: Any, check: Check) -> None:
    hand = made.hand
    start = hand.on_pipe(hand.pipe("2", "0"))
    hand.press(start)
    for step in (10, 30, 60):
        hand.move(start + QPointF(0, step))
    assert made.canvas.viewer.busy()
    hand.key(Qt.Key.Key_Escape)
    assert not made.canvas.viewer.busy()
    hand.release(start + QPointF(0, 60))
    assert made.edits == []
    check(made)


def test_a_pipe_over_a_card_does_not_drag_the_card(made: Any, check: Check) -> None:
    """A port that reaches over another card is the port's."""
    hand = made.hand
    made.change(
        replace(
            made.document,
            states=tuple(
                replace(s, aside=s.aside.at(176 - 4, 30)) if s.no == "2" else s
                for s in made.document.states
            ),
        )
    )
    hand.card("2").setZValue(3)
    hand.drag(hand.exit("1", "1"), hand.body("4"))
    assert made.edits == ["Lead human of state 1 to 4 no user"]
    check(made)


def test_alt_and_shift_cut_pipes(made: Any, check: Check) -> None:
    hand = made.hand
    straight = hand.pipe("1", "0").route.points
    assert len(straight) == 2
    x = (straight[0][0] + straight[1][0]) / 2 + 12
    hand.drag(QPointF(x, 30), QPointF(x, 150), ALT | SHIFT)
    assert made.document.states[0].events[0].next is None
    check(made)


# -- what can follow -------------------------------------------------------------------


def test_an_exit_dropped_on_the_ground_asks_what_follows(made: Any, check: Check) -> None:
    hand = made.hand
    hand.drag(hand.exit("4", "0"), QPointF(480, 500))
    menu = made.canvas.menu
    labels = [menu.list.item(i).text() for i in range(menu.list.count())]
    assert labels[0] == "New state"
    assert "3 names" in labels
    check(made)
    hand.type(menu.field, "question")
    assert menu.list.item(0).text() == "New question with Yes and No"
    QTest.keyClick(menu.field, Qt.Key.Key_Return)
    hand.settle()
    assert made.edits == ["Add state 6 after state 4"]
    state = made.document.state("6")
    assert state.aside.position == (480, 440)
    assert made.document.states[3].events[0].next == "6"
    assert made.canvas.selection() == (("state", "6"),)
    check(made)


def test_a_name_that_nothing_has_is_offered_as_a_new_state(made: Any, check: Check) -> None:
    made.hand.drag(made.hand.exit("4", "0"), QPointF(480, 500))
    menu = made.canvas.menu
    made.hand.type(menu.field, "names")
    offered = [menu.list.item(i).text() for i in range(menu.list.count())]
    assert offered == ["3 names", "New state “names”"]
    made.hand.type(menu.field, " again")
    QTest.keyClick(menu.field, Qt.Key.Key_Return)
    made.hand.settle()
    assert made.edits == ["Add state 6 after state 4"]
    assert made.document.state("6").name == "names again"
    assert made.document.states[3].events[0].next == "6"
    check(made)


def test_the_menu_of_what_follows_is_seen_whole(made: Any) -> None:
    made.canvas.move(200, 200)
    made.hand.drag(made.hand.exit("4", "0"), QPointF(520, 560))
    menu = made.canvas.menu
    assert menu.screen().availableGeometry().contains(menu.geometry())
    menu.close()


def test_escape_in_the_menu_leaves_the_old_pipe(made: Any, check: Check) -> None:
    hand = made.hand
    hand.drag(hand.on_pipe(hand.pipe("2", "0")), QPointF(480, 500))
    QTest.keyClick(made.canvas.menu.field, Qt.Key.Key_Escape)
    hand.settle()
    assert made.edits == []
    assert made.canvas.menu is None
    check(made)


def test_stay_here_disconnects(made: Any, check: Check) -> None:
    hand = made.hand
    hand.drag(hand.on_pipe(hand.pipe("2", "0")), QPointF(480, 500))
    hand.type(made.canvas.menu.field, "stay")
    QTest.keyClick(made.canvas.menu.field, Qt.Key.Key_Return)
    hand.settle()
    assert made.edits == ["Disconnect returned of state 2"]
    check(made)


# -- keys --------------------------------------------------------------------------------


def test_arrows_go_from_card_to_card(made: Any) -> None:
    hand = made.hand
    made.canvas.select([("state", "1")])
    for key, no in (
        (Qt.Key.Key_Right, "2"),
        (Qt.Key.Key_Right, "3"),
        (Qt.Key.Key_Left, "2"),
        (Qt.Key.Key_Down, "5"),
        (Qt.Key.Key_Left, "4"),
    ):
        hand.key(key)
        assert made.canvas.selection() == (("state", no),)


def test_tab_goes_in_the_order_of_the_document_and_letters_find_names(made: Any) -> None:
    hand = made.hand
    made.canvas.select([("state", "2")])
    hand.key(Qt.Key.Key_Tab)
    assert made.canvas.selection() == (("state", "3"),)
    hand.key(Qt.Key.Key_Backtab)
    assert made.canvas.selection() == (("state", "2"),)
    hand.key(Qt.Key.Key_N, text="n")
    assert made.canvas.selection() == (("state", "3"),)
    hand.key(Qt.Key.Key_N, text="n")
    assert made.canvas.selection() == (("state", "4"),)


def test_control_and_arrows_move_cards(made: Any, check: Check) -> None:
    made.canvas.select([("state", "5")])
    made.hand.key(Qt.Key.Key_Down, CONTROL)
    assert made.edits == ["Move state 5"]
    assert made.document.states[4].aside.position == (230, 236)
    check(made)


def test_select_all_and_escape(made: Any) -> None:
    made.hand.key(Qt.Key.Key_A, CONTROL)
    assert len(made.canvas.selection()) == 6
    made.hand.key(Qt.Key.Key_Escape)
    assert made.canvas.selection() == ()


# -- selection from outside -----------------------------------------------------------------


def test_select_by_place_tells_once(made: Any) -> None:
    made.canvas.select([("state", "1", "event", "1")])
    made.canvas.select([("state", "1", "event", "1")])
    assert made.selections == [(("state", "1", "event", "1"),)]
    made.canvas.select([("state", "99")])
    assert made.canvas.selection() == ()
    made.canvas.select([("always",), ("state", "2")])
    assert made.canvas.selection() == (("always",), ("state", "2"))


def test_a_selection_survives_an_edit_of_something_else(made: Any, small: Application) -> None:
    made.canvas.select([("state", "2", "event", "0")])
    renamed = replace(small.states[4], name="bye")
    made.change(replace(small, states=(*small.states[:4], renamed)))
    assert made.canvas.selection() == (("state", "2", "event", "0"),)
    assert len(made.selections) == 1


# -- zoom ---------------------------------------------------------------------------------------


def test_the_wheel_zooms_at_the_cursor(made: Any) -> None:
    hand, canvas = made.hand, made.canvas
    spot = QPointF(300, 200)
    at = hand.pixel(spot)
    hand.wheel(spot, 240)
    assert canvas.zoom() == pytest.approx(1.0015**240, rel=0.01)
    there = canvas.viewer.mapToScene(at)
    assert abs(there.x() - spot.x()) < 2
    assert abs(there.y() - spot.y()) < 2


def test_zoom_has_ends(made: Any) -> None:
    made.canvas.set_zoom(100)
    assert made.canvas.zoom() == 4.0
    made.canvas.set_zoom(0)
    assert made.canvas.zoom() == 0.04


def test_zoom_to_fit_shows_everything(made: Any) -> None:
    canvas = made.canvas
    canvas.set_zoom(3)
    canvas.zoom_to_fit()
    assert canvas.zoom() <= 1
    assert len(canvas.cards_in_view()) == 6


def test_a_large_drawing_opens_readable_at_its_start(desk: Make, small: Application) -> None:
    """A small one opens whole, wherever its start is."""
    away = tuple(
        replace(s, aside=s.aside.at(*at))
        for s, at in zip(
            small.states, ((4000, 2600), (0, 0), (230, 0), (460, 0), (690, 0)), strict=True
        )
    )
    canvas = desk(replace(small, states=away)).canvas
    canvas.zoom_to_begin()
    assert canvas.zoom() == 0.8
    assert canvas.cards_in_view() == ["1"]
    near = desk(small, size=(1280, 800)).canvas
    near.zoom_to_begin()
    assert len(near.cards_in_view()) == 6
    assert near.zoom() >= 0.75


def test_zoom_to_places_brings_them_into_view(made: Any) -> None:
    canvas = made.canvas
    canvas.viewer._set_viewer_pan(5000, 5000)
    canvas.zoom_to([("state", "4", "event", "0")])
    assert "4" in canvas.cards_in_view()
    assert canvas.zoom() == 1.0


def test_the_middle_button_and_space_move_the_ground(made: Any) -> None:
    hand, canvas = made.hand, made.canvas
    spot = QPointF(300, 20)

    def drag(button: Qt.MouseButton) -> None:
        port = canvas.viewer.viewport()
        for kind, at in (
            (QEvent.Type.MouseButtonPress, QPoint(200, 200)),
            (QEvent.Type.MouseMove, QPoint(250, 230)),
            (QEvent.Type.MouseButtonRelease, QPoint(250, 230)),
        ):
            held = Qt.MouseButton.NoButton if kind == QEvent.Type.MouseButtonRelease else button
            where = QPointF(port.mapToGlobal(at))
            event = QMouseEvent(
                kind, QPointF(at), where, button, held, Qt.KeyboardModifier.NoModifier
            )
            QApplication.sendEvent(port, event)

    before = hand.pixel(spot)
    drag(Qt.MouseButton.MiddleButton)
    assert hand.pixel(spot) - before == QPoint(50, 30)
    QTest.keyPress(canvas.viewer, Qt.Key.Key_Space)
    drag(Qt.MouseButton.LeftButton)
    QTest.keyRelease(canvas.viewer, Qt.Key.Key_Space)
    assert hand.pixel(spot) - before == QPoint(100, 60)
    assert made.edits == []


def test_resizing_keeps_zoom_and_corner(made: Any) -> None:
    canvas = made.canvas
    corner = canvas.viewer._scene_range.topLeft()
    canvas.resize(800, 600)
    QApplication.processEvents()
    assert canvas.zoom() == 1.0
    assert canvas.viewer._scene_range.topLeft() == corner


def test_the_overview_follows_what_moves_and_what_is_selected_and_a_press_goes_there(
    made: Any,
) -> None:
    canvas, hand = made.canvas, made.hand
    canvas.resize(620, 580)
    QApplication.processEvents()
    canvas.viewer.look_at(QPointF(460, 250))
    overview = canvas.minimap
    seen = [overview.grab().toImage()]
    assert overview.isVisible()

    def changed() -> bool:
        seen.append(overview.grab().toImage())
        return bool(seen[-1] != seen[-2])

    hand.click(hand.header("2"))
    assert changed()
    hand.drag(hand.header("2"), hand.header("2") + QPointF(0, 200))
    assert changed()
    made.undo()
    assert changed()
    canvas.set_theme(theme.DARK)
    assert changed()
    before = canvas.viewer.seen()
    QTest.mouseClick(overview, Qt.MouseButton.LeftButton, pos=QPoint(4, 33))
    assert canvas.viewer.seen().left() < before.left()
    assert changed()
    assert not changed()


def test_the_overview_of_very_many_cards_follows_a_little_later(
    made: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    canvas, hand = made.canvas, made.hand
    canvas.resize(620, 580)
    QApplication.processEvents()
    canvas.viewer.look_at(QPointF(460, 250))
    overview = canvas.minimap
    monkeypatch.setattr("situ_studio.canvas.overlay.MANY", 1)
    before = overview._drawn()[0].toImage()
    hand.click(hand.header("2"))
    assert overview._drawn()[0].toImage() == before
    while overview._drawn()[0].toImage() == before:
        QApplication.processEvents(QEventLoop.ProcessEventsFlag.WaitForMoreEvents)


# -- folded pipes -----------------------------------------------------------------------------


def test_a_chip_leads_to_its_state_and_alt_draws_the_pipe(made: Any) -> None:
    hand = made.hand
    pipe = hand.pipe("2", "timeout")
    assert pipe.route.folded
    hand.click(hand.on_pipe(pipe))
    assert made.canvas.selection() == (("state", "1"),)
    hand.click(hand.on_pipe(pipe), ALT)
    assert not hand.pipe("2", "timeout").route.folded
    assert made.edits == []


# -- commands ----------------------------------------------------------------------------------


def test_commands_are_one_edit_each(made: Any, check: Check) -> None:
    canvas = made.canvas
    canvas.add_state()
    check(made)
    canvas.select([("state", "1"), ("state", "2")])
    canvas.duplicate()
    assert canvas.selection() == (("state", "7"), ("state", "8"))
    check(made)
    canvas.select([("state", "1"), ("state", "5")])
    canvas.align("left")
    canvas.connect_selected()
    canvas.auto_layout()
    check(made)
    canvas.select([("state", "8")])
    canvas.delete_selection()
    assert made.edits == [
        "Add state 6",
        "Duplicate 2 states",
        "Align 2 cards",
        "Add go of state 1 to 5 end",
        "Arrange all cards",
        "Delete state 8",
    ]
    check(made)


def test_a_new_state_stands_free(made: Any) -> None:
    canvas = made.canvas
    for _ in range(3):
        canvas.add_state()
    cards = list(canvas.graph.cards.values())
    for one in cards:
        for other in cards:
            if one is not other:
                apart = (
                    one.x >= other.x + other.width
                    or other.x >= one.x + one.width
                    or one.y >= other.y + other.height
                    or other.y >= one.y + one.height
                )
                assert apart


def test_copies_go_by_the_clipboard_to_another_canvas(
    desk: Make, small: Application, check: Check
) -> None:
    first, second = desk(small), desk(Application(name="other"))
    first.canvas.select([("state", "1"), ("state", "2")])
    first.canvas.copy()
    assert "<state" in QGuiApplication.clipboard().text()
    second.canvas.paste()
    assert [s.name for s in second.document.states] == ["start", "look"]
    assert [s.no for s in second.document.states] == ["1", "2"]
    assert second.canvas.selection() == (("state", "1"), ("state", "2"))
    check(second)
    first.canvas.cut()
    assert first.edits == ["Cut 2 states"]
    check(first)


def test_pasting_something_else_says_so(made: Any) -> None:
    said: list[str] = []
    made.canvas.status.connect(said.append)
    QGuiApplication.clipboard().clear()
    made.canvas.paste()
    for text in ("", "hello", "<spds name='x'/>", "<application name='x'/>"):
        QGuiApplication.clipboard().setText(text)
        made.canvas.paste()
    assert made.edits == []
    assert said == ["There are no states on the clipboard"] * 5


# -- drops from the palette ------------------------------------------------------------------------


def drop(made: Any, kind: str, spot: QPointF) -> None:
    viewer = made.canvas.viewer
    data = QMimeData()
    data.setData(MIME, kind.encode())
    at = made.hand.pixel(spot)
    left, none = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    copy = Qt.DropAction.CopyAction
    enter = QDragEnterEvent(at, copy, data, left, none)
    QApplication.sendEvent(viewer.viewport(), enter)
    assert enter.isAccepted()
    QApplication.sendEvent(viewer.viewport(), QDragMoveEvent(at, copy, data, left, none))
    QApplication.sendEvent(viewer.viewport(), QDropEvent(QPointF(at), copy, data, left, none))
    made.hand.settle()


def test_a_state_dropped_on_the_ground(made: Any, check: Check) -> None:
    drop(made, "state", QPointF(600, 520))
    assert made.edits == ["Add state 6"]
    assert made.document.states[-1].aside.position == (512, 464)
    check(made)


def test_a_state_dropped_on_a_pipe_is_inserted(made: Any, check: Check) -> None:
    drop(made, "state", made.hand.on_pipe(made.hand.pipe("2", "0")))
    assert made.edits == ["Insert state 6"]
    assert made.document.states[1].events[0].next == "6"
    assert made.document.state("6").events[0].next == "3"
    check(made)


def test_a_drawing_with_next_to_nothing_says_what_to_do_first(desk: Make) -> None:
    made = desk(Application(name="new"))
    advice = made.canvas.advice
    assert advice.isVisible()
    assert "Drag State" in advice.text()
    # What lies under the words is dropped on as if they were not there.
    drop(made, "state", made.canvas.viewer.mapToScene(advice.geometry().center()))
    assert made.edits == ["Add state 1"]
    assert "drag the plus" in advice.text()
    assert not advice.geometry().intersects(made.canvas.zoom_bar.geometry())
    made.hand.drag(made.hand.exit("1", "new"), QPointF(200, 100))
    QTest.keyClick(made.canvas.menu.field, Qt.Key.Key_Return)
    made.hand.settle()
    assert len(made.document.states) == 2
    assert not advice.isVisible()


def test_an_action_dropped_on_a_card_is_its(made: Any, check: Check) -> None:
    drop(made, "speech", made.hand.body("5"))
    assert isinstance(made.document.states[4].actions[0], Speech)
    assert len(made.edits) == 1
    check(made)


def test_an_action_dropped_on_the_ground_says_what_to_do(made: Any) -> None:
    said: list[str] = []
    made.canvas.status.connect(said.append)
    drop(made, "speech", QPointF(600, 520))
    assert made.edits == []
    assert len(said) == 1


# -- documents of all kinds -----------------------------------------------------------------------


def test_cards_without_places_get_some_and_keep_them(desk: Make, check: Check) -> None:
    document = Application(
        name="plain",
        states=tuple(
            State(no=str(i), events=(Event(name="go", next=str(i + 1)),)) for i in range(1, 9)
        ),
    )
    made = desk(document)
    check(made)
    before = {u: (c.x, c.y) for u, c in made.canvas.graph.cards.items()}
    assert len(set(before.values())) == 8
    made.hand.drag(made.hand.header("1"), made.hand.header("1") + QPointF(0, 64))
    assert made.edits == ["Move state 1"]
    after = {s.no: s.aside.position for s in made.document.states}
    assert after.pop("1") == (before["1"][0], before["1"][1] + 68)
    assert after == {no: at for no, at in before.items() if no != "1"}
    check(made)


def test_a_faulty_document_is_shown_as_it_is(desk: Make, check: Check) -> None:
    """Doubled numbers, no start, dangling targets: an editor shows them, check says so."""
    document = Application(
        name="faulty",
        start="99",
        states=(
            State(no="1", events=(Event(name="a", next="2"), Event(name="b", next="#back"))),
            State(no="1", events=(Event(next="7"),)),
            State(no="always", flow="part.rbd.xml"),
        ),
    )
    made = desk(document)
    assert len(made.canvas.graph.cards) == 3
    check(made)
    made.hand.drag(made.hand.header("always"), made.hand.header("always") + QPointF(30, 30))
    check(made)


def test_an_empty_application(desk: Make, check: Check) -> None:
    made = desk(Application(name="empty"))
    check(made)
    made.canvas.zoom_to_fit()
    made.canvas.select_all()
    made.canvas.auto_layout()
    made.hand.key(Qt.Key.Key_Tab)
    made.hand.key(Qt.Key.Key_Delete)
    assert made.edits == []
    made.canvas.add_state()
    assert made.edits == ["Add state 1"]
    check(made)


def test_a_large_drawing_is_routed_in_slices(desk: Make, qt: QApplication) -> None:
    states = tuple(
        State(
            no=str(i),
            events=(Event(name="on", next=str(i % 200 + 1)), Event(name="no", next="1")),
        )
        for i in range(1, 201)
    )
    made = desk(Application(name="large", states=states))
    canvas = made.canvas
    while canvas._piping.is_routing():
        qt.processEvents()
    pipes = [canvas.graph.pipe(i) for i in canvas.graph.links]
    assert len(pipes) == 400
    assert all(p.route.folded or len(p.route.points) > 1 for p in pipes)
    # One edit touches only what it must.
    ways = {i: canvas.graph.pipe(i).route for i in canvas.graph.links}
    made.change(replace(made.document, states=(replace(states[0], name="first"), *states[1:])))
    while canvas._piping.is_routing():
        qt.processEvents()
    assert all(canvas.graph.pipe(i).route is way for i, way in ways.items())
    for moved in (states[0], states[9]):
        # The first has a pipe from every other: what takes longer follows in slices.
        other = replace(moved, aside=NOTHING.at(4000, 4000))
        now = made.document.states
        index = now.index(next(s for s in now if s.no == moved.no))
        made.change(replace(made.document, states=(*now[:index], other, *now[index + 1 :])))
        assert not canvas.look.unrouted
    while canvas._piping.is_routing():
        qt.processEvents()
    own = [i for i in canvas.graph.links if {i[0], i[2]} & {"1", "10"}]
    for id in own:
        pipe = canvas.graph.pipe(id)
        assert pipe.route.folded or pipe.route.points[0] == pipe.output_port.centre().toTuple()


# -- looks -----------------------------------------------------------------------------------------


def test_problems_are_marked(made: Any, small: Application) -> None:
    problems = [
        Problem(file="x", severity="warning", code="a", message="a", place=("state", "2")),
        Problem(file="x", code="b", message="b", place=("state", "3", "event", "3")),
        Problem(file="x", severity="warning", code="c", message="c", place=("state", "3")),
    ]
    made.canvas.show_document(small, problems)
    marks = {u: c.mark for u, c in made.canvas.graph.cards.items()}
    assert marks["2"] == "warning"
    assert marks["3"] == "error"
    assert marks["1"] == ""


@pytest.mark.parametrize("zoom", [0.1, 0.25, 0.5, 1.0, 2.0])
@pytest.mark.parametrize("looks", [theme.LIGHT, theme.DARK], ids=["light", "dark"])
def test_every_level_of_detail_is_painted(made: Any, zoom: float, looks: theme.Theme) -> None:
    canvas = made.canvas
    canvas.set_theme(looks)
    canvas.zoom_to_fit()
    canvas.set_zoom(zoom)
    ground = looks.color("canvas").rgb()
    image = canvas.viewer.grab().toImage()
    spot = made.hand.pixel(made.hand.card("2").sceneBoundingRect().center())
    if image.rect().contains(spot):
        assert image.pixelColor(spot).rgb() != ground
    colors = {image.pixelColor(x, y).rgb() for x in range(0, 1100, 9) for y in range(0, 760, 9)}
    assert ground in colors
    assert len(colors) > 2


def test_live_highlights_touch_neither_document_nor_model(
    made: Any, check: Check, farthest: Callable[[QImage, QImage], int]
) -> None:
    canvas, hand = made.canvas, made.hand
    plain = canvas.viewer.grab().toImage()
    canvas.set_live(
        LiveView(
            active=frozenset({"2"}),
            entered={"2": 4.2},
            counts={"1": 3},
            taken=(Taken("1", "0", 0.5),),
            transitions={("1", "0"): 3},
        )
    )
    check(made)
    live = canvas.viewer.grab().toImage()
    corner = hand.pixel(hand.card("2").scenePos())
    edge = QPoint(corner.x() + 60, corner.y())
    color = live.pixelColor(edge)
    assert color.green() > color.red()
    assert plain.pixelColor(edge) != color
    canvas.set_live(None)
    assert farthest(canvas.viewer.grab().toImage(), plain) <= 2
    assert made.edits == []
