"""Recorded runs (MCAP): replayed as they were, decided again, and what is wrong with a file."""

from __future__ import annotations

import contextlib
import functools
import json
import os
import tempfile
from collections.abc import Mapping
from io import BytesIO
from pathlib import Path
from typing import Any

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mcap.writer import Writer
from tests.rehearse.recorded_robot import LAB, ROOT, Recorded, Replay, recorder

from situ import cli
from situ.decide import inputs
from situ.decide.robot import Robot
from situ.decide.step import SECOND
from situ.decide.trace import to_line
from situ.document.folder import sources
from situ.document.ready import load_ready
from situ.errors import UsageError
from situ.rehearse import recorded, scenario
from situ.rehearse.expect import Expect
from situ.rehearse.mcap_file import McapFile
from situ.rehearse.recorded import Difference, Document, Heading, Line, Piece, Snapshot, Taken, Torn
from situ.rehearse.recording import Recording, read_trace
from situ.rehearse.recording import read as read_run

SCENARIOS = sorted(ROOT.glob("examples/*/scenarios/*.jsonl"))


@pytest.mark.parametrize("script", SCENARIOS, ids=lambda p: f"{p.parts[-3]}/{p.stem}")
def test_each_scenario_is_replayed_as_it_was_and_decided_again_byte_for_byte(
    script: Path, tmp_path: Path, replay: Replay
) -> None:
    path = script.parents[1]
    file = tmp_path / "run.mcap"
    run = Recorded(path, recorder(file, path))
    names = [application.name for application in run.project.applications.values()]
    for line in scenario.load(str(script), names):
        run.at(line.at)
        if not isinstance(line.does, (Expect, scenario.End)):
            run.at(line.at, line.does)
    run.recorder.close()
    assert replay(file) == (0, run.trace, "")
    assert replay(file, "--decide") == (0, b"decided again, all is as recorded\n", "")


def test_a_file_cut_anywhere_is_read_as_far_as_it_is_whole(tmp_path: Path) -> None:
    file, cut = tmp_path / "run.mcap", tmp_path / "cut.mcap"
    run = Recorded(LAB, recorder(file))
    for n in range(1, 40):
        run.at(n * SECOND, inputs.Set({"watched.x": n}, "nod"))
    run.recorder.close()
    data = file.read_bytes()
    begin = data.index(b"application/xml")
    seen = set()
    for end in range(begin, len(data), 997):
        cut.write_bytes(data[:end])
        read = list(recorded.read(cut))
        found = b"".join(p.text + b"\n" for p in read if isinstance(p, Line))
        assert run.trace.startswith(found)
        assert read[-1] == Torn()
        assert recorded.again(read, "cut") is None
        seen.add(len(found))
    assert len(seen) > 3


def test_a_difference_is_told_with_both_events(tmp_path: Path, replay: Replay) -> None:
    file = tmp_path / "run.mcap"
    run = Recorded(LAB, recorder(file))
    given = inputs.Set({"watched.x": 1}, "nod")
    events, _ = Robot(run.project).step(inputs.Set({"watched.x": 2}, "nod"), SECOND)
    run.recorder.step(SECOND, given, [e for e in events if e.__class__.__name__ == "Data"], 0.0)
    run.recorder.close()
    status, _, told = replay(file, "--decide")
    assert status == 1
    assert "at 1 s recorded was" in told
    assert '"value":2' in told
    assert '"value":1' in told


def test_what_is_no_recording_is_2(tmp_path: Path, replay: Replay) -> None:
    (tmp_path / "x.mcap").write_bytes(b"{}")
    for name in ("x.mcap", "none.mcap"):
        for options in ((), ("--decide",)):
            status, out, told = replay(tmp_path / name, *options)
            assert (status, out, len(told.splitlines())) == (2, b"", 1)


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "run.mcap"


def made(
    file: Path, *pieces: Piece, documents: Mapping[str, str] | None = None, **heading: Any
) -> str:
    """A recording of just these."""
    documents = sources(load_ready(LAB)) if documents is None else documents
    given: dict[str, Any] = {"project": "lab", "file": "situ.toml", "tags": {}} | heading
    out = McapFile(os.open(file, os.O_WRONLY | os.O_CREAT), Heading(**given), documents)
    for piece in pieces:
        if isinstance(piece, Line):
            out.add("/trace", piece.at / 1e9, piece.text)
        elif isinstance(piece, Taken):
            out.add("/inputs", 0.0, msgspec.json.encode(piece))
        else:
            assert isinstance(piece, Snapshot)
            out.add("/snapshot", 0.0, piece.state)
    out.finish()
    return str(file)


