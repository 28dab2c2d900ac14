"""One test of a condition in the words of its data: yes or no, a number with its unit, a text."""

from __future__ import annotations

import json
from typing import Any

from msgspec.structs import replace
from PySide6.QtCore import Signal
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from situ.document.condition import Test
from situ.document.datatypes import number, write_number
from situ.document.names import only_reference
from situ.document.spds import DataType
from situ_studio.assistive.heard_as import hear_as
from situ_studio.edits.vocabulary import Vocabulary
from situ_studio.help.help_topics import explain
from situ_studio.kinds import TESTS
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import Choice, Line, Number
from situ_studio.widgets.icon_widgets import IconButton, IconLabel
from situ_studio.wording.language import translated

# `exists` has only two values, so it is two tests to the designer.
_MISSING = "missing"
CHOICES = (*TESTS, (_MISSING, "is missing"))


class TestBox(QFrame):
    """One test: its tag, what it asks, and since when."""

    changed = Signal(object)
    removed = Signal()
    refused = Signal(str)
    """Why what was typed is not taken."""

    __test__ = False

    def __init__(
        self, theme: Theme, parent: QWidget | None = None, *, lasting: bool = True
    ) -> None:
        """lasting: whether it may ask for how long the test has held."""
        super().__init__(parent)
        self.setObjectName("testBox")
        self.setProperty("role", "box")
        hear_as(self, QAccessible.Role.Grouping)
        self._test: Test | None = None
        self._kind: DataType | None = None
        column = QVBoxLayout(self)
        column.setContentsMargins(7, 5, 7, 7)
        column.setSpacing(4)
        first = QHBoxLayout()
        first.setSpacing(6)
        first.addWidget(IconLabel(theme, "data", "data", 15))
        self.tag = Line()
        self.tag.setAccessibleName(self.tr("Tag"))
        first.addWidget(self.tag, 1)
        self.remove = IconButton(theme, "close", self.tr("Remove this test"), "text3", 12)
        self.remove.setFixedSize(px(18), px(18))
        self.remove.clicked.connect(self.removed)
        first.addWidget(self.remove)
        column.addLayout(first)
        second = QHBoxLayout()
        second.setSpacing(6)
        self.test = Choice(theme)
        self.test.setAccessibleName(self.tr("Test"))
        self.test.offer(tuple((test, translated(words)) for test, words in CHOICES))
        self.test.setFixedWidth(px(98))
        second.addWidget(self.test)
        self.value = Value()
        self.value.setAccessibleName(self.tr("Value"))
        second.addWidget(self.value, 1)
        self.answer = Choice(theme)
        self.answer.setAccessibleName(self.tr("Value"))
        self.answer.offer((("true", self.tr("yes")), ("false", self.tr("no"))))
        second.addWidget(self.answer, 1)
        self.unit = QLabel()
        self.unit.setProperty("role", "label")
        second.addWidget(self.unit)
        self._value_gap = QWidget()
        second.addWidget(self._value_gap, 1)
        column.addLayout(second)
        third = QHBoxLayout()
        third.setSpacing(6)
        self.within = self._seconds(third, self.tr("within"), "within")
        self.hold = self._seconds(third, self.tr("for"), "hold", lasting)
        column.addLayout(third)
        for name in ("tag", "test", "value", "within", "hold"):
            explain(getattr(self, name), "condition", name)
        explain(self.answer, "condition", "value")
        self.tag.committed.connect(lambda v: self._change(tag=v))
        self.test.committed.connect(self._on_test)
        self.value.committed.connect(self._on_value)
        for line in (self.tag, self.value, self.within, self.hold):
            line.refused.connect(self.refused)
        self.answer.committed.connect(lambda v: self._change(value=v))
        self.within.committed.connect(lambda v: self._change(within=v))
        self.hold.committed.connect(lambda v: self._change(hold=v))

    def _seconds(self, line: QHBoxLayout, words: str, name: str, offered: bool = True) -> Number:
        label = QLabel(words)
        label.setProperty("role", "label")
        explain(label, "condition", name)
        line.addWidget(label)
        field = Number(unit=translated("s"), above=True)
        field.setAccessibleName(words)
        line.addWidget(field, 1)
        for widget in (label, field) if not offered else ():
            widget.hide()
        return field

    def show_test(self, test: Test, vocabulary: Vocabulary) -> None:
        self._test = test
        # A reader tells it of the first field in it that somebody comes to.
        self.setAccessibleName(self.tr("Test of {0}").format(test.tag))
        self.tag.complete_from(vocabulary.tags)
        self.tag.show_value(test.tag)
        missing = test.test == "exists" and test.value == "false"
        self.test.show_value(_MISSING if missing else test.test)
        kind, unit = self._kind, _ = vocabulary.type_of(test.tag)
        asked = test.test in ("is", "isnot") and test.value in ("true", "false")
        answers = asked and kind == "boolean"
        # Texts are compared by order too, as in 08:00.
        self.value.numeric = kind == "number" and test.test not in ("in", "exists")
        self.answer.setVisible(answers)
        self.answer.show_value(test.value)
        self.value.setVisible(test.test != "exists" and not answers)
        self._value_gap.setVisible(test.test == "exists")
        self.unit.setText(unit)
        self.unit.setVisible(bool(unit) and self.value.isVisibleTo(self))
        self.value.show_value(listed(test.value) if test.test == "in" else test.value)
        self.within.show_value(test.within)
        self.hold.show_value(test.hold)

    def field(self, attribute: str) -> Line | Choice:
        """The field of an attribute that is shown now; LookupError where there is none."""
        fields: dict[str, Line | Choice] = {
            "tag": self.tag,
            "test": self.test,
            "within": self.within,
            "hold": self.hold,
        }
        if attribute == "value":
            return self.answer if self.answer.isVisibleTo(self) else self.value
        return fields[attribute]

    def _on_test(self, test: str) -> None:
        if self._test is None:
            return
        before = self._test
        if test in ("exists", _MISSING):
            self._change(test="exists", value="true" if test == "exists" else "false")
        elif test == "in":
            first = "" if before.test == "exists" else before.value
            self._change(test=test, value=several(first))
        else:
            value = "" if before.test == "exists" else before.value
            first = listed(value).partition(",")[0] if before.test == "in" else value
            self._change(test=test, value=self._fitting(test, first))

    def _fitting(self, test: str, value: str) -> str:
        """The value, or where it is none for that test of such data, one to begin with."""
        equal, answer = test in ("is", "isnot"), value in ("true", "false")
        if equal and self._kind == "boolean":
            return value if answer else "true"
        if answer and (not equal or self._kind == "number"):
            # Yes and no have no order.
            return "0"
        return value or ("true" if equal and self._kind != "number" else "0")

    def _on_value(self, text: str) -> None:
        if self._test is not None:
            self._change(value=several(text) if self._test.test == "in" else text)

    def _change(self, **fields: Any) -> None:
        if self._test is not None:
            self.changed.emit(replace(self._test, **fields))


