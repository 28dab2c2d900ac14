"""The file of a recording (MCAP), written: ``recorded`` says what is in it, and reads it."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import msgspec
from mcap.writer import Writer
from msgspec.structs import replace

from situ.document.folder import PROJECT_FILE
from situ.rehearse import recorded
from situ.rehearse.recorded import Document, Heading, loaded

CHUNK = 256 * 1024


class McapFile:
    """One MCAP file, into a descriptor that it closes. Every call may raise OSError.

    grown: bytes written after what heads it. ``flush`` makes whole all that was added;
    ``finish`` ends it with its index; ``give_up`` leaves what is whole.
    """

    def __init__(self, file: int, heading: Heading, documents: Mapping[str, str]) -> None:
        self._out = _Out(file)
        self._counts = dict.fromkeys((recorded.TRACE, recorded.INPUTS, recorded.SNAPSHOT), 0)
        writer: Any = Writer(self._out, chunk_size=CHUNK)  # type: ignore[arg-type]
        self._writer = writer
        writer.start(profile="situ", library=f"situ {heading.version}".rstrip())
        writer.add_metadata(recorded.NAME, {"heading": _encode(heading).decode(), **_said(heading)})
        for path, text in documents.items():
            writer.add_attachment(0, 0, path, _media_type(path), text.encode())
        schemas = {
            recorded.TRACE: ("situ.Trace", recorded.trace_schema()),
            recorded.INPUTS: ("situ.Input", recorded.inputs_schema()),
            recorded.SNAPSHOT: ("situ.Snapshot", b'{"type":"object"}'),
        }
        self._channels = {
            topic: writer.register_channel(
                topic, "json", writer.register_schema(name, "jsonschema", schema)
            )
            for topic, (name, schema) in schemas.items()
        }
        self._head = self._out.tell()

    @property
    def grown(self) -> int:
        return self._out.tell() - self._head

    def add(self, topic: str, moment: float, body: bytes) -> None:
        """A message; moment: UNIX time in s."""
        self._counts[topic] += 1
        at = max(0, int(moment * 1e9))
        self._writer.add_message(self._channels[topic], at, body, at, self._counts[topic])

    def flush(self) -> None:
        self._writer.flush()

    def finish(self) -> None:
        self._writer.finish()
        self._out.flush()
        self._out.close()

    def give_up(self) -> None:
        self._out.close()


class _Out:
    """What mcap writes to: handed to the system by ``flush``, all of it or nothing."""

    def __init__(self, file: int) -> None:
        self._file = file
        self._buffer = bytearray()
        self._whole = 0

    def write(self, data: bytes) -> int:
        self._buffer += data
        return len(data)

    def tell(self) -> int:
        return self._whole + len(self._buffer)

    def flush(self) -> None:
        left = bytes(self._buffer)
        try:
            while left:
                left = left[os.write(self._file, left) :]
        except OSError:
            with contextlib.suppress(OSError):
                os.ftruncate(self._file, self._whole)
            raise
        self._whole += len(self._buffer)
        self._buffer.clear()

    def close(self) -> None:
        os.close(self._file)


def heading(name: str, documents: Mapping[str, str], version: str, *, masked: bool) -> Heading:
    """What runs there, as far as its documents tell. version: of situ."""
    bare = Heading(version=version, project=name, file=main_file(documents), masked=masked)
    files = [Document(path, text.encode()) for path, text in documents.items()]
    project = loaded(bare, files)
    if project is None:
        return bare
    tags = {} if masked else project.tags
    return replace(bare, tags=tags, private=project.private)


def main_file(documents: Iterable[str]) -> str:
    """The one that the project is read from: ``situ.toml``, else there is only one."""
    paths = list(documents)
    return PROJECT_FILE if PROJECT_FILE in paths else next(iter(paths), "")


def _said(heading: Heading) -> dict[str, str]:
    """The heading for people."""
    masked = "yes: it can not be replayed" if heading.masked else "no"
    return {
        "runtime": heading.runtime,
        "version": heading.version,
        "project": heading.project,
        "masked": masked,
    }


def _media_type(path: str) -> str:
    kinds = {".xml": "application/xml", ".toml": "application/toml"}
    return kinds.get(Path(path).suffix, "text/plain")


_encode = msgspec.json.Encoder().encode
