"""The questions that the studio asks a person; tests answer them themselves."""

from __future__ import annotations

from typing import Literal

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QFileDialog, QInputDialog, QLineEdit, QMessageBox, QWidget

Answer = Literal["save", "discard", "cancel"]
Conflict = Literal["mine", "theirs", "cancel"]


class Dialogs(QObject):
    """Modal windows over ``window``."""

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._window = window

    def project(self, start: str) -> str | None:
        """A project's folder to open; None: nothing was chosen."""
        chosen = QFileDialog.getExistingDirectory(
            self._window, self.tr("Open a project: the folder with situ.toml"), start
        )
        return chosen or None

    def new_folder(self, start: str, title: str) -> str | None:
        """A folder in which something new will be put; None: nothing was chosen."""
        chosen = QFileDialog.getExistingDirectory(self._window, title, start)
        return chosen or None

    def name(self, title: str, label: str, usual: str) -> str | None:
        """One line of text; None: nothing was given."""
        text, well = QInputDialog.getText(
            self._window, title, label, QLineEdit.EchoMode.Normal, usual
        )
        return text.strip() or None if well else None

    def part(self, known: list[str]) -> str | None:
        """Which part a state shall run: one of these, or the name of a new one; None: neither."""
        text, well = QInputDialog.getItem(
            self._window,
            self.tr("Add a part"),
            self.tr("Choose a part, or type the name of a new one"),
            known,
            editable=True,
        )
        return text.strip() or None if well else None

    def unsaved(self, files: list[str]) -> Answer:
        """What to do with documents that have changed."""
        box = QMessageBox(self._window)
        box.setIcon(QMessageBox.Icon.NoIcon)
        box.setText(self.tr("Save the changes to {0}?").format(", ".join(files)))
        save = box.addButton(self.tr("Save"), QMessageBox.ButtonRole.AcceptRole)
        discard = box.addButton(self.tr("Do not save"), QMessageBox.ButtonRole.DestructiveRole)
        box.addButton(self.tr("Cancel"), QMessageBox.ButtonRole.RejectRole)
        box.setDefaultButton(save)
        box.exec()
        if box.clickedButton() is save:
            return "save"
        return "discard" if box.clickedButton() is discard else "cancel"

    def conflict(self, file: str) -> Conflict:
        """Another program changed a file that is to be saved."""
        box = QMessageBox(self._window)
        box.setIcon(QMessageBox.Icon.NoIcon)
        box.setText(self.tr("Another program changed {0} since it was read here.").format(file))
        box.setInformativeText(self.tr("Which one shall stay?"))
        mine = box.addButton(self.tr("Mine"), QMessageBox.ButtonRole.DestructiveRole)
        theirs = box.addButton(self.tr("The one on disk"), QMessageBox.ButtonRole.AcceptRole)
        box.addButton(self.tr("Cancel"), QMessageBox.ButtonRole.RejectRole)
        box.exec()
        if box.clickedButton() is mine:
            return "mine"
        return "theirs" if box.clickedButton() is theirs else "cancel"

    def tell(self, text: str) -> None:
        """Something went wrong, in one line."""
        box = QMessageBox(self._window)
        box.setIcon(QMessageBox.Icon.NoIcon)
        box.setText(text)
        box.exec()
