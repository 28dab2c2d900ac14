"""Numbers that arrow keys and the wheel step, with the look of the other fields."""

from __future__ import annotations

from PySide6.QtCore import QMargins
from PySide6.QtWidgets import QDoubleSpinBox, QSpinBox

# A style sheet's padding does not reach the line inside.
_ROOM = QMargins(6, 0, 6, 0)


class Stepped(QSpinBox):
    """A whole number."""

    def __init__(self) -> None:
        super().__init__()
        self.lineEdit().setTextMargins(_ROOM)


class SteppedDecimal(QDoubleSpinBox):
    """A number with decimals."""

    def __init__(self) -> None:
        super().__init__()
        self.lineEdit().setTextMargins(_ROOM)