START = Taken(0, 0.0, inputs.Start())


def decided(name: str) -> Difference | None:
    return recorded.again(recorded.read(name), name)


def test_what_is_made_is_read(file: Path) -> None:
    pieces = (Snapshot(b"{}"), START, Line(b'{"seq":1}', 2_000_000_000), Taken(1, 0.5, None))
    read = list(recorded.read(made(file, *pieces, documents={"a.xml": "x"}, masked=True)))
    heading = Heading(project="lab", file="situ.toml", masked=True)
    assert read == [heading, Document("a.xml", b"x"), *pieces]


def test_an_event_that_no_longer_comes_is_told(file: Path) -> None:
    robot = Robot(load_ready(LAB))
    name = robot.project.name
    events = robot.step(inputs.Start(), 0)[0]
    whole = [Line(to_line(event).rstrip(), 0) for event in events]
    given: dict[str, Any] = {"project": name, "tags": robot.project.tags}
    assert decided(made(file, START, *whole, **given)) is None
    extra = decided(made(file, START, *whole, whole[0], **given))
    assert extra == Difference(0.0, whole[0].text.decode(), None)
    assert "decided now is no further event" in str(extra)
    for rest in ((), (Taken(1, 1.0, None),)):
        missing = decided(made(file, START, *whole[:-1], *rest, **given))
        assert missing == Difference(0.0, None, whole[-1].text.decode())
        assert "recorded was no further event" in str(missing)


@pytest.mark.parametrize(
    ("pieces", "options", "said"),
    [
        ((Line(b"{}", 0),), {}, "holds a trace without inputs"),
        ((Taken(1, 0.0, None),), {}, "lacks where the robot began"),
        ((START,), {"masked": True}, "private values are masked"),
        ((START,), {"documents": {"../a.xml": ""}}, "the project that it holds can not be read"),
        ((START,), {"documents": {"/tmp/a.xml": ""}}, "the project that it holds can not be read"),
        ((START,), {"documents": {"situ.toml": "["}}, "the project that it holds can not be read"),
        ((START,), {"documents": {}}, "the project that it holds can not be read"),
        ((Snapshot(b"{}"),), {}, "its snapshot is damaged"),
    ],
)
def test_what_can_not_be_decided_again_says_why(
    file: Path, pieces: tuple[Piece, ...], options: dict[str, Any], said: str, replay: Replay
) -> None:
    made(file, *pieces, **options)
    status, _, told = replay(file, "--decide")
    assert (status, len(told.splitlines())) == (2, 1)
    assert said in told


def test_what_others_put_into_the_file_is_passed_over(file: Path) -> None:
    with open(file, "wb") as stream:
        writer: Any = Writer(stream)
        writer.start()
        writer.add_metadata("theirs", {"heading": "nonsense"})
        channel = writer.register_channel("/camera", "raw", 0)
        writer.add_message(channel, 0, b"...", 0)
        writer.add_metadata("situ", {"heading": "{}"})
        writer.add_message(channel, 0, b"...", 0)
        writer.finish()
    assert list(recorded.read(file)) == [Heading()]


@pytest.mark.parametrize("damage", ["heading", "input"])
def test_damage_is_an_error_before_the_heading_and_an_end_behind_it(
    file: Path, damage: str
) -> None:
    with open(file, "wb") as stream:
        writer: Any = Writer(stream)
        writer.start()
        writer.add_metadata("situ", {} if damage == "heading" else {"heading": "{}"})
        writer.add_message(writer.register_channel("/inputs", "json", 0), 0, b"{", 0)
        writer.finish()
    if damage == "heading":
        with pytest.raises(UsageError, match="not a recording of situ"):
            list(recorded.read(file))
    else:
        assert list(recorded.read(file)) == [Heading(), Torn(damaged=True)]


def test_messages_that_stand_in_no_chunk_are_read_too(file: Path) -> None:
    with open(file, "wb") as stream:
        writer: Any = Writer(stream, use_chunking=False)
        writer.start()
        writer.add_metadata("situ", {"heading": "{}"})
        channel = writer.register_channel("/trace", "json", 0)
        writer.add_message(channel, 7, b'{"seq":1}', 7)
        writer.finish()
    assert list(recorded.read(file)) == [Heading(), Line(b'{"seq":1}', 7)]


