"""The preview of an upright screen, at several sizes: opened, used and closed by hand."""

from __future__ import annotations

from typing import Any

import pytest
from PySide6.QtCore import QSize, Qt
from PySide6.QtTest import QTest
from tests.gui.screens.test_designer_alone import Desk, desk

from situ_studio.screens import placing
from situ_studio.screens.devices import DEVICES
from situ_studio.screens.marks import Scale
from situ_studio.screens.painting import layer

__all__ = ["desk"]

LEFT = Qt.MouseButton.LeftButton


def test_an_upright_screen_is_previewed_and_used_at_several_sizes(desk: Desk) -> None:
    desk.go_to("11")
    desk.click(desk.bar.ways.button("upright"))
    shapes = set()
    for device in DEVICES:
        wanted = device.upright(True)
        desk.choose(desk.bar.devices, wanted.words)
        assert desk.designer.device == wanted
        # On the sheet it is upright, too.
        assert desk.sheet.height() > desk.sheet.width()
        desk.click(desk.bar.preview)
        preview: Any = desk.designer.preview
        page = preview.page
        shapes.add((page.width(), page.height()))
        shared = layer(QSize(wanted.wide, wanted.high))
        assert page.width() * shared.height() == pytest.approx(
            page.height() * shared.width(), rel=0.02
        )
        # A finger on the button goes on; the arrow leads back, and so it is left.
        button = next(c for c in desk.components("11") if c.id == "measure")
        spot = Scale(page.size()).area(placing.box_of(button)).center().toPoint()
        QTest.mouseClick(page, LEFT, pos=spot)
        desk.settle()
        assert preview.walk.no == "12"
        desk.click(preview.back)
        assert preview.walk.no == "11"
        QTest.keyClick(preview, Qt.Key.Key_Escape)
        desk.settle()
        assert desk.designer.preview is None
    assert len(shapes) == len(DEVICES), "each has its own shape"
    desk.click(desk.bar.ways.button("lying"))
    assert desk.sheet.width() > desk.sheet.height()
    assert desk.steps == [], "looking changes nothing"
