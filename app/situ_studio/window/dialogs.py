"""The questions that the studio asks a person; tests answer them themselves."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from PySide6.QtCore import QObject, QRectF
from PySide6.QtPrintSupport import QPrintDialog, QPrinter, QPrintPreviewDialog
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QInputDialog,
    QLineEdit,
    QMessageBox,
    QPushButton,
)

from situ_studio.edits.vocabulary import Vocabulary
from situ_studio.export import picture
from situ_studio.export.export_dialog import Export, ExportDialog, What
from situ_studio.export.print_preview import reach_by_keys
from situ_studio.files import conflict
from situ_studio.live.connecting_dialog import Chosen, ConnectDialog
from situ_studio.live.nearby import NearbyRobots
from situ_studio.live.raising_dialog import Offer, RaisingDialog
from situ_studio.live.setting_dialog import Setting, SettingDialog
from situ_studio.looks import icons
from situ_studio.looks.letters import px
from situ_studio.project.differing import Differing
from situ_studio.widgets.details import Details

if TYPE_CHECKING:
    from situ_studio.window.frame import Frame

WIDTH = 352
"""Px of a field that is asked for."""
Answer = Literal["save", "discard", "cancel"]
Where = Literal["here", "new", "cancel"]


class Dialogs(QObject):
    """Modal windows over ``window``."""

    def __init__(self, window: Frame) -> None:
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
        dialog = QInputDialog(self._window)
        dialog.setWindowTitle(title)
        dialog.setLabelText(label)
        dialog.setTextValue(usual)
        return self._given(dialog)

    def robot(self, usual: str) -> Chosen | None:
        """Which robot to connect to; None: none."""
        dialog = ConnectDialog(usual, NearbyRobots(), self._window.theme, self._window)
        make_room(dialog)
        try:
            return dialog.chosen if dialog.exec() else None
        finally:
            dialog.deleteLater()

    def raising(self, offered: list[Offer], usual: str, known: tuple[str, ...]) -> str | None:
        """Which event to raise at the robot; None: none."""
        dialog = RaisingDialog(offered, usual, known, self._window)
        make_room(dialog)
        try:
            return dialog.event_name if dialog.exec() else None
        finally:
            dialog.deleteLater()

    def setting(self, vocabulary: Vocabulary, now: Mapping[str, Any]) -> Setting | None:
        """Which value to set on the robot's blackboard; None: none."""
        dialog = SettingDialog(vocabulary, now, self._window)
        make_room(dialog)
        try:
            return dialog.setting if dialog.exec() else None
        finally:
            dialog.deleteLater()

    def part(self, known: list[str]) -> str | None:
        """Which part a state shall run: one of these, or the name of a new one; None: neither."""
        dialog = QInputDialog(self._window)
        dialog.setWindowTitle(self.tr("Add a part"))
        dialog.setLabelText(self.tr("Choose a part, or type the name of a new one"))
        dialog.setComboBoxItems(known)
        dialog.setComboBoxEditable(True)
        return self._given(dialog)

    def _given(self, dialog: QInputDialog) -> str | None:
        # The layout is made at the first question for it.
        dialog.sizeHint()
        make_room(dialog)
        buttons = dialog.findChild(QDialogButtonBox)
        if buttons is not None:
            _fill(buttons.button(QDialogButtonBox.StandardButton.Ok))
        for field in (*dialog.findChildren(QLineEdit), *dialog.findChildren(QComboBox)):
            field.setMinimumWidth(px(WIDTH))
        try:
            well = dialog.exec()
            return dialog.textValue().strip() or None if well else None
        finally:
            dialog.deleteLater()

    def unsaved(self, files: list[str]) -> Answer:
        """What to do with documents that have changed."""
        box = QMessageBox(self._window)
        box.setText(self.tr("Save the changes to {0}?").format(", ".join(files)))
        save = box.addButton(self.tr("Save"), QMessageBox.ButtonRole.AcceptRole)
        discard = box.addButton(self.tr("Do not save"), QMessageBox.ButtonRole.DestructiveRole)
        box.addButton(self.tr("Cancel"), QMessageBox.ButtonRole.RejectRole)
        box.setDefaultButton(save)
        _fill(save)
        self._lay_out(box, "save", "text2")
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

    def picture_file(self, usual: str) -> str | None:
        """The file of a picture, its ending the one of its format; None: nothing was chosen."""
        dialog = QFileDialog(self._window, self.tr("Export picture"))
        dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
        filters = {f"{kind.upper()} (*.{kind})": kind for kind in picture.FORMATS}
        dialog.setNameFilters(list(filters))
        dialog.setDefaultSuffix(picture.FORMATS[0])
        dialog.filterSelected.connect(lambda chosen: dialog.setDefaultSuffix(filters[chosen]))
        dialog.selectFile(usual)
        try:
            return dialog.selectedFiles()[0] if dialog.exec() else None
        finally:
            dialog.deleteLater()

    def recording(self) -> Path | None:
        """The file of a recorded run; None: nothing was chosen."""
        chosen, _ = QFileDialog.getOpenFileName(
            self._window,
            self.tr("Open recording"),
            "",
            self.tr("Recordings ({0})").format("*.mcap"),
        )
        return Path(chosen) if chosen else None

    def recording_to(self, usual: str) -> Path | None:
        """The file that a run goes to; None: nothing was chosen."""
        chosen, _ = QFileDialog.getSaveFileName(
            self._window,
            self.tr("Save as a recording"),
            usual,
            self.tr("Recordings ({0})").format("*.mcap"),
        )
        return Path(chosen) if chosen else None

    def field_recordings(self) -> list[Path]:
        """The files of recorded runs; none: nothing was chosen."""
        chosen, _ = QFileDialog.getOpenFileNames(
            self._window,
            self.tr("Count recordings"),
            "",
            self.tr("Recordings ({0})").format("*.mcap"),
        )
        return [Path(one) for one in chosen]

    def field_folder(self) -> Path | None:
        """A folder with recorded runs; None: nothing was chosen."""
        title = self.tr("Count the recordings of a folder")
        chosen = QFileDialog.getExistingDirectory(self._window, title)
        return Path(chosen) if chosen else None

    def usage_file(self, usual: str) -> Path | None:
        """The file of a table; None: nothing was chosen."""
        chosen, _ = QFileDialog.getSaveFileName(
            self._window,
            self.tr("Export the table"),
            usual,
            self.tr("Tables ({0})").format("*.csv"),
        )
        return Path(chosen) if chosen else None

    def media_file(self, endings: tuple[str, ...]) -> str | None:
        """A file for a screen or a sound; None: nothing was chosen."""
        pattern = " ".join(f"*{ending}" for ending in endings)
        chosen, _ = QFileDialog.getOpenFileName(
            self._window,
            self.tr("Choose a file"),
            "",
            self.tr("Files that the robot takes ({0})").format(pattern),
        )
        return chosen or None

    def translations_from(self) -> str | None:
        """The file of a translator to take in; None: nothing was chosen."""
        chosen, _ = QFileDialog.getOpenFileName(
            self._window, self.tr("Import translations"), "", "gettext (*.po *.pot)"
        )
        return chosen or None

    def translations_to(self, usual: str) -> str | None:
        """The file that a translator gets; None: nothing was chosen."""
        chosen, _ = QFileDialog.getSaveFileName(
            self._window, self.tr("Export for a translator"), usual, "gettext (*.po)"
        )
        return chosen or None

    def export(self, name: str, areas: Mapping[What, QRectF]) -> Export | None:
        """What of a drawing goes into the file of that name; None: it shall not be written."""
        dialog = ExportDialog(name, areas, self._window)
        make_room(dialog)
        try:
            return dialog.chosen if dialog.exec() else None
        finally:
            dialog.deleteLater()

    def preview(self, printer: QPrinter, paint: Callable[[QPrinter], object]) -> bool:
        """Shows what ``paint`` puts on the pages; whether a person printed them from there."""
        dialog = QPrintPreviewDialog(printer, self._window)
        dialog.paintRequested.connect(paint)
        reach_by_keys(dialog)
        dialog.resize(px(960), px(720))
        try:
            return dialog.exec() == QDialog.DialogCode.Accepted
        finally:
            dialog.deleteLater()

    def printer(self, printer: QPrinter) -> bool:
        """Asks on which printer, and sets it up so; whether a person wants to print at all."""
        dialog = QPrintDialog(printer, self._window)
        # All pages belong together: there is no telling beforehand which one shows what.
        dialog.setOption(QPrintDialog.PrintDialogOption.PrintPageRange, False)
        try:
            return dialog.exec() == QDialog.DialogCode.Accepted
        finally:
            dialog.deleteLater()

    def where(self, name: str) -> Where:
        """In which window a second project is opened."""
        box = QMessageBox(self._window)
        box.setText(self.tr("{0} is open in this window.").format(name))
        box.setInformativeText(self.tr("Where shall the other project be opened?"))
        new = box.addButton(self.tr("New window"), QMessageBox.ButtonRole.AcceptRole)
        here = box.addButton(self.tr("This window"), QMessageBox.ButtonRole.AcceptRole)
        box.addButton(self.tr("Cancel"), QMessageBox.ButtonRole.RejectRole)
        box.setDefaultButton(new)
        _fill(new)
        self._lay_out(box, "new_window", "text2")
        box.exec()
        if box.clickedButton() is new:
            return "new"
        return "here" if box.clickedButton() is here else "cancel"

    def _lay_out(self, box: QMessageBox, name: str, token: str) -> None:
        """The family's icon before the words, and room round them."""
        box.setIconPixmap(icons.pixmap(name, self._window.theme.color(token), 24))
        make_room(box)

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
        box.setText(text)
        self._lay_out(box, "info", "text2")
        box.exec()


def make_room(dialog: QDialog) -> None:
    """Space round what a dialog says: Qt's own measures are narrow."""
    layout = dialog.layout()
    if layout is not None:
        layout.setContentsMargins(24, 20, 24, 20)
        layout.setSpacing(12)


def _fill(button: QPushButton) -> None:
    """The one filled button: what is usually wanted."""
    button.setProperty("role", "filled")
    button.style().unpolish(button)
    button.style().polish(button)
