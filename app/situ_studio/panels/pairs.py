"""Short lists edited in place: values sent, results, phrases, what a module needs and provides."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from msgspec import Struct
from msgspec.structs import replace
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QGridLayout, QLabel, QWidget

from situ.document import modules, rbd
from situ_studio.edits.vocabulary import Vocabulary
from situ_studio.kinds import TYPES
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import Choice, Line
from situ_studio.widgets.icon_widgets import IconButton
from situ_studio.wording.language import translated


class Column(Struct, frozen=True):
    """One column: the attribute it shows, its words, what it completes from."""

    attribute: str
    words: str
    completes: str = ""
    choices: tuple[tuple[Any, str], ...] = ()
    stretch: int = 1


class Pairs(Struct, frozen=True):
    """How the members of one attribute are edited, and how a new one is made."""

    columns: tuple[Column, ...]
    make: Callable[[Vocabulary], Any]
    noun: str
    between: str = ""


_TYPES = ((None, "–"), *TYPES)


def _first(words: tuple[str, ...], usual: str) -> str:
    return words[0] if words else usual


PAIRS: dict[str, Pairs] = {
    "params": Pairs(
        (Column("name", "Name", stretch=2), Column("text", "Value", stretch=3)),
        lambda _: rbd.Param("name", "value"),
        "value",
    ),
    "results": Pairs(
        (
            Column("tag", "Tag", "tags", stretch=3),
            Column("path", "Part of the answer", stretch=2),
        ),
        lambda _: rbd.Result("result"),
        "result",
        "←",
    ),
    "says": Pairs((Column("text", "Phrase"),), lambda _: rbd.Say("yes"), "phrase"),
    "requires": Pairs(
        (
            Column("data", "Data", "tags"),
            Column("module", "or module", "modules"),
        ),
        lambda v: modules.Requires(data=_first(v.tags, "data")),
        "need",
    ),
    "provides": Pairs(
        (
            Column("data", "Data", "tags", stretch=4),
            Column("type", "Type", choices=_TYPES, stretch=3),
            Column("unit", "Unit", stretch=2),
        ),
        lambda v: modules.Provides(data="data"),
        "datum",
    ),
}


class PairsEditor(QWidget):
    """The members of one attribute, a row each; tells all of them anew, with words for the step."""

    changed = Signal(object, str)

    def __init__(self, theme: Theme, attribute: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme = theme
        self._pairs = PAIRS[attribute]
        self._members: tuple[Any, ...] = ()
        self._vocabulary = Vocabulary()
        self._fields: list[list[Line | Choice]] = []
        self._extra: list[QWidget] = []
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(4)
        self._grid.setVerticalSpacing(4)

    def show_value(self, theme: Theme, members: tuple[Any, ...], vocabulary: Vocabulary) -> None:
        self._members, self._vocabulary = members, vocabulary
        if len(members) != len(self._fields) or theme is not self._theme:
            self._theme = theme
            self._rebuild(len(members))
        for fields, member in zip(self._fields, members, strict=True):
            for field, column in zip(fields, self._pairs.columns, strict=True):
                if isinstance(field, Line) and column.completes:
                    field.complete_from(getattr(vocabulary, column.completes))
                field.show_value(getattr(member, column.attribute))
        self.setVisible(bool(members))

    def field(self, row: int, column: int) -> Line | Choice:
        return self._fields[row][column]

    def add(self) -> None:
        """One more at the end; its first field gets the focus."""
        made = self._pairs.make(self._vocabulary)
        self.changed.emit(
            (*self._members, made), self.tr("Add a {0}").format(translated(self._pairs.noun))
        )
        if self._fields:
            field = self._fields[-1][0]
            field.setFocus()
            if isinstance(field, Line):
                field.selectAll()

    def _rebuild(self, count: int) -> None:
        for old in [w for row in self._fields for w in row] + self._extra:
            old.hide()
            old.setParent(None)
            old.deleteLater()
        self._fields, self._extra = [], []
        for index in range(count):
            row: list[Line | Choice] = []
            at = 0
            for number, column in enumerate(self._pairs.columns):
                if number and self._pairs.between:
                    sign = QLabel(self._pairs.between)
                    sign.setProperty("role", "label")
                    self._grid.addWidget(sign, index, at)
                    self._extra.append(sign)
                    at += 1
                field: Line | Choice
                if column.choices:
                    field = Choice(self._theme)
                    field.offer(tuple((v, translated(text)) for v, text in column.choices))
                else:
                    field = Line()
                    field.setPlaceholderText(translated(column.words))
                field.setAccessibleName(translated(column.words))
                field.setToolTip(translated(column.words))
                field.setMinimumWidth(px(30))
                field.committed.connect(
                    lambda v, i=index, c=column: self._change(i, c.attribute, v)
                )
                self._grid.addWidget(field, index, at)
                self._grid.setColumnStretch(at, column.stretch)
                row.append(field)
                at += 1
            remove = IconButton(self._theme, "close", self.tr("Remove"), "text3", 12)
            remove.setFixedSize(px(18), px(18))
            remove.clicked.connect(lambda _=False, i=index: self._remove(i))
            self._grid.addWidget(remove, index, at)
            self._extra.append(remove)
            self._fields.append(row)

    def _change(self, index: int, attribute: str, value: Any) -> None:
        member = self._members[index]
        old = getattr(member, attribute)
        if value == "" and (old is None or isinstance(member, modules.Requires)):
            value = None
        if isinstance(member, modules.Requires) and value is not None:
            # Exactly one of the two.
            other = "module" if attribute == "data" else "data"
            changed = replace(member, **{attribute: value, other: None})
        else:
            changed = replace(member, **{attribute: value})
        every = (*self._members[:index], changed, *self._members[index + 1 :])
        self.changed.emit(every, self.tr("Change a {0}").format(translated(self._pairs.noun)))

    def _remove(self, index: int) -> None:
        every = (*self._members[:index], *self._members[index + 1 :])
        self.changed.emit(every, self.tr("Remove a {0}").format(translated(self._pairs.noun)))
