"""A document's graph as a picture: SVG and PDF in lines, PNG in px; always light, for paper."""

from __future__ import annotations

import math
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QBuffer, QIODevice, QMarginsF, QRectF, QSize, QSizeF, Qt
from PySide6.QtGui import QImage, QImageWriter, QPageLayout, QPageSize, QPainter, QPdfWriter
from PySide6.QtSvg import QSvgGenerator

from situ.document import folder
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ.errors import UsageError
from situ_studio.edits.edit import Document, Place
from situ_studio.looks.theme import LIGHT
from situ_studio.views.table import PIECES, Setting
from situ_studio.wording.language import tr

if TYPE_CHECKING:
    from situ_studio.canvas.base import Canvas
    from situ_studio.canvas.paper import Paper

FORMATS = ("svg", "pdf", "png")
SCREEN_DPI = 96
"""Px of the drawing to an inch, so that a text is as large on paper as on the screen."""
SCALE = 2.0
"""Px of a PNG for one of the drawing, unless a person says otherwise."""
MOST_PIXELS = 400_000_000
"""Of a PNG: 1.6 GB while it is drawn."""
WIDEST = 14400
"""Points of a PDF's page; readers show no larger ones."""


def has_picture(document: Document | None) -> bool:
    """Whether documents of this kind have a graph."""
    return isinstance(document, Application | Spds)


def paper(
    document: Document, like: Canvas | None = None, only: Iterable[Place] | None = None
) -> Paper:
    """The document's graph on paper; ``close`` it after use.

    like, only: as ``Paper`` takes them. UsageError where nothing would be on it.
    """
    from situ_studio.canvas.paper import Paper

    if not has_picture(document):
        raise UsageError(
            tr("documents of this kind have no graph: choose an application or a script")
        )
    canvas = PIECES["graph"](Setting(document, LIGHT, None))
    made = Paper(canvas, document, like, only)
    if not canvas.graph.cards:
        made.close()
        raise UsageError(tr("there is nothing on the drawing yet"))
    return made


def draw(document: Document, path: str | Path, title: str) -> None:
    """Writes the whole graph of the document; raises as ``paper`` and ``write`` do."""
    drawn = paper(document)
    try:
        write(drawn, path, title)
    finally:
        drawn.close()


def format_of(path: str | Path) -> str:
    """``svg``, ``pdf`` or ``png``, by the name's ending; UsageError where it is another."""
    found = Path(path).suffix.lower().removeprefix(".")
    if found not in FORMATS:
        told = tr("{0}: end the name of a picture with .svg, .pdf or .png")
        raise UsageError(told.format(path))
    return found


def write(
    drawn: Paper,
    path: str | Path,
    title: str,
    part: QRectF | None = None,
    scale: float = SCALE,
) -> None:
    """Writes the picture, in the format of the name's ending: whole, or not at all.

    part: of the scene; everything unless given. scale: px of a PNG for one of the drawing.
    Raises UsageError where it can not be written or would be too large.
    """
    area = QRectF(part if part is not None else drawn.area)
    kind = format_of(path)
    # Qt does not tell when a disk is full: it writes into the memory.
    made = QBuffer()
    made.open(QIODevice.OpenModeFlag.WriteOnly)
    if kind == "svg":
        well = _write_svg(drawn, made, title, area)
    elif kind == "pdf":
        well = _write_pdf(drawn, made, title, area)
    else:
        well = _write_png(drawn, made, title, area, scale)
    if not well:
        raise UsageError(tr("{0}: can not be drawn").format(path))
    folder.write(path, bytes(made.data().data()))


def _write_svg(drawn: Paper, into: QIODevice, title: str, area: QRectF) -> bool:
    from situ_studio.canvas.paper import Outlines

    made = QSvgGenerator()
    made.setOutputDevice(into)
    made.setTitle(title)
    made.setResolution(SCREEN_DPI)
    made.setSize(QSize(math.ceil(area.width()), math.ceil(area.height())))
    made.setViewBox(QRectF(0, 0, area.width(), area.height()))
    painter = Outlines()
    return painter.begin(made) and _paint(drawn, painter, area, 1.0)


def _write_pdf(drawn: Paper, into: QIODevice, title: str, area: QRectF) -> bool:
    points = 72 / SCREEN_DPI
    size = QSizeF(area.width(), area.height()) * points
    size *= min(1.0, WIDEST / max(size.width(), size.height()))
    made = QPdfWriter(into)
    made.setTitle(title)
    made.setCreator("Situ Studio")
    made.setResolution(1200)
    page = QPageSize(size, QPageSize.Unit.Point, title, QPageSize.SizeMatchPolicy.ExactMatch)
    made.setPageLayout(QPageLayout(page, QPageLayout.Orientation.Portrait, QMarginsF()))
    painter = QPainter()
    return painter.begin(made) and _paint(drawn, painter, area, made.width() / area.width())


def _write_png(drawn: Paper, into: QIODevice, title: str, area: QRectF, scale: float) -> bool:
    wide, high = pixels(area, scale)
    if wide * high > MOST_PIXELS:
        told = tr("a picture of {0} × {1} px is too large: choose a smaller scale, or SVG or PDF")
        raise UsageError(told.format(wide, high))
    made = QImage(wide, high, QImage.Format.Format_RGB32)
    made.fill(Qt.GlobalColor.white)
    made.setDotsPerMeterX(round(SCREEN_DPI * scale / 0.0254))
    made.setDotsPerMeterY(round(SCREEN_DPI * scale / 0.0254))
    made.setText("Title", title)
    painter = QPainter()
    well = painter.begin(made) and _paint(drawn, painter, area, scale)
    return well and QImageWriter(into, b"png").write(made)


def _paint(drawn: Paper, painter: QPainter, area: QRectF, scale: float) -> bool:
    drawn.paint(painter, area, QRectF(0, 0, area.width() * scale, area.height() * scale))
    return painter.end()


def pixels(area: QRectF, scale: float) -> tuple[int, int]:
    """Width and height of a PNG of this part of the scene."""
    return math.ceil(area.width() * scale), math.ceil(area.height() * scale)
