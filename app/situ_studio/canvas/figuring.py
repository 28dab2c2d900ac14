"""Notes and frames of one canvas: dragged, resized, written on, added."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from PySide6.QtCore import QPointF, QRect

from situ.document.drawing import Frame, Note
from situ.document.rbd import Application
from situ_studio.canvas import figures, gestures
from situ_studio.canvas.figure_items import FigureItem
from situ_studio.canvas.figures import Area, Figure
from situ_studio.canvas.note_editor import NoteEditor
from situ_studio.edits.edit import Place
from situ_studio.edits.exchanged import draws_the_same

if TYPE_CHECKING:
    from situ_studio.canvas.application import ApplicationCanvas

Spot = tuple[float, float]


class Figuring:
    """shown: what is drawn, by uid. edit: makes an edit of a document and its name."""

    def __init__(self, canvas: ApplicationCanvas, edit: Callable[[Application, str], None]) -> None:
        self._canvas = canvas
        self._edit = edit
        self.shown: dict[str, Figure] = {}
        self._application: Application | None = None

    def show(self, application: Application) -> dict[str, Figure]:
        """What the application has drawn; what a hand was dragging counts no more."""
        for uid in self._canvas.viewer.touched:
            item = self._item(uid)
            if item is not None:
                item.forget_wanted()
        if not draws_the_same(self._application, application):
            self.shown = figures.shown(application, self.shown)
        self._application = application
        return self.shown

    def _item(self, uid: str) -> FigureItem | None:
        node = self._canvas.graph.nodes.get(uid)
        return node.view if node is not None and isinstance(node.view, FigureItem) else None

    def _areas(self) -> dict[str, Area]:
        cards = self._canvas.graph.cards.items()
        return {uid: (card.x, card.y, card.width, card.height) for uid, card in cards}

    # -- moving and resizing --------------------------------------------------------------

    def carry(self) -> None:
        """What lies in a frame that is dragged follows it."""
        viewer, nodes = self._canvas.viewer, self._canvas.graph.nodes
        frames = [self.shown[uid] for uid in viewer.touched if uid in self.shown]
        frames = [one for one in frames if one.kind == "frame"]
        if not frames:
            return
        areas = self._areas()
        for frame in frames:
            item = self._item(frame.uid)
            if item is None or item.wanted is not None:
                continue
            across, down = item.x() - frame.x, item.y() - frame.y
            for uid in figures.held(frame.area, areas):
                if uid in nodes:
                    nodes[uid].view.setPos(areas[uid][0] + across, areas[uid][1] + down)

    def with_held(self, to: Mapping[str, Spot]) -> dict[str, Spot]:
        """New places of some things, with what the frames among them hold."""
        found = dict(to)
        frames = [self.shown[u] for u in to if u in self.shown and self.shown[u].kind == "frame"]
        areas = self._areas() if frames else {}
        # The largest last: what lies in a frame in a frame goes with the outer one.
        for frame in sorted(frames, key=lambda one: one.width * one.height):
            across, down = found[frame.uid][0] - frame.x, found[frame.uid][1] - frame.y
            for uid in figures.held(frame.area, areas):
                found[uid] = areas[uid][0] + across, areas[uid][1] + down
        return found

    def arranged(self, application: Application, placed: Mapping[str, Spot]) -> Application:
        """The application with notes and frames where cards that are placed anew want them."""
        cards = {uid: area for uid, area in self._areas().items() if uid not in self.shown}
        every = tuple(self.shown.values())
        for uid, area in figures.arranged(every, cards, placed).items():
            application, _ = figures.put(application, self.shown[uid].place, area)
        return application

    def resized(self, application: Application) -> tuple[Application, str]:
        """What a hand has dragged an edge to, on the grid."""
        for uid in self._canvas.viewer.touched:
            item = self._item(uid)
            if item is None or item.wanted is None or uid not in self.shown:
                continue
            left, top = gestures.snap(item.wanted.left()), gestures.snap(item.wanted.top())
            right, bottom = gestures.snap(item.wanted.right()), gestures.snap(item.wanted.bottom())
            area = self._kept(self.shown[uid], (left, top, right - left, bottom - top))
            return figures.put(application, self.shown[uid].place, area)
        return application, ""

    @staticmethod
    def _kept(before: Figure, area: Area) -> Area:
        """Edges that were not dragged stay, also where they are not on the grid."""
        x, y, width, height = area
        left = before.x if abs(before.x - x) < gestures.GRID / 2 else x
        top = before.y if abs(before.y - y) < gestures.GRID / 2 else y
        right, bottom = before.x + before.width, before.y + before.height
        right = right if abs(right - x - width) < gestures.GRID / 2 else x + width
        bottom = bottom if abs(bottom - y - height) < gestures.GRID / 2 else y + height
        return left, top, right - left, bottom - top

    # -- writing ---------------------------------------------------------------------------

    def editor(self, uid: str) -> NoteEditor:
        """A field over a note, to write on it where it stands."""
        canvas, note = self._canvas, self.shown[uid]
        look = canvas.look
        corner = canvas.viewer.mapFromScene(QPointF(note.x, note.y))
        width = max(160, round(note.width * look.zoom))
        height = max(72, round(note.height * look.zoom))
        editor = NoteEditor(uid, note.text, look, canvas.viewer.viewport())
        editor.open_at(QRect(corner.x(), corner.y(), width, height))
        return editor

    def write(self, uid: str, text: str) -> None:
        self._edit(*figures.write(self._canvas.document, self.shown[uid].place, text))

    # -- adding ----------------------------------------------------------------------------

    def add(self, kind: str, at: QPointF | None = None, chosen: tuple[str, ...] = ()) -> Place:
        """A note or a frame, with its middle or corner at ``at``, else where there is room; a
        frame goes round what is chosen. Its place; its text can be written at once."""
        canvas = self._canvas
        made: Note | Frame
        if kind == "note":
            spot = at - QPointF(88, 36) if at is not None else canvas.free_spot()
            made = Note(x=gestures.snap(spot.x()), y=gestures.snap(spot.y()))
        else:
            areas = self._areas()
            if at is None and chosen:
                x, y, width, height = figures.around(areas[uid] for uid in chosen)
                made = Frame(x=x, y=y, width=width, height=height)
            else:
                spot = at if at is not None else canvas.free_spot()
                made = Frame(x=gestures.snap(spot.x()), y=gestures.snap(spot.y()))
        after, place, text = figures.add(canvas.document, made)
        self._edit(after, text)
        return place
