"""Why, where an application runs parts, or another version has come meanwhile."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest
from tests.rehearse.asked import answered

from situ.decide import inputs
from situ.decide.trace import TraceEvent, to_fields
from situ.document import deployed
from situ.document.project import Project
from situ.errors import UsageError
from situ.rehearse.recording import Recording
from situ.rehearse.simulate import Rehearsal
from situ.rehearse.stays import stays

if TYPE_CHECKING:
    from tests.rehearse.conftest import Make, Record


VISIT = """<application name="visit">
<always><expectedevents><event name="home" next="1"/></expectedevents></always>
<state no="1" name="hall"><expectedevents><event name="in" next="2"/>
  <event name="anew" next="#again"/></expectedevents></state>
<state no="2" name="desk"><flow src="desk.rbd.xml"/><expectedevents>
  <event name="done.known" next="3"/><event name="done" next="1"/>
  <event name="anew" next="#again"/></expectedevents></state>
<state no="3" name="room"><expectedevents><event name="out" next="1"/></expectedevents></state>
</application>"""

DESK = """<application name="desk">
<state no="a" name="ask"><expectedevents><event name="yes" next="b"/><event name="no" next="gone"/>
</expectedevents></state>
<state no="b" name="look up"><expectedevents><event name="found" next="known"/></expectedevents>
</state>
<state no="known" final="true"/><state no="gone" final="true"/>
</application>"""


@pytest.fixture
def visit(make: Make) -> Project:
    return make(VISIT, parts={"desk.rbd.xml": make(DESK).applications["0.rbd.xml"]})


@pytest.fixture
def visited(visit: Project, record: Record) -> Recording:
    events = {1: "in", 2: "yes", 4: "home", 5: "in", 6: "no"}
    return record(visit, *({"at": at, "event": name} for at, name in events.items()))


def test_the_end_of_a_part_comes_from_its_end_state_and_that_has_a_way(
    visit: Project, visited: Recording
) -> None:
    assert answered(visit, visited, 3, "enter", state="3") == (
        "- event done.known did not come while visit was in 2/b look up, since 2 s\n"
        "  - it comes when the part enters its end state 2/known\n"
        "    - event found did not come while visit was in 2/b look up, since 2 s\n"
        "      - it comes from outside: from a module, a message, or the blackboard"
    )


def test_done_comes_from_ends_without_an_event_of_their_own(
    visit: Project, visited: Recording
) -> None:
    told = answered(visit, visited, 1.5, "event", name="done")
    assert "enters its end state 2/gone" in told
    assert "event no did not come" in told
    assert "known" not in told


def test_the_nearest_way_to_an_end_is_told_from_afar(visit: Project, visited: Recording) -> None:
    told = answered(visit, visited, 1.5, "transition", **{"from": "2", "to": "3"})
    assert (
        "visit was in 2/a ask since 1 s; the nearest way to 2/known: "
        "yes → 2/b look up, found → 2/known"
    ) in told


def test_a_state_that_holds_a_part_is_one_to_be_in_and_to_go_to(
    visit: Project, visited: Recording
) -> None:
    assert answered(visit, visited, 5.5, "enter", state="2") == (
        "- visit was in 2 desk already, since 5 s"
    )
    told = answered(visit, visited, 4.5, "transition", **{"from": "2", "to": "3"})
    assert told.startswith("- visit was in 1 hall since 4 s\n  - event in did not come")
    told = answered(visit, visited, 4.5, "enter", state="2/b")
    assert "the nearest way to 2/b look up: in → 2/a ask, yes → 2/b look up" in told


def test_a_part_begun_anew_is_entered_at_its_start(visit: Project, visited: Recording) -> None:
    told = answered(visit, visited, 2.5, "enter", state="2/a")
    assert "event anew did not come while visit was in 2/b look up" in told
    assert "event anew" not in answered(
        visit, visited, 2.5, "transition", **{"from": "2/b", "to": "3"}
    )


def test_a_state_that_there_is_not_is_told_so(visit: Project, visited: Recording) -> None:
    with pytest.raises(UsageError, match="visit has no state 2/c"):
        answered(visit, visited, 2, "enter", state="2/c")


def test_a_state_left_because_a_deploy_lacks_it_is_left() -> None:
    flow = '<application name="app"><state no="{}"><expectedevents><event name="go" next="2"/>'
    flow += '</expectedevents></state><state no="2"/></application>'
    before, after = ({"a.rbd.xml": flow.format(no)} for no in ("1", "7"))
    events: list[TraceEvent] = []
    project, new = (deployed.read(files)[0] for files in (before, after))
    assert project is not None
    assert new is not None
    rehearsal = Rehearsal(project, events.extend)
    rehearsal.give(inputs.Deploy(1, after, "operator:ann"), 2_000_000)
    recording = Recording.of(list(map(to_fields, events)))
    found, _ = stays(new, recording, "app", 9)
    assert [(one.state, one.at(1), one.at(9)) for one in found] == [
        ("1", True, False),
        ("7", False, True),
    ]
