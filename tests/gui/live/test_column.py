"""The column beside the drawing: the robot at the moment of the cursor, whatever it is of."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from msgspec import structs
from PySide6.QtCore import QPoint, QRect, QRectF, Qt
from PySide6.QtGui import QAccessible, QContextMenuEvent, QFontMetrics, QImage, QPainter
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from tests.gui.live.test_link import connect
from tests.gui.live.test_recordings import opened, until_shown

import situ
from situ.document import condition
from situ.document.spds import Observed, Situation, Spds
from situ_studio.live import column_list
from situ_studio.live.column import MomentColumn
from situ_studio.live.column_list import EDGE, ROW, ColumnDelegate
from situ_studio.live.column_rows import ColumnRow, PartTold, Telling
from situ_studio.live.column_words import Lettering
from situ_studio.live.moment import Entry, Moment
from situ_studio.looks.letters import px
from situ_studio.looks.theme import CAPTION, LABEL

LEFT = Qt.MouseButton.LeftButton
DRAWING = ("project", "outline", "palette")
SCRIPT = "conversation.spds.xml"


def rows(kind: Any) -> dict[str, tuple[str, str]]:
    """Name to value, and what stands behind it, of a list's rows."""
    told = [kind.rows.row(place) for place in range(len(kind.rows.names))]
    return {row.name: (row.value, row.after) for row in told}


def drawing_is_seen(it: Any) -> set[bool]:
    return {it.window.docks[name].isVisible() for name in DRAWING}


