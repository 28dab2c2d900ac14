"""docs/semantics.md, *The debugger*: what an operator may do to running applications."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.decide.conftest import Trace, build_project
from tests.decide.test_parts import application, flow

from situ.decide.debugger import ONE_KIND
from situ.decide.effects import Refuse
from situ.decide.inputs import (
    AnyInput,
    Break,
    Finish,
    Goto,
    Pause,
    Raise,
    Resume,
    Set,
    Start,
    Step,
    Touch,
    Unbreak,
)
from situ.decide.robot import Robot
from situ.decide.trace import to_fields, to_line

if TYPE_CHECKING:
    from situ.document.project import Project

ANN = "operator:ann"
SECOND = 1_000_000
TOLD = ("paused", "resumed", "enter", "event", "ignored", "warning", "error")

ALL = """<modules><module name="app" resources="{}"/></modules>
<situation name="busy"><condition><data tag="busy" is="true"/></condition></situation>
<situation name="calm"><module name="app" priority="1"/></situation>"""


def state(no: str, events: str = "", actions: str = "", timeout: str = "", more: str = "") -> str:
    return (
        f'<state no="{no}" {more}>{timeout}<backgroundactions>{actions}</backgroundactions>'
        f"<expectedevents>{events}</expectedevents></state>"
    )


def event(name: str, to: str) -> str:
    return f'<event name="{name}" next="{to}"/>'


def always(to: str, tag: str) -> str:
    return f'<event next="{to}"><when><data tag="{tag}" is="1"/></when></event>'


def after(seconds: float, to: str = "") -> str:
    return f'<timeout next="{to}">{seconds}</timeout>' if to else f"<timeout>{seconds}</timeout>"


GO = state("1", event("go", "2")) + state("2", event("go", "3")) + state("3")
TWO = [f'<application name="{name}">{GO}</application>' for name in ("a", "b")]


class Run:
    """A robot that has started. trace: all of it so far."""

    def __init__(self, rbd: str | list[str], **more: Any) -> None:
        self.project: Project = build_project(rbd, **more)
        self.robot = Robot(self.project)
        self.trace = Trace()
        self.raw = b""
        self.refused: list[str] = []
        self.do(0, Start())

    def do(self, at: float, *given: AnyInput) -> None:
        """What falls due until then, then the inputs."""
        self.until(at)
        for one in given:
            self._step(one, round(at * SECOND))

    def until(self, at: float) -> None:
        while (due := self.robot.due()) is not None and due <= at * SECOND:
            self._step(None, due)

    def _step(self, given: AnyInput | None, now: int) -> None:
        events, effects = self.robot.step(given, now)
        self.trace += map(to_fields, events)
        self.raw += b"".join(map(to_line, events))
        self.refused += [one.message for one in effects if isinstance(one, Refuse)]

    def lines(self, since: float = 0, *kinds: str) -> list[str]:
        return [
            told(one) for one in self.trace if one["t"] >= since and one["kind"] in (kinds or TOLD)
        ]


def told(one: dict[str, Any]) -> str:
    kind = one["kind"]
    if kind in ("paused", "resumed"):
        who = one.get("writer", f"breakpoint {one['breakpoint']}")
        return f"{one['t']:g} {kind} {one['application']} {one['state']} {who}"
    if kind in ("warning", "error"):
        return f"{one['t']:g} {kind} {one['message']}"
    what = one.get("name") or one.get("action") or one.get("state")
    return f"{one['t']:g} {kind} {what}"


# -- while it is paused ------------------------------------------------------


def test_what_comes_to_a_paused_application_waits_and_is_judged_in_order() -> None:
    run = Run(GO)
    run.do(1, Pause(ANN))
    run.do(2, Raise("go"), Raise("other"), Raise("go"))
    run.do(3, Resume(ANN))
    assert run.lines(1) == [
        "1 paused app 1 operator:ann",
        "3 resumed app 1 operator:ann",
        "3 event go",
        "3 enter 2",
        "3 event other",
        "3 ignored other",
        "3 event go",
        "3 enter 3",
    ]


def test_a_paused_applications_timeout_stands_still() -> None:
    run = Run(state("1", timeout=after(5, "2")) + state("2"))
    run.do(3, Pause(ANN))
    run.do(100, Resume(ANN))
    run.until(200)
    assert run.trace.states() == [(0, "1"), (102, "2")]
    entered, left = run.trace.of("enter")[0], run.trace.one("transition")
    assert left["cause"] == entered["seq"]


def test_a_timeout_that_begins_while_paused_counts_from_the_resume() -> None:
    run = Run(GO + state("4", timeout=after(5, "1")))
    run.do(1, Pause(ANN))
    run.do(2, Goto(ANN, "4"))
    run.do(10, Resume(ANN))
    run.until(100)
    assert run.trace.states() == [(0, "1"), (2, "4"), (15, "1")]


def test_a_suspension_while_paused_stops_the_timeout_and_the_resume_waits() -> None:
    rbd = state("1", timeout=after(5, "2"), actions="<speech>A</speech>") + state("2")
    run = Run(rbd, spds=ALL.format("speech"))
    run.do(1, Pause(ANN))
    run.do(2, Set({"busy": True}, "m"))
    run.do(3, Resume(ANN))
    run.do(4, Pause(ANN), Set({"busy": False}, "m"))
    assert run.trace.of("resume") == []
    run.do(6, Resume(ANN))
    run.until(50)
    assert [one["t"] for one in run.trace.of("suspend", "resume")] == [2, 6]
    assert run.trace.states() == [(0, "1"), (10, "2")]


def test_situations_priorities_and_other_applications_go_on() -> None:
    spds = """<modules><module name="a" resources=""/><module name="b" resources=""/>
      <module name="m" resources="head"/></modules>
      <situation name="busy"><condition><data tag="busy" is="true"/></condition>
      <module name="m" priority="1"/><module name="a" priority="1"/><module name="b" priority="1"/>
      </situation><situation name="calm"/>"""
    run = Run(TWO, spds=spds)
    run.do(1, Pause(ANN, "a"), Set({"busy": True}, "m"), Raise("go"))
    assert run.trace.situations() == [(0, "calm"), (1, "busy")]
    assert run.trace.states("a") == [(0, "1")]
    assert run.trace.states("b") == [(0, "1"), (1, "2")]


def test_what_runs_goes_on_and_nothing_new_begins() -> None:
    actions = """<service name="s" url="http://x/" wait="true"/><launch program="p"/>"""
    run = Run(state("1", actions=actions))
    run.do(1, Pause(ANN))
    run.do(2, Finish("service"))
    assert run.lines(1, "finished", "action") == ["2 finished s"]
    run.do(3, Resume(ANN))
    assert run.lines(3, "resumed", "action") == ["3 resumed app 1 operator:ann", "3 action p"]
    assert run.trace.cause(run.trace[-1]) == run.trace.one("resumed")


def test_the_next_speech_waits_for_the_resume() -> None:
    run = Run(state("1", actions="<speech>A</speech><speech>B</speech>"))
    run.do(1, Pause(ANN), Finish("speech"))
    assert len(run.trace.of("action")) == 1
    run.do(2, Resume(ANN))
    assert [one["text"] for one in run.trace.of("action")] == ["A", "B"]


def test_unnamed_events_wait_and_are_judged_by_what_holds_then() -> None:
    run = Run(state("1", always("2", "x")) + state("2"))
    run.do(1, Pause(ANN), Set({"x": 1}, "m"), Set({"x": 0}, "m"), Resume(ANN))
    assert run.trace.states() == [(0, "1")]
    run.do(2, Pause(ANN), Set({"x": 1}, "m"))
    assert run.trace.states() == [(0, "1")]
    run.do(3, Resume(ANN))
    assert run.trace.states() == [(0, "1"), (3, "2")]


def test_a_touch_of_a_paused_application_sets_its_idle_timeout_back_for_later() -> None:
    screen = '<screen touched="t"/>'
    rbd = state("1", timeout='<timeout next="2" idle="true">5</timeout>' + screen) + state("2")
    run = Run(rbd)
    run.do(3, Pause(ANN))
    run.do(4, Touch())
    run.do(6, Resume(ANN))
    run.until(50)
    assert run.trace.states() == [(0, "1"), (11, "2")]


def test_one_application_or_all_are_paused_and_twice_is_once() -> None:
    run = Run(TWO)
    run.do(1, Pause(ANN, "b"), Pause(ANN), Pause(ANN), Resume(ANN, "a"), Resume(ANN))
    assert run.lines(1, "paused", "resumed") == [
        "1 paused b 1 operator:ann",
        "1 paused a 1 operator:ann",
        "1 resumed a 1 operator:ann",
        "1 resumed b 1 operator:ann",
    ]
    assert run.refused == []


def test_more_that_waited_than_a_livelock_has_is_no_livelock() -> None:
    run = Run(state("1", '<event name="go"/>'))
    run.do(1, Pause(ANN), *[Raise("go")] * 150, Resume(ANN))
    assert len(run.trace.of("event")) == 150
    assert run.trace.of("error") == []


# -- step --------------------------------------------------------------------


def test_a_step_judges_one_event_and_pauses_again() -> None:
    run = Run(GO)
    run.do(1, Pause(ANN), Raise("go"), Raise("go"))
    run.do(2, Step(ANN))
    assert run.lines(2) == ["2 event go", "2 enter 2", "2 paused app 2 operator:ann"]
    run.do(3, Step(ANN))
    assert run.lines(3) == ["3 event go", "3 enter 3", "3 paused app 3 operator:ann"]


def test_a_step_takes_the_resume_then_unnamed_events_then_the_raised() -> None:
    rbd = state("1", always("2", "x") + event("go", "3"), "<speech>A</speech>") + state(
        "2", event("go", "3")
    )
    run = Run(rbd + state("3"), spds=ALL.format("speech"))
    run.do(1, Set({"busy": True}, "m"), Pause(ANN))
    run.do(1, Raise("go"), Set({"x": 1}, "m"), Set({"busy": False}, "m"))
    run.do(2, Step(ANN))
    assert run.lines(2) == ["2 event resumed", "2 paused app 1 operator:ann"]
    run.do(3, Step(ANN), Step(ANN))
    assert run.trace.states() == [(0, "1"), (3, "2"), (3, "3")]


def test_where_nothing_waits_a_step_lets_the_timeout_fall_due() -> None:
    run = Run(
        state("1", event("timeout", "2"), timeout=after(5)) + state("2", timeout=after(5, "3"))
        + state("3")
    )  # fmt: skip
    run.do(1, Pause(ANN), Step(ANN))
    assert run.trace.states() == [(0, "1"), (1, "2")]
    run.do(2, Step(ANN))
    assert run.trace.states()[-1] == (2, "3")


def test_what_waited_behind_an_action_is_a_step_of_its_own() -> None:
    actions = """<service name="s" url="http://x/" wait="true"/><launch program="p"/>"""
    run = Run(state("1", event("go", "2"), actions) + state("2"))
    run.do(1, Pause(ANN), Finish("service"), Raise("go"), Step(ANN))
    assert run.lines(1, "action", "enter") == ["1 action p"]
    run.do(2, Step(ANN))
    assert run.lines(2, "action", "enter") == ["2 enter 2"]


def test_a_step_is_refused_where_nothing_waits_or_nothing_is_paused() -> None:
    run = Run(GO)
    run.do(1, Step(ANN), Pause(ANN), Step(ANN))
    assert run.refused == [
        "app is not paused: pause it first",
        "nothing waits in app: raise an event, or let it go on",
    ]
    run.do(2, Raise("go"))
    assert run.trace.states() == [(0, "1")]


# -- going to a state --------------------------------------------------------


def test_go_to_is_a_transition_that_tells_who_did_it() -> None:
    run = Run(GO)
    run.do(1, Goto(ANN, "3"))
    assert run.trace.lines(since=1) == [
        "1 exit app 1 <-",
        "1 transition app 1 3 - <-",
        "1 enter app 3 <transition",
    ]
    assert run.trace.one("transition")["writer"] == ANN


def test_a_paused_application_stays_paused_where_it_is_sent() -> None:
    run = Run(GO)
    run.do(1, Pause(ANN), Raise("go"), Goto(ANN, "2"))
    assert run.trace.states() == [(0, "1"), (1, "2")]
    run.do(2, Resume(ANN))
    assert run.trace.states() == [(0, "1"), (1, "2"), (2, "3")]


def test_where_it_is_sent_while_paused_what_waits_behind_an_action_goes_on_waiting() -> None:
    actions = """<service name="s" url="http://x/" wait="true"/><launch program="p"/>"""
    run = Run(state("1") + state("2", actions=actions))
    run.do(1, Pause(ANN), Goto(ANN, "2"), Finish("service"))
    assert run.lines(1, "action") == ["1 action s"]
    run.do(2, Resume(ANN))
    assert run.lines(2, "action") == ["2 action p"]


PART = application(state("p") + state("q"), "part")


def test_go_to_leads_into_a_part_and_out_of_it() -> None:
    run = Run(state("1") + flow("5", "part"), parts={"part.rbd.xml": PART})
    for at, to in enumerate(("5/q", "5/p", "5", "1"), 1):
        run.do(at, Goto(ANN, to, "app"))
    assert run.trace.states() == [
        (0, "1"), (1, "5"), (1, "5/q"), (2, "5/p"), (3, "5"), (3, "5/p"), (4, "1"),
    ]  # fmt: skip


def test_a_state_or_application_that_is_not_there_is_refused() -> None:
    run = Run(TWO)
    run.do(
        1, Goto(ANN, "9", "a"), Goto(ANN, "1"), Pause(ANN, "c"), Break(ANN, state="1"),
        Break(ANN, "a", to="9"), Break(ANN, situation="s"), Break(ANN, "a"),
        Break(ANN, "a", state="1", to="2"), Unbreak(ANN, 1),
    )  # fmt: skip
    assert run.refused == [
        "a has no state 9; there is 1, 2, 3",
        "which application? there is a, b",
        "there is no application c; there is a, b",
        "which application? there is a, b",
        "a has no state 9; there is 1, 2, 3",
        "there is no situation s; there is none",
        ONE_KIND,
        ONE_KIND,
        "there is no breakpoint 1; there is none",
    ]
    assert run.lines(1) == [f"1 error {said}" for said in run.refused]


# -- breakpoints -------------------------------------------------------------


def test_a_breakpoint_on_a_state_pauses_after_it_was_entered() -> None:
    run = Run(state("1", event("go", "2")) + state("2", always("3", "x"), "<set tag='x'>1</set>")
              + state("3"))  # fmt: skip
    run.do(1, Break(ANN, state="2"))
    run.do(2, Raise("go"))
    assert run.trace.lines("transition", "enter", "finished", "data", since=2) == [
        "2 transition app 1 2 go <event",
        "2 enter app 2 <transition",
        "2 data x 1 app v1 <action",
        '2 finished app set - ok null <action',
    ]  # fmt: skip
    paused = run.trace.one("paused")
    assert (paused["breakpoint"], run.trace.cause(paused)) == (1, run.trace.of("enter")[-1])
    run.do(3, Resume(ANN))
    assert run.trace.states() == [(0, "1"), (2, "2"), (3, "3")]
    assert run.trace.one("resumed")["breakpoint"] == 1


@pytest.mark.parametrize(
    "ends", [{"source": "1"}, {"to": "2"}, {"source": "1", "to": "2"}], ids=str
)
def test_a_breakpoint_on_a_transition_pauses_before_it_is_taken(ends: dict[str, str]) -> None:
    run = Run(GO)
    run.do(1, Break(ANN, **ends))
    run.do(2, Raise("go"), Raise("go"))
    assert run.lines(2) == ["2 paused app 1 breakpoint 1"]
    run.do(3, Resume(ANN))
    assert run.trace.states() == [(0, "1"), (3, "2"), (3, "3")]


@pytest.mark.parametrize("ends", [{"source": "2"}, {"to": "3"}, {"source": "2", "to": "2"}])
def test_other_transitions_go_on(ends: dict[str, str]) -> None:
    run = Run(GO)
    run.do(1, Break(ANN, **ends))
    run.do(2, Raise("other"), Raise("go"))
    assert run.trace.states() == [(0, "1"), (2, "2")]


def test_a_step_takes_the_transition_at_which_it_paused() -> None:
    run = Run(GO)
    run.do(1, Break(ANN, to="2"), Raise("go"), Step(ANN))
    assert run.trace.states() == [(0, "1"), (1, "2")]
    run.do(2, Resume(ANN), Raise("go"))
    assert run.trace.states() == [(0, "1"), (1, "2"), (2, "3")]


def test_the_next_time_it_pauses_again() -> None:
    run = Run(state("1", event("go", "1")))
    run.do(1, Break(ANN, source="1", to="1"))
    run.do(2, Raise("go"), Resume(ANN), Raise("go"))
    assert run.lines(2, "paused", "enter") == [
        "2 paused app 1 breakpoint 1", "2 enter 1", "2 paused app 1 breakpoint 1",
    ]  # fmt: skip
    run.do(3, Goto(ANN, "1"), Resume(ANN))
    assert run.lines(3, "resumed", "paused")[-1] == "3 paused app 1 breakpoint 1"


def test_transitions_by_time_pause_too_and_are_taken_with_the_resume() -> None:
    run = Run(state("1", timeout=after(5, "2")) + state("2"))
    run.do(1, Break(ANN, to="2"))
    run.do(100, Resume(ANN))
    run.until(200)
    assert run.trace.of("paused")[0]["t"] == 5
    assert run.trace.states() == [(0, "1"), (100, "2")]
    assert run.trace.one("transition")["timeout"] is True


def test_a_timeout_that_leads_nowhere_is_no_transition() -> None:
    run = Run(state("1", timeout=after(5)) + state("2", timeout=after(5, "#back")))
    run.do(1, Break(ANN, source="1"), Break(ANN, source="2"))
    run.until(6)
    assert run.lines(5) == ["5 event timeout", "5 ignored timeout"]
    other = Run(state("2", timeout=after(5, "#back")) + state("1"))
    other.do(1, Break(ANN, source="2"))
    other.until(6)
    assert other.trace.of("paused") == []


def test_transitions_back_pause_by_where_they_lead() -> None:
    rbd = state("1", event("go", "2")) + state("2", event("back", "#back"))
    run = Run(rbd)
    run.do(1, Raise("go"), Break(ANN, to="1"))
    run.do(2, Raise("back"))
    assert run.lines(2) == ["2 paused app 2 breakpoint 1"]
    timed = Run(state("1", event("go", "2")) + state("2", timeout=after(5, "#back")))
    timed.do(1, Raise("go"), Break(ANN, to="1"))
    timed.until(50)
    assert timed.lines(2) == ["6 paused app 2 breakpoint 1"]


def test_unnamed_events_pause_before_they_are_taken() -> None:
    run = Run(state("1", always("#again", "x") + always("2", "y")) + state("2"))
    run.do(1, Break(ANN, to="1"))
    run.do(2, Set({"x": 1}, "m"))
    assert run.lines(2) == ["2 paused app 1 breakpoint 1"]
    assert run.trace.cause(run.trace[-1]) == run.trace.one("data", tag="x")


def test_a_resume_that_leads_on_pauses_before_it() -> None:
    rbd = state("1", event("resumed", "2"), "<speech>A</speech>") + state("2")
    run = Run(rbd, spds=ALL.format("speech"))
    run.do(1, Break(ANN, to="2"), Set({"busy": True}, "m"), Raise("x"), Set({"busy": False}, "m"))
    assert run.trace.of("resume") == []
    run.do(2, Resume(ANN))
    assert run.trace.states() == [(0, "1"), (2, "2")]


@pytest.mark.parametrize("name", ["done", "done.p"])
def test_the_end_of_a_part_pauses_before_its_state_is_left(name: str) -> None:
    part = application(state("p"), "part")
    rbd = state("1", event("go", "5")) + flow("5", "part", event(name, "1"))
    run = Run(rbd, parts={"part.rbd.xml": part})
    run.do(1, Break(ANN, source="5"), Raise("go"))
    assert run.trace.one("paused")["state"] == "5/p"
    run.do(2, Resume(ANN))
    assert run.trace.states()[-1] == (2, "1")


def test_a_breakpoint_on_a_situation_pauses_all_or_one() -> None:
    spds = """<modules><module name="a" resources=""/><module name="b" resources=""/></modules>
      <situation name="busy"><condition><data tag="busy" is="true"/></condition></situation>
      <situation name="calm"><module name="a" priority="1"/><module name="b" priority="1"/>
      </situation>"""
    run = Run(TWO, spds=spds)
    run.do(1, Break(ANN, situation="busy"), Break(ANN, "b", situation="calm"))
    run.do(2, Set({"busy": True}, "m"), Resume(ANN))
    assert run.lines(2, "paused") == ["2 paused a 1 breakpoint 1", "2 paused b 1 breakpoint 1"]
    assert run.trace.cause(run.trace.of("paused")[0]) == run.trace.of("situation")[-1]
    run.do(3, Set({"busy": False}, "m"), Break(ANN, situation="none"))
    assert run.lines(3, "paused") == ["3 paused b 1 breakpoint 2"]
    assert run.refused == ["there is no situation none; there is busy, calm"]


def test_a_breakpoint_pauses_only_while_its_condition_holds() -> None:
    run = Run(GO)
    when = '<any><data tag="x" is="1"/><data tag="y" within="5" exists="true"/></any>'
    run.do(1, Break(ANN, state="2", when=when), Break(ANN, to="3", when='<data tag="z" is="1"/>'))
    run.do(2, Goto(ANN, "2"))
    assert run.trace.of("paused") == []
    run.do(3, Set({"x": 1}, "m"), Goto(ANN, "2"), Resume(ANN))
    run.do(4, Raise("go"))
    assert run.trace.states()[-1] == (4, "3")
    assert len(run.trace.of("paused")) == 1


@pytest.mark.parametrize(
    ("when", "said"),
    [
        ('<data tag="x" is="1" for="2"/>', "a breakpoint's condition is judged at its moment"),
        ('<any><data tag="x" is="1" for="2"/></any>', "a breakpoint's condition is judged"),
        ("<data", "the condition can not be read: "),
        ("<other/>", "the condition can not be read: "),
        ("", "the condition can not be read: "),
    ],
)
def test_a_condition_that_can_not_be_judged_is_refused(when: str, said: str) -> None:
    run = Run(GO)
    run.do(1, Break(ANN, state="2", when=when))
    assert run.refused[0].startswith(said)
    assert run.robot.board.get("debugger.breakpoints") is None


def test_breakpoints_stand_on_the_blackboard_and_in_the_trace_with_who_changed_them() -> None:
    run = Run(GO)
    run.do(1, Break(ANN, state="2"), Break("operator:bo", source="1", to="2"), Unbreak(ANN, 1))
    second = {"id": 2, "writer": "operator:bo", "application": "app", "from": "1", "to": "2"}
    last = run.trace.of("data", tag="debugger.breakpoints")[-1]
    assert (last["value"], last["writer"], last["version"]) == ([second], ANN, 3)
    assert run.robot.board.look("debugger.breakpoints") == [second]
    run.do(2, Unbreak(ANN), Unbreak(ANN))
    assert run.robot.board.look("debugger.breakpoints") == []
    assert len(run.trace.of("data", t=2)) == 1
    run.do(3, Set({"debugger.breakpoints": []}, "m"))
    assert run.refused == ["debugger.breakpoints is kept by the runtime; set a tag of your own"]


def test_an_event_that_an_operator_raises_tells_who_did_it() -> None:
    for before in ((), (Pause(ANN), Raise("gone"))):
        run = Run(GO)
        run.do(1, *before, Raise("go", writer=ANN), Raise("gone"), Resume(ANN))
        told = {event["name"]: event.get("writer") for event in run.trace.of("event")}
        assert told == {"go": ANN, "gone": None}


# -- laws --------------------------------------------------------------------


def test_a_snapshot_keeps_breakpoints_and_pauses() -> None:
    run, rbd = Run(GO), GO
    when = '<data tag="x" is="1"/>'
    run.do(1, Set({"x": 1}, "m"), Break(ANN, to="2", when=when), Break(ANN, state="3"))
    run.do(2, Raise("go"))
    other = Run(rbd)
    other.robot.restore(run.robot.snapshot())
    for one in (run, other):
        one.raw = b""
        one.do(3, Raise("go"))
        one.do(4, Resume(ANN), Step(ANN), Goto(ANN, "1"), Raise("go"))
    assert other.raw == run.raw
    assert b'"breakpoint":2' in run.raw


CLOCKS = (
    state("1", event("go", "2") + event("timeout", "3"), timeout=after(3))
    + state("2", timeout=after(2, "1"), events=event("go", "#again"))
    + state("3", timeout='<timeout next="#back" idle="true">1.5</timeout>', events=event("go", "1"))
)
moments = st.integers(0, 30).map(lambda n: n / 2 + 0.25)


@settings(max_examples=40, deadline=None)
@given(st.lists(moments, max_size=5).map(sorted), moments, st.integers(0, 9))
def test_pausing_and_resuming_only_shifts_what_comes_after(
    goes: list[float], paused: float, length: int
) -> None:
    plain, other = Run(CLOCKS), Run(CLOCKS)
    for at in goes:
        plain.do(at, Raise("go"))
    plain.until(20)
    before = [at for at in goes if at <= paused]
    for at in before:
        other.do(at, Raise("go"))
    other.do(paused, Pause(ANN))
    other.do(paused + length, Resume(ANN))
    for at in goes[len(before) :]:
        other.do(at + length, Raise("go"))
    other.until(20 + length)

    def shifted(run: Run, by: float) -> list[tuple[float, str]]:
        kept = [one for one in run.trace if one["kind"] not in ("paused", "resumed")]
        resumed = run.trace.of("resumed")
        after = resumed[0]["seq"] if resumed else 0
        return [
            (one["t"] - (by if after and one["seq"] > after else 0), told(one).split(" ", 1)[1])
            for one in kept
        ]

    assert shifted(other, length) == shifted(plain, 0)
