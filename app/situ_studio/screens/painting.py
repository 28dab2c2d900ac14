"""What the robot's page shows, painted.

x, y, width, height are percent of the robot's screen (formats.md, *Screen*).
"""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QPointF, QRectF, QSize, QSizeF, Qt
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontMetricsF,
    QPainter,
    QPainterPath,
    QPen,
    QPixmap,
)

from situ.decide.screens import Shown
from situ.document import rbd
from situ_studio import icons
from situ_studio.screens.shown import Content, Values, content
from situ_studio.theme import FAMILIES

DEVICE = QSize(1280, 800)
"""The robot's screen in px, unless another is given."""
INK, INK_SOFT, GROUND, LINE = "#15223b", "#43526d", "#f7fafe", "#b9c6dc"
TOUCH, TOUCH_SOFT = "#1f4fc4", "#e4edfb"
"""The colours of the robot's own page, the same in both themes of the editor."""
SMALLEST = 11.0

_ALIGN = {
    "left": Qt.AlignmentFlag.AlignLeft,
    "center": Qt.AlignmentFlag.AlignHCenter,
    "right": Qt.AlignmentFlag.AlignRight,
}


def paint_screen(
    painter: QPainter,
    rect: QRectF,
    screen: rbd.Screen,
    above: tuple[rbd.Component, ...] = (),
    media: Path | None = None,
    *,
    device: QSize = DEVICE,
    values: Values | None = None,
) -> None:
    """Paints a screen into ``rect``; ``above`` are the components that Always adds.

    media: the folder in which its pictures lie; pictures that are not there are a pale box.
    device: the robot's screen in px: it is painted at that size and scaled, so that texts break
    where they do on it. values: tag to value, with which references are filled in; without them
    texts stand as they are written.
    """
    paint_content(painter, rect, content(screen, above, values), media, device)


def paint_content(
    painter: QPainter,
    rect: QRectF,
    content: Content,
    media: Path | None = None,
    device: QSize = DEVICE,
) -> None:
    """Paints what is on a robot's screen into ``rect``, as ``paint_screen``."""
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
    clip = QPainterPath()
    clip.addRoundedRect(rect, 4, 4)
    painter.setClipPath(clip)
    painter.translate(rect.topLeft())
    painter.scale(rect.width() / device.width(), rect.height() / device.height())
    whole = QRectF(QPointF(0, 0), QSizeF(device))
    painter.fillRect(whole, QColor(GROUND))
    if content.background:
        color = QColor(content.background)
        picture = _picture(media, content.background)
        if picture is not None:
            painter.drawPixmap(whole, picture, QRectF(picture.rect()))
        elif color.isValid():
            painter.fillRect(whole, color)
    buttons = [one for one in content.components if one["type"] == "button"]
    first = next((one for one in buttons if "fill" not in one), None)
    for one in content.components:
        box = QRectF(
            one["x"] / 100 * whole.width(),
            one["y"] / 100 * whole.height(),
            one["width"] / 100 * whole.width(),
            one["height"] / 100 * whole.height(),
        )
        _paint_component(painter, box, one, one is first, media, whole.height())
    painter.restore()


