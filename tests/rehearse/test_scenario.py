"""formats.md, *Scenarios*: lines, verbs, expectations."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import msgspec
import pytest

from situ.decide import inputs
from situ.rehearse import scenario
from situ.rehearse.expect import Expect
from situ.rehearse.scenario import End

if TYPE_CHECKING:
    from tests.rehearse.conftest import Simulate


# -- verbs -------------------------------------------------------------------


def at_1(run: Any) -> list[tuple[str, Any]]:
    return [
        (e["kind"], e.get("name", e.get("tag", e.get("state"))))
        for e in run.trace
        if e["t"] == 1 and e["kind"] not in ("abandon", "authority", "mapping", "cancelled")
    ]


@pytest.mark.parametrize(
    ("verb", "kinds"),
    [
        ({"set": {"face.visible": True, "x": 1}}, [("data", "face.visible"), ("data", "x")]),
        ({"event": "other"}, [("event", "other"), ("ignored", "other")]),
        (
            {"event": "other", "application": "reception"},
            [("event", "other"), ("ignored", "other")],
        ),
        ({"touch": True}, [("event", "woken"), ("ignored", "woken")]),
        (
            {"use": {"component": "go"}},
            [
                ("data", "pressed"),
                ("event", "clickGo"),
                ("exit", "1"),
                ("transition", None),
                ("enter", "2"),
            ],
        ),
        (
            {"finish": {"action": "speech"}},
            [("finished", None), ("event", "said"), ("ignored", "said")],
        ),
        ({"acquire": {"module": "transfer", "resources": ["base"]}}, [("error", None)]),
        ({"abandon": {"module": "transfer", "resources": ["base"]}}, [("error", None)]),
        ({"command": {"module": "m", "resource": "b", "value": 1, "for": 1}}, [("error", None)]),
        ({"lost": {"module": "transfer"}}, [("error", None)]),
        ({"end": True}, []),
        ({"expect": {"kind": "enter", "state": "1"}}, []),
    ],
)
def test_each_verb_does_what_it_says(
    simulate: Simulate, verb: dict[str, Any], kinds: list[tuple[str, Any]]
) -> None:
    run = simulate([{"at": 1, **verb}])
    assert (run.status, at_1(run)) == (0, kinds)


# -- what is no scenario -----------------------------------------------------


@pytest.mark.parametrize(
    "scenario",
    [
        '{"at": 2, "event": "a"}\n{"at": 1, "event": "b"}',
        '{"at": 1}',
        '{"at": 1, "event": "a", "touch": true}',
        '{"at": 1, "end": true}\n{"at": 2, "event": "a"}',
        '{"at": 1, "end": true}\n{"at": 1, "expect": {"kind": "enter"}}',
        '{"at": 1, "event": "a", "application": "nobody"}',
        '{"at": 1, "finish": {"action": "speech", "application": "nobody"}}',
        '{"at": 1, "touch": true, "application": "reception"}',
        '{"event": "a"}',
        '{"at": -1, "event": "a"}',
        '{"at": "1", "event": "a"}',
        '{"at": null, "event": "a"}',
        '{"at": 1, "event": 5}',
        '{"at": 1, "fly": true}',
        '{"at": 1, "set": ["x"]}',
        '{"at": 1, "use": {"value": 1}}',
        '{"at": 1, "use": {"component": "go", "colour": 1}}',
        '{"at": 1, "acquire": {"module": "m"}}',
        '{"at": 1, "acquire": {"module": "m", "resources": "head"}}',
        '{"at": 1, "command": {"module": "m", "resource": "head", "value": 1, "for": 0}}',
        '{"at": 1, "touch": false}',
        '{"at": 1, "end": false}',
        '{"at": 1, "expect": 5}',
        '{"at": 1, "event": "a"',
        "at 1: event a",
        "[1, 2]",
        '{"at": NaN, "event": "a"}',
        b'{"at": 1, "event": "\xff"}',
        '{"at": 1, "set": ' + "[" * 20_000,
        '{"at": 1, "set": {"a": ' + "[" * 20_000 + "]" * 20_000 + "}}",
    ],
)
def test_what_is_no_scenario_is_one_line_and_exit_2(
    simulate: Simulate, scenario: str | bytes
) -> None:
    run = simulate(scenario)
    assert (run.status, run.raw) == (2, b"")
    assert len(run.told.splitlines()) == 1
    number = len(scenario.splitlines())
    assert f"s.jsonl:{number}:" in run.told


def test_empty_lines_are_passed_over(simulate: Simulate) -> None:
    run = simulate('\n{"at": 1, "event": "a"}\n\n  \n{"at": 2, "event": "b"}\r\n')
    assert [e["name"] for e in run.of("event")] == ["a", "b"]


def test_lines_of_one_moment_are_taken_in_their_order(simulate: Simulate) -> None:
    run = simulate([{"at": 1, "event": name} for name in "abc"])
    assert [e["name"] for e in run.of("event")] == ["a", "b", "c"]


# -- finish ------------------------------------------------------------------

THREE = """<application name="reception"><state no="1"><backgroundactions>
  <launch program="a"/><launch program="b"/><launch program="a"/></backgroundactions></state>
  </application>"""


def test_finish_ends_the_earliest_started_action_that_fits(simulate: Simulate) -> None:
    run = simulate(
        [
            {"at": 1, "finish": {"action": "launch", "name": "b"}},
            {"at": 2, "finish": {"action": "launch", "application": "reception"}},
            {"at": 3, "finish": {"action": "launch", "name": "a", "ok": False}},
            {"at": 4, "finish": {"action": "launch", "name": "a"}},
        ],
        rbd=THREE,
    )
    assert [(e["t"], e["name"], e["ok"]) for e in run.of("finished")] == [
        (1, "b", True), (2, "a", True), (3, "a", False),
    ]  # fmt: skip
    assert [e["t"] for e in run.of("warning")] == [4]


@pytest.mark.parametrize(
    "finish",
    [
        {"action": "service", "name": "other"},
        {"action": "movie"},
        {"action": "set"},
        {"action": "speech", "name": "find"},
    ],
)
def test_finish_of_what_does_not_run_is_a_warning(
    simulate: Simulate, finish: dict[str, Any]
) -> None:
    run = simulate([{"at": 1, "finish": finish}])
    assert (run.status, at_1(run)) == (0, [("warning", None)])


def test_finish_goes_well_unless_it_says_otherwise_and_brings_a_result(
    simulate: Simulate,
) -> None:
    run = simulate([{"at": 1, "finish": {"action": "service", "result": {"names": [1]}}}])
    (finished,) = run.of("finished")
    assert (finished["ok"], finished["result"]) == (True, {"names": [1]})
    assert run.of("data", tag="names")[0]["value"] == [1]


def test_the_action_of_which_of_several_applications(simulate: Simulate) -> None:
    run = simulate([{"at": 1, "finish": {"action": "launch", "application": "reception"}}])
    assert [e["application"] for e in run.of("finished")] == ["reception"]


# -- the end -----------------------------------------------------------------


def test_what_falls_due_at_the_end_is_done(simulate: Simulate) -> None:
    assert simulate([{"at": 5, "end": True}]).of("enter")[-1]["state"] == "2"
    assert simulate([{"at": 4.999999, "end": True}]).of("enter")[-1]["state"] == "1"


def test_without_an_end_the_run_ends_at_the_last_lines_moment(simulate: Simulate) -> None:
    assert simulate([{"at": 5, "event": "a"}]).of("enter")[-1]["state"] == "2"
    assert simulate([{"at": 4, "event": "a"}]).of("enter")[-1]["state"] == "1"
    assert [e["t"] for e in simulate([]).trace if e["t"] > 0] == []


# -- expectations ------------------------------------------------------------


def expected(simulate: Simulate, *lines: dict[str, Any]) -> bool:
    return simulate(list(lines)).status == 0


def expect(at: float, **fields: Any) -> dict[str, Any]:
    if "from_" in fields:
        fields["from"] = fields.pop("from_")
    return {"at": at, "expect": fields}


GO = {"at": 1, "use": {"component": "go"}}


def test_an_event_must_have_these_fields(simulate: Simulate) -> None:
    assert expected(simulate, GO, expect(1, kind="transition", from_="1", to="2"))
    assert not expected(simulate, GO, expect(1, kind="transition", from_="1", to="3"))
    assert not expected(simulate, GO, expect(1, kind="transition", nothing=None))
    assert expected(simulate, GO, expect(1, kind="mapping", resource="screen", value=None)) is (
        False
    )


def test_expectations_are_fulfilled_one_after_the_other(simulate: Simulate) -> None:
    one, two = expect(1, kind="exit"), expect(1, kind="transition")
    assert expected(simulate, GO, one, two)
    assert not expected(simulate, GO, two, one)
    # One event fulfils one expectation.
    assert not expected(simulate, GO, one, one)


def test_any_event_since_the_last_one_found_will_do(simulate: Simulate) -> None:
    assert expected(simulate, GO, expect(9, kind="enter", state="1"), expect(9, kind="exit"))


def test_one_that_fails_takes_nothing_away(simulate: Simulate) -> None:
    run = simulate([GO, expect(1, kind="lost"), expect(1, kind="enter", state="1")])
    assert run.status == 1
    assert len(run.told.splitlines()) == 1


def test_it_is_judged_when_its_moment_is_over(simulate: Simulate) -> None:
    assert expected(simulate, expect(1, kind="transition"), GO)
    assert not expected(simulate, expect(0.9, kind="transition"), GO)
    # What falls due at its moment belongs to it, what comes later does not.
    assert expected(simulate, expect(5, kind="transition"))
    assert not expected(simulate, expect(4, kind="transition"), {"at": 5, "end": True})


def test_two_of_one_moment_are_judged_in_their_order(simulate: Simulate) -> None:
    first, second = expect(1, kind="exit"), expect(1, kind="enter", state="2")
    assert expected(simulate, first, second, GO)
    assert not expected(simulate, second, first, GO)


@pytest.mark.parametrize(
    ("wanted", "fits"),
    [
        ({"a": [1, {"b": True}]}, True),
        ({"a": [1.0, {"b": True}]}, True),
        ({"a": [1, {"b": 1}]}, False),
        ({"a": [1]}, False),
        ({}, False),
        ('{"a": [1, {"b": true}]}', False),
    ],
)
def test_nested_fields_are_compared_like_is(simulate: Simulate, wanted: object, fits: bool) -> None:
    line = {"at": 1, "set": {"x": {"a": [1, {"b": True}]}}}
    assert expected(simulate, line, expect(1, kind="data", value=wanted)) is fits


def test_null_fields_can_be_expected(simulate: Simulate) -> None:
    timeout = {"kind": "transition", "event": None, "timeout": True}
    assert expected(simulate, {"at": 5, "expect": timeout})
    assert not expected(simulate, GO, {"at": 1, "expect": timeout})


def test_a_failed_expectation_is_told_with_its_line_and_what_came_nearest(
    simulate: Simulate,
) -> None:
    run = simulate([GO, expect(2, kind="enter", state="3")])
    assert run.status == 1
    assert "line 2" in run.told
    assert '"state":"3"' in run.told
    assert '"state":"2"' in run.told


def test_what_is_written_is_read_as_the_same() -> None:
    done: list[tuple[int, Any]] = [
        (0, inputs.Touch()),
        (250_000, inputs.Set({"a.b": None, "n": 2}, scenario.WRITER)),
        (1_000_000, inputs.Raise("clickYes")),
        (1_000_000, inputs.Raise("clickNo", "reception")),
        (1_000_001, inputs.Use("yes")),
        (2_000_000, inputs.Use("name", None)),
        (2_000_000, inputs.Acquire("nod", ("head",), ("base",))),
        (2_000_000, inputs.Abandon("nod")),
        (2_000_000, inputs.Command("nod", "head", {"pan": 3}, 0.5)),
        (2_000_000, inputs.Lost("nod")),
        (3_000_000, inputs.Finish("service", "find", ok=False, error="gone", status=404)),
        (3_000_000, inputs.Finish("speech", result=[])),
        (3_000_000, Expect({"kind": "enter", "state": "2"})),
        (3_500_000, End()),
    ]
    read = scenario.parse(scenario.write(done), "x.jsonl")
    assert [(line.at, line.does) for line in read] == [
        (at, msgspec.structs.replace(does, status=None))
        if isinstance(does, inputs.Finish) and does.status is msgspec.UNSET
        else (at, does)
        for at, does in done
    ]


def test_what_has_no_verb_is_not_written() -> None:
    with pytest.raises(ValueError, match="Finish"):
        scenario.write([(0, inputs.Finish(id=3))])
