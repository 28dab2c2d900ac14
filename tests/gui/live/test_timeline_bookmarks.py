"""Bookmarks of a run: made at the cursor, kept beside the recording, found by key and hand."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from tests.gui.live.test_recordings import until_shown
from tests.gui.live.test_timeline import LEFT, place, shown

from situ.errors import UsageError
from situ_studio.live.timeline.bookmarks import Bookmark, Bookmarks, beside


def entries(timeline: Any) -> dict[str, Any]:
    menu = timeline.marking.menu
    menu.aboutToShow.emit()
    return {action.text(): action for action in menu.actions() if action.text()}


def test_a_bookmark_has_a_name_is_found_again_and_outlasts_the_window(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    file = tmp_path / "run.mcap"
    it, timeline = shown(studio, project("conversation"), file, "conversation", "fig5.jsonl")
    chart, viewing = timeline.chart, it.window.robot.follower.viewing
    timeline.setFocus()
    for t, name in ((4.0, "it nods & waits"), (9.0, "a slap")):
        viewing.seek(t)
        it.answers.put("name", name)
        it.key(Qt.Key.Key_B)
    kept = [Bookmark(4.0, "it nods & waits"), Bookmark(9.0, "a slap")]
    assert timeline.bookmarks.every == kept
    # By key from one to another, by its flag, and from the menu.
    it.key(Qt.Key.Key_PageUp)
    assert viewing.t == 4.0
    it.key(Qt.Key.Key_PageUp)
    assert viewing.t == 4.0
    it.key(Qt.Key.Key_PageDown)
    assert viewing.t == 9.0
    QTest.mouseClick(chart.viewport(), LEFT, pos=place(chart, 4.0, 10) + QPoint(20, 0))
    assert viewing.t == 4.0
    names = list(entries(timeline))
    assert names[-2].endswith("it nods && waits")
    entries(timeline)[names[-1]].trigger()
    assert viewing.t == 9.0
    # Nobody wanted a name: there is none.
    it.answers.put("name", None)
    it.key(Qt.Key.Key_B)
    assert timeline.bookmarks.every == kept
    # Another run has its own; this one has them again when it is opened again.
    it.window.commands.close_recording()
    assert timeline.bookmarks.every == []
    it.answers.put("recording", file)
    it.window.commands.open_recording()
    until_shown(it)
    assert timeline.bookmarks.every == kept
    viewing.seek(9.0)
    entries(timeline)[timeline.tr("Remove the bookmark here")].trigger()
    again = Bookmarks()
    again.open(beside(file))
    assert again.every == kept[:1]


def test_bookmarks_that_can_not_be_read_are_told_and_left_as_they_are(tmp_path: Path) -> None:
    file = tmp_path / "run.mcap.bookmarks.json"
    file.write_text("not ours")
    bookmarks = Bookmarks()
    with pytest.raises(UsageError, match="bookmarks"):
        bookmarks.open(file)
    bookmarks.add(1.0, "seen all the same")
    assert bookmarks.at(1.0) is not None
    assert file.read_text() == "not ours"


def test_what_can_not_be_kept_is_told_and_seen_all_the_same(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    file = tmp_path / "run.mcap"
    it, timeline = shown(studio, project("conversation"), file, "conversation", "fig5.jsonl")
    # A folder of that name stands in the way.
    beside(file).mkdir()
    timeline.setFocus()
    it.answers.put("name", "here")
    it.key(Qt.Key.Key_B)
    assert beside(file).name in it.answers.told[-1]
    assert [mark.name for mark in timeline.bookmarks.every] == ["here"]
