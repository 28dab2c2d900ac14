"""What stands on a pipe: its event's name on a gap, a guard or a counter in a pill."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor, QPainter, QPen, Qt

from situ_studio.canvas.routes import Point, Route
from situ_studio.canvas.style import HALF, Label, Look, whole_label

GUARD_HEIGHT = 22.0
LABEL_HEIGHT = 18.0
PIXELS = 12
LEAST = 11.0
"""Px on screen that a label keeps where cards are small."""
LONGEST = 220.0
"""A label is cut at this width."""
LARGEST = LEAST / PIXELS / HALF


class PipeLabel:
    """The label of one route, that has a place for it. pill: it is a guard."""

    def __init__(self, route: Route, said: str, pill: bool) -> None:
        assert route.label is not None
        self._x, self._y = route.label
        self._pill = pill
        room = route.room - (36 if pill else 10)
        self._text = Label(said, PIXELS, 500, min(LONGEST, max(20.0, room)))
        self._stretch = max(
            (abs(ax - bx) for (ax, ay), (bx, by) in pairwise(route.points) if ay == by == self._y),
            default=0.0,
        )
        wide = self._text.width + (36 if pill else 10)
        tall = GUARD_HEIGHT if pill else LABEL_HEIGHT
        self.area = QRectF(self._x - wide / 2, self._y - tall / 2, wide, tall)
        """In the scene, at 100 %."""

    @property
    def width(self) -> float:
        """Of the words alone."""
        return self._text.width

    def is_shown(self, look: Look) -> bool:
        """Whether it is painted though no mouse is on it: small drawings leave the guards."""
        return self._pill or look.level == "full"

    def leave_free(self, points: Sequence[Point]) -> list[tuple[Point, ...]]:
        """The way before the label and the way after it."""
        x, y = self._x, self._y
        wide, tall = self.area.width() / 2, self.area.height() / 2
        for index, ((ax, ay), (bx, by)) in enumerate(pairwise(points)):
            if ay == by == y and min(ax, bx) <= x <= max(ax, bx):
                step = (wide if bx > ax else -wide, 0.0)
            elif ax == bx == x and min(ay, by) <= y <= max(ay, by):
                step = (0.0, tall if by > ay else -tall)
            else:
                continue
            before, after = (x - step[0], y - step[1]), (x + step[0], y + step[1])
            return [(*points[: index + 1], before), (after, *points[index + 1 :])]
        return [tuple(points)]

    def reach(self) -> QRectF:
        """Where it is painted at any zoom."""
        wide, tall = self.area.width() * LARGEST / 2, self.area.height() * LARGEST / 2
        return QRectF(self._x - wide, self._y - tall, 2 * wide, 2 * tall)

    def paint(
        self, painter: QPainter, look: Look, ink: QColor, selected: bool, hovered: bool
    ) -> None:
        """Small cards leave the guards, as a shield where the words have no room, and what the
        mouse is on; both as large as can be read."""
        if look.level == "full":
            self._paint_whole(painter, look, ink, selected)
            return
        scale = self._scale(look)
        if hovered or (self._pill and self.area.width() * scale < self._stretch - 40):
            self._enlarge(painter, scale)
            self._paint_whole(painter, look, ink, selected)
            painter.restore()
        elif self._pill:
            self._enlarge(painter, scale)
            self._paint_pill(painter, look, QRectF(self._x - 9, self._y - 9, 18, 18), selected)
            look.icon(painter, "guard", self._x - 7, self._y - 7, 14, look["condition"])
            painter.restore()

    def paint_count(self, painter: QPainter, look: Look, count: int, taken: bool) -> None:
        """Live: how often the robot went this way."""
        self._enlarge(painter, 1.0 if look.level == "full" else self._scale(look))
        text = whole_label(f"{count}×", 14, 600)
        box = QRectF(self._x - text.width / 2 - 8, self._y - 11, text.width + 16, 22)
        painter.setPen(QPen(look["live"] if taken else look["line_strong"], 1.25 if taken else 1))
        painter.setBrush(look["live_soft"] if taken else look["panel"])
        painter.drawRoundedRect(box, 11, 11)
        text.draw_middle(painter, self._x, self._y + 5, look["live"] if taken else look["text2"])
        painter.restore()

    @staticmethod
    def _scale(look: Look) -> float:
        return max(1.0, LEAST / PIXELS / look.zoom)

    def _enlarge(self, painter: QPainter, scale: float) -> None:
        painter.save()
        painter.translate(self._x, self._y)
        painter.scale(scale, scale)
        painter.translate(-self._x, -self._y)

    def _paint_pill(self, painter: QPainter, look: Look, area: QRectF, selected: bool) -> None:
        painter.setPen(QPen(look["condition"], 1.5 if selected else 1))
        painter.setBrush(look["condition_soft"])
        painter.drawRoundedRect(area, area.height() / 2, area.height() / 2)

    def _paint_whole(self, painter: QPainter, look: Look, ink: QColor, selected: bool) -> None:
        box = self.area
        if self._pill and look.level != "full":
            # Enlarged, it would reach the cards above and below.
            box = box.adjusted(0, 2, 0, -2)
        if self._pill:
            self._paint_pill(painter, look, box, selected)
            look.icon(painter, "guard", box.left() + 6, self._y - 7, 14, look["condition"])
            self._text.draw(painter, box.left() + 23, self._y + 4, look["condition"])
            return
        if look.level != "full":
            # Enlarged, it lies over others.
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(look["canvas"])
            painter.drawRoundedRect(box, 4, 4)
        self._text.draw_middle(painter, self._x, self._y + 4, ink)
