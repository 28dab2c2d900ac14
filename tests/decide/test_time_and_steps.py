"""formats.md, *Time and steps*."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

from situ.decide.inputs import Set, Start
from situ.decide.robot import Robot

if TYPE_CHECKING:
    from tests.decide.conftest import Build, Play, Trace

END: dict[str, Any] = {"at": 100, "end": True}


def state(no: str, events: str = "", actions: str = "", timeout: str = "") -> str:
    return (
        f'<state no="{no}">{timeout}<backgroundactions>{actions}</backgroundactions>'
        f"<expectedevents>{events}</expectedevents></state>"
    )


def application(name: str, states: str) -> str:
    return f'<application name="{name}">{states}</application>'


def together(*names: str, resources: str = "") -> str:
    declared = "".join(f'<module name="{name}" resources="{resources}"/>' for name in names)
    given = "".join(f'<module name="{name}" priority="1"/>' for name in names)
    return f'<modules>{declared}</modules><situation name="s">{given}</situation>'


# -- time --------------------------------------------------------------------


def test_time_is_whole_microseconds(play: Play) -> None:
    rbd = state("1", timeout='<timeout next="2">0.1000004</timeout>')
    rbd += state("2", timeout='<timeout next="3">0.2</timeout>') + state("3")
    assert play(rbd, [END]).states() == [(0, "1"), (0.1, "2"), (0.3, "3")]


def test_due_times_do_not_drift(play: Play) -> None:
    trace = play(state("1", timeout="<timeout>0.1</timeout>"), [{"at": 1, "end": True}])
    assert [e["t"] for e in trace.of("event")] == [
        0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0,
    ]  # fmt: skip


# -- what falls due at one moment --------------------------------------------

EVERYTHING = """
  <modules><module name="m" resources="base"/><module name="app" resources="head"/></modules>
  <situation name="near"><condition><data tag="near" is="true" within="5"/></condition>
    <module name="app" priority="1"/><module name="m" priority="1"/></situation>
  <situation name="held" dwell="5"><condition><data tag="held" is="true"/></condition>
    <module name="app" priority="1"/><module name="m" priority="1"/></situation>
  <situation name="rest"><module name="app" priority="1"/><module name="m" priority="1"/>
  </situation>"""


def test_due_at_one_moment_has_an_order(play: Play) -> None:
    """Ends of ``within``, of dwell, of commands, automatic finishes, timeouts, then inputs."""
    rbd = state("1", actions='<robot resource="head" command="nod" wait="true"/>',
                timeout="<timeout>5</timeout>")  # fmt: skip
    lines = [
        {"at": 0, "acquire": {"module": "m", "resources": ["base"]}},
        {"at": 0, "command": {"module": "m", "resource": "base", "value": 1, "for": 5}},
        # It dwells from 0 on, and what stands before it takes over at 0 until 5.
        {"at": 0, "set": {"held": True}},
        {"at": 0, "set": {"held": False}},
        {"at": 0, "set": {"near": True}},
        {"at": 5, "set": {"x": 1}},
    ]
    trace = play(rbd, lines, spds=EVERYTHING, auto_finish=5)
    assert trace.lines(since=5) == [
        "5 condition near false <data",
        "5 situation near held <condition",
        "5 situation held rest <situation^2",
        "5 mapping base m null <mapping",
        "5 finished app robot nod ok null <action",
        "5 mapping head app null <finished",
        "5 event app timeout <enter",
        "5 ignored app timeout unexpected <event",
        "5 data x 1 scenario v1 <-",
    ]


def test_of_timeouts_the_earlier_started_goes_first(play: Play) -> None:
    rbd = [
        application("a", state("1", '<event name="go" next="2"/>')
                    + state("2", timeout='<timeout next="1">2</timeout>')),
        application("b", state("1", timeout='<timeout next="2">5</timeout>') + state("2")),
    ]  # fmt: skip
    lines = [{"at": 3, "event": "go"}, END]
    trace = play(rbd, lines, spds=together("a", "b"))
    assert trace.lines("transition", since=5) == [
        "5 transition b 1 2 timeout <enter^1",
        "5 transition a 2 1 timeout <enter^1",
    ]


def test_started_at_one_moment_they_go_in_the_projects_order(play: Play) -> None:
    one = state("1", timeout='<timeout next="2">5</timeout>') + state("2")
    rbd = [application("b", one), application("a", one)]
    trace = play(rbd, [END], spds=together("a", "b"))
    assert [e["application"] for e in trace.of("transition")] == ["b", "a"]


def test_of_automatic_finishes_the_earlier_started_goes_first(play: Play) -> None:
    rbd = state("1", actions='<launch program="b"/><launch program="a"/><speech>A</speech>')
    trace = play(rbd, [END], auto_finish=2)
    assert trace.lines("finished") == [
        "2 finished app launch b ok null <action^2",
        "2 finished app launch a ok null <action^1",
        "2 finished app speech - ok null <action",
    ]


def test_each_thing_that_falls_due_is_a_step(play: Play) -> None:
    """What the first timeout brings is done before the second is looked at."""
    rbd = [
        application("a", state("1", timeout='<timeout next="2">5</timeout>')
                    + state("2", actions='<set tag="x">1</set>')),
        application("b", state("1", timeout='<timeout next="2">5</timeout>',
                    events='<event next="3"><when><data tag="x" is="1"/></when></event>')
                    + state("2") + state("3")),
    ]  # fmt: skip
    trace = play(rbd, [END], spds=together("a", "b"))
    assert trace.states("b") == [(0, "1"), (5, "3")]


def test_what_falls_due_goes_before_an_input_of_the_same_moment(play: Play) -> None:
    rbd = state("1", '<event name="go" next="3"/>', timeout='<timeout next="2">5</timeout>')
    rbd += state("2", '<event name="go" next="4"/>') + state("3") + state("4")
    trace = play(rbd, [{"at": 5, "event": "go"}])
    assert trace.states() == [(0, "1"), (5, "2"), (5, "4")]


# -- writes ------------------------------------------------------------------


def test_all_tags_of_one_set_are_written_before_anything_is_judged(play: Play) -> None:
    spds = """<situation name="a"><condition><data tag="x" is="1"/><data tag="y" is="1"/>
      </condition></situation><situation name="b"><condition><data tag="x" is="1"/></condition>
      </situation><situation name="c"/>"""
    trace = play((), [{"at": 1, "set": {"x": 1, "y": 1}}], spds=spds)
    assert trace.situations() == [(0, "c"), (1, "a")]


def test_a_set_action_counts_at_once_for_what_comes_after_it(play: Play) -> None:
    rbd = state(
        "1",
        '<event name="go"><add tag="x">1</add><set tag="y">{x}</set><add tag="x">{y}</add></event>',
    )
    trace = play(rbd, [{"at": 1, "event": "go"}], tags={"x": 1})
    assert (trace.values("y"), trace.values("x")) == ([2], [1, 2, 4])


# -- inside a step -----------------------------------------------------------


def test_situations_go_first_then_resumptions_then_unnamed_then_raised(play: Play) -> None:
    rbd = [
        application("a", state("1", '<event name="said"><set tag="log">said</set></event>',
                               '<message topic="t" done="said"/>')),
        application("b", state("1", '<event next="2"><when><data tag="x" is="1"/></when></event>')
                    + state("2")),
        application("c", state("1", actions="<speech>A</speech>")),
    ]  # fmt: skip
    spds = """<modules><module name="a" resources=""/><module name="b" resources=""/>
      <module name="c" resources="speech"/></modules>
      <situation name="quiet"><condition><data tag="x" isnot="1"/></condition></situation>
      <situation name="loud"><module name="a" priority="1"/><module name="b" priority="1"/>
      <module name="c" priority="1"/></situation>"""
    rbd[0] = rbd[0].replace(
        "</expectedevents>",
        '<event name="go" next="#again"/></expectedevents>',
    )
    lines = [{"at": 1, "event": "go", "application": "a"}]
    # ``a`` enters anew, which raises ``said`` and sets x: everything follows from that.
    rbd[0] = rbd[0].replace("<message", '<set tag="x">{y}</set><message')
    trace = play(rbd, [{"at": 1, "set": {"y": 1}}, *lines], spds=spds)
    assert trace.lines("situation", "resume", "transition", "event", since=1) == [
        "1 event a go <-",
        "1 transition a 1 1 go <event",
        "1 situation quiet loud <condition",
        "1 resume c [] <authority",
        "1 event c resumed <resume",
        "1 transition b 1 2 - <data",
        "1 event a said <finished",
    ]


def test_the_earliest_raised_event_of_all_applications_goes_first(play: Play) -> None:
    """b's event was raised before what a raised while it handled its own."""
    rbd = [
        application("a", state("1", '<event name="go"><message topic="t" done="a1"/></event>'
                               '<event name="a1"/>')),
        application("b", state("1", '<event name="go"><message topic="t" done="b1"/></event>'
                               '<event name="b1"><message topic="t" done="b2"/></event>'
                               '<event name="b2"/>')),
    ]  # fmt: skip
    trace = play(rbd, [{"at": 1, "event": "go"}], spds=together("a", "b"))
    assert trace.lines("event") == [
        "1 event a go <-",
        "1 event b go <-",
        "1 event a a1 <finished^1",
        "1 event b b1 <finished",
        "1 event b b2 <finished",
    ]


