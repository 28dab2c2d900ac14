"""The studio's log: a file of bounded size that goes with a report, without what people wrote.

Texts of documents stand in the messages of exceptions; of those the log keeps the type and where
they came from, not the message.
"""

from __future__ import annotations

import faulthandler
import logging
import traceback
from logging.handlers import RotatingFileHandler
from pathlib import Path
from types import TracebackType
from typing import IO

from PySide6.QtCore import QMessageLogContext, QStandardPaths, QtMsgType

SIZE = 256 * 1024
"""Bytes after which a new file begins."""
OLD = 2
"""Files that are kept beside the one that is written."""
_qt = logging.getLogger("situ.qt")
_LEVELS = {
    QtMsgType.QtDebugMsg: logging.DEBUG,
    QtMsgType.QtInfoMsg: logging.INFO,
    QtMsgType.QtWarningMsg: logging.WARNING,
    QtMsgType.QtCriticalMsg: logging.ERROR,
    QtMsgType.QtFatalMsg: logging.CRITICAL,
}


def usual_folder() -> Path:
    """Where the user's programs keep their state."""
    kind = QStandardPaths.StandardLocation.GenericStateLocation
    return Path(QStandardPaths.writableLocation(kind)) / "situ-studio"


class LogFile:
    """Writes ``studio.log`` in ``folder`` while it is open; says nothing where it can not.

    A crash below Python leaves its traces in ``crash.log`` beside it.
    """

    def __init__(self, folder: Path) -> None:
        self.path = folder / "studio.log"
        self._handler: logging.Handler | None = None
        self._crash: IO[str] | None = None

    def open(self) -> None:
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            handler = _Silent(
                self.path, maxBytes=SIZE, backupCount=OLD, encoding="utf-8", delay=False
            )
            self._crash = (self.path.parent / "crash.log").open("w", encoding="utf-8")
        except OSError:
            return
        handler.setLevel(logging.INFO)
        handler.setFormatter(_WithoutTexts("%(asctime)s %(levelname)s %(name)s: %(message)s"))
        self._handler = handler
        logging.getLogger().addHandler(handler)
        faulthandler.enable(self._crash)

    def close(self) -> None:
        if self._handler is not None:
            logging.getLogger().removeHandler(self._handler)
            self._handler.close()
            self._handler = None
        if self._crash is not None:
            faulthandler.disable()
            self._crash.close()
            self._crash = None

    def end(self, most: int = 64 * 1024) -> str:
        """Its last ``most`` bytes, from a line's beginning; nothing where there is none."""
        try:
            data = self.path.read_bytes()[-most:]
        except OSError:
            return ""
        text = data.decode(errors="replace")
        return text.partition("\n")[2] if len(data) == most else text


class _Silent(RotatingFileHandler):
    """A disk that is full does not become a flood of words about it."""

    def handleError(self, record: logging.LogRecord) -> None:
        pass


class _WithoutTexts(logging.Formatter):
    """Without the messages of exceptions."""

    def format(self, record: logging.LogRecord) -> str:
        # Another handler's formatter leaves there what it wrote, messages included.
        kept, record.exc_text = record.exc_text, None
        try:
            return super().format(record)
        finally:
            record.exc_text = kept

    def formatException(
        self,
        ei: tuple[type[BaseException], BaseException, TracebackType | None]
        | tuple[None, None, None],
    ) -> str:
        kind, _, trace = ei
        frames = traceback.StackSummary.extract(traceback.walk_tb(trace), lookup_lines=False)
        lines = [f"  {one.filename}:{one.lineno} in {one.name}" for one in frames]
        return "\n".join((*lines, kind.__name__ if kind is not None else ""))


def on_qt_message(kind: QtMsgType, where: QMessageLogContext, text: str) -> None:
    """What Qt says goes where everything goes."""
    _qt.log(_LEVELS.get(kind, logging.WARNING), "%s", text)
