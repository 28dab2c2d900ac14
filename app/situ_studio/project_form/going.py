"""From a line of ``situ.toml`` to the field of the form that shows it."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, Qt, QTimer
from PySide6.QtWidgets import QApplication, QWidget

from situ_studio.project_form.boxes import FieldsSection, RowsSection, Section

if TYPE_CHECKING:
    from situ_studio.project_form.form import ProjectForm

HEADER = re.compile(r"""\s*\[+\s*["']?([^\]"']+)["']?\s*\]""")
KEY = re.compile(r"""\s*(?:"([^"]+)"|'([^']+)'|([\w-]+(?:\.[\w-]+)*))\s*=""")
SECTIONS = {
    "robot": "robot",
    "tags": "tags",
    "setting": "settings",
    "durable": "durable",
    "privacy": "private",
    "places": "places",
    "mqtt": "mqtt",
}
"""By table, the section that shows it."""
ROWS_BY_KEY = ("tags", "places")
"""Tables of which each key is a row, in their order."""


def go_to_line(form: ProjectForm, text: str, line: int) -> None:
    """Gives the field of what stands in a line of the shown file the focus, and shows it."""
    found = field_at(form, text, line)
    if found is not None:
        QTimer.singleShot(0, form, lambda: _show(form, found))
        first = found.plus if isinstance(found, Section) and found.plus.isVisible() else found
        first.setFocus(Qt.FocusReason.OtherFocusReason)


def _show(form: ProjectForm, field: QWidget) -> None:
    # A form that was not seen before gets widths first, heights from them, and only then scrolls.
    for _ in range(3):
        QApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest)
    form.area.ensureWidgetVisible(field, 24, 24)


def written_at(text: str, line: int) -> tuple[str, str, int]:
    """What stands in a line, from 1: its table, its key, and which row of its table it is.

    Of ``[[setting]]`` each table is a row, of others each key.
    """
    table = key = ""
    headers: dict[str, int] = {}
    row = -1
    for one in text.split("\n")[: max(line, 0)]:
        header, found = HEADER.match(one), KEY.match(one)
        if found is not None:
            key = next(part for part in found.groups() if part is not None)
            row += table != "setting"
        elif header is not None:
            table, key, row = header[1].strip(), "", -1
            headers[table] = headers.get(table, -1) + 1
            if table == "setting":
                row = headers[table]
    return table, key, row


def field_at(form: ProjectForm, text: str, line: int) -> QWidget | None:
    """The field of what stands in a line; its section where it has none, None: no section."""
    table, key, row = written_at(text, line)
    if table == "project":
        fields = form.sections["project"]
        assert isinstance(fields, FieldsSection)
        if key in ("applications", "languages"):
            return form.sections[key]
        return fields.fields.get((table, key), fields)
    section = form.sections.get(SECTIONS.get(table, ""))
    if isinstance(section, FieldsSection):
        return section.fields.get((table, key), section)
    by_row = table == "setting" or table in ROWS_BY_KEY
    if isinstance(section, RowsSection) and by_row and 0 <= row < len(section.rows):
        return section.rows.field(row, 0)
    return section
