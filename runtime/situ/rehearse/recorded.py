"""A recorded run (MCAP): what is in the file, piece by piece, and the same decisions once more.

A file is headed by who ran (``Heading``) and the project's documents (``Document``). Then come, on
the channels ``/inputs`` and ``/trace``, each step's input (``Taken``) and its trace events
(``Line``); a recording that does not begin with the run has the robot's state (``Snapshot``, on
``/snapshot``) before its first step. ``situ.rehearse.mcap_file`` writes them.
"""

from __future__ import annotations

import functools
import struct
import tempfile
from collections import deque
from collections.abc import Iterable, Iterator
from io import BytesIO
from pathlib import Path, PurePosixPath
from typing import IO, Any

import msgspec
import zstandard
from mcap.data_stream import ReadDataStream
from mcap.exceptions import McapError
from mcap.opcode import Opcode
from mcap.records import Attachment, Channel, Chunk, McapRecord, Message, Metadata
from mcap.stream_reader import StreamReader, get_chunk_data_stream
from msgspec import Struct
from msgspec.structs import replace

from situ.decide.inputs import AnyInput, Start
from situ.decide.robot import Robot
from situ.decide.step import SECOND
from situ.decide.trace import TraceEvent, to_line
from situ.document import folder
from situ.document.project import Project
from situ.errors import UsageError

MAGIC = b"\x89MCAP0\r\n"
NAME = "situ"
"""Of the metadata."""
TRACE, INPUTS, SNAPSHOT = "/trace", "/inputs", "/snapshot"
LARGEST = 1 << 28
"""Bytes of a record: larger ones are damage."""
_RECORD = struct.Struct("<BQ")
"""What a record of a chunk begins with: its kind and its length."""
_MESSAGE = struct.Struct("<HIQQ")
"""What a message begins with: channel, number, the time that it tells, that of its writing; ns."""


class Heading(Struct, frozen=True):
    """What ran. version: of situ. tags, private: as in ``Project``. file: where the project is read
    from among its documents. deployed: the version that these documents are. masked: private
    values are ``•••``, and there are no inputs.
    """

    runtime: str = ""
    version: str = ""
    project: str = ""
    file: str = ""
    tags: dict[str, Any] = {}
    private: tuple[str, ...] = ()
    deployed: int = 0
    masked: bool = False


class Document(Struct, frozen=True):
    """A file of the project, its path in it."""

    path: str
    data: bytes


class Snapshot(Struct, frozen=True):
    """``Robot.snapshot()`` before the first step that is recorded."""

    state: bytes


class Taken(Struct, frozen=True):
    """A step at ``us`` µs. given: its input, None where something fell due; t: ``us`` in s."""

    us: int
    t: float
    given: AnyInput | None


class Line(Struct, frozen=True):
    """A trace event as its JSON, without newline; at: UNIX time in ns."""

    text: bytes
    at: int


class Torn(Struct, frozen=True):
    """The file ends here without its end: the robot still runs, or was killed. damaged: it goes
    on, but with what no recorder wrote.
    """

    damaged: bool = False


Piece = Heading | Document | Snapshot | Taken | Line | Torn


def board_of(state: bytes) -> dict[str, Any]:
    """The tags that stood on the blackboard of a ``Snapshot``. Raises UsageError."""
    try:
        found = _board.decode(state).board
    except (msgspec.DecodeError, UnicodeDecodeError):
        raise UsageError("the recording's snapshot is damaged, or another situ's") from None
    return {tag: entry.value for tag, entry in found.items()}


def is_recording(data: bytes) -> bool:
    """Whether a file that begins so is one."""
    return data.startswith(MAGIC)


def read(path: str | Path) -> Iterator[Piece]:
    """What is in the file, in its order, as far as it is whole.

    Raises UsageError where it can not be read or is no recording of situ.
    """
    try:
        with open(path, "rb") as file:
            yield from pieces(file, str(path))
    except (OSError, ValueError) as error:
        raise UsageError(f"{path}: {getattr(error, 'strerror', None) or error}") from None


