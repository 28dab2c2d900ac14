"""The templates as small pictures: a press gives the state that screen."""

from __future__ import annotations

from PySide6.QtCore import QMimeData, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QContextMenuEvent, QKeyEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QAbstractButton, QGridLayout, QMenu, QWidget

from situ.document import rbd
from situ_studio.canvas import thumbnails
from situ_studio.canvas.style import Look
from situ_studio.looks.letters import px
from situ_studio.looks.theme import CAPTION, Theme, font
from situ_studio.screens.templates import TEMPLATE, templates, title, written
from situ_studio.widgets.dragging import Dragging
from situ_studio.widgets.layouts import clear

HIGH = 74
PICTURE = 54
FEW = 4
"""Templates that are seen before a person asks for all."""


class TemplateTile(QAbstractButton):
    """One template: its picture and its name. Pressed, or dragged onto a screen."""

    removed = Signal()
    """It is not wanted any more; only of one's own."""

    def __init__(
        self, theme: Theme, template: rbd.State, own: bool, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.template = template
        self.own = own
        self._look = Look(theme)
        screen = template.screen
        self._marks = thumbnails.marks(screen) if screen is not None else ()
        name = template.name if own else title(template.name)
        self.setText(name)
        self.setAccessibleName(self.tr("Template: {0}").format(name))
        tip = self.tr("The state gets this screen; undo brings back the one before")
        self.setToolTip(f"{tip}\n{self.tr('Delete removes this template')}" if own else tip)
        self.setFixedHeight(px(HIGH))
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        Dragging(self, lambda: dragged(self.template))

    def set_theme(self, theme: Theme) -> None:
        self._look = Look(theme)
        self.update()

    def sizeHint(self) -> QSize:
        return QSize(px(88), px(HIGH))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if self.own and event.key() in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace):
            self.removed.emit()
        else:
            super().keyPressEvent(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        if self.own:
            menu = QMenu(self)
            menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
            menu.addAction(self.tr("Remove this template")).triggered.connect(self.removed)
            menu.popup(event.globalPos())

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        theme = self._look.theme
        area = QRectF(1.5, 1.5, self.width() - 3, px(PICTURE))
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
        below = QRectF(0, area.bottom() + 1, self.width(), self.height() - area.bottom() - 1)
        cut, wide = painter.fontMetrics().elidedText, int(below.width())
        text = cut(self.text(), Qt.TextElideMode.ElideRight, wide)
        painter.drawText(below, int(Qt.AlignmentFlag.AlignCenter), text)
        painter.end()


def dragged(template: rbd.State) -> QMimeData:
    data = QMimeData()
    data.setData(TEMPLATE, written(template))
    return data


class TemplateTiles(QWidget):
    """Two columns, those of one's own first."""

    chosen = Signal(object)
    """A template: a state with a screen."""
    removed = Signal(str)
    """The name of one of one's own."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme = theme
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(8, 0, 12, 8)
        self._grid.setSpacing(6)
        self.tiles: dict[str, TemplateTile] = {}
        self.own: dict[str, TemplateTile] = {}
        self.shows_all = False
        self.show_own(())

    def show_own(self, own: tuple[rbd.State, ...]) -> None:
        """Shows these before those that everybody has."""
        clear(self._grid)
        self.own = {one.name: self._tile(one, True) for one in own}
        self.tiles = {name: self._tile(one, False) for name, one in templates().items()}
        for at, tile in enumerate(self._every()):
            self._grid.addWidget(tile, at // 2, at % 2)
        self.show_all(self.shows_all)

    def _tile(self, template: rbd.State, own: bool) -> TemplateTile:
        tile = TemplateTile(self._theme, template, own, self)
        tile.clicked.connect(lambda _=False: self.chosen.emit(template))
        tile.removed.connect(lambda: self.removed.emit(template.name))
        return tile

    def _every(self) -> tuple[TemplateTile, ...]:
        return (*self.own.values(), *self.tiles.values())

    def show_all(self, every: bool) -> None:
        """All of them, or the first ``FEW``."""
        self.shows_all = every
        for at, tile in enumerate(self._every()):
            tile.setVisible(every or at < FEW)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        for tile in self._every():
            tile.set_theme(theme)
