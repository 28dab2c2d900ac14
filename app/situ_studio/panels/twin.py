"""The outline twin of a canvas: the same document as a tree, with names that can be edited.

For those who prefer it to the graph, or need a screen reader; it has the canvas's
signals and what of its methods makes sense without a picture.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from PySide6.QtCore import (
    QAbstractItemModel,
    QModelIndex,
    QPersistentModelIndex,
    QSize,
    Qt,
    Signal,
)
from PySide6.QtGui import QIcon, QKeyEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QVBoxLayout,
    QWidget,
)

from situ.document import rbd, spds
from situ.document.problem import Problem
from situ_studio import changes, icons, kinds, places, words
from situ_studio.edit import Document, Place
from situ_studio.panels.fields import Choice
from situ_studio.panels.project_tree import Tree
from situ_studio.panels.twin_rows import (
    Node,
    application_rows,
    information_rows,
    script_rows,
)
from situ_studio.theme import Theme

AnyIndex = QModelIndex | QPersistentModelIndex


class TwinModel(QAbstractItemModel):
    """The document as rows; an edited cell is told, not written."""

    cell_edited = Signal(tuple, str, str, object)
    """Place, attribute, label, new value."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.theme = theme
        self.document: Document | None = None
        self._marks: dict[Place, str] = {}
        self._top: list[Node] = []

    def show_document(self, document: Document, marks: dict[Place, str]) -> None:
        self.beginResetModel()
        self.document, self._marks = document, marks
        if isinstance(document, rbd.Application):
            self._top = list(application_rows(document))
        elif isinstance(document, spds.Spds):
            self._top = list(script_rows(document))
        else:
            self._top = list(information_rows(document))
        for row, node in enumerate(self._top):
            node.row = row
        self.endResetModel()

    def node(self, index: AnyIndex) -> Node | None:
        found = index.internalPointer() if index.isValid() else None
        return found if isinstance(found, Node) else None

    def index_of(self, place: Place) -> QModelIndex:
        """The row of a place, or of what it stands in; invalid where there is none."""
        rows, found = self._top, None
        while True:
            step = next((n for n in rows if place[: len(n.place)] == n.place), None)
            if step is None:
                break
            found = step
            if step.place == place:
                break
            rows = step.children
        return self.createIndex(found.row, 0, found) if found is not None else QModelIndex()

    def index(self, row: int, column: int, parent: AnyIndex = QModelIndex()) -> QModelIndex:  # noqa: B008
        node = self.node(parent)
        rows = self._top if node is None else node.children
        if not 0 <= row < len(rows):
            return QModelIndex()
        return self.createIndex(row, column, rows[row])

    def parent(self, index: AnyIndex = QModelIndex()) -> QModelIndex:  # type: ignore[override]  # noqa: B008
        node = self.node(index)
        if node is None or node.parent is None:
            return QModelIndex()
        return self.createIndex(node.parent.row, 0, node.parent)

    def rowCount(self, parent: AnyIndex = QModelIndex()) -> int:  # noqa: B008
        node = self.node(parent)
        return len(self._top) if node is None else len(node.children)

    def hasChildren(self, parent: AnyIndex = QModelIndex()) -> bool:  # noqa: B008
        node = self.node(parent)
        return bool(self._top) if node is None else node.has_children

    def columnCount(self, parent: AnyIndex = QModelIndex()) -> int:  # noqa: B008
        return 4

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = 0) -> Any:
        if orientation != Qt.Orientation.Horizontal or role != Qt.ItemDataRole.DisplayRole:
            return None
        if isinstance(self.document, rbd.Application):
            names = (self.tr("State"), self.tr("Name"), self.tr("Leads to"), self.tr("Details"))
        elif isinstance(self.document, spds.Spds):
            names = (self.tr("What"), self.tr("Name"), self.tr("Takes over"), self.tr("Details"))
        else:
            names = (self.tr("What"), self.tr("Name"), self.tr("Resources"), self.tr("Details"))
        return names[section]

    def data(self, index: AnyIndex, role: int = 0) -> Any:
        node = self.node(index)
        if node is None:
            return None
        column = index.column()
        if role == Qt.ItemDataRole.DisplayRole:
            return node.cells[column]
        if role == Qt.ItemDataRole.EditRole:
            place = node.editable.get(column)
            value = getattr(node.value, place[1]) if place is not None else node.cells[column]
            return " ".join(value) if isinstance(value, tuple) else value
        if role == Qt.ItemDataRole.DecorationRole and column == 0:
            return icons.icon(node.icon[0], self.theme.color(node.icon[1]), 16)
        if role == Qt.ItemDataRole.DecorationRole and column == 1:
            mark = self._marks.get(node.place)
            return icons.icon(mark, self.theme.color(mark), 14) if mark else QIcon()
        if role == Qt.ItemDataRole.ForegroundRole and column > 1:
            return self.theme.color("text2")
        if role == Qt.ItemDataRole.ToolTipRole:
            return node.cells[column]
        return None

    def flags(self, index: AnyIndex) -> Qt.ItemFlag:
        found = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
        node = self.node(index)
        if node is not None and index.column() in node.editable:
            found |= Qt.ItemFlag.ItemIsEditable
        return found

    def setData(self, index: AnyIndex, value: Any, role: int = 2) -> bool:
        node = self.node(index)
        if node is None or role != Qt.ItemDataRole.EditRole:
            return False
        editable = node.editable.get(index.column())
        if editable is None:
            return False
        place, attribute, label = editable
        self.cell_edited.emit(place, attribute, label, value)
        return True


