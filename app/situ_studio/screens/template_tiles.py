"""The templates as small pictures: a press gives the state that screen."""

from __future__ import annotations

from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QAbstractButton, QGridLayout, QWidget

from situ_studio.canvas import thumbnails
from situ_studio.canvas.style import Look
from situ_studio.screens.templates import templates, title
from situ_studio.theme import CAPTION, Theme, font

HIGH = 74
PICTURE = 54
FEW = 4
"""Templates that are seen before a person asks for all."""


class TemplateTile(QAbstractButton):
    """One template: its picture and its name."""

    def __init__(self, theme: Theme, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.name = name
        self._look = Look(theme)
        screen = templates()[name].screen
        self._marks = thumbnails.marks(screen) if screen is not None else ()
        self.setText(title(name))
        self.setAccessibleName(self.tr("Template: {0}").format(title(name)))
        self.setToolTip(self.tr("The state gets this screen; undo brings back the one before"))
        self.setFixedHeight(HIGH)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)

    def set_theme(self, theme: Theme) -> None:
        self._look = Look(theme)
        self.update()

    def sizeHint(self) -> QSize:
        return QSize(88, HIGH)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        theme = self._look.theme
        area = QRectF(1.5, 1.5, self.width() - 3, PICTURE)
        thumbnails.paint(painter, self._marks, area, self._look)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        if self.hasFocus() or self.isDown():
            painter.setPen(QPen(theme.color("accent"), 2))
            painter.drawRoundedRect(area, 4, 4)
        elif self.underMouse():
            painter.setPen(QPen(theme.color("text3"), 1))
            painter.drawRoundedRect(area, 3, 3)
        painter.setFont(font(CAPTION))
        painter.setPen(theme.color("text2"))
        below = QRectF(0, area.bottom() + 1, self.width(), HIGH - area.bottom() - 1)
        painter.drawText(below, int(Qt.AlignmentFlag.AlignCenter), self.text())
        painter.end()


class TemplateTiles(QWidget):
    """Two columns. chosen: the name of a template."""

    chosen = Signal(str)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        grid = QGridLayout(self)
        grid.setContentsMargins(8, 0, 12, 8)
        grid.setSpacing(6)
        self.tiles: dict[str, TemplateTile] = {}
        for at, name in enumerate(templates()):
            tile = TemplateTile(theme, name, self)
            tile.clicked.connect(lambda _=False, n=name: self.chosen.emit(n))
            grid.addWidget(tile, at // 2, at % 2)
            self.tiles[name] = tile
        self.shows_all = True
        self.show_all(False)

    def show_all(self, every: bool) -> None:
        """All of them, or the first ``FEW``."""
        self.shows_all = every
        for at, tile in enumerate(self.tiles.values()):
            tile.setVisible(every or at < FEW)

    def set_theme(self, theme: Theme) -> None:
        for tile in self.tiles.values():
            tile.set_theme(theme)
