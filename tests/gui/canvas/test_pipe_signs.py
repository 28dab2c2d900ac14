"""What is wrong with a transition or a priority is seen on its pipe, told there, and leads to its
mends; numbers on pipes can be read, or are not shown.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QImage
from PySide6.QtTest import QSignalSpy
from tests.gui.canvas.script_desk import pipe
from tests.gui.canvas.test_pipes import rest

from situ.document.problem import Problem
from situ.document.rbd import Application
from situ.document.spds import Declaration, Entry, Situation, Spds
from situ_studio.canvas.curves import CurvedPipe
from situ_studio.canvas.pipe_labels import LEAST
from situ_studio.canvas.script import ScriptCanvas


def wrong(*place: str, severity: Any = "warning", message: str = "Never taken") -> Problem:
    return Problem(file="x", severity=severity, code="c", message=message, place=place)


def seen(made: Any) -> QImage:
    made.hand.settle()
    found: QImage = made.canvas.viewer.viewport().grab().toImage()
    return found


def has(picture: QImage, made: Any, area: QRectF, token: str) -> bool:
    """Whether a colour is painted in an area of the scene."""
    wanted = made.canvas.look[token]
    box = made.canvas.viewer.mapFromScene(area).boundingRect()
    return any(
        abs(wanted.red() - one.red()) < 12
        and abs(wanted.green() - one.green()) < 12
        and abs(wanted.blue() - one.blue()) < 12
        for x in range(box.left(), box.right())
        for y in range(box.top(), box.bottom())
        for one in [picture.pixelColor(x, y)]
    )


def test_a_transition_with_a_problem_has_a_sign_on_its_pipe_that_asks_for_mends(
    desk: Callable[..., Any], small: Application
) -> None:
    made = desk(small)
    asked = QSignalSpy(made.canvas.mends_asked)
    place = ("state", "4", "event", "0")
    back, other = made.hand.pipe("4", "0"), made.hand.pipe("4", "1")
    assert back.sign_area().isEmpty()
    made.canvas.show_document(small, [wrong(*place)])
    assert back.sign_area().width() == 16
    assert other.sign_area().isEmpty()
    assert has(seen(made), made, back.sign_area(), "warning")
    made.canvas.show_document(small, [wrong(*place, severity="error")])
    assert has(seen(made), made, back.sign_area(), "error")
    spot = back.sign_area().center()
    rest(made, spot)
    assert "Never taken" in back.toolTip().splitlines()
    made.hand.click(spot)
    assert made.canvas.selection() == (place,)
    assert asked.count() == 1
    # Elsewhere on the pipe nothing is asked.
    made.canvas.clear_selection()
    made.hand.click(made.hand.on_pipe(back, 0.9))
    assert made.canvas.selection() == (place,)
    assert asked.count() == 1
    made.canvas.show_document(small, [])
    assert back.sign_area().isEmpty()


def test_of_events_that_share_a_pipe_the_worst_is_shown_once_and_chosen(
    desk: Callable[..., Any], small: Application
) -> None:
    made = desk(small)
    first, second = made.hand.pipe("1", "0"), made.hand.pipe("1", "1")
    leader, joining = (first, second) if first.route.trunk is None else (second, first)
    assert joining.route.trunk is not None
    found = [
        wrong("state", "1", "event", leader.link.exit),
        wrong("state", "1", "event", joining.link.exit, severity="error", message="Twice"),
    ]
    made.canvas.show_document(small, found)
    assert joining.sign_area().isEmpty()
    assert has(seen(made), made, leader.sign_area(), "error")
    rest(made, leader.sign_area().center())
    assert {"Never taken", "Twice"} <= set(leader.toolTip().splitlines())
    made.hand.click(leader.sign_area().center())
    assert made.canvas.selection() == (("state", "1", "event", joining.link.exit),)


def test_a_sign_is_as_large_where_cards_are_small(
    desk: Callable[..., Any], small: Application
) -> None:
    made = desk(small)
    made.canvas.show_document(small, [wrong("state", "4", "event", "0")])
    made.canvas.set_zoom(0.5)
    area = made.hand.pipe("4", "0").sign_area()
    assert area.width() * 0.5 >= LEAST
    assert has(seen(made), made, area, "warning")


def test_a_sign_lies_above_other_pipes_from_the_first(
    desk: Callable[..., Any], small: Application
) -> None:
    made = desk(replace(small, states=()))
    made.canvas.show_document(small, [wrong("state", "4", "event", "0")])
    signed = made.hand.pipe("4", "0")
    others = {made.canvas.graph.pipe(id) for id in made.canvas.graph.links} - {signed}
    assert others
    assert all(one.zValue() < signed.zValue() for one in others)


@pytest.fixture
def script(desk: Callable[..., Any]) -> Any:
    """Two situations that give three modules numbers: where some have no room to be larger."""
    every = ("nod", "look", "talk")
    modules = tuple(Declaration(name, ("head",)) for name in every)
    situations = tuple(
        Situation(name, entries=tuple(Entry(m, 10 * (n + 1)) for n, m in enumerate(every)))
        for name in ("busy", "rest")
    )
    return desk(Spds(name="ward", modules=modules, situations=situations), ScriptCanvas)


def test_a_priority_with_a_problem_tells_it_and_its_sign_asks_for_mends(script: Any) -> None:
    asked = QSignalSpy(script.canvas.mends_asked)
    place = ("situation", "rest", "entry", "1")
    told = wrong(*place, message="Never wins")
    script.canvas.show_document(script.document, [told])
    found = pipe(script, "situation rest", "module look")
    assert has(seen(script), script, found.sign_area(), "warning")
    rest(script, found.sign_area().center())
    assert found.toolTip().splitlines() == ["look has priority 20 in rest", "Never wins"]
    script.hand.click(found.sign_area().center())
    assert script.canvas.selection() == (place,)
    assert asked.count() == 1
    priorities = script.canvas.priorities
    assert not priorities.editor
    # On the number itself it is typed anew.
    script.hand.click(found.pill().center() - QPointF(10, 0))
    assert asked.count() == 1
    assert priorities.editor
    priorities.editor.close_editor()
    # A card tells what is wrong with it, too.
    script.canvas.show_document(script.document, [wrong("module", "nod", message="Nobody has it")])
    assert "Nobody has it" in script.canvas.graph.cards["module nod"].hint().splitlines()


def test_numbers_of_small_drawings_can_be_read_or_are_not_shown(script: Any) -> None:
    pipes: list[CurvedPipe] = [
        script.canvas.graph.pipe(id) for id in script.canvas.graph.links if id[0].startswith("sit")
    ]
    assert {one.roomy for one in pipes} == {True, False}
    shown = [one for one in pipes if one.roomy]
    for zoom, larger in ((1.0, 1.0), (0.5, 1.8)):
        script.canvas.set_zoom(zoom)
        boxes = [one.painted_pill() for one in (pipes if zoom == 1.0 else shown)]
        assert all(abs(b.height() - 18 * larger) <= 9 for b in boxes)
        apart = [a.intersects(b) for n, a in enumerate(boxes) for b in boxes[:n]]
        assert zoom == 1.0 or not any(apart)
    for one in pipes:
        assert one.painted_pill().isEmpty() is not one.roomy
    # The one that is pointed at is shown whole all the same; nothing is where cards are smaller.
    hidden = next(one for one in pipes if not one.roomy)
    hidden.hovered = True
    assert not hidden.painted_pill().isEmpty()
    script.canvas.set_zoom(0.25)
    assert all(one.painted_pill().isEmpty() for one in pipes)
