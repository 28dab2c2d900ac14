"""Whatever a hand does on a sheet: the document is sound, undo gives all of it back."""

from __future__ import annotations

import os
import random
from collections.abc import Callable
from typing import Any

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from situ.document import codec
from situ_studio import kinds
from situ_studio.edits import places
from situ_studio.screens import copies, ordering
from situ_studio.screens.placing import HANDLES

LEFT = Qt.MouseButton.LeftButton
NONE = Qt.KeyboardModifier.NoModifier
CONTROL, SHIFT, ALT = (
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.AltModifier,
)
SOAK = bool(os.environ.get("SITU_SOAK"))
SEEDS, LENGTH = (range(1, 41), 400) if SOAK else (range(1, 5), 50)

Page = Any


class Player:
    """Draws gestures from a seed."""

    def __init__(self, page: Page, seed: int) -> None:
        self.page, self.sheet = page, page.sheet
        self.random = random.Random(seed)
        self.trace: list[str] = []

    def spot(self) -> QPoint:
        return QPoint(
            self.random.randrange(self.sheet.width()), self.random.randrange(self.sheet.height())
        )

    def held(self) -> Qt.KeyboardModifier:
        return self.random.choice([NONE, NONE, NONE, SHIFT, CONTROL, ALT, ALT | SHIFT])

    def one(self) -> QPoint:
        """A place on a component, or anywhere where there is none."""
        boxes = list(self.sheet.own().values())
        if not boxes:
            return self.spot()
        box = self.random.choice(boxes)
        at: QPoint = self.page.at(
            box.x + self.random.random() * box.width, box.y + self.random.random() * box.height
        )
        return at

    # -- gestures ------------------------------------------------------------------------

    def click(self) -> None:
        QTest.mouseClick(self.sheet, LEFT, self.held(), self.random.choice([self.one, self.spot])())

    def drag(self) -> None:
        self.page.drag(self.one(), self.spot() - self.spot(), self.held())

    def resize(self) -> None:
        if self.sheet.selected:
            start = self.sheet.handle_at(self.random.choice(HANDLES)).toPoint()
            self.page.drag(start, self.spot() - self.spot(), self.held())

    def band(self) -> None:
        self.page.drag(self.spot(), self.spot() - self.spot(), self.held())

    def cancel(self) -> None:
        """Esc in the middle of a drag leaves the document as it is."""
        before, start = self.page.document, self.random.choice([self.one, self.spot])()
        QTest.mousePress(self.sheet, LEFT, NONE, start)
        self.page.sheet_move(self.spot(), self.held())
        QTest.keyClick(self.sheet, Qt.Key.Key_Escape)
        self.page.sheet_move(self.spot(), NONE)
        QTest.mouseRelease(self.sheet, LEFT, NONE, self.spot())
        assert self.page.document is before

    def key(self) -> None:
        key = self.random.choice(
            [
                Qt.Key.Key_Left,
                Qt.Key.Key_Right,
                Qt.Key.Key_Up,
                Qt.Key.Key_Down,
                Qt.Key.Key_Tab,
                Qt.Key.Key_Backtab,
                Qt.Key.Key_Escape,
                Qt.Key.Key_A,
            ]
        )
        held = self.random.choice([NONE, SHIFT, ALT, CONTROL, ALT | SHIFT, CONTROL | SHIFT])
        if key == Qt.Key.Key_A:
            held = CONTROL
        self.sheet.setFocus()
        QTest.keyClick(self.sheet, key, held)

    def delete(self) -> None:
        if len(self.sheet.own()) > 2:
            QTest.keyClick(self.sheet, Qt.Key.Key_Delete)

    def drop(self) -> None:
        if len(self.sheet.own()) < 12:
            self.page.drop(self.random.choice(kinds.COMPONENTS).name, self.spot())

    def write(self) -> None:
        QTest.mouseDClick(self.sheet, LEFT, NONE, self.one())
        field = self.sheet.writing.field
        if field is None:
            return
        QTest.keyClicks(field, self.random.choice(["Hello", "{us", "", " "]))
        for _ in range(3):
            # The list of tags may be open, which takes the first one.
            if self.sheet.writing.field is not None:
                key = self.random.choice([Qt.Key.Key_Return, Qt.Key.Key_Escape, Qt.Key.Key_Tab])
                QTest.keyClick(self.sheet.writing.field, key)
        self.sheet.setFocus()

    def order(self) -> None:
        screen = self.page.shown.screen
        ways: tuple[ordering.Way, ...] = ("front", "forward", "backward", "back")
        way = self.random.choice(ways)
        self.sheet.tell(ordering.reordered(screen, self.sheet.selected, way), "Order {0}")

    def align(self) -> None:
        self.sheet.align(self.random.choice(["left", "middle", "across", "down", "bottom"]))

    def paste(self) -> None:
        screen = self.page.shown.screen
        chosen = copies.chosen(screen, self.sheet.selected)
        if chosen and len(screen.components) < 12:
            after, ids = copies.pasted(screen, copies.read(copies.written(chosen)))
            self.sheet.tell(after, "Paste {0}")
            self.sheet.choose(ids)

    def undo(self) -> None:
        if self.page.steps:
            self.page.undo()

    def play(self) -> None:
        gesture: Callable[[], None] = self.random.choice(
            [
                self.click,
                self.click,
                self.drag,
                self.drag,
                self.resize,
                self.band,
                self.cancel,
                self.key,
                self.key,
                self.delete,
                self.drop,
                self.write,
                self.order,
                self.align,
                self.paste,
                self.undo,
            ]
        )
        self.trace.append(gesture.__name__)
        gesture()
        self.page.settle()

    # -- what holds always -----------------------------------------------------------------

    def check(self) -> None:
        document, sheet = self.page.document, self.sheet
        screen = document.state("11").screen
        assert sheet.screen_shown is screen
        assert sheet.proposal is None
        ids = [c.id for c in screen.components]
        assert len(ids) == len(set(ids))
        for c in screen.components:
            assert 0 <= c.x <= c.x + c.width <= 100.0001
            assert 0 <= c.y <= c.y + c.height <= 100.0001
            assert c.width > 0
            assert c.height > 0
        assert set(sheet.selected) <= set(ids)
        if self.page.selected:
            named = {p[-1] for p in self.page.selected if places.is_component(p)}
            assert named & set(ids) == set(sheet.selected)
        read, problems = codec.read(codec.write(document), "walk.rbd.xml")
        assert read == document
        assert not [p for p in problems if p.severity == "error"]


@pytest.mark.parametrize("seed", SEEDS)
def test_whatever_a_hand_does_the_document_is_sound_and_undo_gives_it_back(
    page: Page, seed: int
) -> None:
    first = codec.write(page.document)
    page.sheet.offer_tags(("user.name", "user.first"))
    player = Player(page, seed)
    widgets = len(page.sheet.children())
    for step in range(LENGTH):
        try:
            player.play()
            player.check()
        except AssertionError:
            print(f"seed {seed}, step {step}: {player.trace[-8:]}")
            raise
    page.sheet.writing.take()
    page.settle()
    assert len(page.sheet.children()) == widgets
    assert QApplication.activePopupWidget() is None
    while page.steps:
        page.undo()
    assert codec.write(page.document) == first
