"""The outline at the left: the states of an application, the modules of a script, in order."""

from __future__ import annotations

from itertools import compress, count
from operator import is_, is_not

from msgspec import Struct
from PySide6.QtCore import QItemSelection, QModelIndex, QSortFilterProxyModel, Qt, Signal
from PySide6.QtGui import QStandardItem, QStandardItemModel
from PySide6.QtWidgets import QLineEdit, QListView, QVBoxLayout, QWidget

from situ.document import drawing
from situ.document.problem import Problem
from situ.document.project import Project
from situ.document.rbd import Application, State
from situ.document.spds import Spds
from situ_studio import kinds
from situ_studio.edits import places, words
from situ_studio.edits.edit import Document, Place
from situ_studio.edits.exchanged import draws_the_same
from situ_studio.looks.theme import Theme
from situ_studio.panels.lists import COUNT, DETAIL, ICON, MARKS, NUMBER, PLACE, RowDelegate
from situ_studio.panels.more_modules import MoreModules
from situ_studio.wording.language import tr


class Row(Struct, frozen=True, kw_only=True):
    """What the row of one member shows."""

    place: Place
    name: str
    number: str | None = None
    icon: tuple[str, str] | None = None
    count: str | None = None
    marks: tuple[tuple[str, str], ...] | None = None
    detail: str | None = None

    def item(self) -> QStandardItem:
        made = QStandardItem(self.name)
        for role, value in self.data():
            if value is not None:
                made.setData(value, role)
        return made

    def data(self) -> tuple[tuple[int, object], ...]:
        """Its values, each with its role."""
        return (
            (PLACE, self.place),
            (NUMBER, self.number),
            (ICON, self.icon),
            (COUNT, self.count),
            (MARKS, self.marks),
            (DETAIL, self.detail),
            (int(Qt.ItemDataRole.AccessibleTextRole), self.heard()),
        )

    def heard(self) -> str:
        """The row for those who hear it: its signs in words."""
        signs = {
            "start": tr("start"),
            "part": tr("part"),
            "end": tr("end"),
            "error": tr("has an error"),
            "warning": tr("has a warning"),
            "link": tr("connected"),
        }
        number = self.number if self.number and self.number.isalnum() else ""
        called = f"{number} {self.name}".strip()
        marks = [signs[sign] for sign, _ in self.marks or ()]
        every = (called, *marks, self.count or "", self.detail or "")
        return ", ".join(one for one in every if one)


def _stand(row: Row) -> tuple[Place, bool]:
    """What it stands for, and whether it is twice as high."""
    return row.place, bool(row.detail)


def drawn_rows(application: Application) -> list[Row]:
    """Notes and frames, below the states."""
    counts = dict.fromkeys(places.DRAWN, 0)
    rows = []
    for value in drawing.drawn(application):
        kind = "note" if isinstance(value, drawing.Note) else "frame"
        row = kinds.kind(kind)
        rows.append(
            Row(
                place=(kind, str(counts[kind])),
                name=words.drawn_words(value),
                icon=(row.icon, str(row.tint)),
            )
        )
        counts[kind] += 1
    return rows


