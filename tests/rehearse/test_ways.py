"""The ways out of a state as formats.md has them: parts inwards out, ``always`` after states."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from situ.document import codec
from situ.document.project import Project
from situ.document.rbd import Application
from situ.rehearse.coverage import Coverage
from situ.rehearse.reason import lines
from situ.rehearse.recording import Fields, Recording
from situ.rehearse.ways import frames, name_of_state, states, ways
from situ.rehearse.why import why_not

if TYPE_CHECKING:
    from tests.rehearse.conftest import Make

OUTER = """<application name="shop">
<always><timeout next="1">60</timeout><expectedevents><event name="home" next="1"/>
</expectedevents></always>
<state no="1" name="start"><expectedevents><event name="go" next="5"/></expectedevents></state>
<state no="5" name="register"><flow src="part.rbd.xml"/><expectedevents>
  <event name="done.end" next="1"/><event name="yes" next="1"/></expectedevents></state>
<state no="6" name="quiet" always="false"><flow src="part.rbd.xml"/></state>
</application>"""
PART = """<application name="part">
<always><expectedevents><event name="repeat"><repeat/></event></expectedevents></always>
<state no="ask" name="name"><expectedevents><event name="yes" next="end"/>
  <event name="undo" next="#back"/></expectedevents></state>
<state no="more" always="false"><timeout next="ask">9</timeout></state>
<state no="end"/></application>"""


def _part(text: str) -> Application:
    document, _ = codec.read(text.encode(), "part.rbd.xml")
    assert isinstance(document, Application)
    return document


@pytest.fixture
def shop(make: Make) -> Project:
    return make(OUTER, parts={"part.rbd.xml": _part(PART)})


def _told(project: Project, no: str) -> list[str]:
    return [f"{way.source}: {way.exit} → {way.to}" for way in ways(project, "shop", no)]


def test_events_of_the_innermost_state_come_first_each_always_after_its_file(shop: Project) -> None:
    assert _told(shop, "5/ask") == [
        "5/ask: yes → 5/end",
        "5/ask: undo → #back",
        "always: repeat → None",
        "5: done.end → 1",
        "5: yes → 1",
        "always: home → 1",
        "always: timeout → 1",
    ]


def test_a_timeout_of_its_own_serves_and_always_is_left_out_where_it_says_so(shop: Project) -> None:
    assert _told(shop, "5/more")[-1] == "5/more: timeout → 5/ask"
    assert "always: repeat → None" not in _told(shop, "5/more")
    assert _told(shop, "6/end") == ["always: repeat → None"]


def test_states_of_parts_stand_behind_the_state_that_holds_them(shop: Project) -> None:
    assert [frame.no for frame in states(shop, "shop")] == [
        "1", "5", "5/ask", "5/more", "5/end", "6", "6/ask", "6/more", "6/end",
    ]  # fmt: skip
    assert [(f.file, f.no, f.before) for f in frames(shop, "shop", "5/ask")] == [
        ("0.rbd.xml", "5", ""), ("part.rbd.xml", "5/ask", "5/"),
    ]  # fmt: skip
    assert name_of_state(shop, "shop", "5/ask") == "5/ask name"
    assert frames(shop, "shop", "5/none") == frames(shop, "none", "5") == []
    assert list(states(shop, "none")) == []


def test_a_circle_of_parts_ends(make: Make) -> None:
    circle = PART.replace('<state no="end"/>', '<state no="end"><flow src="part.rbd.xml"/></state>')
    project = make(OUTER, parts={"part.rbd.xml": _part(PART)})
    project.parts["part.rbd.xml"] = _part(circle)
    assert [f.no for f in frames(project, "shop", "5/end/ask")] == []
    assert "5/end" in [frame.no for frame in states(project, "shop")]
    project.parts.clear()
    assert [frame.no for frame in states(project, "shop")] == ["1", "5", "6"]


Told = tuple[str, dict[str, str]]


def _trace(*events: Told) -> Recording:
    told: list[Fields] = []
    for seq, (kind, fields) in enumerate(events, 1):
        cause = None if kind == "event" or not told else seq - 1
        common: Fields = {"seq": seq, "t": float(seq), "kind": kind, "cause": cause}
        told.append({**common, "application": "shop", **fields})
    return Recording.of(told)


def _go(source: str, to: str, event: str) -> list[Told]:
    return [
        ("event", {"name": event}),
        ("exit", {"state": source}),
        ("transition", {"from": source, "to": to, "event": event}),
        ("enter", {"state": to}),
    ]


def test_the_way_into_a_part_and_back_in_it(shop: Project) -> None:
    recording = _trace(("enter", {"state": "1"}))
    answer = why_not(shop, recording, {"kind": "enter", "state": "5/end"}, 1.5)
    assert lines(answer.reasons) == [
        (
            "- shop was in 1 start since 1 s; the nearest way to 5/end: go → 5/ask name, "
            "yes → 5/end  (#1)"
        ),
        "  - event go did not come while shop was in 1 start, since 1 s  (#1)",
        "    - it comes from outside: from a module, a message, or the blackboard",
    ]
    recording = _trace(("enter", {"state": "1"}), *_go("1", "5/ask", "go"))
    answer = why_not(shop, recording, {"kind": "enter", "state": "5"}, 9)
    assert answer.reasons[0].text == "shop was in 5 register already, since 5 s"


def test_back_goes_by_the_run_of_its_part(shop: Project) -> None:
    start: Told = ("enter", {"state": "1"})
    inside = [start, *_go("1", "5/ask", "go"), *_go("5/ask", "5/end", "yes")]
    recording = _trace(*inside, *_go("5/end", "1", "yes"))
    coverage = Coverage(shop)
    coverage.add(recording)
    taken = {seen.label for seen in coverage.transitions.values() if seen.covered}
    assert taken == {
        "shop, 1 start – go → 5 register",
        "shop, 5/ask name – yes → 5/end",
        "shop, 5 register – yes → 1 start",
    }
