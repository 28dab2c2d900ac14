"""What a project is, written into its form: values, places, settings, patterns, messages."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLineEdit, QWidget
from tests.gui.drawing.forms import FormFiller, middle

from situ.document.datatypes import write_number

TITLES = {
    "text": "Text",
    "number": "Number",
    "time": "Time",
    "date": "Date",
    "boolean": "Yes or no",
    "choice": "Choice",
}


class ValuesFiller(FormFiller):
    """Fills in the form of the project; ``tables`` are those of ``situ.toml``."""

    def fill_project(self, tables: Mapping[str, Any]) -> None:
        self.run("The project")
        for key in ("endpoint", "adapter"):
            self.in_section("robot", key, tables.get("robot", {}).get(key))
        self.rows(
            "tags", [(name, *value_cells(one)) for name, one in tables.get("tags", {}).items()]
        )
        self.rows("durable", [(one,) for one in tables.get("durable", {}).get("tags", ())])
        self.rows("private", [(one,) for one in tables.get("privacy", {}).get("private", ())])
        places = tables.get("places", {}).items()
        self.rows("places", [(name, *map(write_number, one)) for name, one in places])
        messages = tables.get("mqtt", {})
        if "url" in messages:
            self.write_at(self.section("mqtt").broker, messages["url"])
        means = {"tag": "a value", "event": "an event"}
        heard = [(topic, *one.split(":", 1)) for topic, one in messages.get("in", {}).items()]
        self.rows("mqtt", [(topic, means[kind], name) for topic, kind, name in heard])
        self.rows("settings", [setting_cells(one) for one in tables.get("setting", ())])

    def in_section(self, section: str, key: str, wanted: str | None) -> None:
        """A single value; what the project has already is left."""
        field = self.section(section).field_of(section, key)
        if wanted is not None and isinstance(field, QLineEdit) and field.text() != wanted:
            self.write_at(field, wanted)

    def rows(self, section: str, wanted: Sequence[Sequence[str]]) -> None:
        """Each is begun with the section's plus, and written from cell to cell."""
        for row in wanted:
            plus = self.section(section).plus
            self.bring(plus)
            self.click_at(middle(plus))
            for at, text in enumerate(row):
                self.write(self.focus(), text)
                if at < len(row) - 1 or not isinstance(self.focus(), QLineEdit):
                    self.key(Qt.Key.Key_Tab)
                else:
                    self.key(Qt.Key.Key_Return)

    def write_at(self, field: QWidget, wanted: str) -> None:
        self.bring(field)
        self.click_at(middle(field))
        self.write(field, wanted)
        self.key(Qt.Key.Key_Return)

    def section(self, name: str) -> Any:
        return self.window.pages.page("situ.toml").sections[name]


def value_cells(value: Any) -> tuple[str, str]:
    """Its kind, and how it is written."""
    if isinstance(value, bool):
        return "Yes or no", "yes" if value else "no"
    if isinstance(value, (int, float)):
        return "Number", repr(value)
    if isinstance(value, str):
        return "Text", value
    return "List", json.dumps(value, ensure_ascii=False)


def setting_cells(one: Mapping[str, Any]) -> tuple[str, ...]:
    cells = (one["label"], one["tag"], TITLES[one.get("type", "text")])
    choices = one.get("choices")
    return (*cells, ", ".join(choices)) if choices else cells
