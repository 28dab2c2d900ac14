"""One document in the middle of the window, shown as one of the views that its kind has."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtWidgets import QApplication, QSplitter, QVBoxLayout, QWidget

from situ.document.problem import Problem
from situ.document.project import Project
from situ_studio.edits.edit import Document, Place
from situ_studio.looks.theme import Theme
from situ_studio.panels.twin import Twin
from situ_studio.views.table import PIECES, VIEWS, Setting, View, views_of


class DocumentView(QWidget):
    """The pieces of the views of one file; all tell through the same signals.

    project: as ``Setting`` has it. Pieces are made when they are first shown, and brought up to
    date when they are shown again.
    """

    edited = Signal(object, str)
    selection_changed = Signal(tuple)
    activated = Signal(tuple)
    status = Signal(str)
    menu_requested = Signal(tuple, QPoint)
    """A context menu is wanted: of what, and where on the screen."""
    mends_asked = Signal()
    module_dropped = Signal(str, tuple)
    part_asked = Signal(object, tuple)
    """A part was dropped: where its card's corner shall be, and the exit into whose pipe."""
    screen_asked = Signal(tuple)
    """The place whose screen is to be drawn, in the view made for it."""
    work_begun = Signal(str, object)
    """Something goes on beside the window: what, and the job (``processes.working.follow``)."""
    filled_in = Signal(tuple)
    """The place whose form is wanted."""
    media_asked = Signal(tuple, str, object)
    file_asked = Signal(tuple, str, QPoint)
    """A file is to be chosen, as ``StateScreen`` tells it."""

    origin: str
    """The path of the file, for what is copied from here."""

    def __init__(
        self,
        theme: Theme,
        file: str,
        parent: QWidget | None = None,
        project: Callable[[], Project | None] = lambda: None,
    ) -> None:
        super().__init__(parent)
        self.file = file
        self.origin = ""
        self.selected: tuple[Place, ...] = ()
        self._theme = theme
        self._project = project
        self._document: Document | None = None
        self._problems: list[Problem] = []
        self._pieces: dict[str, Any] = {}
        self._view = VIEWS[0]
        self._arranged: View | None = None
        self._shares: dict[str, list[int]] = {}
        self._live: Any = None
        self._supposed: Any = None
        self._fresh: set[str] = set()
        self._telling = False
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.room = QSplitter()
        self.room.setChildrenCollapsible(False)
        self.room.splitterMoved.connect(self._on_moved)
        column.addWidget(self.room)

    # -- what is shown ---------------------------------------------------------------

    @property
    def shown_as(self) -> str:
        """The name of the view that is shown."""
        return self._view.name

    @property
    def mode(self) -> str:
        """The name of the shown view's first piece: ``graph``, ``outline`` …"""
        return self._view.pieces[0]

    @property
    def ways_to_show(self) -> tuple[str, ...]:
        """What ``shown_as`` can be for this document."""
        return tuple(view.name for view in views_of(self._document))

    @property
    def problems(self) -> list[Problem]:
        """The problems that are shown."""
        return self._problems

    @property
    def has_graph(self) -> bool:
        """Whether documents of this kind have a graph."""
        return "graph" in self.ways_to_show

    def piece(self, name: str) -> Any:
        """A piece's widget; None before it was first shown."""
        return self._pieces.get(name)

    @property
    def shown_pieces(self) -> tuple[QWidget, ...]:
        """The widgets of the present view, as they lie."""
        return tuple(self._pieces[name] for name in self._view.pieces if name in self._pieces)

    @property
    def canvas(self) -> Any:
        """The graph's widget; None before it was first shown."""
        return self.piece("graph")

    @property
    def twin(self) -> Twin | None:
        """The outline's widget; None before it was first shown."""
        return self._pieces.get("outline")

    @property
    def shares(self) -> dict[str, list[int]]:
        """How a person has divided the room, by view, in px."""
        return dict(self._shares)

    def set_shares(self, shares: dict[str, list[int]]) -> None:
        """Divides the room as it was; nothing is changed for views that are not in ``shares``."""
        self._shares |= shares
        self._divide()

    # -- showing ---------------------------------------------------------------------

    def show_document(self, document: Document, problems: list[Problem]) -> None:
        """Shows a new value of the document; what is hidden gets it when it is shown."""
        self._document, self._problems = document, problems
        self._fresh = set()
        if self.shown_as not in self.ways_to_show:
            self._view = views_of(document)[0]
        self._bring()

    def set_mode(self, name: str) -> None:
        """Shows the document as the view of that name, if it can be shown so."""
        offered = {view.name: view for view in views_of(self._document)}
        if not offered:
            return
        self._view = offered.get(name, next(iter(offered.values())))
        self._bring()

    def _bring(self) -> None:
        """Makes the pieces of the shown view if need be, and brings them up to date."""
        if self._document is None:
            return
        self._arrange(self._view)
        for name in self._view.pieces:
            if name in self._fresh:
                continue
            self._fresh.add(name)
            # What a piece thinks to be selected while it takes a new value is not what a person
            # chose.
            with _Telling(self):
                self._pieces[name].show_document(self._document, self._problems)
                self._pieces[name].select(self.selected)

    def _arrange(self, view: View) -> None:
        if self._arranged is view:
            return
        self._arranged = view
        upright = Qt.Orientation.Vertical if view.upright else Qt.Orientation.Horizontal
        self.room.setOrientation(upright)
        for name in view.pieces:
            self._made(name).show()
        gone = [piece for name, piece in self._pieces.items() if name not in view.pieces]
        focus = QApplication.focusWidget()
        if focus is not None and any(piece.isAncestorOf(focus) for piece in gone):
            # Else Qt gives it to anything in the window.
            self.current_view().setFocus()
        for piece in gone:
            piece.hide()
        if self._supposed is not None:
            self._show_live()
        self._divide()

    def _divide(self) -> None:
        """Gives the shown pieces their shares of the room."""
        view = self._view
        wanted = self._shares.get(view.name)
        if wanted is None or len(wanted) != len(view.pieces):
            wanted = [1000 * share for share in view.shares]
        shares = dict(zip(view.pieces, wanted, strict=True))
        every = [shares.get(name, 0) for name in self._lying()]
        self.room.setSizes(every)
        for at, share in enumerate(every):
            self.room.setStretchFactor(at, share)

    def _on_moved(self) -> None:
        sizes = dict(zip(self._lying(), self.room.sizes(), strict=True))
        self._shares[self._view.name] = [sizes[name] for name in self._view.pieces]

    def _lying(self) -> list[str]:
        """The pieces that there are, as they lie: in the order of ``PIECES``."""
        return [name for name in PIECES if name in self._pieces]

    def current_view(self) -> Any:
        """The first piece of the present view, made at its first use."""
        return self._made(self.mode)

    def _made(self, name: str) -> Any:
        piece = self._pieces.get(name)
        if piece is None:
            assert self._document is not None
            setting = Setting(self._document, self._theme, self, self._project)
            piece = self._pieces[name] = PIECES[name](setting)
            self.room.insertWidget(self._lying().index(name), piece)
            self._add(name, piece)
        return piece

    def _add(self, name: str, piece: Any) -> None:
        if hasattr(piece, "origin"):
            piece.origin = self.origin
        piece.edited.connect(self.edited)
        piece.selection_changed.connect(self._on_selection)
        for heard in (
            "activated",
            "status",
            "menu_requested",
            "mends_asked",
            "module_dropped",
            "part_asked",
            "filled_in",
            "media_asked",
            "file_asked",
            "screen_asked",
            "work_begun",
        ):
            if hasattr(piece, heard):
                getattr(piece, heard).connect(getattr(self, heard))
        if name == "graph":
            piece.viewer.clicked.connect(lambda *_: self._on_clicked())
        if hasattr(piece, "supposed"):
            piece.supposed.connect(self._on_supposed)
        if self._live is not None and hasattr(piece, "set_live"):
            piece.set_live(self._live)

    # -- the selection ----------------------------------------------------------------

    def _on_selection(self, chosen: Any) -> None:
        if self._telling:
            return
        self.selected = tuple(tuple(p) for p in chosen)
        told = self.sender()
        self._tell({name for name in self._view.pieces if self._made(name) is not told})
        self.selection_changed.emit(self.selected)

    def _on_clicked(self) -> None:
        """A click on the card of which a part is selected selects the card again."""
        chosen = self.canvas.selection()
        if chosen != self.selected and len(chosen) == 1 and len(self.selected) == 1:
            self._on_selection(chosen)

    def select(self, chosen: tuple[Place, ...]) -> None:
        """Shows this selection in the present view, and in others when they are shown."""
        self.selected = chosen
        if self._document is not None:
            self._tell(set(self._view.pieces))

    def bring_selected(self) -> None:
        """Moves each piece that is shown as far as needed so that what is selected is seen."""
        for name in self._view.pieces if self.selected else ():
            bring = getattr(self._made(name), "bring_into_view", None)
            if bring is not None:
                bring(self.selected)

    def _tell(self, names: set[str]) -> None:
        """Tells the selection to these pieces now, to those that are hidden when they come."""
        self._fresh &= set(self._view.pieces)
        with _Telling(self):
            for name in self._view.pieces:
                if name in names:
                    self._made(name).select(self.selected)

    # -- what commands ask for ----------------------------------------------------------

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
        for piece in self._pieces.values():
            piece.set_theme(theme)

    def set_live(self, live: Any) -> None:
        """What the robot does at the moment, or None."""
        self._live = live
        self._show_live()

    def _on_supposed(self, supposed: Any) -> None:
        if supposed is not None or self._supposed is not None:
            self._supposed = supposed
            self._show_live()

    def _show_live(self) -> None:
        """A robot goes before what is supposed, which is marked only where it can be seen."""
        supposes = any(hasattr(self._pieces.get(name), "supposed") for name in self._view.pieces)
        shown = self._live if self._live is not None else self._supposed if supposes else None
        for piece in self._pieces.values():
            if hasattr(piece, "set_live"):
                piece.set_live(shown)


class _Telling:
    """While it lasts, what a piece tells of its selection is what it was told."""

    def __init__(self, view: DocumentView) -> None:
        self._view = view

    def __enter__(self) -> None:
        self._before, self._view._telling = self._view._telling, True

    def __exit__(self, *_: object) -> None:
        self._view._telling = self._before
