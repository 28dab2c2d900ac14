"""The outline twin of a canvas: the same document as a tree, with names that can be edited.

For those who prefer it to the graph, or need a screen reader; it has the canvas's
signals and what of its methods makes sense without a picture.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from PySide6.QtCore import QPoint, QSize, Qt, Signal
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtWidgets import QAbstractItemView, QApplication, QHeaderView, QVBoxLayout, QWidget

from situ.document import rbd
from situ.document.problem import Problem
from situ.document.project import Project
from situ.document.spds import Spds
from situ_studio import kinds
from situ_studio.canvas.script_laws import Laws
from situ_studio.copying.clipboard import Copying
from situ_studio.copying.script_clipboard import ScriptCopying
from situ_studio.edits import changes, places, words
from situ_studio.edits.edit import Document, Place
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.twin_model import TwinModel, read
from situ_studio.panels.twin_rows import Node
from situ_studio.panels.twin_tree import TwinDelegate, TwinTree

SHORT = 40
"""Rows at the top up to which all are open at the start."""


class Twin(QWidget, Copying):
    """The same contract as a canvas: shows a document, tells whole new ones."""

    edited = Signal(object, str)
    selection_changed = Signal(tuple)
    activated = Signal(tuple)
    status = Signal(str)
    menu_requested = Signal(tuple, QPoint)
    """A right click or the menu key: the current row's place, where on the screen."""

    def __init__(
        self,
        theme: Theme,
        parent: QWidget | None = None,
        project: Callable[[], Project | None] = lambda: None,
    ) -> None:
        super().__init__(parent)
        self.setProperty("role", "panel")
        self.project = project
        self._of_script = ScriptCopying(self, self._script, Laws())
        self._document: Document | None = None
        self._selected: tuple[Place, ...] = ()
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.tree = TwinTree(theme)
        self.tree.setAccessibleName(self.tr("Outline of the document"))
        self.tree.setHeaderHidden(False)
        self.tree.setIndentation(px(20))
        self.tree.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.tree.setEditTriggers(
            QAbstractItemView.EditTrigger.DoubleClicked
            | QAbstractItemView.EditTrigger.EditKeyPressed
        )
        self.tree.setIconSize(QSize(px(16), px(16)))
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
        self.tree.move_asked.connect(self.shift_selection)
        self.tree.form_asked.connect(self._on_form)
        column.addWidget(self.tree)
        self.setFocusProxy(self.tree)

    def set_theme(self, theme: Theme) -> None:
        self.model.theme = theme
        self.tree.set_theme(theme)

    def show_document(self, document: Document, problems: list[Problem]) -> None:
        """Shows the document; what was open, selected and in view stays so."""
        marks = _marks(problems)
        if document is self._document:
            # Problems come when they are found: a cell that is being edited stays open.
            self.model.show_marks(marks)
            self.tree.viewport().update()
            return
        first = self._document is None
        self._document = document
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
        focus = QApplication.focusWidget()
        edited = focus is not None and self.tree.isAncestorOf(focus)
        self.model.show_document(document, marks)
        if edited:
            # The cell's editor is gone, and the focus would go to whatever comes next.
            self.tree.setFocus()
        if first:
            self._open_top()
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

    def _open_top(self) -> None:
        """Of a short document; a row without others would be read as an open one."""
        if self.model.rowCount() <= SHORT:
            for row in range(self.model.rowCount()):
                index = self.model.index(row, 0)
                if self.model.hasChildren(index):
                    self.tree.expand(index)

    def select(self, chosen: tuple[Place, ...]) -> None:
        """Shows this selection without telling it."""
        self._selected = chosen
        model = self.tree.selectionModel()
        column = max(0, self.tree.currentIndex().column())
        model.blockSignals(True)
        model.clearSelection()
        for place in chosen:
            index = self.model.index_of(place)
            if index.isValid():
                flags = model.SelectionFlag.Select | model.SelectionFlag.Rows
                model.setCurrentIndex(index.siblingAtColumn(column), model.SelectionFlag.NoUpdate)
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
        self.tree.setFocus()
        self.tree.setCurrentIndex(self.tree.currentIndex().siblingAtColumn(1))
        self.tree.edit_row()

    def copied_document(self) -> rbd.Application | None:
        return self._document if isinstance(self._document, rbd.Application) else None

    def selection(self) -> tuple[Place, ...]:
        return self._selected

    def paste_corner(self) -> None:
        return None

    def copy(self) -> None:
        self._of_script.copy() if self._is_script else super().copy()

    def cut(self) -> None:
        self._of_script.cut() if self._is_script else super().cut()

    def paste(self) -> None:
        self._of_script.paste() if self._is_script else super().paste()

    def duplicate(self) -> None:
        self._of_script.duplicate() if self._is_script else super().duplicate()

    def choose_copies(self, made: tuple[Place, ...]) -> None:
        self.select(made)
        self.selection_changed.emit(made)

    @property
    def _is_script(self) -> bool:
        return isinstance(self._document, Spds)

    def _script(self) -> Spds:
        assert isinstance(self._document, Spds)
        return self._document

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

    def shift_selection(self, by: int) -> None:
        """The current row goes so many rows on among its own."""
        node = self.model.node(self.tree.currentIndex())
        if self._document is None or node is None:
            return
        after, place = places.shift(self._document, node.place, by)
        if after is self._document:
            return
        text = self.tr("Move {0}").format(words.place_words(self._document, node.place))
        self.edited.emit(after, text)
        self.select((place,))
        self.selection_changed.emit(self._selected)

    def _on_form(self) -> None:
        """A row of which no cell can be edited is edited in its form."""
        node = self.model.node(self.tree.currentIndex())
        if self._document is None or node is None:
            return
        place = node.place
        while place and kinds.kind_of(places.get(self._document, place)) is None:
            place = place[:-1]
        self.activated.emit(place)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        node = self.model.node(self.tree.currentIndex())
        self.menu_requested.emit(node.place if node is not None else (), event.globalPos())

    def add_state(self) -> None:
        """A new state at the end of an application."""
        if not isinstance(self._document, rbd.Application):
            return
        no = changes.free_number(self._document)
        state = kinds.STATE.make(no)
        after = places.change(self._document, (), states=(*self._document.states, state))
        self.edited.emit(after, self.tr("Add state {0}").format(no))
        self.select((("state", no),))
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
            value = read(attribute, value)
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


def _marks(problems: list[Problem]) -> dict[Place, str]:
    """The worst severity of each place and of all that it stands in."""
    marks: dict[Place, str] = {}
    for problem in problems:
        for end in range(1, len(problem.place) + 1):
            place = problem.place[:end]
            if marks.get(place) != "error":
                marks[place] = problem.severity
    return marks
