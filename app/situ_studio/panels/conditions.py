"""Conditions, edited in place: a box a test (``test_box``), a frame a group."""

from __future__ import annotations

from functools import partial
from typing import Any, Literal

from msgspec.structs import replace
from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QMenu, QVBoxLayout, QWidget

from situ.document.condition import Condition, Group, GroupName, Test
from situ_studio.assistive.heard_as import hear_as
from situ_studio.edits.vocabulary import Vocabulary
from situ_studio.kinds import GROUPS
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import Choice
from situ_studio.panels.test_box import TestBox
from situ_studio.widgets.icon_widgets import IconButton, IconLabel
from situ_studio.widgets.layouts import clear
from situ_studio.wording.language import translated

Path = tuple[int, ...]


class GroupBox(QFrame):
    """A group: its kind above, its members below a line at the left."""

    changed = Signal(str)
    removed = Signal()
    added = Signal(str)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        hear_as(self, QAccessible.Role.Grouping)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(4)
        first = QHBoxLayout()
        first.setSpacing(4)
        first.addWidget(IconLabel(theme, "condition", "condition", 15))
        self.kind = Choice(theme)
        self.kind.setAccessibleName(self.tr("Group"))
        self.kind.setToolTip(self.tr("How many of the tests in it must hold"))
        self.kind.offer(tuple((kind, translated(words)) for kind, words in GROUPS))
        self.kind.committed.connect(lambda kind: self.changed.emit(str(kind)))
        first.addWidget(self.kind, 1)
        self.plus = AddTest(theme, self.added.emit)
        first.addWidget(self.plus)
        remove = IconButton(theme, "close", self.tr("Remove this group"), "text3", 12)
        remove.setFixedSize(px(18), px(18))
        remove.clicked.connect(self.removed)
        first.addWidget(remove)
        column.addLayout(first)
        inner = QHBoxLayout()
        inner.setContentsMargins(6, 0, 0, 0)
        inner.setSpacing(6)
        line = QFrame()
        line.setFixedWidth(2)
        line.setStyleSheet(f"background: {theme.condition_soft};")
        inner.addWidget(line)
        self.members = QVBoxLayout()
        self.members.setSpacing(6)
        self.empty = QLabel(self.tr("Nothing in it yet: add a test or a group."))
        self.empty.setProperty("role", "hint")
        self.empty.setWordWrap(True)
        self.members.addWidget(self.empty)
        inner.addLayout(self.members, 1)
        column.addLayout(inner)

    def show_group(self, group: Group) -> None:
        self.kind.show_value(group.kind)
        self.setAccessibleName(self.kind.currentText())
        self.empty.setVisible(not group.children)


class AddTest(IconButton):
    """The button that adds a test or a group."""

    def __init__(self, theme: Theme, add: Any, parent: QWidget | None = None) -> None:
        super().__init__(theme, "plus", "", "text3", 16, parent)
        self.setObjectName("add test")
        self.setToolTip(self.tr("Add a test"))
        self.setAccessibleName(self.tr("Add a test"))
        menu = QMenu(self)
        menu.addAction(self.tr("A test"), lambda: add("test"))
        for kind, words in GROUPS:
            menu.addAction(translated(words).capitalize(), partial(add, kind))
        self.setMenu(menu)
        self.setPopupMode(self.ToolButtonPopupMode.InstantPopup)
        self.setStyleSheet("QToolButton::menu-indicator { image: none; }")
        self.setIconSize(QSize(px(16), px(16)))


