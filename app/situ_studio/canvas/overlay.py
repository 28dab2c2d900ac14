"""Small widgets that lie on a canvas: zoom, the whole drawing in small, a name being edited."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QEvent, QPointF, QRect, QRectF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QLineEdit, QToolButton, QWidget

from situ_studio import icons
from situ_studio.theme import LABEL, Theme, font

if TYPE_CHECKING:
    from situ_studio.canvas.style import Look
    from situ_studio.canvas.viewer import Viewer


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
        self._less = self._button("Zoom out", -1)
        self._label = QLabel("100 %")
        self._label.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._label.setFont(font(LABEL))
        self._label.setFixedWidth(44)
        self._more = self._button("Zoom in", 1)
        self._fit = self._button("Show the whole drawing", 0)
        for widget in (self._less, self._label, self._more, self._fit):
            layout.addWidget(widget)
        self.setFixedHeight(28)
        self.adjustSize()

    def _button(self, tip: str, step: int) -> QToolButton:
        button = QToolButton()
        button.setToolTip(tip)
        button.setAccessibleName(tip)
        button.setFixedSize(28, 26)
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


class MiniMap(QWidget):
    """The whole drawing in small; the part that is seen is framed, a press goes there."""

    def __init__(self, viewer: Viewer, look: Look, parent: Any) -> None:
        super().__init__(parent)
        self._viewer = viewer
        self._look = look
        self._canvas = parent
        self.wanted = True
        self.setFixedSize(120, 66)
        self.setAccessibleName("Overview")
        self.hide()

    def _scale(self) -> tuple[QRectF, float]:
        area = QRectF()
        for card in self._canvas.graph.cards.values():
            area = area.united(QRectF(card.x, card.y, card.width, card.height))
        area = area.adjusted(-40, -40, 40, 40)
        scale = min((self.width() - 6) / area.width(), (self.height() - 6) / area.height())
        return area, scale

    def paintEvent(self, event: QPaintEvent) -> None:
        look = self._look
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(look["line"], 1))
        painter.setBrush(look["panel"])
        painter.drawRoundedRect(QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4)
        area, scale = self._scale()
        painter.translate(
            (self.width() - area.width() * scale) / 2, (self.height() - area.height() * scale) / 2
        )
        painter.scale(scale, scale)
        painter.translate(-area.topLeft())
        live = look.live
        active: frozenset[str] = getattr(live, "active", frozenset())
        for uid, card in self._canvas.graph.cards.items():
            kind = getattr(card, "kind", "")
            color = look[kind] if kind in ("start", "part") else look["far"]
            if getattr(card, "no", None) in active:
                color = look["live"]
            elif self._canvas.graph.nodes[uid].view.isSelected():
                color = look["accent"]
            painter.fillRect(QRectF(card.x, card.y, card.width, card.height), color)
        seen = self._viewer.seen().intersected(area)
        painter.setPen(QPen(look["accent"], 1 / scale))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(seen)

    def _go(self, event: QMouseEvent) -> None:
        area, scale = self._scale()
        left = (self.width() - area.width() * scale) / 2
        top = (self.height() - area.height() * scale) / 2
        spot = area.topLeft() + (event.position() - QPointF(left, top)) / scale
        self._viewer.look_at(spot)

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
        self.setFont(font(size, 600))
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
    editor.setAccessibleName("Name")
    editor.dress(look.theme, 4)
    return editor


def priority_editor(key: object, text: str, look: Look, parent: QWidget) -> InPlace:
    """For a priority in its pill: a whole number, or *none*."""
    editor = InPlace(key, text, 12, parent)
    editor.setAccessibleName("Priority")
    editor.setAlignment(Qt.AlignmentFlag.AlignCenter)
    editor.dress(look.theme, 13)
    return editor
