"""The card of the current situation: which of how many, and what it rests on."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QEvent, QPoint, Qt, Signal
from PySide6.QtGui import (
    QAccessible,
    QEnterEvent,
    QFocusEvent,
    QKeyEvent,
    QMouseEvent,
    QResizeEvent,
)
from PySide6.QtWidgets import QFrame, QHBoxLayout, QVBoxLayout, QWidget

from situ_studio.assistive.heard_as import hear_as
from situ_studio.live.column_rows import TESTS, PartTold, SituationTold
from situ_studio.live.column_words import Words
from situ_studio.looks.letters import px
from situ_studio.looks.theme import CAPTION, LABEL, SECTION, Theme
from situ_studio.widgets.icon_widgets import IconButton, IconLabel, retheme
from situ_studio.wording.language import tr

_SIGNS = {True: ("check", "live"), False: ("close", "text3"), None: ("minus", "text3")}


class SituationCard(QFrame):
    """As the rows below it: a click, or Enter, goes there; Why? has a button and a menu."""

    chosen = Signal()
    why_asked = Signal()
    menu_asked = Signal(QPoint)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "situation")
        hear_as(self, QAccessible.Role.Button, lambda card: card.chosen.emit())
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self._told: SituationTold | None = None
        self._pressed = False
        column = QVBoxLayout(self)
        column.setContentsMargins(10, 7, 10, 7)
        column.setSpacing(3)
        line = QHBoxLayout()
        line.setSpacing(8)
        line.addWidget(IconLabel(theme, "situation", "situation", 18))
        self.name = Words(theme, SECTION, 600, least=LABEL)
        line.addWidget(self.name, 1)
        self.place = Words(theme, CAPTION, token="situation", wide=0)
        line.addWidget(self.place)
        column.addLayout(line)
        self.parts = [_Part(theme) for _ in range(TESTS)]
        for part in self.parts:
            column.addWidget(part)
        self.kept = Words(theme, CAPTION, token="text3")
        column.addWidget(self.kept)
        self.why = IconButton(theme, "why", tr("Why?"), "text2", 16, self)
        self.why.setFixedSize(px(22), px(22))
        self.why.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.why.setProperty("role", "over")
        self.why.hide()
        self.why.clicked.connect(self.why_asked)

    def set_theme(self, theme: Theme) -> None:
        retheme(self, theme)
        for words in self.findChildren(Words):
            words.theme = theme

    def show_told(self, told: SituationTold) -> None:
        if told == self._told:
            return
        before, self._told = self._told, told
        self.name.show_words(told.name)
        if told.place != self.place.words:
            self.place.show_words(told.place)
            self.place.fit()
        for number, part in enumerate(self.parts):
            shown = number < len(told.parts)
            if shown:
                part.show_told(told.parts[number])
            if part.isHidden() == shown:
                part.setVisible(shown)
        self.kept.show_words(told.kept)
        if self.kept.isHidden() == bool(told.kept):
            self.kept.setVisible(bool(told.kept))
        signs = {True: tr("holds"), False: tr("does not hold"), None: tr("not known")}
        rests = [f"{part.words}: {signs[part.holds]}" for part in told.parts]
        place = f"{told.name}, {told.place}" if told.place else told.name
        self.setAccessibleName(tr("Situation {0}").format(place))
        # Where there is none, readers take the tip, with its tags.
        self.setAccessibleDescription(". ".join((*rests, told.kept)).strip(". ") or told.tip)
        if before is None or before.tip != told.tip:
            self.setToolTip(f"<p>{told.tip}</p>" if told.tip else "")

    # -- hands and keys ----------------------------------------------------------------

    def _show_why(self, shown: bool) -> None:
        self.why.setVisible(shown)
        self.why.raise_()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.why.move(self.width() - self.why.width() - px(6), px(6))

    def enterEvent(self, event: QEnterEvent) -> None:
        self._show_why(True)
        super().enterEvent(event)

    def leaveEvent(self, event: QEvent) -> None:
        self._show_why(self.hasFocus())
        super().leaveEvent(event)

    def focusInEvent(self, event: QFocusEvent) -> None:
        self._show_why(True)
        super().focusInEvent(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self._show_why(self.underMouse())
        super().focusOutEvent(event)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._pressed = event.button() == Qt.MouseButton.LeftButton

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        pressed, self._pressed = self._pressed, False
        if pressed and self.rect().contains(event.position().toPoint()):
            self.chosen.emit()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space):
            self.chosen.emit()
        else:
            super().keyPressEvent(event)

    def contextMenuEvent(self, event: Any) -> None:
        by_keys = event.reason() == event.Reason.Keyboard
        at = self.mapToGlobal(self.rect().bottomLeft()) if by_keys else event.globalPos()
        self.menu_asked.emit(at)


class _Part(QWidget):
    """A part of its condition, and whether it holds."""

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        line = QHBoxLayout(self)
        line.setContentsMargins(2, 0, 0, 0)
        line.setSpacing(7)
        self._sign = IconLabel(theme, "check", "live", 13)
        line.addWidget(self._sign)
        self._words = Words(theme, LABEL)
        line.addWidget(self._words, 1)
        self.told: PartTold | None = None

    def show_told(self, told: PartTold) -> None:
        if told != self.told:
            self.told = told
            self._sign.set_icon(*_SIGNS[told.holds])
            self._words.show_words(told.words)