def pieces(file: IO[bytes], name: str) -> Iterator[Piece]:
    """As ``read``."""
    channels: dict[int, str] = {}
    headed = False
    try:
        reader = _Records(file, emit_chunks=True, validate_crcs=True, record_size_limit=LARGEST)
        for record in reader.records:
            if isinstance(record, Chunk) and headed:
                yield from _messages(record, channels)
            elif isinstance(record, Message) and headed:
                yield from _piece(channels.get(record.channel_id), record.data, record.log_time)
            elif isinstance(record, Channel):
                channels[record.id] = record.topic
            elif isinstance(record, Metadata) and record.name == NAME:
                heading = _heading.decode(record.metadata.get("heading", ""))
                headed = True
                yield heading
            elif isinstance(record, Attachment):
                yield Document(record.name, record.data)
    except _DAMAGE:
        if headed:
            yield Torn(damaged=bool(file.read(1)))
    if not headed:
        raise UsageError(f"{name}: not a recording of situ; give what situ run --record wrote")


class _Records(StreamReader):
    """Passes over where each message is in its chunk: all are read in their order, and of a million
    events that took as long as reading them.
    """

    def _read_record(self, opcode: int, length: int) -> McapRecord | None:
        if opcode == Opcode.MESSAGE_INDEX:
            self._stream.read(length)
            return None
        return super()._read_record(opcode, length)


def _messages(chunk: Chunk, channels: dict[int, str]) -> Iterator[Piece]:
    """The messages of a chunk; ``channels`` learns of those that begin in it.

    They are taken apart here: a reader of single records takes twice as long for a million.
    """
    stream, length = get_chunk_data_stream(chunk, validate_crc=True)
    data = stream.read(length)
    at = 0
    while at < length:
        kind, size = _RECORD.unpack_from(data, at)
        at += _RECORD.size
        if kind == Opcode.MESSAGE:
            channel, _, time, _ = _MESSAGE.unpack_from(data, at)
            body = data[at + _MESSAGE.size : at + size]
            topic = channels.get(channel)
            if topic == TRACE:
                # Most are; and a generator more is a third more of the time.
                yield Line(body, time)
            else:
                yield from _piece(topic, body, time)
        elif kind == Opcode.CHANNEL:
            begun = Channel.read(ReadDataStream(BytesIO(data[at : at + size])))
            channels[begun.id] = begun.topic
        at += size


def _piece(topic: str | None, body: bytes, time: int) -> Iterator[Piece]:
    """What a message is; nothing on a channel that is none of situ's."""
    if topic == TRACE:
        yield Line(body, time)
    elif topic == INPUTS:
        yield _taken.decode(body)
    elif topic == SNAPSHOT:
        yield Snapshot(body)


class Difference(Struct, frozen=True):
    """The first event that is not the same. recorded, decided: its JSON, None where there is none;
    t: the time in s of the step."""

    t: float
    recorded: str | None
    decided: str | None

    def __str__(self) -> str:
        return (
            f"at {self.t:g} s recorded was {self.recorded or 'no further event'}, "
            f"decided now is {self.decided or 'no further event'}"
        )


