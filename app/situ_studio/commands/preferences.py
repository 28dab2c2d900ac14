"""Preferences (Ctrl+,): language, letters, colours, and the keys of the commands."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QDialog,
    QFormLayout,
    QHBoxLayout,
    QKeySequenceEdit,
    QLabel,
    QPushButton,
    QTreeWidgetItem,
    QVBoxLayout,
)

from situ_studio.actions import COMMANDS
from situ_studio.commands.keys import headed, written
from situ_studio.commands.menus import told
from situ_studio.commands.shortcuts import KeyList
from situ_studio.looks import letters
from situ_studio.looks.letters import px
from situ_studio.panels.fields import Choice
from situ_studio.wording.language import LANGUAGES, SYSTEM

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow
    from situ_studio.window.windows import Windows

ID = int(Qt.ItemDataRole.UserRole) + 1


class Preferences(QDialog):
    """What is chosen holds at once, in all windows, and at the next start. Esc closes it."""

    def __init__(self, windows: Windows, window: MainWindow) -> None:
        super().__init__(window)
        self._windows = windows
        self._window = window
        self._keys = window.keys
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowModality(Qt.WindowModality.ApplicationModal)
        self.setWindowTitle(self.tr("Preferences"))
        self.resize(px(600), 680)
        column = QVBoxLayout(self)
        column.setContentsMargins(24, 20, 24, 20)
        column.setSpacing(12)
        form = QFormLayout()
        column.addLayout(form)
        self.language = Choice(window.theme)
        for code, name in ((SYSTEM, self.tr("Like the system")), *LANGUAGES.items()):
            self.language.addItem(name, code)
        self.language.setCurrentIndex(self.language.findData(windows.language))
        self.language.activated.connect(self._on_language)
        form.addRow(self.tr("Language"), self.language)
        self.letters = Choice(window.theme)
        as_system = self.tr("Like the system ({0} %)").format(letters.of_system())
        self.letters.addItem(as_system, letters.SYSTEM)
        for size in letters.SIZES:
            self.letters.addItem(f"{size} %", str(size))
        self.letters.setCurrentIndex(self.letters.findData(windows.letters))
        self.letters.activated.connect(self._on_letters)
        form.addRow(self.tr("Letters"), self.letters)
        self.colours = Choice(window.theme)
        for choice, name in (
            ("system", self.tr("Like the system")),
            ("light", self.tr("Light")),
            ("dark", self.tr("Dark")),
        ):
            self.colours.addItem(name, choice)
        self.colours.setCurrentIndex(self.colours.findData(window.theme_choice))
        self.colours.activated.connect(self._on_colours)
        form.addRow(self.tr("Colours"), self.colours)
        heading = QLabel(self.tr("Keyboard shortcuts"))
        heading.setProperty("role", "heading")
        column.addWidget(heading)
        self._build_keys(column)
        self._show_keys()
        self._on_row()

    def _build_keys(self, column: QVBoxLayout) -> None:
        self.list = KeyList()
        self._rows: dict[str, QTreeWidgetItem] = {}
        for one in COMMANDS:
            self._rows[one.id] = self.list.add(headed(one), told(one), "")
            self._rows[one.id].setData(0, ID, one.id)
        self.list.tree.currentItemChanged.connect(self._on_row)
        column.addWidget(self.list)
        line = QHBoxLayout()
        column.addLayout(line)
        self.key = QKeySequenceEdit()
        self.key.setMaximumSequenceLength(1)
        self.key.setAccessibleName(self.tr("Press the new key"))
        self.key.editingFinished.connect(self._on_key)
        line.addWidget(self.key, 1)
        self.reset = QPushButton(self.tr("Reset"))
        self.reset.setToolTip(self.tr("The command has its usual key again."))
        self.reset.clicked.connect(self._on_reset)
        self.reset_all = QPushButton(self.tr("Reset all"))
        self.reset_all.setToolTip(self.tr("Every command has its usual key again."))
        self.reset_all.clicked.connect(self._on_reset_all)
        for button in (self.reset, self.reset_all):
            # Enter in the field above is no wish to reset anything.
            button.setAutoDefault(False)
            line.addWidget(button)
        self.told = QLabel()
        self.told.setWordWrap(True)
        column.addWidget(self.told)

    # -- keys --------------------------------------------------------------------------

    def _show_keys(self) -> None:
        for id, keys in self._keys.every().items():
            self._rows[id].setText(1, written(keys))

    @property
    def _chosen(self) -> str:
        """The id of the command whose row is chosen; "" on a heading."""
        item = self.list.tree.currentItem()
        return str(item.data(0, ID) or "") if item is not None else ""

    def _on_row(self) -> None:
        id = self._chosen
        keys = self._keys.every()[id] if id else []
        self.key.setKeySequence(keys[0] if keys else QKeySequence())
        self.key.setEnabled(bool(id))
        self.reset.setEnabled(bool(id) and self._keys.is_changed(id))
        self.told.setText(
            self.tr("Click into the field and press the new key.")
            if id
            else self.tr("Choose a command to give it another key.")
        )

    def _on_key(self) -> None:
        id, key = self._chosen, self.key.keySequence()
        if id and not key.isEmpty() and [key] != self._keys.every()[id][:1]:
            self._settle(self._keys.give(id, key))

    def _on_reset(self) -> None:
        self._settle(self._keys.reset(self._chosen))

    def _on_reset_all(self) -> None:
        self._keys.reset_all()
        self._settle("")

    def _settle(self, refused: str) -> None:
        self._windows.settle_keys()
        self._show_keys()
        self._on_row()
        if refused:
            self.told.setText(refused)

    # -- language, letters and colours ----------------------------------------------------------

    def _on_colours(self) -> None:
        for window in self._windows.windows:
            window.choose_theme(self.colours.currentData())

    def _on_letters(self) -> None:
        """The windows are made anew, this one not."""
        chosen = self.letters.currentData()
        self.close()
        self._windows.choose_letters(chosen)

    def _on_language(self) -> None:
        """The windows are made anew in another language, this one not."""
        chosen = self.language.currentData()
        self.close()
        self._windows.choose_language(chosen)
