"""Recorded runs are looked at as a robot is: every view shows the moment of the cursor."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec
import pytest
from mcap.writer import Writer
from PySide6.QtCore import QEventLoop, QTimer
from tests.gui.live.test_log import played

from situ.document.export import deployable
from situ.document.ready import load_ready
from situ.resources import examples
from situ_studio.live import recordings
from situ_studio.live.recordings import ReadingRecording
from situ_studio.live.viewing import Viewing

PATIENCE = 20_000


def recording(
    file: Path, events: list[dict[str, Any]], project: Path | None, whole: bool = True
) -> Path:
    """A file as ``situ run --record`` writes it, of these events; without a project as it is
    written for those who may not see what is private.
    """
    with file.open("wb") as stream:
        writer: Any = Writer(stream, chunk_size=20_000)
        writer.start()
        name = "" if project is None else project.name
        heading = {"runtime": "r", "project": name, "file": "situ.toml", "masked": project is None}
        writer.add_metadata("situ", {"heading": msgspec.json.encode(heading).decode()})
        for path, text in ({} if project is None else deployable(load_ready(project))).items():
            writer.add_attachment(0, 0, path, "text/plain", text)
        channel = writer.register_channel("/trace", "json", 0)
        for event in events:
            stamped = {**event, "time": f"2026-11-22T10:00:{int(event['t']) % 60:02}+00:00"}
            writer.add_message(channel, int(event["t"] * 1e9), msgspec.json.encode(stamped), 0)
        writer.finish()
    if not whole:
        file.write_bytes(file.read_bytes()[: file.stat().st_size * 2 // 3])
    return file


def came(reading: ReadingRecording) -> list[Any]:
    """What is told in the end: a recording, or why there is none."""
    loop = QEventLoop()
    told: list[Any] = []

    def note(one: Any) -> None:
        told.append(one)
        loop.quit()

    reading.read.connect(note)
    reading.refused.connect(note)
    late = QTimer()
    late.setSingleShot(True)
    late.timeout.connect(loop.quit)
    late.start(PATIENCE)
    loop.exec()
    late.stop()
    return told


def test_a_recording_is_read_with_its_documents(
    qt: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # A turn of the loop for each few pieces.
    monkeypatch.setattr(recordings, "SLICE", 1e-5)
    monkeypatch.setattr(recordings, "PIECE", 5)
    _, _, events = played("conversation", "fig5.jsonl")
    project = Path(examples()["conversation"])
    reading = ReadingRecording()
    went: list[float] = []
    reading.went_on.connect(went.append)
    reading.start(recording(tmp_path / "run.mcap", events, project))
    (read,) = came(reading)
    assert [event["seq"] for event in read.log] == [event["seq"] for event in events]
    assert read.files["situ.toml"] == (project / "situ.toml").read_text()
    assert read.project == "conversation"
    assert not read.torn
    assert len(went) > 1
    assert went == sorted(went)


def test_a_torn_file_is_read_as_far_as_it_is_whole(qt: Any, tmp_path: Path) -> None:
    _, _, events = played("conversation", "fig5.jsonl")
    many = [{**event, "seq": n} for n, event in enumerate(events * 8, 1)]
    file = recording(tmp_path / "run.mcap", many, Path(examples()["conversation"]), whole=False)
    reading = ReadingRecording()
    reading.start(file)
    (read,) = came(reading)
    assert read.torn
    assert 0 < len(read.log) < len(many)


def test_a_file_with_other_bytes_in_it_is_read_up_to_there_and_told_as_damaged(
    qt: Any, tmp_path: Path
) -> None:
    _, _, events = played("conversation", "fig5.jsonl")
    many = [{**event, "seq": n} for n, event in enumerate(events * 8, 1)]
    file = recording(tmp_path / "run.mcap", many, Path(examples()["conversation"]))
    data = bytearray(file.read_bytes())
    data[len(data) // 2] ^= 0xFF
    file.write_bytes(data)
    reading = ReadingRecording()
    reading.start(file)
    (read,) = came(reading)
    assert 0 < len(read.log) < len(many)
    assert read.notice() == "run.mcap is damaged: what comes behind that is not shown."


def test_a_recording_in_which_nothing_happens_says_so(qt: Any, tmp_path: Path) -> None:
    reading = ReadingRecording()
    reading.start(recording(tmp_path / "run.mcap", [], Path(examples()["conversation"])))
    (read,) = came(reading)
    assert read.notice() == "Nothing that a robot did is in it."


@pytest.mark.parametrize("content", [None, b"", b"not a recording at all, but long enough"])
def test_what_is_no_recording_is_refused_in_one_line(
    qt: Any, tmp_path: Path, content: bytes | None
) -> None:
    file = tmp_path / "x.mcap"
    if content is not None:
        file.write_bytes(content)
    reading = ReadingRecording()
    told: list[str] = []
    reading.refused.connect(told.append)
    reading.start(file)
    said = told or came(reading)
    assert len(said) == 1
    assert "\n" not in said[0]
    assert "x.mcap" in said[0]
    assert ("is empty" in said[0]) == (content == b"")


@pytest.mark.parametrize(
    ("spoilt", "said"),
    [
        ({"seq": None}, "event 5 is none of a robot's"),
        ({"t": "soon"}, "event 5 is none of a robot's"),
        ("seq", "event 5 lacks “seq”"),
        ("t", "event 5 lacks “t”"),
        ("kind", "event 5 lacks “kind”"),
        ("application", "event 5 lacks “application”"),
    ],
)
def test_an_event_that_is_none_is_told_in_one_line(
    qt: Any, tmp_path: Path, spoilt: str | dict[str, Any], said: str
) -> None:
    file = tmp_path / "x.mcap"
    lines: list[Any] = [
        {"kind": "enter", "seq": n, "t": n / 2, "cause": None, "application": "a", "state": "1"}
        for n in range(1, 9)
    ]
    if isinstance(spoilt, str):
        del lines[4][spoilt]
    else:
        lines[4] |= spoilt
    with file.open("wb") as stream:
        writer: Any = Writer(stream)
        writer.start()
        heading = {"runtime": "r", "project": "p", "file": "situ.toml"}
        writer.add_metadata("situ", {"heading": msgspec.json.encode(heading).decode()})
        channel = writer.register_channel("/trace", "json", 0)
        for line in lines:
            writer.add_message(channel, 0, msgspec.json.encode(line), 0)
        writer.finish()
    reading = ReadingRecording()
    reading.start(file)
    (told,) = came(reading)
    assert said in told
    assert str(file) in told
    assert "\n" not in told


def test_the_cursor_goes_where_something_is_and_from_event_to_event(qt: Any) -> None:
    from situ_studio.live.log import TraceLog

    _, _, events = played("conversation", "fig5.jsonl")
    log = TraceLog()
    log.add(events)
    viewing: Any = Viewing(log)
    assert viewing.follows
    assert viewing.moment() is log.now
    times = sorted({event["t"] for event in events})
    viewing.seek(-5)
    for t in times[1:]:
        viewing.step(1)
        assert viewing.t == t
    viewing.step(1)
    assert viewing.t == times[-1]
    for t in reversed(times[:-1]):
        viewing.step(-1)
        assert viewing.t == t
    viewing.seek(1e9)
    assert viewing.t == events[-1]["t"]
    assert not viewing.follows
    viewing.follow()
    assert viewing.follows


def test_every_view_shows_the_moment_under_the_cursor(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    _, _, events = played("conversation", "fig5.jsonl")
    where = project("conversation")
    it = studio(where)
    file = recording(tmp_path / "run.mcap", events, where)
    it.answers.put("recording", file)
    robot = it.window.robot
    it.window.commands.open_recording()
    until_shown(it)
    viewing = robot.follower.viewing
    assert "run.mcap" in it.window.status.link.text()
    assert ", same as it ran" in it.window.status.link.text()
    sound = next(e for e in events if e["kind"] == "situation" and e["to"] == "sound")
    viewing.seek(sound["t"])
    script = "conversation.spds.xml"
    it.window.open_file(script)
    it.settle()
    assert it.window.views[script].canvas.look.live.situation == "sound"
    it.window.commands.open_beside()
    it.settle()
    both = it.window.sides.views_of(script)
    assert [view.canvas.look.live.situation for view in both] == ["sound", "sound"]
    assert robot.blackboard.isEnabled()
    board = {row.key: row.cells for row in robot.blackboard.rows.rows}
    assert "sound.slap" in board
    it.window.commands.close_recording()
    assert it.window.status.link.text() == "no robot"
    assert [view.canvas.look.live for view in both] == [None, None]


def until_shown(it: Any) -> None:
    loop, late = QEventLoop(), QTimer()
    it.window.robot.follower.viewing.exchanged.connect(loop.quit)
    late.setSingleShot(True)
    late.timeout.connect(loop.quit)
    late.start(PATIENCE)
    loop.exec()
    assert late.isActive(), "no recording came"
    late.stop()
    it.settle()


def opened(
    studio: Any, where: Path, file: Path, name: str, script: str
) -> tuple[Any, list[dict[str, Any]]]:
    """A window in which a run of that scenario is looked at, recorded in ``file``; its events."""
    _, _, events = played(name, script)
    it = studio(where)
    it.answers.put("recording", recording(file, events, where))
    it.window.commands.open_recording()
    until_shown(it)
    return it, events


def test_reading_is_cancelled_in_the_status_bar_and_begun_again(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    _, _, events = played("conversation", "fig5.jsonl")
    where = project("conversation")
    it = studio(where)
    file = recording(tmp_path / "run.mcap", events, where)
    robot: Any = it.window.robot
    robot.open_recording(file)
    it.window.status.work.cancel()
    assert it.window.status.work.going == []
    assert it.window.status.link.text() == "no robot"
    robot.open_recording(file)
    until_shown(it)
    assert robot.recording.path == file
    it.window.commands.close_recording()


def test_a_recording_that_can_not_be_read_leaves_everything_as_it_is(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    it = studio(project("conversation"))
    it.window.robot.open_recording(tmp_path / "gone.mcap")
    assert "gone.mcap" in it.answers.told[0]
    assert it.window.robot.recording is None
    assert it.window.status.work.going == []
