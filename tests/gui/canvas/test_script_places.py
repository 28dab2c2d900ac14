"""Where the cards of a script stand: what is there stays there, whatever is typed and drawn."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest
from tests.gui.canvas.script_desk import agree, body, edit, holds, middle, out, pipe
from tests.gui.canvas.test_script_drawing import scripts

from situ.document.spds import Declaration, Entry, Observed, Situation, Spds
from situ_studio.canvas.script import ScriptCanvas
from situ_studio.canvas.script_projection import ScriptProjector

KEPT = ("data", "module", "resource")


def talk() -> Spds:
    """The first module belongs to the last situation; the last is of none."""
    return Spds(
        name="talk",
        observe=(Observed("slap"), Observed("waving", "boolean"), Observed("unused", "text")),
        modules=(
            Declaration("converse", ("speech",)),
            Declaration("gaze", ("head",)),
            Declaration("transfer", ("base",)),
        ),
        situations=(
            Situation("invited", condition=holds("waving"), entries=(Entry("transfer", 90),)),
            Situation("sound", condition=holds("slap"), entries=(Entry("gaze", 60),)),
            Situation("talking", entries=(Entry("converse", 30),)),
        ),
    )


@pytest.fixture
def made(desk: Callable[..., Any]) -> Any:
    return desk(talk(), ScriptCanvas)


def tops(made: Any) -> dict[str, float]:
    """The cards of the columns that are not in an order of their own."""
    cards = made.canvas.graph.nodes.items()
    return {key: node.view.y() for key, node in cards if key.split()[0] in KEPT}


def test_a_module_that_is_given_a_priority_stays_where_it_is(made: Any) -> None:
    """It is wanted further up from then on, where others stand."""
    before = tops(made)
    assert before["module transfer"] < before["module gaze"] < before["module converse"]
    made.hand.drag(out(made, "situation invited"), middle(made, "module converse"))
    assert made.document.situations[0].entries[-1] == Entry("converse", 100)
    assert tops(made) == before
    made.hand.click(pipe(made, "situation invited", "module converse").pill().center())
    edit(made, "95")
    assert made.document.situations[0].entries[-1] == Entry("converse", 95)
    assert tops(made) == before
    agree(made)


def test_only_situations_move_where_one_is_dragged_to_another_place(made: Any) -> None:
    before = tops(made)
    start = body(made, "situation sound")
    made.hand.drag(start, start - QPointF(0, 150))
    assert [s.name for s in made.document.situations] == ["sound", "invited", "talking"]
    assert tops(made) == before
    agree(made)


def test_what_is_looked_at_and_what_uses_it_stay(made: Any) -> None:
    before = tops(made)
    made.hand.drag(out(made, "data unused"), body(made, "situation invited"))
    made.hand.drag(out(made, "module converse"), middle(made, "resource base"))
    assert made.edits == ["Let invited look at unused", "Let converse use base"]
    assert tops(made) == before
    agree(made)


def test_a_card_with_another_name_stays(made: Any) -> None:
    at = tops(made)["module gaze"]
    made.hand.double_click(body(made, "module gaze"))
    made.hand.type(made.canvas._editor, "look")
    QTest.keyClick(made.canvas._editor, Qt.Key.Key_Return)
    made.hand.settle()
    assert tops(made)["module look"] == at
    made.undo()
    assert tops(made)["module gaze"] == at
    agree(made)


def test_a_deleted_card_leaves_its_place_and_comes_back_to_it(made: Any) -> None:
    before = tops(made)
    made.canvas.select([("module", "gaze")])
    made.hand.key(Qt.Key.Key_Delete)
    # Nothing but it used the head.
    assert tops(made).keys() == before.keys() - {"module gaze", "resource head"}
    assert tops(made).items() <= before.items()
    made.undo()
    assert tops(made) == before
    agree(made)


def test_a_new_card_goes_to_the_free_place_nearest_to_what_it_belongs_to(made: Any) -> None:
    before = tops(made)
    made.canvas.select([("module", "gaze")])
    made.hand.key(Qt.Key.Key_Delete)
    made.hand.drag(out(made, "situation sound"), QPointF(1000, 500))
    made.hand.type(made.canvas.menu.field, "nod")
    QTest.keyClick(made.canvas.menu.field, Qt.Key.Key_Return)
    made.hand.settle()
    assert tops(made)["module nod"] == before["module gaze"]
    made.canvas.add_module()
    last = max(before.values())
    assert tops(made)["module module"] > before["module converse"]
    made.canvas.add_data()
    assert tops(made)["data data"] == before["data unused"] + 72 <= last + 72
    agree(made)


def test_while_a_situation_is_dragged_a_line_shows_where_it_will_stand(made: Any) -> None:
    told: list[str] = []
    made.canvas.status.connect(told.append)
    start, landing = body(made, "situation sound"), made.canvas.landing
    made.hand.press(start)
    for down in (-20, -60, -110):
        made.hand.move(start + QPointF(0, down))
        made.hand.settle()
    assert landing.number == 1
    assert told[-1] == "sound becomes number 1"
    (line,) = (i for i in made.canvas.viewer.scene().items() if i is landing._line)
    area = line.path().boundingRect()
    cards = made.canvas.graph.cards
    assert area.bottom() < cards["situation invited"].y
    assert area.left() < cards["situation sound"].x
    assert area.right() > cards["situation sound"].x + cards["situation sound"].width
    # Back where it was it stays what it is.
    made.hand.move(start + QPointF(0, -4))
    made.hand.settle()
    assert (landing.number, told[-1]) == (0, "")
    assert line.path().isEmpty()
    made.hand.move(start + QPointF(0, -110))
    made.hand.settle()
    made.hand.release(start + QPointF(0, -110))
    assert made.edits == ["Move sound to place 1"]
    assert (landing.number, told[-1]) == (0, "")
    assert line.path().isEmpty()
    agree(made)


def test_a_drag_of_a_situation_that_is_given_up_leaves_no_line(made: Any) -> None:
    start = body(made, "situation sound")
    made.hand.press(start)
    for down in (-20, -110):
        made.hand.move(start + QPointF(0, down))
        made.hand.settle()
    assert made.canvas.landing.number == 1
    made.hand.key(Qt.Key.Key_Escape)
    assert made.canvas.landing.number == 0
    made.hand.release(start)
    assert made.edits == []
    agree(made)


def test_arranged_by_itself_each_card_stands_near_what_it_belongs_to_again(made: Any) -> None:
    made.hand.drag(out(made, "situation invited"), middle(made, "module converse"))
    made.hand.drag(out(made, "situation talking"), middle(made, "module transfer"))
    document, edits = made.document, list(made.edits)
    made.canvas.auto_layout()
    wanted = {key: card.y for key, card in ScriptProjector().picture(document).cards.items()}
    assert tops(made) == {key: y for key, y in wanted.items() if key.split()[0] in KEPT}
    assert (made.document, made.edits) == (document, edits)
    agree(made)


@settings(max_examples=20, deadline=None)
@given(st.lists(scripts(), min_size=2, max_size=3))
def test_whatever_becomes_of_a_script_its_cards_stay_and_none_lies_on_another(
    several: list[Spds],
) -> None:
    projector = ScriptProjector()
    before: dict[str, Any] = {}
    for script in several:
        drawn = projector.picture(script)
        for one, other in combinations(drawn.cards.values(), 2):
            beside = one.x + one.width <= other.x or other.x + other.width <= one.x
            assert beside or one.y + one.height <= other.y or other.y + other.height <= one.y
        for key, card in drawn.cards.items():
            if key in before and card.kind in KEPT:
                assert card.y == before[key].y
        before = drawn.cards


@settings(max_examples=20, deadline=None)
@given(scripts(), st.data())
def test_what_an_edit_leaves_is_the_same_value_in_the_picture(
    script: Spds, data: st.DataObject
) -> None:
    """So it is not shown anew; and what it does not leave is as it is drawn afresh."""
    projector = ScriptProjector()
    before = projector.picture(script)
    at = data.draw(st.integers(0, len(script.situations) - 1))
    other = replace(script.situations[at], entries=(Entry("m0", 7),))
    situations = (*script.situations[:at], other, *script.situations[at + 1 :])
    after = replace(script, situations=situations)
    drawn = projector.picture(after)
    afresh = ScriptProjector()
    afresh.columns.like(projector.columns)
    assert drawn == afresh.picture(after)
    for key, card in drawn.cards.items():
        assert card is before.cards.get(key) or card != before.cards.get(key)
    for id, link in drawn.links.items():
        assert link is before.links.get(id) or link != before.links.get(id)
