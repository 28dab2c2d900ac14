"""The table of texts for Qt: a row a text, a column a language, those that a filter lets by."""

from __future__ import annotations

from typing import Any, ClassVar, Literal

from msgspec import Struct
from PySide6.QtCore import (
    QAbstractTableModel,
    QLocale,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    Qt,
    Signal,
)

from situ.document import rbd
from situ.document.projectfile import CODE
from situ.document.texts_table import Kind, TextRow
from situ_studio import kinds
from situ_studio.assistive.heard_cells import headed
from situ_studio.edits import places, words
from situ_studio.panels.project_tree import stem
from situ_studio.texts import settings
from situ_studio.texts.sheet import Cell, Sheet, Typed
from situ_studio.wording.language import translated

AnyIndex = QModelIndex | QPersistentModelIndex
STATE, WHAT, WRITTEN = 0, 1, 2
"""The columns before those of the other languages."""
CELL = int(Qt.ItemDataRole.UserRole) + 1
"""The ``Cell`` of an index."""
ROW = CELL + 1
"""The ``TextRow`` of an index."""
ICONS: dict[Kind, str] = {
    "shown": "screen",
    "spoken": "speech",
    "heard": "heard",
    "setting": "preferences",
}


class Filter(Struct, frozen=True):
    """kind: only texts of it. open: only those with something left to do. search: in any column."""

    kind: Kind | Literal[""] = ""
    open: bool = False
    search: str = ""


def language_name(code: str) -> str:
    """A language as its speakers call it: ``日本語``; its code where nobody knows it."""
    locale = QLocale(code.replace("-", "_"))
    if locale.language() == QLocale.Language.C:
        return code
    name = _WITHOUT_COUNTRY.get(code) or locale.nativeLanguageName() or code
    if code.startswith(("pt-", "zh-")):
        name = f"{name} ({locale.nativeTerritoryName()})"
    return name[:1].upper() + name[1:]


def language_code(words: str) -> str | None:
    """The code of a language that somebody names by it, in English or as its speakers do.

    ``ja``, ``Japanese`` and ``日本語`` are ``ja``; None where it is no language.
    """
    words = " ".join(words.split())
    named = words.casefold()
    for one in QLocale.Language:
        code = QLocale.languageToCode(one)
        if code and named in (QLocale.languageToString(one).casefold(), _native(code)):
            return code
    return words if CODE.fullmatch(words) else None


def _native(code: str) -> str:
    return language_name(code).casefold()


_WITHOUT_COUNTRY = {"en": "English", "es": "español"}
"""Languages that Qt calls after one of their countries."""


