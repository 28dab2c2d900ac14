"""Recordings of a robot: whole, read by others, bounded, and no danger to the robot."""

from __future__ import annotations

import errno
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from mcap.reader import make_reader
from tests.rehearse.recorded_robot import LAB, Recorded, Replay, lines, recorder, ring

from situ.decide import inputs
from situ.decide.step import SECOND
from situ.document import deployed
from situ.document.folder import sources
from situ.engine import record
from situ.engine.record import OneFile, RingFiles
from situ.errors import UsageError
from situ.rehearse import recorded
from situ.rehearse.recorded import Document, Heading, Taken

# -- what is recorded ----------------------------------------------------------------


def test_others_read_it_by_its_index(tmp_path: Path) -> None:
    file = tmp_path / "run.mcap"
    run = Recorded(LAB, recorder(file))
    run.at(3 * SECOND, inputs.Set({"watched.x": 1}, "nod"))
    run.recorder.close()
    with open(file, "rb") as stream:
        reader = make_reader(stream, validate_crcs=True)
        summary = reader.get_summary()
        assert summary is not None
        assert summary.statistics is not None
        assert summary.statistics.attachment_count == len(sources(run.project))
        schemas = {s.name: json.loads(s.data) for s in summary.schemas.values()}
        # What looks at one object a topic asks for just this.
        assert {schema["type"] for schema in schemas.values()} == {"object"}
        kinds = schemas["situ.Trace"]["$defs"]
        messages = list(reader.iter_messages(topics=["/trace"]))
        for _, _, message in messages:
            event = json.loads(message.data)
            known = next(
                k for k in kinds.values() if k["properties"]["kind"]["enum"] == [event["kind"]]
            )
            assert set(known["required"]) <= set(event)
        assert b"".join(message.data + b"\n" for _, _, message in messages) == run.trace
        assert [m.name for m in reader.iter_metadata()] == ["situ"]
        at = json.loads(messages[-1][2].data)["t"]
        assert messages[-1][2].log_time == (1_700_000_000 + at) * 1e9


def test_the_first_input_has_the_seed(tmp_path: Path) -> None:
    file = tmp_path / "run.mcap"
    Recorded(LAB, recorder(file)).recorder.close()
    first = next(piece for piece in recorded.read(file) if isinstance(piece, Taken))
    assert first == Taken(0, 0.0, inputs.Start(seed=7))


# -- when it is on the disk ----------------------------------------------------------


def test_what_is_recorded_is_in_the_file_a_second_later(tmp_path: Path, replay: Replay) -> None:
    file = tmp_path / "run.mcap"
    run = Recorded(LAB, recorder(file))
    begun = run.trace
    assert lines(file) == begun
    run.step(inputs.Set({"watched.x": 1}, "nod"), 10)
    due = run.recorder.tend(0.5)
    assert due is not None
    assert due <= record.FLUSH + 0.5
    assert lines(file) == begun
    assert run.recorder.tend(due) is None
    # Killed here: nothing ends the file.
    status, out, told = replay(file)
    assert (status, out) == (0, run.trace)
    assert "breaks off" in told
    assert replay(file, "--decide")[0] == 0
    run.recorder.close()


def test_what_is_recorded_is_handed_over_when_it_is_asked_for(tmp_path: Path) -> None:
    file = tmp_path / "run.mcap"
    run = Recorded(LAB, recorder(file))
    run.step(inputs.Set({"watched.x": 1}, "nod"), 10)
    run.recorder.flush(0.1)
    assert lines(file) == run.trace
    run.recorder.close()


def test_many_messages_are_not_put_into_the_file_at_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = Recorded(LAB, recorder(tmp_path / "run.mcap"))
    most = 0
    for n in range(1, 1000):
        run.step(inputs.Set({"watched.x": n}, "nod"), n)
        most = max(most, len(run.recorder._waiting))
    assert most < 2 * record.MANY
    run.recorder.close()


# -- a robot that goes on ------------------------------------------------------------


def test_a_robot_that_goes_on_records_into_the_next_file(tmp_path: Path, replay: Replay) -> None:
    file = tmp_path / "run.mcap"
    run = Recorded(LAB, recorder(file))
    run.at(5 * SECOND, inputs.Set({"watched.x": 1}, "nod"))
    state = run.robot.snapshot()
    run.recorder.tend(6.0)
    before = file.read_bytes()
    for n in (2, 3):
        more = Recorded(LAB, recorder(file, goes_on=True), state=state)
        more.at(7 * SECOND, inputs.Set({"watched.x": n}, "nod"))
        more.recorder.close()
        next_file = tmp_path / f"run-{n}.mcap"
        assert replay(next_file) == (0, more.trace, "")
        assert replay(next_file, "--decide")[0] == 0
    assert file.read_bytes() == before
    run.recorder.close()


def test_a_run_that_begins_anew_takes_the_place_of_the_recording(tmp_path: Path) -> None:
    file = tmp_path / "run.mcap"
    file.write_bytes(b"x" * 1_000_000)
    run = Recorded(LAB, recorder(file))
    run.recorder.close()
    assert lines(file) == run.trace


# -- the ring ------------------------------------------------------------------------


def test_the_ring_is_divided_by_time_and_each_file_is_decided_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = Recorded(LAB, ring(tmp_path / "ring"))
    for minute in range(1, 21):
        run.at(minute * 60 * SECOND, inputs.Set({"watched.x": minute}, "nod"))
        run.recorder.tend(minute * 60 + record.FLUSH)
    run.recorder.close()
    files = RingFiles(tmp_path / "ring").found()
    assert 3 <= len(files) <= 5
    assert b"".join(map(lines, files)) == run.trace
    for file in files:
        assert recorded.again(recorded.read(file), "ring") is None