def test_an_application_finishes_an_event_before_anything_else_is_looked_at(play: Play) -> None:
    """The situation changes by the first action, but the entry comes to its end."""
    rbd = state("1", '<event name="go" next="2"><set tag="x">1</set></event>')
    rbd += state("2", actions='<set tag="x">0</set><set tag="y">1</set>')
    spds = """<modules><module name="app" resources=""/></modules>
      <situation name="a"><condition><data tag="x" is="1"/></condition></situation>
      <situation name="b"><condition><data tag="y" is="1"/></condition></situation>
      <situation name="c"><module name="app" priority="1"/></situation>"""
    trace = play(rbd, [{"at": 1, "event": "go"}], spds=spds)
    assert trace.situations() == [(0, "c"), (1, "b")]
    assert [e["kind"] for e in trace if e["t"] == 1][-2:] == ["condition", "situation"]


def test_a_raised_event_survives_a_change_of_state_and_is_judged_by_the_state_then_current(
    play: Play,
) -> None:
    rbd = state(
        "1",
        '<event name="one" next="2"/><event name="two" next="3"/>',
        '<message topic="t" done="one"/><message topic="t" done="two"/>',
    )
    rbd += state("2", '<event name="two" next="4"/>') + state("3") + state("4")
    assert play(rbd, []).states() == [(0, "1"), (0, "2"), (0, "4")]


