"""A drawing on pages: on one where it stays legible, else on several that can be glued together."""

from __future__ import annotations

import math
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QDate, QLocale, QRectF, QSizeF, Qt
from PySide6.QtGui import QFont, QPageLayout, QPainter
from PySide6.QtPrintSupport import QPrinter

from situ_studio.export.picture import SCREEN_DPI
from situ_studio.wording.language import tr

if TYPE_CHECKING:
    from situ_studio.canvas.paper import Paper

SMALLEST = 0.6
"""The smallest scale at which a drawing is put on one page: its texts have 6 points then."""
OVERLAP = 10.0
"""Millimetres of a page that stand on the next one too."""
FOOT = 8.0
"""Millimetres at the bottom of a page for the title."""
_INCH = 25.4


def scale_for(area: QRectF, page: QSizeF) -> float:
    """How large a drawing is printed: no larger than on the screen, no smaller than legible.

    page: what of the drawing, in its px, goes on a page at 100 %.
    """
    fits = min(page.width() / area.width(), page.height() / area.height())
    return min(1.0, max(SMALLEST, fits))


def parts(area: QRectF, page: QSizeF, overlap: float) -> list[list[QRectF]]:
    """What of ``area`` stands on which page, in rows: each as large as ``page``, in px.

    Neighbours share ``overlap`` at least, which is less than a page; all lie in the middle of
    what the pages have room for.
    """

    def along(start: float, length: float, room: float) -> list[float]:
        count = max(1, math.ceil((length - overlap) / (room - overlap) - 1e-9))
        taken = count * room - (count - 1) * overlap
        first = start - (taken - length) / 2
        return [first + i * (room - overlap) for i in range(count)]

    lefts = along(area.left(), area.width(), page.width())
    tops = along(area.top(), area.height(), page.height())
    return [[QRectF(x, y, page.width(), page.height()) for x in lefts] for y in tops]


def lay(printer: QPrinter, area: QRectF) -> None:
    """Turns the pages like the drawing, wide or high."""
    wide = area.width() > area.height()
    way = QPageLayout.Orientation.Landscape if wide else QPageLayout.Orientation.Portrait
    printer.setPageOrientation(way)


def print_paper(printer: QPrinter, drawn: Paper, title: str, at: datetime) -> int:
    """Prints the drawing in lines, title and date at the foot of each page. Returns how many.

    at: the date that is printed. 0 pages where the printer can not be begun.
    """
    painter = QPainter()
    if not painter.begin(printer):
        return 0
    dots = printer.resolution() / _INCH
    sheet = QRectF(printer.pageRect(QPrinter.Unit.DevicePixel))
    room = QRectF(0, 0, sheet.width(), sheet.height() - FOOT * dots)
    full = printer.resolution() / SCREEN_DPI
    scale = full * scale_for(drawn.area, room.size() / full)
    rows = parts(drawn.area, room.size() / scale, OVERLAP * dots / scale)
    several = len(rows) > 1 or len(rows[0]) > 1
    date = QLocale().toString(QDate(at.year, at.month, at.day), QLocale.FormatType.ShortFormat)
    count = 0
    for y, row in enumerate(rows):
        for x, part in enumerate(row):
            if count:
                printer.newPage()
            count += 1
            drawn.paint(painter, part, room)
            where = tr("row {0}, column {1}").format(y + 1, x + 1) if several else ""
            foot = QRectF(0, room.bottom(), room.width(), FOOT * dots)
            _paint_foot(painter, foot, title, where, date)
    painter.end()
    return count


def refused(printer: QPrinter, pages: int) -> str:
    """Why what was printed on so many pages is not all there, in one line; "" where it is."""
    if not pages:
        return tr("the printer does not begin; is it there, and is there room?")
    file = printer.outputFileName()
    if file and printer.outputFormat() == QPrinter.OutputFormat.PdfFormat and not _is_whole(file):
        # Qt does not tell when a disk is full.
        return tr("its file is not whole; is there room?")
    return ""


def _is_whole(file: str) -> bool:
    """Whether a PDF has its end."""
    try:
        return Path(file).read_bytes().rstrip().endswith(b"%%EOF")
    except OSError:
        return False


def _paint_foot(painter: QPainter, foot: QRectF, title: str, where: str, date: str) -> None:
    """Title at the left, the page's place in the middle, the date at the right."""
    painter.save()
    font = QFont(painter.font())
    font.setPointSizeF(8)
    painter.setFont(font)
    painter.setPen(Qt.GlobalColor.black)
    sides = (
        (Qt.AlignmentFlag.AlignLeft, title),
        (Qt.AlignmentFlag.AlignHCenter, where),
        (Qt.AlignmentFlag.AlignRight, date),
    )
    for side, text in sides:
        painter.drawText(foot, side | Qt.AlignmentFlag.AlignBottom, text)
    painter.restore()
