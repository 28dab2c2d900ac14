"""Care with whoever stands there: what the lints must find, and what they must leave alone."""

from __future__ import annotations

import pytest
from tests.document.care_projects import (
    BUTTON,
    MORNING,
    TOUCHED,
    WIDE,
    always,
    app,
    mended,
    places,
    state,
    told,
    whole,
)

from situ.document.project import Project

START = state(BUTTON, events=TOUCHED)
BACK = '<event name="home" next="1"><say>home</say></event>'
TIMED_OUT = '<event name="timeout" next="1"/>'


def idle(seconds: float, to: str = "1") -> str:
    return f'<timeout next="{to}" idle="true">{seconds}</timeout>'


# -- finding back ------------------------------------------------------------------


@pytest.mark.parametrize(
    ("second", "is_told"),
    [
        (state(BUTTON, rest=idle(30), no="2"), True),
        (state(BUTTON, rest=idle(10), no="2"), False),
        # What is said is not waited for.
        (state(acts=MORNING, rest='<timeout next="1">12</timeout>', no="2"), False),
        (state(acts=MORNING, rest='<timeout next="1">13</timeout>', no="2"), True),
        (state(acts=MORNING, rest=idle(12), no="2"), True),
        (
            state(rest="<timeout>30</timeout>", events='<event name="timeout" next="1"/>', no="2"),
            True,
        ),
        # A hand, an end, anything else.
        (state(rest=idle(30), events=BACK, no="2"), False),
        (state(rest=idle(30), events='<event name="home" next="#back"/>', no="2"), False),
        (state(rest=idle(30), events='<event name="arrived" next="1"/>', no="2"), False),
        (state(rest=idle(30), no="2", attributes='final="true"'), False),
        (state(no="2"), False),
        # It leads on to where a hand leads back.
        (
            state(rest=idle(30), events='<event name="click" next="3"/>', no="2")
            + state(events=BACK, no="3"),
            False,
        ),
        # Nothing at all leads back: another warning says so.
        (
            state(events='<event name="a" next="3"/>', no="2")
            + state(events='<event name="a" next="2"/>', no="3"),
            False,
        ),
    ],
)
def test_a_state_from_which_only_waiting_leads_back_is_told(second: str, is_told: bool) -> None:
    found = places(whole(START + second), "no-way-back-by-hand")
    assert found == ([("state", "2")] if is_told else [])


def test_home_in_always_leads_back_where_always_does() -> None:
    home = always(events=BACK)
    waits = state(BUTTON, rest=idle(30), no="2")
    assert told(whole(home + START + waits), "no-way-back-by-hand") == []
    apart = state(BUTTON, rest=idle(30), no="2", attributes='always="false"')
    assert told(whole(home + START + apart), "no-way-back-by-hand") != []


def test_where_nobody_can_do_anything_nobody_is_caught() -> None:
    start = state(events='<event name="fall" next="2"/>')
    assert told(whole(start + state(rest=idle(30), no="2")), "no-way-back-by-hand") == []


def test_a_state_that_is_not_reached_catches_nobody() -> None:
    start = state(BUTTON, events='<event name="click" next="#again"/>')
    assert told(whole(start + state(rest=idle(30), no="2")), "no-way-back-by-hand") == []


def test_nobody_is_told_to_be_caught_in_a_part() -> None:
    part = app(START + state(rest=idle(30), no="2"), "part")
    flow = '<state no="1"><flow src="part1.rbd.xml"/></state>'
    assert told(whole(flow, part), "no-way-back-by-hand") == []


def test_an_application_without_a_start_is_left_to_the_error() -> None:
    assert told(whole("<!-- nothing -->"), "no-way-back-by-hand") == []


# -- private data ------------------------------------------------------------------

NAME = f'<text id="t" {WIDE}>Hello {{user.name}}</text>'
NAMED = "<speech>Hello {user.name}</speech>"


def private(*applications: str, code: str, pattern: str = "user.**") -> list[tuple[str, ...]]:
    project = whole(*applications, private=(pattern,), tags={"user.name": "Ann"})
    return places(project, code)


SPOKEN = ("state", "1", "action", "0")


@pytest.mark.parametrize(
    ("pattern", "acts", "is_told"),
    [
        ("user.**", NAMED, True),
        ("user", NAMED, True),
        ("*.name", NAMED, True),
        ("user.name.first", NAMED, False),
        ("other", NAMED, False),
        ("user.**", "<speech>Hello {{user.name}}</speech>", False),
        ("user.**", '<message topic="a">{user.name}</message>', False),
    ],
)
def test_private_data_spoken_in_the_start_state_is_told(
    pattern: str, acts: str, is_told: bool
) -> None:
    found = private(state(acts=acts), code="private-spoken", pattern=pattern)
    assert found == ([SPOKEN] if is_told else [])


