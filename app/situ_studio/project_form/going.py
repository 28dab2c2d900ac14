"""From a place in ``situ.toml`` to the field of the form that shows it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, Qt, QTimer
from PySide6.QtWidgets import QApplication, QWidget

from situ_studio.edits.edit import Place
from situ_studio.project_form.boxes import FieldsSection, RowsSection, Section

if TYPE_CHECKING:
    from situ_studio.project_form.form import ProjectForm

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
SETTING_COLUMNS = {"label": 0, "tag": 1, "type": 2, "choices": 3}


def go_to_place(form: ProjectForm, place: Place) -> None:
    """Gives the field of what stands at a place of the shown file the focus, and shows it."""
    found = field_at(form, place)
    if found is not None:
        QTimer.singleShot(0, form, lambda: _show(form, found))
        first: QWidget = found
        if isinstance(found, Section) and found.plus.isVisible():
            first = found.plus
        first.setFocus(Qt.FocusReason.OtherFocusReason)


def _show(form: ProjectForm, field: QWidget) -> None:
    # A form that was not seen before gets widths first, heights from them, and only then scrolls.
    for _ in range(3):
        QApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest)
    form.area.ensureWidgetVisible(field, 24, 24)


def field_at(form: ProjectForm, place: Place) -> QWidget | None:
    """The field of what stands at a place; its section where it has none, None: no section."""
    table, key = place[0] if place else "", place[1] if len(place) > 1 else ""
    if table == "readings":
        return form.readings
    listed = table == "project" and key in ("applications", "languages")
    section = form.sections.get(key if listed else SECTIONS.get(table, table))
    if isinstance(section, FieldsSection):
        return section.field_of(table, key) or section
    if isinstance(section, RowsSection):
        row, column = section.row_of(place), 0
        if table == "setting":
            column = SETTING_COLUMNS.get(place[2] if len(place) > 2 else "", 0)
        if row is not None and row < len(section.rows):
            return section.rows.field(row, column)
    return section
