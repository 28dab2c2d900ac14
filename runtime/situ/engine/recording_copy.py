"""A recording made of another one (``situ replay -o``): in whole chunks, with an index."""

from __future__ import annotations

from collections.abc import Iterable

import msgspec

from situ.engine.record import Files
from situ.rehearse.mcap_file import McapFile
from situ.rehearse.recorded import (
    INPUTS,
    SNAPSHOT,
    TRACE,
    Document,
    Heading,
    Line,
    Piece,
    Snapshot,
    Taken,
)


def write(files: Files, pieces: Iterable[Piece]) -> None:
    """Writes the pieces into the one file of ``files``. Raises OSError."""
    heading = Heading()
    documents: dict[str, str] = {}
    file: McapFile | None = None
    # What has no time of day of its own has that of the event behind it.
    waiting: list[tuple[str, bytes]] = []
    descriptor, at = files.open(), 0.0
    for piece in pieces:
        if isinstance(piece, Heading):
            heading = piece
        elif isinstance(piece, Document):
            documents[piece.path] = piece.data.decode("utf-8", "replace")
        elif isinstance(piece, Snapshot):
            waiting.append((SNAPSHOT, piece.state))
        elif isinstance(piece, Taken):
            waiting.append((INPUTS, msgspec.json.encode(piece)))
        elif isinstance(piece, Line):
            file = file or McapFile(descriptor, heading, documents)
            at = piece.at / 1e9
            for topic, body in waiting:
                file.add(topic, at, body)
            waiting.clear()
            file.add(TRACE, at, piece.text)
    file = file or McapFile(descriptor, heading, documents)
    for topic, body in waiting:
        file.add(topic, at, body)
    file.finish()
