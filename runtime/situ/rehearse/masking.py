"""Recordings for those who may not see private values (``situ.decide.masking``)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import msgspec
from msgspec.structs import replace

from situ.decide.masking import Mask
from situ.rehearse.recorded import (
    Document,
    Heading,
    Line,
    Piece,
    Snapshot,
    Torn,
    board_of,
    loaded,
)
from situ.rehearse.recording import Fields


def masked(recording: Iterable[Piece]) -> Iterator[Piece]:
    """The same recording as a viewer may see it: its trace, without what is private."""
    heading, mask = Heading(), Mask(())
    documents: list[Document] = []
    ended: list[Piece] = []
    moment: list[tuple[Line, Fields]] = []
    for piece in recording:
        if documents and isinstance(piece, (Line, Snapshot)):
            project = loaded(heading, documents)
            if project is not None:
                mask = Mask.of(replace(project, private=heading.private))
            documents = []
        if isinstance(piece, Line):
            event = msgspec.json.decode(piece.text)
            if moment and moment[0][1]["t"] != event["t"]:
                yield from _shown(mask, moment)
                moment = []
            moment.append((piece, event))
        elif isinstance(piece, Heading):
            heading, mask = piece, Mask(piece.private)
            yield replace(piece, tags={}, masked=True)
        elif isinstance(piece, Document):
            documents.append(piece)
        elif isinstance(piece, Snapshot):
            for tag, value in board_of(piece.state).items():
                mask.know(tag, value)
        elif isinstance(piece, Torn):
            ended.append(piece)
    yield from _shown(mask, moment)
    yield from ended


def _shown(mask: Mask, moment: list[tuple[Line, Fields]]) -> Iterator[Line]:
    events = mask.step([event for _, event in moment])
    for (line, _), event in zip(moment, events, strict=True):
        yield Line(msgspec.json.encode(event), line.at)
