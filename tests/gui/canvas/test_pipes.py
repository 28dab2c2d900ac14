"""Pipes under the mouse and at every zoom: what can be hit, what is said, what can be read."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PySide6.QtCore import QEvent, QPoint, QPointF, QRectF, Qt
from PySide6.QtGui import QImage

from situ.document import condition, drawing
from situ.document.drawing import Frame
from situ.document.rbd import Application, Event, State, Timeout
from situ_studio.canvas.live import LiveView, Taken

Make = Callable[..., Any]


@pytest.fixture
def made(desk: Make, small: Application) -> Any:
    return desk(small)


def rest(made: Any, spot: QPointF) -> None:
    """The mouse comes to a spot, no button held."""
    none = Qt.MouseButton.NoButton
    for away in (QPoint(9, 9), QPoint(0, 0)):
        at = made.hand.pixel(spot) + away
        made.hand._send(QEvent.Type.MouseMove, at, none, none)
    made.hand.settle()


def shape(made: Any) -> Qt.CursorShape:
    found: Qt.CursorShape = made.canvas.viewer.viewport().cursor().shape()
    return found


def height(made: Any, spot: QPointF, token: str) -> int:
    """How many px of a colour lie above each other around a spot, where most do."""
    image: QImage = made.canvas.viewer.grab().toImage()
    at, wanted = made.hand.pixel(spot), made.canvas.look[token].rgb()
    highest: int = max(
        sum(image.pixelColor(x, y).rgb() == wanted for y in range(at.y() - 20, at.y() + 20))
        for x in range(at.x() - 60, at.x() + 60)
    )
    return highest


@pytest.mark.parametrize("zoom", [1.0, 0.5, 0.4])
def test_a_pipe_is_hit_within_six_px_of_its_line(made: Any, zoom: float) -> None:
    hand = made.hand
    made.canvas.set_zoom(zoom)
    spot = hand.on_pipe(hand.pipe("2", "0"), 0.85)
    for off in (-6, 6):
        made.canvas.clear_selection()
        hand.click(spot + QPointF(0, off / zoom))
        assert made.canvas.selection() == (("state", "2", "event", "0"),)
    hand.click(spot + QPointF(0, 14 / zoom))
    assert made.canvas.selection() != (("state", "2", "event", "0"),)


def test_of_two_pipes_beside_each_other_the_nearer_is_meant(made: Any) -> None:
    hand = made.hand
    made.canvas.set_zoom(0.5)
    first, second = (hand.exit("2", exit) + QPointF(11, 0) for exit in ("0", "1"))
    for spot, exit in ((first, "0"), (second, "1"), (first + QPointF(0, 6), "0")):
        made.canvas.clear_selection()
        hand.click(spot)
        assert made.canvas.selection() == (("state", "2", "event", exit),)


def test_the_mouse_on_a_pipe_marks_it_and_says_all_of_it(made: Any) -> None:
    hand, pipe = made.hand, made.hand.pipe("2", "0")
    plain = made.canvas.viewer.grab().toImage()
    rest(made, hand.on_pipe(pipe, 0.15))
    assert shape(made) == Qt.CursorShape.PointingHandCursor
    assert pipe.toolTip() == "returned\nif patients.0 exists\nleads to 3 names"
    assert made.canvas.viewer.grab().toImage() != plain
    rest(made, QPointF(560, 420))
    assert shape(made) != Qt.CursorShape.PointingHandCursor
    assert made.canvas.viewer.grab().toImage() == plain


def test_a_chip_says_where_it_leads_and_what_clicks_do(made: Any) -> None:
    pipe = made.hand.pipe("2", "timeout")
    rest(made, made.hand.on_pipe(pipe))
    assert "leads to 1 start" in pipe.toolTip()
    assert "Alt" in pipe.toolTip()


def test_an_exit_says_by_the_cursor_that_a_pipe_is_drawn_from_it(made: Any) -> None:
    rest(made, made.hand.exit("2", "1"))
    assert shape(made) == Qt.CursorShape.CrossCursor


def test_a_guard_is_as_high_where_cards_are_small(made: Any) -> None:
    label = made.hand.pipe("2", "0").route.label
    assert label is not None
    heights = []
    for zoom in (1.0, 0.5):
        made.canvas.set_zoom(zoom)
        heights.append(height(made, QPointF(*label), "condition_soft"))
    assert heights[0] >= 10
    assert heights[1] >= 10


def test_names_of_pipes_are_shown_small_only_under_the_mouse(made: Any) -> None:
    hand, pipe = made.hand, made.hand.pipe("3", "1")
    assert pipe.route.label is not None
    made.canvas.set_zoom(0.5)
    spot = QPointF(*pipe.route.label)
    plain = made.canvas.viewer.grab().toImage()
    rest(made, spot)
    shown = made.canvas.viewer.grab().toImage()
    at = hand.pixel(spot)
    # As high as a letter of 11 px, where only a line was.
    rows = [
        y
        for y in range(at.y() - 14, at.y() + 14)
        if any(
            plain.pixelColor(x, y) != shown.pixelColor(x, y)
            for x in range(at.x() - 12, at.x() + 12)
        )
    ]
    assert max(rows) - min(rows) >= 8


def test_chips_that_are_not_shown_are_not_hit(made: Any) -> None:
    pipe = made.hand.pipe("2", "timeout")
    spot = made.hand.on_pipe(pipe)
    made.canvas.set_zoom(0.5)
    made.hand.click(spot)
    assert made.canvas.selection() == ()


@pytest.mark.parametrize("zoom", [1.0, 0.5])
def test_timeouts_are_dashed_at_every_zoom_that_shows_their_way(made: Any, zoom: float) -> None:
    """The loop of state 1 runs below its card."""
    pipe = made.hand.pipe("1", "timeout")
    (ax, y), (bx, _) = pipe.route.points[-3], pipe.route.points[-2]
    made.canvas.set_zoom(zoom)
    image = made.canvas.viewer.grab().toImage()
    left, right = (made.hand.pixel(QPointF(x, y)) for x in (min(ax, bx) + 10, max(ax, bx) - 10))
    ground = made.canvas.look["canvas"].lightness()
    dark = [
        abs(image.pixelColor(x, left.y()).lightness() - ground) > 40
        for x in range(left.x(), right.x())
    ]
    changes = sum(a != b for a, b in pairwise(dark))
    assert changes >= 4


def test_far_out_pipes_that_end_in_chips_are_left_out(made: Any) -> None:
    ends = {i[:2] for i in made.canvas.graph.links if made.hand.pipe(*i[:2]).route.folded}
    assert ("2", "timeout") in ends
    shown = len(made.canvas.graph.links) - len(ends)
    loops = [i for i in made.canvas.graph.links if i[0] == i[2]]
    assert len(made.canvas.graph.lines()[0]) == shown - len(loops)
    made.hand.click(
        made.hand.on_pipe(made.hand.pipe("2", "timeout")), Qt.KeyboardModifier.AltModifier
    )
    made.hand.settle()
    assert len(made.canvas.graph.lines()[0]) == shown - len(loops) + 1


def test_the_name_of_a_pipe_stands_on_whatever_lies_there(desk: Make, small: Application) -> None:
    """The line leaves it free; no ground is painted over a frame."""
    frame = Frame(x=-40, y=-60, width=1000, height=520, color="#0b7a4b")
    made = desk(drawing.add(small, frame))
    pipe = made.hand.pipe("3", "1")
    assert pipe.route.label is not None
    image = made.canvas.viewer.grab().toImage()
    x, y = pipe.route.label
    beside = made.hand.pixel(QPointF(x - pipe.route.room / 2 + 2, y))
    assert image.pixelColor(beside) == image.pixelColor(beside - QPoint(0, 12))
    line = made.hand.pixel(QPointF(x - pipe.route.room / 2 - 6, y))
    assert image.pixelColor(line) != image.pixelColor(beside)


def test_a_way_that_the_robot_took_long_ago_is_a_way_still(made: Any) -> None:
    """The highlight fades, not the pipe under it."""
    spot = made.hand.pixel(made.hand.on_pipe(made.hand.pipe("2", "0"), 0.2))
    ground = made.canvas.look["canvas"].lightness()
    for rank in range(3):
        newer = tuple(Taken("9", str(n), 0.1) for n in range(rank))
        made.canvas.set_live(LiveView(taken=(*newer, Taken("2", "0", 11.0))))
        color = made.canvas.viewer.grab().toImage().pixelColor(spot)
        assert color.lightness() < ground - 80


TAGS = st.sampled_from(["user.name", "patients.0", "a.tag.longer.than.any.pipe.has.room.for"])
GUARDS = st.none() | TAGS.map(
    lambda tag: condition.Condition((condition.Test(tag, "exists", "true"),))
)
NAMES = st.sampled_from(["ok", "clickYes", "次へ", "anEventWithANameLongerThanItsPipe"])


@st.composite
def applications(draw: st.DrawFn) -> Application:
    """Up to nine states without places, and whatever leads from one to another."""
    numbers = [str(n) for n in range(1, draw(st.integers(2, 9)) + 1)]
    goals = st.sampled_from([*numbers, "#back", "#again", "99", None])
    events = st.builds(Event, name=NAMES, next=goals, when=GUARDS)
    timeouts = st.none() | st.builds(Timeout, seconds=st.just(60.0), next=goals)
    states = tuple(
        State(no=no, events=tuple(draw(st.lists(events, max_size=4))), timeout=draw(timeouts))
        for no in numbers
    )
    return Application(name="any", states=states)


@settings(
    max_examples=40,
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)
@given(document=applications())
def test_every_transition_of_any_drawing_can_be_seen(made: Any, document: Application) -> None:
    """It has a way or a chip, no way crosses a card, and no name lies on a card or a name."""
    made.change(document)
    canvas = made.canvas
    cards = [canvas.card_area(uid) for uid in canvas.graph.cards]
    taken: list[QRectF] = []
    for card in canvas.graph.cards.values():
        for leaving in card.exits:
            assert leaving.next is None or leaving.short or made.hand.pipe(card.uid, leaving.id)
    for id in canvas.graph.links:
        pipe = canvas.graph.pipe(id)
        assert pipe.route.folded or len(pipe.route.points) > 1
        assert not pipe.shape().isEmpty() or pipe.route.trunk is not None
        for a, b in pairwise(pipe.route.points):
            line = QRectF(QPointF(*a), QPointF(*b)).normalized().adjusted(-0.5, -0.5, 0.5, 0.5)
            inside = line.adjusted(1, 0, -1, 0) if a[1] == b[1] else line.adjusted(0, 1, 0, -1)
            assert not any(inside.intersects(card.adjusted(1, 1, -1, -1)) for card in cards)
        if pipe.label_area() is not None:
            assert pipe.label_area().width() <= pipe.route.room + 1
            assert not any(pipe.label_area().intersects(area) for area in (*cards, *taken))
            taken.append(pipe.label_area())
