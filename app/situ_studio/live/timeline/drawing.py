"""The timeline's drawing: rows over time, bookmarks and the cursor. It takes no hands."""

from __future__ import annotations

from math import inf

from PySide6.QtCore import QPoint, QPointF, QRectF, Qt, QTimer, Signal
from PySide6.QtGui import (
    QFontMetricsF,
    QHideEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPixmap,
    QResizeEvent,
    QShowEvent,
)
from PySide6.QtWidgets import QAbstractScrollArea

from situ_studio.live.lanes import Lane, Series
from situ_studio.live.log import Gap
from situ_studio.live.timeline import gaps
from situ_studio.live.timeline.axis import TimeAxis
from situ_studio.live.timeline.beside import (
    LETTER,
    Marked,
    RunBeside,
    interleaved,
    paint_bookmarks,
    paint_differences,
    paint_letter,
)
from situ_studio.live.timeline.bookmarks import Bookmark, Bookmarks
from situ_studio.live.timeline.cursor import CursorPainter, told
from situ_studio.live.timeline.drawn import blocks
from situ_studio.live.timeline.painting import EDGE, GUTTER, NARROW, RowPainter, StateName
from situ_studio.live.timeline.rows import TimelineRow, rows_of
from situ_studio.live.viewing import Viewing
from situ_studio.looks import icons
from situ_studio.looks.letters import px
from situ_studio.looks.theme import CAPTION, LABEL, Theme, font
from situ_studio.wording.language import tr

FRAME = 33
"""Milliseconds between two looks at a log that goes on."""
FLAG = 140
"""Px that a bookmark's name gets at most."""


