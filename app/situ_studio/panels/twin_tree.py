"""The outline twin's tree: editors in its cells, and its keys."""

from __future__ import annotations

from PySide6.QtCore import QAbstractItemModel, QModelIndex, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent
from PySide6.QtWidgets import (
    QAbstractItemDelegate,
    QAbstractItemView,
    QLineEdit,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QWidget,
)

from situ.document import rbd, spds, words
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import Choice
from situ_studio.panels.project_tree import Tree
from situ_studio.panels.twin_model import AnyIndex, TwinModel
from situ_studio.panels.twin_rows import Node


class TwinTree(Tree):
    """Enter, F2 or a double click edits, Tab goes on to the row's next cell; Enter on a row without
    cells to edit opens its form. Alt+Up and Alt+Down move a row among its own.
    """

    move_asked = Signal(int)
    form_asked = Signal()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        idle = self.state() != QAbstractItemView.State.EditingState
        if not idle or not self.currentIndex().isValid():
            super().keyPressEvent(event)
            return
        alt = bool(event.modifiers() & Qt.KeyboardModifier.AltModifier)
        key = event.key()
        if key in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_F2):
            if not self.edit_row():
                self.form_asked.emit()
        elif alt and key in (Qt.Key.Key_Up, Qt.Key.Key_Down):
            self.move_asked.emit(-1 if key == Qt.Key.Key_Up else 1)
        else:
            super().keyPressEvent(event)

    def edit_row(self) -> bool:
        """Edits the current cell but for a number, else the row's name, else its first cell.

        False where no cell can be edited.
        """
        index = self.currentIndex()
        columns = self._columns(index)
        if not columns:
            return False
        wanted = next((c for c in (index.column(), 1) if c and c in columns), columns[0])
        cell = index.siblingAtColumn(wanted)
        self.setCurrentIndex(cell)
        self.edit(cell)
        return True

    def closeEditor(self, editor: QWidget, hint: QAbstractItemDelegate.EndEditHint) -> None:
        ends = QAbstractItemDelegate.EndEditHint
        super().closeEditor(editor, ends.NoHint)
        # What was written may have made every row anew; the current one is found again.
        index = self.currentIndex()
        columns = self._columns(index)
        if hint == ends.EditPreviousItem:
            columns = columns[::-1]
        on = hint in (ends.EditNextItem, ends.EditPreviousItem) and index.column() in columns[:-1]
        column = columns[columns.index(index.column()) + 1] if on else 0
        self.setCurrentIndex(index.siblingAtColumn(column))
        if on:
            self.edit(self.currentIndex())

    def _columns(self, index: QModelIndex) -> list[int]:
        node = index.internalPointer() if index.isValid() else None
        return sorted(node.editable) if isinstance(node, Node) else []


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
            choice = CellChoice(self._model.theme, parent)
            if isinstance(document, rbd.Application):
                choice.offer(
                    (
                        (None, self.tr("nothing, it stays")),
                        *((s.no, words.state(s)) for s in document.states),
                        (rbd.AGAIN, self.tr("the same state, anew")),
                        (rbd.BACK, self.tr("back to where it came from")),
                    )
                )
            elif isinstance(document, spds.Spds):
                choice.offer(((None, "–"), *((s.name, s.name) for s in document.situations)))
            choice.committed.connect(lambda: self.commitData.emit(choice))
            choice.committed.connect(lambda: self.closeEditor.emit(choice))
            return choice
        # Not Qt's own: for seconds it would be a spin box that ends at 99.99.
        editor = QLineEdit(parent)
        editor.setFrame(False)
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


class CellChoice(Choice):
    """A choice in a cell: its list is open at once, so that arrows look and Enter takes."""

    def __init__(self, theme: Theme, parent: QWidget) -> None:
        super().__init__(theme, parent)
        self._begun = False

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        if not self._begun:
            self._begun = True
            QTimer.singleShot(0, self, self.showPopup)
