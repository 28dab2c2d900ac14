"""Small widgets that show an icon or a shortened text in the theme's colours."""

from __future__ import annotations

from PySide6.QtCore import QRect, QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QLabel, QPushButton, QSizePolicy, QToolButton, QWidget

from situ_studio.looks import icons
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme


class IconLabel(QWidget):
    """An icon in a token's colour."""

    def __init__(
        self,
        theme: Theme,
        name: str,
        token: str = "text2",
        size: int = 16,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._theme, self._name, self._token, self._size = theme, name, token, size
        self.setFixedSize(px(size), px(size))
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)

    def set_icon(self, name: str, token: str) -> None:
        self._name, self._token = name, token
        self.update()

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        icons.paint(painter, self._name, QRectF(self.rect()), self._theme.color(self._token))
        painter.end()


class IconButton(QToolButton):
    """A bare square button of an icon; ``words`` are its tooltip and its accessible name."""

    def __init__(
        self,
        theme: Theme,
        name: str,
        words: str,
        token: str = "text3",
        size: int = 16,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._name, self._token, self._size = name, token, size
        self.setProperty("role", "bare")
        self.setFixedSize(px(size + 8), px(size + 8))
        self.setIconSize(QSize(px(size), px(size)))
        self.setToolTip(words)
        self.setAccessibleName(words)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.set_theme(theme)

    def show_icon(self, name: str, words: str) -> None:
        """Another icon, with other words."""
        self._name = name
        self.setToolTip(words)
        self.setAccessibleName(words)
        self.set_theme(self._theme)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self.setIcon(icons.icon(self._name, theme.color(self._token), self._size))


class ThemedButton(QPushButton):
    """A button with an icon and words."""

    def __init__(
        self,
        theme: Theme,
        name: str,
        words: str,
        role: str = "",
        token: str = "text2",
        size: int = 16,
        on: str | None = None,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(words, parent)
        self._name, self._token, self._size, self._on = name, token, size, on
        if role:
            self.setProperty("role", role)
        self.setIconSize(QSize(px(size), px(size)))
        self.setAccessibleName(words)
        self.set_theme(theme)

    def set_theme(self, theme: Theme) -> None:
        on = theme.color(self._on) if self._on is not None else None
        self.setIcon(icons.icon(self._name, theme.color(self._token), self._size, on))


class Elided(QLabel):
    """One line that ends with … where it does not fit; then its tooltip says it whole."""

    def __init__(self, text: str = "", role: str = "", parent: QWidget | None = None) -> None:
        super().__init__(parent)
        if role:
            self.setProperty("role", role)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.setMinimumWidth(8)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setText(text)

    def setText(self, text: str) -> None:
        super().setText(" ".join(text.split()))
        self.setAccessibleName(text)
        self._tell()

    def _tell(self) -> None:
        fits = self.fontMetrics().horizontalAdvance(self.text()) <= self.width()
        self.setToolTip("" if fits else self.text())

    def minimumSizeHint(self) -> QSize:
        return QSize(8, super().minimumSizeHint().height())

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setPen(self.palette().color(self.foregroundRole()))
        rect: QRect = self.contentsRect()
        shown = self.fontMetrics().elidedText(
            self.text(), Qt.TextElideMode.ElideRight, rect.width()
        )
        painter.drawText(rect, int(self.alignment() | Qt.AlignmentFlag.AlignVCenter), shown)
        painter.end()
        self._tell()


def retheme(top: QWidget, theme: Theme) -> None:
    """Gives the theme to every icon below ``top``."""
    for label in top.findChildren(IconLabel):
        label.set_theme(theme)
    for button in top.findChildren(IconButton):
        button.set_theme(theme)
    for themed in top.findChildren(ThemedButton):
        themed.set_theme(theme)
