"""The pipe that somebody is drawing: from an exit to the cursor."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QPainter, QPainterPath, QPen, Qt
from PySide6.QtWidgets import QGraphicsItem, QGraphicsPathItem, QStyleOptionGraphicsItem
from PySide6.QtWidgets import QWidget as Widget

from situ_studio.canvas.library import PipeItem
from situ_studio.canvas.style import Look


class DrawnPipe(PipeItem):
    """The pipe between an exit and the cursor, while somebody draws one."""

    def __init__(self, look: Look) -> None:
        QGraphicsPathItem.__init__(self)
        self._input_port = self._output_port = None
        self._color, self._style = (0, 0, 0, 255), 0
        self._active = self._highlight = False
        self.look = look
        self.shift_selected = False
        self._end: QPointF | None = None
        self._good = False
        self.setZValue(5)
        self.setCacheMode(QGraphicsItem.CacheMode.NoCache)
        self.setAcceptedMouseButtons(Qt.MouseButton.NoButton)

    def shape(self) -> QPainterPath:
        return QPainterPath()

    def boundingRect(self) -> QRectF:
        return QRectF(self.path().boundingRect().adjusted(-16, -16, 16, 16))

    def draw_path(
        self, start_port: Any, end_port: Any = None, cursor_pos: Any = None, color: Any = None
    ) -> None:
        if start_port is None or cursor_pos is None:
            return
        self.draw_index_pointer(start_port, cursor_pos, color)

    def draw_index_pointer(self, start_port: Any, cursor_pos: Any, color: Any = None) -> None:
        self.prepareGeometryChange()
        start = start_port.centre()
        end = QPointF(cursor_pos)
        self._end = end
        path = QPainterPath(start)
        reach = max(24.0, min(120.0, abs(end.x() - start.x()) / 2))
        path.cubicTo(start + QPointF(reach, 0), end - QPointF(reach, 0), end)
        self.setPath(path)

    def aim(self, good: bool) -> None:
        """Whether what is under the cursor would take the pipe."""
        if good != self._good:
            self._good = good
            self.update()

    def reset_path(self) -> None:
        self.prepareGeometryChange()
        self._end, self._good = None, False
        self.setPath(QPainterPath())

    def reset(self) -> None:
        return

    def paint(
        self, painter: QPainter, option: QStyleOptionGraphicsItem, widget: Widget | None = None
    ) -> None:
        if self._end is None:
            return
        look = self.look
        pen = QPen(look["accent"], 2)
        if not self._good:
            pen.setDashPattern([3, 2])
        painter.setPen(pen)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawPath(self.path())
        painter.setBrush(look["accent"])
        painter.setPen(Qt.PenStyle.NoPen)
        painter.drawEllipse(self._end, 4.5, 4.5)

    def delete(self) -> None:
        return
