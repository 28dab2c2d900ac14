"""The row below a dialog that asks: what is wanted, filled and pressed by Enter, and Cancel."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtWidgets import QBoxLayout, QDialog, QDialogButtonBox, QPushButton


def add_buttons(
    dialog: QDialog, column: QBoxLayout, text: str, agree: Callable[[], object]
) -> QPushButton:
    """Puts them at the end of the dialog's column; gives the one that calls ``agree``."""
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
    wanted = buttons.addButton(text, QDialogButtonBox.ButtonRole.AcceptRole)
    wanted.setProperty("role", "filled")
    buttons.accepted.connect(agree)
    buttons.rejected.connect(dialog.reject)
    column.addWidget(buttons)
    # Last: a button that lies in no dialog yet would not be the dialog's.
    wanted.setDefault(True)
    return wanted
