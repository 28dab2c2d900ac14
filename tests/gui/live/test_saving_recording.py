"""What was seen of a robot is saved as a recording, and looked at again."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec
import pytest
from PySide6.QtWidgets import QApplication
from tests.gui.live.test_link import connect
from tests.gui.live.test_log import played
from tests.gui.live.test_recordings import until_shown

from situ.blackboard.client import connect as operator
from situ.rehearse import recorded
from situ_studio.live import saving_recording


def test_what_was_seen_of_a_robot_is_saved_and_opened_as_it_was(
    studio: Callable[..., Any],
    project: Callable[[str], Path],
    robot: Any,
    until: Any,
    tmp_path: Path,
) -> None:
    there, file = robot(project("conversation")), tmp_path / "seen.mcap"
    it = studio(there.project)
    window = it.window
    save = window.actions_.actions["recording.save"]
    assert not save.isEnabled()
    link = connect(it, there.endpoint, until)
    until(link.documents_came, lambda: window.robot.follower.same is True)
    with operator(there.endpoint, role="operator") as board:
        board.publish("clickYes")
    now = link.log.now.applications
    until(link.moment_changed, lambda: "converse" in now and now["converse"].state == "2")
    it.answers.put("recording_to", None)
    save.trigger()
    assert list(tmp_path.glob("seen*")) == []
    events = list(link.log)
    it.answers.put("recording_to", file)
    save.trigger()
    saving = window.robot.saving
    until(saving.ended, file.exists)
    assert window.status.said.text() == f"seen.mcap is saved: {len(events):,} events."
    # Private values are in it.
    assert file.stat().st_mode & 0o077 == 0
    assert [one.name for one in tmp_path.glob("seen*")] == ["seen.mcap"]
    window.robot.disconnect_robot()
    window.robot.open_recording(file)
    until_shown(it)
    recording = window.robot.recording
    assert list(recording.log)[: len(events)] == events
    assert recording.project == "conversation"
    assert not recording.torn
    assert window.robot.follower.same is True
    assert not save.isEnabled()


@pytest.fixture
def seen(studio: Callable[..., Any], project: Callable[[str], Path]) -> Any:
    """A window with what a robot did, a little at a time."""
    it = studio(project("conversation"))
    it.window.robot.link.log.add(played("conversation", "fig5.jsonl")[2])
    return it


def later(number: int) -> dict[str, Any]:
    """An event behind all others."""
    first = next(one for one in played("conversation", "fig5.jsonl")[2] if one["kind"] == "data")
    return {**first, "seq": 10_000 + number, "t": 1e6, "cause": None}


def lines(file: Path) -> list[dict[str, Any]]:
    found = recorded.read(file)
    return [msgspec.json.decode(one.text) for one in found if isinstance(one, recorded.Line)]


def test_it_is_written_a_slice_at_a_time_and_is_there_once_it_is_whole(
    seen: Any, until: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(saving_recording, "SLICE", 0.0)
    monkeypatch.setattr(saving_recording, "PIECE", 1)
    link, saving, file = seen.window.robot.link, seen.window.robot.saving, tmp_path / "seen.mcap"
    file.write_bytes(b"before")
    events = list(link.log)
    saving.start(file)
    # What comes meanwhile is none of it.
    link.log.add([later(0)])
    QApplication.processEvents()
    assert file.read_bytes() == b"before"
    until(saving.ended, lambda: file.read_bytes() != b"before")
    assert lines(file) == events


def test_events_that_are_forgotten_while_it_is_written_are_written_once_or_left_out(
    seen: Any, until: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(saving_recording, "SLICE", 0.0)
    monkeypatch.setattr(saving_recording, "PIECE", 7)
    link, saving, file = seen.window.robot.link, seen.window.robot.saving, tmp_path / "seen.mcap"
    events = list(link.log)
    link.log.__init__(limit=len(events), block=5)
    link.log.add(events)
    saving.start(file)
    QApplication.processEvents()
    link.log.add([later(n) for n in range(40)])
    assert link.log.gone
    until(saving.ended, file.exists)
    found = [one["seq"] for one in lines(file)]
    assert found == sorted(set(found))
    every = [one["seq"] for one in events]
    assert set(found) <= set(every)
    assert found[-(len(every) - link.log.gone) :] == every[link.log.gone :]


def test_nothing_is_left_of_what_is_cancelled_or_can_not_be_written(
    seen: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(saving_recording, "SLICE", 0.0)
    monkeypatch.setattr(saving_recording, "PIECE", 1)
    window, file = seen.window, tmp_path / "seen.mcap"
    saving = window.robot.saving
    saving.start(file)
    QApplication.processEvents()
    saving.cancel()
    assert list(tmp_path.glob("seen*")) == []
    # The robot that comes back is another run.
    saving.start(file)
    window.robot.link.log.clear()
    QApplication.processEvents()
    assert seen.answers.told == ["The robot has begun anew: nothing was saved."]
    assert list(tmp_path.glob("seen*")) == []
    saving.start(tmp_path / "none" / "seen.mcap")
    assert "No such file" in seen.answers.told[-1]
    # The disk is full in the end.
    saving.start(file)
    monkeypatch.setattr(os, "write", full)
    for _ in range(3):
        QApplication.processEvents()
    assert seen.answers.told[-1] == f"{file}: No space left on device"
    assert list(tmp_path.glob("seen*")) == []


def full(descriptor: int, data: bytes) -> int:
    raise OSError(28, "No space left on device")
