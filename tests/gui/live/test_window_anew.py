"""A window that is made anew, for another language or other letters, looks at what it looked at."""

from __future__ import annotations

import signal
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtTest import QSignalSpy
from tests.gui.conftest import PATIENCE
from tests.gui.live.test_comparing import until as compared
from tests.gui.live.test_deploying import connect, rename
from tests.gui.live.test_log import played
from tests.gui.live.test_recordings import recording, until_shown

from situ_studio.live import recordings


def anew(it: Any) -> Any:
    """The window that stands in its place, once it is there."""
    windows, before = it.window.windows, it.window
    gone = QSignalSpy(before.destroyed)
    windows.choose_language("en" if windows.language == "ja" else "ja")
    assert gone.wait(PATIENCE)
    (it.window,) = windows.windows
    it.window.dialogs = it.answers
    it.settle()
    return it.window


def test_a_robot_stays_at_the_moment_that_is_looked_at_and_a_version_on_trial_is_told_of(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    link = connect(it, there.endpoint, until)
    until(link.moment_changed, lambda: link.log.now.t > 0)
    window = it.window
    t = window.robot.follower.viewing.span[1]
    window.robot.timeline.bookmarks.add(t, "here")
    window.robot.follower.viewing.seek(t)
    rename(it, "greeting")
    window.deploying.ask()
    window.deploying.dialog.force.setChecked(True)
    window.deploying.dialog.seconds.setValue(0)
    it.click(window.deploying.dialog.deploy)
    deploying = window.deploying.deploying
    until(deploying.changed, lambda: deploying.is_on_trial)

    window = anew(it)
    assert window.robot.follower.viewing.t == t
    assert [mark.name for mark in window.robot.timeline.bookmarks.every] == ["here"]
    assert window.deploying.deploying is deploying
    dialog = window.deploying.dialog
    assert dialog.isVisible()
    assert dialog.stands.text().startswith("バージョン 1")
    # It goes on being told there, and can be taken back once it is known to what.
    until(deploying.changed, dialog.back.isEnabled)
    it.click(dialog.back)
    until(deploying.changed, lambda: deploying.stands == "running" and deploying.number == 0)
    assert dialog.stands.text().startswith("バージョン 0")
    dialog.close()
    window.robot.follower.viewing.follow()
    anew(it)
    assert it.window.robot.follower.viewing.follows
    assert not it.window.robot.timeline.bookmarks.every[1:]
    it.window.robot.disconnect_robot()


def test_what_the_window_before_asked_of_a_robot_and_hears_of_it_is_no_matter_of_the_next_one(
    studio: Callable[..., Any],
    project: Callable[[str], Path],
    robot: Any,
    until: Any,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    faults: list[BaseException] = []
    monkeypatch.setattr(sys, "excepthook", lambda kind, error, trace: faults.append(error))
    there = robot(project("conversation"))
    it = studio(there.project)
    link = connect(it, there.endpoint, until)
    # It answers only once the window that asked is gone.
    there.process.send_signal(signal.SIGSTOP)
    it.window.operating.raise_event()
    window = anew(it)
    present = window.modules.present
    assert not present.modules
    there.process.send_signal(signal.SIGCONT)
    # What is answered comes after all that was asked before it.
    until(present.changed, lambda: bool(present.modules))
    it.settle()
    assert faults == []
    # Nor what is drawn here, nor what the robot runs, which is heard of again.
    rename(it, "greeting")
    window.robot.disconnect_robot()
    assert connect(it, there.endpoint, until) is link
    it.settle()
    assert faults == []
    window.robot.disconnect_robot()


def test_a_recording_stays_with_what_stands_beside_it_and_what_was_counted(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    where = project("reception")
    it = studio(where)
    files = [
        recording(tmp_path / f"{name}.mcap", played("reception", script)[2], where)
        for name, script in (("monday", "known-user.jsonl"), ("tuesday", "second-thoughts.jsonl"))
    ]
    it.answers.put("recording", files[0])
    it.window.commands.open_recording()
    until_shown(it)
    side = it.window.robot.comparing
    side.compare_with(files[1])
    compared(side.comparing)
    side.comparing.line_up("start")
    it.window.robot.timeline.bookmarks.add(3.0, "door")
    it.window.robot.follower.viewing.seek(14.0)
    counted = QSignalSpy(it.window.field.reading.counted)
    it.window.field.count([files[0]])
    assert counted.wait(PATIENCE)
    field, painted = it.window.field.field, it.window.field.panel.paint.isChecked()
    assert painted

    window = anew(it)
    assert window.robot.recording.path == files[0]
    assert window.robot.follower.viewing.t == 14.0
    comparing = window.robot.comparing.comparing
    compared(comparing)
    assert [one.name for one in (comparing.own, *comparing.others)] == [
        "monday.mcap",
        "tuesday.mcap",
    ]
    assert comparing.way == "start"
    assert [mark.name for mark in window.robot.timeline.bookmarks.every] == ["door"]
    assert window.field.field is field
    assert window.field.panel.paint.isChecked()
    assert window.field.panel.table.used
    # What is being counted is counted on.
    window.field.count([files[1]])
    window = anew(it)
    counted = QSignalSpy(window.field.reading.counted)
    # It may have been counted while the window was made.
    assert window.field.field is not field or counted.wait(PATIENCE)
    assert window.field.field is not field
    window.commands.close_recording()


def test_what_is_being_read_is_read_on_for_the_window_that_comes(
    studio: Callable[..., Any],
    project: Callable[[str], Path],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    where = project("reception")
    it = studio(where)
    files = [
        recording(tmp_path / f"{name}.mcap", played("reception", script)[2], where)
        for name, script in (("monday", "known-user.jsonl"), ("tuesday", "second-thoughts.jsonl"))
    ]
    with monkeypatch.context() as slow:
        # No slice has time for anything.
        slow.setattr(recordings, "SLICE", -1.0)
        it.answers.put("recording", files[0])
        it.window.commands.open_recording()
        window = anew(it)
        (work,) = window.status.work.going
        assert "monday.mcap" in work.words
    until_shown(it)
    assert window.robot.recording.path == files[0]
    assert window.status.work.going == []
    # So is one that is to stand beside it, and can be cancelled there.
    with monkeypatch.context() as slow:
        slow.setattr(recordings, "SLICE", -1.0)
        window.robot.comparing.compare_with(files[1])
        window = anew(it)
        window.status.work.cancel()
        assert window.status.work.going == []
        window.robot.comparing.compare_with(files[1])
        window = anew(it)
    comparing = window.robot.comparing.comparing
    compared(comparing)
    assert [one.name for one in comparing.others] == ["tuesday.mcap"]
    assert window.robot.recording.path == files[0]
    window.commands.close_recording()


def test_a_rehearsal_goes_on(studio: Callable[..., Any], project: Callable[[str], Path]) -> None:
    it = studio(project("reception"))
    it.settle()
    wide = it.window.docks["inspector"].width()
    it.window.rehearsing.clock = lambda: 0.0
    it.window.commands.rehearse()
    running = it.window.rehearsing.running
    running.step()
    t, states = running.seconds, len(running.course.log)
    window = anew(it)
    assert window.rehearsing.running is running
    assert window.robot.follower.viewing.log is running.course.log
    assert window.robot.follower.viewing.t == t
    assert not window.docks["rehearsal"].isHidden()
    assert window.docks["inspector"].isHidden()
    assert len(running.course.log) == states
    window.rehearsing.step()
    assert running.seconds > t
    window.rehearsing.end()
    assert not window.docks["inspector"].isHidden()
    it.settle()
    assert window.docks["inspector"].width() == wide
