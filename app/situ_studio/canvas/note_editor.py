"""A note written on where it stands: taken by Ctrl+Enter, Tab or a click elsewhere."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QEvent, QRect, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QPlainTextEdit, QWidget

from situ_studio.canvas.style import Look
from situ_studio.looks.theme import face
from situ_studio.wording.language import tr


class NoteEditor(QPlainTextEdit):
    """As ``overlay.InPlace``, for more than a line; Esc leaves the text as it was."""

    finished = Signal(object, object, int)
    """key, the text (None where it is left as it was), which is next: 1, -1, or 0 for none."""

    def __init__(self, key: str, text: str, look: Look, parent: QWidget) -> None:
        super().__init__(text, parent)
        self.key = key
        self._done = False
        self.setAccessibleName(tr("Note"))
        self.setFont(face(max(11.0, min(24.0, 12 * look.zoom)), 400))
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        theme = look.theme
        self.setStyleSheet(
            f"QPlainTextEdit {{ background: {theme.panel}; color: {theme.text};"
            f" border: 2px solid {theme.accent}; border-radius: 2px; padding: 2px;"
            f" selection-background-color: {theme.accent};"
            f" selection-color: {theme.on_accent}; }}"
        )
        self.selectAll()

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
                back = event.key() == Qt.Key.Key_Backtab
                self.close_editor(self.toPlainText(), -1 if back else 1)
                return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        enter = event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter)
        if enter and event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            self.close_editor(self.toPlainText())
        elif event.key() == Qt.Key.Key_Escape:
            self.close_editor()
        else:
            super().keyPressEvent(event)

    def focusOutEvent(self, event: Any) -> None:
        super().focusOutEvent(event)
        self.close_editor(self.toPlainText())
