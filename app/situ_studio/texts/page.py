"""The page of all texts: what is looked for and what is left to do above, the table below."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from PySide6.QtCore import QModelIndex, QPoint, Qt, Signal
from PySide6.QtGui import QKeySequence, QResizeEvent
from PySide6.QtWidgets import (
    QBoxLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QMenu,
    QVBoxLayout,
    QWidget,
)

from situ.document.beside import Toml
from situ.document.catalogue import Catalogue
from situ.document.project import Project
from situ_studio.edits.edit import Written
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import Flag
from situ_studio.panels.tabs import Segments
from situ_studio.texts.model import CELL, ROW, WRITTEN, Filter, language_name
from situ_studio.texts.sheet import Cell, Refused, Sheet, Typed, changed, confirmed
from situ_studio.texts.table import TextsTable
from situ_studio.widgets.icon_widgets import IconButton
from situ_studio.widgets.layouts import rule


class TextsPage(QWidget):
    """Shows the texts of a project, and tells its files as they are after each change."""

    edited = Signal(object, str)
    """By their paths the files that changed, and the name of the step."""
    go_asked = Signal(str, tuple)
    refused = Signal(str)
    import_asked = Signal()
    export_asked = Signal(str)
    """A language."""
    language_asked = Signal()
    listen_asked = Signal(str, str)
    """A text, as it is said, and its language."""

    def __init__(
        self, theme: Theme, tags: Callable[[], tuple[str, ...]], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setProperty("role", "panel")
        self.sheet: Sheet | None = None
        self.has_changed = False
        """Whether the texts shown last are others, or said otherwise, than those before."""
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        self._head = QBoxLayout(QBoxLayout.Direction.LeftToRight)
        self._head.setContentsMargins(12, 6, 8, 6)
        self._head.setSpacing(8)
        self._finding, self._tools = self._make_finding(theme), self._make_tools(theme)
        self._head.addLayout(self._finding, 1)
        self._head.addLayout(self._tools)
        column.addLayout(self._head)
        column.addWidget(rule())
        self.table = TextsTable(theme, tags)
        self.table.go_asked.connect(self.go_asked)
        self.table.refused.connect(self.refused)
        self.table.texts.typed.connect(self._on_typed)
        self.table.selectionModel().currentChanged.connect(self._settle_buttons)
        self.table.texts.modelReset.connect(self._settle_buttons)
        self.table.texts.dataChanged.connect(lambda *_: self._settle_buttons())
        self.table.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.table.customContextMenuRequested.connect(self._on_menu)
        column.addWidget(self.table, 1)
        self.nothing = QLabel(self.tr("No text fits what you look for."))
        self.nothing.setProperty("role", "dim")
        self.nothing.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.nothing.hide()
        column.addWidget(self.nothing, 1)
        column.addWidget(rule())
        self.counts = QLabel()
        self.counts.setProperty("role", "hint")
        self.counts.setContentsMargins(12, 5, 12, 5)
        column.addWidget(self.counts)
        self._settle_buttons()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        # Where there is no room for both beside each other they are in two lines.
        wide = sum(part.minimumSize().width() for part in (self._finding, self._tools))
        fits = wide + 28 <= self.width()
        way = QBoxLayout.Direction
        self._head.setDirection(way.LeftToRight if fits else way.TopToBottom)

    def _make_finding(self, theme: Theme) -> QHBoxLayout:
        line = QHBoxLayout()
        line.setSpacing(8)
        self.search = QLineEdit()
        self.search.setPlaceholderText(self.tr("Find a text"))
        self.search.setAccessibleName(self.tr("Find a text"))
        self.search.setToolTip(self.tr("Only texts with these letters, in any language."))
        self.search.setClearButtonEnabled(True)
        self.search.setMinimumWidth(px(72))
        self.search.setMaximumWidth(px(240))
        self.search.textChanged.connect(self._on_filter)
        line.addWidget(self.search, 1)
        self.kinds = Segments(
            theme,
            (
                ("", "", self.tr("All")),
                ("shown", "", self.tr("Shown")),
                ("spoken", "", self.tr("Spoken")),
                ("heard", "", self.tr("Heard")),
                ("setting", "", self.tr("Settings")),
            ),
            self.tr("Which texts"),
        )
        self._kind = ""
        self.kinds.show_choice("")
        self.kinds.chosen.connect(self._on_kind)
        line.addWidget(self.kinds)
        self.open = Flag(theme, self.tr("To do"))
        self.open.setToolTip(
            self.tr("Only what is missing, has to be looked at, or leaves out a {tag}.")
        )
        self.open.toggled.connect(self._on_filter)
        line.addWidget(self.open)
        line.addStretch(1)
        return line

    def _make_tools(self, theme: Theme) -> QHBoxLayout:
        line = QHBoxLayout()
        line.setSpacing(8)
        line.addStretch(1)
        self.listen = self._button(theme, "sound", self.tr("Listen"), self._on_listen)
        self.confirm = self._button(theme, "check", self.tr("It is right"), self._on_confirm)
        self.take_in = self._button(
            theme, "import", self.tr("Import translations…"), self.import_asked.emit
        )
        self.give_out = self._button(
            theme, "export", self.tr("Export for a translator…"), self._on_export
        )
        self.more = self._button(
            theme, "plus", self.tr("Add a language…"), self.language_asked.emit
        )
        for button in (self.listen, self.confirm, self.take_in, self.give_out, self.more):
            line.addWidget(button)
        return line

    def _button(
        self, theme: Theme, icon: str, words: str, pressed: Callable[[], Any]
    ) -> IconButton:
        made = IconButton(theme, icon, words, "text2", 18)
        made.clicked.connect(lambda: pressed())
        return made

    def set_theme(self, theme: Theme) -> None:
        self.table.set_theme(theme)

    # -- showing -----------------------------------------------------------------

    def show_project(
        self, project: Project, catalogues: Mapping[str, Catalogue], toml: Toml | None
    ) -> None:
        """Shows the texts as they are now; toml: ``situ.toml``."""
        old, self.sheet = self.sheet, Sheet(project, catalogues, toml)
        said = (self.sheet.rows, self.sheet.catalogues)
        self.has_changed = old is None or (old.rows, old.catalogues) != said
        current = self.table.currentIndex()
        row = current.data(ROW) if current.isValid() else None
        language = self.table.texts.language(current.column()) if current.isValid() else None
        self.table.texts.show_sheet(self.sheet)
        if row is not None and not self.table.currentIndex().isValid():
            self.table.select(row.file, row.place, language)
        self._settle_counts()
        self._settle_buttons()

    def begin(self) -> None:
        """Gives the table the focus, at the cell where somebody was last."""
        table = self.table
        if not table.currentIndex().isValid():
            columns = table.texts.columnCount()
            table.setCurrentIndex(table.texts.index(0, min(WRITTEN + 1, columns - 1)))
        table.setFocus()

    def bring(self, file: str, place: tuple[str, ...], language: str | None) -> None:
        """Selects the cell of a text, if it is shown."""
        self.table.select(file, place, language)

    def set_listening(self, can: bool, going: bool) -> None:
        """can: there is a voice on this machine; going: it speaks now."""
        self._voice = can
        self.listen.show_icon(
            "pause" if going else "sound", self.tr("Stop") if going else self.tr("Listen")
        )
        self._settle_buttons()

    _voice = False

    def _on_kind(self, kind: str) -> None:
        self._kind = kind
        self._on_filter()

    def _on_filter(self) -> None:
        kind: Any = self._kind
        current = self.table.currentIndex()
        row = current.data(ROW) if current.isValid() else None
        language = self.table.texts.language(current.column()) if current.isValid() else None
        self.table.texts.show_filter(Filter(kind, self.open.isChecked(), self.search.text()))
        if row is not None:
            self.table.select(row.file, row.place, language)
        self._settle_counts()

    def _settle_counts(self) -> None:
        if self.sheet is None:
            return
        texts = self.table.texts
        none = not texts.shown
        self.nothing.setVisible(none)
        self.table.setVisible(not none)
        every = self.tr("{0} texts").format(len(self.sheet.rows))
        if len(texts.shown) != len(self.sheet.rows):
            every = self.tr("{0} of {1} texts").format(len(texts.shown), len(self.sheet.rows))
        told = [every]
        told += [f"{language_name(one)}: {texts.counts_words(one)}" for one in self.sheet.languages]
        if not self.sheet.languages:
            told.append(self.tr("one language only: add another to translate them"))
        self.counts.setText("   ·   ".join(told))

    def _settle_buttons(self, *_: QModelIndex) -> None:
        cell = self._cell()
        languages = self.sheet.languages if self.sheet is not None else ()
        self.confirm.setEnabled(cell is not None and cell.standing == "unsure")
        self.listen.setEnabled(self._voice and cell is not None and bool(cell.text))
        self.listen.setVisible(self._voice)
        self.take_in.setEnabled(bool(languages))
        self.give_out.setEnabled(bool(languages))

    def _cell(self) -> Cell | None:
        index = self.table.currentIndex()
        return index.data(CELL) if index.isValid() else None

    @property
    def language(self) -> str | None:
        """The language of the current column, else the only one into which is translated."""
        index = self.table.currentIndex()
        found = self.table.texts.language(index.column()) if index.isValid() else None
        languages = self.table.texts.languages
        return found if found is not None else languages[0] if len(languages) == 1 else None

    # -- changes -----------------------------------------------------------------

    def _on_typed(self, typed: list[Typed]) -> None:
        if self.sheet is None:
            return
        try:
            files = changed(self.sheet, typed)
        except Refused as refused:
            self.refused.emit(str(refused))
            return
        if files:
            self._tell(files, self._step(typed))

    def _tell(self, files: dict[str, Written], words: str) -> None:
        self.edited.emit(files, words)

    def _step(self, typed: list[Typed]) -> str:
        if len(typed) > 1:
            return self.tr("Change {0} texts").format(len(typed))
        row, language = typed[0].row, typed[0].language
        text = row.text if len(row.text) <= 32 else f"{row.text[:31]}…"
        if language is None:
            return self.tr("Change the text “{0}”").format(text)
        return self.tr("Translate “{0}” into {1}").format(text, language_name(language))

    def _on_confirm(self) -> None:
        index = self.table.currentIndex()
        language = self.table.texts.language(index.column()) if index.isValid() else None
        if self.sheet is None or language is None:
            return
        row = index.data(ROW)
        files = confirmed(self.sheet, row, language)
        if files:
            self._tell(files, self._step([Typed(row, language, "")]))

    # -- the rest ----------------------------------------------------------------

    def _on_listen(self) -> None:
        index, cell = self.table.currentIndex(), self._cell()
        if self.sheet is None or cell is None:
            return
        row = index.data(ROW)
        language = self.table.texts.language(index.column()) or row.lang or self.sheet.written_in
        self.listen_asked.emit(cell.text, language or "en")

    def _on_export(self) -> None:
        languages = self.table.texts.languages
        if len(languages) == 1:
            self.export_asked.emit(languages[0])
            return
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        for language in languages:
            chosen = menu.addAction(language_name(language))
            chosen.triggered.connect(lambda _=False, one=language: self.export_asked.emit(one))
        menu.popup(self.give_out.mapToGlobal(self.give_out.rect().bottomLeft()))

    def _on_menu(self, at: QPoint) -> None:
        index = self.table.indexAt(at)
        if not index.isValid():
            return
        table, editable = self.table, index.column() >= WRITTEN
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        keys = QKeySequence.StandardKey
        for words, done, key, can in (
            (self.tr("Show where it stands"), table.go, "Ctrl+Return", True),
            (self.tr("It is right"), self._on_confirm, "", self.confirm.isEnabled()),
            (self.tr("Listen"), self._on_listen, "", self.listen.isEnabled()),
            (self.tr("Cut"), table.cut, keys.Cut, editable),
            (self.tr("Copy"), table.copy, keys.Copy, True),
            (self.tr("Paste"), table.paste, keys.Paste, editable),
        ):
            action = menu.addAction(words)
            action.setShortcut(QKeySequence(key))
            action.setEnabled(can)
            action.triggered.connect(lambda _=False, do=done: do())
        menu.popup(table.viewport().mapToGlobal(at))