class ConditionEditor(QWidget):
    """All of a condition; tells the new one (None: no test is left) with words for the step.

    A group that is added has nothing in it yet. A condition with such a group is none, so it
    stands here only, until there is a test in it or the condition becomes another one elsewhere.
    """

    changed = Signal(object, str)
    refused = Signal(str)
    """Why what was typed into a test is not taken."""

    def __init__(
        self, theme: Theme, parent: QWidget | None = None, *, lasting: bool = True
    ) -> None:
        """lasting: whether a test may ask for how long it has held."""
        super().__init__(parent)
        self._theme, self._lasting = theme, lasting
        self._condition: Condition | None = None
        self._begun: Condition | None = None
        """The condition with the groups that are empty yet; None where none is."""
        self._vocabulary = Vocabulary()
        self._shape: Any = ()
        self._boxes: dict[Path, TestBox | GroupBox] = {}
        self._layout = QVBoxLayout(self)
        self._layout.setContentsMargins(0, 0, 0, 0)
        self._layout.setSpacing(6)

    def show_value(self, theme: Theme, condition: Condition | None, vocabulary: Vocabulary) -> None:
        self._condition, self._vocabulary = condition, vocabulary
        if self._begun is not None and _told(self._begun) != condition:
            self._begun = None
        children = self._shown.children
        shape = (theme.name, _shape(children))
        if shape != self._shape:
            self._theme, self._shape = theme, shape
            self._rebuild(children)
        self._fill((), children)
        self.setVisible(bool(children))

    def give_up(self) -> None:
        """Something else is shown next: groups that are empty yet are forgotten."""
        self._begun = None

    @property
    def _shown(self) -> Condition:
        return self._begun or self._condition or Condition()

    def box(self, *path: int) -> TestBox | GroupBox:
        """The box at a path of positions; tests type into it."""
        return self._boxes[path]

    def add(self, kind: GroupName | Literal["test"], path: Path = ()) -> None:
        """Adds a test or a group of that kind at the end of the group at ``path``."""
        tags = self._vocabulary.tags
        test = Test(tags[0] if tags else "tag", "exists", "true")
        new: Test | Group = test if kind == "test" else Group(kind, ())
        at = (*path, len(_at(self._shown, path).children))
        self._tell(_insert(self._shown, path, new), self.tr("Add a test"))
        box = self._boxes.get(at)
        if isinstance(box, TestBox):
            box.tag.setFocus(Qt.FocusReason.OtherFocusReason)
            box.tag.selectAll()
        elif isinstance(box, GroupBox):
            box.plus.setFocus(Qt.FocusReason.OtherFocusReason)

    def _tell(self, shown: Condition, text: str) -> None:
        """Another condition; only what is in no empty group is told, and only where that is new."""
        told = _told(shown)
        self._begun = shown if told != shown else None
        if told != self._condition:
            self.changed.emit(told, text)
        else:
            self.show_value(self._theme, self._condition, self._vocabulary)

    def _rebuild(self, children: tuple[Test | Group, ...]) -> None:
        clear(self._layout)
        self._boxes = {}
        self._build(self._layout, (), children)

    def _build(self, layout: QVBoxLayout, path: Path, children: tuple[Test | Group, ...]) -> None:
        for index, child in enumerate(children):
            at = (*path, index)
            if isinstance(child, Test):
                box = TestBox(self._theme, lasting=self._lasting)
                box.changed.connect(lambda v, p=at: self._put(p, v, self.tr("Change a test")))
                box.removed.connect(lambda p=at: self._put(p, None, self.tr("Remove a test")))
                box.refused.connect(self.refused)
                self._boxes[at] = box
                layout.addWidget(box)
            else:
                group = GroupBox(self._theme)
                group.changed.connect(lambda kind, p=at: self._regroup(p, kind))
                group.removed.connect(lambda p=at: self._put(p, None, self.tr("Remove a group")))
                group.added.connect(lambda kind, p=at: self.add(kind, p))
                self._boxes[at] = group
                layout.addWidget(group)
                self._build(group.members, at, child.children)

    def _fill(self, path: Path, children: tuple[Test | Group, ...]) -> None:
        for index, child in enumerate(children):
            box = self._boxes[(*path, index)]
            if isinstance(child, Test) and isinstance(box, TestBox):
                box.show_test(child, self._vocabulary)
            elif isinstance(child, Group) and isinstance(box, GroupBox):
                box.show_group(child)
                self._fill((*path, index), child.children)

    def _regroup(self, path: Path, kind: Any) -> None:
        group = _at(self._shown, path)
        if isinstance(group, Group):
            self._put(path, replace(group, kind=kind), self.tr("Change a group"))

    def _put(self, path: Path, value: Test | Group | None, text: str) -> None:
        self._tell(_exchange(self._shown, path, value), text)


def _shape(children: tuple[Test | Group, ...]) -> Any:
    return tuple("test" if isinstance(c, Test) else _shape(c.children) for c in children)


def _at(condition: Condition | None, path: Path) -> Any:
    value: Any = condition
    for index in path:
        value = value.children[index]
    return value


def _told(shown: Condition) -> Condition | None:
    """The condition without what is empty in it; None where nothing is left."""

    def filled(children: tuple[Test | Group, ...]) -> tuple[Test | Group, ...]:
        kept: list[Test | Group] = []
        for child in children:
            if isinstance(child, Test):
                kept.append(child)
            elif inner := filled(child.children):
                kept.append(child if inner == child.children else replace(child, children=inner))
        return tuple(kept)

    children = filled(shown.children)
    return replace(shown, children=children) if children else None


def _exchange(holder: Any, path: Path, value: Test | Group | None) -> Any:
    """``holder`` with the member at ``path`` exchanged, or taken out; empty groups go too."""
    children = list(holder.children)
    if len(path) == 1:
        children[path[0] : path[0] + 1] = [] if value is None else [value]
    else:
        inner = _exchange(children[path[0]], path[1:], value)
        children[path[0] : path[0] + 1] = [inner] if inner.children else []
    return replace(holder, children=tuple(children))


def _insert(holder: Any, path: Path, value: Test | Group) -> Any:
    if not path:
        return replace(holder, children=(*holder.children, value))
    inner = _insert(holder.children[path[0]], path[1:], value)
    return _exchange(holder, path[:1], inner)
