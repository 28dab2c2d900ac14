"""The strip of panels below the canvas, and the switch between views."""

from __future__ import annotations

from PySide6.QtCore import QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QFont, QFontMetrics, QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import (
    QButtonGroup,
    QFrame,
    QHBoxLayout,
    QMenu,
    QPushButton,
    QSizePolicy,
    QStackedWidget,
    QStyle,
    QStyleOptionButton,
    QStylePainter,
    QVBoxLayout,
    QWidget,
)

from situ_studio.looks.letters import px
from situ_studio.looks.theme import CAPTION, Theme, font
from situ_studio.panels.header import TitleBar
from situ_studio.widgets.icon_widgets import IconButton, ThemedButton
from situ_studio.widgets.layouts import rule


class Segments(QFrame):
    """Buttons of which one is down: ``Graph | Outline``."""

    chosen = Signal(str)

    def __init__(
        self,
        theme: Theme,
        segments: tuple[tuple[str, str, str], ...],
        words: str,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setProperty("role", "segments")
        self.setAccessibleName(words)
        self.setFixedHeight(px(28))
        line = QHBoxLayout(self)
        line.setContentsMargins(1, 1, 1, 1)
        line.setSpacing(0)
        self._group = QButtonGroup(self)
        self._buttons: dict[str, QPushButton] = {}
        for name, icon, text in segments:
            button: QPushButton
            if icon:
                button = ThemedButton(theme, icon, text, "", "text2", 14, on="accent")
            else:
                button = QPushButton(text)
            button.setCheckable(True)
            # Heard as one of several, not as a box of its own.
            button.setAutoExclusive(True)
            button.setAccessibleName(text)
            button.setToolTip(f"{words}: {text}")
            button.clicked.connect(lambda _=False, n=name: self.chosen.emit(n))
            self._group.addButton(button)
            self._buttons[name] = button
            line.addWidget(button)

    def show_choice(self, name: str) -> None:
        self._buttons[name].setChecked(True)

    def set_offered(self, names: tuple[str, ...]) -> None:
        """Shows only these."""
        for name, button in self._buttons.items():
            button.setVisible(name in names)

    def set_narrow(self, narrow: bool) -> None:
        """Only the icons, with the words as tooltips."""
        for button in self._buttons.values():
            words = button.accessibleName()
            if bool(button.text()) == narrow:
                button.setText("" if narrow else words)
                button.setToolTip(words if narrow else "")

    def button(self, name: str) -> QPushButton:
        return self._buttons[name]


READABLE = 64
"""Px that a tab of the strip below has at least, if its words want them."""
AROUND = 8
"""Px beside its words at least; two more where they are as the style measures them."""


class CountButton(QPushButton):
    """A tab of the strip below, with a number in a pill behind its words; 0 shows none.

    Where there is little room its words end with …, and its tooltip says them whole.
    """

    def __init__(self, theme: Theme, words: str, parent: QWidget | None = None) -> None:
        super().__init__(words, parent)
        self._theme, self._words, self._count = theme, words, 0
        self.setCheckable(True)
        # Heard as one of several, not as a box of its own.
        self.setAutoExclusive(True)
        self.setAccessibleName(words)
        self.toggled.connect(self._settle_tip)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self.update()

    def set_count(self, count: int) -> None:
        self._count = count
        self.setAccessibleName(f"{self._words} {count}" if count else self._words)
        self.setText(self._words + self._behind())
        self._settle_tip()

    def _behind(self) -> str:
        """Room for the pill: the words stand at the left of what spaces make wider."""
        return "\u2003\u2002" + "\u2002" * len(str(self._count)) if self._count else ""

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._settle_tip()

    def _settle_tip(self) -> None:
        self.setToolTip("" if self._fitting() == self._words else self._words)

    def sizeHint(self) -> QSize:
        """As wide as it is while it is the one that is shown, whose letters are bolder."""
        hint = super().sizeHint()
        wide = self._letters(True).horizontalAdvance(self._words + self._behind())
        return hint.expandedTo(QSize(wide + 2 * px(AROUND), 0))

    def _letters(self, shown: bool) -> QFontMetrics:
        """As the style paints them."""
        letters = QFont(self.font())
        if shown:
            letters.setWeight(QFont.Weight.DemiBold)
        return QFontMetrics(letters)

    def _room(self) -> QRect:
        """Where words are painted."""
        return self.rect().adjusted(px(AROUND), 0, -px(AROUND), 0)

    def _fitting(self) -> str:
        """What of its words has room."""
        metrics = self._letters(self.isChecked())
        room = self._room().width() - metrics.horizontalAdvance(self._behind())
        return metrics.elidedText(self._words, Qt.TextElideMode.ElideRight, room)

    def paintEvent(self, event: QPaintEvent) -> None:
        option = QStyleOptionButton()
        self.initStyleOption(option)
        styled = QStylePainter(self)
        styled.drawControl(QStyle.ControlElement.CE_PushButtonBevel, option)
        option.rect, option.text = self._room(), self._fitting() + self._behind()
        styled.drawControl(QStyle.ControlElement.CE_PushButtonLabel, option)
        styled.end()
        if not self._count:
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setFont(font(CAPTION, 500))
        text = str(self._count)
        high = px(16)
        width = max(float(high), painter.fontMetrics().horizontalAdvance(text) + px(10))
        pill = QRectF(self.width() - width - px(10), (self.height() - high) / 2, width, high)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(self._theme.color("hover"))
        painter.drawRoundedRect(pill, high / 2, high / 2)
        painter.setPen(self._theme.color("text2"))
        painter.drawText(pill, int(Qt.AlignmentFlag.AlignCenter), text)
        painter.end()


class BottomPanels(QWidget):
    """Panels below the canvas, one shown at a time; a second click on its tab folds them.

    ``strip`` with the tabs is meant to be the title bar of their dock.
    """

    folded = Signal(bool)
    """It is folded now, or not any more."""
    chosen = Signal(str)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme = theme
        self.setProperty("role", "panel")
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        self.strip = TitleBar(33)
        whole = QVBoxLayout(self.strip)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.setSpacing(0)
        tabs = QFrame()
        tabs.setProperty("role", "bottomtabs")
        whole.addWidget(tabs, 1)
        whole.addWidget(rule())
        self._line = QHBoxLayout(tabs)
        self._line.setContentsMargins(4, 0, 12, 0)
        self._line.setSpacing(0)
        self._line.addStretch(1)
        self.more = IconButton(theme, "more", self.tr("More panels"), "text2", 16)
        self.more.hide()
        self.more.clicked.connect(self._on_more)
        self._line.addWidget(self.more)
        self._fold = IconButton(theme, "down", self.tr("Fold the panel"), "text2", 14)
        self._fold.clicked.connect(lambda: self.set_folded(not self.is_folded))
        self._line.addWidget(self._fold)
        self._stack = QStackedWidget()
        column.addWidget(self._stack, 1)
        self._group = QButtonGroup(self)
        self._buttons: dict[str, CountButton] = {}
        self._panels: dict[str, QWidget] = {}
        self._gone: set[str] = set()

    @property
    def is_folded(self) -> bool:
        return self._stack.isHidden()

    @property
    def current(self) -> str:
        """The name of the panel that is shown."""
        shown = self._stack.currentWidget()
        return next((n for n, w in self._panels.items() if w is shown), "")

    def add(self, name: str, words: str, panel: QWidget) -> None:
        button = CountButton(self._theme, words)
        button.clicked.connect(lambda: self._on_clicked(name))
        self._group.addButton(button)
        self._line.insertWidget(len(self._buttons), button)
        self._buttons[name], self._panels[name] = button, panel
        self._stack.addWidget(panel)
        self._settle_room()
        if len(self._buttons) == 1:
            button.setChecked(True)
        self._settle_tabs()

    def set_shown(self, name: str, shown: bool) -> None:
        """Whether a panel has a tab at the moment."""
        if shown:
            self._gone.discard(name)
        else:
            self._gone.add(name)
        if not shown and self.current == name:
            self.choose(next(iter(self._buttons)))
        self._settle_tabs()

    @property
    def names(self) -> tuple[str, ...]:
        """Of all panels, as their tabs stand."""
        return tuple(self._buttons)

    def set_count(self, name: str, count: int) -> None:
        """A number behind the tab's words; 0 shows none."""
        self._buttons[name].set_count(count)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        for button in self._buttons.values():
            button.set_theme(theme)

    def choose(self, name: str) -> None:
        """Shows a panel, unfolded."""
        self._buttons[name].setChecked(True)
        self._stack.setCurrentWidget(self._panels[name])
        self._settle_room()
        self._settle_tabs()
        self.set_folded(False)
        self.chosen.emit(name)

    def _settle_room(self) -> None:
        """Only the panel that is shown asks for width."""
        for panel in self._panels.values():
            shown = panel is self._stack.currentWidget()
            policy = panel.sizePolicy()
            policy.setHorizontalPolicy(
                QSizePolicy.Policy.Preferred if shown else QSizePolicy.Policy.Ignored
            )
            panel.setSizePolicy(policy)
        self._stack.updateGeometry()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._settle_tabs()

    def _settle_tabs(self) -> None:
        """Tabs that can be read, the one that is shown among them; a menu has the others."""
        there = [name for name in self._buttons if name not in self._gone]
        wide = {name: min(px(READABLE), self._buttons[name].sizeHint().width()) for name in there}
        margins = self._line.contentsMargins()
        around = margins.left() + margins.right() + self._fold.width()
        room = self.width() - around
        overflows = sum(wide.values()) > room
        if overflows:
            room -= self.more.width() + wide.get(self.current, 0)
        for name, button in self._buttons.items():
            if name in wide and name != self.current:
                room -= wide[name]
            button.setVisible(name in wide and (not overflows or name == self.current or room >= 0))
        self.more.setVisible(overflows)

    def _on_more(self) -> None:
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        for name, button in self._buttons.items():
            if name not in self._gone and button.isHidden():
                made = menu.addAction(button.accessibleName())
                made.triggered.connect(lambda _=False, name=name: self.choose(name))
        menu.popup(self.more.mapToGlobal(self.more.rect().bottomLeft()))

    def button(self, name: str) -> QPushButton:
        return self._buttons[name]

    def set_folded(self, folded: bool) -> None:
        """Only the strip, or the panel too."""
        if folded == self.is_folded:
            return
        self._stack.setVisible(not folded)
        self.setMaximumHeight(0 if folded else 16777215)
        if folded:
            self._fold.show_icon("up", self.tr("Unfold the panel"))
        else:
            self._fold.show_icon("down", self.tr("Fold the panel"))
        self.folded.emit(folded)

    def _on_clicked(self, name: str) -> None:
        if self.current == name and not self.is_folded:
            self.set_folded(True)
        else:
            self.choose(name)
