"""What a screen reader takes a widget for, where Qt would take it for another thing.

One factory is installed per process. A widget that is not spoken for here stays Qt's.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QCoreApplication, QObject
from PySide6.QtGui import QAccessible, QAccessibleActionInterface
from PySide6.QtWidgets import QAccessibleWidget, QWidget

from situ_studio.assistive.accessible_actions import NOTHING_MORE, PartActions

INSTALLED = "situ_roles_are_heard"
ROLE, SPOKEN = "heard_as", "spoken_as"


def hear_as(
    widget: QWidget, role: QAccessible.Role, press: Callable[[Any], object] | None = None
) -> None:
    """To be said before anybody asks for the widget, whose name and description stay its own.

    press: what Enter does there; it gets the widget, and holds none.
    """
    application = QCoreApplication.instance()
    if application is not None and not application.property(INSTALLED):
        application.setProperty(INSTALLED, True)
        QAccessible.installFactory(_factory)
    setattr(widget, ROLE, (role, press))


class HeardWidget(QAccessibleWidget):
    """Qt's own, with another role, and with what can be done."""

    def __init__(self, widget: QWidget, role: QAccessible.Role) -> None:
        super().__init__(widget, role, "")
        # Qt keeps this as long as it likes: the widget is asked for, and not held.
        self._actions = PartActions(self)

    def interface_cast(self, kind: QAccessible.InterfaceType) -> Any:
        if kind == QAccessible.InterfaceType.ActionInterface:
            return self._actions
        return NOTHING_MORE

    def do(self, name: str) -> None:
        """``Press`` is Enter, ``SetFocus`` a click that does nothing more."""
        widget = self.object()
        if not isinstance(widget, QWidget):
            return
        _, press = getattr(widget, ROLE)
        if name == QAccessibleActionInterface.setFocusAction():
            widget.setFocus()
        elif name == QAccessibleActionInterface.pressAction() and press is not None:
            press(widget)


def _factory(name: str, watched: QObject) -> Any:
    told = getattr(watched, ROLE, None)
    if told is None or not isinstance(watched, QWidget):
        return None
    # Kept by what it speaks for: Qt holds no reference.
    spoken_as = HeardWidget(watched, told[0])
    setattr(watched, SPOKEN, spoken_as)
    return spoken_as
