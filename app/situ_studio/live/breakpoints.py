"""Breakpoints: where the connected robot pauses, who set it, and what must hold then."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QScrollArea, QVBoxLayout, QWidget

from situ.document import words
from situ.document.condition import Condition
from situ_studio.edits.vocabulary import Vocabulary
from situ_studio.live.breaking import Point, condition_of, point_of
from situ_studio.live.conditions_sought import SoughtConditions
from situ_studio.looks.theme import Theme
from situ_studio.panels.conditions import AddTest, ConditionEditor
from situ_studio.panels.table import Row, RowsTable
from situ_studio.widgets.icon_widgets import ThemedButton, retheme
from situ_studio.wording.language import say, tr

EARLIER = "earlier "
"""What the keys of rows begin with that are not set on this robot."""
WIDE = 300


class Breakpoints(QWidget):
    """``table`` has one a row: those of the robot, then those that were set in this project before
    and that it has not. ``condition`` is that of the current row.

    state_name: what a designer calls an application's state.
    """

    removed = Signal(str)
    """The key of a row."""
    conditioned = Signal(str, object)
    """The key of a row of the robot's, and its other ``Condition``, or None."""
    wanted_again = Signal()
    """The earlier ones shall be set on this robot."""

    def __init__(
        self, theme: Theme, state_name: Callable[[str, str], str], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._theme = theme
        self._state_name = state_name
        self.sought = SoughtConditions()
        self._points: dict[str, Point] = {}
        self._vocabulary = Vocabulary()
        self._adds: tuple[Point, ...] = ()
        self._chosen: Point | None = None
        # Whose condition is shown.
        self._shown: Point | None = None
        self._shows = False
        self._may_change = True
        self.setProperty("role", "panel")
        titles = (tr("No."), tr("The robot pauses"), tr("Application"), tr("Set by"))
        self.table = BreakpointTable(tr("Breakpoints"), titles, (40, 360, 120), theme)
        self.table.rows.tips = (
            tr("The breakpoint's number; green where something waits at it"),
            tr("A click goes there, Delete takes the breakpoint away"),
            tr("Which application pauses"),
            tr("The operator who set it"),
        )
        self.table.removed.connect(self.removed)
        self.table.selectionModel().currentChanged.connect(lambda *_: self._on_chosen())
        self.again = ThemedButton(theme, "breakpoint", "", "link", "error", 14)
        self.again.clicked.connect(self.wanted_again)
        self.again.hide()
        left = QVBoxLayout()
        left.setContentsMargins(0, 0, 0, 0)
        left.setSpacing(0)
        left.addWidget(self.again, 0, Qt.AlignmentFlag.AlignLeft)
        left.addWidget(self.table, 1)
        line = QHBoxLayout(self)
        line.setContentsMargins(0, 0, 0, 0)
        line.setSpacing(0)
        line.addLayout(left, 1)
        line.addWidget(self._side(theme))
        self.setFocusProxy(self.table)
        self._show_condition()

    def _side(self, theme: Theme) -> QWidget:
        """Beside the table: the condition of the current row."""
        side = QFrame()
        side.setProperty("role", "panel")
        column = QVBoxLayout(side)
        column.setContentsMargins(12, 6, 12, 8)
        column.setSpacing(6)
        head = QHBoxLayout()
        title = QLabel(tr("Pauses only while"))
        title.setProperty("role", "heading")
        head.addWidget(title, 1)
        self.condition = ConditionEditor(theme, lasting=False)
        self.condition.changed.connect(self._on_changed)
        self.add = AddTest(theme, self.condition.add)
        head.addWidget(self.add)
        column.addLayout(head)
        self.hint = QLabel()
        self.hint.setProperty("role", "dim")
        self.hint.setWordWrap(True)
        column.addWidget(self.hint)
        column.addWidget(self.condition)
        column.addStretch(1)
        room = QScrollArea()
        room.setAccessibleName(title.text())
        room.setFrameShape(QFrame.Shape.NoFrame)
        room.setWidgetResizable(True)
        room.setFixedWidth(WIDE)
        room.setWidget(side)
        return room

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self.table.set_theme(theme)
        retheme(self, theme)
        self._show_condition()

    def show_breakpoints(
        self,
        every: Sequence[Point],
        stopped: frozenset[int],
        earlier: Sequence[Point],
        vocabulary: Vocabulary,
        may_change: bool = True,
    ) -> None:
        """every: as the tag ``debugger.breakpoints`` has them. stopped: those at which something
        waits now. earlier: those that the robot has not. vocabulary: for conditions. may_change:
        whether the robot takes others from us.
        """
        self._vocabulary, self._may_change = vocabulary, may_change
        self._points = {str(one["id"]): one for one in every}
        self._points |= {f"{EARLIER}{n}": one for n, one in enumerate(earlier)}
        self._shows = True
        self.table.rows.show(
            [self._row(key, one, one.get("id") in stopped) for key, one in self._points.items()]
        )
        self.again.setVisible(bool(earlier) and may_change)
        self.again.setText(tr("Set {0} from before on this robot, too").format(len(earlier)))
        # One whose condition changes is gone and comes again as another, maybe in another turn:
        # what was chosen stays so, and is the newer of both while both stand.
        if self._adds:
            self._chosen = self._adds[0]
        standing = [point_of(one) for one in self._points.values()]
        if self._chosen in standing:
            row = max(n for n, one in enumerate(standing) if one == self._chosen)
            self.table.setCurrentIndex(self.table.rows.index(row, 0))
        self._shows = False
        self._show_condition()
        there = standing[: len(every)]
        if self._adds and all(one in there for one in self._adds):
            self._adds = ()
            self.condition.add("test")

    @property
    def current(self) -> Point | None:
        """The breakpoint of the current row."""
        row = self.table.currentIndex().row()
        return self._points.get(self.table.rows.rows[row].key) if row >= 0 else None

    def point(self, key: str) -> Point | None:
        """The breakpoint of a row."""
        return self._points.get(key)

    def add_test(self, points: Sequence[Point]) -> None:
        """The first gets a condition, at once or when all stand on the robot: they may share it.
        No points: none is waited for any longer.
        """
        self._adds = tuple(points)

    def _row(self, key: str, one: Point, stopped: bool) -> Row:
        writer = str(one.get("writer", "")).removeprefix("operator:")
        earlier = key.startswith(EARLIER)
        cells = (
            "–" if earlier else key,
            self._where(one),
            one.get("application") or tr("all"),
            tr("not on this robot") if earlier else writer,
        )
        return Row(key, cells, stopped)

    def _where(self, one: Point) -> str:
        def name(state: str) -> str:
            return self._state_name(one.get("application") or "", state)

        if one.get("situation") is not None:
            said = tr("in situation {0}").format(one["situation"])
        elif one.get("state") is not None:
            said = tr("in {0}").format(name(one["state"]))
        elif one.get("to") is None:
            said = tr("before it leaves {0}").format(name(one["from"]))
        elif one.get("from") is None:
            said = tr("before it comes to {0}").format(name(one["to"]))
        else:
            said = tr("between {0} and {1}").format(name(one["from"]), name(one["to"]))
        condition = condition_of(one)
        if condition is not None:
            said = tr("{0}, while {1}").format(said, words.condition(condition, say))
        return said

    # -- its condition -----------------------------------------------------------------

    def _on_chosen(self) -> None:
        """By a person, not because the rows are others now."""
        if not self._shows:
            self._chosen = None if self.current is None else point_of(self.current)
            self._show_condition()

    def _show_condition(self) -> None:
        one = self.current
        where = None if one is None else point_of(one)
        if where != self._shown:
            # Also where another operator took away what was chosen.
            self._shown = where
            self.condition.give_up()
        settable = one is not None and "id" in one
        condition = self.sought.of(one) if one is not None and settable else None
        self.condition.show_value(self._theme, condition, self._vocabulary)
        self.condition.setEnabled(self._may_change)
        self.add.setEnabled(settable and self._may_change)
        self.hint.setVisible(condition is None or not self._may_change)
        if not self._may_change:
            self.hint.setText(tr("Only an operator may change it: your key lets you look only."))
        elif settable:
            self.hint.setText(tr("Always. Add a test, as in a guard."))
        else:
            self.hint.setText(tr("Select a breakpoint of this robot."))

    def _on_changed(self, condition: Condition | None, _: str) -> None:
        one = self.current
        if one is not None:
            self.conditioned.emit(str(one["id"]), condition)


class BreakpointTable(RowsTable):
    removed = Signal(str)
    """The key of the row on which Delete was pressed."""

    def event(self, event: QEvent) -> bool:
        ours = isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Delete
        if ours and event.type() == QEvent.Type.ShortcutOverride:
            # Else what is selected in the drawing would be deleted.
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        row = self.currentIndex().row()
        if event.key() == Qt.Key.Key_Delete and row >= 0:
            self.removed.emit(self.rows.rows[row].key)
        else:
            super().keyPressEvent(event)
