"""The canvas of a script: by real events, view = document = model, one edit or none."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest
from tests.gui.canvas.script_desk import TALK, agree, body, edit, holds, middle, out, pipe

from situ.document.condition import Test as Question
from situ.document.problem import Problem
from situ.document.spds import Entry, Situation, Spds
from situ_studio.canvas import script_gestures as gestures
from situ_studio.canvas.curves import InheritedPipe
from situ_studio.canvas.live import LiveScript
from situ_studio.canvas.script import ScriptCanvas
from situ_studio.looks import theme

CONTROL = Qt.KeyboardModifier.ControlModifier


@pytest.fixture
def script() -> Spds:
    return TALK


@pytest.fixture
def made(desk: Callable[..., Any], script: Spds) -> Any:
    return desk(script, ScriptCanvas)


# -- what is shown ---------------------------------------------------------------------


def test_columns_stand_in_the_order_of_reading(made: Any) -> None:
    agree(made)
    columns: dict[str, set[float]] = {}
    for card in made.canvas.graph.cards.values():
        columns.setdefault(card.kind, set()).add(card.x)
    assert all(len(xs) == 1 for xs in columns.values())
    order = sorted(columns, key=lambda kind: min(columns[kind]))
    assert order == ["data", "condition", "situation", "module", "resource"]
    situations = [c for c in made.canvas.graph.cards.values() if c.kind == "situation"]
    assert [c.number for c in sorted(situations, key=lambda c: c.y)] == [1, 2, 3]


@pytest.mark.parametrize("high", [600, 260])
def test_the_whole_drawing_begins_below_its_headings_at_any_zoom(made: Any, high: int) -> None:
    made.canvas.resize(1000, high)
    made.canvas.zoom_to_fit()
    top = min(card.y for card in made.canvas.graph.cards.values())
    assert made.canvas.viewer.mapFromScene(QPointF(0, top)).y() >= made.canvas.headings.height()


def test_nothing_lies_on_anything(made: Any) -> None:
    cards = list(made.canvas.graph.cards.values())
    for one in cards:
        for other in cards:
            if one is not other and one.x == other.x:
                assert one.y + one.height <= other.y or other.y + other.height <= one.y


def test_a_condition_says_its_tests_and_what_ends_it_stands_by_itself(made: Any) -> None:
    card = made.canvas.graph.cards["condition invited"]
    assert [row.text for row in card.rows] == ["is true, within 2 s", "is true, within 2 s"]
    assert (card.joint, card.until) == ("all", False)
    until = made.canvas.graph.cards["until invited"]
    assert [row.text for row in until.rows] == ["is true, within 2 s"]
    assert (until.joint, until.until) == ("", True)


def test_inherited_priorities_show_for_the_selected_situation_only(made: Any) -> None:
    canvas = made.canvas
    assert canvas.priorities.taken_over == []
    canvas.select([("situation", "sound")])
    shown = [(t.value.module, t.value.priority) for t in canvas.priorities.taken_over]
    assert shown == [("converse", 30)]
    canvas.select([("situation", "invited")])
    assert canvas.priorities.taken_over == []


def test_the_line_of_what_is_taken_over_strikes_no_number(made: Any) -> None:
    """It passes below every pipe that has one."""
    canvas = made.canvas
    canvas.select([("situation", "sound")])
    (over,) = canvas.priorities.taken_over
    pipes = [canvas.graph.pipe(id) for id in canvas.graph.links]
    assert over.way.scene() is canvas.viewer.scene()
    assert all(over.way.zValue() < pipe.zValue() for pipe in (*pipes, over))
    canvas.select([("situation", "invited")])
    assert over.way.scene() is None


def test_an_edit_makes_what_is_taken_over_anew_once(
    made: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each is a pipe with a place that has to be found."""
    canvas = made.canvas
    canvas.select([("situation", "sound")])
    (before,) = canvas.priorities.taken_over
    held: list[Any] = []
    hold = canvas.viewer.hold_pipe

    def hold_pipe(pipe: Any) -> None:
        held.append(pipe)
        hold(pipe)

    monkeypatch.setattr(canvas.viewer, "hold_pipe", hold_pipe)
    made.hand.settle()
    canvas._edit(*gestures.prioritise(canvas.document, "conversation", "converse", 31))
    (after,) = canvas.priorities.taken_over
    assert [pipe for pipe in held if isinstance(pipe, InheritedPipe)] == [after]
    assert (before.value.priority, after.value.priority) == (30, 31)


def test_the_way_through_the_selected_situation_is_lit(made: Any) -> None:
    made.canvas.select([("situation", "sound")])
    assert pipe(made, "condition sound", "situation sound").selected()
    assert pipe(made, "data slap", "condition sound").selected()
    assert pipe(made, "module gaze", "resource head").selected()
    assert not pipe(made, "module transfer", "resource head").selected()


