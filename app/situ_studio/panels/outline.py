"""The outline at the left: the states of an application, the modules of a script, in order."""

from __future__ import annotations

from PySide6.QtCore import QItemSelection, QModelIndex, QSortFilterProxyModel, Qt, Signal
from PySide6.QtGui import QStandardItem, QStandardItemModel
from PySide6.QtWidgets import QLineEdit, QListView, QVBoxLayout, QWidget

from situ.document.problem import Problem
from situ.document.project import Project
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ_studio.edit import Document, Place
from situ_studio.panels.lists import COUNT, DETAIL, ICON, MARKS, NUMBER, PLACE, RowDelegate
from situ_studio.theme import Theme


class Outline(QWidget):
    """Selects along with the canvas: ``selected`` tells what a person selected here."""

    selected = Signal(tuple)
    activated = Signal(tuple)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "panel")
        self._document: Document | None = None
        self._told: tuple[Place, ...] = ()
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
        column.addWidget(self.list)

    def set_theme(self, theme: Theme) -> None:
        self._delegate.set_theme(theme)
        self.list.viewport().update()

    def toggle_search(self) -> None:
        """Shows or hides the field that filters."""
        self.search.setVisible(not self.search.isVisible())
        if self.search.isVisible():
            self.search.setFocus()
        else:
            self.search.clear()

    def show_document(
        self, project: Project, document: Document | None, problems: tuple[Problem, ...]
    ) -> None:
        """Shows the members of ``document`` with their problems' marks."""
        self._document = document
        rows: list[QStandardItem] = []
        worst: dict[Place, str] = {}
        for problem in problems:
            place = problem.place[:2]
            if worst.get(place) != "error":
                worst[place] = problem.severity
        if isinstance(document, Application):
            self.search.setPlaceholderText(self.tr("Find a state"))
            if document.always is not None:
                rows.append(self._item(("always",), self.tr("Always"), worst))
                rows[-1].setData("∞", NUMBER)
            for state in document.states:
                item = self._item(("state", state.no), state.name, worst)
                item.setData(state.no, NUMBER)
                if state.no == document.start_no:
                    item.setData((("start", "start"), *(item.data(MARKS) or ())), MARKS)
                elif state.flow is not None:
                    item.setData((("part", "part"), *(item.data(MARKS) or ())), MARKS)
                elif state.final:
                    item.setData((("end", "text2"), *(item.data(MARKS) or ())), MARKS)
                rows.append(item)
        elif isinstance(document, Spds):
            self.search.setPlaceholderText(self.tr("Find a module"))
            for declared in document.modules:
                item = self._item(("module", declared.name), declared.name, worst)
                item.setData(("module", "module"), ICON)
                item.setData(" ".join(declared.resources), COUNT)
                known = project.module(declared.name)
                about = known.description if known is not None else ""
                item.setData(about or self.tr("no module information"), DETAIL)
                if any(a.name == declared.name for a in project.applications.values()):
                    item.setData(("state", "state"), ICON)
                    item.setData(about or self.tr("an application of this project"), DETAIL)
                rows.append(item)
        elif document is not None:
            self.search.setPlaceholderText(self.tr("Find a module"))
            for module in document.modules:
                item = self._item(("module", module.name), module.name, worst)
                item.setData(("module", "module"), ICON)
                item.setData(" ".join(module.resources), COUNT)
                item.setData(module.description, DETAIL)
                rows.append(item)
        self._show(rows)

    def _show(self, rows: list[QStandardItem]) -> None:
        """Exchanges only what differs, so that a long list stays where it is."""
        model, chosen = self._model, self._told
        roles = (Qt.ItemDataRole.DisplayRole, NUMBER, ICON, COUNT, MARKS, PLACE, DETAIL)
        selection = self.list.selectionModel()
        selection.blockSignals(True)
        if model.rowCount() == len(rows):
            for index, row in enumerate(rows):
                shown = model.item(index)
                for role in roles:
                    if shown.data(role) != row.data(role):
                        shown.setData(row.data(role), role)
        else:
            model.clear()
            model.invisibleRootItem().appendRows(rows)
        selection.blockSignals(False)
        self._told = ()
        self.select(chosen)

    def _item(self, place: Place, name: str, worst: dict[Place, str]) -> QStandardItem:
        item = QStandardItem(name)
        item.setData(place, PLACE)
        if place in worst:
            item.setData(((worst[place], worst[place]),), MARKS)
        return item

    def select(self, chosen: tuple[Place, ...]) -> None:
        """Shows this selection without telling it."""
        wanted = {p[:1] if p[:1] == ("always",) else p[:2] for p in chosen}
        self._told = chosen
        model = self.list.selectionModel()
        model.blockSignals(True)
        self.list.clearSelection()
        for row in range(self._proxy.rowCount()):
            index = self._proxy.index(row, 0)
            if index.data(PLACE) in wanted:
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

    def _on_activated(self, index: QModelIndex) -> None:
        self.activated.emit(index.data(PLACE))