class TextsModel(QAbstractTableModel):
    """Shows a ``Sheet``; what is typed is told, and shown once the sheet has it."""

    typed = Signal(object)
    """A list of ``Typed``."""

    _NO: ClassVar[QModelIndex] = QModelIndex()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.sheet: Sheet | None = None
        self.filter = Filter()
        self.shown: list[TextRow] = []
        self._where: dict[tuple[str, tuple[str, ...]], tuple[str, str]] = {}

    @property
    def languages(self) -> tuple[str, ...]:
        return self.sheet.languages if self.sheet is not None else ()

    def language(self, column: int) -> str | None:
        """The language of a column; None of that of the texts as they are written."""
        return self.languages[column - WRITTEN - 1] if column > WRITTEN else None

    def show_sheet(self, sheet: Sheet) -> None:
        """Another value of the table; rows that stand where they stood keep their places, and are
        shown until another filter is asked for, though what was to do is done.
        """
        old, self.sheet = self.sheet, sheet
        self._where = {}
        before_shown = {(row.file, row.place) for row in self.shown}
        passing = {(row.file, row.place) for row in self._filtered()}
        wanted = passing | before_shown
        shown = [row for row in sheet.rows if (row.file, row.place) in wanted]
        if old is not None and old.languages == sheet.languages and self._same_places(shown):
            self._tell(old, sheet, shown)
        else:
            self._reset(shown)

    def show_filter(self, wanted: Filter) -> None:
        self.filter = wanted
        self._reset(self._filtered())

    def row_at(self, file: str, place: tuple[str, ...]) -> int:
        """The row of a text in the view as it is filtered; -1: it is not shown."""
        at = (file, place)
        return next((i for i, r in enumerate(self.shown) if (r.file, r.place) == at), -1)

    def place_words(self, row: TextRow) -> tuple[str, str]:
        """A text's state and what it is there, in words."""
        found = self._where.get((row.file, row.place))
        if found is None:
            found = self._where[row.file, row.place] = self._words(row)
        return found

    # -- filtering ---------------------------------------------------------------

    def _filtered(self) -> list[TextRow]:
        sheet = self.sheet
        if sheet is None:
            return []
        found, search = self.filter, self.filter.search.casefold().strip()
        return [
            row
            for row in sheet.rows
            if (not found.kind or row.kind == found.kind)
            and (not found.open or sheet.is_open(row))
            and (not search or self._has(row, search))
        ]

    def _has(self, row: TextRow, search: str) -> bool:
        assert self.sheet is not None
        said = (self.sheet.cell(row, language).text for language in self.languages)
        return any(search in one.casefold() for one in (row.text, *self.place_words(row), *said))

    def _same_places(self, rows: list[TextRow]) -> bool:
        return [(r.file, r.place) for r in rows] == [(r.file, r.place) for r in self.shown]

    def _reset(self, rows: list[TextRow]) -> None:
        self.beginResetModel()
        self.shown = rows
        self.endResetModel()

    def _tell(self, old: Sheet, new: Sheet, rows: list[TextRow]) -> None:
        """Takes rows that stand where those before stood; only what differs is told."""
        before, self.shown = self.shown, rows
        last = self.columnCount() - 1
        for at, (was, row) in enumerate(zip(before, rows, strict=True)):
            # Entries that nobody changed are the very same.
            if was != row or any(
                old.entry(was, one) is not new.entry(row, one) for one in new.languages
            ):
                self.dataChanged.emit(self.index(at, 0), self.index(at, last))
        self.headerDataChanged.emit(Qt.Orientation.Horizontal, 0, last)

    def _words(self, row: TextRow) -> tuple[str, str]:
        assert self.sheet is not None
        if row.kind == "setting":
            return settings.words(self.sheet.project, row.place)
        document = self.sheet.project.flows[row.file]
        outer = self.tr("In every state") if row.place[0] == "always" else ""
        if not outer:
            outer = words.state_words(document, row.place[1])
        if len(self.sheet.project.flows) > 1:
            outer = f"{stem(row.file)}: {outer}"
        value = places.get(document, row.place)
        if isinstance(value, rbd.Component):
            kind = kinds.kind_of(value)
            inner = f"{translated(kind.title) if kind is not None else ''} {value.id}"
        elif row.kind == "heard":
            event = places.get(document, row.place[:-2])
            inner = self.tr("Phrase for {0}").format(getattr(event, "name", None) or "")
        else:
            inner = self.tr("Speech")
        return outer, inner.strip()

    # -- what Qt asks ------------------------------------------------------------

    def rowCount(self, parent: AnyIndex = _NO) -> int:
        return 0 if parent.isValid() else len(self.shown)

    def columnCount(self, parent: AnyIndex = _NO) -> int:
        return 0 if parent.isValid() else WRITTEN + 1 + len(self.languages)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if orientation != Qt.Orientation.Horizontal or self.sheet is None:
            return None
        language = self.language(section)
        if role == Qt.ItemDataRole.DisplayRole:
            if language is None:
                return self._head(section)
            counts = self.sheet.counts(language)
            return self.tr("{0}, {1} of {2}").format(self._head(section), counts.done, counts.every)
        if role == Qt.ItemDataRole.ToolTipRole:
            if section == STATE:
                return self.tr("The state, or the setting, in which the text stands.")
            if section < WRITTEN:
                return self.tr("What says it or shows it there.")
            if language is None:
                return self.tr("As it is written in the documents: what you type here goes there.")
            return self.counts_words(language)
        return None

    def _head(self, section: int) -> str:
        """A column's, without how far its language is."""
        assert self.sheet is not None
        if section < WRITTEN:
            return self.tr("Where") if section == STATE else self.tr("What")
        code = self.language(section) or self.sheet.written_in
        return language_name(code) if code else self.tr("Text as written")

    def counts_words(self, language: str) -> str:
        """How far the texts of a language are, in a sentence."""
        assert self.sheet is not None
        found = self.sheet.counts(language)
        told = [self.tr("{0} of {1} texts translated").format(found.done, found.every)]
        if found.missing:
            told.append(self.tr("{0} missing").format(found.missing))
        if found.unsure:
            told.append(self.tr("{0} to be looked at").format(found.unsure))
        if found.lacking:
            told.append(self.tr("{0} without a tag of the text").format(found.lacking))
        return ", ".join(told)

    def cell(self, index: AnyIndex) -> Cell | None:
        """What stands in a column of a language; None in the columns before."""
        if self.sheet is None or index.column() < WRITTEN:
            return None
        return self.sheet.cell(self.shown[index.row()], self.language(index.column()))

    def data(self, index: AnyIndex, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if not index.isValid():
            return None
        row = self.shown[index.row()]
        if role == ROW:
            return row
        if index.column() < WRITTEN:
            if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.ToolTipRole):
                return self.place_words(row)[index.column()]
            if role == Qt.ItemDataRole.AccessibleTextRole:
                words = ", ".join(self.place_words(row)[index.column() :])
                return headed(self._head(index.column()), words)
            return None
        cell = self.cell(index)
        assert cell is not None
        if role == CELL:
            return cell
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.EditRole):
            return cell.text
        if role == Qt.ItemDataRole.ToolTipRole:
            return "\n".join(part for part in (cell.text, self.standing_words(row, cell)) if part)
        if role == Qt.ItemDataRole.AccessibleTextRole:
            told = self.standing_words(row, cell)
            words = ", ".join(part for part in (cell.text, told) if part)
            return headed(self._head(index.column()), words)
        return None

    def standing_words(self, row: TextRow, cell: Cell) -> str:
        """What there is to know about a cell, in a few words; empty where all is well."""
        if cell.standing == "missing":
            return self.tr("missing")
        if cell.standing == "own":
            return self.tr("always said in {0}").format(language_name(row.lang or ""))
        if cell.standing == "as_is":
            return self.tr("nothing to translate")
        told = []
        if cell.standing == "unsure":
            told.append(
                self.tr("to be looked at: it was “{0}”").format(cell.was)
                if cell.was
                else self.tr("to be looked at")
            )
        if cell.lacks:
            tags = ", ".join(f"{{{name}}}" for name in cell.lacks)
            told.append(self.tr("leaves out {0}").format(tags))
        return "; ".join(told)

    def setData(self, index: AnyIndex, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        cell = self.cell(index)
        if role != Qt.ItemDataRole.EditRole or cell is None:
            return False
        text = str(value).strip()
        if text != cell.text:
            row = self.shown[index.row()]
            self.typed.emit([Typed(row, self.language(index.column()), text)])
        return True

    def flags(self, index: AnyIndex) -> Qt.ItemFlag:
        if not index.isValid():
            return Qt.ItemFlag.NoItemFlags
        found = Qt.ItemFlag.ItemIsSelectable | Qt.ItemFlag.ItemIsEnabled
        cell = self.cell(index)
        if cell is not None and cell.standing != "own":
            found |= Qt.ItemFlag.ItemIsEditable
        return found
