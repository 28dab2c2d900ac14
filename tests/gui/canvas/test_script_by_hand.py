"""What is refused on the canvas of a script, what is heard of it, and the ways without a mouse."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QAccessible, QImage
from PySide6.QtTest import QTest
from tests.gui.canvas.script_desk import agree, body, middle, out, pipe
from tests.gui.canvas.test_accessible import DESCRIPTION, NAME, tree
from tests.gui.canvas.test_dropping import drop

from situ.document.condition import Condition, Group
from situ.document.condition import Test as Question
from situ.document.problem import Problem
from situ.document.spds import DataType, Declaration, Entry, Observed, Situation, Spds
from situ_studio.canvas.script import ScriptCanvas
from situ_studio.edits.vocabulary import Vocabulary
from situ_studio.panels.test_box import TestBox

ALT = Qt.KeyboardModifier.AltModifier
CONTROL = Qt.KeyboardModifier.ControlModifier
CALLING = Question("calling", "is", "true")
HOT = Question("heat", "above", "30")


@pytest.fixture
def made(desk: Callable[..., Any]) -> Any:
    made = desk(
        Spds(
            name="ward",
            observe=(Observed("calling", "boolean"), Observed("heat", "number")),
            modules=(Declaration("nod", ("head",)), Declaration("talk", ("speech",))),
            situations=(
                Situation("hot", dwell=2, condition=Condition((CALLING, HOT, CALLING))),
                Situation("called", extends="rest", condition=Condition((CALLING,))),
                Situation("rest", entries=(Entry("nod", 20), Entry("talk", 10))),
            ),
        ),
        ScriptCanvas,
    )
    made.said = []
    made.canvas.status.connect(made.said.append)
    return made


def typed(made: Any, text: str, end: Qt.Key = Qt.Key.Key_Return) -> None:
    """Into the menu that is open."""
    made.hand.type(made.canvas.menu.field, text)
    QTest.keyClick(made.canvas.menu.field, end)
    made.hand.settle()


# -- refused, with a sentence -----------------------------------------------------------------

DELETE = Qt.Key.Key_Delete
REFUSED: dict[str, tuple[Callable[[Any], object], str]] = {
    "a condition of the last": (
        lambda made: made.hand.drag(out(made, "data heat"), body(made, "situation rest")),
        "rest would be the last, and the last must always hold: first add one below",
    ),
    "the last before others": (
        lambda made: made.hand.drag(
            body(made, "situation rest"), body(made, "situation hot") - QPointF(0, 60)
        ),
        "called would be the last, and the last must always hold: first add one below",
    ),
    "taking the last away": (
        lambda made: (made.hand.click(body(made, "situation rest")), made.hand.key(DELETE)),
        "called would be the last, and the last must always hold: first add one below",
    ),
    "taking over in a circle": (
        lambda made: made.hand.drag(out(made, "situation rest"), body(made, "situation called")),
        "The situations would take over from each other in a circle",
    ),
    "dwell and until": (
        lambda made: pull_until(made),
        "hot can either stay so long at least, or have an until or an end: not both",
    ),
    "two of a name": (
        lambda made: rename(made, "situation called", "hot"),
        'There are two situations "hot": give one another name',
    ),
    "two modules of a name": (
        lambda made: rename(made, "module nod", "talk"),
        '"talk" is declared twice: take one out',
    ),
    "data to a module": (
        lambda made: made.hand.drag(out(made, "data heat"), middle(made, "module nod")),
        "Data leads to a condition or a situation, and nod is neither",
    ),
    "a situation to a resource": (
        lambda made: made.hand.drag(out(made, "situation hot"), middle(made, "resource head")),
        "A situation leads to a module, or to a situation that it takes over from",
    ),
    "a module to data": (
        lambda made: made.hand.drag(out(made, "module nod"), middle(made, "data heat")),
        "A module leads to the resources that it uses, and heat is none",
    ),
    "a condition to a module": (
        lambda made: made.hand.drag(out(made, "condition hot"), middle(made, "module nod")),
        "A condition belongs to its situation: drag from data to nod instead",
    ),
    "a priority that is no number": (
        lambda made: priority(made, "much"),
        "A priority is a whole number or none, not much",
    ),
    "a priority out of range": (
        lambda made: priority(made, "9" * 20),
        f"{'9' * 20} is too large for a priority",
    ),
    "a tag that is none": (
        lambda made: rename(made, "data heat", "Room!"),
        "",
    ),
}


def pull_until(made: Any) -> None:
    made.hand.drag(out(made, "data heat"), QPointF(660, 400))
    typed(made, "hot holds until")


def rename(made: Any, key: str, name: str) -> None:
    made.hand.double_click(body(made, key) - QPointF(0, 6))
    made.hand.type(made.canvas._editor, name)
    QTest.keyClick(made.canvas._editor, Qt.Key.Key_Return)
    made.hand.settle()


def priority(made: Any, text: str) -> None:
    made.hand.click(pipe(made, "situation rest", "module nod").pill().center())
    made.hand.type(made.canvas.priorities.editor, text)
    QTest.keyClick(made.canvas.priorities.editor, Qt.Key.Key_Return)
    made.hand.settle()


@pytest.mark.parametrize("case", REFUSED)
def test_what_may_not_be_is_refused_with_a_sentence(made: Any, case: str) -> None:
    draw, sentence = REFUSED[case]
    before = made.document
    draw(made)
    assert made.edits == []
    assert made.document is before
    assert len(made.said) == 1
    assert sentence in made.said[0]
    agree(made)


def test_the_last_test_of_a_group_takes_the_group_along(made: Any) -> None:
    """There is no way to an empty group."""
    inside = Condition((HOT, Group("any", (Group("none", (CALLING,)),))))
    situations = made.document.situations
    made.change(
        Spds(
            "ward",
            made.document.observe,
            made.document.modules,
            (Situation("hot", condition=inside), *situations[1:]),
        )
    )
    made.canvas.select([("situation", "hot", "condition", "1", "0", "0")])
    made.hand.key(DELETE)
    assert made.document.situations[0].condition == Condition((HOT,))
    made.canvas.select([("situation", "hot", "condition", "0")])
    made.hand.key(DELETE)
    assert made.document.situations[0].condition is None
    agree(made)


def test_what_is_wrong_already_hinders_nothing(desk: Callable[..., Any]) -> None:
    """A file by another's hand, whose last situation has a condition."""
    made = desk(
        Spds("w", situations=(Situation("a"), Situation("b", condition=Condition((HOT,))))),
        ScriptCanvas,
    )
    rename(made, "situation a", "first")
    assert made.edits == ["Rename situation a to first"]


