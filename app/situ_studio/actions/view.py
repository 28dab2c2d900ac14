"""The views of a document and how near they are: the View menu."""

from __future__ import annotations

from typing import Any

from situ.document.folder import PROJECT_FILE, TEXTS_FOLDER
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ_studio.actions.command import Command, row
from situ_studio.views.table import VIEWS

_ONLY: dict[tuple[type[Any], ...], str] = {
    (Application,): "is_application",
    (Spds,): "is_script",
    (Application, Spds): "has_graph",
}
"""The condition of a view that is not of every kind of document."""

_VIEWS = tuple(
    row(
        f"view.{view.name}",
        view.text,
        "show_view",
        argument=view.name,
        icon=view.icon,
        shortcut=view.key,
        menu="View",
        when=_ONLY.get(view.kinds, "has_document"),
        choice="view",
        checked="shows_view",
        tip=view.tip,
    )
    for view in VIEWS
)

VIEW: tuple[Command, ...] = (
    *_VIEWS,
    row(
        "open_beside",
        "Open beside",
        "open_beside",
        icon="beside",
        shortcut="Ctrl+\\",
        menu="View",
        when="has_document",
        tip="This document in a second group of tabs, beside the first.",
    ),
    row(
        "texts",
        "All texts",
        "show_page",
        argument=TEXTS_FOLDER,
        icon="language",
        shortcut="Ctrl+7",
        menu="View",
        when="has_pages",
        rule=True,
        tip="Every text of the project, spoken, shown and heard, with a column a language",
    ),
    row(
        "project_form",
        "The project",
        "show_page",
        argument=PROJECT_FILE,
        icon="folder",
        menu="View",
        when="has_pages",
        tip="Its name and languages, values at the start, settings for those who use the robot",
    ),
    row(
        "zoom_in",
        "Zoom in",
        "zoom_by",
        argument=1.25,
        icon="zoom_in",
        shortcut="Ctrl++",
        menu="View",
        when="on_graph",
        rule=True,
    ),
    row(
        "zoom_out",
        "Zoom out",
        "zoom_by",
        argument=0.8,
        icon="zoom_out",
        shortcut="Ctrl+-",
        menu="View",
        when="on_graph",
    ),
    row(
        "zoom_100",
        "Actual size",
        "zoom_to_actual_size",
        icon="zoom_actual",
        shortcut="Ctrl+0",
        menu="View",
        when="on_graph",
    ),
    row(
        "zoom_fit",
        "Show everything",
        "on_view",
        argument="zoom_to_fit",
        icon="fit",
        shortcut="Ctrl+9",
        menu="View",
        when="on_graph",
        contexts="ground",
    ),
    row(
        "zoom_selection",
        "Show the selection",
        "zoom_to_selection",
        icon="zoom_selection",
        shortcut="Ctrl+8",
        menu="View",
        when="has_selection",
        contexts="states thing",
    ),
    row(
        "reset_layout",
        "Reset layout",
        "reset_layout",
        icon="layers",
        menu="View",
        when="has_project",
        rule=True,
        tip="Every panel back to where it lies at first",
    ),
)
