"""formats.md, *Parts*, and what touches them in *States*, *Events*, *Timeouts*, *always*."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Protocol

import pytest
from tests.decide.conftest import build_project, run

from situ.decide.inputs import Raise, Start
from situ.decide.robot import Robot
from situ.document import codec
from situ.document.project import Project
from situ.document.rbd import Application

if TYPE_CHECKING:
    from tests.decide.conftest import Trace

END: dict[str, Any] = {"at": 100, "end": True}
AT = 'x="1" y="1" width="9" height="9"'


class Parts(Protocol):
    def __call__(
        self, rbd: str, lines: Sequence[dict[str, Any]], *, spds: str | None = ..., **parts: str
    ) -> Trace: ...


def application(text: str, name: str) -> Application:
    read, problems = codec.read(
        f'<application name="{name}">{text}</application>'.encode(), f"{name}.rbd.xml"
    )
    assert not problems
    assert isinstance(read, Application)
    return read


def project(rbd: str, spds: str | None = None, **parts: str) -> Project:
    named = {f"{name}.rbd.xml": application(text, name) for name, text in parts.items()}
    return build_project(rbd, spds, parts=named)


@pytest.fixture
def play() -> Parts:
    """Plays a scenario in the application ``app`` of ``rbd`` with parts by name."""

    def played(
        rbd: str, lines: Sequence[dict[str, Any]], *, spds: str | None = None, **parts: str
    ) -> Trace:
        return run(project(rbd, spds, **parts), lines)

    return played


def state(no: str, inside: str = "", more: str = "") -> str:
    return f'<state no="{no}" {more}>{inside}</state>'


def flow(no: str, part: str, events: str = "", more: str = "") -> str:
    return state(no, f'<flow src="{part}.rbd.xml"/>' + expected(events), more)


def expected(events: str) -> str:
    return f"<expectedevents>{events}</expectedevents>" if events else ""


def event(name: str, target: str | None = None, inside: str = "") -> str:
    to = "" if target is None else f' next="{target}"'
    return f'<event name="{name}"{to}>{inside}</event>'


def go(*targets: str) -> str:
    """Expected events ``go2`` … that lead to the states of those numbers."""
    return expected("".join(event(f"go{one.strip('#')}", one) for one in targets))


def says(text: str) -> str:
    return f"<backgroundactions><speech>{text}</speech></backgroundactions>"


def shows(name: str) -> str:
    return f'<screen><components><text id="{name}" {AT}>{name}</text></components></screen>'


def always(inside: str) -> str:
    return f"<always>{inside}</always>"


def at(*events: str) -> list[dict[str, Any]]:
    """One event a second, from 1 s on."""
    return [{"at": n, "event": name} for n, name in enumerate(events, 1)]


def entered(trace: Trace) -> list[str]:
    return [path for _, path in trace.states()]


# -- names, entering and leaving ------------------------------------------------


def test_the_states_of_a_part_are_named_by_their_paths(play: Parts) -> None:
    trace = play(state("1", go("5")) + flow("5", "p"), at("go5", "go2"), p=state("a", go("2")) +
                 state("2"))  # fmt: skip
    assert entered(trace) == ["1", "5", "5/a", "5/2"]
    assert trace.lines("transition") == [
        "1 transition app 1 5 go5 <event",
        "2 transition app 5/a 5/2 go2 <event",
    ]


def test_entering_a_part_enters_the_state_around_it_first(play: Parts) -> None:
    trace = play(state("1", go("5")) + flow("5", "p"), at("go5"), p=state("1", says("in")))
    assert trace.lines("event", "exit", "transition", "enter", "action", since=1)[:6] == [
        "1 event app go5 <-",
        "1 exit app 1 <event",
        "1 transition app 1 5 go5 <event",
        "1 enter app 5 <transition",
        "1 enter app 5/1 <enter",
        "1 action app 5/1 speech - text=\"in\" <enter",
    ]  # fmt: skip


def test_an_event_taken_outside_leaves_the_part_inner_states_first(play: Parts) -> None:
    trace = play(
        flow("5", "p", event("out", "6")) + state("6"), at("out"), p=flow("2", "q"),
        q=state("1", says("in")),
    )  # fmt: skip
    assert trace.lines("exit", "cancelled", "transition", "enter", since=1) == [
        "1 exit app 5/2/1 <event",
        "1 cancelled app speech - <exit",
        "1 exit app 5/2 <event",
        "1 exit app 5 <event",
        "1 transition app 5 6 out <event",
        "1 enter app 6 <transition",
    ]


def test_parts_may_hold_parts_and_start_with_one(play: Parts) -> None:
    trace = play(flow("5", "p"), [], p=flow("2", "q"), q=state("1"))
    assert trace.lines("enter") == [
        "0 enter app 5 <-",
        "0 enter app 5/2 <enter",
        "0 enter app 5/2/1 <enter",
    ]


def test_a_part_may_run_in_several_states(play: Parts) -> None:
    trace = play(
        flow("5", "p", event("out", "6")) + flow("6", "p"), at("go2", "out", "go2"),
        p=state("1", go("2")) + state("2"),
    )  # fmt: skip
    assert entered(trace) == ["5", "5/1", "5/2", "6", "6/1", "6/2"]


def test_the_application_tells_its_innermost_state(play: Parts) -> None:
    robot = Robot(project(flow("5", "p"), p=state("1", more='name="Ask the name"')))
    robot.step(Start(), 0)
    assert robot.board.look("application/app") == {
        "state": "5/1", "name": "Ask the name", "suspended": False,
    }  # fmt: skip


def test_the_part_belongs_to_its_parents_application(play: Parts) -> None:
    inner = state("1", says("in") + go("2")) + state("2")
    trace = play(flow("5", "p"), at("go2"), p=inner)
    assert {e["application"] for e in trace if "application" in e} == {"app"}
    assert trace.one("acquire")["module"] == "app"


# -- the order in which candidates are tried -------------------------------------


@pytest.mark.parametrize(
    ("inner", "inner_always", "outer", "outer_always", "taken"),
    [
        ("a", "b", "c", "d", "5/a"),
        ("", "b", "c", "d", "5/b"),
        ("", "", "c", "d", "c"),
        ("", "", "", "d", "d"),
    ],
)
def test_an_event_is_offered_to_the_innermost_state_first_then_outwards(
    play: Parts, inner: str, inner_always: str, outer: str, outer_always: str, taken: str
) -> None:
    def one(target: str) -> str:
        return expected(event("x", target) if target else "")

    ends = state("a") + state("b") + state("c") + state("d")
    trace = play(
        always(one(outer_always)) + flow("5", "p", event("x", outer) if outer else "") + ends,
        at("x"),
        p=always(one(inner_always)) + state("1", one(inner)) + ends,
    )
    assert entered(trace)[-1] == taken


def test_a_guard_that_fails_inside_lets_the_event_go_outwards(play: Parts) -> None:
    when = '<when><data tag="t" exists="true"/></when>'
    trace = play(
        flow("5", "p", event("x", "6")) + state("6"), at("x"),
        p=state("1", expected(event("x", "2", when))) + state("2"),
    )  # fmt: skip
    assert entered(trace)[-1] == "6"


def test_an_unnamed_event_outside_is_taken_as_soon_as_it_holds(play: Parts) -> None:
    when = '<event next="6"><when><data tag="t" exists="true"/></when></event>'
    trace = play(
        flow("5", "p", when) + state("6"), [*at("go2"), {"at": 2, "set": {"t": 1}}],
        p=state("1", go("2")) + state("2"),
    )  # fmt: skip
    assert trace.lines("transition", since=2) == ["2 transition app 5 6 - <data"]


def test_unnamed_events_inside_come_before_those_outside(play: Parts) -> None:
    when = '<event next="2"><when><data tag="t" exists="true"/></when></event>'
    trace = play(
        flow("5", "p", when) + state("2"), [{"at": 1, "set": {"t": 1}}],
        p=state("1", expected(when)) + state("2"),
    )  # fmt: skip
    assert entered(trace) == ["5", "5/1", "5/2", "2"]


def test_an_internal_event_outside_leaves_the_part_where_it_is(play: Parts) -> None:
    trace = play(
        flow("5", "p", event("x", None, '<set tag="t">1</set>')), [*at("x"), END],
        p=state("1", '<timeout next="2">3</timeout>') + state("2"),
    )  # fmt: skip
    assert trace.values("t") == [1]
    assert trace.states() == [(0, "5"), (0, "5/1"), (3, "5/2")]
    assert trace.one("action")["state"] == "5/1"


def test_an_event_nobody_accepts_is_ignored_once(play: Parts) -> None:
    trace = play(flow("5", "p"), at("x"), p=state("1", go("1")))
    assert trace.lines("ignored") == ["1 ignored app x unexpected <event"]


def test_always_next_names_a_state_of_its_file(play: Parts) -> None:
    trace = play(
        always(expected(event("home", "1"))) + state("1", go("5")) + flow("5", "p"),
        at("go5", "go2", "restart", "home"),
        p=always(expected(event("restart", "1"))) + state("1", go("2")) + state("2"),
    )
    assert entered(trace) == ["1", "5", "5/1", "5/2", "5/1", "1"]


# -- always="false" ------------------------------------------------------------------


def test_without_always_leaves_out_that_files(play: Parts) -> None:
    outer, inner = always(expected(event("x", "6"))), always(expected(event("y", "2")))
    trace = play(
        outer + flow("5", "p") + state("6"), at("y", "x"),
        p=inner + state("1", more='always="false"') + state("2"),
    )  # fmt: skip
    assert entered(trace) == ["5", "5/1", "6"]


def test_without_always_on_a_state_with_a_flow_is_for_the_whole_part(play: Parts) -> None:
    outer, inner = always(expected(event("x", "6"))), always(expected(event("y", "2")))
    trace = play(
        outer + flow("5", "p", more='always="false"') + state("6"), at("x", "y", "x"),
        p=inner + state("1") + state("2"),
    )  # fmt: skip
    assert entered(trace) == ["5", "5/1", "5/2"]


# -- timeouts -------------------------------------------------------------------------


def test_the_timeout_of_the_innermost_always_that_has_one_serves(play: Parts) -> None:
    outer = always('<timeout next="6">9</timeout>') + flow("5", "p") + state("6", more=
        'always="false"')  # fmt: skip
    inner = always('<timeout next="2">4</timeout>')
    both = play(outer, [END], p=inner + state("1") + state("2", more='always="false"'))
    assert both.states() == [(0, "5"), (0, "5/1"), (4, "5/2"), (13, "6")]


def test_a_timeout_of_always_counts_from_entering_the_innermost_state(play: Parts) -> None:
    outer = always('<timeout next="6">9</timeout>') + flow("5", "p") + state("6", more=
        'always="false"')  # fmt: skip
    trace = play(outer, [{"at": 5, "event": "go2"}, END], p=state("1", go("2")) + state("2"))
    assert trace.states()[-1] == (14, "6")
    assert trace.lines("transition", since=14) == ["14 transition app 5 6 timeout <enter"]


def test_an_own_timeout_goes_before_those_of_always(play: Parts) -> None:
    trace = play(
        always('<timeout next="5">2</timeout>') + flow("5", "p"), [END],
        p=always('<timeout next="1">3</timeout>')
        + state("1", '<timeout next="2">4</timeout>')
        + state("2", '<timeout next="3">1000</timeout>')
        + state("3"),
    )  # fmt: skip
    assert trace.states() == [(0, "5"), (0, "5/1"), (4, "5/2")]


# -- #back and #again ------------------------------------------------------------------


def test_each_run_of_a_part_has_its_own_stack(play: Parts) -> None:
    inner = state("1", go("2")) + state("2", go("3")) + state("3", go("#back"))
    outer = state("1", go("5")) + flow("5", "p", event("out", "6")) + state("6", go("#back"))
    trace = play(
        outer, at("go5", "go2", "go3", "out", "goback", "goback", "go2", "go3", "goback", "goback"),
        p=inner,
    )  # fmt: skip
    assert entered(trace) == [
        "1", "5", "5/1", "5/2", "5/3", "6", "5", "5/1", "5/2", "5/3", "5/2",
    ]  # fmt: skip
    assert [e["reason"] for e in trace.of("ignored")] == ["unexpected", "unexpected"]


def test_back_inside_is_refused_where_its_run_has_nothing_to_go_back_to(play: Parts) -> None:
    trace = play(
        state("0", go("5")) + flow("5", "p", event("goback", "6")) + state("6"),
        at("go5", "goback"), p=state("1", go("#back")),
    )  # fmt: skip
    assert entered(trace) == ["0", "5", "5/1", "6"]


def test_back_outside_goes_to_the_state_from_which_the_holding_one_was_entered(
    play: Parts,
) -> None:
    trace = play(
        state("0", go("1")) + state("1", go("5")) + flow("5", "p", event("goback", "#back")),
        at("go1", "go5", "go2", "goback"), p=state("1", go("2")) + state("2"),
    )  # fmt: skip
    assert entered(trace) == ["0", "1", "5", "5/1", "5/2", "1"]


def test_entering_the_start_of_a_part_empties_its_stack_only(play: Parts) -> None:
    inner = state("1", go("2", "#back")) + state("2", go("1"))
    outer = state("0", go("5")) + flow("5", "p", event("out", "#back"))
    trace = play(outer, at("go5", "go2", "go1", "goback", "out"), p=inner)
    assert entered(trace) == ["0", "5", "5/1", "5/2", "5/1", "0"]
    assert trace.lines("ignored") == ["4 ignored app goback guard <event"]


def test_again_outside_runs_the_part_anew(play: Parts) -> None:
    inner = state("1", go("2")) + state("2", go("#back"))
    trace = play(flow("5", "p", event("anew", "#again")), at("go2", "anew", "go2", "goback"),
                 p=inner)  # fmt: skip
    assert entered(trace) == ["5", "5/1", "5/2", "5", "5/1", "5/2", "5/1"]
    assert "2 transition app 5 5 anew <event" in trace.lines()


# -- done.x and done ---------------------------------------------------------------------


def test_entering_an_end_state_raises_done_x_in_the_state_that_holds_the_part(
    play: Parts,
) -> None:
    trace = play(
        flow("5", "p", event("done.ok", "6") + event("done.no", "7")) + state("6") + state("7"),
        at("gook"), p=state("1", go("ok", "no")) + state("ok", says("thanks")) + state("no"),
    )  # fmt: skip
    assert trace.lines("enter", "action", "event", "transition", "cancelled", since=1)[2:] == [
        "1 enter app 5/ok <transition",
        '1 action app 5/ok speech - text="thanks" <enter',
        "1 event app done.ok <enter",
        "1 cancelled app speech - <exit",
        "1 transition app 5 6 done.ok <event",
        "1 enter app 6 <transition",
    ]


def test_done_comes_where_done_x_is_not_accepted(play: Parts) -> None:
    trace = play(flow("5", "p", event("done", "6")) + state("6"), at("go2"),
                 p=state("1", go("2")) + state("2"))  # fmt: skip
    assert trace.lines("event", "ignored", "transition", since=1)[2:] == [
        "1 event app done.2 <enter",
        "1 event app done <event",
        "1 transition app 5 6 done <event",
    ]


def test_done_comes_where_the_guard_of_done_x_fails(play: Parts) -> None:
    when = '<when><data tag="t" exists="true"/></when>'
    events = event("done.2", "7", when) + event("done", "6")
    trace = play(flow("5", "p", events) + state("6") + state("7"), at("go2"),
                 p=state("1", go("2")) + state("2"))  # fmt: skip
    assert entered(trace)[-1] == "6"
    assert trace.of("ignored") == []


def test_where_neither_is_accepted_only_done_is_ignored(play: Parts) -> None:
    trace = play(flow("5", "p"), at("go2"), p=state("1", go("2")) + state("2"))
    assert trace.lines("ignored") == ["1 ignored app done unexpected <event"]


def test_neither_goes_further_up(play: Parts) -> None:
    events = event("done.2", "6") + event("done", "6")
    inner = always(expected(event("done", "9"))) + state("1", go("2")) + state("2") + state("9")
    outer = always(expected(events)) + flow("5", "p", events) + state("6")
    trace = play(outer, at("go2"), p=flow("1", "q", event("x", "9")) + state("9"),
                 q=inner)  # fmt: skip
    assert entered(trace) == ["5", "5/1", "5/1/1", "5/1/2"]


def test_always_of_the_holding_file_takes_it_and_that_of_the_part_does_not(play: Parts) -> None:
    outer = always(expected(event("done.2", "6"))) + flow("5", "p") + state("6")
    inner = always(expected(event("done.2", "1"))) + state("1", go("2")) + state("2")
    trace = play(outer, at("go2"), p=inner)
    assert entered(trace) == ["5", "5/1", "5/2", "6"]


def test_an_end_may_be_answered_without_leaving(play: Parts) -> None:
    events = event("done", None, '<set tag="ended">true</set>')
    trace = play(flow("5", "p", events), at("go2"), p=state("1", go("2")) + state("2"))
    assert trace.values("ended") == [True]
    assert entered(trace)[-1] == "5/2"


@pytest.mark.parametrize(
    ("inside", "ends"),
    [
        ("", True),
        (expected(event("x")), True),
        ('<timeout>5</timeout>', True),
        (expected(event("x", "1")), False),
        ('<timeout next="1">5</timeout>', False),
    ],
)  # fmt: skip
def test_an_end_is_what_no_own_event_and_no_own_timeout_leaves(
    play: Parts, inside: str, ends: bool
) -> None:
    # always and outer states do not count
    inner = always(expected(event("y", "1"))) + state("1", go("2")) + state("2", inside)
    trace = play(flow("5", "p", event("z", "5")), at("go2"), p=inner)
    assert [e["name"] for e in trace.of("event")][1:] == (["done.2", "done"] if ends else [])


def test_an_end_outside_of_any_part_tells_nobody(play: Parts) -> None:
    assert play(state("1", go("2")) + state("2"), at("go2")).lines("event") == [
        "1 event app go2 <-"
    ]


def test_what_waits_before_the_end_of_the_actions_delays_done(play: Parts) -> None:
    waiting = '<backgroundactions><speech wait="true">bye</speech></backgroundactions>'
    trace = play(
        flow("5", "p", event("done", "6")) + state("6"),
        [{"at": 3, "finish": {"action": "speech"}}], p=state("1", waiting),
    )  # fmt: skip
    assert trace.states() == [(0, "5"), (0, "5/1"), (3, "6")]
    assert trace.lines("cancelled") == []


def test_done_of_a_part_that_has_been_left_is_ignored(play: Parts) -> None:
    # The unnamed event leaves the part before the raised one is looked at.
    leaves = '<event next="6"><when><data tag="t" exists="true"/></when></event>'
    sets = '<backgroundactions><set tag="t">1</set></backgroundactions>'
    done = expected(event("done", "7") + event("done.2", "7"))
    trace = play(
        flow("5", "p", leaves) + state("6", done) + state("7"), at("go2"),
        p=state("1", go("2")) + state("2", sets),
    )  # fmt: skip
    assert entered(trace)[-1] == "6"


def test_an_inner_end_may_be_its_parts_way_to_its_own_end(play: Parts) -> None:
    middle = flow("1", "q", event("done.ok", "good")) + state("good")
    trace = play(flow("5", "p", event("done.good", "6")) + state("6"), at("gook"), p=middle,
                 q=state("1", go("ok")) + state("ok"))  # fmt: skip
    assert entered(trace) == ["5", "5/1", "5/1/1", "5/1/ok", "5/good", "6"]


# -- screens, resources, speech --------------------------------------------------------


def test_the_components_of_always_lie_above_inner_to_outer(play: Parts) -> None:
    trace = play(always(shows("out")) + flow("5", "p"), [],
                 p=always(shows("in")) + state("1", shows("own")))  # fmt: skip
    assert trace.lines("screen") == ["0 screen app 5/1 [own=own in=in out=out] <enter"]


def test_a_screen_is_kept_into_a_part_within_it_and_out_of_it(play: Parts) -> None:
    trace = play(
        state("1", shows("own") + go("5")) + flow("5", "p", event("out", "6")) + state("6"),
        at("go5", "go2", "out"), p=state("1", go("2")) + state("2", shows("inner")),
    )  # fmt: skip
    assert trace.lines("screen", "abandon") == [
        "0 screen app 1 [own=own] <enter",
        "2 screen app 5/2 [inner=inner] <enter",
    ]


def test_a_kept_screen_lies_under_the_always_of_the_state_that_keeps_it(play: Parts) -> None:
    trace = play(
        always(shows("out")) + state("1", shows("own") + go("5")) + flow("5", "p"),
        at("go5"), p=always(shows("in")) + state("1"),
    )  # fmt: skip
    assert trace.lines("screen", since=1) == ["1 screen app 5/1 [own=own in=in out=out] <enter"]


def test_it_asks_for_what_all_active_states_use_together(play: Parts) -> None:
    robot = '<backgroundactions><robot resource="base" command="go"/></backgroundactions>'
    trace = play(always(shows("out")) + flow("5", "p"), [], p=state("1", robot))
    assert trace.lines("acquire") == ["0 acquire app [base screen] <enter"]


def test_repeat_outside_says_the_speeches_of_the_innermost_state(play: Parts) -> None:
    trace = play(
        always(expected(event("again", None, "<repeat/>"))) + flow("5", "p"), at("again"),
        p=state("1", says("hello")),
    )  # fmt: skip
    assert [e["text"] for e in trace.of("action")] == ["hello", "hello"]


def test_phrases_of_all_active_states_are_heard(play: Parts) -> None:
    robot = Robot(project(
        flow("5", "p", event("x", "5", "<say>stop</say>")),
        p=state("1", expected(event("y", "1", "<say>yes</say>"))),
    ))  # fmt: skip
    robot.step(Start(), 0)
    assert robot.board.look("listen") == ["yes", "stop"]


_BUSY = """
  <observe><data tag="busy"/></observe>
  <modules><module name="app" resources="screen speech"/></modules>
  <situation name="busy"><condition><data tag="busy" is="true"/></condition></situation>
  <situation name="calm"><module name="app" priority="1"/></situation>