# -- without a mouse --------------------------------------------------------------------------


def test_every_pipe_and_line_is_reached_by_keys(made: Any) -> None:
    """Tab from node to node, Alt with the arrows through the pipes or lines of one."""
    reached: set[tuple[str, ...]] = set()
    made.canvas.setFocus()
    for _ in range(len(made.canvas.graph.cards)):
        made.hand.key(Qt.Key.Key_Tab)
        (node,) = made.canvas.selection()
        reached.add(node)
        for _ in range(4):
            made.canvas.next_exit()
            reached.add(made.canvas.selection()[0])
            if made.canvas.selection() == (node,):
                break
        made.canvas.select([node])
    pipes = {link.place for link in made.canvas._picture.links.values() if link.place}
    assert pipes <= reached
    assert {card.place for card in made.canvas.graph.cards.values()} <= reached


def test_alt_and_arrows_go_round(made: Any) -> None:
    made.canvas.select([("situation", "rest")])
    seen = []
    for _ in range(3):
        made.canvas.next_exit()
        seen += made.canvas.selection()
    assert [place[-1] for place in seen] == ["0", "1", "0"]
    made.canvas.previous_exit()
    assert made.canvas.selection() == (("situation", "rest", "entry", "1"),)


def test_return_opens_what_is_selected_where_it_stands(made: Any) -> None:
    canvas, hand = made.canvas, made.hand
    canvas.select([("situation", "rest", "entry", "0")])
    hand.key(Qt.Key.Key_Return)
    assert canvas.priorities.editor.text() == "20"
    QTest.keyClick(canvas.priorities.editor, Qt.Key.Key_Escape)
    canvas.select([("situation", "hot", "condition", "1")])
    hand.key(Qt.Key.Key_Return)
    assert canvas.test_editor.box.tag.text() == "heat"
    QTest.keyClick(canvas.test_editor.box.tag, Qt.Key.Key_Escape)
    assert canvas.test_editor is None
    assert made.edits == []


