"""The states below the designer, each as a small picture of its screen, in document order."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import (
    QAbstractListModel,
    QModelIndex,
    QPersistentModelIndex,
    QPointF,
    QRectF,
    QSize,
    Qt,
    Signal,
)
from PySide6.QtGui import (
    QDragEnterEvent,
    QDragMoveEvent,
    QDropEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPen,
    QPixmap,
)
from PySide6.QtWidgets import (
    QListView,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QWidget,
)

from situ.document import rbd
from situ_studio.edits import places, words
from situ_studio.edits.edit import Place
from situ_studio.looks.letters import px
from situ_studio.looks.theme import CAPTION, Theme, font
from situ_studio.screens.media_pictures import picture
from situ_studio.screens.painting import paint_screen
from situ_studio.screens.templates import TEMPLATE, read

WIDE, HIGH = 104, 84
"""Px of a state's place."""
PICTURE = 10, 9, 84, 52
"""Where in it the picture lies."""
MOST = 32 * 2**20
"""Bytes of the pictures that are kept: of 1,900 states, or 480 on a screen of twice the px."""
AnyIndex = QModelIndex | QPersistentModelIndex
NOWHERE = QModelIndex()
PART = int(Qt.ItemDataRole.UserRole) + 1


class _States(QAbstractListModel):
    """The states, Always first where it has a screen."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.application: rbd.Application | None = None
        self.places: tuple[Place, ...] = ()

    def show(self, application: rbd.Application) -> None:
        always: tuple[Place, ...] = (("always",),) if application.always is not None else ()
        every = (*always, *(("state", state.no) for state in application.states))
        if every == self.places:
            self.application = application
            self.dataChanged.emit(self.index(0), self.index(len(every) - 1))
            return
        self.beginResetModel()
        self.application, self.places = application, every
        self.endResetModel()

    def rowCount(self, parent: AnyIndex = NOWHERE) -> int:
        return 0 if parent.isValid() else len(self.places)

    def data(self, index: AnyIndex, role: int = int(Qt.ItemDataRole.DisplayRole)) -> Any:
        if self.application is None or not index.isValid():
            return None
        place = self.places[index.row()]
        if role == Qt.ItemDataRole.DisplayRole:
            if place == ("always",):
                return self.tr("In every state")
            return words.state_words(self.application, place[1])
        if role == PART:
            return places.get(self.application, place)
        return None


class _Pictures(QStyledItemDelegate):
    """The screens in small, as the robot shows them; each is painted once."""

    def __init__(self, theme: Theme, media: Callable[[], Path | None], parent: QWidget) -> None:
        super().__init__(parent)
        self.theme = theme
        self.above: tuple[rbd.Component, ...] = ()
        """The components that Always adds."""
        self._media = media
        self._painted: dict[tuple[int, int, float], tuple[tuple[Any, ...], QPixmap]] = {}

    def sizeHint(self, option: QStyleOptionViewItem, index: AnyIndex) -> QSize:
        return QSize(px(WIDE), px(HIGH))

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: AnyIndex) -> None:
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        theme = self.theme
        area = QRectF(*map(px, PICTURE)).translated(option.rect.topLeft())
        selected = bool(option.state & QStyle.StateFlag.State_Selected)
        part = index.data(PART)
        screen = part.screen if part is not None else None
        if screen is not None:
            above = self.above if getattr(part, "always", False) else ()
            painter.drawPixmap(area.topLeft(), self._picture(screen, above))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(theme.color("line_strong"), 1))
        painter.drawRoundedRect(area, 4, 4)
        if selected:
            painter.setPen(QPen(theme.color("accent"), 2))
            painter.drawRoundedRect(area.adjusted(-4, -4, 4, 4), 5, 5)
        elif option.state & QStyle.StateFlag.State_MouseOver:
            painter.setPen(QPen(theme.color("line_strong"), 1))
            painter.drawRoundedRect(area.adjusted(-4, -4, 4, 4), 5, 5)
        if screen is None:
            painter.setPen(theme.color("text3"))
            painter.setFont(font(CAPTION))
            painter.drawText(area, int(Qt.AlignmentFlag.AlignCenter), "–")
        painter.setFont(font(CAPTION, 600 if selected else 400))
        painter.setPen(theme.color("text" if selected else "text2"))
        below = QRectF(option.rect.x() + 4, area.bottom() + 5, px(WIDE) - 8, px(16))
        text = painter.fontMetrics().elidedText(
            index.data(), Qt.TextElideMode.ElideRight, int(below.width())
        )
        painter.drawText(below, int(Qt.AlignmentFlag.AlignCenter), text)
        painter.restore()

    def _picture(self, screen: rbd.Screen, above: tuple[rbd.Component, ...]) -> QPixmap:
        view: Any = self.parent()
        ratio, media = view.devicePixelRatioF(), self._media()
        every = (screen.background, *(getattr(one, "src", None) for one in screen.components))
        # Compared too: what has the same id later may be another one, and a file be written anew.
        of = (screen, above, tuple(picture(media, src) for src in every if src))
        key = (id(screen), id(above), ratio)
        kept = self._painted.get(key)
        if kept is not None and kept[0][0] is screen and kept[0][1:] == of[1:]:
            return kept[1]
        size = QSize(*map(px, PICTURE[2:]))
        made = QPixmap(size * ratio)
        if (len(self._painted) + 1) * 4 * made.width() * made.height() > MOST:
            self._painted.clear()
        made.setDevicePixelRatio(ratio)
        made.fill(Qt.GlobalColor.transparent)
        painter = QPainter(made)
        paint_screen(painter, QRectF(QPointF(0, 0), size), screen, above, media)
        painter.end()
        self._painted[key] = (of, made)
        return made


class StateStrip(QListView):
    """chosen: the place of the state that a person goes to."""

    chosen = Signal(tuple)
    template_dropped = Signal(object, tuple)
    """A template, and the place of the state that gets it."""

    def __init__(
        self, theme: Theme, media: Callable[[], Path | None], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setAccessibleName(self.tr("States"))
        self._states = _States(self)
        self._pictures = _Pictures(theme, media, self)
        self.setModel(self._states)
        self.setItemDelegate(self._pictures)
        self.setFlow(QListView.Flow.LeftToRight)
        self.setWrapping(False)
        self.setUniformItemSizes(True)
        self.setMouseTracking(True)
        self.setFixedHeight(px(HIGH) + 12)
        self.setHorizontalScrollMode(QListView.ScrollMode.ScrollPerPixel)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setAcceptDrops(True)
        self.setEditTriggers(QListView.EditTrigger.NoEditTriggers)

    def set_theme(self, theme: Theme) -> None:
        self._pictures.theme = theme
        self.viewport().update()

    def show_state(self, application: rbd.Application, place: Place) -> None:
        """Shows the states, one of them as the one that is drawn."""
        always = application.always
        above = always.screen.components if always is not None and always.screen is not None else ()
        self._pictures.above = above
        self._states.show(application)
        every = self._states.places
        row = every.index(place) if place in every else -1
        index = self._states.index(row) if row >= 0 else QModelIndex()
        if row >= 0 and index == self.currentIndex():
            # An edit of it: a person may have scrolled on meanwhile.
            return
        self.setCurrentIndex(index)
        # Its neighbours are seen too: there it goes on.
        for near in (row + 1, row - 1, row):
            if 0 <= near < len(every):
                self.scrollTo(self._states.index(near), QListView.ScrollHint.EnsureVisible)

    def place_at(self, index: AnyIndex) -> Place:
        return self._states.places[index.row()]

    def step(self, by: int) -> None:
        """Goes to the next state (1), or to the one before (-1)."""
        row = self.currentIndex().row() + by
        if 0 <= row < len(self._states.places):
            self.chosen.emit(self._states.places[row])

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        super().mouseReleaseEvent(event)
        index = self.indexAt(event.position().toPoint())
        if index.isValid() and event.button() == Qt.MouseButton.LeftButton:
            self.chosen.emit(self.place_at(index))

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        self._welcome(event)

    def dragMoveEvent(self, event: QDragMoveEvent) -> None:
        self._welcome(event)

    def _welcome(self, event: QDragMoveEvent) -> None:
        fits = event.mimeData().hasFormat(TEMPLATE)
        event.setAccepted(fits and self.indexAt(event.position().toPoint()).isValid())

    def dropEvent(self, event: QDropEvent) -> None:
        index = self.indexAt(event.position().toPoint())
        template = read(bytes(event.mimeData().data(TEMPLATE).data()))
        if index.isValid() and template is not None:
            event.setDropAction(Qt.DropAction.CopyAction)
            event.accept()
            self.template_dropped.emit(template, self.place_at(index))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        ways = {Qt.Key.Key_Left: -1, Qt.Key.Key_Right: 1}
        if (by := ways.get(Qt.Key(event.key()))) is not None:
            self.step(by)
        elif event.key() in (Qt.Key.Key_PageUp, Qt.Key.Key_PageDown):
            # Those go from state to state in all of the designer.
            event.ignore()
        else:
            super().keyPressEvent(event)
