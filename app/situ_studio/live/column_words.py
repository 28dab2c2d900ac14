"""Words that are others in each frame: a label would have the window laid out anew each time."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from situ_studio.letters import px
from situ_studio.theme import Theme, font


class Words(QWidget):
    """One line, ending with … where it does not fit; its size never depends on what it says.

    size, weight, token: how it is written. wide: px; None: what there is.
    """

    def __init__(
        self,
        theme: Theme,
        size: float,
        weight: int = 400,
        token: str = "text",
        wide: int | None = None,
    ) -> None:
        super().__init__()
        self.theme, self._token = theme, token
        self._font = font(size, weight)
        self._right = wide is not None
        self.words = ""
        self.setFixedHeight(px(round(size) + 5))
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        if wide is not None:
            self.setFixedWidth(px(wide))
        else:
            self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def show_words(self, words: str) -> None:
        if words != self.words:
            self.words = words
            self.setAccessibleName(words)
            self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setFont(self._font)
        painter.setPen(self.theme.color(self._token))
        side = Qt.AlignmentFlag.AlignRight if self._right else Qt.AlignmentFlag.AlignLeft
        shown = painter.fontMetrics().elidedText(
            self.words, Qt.TextElideMode.ElideRight, self.width()
        )
        painter.drawText(self.rect(), Qt.AlignmentFlag.AlignVCenter | side, shown)
        painter.end()
