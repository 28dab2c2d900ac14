"""Small widgets that lie on a canvas: zoom, the whole drawing in small, a name being edited."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QEvent, QRect, QRectF, Qt, QTimer, Signal
from PySide6.QtGui import (
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPixmap,
    QResizeEvent,
    QTransform,
)
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QLineEdit, QToolButton, QWidget

from situ_studio.looks import icons
from situ_studio.looks.letters import px
from situ_studio.looks.theme import BODY, LABEL, Theme, face, font
from situ_studio.wording.language import tr

if TYPE_CHECKING:
    from situ_studio.canvas.style import Look
    from situ_studio.canvas.viewer import Viewer


MANY = 500
"""Cards from which on the overview is painted anew ``SOON`` ms after a change."""
SOON = 100


class ZoomBar(QFrame):
    """Minus, the zoom in percent, plus, and the whole drawing."""

    stepped = Signal(int)
    fitted = Signal()

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("zoomBar")
        layout = QHBoxLayout(self)
        layout.setContentsMargins(1, 1, 1, 1)
        layout.setSpacing(0)
        self._less = self._button(tr("Zoom out"), -1)
        self._label = QLabel("100 %")
        self._label.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._label.setFont(font(LABEL))
        self._label.setFixedWidth(px(44))
        self._more = self._button(tr("Zoom in"), 1)
        self._fit = self._button(tr("Show the whole drawing"), 0)
        for widget in (self._less, self._label, self._more, self._fit):
            layout.addWidget(widget)
        self.setFixedHeight(px(28))
        self.adjustSize()

    def _button(self, tip: str, step: int) -> QToolButton:
        button = QToolButton()
        button.setToolTip(tip)
        button.setAccessibleName(tip)
        button.setFixedSize(px(28), px(26))
        button.setAutoRaise(True)
        button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        if step:
            button.clicked.connect(lambda: self.stepped.emit(step))
        else:
            button.clicked.connect(self.fitted)
        return button

    def set_zoom(self, zoom: float) -> None:
        self._label.setText(f"{round(zoom * 100)} %")

    def set_theme(self, theme: Theme) -> None:
        self.setStyleSheet(
            f"#zoomBar {{ background: {theme.panel}; border: 1px solid {theme.line};"
            " border-radius: 6px; }"
            f"QLabel {{ color: {theme.text2}; background: transparent; }}"
            "QToolButton { border: none; background: transparent; border-radius: 5px; padding: 0; }"
            f"QToolButton:hover {{ background: {theme.hover}; }}"
        )
        for button, name in ((self._less, "minus"), (self._more, "plus"), (self._fit, "fit")):
            button.setIcon(icons.icon(name, theme.text2))


class Advice(QLabel):
    """What to do first, in words, at the lower edge of a canvas that has next to nothing yet."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._canvas = parent
        self.setFont(font(BODY))
        self.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.setWordWrap(True)
        # What lies under it is dropped on and pressed as if it were not there.
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.hide()

    def set_theme(self, theme: Theme) -> None:
        self.setStyleSheet(f"color: {theme.text2}; background: transparent;")

    def say(self, text: str) -> None:
        if text != self.text():
            self.setText(text)
            self.place()
        self.setVisible(bool(text))

    def place(self) -> None:
        room = self._canvas.size()
        wide = min(440, room.width() - 32)
        high = self.heightForWidth(wide)
        self.setGeometry((room.width() - wide) // 2, room.height() - high - 48, wide, high)


class MiniMap(QWidget):
    """The whole drawing in small; the part that is seen is framed, a press goes there."""

    def __init__(self, viewer: Viewer, look: Look, parent: Any) -> None:
        super().__init__(parent)
        self._viewer = viewer
        self._look = look
        self._canvas = parent
        self.wanted = True
        self._picture: tuple[QPixmap, QRectF] | None = None
        self._soon = QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.setInterval(SOON)
        self._soon.timeout.connect(self._paint_anew)
        self.setFixedSize(120, 66)
        self.setAccessibleName(tr("Overview"))
        self.hide()

    def redraw(self) -> None:
        """Cards, their colours or what is selected have changed.

        Of very many cards the picture follows a little later: no edit waits for it.
        """
        if self._picture is None or len(self._canvas.graph.cards) <= MANY:
            self._paint_anew()
        elif not self._soon.isActive():
            self._soon.start()

    def _paint_anew(self) -> None:
        self._soon.stop()
        self._picture = None
        self.update()

    def _area(self) -> QRectF:
        """What is shown, in the drawing's units."""
        cards = self._canvas.graph.cards.values()
        if not cards:
            return QRectF(0, 0, 1, 1)
        left, top = min(card.x for card in cards), min(card.y for card in cards)
        right = max(card.x + card.width for card in cards)
        bottom = max(card.y + card.height for card in cards)
        return QRectF(left, top, right - left, bottom - top).adjusted(-40, -40, 40, 40)

    def _place(self, area: QRectF) -> QTransform:
        """From the drawing's units to this widget's."""
        scale = min((self.width() - 6) / area.width(), (self.height() - 6) / area.height())
        place = QTransform.fromTranslate(self.width() / 2, self.height() / 2).scale(scale, scale)
        return place.translate(-area.center().x(), -area.center().y())

    def _drawn(self) -> tuple[QPixmap, QRectF]:
        """All but the frame: kept, for the canvas beneath is painted with every move."""
        if self._picture is not None:
            return self._picture
        look, area = self._look, self._area()
        picture = QPixmap(self.size() * self.devicePixelRatioF())
        picture.setDevicePixelRatio(self.devicePixelRatioF())
        picture.fill(Qt.GlobalColor.transparent)
        painter = QPainter(picture)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(look["line"], 1))
        painter.setBrush(look["panel"])
        painter.drawRoundedRect(QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4)
        painter.setTransform(self._place(area), combine=True)
        active: frozenset[str] = getattr(look.live, "active", frozenset())
        # Frames lie under all others.
        every = self._canvas.graph.cards.items()
        for uid, card in sorted(every, key=lambda one: getattr(one[1], "kind", "") != "frame"):
            kind = getattr(card, "kind", "")
            if kind in ("note", "frame"):
                _, color = self._canvas.graph.nodes[uid].view.ink(look)
                painter.fillRect(QRectF(card.x, card.y, card.width, card.height), color)
                continue
            color = look[kind] if kind in ("start", "part") else look["far"]
            if getattr(card, "no", None) in active:
                color = look["live"]
            elif self._canvas.graph.nodes[uid].view.isSelected():
                color = look["accent"]
            painter.fillRect(QRectF(card.x, card.y, card.width, card.height), color)
        painter.end()
        self._picture = picture, area
        return self._picture

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._paint_anew()

    def paintEvent(self, event: QPaintEvent) -> None:
        picture, area = self._drawn()
        painter = QPainter(self)
        painter.drawPixmap(0, 0, picture)
        seen = self._viewer.seen().intersected(area)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(self._look["accent"], 1))
        painter.drawRect(self._place(area).mapRect(seen))

    def _go(self, event: QMouseEvent) -> None:
        _, area = self._drawn()
        there, _ = self._place(area).inverted()
        self._viewer.look_at(there.map(event.position()))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._go(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._go(event)


class InPlace(QLineEdit):
    """A text edited where it stands: Enter takes it, Esc leaves it, Tab takes it and goes on.

    key: what it is the text of.
    """

    finished = Signal(object, object, int)
    """key, the text (None where it is left as it was), which is next: 1, -1, or 0 for none."""

    def __init__(self, key: object, text: str, size: float, parent: QWidget) -> None:
        super().__init__(text, parent)
        self.key = key
        self._done = False
        self.setFont(face(size, 600))
        self.selectAll()

    def dress(self, theme: Theme, radius: int) -> None:
        self.setStyleSheet(
            f"QLineEdit {{ background: {theme.panel}; color: {theme.text};"
            f" border: 2px solid {theme.accent}; border-radius: {radius}px; padding: 0 4px;"
            f" selection-background-color: {theme.accent};"
            f" selection-color: {theme.on_accent}; }}"
        )

    def open_at(self, area: QRect) -> None:
        self.setGeometry(area)
        self.show()
        self.setFocus()

    def close_editor(self, text: str | None = None, onwards: int = 0) -> None:
        """Says ``finished`` once and goes away."""
        if self._done:
            return
        self._done = True
        self.hide()
        self.deleteLater()
        self.finished.emit(self.key, text, onwards)

    def event(self, event: QEvent) -> bool:
        # Before Qt moves the focus by Tab.
        if event.type() == QEvent.Type.KeyPress:
            assert isinstance(event, QKeyEvent)
            if event.key() in (Qt.Key.Key_Tab, Qt.Key.Key_Backtab):
                self.close_editor(self.text(), -1 if event.key() == Qt.Key.Key_Backtab else 1)
                return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.close_editor(self.text())
        elif event.key() == Qt.Key.Key_Escape:
            self.close_editor()
        else:
            super().keyPressEvent(event)

    def focusOutEvent(self, event: Any) -> None:
        super().focusOutEvent(event)
        self.close_editor(self.text())


def name_editor(uid: str, name: str, look: Look, parent: QWidget) -> InPlace:
    """For a card's name, as large as it stands there."""
    editor = InPlace(uid, name, max(11.0, min(28.0, 13.5 * look.zoom)), parent)
    editor.setAccessibleName(tr("Name"))
    editor.dress(look.theme, 4)
    return editor


def priority_editor(key: object, text: str, look: Look, parent: QWidget) -> InPlace:
    """For a priority in its pill: a whole number, or *none*."""
    editor = InPlace(key, text, 12, parent)
    editor.setAccessibleName(tr("Priority"))
    editor.setAlignment(Qt.AlignmentFlag.AlignCenter)
    editor.dress(look.theme, 13)
    return editor
