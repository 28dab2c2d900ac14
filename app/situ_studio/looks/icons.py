"""The icons of resources/icons: one family on a 20 px grid, drawn in any colour and size."""

from __future__ import annotations

from functools import lru_cache

from PySide6.QtCore import QByteArray, QRectF, Qt
from PySide6.QtGui import QColor, QGuiApplication, QIcon, QPainter, QPixmap
from PySide6.QtSvg import QSvgRenderer

from situ.resources import resource
from situ_studio.looks.letters import px


def scales() -> list[float]:
    """The device pixel ratios of the screens: for each an icon holds a picture.

    A window that comes to a screen with another one makes its icons anew.
    """
    return sorted({screen.devicePixelRatio() for screen in QGuiApplication.screens()})


@lru_cache(maxsize=512)
def renderer(name: str, color: str) -> QSvgRenderer:
    """An SVG renderer of the icon in ``color`` (as a QColor's name); shared, so only read from.

    Raises UsageError for a name that no icon has.
    """
    text = resource("icons", f"{name}.svg").read_text(encoding="utf-8")
    return QSvgRenderer(QByteArray(text.replace("currentColor", color).encode()))


def paint(painter: QPainter, name: str, rect: QRectF, color: QColor | str) -> None:
    """Draws the icon into ``rect``."""
    renderer(name, QColor(color).name()).render(painter, rect)


@lru_cache(maxsize=1024)
def _picture(name: str, color: str, size: int, scale: float, opacity: float) -> QPixmap:
    picture = QPixmap(round(size * scale), round(size * scale))
    picture.fill(Qt.GlobalColor.transparent)
    painter = QPainter(picture)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    if opacity < 1:
        painter.setOpacity(opacity)
        painter.drawPixmap(picture.rect(), _picture(name, color, size, scale, 1.0))
    else:
        renderer(name, color).render(painter)
    painter.end()
    picture.setDevicePixelRatio(scale)
    return picture


def pixmap(name: str, color: QColor | str, size: int = 16, scale: float | None = None) -> QPixmap:
    """The icon as a square picture of ``size`` px, for screens of that device pixel ratio."""
    if scale is None:
        qt = QGuiApplication.instance()
        assert isinstance(qt, QGuiApplication)
        scale = qt.devicePixelRatio()
    return _picture(name, QColor(color).name(), size, scale, 1.0)


def icon(name: str, color: QColor | str, size: int = 16, on: QColor | str | None = None) -> QIcon:
    """The icon in ``color``, not to be changed; sharp on HiDPI; paler where its widget is disabled.

    size: px of the design; it grows with the letters.
    on: the colour where its widget is checked, if it differs.
    """
    plain = QColor(color).name()
    checked = QColor(on).name() if on is not None else plain
    return _icon(name, plain, checked, px(size), tuple(scales()))


@lru_cache(maxsize=1024)
def _icon(name: str, plain: str, checked: str, size: int, scales: tuple[float, ...]) -> QIcon:
    """Every command, button and row has one: they share it, and whoever takes one copies it."""
    made = QIcon()
    for scale in scales:
        for state, shade in ((QIcon.State.Off, plain), (QIcon.State.On, checked)):
            made.addPixmap(_picture(name, shade, size, scale, 1.0), QIcon.Mode.Normal, state)
            made.addPixmap(_picture(name, shade, size, scale, 0.45), QIcon.Mode.Disabled, state)
            made.addPixmap(_picture(name, shade, size, scale, 1.0), QIcon.Mode.Selected, state)
    return made
