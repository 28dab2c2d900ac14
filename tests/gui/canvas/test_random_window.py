"""The proof of the whole window: whatever a person does, what is seen is what is kept and saved.

After every gesture of a random walk through the window, with parts, tabs, both views, undo, saving
and another program that writes the files, the view, NodeGraphQt's model, the document and the
file say the same.
"""

from __future__ import annotations

import os
import random
import sys
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QSignalSpy, QTest
from PySide6.QtWidgets import QApplication
from tests.gui.canvas.conftest import Hand

from situ.document import codec
from situ.document.rbd import Application
from situ_studio.canvas import gestures

SOAK = bool(os.environ.get("SITU_SOAK"))
SEEDS, LENGTH = (range(1, 26), 200) if SOAK else (range(1, 3), 40)
NONE = Qt.KeyboardModifier.NoModifier
CONTROL, SHIFT, ALT = (
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.AltModifier,
)
OUTER, INNER = "ward.rbd.xml", "ask.rbd.xml"
PROJECT = {
    "situ.toml": f'[project]\nname = "ward"\napplications = ["{OUTER}"]\n',
    OUTER: """<application name="ward" xmlns:ed="urn:situ:editor">
  <state no="1" name="start" ed:x="0" ed:y="0"><expectedevents><event name="go" next="2"/>
    <event name="ask" next="4"/></expectedevents></state>
  <state no="2" name="menu" ed:x="230" ed:y="0"><timeout next="3">5</timeout></state>
  <state no="3" name="thanks" ed:x="460" ed:y="0"><timeout next="1">5</timeout></state>
  <state no="4" name="asking" ed:x="0" ed:y="228"><flow src="ask.rbd.xml"/>
    <expectedevents><event name="done" next="1"/></expectedevents></state>
</application>
""",
    INNER: """<application name="ask" xmlns:ed="urn:situ:editor">
  <state no="1" name="question" ed:x="0" ed:y="0"><timeout next="2">5</timeout></state>
  <state no="2" name="answer" final="true" ed:x="230" ed:y="0"/>
</application>
""",
}


