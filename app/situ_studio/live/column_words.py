"""Words that are others in each frame: a label would have the window laid out anew each time."""

from __future__ import annotations

from functools import lru_cache

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetrics, QPainter, QPaintEvent, QStaticText
from PySide6.QtWidgets import QSizePolicy, QWidget

from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme, face, font


class Words(QWidget):
    """One line, ending with … where it does not fit; its size never depends on what it says.

    size, weight, token: how it is written. wide: px; None: what there is. least: the size
    in which it is written where it would not fit.
    """

    def __init__(
        self,
        theme: Theme,
        size: float,
        weight: int = 400,
        token: str = "text",
        wide: int | None = None,
        least: float | None = None,
    ) -> None:
        super().__init__()
        self.theme, self._token = theme, token
        self._fonts = [font(one, weight) for one in (size, least) if one is not None]
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

    def fit(self) -> None:
        """It is as wide as what it says: for what seldom says something else."""
        self.setFixedWidth(self._needs(self._fonts[0]) + 1)

    def _needs(self, font: QFont) -> int:
        return QFontMetrics(font).horizontalAdvance(self.words)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        fits = (one for one in self._fonts if self._needs(one) <= self.width())
        painter.setFont(next(fits, self._fonts[-1]))
        painter.setPen(self.theme.color(self._token))
        side = Qt.AlignmentFlag.AlignRight if self._right else Qt.AlignmentFlag.AlignLeft
        shown = painter.fontMetrics().elidedText(
            self.words, Qt.TextElideMode.ElideRight, self.width()
        )
        painter.drawText(self.rect(), Qt.AlignmentFlag.AlignVCenter | side, shown)
        painter.end()


class Lettering:
    """Words of one size and weight, as rows have them: each is measured, and laid out, once."""

    def __init__(self, size: float, weight: int = 400) -> None:
        self.font = face(size, weight)
        self.metrics = QFontMetrics(self.font)
        self.advance = lru_cache(512)(self._advance)
        self._laid = lru_cache(128)(self._lay)

    def _advance(self, words: str) -> int:
        return self.metrics.horizontalAdvance(words)

    @staticmethod
    def _lay(words: str) -> QStaticText:
        text = QStaticText(words)
        text.setTextFormat(Qt.TextFormat.PlainText)
        text.setPerformanceHint(QStaticText.PerformanceHint.AggressiveCaching)
        return text

    def draw(
        self,
        painter: QPainter,
        words: str,
        x: float,
        rect: QRectF,
        color: QColor,
        ends: bool = False,
    ) -> None:
        """From ``x`` on, in the middle of the height of ``rect``. ends: they end at ``x``.

        For words that come again: others are as quickly drawn as they are laid out.
        """
        painter.setFont(self.font)
        painter.setPen(color)
        top = rect.center().y() - self.metrics.height() / 2
        at = QPointF(x - self.advance(words) if ends else x, top)
        painter.drawStaticText(at, self._laid(words))
