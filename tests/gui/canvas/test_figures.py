"""Notes and frames on the canvas, by real events: dragged, resized, written on, added, deleted."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QMimeData, QPointF, Qt
from PySide6.QtGui import QDragEnterEvent, QDragMoveEvent, QDropEvent
from PySide6.QtWidgets import QApplication

from situ.document import codec, drawing
from situ.document.drawing import Frame, Note
from situ.document.rbd import Application
from situ_studio.canvas import figures
from situ_studio.canvas.figure_items import broken
from situ_studio.canvas.note_editor import NoteEditor
from situ_studio.canvas.overlay import InPlace
from situ_studio.kinds import MIME
from situ_studio.looks import theme

CONTROL = Qt.KeyboardModifier.ControlModifier
NONE = Qt.KeyboardModifier.NoModifier
Make = Callable[..., Any]
Check = Callable[[Any], None]
FRAME = Frame(x=-24, y=184, width=480, height=240, title="Nobody")
"""Round states 4 and 5 of ``small``."""
NOTE = Note(x=480, y=304, width=160, height=80, text="From the pilot study")


@pytest.fixture
def drawn(small: Application) -> Application:
    return drawing.add(drawing.add(small, FRAME), NOTE)


@pytest.fixture
def made(desk: Make, drawn: Application) -> Any:
    return desk(drawn)


def values(desk: Any) -> tuple[Any, ...]:
    return drawing.drawn(desk.document)


def position(desk: Any, no: str) -> Any:
    return desk.document.state(no).aside.position


TITLE = QPointF(FRAME.x + 60, FRAME.y + 14)
INSIDE = QPointF(FRAME.x + 440, FRAME.y + 200)
ON_NOTE = QPointF(NOTE.x + 60, NOTE.y + 40)
CORNER = QPointF(FRAME.x + FRAME.width, FRAME.y + FRAME.height)


def test_a_frame_dragged_by_its_title_takes_along_what_lies_in_it(made: Any, check: Check) -> None:
    made.hand.drag(TITLE, TITLE + QPointF(81, 42))
    assert made.edits == ["Move the frame Nobody"]
    assert (values(made)[0].x, values(made)[0].y) == (56, 224)
    assert (position(made, "4"), position(made, "5")) == ((80, 268), (310, 268))
    assert position(made, "1") == (0, 0)
    check(made)


def test_what_lies_in_a_frame_follows_while_it_is_dragged_and_esc_puts_all_back(
    made: Any, check: Check
) -> None:
    hand, view = made.hand, made.hand.card("4")
    hand.press(TITLE)
    for step in range(1, 6):
        hand.move(TITLE + QPointF(20 * step, 10 * step))
    hand.settle()
    assert (view.x(), view.y()) == (100, 278)
    hand.key(Qt.Key.Key_Escape)
    hand.release(TITLE + QPointF(100, 50))
    assert made.edits == []
    assert (view.x(), view.y()) == (0, 228)
    check(made)


def test_a_frame_in_a_frame_goes_along_with_all_that_is_in_it(
    desk: Make, drawn: Application, check: Check
) -> None:
    outer = Frame(x=-40, y=144, width=720, height=320, title="All")
    used = desk(drawing.add(drawn, outer))
    spot = QPointF(outer.x + 60, outer.y + 14)
    used.hand.drag(spot, spot + QPointF(0, 40))
    assert [one.y for one in values(used)] == [FRAME.y + 40, NOTE.y + 40, outer.y + 40]
    assert position(used, "4") == (0, 268)
    check(used)


def test_a_card_in_a_frame_is_dragged_alone_and_the_ground_in_it_is_ground(
    made: Any, check: Check
) -> None:
    hand = made.hand
    hand.drag(hand.header("4"), hand.header("4") + QPointF(8, 8))
    assert made.edits == ["Move state 4"]
    hand.click(TITLE)
    assert made.canvas.selection() == (("frame", "0"),)
    hand.click(INSIDE)
    assert made.canvas.selection() == ()
    check(made)


@pytest.mark.parametrize(
    ("spot", "way", "area"),
    [
        (CORNER, QPointF(41, 33), (-24, 184, 520, 272)),
        (QPointF(FRAME.x, FRAME.y + 120), QPointF(-33, 5), (-56, 184, 512, 240)),
        (QPointF(FRAME.x + 200, FRAME.y), QPointF(3, -23), (-24, 160, 480, 264)),
        (CORNER, QPointF(-900, -900), (-24, 184, 96, 64)),
    ],
)
def test_a_frame_is_resized_at_its_edges_and_never_too_small(
    made: Any, check: Check, spot: QPointF, way: QPointF, area: Any
) -> None:
    made.hand.drag(spot, spot + way)
    frame = values(made)[0]
    assert (frame.x, frame.y, frame.width, frame.height) == area
    assert made.edits == ["Resize the frame Nobody"]
    assert position(made, "4") == (0, 228)
    check(made)


def test_esc_ends_resizing_as_if_it_had_not_begun(made: Any, check: Check) -> None:
    made.hand.press(CORNER)
    for step in range(1, 6):
        made.hand.move(CORNER + QPointF(10 * step, 10 * step))
    item = made.hand.card("frame 0")
    assert item.area().width() > FRAME.width
    made.hand.key(Qt.Key.Key_Escape)
    made.hand.release(CORNER + QPointF(50, 50))
    assert item.area().width() == FRAME.width
    assert made.edits == []
    check(made)


def test_a_note_is_dragged_and_written_on_where_it_stands(made: Any, check: Check) -> None:
    hand = made.hand
    hand.drag(ON_NOTE, ON_NOTE + QPointF(16, 0))
    assert made.edits == ["Move a note"]
    hand.double_click(ON_NOTE + QPointF(16, 0))
    (editor,) = made.canvas.findChildren(NoteEditor)
    hand.type(editor, "Ask")
    hand.type(editor, "\r")
    hand.type(editor, "again")
    QApplication.sendEvent(editor, _key(Qt.Key.Key_Return, CONTROL))
    hand.settle()
    assert values(made)[1].text == "Ask\nagain"
    assert made.edits[-1] == "Change the text of a note"
    check(made)


def test_esc_leaves_a_note_as_it_was(made: Any) -> None:
    made.hand.double_click(ON_NOTE)
    (editor,) = made.canvas.findChildren(NoteEditor)
    made.hand.type(editor, "Ask")
    QApplication.sendEvent(editor, _key(Qt.Key.Key_Escape))
    made.hand.settle()
    assert made.edits == []


def test_a_frames_title_is_edited_by_f2(made: Any) -> None:
    made.hand.click(TITLE)
    made.hand.key(Qt.Key.Key_F2)
    (editor,) = made.canvas.findChildren(InPlace)
    made.hand.type(editor, "Vital signs")
    made.hand.type(editor, "\r")
    assert values(made)[0].title == "Vital signs"
    assert made.edits == ["Call a frame Vital signs"]


def test_keys_reach_move_and_delete_notes_and_frames(made: Any, check: Check) -> None:
    hand, canvas = made.hand, made.canvas
    hand.click(INSIDE)
    seen = set()
    for _ in range(len(canvas.graph.cards)):
        hand.key(Qt.Key.Key_Tab)
        seen.update(canvas.selection())
    assert {("note", "0"), ("frame", "0")} <= seen
    canvas.select([("frame", "0")])
    hand.key(Qt.Key.Key_Right, CONTROL)
    assert values(made)[0].x == FRAME.x + 8
    assert position(made, "4") == (8, 228)
    hand.key(Qt.Key.Key_Delete)
    assert values(made) == (NOTE,)
    assert made.edits[-1] == "Delete the frame Nobody"
    assert made.document.state("4") is not None
    check(made)


def test_deleting_several_leaves_the_right_ones(desk: Make, small: Application) -> None:
    notes = [replace(NOTE, x=480 + 200 * i, text=str(i)) for i in range(3)]
    document = small
    for note in notes:
        document = drawing.add(document, note)
    used = desk(document)
    used.canvas.select([("note", "0"), ("note", "2"), ("state", "5")])
    used.hand.key(Qt.Key.Key_Delete)
    assert values(used) == (notes[1],)
    assert used.document.state("5") is None


def test_a_frame_goes_round_what_is_selected(made: Any, check: Check) -> None:
    made.canvas.select([("state", "1"), ("state", "2")])
    made.canvas.add_drawn("frame")
    frame = values(made)[2]
    assert (frame.x, frame.y, frame.width) == (-24, -44, 230 + 176 + 48)
    assert made.edits == ["Add frame"]
    assert made.canvas.selection() == (("frame", "1"),)
    (editor,) = made.canvas.findChildren(InPlace)
    made.hand.type(editor, "Begin")
    made.hand.type(editor, "\r")
    assert values(made)[2].title == "Begin"
    held = figures.held((frame.x, frame.y, frame.width, frame.height), _areas(made))
    assert held == ["1", "2"]
    check(made)


def test_a_note_is_dropped_from_the_palette(made: Any, check: Check) -> None:
    at = made.hand.pixel(QPointF(700, 40))
    data = QMimeData()
    data.setData(MIME, b"note")
    action, left = Qt.DropAction.CopyAction, Qt.MouseButton.LeftButton
    for event in (
        QDragEnterEvent(at, action, data, left, NONE),
        QDragMoveEvent(at, action, data, left, NONE),
        QDropEvent(QPointF(at), action, data, left, NONE),
    ):
        QApplication.sendEvent(made.hand.port, event)
    (editor,) = made.canvas.findChildren(NoteEditor)
    made.hand.type(editor, "Here")
    QApplication.sendEvent(editor, _key(Qt.Key.Key_Return, CONTROL))
    made.hand.settle()
    assert values(made)[2].text == "Here"
    assert (values(made)[2].x, values(made)[2].y) == (616, 8)
    check(made)


def test_a_pipe_dropped_in_a_frame_asks_what_follows_there(made: Any) -> None:
    hand = made.hand
    hand.drag(hand.exit("2", "0"), INSIDE)
    assert made.canvas.menu is not None
    made.canvas.menu.close()


def test_undo_brings_a_note_back_and_the_file_keeps_everything(made: Any, check: Check) -> None:
    made.hand.click(ON_NOTE)
    made.hand.key(Qt.Key.Key_Delete)
    made.undo()
    assert values(made) == (FRAME, NOTE)
    check(made)
    written = codec.write(made.document)
    again, problems = codec.read(written, "a")
    assert not problems
    assert isinstance(again, Application)
    assert drawing.drawn(again) == (FRAME, NOTE)


@pytest.mark.parametrize("zoom", [1.0, 0.1])
def test_a_frames_title_is_seen_at_every_zoom(made: Any, zoom: float) -> None:
    canvas = made.canvas
    canvas.clear_selection()
    canvas.set_zoom(zoom)
    made.hand.settle()

    def ink() -> int:
        image = canvas.viewer.viewport().grab().toImage()
        wanted = theme.LIGHT.color("module")
        corner = made.hand.pixel(QPointF(FRAME.x, FRAME.y))
        ratio = image.devicePixelRatio()
        spots = (
            QPointF(corner.x() + x, corner.y() + y) * ratio
            for x in range(100)
            for y in range(-18, 26)
        )
        return sum(_near(image.pixelColor(spot.toPoint()), wanted) for spot in spots)

    titled = ink()
    made.change(drawing.exchange(made.document, 0, replace(FRAME, title="")))
    made.hand.settle()
    assert titled >= ink() + 15


def _near(color: Any, wanted: Any) -> bool:
    way = (color.red() - wanted.red(), color.green() - wanted.green(), color.blue() - wanted.blue())
    return bool(sum(abs(one) for one in way) < 60)


def test_a_colour_of_the_studio_is_that_of_its_kind_on_any_ground(made: Any) -> None:
    item = made.hand.card("frame 0")
    for used in (theme.LIGHT, theme.DARK):
        made.canvas.set_theme(used)
        assert item.ink(made.canvas.look) == (used.color("module"), used.color("module_soft"))
    made.change(drawing.exchange(made.document, 0, replace(FRAME, color="#8A2178")))
    assert item.ink(made.canvas.look)[0] == theme.DARK.color("situation")
    made.change(drawing.exchange(made.document, 0, replace(FRAME, color="#123456")))
    assert item.ink(made.canvas.look)[0].name() == "#123456"
    made.change(drawing.exchange(made.document, 0, replace(FRAME, color="no colour")))
    assert item.ink(made.canvas.look)[0] == theme.DARK.color("state")


def test_a_note_shows_whole_lines_and_says_that_there_are_more(qt: QApplication) -> None:
    assert broken("one\ntwo", 12, 200, 60) == ["one", "two"]
    few = broken("a long text that has no room in so small a note", 12, 80, 34)
    assert len(few) == 2
    assert few[1].endswith("…")


def _areas(desk: Any) -> dict[str, Any]:
    return {
        uid: (c.x, c.y, c.width, c.height)
        for uid, c in desk.canvas.graph.cards.items()
        if uid.isdigit()
    }


def _key(key: Qt.Key, held: Qt.KeyboardModifier = NONE) -> Any:
    from PySide6.QtCore import QEvent
    from PySide6.QtGui import QKeyEvent

    return QKeyEvent(QEvent.Type.KeyPress, key, held)


def test_notes_and_frames_are_copied_with_states_and_pasted_as_they_lay(
    made: Any, check: Check
) -> None:
    canvas = made.canvas
    canvas.select([("state", "4"), ("note", "0"), ("frame", "0")])
    canvas.copy()
    made.hand.click(QPointF(900, 600))
    canvas.paste()
    assert made.edits == ["Paste 3 things"]
    _, _, frame, note = values(made)
    state = made.document.states[-1]
    assert (frame.title, note.text) == (FRAME.title, NOTE.text)
    assert (note.x - frame.x, note.y - frame.y) == (NOTE.x - FRAME.x, NOTE.y - FRAME.y)
    x, y = state.aside.position
    assert (x - frame.x, y - frame.y) == (0 - FRAME.x, 228 - FRAME.y)
    assert canvas.selection() == (("state", state.no), ("frame", "1"), ("note", "1"))
    check(made)


def test_a_note_alone_is_duplicated_and_cut(made: Any, check: Check) -> None:
    made.hand.click(ON_NOTE)
    made.canvas.duplicate()
    assert made.edits == ["Duplicate a note"]
    assert values(made)[2] == replace(NOTE, x=NOTE.x + 32, y=NOTE.y + 32)
    assert made.canvas.selection() == (("note", "1"),)
    made.canvas.cut()
    assert values(made) == (FRAME, NOTE)
    assert made.edits[-1] == "Cut a note"
    check(made)


def test_a_note_written_before_a_state_in_the_file_stays_when_the_state_goes(
    desk: Make, check: Check
) -> None:
    text = """<application name="a" xmlns:ed="urn:situ:editor"><state no="1" ed:x="0" ed:y="0"/>
    <ed:note x="300" y="40">why</ed:note><state no="2" ed:x="0" ed:y="200"/></application>"""
    document, _ = codec.read(text.encode(), "a")
    used = desk(document)
    used.canvas.select([("state", "2")])
    used.hand.key(Qt.Key.Key_Delete)
    assert [one.text for one in values(used)] == ["why"]
    assert used.document.state("2") is None
    check(used)


def test_frames_and_notes_go_with_their_cards_when_all_are_arranged(
    made: Any, check: Check
) -> None:
    # The card next to the note is that of what every state has.
    before = made.document.always.aside.position
    made.canvas.auto_layout()
    made.hand.settle()
    frame, moved = values(made)
    areas = _areas(made)
    assert figures.around((areas["4"], areas["5"])) == (frame.x, frame.y, frame.width, frame.height)
    now = made.document.always.aside.position
    assert now != before
    assert (moved.x - NOTE.x, moved.y - NOTE.y) == (now[0] - before[0], now[1] - before[1])
    made.undo()
    assert values(made) == (FRAME, NOTE)
    check(made)
