"""What a timeline does not know: hatched, with how many events it lacks."""

from __future__ import annotations

from collections.abc import Iterable

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QBrush, QFontMetricsF, QPainter, QPen

from situ_studio.live.log import Gap
from situ_studio.live.timeline.axis import TimeAxis
from situ_studio.live.timeline.painting import GUTTER
from situ_studio.looks.letters import px
from situ_studio.looks.theme import CAPTION, Theme, font
from situ_studio.wording.language import tr

LEAST = 3.0
"""Px that a gap has at least, however short it is."""


def words(gap: Gap) -> str:
    """``1,234 events are not known``."""
    return tr("{0} events are not known").format(f"{gap.count:,}")


def seen(axis: TimeAxis, gap: Gap) -> tuple[float, float] | None:
    """From where to where the gap is on the axis, in px; None where it is not seen."""
    start, end = max(axis.x(gap.t), 0.0), min(axis.x(gap.to), axis.width)
    if end < 0.0 or start > axis.width:
        return None
    return (start, end) if end - start >= LEAST else (max(end - LEAST, 0.0), end)


def at(gaps: Iterable[Gap], t: float, least: float = 0.0) -> Gap | None:
    """The gap that a moment is in; None where it is in none. least: seconds that each counts for at
    least."""
    for gap in gaps:
        if min(gap.t, gap.to - least) < t < gap.to:
            return gap
    return None


def paint_gaps(
    painter: QPainter,
    theme: Theme,
    axis: TimeAxis,
    gaps: Iterable[Gap],
    row: tuple[float, float],
    named: bool,
) -> None:
    """Over a row of their run: nothing that stands there is known to have been so.

    row: its upper edge and its height. named: says how many events each lacks.
    """
    top, high = row
    painter.setFont(font(CAPTION, 600))
    metrics = QFontMetricsF(painter.font())
    for gap in gaps:
        place = seen(axis, gap)
        if place is None:
            continue
        start, end = place
        band = QRectF(start + px(GUTTER), top + 1, end - start, high - 1)
        painter.fillRect(band, theme.color("panel"))
        painter.fillRect(band, QBrush(theme.color("text3"), Qt.BrushStyle.BDiagPattern))
        if not named:
            continue
        said = words(gap)
        wide = metrics.horizontalAdvance(said) + px(12)
        if wide > band.width():
            continue
        box = QRectF(0, 0, wide, px(18))
        box.moveCenter(band.center())
        painter.setPen(QPen(theme.color("card_border"), 1))
        painter.setBrush(theme.color("card"))
        painter.drawRoundedRect(box, 3, 3)
        painter.setPen(theme.color("text"))
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, said)