@pytest.mark.parametrize("looks", [theme.LIGHT, theme.DARK], ids=["light", "dark"])
def test_it_is_painted_live_and_marked(
    made: Any, script: Spds, looks: theme.Theme, farthest: Callable[..., int]
) -> None:
    canvas = made.canvas
    place = ("situation", "sound", "entry", "0")
    canvas.show_document(
        script, [Problem(file="x", severity="warning", code="tie", message="t", place=place)]
    )
    canvas.set_theme(looks)
    plain = canvas.viewer.grab().toImage()
    canvas.set_live(
        LiveScript(
            situation="sound",
            holds=frozenset({"sound"}),
            authority={"head": "gaze", "base": None},
            asking={"gaze": ("head",)},
            values={"slap": 40.0},
        )
    )
    assert farthest(canvas.viewer.grab().toImage(), plain) > 20
    agree_document = made.document
    canvas.set_live(None)
    assert farthest(canvas.viewer.grab().toImage(), plain) <= 2
    assert made.document is agree_document
    assert pipe(made, "situation sound", "module gaze").link.mark == "warning"


# -- situations ---------------------------------------------------------------------------


def test_dragging_a_situation_reorders_the_precedence(made: Any) -> None:
    start = body(made, "situation sound")
    made.hand.drag(start, start - QPointF(0, 150))
    assert made.edits == ["Move sound to place 1"]
    assert [s.name for s in made.document.situations] == ["sound", "invited", "conversation"]
    agree(made)


def test_a_short_drag_puts_it_back(made: Any) -> None:
    start = body(made, "situation sound")
    made.hand.drag(start, start + QPointF(30, 14))
    assert made.edits == []
    agree(made)


def test_other_columns_do_not_move(made: Any) -> None:
    for key in ("data slap", "module gaze", "resource head", "condition sound"):
        made.hand.drag(body(made, key), body(made, key) + QPointF(60, 60))
    assert made.edits == []
    agree(made)


def test_control_and_arrows_reorder(made: Any) -> None:
    made.canvas.select([("situation", "sound")])
    made.hand.key(Qt.Key.Key_Up, CONTROL)
    assert made.edits == ["Move sound to place 1"]
    made.hand.key(Qt.Key.Key_Up, CONTROL)
    assert len(made.edits) == 1
    assert made.canvas.selection() == (("situation", "sound"),)


# -- pipes ----------------------------------------------------------------------------------


def test_situation_to_module_gives_a_priority(made: Any) -> None:
    made.hand.drag(out(made, "situation invited"), middle(made, "module gaze"))
    assert made.edits == ["Give gaze priority 100 in invited"]
    assert made.document.situations[0].entries[-1] == Entry("gaze", 100)
    agree(made)


def test_data_to_condition_or_situation_adds_a_test(made: Any) -> None:
    made.hand.drag(out(made, "data waving"), middle(made, "condition sound"))
    made.hand.drag(out(made, "data calling"), body(made, "situation sound"))
    assert made.edits == ["Let sound look at waving", "Let sound look at calling"]
    condition = made.document.situations[1].condition
    assert [t.tag for t in condition.children] == ["slap", "waving", "calling"]
    assert condition.children[2] == Question("calling", "is", "true")
    agree(made)


def test_module_to_resource_declares_it(made: Any) -> None:
    made.hand.drag(out(made, "module gaze"), middle(made, "resource base"))
    assert made.edits == ["Let gaze use base"]
    assert made.document.modules[1].resources == ("head", "base")
    agree(made)


def test_what_means_nothing_is_refused(made: Any) -> None:
    made.hand.drag(out(made, "data slap"), middle(made, "module gaze"))
    made.hand.drag(out(made, "situation invited"), middle(made, "resource head"))
    made.hand.drag(out(made, "module gaze"), body(made, "situation sound"))
    made.hand.drag(out(made, "situation invited"), middle(made, "module transfer"))
    assert made.edits == []
    agree(made)


def test_a_priority_pulled_to_another_module_keeps_its_number(made: Any) -> None:
    spot = pipe(made, "situation sound", "module gaze").pill().center()
    made.hand.drag(spot, middle(made, "module transfer"))
    assert len(made.edits) == 1
    assert made.document.situations[1].entries == (Entry("transfer", 60),)
    agree(made)


def test_a_pipe_pulled_away_goes(made: Any) -> None:
    spot = pipe(made, "situation sound", "module gaze").pill().center()
    made.hand.drag(spot, spot + QPointF(0, 260))
    assert made.edits == ["Delete a priority of sound"]
    assert made.document.situations[1].entries == ()
    agree(made)