class Value(Line):
    """What a test compares with, as the file has it; numeric: a number, or a reference to one."""

    numeric = False

    def read(self, text: str) -> Any:
        text = text.strip()
        if not self.numeric or only_reference(text) is not None:
            return text
        try:
            return write_number(number(text.replace(",", ".")))
        except ValueError:
            raise ValueError(self.tr("Write a number.")) from None


def several(text: str) -> str:
    """What somebody typed for *is one of*, divided by commas, as the JSON array of the file.

    What reads as JSON is that value; a whole array may be typed too.
    """
    found = _read(text)
    if isinstance(found, list):
        return text.strip()
    parts = [part.strip() for part in text.split(",")]
    values = [part if (value := _read(part)) is None else value for part in parts if part]
    return json.dumps(values, ensure_ascii=False)


def listed(array: str) -> str:
    """The JSON array of a file as somebody types it; as it is where commas would not tell."""
    found = _read(array)
    if not isinstance(found, list):
        return array
    told = [
        one if isinstance(one, str) and _read(one) is None else json.dumps(one, ensure_ascii=False)
        for one in found
    ]
    text = ", ".join(told)
    return text if _read(several(text)) == found else array


def _read(text: str) -> Any:
    """The value of a JSON text; None where it is none."""
    try:
        return json.loads(text)
    except ValueError:
        return None
