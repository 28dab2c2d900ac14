"""The matrix of a script: a title, the table of priorities with who holds what, and *what if*."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QHeaderView, QLabel, QVBoxLayout, QWidget

from situ.document.problem import Problem
from situ.document.spds import Spds
from situ.rehearse.what_if import Answer
from situ_studio.canvas import script_gestures as gestures
from situ_studio.canvas.live import LiveScript
from situ_studio.edits import changes, words
from situ_studio.edits.edit import Place
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.matrix.grid import Grid, asking
from situ_studio.matrix.model import MatrixModel
from situ_studio.matrix.range_edits import RangeEdits
from situ_studio.matrix.sides import Sides
from situ_studio.matrix.table import Area
from situ_studio.matrix.what_if import WhatIf
from situ_studio.widgets.icon_widgets import Elided, ThemedButton, retheme
from situ_studio.widgets.layouts import rule

if TYPE_CHECKING:
    from situ_studio.views.table import Setting

LOW = 250
"""Px of height below which what follows from *what if* has one line."""


class MatrixView(QWidget):
    """A piece of the views of a script (``situ_studio.views.table``): cells become ``edited``.

    What is selected in the document are the situations of the selected range, or the modules of
    selected columns.
    """

    edited = Signal(object, str)
    selection_changed = Signal(tuple)
    activated = Signal(tuple)
    status = Signal(str)
    menu_requested = Signal(tuple, QPoint)
    supposed = Signal(object)
    """What follows from *what if*, as a ``LiveScript``; None where nothing is supposed."""

    def __init__(self, setting: Setting) -> None:
        super().__init__(setting.parent)
        theme = setting.theme
        self._project = setting.project
        self._document: Spds | None = None
        self._selected: tuple[Place, ...] = ()
        self._telling = False
        self._live: LiveScript | None = None
        self._answer: Answer | None = None
        self.setProperty("role", "panel")
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self._head(theme))
        column.addWidget(rule())
        self.model = MatrixModel(self)
        self.sides = Sides(theme, self.model)
        self.table = self.sides.table
        column.addWidget(self.sides, 1)
        self.range = RangeEdits(self.model, self.table)
        self.what_if = WhatIf(theme)
        self.what_if.answered.connect(self._on_answer)
        column.addWidget(self.what_if)
        self.setFocusProxy(self.table)
        self.setMinimumHeight(px(198))
        self._wire()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.what_if.set_low(self.height() < px(LOW))

    def _head(self, theme: Theme) -> QWidget:
        head = QFrame()
        head.setProperty("role", "panel")
        head.setFixedHeight(px(32))
        line = QHBoxLayout(head)
        line.setContentsMargins(12, 0, 8, 0)
        line.setSpacing(8)
        title = QLabel(self.tr("Priorities"))
        title.setProperty("role", "heading")
        line.addWidget(title)
        for icon, text, make in (
            ("situation", self.tr("Situation"), self.add_situation),
            ("module", self.tr("Module"), self.add_module),
        ):
            button = ThemedButton(theme, "plus", text, "link", "text2", 12)
            button.setAccessibleName(self.tr("Add: {0}").format(text))
            button.setToolTip(button.accessibleName())
            button.setObjectName(f"add_{icon}")
            # By keys the same is had from the menu, and the table is the first to have the focus.
            button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
            button.clicked.connect(make)
            line.addWidget(button)
        legend = Elided(
            self.tr("pale: taken over from another situation · right: who holds it when all ask"),
            "hint",
        )
        legend.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        line.addWidget(legend, 1)
        return head

    def _wire(self) -> None:
        self.table.selectionModel().selectionChanged.connect(self._on_range)
        self.table.selectionModel().currentChanged.connect(self._on_range)
        for table in (self.table, self.sides.holders):
            table.asked.connect(self._on_key)
            table.menu_asked.connect(self._on_menu)
            for head, press in ((table.rows, self._press_row), (table.heads, self._on_column)):
                head.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
                asked = partial(self._on_head_menu, head, press)
                head.customContextMenuRequested.connect(asked)
        self.range.edited.connect(self.edited)
        self.range.status.connect(self.status)
        self.table.rows.moved.connect(self._move)
        self.table.rows.renamed.connect(self._on_situation_renamed)
        self.table.heads.renamed.connect(self._on_module_renamed)
        self.table.rows.sectionPressed.connect(self._on_row)
        self.table.heads.sectionPressed.connect(self._on_column)
        self.sides.holders.heads.sectionPressed.connect(self._on_column)

    # -- the contract of a piece ---------------------------------------------------------

    def set_theme(self, theme: Theme) -> None:
        retheme(self, theme)
        self.sides.set_theme(theme)
        self.what_if.set_theme(theme)

    def show_document(self, document: Spds, problems: list[Problem]) -> None:
        """Shows the script; range and current cell stay at what they were about."""
        before = self.model.grid
        asked = asking(self._project(), document)
        if document is not self._document or before is None or before.asked.by_module != asked:
            self._document = document
            with self._told():
                name, module = self._at()
                if self.model.show(Grid(document, asked, before)):
                    self.sides.settle()
                    self._go_back(name, module)
        if self.model.show_problems(problems):
            self.sides.settle()
        project = self._project()
        self.what_if.show_script(document, asked, project.tags if project is not None else None)

    def _at(self) -> tuple[str, str]:
        """Situation and module of the current cell; empty where there is none."""
        at, grid = self.table.currentIndex(), self.model.grid
        if grid is None or not at.isValid() or at.column() >= len(grid.modules):
            return "", ""
        return grid.lines[at.row()].situation.name, grid.modules[at.column()]

    def _go_back(self, name: str, module: str) -> None:
        grid = self.model.grid
        assert grid is not None
        if not grid.lines or not grid.modules:
            return
        row = max(0, grid.row(name))
        column = grid.modules.index(module) if module in grid.modules else 0
        self.table.choose(Area(row, column))

    def select(self, chosen: tuple[Place, ...]) -> None:
        """Shows this selection without telling it."""
        self._selected = chosen
        grid = self.model.grid
        if grid is None:
            return
        rows = [grid.row(p[1]) for p in chosen if p[:1] == ("situation",) and len(p) > 1]
        modules = [p[1] for p in chosen if p[:1] == ("module",) and len(p) > 1]
        columns = [at for at, name in enumerate(grid.modules) if name in modules]
        resources = [p[1] for p in chosen if p[:1] == ("resource",) and len(p) > 1]
        columns += [len(grid.modules) + i for i, r in enumerate(grid.resources) if r in resources]
        self.sides.show_chosen(frozenset(rows) - {-1}, frozenset(columns))
        if len(rows) == 1 and rows[0] >= 0 and grid.modules:
            at = self.table.currentIndex().column()
            module = _module_of(self._document, chosen[0])
            column = grid.modules.index(module) if module in grid.modules else None
            if not self._covers(rows[0], column):
                to = max(0, at) if column is None else column
                with self._told():
                    self.table.choose(Area(rows[0], min(to, len(grid.modules) - 1)))

    def _covers(self, row: int, column: int | None) -> bool:
        """Whether a row is in the chosen area, and a column, where one is meant."""
        area = self.table.area
        if area is None or not area.top <= row <= area.bottom:
            return False
        return column is None or area.left <= column <= area.right

    def selection(self) -> tuple[Place, ...]:
        return self._selected

    def set_live(self, live: LiveScript | None) -> None:
        """Marks what a robot does; *what if* goes before it."""
        self._live = live
        self._mark()

    def _on_answer(self, answer: Answer | None) -> None:
        self._answer = answer
        self._mark()
        self.supposed.emit(self._as_live(answer) if answer is not None else None)

    def _as_live(self, answer: Answer) -> LiveScript:
        strip = self.what_if
        asked = self.model.grid.asked.by_module if self.model.grid is not None else {}
        return LiveScript(
            answer.situation,
            frozenset(answer.holds),
            {resource: held.module for resource, held in answer.holdings.items()},
            {module: uses for module, uses in asked.items() if module not in strip.silent and uses},
            strip.values,
        )

    def _mark(self) -> None:
        answer, live = self._answer, self._live
        if answer is not None:
            self.model.show_situation(answer.situation, frozenset(answer.holds))
        elif live is not None:
            self.model.show_situation(live.situation, live.holds)
        else:
            self.model.show_situation(None, frozenset())

    # -- what is selected ------------------------------------------------------------------

    @contextmanager
    def _told(self) -> Iterator[None]:
        """While it lasts, what changes in the table is not what a person chose."""
        before, self._telling = self._telling, True
        try:
            yield
        finally:
            self._telling = before

    def _on_range(self, *_: object) -> None:
        grid, area = self.model.grid, self.table.area
        if self._telling or grid is None:
            return
        at = self.table.currentIndex()
        if area is None and at.isValid():
            area = Area(at.row(), at.column())
        if area is None:
            self._choose(())
            return
        lines = grid.lines[area.top : area.bottom + 1]
        self._choose(tuple(("situation", line.situation.name) for line in lines))

    def _on_row(self, row: int) -> None:
        """A situation was pressed; where there are cells, their range says it already."""
        if not self.model.columnCount():
            self._choose((("situation", self.model.line(row).situation.name),))

    def _on_column(self, column: int) -> None:
        """A header was pressed: its module or resource is meant, not all situations."""
        grid = self.model.grid
        if grid is None:
            return
        if column < len(grid.modules):
            self._choose((("module", grid.modules[column]),))
        else:
            self._choose((("resource", grid.resources[column - len(grid.modules)]),))

    def _choose(self, chosen: tuple[Place, ...]) -> None:
        if chosen != self._selected:
            self.select(chosen)
            self.selection_changed.emit(chosen)

    def _on_key(self, name: str) -> None:
        """A key of the tables: of the range, or of the situations."""
        keys = {"move_up": -1, "move_down": 1}
        if name in keys:
            self.shift_selection(keys[name])
        elif name == "select_all":
            self.select_all()
        else:
            getattr(self.range, name)()

    def asked_about(self) -> Place:
        """The current cell's module in its situation, or the situation, module or resource of the
        row or column that is selected as a whole.
        """
        grid, area = self.model.grid, self.table.area
        name, module = self._at()
        if grid is None or not self._selected or self._selected[0][0] != "situation":
            return self._selected[0] if self._selected else ()
        at = self.table.currentIndex().column()
        if area is not None and area.wide >= len(grid.modules) > 1:
            return ("situation", name) if name else self._selected[0]
        if at >= len(grid.modules):
            return ("resource", grid.resources[at - len(grid.modules)])
        return ("situation", name, "module", module) if module else self._selected[0]

    def _on_head_menu(self, head: QHeaderView, press: Callable[[int], None], at: QPoint) -> None:
        """The menu of a row's or column's head is about that, not about what was selected."""
        section = head.logicalIndexAt(at)
        if section >= 0:
            press(section)
        self._on_menu(head.viewport().mapToGlobal(at))

    def _press_row(self, row: int) -> None:
        self.table.selectRow(row)
        self._on_row(row)

    def _on_menu(self, at: QPoint) -> None:
        self.menu_requested.emit(self._selected[0] if self._selected else (), at)

    # -- what commands ask for ------------------------------------------------------------

    def copy(self) -> None:
        self.range.copy()

    def cut(self) -> None:
        self.range.cut()

    def paste(self) -> None:
        self.range.paste()

    def select_all(self) -> None:
        self.table.selectAll()

    # -- situations and modules -----------------------------------------------------------

    def shift_selection(self, by: int) -> None:
        """The current situation goes before or after its neighbour."""
        row = self.table.currentIndex().row()
        if row >= 0 and 0 <= row + by < self.model.rowCount():
            self._move(row, row + by)

    def _move(self, row: int, to: int) -> None:
        assert self._document is not None
        name = self.model.line(row).situation.name
        after, text = gestures.reorder(self._document, name, to)
        if text:
            self.edited.emit(after, text)

    def add_situation(self) -> None:
        """A new situation before the last, to be named."""
        if self._document is None:
            return
        after, text, name = gestures.add_situation(self._document)
        self.edited.emit(after, text)
        self._choose((("situation", name),))
        grid = self.model.grid
        if grid is not None and grid.row(name) >= 0:
            self.table.rows.edit_name(grid.row(name))

    def add_module(self) -> None:
        """A new module, to be named."""
        if self._document is None:
            return
        after, text, name = gestures.add_module(self._document)
        self.edited.emit(after, text)
        self._choose((("module", name),))
        if name in self.model.modules:
            column = self.model.modules.index(name)
            self.table.scrollTo(self.model.index(0, column))
            self.table.heads.edit_name(column)

    def delete_selection(self) -> None:
        """The selected situations or modules, as a menu says it; the key clears cells."""
        if self._document is None or not self._selected:
            return
        after, text = gestures.delete(self._document, self._selected)
        if text:
            self.edited.emit(after, text)

    def rename(self) -> None:
        """Edits the name of what is selected where it stands."""
        grid = self.model.grid
        if grid is None or not self._selected:
            return
        kind, name = (*self._selected[0], "")[:2]
        if kind == "situation" and grid.row(name) >= 0:
            self.table.rows.edit_name(grid.row(name))
        elif kind == "module" and name in grid.modules:
            self.table.heads.edit_name(grid.modules.index(name))

    def _on_situation_renamed(self, row: int, name: str) -> None:
        old = self.model.line(row).situation.name
        self._rename(("situation", old), " ".join(name.split()))

    def _on_module_renamed(self, column: int, name: str) -> None:
        self._rename(("module", self.model.modules[column]), "".join(name.split()))

    def _rename(self, place: Place, name: str) -> None:
        document = self._document
        if document is None or not name or name == place[1]:
            return
        try:
            if place[0] == "module" and name in self.model.modules:
                raise ValueError(self.tr("{0} is taken already.").format(name))
            if any(m.name == place[1] for m in document.modules) or place[0] == "situation":
                after, moved = changes.set_field(document, place, "name", name)
                assert isinstance(after, Spds)
            else:
                after, moved = changes.rename_module(document, place[1], name), ("module", name)
        except ValueError as taken:
            self.status.emit(str(taken))
            return
        self.edited.emit(after, words.change_words(document, place, "name", "name"))
        self._choose((moved,))

    def zoom_to(self, chosen: tuple[Place, ...]) -> None:
        """Brings the rows and columns of these places into view."""
        self.select(chosen)
        self.bring_into_view(chosen)

    def bring_into_view(self, chosen: tuple[Place, ...]) -> None:
        """Scrolls to the first row, else column, of what is selected; of priorities to theirs."""
        current = self.table.currentIndex()
        if any(place[2:3] == ("entry",) for place in chosen) and current.isValid():
            self.table.scrollTo(current)
            return
        rows, columns = self.table.cells.rows, self.table.cells.columns
        if rows:
            self.table.scrollTo(
                self.model.index(min(rows), max(0, self.table.currentIndex().column()))
            )
        elif columns:
            self.table.scrollTo(self.model.index(0, min(columns)))


def _module_of(script: Spds | None, place: Place) -> str:
    """The module of an entry's place."""
    situation = script.situation(place[1]) if script is not None else None
    if situation is None or place[2:3] != ("entry",) or not place[3].isdigit():
        return ""
    at = int(place[3])
    return situation.entries[at].module if at < len(situation.entries) else ""
