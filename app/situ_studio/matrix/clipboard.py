"""Cells to and from the clipboard, in the ways that spreadsheets write and read them."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QMimeData
from PySide6.QtGui import QGuiApplication

from situ_studio.matrix import spreadsheet


def put(rows: Sequence[Sequence[str]]) -> None:
    """Copies rows of cells, as text and as a table."""
    data = QMimeData()
    data.setText(spreadsheet.to_text(rows))
    data.setHtml(spreadsheet.to_html(rows))
    QGuiApplication.clipboard().setMimeData(data)


def cells() -> list[list[str]]:
    """The rows of cells that were copied, all of one length; empty where nothing was."""
    # Where nothing was ever copied it is None, whatever the types of Qt say.
    data: QMimeData | None = QGuiApplication.clipboard().mimeData()
    if data is None:
        return []
    found = spreadsheet.from_html(data.html()) if data.hasHtml() else []
    return found or spreadsheet.from_text(data.text())
