"""The messages of ``protocol`` as bytes: JSON, on ZeroMQ a notice after its topic."""

from __future__ import annotations

from typing import Any

import msgspec
from msgspec import Struct

from situ.blackboard import notices, protocol, replies
from situ.errors import BlackboardError

MAXIMUM = 16_000_000
"""Bytes of one message; pictures and sound go by URL."""

DEPTH = 100
"""Levels of lists and objects in a value; what is deeper could not be worked with."""


class Malformed(BlackboardError):
    """A message that is none of version 1; ``id`` is its request's where that could be read."""

    def __init__(self, message: str, id: int | None = None) -> None:
        super().__init__(message)
        self.id = id


_encoder = msgspec.json.Encoder()
_requests: msgspec.json.Decoder[protocol.AnyRequest] = msgspec.json.Decoder(protocol.AnyRequest)
_requests_as_found = msgspec.json.Decoder()
_replies: msgspec.json.Decoder[replies.AnyReply] = msgspec.json.Decoder(replies.AnyReply)
_notices: msgspec.json.Decoder[notices.AnyNotice] = msgspec.json.Decoder(notices.AnyNotice)


class _Id(Struct):
    id: int | None = None


_id = msgspec.json.Decoder(_Id)

# What decoding can raise: a JSON text may be no UTF-8, or nested too deep.
_BROKEN = (msgspec.MsgspecError, UnicodeError, RecursionError)


def encode(message: protocol.Request | replies.Reply | notices.Notice) -> bytes:
    """The body of a message; its values must be JSON values."""
    return _encoder.encode(message)


def read_request(body: bytes) -> protocol.AnyRequest:
    """Raises ``Malformed``, with the request's id where there is one, and nothing else."""
    try:
        request = _requests.decode(body)
        # Most bodies are too short of brackets to be looked at.
        if body.count(b"[") + body.count(b"{") > DEPTH and too_deep(
            _requests_as_found.decode(body)
        ):
            raise RecursionError
        return request
    except _BROKEN as error:
        raise Malformed(
            f"no request of version {protocol.VERSION}: {_said(error)}; see docs/protocol.md",
            read_id(body),
        ) from None


def read_id(body: bytes) -> int | None:
    """The id of a request, however wrong the rest of it is; None where it has none."""
    try:
        return _id.decode(body).id
    except _BROKEN:
        return None


def read_reply(body: bytes) -> replies.AnyReply:
    """Raises ``Malformed`` and nothing else."""
    try:
        return _replies.decode(body)
    except _BROKEN as error:
        raise Malformed(f"no reply of version {protocol.VERSION}: {_said(error)}") from None


def read_notice(frame: bytes) -> notices.AnyNotice:
    """A frame with its topic. Raises ``Malformed`` and nothing else."""
    try:
        begin = frame.index(b"\n") + 1
        # Where there is little to copy that is faster than to look at it in its place.
        return _notices.decode(frame[begin:] if len(frame) < 4_096 else memoryview(frame)[begin:])
    except (*_BROKEN, ValueError) as error:
        raise Malformed(f"no notice of version {protocol.VERSION}: {_said(error)}") from None


def notice(topic: bytes, body: notices.Notice) -> bytes:
    """One frame: topic (which ends with a newline) and body."""
    return topic + _encoder.encode(body)


def too_deep(value: Any) -> bool:
    """Whether there are more than ``DEPTH`` levels, and those of a request round the value."""
    level: list[Any] = [value]
    for _ in range(DEPTH + 3):
        level = [
            inner
            for outer in level
            for inner in (outer.values() if isinstance(outer, dict) else outer)
            if isinstance(inner, dict | list)
        ]
        if not level:
            return False
    return True


def _said(error: Exception) -> str:
    if isinstance(error, RecursionError):
        return "it is nested too deep"
    return str(error).replace("\n", " ")
