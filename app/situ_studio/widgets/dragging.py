"""Buttons that are dragged: pressed and moved, they carry something; a press alone is a click."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QMimeData, QObject, QPoint, Qt
from PySide6.QtGui import QDrag, QMouseEvent, QPixmap
from PySide6.QtWidgets import QAbstractButton, QApplication


class Dragging(QObject):
    """Drags of one button, for as long as that lives.

    carried: what a drag carries, at the time of the drag. picture: what is seen beside the pointer;
    without, the button as it looks.
    """

    def __init__(
        self,
        button: QAbstractButton,
        carried: Callable[[], QMimeData],
        picture: Callable[[], QPixmap] | None = None,
    ) -> None:
        super().__init__(button)
        self._button = button
        self._carried = carried
        self._picture = picture or button.grab
        self._press: QPoint | None = None
        button.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if not isinstance(event, QMouseEvent):
            return False
        kind, at = event.type(), event.position().toPoint()
        if kind == QEvent.Type.MouseMove:
            self._on_move(at)
            # A button that is left while it is pressed would show itself as not pressed.
            return True
        if event.button() == Qt.MouseButton.LeftButton:
            self._press = at if kind == QEvent.Type.MouseButtonPress else None
        return False

    def _on_move(self, at: QPoint) -> None:
        far = QApplication.startDragDistance()
        if self._press is None or (at - self._press).manhattanLength() < far:
            return
        self._press = None
        self._button.setDown(False)
        drag = QDrag(self._button)
        drag.setMimeData(self._carried())
        drag.setPixmap(self._picture())
        drag.exec(Qt.DropAction.CopyAction)