def test_where_it_leads_is_asked_by_keys_too(made: Any) -> None:
    canvas = made.canvas
    canvas.select([("module", "nod")])
    canvas.ask_where_to()
    typed(made, "arm")
    canvas.select([("data", "heat")])
    canvas.ask_where_to()
    typed(made, "boiling")
    assert made.edits == ["Let nod use arm", "Add situation boiling"]
    assert made.document.modules[0].resources == ("head", "arm")
    assert made.document.situation("boiling").condition == Condition(
        (Question("heat", "above", "0"),)
    )
    agree(made)


def test_lines_chosen_together_become_a_group(made: Any) -> None:
    """With Ctrl, and then taken apart again."""
    lines = [made.canvas.row_area(("situation", "hot", "condition", i)).center() for i in "012"]
    made.hand.click(lines[0])
    made.hand.click(lines[2], CONTROL)
    made.canvas.group("any")
    whole = Condition((Group("any", (CALLING, CALLING)), HOT))
    assert made.document.situation("hot").condition == whole
    row = made.canvas.row_area(("situation", "hot", "condition", "0")).center()
    made.hand.click(row)
    assert made.canvas.selection() == (("situation", "hot", "condition", "0"),)
    made.canvas.ungroup()
    assert made.document.situation("hot").condition == Condition((CALLING, CALLING, HOT))
    agree(made)


def test_a_test_is_pulled_into_a_group_as_it_is(made: Any) -> None:
    made.canvas.select(
        [("situation", "hot", "condition", "0"), ("situation", "hot", "condition", "2")]
    )
    made.canvas.group("none")
    assert len(made.edits) == 1
    made.hand.drag(
        middle_of_pipe(made, ("situation", "hot", "condition", "1")),
        made.canvas.row_area(("situation", "hot", "condition", "0")).center(),
    )
    assert made.edits[1:] == ["Let hot look at heat"]
    assert made.document.situation("hot").condition == Condition(
        (Group("none", (CALLING, CALLING, HOT)),)
    )
    agree(made)


def middle_of_pipe(made: Any, place: tuple[str, ...]) -> QPointF:
    link = next(id for id, one in made.canvas._picture.links.items() if one.place == place)
    return QPointF(made.canvas.graph.pipe(link).path().pointAtPercent(0.75))


def test_a_pipe_dropped_on_a_pipe_goes_where_that_leads(made: Any) -> None:
    holds = pipe(made, "condition called", "situation called").path().pointAtPercent(0.5)
    made.hand.drag(out(made, "data heat"), QPointF(holds))
    assert made.edits == ["Let called look at heat"]
    agree(made)


@pytest.mark.parametrize(
    ("kind", "on", "edit"),
    [
        ("situation", "data heat", "Add situation situation"),
        ("module", "situation called", "Add module module"),
        ("data", "module nod", "Add data data"),
    ],
)
def test_what_is_dropped_belongs_to_what_it_is_dropped_on(
    made: Any, kind: str, on: str, edit: str
) -> None:
    drop(made, kind, body(made, on))
    assert made.edits == [edit]
    if kind == "situation":
        (test,) = made.document.situation("situation").condition.children
        assert test.tag == "heat"
    if kind == "module":
        assert made.document.situation("called").entries == (Entry("module", 30),)
    agree(made)


def test_a_condition_dropped_on_a_pipe_asks_which_data(made: Any) -> None:
    """And what is chosen is edited at once."""
    holds = pipe(made, "condition called", "situation called").path().pointAtPercent(0.5)
    drop(made, "condition", QPointF(holds))
    typed(made, "heat")
    assert made.edits == ["Let called look at heat"]
    assert made.canvas.test_editor.place == ("situation", "called", "condition", "1")
    QTest.keyClick(made.canvas.test_editor.box.value, Qt.Key.Key_Escape)
    drop(made, "condition", QPointF(640, 420))
    assert made.said == ["Drop a condition on the situation that it is of"]


