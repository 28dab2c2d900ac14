"""What one click adds to every state: Home and Repeat buttons that are in nobody's way."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace
from tests.document.care_projects import (
    BUTTON,
    MORNING,
    TOUCHED,
    always,
    app,
    mended,
    state,
    told,
    whole,
)

from situ.document.check import check
from situ.document.project import Project
from situ.document.rbd import Application

WAITS = '<timeout next="1" idle="true">30</timeout>'
EDGES = st.integers(0, 75)
SIZE = st.integers(10, 25)


def button(number: int, x: int, y: int, width: int, height: int) -> str:
    box = f'x="{x}" y="{y}" width="{width}" height="{height}"'
    return f'<button id="b{number}" {box} event="click">Yes</button>'


def asking(*buttons: str, before: str = "") -> str:
    """State 1 asks; from state 2 only waiting leads back: both lints have something to say."""
    screen = "".join(buttons) or BUTTON
    return before + state(screen, MORNING, TOUCHED) + state(screen, rest=WAITS, no="2")


def first(project: Project) -> Application:
    return project.applications["a0.rbd.xml"]


def both(project: Project) -> Project:
    for code in ("no-repeat", "no-way-back-by-hand"):
        (problem,) = told(project, code)
        project = mended(project, problem)
    return project


@settings(max_examples=25, deadline=None)
@given(st.lists(st.tuples(EDGES, EDGES, SIZE, SIZE), min_size=1, max_size=6))
def test_the_mends_take_the_warnings_away_and_make_no_new_one(
    boxes: list[tuple[int, int, int, int]],
) -> None:
    project = whole(asking(*(button(n, *box) for n, box in enumerate(boxes))))
    before = {(p.code, p.place) for p in check(project)}
    after = {(p.code, p.place) for p in check(both(project))}
    gone = {code for code, _ in before} - {code for code, _ in after}
    assert {"no-repeat", "no-way-back-by-hand"} <= gone
    assert after <= before


def test_a_home_button_leads_to_the_start_and_a_repeat_button_says_it_again() -> None:
    shared = first(both(whole(asking()))).always
    assert shared is not None
    assert shared.screen is not None
    assert [(e.name, e.next) for e in shared.events] == [("clickRepeat", None), ("clickHome", "1")]
    assert [one.element for one in shared.events[0].actions] == ["repeat"]
    assert {(c.text, c.event) for c in shared.screen.components} == {  # type: ignore[attr-defined]
        ("Home", "clickHome"),
        ("Repeat", "clickRepeat"),
    }


def test_the_buttons_are_called_in_the_language_of_the_project() -> None:
    project = replace(whole(asking()), languages=("ja", "en"))
    shared = first(both(project)).always
    assert shared is not None
    assert shared.screen is not None
    named = {(c.id, c.text, c.event) for c in shared.screen.components}  # type: ignore[attr-defined]
    assert named == {("home", "ホーム", "clickHome"), ("repeat", "もう一度", "clickRepeat")}


@pytest.mark.parametrize(
    "before",
    [
        always(BUTTON.replace('"b"', '"home"').replace("Yes", "x").replace("30", "60", 1)),
        always(events='<event name="clickHome"/>'),
        always("<screen/>"),
        always(rest=WAITS),
    ],
)
def test_what_every_state_has_already_stays(before: str) -> None:
    was = first(whole(asking(before=before))).always
    project = both(whole(asking(before=before)))
    now = first(project).always
    assert was is not None
    assert now is not None
    assert now.events[: len(was.events)] == was.events
    assert now.timeout == was.timeout
    if was.screen is not None and now.screen is not None:
        assert now.screen.components[: len(was.screen.components)] == was.screen.components
    assert not [p for p in check(project) if p.severity == "error"]
    assert told(project, "no-repeat") == told(project, "no-way-back-by-hand") == []


@pytest.mark.parametrize("screen", ["", button(0, 0, 0, 100, 100)])
def test_without_room_on_the_screens_it_is_a_phrase(screen: str) -> None:
    click = '<event name="click" next="2"><say>yes</say></event>'
    project = whole(state(screen, MORNING, click) + state(screen, rest=WAITS, no="2"))
    after = both(project)
    shared = first(after).always
    assert shared is not None
    assert shared.screen is None
    assert [say.text for event in shared.events for say in event.says] == ["repeat", "home"]
    assert told(after, "no-repeat") == told(after, "no-way-back-by-hand") == []


def test_a_picture_may_lie_beneath_the_button() -> None:
    picture = '<image id="p" x="0" y="0" width="100" height="100" src="http://a/b.png"/>'
    shared = first(both(whole(asking(picture, BUTTON)))).always
    assert shared is not None
    assert shared.screen is not None


def test_the_buttons_of_what_holds_a_part_lie_on_nothing_of_the_part() -> None:
    corner = button(7, 0, 0, 60, 60).replace('"click"', '"other"')
    part = app(state(corner, events='<event name="other" next="2"/>') + state(no="2"), "part")
    flow = '<state no="3"><flow src="part1.rbd.xml"/></state>'
    project = both(whole(asking() + flow, part))
    shared = first(project).always
    assert shared is not None
    assert shared.screen is not None
    home = shared.screen.components[1]
    assert home.x >= 60 or home.y >= 60


def test_a_state_without_what_every_state_has_gets_no_such_mend() -> None:
    apart = state(BUTTON, MORNING, TOUCHED, attributes='always="false"')
    (problem,) = told(whole(apart + state(no="2")), "no-repeat")
    assert problem.mend is None
