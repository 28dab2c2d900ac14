"""A screen in small: the shape of its device, and pictures as they are on disk now."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QImage, QPainter
from PySide6.QtWidgets import QApplication

from situ.document import rbd
from situ_studio.looks.theme import LIGHT
from situ_studio.panels.preview import ScreenPreview
from situ_studio.screens.painting import paint_screen

PICTURE = rbd.Image(id="i", x=0, y=0, width=100, height=100, src="p.png")


def middle(screen: rbd.Screen, media: Path) -> str:
    """The colour in the middle of a screen."""
    image = QImage(320, 200, QImage.Format.Format_RGB32)
    painter = QPainter(image)
    paint_screen(painter, QRectF(0, 0, 320, 200), screen, (), media)
    painter.end()
    return image.pixelColor(160, 100).name()


def save(path: Path, colour: str, moment: int) -> None:
    image = QImage(640, 640, QImage.Format.Format_RGB32)
    image.fill(QColor(colour))
    image.save(str(path))
    os.utime(path, (moment, moment))


@pytest.mark.parametrize(
    ("device", "height"),
    [
        (None, 200),
        (QSize(1024, 600), 187),
        (QSize(800, 1280), 512),
        (QSize(390, 844), 576),
    ],
)
def test_a_preview_has_the_shape_of_the_device(
    qt: QApplication, device: QSize | None, height: int
) -> None:
    preview = ScreenPreview(LIGHT)
    if device is not None:
        preview.show_device(device)
    preview.resize(320, 10)
    preview.show()
    assert preview.height() == height
    # And takes that of another while it is seen.
    preview.show_device(QSize(1000, 1000))
    assert preview.height() == 320
    preview.close()
    preview.deleteLater()


def test_a_picture_that_is_another_file_now_is_shown_as_it_is(
    qt: QApplication, tmp_path: Path
) -> None:
    screen = rbd.Screen(components=(PICTURE,))
    save(tmp_path / "p.png", "#ff0000", 1000)
    assert middle(screen, tmp_path) == "#ff0000"
    save(tmp_path / "p.png", "#0000ff", 2000)
    assert middle(screen, tmp_path) == "#0000ff"
    (tmp_path / "p.png").unlink()
    assert middle(screen, tmp_path) not in ("#ff0000", "#0000ff")


def test_a_background_covers_the_screen_whatever_its_shape(
    qt: QApplication, tmp_path: Path
) -> None:
    tall = QImage(100, 400, QImage.Format.Format_RGB32)
    tall.fill(QColor("#ff0000"))
    painter = QPainter(tall)
    painter.fillRect(0, 180, 100, 40, Qt.GlobalColor.blue)
    painter.end()
    tall.save(str(tmp_path / "b.png"))
    # Of 400 px the middle 62.5 are seen: 40 of them blue.
    assert middle(rbd.Screen(background="b.png"), tmp_path) == "#0000ff"
