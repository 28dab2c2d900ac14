"""What a person chose of a printer, as a value: another process prints with it."""

from __future__ import annotations

from msgspec import Struct
from PySide6.QtCore import QMarginsF, QSizeF
from PySide6.QtGui import QPageLayout, QPageSize
from PySide6.QtPrintSupport import QPrinter

POINT = QPageLayout.Unit.Point


class ChosenPrinter(Struct, frozen=True, kw_only=True):
    """name: of the printer; file: into which it prints, "" where on paper.

    size: of the paper, wide and high as it stands; margins: left, top, right, bottom; both in
    points. wide: whether the pages lie.
    """

    name: str
    file: str
    pdf: bool
    title: str
    size: tuple[float, float]
    margins: tuple[float, float, float, float]
    wide: bool
    copies: int
    collated: bool
    coloured: bool
    duplex: QPrinter.DuplexMode
    resolution: int

    def printer(self, file: str) -> QPrinter:
        """The printer, set up as it was chosen. file: in place of its own."""
        made = QPrinter(QPrinter.PrinterMode.HighResolution)
        if self.name:
            made.setPrinterName(self.name)
        if self.pdf:
            made.setOutputFormat(QPrinter.OutputFormat.PdfFormat)
        if file:
            made.setOutputFileName(file)
        made.setDocName(self.title)
        made.setResolution(self.resolution)
        ways = QPageLayout.Orientation
        way = ways.Landscape if self.wide else ways.Portrait
        paper = QPageSize(
            QSizeF(*self.size), QPageSize.Unit.Point, "", QPageSize.SizeMatchPolicy.FuzzyMatch
        )
        made.setPageLayout(QPageLayout(paper, way, QMarginsF(*self.margins), POINT))
        made.setCopyCount(self.copies)
        made.setCollateCopies(self.collated)
        colours = QPrinter.ColorMode
        made.setColorMode(colours.Color if self.coloured else colours.GrayScale)
        made.setDuplex(self.duplex)
        return made


def chosen(printer: QPrinter) -> ChosenPrinter:
    """What was chosen of ``printer``."""
    layout = printer.pageLayout()
    size = layout.pageSize().size(QPageSize.Unit.Point)
    margins = layout.margins(POINT)
    return ChosenPrinter(
        name=printer.printerName(),
        file=printer.outputFileName(),
        pdf=printer.outputFormat() == QPrinter.OutputFormat.PdfFormat,
        title=printer.docName(),
        size=(size.width(), size.height()),
        margins=(margins.left(), margins.top(), margins.right(), margins.bottom()),
        wide=layout.orientation() == QPageLayout.Orientation.Landscape,
        copies=printer.copyCount(),
        collated=printer.collateCopies(),
        coloured=printer.colorMode() == QPrinter.ColorMode.Color,
        duplex=printer.duplex(),
        resolution=printer.resolution(),
    )
