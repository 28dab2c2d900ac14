"""The trace log: what it says of a moment is what the robot is."""

from __future__ import annotations

import random
import tracemalloc
from pathlib import Path
from typing import Any

import msgspec
import pytest
from msgspec.structs import replace

from situ.decide.robot import Robot
from situ.decide.trace import TraceEvent, to_fields
from situ.document.project import Project
from situ.document.rbd import AGAIN, BACK, Application, Event, State
from situ.document.ready import load_ready
from situ.rehearse import scenario
from situ.rehearse.expect import Expect
from situ.rehearse.scenario import End
from situ.rehearse.simulate import Rehearsal
from situ.resources import examples
from situ_studio.live.log import TraceLog
from situ_studio.live.log_rows import LogRows
from situ_studio.live.moment import Moment, Taken
from situ_studio.live.views import exit_of, live_script, live_view
from situ_studio.panels.table import Row

SCENARIOS = [
    (name, path.name)
    for name, where in examples().items()
    for path in sorted(Path(where, "scenarios").glob("*.jsonl"))
]


def played(name: str, script: str) -> tuple[Project, Robot, list[dict[str, Any]]]:
    where = Path(examples()[name])
    project = load_ready(where)
    events: list[dict[str, Any]] = []

    def tell(came: list[TraceEvent]) -> None:
        events.extend(to_fields(event) for event in came)

    rehearsal = Rehearsal(project, tell)
    for line in scenario.load(where / "scenarios" / script):
        rehearsal.advance(line.at)
        if not isinstance(line.does, Expect | End):
            rehearsal.give(line.does, line.at)
    return project, rehearsal.robot, events


@pytest.mark.parametrize(("name", "script"), SCENARIOS)
def test_the_moment_is_what_the_robot_is(name: str, script: str) -> None:
    project, robot, events = played(name, script)
    log = TraceLog()
    assert log.add(events) == events
    now = log.now
    for application in project.applications.values():
        kept = robot.board.look(f"application/{application.name}")
        moment = now.applications[application.name]
        assert (moment.state, moment.suspended) == (kept["state"], kept["suspended"])
        assert sum(moment.entered.values()) == sum(
            e["kind"] == "enter" and e["application"] == application.name for e in events
        )
    assert now.situation == robot.board.look("situation.name")
    traced = {tag for tag, entry in robot.board.entries() if entry.version} - {
        tag
        for tag, _ in robot.board.entries()
        if "/" in tag or tag.startswith("clock.") or tag in ("situation", "listen")
    }
    assert {t: now.board[t].value for t in traced} == {t: robot.board.look(t) for t in traced}
    for resource, value in now.robot.items():
        assert value == robot.board.look(f"robot/{resource}")


def inside(project: Project, file: Application, crossed: Taken) -> tuple[Application, Taken]:
    """The file whose states it joins, and what it is called there."""
    holder, part, source = crossed.source.partition("/")
    if not part:
        return file, crossed
    state = file.state(holder)
    assert state is not None
    assert state.flow is not None
    to = crossed.to.removeprefix(f"{holder}/")
    return inside(project, project.parts[state.flow], replace(crossed, source=source, to=to))


def exit_taken(file: Application, way: Taken) -> str | None:
    return exit_of(file.state(way.source), way.to, way.event, way.timeout)


@pytest.mark.parametrize(("name", "script"), SCENARIOS)
def test_every_transition_is_found_on_the_graph(name: str, script: str) -> None:
    project, _, events = played(name, script)
    log = TraceLog()
    log.add(events)
    for application in project.applications.values():
        moment = log.now.applications[application.name]
        view = live_view(application, moment, log.now.t)
        assert moment.state is not None
        assert view.active == {moment.state.partition("/")[0]}
        own = [c for c in moment.taken if exit_taken(application, c) is not None]
        assert [t.state for t in view.taken] == [c.source for c in reversed(own)]
        for crossed in moment.taken:
            file, way = inside(project, application, crossed)
            always = file.always.events if file.always is not None else ()
            shared = {event.name for event in always}
            timed = crossed.timeout and file.always is not None and file.always.timeout is not None
            assert exit_taken(file, way) is not None or crossed.event in shared or timed
    glow = live_script(log.now)
    assert glow.situation == log.now.situation
    assert set(glow.authority) == set(log.now.holders)


