"""The trace of a core that may be killed, as far back as its backlog goes, or nearly.

``core/trace`` and, before it, ``core/trace.1``: frames, the first the runtime's id, each other one
the events between two snapshots. What came after the last snapshot is not in it: a core that goes
on makes those events again.
"""

from __future__ import annotations

import contextlib
import os
from pathlib import Path

import msgspec

from situ.blackboard.backlog import Backlog, Line
from situ.engine import frames

LIMIT = 8_000_000
"""Bytes of a file; then it becomes the one before."""


class KeptTrace:
    """Raises OSError where nothing can be written; ``load`` never does."""

    def __init__(self, folder: Path) -> None:
        self._now, self._before = folder / "trace", folder / "trace.1"
        self._file: int | None = None
        self._size = 0
        self._last = 0

    def load(self, runtime: str, last: int) -> list[Line]:
        """Events without a gap, ``last`` the last; none where that one is not there."""
        lines: list[Line] = []
        for file in (self._before, self._now):
            for line in _lines(file, runtime):
                # Those of a snapshot that was not made came once more with the next.
                while lines and lines[-1][0] >= line[0]:
                    lines.pop()
                if lines and lines[-1][0] + 1 != line[0]:
                    lines.clear()
                lines.append(line)
        while lines and lines[-1][0] > last:
            lines.pop()
        return lines if lines and lines[-1][0] == last else []

    def follow(self, runtime: str, backlog: Backlog) -> None:
        """Adds the events that have come since the last call; with the first begins anew."""
        if self._file is None or self._size > LIMIT:
            if self._file is None:
                self._last = 0
                self._before.unlink(missing_ok=True)
            else:
                os.close(self._file)
                self._file = None
                self._now.replace(self._before)
            # What is there stands until the new one is whole.
            new = self._now.with_suffix(".new")
            self._file = frames.create(new, runtime.encode())
            self._size = 0
            self._add(backlog)
            new.replace(self._now)
        else:
            self._add(backlog)

    def _add(self, backlog: Backlog) -> None:
        assert self._file is not None
        lines = backlog.after(self._last, LIMIT)
        if lines:
            self._size += frames.append(self._file, _encode(lines))
            self._last = lines[-1][0]

    def forget(self) -> None:
        if self._file is not None:
            os.close(self._file)
            self._file = None
        for file in (self._now, self._before):
            with contextlib.suppress(OSError):
                file.unlink(missing_ok=True)


def _lines(file: Path, runtime: str) -> list[Line]:
    """What can be read of one file; nothing of another run's."""
    try:
        found = frames.read(file.read_bytes())
    except OSError:
        return []
    first = next(found, None)
    if first is None or first[0] != runtime.encode():
        return []
    lines: list[Line] = []
    for body, _ in found:
        try:
            lines += _decode(body)
        except msgspec.MsgspecError:
            break
    return lines


_encode = msgspec.msgpack.Encoder().encode
_decode = msgspec.msgpack.Decoder(list[Line]).decode