class TwinDelegate(QStyledItemDelegate):
    """Lines for texts, a choice of states for where an event leads."""

    def __init__(self, model: TwinModel, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._model = model

    def sizeHint(self, option: QStyleOptionViewItem, index: AnyIndex) -> QSize:
        size = super().sizeHint(option, index)
        return QSize(size.width(), 26)

    def createEditor(
        self, parent: QWidget, option: QStyleOptionViewItem, index: AnyIndex
    ) -> QWidget:
        node = self._model.node(index)
        editable = node.editable.get(index.column()) if node is not None else None
        document = self._model.document
        if editable is not None and editable[1] in ("next", "extends"):
            choice = Choice(self._model.theme, parent)
            if isinstance(document, rbd.Application):
                choice.offer(
                    (
                        (None, self.tr("nothing, it stays")),
                        *((s.no, f"{s.no} {s.name}") for s in document.states),
                        (rbd.AGAIN, self.tr("the same state, anew")),
                        (rbd.BACK, self.tr("back to where it came from")),
                    )
                )
            elif isinstance(document, spds.Spds):
                choice.offer(((None, "–"), *((s.name, s.name) for s in document.situations)))
            choice.committed.connect(lambda: self.commitData.emit(choice))
            choice.committed.connect(lambda: self.closeEditor.emit(choice))
            return choice
        editor = super().createEditor(parent, option, index)
        editor.setAccessibleName(
            str(
                self._model.headerData(
                    index.column(), Qt.Orientation.Horizontal, int(Qt.ItemDataRole.DisplayRole)
                )
            )
        )
        return editor

    def setEditorData(self, editor: QWidget, index: AnyIndex) -> None:
        if isinstance(editor, Choice):
            editor.show_value(index.data(Qt.ItemDataRole.EditRole))
        else:
            value = index.data(Qt.ItemDataRole.EditRole)
            shown = (
                f"{value:g}" if isinstance(value, float) else "" if value is None else str(value)
            )
            editor.setProperty("text", shown)

    def setModelData(self, editor: QWidget, model: QAbstractItemModel, index: AnyIndex) -> None:
        value = editor.currentData() if isinstance(editor, Choice) else editor.property("text")
        model.setData(index, value, Qt.ItemDataRole.EditRole)


class TwinTree(Tree):
    """Enter, F2 or a double click edits; Delete asks to remove."""

    delete_asked = Signal()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        enter = event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_F2)
        idle = self.state() != QAbstractItemView.State.EditingState
        if enter and idle and self.currentIndex().isValid():
            index = self.currentIndex()
            node = index.internalPointer()
            if (
                isinstance(node, Node)
                and index.column() not in node.editable
                and 1 in node.editable
            ):
                index = index.siblingAtColumn(1)
            self.edit(index)
            return
        super().keyPressEvent(event)


