"""A combo box that screen readers call by its name, not by what is chosen in it alone.

On Linux Qt tells as the name of a combo box what is chosen; readers take its name from the label
that it belongs to. Where none stands before it, as in a line of a condition, there is one that is
never seen.
"""

from __future__ import annotations

from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QComboBox, QLabel, QWidget


def label_unseen(box: QComboBox, name: str) -> QLabel:
    """A label that readers find: among what stands in the same widget as the box."""
    label = QLabel(name, box.parentWidget())
    label.setBuddy(box)
    label.hide()
    # What is filled anew deletes its boxes, and keeps what else stands there.
    box.destroyed.connect(label.deleteLater)
    return label


class NamedBox(QComboBox):
    """Called by its accessible name, unless a label beside it has it as buddy."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._label: QLabel | None = None

    def setAccessibleName(self, name: str) -> None:
        super().setAccessibleName(name)
        if self._label is not None:
            self._label.setText(name)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        # It has come where it stays.
        around = self.parentWidget()
        beside = around.children() if around is not None else []
        labels = [one for one in beside if isinstance(one, QLabel) and one.buddy() is self]
        if around is not None and not labels:
            self._label = label_unseen(self, self.accessibleName())