class TimelineDrawing(QAbstractScrollArea):
    """Shows what ``viewing`` looks at; changes nothing."""

    marked = Signal()
    """What is seen is another stretch of time."""

    def __init__(
        self, theme: Theme, viewing: Viewing, bookmarks: Bookmarks, state_name: StateName
    ) -> None:
        super().__init__()
        self.axis = TimeAxis()
        self.viewing = viewing
        self.bookmarks = bookmarks
        self.rows: list[TimelineRow] = []
        self.chosen: frozenset[str] | None = None
        self._theme = theme
        self._painter = RowPainter(self.axis, theme, state_name)
        self._cursor = CursorPainter(self.axis, theme, viewing)
        self.beside: tuple[RunBeside, ...] = ()
        self.differences: tuple[Marked, ...] = ()
        self._picture = QPixmap()
        self._pictured: tuple[object, ...] = ()
        self._held = False
        """Whether a hand moves what is seen, which then must not move by itself."""
        self.setAccessibleName(tr("Timeline"))
        self.setFrameShape(QAbstractScrollArea.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.verticalScrollBar().valueChanged.connect(self.viewport().update)
        self._frames = QTimer(self)
        self._frames.setInterval(FRAME)
        self._frames.timeout.connect(self._go_on)
        viewing.exchanged.connect(self._on_exchanged)
        viewing.moved.connect(self._on_moved)
        bookmarks.changed.connect(self._changed)

    def set_theme(self, theme: Theme) -> None:
        self._theme = self._painter.theme = self._cursor.theme = theme
        for run in self.beside:
            run.painter.theme = theme
        self._changed()

    def choose(self, data: frozenset[str] | None) -> None:
        """The data whose curves are shown; None: the first that came."""
        self.chosen = data
        self._changed()

    def show_beside(self, runs: tuple[RunBeside, ...], differences: tuple[Marked, ...]) -> None:
        """Those runs below ours, and where they part; none: ours alone."""
        self.beside, self.differences = runs, differences
        self._painter.spare = LETTER if runs else 0
        self._changed()

    def zoom(self, factor: float) -> None:
        """About the cursor where it is seen, else about the middle."""
        t, axis = self.viewing.t, self.axis
        axis.zoom(factor, t if axis.start <= t <= axis.end else axis.t(axis.width / 2))
        self._changed()

    def show_all(self) -> None:
        """From the first moment to the last."""
        start, end = self.viewing.span
        for run in self.beside:
            start = min(start, run.log.lanes.start - run.shift)
            end = max(end, run.end - run.shift)
        self.axis.zoom(max(end - start, 0.1) * 1.02 / self.axis.seen, self.axis.start)
        self.axis.start = start - self.axis.seen * 0.01
        self._changed()

    # -- time goes on ------------------------------------------------------------------

    def _on_exchanged(self) -> None:
        self._painter.forget()
        # They stood beside the run that was looked at before.
        self.show_beside((), ())
        if not self.viewing.grows:
            self.show_all()
        self._changed()

    def _on_moved(self) -> None:
        if not self._frames.isActive() and self.isVisible():
            self._frames.start()
        self._bring()
        # A reader tells of what has the focus each change of it; ``told_moment`` says more.
        if not self.hasFocus():
            self.setAccessibleDescription(self.clock(self.viewing.t))
        self.viewport().update()

    def _bring(self) -> None:
        """What the cursor is at is seen."""
        before = self.axis.start
        if self.viewing.follows:
            self.axis.end_at(self.viewing.t, self.viewing.span[0])
        elif not self._held:
            self.axis.show(self.viewing.t)
        if before != self.axis.start:
            self.marked.emit()

    def _go_on(self) -> None:
        if self.viewing.follows:
            self._bring()
        rows = self._read_rows()
        if [id(row.lane) for row in rows] != [id(row.lane) for row in self.rows]:
            self._changed()
        if self._pictured != self._wanted():
            self.viewport().update()
        elif not self.viewing.grows:
            self._frames.stop()

    def _changed(self) -> None:
        self._pictured = ()
        self._lay_out()
        self.marked.emit()
        self.viewport().update()

    def _lay_out(self) -> None:
        self.rows = self._read_rows()
        room = self.viewport().height() - px(EDGE)
        high = sum(px(row.height) for row in self.rows)
        bar = self.verticalScrollBar()
        bar.setRange(0, max(0, high - room))
        bar.setPageStep(max(room, 1))
        bar.setSingleStep(26)

    def _read_rows(self) -> list[TimelineRow]:
        own = rows_of(self.viewing.log.lanes, self.chosen)
        data = frozenset(row.name for row in own if row.kind == "data")
        return interleaved(own, [rows_of(run.log.lanes, data) for run in self.beside])

    def resizeEvent(self, event: QResizeEvent) -> None:
        self.axis.width = max(self.viewport().width() - px(GUTTER), 1.0)
        self._changed()

    def showEvent(self, event: QShowEvent) -> None:
        self._changed()
        self._bring()
        self._frames.start()

    def hideEvent(self, event: QHideEvent) -> None:
        self._frames.stop()

    # -- the clock ---------------------------------------------------------------------

    def clock(self, t: float, finest: bool = True) -> str:
        """How that moment is written."""
        return self.viewing.written(t, finest)

    # -- painting ----------------------------------------------------------------------

    def _wanted(self) -> tuple[object, ...]:
        """What the picture depends on, but for what ``_changed`` tells."""
        axis, log = self.axis, self.viewing.log
        start, end = self.viewing.span
        others = tuple((run.log.seq, run.shift) for run in self.beside)
        # What comes later than the right edge changes nothing.
        seq = log.seq if log.lanes.end <= axis.end else -1
        bar = self.verticalScrollBar().value()
        return (axis.start, axis.seen, seq, start, min(end, axis.end), others, bar)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self.viewport())
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        wanted = self._wanted()
        if self._pictured != wanted:
            self._take_picture()
            self._pictured = wanted
        painter.drawPixmap(0, 0, self._picture)
        rows = [(row, top, self._run(row)[1]) for row, top in self._tops()]
        self._cursor.paint(painter, self.viewport().size(), rows)
        painter.end()

    def _take_picture(self) -> None:
        """All but the cursor: that moves much oftener."""
        scale, theme = self.devicePixelRatioF(), self._theme
        size = self.viewport().size()
        if self._picture.size() != size * scale:
            self._picture = QPixmap(size * scale)
            self._picture.setDevicePixelRatio(scale)
        self._picture.fill(theme.color("panel"))
        painter = QPainter(self._picture)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._paint_edge(painter)
        for run in self.beside:
            run.go_with(self.axis)
        named: set[int] = set()
        wide, high, edge, left = size.width(), size.height(), px(EDGE), px(GUTTER)
        for row, top in self._tops():
            below = top + px(row.height)
            if edge < below and top < high:
                painter.setClipRect(QRectF(left, edge, wide - left, high - edge))
                drawn, _, end = self._run(row)
                drawn.row(painter, row, top, end)
                unknown, place = self._unknown(row), (top, px(row.height))
                gaps.paint_gaps(painter, theme, drawn.axis, unknown, place, row.run not in named)
                named.add(row.run)
                painter.setClipRect(QRectF(0, edge, wide, high - edge))
                drawn.title(painter, row, top)
                if self.beside:
                    paint_letter(painter, theme, row.run, top, px(row.height))
                painter.setPen(theme.color("line"))
                painter.drawLine(QPointF(0, below), QPointF(wide, below))
        painter.setClipRect(QRectF(left, edge, wide - left, high - edge))
        paint_bookmarks(painter, theme, self._tops(), self.beside)
        if self.differences:
            axes = [self.axis, *(run.axis for run in self.beside)]
            paint_differences(painter, theme, self._tops(), axes, self.differences)
        painter.setClipping(False)
        self._paint_bookmarks(painter)
        painter.setPen(theme.color("line"))
        painter.drawLine(QPointF(px(GUTTER) - 0.5, px(EDGE)), QPointF(px(GUTTER) - 0.5, high))
        if not self.rows:
            painter.setFont(font(LABEL))
            painter.setPen(theme.color("text3"))
            room = QRectF(0, px(EDGE), wide, high - px(EDGE))
            painter.drawText(room, Qt.AlignmentFlag.AlignCenter, tr("Nothing has happened yet."))
        painter.end()

    def _paint_edge(self, painter: QPainter) -> None:
        theme, axis = self._theme, self.axis
        high = self.viewport().height()
        painter.setFont(font(CAPTION))
        metrics = QFontMetricsF(painter.font())
        # Without a clock there is no time before the run.
        first = -inf if self.viewing.wall() is not None else 0.0
        for t in axis.marks(metrics.horizontalAdvance("00:00:00.000") + 28, self._midnight()):
            if t < first:
                continue
            x = axis.x(t) + px(GUTTER)
            painter.setPen(theme.color("line"))
            painter.drawLine(QPointF(x, px(EDGE) - 6), QPointF(x, high))
            words = self.clock(t, finest=False)
            wide = metrics.horizontalAdvance(words)
            if x - wide / 2 > px(GUTTER) and x + wide / 2 < axis.width + px(GUTTER):
                painter.setPen(theme.color("text3"))
                painter.drawText(QPointF(x - wide / 2, px(EDGE - 9)), words)
        painter.setPen(theme.color("line"))
        painter.drawLine(QPointF(0, px(EDGE)), QPointF(self.viewport().width(), px(EDGE)))

    def _paint_bookmarks(self, painter: QPainter) -> None:
        theme, high = self._theme, self.viewport().height()
        painter.setFont(font(CAPTION, 500))
        for mark, flag in self._flags():
            x = self.axis.x(mark.t) + px(GUTTER)
            painter.setPen(QPen(theme.color("accent_line"), 1, Qt.PenStyle.DashLine))
            painter.drawLine(QPointF(x, px(EDGE)), QPointF(x, high))
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(theme.color("accent_soft"))
            painter.drawRoundedRect(flag, 3, 3)
            sign = QRectF(flag.left() + px(4), flag.top() + px(3), px(11), px(11))
            icons.paint(painter, "bookmark", sign, theme.color("accent"))
            painter.setPen(theme.color("text"))
            words = painter.fontMetrics().elidedText(
                mark.name, Qt.TextElideMode.ElideRight, int(flag.width()) - px(22)
            )
            room = flag.adjusted(px(18), 0, -px(4), 0)
            painter.drawText(room, Qt.AlignmentFlag.AlignVCenter, words)

    def _flags(self) -> list[tuple[Bookmark, QRectF]]:
        """The bookmarks that are seen, and where their flags are."""
        metrics = QFontMetricsF(font(CAPTION, 500))
        found = []
        for mark in self.bookmarks.every:
            x = self.axis.x(mark.t) + px(GUTTER)
            if px(GUTTER) <= x <= self.axis.width + px(GUTTER):
                wide = min(metrics.horizontalAdvance(mark.name) + px(24), px(FLAG))
                found.append((mark, QRectF(x, 3, wide, px(EDGE - 7))))
        return found

    def _midnight(self) -> float:
        """A moment at which the clock on the wall stands at 0, so that marks are whole times."""
        begun = self.viewing.wall()
        if begun is None:
            return 0.0
        day = begun.replace(hour=0, minute=0, second=0, microsecond=0)
        return -(begun - day).total_seconds()

    def _tops(self) -> list[tuple[TimelineRow, float]]:
        top = float(px(EDGE) - self.verticalScrollBar().value())
        found = []
        for row in self.rows:
            found.append((row, top))
            top += px(row.height)
        return found

    def _run(self, row: TimelineRow) -> tuple[RowPainter, float, float]:
        """What paints the row's run, how far its clock is ahead of ours, its end by its own."""
        if row.run == 0:
            return self._painter, 0.0, self.viewing.span[1]
        run = self.beside[row.run - 1]
        return run.painter, run.shift, run.end

    def _unknown(self, row: TimelineRow) -> list[Gap]:
        """What is not known of the row's run, by its own clock."""
        return (self.beside[row.run - 1] if row.run else self.viewing).log.unknown

    # -- words --------------------------------------------------------------------------

    def row_at(self, at: QPoint) -> TimelineRow | None:
        """The row of a place on the drawing, of the run that all views show; None where there is
        none."""
        row = self._row_at(at)
        return row if row is not None and row.run == 0 else None

    def _row_at(self, at: QPoint) -> TimelineRow | None:
        found = [row for row, top in self._tops() if top <= at.y() < top + px(row.height)]
        return found[0] if found and at.y() >= px(EDGE) else None

    def moment_at(self, at: QPoint) -> float | None:
        """The time of a place on the drawing; None beside it, where the names are."""
        return self.axis.t(at.x() - px(GUTTER)) if at.x() >= px(GUTTER) else None

    def told_at(self, at: QPoint) -> str:
        """What a place on the drawing says: what, from when, how long; "" where nothing is."""
        row = self._row_at(at)
        if row is None:
            return ""
        if at.x() < px(GUTTER):
            return row.name
        t = self.axis.t(at.x() - px(GUTTER)) + self._run(row)[1]
        gap = gaps.at(self._unknown(row), t, self.axis.pixel * gaps.LEAST)
        if gap is not None:
            return gaps.words(gap)
        if isinstance(row.lane, Series):
            value = row.lane.at(t)
            return "" if value != value else f"{row.name} = {told(row.lane, value)}"
        return self._told_block(row, row.lane, t)

    def _told_block(self, row: TimelineRow, lane: Lane, t: float) -> str:
        drawn, shift, end = self._run(row)
        axis = drawn.axis
        for block in blocks(lane, axis.start, min(end, axis.end), axis.pixel * NARROW):
            if block.start <= t < block.end:
                words = drawn.words(row, block)
                until = block.end if block.many > 1 else lane.ends(block.start, end)
                lasts = f"{until - block.start:.2f} s"
                begun = self.clock(block.start - shift)
                return tr("{0}, from {1}, {2}").format(words, begun, lasts)
        return ""
