"""A script with very many pipes: what is seen follows an edit at once, the rest soon."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from PySide6.QtCore import QPointF
from PySide6.QtWidgets import QApplication
from tests.gui.canvas.script_desk import agree, body, holds

from situ.document.spds import Declaration, Entry, Observed, Situation, Spds
from situ_studio.canvas import script_gestures as gestures
from situ_studio.canvas.paper import Paper
from situ_studio.canvas.script import ScriptCanvas
from situ_studio.looks.theme import LIGHT

MANY = 70


@pytest.fixture
def made(desk: Callable[..., Any]) -> Any:
    script = Spds(
        name="many",
        observe=tuple(Observed(f"d{number}", "boolean") for number in range(MANY)),
        modules=(Declaration("nod", ("head",)), Declaration("talk", ("speech",))),
        situations=(
            *(
                Situation(f"s{n}", condition=holds(f"d{n}"), entries=(Entry("nod", n),))
                for n in range(MANY)
            ),
            Situation("rest", entries=(Entry("talk", 10),)),
        ),
    )
    made = desk(script, ScriptCanvas)
    settle(made.canvas)
    return made


def settle(canvas: Any) -> None:
    while canvas.filling.is_filling or canvas.curving.is_curving():
        QApplication.processEvents()


def astray(canvas: Any) -> list[tuple[str, ...]]:
    """The pipes that do not lead from the one end to the other."""
    found = []
    for id, link in canvas.graph.links.items():
        ends = canvas.port_at(link.source, link.exit), canvas.port_at(link.target, link.entry)
        if canvas.graph.pipe(id).route.points != tuple((end.x(), end.y()) for end in ends):
            found.append(id)
    return found


def in_sight(canvas: Any, ids: list[tuple[str, ...]]) -> list[tuple[str, ...]]:
    """Those of which a card can be seen, or the pipe as it is painted."""
    shown, links = set(canvas.cards_in_view()), canvas.graph.links
    return [
        id
        for id in ids
        if {links[id].source, links[id].target} & shown
        or canvas.graph.pipe(id).boundingRect().intersects(canvas.viewer.seen())
    ]


def test_an_edit_moves_the_pipes_in_sight_at_once_and_all_others_soon(made: Any) -> None:
    canvas = made.canvas
    assert astray(canvas) == []
    canvas._edit(*gestures.add_situation(canvas.document, 0, "d0")[:2])
    late = astray(canvas)
    assert late
    assert in_sight(canvas, late) == []
    settle(canvas)
    assert astray(canvas) == []
    agree(made)


def test_what_an_edit_leaves_astray_is_mended_after_the_next_one(made: Any) -> None:
    """A pipe that waits may be gone by then, or moved again."""
    canvas = made.canvas
    canvas._edit(*gestures.add_situation(canvas.document, 0, "d0")[:2])
    assert canvas.curving.is_curving()
    canvas._edit(*gestures.delete(canvas.document, [("situation", f"s{MANY - 1}")]))
    canvas._edit(*gestures.set_seconds(canvas.document, "s0", "dwell", 2))
    settle(canvas)
    assert astray(canvas) == []
    agree(made)


def test_a_situation_dragged_in_a_large_script_takes_its_pipes_along_at_once(made: Any) -> None:
    start = body(made, "situation s3")
    made.hand.drag(start, start - QPointF(0, 160))
    assert made.edits == ["Move s3 to place 2"]
    assert astray(made.canvas) == []
    agree(made)


def test_on_paper_all_pipes_have_their_ways(made: Any) -> None:
    paper = Paper(ScriptCanvas(LIGHT), made.document, made.canvas)
    assert astray(paper._canvas) == []
    paper.close()
