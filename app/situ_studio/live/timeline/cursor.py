"""The cursor of a timeline: a line through all rows, its time, and what each number is there."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QFontMetricsF, QPainter, QPen

from situ_studio.live.lanes import Series
from situ_studio.live.timeline.axis import TimeAxis
from situ_studio.live.timeline.painting import EDGE, GUTTER
from situ_studio.live.timeline.rows import TimelineRow
from situ_studio.live.viewing import Viewing
from situ_studio.looks.letters import px
from situ_studio.looks.theme import CAPTION, Theme, font
from situ_studio.wording.language import tr
from situ_studio.wording.value_words import number

Placed = tuple[TimelineRow, float, float]
"""A row, where its upper edge is, and how many seconds the clock of its run is ahead of ours."""


class CursorPainter:
    """Where ``viewing`` is on ``axis``; and where the robot is now, if that is elsewhere."""

    def __init__(self, axis: TimeAxis, theme: Theme, viewing: Viewing) -> None:
        self.axis, self.theme, self.viewing = axis, theme, viewing

    def paint(self, painter: QPainter, size: QSize, rows: Sequence[Placed]) -> None:
        """Over everything else."""
        viewing, t = self.viewing, self.viewing.t
        if viewing.follows:
            # Its clock has gone on since the rows were laid to end at it.
            t = min(t, self.axis.end)
        if viewing.grows and not viewing.follows:
            self._moment(painter, size, viewing.span[1], tr("now"), "live")
        token = "live" if viewing.follows else "accent"
        self._moment(painter, size, t, viewing.written(t), token)
        if self.axis.sees(t):
            self._values(painter, size, rows, t)

    def _moment(self, painter: QPainter, size: QSize, t: float, words: str, token: str) -> None:
        """A line through all rows, and what it says at the top."""
        if not self.axis.sees(t):
            return
        x = self.axis.x(t) + px(GUTTER)
        color = self.theme.color(token)
        painter.setPen(QPen(color, 1.5))
        painter.drawLine(QPointF(x, px(EDGE) - 4), QPointF(x, size.height()))
        painter.setFont(font(CAPTION, 600))
        wide = QFontMetricsF(painter.font()).horizontalAdvance(words) + 12
        left = min(max(x - wide / 2, px(GUTTER)), size.width() - wide - 2)
        flag = QRectF(left, 3, wide, px(EDGE - 7))
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(color)
        painter.drawRoundedRect(flag, 3, 3)
        painter.setPen(self.theme.color("on_accent"))
        painter.drawText(flag, Qt.AlignmentFlag.AlignCenter, words)

    def _values(self, painter: QPainter, size: QSize, rows: Sequence[Placed], t: float) -> None:
        theme, x = self.theme, self.axis.x(t) + px(GUTTER)
        painter.setFont(font(CAPTION, 500))
        metrics = QFontMetricsF(painter.font())
        painter.setClipRect(QRectF(0, px(EDGE), size.width(), size.height()))
        for row, top, shift in rows:
            if not isinstance(row.lane, Series):
                continue
            value = row.lane.at(t + shift)
            if value != value:
                continue
            words = told(row.lane, value)
            wide = metrics.horizontalAdvance(words) + 8
            left = x + 5 if x + 5 + wide < size.width() else x - 5 - wide
            box = QRectF(left, top + px(row.height - 21), wide, px(16))
            painter.setPen(QPen(theme.color("card_border"), 1))
            painter.setBrush(theme.color("card"))
            painter.drawRoundedRect(box, 3, 3)
            painter.setPen(theme.color("text"))
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, words)
        painter.setClipping(False)


def told(series: Series, value: float) -> str:
    """A number of a series as it is written."""
    if series.truth and value in (0.0, 1.0):
        return "true" if value else "false"
    return number(value)