def test_of_exits_of_one_name_that_was_taken_which_leads_where_it_went() -> None:
    exits = (Event("e", next=AGAIN), Event("e", next=BACK), Event("e", next="3"))
    state = State("2", "asks", events=exits)
    assert exit_of(state, "3", "e", False) == "2"
    assert exit_of(state, "2", "e", False) == "0"
    assert exit_of(state, "1", "e", False) == "1"
    assert exit_of(replace(state, events=exits[::2]), "1", "e", False) is None


def test_inside_a_part_the_state_that_holds_it_glows() -> None:
    part = Application("visit", states=(State("5", "register", flow="register.rbd.xml"),))
    log = TraceLog()
    for seq, state in enumerate(("5", "5/1", "5/2"), 1):
        fields = {"kind": "enter", "seq": seq, "t": float(seq), "cause": None}
        log.add([{**fields, "application": "visit", "state": state}])
    view = live_view(part, log.now.applications["visit"], 4.0)
    assert view.active == {"5"}
    assert view.counts["5"] == 1


def test_events_seen_before_are_passed_over() -> None:
    _, _, events = played("conversation", "fig5.jsonl")
    log = TraceLog()
    log.add(events[:40])
    assert log.add(events[20:60]) == events[40:60]
    assert log.seq == 60
    log.clear()
    assert log.add(events[:3]) == events[:3]


def test_only_so_many_events_are_kept_but_all_are_known() -> None:
    _, _, events = played("reception", "known-user.jsonl")
    log = TraceLog(limit=10, block=4)
    for event in events:
        log.add([event])
    assert 10 <= len(log) <= 14
    assert list(log) == events[-len(log) :]
    assert log[-1] == log[len(log) - 1] == events[-1]
    assert log[2:9] == events[-len(log) :][2:9]
    with pytest.raises(IndexError):
        log[len(log)]
    entered = log.now.applications["reception"].entered
    assert sum(entered.values()) == sum(e["kind"] == "enter" for e in events)
    assert log.lanes.start == log.time(0)
    assert log.after(0) == folded(events[: -len(log)])


def folded(events: list[dict[str, Any]]) -> Moment:
    moment = Moment()
    for event in events:
        moment.take(event)
    return moment


