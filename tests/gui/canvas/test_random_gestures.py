"""The proof of the seam: whatever a hand does, view = document = model, and one edit or none."""

from __future__ import annotations

import random
from collections.abc import Callable
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QPointF, Qt
from PySide6.QtWidgets import QApplication

from situ.document.rbd import Application
from situ_studio.canvas import gestures
from situ_studio.canvas.pipes import RoutedPipe

NONE = Qt.KeyboardModifier.NoModifier
CONTROL, SHIFT, ALT = (
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.AltModifier,
)


class Player:
    """Draws gestures from a seed."""

    def __init__(self, desk: Any, seed: int) -> None:
        self.desk = desk
        self.hand = desk.hand
        self.canvas = desk.canvas
        self.random = random.Random(seed)
        self.trace: list[str] = []

    def cards(self) -> list[str]:
        return [u for u in self.canvas.graph.cards if self.hand.sees(self.hand.header(u))]

    def spot(self) -> QPointF:
        size = self.hand.port.size()
        at = QPointF(
            self.random.uniform(8, size.width() - 8), self.random.uniform(8, size.height() - 50)
        )
        return QPointF(self.canvas.viewer.mapToScene(at.toPoint()))

    def empty(self) -> QPointF | None:
        for _ in range(30):
            spot = self.spot()
            if self.canvas.viewer.hit(spot) is None:
                return spot
        return None

    def exits(self) -> list[QPointF]:
        return [
            s.centre()
            for u in self.cards()
            for s in self.hand.card(u).outputs
            if self.hand.sees(s.centre())
        ]

    def pipes(self) -> list[RoutedPipe]:
        return [
            p
            for i in self.canvas.graph.links
            if (p := self.canvas.graph.pipe(i)) is not None and not p.shape().isEmpty()
        ]

    # -- gestures ----------------------------------------------------------------

    def move(self) -> None:
        cards = self.cards()
        if cards:
            start = self.hand.header(self.random.choice(cards))
            self.hand.drag(start, start + self._way(160))

    def move_several(self) -> None:
        cards = self.cards()
        if len(cards) > 1:
            chosen = self.random.sample(cards, 2)
            self.hand.click(self.hand.header(chosen[0]))
            self.hand.click(self.hand.header(chosen[1]), CONTROL)
            start = self.hand.header(chosen[0])
            self.hand.drag(start, start + self._way(90))

    def _way(self, most: float) -> QPointF:
        return QPointF(self.random.uniform(-most, most), self.random.uniform(-most, most))

    def band(self) -> None:
        start = self.empty()
        if start is not None:
            self.hand.drag(start, self.spot(), self.random.choice([NONE, SHIFT]))

    def connect(self) -> None:
        exits, cards = self.exits(), self.cards()
        if exits and cards:
            self.hand.drag(self.random.choice(exits), self.hand.body(self.random.choice(cards)))

    def follow(self) -> None:
        exits, spot = self.exits(), self.empty()
        if not exits or spot is None:
            return
        self.hand.drag(self.random.choice(exits), spot)
        self._answer()

    def _answer(self) -> None:
        menu = self.canvas.menu
        if menu is None:
            return
        if self.random.random() < 0.3:
            self.hand.type(menu.field, self.random.choice(["new", "back", "e", "3", "zzz"]))
        for _ in range(self.random.randrange(4)):
            self._key(menu.field, Qt.Key.Key_Down)
        taken = self.random.random() < 0.7 and menu.list.count() > 0
        self._key(menu.field, Qt.Key.Key_Return if taken else Qt.Key.Key_Escape)
        if self.canvas.menu is not None:
            self.canvas.menu.close()
        self.hand.settle()

    def _key(self, widget: Any, key: Qt.Key) -> None:
        from PySide6.QtTest import QTest

        QTest.keyClick(widget, key)

    def drag_pipe(self) -> None:
        pipes = self.pipes()
        if not pipes:
            return
        start = self.hand.on_pipe(self.random.choice(pipes), self.random.uniform(0.2, 0.8))
        if not self.hand.sees(start):
            return
        cards = self.cards()
        end = self.hand.body(self.random.choice(cards)) if cards else self.spot()
        if self.random.random() < 0.4:
            end = self.spot()
        self.hand.drag(start, end)
        self._answer()

    def click(self) -> None:
        spots = [self.spot(), *self.exits(), *(self.hand.body(u) for u in self.cards())]
        spots += [self.hand.on_pipe(p) for p in self.pipes()]
        seen = [s for s in spots if self.hand.sees(s)]
        self.hand.click(self.random.choice(seen), self.random.choice([NONE, SHIFT, CONTROL, ALT]))

    def escape(self) -> None:
        starts = self.exits() + [
            s for p in self.pipes() if self.hand.sees(s := self.hand.on_pipe(p))
        ]
        if not starts:
            return
        start, end = self.random.choice(starts), self.spot()
        self.hand.press(start)
        for step in range(1, 5):
            self.hand.move(start + (end - start) * (step / 5))
        self.hand.key(Qt.Key.Key_Escape)
        if self.random.random() < 0.5:
            self.hand.move(end)
        self.hand.release(end)
        self._answer()

    def slice(self) -> None:
        start = self.empty()
        if start is not None:
            self.hand.drag(start, self.spot(), ALT | SHIFT)

    def delete(self) -> None:
        if len(self.canvas.graph.cards) > 2 or self.canvas.viewer.selected_pipes():
            self.hand.key(Qt.Key.Key_Delete)

    def add(self) -> None:
        self.canvas.add_state(self.random.choice(["state", "question", "end"]))

    def duplicate(self) -> None:
        if len(self.canvas.graph.cards) < 12:
            self.canvas.duplicate()

    def rename(self) -> None:
        cards = self.cards()
        if not cards:
            return
        self.hand.double_click(self.hand.header(self.random.choice(cards)))
        editor = self.canvas._editor
        if editor is not None:
            editor.selectAll()
            self.hand.type(editor, f"name {self.random.randrange(100)}")
            self._key(editor, self.random.choice([Qt.Key.Key_Return, Qt.Key.Key_Escape]))
            self.hand.settle()

    def nudge(self) -> None:
        self.hand.key(self.random.choice([Qt.Key.Key_Left, Qt.Key.Key_Down]), CONTROL)

    def step(self) -> None:
        self.hand.key(
            self.random.choice([Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Up, Qt.Key.Key_Tab])
        )

    def align(self) -> None:
        self.canvas.align(self.random.choice(["left", "top", "across"]))

    def wheel(self) -> None:
        self.hand.wheel(self.spot(), self.random.choice([120, -120, 480, -480]))
        self.canvas.set_zoom(1.0)

    def undo(self) -> None:
        for _ in range(self.random.randrange(1, 4)):
            self.desk.undo()

    def redo(self) -> None:
        self.desk.redo()

    def interrupted(self) -> None:
        """The document changes in mid-drag of a card, a pipe, an exit or a band."""
        starts = [self.hand.header(u) for u in self.cards()] + self.exits()
        starts += [s for p in self.pipes() if self.hand.sees(s := self.hand.on_pipe(p))]
        empty = self.empty()
        starts += [empty] if empty is not None else []
        start, end = self.random.choice(starts), self.spot()
        self.hand.press(start)
        self.hand.move(start + (end - start) * 0.3)
        self.hand.move(start + (end - start) * 0.5)
        before = len(self.desk.edits)
        self.desk.change(self._elsewhere())
        assert len(self.desk.edits) == before
        self.hand.move(start + (end - start) * 0.8)
        self.hand.release(end)
        self._answer()

    def _elsewhere(self) -> Application:
        document: Application = self.desk.document
        numbers = [s.no for s in document.states]
        what = self.random.randrange(4)
        if what == 0 and len(numbers) > 3:
            return gestures.delete(document, [("state", self.random.choice(numbers))])[0]
        if what == 1:
            return gestures.add_state(document, self.random.uniform(0, 700), 400)[0]
        if what == 2 and numbers:
            no = self.random.choice(numbers)
            return gestures.move(document, {("state", no): (self.random.uniform(0, 600), 300)})[0]
        states = [replace(s, events=s.events[:-1]) for s in document.states]
        return replace(document, states=tuple(states))

    def refused(self) -> None:
        """The shell does not take the edit: the picture goes back."""
        self.desk.refuse = True
        try:
            self.random.choice([self.move, self.connect, self.drag_pipe, self.follow])()
        finally:
            self.desk.refuse = False


