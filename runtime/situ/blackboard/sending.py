"""The client's half of a deploy: what it asks, one request after the other (docs/protocol.md).

::

    wanted = stage(dialog, files, main)
    for piece in pieces(files, wanted): send(dialog, piece)
    deploy(dialog, None)
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from situ.blackboard import protocol, replies
from situ.blackboard.calls import Call
from situ.blackboard.dialog import Dialog

PIECE = 700_000
"""Bytes of one request: less than a frame of the WebSocket door, in base64 too."""


def stage(dialog: Dialog, files: Mapping[str, bytes], main: str | None) -> Call[replies.Staged]:
    """Announces files. main: what the project is read from; None: all other files stay."""
    sent = {path: protocol.Sent(len(d), hashlib.sha256(d).hexdigest()) for path, d in files.items()}
    request = protocol.Stage(id=dialog.next_id(), files=sent, main=main)
    return dialog.ask(request, _same, again=False)


def pieces(files: Mapping[str, bytes], wanted: Iterable[str]) -> Iterator[tuple[str, int, bytes]]:
    """Path, offset and bytes of all that is to be sent."""
    for path in wanted:
        for offset in range(0, len(files[path]), PIECE):
            yield path, offset, files[path][offset : offset + PIECE]


def send(dialog: Dialog, piece: tuple[str, int, bytes]) -> Call[replies.Done]:
    path, offset, data = piece
    request = protocol.Piece(id=dialog.next_id(), path=path, offset=offset, data=data)
    # One that has come already is passed over.
    return dialog.ask(request, _same, again=True)


def deploy(dialog: Dialog, force_after: float | None) -> Call[replies.Deployment]:
    request = protocol.Deploy(id=dialog.next_id(), force_after=force_after)
    return dialog.ask(request, _same, again=False)


def rollback(
    dialog: Dialog, version: int | None, force_after: float | None
) -> Call[replies.Deployment]:
    number = dialog.next_id()
    request = protocol.Rollback(id=number, version=version, force_after=force_after)
    return dialog.ask(request, _same, again=False)


def progress(dialog: Dialog) -> Call[replies.Deployment]:
    return dialog.ask(protocol.Progress(id=dialog.next_id()), _same, again=True)


def history(dialog: Dialog) -> Call[replies.Turns]:
    return dialog.ask(protocol.History(id=dialog.next_id()), _same, again=True)


def _same(reply: Any) -> Any:
    return reply