class Outline(QWidget):
    """Selects along with the canvas: ``selected`` tells what a person selected here."""

    selected = Signal(tuple)
    activated = Signal(tuple)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "panel")
        self._document: Document | None = None
        self._rows: list[Row] = []
        self._at: dict[Place, list[int]] = {}
        self._worst: dict[Place, str] = {}
        self._told: tuple[Place, ...] = ()
        self._present: frozenset[str] = frozenset()
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        self.search = QLineEdit()
        self.search.setPlaceholderText(self.tr("Find a state"))
        self.search.setAccessibleName(self.tr("Find in the outline"))
        self.search.setClearButtonEnabled(True)
        self.search.hide()
        column.addWidget(self.search)
        self.list = QListView()
        self.list.setAccessibleName(self.tr("Outline"))
        self.list.setSelectionMode(QListView.SelectionMode.ExtendedSelection)
        self.list.setEditTriggers(QListView.EditTrigger.NoEditTriggers)
        self.list.setMouseTracking(True)
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._delegate = RowDelegate(theme, 22, self.list)
        self.list.setItemDelegate(self._delegate)
        self._model = QStandardItemModel(self)
        self._proxy = QSortFilterProxyModel(self)
        self._proxy.setSourceModel(self._model)
        self._proxy.setFilterCaseSensitivity(Qt.CaseSensitivity.CaseInsensitive)
        self.search.textChanged.connect(self._proxy.setFilterFixedString)
        self.list.setModel(self._proxy)
        self.list.selectionModel().selectionChanged.connect(self._on_selection)
        self.list.activated.connect(self._on_activated)
        self.list.clicked.connect(self._on_clicked)
        column.addWidget(self.list, 2)
        self.more = MoreModules(theme)
        column.addWidget(self.more, 1)

    def set_theme(self, theme: Theme) -> None:
        self._delegate.set_theme(theme)
        self.list.viewport().update()
        self.more.set_theme(theme)

    def toggle_search(self) -> None:
        """Shows or hides the field that filters."""
        self.search.setVisible(not self.search.isVisible())
        if self.search.isVisible():
            self.search.setFocus()
        else:
            self.search.clear()

    def show_present(self, names: frozenset[str]) -> None:
        """Marks the modules that are connected to the robot now, from the next document on."""
        self._present = names

    def show_document(
        self, project: Project, document: Document | None, problems: tuple[Problem, ...]
    ) -> None:
        """Shows the members of ``document`` with their problems' marks."""
        before, self._document = self._document, document
        rows: list[Row] = []
        worst: dict[Place, str] = {}
        for problem in problems:
            place = problem.place[:2]
            if worst.get(place) != "error":
                worst[place] = problem.severity
        unmarked, self._worst = worst != self._worst, worst

        def marks(place: Place, *more: str) -> tuple[tuple[str, str], ...] | None:
            colours = {"start": "start", "part": "part", "end": "text2"}
            found = tuple((name, colours[name]) for name in more)
            if place in worst:
                found = (*found, (worst[place], worst[place]))
            return found or None

        if isinstance(document, Application):
            self.search.setPlaceholderText(self.tr("Find a state"))
            start = document.start_no
            if document.always is not None:
                place = ("always",)
                said = self.tr("In every state")
                rows.append(Row(place=place, name=said, number="∞", marks=marks(place)))

            def row(state: State) -> Row:
                place = ("state", state.no)
                more = ["start"] * (state.no == start)
                more = more or ["part"] * (state.flow is not None) or ["end"] * state.final
                found = marks(place, *more)
                return Row(place=place, name=state.name, number=state.no, marks=found)

            first = len(rows)
            if (
                isinstance(before, Application)
                and not unmarked
                and before.start_no == start
                and len(before.states) == len(document.states)
                and (before.always is None) == (document.always is None)
            ):
                # Rows of states that are the very same stand as they are.
                rows += self._rows[first : first + len(document.states)]
                for index, same in enumerate(map(is_, before.states, document.states)):
                    if not same:
                        rows[first + index] = row(document.states[index])
            else:
                rows += map(row, document.states)
            if isinstance(before, Application) and draws_the_same(before, document):
                rows += self._rows[first + len(document.states) :]
            else:
                rows += drawn_rows(document)
        elif isinstance(document, Spds):
            self.search.setPlaceholderText(self.tr("Find a module"))
            applications = {a.name for a in project.applications.values()}
            for declared in document.modules:
                place = ("module", declared.name)
                known = project.module(declared.name)
                about = known.description if known is not None else ""
                icon, otherwise = "module", self.tr("no module information")
                if declared.name in applications:
                    icon, otherwise = "state", self.tr("an application of this project")
                found = marks(place)
                if declared.name in self._present:
                    found = (("link", "live"), *(found or ()))
                rows.append(
                    Row(
                        place=place,
                        name=declared.name,
                        icon=(icon, icon),
                        count=" ".join(declared.resources),
                        marks=found,
                        detail=about or otherwise,
                    )
                )
        elif document is not None:
            self.search.setPlaceholderText(self.tr("Find a module"))
            for module in document.modules:
                place = ("module", module.name)
                rows.append(
                    Row(
                        place=place,
                        name=module.name,
                        icon=("module", "module"),
                        count=" ".join(module.resources),
                        marks=marks(place),
                        detail=module.description,
                    )
                )
        self._show(rows)

    def _show(self, rows: list[Row]) -> None:
        """Exchanges only what differs, so that a long list stays where it is, and is quick."""
        shown, self._rows = self._rows, rows
        if shown == rows:
            return
        other = [*compress(count(), map(is_not, shown, rows))]
        if len(shown) != len(rows) or any(_stand(shown[i]) != _stand(rows[i]) for i in other):
            self._at = {}
            for index, row in enumerate(rows):
                self._at.setdefault(row.place, []).append(index)
            # Else each row's height would be asked for again with every change.
            self.list.setUniformItemSizes(len({bool(row.detail) for row in rows}) < 2)
        model, chosen = self._model, self._told
        selection = self.list.selectionModel()
        selection.blockSignals(True)
        if len(shown) == len(rows):
            for index in other:
                if shown[index] != rows[index]:
                    item = model.item(index)
                    item.setText(rows[index].name)
                    for role, value in rows[index].data():
                        item.setData(value, role)
        else:
            model.clear()
            model.invisibleRootItem().appendRows([row.item() for row in rows])
        selection.blockSignals(False)
        self._told = ()
        self.select(chosen)

    def select(self, chosen: tuple[Place, ...]) -> None:
        """Shows this selection without telling it."""
        wanted = {p[:1] if p[:1] == ("always",) else p[:2] for p in chosen}
        self._told = chosen
        model = self.list.selectionModel()
        model.blockSignals(True)
        self.list.clearSelection()
        for row in sorted(row for place in wanted for row in self._at.get(place, ())):
            index = self._proxy.mapFromSource(self._model.index(row, 0))
            if index.isValid():
                flag = model.SelectionFlag.Select
                model.select(index, flag)
                model.setCurrentIndex(index, model.SelectionFlag.NoUpdate)
                self.list.scrollTo(index)
        model.blockSignals(False)
        self.list.viewport().update()

    def _on_selection(self, new: QItemSelection, old: QItemSelection) -> None:
        chosen = tuple(i.data(PLACE) for i in self.list.selectionModel().selectedIndexes())
        self._told = chosen
        self.list.viewport().update()
        self.selected.emit(chosen)

    def _on_clicked(self, index: QModelIndex) -> None:
        """A click on the row of which a part is selected selects the whole again."""
        place = index.data(PLACE)
        if len(self._told) == 1 and self._told != (place,) and places.root(self._told[0]) == place:
            self._told = (place,)
            self.selected.emit(self._told)

    def _on_activated(self, index: QModelIndex) -> None:
        self.activated.emit(index.data(PLACE))