class Walker:
    """A person who does anything, by a seed. ``done`` is what was done last."""

    def __init__(self, used: Any, folder: Path, seed: int) -> None:
        self.used = used
        self.folder = folder
        self.random = random.Random(seed)
        self.done: list[str] = []

    @property
    def window(self) -> Any:
        return self.used.window

    @property
    def session(self) -> Any:
        return self.used.session

    @property
    def view(self) -> Any:
        return self.window.current_view

    @property
    def canvas(self) -> Any:
        """The drawing that is seen; None where the outline is."""
        view = self.view
        return view.canvas if view is not None and view.mode == "graph" else None

    def hand(self) -> Hand | None:
        return Hand(self.canvas) if self.canvas is not None else None

    def spots(self, hand: Hand) -> list[QPointF]:
        return [s for u in self.canvas.graph.cards if hand.sees(s := hand.header(u))]

    def exits(self, hand: Hand) -> list[QPointF]:
        every = [s.centre() for u in self.canvas.graph.cards for s in hand.card(u).outputs]
        return [s for s in every if hand.sees(s)]

    def way(self, most: float) -> QPointF:
        return QPointF(self.random.uniform(-most, most), self.random.uniform(-most, most))

    # -- by mouse ----------------------------------------------------------------------

    def drag_card(self) -> None:
        hand = self.hand()
        if hand is not None and (spots := self.spots(hand)):
            start = self.random.choice(spots)
            hand.drag(start, start + self.way(200))

    def connect(self) -> None:
        hand = self.hand()
        if hand is not None and (exits := self.exits(hand)) and (spots := self.spots(hand)):
            hand.drag(self.random.choice(exits), self.random.choice(spots) + QPointF(0, 30))
            self._answer()

    def drag_to_ground(self) -> None:
        hand = self.hand()
        if hand is not None and (exits := self.exits(hand)):
            start = self.random.choice(exits)
            hand.drag(start, start + self.way(250))
            self._answer()

    def _answer(self) -> None:
        menu = self.canvas.menu if self.canvas is not None else None
        if menu is not None:
            taken = self.random.random() < 0.7
            QTest.keyClick(menu.field, Qt.Key.Key_Return if taken else Qt.Key.Key_Escape)
            if self.canvas is not None and self.canvas.menu is not None:
                self.canvas.menu.close()

    def click(self) -> None:
        hand = self.hand()
        if hand is not None and (spots := self.spots(hand) + self.exits(hand)):
            hand.click(self.random.choice(spots), self.random.choice([NONE, NONE, CONTROL]))

    def double_click(self) -> None:
        """Renames, or goes into a part."""
        hand = self.hand()
        if hand is None or not (spots := self.spots(hand)):
            return
        below = QPointF(-30, self.random.choice([0, 80]))
        hand.double_click(self.random.choice(spots) + below)
        focus = QApplication.focusWidget()
        if self.canvas is not None and self.canvas._editor is not None and focus is not None:
            QTest.keyClicks(focus, f"name {self.random.randrange(99)}")
            QTest.keyClick(focus, self.random.choice([Qt.Key.Key_Return, Qt.Key.Key_Escape]))

    def palette(self) -> None:
        document = self.session.document(self.window.current_file)
        many = len(document.states) > 12
        kinds = ["event", "timeout", "always", "text", "button", "speech"]
        self.used.click(
            self.window.palette_.item(self.random.choice(kinds + ["state"] * (not many)))
        )

    def crumb(self) -> None:
        """Out of a part, by its name above."""
        way = self.window.parts.way
        if len(way) > 1:
            self.used.click(self.window.crumbs.button(way[0].partition(".")[0]))

    def tab(self) -> None:
        self.key(self.random.choice([Qt.Key.Key_PageDown, Qt.Key.Key_PageUp]), CONTROL)

    # -- by keys -----------------------------------------------------------------------

    def key(self, key: Qt.Key, held: Qt.KeyboardModifier = NONE) -> None:
        self.used.key(key, held)

    def canvas_key(self) -> None:
        view = self.view
        if view is not None:
            view.current_view().setFocus()
            keys = [
                (Qt.Key.Key_Delete, NONE),
                (Qt.Key.Key_D, CONTROL),
                (Qt.Key.Key_C, CONTROL),
                (Qt.Key.Key_V, CONTROL),
                (Qt.Key.Key_X, CONTROL),
                (Qt.Key.Key_Tab, NONE),
                (Qt.Key.Key_Right, NONE),
                (Qt.Key.Key_Down, CONTROL),
                (Qt.Key.Key_Right, ALT),
                (Qt.Key.Key_Left, ALT),
                (Qt.Key.Key_Down, ALT),
                (Qt.Key.Key_L, CONTROL),
            ]
            self.key(*self.random.choice(keys))

    def other_view(self) -> None:
        self.key(self.random.choice([Qt.Key.Key_1, Qt.Key.Key_1, Qt.Key.Key_2]), CONTROL)

    def undo(self) -> None:
        for _ in range(self.random.randrange(1, 4)):
            self.key(Qt.Key.Key_Z, CONTROL)

    def redo(self) -> None:
        self.key(Qt.Key.Key_Z, CONTROL | SHIFT)

    def run_command(self) -> None:
        """By its name, in the palette of commands."""
        self.key(Qt.Key.Key_K, CONTROL)
        words = ["start here", "put on the grid", "duplicate", "show everything", "everything"]
        focus = QApplication.focusWidget()
        assert focus is not None
        QTest.keyClicks(focus, self.random.choice(words))
        QTest.keyClick(focus, self.random.choice([Qt.Key.Key_Return, Qt.Key.Key_Escape]))
        popup = QApplication.activePopupWidget()
        if popup is not None:
            popup.close()

    def make_part(self) -> None:
        self.used.answers.waiting["name"] = [f"part {self.random.randrange(9)}"]
        self.key(Qt.Key.Key_G, CONTROL)
        self.used.answers.waiting["name"] = []

    def mend(self) -> None:
        found = [p for p in self.session.problems if p.mend is not None]
        if found:
            self.window.problems.mend_asked.emit(self.random.choice(found))

    def save(self) -> None:
        answers = [
            self.random.choice(["mine", "theirs"]) for _ in self.session.reconciling.conflicts()
        ]
        self.used.answers.waiting["conflict"] = answers
        self.key(Qt.Key.Key_S, CONTROL)
        self.used.answers.waiting["conflict"] = []
        assert not self.session.dirty
        for file in self.session.project.flows:
            there, _ = codec.read((self.folder / file).read_bytes(), file)
            assert there is not None
            assert codec.write(there) == codec.write(self.session.document(file))

    # -- another program ---------------------------------------------------------------

    def outside(self) -> None:
        """It writes a file, sometimes while a card is being dragged."""
        hand = self.hand()
        spots = self.spots(hand) if hand is not None else []
        start = self.random.choice(spots) if spots and self.random.random() < 0.6 else None
        if hand is not None and start is not None:
            hand.press(start)
            hand.move(start + QPointF(40, 30))
            hand.move(start + QPointF(60, 40))
        file = self.random.choice([f for f in (OUTER, INNER) if (self.folder / f).exists()])
        there, _ = codec.read((self.folder / file).read_bytes(), file)
        assert isinstance(there, Application)
        words = f"theirs {self.random.randrange(10_000)}"
        after, _, no = gestures.add_state(there, 400, 400)
        if there.states:
            after, no = there, self.random.choice([s.no for s in there.states])
        after, _ = gestures.rename(after, no, words)
        changed = QSignalSpy(self.session.changed)
        told = QSignalSpy(self.session.changed_on_disk)
        (self.folder / file).write_bytes(codec.write(after))
        dirty = file in self.session.dirty
        assert told.wait(20_000) if told.count() == 0 else True, file
        if not dirty and changed.count() == 0:
            assert changed.wait(20_000)
        if hand is not None and start is not None:
            hand.move(start + QPointF(90, 60))
            hand.release(start + QPointF(90, 60))
            self._answer()

    # -- all of it ---------------------------------------------------------------------

    def agree(self, check: Callable[[Any], None]) -> None:
        """What every view that is open shows is what the session has."""
        for file, view in self.window.views.items():
            document = self.session.document(file)
            if document is None:
                continue
            if view.canvas is not None and view is self.view and view.mode == "graph":
                check(SimpleNamespace(canvas=view.canvas, document=document))
            data = codec.write(document)
            again, problems = codec.read(data, file)
            assert not problems
            assert codec.write(again) == data
        assert not [w for w in [QApplication.activePopupWidget()] if w is not None]


