"""Rows of the lists at the left: what is cut where there is little room."""

from __future__ import annotations

from PySide6.QtCore import QRect, Qt
from PySide6.QtGui import QFontMetricsF, QImage, QPainter, QStandardItem, QStandardItemModel
from PySide6.QtWidgets import QApplication, QStyleOptionViewItem

from situ_studio.looks.theme import LIGHT, face
from situ_studio.panels.lists import COUNT, RowDelegate

WIDTH = 208


def ink(count: str, name: str = "night-round") -> list[int]:
    """Where a row of a panel is not white, as columns of pixels."""
    model = QStandardItemModel()
    item = QStandardItem(name)
    item.setData(count, COUNT)
    model.appendRow(item)
    option = QStyleOptionViewItem()
    option.rect = QRect(0, 0, WIDTH, 24)
    image = QImage(WIDTH, 24, QImage.Format.Format_RGB32)
    image.fill(Qt.GlobalColor.white)
    painter = QPainter(image)
    RowDelegate(LIGHT).paint(painter, option, item.index())
    painter.end()
    white = QImage(image).copy()
    white.fill(Qt.GlobalColor.white)
    return [
        x
        for x in range(WIDTH)
        if any(image.pixel(x, y) != white.pixel(x, y) for y in range(image.height()))
    ]


def test_a_long_list_of_resources_cuts_no_name(qt: QApplication) -> None:
    alone = ink("")
    end = max(alone)
    assert end - min(alone) > QFontMetricsF(face(13)).horizontalAdvance("night-round") * 0.9
    beside = ink("screen speech head base arm left")
    # The name is painted as it is alone, and what is cut begins behind it.
    assert [x for x in beside if x <= end] == alone
    assert any(x > end + 4 for x in beside)
    # A number is never cut.
    assert max(ink("1200", "a name that is much too long for this row, and cut")) > WIDTH - 12