def again(recording: Iterable[Piece], name: str) -> Difference | None:
    """Feeds the inputs to a new robot; where its trace differs first from what was recorded.

    name: the file's. Raises UsageError where the recording does not hold what that needs.
    """
    robot: Robot | None = None
    heading, documents = Heading(), []
    expected: deque[bytes] = deque()
    t = 0.0
    for piece in recording:
        if isinstance(piece, Heading):
            heading = piece
            if heading.masked:
                raise UsageError(
                    f"{name}: private values are masked, so it holds no inputs and can not be "
                    "decided again; give the recording as it lies on the robot"
                )
        elif isinstance(piece, Document):
            documents.append(piece)
        elif isinstance(piece, Snapshot):
            robot = _robot(heading, documents, name)
            try:
                robot.restore(piece.state)
            except (msgspec.DecodeError, ValueError):
                raise UsageError(f"{name}: its snapshot is damaged, or another situ's") from None
        elif isinstance(piece, Taken):
            if expected:
                return Difference(t, None, expected[0].decode().rstrip())
            if robot is None:
                if not isinstance(piece.given, Start):
                    raise UsageError(f"{name}: it lacks where the robot began")
                robot = _robot(heading, documents, name)
            t = piece.us / SECOND
            expected.extend(map(to_line, robot.step(piece.given, piece.us)[0]))
        elif isinstance(piece, Line):
            if robot is None:
                raise UsageError(
                    f"{name}: it holds a trace without inputs, so it can not be decided again; "
                    "record with situ run --record"
                )
            recorded = bare(piece.text)
            decided = expected.popleft() if expected else None
            if decided is None or recorded != decided:
                said = None if decided is None else decided.decode().rstrip()
                return Difference(t, recorded.decode("utf-8", "replace").rstrip(), said)
        else:
            # Events of the last step may be lost with it.
            return None
    return Difference(t, None, expected[0].decode().rstrip()) if expected else None


def bare(line: bytes) -> bytes:
    """The event without the time of day that live traces have, as ``to_line``."""
    event, found, _ = line.rpartition(b',"time":"')
    return event + b"}\n" if found else line + b"\n"


def _robot(heading: Heading, documents: list[Document], name: str) -> Robot:
    """One that runs the project as it ran."""
    project = loaded(heading, documents)
    if project is None:
        raise UsageError(f"{name}: the project that it holds can not be read")
    project = replace(project, name=heading.project, tags=heading.tags)
    files = {document.path: document.data.decode(errors="replace") for document in documents}
    return Robot(project, heading.deployed, files)


def loaded(heading: Heading, documents: Iterable[Document]) -> Project | None:
    """The project that these documents are; None where they are none."""
    with tempfile.TemporaryDirectory() as place:
        for document in documents:
            path = PurePosixPath(document.path)
            if path.is_absolute() or ".." in path.parts:
                return None
            file = Path(place, path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(document.data)
        try:
            return folder.load(Path(place, heading.file))[0]
        except UsageError:
            return None


@functools.cache
def trace_schema() -> bytes:
    """JSON Schema of the events on ``/trace``: each kind's under ``oneOf``, above them what all
    have, so that who looks at no more than that can draw it."""
    kinds = TraceEvent.__subclasses__()
    one_of, definitions = msgspec.json.schema_components(kinds, ref_template="#/$defs/{name}")
    text, number = {"type": "string"}, {"type": "number"}
    shared = {"seq": {"type": "integer"}, "t": number, "kind": text, "time": text}
    return msgspec.json.encode(
        {
            "title": "situ.Trace",
            "type": "object",
            "properties": shared,
            "required": ["seq", "t", "kind", "cause"],
            "oneOf": list(one_of),
            "$defs": definitions,
        }
    )


@functools.cache
def inputs_schema() -> bytes:
    """JSON Schema of the steps on ``/inputs``."""
    _, definitions = msgspec.json.schema_components([Taken], ref_template="#/$defs/{name}")
    taken = definitions.pop("Taken")
    return msgspec.json.encode({**taken, "title": "situ.Input", "$defs": definitions})


class _Entry(Struct):
    value: Any = None


class _Board(Struct):
    board: dict[str, _Entry] = {}


_board = msgspec.json.Decoder(_Board)
_heading = msgspec.json.Decoder(Heading)
_taken = msgspec.json.Decoder(Taken)
_DAMAGE = (
    McapError,
    ValueError,
    struct.error,
    zstandard.ZstdError,
    msgspec.MsgspecError,
    OverflowError,
    MemoryError,
)
"""What damaged bytes raise."""
