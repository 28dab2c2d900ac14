"""Where the cards of an application's drawing stand, and the edits that put them elsewhere."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from situ.document.rbd import Application
from situ_studio.canvas import gestures, layout
from situ_studio.canvas.arranging import Arranging
from situ_studio.canvas.figuring import Figuring
from situ_studio.canvas.projection import identified
from situ_studio.edits.edit import Place
from situ_studio.edits.exchanged import exchanged
from situ_studio.wording.language import tr

if TYPE_CHECKING:
    from situ_studio.canvas.application import ApplicationCanvas

AT_ONCE = 300
"""So many cards are arranged at once; more in a process of its own."""

Spot = tuple[float, float]


class Positions(QObject):
    """Of one canvas. laid: where cards without a place in the file are shown, by uid; they keep it
    while they are shown. edit: makes an edit of a document and its name.
    """

    def __init__(
        self,
        canvas: ApplicationCanvas,
        figuring: Figuring,
        edit: Callable[[Application, str], None],
    ) -> None:
        super().__init__(canvas)
        self._canvas, self._figuring, self._edit = canvas, figuring, edit
        self.laid: dict[str, Spot] = {}
        self._shown: Application | None = None
        self.arranging = Arranging(self)
        self.arranging.refused.connect(canvas.status)
        self.arranging.done.connect(self._on_arranged)

    def lay_out_new(self) -> None:
        """Cards that came without a place get one."""
        document = self._canvas.document
        parts = exchanged(self._shown, document)
        self._shown = document
        if parts is not None and all(one.new.aside.position is not None for one in parts):
            return
        if any(
            value.aside.position is None and uid not in self.laid
            for uid, value in identified(document)
        ):
            self.laid.update(layout.missing(document, self.laid))

    def _unplaced(self) -> dict[Place, Spot]:
        """Where cards without a place in the file are shown: they stay when one is moved."""
        return {
            self._canvas.face(uid).place: self.laid[uid]
            for uid, value in identified(self._canvas.document)
            if uid in self.laid and value.aside.position is None
        }

    def pinned(self) -> Application:
        """The document with a place for every card: what is shown stays where it is."""
        return gestures.move(self._canvas.document, self._unplaced())[0]

    # -- moving ------------------------------------------------------------------------

    def moved(self, to: Mapping[str, Spot]) -> tuple[Application, str]:
        """Cards, notes and frames at other places, by uid, on the grid."""
        return self._put({u: (gestures.snap(x), gestures.snap(y)) for u, (x, y) in to.items()})

    def _put(self, to: Mapping[str, Spot]) -> tuple[Application, str]:
        """With what lies in the frames among them."""
        document, face = self._canvas.document, self._canvas.face
        every = {uid: (face(uid), at) for uid, at in self._figuring.with_held(to).items()}
        changed = {one.place: at for one, at in every.values() if (one.x, one.y) != at}
        if not changed:
            return document, ""
        after, text = gestures.move(document, changed)
        if len(to) == 1:
            one = gestures.called(document, face(next(iter(to))).place)
            text = tr("Move {0}").format(one)
        return gestures.move(after, {**self._unplaced(), **changed})[0], text

    def nudge(self, across: int, down: int) -> None:
        """The selected ones, by steps of the grid."""
        to = {}
        for uid in self._canvas.selected_uids():
            face = self._canvas.face(uid)
            to[uid] = (face.x + across * gestures.GRID, face.y + down * gestures.GRID)
        self._edit(*self._put(to))

    def align(self, edge: str) -> None:
        """The selected ones; edge as ``ApplicationCanvas.align`` has it."""
        areas = {}
        for uid in self._canvas.selected_uids():
            face = self._canvas.face(uid)
            areas[face.place] = gestures.Area(face.x, face.y, face.width, face.height)
        self._edit(*gestures.align(self.pinned(), areas, edge))

    # -- all of them -------------------------------------------------------------------

    def arrange(self) -> None:
        """Every card by the automatic layout; one edit. Of many cards in a process, until when
        they stay where they are."""
        shape = layout.shape(self._canvas.document)
        if len(shape.heights) <= AT_ONCE:
            self._arrange(layout.place(shape))
            return
        self.arranging.start(shape)
        words = tr("Arranging {0} cards").format(f"{len(shape.heights):,}")
        self._canvas.work_begun.emit(words, self.arranging)

    def _on_arranged(self, placed: Mapping[str, Spot]) -> None:
        if placed.keys() == {uid for uid, _ in identified(self._canvas.document)}:
            self._arrange(placed)
        else:
            self._canvas.status.emit(
                tr("There are other cards now than those arranged: arrange them again")
            )

    def _arrange(self, placed: Mapping[str, Spot]) -> None:
        to = {self._canvas.face(uid).place: at for uid, at in placed.items()}
        after, text = gestures.move(self._canvas.document, to)
        after = self._figuring.arranged(after, placed)
        self._edit(after, tr("Arrange all cards") if text else "")
        self._canvas.zoom_to_fit()
