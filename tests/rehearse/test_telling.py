"""Traces as files, and their events in plain words."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from situ.decide import trace
from situ.document.project import Project
from situ.errors import UsageError
from situ.rehearse.recording import Recording, Step, read_trace
from situ.rehearse.telling import Teller, kept_by_runtime, value_words

ENTER = '{"kind":"enter","seq":1,"t":0,"cause":null,"application":"a","state":"1"}\n'


# -- files -----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("nonsense\n", ":1: not an event of a trace"),
        ("\n{}\n", ":2: not an event of a trace: Object missing required field `seq`"),
        ('{"kind":"enter","seq":1,"t":0,"cause":null}\n', "missing required field `application`"),
        (ENTER + ENTER, ":2: seq 1 after 1: give the trace of one run"),
        ("\xff", ":1: not an event of a trace"),
    ],
)
def test_what_is_no_trace_is_refused_with_its_line(tmp_path: Path, text: str, said: str) -> None:
    file = tmp_path / "t.jsonl"
    file.write_bytes(text.encode("latin-1"))
    with pytest.raises(UsageError) as refused:
        read_trace(file)
    assert said in str(refused.value)
    assert str(refused.value).startswith(str(file))


def test_empty_lines_and_kinds_that_only_a_robot_has_are_read(tmp_path: Path) -> None:
    file = tmp_path / "t.jsonl"
    file.write_text(ENTER + '\n{"kind":"told","seq":2,"t":1,"cause":null,"files":[]}\n')
    assert [event["kind"] for event in read_trace(file)] == ["enter", "told"]
    with pytest.raises(UsageError, match="No such file"):
        read_trace(tmp_path / "none")


def test_the_steps_of_a_trace_begin_with_outside_input_or_later() -> None:
    def event(seq: int, t: float, cause: int | None) -> dict[str, Any]:
        return {"seq": seq, "t": t, "cause": cause, "kind": "x"}

    events = [event(1, 0, None), event(2, 0, None), event(3, 0, 2), event(4, 1, None),
              event(5, 1, 4), event(6, 1, None), event(7, 2, 4)]  # fmt: skip
    steps = Recording.of(events).steps
    assert [[e["seq"] for e in step.events] for step in steps] == [[1, 2, 3], [4, 5], [6], [7]]
    assert [step.t for step in steps] == [0, 1, 1, 2]
    assert Step([]).t == 0


# -- words -----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("event", "told"),
    [
        (trace.Data(1, 0, None, "x", None, "a", 2), "a deletes x"),
        (trace.Data(1, 0, None, "x", [1, 2.0], "a", 2), "a sets x to [1,2]"),
        (trace.Data(1, 0, None, "x", ["y" * 99], "a", 2), f'a sets x to ["{"y" * 57}…'),
        (trace.Condition(1, 0, None, "s", False), "the condition of situation s no longer holds"),
        (trace.Situation(1, 0, None, source=None, to="s"), "situation s"),
        (trace.Situation(1, 0, None, source="r", to="s"), "situation s after r"),
        (trace.Acquire(1, 0, None, "m", ("a", "b"), ("c",)), "m asks for a, b and c"),
        (trace.Acquire(1, 0, None, "m", ()), "m asks for nothing"),
        (trace.Abandon(1, 0, None, "m", ("a",)), "m gives back a"),
        (trace.Lost(1, 0, None, "m", ()), "m is lost"),
        (trace.Connected(1, 0, None, "m", ()), "m connects"),
        (trace.Authority(1, 0, None, "r", "m", None), "m loses r, nobody holds it"),
        (trace.Authority(1, 0, None, "r", "m", "n"), "n gets r from m"),
        (trace.Mapping(1, 0, None, "r", "m", None), "r stops and holds"),
        (trace.Event(1, 0, None, "a", "e"), "event e comes to a"),
        (trace.Ignored(1, 0, None, "a", "e", "suspended"), "a ignores e: it is suspended"),
        (
            trace.Ignored(1, 0, None, "a", "e", "guard"),
            "a ignores e: it has no guard for it that holds",
        ),
        (
            trace.Ignored(1, 0, None, "a", "e", "unexpected"),
            "a ignores e: it does not expect it here",
        ),
        (trace.Ignored(1, 0, None, "a", "e", "later"), "a ignores e: it later"),
        (trace.Exit(1, 0, None, "a", "1"), "a leaves 1"),
        (
            trace.Transition(1, 0, None, "a", "1", "2", None, True),
            "a goes from 1 to 2 by the timeout",
        ),
        (trace.Screen(1, 0, None, "a", "1", []), "a shows the screen of 1"),
        (trace.Action(1, 0, None, "a", "1", "sound", None, src="x.ogg"), "a begins sound x.ogg"),
        (
            trace.Action(1, 0, None, "a", "1", "robot", "go", resource="base"),
            "a begins robot go on base",
        ),
        (trace.Action(1, 0, None, "a", "1", "set", None, tag="t"), "a begins set t"),
        (trace.Action(1, 0, None, "a", "1", "speech", None, text="Hi"), "a begins speech “Hi”"),
        (trace.Finished(1, 0, None, "a", "speech", None, True), "speech ends well"),
        (
            trace.Finished(1, 0, None, "a", "service", "s", False, error="late"),
            "service s ends badly: late",
        ),
        (trace.Cancelled(1, 0, None, "a", "launch", "g"), "launch g is cancelled"),
        (trace.Suspend(1, 0, None, "a", ("r",)), "a is suspended: it does not hold r"),
        (trace.Resume(1, 0, None, "a", ()), "a goes on"),
        (
            trace.Transition(1, 0, None, "a", "1", "2", None, writer="operator:ann"),
            "a goes from 1 to 2 by operator ann",
        ),
        (trace.Paused(1, 0, None, "a", "1", 3), "a is paused in 1 by breakpoint 3"),
        (trace.Paused(1, 0, None, "a", "1", None, "o"), "a is paused in 1 by o"),
        (trace.Resumed(1, 0, None, "a", "1", 3, "o"), "a is no longer paused, by o"),
        (
            trace.Deployed(1, 0, None, 2, ("a.xml", "b.xml"), "o"),
            "version 2 takes over, deployed by o; changed: a.xml and b.xml",
        ),
        (trace.Deployed(1, 0, None, 2, (), "o"), "version 2 takes over, deployed by o"),
        (trace.Warned(1, 0, None, "so", "there"), "warning: so"),
        (trace.Failed(1, 0, None, "so", "there"), "error: so"),
    ],
    ids=lambda one: one if isinstance(one, str) else "",
)
def test_every_kind_of_event_has_its_words(event: trace.TraceEvent, told: str) -> None:
    assert Teller().tell(trace.to_fields(event)) == told


def test_what_somebody_did_is_told_by_his_name_or_as_you() -> None:
    ann, given = "operator:ann", {"seq": 1, "t": 0, "cause": None}
    sets = {**given, "kind": "data", "tag": "x", "value": 1, "writer": ann}
    deletes = {**sets, "value": None}
    raised = {**given, "kind": "event", "application": "a", "name": "e", "writer": ann}
    sent = trace.to_fields(trace.Transition(1, 0, None, "a", "1", "2", None, writer=ann))
    paused = trace.to_fields(trace.Paused(1, 0, None, "a", "1", None, ann))
    every = (sets, deletes, raised, sent, paused)
    assert [Teller().tell(event) for event in every] == [
        "operator ann sets x to 1",
        "operator ann deletes x",
        "event e comes to a, raised by operator ann",
        "a goes from 1 to 2 by operator ann",
        "a is paused in 1 by operator ann",
    ]
    assert [Teller(me=ann).tell(event) for event in every] == [
        "you set x to 1",
        "you delete x",
        "event e comes to a, raised by you",
        "a goes from 1 to 2 by you",
        "a is paused in 1 by you",
    ]
    other = {**sets, "writer": "operator:bob"}
    assert Teller(me=ann).tell(other) == "operator bob sets x to 1"


def test_a_kind_that_is_not_known_is_called_by_its_name() -> None:
    assert Teller().tell({"kind": "told", "seq": 1, "t": 0, "cause": None}) == "told"


def test_where_an_event_without_a_cause_comes_from() -> None:
    teller = Teller()
    given: dict[str, Any] = {"seq": 2, "t": 0, "cause": None, "kind": "data"}
    assert teller.origin({**given, "writer": "project"}) == "the start"
    assert teller.origin({**given, "writer": "scenario"}) == "from outside"
    assert teller.origin({**given, "kind": "enter"}) == "the start"
    assert teller.origin({**given, "kind": "acquire"}) == "from outside"
    assert teller.origin({**given, "kind": "enter", "t": 1}) == "from outside"
    assert teller.origin({**given, "cause": 1}) == "because of #1"


def test_values_in_a_line() -> None:
    assert [value_words(v) for v in (None, "a b", True, 1.0, {"x": "y"})] == [
        "nothing", "“a b”", "true", "1", '{"x":"y"}',
    ]  # fmt: skip
    assert kept_by_runtime("robot/head")
    assert kept_by_runtime("clock.time")
    assert not kept_by_runtime("user.name")


@pytest.mark.parametrize(
    ("resource", "value", "said"),
    [
        ("head", {"yaw": 40}, 'm moves head: {"yaw":40}'),
        ("head", None, "head stops and holds"),
        ("head", {"components": ["neck"]}, 'm moves head: {"components":["neck"]}'),
        ("head", {"components": 2, "text": ""}, 'm moves head: {"components":2,"text":""}'),
        ("speech", {"text": "Good morning", "lang": "en"}, "m says “Good morning”"),
        (
            "screen",
            {"components": [{"type": "image"}, {"type": "text", "text": "Hello"}]},
            "m shows “Hello” on the screen",
        ),
        ("screen", {"components": []}, "m shows something else on the screen"),
    ],
)
def test_what_is_said_and_shown_is_told_in_its_own_words(
    resource: str, value: Any, said: str
) -> None:
    fields = {"kind": "mapping", "resource": resource, "module": "m", "value": value}
    event = {"seq": 1, "t": 0.0, "cause": None, **fields}
    assert Teller(Project(root=".", name="p")).tell(event) == said
