"""The status bar's part about the link: to where, as whom, how much comes; more at a click."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from msgspec import UNSET
from msgspec.structs import replace
from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtTest import QTest
from tests.gui.live.test_link import connect
from tests.gui.live.test_recordings import opened

import situ
from situ_studio.live.link_status import OVER, Rate
from situ_studio.looks.letters import px
from situ_studio.window.status import SLACK


def test_events_are_counted_over_the_last_seconds_alone() -> None:
    rate = Rate()
    assert rate.at(0.0) == 0.0
    rate.add(10.0, 30)
    rate.add(10.5, 10)
    assert rate.at(10.5) == 40 / OVER
    assert rate.at(10.2 + OVER) == 10 / OVER
    assert rate.at(11.0 + OVER) == 0.0


def test_the_status_bar_tells_of_the_link_and_the_rest_at_a_click(
    studio: Callable[..., Any],
    project: Callable[[str], Path],
    robot: Any,
    until: Any,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    where = project("conversation")
    there = robot(where)
    script = where / "conversation.spds.xml"
    text = script.read_text(encoding="utf-8").replace('priority="60"', 'priority="65"')
    script.write_text(text, encoding="utf-8")
    it = studio(where)
    status = it.window.link_status
    assert not status.button.isVisible()
    assert not status.right.isVisible()
    link = connect(it, there.endpoint, until)
    until(link.documents_came, lambda: link.files is not None)
    until(link.moment_changed, lambda: status.version is not None)
    assert status.button.isVisible()
    assert status.right.isVisible()
    assert status.button.text() == f"{there.endpoint}, operator"
    assert status.rate.text().endswith(" events/s")
    # Nothing was deployed to it.
    assert status.version == 0
    assert not status.version_label.isVisible()
    # By the keyboard, and away again.
    status.button.setFocus()
    it.key(Qt.Key.Key_Space)
    assert status.popup.isVisible()
    facts = dict(status.facts())
    assert facts["Address"] == there.endpoint
    assert facts["Project"] == "conversation"
    assert facts["You are"].startswith("operator")
    assert facts["It runs"] == "the project that it was started with"
    assert facts["Its Situ"] == f"{situ.__version__}, as here"
    assert facts["Its documents"] == "differ from these here: conversation.spds.xml"
    shown = [value.text() for value in status.popup._values]
    assert facts["Its documents"] in shown
    assert facts["Its Situ"] in shown
    # Of another version than the editor, and of a robot from before it was told.
    monkeypatch.setattr("situ_studio.live.link_status.__version__", "9.0")
    assert dict(status.facts())["Its Situ"] == f"{situ.__version__}; here it is 9.0"
    dialog = link._link.dialog
    monkeypatch.setattr(dialog, "welcome", replace(dialog.welcome, situ=UNSET))
    assert dict(status.facts())["Its Situ"] == "not told; an older one"
    QTest.keyClick(status.popup, Qt.Key.Key_Escape)
    assert not status.popup.isVisible()
    # What is lost is told as far as it is known.
    there.kill()
    until(link.state_changed, lambda: link.state.kind == "lost")
    assert not status.right.isVisible()
    assert status.button.text() == there.endpoint
    assert [name for name, _ in status.facts()] == ["Address", "Project", "Link"]
    it.window.robot.disconnect_robot()
    assert not status.button.isVisible()


class Laid(QObject):
    """Counts how often something is laid out anew."""

    def __init__(self) -> None:
        super().__init__()
        self.count = 0

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        self.count += event.type() == QEvent.Type.LayoutRequest
        return False


def test_what_the_link_is_has_room_and_the_bar_is_not_laid_out_for_each_moment_of_a_scrub(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    it, _ = opened(
        studio, project("conversation"), tmp_path / "run.mcap", "conversation", "fig5.jsonl"
    )
    label, viewing = it.window.status.link, it.window.robot.follower.viewing
    said, laid = set(), Laid()
    viewing.seek(3.0)
    it.settle()
    it.window.status.installEventFilter(laid)
    for tenths in range(30, 60):
        viewing.seek(tenths / 10)
        it.settle()
        said.add(label.text())
        assert label.width() >= label.sizeHint().width()
    assert len(said) > 2
    assert laid.count == 0
    # Other words have the room that they need, bold ones too, and no more of it.
    for live in ("true", "lost", ""):
        for words in ("live, 12 ms behind, differs here", "no robot"):
            it.window.status.show_link("link", words, live)
            it.settle()
            assert 0 <= label.width() - label.sizeHint().width() <= px(SLACK)
    it.window.commands.close_recording()


def test_whatever_is_said_of_a_robot_what_is_saved_is_never_pushed_out_of_the_window(
    studio: Callable[..., Any], project: Callable[[str], Path]
) -> None:
    it = studio(project("conversation"))
    status, window = it.window.status, it.window

    def end() -> int:
        return int(status.saved.mapTo(window, status.saved.rect().topRight()).x())

    counts = status.counts.width()
    assert counts >= status.counts.sizeHint().width()
    for words in ("live, 0 ms behind, its clock is 5 min ahead, differs here", "no robot"):
        status.show_link("link", words, "true")
        window.operating.waiting.setText("converse is paused at 2 sleep, at breakpoint 1, " * 5)
        window.operating.waiting.show()
        status.say("nothing waits in converse: raise an event, or let it go on")
        it.settle()
        assert end() < window.width()
        assert status.saved.width() >= status.saved.sizeHint().width()
        assert status.link.width() >= status.link.sizeHint().width()
    # Who can not read it all has it in a tip.
    assert window.operating.waiting.toolTip() == window.operating.waiting.text()
    window.operating.waiting.hide()
    it.settle()
    assert status.counts.width() == counts
