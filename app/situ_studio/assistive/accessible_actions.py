"""What an assistive program can do with a part of a drawing or of a screen: choose it, open it."""

from __future__ import annotations

from typing import Protocol

from PySide6.QtGui import QAccessibleActionInterface
from shiboken6 import VoidPtr

NOTHING_MORE = VoidPtr(0)
"""What ``interface_cast`` answers where a part can not do what is asked for.

None, which the binding itself answers there, ends the process as soon as a screen reader asks.
"""


class Acting(Protocol):
    """A part of the accessible tree."""

    def do(self, name: str) -> None:
        """``Press`` is a double click, ``SetFocus`` a click."""
        ...


class PartActions(QAccessibleActionInterface):
    """The actions of one part; they live as long as it does."""

    def __init__(self, part: Acting) -> None:
        super().__init__()
        self._part = part

    def actionNames(self) -> list[str]:
        return [self.pressAction(), self.setFocusAction()]

    def doAction(self, actionName: str) -> None:
        self._part.do(actionName)

    def keyBindingsForAction(self, actionName: str) -> list[str]:
        return []
