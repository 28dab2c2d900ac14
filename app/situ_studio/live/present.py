"""The modules that a robot knows: who is connected, and what each tells of itself."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from situ_studio.live.link import RobotLink
from situ_studio.live.moment import TraceFields

if TYPE_CHECKING:
    from situ.blackboard.replies import ModuleState

COMINGS = ("connected", "lost", "deployed")


class PresentModules(QObject):
    """``modules`` are those of the robot that ``link`` is connected to; none where it is not."""

    changed = Signal()

    def __init__(self, link: RobotLink, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.modules: tuple[ModuleState, ...] = ()
        self._link = link
        self._live = False
        link.state_changed.connect(self._on_state)
        link.came.connect(self._on_came)
        self._on_state()

    def _on_state(self) -> None:
        live = self._link.connected
        if live and not self._live:
            self._link.ask_modules(self, self._become)
        elif not live:
            self._become(())
        self._live = live

    def _on_came(self, events: list[TraceFields]) -> None:
        if any(event["kind"] in COMINGS for event in events):
            self._link.ask_modules(self, self._become)

    def _become(self, modules: tuple[ModuleState, ...]) -> None:
        if modules != self.modules and (self._link.connected or not modules):
            self.modules = modules
            self.changed.emit()