"""


def test_a_part_entered_suspended_ends_when_it_resumes(play: Parts) -> None:
    trace = play(
        flow("5", "p", event("done.2", "6")) + state("6"),
        [{"at": 1, "set": {"busy": True}}, {"at": 3, "set": {"busy": False}}],
        spds=_BUSY, p=state("1", '<timeout next="2">2</timeout>') + state("2", says("b")),
    )  # fmt: skip
    assert trace.lines("enter", "suspend", "resume", "action", "event") == [
        "0 enter app 5 <-",
        "0 enter app 5/1 <enter",
        "2 enter app 5/2 <transition",
        "2 suspend app [speech] <acquire",
        "3 resume app [] <authority",
        "3 event app resumed <resume",
        '3 action app 5/2 speech - text="b" <resume',
        "3 event app done.2 <resume",
        "3 enter app 6 <transition",
    ]


def test_the_queue_belongs_to_the_application_as_a_whole(play: Parts) -> None:
    sets = '<backgroundactions><set tag="t" done="later">1</set></backgroundactions>'
    trace = play(
        flow("5", "p", event("done", "6")) + state("6", expected(event("later", "7"))) + state("7"),
        [], p=state("1", sets),
    )  # fmt: skip
    # ``later`` was raised before ``done`` and is judged in the part, where nobody accepts it.
    assert [(e["name"]) for e in trace.of("event")] == ["later", "done.1", "done"]
    assert entered(trace) == ["5", "5/1", "6"]


def test_a_snapshot_within_a_part_goes_on_the_same(play: Parts) -> None:
    made = project(
        state("0", go("5")) + flow("5", "p", event("goout", "#back") + event("done", "0")),
        p=state("1", go("2")) + state("2", go("3")) + state("3", go("#back", "4")) + state("4"),
    )
    names = ["go5", "go2", "go3", "goback", "go3", "go4", "go5", "goout"]
    whole = Robot(made)
    whole.step(Start(), 0)
    for number, name in enumerate(names, 1):
        again = Robot(made)
        again.restore(whole.snapshot())
        events, effects = whole.step(Raise(name), number)
        assert again.step(Raise(name), number) == (events, effects)
    assert whole.board.look("application/app")["state"] == "0"
