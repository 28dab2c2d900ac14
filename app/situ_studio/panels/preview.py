"""A state's screen in small, painted from its components.

x, y, width, height are percent of the robot's screen (formats.md, *Screen*); the
shape is that of a 16 : 10 screen.
"""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QPointF, QRectF, QSize, QSizeF, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontMetricsF,
    QMouseEvent,
    QPainter,
    QPainterPath,
    QPaintEvent,
    QPen,
    QPixmap,
    QResizeEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from situ.document import rbd
from situ_studio import icons
from situ_studio.theme import FAMILIES, Theme

RATIO = 10 / 16
SCREEN = QSizeF(1280, 800)
"""The screen is painted at this size and scaled, so that texts break where they do on it."""
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
) -> None:
    """Paints a screen into ``rect``; ``above`` are the components that Always adds.

    media: the folder in which its pictures lie; pictures that are not there are a pale box.
    """
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
    clip = QPainterPath()
    clip.addRoundedRect(rect, 4, 4)
    painter.setClipPath(clip)
    painter.translate(rect.topLeft())
    painter.scale(rect.width() / SCREEN.width(), rect.height() / SCREEN.height())
    whole = QRectF(QPointF(0, 0), SCREEN)
    painter.fillRect(whole, QColor(GROUND))
    if screen.background:
        color = QColor(screen.background)
        picture = _picture(media, screen.background)
        if picture is not None:
            painter.drawPixmap(whole, picture, QRectF(picture.rect()))
        elif color.isValid():
            painter.fillRect(whole, color)
    first = next((c for c in screen.components if isinstance(c, rbd.Button) and not c.fill), None)
    for component in (*screen.components, *above):
        box = QRectF(
            component.x / 100 * whole.width(),
            component.y / 100 * whole.height(),
            component.width / 100 * whole.width(),
            component.height / 100 * whole.height(),
        )
        _paint_component(painter, box, component, component is first, media)
    painter.restore()


def _paint_component(
    painter: QPainter, box: QRectF, component: rbd.Component, first: bool, media: Path | None
) -> None:
    radius = SCREEN.height() * 0.026
    if component.fill and not isinstance(component, rbd.Button):
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(component.fill))
        painter.drawRoundedRect(box, radius, radius)
    if isinstance(component, rbd.Text):
        size = component.size or 6.0
        weight = 600 if size >= 8 else 500 if size >= 5.5 else 400
        ink = QColor(component.color or (INK if size >= 5.5 else INK_SOFT))
        _words(painter, box, component.text, size, weight, ink, component.align or "left")
    elif isinstance(component, rbd.Button):
        _button(painter, box, component, first, radius)
    elif isinstance(component, rbd.Image | rbd.Movie):
        _image(painter, box, component, media, radius)
    elif isinstance(component, rbd.Input):
        painter.setPen(QPen(QColor(LINE), 4))
        painter.setBrush(QColor("#FFFFFF"))
        painter.drawRoundedRect(box.adjusted(2, 2, -2, -2), radius, radius)
    elif isinstance(component, rbd.List):
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


def _button(painter: QPainter, box: QRectF, button: rbd.Button, first: bool, radius: float) -> None:
    ground, ink = QColor(button.fill or TOUCH), QColor("#FFFFFF")
    painter.setPen(Qt.PenStyle.NoPen)
    if not button.fill and not first:
        ground, ink = QColor("#FFFFFF"), QColor(TOUCH)
        painter.setPen(QPen(ink, 4))
    elif ground.lightnessF() > 0.65:
        ink = QColor(INK)
    painter.setBrush(ground)
    painter.drawRoundedRect(box.adjusted(2, 2, -2, -2), radius, radius)
    if button.color:
        ink = QColor(button.color)
    inner = box.adjusted(16, 8, -16, -8)
    _words(painter, inner, button.text, button.size or 6.0, 600, ink, button.align or "center")


def _image(
    painter: QPainter,
    box: QRectF,
    component: rbd.Image | rbd.Movie,
    media: Path | None,
    radius: float,
) -> None:
    picture = _picture(media, component.src) if isinstance(component, rbd.Image) else None
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
    icons.paint(painter, component.element, at, QColor(TOUCH))


def _words(
    painter: QPainter,
    box: QRectF,
    text: str,
    percent: float,
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
    size = percent / 100 * SCREEN.height()
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


class ScreenPreview(QWidget):
    """The screen of the selected state, as wide as the panel."""

    clicked = Signal()

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme = theme
        self._screen: rbd.Screen | None = None
        self._above: tuple[rbd.Component, ...] = ()
        self._media: Path | None = None
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
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

    @property
    def components(self) -> tuple[rbd.Component, ...]:
        """Those of the screen and those that Always adds, back to front."""
        return (*(self._screen.components if self._screen is not None else ()), *self._above)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.setFixedHeight(int(event.size().width() * RATIO))

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
