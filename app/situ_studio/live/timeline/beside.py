"""Other runs in a timeline: each of their rows stands below ours, and where they part is marked."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from msgspec import Struct
from msgspec.structs import replace
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPen, QPolygonF

from situ.rehearse.comparing import Difference, Stretch
from situ_studio.live.log import TraceLog
from situ_studio.live.timeline.axis import TimeAxis
from situ_studio.live.timeline.bookmarks import Bookmark
from situ_studio.live.timeline.painting import GUTTER, RowPainter, StateName
from situ_studio.live.timeline.rows import TimelineRow
from situ_studio.looks.letters import px
from situ_studio.looks.theme import CAPTION, Theme, font

LETTERS = "ABCDEFGH"
"""What the runs are called in the drawing; A is the one whose moment all views show."""
LONGEST = 120
"""Px that a bookmark's name gets at most."""
LETTER = 20
"""Px that a letter takes of a row's name."""


class RunBeside:
    """A run that is looked at beside another. shift: how many seconds its clock is ahead."""

    def __init__(self, log: TraceLog, theme: Theme, state_name: StateName) -> None:
        self.log = log
        self.shift = 0.0
        self.bookmarks: tuple[Bookmark, ...] = ()
        self.axis = TimeAxis()
        self.painter = RowPainter(self.axis, theme, state_name)
        self.painter.spare = LETTER

    def go_with(self, axis: TimeAxis) -> None:
        """Shows the stretch of time that stands on ``axis``, by its own clock."""
        self.axis.start, self.axis.seen = axis.start + self.shift, axis.seen
        self.axis.width = axis.width

    @property
    def end(self) -> float:
        """The last moment that is known, by its own clock."""
        return self.log.lanes.end


class Marked(Struct, frozen=True):
    """A difference of the first run to that one. chosen: the one that is told about."""

    run: int
    difference: Difference
    chosen: bool = False


def interleaved(own: list[TimelineRow], others: Sequence[list[TimelineRow]]) -> list[TimelineRow]:
    """Each of our rows with those of the other runs of the same thing below it; then what only
    others have."""
    every = {(row.kind, row.name): [row] for row in own}
    for run, rows in enumerate(others, 1):
        for row in rows:
            every.setdefault((row.kind, row.name), []).append(replace(row, run=run))
    kinds = ("state", "situation", "resource", "data")
    found = sorted(every.values(), key=lambda rows: kinds.index(rows[0].kind))
    return [row for rows in found for row in rows]


def paint_letter(painter: QPainter, theme: Theme, run: int, top: float, height: float) -> None:
    """Which run a row is of, at the right of its name."""
    box = QRectF(px(GUTTER) - px(22), top + (height - px(16)) / 2, px(16), px(16))
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(theme.color("accent_soft" if run == 0 else "warning_soft"))
    painter.drawRoundedRect(box, 3, 3)
    painter.setFont(font(CAPTION, 600))
    painter.setPen(theme.color("accent" if run == 0 else "warning"))
    painter.drawText(box, Qt.AlignmentFlag.AlignCenter, LETTERS[run])


def paint_bookmarks(
    painter: QPainter,
    theme: Theme,
    tops: Iterable[tuple[TimelineRow, float]],
    runs: Sequence[RunBeside],
) -> None:
    """Those of the runs beside: a dashed line through their own rows, its name in the first."""
    named: set[int] = set()
    painter.setFont(font(CAPTION, 500))
    metrics = painter.fontMetrics()
    for row, top in tops:
        if row.run == 0:
            continue
        run = runs[row.run - 1]
        for mark in run.bookmarks:
            if not run.axis.sees(mark.t):
                continue
            x = run.axis.x(mark.t) + px(GUTTER)
            painter.setPen(QPen(theme.color("accent"), 1, Qt.PenStyle.DashLine))
            painter.drawLine(QPointF(x, top), QPointF(x, top + px(row.height)))
            if row.run in named:
                continue
            words = metrics.elidedText(mark.name, Qt.TextElideMode.ElideRight, px(LONGEST))
            flag = QRectF(x, top + px(2), metrics.horizontalAdvance(words) + px(8), px(15))
            painter.setPen(QPen(theme.color("accent_line"), 1))
            painter.setBrush(theme.color("card"))
            painter.drawRoundedRect(flag, 3, 3)
            painter.setPen(theme.color("text"))
            painter.drawText(flag, Qt.AlignmentFlag.AlignCenter, words)
        named.add(row.run)


def paint_differences(
    painter: QPainter,
    theme: Theme,
    tops: Iterable[tuple[TimelineRow, float]],
    axes: Sequence[TimeAxis],
    marked: Sequence[Marked],
) -> None:
    """In each row of what differs a diamond where it begins, and a line below what was done;
    hollow where that run did nothing.

    axes: of each run.
    """
    color = theme.color("warning")
    size = px(5)
    # Runs that part thousands of times are drawn many times a second: not each for every row.
    by_strand: dict[tuple[str, str], list[tuple[Marked, Stretch]]] = {}
    for mark in marked:
        for stretch in mark.difference.stretches:
            by_strand.setdefault(stretch.strand, []).append((mark, stretch))
    for row, top in tops:
        axis, below = axes[row.run], top + px(row.height) - px(4)
        last = -float(size)
        side = 0 if row.run == 0 else 1
        for mark, stretch in by_strand.get((row.kind, row.name), ()):
            if row.run not in (0, mark.run):
                continue
            deeds = (stretch.first, stretch.second)[side]
            x = axis.x(stretch.at[side])
            end = axis.x(deeds[-1].t) if deeds else x
            if end < -size or x > axis.width + size or (x - last < 2 and end - last < 2):
                # Beside what is seen, or where there is a mark already.
                continue
            last = end
            left = QPointF(x + px(GUTTER), below)
            painter.setPen(QPen(color, px(3) if mark.chosen else px(2)))
            painter.drawLine(left, QPointF(max(end, x) + px(GUTTER), below))
            wide = size + (px(2) if mark.chosen else 0)
            painter.setPen(QPen(color, 1.5))
            painter.setBrush(color if deeds else theme.color("panel"))
            painter.drawPolygon(_diamond(left, wide))


def _diamond(middle: QPointF, half: float) -> QPolygonF:
    sides = ((-half, 0.0), (0.0, -half), (half, 0.0), (0.0, half))
    return QPolygonF([middle + QPointF(x, y) for x, y in sides])
