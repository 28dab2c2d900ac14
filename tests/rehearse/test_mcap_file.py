"""The file of a recording: what is whole of it, also where the disk does not take it."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from situ.document.folder import sources
from situ.document.ready import load_ready
from situ.rehearse import recorded
from situ.rehearse.mcap_file import McapFile, heading
from situ.rehearse.recorded import TRACE, Document, Heading, Line, Torn
from situ.resources import examples

LINE = b'{"seq":1}'


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "run.mcap"


def begun(file: Path) -> McapFile:
    descriptor = os.open(file, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
    return McapFile(descriptor, Heading(project="lab"), {"notes.txt": "x"})


def read(file: Path) -> list[recorded.Piece]:
    return list(recorded.read(file))


HEAD = [Heading(project="lab"), Document("notes.txt", b"x")]


def test_what_was_flushed_is_whole_without_an_end(file: Path) -> None:
    out = begun(file)
    assert out.grown == 0
    out.add(TRACE, 2.0, LINE)
    out.flush()
    assert out.grown > 0
    out.add(TRACE, 3.0, LINE)
    out.give_up()
    assert read(file) == [*HEAD, Line(LINE, 2_000_000_000), Torn()]


def test_what_ended_is_all_there(file: Path) -> None:
    out = begun(file)
    out.add(TRACE, -1.0, LINE)
    out.finish()
    assert read(file) == [*HEAD, Line(LINE, 0)]


def test_what_the_disk_does_not_take_leaves_what_was_whole(
    file: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = begun(file)
    out.add(TRACE, 2.0, LINE)
    out.flush()
    out.add(TRACE, 3.0, LINE)
    write, left = os.write, [10]

    def full(descriptor: int, data: bytes) -> int:
        if not left[0]:
            raise OSError(28, "No space left on device")
        taken = write(descriptor, data[: left[0]])
        left[0] -= taken
        return taken

    with monkeypatch.context() as disk:
        disk.setattr(os, "write", full)
        with pytest.raises(OSError, match="No space left"):
            out.flush()
    out.give_up()
    assert read(file) == [*HEAD, Line(LINE, 2_000_000_000), Torn()]


def test_it_is_headed_by_what_its_documents_tell() -> None:
    documents = sources(load_ready(examples()["vitals"]))
    whole = heading("vitals", documents, "1.0", masked=False)
    assert (whole.project, whole.file, whole.version) == ("vitals", "situ.toml", "1.0")
    assert not whole.masked
    assert "services.records" in whole.tags
    assert whole.private
    masked = heading("vitals", documents, "1.0", masked=True)
    assert (masked.tags, masked.private, masked.masked) == ({}, whole.private, True)


def test_documents_that_are_no_project_are_headed_by_its_name() -> None:
    assert heading("lab", {}, "1.0", masked=False).project == "lab"
    one = heading("lab", {"lab.rbd.xml": "<none/>"}, "1.0", masked=False)
    assert (one.project, one.file, one.tags) == ("lab", "lab.rbd.xml", {})
