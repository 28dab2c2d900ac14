"""What an edit of an application is called, and why one is refused, in the user's language."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import pytest
from PySide6.QtCore import QTranslator
from PySide6.QtWidgets import QApplication

from situ.document.drawing import Frame, Note
from situ.document.rbd import Application
from situ_studio import kinds
from situ_studio.canvas import figures, gestures
from situ_studio.commands.insert import NotHere, insert
from situ_studio.copying import copies

EVENT = ("state", "1", "event", "0")


class Marking(QTranslator):
    """Whatever is asked for comes in brackets."""

    def isEmpty(self) -> bool:
        return False

    def translate(self, context: str, text: str, *_: Any) -> str:
        return f"[{text}]"


@pytest.fixture(autouse=True)
def marked(qt: QApplication) -> Iterator[None]:
    marking = Marking()
    qt.installTranslator(marking)
    yield
    qt.removeTranslator(marking)


def test_every_step_of_an_application_is_named_in_the_language_of_the_window(
    small: Application,
) -> None:
    note, frame = (
        Note(x=0, y=0, width=9, height=9, text="x"),
        Frame(x=0, y=0, width=9, height=9, title="x"),
    )
    noted, place, added = figures.add(small, note)
    framed, on, added_too = figures.add(small, frame)
    copied = copies.fragment(small, [("state", "1"), ("state", "2")])
    said = {
        added,
        added_too,
        figures.put(noted, place, (8, 8, 9, 9))[1],
        figures.write(noted, place, "y")[1],
        figures.write(framed, on, "y")[1],
        gestures.move(small, {("state", "2"): (300, 8)})[1],
        gestures.move(small, {("state", "2"): (300, 8), ("state", "1"): (1, 1)})[1],
        gestures.move(noted, {("state", "2"): (300, 8), place: (1, 1)})[1],
        gestures.connect(small, EVENT, "3")[1],
        gestures.connect(small, EVENT, "#back")[1],
        gestures.disconnect(small, EVENT)[1],
        gestures.add_event(small, ("state", "1"), None)[1],
        gestures.add_event(small, ("state", "1"), "2")[1],
        gestures.add_state(small, 0, 0)[1],
        gestures.follow(small, ("state", "1"), "0", "speech", 0, 0)[1],
        gestures.insert(small, EVENT, 0, 0)[1],
        gestures.put_between(small, EVENT, "4")[1],
        gestures.rename(small, "1", "other")[1],
        gestures.delete(small, [("state", "1")])[1],
        gestures.delete(small, [("state", "1"), ("always",)])[1],
        gestures.mark_start(small, "2")[1],
        copies.paste(small, copied, (0, 0))[1],
        copies.duplicate(small, [("state", "1")])[1],
        copies.counted(copied),
        copies.named(copies.fragment(noted, [place])),
    }
    for kind in (kinds.STATE, kinds.TIMEOUT, kinds.EVENT):
        said.add(insert(small, kind, ("state", "4"))[2])
    assert [text for text in said if not text.startswith("[")] == []
    # Nor is a piece of it: but for names and numbers all of it stands in brackets.
    assert gestures.connect(small, EVENT, "#back")[1].count("[") == 4
    assert gestures.delete(small, [("state", "1", "timeout")])[1].count("[") == 3


@pytest.mark.parametrize(
    "ask",
    [
        lambda small: insert(small, kinds.EVENT, ()),
        lambda small: insert(small, kinds.TIMEOUT, ("state", "1")),
    ],
)
def test_why_something_can_not_be_put_there_is_said_so_too(
    small: Application, ask: Callable[[Application], Any]
) -> None:
    with pytest.raises(NotHere, match=r"^\["):
        ask(small)
