"""The questions that the studio asks a person; tests answer them themselves."""

from __future__ import annotations

from typing import Literal

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QFileDialog, QInputDialog, QLineEdit, QMessageBox, QWidget

from situ_studio import conflict
from situ_studio.details import Details
from situ_studio.differing import Differing

Answer = Literal["save", "discard", "cancel"]
Where = Literal["here", "new", "cancel"]


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

    def conflict(self, found: Differing) -> conflict.Answer:
        """Which one stays of a file that another program changed."""
        dialog = conflict.ConflictDialog(found, self._window)
        try:
            dialog.exec()
            return dialog.answer
        finally:
            dialog.deleteLater()

    def where(self, name: str) -> Where:
        """In which window a second project is opened."""
        box = QMessageBox(self._window)
        box.setIcon(QMessageBox.Icon.NoIcon)
        box.setText(self.tr("{0} is open in this window.").format(name))
        box.setInformativeText(self.tr("Where shall the other project be opened?"))
        new = box.addButton(self.tr("New window"), QMessageBox.ButtonRole.AcceptRole)
        here = box.addButton(self.tr("This window"), QMessageBox.ButtonRole.AcceptRole)
        box.addButton(self.tr("Cancel"), QMessageBox.ButtonRole.RejectRole)
        box.setDefaultButton(new)
        box.exec()
        if box.clickedButton() is new:
            return "new"
        return "here" if box.clickedButton() is here else "cancel"

    def details(self, title: str, words: str, details: str, unfolded: bool = False) -> None:
        """A sentence, with details that can be copied into a report."""
        dialog = Details(title, words, details, self._window, unfolded)
        try:
            dialog.exec()
        finally:
            dialog.deleteLater()

    def tell(self, text: str) -> None:
        """Something went wrong, in one line."""
        box = QMessageBox(self._window)
        box.setIcon(QMessageBox.Icon.NoIcon)
        box.setText(text)
        box.exec()