# -- livelocks ---------------------------------------------------------------


def ring(length: int) -> str:
    """An application that raises ``length`` events one after the other, once ``go`` came."""
    return state(
        "1",
        '<event name="go"><set tag="n">1</set><message topic="t" done="next"/></event>'
        f'<event name="next"><when><data tag="n" below="{length}"/></when><add tag="n">1</add>'
        '<message topic="t" done="next"/></event><event name="next"/>',
    )


def test_a_hundred_events_in_one_step_are_none_too_many(play: Play) -> None:
    trace = play(ring(99), [{"at": 1, "event": "go"}])
    assert len(trace.of("event")) == 100
    assert trace.of("error") == []


def test_one_more_is_a_livelock(play: Play) -> None:
    trace = play(ring(100), [{"at": 1, "event": "go"}, {"at": 2, "event": "next"}])
    assert [e["t"] for e in trace.of("error")] == [1]
    assert len([e for e in trace.of("event") if e["t"] == 1]) == 100
    # The waiting event was dropped; the next input is judged as ever.
    assert len(trace.of("event")) == 101


@pytest.mark.parametrize(("entries", "livelocks"), [(100, 0), (101, 1)])
def test_a_list_that_unnamed_events_empty_may_have_a_hundred_entries(
    play: Play, entries: int, livelocks: int
) -> None:
    """So the checker can not tell whether it ends: no list says how long it gets."""
    when = '<when><data tag="many.0" exists="true"/></when>'
    take = '<take from="many" tag="one"/>'
    rbd = state("1", f'<event next="#again">{when}{take}</event>')
    trace = play(rbd, [{"at": 1, "set": {"many": list(range(entries))}}])
    assert len(trace.of("error")) == livelocks


def loop(when: str = "") -> str:
    return state("1", f'<event next="2">{when}</event>') + state("2", '<event next="1"/>')


def test_unnamed_events_that_lead_to_each_other_are_a_livelock_and_the_state_reached_stays(
    play: Play,
) -> None:
    when = '<when><data tag="x" is="1"/></when>'
    rbd = state("1", f'<event next="2">{when}</event>') + state(
        "2", f'<event next="1">{when}</event><event name="go" next="3"/>'
    )
    trace = play(rbd + state("3"), [{"at": 1, "set": {"x": 1}}, {"at": 2, "set": {"x": 0}}])
    assert len(trace.of("transition")) == 100
    assert len(trace.of("error")) == 1
    assert trace.states()[-1] == (1, "1")


def test_after_a_livelock_the_state_stays_until_something_new_comes(play: Play) -> None:
    """It is not taken up again by a step that has nothing to do with it."""
    rbd = (
        loop()
        .replace('<event next="1"/>', '<event next="1"/><event name="go" next="3"/>')
        .replace('<event next="2"></event>', '<event next="2"/><event name="go" next="3"/>')
    )
    trace = play(rbd + state("3"), [{"at": 1, "set": {"x": 1}}, {"at": 2, "event": "go"}])
    assert [e["t"] for e in trace.of("error")] == [0]
    assert trace.states()[-1] == (2, "3")


