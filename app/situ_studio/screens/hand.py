"""The mouse on a sheet: what was pressed, when that is a drag, and what a click selects."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QPointF, Qt

from situ_studio.screens.drags import Banding, Held, Moving, Proposal, Resizing
from situ_studio.screens.placing import Box

if TYPE_CHECKING:
    from situ_studio.screens.sheet import Sheet

SLACK = 4.0
"""How far the mouse goes, in px, before a press is a drag."""
ALT = Qt.KeyboardModifier.AltModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
MORE = SHIFT | Qt.KeyboardModifier.ControlModifier
"""With one of these a click adds to what is selected, or takes from it."""
CURSORS = {
    "nw": Qt.CursorShape.SizeFDiagCursor,
    "se": Qt.CursorShape.SizeFDiagCursor,
    "ne": Qt.CursorShape.SizeBDiagCursor,
    "sw": Qt.CursorShape.SizeBDiagCursor,
    "n": Qt.CursorShape.SizeVerCursor,
    "s": Qt.CursorShape.SizeVerCursor,
    "e": Qt.CursorShape.SizeHorCursor,
    "w": Qt.CursorShape.SizeHorCursor,
}


class Hand:
    """One for a sheet. A click again at the same place goes through what lies there one over the
    other, and so does one with Alt.
    """

    def __init__(self, sheet: Sheet) -> None:
        self._sheet = sheet
        self._start: QPointF | None = None
        self._held = Qt.KeyboardModifier.NoModifier
        self._handle = ""
        self._drag: Moving | Resizing | Banding | None = None
        self._proposal: Proposal | None = None
        self._before: tuple[str, ...] = ()
        self._last: tuple[QPointF, tuple[str, ...]] | None = None
        """Where was clicked last, and what was selected by that."""
        self._again = False
        """It is pressed where it was clicked before."""

    @property
    def band(self) -> Box | None:
        """The rubber band, while there is one."""
        return self._drag.box if isinstance(self._drag, Banding) else None

    @property
    def moves(self) -> bool:
        """Whether components go with the mouse, as large as they are."""
        return isinstance(self._drag, Moving)

    def press(self, at: QPointF, held: Qt.KeyboardModifier) -> None:
        sheet = self._sheet
        self.cancel()
        self._start, self._held, self._before = at, held, sheet.selected
        self._handle = sheet.handle_under(at)
        self._again = (
            self._last is not None
            and (self._last[0] - at).manhattanLength() < SLACK
            and self._last[1] == sheet.selected
        )
        under = sheet.under(at)
        if self._handle or set(under) & set(sheet.selected) or held & ALT:
            # What is selected may be dragged; what a mere click means is known at its end.
            return
        if under:
            sheet.choose((*sheet.selected, under[0]) if held & MORE else (under[0],))
        elif not held & MORE and sheet.selected:
            sheet.choose(())

    def move(self, at: QPointF, held: Qt.KeyboardModifier) -> None:
        sheet = self._sheet
        if self._start is None:
            handle = sheet.handle_under(at)
            sheet.setCursor(CURSORS.get(handle, Qt.CursorShape.ArrowCursor))
            return
        way = at - self._start
        if self._drag is None and way.manhattanLength() < SLACK:
            return
        if self._drag is None:
            self._drag = self._begin()
        if isinstance(self._drag, Banding):
            sheet.select(self._drag.at(*sheet.scale.percent(at), sheet.own()))
            sheet.update()
            return
        dx, dy = sheet.scale.percent(way)
        keys = Held(free=bool(held & ALT), straight=bool(held & SHIFT))
        self._proposal = self._drag.at(dx, dy, keys)
        sheet.propose(self._proposal)

    def _begin(self) -> Moving | Resizing | Banding:
        sheet = self._sheet
        assert self._start is not None
        boxes = sheet.selected_boxes()
        if self._handle:
            return Resizing(boxes, sheet.others(boxes), self._handle, sheet.guides)
        under = sheet.under(self._start)
        if under and not set(under) & set(boxes):
            # With Alt nothing was selected yet.
            sheet.choose((under[0],))
            boxes = sheet.selected_boxes()
        if under:
            return Moving(boxes, sheet.others(boxes), sheet.guides)
        kept = self._before if self._held & MORE else ()
        return Banding(*sheet.scale.percent(self._start), kept)

    def release(self) -> None:
        sheet, start, drag, proposal = self._sheet, self._start, self._drag, self._proposal
        self._end()
        if start is None:
            return
        if isinstance(drag, Banding):
            sheet.choose(sheet.selected)
        elif proposal is not None:
            text = sheet.tr("Resize {0}") if self._handle else sheet.tr("Move {0}")
            sheet.place(proposal.boxes, text)
        elif not self._handle:
            self._click(start)
            self._last = start, sheet.selected

    def _click(self, at: QPointF) -> None:
        """A press without a way, of something that was selected before, or with Alt."""
        sheet = self._sheet
        under, selected = sheet.under(at), self._before
        there = [id for id in under if id in selected]
        if self._held & ALT or (self._again and len(selected) == 1 and not self._held & MORE):
            if under:
                at_now = under.index(there[0]) if there else -1
                self._choose((under[(at_now + 1) % len(under)],))
        elif there and self._held & MORE:
            self._choose(tuple(id for id in selected if id != there[0]))
        elif there:
            self._choose((there[0],))

    def _choose(self, ids: tuple[str, ...]) -> None:
        if ids != self._sheet.selected:
            self._sheet.choose(ids)

    def double(self, at: QPointF) -> None:
        """What was selected is opened, though the first one of both clicks went through it."""
        sheet = self._sheet
        self.cancel()
        self._last = None
        under = sheet.under(at)
        if under:
            id = next(i for i in (*self._before, *sheet.selected, under[0]) if i in under)
            self._choose((id,))
            sheet.open(id)

    def cancel(self) -> bool:
        """Leaves everything as it was before the press; whether there was a drag."""
        drag, before = self._drag, self._before
        self._end()
        if isinstance(drag, Banding):
            self._sheet.select(before)
            self._sheet.chosen.emit(before)
        return drag is not None

    def _end(self) -> None:
        changed = self._drag is not None
        self._start = self._drag = self._proposal = None
        if changed:
            self._sheet.propose(None)
