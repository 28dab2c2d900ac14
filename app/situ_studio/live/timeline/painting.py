"""How a timeline's rows look: blocks with names, who holds what, curves of numbers."""

from __future__ import annotations

from collections.abc import Callable
from typing import cast

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QFontMetrics, QFontMetricsF, QPainter, QPen

from situ_studio.live.lanes import NAN, Lane, Series
from situ_studio.live.timeline.axis import TimeAxis
from situ_studio.live.timeline.drawn import Block, Extremes, Strokes, blocks
from situ_studio.live.timeline.rows import RowKind, TimelineRow
from situ_studio.looks import icons
from situ_studio.looks.letters import px
from situ_studio.looks.theme import CAPTION, LABEL, Theme, font
from situ_studio.wording.language import tr
from situ_studio.wording.value_words import number

EDGE = 24
"""Px of the strip at the top with the time."""
GUTTER = 132
"""Px at the left for the rows' names."""
NARROW = 3
"""Px below which blocks are put together."""
NAMED = 4
"""Letters of its name that must fit into a block: fewer say nothing."""
ICONS: dict[RowKind, str] = {
    "state": "state",
    "situation": "situation",
    "resource": "resource",
    "data": "data",
}

StateName = Callable[[str, str], str]
"""What a designer calls a state: application and its number to words."""


