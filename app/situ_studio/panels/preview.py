"""A state's screen in small, painted from its components.

x, y, width, height are percent of the robot's screen (formats.md, *Screen*); the
shape is that of a 16 : 10 screen.
"""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFont, QMouseEvent, QPainter, QPainterPath, QPaintEvent, QPixmap
from PySide6.QtWidgets import QSizePolicy, QWidget

from situ.document import rbd
from situ_studio import icons
from situ_studio.theme import FAMILIES, Theme

RATIO = 10 / 16
PAPER, INK, PALE, TOUCH = "#F7FAFF", "#14213D", "#C9D3E3", "#1F4FC9"
"""The robot's screen has colours of its own, the same in both themes of the editor."""

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
) -> None:
    """Paints a screen into ``rect``; ``above`` are the components that Always adds.

    media: the folder in which its pictures lie; pictures that are not there are a grey box.
    """
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
    clip = QPainterPath()
    clip.addRoundedRect(rect, 4, 4)
    painter.setClipPath(clip)
    painter.fillRect(rect, QColor(PAPER))
    if screen.background:
        color = QColor(screen.background)
        picture = _picture(media, screen.background)
        if picture is not None:
            painter.drawPixmap(rect, picture, QRectF(picture.rect()))
        elif color.isValid():
            painter.fillRect(rect, color)
    for component in (*screen.components, *above):
        box = QRectF(
            rect.x() + component.x / 100 * rect.width(),
            rect.y() + component.y / 100 * rect.height(),
            component.width / 100 * rect.width(),
            component.height / 100 * rect.height(),
        )
        _paint_component(painter, box, rect, component, media)
    painter.restore()


def _paint_component(
    painter: QPainter, box: QRectF, screen: QRectF, component: rbd.Component, media: Path | None
) -> None:
    ink = QColor(component.color) if component.color else QColor(INK)
    if component.fill and not isinstance(component, rbd.Button):
        painter.fillRect(box, QColor(component.fill))
    if isinstance(component, rbd.Text):
        _words(painter, box, screen, component, component.text, ink, "left")
    elif isinstance(component, rbd.Button):
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(component.fill or TOUCH))
        radius = screen.height() * 0.02
        painter.drawRoundedRect(box, radius, radius)
        ink = QColor(component.color) if component.color else QColor("#FFFFFF")
        _words(painter, box, screen, component, component.text, ink, "center", 600)
    elif isinstance(component, rbd.Image | rbd.Movie):
        picture = _picture(media, component.src) if isinstance(component, rbd.Image) else None
        if picture is not None:
            size = picture.size().scaled(box.size().toSize(), Qt.AspectRatioMode.KeepAspectRatio)
            at = QRectF(0, 0, size.width(), size.height())
            at.moveCenter(box.center())
            painter.drawPixmap(at, picture, QRectF(picture.rect()))
            return
        painter.fillRect(box, QColor(PALE))
        side = min(box.width(), box.height(), 32) * 0.7
        at = QRectF(0, 0, side, side)
        at.moveCenter(box.center())
        icons.paint(painter, component.element, at, QColor(INK))
    elif isinstance(component, rbd.Input):
        painter.setPen(QColor("#5B6B86"))
        painter.setBrush(QColor("#FFFFFF"))
        painter.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), 3, 3)
    elif isinstance(component, rbd.List):
        painter.setPen(Qt.PenStyle.NoPen)
        row = max(box.height() / 4, 4.0)
        y = box.y()
        while y + row * 0.8 <= box.bottom() + 0.5:
            painter.setBrush(QColor("#FFFFFF"))
            painter.drawRoundedRect(QRectF(box.x(), y, box.width(), row * 0.8), 2, 2)
            painter.setBrush(QColor(PALE))
            line = QRectF(box.x() + row * 0.3, y + row * 0.28, box.width() * 0.5, row * 0.24)
            painter.drawRoundedRect(line, 1, 1)
            y += row


def _words(
    painter: QPainter,
    box: QRectF,
    screen: QRectF,
    component: rbd.Component,
    text: str,
    ink: QColor,
    usual: str,
    weight: int = 500,
) -> None:
    # What the page does where no size is given: a size that the box can hold.
    percent = component.size or min(8.0, component.height * 0.45)
    pixels = max(1, int(percent / 100 * screen.height() + 0.5))
    font = QFont()
    font.setFamilies(FAMILIES)
    font.setPixelSize(pixels)
    font.setWeight(QFont.Weight(weight))
    painter.setFont(font)
    painter.setPen(ink)
    side = _ALIGN[component.align or usual]
    flags = side | Qt.AlignmentFlag.AlignVCenter | Qt.TextFlag.TextWordWrap
    painter.drawText(box, int(flags), text)


def _picture(media: Path | None, name: str) -> QPixmap | None:
    """The picture ``name`` of the media folder; None where there is none."""
    if media is None or not (media / name).is_file():
        return None
    picture = QPixmap(str(media / name))
    return None if picture.isNull() else picture


class ScreenPreview(QWidget):
    """The screen of the selected state, as wide as the panel."""

    clicked = Signal()

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme = theme
        self._screen: rbd.Screen | None = None
        self._above: tuple[rbd.Component, ...] = ()
        self._media: Path | None = None
        policy = QSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        policy.setHeightForWidth(True)
        self.setSizePolicy(policy)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.setAccessibleName(self.tr("Picture of the screen"))

    def show_screen(
        self,
        theme: Theme,
        screen: rbd.Screen | None,
        above: tuple[rbd.Component, ...],
        media: Path | None,
    ) -> None:
        self._theme, self._screen, self._above, self._media = theme, screen, above, media
        self.update()

    def heightForWidth(self, width: int) -> int:
        return int(width * RATIO)

    def sizeHint(self) -> QSize:
        return QSize(240, int(240 * RATIO))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self.rect().contains(event.position().toPoint()):
            self.clicked.emit()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        rect = QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5)
        if self._screen is not None:
            paint_screen(painter, rect, self._screen, self._above, self._media)
            painter.setBrush(Qt.BrushStyle.NoBrush)
        else:
            painter.setBrush(self._theme.color("field"))
        painter.setPen(self._theme.color("line_strong"))
        painter.drawRoundedRect(rect, 4, 4)
        if self._screen is None:
            painter.setPen(self._theme.color("text3"))
            painter.drawText(
                rect, int(Qt.AlignmentFlag.AlignCenter), self.tr("keeps what was shown before")
            )
        painter.end()
