"""The blackboard as a table."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtGui import QImage
from tests.gui.live.test_timeline import shown

from situ.document.names import RESERVED_ROOTS
from situ_studio.live.moment import Entry, Moment
from situ_studio.looks.theme import LIGHT
from situ_studio.looks.theme_qss import qss
from situ_studio.panels.blackboard import Blackboard


def test_the_projects_own_data_stands_before_what_the_runtime_keeps(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    file = tmp_path / "run.mcap"
    it, _ = shown(studio, project("conversation"), file, "conversation", "fig5.jsonl")
    robot = it.window.robot
    viewing = robot.follower.viewing
    # As a robot tells it to who connects.
    stands = {"state": "1", "name": "hello", "suspended": False}
    viewing.log.stand({"application/converse": (stands, "situ", 0.0)})
    it.click(it.window.bottom.button("blackboard"))
    viewing.follow()
    it.settle()
    model = robot.blackboard.model()
    tags = [model.index(n, 0).data() for n in range(model.rowCount())]
    kept = [tag.startswith(RESERVED_ROOTS) for tag in tags]
    assert "sound.slap" in tags
    assert "application/converse" in tags
    assert kept == sorted(kept)
    own = kept.index(True)
    assert tags[:own] == sorted(tags[:own])
    assert tags[own:] == sorted(tags[own:])


def test_records_and_lists_are_told_by_name_and_operators_as_such(qt: Any) -> None:
    board = Blackboard(LIGHT)
    heard = {"text": "Yes please", "confidence": 0.9}
    entries = {"heard": Entry(heard, "operator:ann", 1.0), "names": Entry(["Jo"], None, 1.0)}
    board.show_moment(Moment(board=entries), 31.0)
    # What nobody sees is told once somebody does.
    model = board.model()
    assert model.rowCount() == 0
    board.show()
    assert [model.index(0, column).data() for column in range(4)] == [
        "heard",
        "text: Yes please, confidence: 0.9",
        "operator ann",
        "30 s",
    ]
    tip = model.index(0, 1).data(Qt.ItemDataRole.ToolTipRole)
    assert tip == "heard\ntext: Yes please\nconfidence: 0.9"
    assert model.index(1, 1).data() == "Jo"
    board.deleteLater()


def inked(picture: QImage) -> int:
    """The first px from the left that is not the ground's."""
    ground = picture.pixel(picture.width() - 1, 2)
    return next(
        x
        for x in range(picture.width())
        if any(picture.pixel(x, y) != ground for y in range(4, picture.height() - 4))
    )


def test_a_tables_heads_stand_over_the_words_of_their_columns(qt: Any) -> None:
    board = Blackboard(LIGHT)
    board.setStyleSheet(qss(LIGHT))
    # All begin with letters that have an upright stroke at their left.
    entries = {"Hand": Entry("Hand", "Hand", 1.0)}
    board.rows._titles = ["Hand", "Hand", "Hand", "Hand"]
    board.show_moment(Moment(board=entries), 31.0)
    board.resize(800, 200)
    board.show()
    for column in range(3):
        left, wide = board.columnViewportPosition(column), board.columnWidth(column)
        head = board.horizontalHeader().viewport().grab().toImage()
        cell = board.viewport().grab().toImage()
        over = head.copy(left, 0, wide, board.horizontalHeader().height())
        below = cell.copy(left, 0, wide, board.rowHeight(0))
        assert abs(inked(over) - inked(below)) <= 1
    board.deleteLater()
