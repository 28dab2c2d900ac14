"""What stands in a list that has no rows: what will stand there, and how it comes there."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QAbstractItemView, QLabel

from situ_studio.looks.letters import px

SIDE, TOP, WIDEST = 12, 10, 560
"""Px left free beside and above the words, and how wide they become."""


class EmptyHint(QLabel):
    """Seen in ``view`` while it has no rows, and is ``wanted``."""

    def __init__(self, view: QAbstractItemView, words: str) -> None:
        super().__init__(words, view.viewport())
        self._view = view
        self._wanted = True
        self.setProperty("role", "dim")
        self.setWordWrap(True)
        self.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        view.viewport().installEventFilter(self)
        model = view.model()
        for changed in (model.rowsInserted, model.rowsRemoved, model.modelReset):
            changed.connect(self._settle)
        self._settle()

    def want(self, wanted: bool) -> None:
        """Whether it is meant here now: not where something was looked for, and is not there."""
        self._wanted = wanted
        self._settle()

    def _settle(self) -> None:
        seen = self._wanted and self._view.model().rowCount() == 0
        self.setVisible(seen)
        if not seen:
            # Rows come one by one.
            return
        wide = min(self._view.viewport().width() - 2 * px(SIDE), px(WIDEST))
        self.setGeometry(px(SIDE), px(TOP), max(0, wide), self.heightForWidth(max(1, wide)))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize:
            self._settle()
        return False
