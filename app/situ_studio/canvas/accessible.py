"""Cards for screen readers: the viewer's children in the accessible tree (canvas.md).

Qt exposes no items of a graphics view by itself. One factory is installed per
process, before a viewer is first asked for; it knows viewers by their class.
"""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QCoreApplication, QObject, QRect, QRectF
from PySide6.QtGui import (
    QAccessible,
    QAccessibleEvent,
    QAccessibleInterface,
    QColor,
    QWindow,
)
from PySide6.QtWidgets import QAccessibleWidget

from situ_studio.canvas.nodes import NodeFace
from situ_studio.canvas.viewer import Viewer

INSTALLED = "situ_cards_are_accessible"


class AccessibleViewer(QAccessibleWidget):
    """The drawing: a list of its cards in document order."""

    def __init__(self, viewer: Viewer) -> None:
        super().__init__(viewer, QAccessible.Role.Canvas, "Drawing")
        self._viewer = viewer
        # Qt holds no reference to what Python hands it.
        self._cards: dict[int, AccessibleCard] = {}

    def _items(self) -> list[NodeFace]:
        return list(self._viewer.cards_in_order())

    def childCount(self) -> int:
        return len(self._items())

    def child(self, index: int) -> Any:
        items = self._items()
        return self._card(items[index]) if 0 <= index < len(items) else None

    def indexOfChild(self, child: QAccessibleInterface) -> int:
        for index, item in enumerate(self._items()):
            if isinstance(child, AccessibleCard) and child.item is item:
                return index
        return -1

    def _card(self, item: NodeFace) -> AccessibleCard:
        kept = self._cards.get(id(item))
        if kept is None or kept.item is not item:
            kept = self._cards[id(item)] = AccessibleCard(self, item)
        return kept


class AccessibleCard(QAccessibleInterface):
    """One card: what it is called, what it shows, where it is; valid while it is in the scene."""

    def __init__(self, parent: AccessibleViewer, item: NodeFace) -> None:
        super().__init__()
        self._parent = parent
        self.item = item

    def isValid(self) -> bool:
        return self.item.scene() is not None

    def object(self) -> Any:
        return None

    def window(self) -> QWindow:
        return self._parent.window()

    def parent(self) -> QAccessibleInterface:
        return self._parent

    def childCount(self) -> int:
        return 0

    def child(self, index: int) -> Any:
        return None

    def childAt(self, x: int, y: int) -> Any:
        return None

    def indexOfChild(self, child: QAccessibleInterface) -> int:
        return -1

    def role(self) -> QAccessible.Role:
        return QAccessible.Role.ListItem

    def state(self) -> QAccessible.State:
        state = QAccessible.State()
        state.selectable = True
        state.selected = self.item.isSelected()
        return state

    def rect(self) -> QRect:
        viewer = self.item.viewer()
        if viewer is None:
            return QRect()
        area = self.item.mapRectToScene(QRectF(0, 0, self.item.width, self.item.height))
        area = viewer.mapFromScene(area).boundingRect()
        return QRect(viewer.viewport().mapToGlobal(area.topLeft()), area.size())

    def text(self, kind: QAccessible.Text) -> str:
        if kind == QAccessible.Text.Name:
            return str(self.item.face.hint().split("\n")[0])
        if kind == QAccessible.Text.Description:
            return str(self.item.face.spoken())
        return ""

    def setText(self, kind: QAccessible.Text, text: str) -> None:
        return

    def backgroundColor(self) -> QColor:
        return QColor()

    def foregroundColor(self) -> QColor:
        return QColor()


def install() -> None:
    """Makes cards known to screen readers; once a process, further calls do nothing."""
    application = QCoreApplication.instance()
    if application is not None and not application.property(INSTALLED):
        application.setProperty(INSTALLED, True)
        QAccessible.installFactory(_factory)


def _factory(name: str, watched: QObject) -> Any:
    if not isinstance(watched, Viewer):
        return None
    # Kept by what it speaks for: Qt holds no reference.
    watched.spoken_as = AccessibleViewer(watched)
    return watched.spoken_as


def tell_focus(viewer: Viewer, index: int) -> None:
    """A screen reader, if one listens, hears which card is chosen now."""
    if QAccessible.isActive():
        event = QAccessibleEvent(viewer, QAccessible.Event.Focus)
        event.setChild(index)
        QAccessible.updateAccessibility(event)
