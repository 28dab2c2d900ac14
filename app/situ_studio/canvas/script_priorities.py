"""The priorities on a script's pipes: where they stand, those taken over, one being edited."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from PySide6.QtCore import QPointF, QRect

from situ.document.spds import Spds
from situ_studio.canvas.curves import CurvedPipe, InheritedPipe
from situ_studio.canvas.overlay import InPlace, priority_editor
from situ_studio.canvas.script_faces import OUT, ScriptPicture
from situ_studio.canvas.script_layout import Pills
from situ_studio.canvas.script_projection import inherited, keyed

PARTS = (0.62, 0.7, 0.54, 0.78, 0.46, 0.38, 0.86, 0.3, 0.22, 0.16)
"""Where along its pipe a priority may stand, the best first."""
OVER = (0.22, 0.28, 0.34, 0.4, 0.16, 0.46, 0.52, 0.58, 0.25)
"""The same for one that is taken over."""
ROOM = 12.0, 8.0
"""What a pill has free at its sides, above and below, where it can: small drawings enlarge it."""
LEAST, MOST = -(2**53), 2**53
"""What every program reads exactly."""


class Priorities:
    """Of one canvas. given: a priority was typed: situation, module and the number, or None for
    taken away. refused: why a text is none."""

    def __init__(
        self,
        canvas: Any,
        given: Callable[[str, str, int | None], None],
        refused: Callable[[str], None],
    ) -> None:
        self._canvas = canvas
        self._given = given
        self._refused = refused
        self._pills = Pills()
        self.taken_over: list[InheritedPipe] = []
        self.editor: InPlace | None = None

    # -- where they stand ---------------------------------------------------------------

    def begin(self) -> None:
        """All pipes get their way anew."""
        self._pills.clear()

    def forget(self, id: tuple[str, ...]) -> None:
        self._pills.remove(id)

    def place(self, pipe: CurvedPipe) -> None:
        """Finds a place for the priority of a pipe that has its way."""
        id = pipe.link.id
        self._pills.remove(id)
        if pipe.link.kind != "priority":
            return
        across, down = ROOM
        wide = (
            part
            for part in PARTS
            if self._pills.is_free(pipe.pill(part).adjusted(-across, -down, across, down))
        )
        part = next(wide, None)
        pipe.roomy = part is not None
        if part is None:
            part = next((one for one in PARTS if self._pills.is_free(pipe.pill(one))), PARTS[0])
        pipe.move_pill(part)
        self._pills.put(id, pipe.pill())

    # -- taken over ---------------------------------------------------------------------

    def show_taken_over(self, script: Spds, picture: ScriptPicture, chosen: Iterable[str]) -> None:
        """Dashed pipes for what the one chosen situation takes over; none for several."""
        canvas = self._canvas
        for item in self.taken_over:
            self._pills.remove(item)
            canvas.viewer.release_pipe(item)
            canvas.viewer.release_pipe(item.way)
        self.taken_over = []
        keys = [k for k in chosen if picture.cards[k].kind == "situation"]
        if len(keys) != 1:
            return
        key = keys[0].removeprefix("situation ")
        situation = next((s for s, name in keyed(script) if name == key), None)
        for value in inherited(script, situation, key) if situation is not None else ():
            if value.target not in canvas.graph.nodes:
                continue
            item = InheritedPipe(canvas.look, value)
            canvas.viewer.hold_pipe(item.way)
            canvas.viewer.hold_pipe(item)
            start = canvas.port_at(value.source, OUT) + QPointF(0, 8)
            end = canvas.port_at(value.target, "in") - QPointF(0, 7)
            for part in OVER:
                item.set_curve(start, end, part)
                if self._pills.is_free(item.pill()):
                    break
            self._pills.put(item, item.pill())
            self.taken_over.append(item)

    def taken_over_at(self, spot: QPointF) -> InheritedPipe | None:
        return next((one for one in self.taken_over if one.pill().contains(spot)), None)

    # -- being edited -------------------------------------------------------------------

    def edit(self, pipe: CurvedPipe, typed: str = "") -> None:
        """Opens the field of a priority in its pill; typed: what was typed already."""
        cards, link = self._canvas._picture.cards, pipe.link
        key = cards[link.source].name, cards[link.target].name
        text = "none" if link.priority is None else str(link.priority)
        self._open(key, pipe.pill().center(), text, typed)

    def override(self, pipe: InheritedPipe) -> None:
        """Opens the field of one that is taken over: what is typed holds in its stead."""
        key = pipe.value.situation, pipe.value.module
        self._open(key, pipe.pill().center(), str(pipe.value.priority))

    def _open(self, key: tuple[str, str], at: QPointF, text: str, typed: str = "") -> None:
        if self.editor is not None:
            self.editor.close_editor()
        canvas = self._canvas
        canvas.viewer.reveal(canvas.around(at))
        centre = canvas.viewer.mapFromScene(at)
        editor = priority_editor(key, typed or text, canvas.look, canvas.viewer.viewport())
        editor.setAccessibleName(self._named(*key))
        editor.finished.connect(self._on_finished)
        self.editor = editor
        editor.open_at(QRect(centre.x() - 28, centre.y() - 13, 56, 26))
        if typed:
            editor.deselect()
            editor.setCursorPosition(len(typed))

    def _named(self, situation: str, module: str) -> str:
        told: str = self._canvas.tr("Priority of {0} in {1}")
        return told.format(module, situation)

    def _on_finished(self, key: tuple[str, str], text: str | None, _: int) -> None:
        self.editor = None
        self._canvas.viewer.setFocus()
        if text is None:
            return
        text = text.strip()
        if text in ("none", "-", "", self._canvas.tr("none")):
            self._given(*key, None)
        elif not text.removeprefix("-").isdecimal():
            told: str = self._canvas.tr("A priority is a whole number or none, not {0}")
            self._refused(told.format(text))
        elif not LEAST <= int(text) <= MOST:
            told = self._canvas.tr("{0} is too large for a priority")
            self._refused(told.format(text))
        else:
            self._given(*key, int(text))