def test_what_is_typed_into_the_fields_of_a_test_is_kept_from_being_wrong(made: Any) -> None:
    made.canvas.edit_test(("situation", "called", "condition", "0"))
    box = made.canvas.test_editor.box
    box.tag.selectAll()
    made.hand.type(box.tag, "Not A Tag!")
    QTest.keyClick(box.tag, Qt.Key.Key_Return)
    assert made.edits == []
    assert len(made.said) == 1
    assert box.tag.text() == "calling"
    assert made.canvas.test_editor is not None
    QTest.keyClick(box.tag, Qt.Key.Key_Return)
    assert made.canvas.test_editor is None


@pytest.mark.parametrize(
    ("kind", "typed_in", "taken"),
    [
        ("number", "7,5", ["7.5"]),
        ("number", "warm", []),
        ("number", "{most}", ["{most}"]),
        ("text", "08:00", ["08:00"]),
        (None, "08:00", ["08:00"]),
    ],
)
def test_what_an_order_compares_with_is_what_its_data_can_be(
    made: Any, kind: DataType | None, typed_in: str, taken: list[str]
) -> None:
    """Texts have an order too, and where a state tests, one value goes by another."""
    box = TestBox(made.canvas.look.theme, made.canvas)
    told: list[str] = []
    box.changed.connect(lambda test: told.append(test.value))
    box.show_test(Question("heat", "above", "1"), Vocabulary(data=(("heat", kind, ""),)))
    box.show()
    box.value.selectAll()
    made.hand.type(box.value, typed_in)
    QTest.keyClick(box.value, Qt.Key.Key_Return)
    assert told == taken


@pytest.mark.parametrize("kind", ["boolean", "number", "text", None])
@pytest.mark.parametrize(("value", "wanted"), [("true", "0"), ("false", "0"), ("{most}", "{most}")])
def test_an_order_of_yes_and_no_is_never_written(
    made: Any, kind: DataType | None, value: str, wanted: str
) -> None:
    """Who asks whether a yes is above something gets a value that has an order."""
    box = TestBox(made.canvas.look.theme, made.canvas)
    told: list[Question] = []
    box.changed.connect(told.append)
    box.show_test(Question("heat", "is", value), Vocabulary(data=(("heat", kind, ""),)))
    box.show()
    box.test.setFocus()
    while box.test.currentText() != "above":
        QTest.keyClick(box.test, Qt.Key.Key_Down)
    assert (told[-1].test, told[-1].value) == ("above", wanted)


# -- heard --------------------------------------------------------------------------------------


def heard(part: Any) -> list[tuple[str, str]]:
    found = []
    for index in range(part.childCount()):
        one = part.child(index)
        found.append((one.text(NAME), one.text(DESCRIPTION)))
        found += [(f"  {name}", told) for name, told in heard(one)]
    return found


def test_nodes_are_heard_in_the_order_of_reading_with_their_pipes(made: Any) -> None:
    place = ("situation", "rest", "entry", "0")
    tie = Problem(file="x", severity="warning", code="tie", message="t", place=place)
    made.canvas.show_document(made.document, [tie])
    told = "calling is true; heat above 30; calling is true"
    held = "while calling is true and heat above 30 and calling is true"
    assert heard(tree(made.canvas)) == [
        ("heat", "data; number; looked at in hot"),
        ("calling", "data; yes or no; looked at in hot, called"),
        ("Condition of hot", f"condition; all of these; {told}"),
        ("  calling is true", "test of hot"),
        ("  heat above 30", "test of hot"),
        ("  calling is true", "test of hot"),
        ("hot", f"situation; number 1; stays 2 s at least; {held}"),
        ("Condition of called", "condition; calling is true"),
        ("  calling is true", "test of called"),
        ("called", "situation; number 2; extends rest; while calling is true"),
        ("  priority 20 for nod", "taken over from rest"),
        ("  priority 10 for talk", "taken over from rest"),
        ("rest", "situation; number 3; always; priority 20 for nod; priority 10 for talk"),
        ("  priority 20 for nod", "priority in rest; with a warning; t"),
        ("  priority 10 for talk", "priority in rest"),
        ("nod", "module; in rest"),
        ("  uses head", "resource of nod"),
        ("talk", "module; in rest"),
        ("  uses speech", "resource of talk"),
        ("head", "resource; used by nod"),
        ("speech", "resource; used by talk"),
    ]


