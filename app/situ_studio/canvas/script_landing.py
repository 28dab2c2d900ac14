"""A situation that is dragged: a line shows where among the others it will stand."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QPainterPath, QPen
from PySide6.QtWidgets import QGraphicsPathItem

from situ_studio.canvas.script_faces import LEFT, WIDTH, ScriptNode
from situ_studio.wording.language import tr

if TYPE_CHECKING:
    from situ_studio.canvas.script import ScriptCanvas

BESIDE = 22.0
"""How far the line is seen at both sides of what is dragged over it."""
THICK = 3.0


class Landing:
    """Knows while one situation is dragged which number it would get; ``number`` is 0 for the
    one that it has."""

    def __init__(self, canvas: ScriptCanvas) -> None:
        self._canvas = canvas
        self._line: QGraphicsPathItem | None = None
        self.number = 0

    def follow(self, moved: Mapping[str, tuple[float, float]]) -> None:
        """To be called when cards were dragged to other places."""
        dragged = self._canvas.dragged(moved)
        if dragged is None or self._canvas.viewer.dragged_to() is None:
            return
        index = self._canvas.index_at(moved[dragged.uid][1] + dragged.height / 2, dragged.uid)
        number = index + 1 if index != dragged.number - 1 else 0
        if number != self.number:
            self.number = number
            self._show(self._between(dragged, index) if number else None)
            told = tr("{0} becomes number {1}").format(dragged.name, number)
            self._canvas.status.emit(told if number else "")

    def end(self) -> None:
        """The drag has ended."""
        if self.number:
            self.number = 0
            self._show(None)
            self._canvas.status.emit("")

    def _between(self, dragged: ScriptNode, index: int) -> float:
        """The height of the line: half way between those that it would stand between."""
        cards = self._canvas.graph.cards.values()
        others = [c for c in cards if c.kind == "situation" and c.uid != dragged.uid]
        if index == 0:
            return float(others[0].y - 10)
        above = others[index - 1]
        end = above.y + above.height
        return float((end + others[index].y) / 2 if index < len(others) else end + 10)

    def _show(self, height: float | None) -> None:
        if self._line is None:
            self._line = QGraphicsPathItem()
            # Above the other cards, below the one that is dragged.
            self._line.setZValue(1.5)
            self._line.setAcceptedMouseButtons(Qt.MouseButton.NoButton)
            self._canvas.viewer.scene().addItem(self._line)
        path = QPainterPath()
        if height is not None:
            left = LEFT["situation"]
            path.moveTo(QPointF(left - BESIDE, height))
            path.lineTo(QPointF(left + WIDTH["situation"] + BESIDE, height))
        ink = self._canvas.look["accent"]
        self._line.setPen(QPen(ink, THICK, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
        self._line.setPath(path)