def test_an_exit_dropped_on_the_ground_asks(made: Any) -> None:
    made.hand.drag(out(made, "situation invited"), QPointF(640, 500))
    menu = made.canvas.menu
    made.hand.type(menu.field, "new")
    QTest.keyClick(menu.field, Qt.Key.Key_Return)
    made.hand.settle()
    assert made.edits == ["Add module module"]
    assert made.document.situations[0].entries[-1] == Entry("module", 100)
    agree(made)


# -- priorities -------------------------------------------------------------------------------


def test_a_priority_is_edited_in_its_pill(made: Any) -> None:
    made.hand.click(pipe(made, "situation sound", "module gaze").pill().center())
    assert made.canvas.selection() == (("situation", "sound", "entry", "0"),)
    made.hand.key(Qt.Key.Key_Return)
    edit(made, "75")
    assert made.edits == ["Give gaze priority 75 in sound"]
    agree(made)


def test_typing_a_number_begins_it(made: Any) -> None:
    made.canvas.select([("situation", "sound", "entry", "0")])
    made.hand.key(Qt.Key.Key_8, text="8")
    made.hand.type(made.canvas.priorities.editor, "5")
    QTest.keyClick(made.canvas.priorities.editor, Qt.Key.Key_Return)
    made.hand.settle()
    assert made.edits == ["Give gaze priority 85 in sound"]


def test_none_and_nonsense(made: Any) -> None:
    said: list[str] = []
    made.canvas.status.connect(said.append)
    made.canvas.select([("situation", "sound", "entry", "0")])
    made.hand.key(Qt.Key.Key_Return)
    edit(made, "high")
    assert made.edits == []
    assert said == ["A priority is a whole number or none, not high"]
    made.hand.key(Qt.Key.Key_Return)
    edit(made, "none")
    assert made.document.situations[1].entries == (Entry("gaze", None),)
    agree(made)


def test_one_taken_over_is_overridden_by_a_click(made: Any) -> None:
    made.canvas.select([("situation", "sound")])
    made.hand.click(made.canvas.priorities.taken_over[0].pill().center())
    edit(made, "5")
    assert made.edits == ["Give converse priority 5 in sound"]
    assert made.document.situations[1].entries[-1] == Entry("converse", 5)
    agree(made)


# -- names, deletion, commands -----------------------------------------------------------------


@pytest.mark.parametrize(
    ("key", "text"),
    [
        ("data slap", "Rename data slap to new"),
        ("situation conversation", "Rename situation conversation to new"),
        ("module gaze", "Rename module gaze to new"),
        ("resource head", "Rename resource head to new"),
    ],
)
def test_a_name_is_edited_in_place_and_everywhere(made: Any, key: str, text: str) -> None:
    made.hand.double_click(body(made, key))
    made.hand.type(made.canvas._editor, "new")
    QTest.keyClick(made.canvas._editor, Qt.Key.Key_Return)
    made.hand.settle()
    assert made.edits == [text]
    agree(made)
    old = key.split()[1]
    assert f'"{old}"' not in repr(made.document).replace("'", '"')


@pytest.mark.parametrize(
    "place",
    [
        ("data", "slap"),
        ("situation", "sound"),
        ("module", "gaze"),
        ("situation", "invited", "condition", "1"),
        ("situation", "invited", "until"),
        ("situation", "conversation", "entry", "1"),
        ("module", "transfer", "resource", "head"),
        ("resource", "head"),
    ],
)
def test_delete_takes_what_is_selected_with_its_pipes(made: Any, place: tuple[str, ...]) -> None:
    made.canvas.select([place])
    made.hand.key(Qt.Key.Key_Delete)
    assert len(made.edits) == 1
    agree(made)


def test_commands(made: Any) -> None:
    canvas = made.canvas
    canvas.add_situation()
    canvas.add_module()
    canvas.add_data()
    assert made.edits == ["Add situation situation", "Add module module", "Add data data"]
    assert [s.name for s in made.document.situations][-2:] == ["situation", "conversation"]
    canvas.select([("situation", "sound"), ("module", "transfer")])
    canvas.connect_selected()
    assert made.edits[-1] == "Give transfer priority 70 in sound"
    agree(made)


def test_an_empty_script(desk: Callable[..., Any]) -> None:
    made = desk(Spds(name="empty"), ScriptCanvas)
    agree(made)
    made.canvas.zoom_to_fit()
    made.canvas.add_situation()
    assert made.document.situations == (Situation("situation"),)
    agree(made)


def test_a_faulty_script_is_shown_as_it_is(desk: Callable[..., Any]) -> None:
    script = Spds(
        name="faulty",
        situations=(
            Situation("one", extends="two", entries=(Entry("nobody", 1), Entry("nobody", 2))),
            Situation("one", extends="one", condition=holds("not.observed")),
        ),
    )
    made = desk(script, ScriptCanvas)
    agree(made)
    made.canvas.select([("situation", "one")])
    agree(made)