@pytest.mark.parametrize(
    ("events", "is_told"),
    [
        # Somebody has done something.
        (TOUCHED, False),
        ('<event name="hello" next="2"><say>hello</say></event>', False),
        # Anybody may have come by.
        ('<event name="humanDetected" next="2"/>', True),
        ('<event next="2"><when><data tag="distance" below="2"/></when></event>', True),
    ],
)
def test_private_data_is_spoken_to_who_has_shown_to_be_there(events: str, is_told: bool) -> None:
    second = state(acts=NAMED, rest=idle(30), no="2")
    found = private(state(BUTTON, events=events) + second, code="private-spoken")
    assert found == ([("state", "2", "action", "0")] if is_told else [])


def test_after_an_idle_timeout_nobody_is_there() -> None:
    second = state(rest=idle(30, "3"), events='<event name="click" next="1"/>', no="2")
    third = state(acts=NAMED, rest=idle(30), no="3")
    assert private(START + second + third, code="private-spoken") != []
    raised = state(
        rest='<timeout idle="true">30</timeout>', events=TIMED_OUT.replace("1", "3"), no="2"
    )
    assert private(START + raised + third, code="private-spoken") != []
    # Who waits for an answer is still there.
    busy = state(rest='<timeout next="3">5</timeout>', no="2")
    assert private(START + busy + third, code="private-spoken") == []


def test_an_event_that_something_else_raises_leads_nobody_here() -> None:
    """A state expects ``found``, but only the one after a touch runs what raises it."""
    start = state(BUTTON, events=TOUCHED + '<event name="found" next="3"/>')
    acts = '<service name="s" url="http://a/b" done="found"/>'
    second = state(acts=acts, events='<event name="found" next="3"/>', no="2")
    third = state(acts=NAMED, rest=idle(30), no="3")
    assert private(start + second + third, code="private-spoken") == []


@pytest.mark.parametrize(
    ("screen", "acts"),
    [
        ("", '<sound src="http://a/b.ogg" done="over"/>'),
        ("", '<sound src="http://a/b.ogg" failed="over"/>'),
        (f'<movie id="m" {WIDE} src="http://a/b.webm" done="over"/>', ""),
        (f'<movie id="m" {WIDE} src="http://a/b.webm" failed="over"/>', ""),
    ],
)
def test_what_ends_by_itself_shows_nobody_to_be_there(screen: str, acts: str) -> None:
    """``other`` is raised in the second state only: it leads nobody from here to the third."""
    over = '<event name="over" next="2"/><event name="other" next="3"/>'
    start = state(screen + BUTTON, acts, over + '<event name="click" next="3"/>')
    second = state("", NAMED.replace(">", ' done="other">', 1), rest=idle(9), no="2")
    third = state(acts=NAMED, rest=idle(9), no="3")
    found = private(start + second + third, code="private-spoken")
    assert found == [("state", "2", "action", "0")]


@pytest.mark.parametrize(
    ("component", "is_told"),
    [
        (NAME, True),
        (f'<text id="t" {WIDE}>Hello</text>', False),
        (f'<button id="t" {WIDE} event="e">{{user.name}}</button>', True),
        (f'<image id="t" {WIDE} src="http://a/{{user.face}}"/>', True),
        (f'<list id="t" {WIDE} items="user.pills" label="{{item}}"/>', True),
        (f'<input id="t" {WIDE} tag="user.name"/>', True),
        (f'<input id="t" {WIDE} tag="user.pin" kind="pin"/>', False),
    ],
)
def test_private_data_shown_in_the_start_state_is_told(component: str, is_told: bool) -> None:
    found = private(state(component), code="private-shown")
    assert found == ([("state", "1", "screen", "t")] if is_told else [])


def test_what_always_shows_is_told_once_and_only_where_it_is_shown() -> None:
    shared = always(NAME)
    detected = state(events='<event name="humanDetected" next="2"/>')
    found = private(shared + detected + state(rest=idle(9), no="2"), code="private-shown")
    assert found == [("always", "screen", "t")]
    apart = state(BUTTON, events=TOUCHED, attributes='always="false"')
    assert private(shared + apart + state(events=BACK, no="2"), code="private-shown") == []


@pytest.mark.parametrize(
    ("start", "is_told"),
    [
        ("", True),
        ("<screen/>", False),
        (BUTTON, False),
    ],
)
def test_a_screen_with_private_data_that_is_kept_where_anyone_passes_is_told(
    start: str, is_told: bool
) -> None:
    """The start state is entered by touch, over a state that keeps the screen as well."""
    first = state(start, events='<event name="click" next="2"><say>go</say></event>')
    second = state(NAME, events=BACK.replace('"1"', '"3"'), no="2")
    third = state(events=BACK, no="3")
    found = private(first + second + third, code="private-shown")
    assert found == ([("state", "1")] if is_told else [])


def test_a_kept_screen_without_private_data_is_not_told() -> None:
    first = state(events='<event name="click" next="2"><say>go</say></event>')
    other = state(f'<text id="t" {WIDE}>Hello {{weather}}</text>', events=BACK, no="2")
    flow = '<state no="3"><flow src="part1.rbd.xml"/><expectedevents>' + BACK
    flow += "</expectedevents></state>"
    assert private(first + other, code="private-shown") == []
    assert private(first + flow, state(NAME) + state(no="2"), code="private-shown") == []


