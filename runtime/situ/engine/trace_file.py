"""The trace of a running robot, recorded by who follows it (``situ trace --record``)."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path
from typing import Any

import msgspec

from situ.engine.record import OneFile
from situ.rehearse.mcap_file import McapFile
from situ.rehearse.recorded import TRACE, Heading


class TraceFile:
    """A recording of a trace without inputs, of which ``flush`` makes whole what was added.

    The events of a core that was started anew go to the next file (``OneFile``). Raises UsageError
    where a file can not be made, OSError where it can not be written.
    """

    def __init__(self, path: Path, heading: Heading, documents: dict[str, str]) -> None:
        self._path = path
        self._documents = documents
        self._heading = heading
        self._last = 0
        self._file = self._open(goes_on=False)

    def add(self, event: dict[str, Any]) -> None:
        """An event as the robot tells it."""
        if event["seq"] <= self._last:
            self._file.finish()
            self._file = self._open(goes_on=True)
        self._last = event["seq"]
        moment = datetime.fromisoformat(event["time"]).timestamp()
        self._file.add(TRACE, moment, msgspec.json.encode(event))

    def flush(self) -> None:
        self._file.flush()

    def close(self) -> None:
        self._file.finish()

    def _open(self, *, goes_on: bool) -> McapFile:
        file = OneFile(self._path, goes_on=goes_on).open()
        return McapFile(file, self._heading, self._documents)
