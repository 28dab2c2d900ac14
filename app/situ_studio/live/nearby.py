"""The robots that announce themselves, followed by a process beside the window."""

from __future__ import annotations

from collections.abc import Sequence

import msgspec
from msgspec import Struct
from PySide6.QtCore import QObject, QProcess, Signal

from situ_studio.processes.worker import module
from situ_studio.wording.language import tr


class Found(Struct, frozen=True):
    """A robot. standing: as ``situ.blackboard.nearby.Standing``, or ``gone``. key: as in
    ``Announced``."""

    name: str
    standing: str = "gone"
    endpoint: str = ""
    key: str = ""


class _Told(Struct):
    name: str = ""
    standing: str = "gone"
    endpoint: str = ""
    key: str = ""
    failed: str = ""


class NearbyRobots(QObject):
    """Follows them from ``start`` to ``stop``. interfaces: as in ``Nearby``.

    robots: name to robot; those that have gone stay there, as gone. failed: why none can be
    found, in one line.
    """

    changed = Signal()

    def __init__(self, interfaces: Sequence[str] = (), parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.robots: dict[str, Found] = {}
        self.failed = ""
        self._command = (*module("situ_studio.live.nearby_process"), *interfaces)
        # No child: a process that is destroyed while it runs would end on its own time.
        self._process: QProcess | None = None

    def start(self) -> None:
        process = QProcess()
        self._process = process
        process.readyReadStandardOutput.connect(self._read)
        process.finished.connect(self._on_gone)
        process.errorOccurred.connect(self._on_error)
        process.start(self._command[0], self._command[1:])

    def stop(self) -> None:
        """Ends the process at once; it holds nothing."""
        process, self._process = self._process, None
        if process is not None:
            process.blockSignals(True)
            process.kill()
            process.waitForFinished()
            process.deleteLater()

    def _read(self) -> None:
        process = self._process
        while process is not None and process.canReadLine():
            told = msgspec.json.decode(process.readLine().data(), type=_Told)
            if told.failed:
                self.failed = told.failed
            elif told.standing != "gone":
                self.robots[told.name] = Found(told.name, told.standing, told.endpoint, told.key)
            elif told.name in self.robots:
                before = self.robots[told.name]
                self.robots[told.name] = msgspec.structs.replace(before, standing="gone")
        self.changed.emit()

    def _on_error(self, error: QProcess.ProcessError) -> None:
        if error == QProcess.ProcessError.FailedToStart:
            self._on_gone()

    def _on_gone(self) -> None:
        """It ended though nobody asked it to: what was found may be gone by now."""
        self.failed = self.failed or tr("the program that looks for them has ended")
        self.robots = {
            name: msgspec.structs.replace(one, standing="gone") for name, one in self.robots.items()
        }
        self.changed.emit()