def test_a_state_that_goes_on_by_itself_keeps_nothing() -> None:
    first = state(events=TOUCHED + '<event next="4"/>')
    second = state(NAME, events=BACK, no="2")
    fourth = state(BUTTON, events=TOUCHED, no="4")
    assert private(first + second + fourth, code="private-shown") == []


def test_a_screen_with_private_data_that_only_a_hand_takes_away_is_told() -> None:
    second = state(NAME, events=BACK, no="2")
    project = whole(START + second, private=("user.**",), tags={"user.name": "Ann"})
    (problem,) = told(project, "private-stays")
    assert problem.place == ("state", "2", "screen")
    after = mended(project, problem)
    assert told(after, "private-stays") == []
    timeout = after.applications["a0.rbd.xml"].states[1].timeout
    assert timeout is not None
    assert (timeout.seconds, timeout.next, timeout.idle) == (60, "1", True)


@pytest.mark.parametrize(
    ("second", "is_told"),
    [
        (state(NAME, events=BACK, rest=idle(60), no="2"), False),
        (
            state(
                NAME,
                events=BACK + '<event next="1"><when><data tag="a" is="1"/></when></event>',
                no="2",
            ),
            False,
        ),
        (state(BUTTON, events=BACK, no="2"), False),
        (state(events=BACK, no="2"), False),
        # A timeout that leads nowhere: nothing to mend by machine.
        (state(NAME, events=BACK, rest="<timeout>5</timeout>", no="2"), True),
    ],
)
def test_private_data_does_not_stay_where_something_takes_it_away(
    second: str, is_told: bool
) -> None:
    project = whole(START + second, private=("user.**",), tags={"user.name": "Ann"})
    found = told(project, "private-stays")
    assert [problem.mend for problem in found] == ([None] if is_told else [])


def test_in_a_part_anyone_passes_where_its_holder_is_passed() -> None:
    def of(events: str) -> Project:
        flow = '<state no="2"><flow src="part1.rbd.xml"/><expectedevents>' + BACK
        holder = state(BUTTON, events=events) + flow + "</expectedevents></state>"
        part = app(state(NAME, NAMED, '<event name="x" next="2"/>') + state(no="2"), "part")
        return whole(holder, part, private=("user.**",), tags={"user.name": "Ann"})

    touched, detected = of(TOUCHED), of('<event name="humanDetected" next="2"/>')
    for code in ("private-spoken", "private-shown", "private-stays"):
        assert told(touched, code) == []
    assert [p.file for p in told(detected, "private-spoken")] == ["nowhere/part1.rbd.xml"]
    # The end of a part keeps the screen, but it is left at once.
    assert places(detected, "private-shown") == [("state", "1", "screen", "t")]


def test_without_private_data_nothing_is_told() -> None:
    project = whole(state(NAME, NAMED), tags={"user.name": "Ann"})
    assert told(project, "private-spoken") + told(project, "private-shown") == []


@pytest.mark.parametrize(
    ("holder", "is_told"),
    [
        # The part ends by itself; a state without one is not left so, whatever it expects.
        ('<flow src="a1.rbd.xml"/>', True),
        ("", False),
    ],
)
def test_the_end_of_a_part_shows_nobody_to_be_there(holder: str, is_told: bool) -> None:
    first = state(rest=holder, events='<event name="done.2" next="2"/>')
    part = state(events='<event name="seen" next="2"/>') + state(no="2")
    found = private(first + state(acts=NAMED, rest=idle(9), no="2"), part, code="private-spoken")
    assert found == ([("state", "2", "action", "0")] if is_told else [])


@pytest.mark.parametrize(
    ("done", "is_told"),
    [
        ('<event name="done.gone" next="3"/>', True),
        ('<event name="done" next="3"/>', True),
        ('<event name="done.2" next="3"/><event name="done" next="1"/>', False),
        ('<event name="done.2" next="3"/>', False),
        ('<event name="done.gone"/>', False),
    ],
)
def test_who_has_left_a_part_alone_is_not_there_after_it(done: str, is_told: bool) -> None:
    holder = state(rest='<flow src="a1.rbd.xml"/>', events=done, no="2")
    third = state(acts=NAMED, rest=idle(9), no="3")
    asks = state(BUTTON, events=TOUCHED, rest=idle(30, "gone"))
    part = asks + state(no="2") + state(no="gone")
    found = private(START + holder + third, part, code="private-spoken")
    assert found == ([("state", "3", "action", "0")] if is_told else [])


def test_who_has_done_something_in_a_part_is_there_after_it() -> None:
    """As where the part's states stand in the application itself."""
    part = app(state(BUTTON, events='<event name="click" next="9"/>') + state(no="9"), "part")
    shows = '<text id="t" x="0" y="0" width="50" height="20">{user.name}</text>'
    holder = state(
        rest='<flow src="part1.rbd.xml"/>', events='<event name="done.9" next="3"/>', no="2"
    )
    outer = state(BUTTON, events=TOUCHED) + holder + state(shows, rest=idle(20, "2"), no="3")
    assert told(whole(app(outer), part, private=("user.**",)), "private-shown") == []
