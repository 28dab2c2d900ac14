"""The card *In every state*, from nothing: made by hand, or by the mend of what lacks in it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt
from PySide6.QtGui import QDragEnterEvent, QDragMoveEvent, QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from situ.document import codec, rbd
from situ_studio.edits import words
from situ_studio.kinds import MIME
from situ_studio.panels.problems import PROBLEM, mend_box
from situ_studio.problems import problem_rows

FILE = "ask.rbd.xml"
LEFT = Qt.MouseButton.LeftButton
Start = Callable[..., Any]


@pytest.fixture
def used(studio: Start, tmp_path: Path) -> Any:
    """A question with a button, an answer that only a timeout leaves."""
    yes = rbd.Button(id="yes", x=30, y=60, width=40, height=20, event="clickYes", text="Yes")
    asks = rbd.State(
        no="1",
        name="ask",
        screen=rbd.Screen(components=(yes,)),
        actions=(rbd.Speech(text="Did you sleep well?"),),
        events=(rbd.Event(name="clickYes", next="2"),),
    )
    thanks = rbd.State(no="2", name="thanks", timeout=rbd.Timeout(30, "1", True))
    document = rbd.Application(name="ask", states=(asks, thanks))
    (tmp_path / FILE).write_bytes(codec.write(document))
    toml = f'[project]\nname = "ask"\napplications = ["{FILE}"]\n'
    (tmp_path / "situ.toml").write_text(toml, encoding="utf-8")
    return studio(tmp_path)


def shared(used: Any) -> Any:
    return used.session.document(FILE).always


def test_the_palette_makes_it_once_and_shows_the_one_there_is(used: Any) -> None:
    used.click(used.window.palette_.item("always"))
    assert shared(used) == rbd.Always(aside=shared(used).aside)
    assert used.window.current_view.selected == (("always",),)
    step = used.session.undo_text
    used.select("state", "1")
    used.click(used.window.palette_.item("always"))
    assert used.window.current_view.selected == (("always",),)
    assert used.session.undo_text == step
    used.click(used.window.palette_.item("button"))
    assert [one.element for one in shared(used).screen.components] == ["button"]
    used.key(Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    used.key(Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert shared(used) is None


def test_it_is_called_alike_wherever_it_is_told(used: Any) -> None:
    used.click(used.window.palette_.item("always"))
    used.click(used.window.palette_.item("button"))
    assert used.session.undo_text == "Add button to “In every state”"
    document, (button,) = used.session.document(FILE), shared(used).screen.components
    place = ("always", "screen", button.id)
    assert words.title(document, place)[3] == "Button of every state"
    used.session.check_now()
    told = next(p for p in used.session.problems if p.place[:1] == ("always",))
    assert problem_rows.where(used.session, told, FILE) == "In every state"
    used.window.show_mode("outline")
    rows = used.window.current_view.current_view().tree
    used.row_with(rows, "In every state")
    # Who deletes the card deletes no state, and the step does not say so either.
    used.select("always")
    used.key(Qt.Key.Key_Delete)
    assert shared(used) is None
    assert used.session.undo_text == "Delete “In every state”"


def test_it_lies_above_the_states_that_have_a_place(used: Any) -> None:
    canvas = used.window.current_view.canvas
    canvas.select([("state", "1"), ("state", "2")])
    canvas.align("left")
    used.settle()
    used.click(used.window.palette_.item("always"))
    card = canvas.card_area(canvas._find(("always",))[0])
    assert not any(
        card.intersects(canvas.card_area(canvas._find(("state", no))[0])) for no in ("1", "2")
    )
    assert card.bottom() < min(
        canvas.card_area(canvas._find(("state", no))[0]).top() for no in ("1", "2")
    )


def test_it_goes_where_it_is_dropped(used: Any) -> None:
    port = used.window.current_view.canvas.viewer.viewport()
    data = QMimeData()
    data.setData(MIME, b"always")
    at = QPoint(port.width() // 2, port.height() - 120)
    action, none = Qt.DropAction.CopyAction, Qt.KeyboardModifier.NoModifier
    for event in (
        QDragEnterEvent(at, action, data, LEFT, none),
        QDragMoveEvent(at, action, data, LEFT, none),
        QDropEvent(QPointF(at), action, data, LEFT, none),
    ):
        QApplication.sendEvent(port, event)
    used.settle()
    canvas = used.window.current_view.canvas
    assert canvas.card_area(canvas._find(("always",))[0]).contains(canvas.viewer.mapToScene(at))


@pytest.mark.parametrize(
    ("code", "name", "words"),
    [("no-repeat", "clickRepeat", "Repeat"), ("no-way-back-by-hand", "clickHome", "Home")],
)
def test_a_click_on_a_mend_puts_the_button_into_every_state(
    used: Any, code: str, name: str, words: str
) -> None:
    rows = used.window.problems.list
    index = next(
        rows.model().index(row, 0)
        for row in range(rows.model().rowCount())
        if rows.model().index(row, 0).data(PROBLEM).code == code
    )
    rows.scrollTo(index)
    box = mend_box(rows.visualRect(index), index.data(PROBLEM))
    QTest.mouseClick(rows.viewport(), LEFT, pos=box.center())
    used.settle()
    assert [(e.name, e.next) for e in shared(used).events] == [
        (name, "1" if words == "Home" else None)
    ]
    assert [c.text for c in shared(used).screen.components] == [words]
    assert code not in {p.code for p in used.session.problems}
    assert used.session.undo_text == f"Add a {words} button to every state"
