"""One document in the middle of the window: its graph and its outline twin, one of them shown."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QPoint, Signal
from PySide6.QtWidgets import QStackedWidget, QWidget

from situ.document.problem import Problem
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ_studio.copying import Copying
from situ_studio.edit import Document, Place
from situ_studio.panels.twin import Twin
from situ_studio.theme import Theme


def make_canvas(document: Document, theme: Theme, parent: QWidget | None) -> Any:
    """The canvas for a document; None where its kind has none."""
    # NodeGraphQt takes a third of a second to import: only when a graph is shown.
    if isinstance(document, Application):
        from situ_studio.canvas.application import ApplicationCanvas

        return ApplicationCanvas(theme, parent)
    if isinstance(document, Spds):
        from situ_studio.canvas.script import ScriptCanvas

        return ScriptCanvas(theme, parent)
    return None


class DocumentView(QStackedWidget):
    """Graph and outline of one file; both tell through the same signals."""

    edited = Signal(object, str)
    selection_changed = Signal(tuple)
    activated = Signal(tuple)
    status = Signal(str)
    menu_requested = Signal(tuple, QPoint)
    """A context menu is wanted: of what, and where on the screen."""
    zoomed = Signal()
    part_asked = Signal(object, tuple)
    """A part was dropped: where its card's corner shall be, and the exit into whose pipe."""

    origin: str
    """The path of the file, for what is copied from here."""

    def __init__(self, theme: Theme, file: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.file = file
        self.origin = ""
        self.selected: tuple[Place, ...] = ()
        self._theme = theme
        self._document: Document | None = None
        self._problems: list[Problem] = []
        self._canvas: Any = None
        self._twin: Twin | None = None
        self._split = False
        self._live: Any = None
        self._mode = "graph"
        self._fresh: set[str] = set()
        self._telling = False

    @property
    def mode(self) -> str:
        """``graph`` or ``outline``."""
        return self._mode

    @property
    def shown_as(self) -> str:
        """``graph``, ``split`` (the window shows the state's screen beside it) or ``outline``."""
        return "split" if self._split and self._mode == "graph" else self._mode

    @property
    def ways_to_show(self) -> tuple[str, ...]:
        """What ``shown_as`` can be for this document."""
        if isinstance(self._document, Application):
            return "graph", "split", "outline"
        return ("graph", "outline") if self.has_graph else ("outline",)

    @property
    def problems(self) -> list[Problem]:
        """The problems that are shown."""
        return self._problems

    @property
    def has_graph(self) -> bool:
        """Whether documents of this kind have a graph."""
        return isinstance(self._document, Application | Spds)

    @property
    def canvas(self) -> Any:
        """The graph's widget; None before it was first shown."""
        return self._canvas

    @property
    def twin(self) -> Twin | None:
        """The outline's widget; None before it was first shown."""
        return self._twin

    def show_document(self, document: Document, problems: list[Problem]) -> None:
        """Shows a new value of the document; the hidden view gets it when it is shown."""
        self._document, self._problems = document, problems
        self._fresh = set()
        if not self.has_graph:
            self._mode = "outline"
        self._bring()

    def set_mode(self, mode: str) -> None:
        """Shows the document as ``graph``, ``split`` or ``outline``, if it can be shown so."""
        if mode not in self.ways_to_show:
            mode = self.ways_to_show[0]
        self._split = mode == "split"
        self._mode = "outline" if mode == "outline" else "graph"
        self._bring()

    def _bring(self) -> None:
        """Makes the shown view if need be, and brings it up to date."""
        if self._document is None:
            return
        shown = self.current_view()
        self.setCurrentWidget(shown)
        if self._mode in self._fresh:
            return
        self._fresh.add(self._mode)
        # What a view thinks to be selected while it takes a new value is not what a person chose.
        self._telling = True
        try:
            shown.show_document(self._document, self._problems)
            shown.select(self.selected)
        finally:
            self._telling = False

    def current_view(self) -> Any:
        """The view of the present mode, made at its first use."""
        assert self._document is not None
        if self._mode == "graph":
            if self._canvas is None:
                self._canvas = make_canvas(self._document, self._theme, self)
                self._add(self._canvas)
                self._canvas.viewer.clicked.connect(lambda *_: self._on_clicked())
                if isinstance(self._document, Application):
                    self._canvas.part_asked.connect(self.part_asked)
                if self._live is not None:
                    self._canvas.set_live(self._live)
            return self._canvas
        if self._twin is None:
            self._twin = Twin(self._theme, self)
            self._add(self._twin)
        return self._twin

    def _add(self, view: Any) -> None:
        if isinstance(view, Copying):
            view.origin = self.origin
        view.edited.connect(self.edited)
        view.selection_changed.connect(self._on_selection)
        view.activated.connect(self.activated)
        view.status.connect(self.status)
        if hasattr(view, "menu_requested"):
            view.menu_requested.connect(self.menu_requested)
        self.addWidget(view)

    def _on_selection(self, chosen: Any) -> None:
        if self._telling:
            return
        self.selected = tuple(tuple(p) for p in chosen)
        self._fresh &= {self._mode}
        self.selection_changed.emit(self.selected)

    def _on_clicked(self) -> None:
        """A click on the card of which a part is selected selects the card again."""
        chosen = self._canvas.selection()
        if chosen != self.selected and len(chosen) == 1 and len(self.selected) == 1:
            self._on_selection(chosen)

    def select(self, chosen: tuple[Place, ...]) -> None:
        """Shows this selection in the present view, and in the other one when it is shown."""
        self.selected = chosen
        if self._document is None:
            return
        self._fresh &= {self._mode}
        self._telling = True
        try:
            self.current_view().select(chosen)
        finally:
            self._telling = False

    def can(self, method: str) -> bool:
        """Whether the present view knows a method of the contract."""
        return self._document is not None and hasattr(self.current_view(), method)

    def call(self, method: str, *arguments: Any) -> Any:
        """Calls a method of the present view, if it has it."""
        if not self.can(method):
            return None
        return getattr(self.current_view(), method)(*arguments)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        for view in (self._canvas, self._twin):
            if view is not None:
                view.set_theme(theme)

    def set_live(self, live: Any) -> None:
        """What the robot does at the moment, or None."""
        self._live = live
        if self._canvas is not None:
            self._canvas.set_live(live)