class RowPainter:
    """Paints rows into a painter whose left edge is the gutter's; rows know nothing of time.

    end: the moment after which nothing is known yet.
    """

    def __init__(self, axis: TimeAxis, theme: Theme, state_name: StateName) -> None:
        self.axis = axis
        self.theme = theme
        self.state_name = state_name
        self.spare = 0
        """Px at the right of the rows' names that something else has."""
        self._extremes: dict[str, Extremes] = {}
        self._ranges: dict[str, tuple[float, float] | None] = {}

    def forget(self) -> None:
        """What follows is of another log."""
        self._extremes.clear()

    def title(self, painter: QPainter, row: TimelineRow, top: float) -> None:
        """The row's icon and name, and of numbers between what they were drawn."""
        theme, high = self.theme, px(row.height)
        sign = QRectF(px(12), top + px(6), px(14), px(14))
        icons.paint(painter, ICONS[row.kind], sign, theme.color(row.kind))
        painter.setFont(font(LABEL))
        painter.setPen(theme.color("text"))
        name = row.name or tr("Situation")
        metrics = QFontMetricsF(painter.font())
        shown = metrics.elidedText(name, Qt.TextElideMode.ElideMiddle, px(GUTTER - 40 - self.spare))
        painter.drawText(QPointF(px(34), top + px(13) + metrics.ascent() / 2 - 1), shown)
        if row.kind == "data":
            between = self._ranges.get(row.name)
            if between is not None:
                painter.setFont(font(CAPTION))
                painter.setPen(theme.color("text3"))
                least, most = (f"{n:.3g}" if abs(n) < 1e3 else number(n) for n in between)
                words = tr("{0} to {1}").format(least, most)
                room = px(GUTTER - 38 - self.spare)
                words = painter.fontMetrics().elidedText(words, Qt.TextElideMode.ElideRight, room)
                painter.drawText(QPointF(px(34), top + high - px(9)), words)

    def row(self, painter: QPainter, row: TimelineRow, top: float, end: float) -> None:
        """The row's blocks or curve, up to ``end``."""
        if row.kind == "data":
            self._curve(painter, row, top, end)
            return
        axis, gutter, high = self.axis, px(GUTTER), px(row.height)
        lane = cast("Lane", row.lane)
        until = min(end, axis.end)
        painter.setFont(font(LABEL))
        metrics = painter.fontMetrics()
        for block in blocks(lane, axis.start, until, axis.pixel * NARROW):
            if block.value is None and block.many == 1:
                continue
            # A block that began before the left edge is named where it is seen.
            left = max(axis.x(block.start), -4.0)
            wide = max(min(axis.x(block.end), axis.width + 4.0) - left, 1.0)
            rect = QRectF(left + gutter, top + 3, wide, high - 6)
            self._block(painter, row, block, rect, block.end >= end)
            room = wide - 14
            if room < NARROW or block.many > 1:
                continue
            words = _fitting(metrics, self.words(row, block), int(room))
            if not words:
                continue
            painter.setPen(self.theme.color("text"))
            at = QRectF(rect.left() + 9, rect.top(), room, rect.height())
            painter.drawText(at, Qt.AlignmentFlag.AlignVCenter, words)

    def _block(
        self, painter: QPainter, row: TimelineRow, block: Block, rect: QRectF, goes_on: bool
    ) -> None:
        theme = self.theme
        token = "module" if row.kind == "resource" else row.kind
        lively = goes_on and row.kind == "state"
        edge = theme.color("live" if lively else token)
        if rect.width() < NARROW or block.many > 1:
            painter.setOpacity(0.55)
            painter.fillRect(rect, edge)
            painter.setOpacity(1.0)
            return
        # A hundred rows have some thousand blocks: as few calls as can be.
        painter.setPen(theme.color("live" if lively else "card_border"))
        painter.setBrush(theme.color("live_soft" if lively else f"{token}_soft"))
        painter.drawRoundedRect(rect.adjusted(0.5, 0.5, -0.5, -0.5), 3, 3)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(edge)
        painter.drawRoundedRect(QRectF(rect.left(), rect.top(), 3, rect.height()), 1.5, 1.5)

    def words(self, row: TimelineRow, block: Block) -> str:
        """What a block says."""
        if block.many > 1:
            return tr("{0} changes").format(block.many)
        if block.value is None:
            return tr("nobody") if row.kind == "resource" else tr("none")
        return self.state_name(row.name, block.value) if row.kind == "state" else block.value

    def _strokes(self, row: TimelineRow) -> Strokes:
        series = cast("Series", row.lane)
        kept = self._extremes.get(row.name)
        if kept is None or kept.series is not series:
            # Also where the robot began anew: what is kept of its run before goes.
            kept = self._extremes[row.name] = Extremes(series)
        axis = self.axis
        return kept.strokes(axis.start, axis.end, axis.pixel)

    def _curve(self, painter: QPainter, row: TimelineRow, top: float, end: float) -> None:
        strokes = self._strokes(row)
        series = cast("Series", row.lane)
        between = strokes.range
        self._ranges[row.name] = None if series.truth else between
        if between is None:
            return
        least, most = (0.0, 1.0) if series.truth else between
        if least == most:
            least, most = least - 1, most + 1
        # Some thousand strokes in each of 30 frames a second: no calls but for the lines.
        axis = self.axis
        gutter, whole = px(GUTTER), px(row.height)
        tall = (whole - 12) / (most - least)
        floor = top + whole - 6 + least * tall
        per, left, right = 1 / axis.pixel, gutter - axis.start / axis.pixel, gutter + axis.width
        starts = [max(t * per + left, gutter) for t in strokes.t]
        stops = [*starts[1:], min(end * per + left, right)]
        lines: list[QLineF] = []
        add, before = lines.append, NAN
        each = zip(starts, stops, strokes.low, strokes.high, strokes.last, strict=True)
        for x, after, low, high, last in each:
            if low == low:
                # Up to where the one before has ended, if there was one.
                low = before if before < low else low
                high = before if before > high else high
                if low < high:
                    add(QLineF(x, floor - low * tall, x, floor - high * tall))
                # A value holds until the next.
                if last == last and after > x + 0.5:
                    level = floor - last * tall
                    add(QLineF(x, level, after, level))
            before = last
        # All lines stand upright or lie: smoothing would cost much, and only blur them.
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
        painter.setPen(QPen(self.theme.color("data"), 1))
        painter.drawLines(lines)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)


def _fitting(metrics: QFontMetrics, words: str, room: int) -> str:
    """What of a block's name is seen in so many px: all, or its beginning; else nothing."""
    if metrics.horizontalAdvance(words) <= room:
        return words
    shown = metrics.elidedText(words, Qt.TextElideMode.ElideRight, room)
    return shown if len(shown) > NAMED else ""
