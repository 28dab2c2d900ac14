"""The trace of a running robot, written where ``--trace`` says."""

from __future__ import annotations

import logging
from collections.abc import Callable
from typing import Any

from situ.blackboard.backlog import stamped
from situ.decide.trace import TraceEvent

_log = logging.getLogger("situ.run")


class TraceOut:
    """Writes every step's events at once; a robot does not stand still because a disk is full.

    file: without a buffer, or standard output. torn: why the trace ended before the robot, then
    the rest is left out. gone: called when nobody reads the trace any longer.
    """

    def __init__(self, name: str, file: Any, gone: Callable[[], None]) -> None:
        self.torn: OSError | None = None
        self._name = name
        self._file = file
        self._gone = gone

    def heard(self, events: list[TraceEvent], moment: float) -> None:
        if self.torn is not None:
            return
        try:
            self._write(b"".join(stamped(event, moment) + b"\n" for event in events))
        except OSError as error:
            self.torn = error
            if isinstance(error, BrokenPipeError):
                self._gone()
            else:
                _log.error("%s: %s; the trace ends here", self._name, error.strerror)

    def status(self) -> int:
        """Whether it could be written: an exit status. Raises BrokenPipeError."""
        if isinstance(self.torn, BrokenPipeError):
            raise self.torn
        return 0 if self.torn is None else 1

    def _write(self, data: bytes) -> None:
        left = memoryview(data)
        while left:
            left = left[self._file.write(left) :]
        self._file.flush()