@pytest.fixture
def looked(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> tuple[Any, MomentColumn]:
    """A recorded conversation, and the column that shows it."""
    it, _ = opened(
        studio, project("conversation"), tmp_path / "run.mcap", "conversation", "fig5.jsonl"
    )
    it.window.resize(1280, 800)
    it.settle()
    return it, it.window.moment.column


@pytest.fixture
def at(looked: tuple[Any, MomentColumn]) -> Callable[[float], None]:
    """``at(t)``: the column shows that moment."""
    it, column = looked

    def go(t: float) -> None:
        it.window.robot.follower.viewing.seek(t)
        column.draw()
        it.settle()

    return go


def test_it_shows_the_moment_of_the_cursor_in_place_of_what_one_draws_with(
    looked: tuple[Any, MomentColumn], at: Callable[[float], None]
) -> None:
    it, column = looked
    assert column.isVisible()
    assert drawing_is_seen(it) == {False}
    # It takes their room, and none of the inspector's.
    assert it.window.docks["inspector"].isVisible()
    at(4.2)
    assert column.card.name.words == "accepted"
    assert column.card.place.words == "5th of 6"
    assert column.since.words == "since 0.2 s"
    assert rows(column.states)["converse"][0].startswith("2 ")
    held = rows(column.resources)
    assert held["head"] == ("nod", "40")
    assert held["screen"] == ("converse", "30")
    assert held["base"] == ("nobody", "")
    # What the situation rests on goes first and stands out; each number has its unit.
    first = column.data.rows.row(0)
    assert (first.name, first.value, first.lit, first.fresh) == (
        "speech.acceptable",
        "true",
        True,
        True,
    )
    assert rows(column.data)["face.direction"][0] == "12°"
    assert rows(column.data)["hand.waving"][0] == "not set"
    # Back where the nod has not been asked for.
    at(3.0)
    assert column.card.name.words == "conversation"
    assert rows(column.resources)["head"] == ("chase-face", "20")
    assert not column.data.rows.row(0).lit
    # Without a robot, a recording or a rehearsal everything is as it was.
    it.window.robot.close_recording()
    it.settle()
    assert not column.isVisible()
    assert drawing_is_seen(it) == {True}


def test_a_situation_that_goes_on_though_its_condition_does_not_hold_tells_why(
    looked: tuple[Any, MomentColumn], at: Callable[[float], None]
) -> None:
    _, column = looked
    at(4.2)
    part = column.card.parts[0].told
    assert part is not None
    assert (part.words, part.holds) == ("speech.acceptable is true", True)
    assert column.card.kept.isHidden()
    at(5.1)
    assert column.card.name.words == "accepted"
    part = column.card.parts[0].told
    assert part is not None
    assert part.holds is False
    assert column.card.kept.words == "stays 1.2 s at least"


@pytest.mark.parametrize(
    ("hidden", "words", "holds"),
    [
        ("true true", "and 2 more", True),
        ("true known-later", "and 2 more", None),
        ("false known-later", "and 2 more, 1 does not hold", False),
        ("true false known-later", "and 3 more, 1 does not hold", False),
        ("false true false", "and 3 more, 2 do not hold", False),
    ],
)
def test_of_tests_without_room_it_is_told_what_is_known(
    hidden: str, words: str, holds: bool | None
) -> None:
    """hidden: what those are, behind three that hold; a ``for`` is known from no moment alone."""
    every = [*["true"] * 3, *hidden.split()]
    tests = tuple(
        condition.Test(f"tag{n}", "is", "true", hold=2.0 if one == "known-later" else None)
        for n, one in enumerate(every)
    )
    situation = Situation("here", condition=condition.Condition(tests))
    moment = Moment()
    moment.situation = "here"
    moment.board = {f"tag{n}": Entry(one != "false", "eyes", 0.0) for n, one in enumerate(every)}
    told = Telling(Spds("script", situations=(situation,))).situation(moment, 1.0)
    assert told is not None
    assert [part.holds for part in told.parts[:3]] == [True] * 3
    assert told.parts[3:] == (PartTold(words, holds),)


def test_what_nobody_has_set_stands_last_and_comes_up_once_it_is_a_field_of_what_is_set() -> None:
    observed = tuple(Observed(tag, "number") for tag in ("person.age", "slap", "far"))
    rests = condition.Condition((condition.Test("far", "above", "3"),))
    situation = Situation("here", condition=rests)
    telling = Telling(Spds("script", observe=observed, situations=(situation,)))
    moment = Moment()
    assert telling.tags(moment) == ["person.age", "slap", "far"]
    moment.situation = "here"
    moment.board = {"person": Entry({}, "eyes", 0.0), "slap": Entry(2, "skin", 0.0)}
    assert telling.tags(moment) == ["far", "slap", "person", "person.age"]
    moment.board["person"] = Entry({"age": 41}, "eyes", 1.0)
    assert telling.tags(moment) == ["far", "person.age", "slap", "person"]
    moment.board["person"] = Entry({}, "eyes", 2.0)
    assert telling.tags(moment) == ["far", "slap", "person", "person.age"]


def test_the_name_of_the_situation_and_of_a_state_go_before_what_stands_beside_them(
    looked: tuple[Any, MomentColumn], at: Callable[[float], None]
) -> None:
    it, column = looked
    at(1.0)
    name, place = column.card.name, column.card.place
    assert name.words == "conversation"
    # In smaller letters it fits, though not in its own.
    assert name._needs(name._fonts[0]) > name.width() >= name._needs(name._fonts[1])
    assert place._needs(place._fonts[0]) <= place.width()

    def drawn(since: str) -> QImage:
        row = ColumnRow("state", "converse", "converse", "6 goodbye now", since, "live")
        image = QImage(200, px(ROW), QImage.Format.Format_RGB32)
        image.fill(it.window.theme.color("panel"))
        painter = QPainter(image)
        ColumnDelegate(it.window.theme, column.states)._row(painter, QRectF(image.rect()), row)
        painter.end()
        return image

    assert drawn("13 s") == drawn("")


def test_a_name_and_a_value_that_have_room_beside_each_other_are_not_cut(
    looked: tuple[Any, MomentColumn], monkeypatch: pytest.MonkeyPatch
) -> None:
    it, column = looked
    cut: list[str] = []

    def cut_words(_: QFontMetrics, words: str, room: float) -> str:
        cut.append(words)
        return words

    monkeypatch.setattr(column_list, "_cut", cut_words)
    plain, strong, small = Lettering(LABEL), Lettering(LABEL, 600), Lettering(CAPTION)
    delegate = ColumnDelegate(it.window.theme, column.data)

    def drawn(row: ColumnRow, wide: int) -> QImage:
        image = QImage(wide, ROW, QImage.Format.Format_RGB32)
        image.fill(it.window.theme.color("panel"))
        painter = QPainter(image)
        delegate._row(painter, QRectF(image.rect()), row)
        painter.end()
        return image

    name, value, since = "blood-pressure", "“otherwise”", "1 s"
    datum = ColumnRow("data", name, name, value, since)
    parts = plain.advance(name), strong.advance(value), small.advance(since)
    wide = 2 * EDGE + sum(parts) + 2 * 8
    drawn(datum, wide)
    assert cut == []
    drawn(datum, wide - 1)
    assert cut == [value]

    # Where a state has no room, its own name is cut, not the application's.
    state = ColumnRow("state", name, name, "2 measuring", pill="live")
    wide = 2 * EDGE + 22 + int((plain.advance(name) + 8) / 0.58)
    words = QRect(EDGE, 0, 22 + plain.advance(name), ROW)
    whole, beside = drawn(state, wide), drawn(structs.replace(state, value="2"), wide)
    assert cut == [value, "2 measuring"]
    assert whole.copy(words) == beside.copy(words)


def test_hands_and_keys_go_to_what_a_row_is_about(
    looked: tuple[Any, MomentColumn], at: Callable[[float], None]
) -> None:
    it, column = looked
    window = it.window
    at(4.2)
    it.click(column.card)
    assert (window.current_file, window.current_view.selected) == (
        SCRIPT,
        (("situation", "accepted"),),
    )
    it.click_row(column.states, column.states.rows.index(0))
    assert window.current_view.selected == (("state", "2"),)
    head = column.resources.rows.names.index("head")
    it.click_row(column.resources, column.resources.rows.index(head))
    assert window.current_view.selected == (("module", "nod"),)
    # By the keyboard: to the list, to the row, there.
    column.data.setFocus(Qt.FocusReason.TabFocusReason)
    assert column.data.current_name == "speech.acceptable"
    it.key(Qt.Key.Key_Return)
    board = window.robot.blackboard
    assert board.isVisible()
    assert board.rows.rows[board.currentIndex().row()].key == "speech.acceptable"
    assert board.hasFocus()
    # What is not set stands in the script alone.
    column.data.setCurrentIndex(column.data.rows.index(column.data.rows.names.index("robot.stop")))
    column.data.setFocus()
    it.key(Qt.Key.Key_Return)
    assert window.current_view.selected == (("data", "robot.stop"),)


def test_why_is_a_button_a_key_and_a_menu_at_every_row(
    looked: tuple[Any, MomentColumn], at: Callable[[float], None]
) -> None:
    it, column = looked
    why = it.window.why
    at(4.2)
    # The button comes where the hand is.
    rect = column.resources.visualRect(
        column.resources.rows.index(column.resources.rows.names.index("head"))
    )
    QTest.mouseMove(column.resources.viewport(), rect.center())
    assert column.resources.why.isVisible()
    it.click(column.resources.why)
    assert "nod" in why.panel.title.text()
    assert "head" in why.panel.title.text()
    # The command is about the row that has the keyboard.
    column.data.setFocus(Qt.FocusReason.TabFocusReason)
    it.window.why.ask()
    assert "speech.acceptable" in why.panel.title.text()
    # The menu has the questions why not, too.
    reason = QContextMenuEvent.Reason.Keyboard
    QApplication.sendEvent(column.card, QContextMenuEvent(reason, QPoint(), QPoint()))
    asked = [action.text() for action in why.menus.shown.actions()]
    assert "Why?" in asked
    assert "Why is invited not the situation?" in asked
    why.menus.shown.close()


def test_who_closes_it_has_the_palette_back_and_is_not_asked_again(
    looked: tuple[Any, MomentColumn], tmp_path: Path
) -> None:
    it, column = looked
    window = it.window
    it.click(column.back)
    assert not column.isVisible()
    assert drawing_is_seen(it) == {True}
    window.robot.close_recording()
    window.robot.open_recording(tmp_path / "run.mcap")
    until_shown(it)
    assert not column.isVisible()
    # The menu of panels brings it back; of a rehearsal it is another matter.
    action = window.docks["moment"].toggleViewAction()
    assert action.isEnabled()
    action.trigger()
    assert column.isVisible()
    assert drawing_is_seen(it) == {False}
    window.robot.close_recording()
    assert not action.isEnabled()


def test_dragged_elsewhere_it_stands_there_and_the_palette_at_the_left(
    looked: tuple[Any, MomentColumn], at: Callable[[float], None]
) -> None:
    it, column = looked
    dock = it.window.docks["moment"]
    dock.setFloating(True)
    it.settle()
    assert column.isVisible()
    assert drawing_is_seen(it) == {True}
    at(4.2)
    assert column.card.name.words == "accepted"
    dock.setFloating(False)
    it.settle()
    assert column.isVisible()
    assert drawing_is_seen(it) == {False}


def test_a_screen_designer_goes_before_it(looked: tuple[Any, MomentColumn]) -> None:
    it, column = looked
    window = it.window
    window.open_file("converse.rbd.xml")
    window.select(("state", "1"))
    window.show_mode("screen")
    it.settle()
    assert not column.isVisible()
    assert window.docks["designer"].isVisible()
    window.show_mode("graph")
    it.settle()
    assert column.isVisible()
    assert drawing_is_seen(it) == {False}


def test_rows_are_reused_and_nothing_is_drawn_that_nobody_sees(
    looked: tuple[Any, MomentColumn], at: Callable[[float], None], monkeypatch: Any
) -> None:
    it, column = looked
    at(3.0)
    reset: list[int] = []
    changed: list[int] = []
    column.data.rows.modelReset.connect(lambda: reset.append(1))
    column.data.rows.dataChanged.connect(lambda first, last: changed.append(first.row()))
    told = {row: column.data.rows.row(row) for row in range(4)}
    at(3.0001)
    assert not reset
    assert not [row for row in changed if column.data.rows.row(row) == told.get(row)]
    drawn: list[float] = []
    monkeypatch.setattr(column, "draw", lambda: drawn.append(1))
    it.window.docks["moment"].close()
    it.window.robot.follower.viewing.seek(5.0)
    it.settle()
    assert drawn == []


def test_a_row_that_says_the_same_as_before_is_not_drawn_again(
    looked: tuple[Any, MomentColumn], at: Callable[[float], None], monkeypatch: Any
) -> None:
    _, column = looked
    drawn: set[str] = set()
    paint = ColumnDelegate._row

    def painted(self: Any, painter: Any, rect: Any, row: Any) -> None:
        drawn.add(row.name)
        paint(self, painter, rect, row)

    monkeypatch.setattr(ColumnDelegate, "_row", painted)
    at(4.2)
    before = [column.data.rows.row(place) for place in range(len(column.data.rows.names))]
    assert drawn
    drawn.clear()
    at(4.4)
    after = [column.data.rows.row(place) for place in range(len(column.data.rows.names))]
    same = [was == now for was, now in zip(before, after, strict=True)]
    # Not even one between two that have changed.
    assert True in same[same.index(False) :]
    assert drawn & {row.name for row in after} == {
        now.name for now, is_same in zip(after, same, strict=True) if not is_same
    }


def test_it_is_read_aloud(looked: tuple[Any, MomentColumn], at: Callable[[float], None]) -> None:
    _, column = looked
    at(4.2)
    card = QAccessible.queryAccessibleInterface(column.card)
    assert card.text(QAccessible.Text.Name) == "Situation accepted, 5th of 6"
    assert card.text(QAccessible.Text.Description) == "speech.acceptable is true: holds"
    listed = QAccessible.queryAccessibleInterface(column.data)
    spoken = listed.child(0).text(QAccessible.Text.Name)
    assert spoken == "speech.acceptable: true, since 0.2 s, the situation rests on it"


def test_of_a_robot_it_goes_on_and_of_what_runs_there_the_script_counts(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    where = project("conversation")
    there = robot(where)
    mine = where / SCRIPT
    text = mine.read_text(encoding="utf-8").replace('priority="60"', 'priority="65"')
    mine.write_text(text, encoding="utf-8")
    it = studio(where)
    column = it.window.moment.column
    link = connect(it, there.endpoint, until)
    until(link.documents_came, lambda: link.files is not None)
    assert column.isVisible()
    with (
        situ.connect(there.endpoint, module="gaze-sound", resources=["head"]) as board,
        board.authority("head"),
    ):
        board.set("sound.slap", 40)
        until(link.moment_changed, lambda: "head" in link.log.now.holders)
        it.window.robot.follower.refresh()
        column.draw()
        assert column.card.name.words == "sound"
        # Not what is drawn here.
        assert it.window.robot.follower.same is False
        assert rows(column.resources)["head"] == ("gaze-sound", "60")
        assert rows(column.data)["sound.slap"][0] == "40°"
    it.window.robot.disconnect_robot()
    assert not column.isVisible()


def test_of_a_rehearsal_it_shows_the_states_where_there_is_no_script(
    studio: Callable[..., Any], project: Callable[[str], Path]
) -> None:
    it = studio(project("reception"))
    it.window.rehearsing.clock = lambda: 0.0
    it.key(Qt.Key.Key_F5)
    column = it.window.moment.column
    assert column.isVisible()
    assert not column.card.isVisible()
    assert rows(column.states)["reception"][0] == "1 start"
    assert rows(column.resources)["screen"] == ("reception", "")
    # Closed for a rehearsal it comes of a robot all the same.
    it.window.docks["moment"].close()
    kept = it.window.settings
    assert kept.value("moment_open/rehearsal", True, bool) is False
    assert kept.value("moment_open/robot", True, bool) is True