def test_waiting_events_of_all_applications_are_dropped(play: Play) -> None:
    rbd = [
        application("a", loop('<when><data tag="x" is="1"/></when>').replace(
            '<event next="1"/>', '<event next="1"><when><data tag="x" is="1"/></when></event>')),
        application("b", state("1", '<event name="late" next="2"/>') + state("2")),
    ]  # fmt: skip
    rbd[0] = rbd[0].replace(
        '<state no="1">', '<state no="0"><expectedevents><event name="late" next="1">'
        '<set tag="x">1</set></event></expectedevents></state><state no="1">'
    )  # fmt: skip
    lines = [{"at": 1, "event": "late"}, {"at": 2, "set": {"x": 0}}, {"at": 3, "event": "late"}]
    trace = play(rbd, lines, spds=together("a", "b"))
    assert [e["t"] for e in trace.of("error")] == [1]
    assert trace.states("b") == [(0, "1"), (3, "2")]


def test_situations_that_alternate_are_a_livelock(play: Play) -> None:
    rbd = state("1", '<event next="2"><when><data tag="situation.name" is="b"/></when>'
                '<set tag="x">1</set></event>')  # fmt: skip
    rbd += state("2", '<event next="1"><when><data tag="situation.name" is="a"/></when>'
                 '<set tag="x">0</set></event>')  # fmt: skip
    spds = """<modules><module name="app" resources=""/></modules><situation name="a"><condition>
      <data tag="x" is="1"/></condition></situation><situation name="b">
      <module name="app" priority="1"/></situation>"""
    trace = play(rbd, [], spds=spds)
    assert len(trace.of("error")) == 1
    # An event and a change of situation in turn, the first situation counted too.
    assert (len(trace.of("transition")), len(trace.of("situation"))) == (50, 51)


def many(steps: int) -> str:
    """So many applications whose timeouts fall due at one moment, two events each."""
    return state(
        "1", '<event name="timeout"><message topic="t" done="x"/></event><event name="x"/>',
        timeout="<timeout>5</timeout>",
    )  # fmt: skip


def play_many(play: Play, count: int, lines: list[dict[str, Any]]) -> Trace:
    names = [f"a{number}" for number in range(count)]
    return play([application(name, many(count)) for name in names], lines, spds=together(*names))


def test_the_steps_of_one_moment_are_counted_together(play: Play) -> None:
    assert play_many(play, 50, [{"at": 5, "end": True}]).of("error") == []
    trace = play_many(play, 51, [{"at": 5, "end": True}])
    assert len(trace.of("error")) == 1
    assert len(trace.of("event")) == 100


def test_an_input_begins_the_count_anew(play: Play) -> None:
    lines = [{"at": 1, "event": "go"}, {"at": 1, "event": "go"}]
    assert play(ring(60), lines).of("error") == []


# -- the start ---------------------------------------------------------------


def test_at_the_start_conditions_then_the_first_situation_then_each_application(
    play: Play,
) -> None:
    rbd = [
        application("a", state("1", actions='<set tag="y">1</set>')),
        application("b", state("1", '<event next="2"><when><data tag="y" is="1"/></when></event>')
                    + state("2")),
    ]  # fmt: skip
    spds = """<modules><module name="a" resources=""/><module name="b" resources=""/></modules>
      <situation name="p"><condition><data tag="y" is="1"/></condition></situation>
      <situation name="q"><condition><data tag="x" is="1"/></condition></situation>
      <situation name="r"><condition><data tag="z" exists="false"/></condition></situation>
      <situation name="s"><module name="a" priority="1"/><module name="b" priority="1"/>
      </situation>"""
    assert play(rbd, [], spds=spds, tags={"x": 1, "w": 2}).lines() == [
        "0 data x 1 project v1 <-",
        "0 data w 2 project v1 <-",
        "0 condition q true <data^1",
        "0 condition r true <-",
        "0 situation - q <condition^1",
        "0 enter a 1 <-",
        '0 action a 1 set - tag="y" value=1 <enter',
        "0 data y 1 a v1 <action",
        "0 finished a set - ok null <action",
        "0 enter b 1 <-",
        "0 condition p true <data",
        "0 situation q p <condition",
        "0 exit b 1 <enter",
        "0 transition b 1 2 - <enter",
        "0 enter b 2 <transition",
    ]


def test_the_first_situation_comes_from_null(play: Play) -> None:
    trace = play((), [], spds='<situation name="s"/>')
    assert trace.one("situation")["from"] is None


@pytest.mark.parametrize("at", [1, 5])
def test_a_step_never_looks_ahead(build: Build, at: int) -> None:
    """What falls due later than the step's time stays for later."""
    robot = Robot(build(state("1", timeout='<timeout next="2">5</timeout>') + state("2")))
    robot.step(Start(), 0)
    assert robot.due() == 5_000_000
    events, _ = robot.step(None, at * 1_000_000)
    assert bool(events) is (at == 5)
    robot.step(Set({"x": 1}, "m"), 5_000_000)
    assert robot.due() == (5_000_000 if at == 1 else None)