WEIGHTS = {
    "drag_card": 3,
    "connect": 2,
    "drag_to_ground": 2,
    "click": 3,
    "double_click": 2,
    "palette": 2,
    "crumb": 1,
    "tab": 1,
    "canvas_key": 4,
    "other_view": 1,
    "undo": 2,
    "redo": 1,
    "run_command": 1,
    "make_part": 1,
    "mend": 1,
    "save": 1,
    "outside": 1,
}
GESTURES = [name for name, weight in WEIGHTS.items() for _ in range(weight)]


@pytest.mark.timeout(1200 if SOAK else 120)
@pytest.mark.parametrize("seed", SEEDS)
def test_what_is_seen_is_what_is_kept_and_saved_whatever_a_person_does(
    studio: Callable[..., Any],
    tmp_path: Path,
    check: Callable[[Any], None],
    monkeypatch: pytest.MonkeyPatch,
    seed: int,
) -> None:
    faults: list[BaseException] = []
    monkeypatch.setattr(sys, "excepthook", lambda kind, error, trace: faults.append(error))
    folder = tmp_path / "ward"
    folder.mkdir()
    for file, text in PROJECT.items():
        (folder / file).write_text(text, encoding="utf-8")
    walker = Walker(studio(folder), folder, seed)
    walker.agree(check)
    for count in range(LENGTH):
        name = walker.random.choice(GESTURES)
        walker.done.append(name)
        try:
            getattr(walker, name)()
            walker.used.settle()
            # What fails in a slot of Qt's is told here only.
            for fault in faults:
                raise fault
            walker.agree(check)
        except BaseException as error:
            error.add_note(f"seed {seed}, gesture {count}: {walker.done[-6:]}")
            raise
    walker.save()
    walker.agree(check)
