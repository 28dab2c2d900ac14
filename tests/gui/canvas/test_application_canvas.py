"""What a hand can do on an application's canvas, each by real events."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import (
    QGuiApplication,
    QImage,
)
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from situ.document.aside import NOTHING
from situ.document.problem import Problem
from situ.document.rbd import Application, Event, State
from situ_studio.canvas.live import LiveView, Taken
from situ_studio.looks import theme

CONTROL = Qt.KeyboardModifier.ControlModifier
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


def test_a_card_that_loses_its_place_gets_one_where_no_other_lies(made: Any, check: Check) -> None:
    """As where somebody else writes the file without it."""
    states = tuple(replace(s, aside=NOTHING) if s.no == "3" else s for s in made.document.states)
    made.change(replace(made.document, states=states))
    area = made.canvas.card_area
    others = [uid for uid in made.canvas.graph.cards if uid != "3"]
    assert len(others) == 5
    assert not [uid for uid in others if area(uid).intersects(area("3"))]
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
