"""The outline twin's rows as Qt's model; what is written into a cell is told, not kept."""

from __future__ import annotations

from typing import Any, overload

from PySide6.QtCore import (
    QAbstractItemModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    Qt,
    Signal,
)
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QWidget

from situ.document import rbd, spds
from situ_studio.assistive.heard_cells import headed
from situ_studio.edits.edit import Document, Place
from situ_studio.looks import icons
from situ_studio.looks.theme import Theme
from situ_studio.panels.twin_rows import (
    Node,
    application_rows,
    information_rows,
    script_rows,
)
from situ_studio.wording.language import tr

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

    def show_marks(self, marks: dict[Place, str]) -> None:
        """Shows other problems of the same document; the view has to be painted anew."""
        self._marks = marks

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

    def index(self, row: int, column: int, parent: AnyIndex = QModelIndex()) -> QModelIndex:
        node = self.node(parent)
        rows = self._top if node is None else node.children
        if not 0 <= row < len(rows):
            return QModelIndex()
        return self.createIndex(row, column, rows[row])

    @overload
    def parent(self, /) -> QObject | None: ...
    @overload
    def parent(self, index: AnyIndex, /) -> QModelIndex: ...
    def parent(self, index: AnyIndex | None = None, /) -> QObject | QModelIndex | None:
        if index is None:
            return super().parent()
        node = self.node(index)
        if node is None or node.parent is None:
            return QModelIndex()
        return self.createIndex(node.parent.row, 0, node.parent)

    def rowCount(self, parent: AnyIndex = QModelIndex()) -> int:
        node = self.node(parent)
        if node is None:
            return len(self._top)
        # Other cells of a row are read as closed ones of their own if they have rows too.
        return len(node.children) if parent.column() == 0 else 0

    def hasChildren(self, parent: AnyIndex = QModelIndex()) -> bool:
        node = self.node(parent)
        if node is None:
            return bool(self._top)
        return node.has_children and parent.column() == 0

    def columnCount(self, parent: AnyIndex = QModelIndex()) -> int:
        return 4

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = 0) -> Any:
        if orientation == Qt.Orientation.Horizontal and role == Qt.ItemDataRole.ToolTipRole:
            return self._tips()[section]
        if orientation != Qt.Orientation.Horizontal or role != Qt.ItemDataRole.DisplayRole:
            return None
        if isinstance(self.document, rbd.Application):
            names = (self.tr("State"), self.tr("Name"), self.tr("Leads to"), self.tr("Details"))
        elif isinstance(self.document, spds.Spds):
            names = (self.tr("What"), self.tr("Name"), self.tr("Takes over"), self.tr("Details"))
        else:
            names = (self.tr("What"), self.tr("Name"), self.tr("Resources"), self.tr("Details"))
        return names[section]

    def _tips(self) -> tuple[str, str, str, str]:
        """What each column says, for its head."""
        details = self.tr("What else it says, in short.")
        name = self.tr("What it is called.")
        if isinstance(self.document, rbd.Application):
            leads = self.tr("The state to which it leads.")
            return self.tr("The state's number, or what stands in it."), name, leads, details
        what = self.tr("What of the script it is.")
        if isinstance(self.document, spds.Spds):
            taken = self.tr("The situation whose priorities it takes over.")
            return what, name, taken, details
        return what, name, self.tr("The parts of the robot that it moves."), details

    def data(self, index: AnyIndex, role: int = 0) -> Any:
        node = self.node(index)
        if node is None:
            return None
        column = index.column()
        if role == Qt.ItemDataRole.DisplayRole:
            return node.cells[column]
        if role == Qt.ItemDataRole.AccessibleTextRole and column:
            # The first cell says which row it is, or in what of it one is.
            head = self.headerData(column, Qt.Orientation.Horizontal)
            return headed(head, node.cells[column])
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


def read(attribute: str, value: Any) -> Any:
    """What a cell's text means; ValueError, with a line for the user, where it means nothing."""
    if attribute == "resources":
        return tuple(dict.fromkeys(str(value or "").replace(",", " ").split()))
    if attribute == "seconds":
        try:
            seconds = float(str(value).replace("s", "").strip())
        except ValueError:
            raise ValueError(tr("Write seconds above 0.")) from None
        if not seconds > 0:
            raise ValueError(tr("Write seconds above 0."))
        return seconds
    if attribute == "priority":
        if str(value).strip() in ("", "none"):
            return None
        try:
            return int(str(value))
        except ValueError:
            raise ValueError(tr("Write a whole number, or nothing.")) from None
    if attribute in ("next", "extends"):
        return value
    return str(value or "").strip()