@pytest.mark.parametrize("block", [3, 50, 10_000])
@pytest.mark.parametrize(("name", "script"), SCENARIOS[:4])
def test_a_moment_of_the_past_is_what_the_robot_was_then(
    name: str, script: str, block: int
) -> None:
    _, _, events = played(name, script)
    log = TraceLog(block=block)
    log.add_lines(map(msgspec.json.encode, events))
    dice = random.Random(script)
    ways = [*range(0, len(events), 7), *dice.sample(range(len(events)), len(events) // 5)]
    for count in ways:
        assert log.after(count) == folded(events[:count])
    for t in {event["t"] for event in events}:
        assert log.at(t) == folded([event for event in events if event["t"] <= t])
    assert log.at(-1.0) == Moment()
    assert log.at(events[-1]["t"]) is log.now


def test_looking_at_the_past_leaves_the_present_as_it_is() -> None:
    _, _, events = played("conversation", "fig5.jsonl")
    log = TraceLog(block=20)
    log.add(events[:70])
    before = log.after(30)
    log.after(65)
    log.add(events[70:])
    assert before == folded(events[:30])
    assert log.now == folded(events)


def test_lanes_hold_what_moments_tell() -> None:
    _, _, events = played("conversation", "fig5.jsonl")
    log = TraceLog(block=30)
    log.add(events)
    lanes = log.lanes
    assert lanes.end == events[-1]["t"]
    for t in {event["t"] for event in events}:
        moment = log.at(t)
        assert lanes.situation.at(t) == moment.situation
        for resource, lane in lanes.holders.items():
            holder = moment.holders.get(resource)
            assert lane.at(t) == (holder[0] if holder is not None else None)
        for name, lane in lanes.states.items():
            assert lane.at(t) == moment.applications[name].state
    numbers = [e for e in events if e["kind"] == "data" and isinstance(e["value"], bool | float)]
    assert sum(len(series.t) for series in lanes.data.values()) >= len(numbers)


def test_a_deleted_number_is_a_gap() -> None:
    log = TraceLog()
    for seq, value in enumerate((1.5, None, True, "text"), 1):
        fields = {"kind": "data", "seq": seq, "t": float(seq), "tag": "a.b", "writer": "w"}
        log.add([{**fields, "value": value}])
    (series,) = log.lanes.data.values()
    assert [*series.t] == [1.0, 2.0, 3.0, 4.0]
    assert [y if y == y else None for y in series.y] == [1.5, None, 1.0, None]


def test_what_stands_on_the_blackboard_fills_in_what_the_trace_does_not_tell() -> None:
    log = TraceLog()
    log.stand(
        {
            "situation": ({"name": "sound", "priorities": {}}, "situ", 3.0),
            "application/converse": ({"state": "2", "name": "sleep", "suspended": True}, "situ", 2),
            "face.visible": (True, "face-detector", 1.0),
            "gone": (None, "face-detector", 1.0),
        }
    )
    assert log.now.situation == "sound"
    assert log.now.applications["converse"].state == "2"
    assert log.now.applications["converse"].suspended
    assert log.now.board["face.visible"].value is True
    assert "gone" not in log.now.board


def test_what_stood_there_counts_in_the_past_from_its_time_on() -> None:
    log = TraceLog(block=2)
    log.stand({"face.visible": (True, "face-detector", 1.0), "late": (7, "w", 3.0)})
    for seq, t in enumerate((0.5, 2.0, 2.5, 4.0, 5.0), 1):
        fields = {"kind": "data", "seq": seq, "t": t, "tag": "a.b", "writer": "w"}
        log.add([{**fields, "value": seq}])
    assert "late" in log.now.board
    assert "face.visible" not in log.at(0.7).board
    assert "face.visible" in log.at(2.6).board
    assert "late" not in log.at(2.6).board
    assert log.at(4.5).board["late"].value == 7
    log.add(
        [
            {
                "kind": "data",
                "seq": seq,
                "t": float(seq),
                "tag": "late",
                "writer": "w",
                "value": None,
            }
            for seq in (6, 7)
        ]
    )
    assert "late" not in log.now.board
    assert "late" not in log.at(6.0).board
    assert "late" in log.at(5.0).board


def told(seq: int, t: float, kind: str = "data", **fields: Any) -> dict[str, Any]:
    if kind == "data":
        fields = {"tag": "a.b", "writer": "w", "value": seq, **fields}
    return {"kind": kind, "seq": seq, "t": t, "cause": None, **fields}


def test_what_stood_there_gives_way_to_what_the_trace_told_later() -> None:
    log = TraceLog(block=2)
    log.add(
        [
            told(11, 7.0, "resumed", application="a", state="1", breakpoint=3, writer="ann"),
            told(12, 7.0, "resume", application="a", missing=[]),
            told(13, 7.0, "situation", **{"from": "sound", "to": None}),
            told(14, 7.0, "mapping", resource="head", module=None, value=None),
            told(15, 7.0, value=None),
            told(16, 8.0, tag="c"),
        ]
    )
    # Read at the robot before, answered after.
    log.stand(
        {
            "debugger.paused": ({"a": 3}, "situ", 5.0),
            "application/a": ({"state": "1", "name": "one", "suspended": True}, "situ", 5.0),
            "situation": ({"name": "sound", "priorities": {}}, "situ", 5.0),
            "robot/head": ([0, 30], "gaze", 5.0),
            "a.b": (1, "w", 5.0),
        }
    )
    log.add([told(17, 9.0, tag="c")])
    for moment in (log.now, log.at(8.0)):
        one = moment.applications["a"]
        assert (one.state, one.paused, one.suspended) == ("1", False, False)
        assert moment.situation is None
        assert "head" not in moment.holders
        assert "a.b" not in moment.board


def test_of_a_robot_met_late_lanes_begin_with_its_events_and_with_what_stood_there() -> None:
    log = TraceLog()
    log.stand(
        {
            "application/a": ({"state": "5", "name": "five", "suspended": False}, "situ", 60.0),
            "situation": ({"name": "sound", "priorities": {}}, "situ", 20.0),
            "robot/head": ([0, 30], "gaze", 30.0),
        }
    )
    log.add([told(20_001, 50.0), told(20_002, 55.0, "enter", application="a", state="4")])
    lanes = log.lanes
    assert (lanes.start, lanes.end) == (50.0, 55.0)
    assert lanes.situation.at(51.0) == "sound"
    assert lanes.holders["head"].at(51.0) == "gaze"
    assert log.now.holders["head"] == ("gaze", 30.0)
    assert log.now.robot["head"] == [0, 30]
    # What stands there since later than the events that come only now waits for its own.
    assert [*lanes.states["a"].t] == [55.0]
    log.add([told(20_003, 60.0, "enter", application="a", state="5")])
    assert [*lanes.states["a"].t] == [55.0, 60.0]


def test_a_robot_that_forgot_its_last_events_is_where_its_blackboard_says() -> None:
    log = TraceLog()
    log.add([told(1, 1.0, "enter", application="a", state="4")])
    log.stand({"application/a": ({"state": "9", "name": "n", "suspended": True}, "situ", 60.0)})
    log.add([told(30_000, 70.0)])
    one = log.now.applications["a"]
    assert (one.state, one.since, one.suspended) == ("9", 60.0, True)
    assert log.at(2.0).applications["a"].state == "4"


def test_events_twice_or_backwards_in_one_delivery_are_taken_and_given_back_once() -> None:
    log = TraceLog()
    new = log.add([told(5, 1.0), told(4, 1.0), told(5, 1.0), told(6, 2.0)])
    assert [event["seq"] for event in new] == [event["seq"] for event in log] == [5, 6]
    log.add_lines(map(msgspec.json.encode, (told(6, 2.0), told(7, 3.0), told(7, 3.0))))
    assert [event["seq"] for event in log] == [5, 6, 7]


def test_time_that_goes_back_counts_as_of_the_event_before() -> None:
    log = TraceLog(block=2)
    log.add([told(1, 1.0), told(2, 5.0), told(3, 3.0), told(4, 4.0), told(5, 6.0)])
    assert [event["t"] for event in log] == [1.0, 5.0, 5.0, 5.0, 6.0]
    assert log.at(4.0).board["a.b"].value == 1
    assert log.at(5.0).board["a.b"].value == 4
    assert [*log.lanes.data["a.b"].t] == sorted(log.lanes.data["a.b"].t)


def test_an_integer_that_no_float_is_near_is_kept_but_not_drawn() -> None:
    log = TraceLog(block=1)
    line = msgspec.json.encode(told(1, 1.0, value=0)).replace(
        b'"value":0', b'"value":1' + b"0" * 400
    )
    log.add_lines([line])
    assert log[0]["value"] == 10**400
    assert log.lanes.data["a.b"].at(1.0) != log.lanes.data["a.b"].at(1.0)


def test_json_with_line_breaks_is_one_event_still() -> None:
    log = TraceLog(block=2)
    events = [told(1, 1.0), told(2, 2.0)]
    log.add_lines(msgspec.json.format(msgspec.json.encode(event)) for event in events)
    assert list(log) == events


def test_a_full_log_forgets_a_part_at_a_time_and_never_more_than_it_has_too_many() -> None:
    log = TraceLog(limit=640, block=2)
    for seq in range(1, 1_000):
        log.add([told(seq, float(seq))])
        assert log[0]["seq"] == log.gone + 1
        assert log.gone % 10 == 0
        assert min(seq, 640) <= len(log) < 640 + 10 + 2
    assert log.gone > 300


def test_what_is_kept_takes_hardly_more_room_than_it_is_packed() -> None:
    log = TraceLog()
    tracemalloc.start()
    begun, _ = tracemalloc.get_traced_memory()
    log.add_lines(
        msgspec.json.encode(told(seq, seq / 100, tag=f"tag.{seq % 60}")) for seq in range(1, 20_001)
    )
    now, _ = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert (now - begun) / len(log) < 80


def test_a_row_that_is_read_before_the_table_is_told_is_never_another_events() -> None:
    def those(first: int, last: int) -> list[dict[str, Any]]:
        return [told(seq, float(seq)) for seq in range(first, last + 1)]

    log = TraceLog(limit=4, block=2)
    log.add(those(1, 6))
    rows = LogRows(log, lambda event: Row(str(event["seq"]), ("", "", "", "")))
    log.add(those(7, 8))
    assert rows.news() == (2, 2)
    assert [row.key for row in rows] == ["", "", "3", "4", "5", "6"]
    rows.drop(2)
    rows.take(2)
    assert [row.key for row in rows[2:]] == ["5", "6", "7", "8"]
    # The robot began anew: its log is empty before anybody is told.
    rows = LogRows(log, lambda event: Row(str(event["seq"]), ("", "", "", "")))
    log.clear()
    assert [row.key for row in rows] == [""] * len(rows)
    assert rows.news() is None