def _paint_component(
    painter: QPainter, box: QRectF, one: Shown, first: bool, media: Path | None, high: float
) -> None:
    radius = high * 0.026
    fill = one.get("fill")
    kind = one["type"]
    if fill and kind != "button":
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(fill))
        painter.drawRoundedRect(box, radius, radius)
    if kind == "text":
        size = one.get("size", 6.0)
        weight = 600 if size >= 8 else 500 if size >= 5.5 else 400
        ink = QColor(one.get("color") or (INK if size >= 5.5 else INK_SOFT))
        _words(painter, box, one["text"], size * high / 100, weight, ink, one.get("align", "left"))
    elif kind == "button":
        _button(painter, box, one, first, radius, high)
    elif kind in ("image", "movie"):
        _image(painter, box, one, media, radius)
    elif kind == "input":
        painter.setPen(QPen(QColor(LINE), 4))
        painter.setBrush(QColor("#FFFFFF"))
        painter.drawRoundedRect(box.adjusted(2, 2, -2, -2), radius, radius)
    elif kind == "list":
        row, gap = 76.0, 10.0
        y = box.y()
        while y + row <= box.bottom() + 1:
            painter.setPen(QPen(QColor("#d5deec"), 4))
            painter.setBrush(QColor("#FFFFFF"))
            line = QRectF(box.x() + 2, y + 2, box.width() - 4, row - 4)
            painter.drawRoundedRect(line, radius, radius)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor(LINE))
            painter.drawRoundedRect(QRectF(box.x() + 32, y + 30, box.width() * 0.4, 16), 8, 8)
            y += row + gap


def _button(
    painter: QPainter, box: QRectF, one: Shown, first: bool, radius: float, high: float
) -> None:
    fill = one.get("fill")
    ground, ink = QColor(fill or TOUCH), QColor("#FFFFFF")
    painter.setPen(Qt.PenStyle.NoPen)
    if not fill and not first:
        ground, ink = QColor("#FFFFFF"), QColor(TOUCH)
        painter.setPen(QPen(ink, 4))
    elif ground.lightnessF() > 0.65:
        ink = QColor(INK)
    painter.setBrush(ground)
    painter.drawRoundedRect(box.adjusted(2, 2, -2, -2), radius, radius)
    if one.get("color"):
        ink = QColor(one["color"])
    inner = box.adjusted(16, 8, -16, -8)
    size = one.get("size", 6.0) * high / 100
    _words(painter, inner, one["text"], size, 600, ink, one.get("align", "center"))


def _image(
    painter: QPainter,
    box: QRectF,
    one: Shown,
    media: Path | None,
    radius: float,
) -> None:
    picture = _picture(media, one["src"]) if one["type"] == "image" else None
    if picture is not None:
        size = picture.size().scaled(box.size().toSize(), Qt.AspectRatioMode.KeepAspectRatio)
        at = QRectF(0, 0, size.width(), size.height())
        at.moveCenter(box.center())
        painter.drawPixmap(at, picture, QRectF(picture.rect()))
        return
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(TOUCH_SOFT))
    painter.drawRoundedRect(box, radius, radius)
    side = min(box.width(), box.height()) * 0.35
    at = QRectF(0, 0, side, side)
    at.moveCenter(box.center())
    icons.paint(painter, one["type"], at, QColor(TOUCH))


def _words(
    painter: QPainter,
    box: QRectF,
    text: str,
    size: float,
    weight: int,
    ink: QColor,
    align: str,
) -> None:
    """As on the robot: the designed size, smaller where it does not fit its box."""
    flags = int(_ALIGN[align] | Qt.AlignmentFlag.AlignVCenter | Qt.TextFlag.TextWordWrap)
    text = "\n".join(line.strip() for line in text.strip().split("\n"))
    font = QFont()
    font.setFamilies(FAMILIES)
    font.setWeight(QFont.Weight(weight))
    font.setHintingPreference(QFont.HintingPreference.PreferNoHinting)
    while True:
        font.setPixelSize(max(1, round(size)))
        needed = QFontMetricsF(font).boundingRect(box, flags, text)
        if size <= SMALLEST or (
            needed.height() <= box.height() + 1 and needed.width() <= box.width() + 1
        ):
            break
        size *= 0.94
    painter.setFont(font)
    painter.setPen(ink)
    painter.drawText(box, flags, text)


def _picture(media: Path | None, name: str) -> QPixmap | None:
    """The picture ``name`` of the media folder; None where there is none."""
    if media is None or not (media / name).is_file():
        return None
    picture = QPixmap(str(media / name))
    return None if picture.isNull() else picture
