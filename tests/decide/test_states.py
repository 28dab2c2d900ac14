"""formats.md, *States*."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tests.decide.conftest import Play

TWO = '<state no="1"/><state no="2"/>'


def test_without_start_the_first_state_starts(play: Play) -> None:
    assert play(TWO, []).lines("enter") == ["0 enter app 1 <-"]


def test_start_names_the_state_that_starts(play: Play) -> None:
    trace = play(f'<application name="app" start="2">{TWO}</application>', [])
    assert trace.lines() == ["0 enter app 2 <-"]


def test_numbers_are_tokens(play: Play) -> None:
    rbd = """<state no="main-menu"><expectedevents><event name="go" next="5.a"/></expectedevents>
             </state><state no="5.a"/>"""
    trace = play(rbd, [{"at": 1, "event": "go"}])
    assert trace.states() == [(0, "main-menu"), (1, "5.a")]


def test_the_name_is_what_designers_see(play: Play) -> None:
    rbd = '<state no="1" name="start"><backgroundactions>{}</backgroundactions></state>'
    trace = play(rbd.format('<set tag="seen">{application/app.name}</set>'), [])
    assert trace.values("seen") == ["start"]


def test_an_end_state_stays(play: Play) -> None:
    rbd = """<state no="1"><expectedevents><event name="go" next="2"/></expectedevents></state>
             <state no="2" final="true"/>"""
    trace = play(rbd, [{"at": 1, "event": "go"}, {"at": 2, "event": "go"}])
    assert trace.lines(since=2) == [
        "2 event app go <-",
        "2 ignored app go unexpected <event",
    ]
