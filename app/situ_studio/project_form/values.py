"""A value of the blackboard as a person writes it: text, number, yes or no, or JSON."""

from __future__ import annotations

import json
from typing import Any

from PySide6.QtCore import QCoreApplication, Signal
from PySide6.QtWidgets import QHBoxLayout, QStackedWidget, QWidget

from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import Choice, Line, Number

KINDS = ("text", "number", "flag", "json")


def kind_of(value: Any) -> str:
    """Which of ``KINDS`` a value is."""
    if isinstance(value, bool):
        return "flag"
    if isinstance(value, (int, float)):
        return "number"
    return "text" if isinstance(value, str) else "json"


def as_kind(value: Any, kind: str) -> Any:
    """A value as one of another kind, as near as can be."""
    if kind == kind_of(value):
        return value
    if kind == "flag":
        return value not in (0, "", "false", "no", [], {})
    if kind == "number":
        try:
            number = float(value)
        except (TypeError, ValueError):
            return 0
        return int(number) if number.is_integer() else number
    if kind == "text":
        return value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)
    return [value] if value != "" else []


class _Json(Line):
    def written(self, value: Any) -> str:
        return json.dumps(value, ensure_ascii=False)

    def read(self, text: str) -> Any:
        try:
            found = json.loads(text)
        except ValueError:
            raise ValueError(self.tr('Write a list such as ["a", "b"], or {"a": 1}.')) from None
        if found is None or _has_null(found):
            raise ValueError(self.tr("There is no null at the start: leave it out."))
        return found


def _has_null(value: Any) -> bool:
    if isinstance(value, dict):
        return any(map(_has_null, value.values()))
    return any(map(_has_null, value)) if isinstance(value, list) else value is None


class _Plain(Line):
    def read(self, text: str) -> Any:
        return text


class _Amount(Number):
    def read(self, text: str) -> Any:
        found = super().read(text)
        if found is None:
            raise ValueError(self.tr("Write a number."))
        return int(found) if float(found).is_integer() and "." not in text else found

    def written(self, value: Any) -> str:
        return "" if value is None else repr(value)


class ValueField(QWidget):
    """Kind and value; choosing another kind turns the value into one."""

    committed = Signal(object)
    refused = Signal(str)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._value: Any = ""
        line = QHBoxLayout(self)
        line.setContentsMargins(0, 0, 0, 0)
        line.setSpacing(8)
        self.kind = Choice(theme)
        self.kind.offer(
            (
                ("text", self.tr("Text")),
                ("number", self.tr("Number")),
                ("flag", self.tr("Yes or no")),
                ("json", self.tr("List")),
            )
        )
        self.kind.setAccessibleName(self.tr("Kind"))
        self.kind.setFixedWidth(px(104))
        self.kind.committed.connect(self._on_kind)
        line.addWidget(self.kind)
        self.flag = Choice(theme)
        self.flag.offer(((True, self.tr("yes")), (False, self.tr("no"))))
        self._fields: dict[str, Line | Choice] = {
            "text": _Plain(),
            "number": _Amount(),
            "flag": self.flag,
            "json": _Json(),
        }
        self._stack = QStackedWidget()
        for field in self._fields.values():
            field.setAccessibleName(QCoreApplication.translate("ValueField", "Value"))
            field.committed.connect(self._on_value)
            if isinstance(field, Line):
                field.refused.connect(self.refused)
            self._stack.addWidget(field)
        self._stack.setFixedHeight(px(28))
        line.addWidget(self._stack, 1)
        self.setFixedHeight(px(28))
        self.kind.setToolTip(self.tr("What sort of value it is."))

    def set_help(self, words: str) -> None:
        """What the tooltip of the value says."""
        self.setToolTip(words)
        for field in self._fields.values():
            if isinstance(field, Line):
                field.set_help(words)
            else:
                field.setToolTip(words)

    @property
    def value_field(self) -> Line | Choice:
        """The field of the present kind."""
        return self._fields[kind_of(self._value)]

    def show_value(self, value: Any) -> None:
        self._value = value
        kind = kind_of(value)
        self.kind.show_value(kind)
        field = self._fields[kind]
        self._stack.setCurrentWidget(field)
        field.show_value(value)

    def _on_kind(self, kind: str) -> None:
        self.committed.emit(as_kind(self._value, kind))

    def _on_value(self, value: Any) -> None:
        if value != self._value or type(value) is not type(self._value):
            self.committed.emit(value)