def test_a_deploy_begins_the_next_file_of_the_ring_with_its_documents(tmp_path: Path) -> None:
    run = Recorded(LAB, ring(tmp_path / "ring"))
    run.at(1 * SECOND, inputs.Set({"watched.x": 1}, "nod"))
    texts = sources(run.project)
    texts["situ.toml"] += '\n[privacy]\nprivate = ["watched.**"]\n'
    project, problems = deployed.read(texts)
    assert project is not None
    assert not [one for one in problems if one.severity == "error"]
    # The engine tells it from inside of the step.
    run.recorder.turn_to(project, 1, texts)
    run.at(2 * SECOND, inputs.Deploy(1, texts, "operator:ann", 0.0))
    assert run.robot.version == 1
    run.at(3 * SECOND, inputs.Set({"watched.x": 2}, "nod"))
    run.recorder.close()
    first, second = map(recorded.read, RingFiles(tmp_path / "ring").found())
    headings, documents = [], []
    for file in RingFiles(tmp_path / "ring").found():
        parts = list(recorded.read(file))
        headings += [one for one in parts if isinstance(one, Heading)]
        documents.append({p.path: p.data.decode() for p in parts if isinstance(p, Document)})
    assert [(one.deployed, one.private) for one in headings] == [(0, ()), (1, ("watched.**",))]
    assert documents == [sources(run.project), texts]
    assert recorded.again(first, "first") is None
    assert recorded.again(second, "second") is None


def test_the_ring_is_bounded_in_files_and_bytes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(RingFiles, "size", 2_000.0)
    monkeypatch.setattr(record, "SIZE", 20_000)
    monkeypatch.setattr(record, "RING_BYTES", 100_000)
    run = Recorded(LAB, ring(tmp_path / "ring"))
    files = RingFiles(tmp_path / "ring")
    for n in range(1, 60):
        noise = os.urandom(2_000).hex()
        run.at(2 * n * SECOND, inputs.Set({"watched.x": noise}, "nod"))
        run.recorder.tend(2 * n + record.FLUSH)
        assert sum(file.stat().st_size for file in files.found()) < 120_000
        assert len(files.found()) <= record.FILES
    run.recorder.close()
    numbers = [int(file.stem) for file in files.found()]
    assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))
    assert numbers[0] > 1
    assert run.trace.endswith(lines(files.found()[-1]))


# -- what can not be written ---------------------------------------------------------


def test_a_full_disk_ends_the_recording_and_not_the_robot(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    caplog: pytest.LogCaptureFixture,
) -> None:
    file = tmp_path / "run.mcap"
    run = Recorded(LAB, recorder(file))
    run.recorder.tend(2.0)
    before, whole = run.trace, file.stat().st_size
    write = os.write
    left = iter([100])

    def full(descriptor: int, data: bytes) -> int:
        # The disk takes a part of it, then nothing.
        room = next(left, 0)
        if not room:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return write(descriptor, data[:room])

    monkeypatch.setattr(os, "write", full)
    for n in range(3, 9):
        run.step(inputs.Set({"watched.x": n}, "nod"), n * SECOND)
        run.recorder.tend(n + 1.5)
    run.recorder.close()
    monkeypatch.undo()
    assert [r.getMessage() for r in caplog.records] == [
        f"{file}: No space left on device; the recording ends here"
    ]
    assert run.recorder.torn is not None
    # What was whole stays whole.
    assert (lines(file), file.stat().st_size) == (before, whole)


def test_a_ring_that_can_not_be_made_is_told_once(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    (tmp_path / "ring").write_text("in the way")
    run = Recorded(LAB, ring(tmp_path / "ring"))
    for n in range(1, 9):
        run.at(n * 2 * SECOND, inputs.Set({"watched.x": n}, "nod"))
    run.recorder.close()
    assert len(caplog.records) == 1
    assert run.robot.board.look("watched.x") == 8


def test_a_ring_is_tried_again_and_its_next_file_stands_alone(tmp_path: Path) -> None:
    (tmp_path / "ring").write_text("in the way")
    run = Recorded(LAB, ring(tmp_path / "ring"))
    (tmp_path / "ring").unlink()
    before = b""
    for n in range(1, 20):
        run.at(n * 60 * SECOND, inputs.Set({"watched.x": n}, "nod"))
        if n == record.SPAN // 60:
            before = run.trace
            assert not (tmp_path / "ring").exists()
    run.recorder.close()
    files = RingFiles(tmp_path / "ring").found()
    assert before + b"".join(map(lines, files)) == run.trace
    for file in files:
        assert recorded.again(recorded.read(file), "ring") is None


def test_what_could_not_be_recorded_shows_in_the_exit_status(tmp_path: Path) -> None:
    script = tmp_path / "s.jsonl"
    script.write_text('{"at":0,"end":true}\n')
    where = ("--endpoint", "tcp://127.0.0.1:0", "--state", str(tmp_path / "state"))
    run = (sys.executable, "-m", "situ", "run", str(LAB), "--services", "core", *where)
    for file, status in ((tmp_path / "run.mcap", 0), (Path("/dev/full"), 1)):
        done = subprocess.run(
            [*run, "--script", str(script), "--record", str(file)], capture_output=True, text=True
        )
        assert done.returncode == status
    assert "/dev/full: No space left on device" in done.stderr


def test_a_file_that_can_not_be_made_is_told_at_once(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="No such file"):
        OneFile(tmp_path / "none" / "run.mcap")
    with pytest.raises(UsageError, match="Is a directory"):
        OneFile(tmp_path)