def test_why_reads_a_recording(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    run = Recorded(LAB, recorder(file))
    run.recorder.close()
    assert cli.main(["why", str(file), "1"]) == 0
    assert "#1" in capsys.readouterr().out
    assert [json.loads(line) for line in run.trace.splitlines()] == read_trace(file)


def _lines(*events: tuple[int, float, int | None]) -> list[Line]:
    return [
        Line(msgspec.json.encode({"kind": "x", "seq": seq, "t": t, "cause": cause}), 0)
        for seq, t, cause in events
    ]


def test_the_steps_of_a_recording_without_inputs_are_guessed_from_its_trace(file: Path) -> None:
    lines = _lines((1, 1, None), (2, 1, 1), (3, 2, None))
    run = read_run(made(file, *lines, masked=True))
    assert [[event["seq"] for event in step.events] for step in run.steps] == [[1, 2], [3]]
    assert run == Recording.of(read_trace(file))


def test_an_input_that_nothing_came_of_begins_no_step(file: Path) -> None:
    first, second = _lines((1, 0, None), (2, 2, None))
    ticked = Taken(1, 1.0, None)
    run = read_run(made(file, START, first, ticked, Taken(2, 2.0, None), second))
    assert [[event["seq"] for event in step.events] for step in run.steps] == [[1], [2]]


def test_a_length_that_nothing_has_is_damage() -> None:
    whole = _whole()
    name = whole.index(b"\x09\0\0\0situ.toml") + 4
    # An attachment: name, media type and data, each with its length before it.
    media = name + len("situ.toml")
    size = media + 4 + int.from_bytes(whole[media : media + 4], "little")
    file = BytesIO(whole[:size] + b"\xff" * 8 + whole[size + 8 :])
    assert isinstance(list(recorded.pieces(file, "x"))[-1], recorded.Torn)


@settings(deadline=None, max_examples=60)
@given(data=st.binary(max_size=200), at=st.integers(0, 10_000))
def test_damaged_bytes_never_raise_anything_else(data: bytes, at: int) -> None:
    whole = _whole()
    at %= len(whole)
    file = BytesIO(whole[:at] + data + whole[at + len(data) :])
    with contextlib.suppress(UsageError):
        list(recorded.pieces(file, "x"))


@functools.cache
def _whole() -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "run.mcap")
        Recorded(LAB, recorder(file)).recorder.close()
        return file.read_bytes()


@pytest.mark.parametrize("late", [False, True], ids=["whole", "from a snapshot"])
def test_a_run_over_deploys_is_decided_again_by_itself(
    tmp_path: Path, replay: Replay, late: bool
) -> None:
    """One version waits for a speech, another fails and is returned from. Nothing is needed beside
    the recording, also where it begins with a version that its documents are not.
    """
    file, path = tmp_path / "run.mcap", ROOT / "examples" / "reception"
    texts = sources(load_ready(path))
    flow = texts["reception.rbd.xml"]
    other = flow.replace("<speech>Touch my screen", "<speech>Please touch my screen")
    loops = other.replace("<event name=", '<event next="#again"/><event name=', 3)
    assert flow != other != loops
    run = Recorded(path, recorder(file, path))
    run.at(SECOND, inputs.Deploy(1, {**texts, "reception.rbd.xml": other}, "operator:ann"))
    run.at(2 * SECOND, inputs.Finish("speech"))
    run.at(2 * SECOND)
    if late:
        state = run.robot.snapshot()
        run.recorder.close()
        run = Recorded(path, recorder(file, path), state=state)
    run.at(3 * SECOND, inputs.Deploy(2, {**texts, "reception.rbd.xml": loops}, "operator:ann"))
    run.at(4 * SECOND, inputs.Raise("screenTouched"))
    run.recorder.close()
    told = [(e["kind"], e.get("version")) for e in map(json.loads, run.trace.splitlines())]
    deployed = [version for kind, version in told if kind == "deployed"]
    assert deployed == ([2, 1] if late else [1, 2, 1])
    assert replay(file) == (0, run.trace, "")
    assert replay(file, "--decide") == (0, b"decided again, all is as recorded\n", "")


@pytest.mark.parametrize("state", [b"", b"{", b'{"board": 3}', b"\xff"])
def test_a_damaged_snapshot_is_told(state: bytes) -> None:
    with pytest.raises(UsageError, match="snapshot is damaged"):
        recorded.board_of(state)
