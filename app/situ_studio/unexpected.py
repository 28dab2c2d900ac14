"""What nobody expected: faults of the studio itself, and signals that end it from outside."""

from __future__ import annotations

import logging
import platform
import signal
import socket
import sys
import threading
import traceback
from collections.abc import Callable
from types import FrameType, TracebackType

import PySide6
from PySide6.QtCore import QObject, QSocketNotifier, Signal
from PySide6.QtWidgets import QApplication

import situ
from situ_studio.wording.language import tr

_log = logging.getLogger("situ.studio")

Handler = Callable[[int, FrameType | None], object] | int | None
"""What ``signal.signal`` takes and gives back."""
SIGNALS = [
    getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)
]
"""Ctrl-C, a polite kill, a terminal that was closed."""


class Unexpected(QObject):
    """``sys.excepthook``: a fault of ours in a slot is logged and told once, with its details.

    What is not saved is kept first, by ``keep``. The studio runs on: what is open can still be
    saved. tell: a sentence, and the details.
    """

    _elsewhere = Signal(object, object, object)

    def __init__(self, keep: Callable[[], None], tell: Callable[[str, str], None]) -> None:
        super().__init__()
        self._keep, self._tell = keep, tell
        self._told: set[str] = set()
        self._telling = False
        self._elsewhere.connect(self)

    def __call__(
        self, kind: type[BaseException], error: BaseException, trace: TracebackType | None
    ) -> None:
        if issubclass(kind, KeyboardInterrupt):
            QApplication.quit()
            return
        _log.error("A fault in the studio", exc_info=(kind, error, trace))
        line = f"{kind.__name__}: {error}"
        if self._telling or line in self._told:
            return
        self._told.add(line)
        self._telling = True
        try:
            try:
                self._keep()
            except Exception:
                # A second fault must not hide the first, of which a person is told below.
                _log.exception("Unsaved changes could not be kept")
            self._tell(_sentence(), _details(kind, error, trace))
        finally:
            self._telling = False

    def in_thread(self, found: threading.ExceptHookArgs) -> None:
        """``threading.excepthook``: as any other, told by the thread of the windows."""
        value = found.exc_value
        if value is not None:
            self._elsewhere.emit(found.exc_type, value, found.exc_traceback)


def _sentence() -> str:
    return tr(
        "Something in Situ Studio itself went wrong. Your documents are as they were, and what is "
        "not saved is kept: save, and go on. To help us mend it, copy the details into a report."
    )


def _details(kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> str:
    versions = (
        f"Situ Studio {situ.__version__}, Python {platform.python_version()}, "
        f"Qt {PySide6.__version__}, {platform.platform()}"
    )
    return "\n".join((versions, *traceback.format_exception(kind, error, trace)))


class Hooks:
    """While it is entered, every fault of the program goes to ``unexpected``."""

    def __init__(self, unexpected: Unexpected) -> None:
        self._unexpected = unexpected

    def __enter__(self) -> None:
        self._before = sys.excepthook, threading.excepthook
        sys.excepthook, threading.excepthook = self._unexpected, self._unexpected.in_thread

    def __exit__(self, *_: object) -> None:
        sys.excepthook, threading.excepthook = self._before


class Interrupts(QObject):
    """What stops a program from outside ends the loop; Qt would not notice it by itself."""

    def __init__(self, qt: QApplication) -> None:
        super().__init__()
        self._qt = qt
        self._read, self._write = socket.socketpair()
        self._read.setblocking(False)
        self._write.setblocking(False)
        self._notifier = QSocketNotifier(self._read.fileno(), QSocketNotifier.Type.Read, self)
        self._notifier.activated.connect(self._on_signal)
        self._old: dict[int, Handler] = {}
        self._wakeup = -1

    def __enter__(self) -> Interrupts:
        self._wakeup = signal.set_wakeup_fd(self._write.fileno(), warn_on_full_buffer=False)
        for number in SIGNALS:
            self._old[number] = signal.signal(number, lambda *_: None)
        return self

    def __exit__(self, *_: object) -> None:
        signal.set_wakeup_fd(self._wakeup)
        for number, handler in self._old.items():
            signal.signal(number, handler)
        self._notifier.setEnabled(False)
        self._read.close()
        self._write.close()

    def _on_signal(self) -> None:
        self._read.recv(64)
        # Whoever stops the program from outside is not asked anything by a dialog.
        self._qt.exit(0)
