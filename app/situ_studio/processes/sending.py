"""Documents sent to another process again and again, where mostly little of it is another.

Documents are values: a state or situation that is the same object as before is sent as a number.
"""

from __future__ import annotations

import io
import pickle
import struct
from collections.abc import Iterator
from typing import Any, BinaryIO

from situ.document.rbd import State
from situ.document.spds import Situation

PIECE = 50
"""Values in one frame: what is packed without the window having its turn, about 2 ms."""
_HEAD = struct.Struct(">I")


def framed(body: bytes) -> bytes:
    """One message of a stream: its length, then itself."""
    return _HEAD.pack(len(body)) + body


def frame(stream: BinaryIO) -> bytes | None:
    """The next message of a stream, waited for; None at its end."""
    head = stream.read(_HEAD.size)
    if len(head) < _HEAD.size:
        return None
    return stream.read(_HEAD.unpack(head)[0])


class Frames:
    """The messages of a stream that comes in pieces of any size."""

    def __init__(self) -> None:
        self._left = b""

    def take(self, came: bytes) -> list[bytes]:
        """The messages that are whole now, in order."""
        self._left += came
        whole = []
        while len(self._left) >= _HEAD.size:
            end = _HEAD.size + _HEAD.unpack_from(self._left)[0]
            if len(self._left) < end:
                break
            whole.append(self._left[_HEAD.size : end])
            self._left = self._left[end:]
        return whole


class Sending:
    """What one receiver has of the values that it was sent."""

    def __init__(self) -> None:
        # The values themselves are kept, so that no other gets the id of one that is gone.
        self._there: dict[int, Any] = {}

    def pack(self, value: Any, number: int) -> Iterator[bytes]:
        """The frames that make ``value``, called ``number``, of what was sent before.

        May be left after any of them, for another value.
        """
        whole, body = value, io.BytesIO()
        used: dict[int, Any] = {}

        class Naming(pickle.Pickler):
            def persistent_id(self, value: Any) -> int | None:
                if type(value) is not State and type(value) is not Situation:
                    return None
                used[id(value)] = value
                return id(value)

        Naming(body, pickle.HIGHEST_PROTOCOL).dump(whole)
        new = [key for key in used if key not in self._there]
        for at in range(0, len(new), PIECE):
            values = [(key, used[key]) for key in new[at : at + PIECE]]
            self._there.update(values)
            yield framed(pickle.dumps(values, pickle.HIGHEST_PROTOCOL))
        gone = self._there.keys() - used.keys()
        for key in gone:
            del self._there[key]
        yield framed(pickle.dumps((number, body.getvalue(), gone), pickle.HIGHEST_PROTOCOL))


class Receiving:
    """The other end of a ``Sending``."""

    def __init__(self) -> None:
        self._there: dict[int, Any] = {}

    def unpack(self, message: bytes) -> tuple[int, Any] | None:
        """A value and its number; None for what only prepares one."""
        came = pickle.loads(message)
        if isinstance(came, list):
            self._there.update(came)
            return None
        number, body, gone = came
        there = self._there

        class Named(pickle.Unpickler):
            def persistent_load(self, key: int) -> Any:
                return there[key]

        value = Named(io.BytesIO(body)).load()
        for key in gone:
            del there[key]
        return number, value
