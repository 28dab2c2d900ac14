"""A guide as it is seen in the designer: a line over the screen and the ground round it.

The mouse goes through it: what lies under it on the screen is taken first (``guiding``).
"""

from __future__ import annotations

from PySide6.QtCore import QEvent, QLineF, QRect, QRectF, Qt, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from situ_studio.looks.letters import px
from situ_studio.looks.theme import CAPTION, LIGHT, Theme, font
from situ_studio.screens.guides import Guide
from situ_studio.screens.keyboard import ARROWS, DELETE

ROOM = 60
"""Px across the line that its place has room in."""
PILL = 16
TAKEN = (*ARROWS, *DELETE, Qt.Key.Key_Escape)


class GuideLine(QWidget):
    """One guide. Tab comes to it, arrows move it, Delete removes it, Escape leaves it."""

    moved = Signal(object, float)
    """The guide, and by how many percent."""
    removed = Signal(object)
    left = Signal()

    def __init__(self, theme: Theme, parent: QWidget) -> None:
        super().__init__(parent)
        self._theme = theme
        self.guide = Guide("x", 0.0)
        self.dragged = False
        self._lit = QRect()
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccessibleDescription(
            self.tr("Arrows move it by 1 %, with Shift by 10 %, with Alt by 0.1 %; Del removes it.")
        )

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self.update()

    def show_guide(self, guide: Guide, dragged: bool = False) -> None:
        self.guide, self.dragged = guide, dragged
        words = self.tr("Upright guide at {0} %")
        if guide.axis == "y":
            words = self.tr("Lying guide at {0} %")
        self.setAccessibleName(words.format(f"{guide.at:g}"))
        self.update()

    def lie(self, geometry: QRect, lit: QRect) -> None:
        """Where it lies, and where the robot's screen does, both in its parent."""
        self.setGeometry(geometry)
        self._lit = lit.translated(-geometry.topLeft())
        self.update()

    # -- keys ----------------------------------------------------------------------------

    def event(self, event: QEvent) -> bool:
        asked = event.type() == QEvent.Type.ShortcutOverride
        if asked and isinstance(event, QKeyEvent) and event.key() in TAKEN:
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key, held = Qt.Key(event.key()), event.modifiers()
        if key in ARROWS:
            across, down = ARROWS[key]
            way = across if self.guide.axis == "x" else down
            far = 1.0
            if held & Qt.KeyboardModifier.ShiftModifier:
                far = 10.0
            elif held & Qt.KeyboardModifier.AltModifier:
                far = 0.1
            if way:
                self.moved.emit(self.guide, way * far)
        elif key in DELETE:
            self.removed.emit(self.guide)
        elif key == Qt.Key.Key_Escape:
            self.left.emit()
        else:
            super().keyPressEvent(event)

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        self.update()

    # -- painting ------------------------------------------------------------------------

    def paintEvent(self, event: QPaintEvent) -> None:
        painter, ink = QPainter(self), self._theme.color("guides")
        told = self.dragged or self.hasFocus()
        painter.setPen(QPen(ink, 2 if told else 1))
        middle = QRectF(self.rect()).center()
        upright = self.guide.axis == "x"
        whole = QLineF(middle.x(), 0, middle.x(), self.height())
        if not upright:
            whole = QLineF(0, middle.y(), self.width(), middle.y())
        painter.drawLine(whole)
        # The robot's screen is light in both themes.
        painter.setClipRect(self._lit)
        painter.setPen(QPen(LIGHT.color("guides"), painter.pen().width()))
        painter.drawLine(whole)
        painter.setClipping(False)
        if told:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setFont(font(CAPTION, 600))
            words = f"{self.guide.at:g} %"
            wide = painter.fontMetrics().horizontalAdvance(words) + 12
            pill = QRectF(0, 0, wide, px(PILL))
            pill.moveCenter(middle)
            if upright:
                # Above stands where one is.
                pill.moveBottom(self.height() - 4)
            else:
                pill.moveLeft(4)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(ink)
            painter.drawRoundedRect(pill, 4, 4)
            painter.setPen(self._theme.color("on_accent"))
            painter.drawText(pill, int(Qt.AlignmentFlag.AlignCenter), words)
        painter.end()