class Twin(QWidget):
    """The same contract as a canvas: shows a document, tells whole new ones."""

    edited = Signal(object, str)
    selection_changed = Signal(tuple)
    activated = Signal(tuple)
    status = Signal(str)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "panel")
        self._document: Document | None = None
        self._selected: tuple[Place, ...] = ()
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.tree = TwinTree(theme)
        self.tree.setAccessibleName(self.tr("Outline of the document"))
        self.tree.setHeaderHidden(False)
        self.tree.setIndentation(20)
        self.tree.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.tree.setEditTriggers(
            QAbstractItemView.EditTrigger.DoubleClicked
            | QAbstractItemView.EditTrigger.EditKeyPressed
        )
        self.tree.setIconSize(QSize(16, 16))
        self.model = TwinModel(theme, self)
        self.model.cell_edited.connect(self._on_cell)
        self.tree.setModel(self.model)
        self.tree.setItemDelegate(TwinDelegate(self.model, self.tree))
        self.tree.selectionModel().selectionChanged.connect(self._on_selection)
        header = self.tree.header()
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        header.setStretchLastSection(True)
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        for section, width in enumerate((168, 240, 168)):
            header.resizeSection(section, width)
        column.addWidget(self.tree)

    def set_theme(self, theme: Theme) -> None:
        self.model.theme = theme
        self.tree.set_theme(theme)
        if self._document is not None:
            self.show_document(self._document, [])

    def show_document(self, document: Document, problems: list[Problem]) -> None:
        """Shows the document; what was open, selected and in view stays so."""
        first = self._document is None
        self._document = document
        marks: dict[Place, str] = {}
        for problem in problems:
            for end in range(1, len(problem.place) + 1):
                place = problem.place[:end]
                if marks.get(place) != "error":
                    marks[place] = problem.severity
        opened = {
            node.place
            for node in self._nodes()
            if self.tree.isExpanded(self.model.createIndex(node.row, 0, node))
        }
        at = self.tree.verticalScrollBar().value()
        current = self.tree.currentIndex()
        node, column = self.model.node(current), current.column()
        # Nobody selected anything else, however the view finds its rows again.
        self.tree.selectionModel().blockSignals(True)
        self.model.show_document(document, marks)
        if first:
            self.tree.expandToDepth(0) if len(self.model._top) <= 40 else None
        for place in opened:
            index = self.model.index_of(place)
            if index.isValid():
                self.tree.setExpanded(index, True)
        self.tree.selectionModel().blockSignals(False)
        self.select(self._selected)
        if node is not None:
            index = self.model.index_of(node.place)
            if index.isValid():
                flag = self.tree.selectionModel().SelectionFlag.NoUpdate
                self.tree.selectionModel().setCurrentIndex(index.siblingAtColumn(column), flag)
        self.tree.verticalScrollBar().setValue(at)

    def select(self, chosen: tuple[Place, ...]) -> None:
        """Shows this selection without telling it."""
        self._selected = chosen
        model = self.tree.selectionModel()
        model.blockSignals(True)
        model.clearSelection()
        for place in chosen:
            index = self.model.index_of(place)
            if index.isValid():
                flags = model.SelectionFlag.Select | model.SelectionFlag.Rows
                model.setCurrentIndex(index, model.SelectionFlag.NoUpdate)
                model.select(index, flags)
                self.tree.scrollTo(index)
        model.blockSignals(False)
        self.tree.viewport().update()

    def zoom_to(self, chosen: tuple[Place, ...]) -> None:
        """Brings the rows of these places into view."""
        self.select(chosen)

    def select_all(self) -> None:
        self.tree.selectAll()

    def rename(self) -> None:
        """Edits the name of the current row in place."""
        index = self.tree.currentIndex()
        if index.isValid():
            self.tree.setFocus()
            self.tree.edit(index.siblingAtColumn(1))

    def delete_selection(self) -> None:
        """Removes what is selected, and what leads to it."""
        if self._document is None or not self._selected:
            return
        text = (
            self.tr("Delete {0}").format(words.place_words(self._document, self._selected[0]))
            if len(self._selected) == 1
            else self.tr("Delete {0} things").format(len(self._selected))
        )
        gone, self._selected = self._selected, ()
        self.edited.emit(changes.remove(self._document, gone), text)

    def add_state(self) -> None:
        """A new state at the end of an application."""
        if not isinstance(self._document, rbd.Application):
            return
        no = changes.free_number(self._document)
        state = kinds.STATE.make(no)
        after = places.change(self._document, (), states=(*self._document.states, state))
        self._selected = (("state", no),)
        self.edited.emit(after, self.tr("Add state {0}").format(no))
        self.selection_changed.emit(self._selected)

    def _nodes(self) -> Iterator[Node]:
        stack = list(self.model._top)
        while stack:
            node = stack.pop()
            yield node
            if node._children is not None:
                stack += node._children

    def _on_selection(self) -> None:
        nodes = (self.model.node(i) for i in self.tree.selectionModel().selectedRows())
        self._selected = tuple(n.place for n in nodes if n is not None)
        self.tree.viewport().update()
        self.selection_changed.emit(self._selected)

    def _empty(self, value: Any, attribute: str) -> Any:
        """What an empty cell means; ValueError where it means nothing."""
        kind = kinds.kind_of(value)
        for field in kind.fields if kind is not None else ():
            if field.attribute == attribute and not field.fixed:
                return field.empty
        raise ValueError(self.tr("This can not be left empty."))

    def _on_cell(self, place: Place, attribute: str, label: str, value: Any) -> None:
        document = self._document
        if document is None:
            return
        old = getattr(places.get(document, place), attribute)
        try:
            value = _read(attribute, value)
            if value == "":
                value = self._empty(places.get(document, place), attribute)
            if value == old:
                return
            after, moved = changes.set_field(document, place, attribute, value)
        except ValueError as error:
            self.status.emit(str(error))
            return
        self._selected = tuple(moved if p == place else p for p in self._selected)
        self.edited.emit(after, words.change_words(document, place, attribute, label))


def _read(attribute: str, value: Any) -> Any:
    """What a cell's text means; ValueError, with a line for the user, where it means nothing."""
    if attribute == "resources":
        return tuple(dict.fromkeys(str(value or "").replace(",", " ").split()))
    if attribute == "seconds":
        try:
            seconds = float(str(value).replace("s", "").strip())
        except ValueError:
            raise ValueError("Write seconds above 0.") from None
        if not seconds > 0:
            raise ValueError("Write seconds above 0.")
        return seconds
    if attribute == "priority":
        if str(value).strip() in ("", "none"):
            return None
        try:
            return int(str(value))
        except ValueError:
            raise ValueError("Write a whole number, or nothing.") from None
    if attribute in ("next", "extends"):
        return value
    return str(value or "").strip()
