"""Which value to set on a robot's blackboard: a tag, and a value as its type has them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from msgspec import Struct
from PySide6.QtWidgets import (
    QDialog,
    QHBoxLayout,
    QLabel,
    QVBoxLayout,
    QWidget,
)

from situ.decide.values import in_text
from situ.document.spds import DataType
from situ.document.values import is_number, read
from situ_studio.edits.vocabulary import Vocabulary
from situ_studio.looks.letters import px
from situ_studio.panels.fields import Line
from situ_studio.widgets.dialog_buttons import add_buttons
from situ_studio.widgets.named_box import NamedBox
from situ_studio.wording.language import tr

BOOLEANS = (True, False, None)


class Setting(Struct, frozen=True):
    """A value for a tag; None removes the tag."""

    tag: str
    value: Any


class SettingDialog(QDialog):
    """``setting``: the answer as it stands, None while there is none. now: what the robot's
    blackboard has; its tags are offered as the project's are.
    """

    def __init__(self, vocabulary: Vocabulary, now: Mapping[str, Any], parent: QWidget) -> None:
        super().__init__(parent)
        self._vocabulary, self._now = vocabulary, now
        self.setWindowTitle(self.tr("Set a value"))
        self.resize(px(400), px(200))
        column = QVBoxLayout(self)
        column.addWidget(self._titled(self.tr("Tag")))
        self.tag = Line()
        self.tag.setAccessibleName(self.tr("Tag"))
        self.tag.complete_from(tuple(sorted({*vocabulary.tags, *now})))
        column.addWidget(self.tag)
        column.addWidget(self._titled(self.tr("Value")))
        line = QHBoxLayout()
        self.value = Line()
        self.value.setAccessibleName(self.tr("Value"))
        self.value.setPlaceholderText(self.tr("nothing: removes it"))
        self.choice = NamedBox()
        self.choice.setAccessibleName(self.tr("Value"))
        self.choice.addItems([self.tr("yes"), self.tr("no"), self.tr("nothing: removes it")])
        self.unit = QLabel()
        self.unit.setProperty("role", "label")
        line.addWidget(self.value, 1)
        line.addWidget(self.choice, 1)
        line.addWidget(self.unit)
        column.addLayout(line)
        self.told = QLabel()
        self.told.setProperty("role", "words")
        self.told.setWordWrap(True)
        column.addWidget(self.told)
        column.addStretch(1)
        self.set_button = add_buttons(self, column, self.tr("Set"), self.accept)
        self.tag.textChanged.connect(self._settle)
        self.value.textChanged.connect(self._settle)
        self.tag.setFocus()
        self._settle()

    def _titled(self, title: str) -> QLabel:
        label = QLabel(title)
        label.setProperty("role", "strong")
        return label

    @property
    def setting(self) -> Setting | None:
        tag, kind = self._tag, self._kind
        if not tag:
            return None
        if kind == "boolean":
            return Setting(tag, BOOLEANS[self.choice.currentIndex()])
        try:
            return Setting(tag, value_of(self.value.text(), kind))
        except ValueError:
            return None

    @property
    def _tag(self) -> str:
        return self.tag.text().strip()

    @property
    def _kind(self) -> DataType | None:
        """As the project says; else as the value is that the robot has."""
        kind, _ = self._vocabulary.type_of(self._tag)
        value = self._now.get(self._tag)
        if kind is None and isinstance(value, bool):
            return "boolean"
        return "number" if kind is None and is_number(value) else kind

    def _settle(self) -> None:
        kind, (_, unit) = self._kind, self._vocabulary.type_of(self._tag)
        self.choice.setVisible(kind == "boolean")
        self.value.setVisible(kind != "boolean")
        self.unit.setText(unit)
        self.unit.setVisible(bool(unit) and kind != "boolean")
        wanted = self.setting
        self.set_button.setEnabled(wanted is not None)
        if self._tag and wanted is None:
            self.told.setText(_wanted(kind))
        elif self._tag in self._now:
            self.told.setText(self.tr("It is {0} now.").format(in_text(self._now[self._tag])))
        else:
            self.told.setText(self.tr("It is not set now.") if self._tag else "")


def value_of(text: str, kind: DataType | None) -> Any:
    """A value as a person types it, None where nothing is typed. Of a known type it is one of
    these, or ValueError; else what it reads as: numbers, ``true``, lists, objects, or text.
    """
    text = text.strip()
    if not text:
        return None
    value = text if kind == "text" else read(text)
    fits = {
        "number": is_number(value),
        "boolean": isinstance(value, bool),
        "list": isinstance(value, list),
        "object": isinstance(value, dict),
    }
    if not fits.get(kind or "", True):
        raise ValueError(text)
    return value


def _wanted(kind: DataType | None) -> str:
    return {
        "list": tr("Write a list, like [1, 2]."),
        "object": tr('Write an object, like {"x": 1}.'),
    }.get(kind or "", tr("Write a number."))
