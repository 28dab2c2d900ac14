"""A test of a condition, edited where it stands: the box of the forms, over the drawing."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QEvent, QPoint, QRect, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QApplication, QFrame, QVBoxLayout, QWidget

from situ.document.condition import Test
from situ_studio.edits.edit import Place
from situ_studio.edits.vocabulary import Vocabulary
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.test_box import TestBox

WIDE = 244


class TestEditor(QFrame):
    """Stays open while its fields are used; Esc, Enter and a press elsewhere close it."""

    changed = Signal(tuple, object)
    """The test's place, and the test as it shall be."""
    removed = Signal(tuple)
    closed = Signal()

    __test__ = False

    def __init__(self, theme: Theme, place: Place, parent: QWidget) -> None:
        super().__init__(parent)
        self.place = place
        self._drawing = parent
        self._gone = self._stays = False
        self.setObjectName("testEditor")
        self.setAccessibleName(self.tr("Test"))
        self.setStyleSheet(
            f"#testEditor {{ background: {theme.panel}; border: 2px solid {theme.accent};"
            " border-radius: 8px; }"
        )
        layout = QVBoxLayout(self)
        layout.setContentsMargins(4, 4, 4, 4)
        self.box = TestBox(theme)
        self.box.changed.connect(lambda test: self.changed.emit(self.place, test))
        self.box.removed.connect(self._on_removed)
        # As high as its fields need at any time: some tests have no value.
        layout.setSizeConstraint(QVBoxLayout.SizeConstraint.SetFixedSize)
        self.box.setFixedWidth(px(WIDE))
        layout.addWidget(self.box)

    def show_test(self, test: Test, vocabulary: Vocabulary) -> None:
        self.box.show_test(test, vocabulary)
        self.adjustSize()

    def open_at(self, row: QRect) -> None:
        """Below a line of a condition, or above where there is no room; the test is typed into."""
        self.settle_at(row)
        self.show()
        self.raise_()
        self.box.test.setFocus(Qt.FocusReason.PopupFocusReason)
        application = QApplication.instance()
        if isinstance(application, QApplication):
            application.focusChanged.connect(self._on_focus)

    def refuse(self) -> None:
        """What was typed is not taken: the Enter that ended it closes nothing."""
        self._stays = True

    def settle_at(self, row: QRect) -> None:
        room = self._drawing.rect().adjusted(4, 4, -4, -4)
        self.adjustSize()
        top = row.bottom() + 4
        if top + self.height() > room.bottom():
            top = max(room.top(), row.top() - 4 - self.height())
        left = max(room.left(), min(row.left(), room.right() - self.width()))
        self.move(QPoint(left, top))

    def close_editor(self) -> None:
        """Goes away; what is being typed is taken first."""
        if self._gone:
            return
        self._gone = True
        application = QApplication.instance()
        if isinstance(application, QApplication):
            application.focusChanged.disconnect(self._on_focus)
        self.hide()
        self.deleteLater()
        self.closed.emit()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        stays, self._stays = self._stays, False
        ends = event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and not stays
        if ends or event.key() == Qt.Key.Key_Escape:
            self.close_editor()

    def focusNextPrevChild(self, next: bool) -> bool:
        """Tab goes from field to field and round again: the drawing beneath would keep it."""
        if self._gone:
            return False
        fields = [
            w
            for w in self.findChildren(QWidget)
            if w.isVisible() and w.isEnabled() and w.focusPolicy() & Qt.FocusPolicy.TabFocus
        ]
        now = self.focusWidget()
        step = 1 if next else -1
        at = fields.index(now) if now in fields else -step
        reason = Qt.FocusReason.TabFocusReason if next else Qt.FocusReason.BacktabFocusReason
        fields[(at + step) % len(fields)].setFocus(reason)
        return True

    def event(self, event: QEvent) -> bool:
        # The drawing beneath takes no key that a field left over.
        handled = super().event(event)
        if event.type() == QEvent.Type.KeyPress:
            event.accept()
            return True
        return handled

    def _on_removed(self) -> None:
        place = self.place
        self.close_editor()
        self.removed.emit(place)

    def _on_focus(self, before: Any, now: Any) -> None:
        if now is not None and now.window() is self.window() and not self.isAncestorOf(now):
            self.close_editor()
