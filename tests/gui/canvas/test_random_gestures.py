"""The proof of the seam: whatever a hand does, view = document = model, and one edit or none."""

from __future__ import annotations

import os
import random
from collections.abc import Callable
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import QApplication

from situ.document import codec
from situ.document.rbd import Application
from situ_studio.canvas import figures, gestures
from situ_studio.canvas.figure_items import FigureItem
from situ_studio.canvas.pipes import RoutedPipe
from situ_studio.canvas.projection import Projector

NONE = Qt.KeyboardModifier.NoModifier
CONTROL, SHIFT, ALT = (
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.AltModifier,
)
SOAK = bool(os.environ.get("SITU_SOAK"))
SEEDS, LENGTH = (range(1, 41), 400) if SOAK else (range(1, 7), 60)


class Player:
    """Draws gestures from a seed."""

    def __init__(self, desk: Any, seed: int) -> None:
        self.desk = desk
        self.hand = desk.hand
        self.canvas = desk.canvas
        self.random = random.Random(seed)
        self.trace: list[str] = []
        self.saved: Any = None

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

    def between(self) -> None:
        """A card onto a pipe."""
        cards, pipes = self.cards(), self.pipes()
        if cards and pipes:
            start = self.hand.header(self.random.choice(cards))
            goal = self.hand.on_pipe(self.random.choice(pipes))
            self.hand.press(start)
            for step in range(1, 5):
                self.hand.move(start + (goal - start) * (step / 4))
                self.hand.settle()
            self.hand.release(goal, self.random.choice([NONE, NONE, ALT]))

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

    def escape_card(self) -> None:
        """Esc while cards are dragged, or an edge of a frame."""
        starts = [self.hand.header(u) for u in self.cards()] + self.edges()
        if starts:
            start = self.random.choice(starts)
            self.hand.press(start)
            self.hand.move(start + self._way(90))
            self.hand.move(start + self._way(90))
            self.hand.key(Qt.Key.Key_Escape)
            self.hand.release(start + self._way(90))

    def slice(self) -> None:
        start = self.empty()
        if start is not None:
            self.hand.drag(start, self.spot(), ALT | SHIFT)

    def delete(self) -> None:
        if len(self.canvas.graph.cards) > 2 or self.canvas.viewer.selected_pipes():
            self.hand.key(Qt.Key.Key_Delete)

    def add(self) -> None:
        self.canvas.add_state(self.random.choice(["state", "question", "end"]))

    def note(self) -> None:
        if sum(u.startswith("note") for u in self.canvas.graph.cards) < 4:
            self.canvas.add_drawn("note")
            self._write()

    def frame(self) -> None:
        if sum(u.startswith("frame") for u in self.canvas.graph.cards) < 3:
            self.canvas.add_drawn("frame")
            self._write()

    def _write(self) -> None:
        editor = self.canvas._editor
        if editor is not None:
            self.hand.type(editor, f"words {self.random.randrange(100)}")
            self._end_editing()

    def _end_editing(self) -> None:
        """A press elsewhere takes the words, Esc does not."""
        editor = self.canvas._editor
        if editor is not None and self.random.random() < 0.5:
            self._key(editor, Qt.Key.Key_Escape)
        self.hand.viewer.setFocus()
        self.hand.settle()
        assert self.canvas._editor is None

    def edges(self) -> list[QPointF]:
        """Where notes and frames can be taken hold of to be resized."""
        items = (self.hand.card(u) for u in self.cards())
        figures_ = [i for i in items if isinstance(i, FigureItem)]
        spots = [i.mapToScene(i.area().bottomRight()) for i in figures_]
        spots += [i.mapToScene(i.area().topLeft()) for i in figures_]
        return [s for s in spots if self.hand.sees(s)]

    def resize(self) -> None:
        edges = self.edges()
        if edges:
            start = self.random.choice(edges)
            self.hand.drag(start, start + self._way(120))

    def copy_and_paste(self) -> None:
        self.canvas.copy()
        if len(self.canvas.graph.cards) < 12:
            self.canvas.paste()

    def cut(self) -> None:
        if len(self.canvas.graph.cards) > 4:
            self.canvas.cut()

    def snap_to_grid(self) -> None:
        self.canvas.snap_to_grid()

    def connect_selected(self) -> None:
        self.canvas.connect_selected()

    def step_to_exit(self) -> None:
        self.random.choice([self.canvas.next_exit, self.canvas.previous_exit])()

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
            self._end_editing()

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
        starts += self.edges()
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
        what = self.random.randrange(5)
        if what == 4:
            gone = self.random.choice(["note", "frame"])
            return gestures.delete(document, [(gone, "0")])[0]
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
            self.random.choice(
                [self.move, self.connect, self.drag_pipe, self.follow, self.resize]
            )()
        finally:
            self.desk.refuse = False


WEIGHTS = {
    "move": 3,
    "between": 1,
    "move_several": 1,
    "band": 1,
    "connect": 2,
    "follow": 1,
    "drag_pipe": 2,
    "click": 2,
    "escape": 1,
    "escape_card": 1,
    "note": 1,
    "frame": 1,
    "resize": 1,
    "copy_and_paste": 1,
    "cut": 1,
    "snap_to_grid": 1,
    "connect_selected": 1,
    "step_to_exit": 1,
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
ALLOWED = {"note": 2, "frame": 2}
"""A new note is an edit, and what is written in it another one."""
GESTURES = [name for name, weight in WEIGHTS.items() for _ in range(weight)]


def saved_again(desk: Any) -> None:
    """What is written and read again is the same document, and looks the same."""
    document, canvas = desk.document, desk.canvas
    data = codec.write(document)
    again, problems = codec.read(data, "again.rbd.xml")
    assert not problems
    assert isinstance(again, Application)
    assert codec.write(again) == data
    seen = Projector().picture(again, canvas._problems, canvas.positions.laid)
    now = Projector().picture(document, canvas._problems, canvas.positions.laid)
    assert (seen.cards, seen.links) == (now.cards, now.links)
    assert figures.shown(again, {}) == figures.shown(document, {})


def heard(desk: Any) -> None:
    """What a screen reader finds is what is drawn."""
    drawing: Any = QAccessible.queryAccessibleInterface(desk.canvas.viewer)
    cards = desk.canvas.graph.cards
    assert drawing.childCount() == len(cards)
    for index, card in enumerate(cards.values()):
        part = drawing.child(index)
        assert part.text(QAccessible.Text.Name) == card.hint().split("\n")[0]
        if card.outputs:
            names = [part.child(i).path[-1] for i in range(part.childCount())]
            assert [n for n in names if not n.startswith("action")] == [e.id for e in card.exits]


@pytest.mark.timeout(1200 if SOAK else 120)
@pytest.mark.parametrize("seed", SEEDS)
def test_view_document_and_model_agree_after_every_gesture(
    desk: Callable[..., Any], small: Application, check: Callable[[Any], None], seed: int
) -> None:
    """canvas.md, last paragraph of *The seam*."""
    made = desk(small)
    player = Player(made, seed)
    check(made)
    for count in range(LENGTH):
        name = player.random.choice(GESTURES)
        before = len(made.edits)
        player.trace.append(name)
        try:
            getattr(player, name)()
            if made.canvas.menu is not None:
                # A real press elsewhere would have closed it.
                made.canvas.menu.close()
            QApplication.processEvents()
            assert len(made.edits) - before <= ALLOWED.get(name, 1), made.edits[before:]
            check(made)
            if made.document is not player.saved:
                saved_again(made)
                heard(made)
                player.saved = made.document
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
