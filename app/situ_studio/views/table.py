"""The views of a document, in one table: a new view is a row here, and a piece that it shows.

Segments above the canvas, menu, keys and the command palette are made from it. A view is made of
pieces beside each other, or one above the other. A piece is a widget that shows a document and
tells what a person does in it:

- ``show_document(document, problems)`` brings it up to date; ``select(places)`` shows a selection
  without telling it; ``set_theme(theme)``;
- ``edited(document, str)`` tells a new value and the name of the step, ``selection_changed(tuple)``
  the places that a person selected. Where it has them, ``activated(place)``, ``status(str)``,
  ``menu_requested(places, point)``, ``mends_asked()``, ``filled_in(place)``,
  ``work_begun(words, job)`` and ``part_asked(corner, exit)`` are heard too, and ``set_live`` is
  called; what it says to be ``supposed(live)`` the others show, too.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from msgspec import Struct

from situ.document.modules import Modules
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ_studio.edits.edit import Document
from situ_studio.screens.media_import import home_of

if TYPE_CHECKING:
    from PySide6.QtWidgets import QWidget

    from situ.document.project import Project
    from situ_studio.looks.theme import Theme


class Setting(Struct, frozen=True):
    """What a piece is made in.

    project: the project as it is at the time of the call, None while there is none.
    """

    document: Document
    theme: Theme
    parent: QWidget | None
    project: Callable[[], Project | None] = lambda: None

    def media(self) -> Path | None:
        """The folder from which the project names its pictures, at the time of the call."""
        project = self.project()
        return home_of(project) if project is not None else None


class View(Struct, frozen=True, kw_only=True):
    """One way of showing a document.

    kinds: of the documents that can be shown so. pieces: of ``PIECES``; the first one is what
    commands go to. shares: of the room, for a start. upright: the pieces lie one above the other.
    """

    name: str
    icon: str
    text: str
    key: str
    kinds: tuple[type[Any], ...]
    pieces: tuple[str, ...]
    shares: tuple[int, ...] = (1,)
    upright: bool = False
    tip: str = ""


VIEWS: tuple[View, ...] = (
    View(
        name="graph",
        icon="graph",
        text="Graph",
        key="Ctrl+1",
        kinds=(Application, Spds),
        pieces=("graph",),
    ),
    View(
        name="split",
        icon="split",
        text="Split",
        key="Ctrl+3",
        kinds=(Application,),
        pieces=("graph", "screen"),
        shares=(3, 2),
        tip="The graph, and beside it the screen of the selected state",
    ),
    View(
        name="screen",
        icon="screen",
        text="Screen",
        key="Ctrl+4",
        kinds=(Application,),
        pieces=("designer",),
        tip="The screen of the selected state, drawn to scale",
    ),
    View(
        name="both",
        icon="both",
        text="Both",
        key="Ctrl+5",
        kinds=(Spds,),
        pieces=("graph", "matrix"),
        shares=(1, 1),
        upright=True,
        tip="The graph, and below it the priorities as a table",
    ),
    View(
        name="matrix",
        icon="matrix",
        text="Matrix",
        key="Ctrl+6",
        kinds=(Spds,),
        pieces=("matrix",),
        tip="Situations and modules as a table of priorities",
    ),
    View(
        name="outline",
        icon="table",
        text="Outline",
        key="Ctrl+2",
        kinds=(Application, Spds, Modules),
        pieces=("outline",),
    ),
)
"""In the order in which they are offered; a document is shown as the first that it can be."""


def views_of(document: Document | None) -> tuple[View, ...]:
    """What a document can be shown as."""
    return tuple(view for view in VIEWS if isinstance(document, view.kinds))


def _graph(setting: Setting) -> Any:
    # NodeGraphQt takes a third of a second to import: only when a graph is shown.
    if isinstance(setting.document, Application):
        from situ_studio.canvas.application import ApplicationCanvas

        return ApplicationCanvas(setting.theme, setting.parent)
    from situ_studio.canvas.script import ScriptCanvas

    return ScriptCanvas(setting.theme, setting.parent, setting.project)


def _outline(setting: Setting) -> Any:
    from situ_studio.panels.twin import Twin

    return Twin(setting.theme, setting.parent, setting.project)


def _screen(setting: Setting) -> Any:
    from situ_studio.panels.beside import ScreenBeside

    return ScreenBeside(setting.theme, setting.media, setting.parent)


def _designer(setting: Setting) -> Any:
    from situ_studio.screens.designer import Designer

    return Designer(setting.theme, setting.project, setting.media, setting.parent)


def _matrix(setting: Setting) -> Any:
    from situ_studio.matrix.view import MatrixView

    return MatrixView(setting)


PIECES: dict[str, Callable[[Setting], Any]] = {
    "graph": _graph,
    "matrix": _matrix,
    "outline": _outline,
    "screen": _screen,
    "designer": _designer,
}
"""By name, what makes the pieces of which the views are made. In a view they lie in this order."""