WEIGHTS = {
    "move": 3,
    "move_several": 1,
    "band": 1,
    "connect": 2,
    "follow": 1,
    "drag_pipe": 2,
    "click": 2,
    "escape": 1,
    "slice": 1,
    "delete": 1,
    "add": 1,
    "duplicate": 1,
    "rename": 1,
    "nudge": 1,
    "step": 1,
    "align": 1,
    "wheel": 1,
    "undo": 2,
    "redo": 1,
    "interrupted": 2,
    "refused": 1,
}
GESTURES = [name for name, weight in WEIGHTS.items() for _ in range(weight)]


@pytest.mark.parametrize("seed", [1, 2, 3, 4, 5, 6])
def test_view_document_and_model_agree_after_every_gesture(
    desk: Callable[..., Any], small: Application, check: Callable[[Any], None], seed: int
) -> None:
    """canvas.md, last paragraph of *The seam*."""
    made = desk(small)
    player = Player(made, seed)
    check(made)
    for count in range(60):
        name = player.random.choice(GESTURES)
        before = len(made.edits)
        player.trace.append(name)
        try:
            getattr(player, name)()
            if made.canvas.menu is not None:
                # A real press elsewhere would have closed it.
                made.canvas.menu.close()
            QApplication.processEvents()
            assert len(made.edits) - before <= 1, made.edits[before:]
            check(made)
        except BaseException as error:
            error.add_note(f"seed {seed}, gesture {count}: {player.trace[-5:]}")
            raise
        if len(made.canvas.graph.cards) < 2:
            made.change(small)
    assert len(made.edits) > 8


def test_undo_and_redo_of_all_edits_show_what_was(
    desk: Callable[..., Any], small: Application, check: Callable[[Any], None]
) -> None:
    made = desk(small)
    player = Player(made, 7)
    while len(made.edits) < 12:
        player.random.choice([player.move, player.connect, player.add, player.follow])()
    documents = list(made.done)
    while len(made.done) > 1:
        made.undo()
        check(made)
    assert made.document is small
    while made.undone:
        made.redo()
        check(made)
    assert made.done == documents