def test_a_press_by_a_screen_reader_selects_the_pipe(made: Any) -> None:
    drawing = tree(made.canvas)
    rest = next(
        drawing.child(i)
        for i in range(drawing.childCount())
        if drawing.child(i).text(NAME) == "rest"
    )
    action = rest.child(1).interface_cast(QAccessible.InterfaceType.ActionInterface)
    action.doAction(action.setFocusAction())
    assert made.canvas.selection() == (("situation", "rest", "entry", "1"),)
    assert rest.child(1).state().focused or not made.canvas.viewer.hasFocus()


# -- seen ---------------------------------------------------------------------------------------


def test_of_a_tie_both_priorities_are_marked(made: Any) -> None:
    script = made.document
    nod, talk = script.situations[2].entries
    for resources, marks in (((("head",), ("head",)), "both"), ((("head",), ("speech",)), "one")):
        after = replace(
            script,
            modules=tuple(
                replace(m, resources=r) for m, r in zip(script.modules, resources, strict=True)
            ),
            situations=(
                *script.situations[:2],
                replace(script.situations[2], entries=(nod, replace(talk, priority=20))),
            ),
        )
        place = ("situation", "rest", "entry", "0")
        told = Problem(file="x", severity="warning", code="tie", message="t", place=place)
        made.canvas.show_document(after, [told])
        other = pipe(made, "situation rest", "module talk").link
        assert pipe(made, "situation rest", "module nod").link.mark == "warning"
        assert other.mark == ("warning" if marks == "both" else "")
        assert other.priority == 20


def corner(made: Any) -> QImage:
    """What the upper right corner of the situation rest looks like, selected as it is."""
    card = made.hand.card("situation rest")
    spot = made.hand.pixel(card.scenePos() + QPointF(card.face.width - 9, 2))
    image: QImage = made.hand.port.grab().toImage()
    return image.copy(spot.x(), spot.y(), 7, 7)


def test_a_note_is_seen_told_where_the_mouse_rests_and_to_those_who_hear(
    made: Any, farthest: Callable[..., int]
) -> None:
    made.canvas.select([("situation", "rest")])
    made.hand.settle()
    before = corner(made)
    made.canvas.edit_note()
    made.hand.type(made.canvas.field_editor, "Nothing else is going on")
    QTest.keyClick(made.canvas.field_editor, Qt.Key.Key_Return)
    assert made.edits == ["Change a note"]
    assert farthest(corner(made), before) > 60
    assert made.hand.card("situation rest").toolTip().endswith("Note: Nothing else is going on")
    (told,) = [told for name, told in heard(tree(made.canvas)) if name == "rest"]
    said = "situation; number 3; always; Note: Nothing else is going on"
    assert told == f"{said}; priority 20 for nod; priority 10 for talk"
    made.undo()
    assert "Note" not in made.hand.card("situation rest").toolTip()


def test_headings_stay_above_their_columns(made: Any) -> None:
    """However far the drawing is scrolled, and as far as there is room for them."""
    canvas = made.canvas
    for top, zoom in ((0.0, 1.0), (900.0, 1.0), (300.0, 0.5)):
        canvas.look_at((zoom, 0.0, top))
        areas = canvas.headings.areas()
        assert list(areas) == ["data", "condition", "situation", "module", "resource"]
        assert canvas.headings.geometry().topLeft() == QPoint()
        for kind, area in areas.items():
            card = next(c for c in canvas.graph.cards.values() if c.kind == kind)
            assert abs(canvas.viewer.mapFromScene(QPointF(card.x, top)).x() - area.left()) <= 1
        edges = [(area.left(), area.right()) for area in areas.values()]
        assert all(one[1] < two[0] for one, two in pairwise(edges))
    canvas.look_at((0.1, 0.0, 0.0))
    assert canvas.headings.areas() == {}


def test_names_stay_readable_in_a_small_drawing(made: Any) -> None:
    """11 px on the screen at least, from 40 to 75 % (tokens.md)."""
    item = made.hand.card("data calling")
    for zoom in (0.41, 0.5, 0.74):
        made.canvas.set_zoom(zoom)
        made.canvas.viewer.grab()
        assert item._short_pixels * zoom > 10.7
