"""Files that are read again after their writer was killed: frames of length, CRC-32 and body.

One that is not whole ends the file.
"""

from __future__ import annotations

import os
import struct
from collections.abc import Iterator
from pathlib import Path
from zlib import crc32

_HEAD = struct.Struct("<II")
_pack = _HEAD.pack


def append(file: int, body: bytes) -> int:
    """Hands one frame to the system; its bytes. Raises OSError, then the file may be torn."""
    # In the way of every reply: one call of the system, without a copy.
    size = _HEAD.size + len(body)
    head = _pack(len(body), crc32(body))
    written = os.writev(file, (head, body))
    while written < size:
        written += os.write(file, (head + body)[written:])
    return size


def create(file: Path, body: bytes) -> int:
    """A file of one frame, in place of what was there; open, to be appended to."""
    made = os.open(file, os.O_WRONLY | os.O_CREAT | os.O_TRUNC | os.O_CLOEXEC, 0o600)
    try:
        append(made, body)
    except BaseException:
        os.close(made)
        raise
    return made


def read(data: bytes) -> Iterator[tuple[bytes, int]]:
    """Bodies, each with where it ends, up to the first that is not whole."""
    at = 0
    while at + _HEAD.size <= len(data):
        length, check = _HEAD.unpack_from(data, at)
        begin, at = at + _HEAD.size, at + _HEAD.size + length
        body = data[begin:at]
        if len(body) < length or crc32(body) != check:
            return
        yield body, at
