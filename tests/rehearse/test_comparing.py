"""Where two runs part (``situ compare``): what the robots did, not when."""

from __future__ import annotations

import itertools
import json
import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.rehearse.recorded_robot import ROOT

from situ import cli
from situ.document.ready import load_ready
from situ.rehearse import scenario
from situ.rehearse.comparing import Difference, alike, matched
from situ.rehearse.deeds import Deeds
from situ.rehearse.parting import lines, told
from situ.rehearse.recording import record
from situ.rehearse.telling import Teller

Events = list[dict[str, Any]]
SEQUENCES = st.text("abc", max_size=12).map(list)


def deeds(events: Events) -> Deeds:
    found = Deeds()
    for event in events:
        found.add(event)
    return found


def played(name: str, script: str) -> Events:
    where = ROOT / "examples" / name
    script_lines = scenario.load(where / "scenarios" / script)
    return record(load_ready(where), script_lines)[0].events


def turned(one: Difference) -> tuple[Any, ...]:
    return one.at[::-1], {(s.strand, s.second, s.first, s.at[::-1]) for s in one.stretches}


def kept(one: Difference) -> tuple[Any, ...]:
    return one.at, {(s.strand, s.first, s.second, s.at) for s in one.stretches}


# -- putting two sequences beside one another ----------------------------------------------


def longest(a: list[str], b: list[str]) -> int:
    """How much two have in common at the most, by the book."""
    row = [0] * (len(b) + 1)
    for one in a:
        before, row = row, [0]
        for j, other in enumerate(b):
            row.append(before[j] + 1 if one == other else max(row[-1], before[j + 1]))
    return row[-1]


@given(SEQUENCES, SEQUENCES)
def test_as_much_as_can_be_is_put_beside_its_like(a: list[str], b: list[str]) -> None:
    pairs = matched(a, b)
    assert all(a[i] == b[j] for i, j in pairs)
    assert all(i < k and j < m for (i, j), (k, m) in itertools.pairwise(pairs))
    assert len(pairs) == longest(a, b)


@given(SEQUENCES, SEQUENCES, st.integers(1, 5))
def test_the_other_way_round_the_pairs_are_the_same_turned(
    a: list[str], b: list[str], patience: int
) -> None:
    pairs = matched(a, b, patience)
    assert all(a[i] == b[j] for i, j in pairs)
    assert [(j, i) for i, j in matched(b, a, patience)] == pairs


# -- what two robots did -------------------------------------------------------------------


SCRIPTS = [
    ("reception", "known-user.jsonl", "second-thoughts.jsonl"),
    ("reception", "walked-away.jsonl", "known-user.jsonl"),
    ("conversation", "fig5.jsonl", "stopped.jsonl"),
]


@pytest.mark.parametrize(("name", "one", "other"), SCRIPTS)
def test_a_run_does_not_differ_from_itself_and_two_do_so_either_way_round(
    name: str, one: str, other: str
) -> None:
    a, b = deeds(played(name, one)), deeds(played(name, other))
    assert alike(a, a).differences == []
    found, back = alike(a, b).differences, alike(b, a).differences
    assert found
    assert [turned(each) for each in back] == [kept(each) for each in found]
    assert alike(a, b).common == (alike(b, a).common or ())[::-1] == (0.0, 0.0)


@pytest.mark.parametrize(("name", "script", "_"), SCRIPTS)
def test_neither_when_nor_in_which_order_strands_went_on_counts(
    name: str, script: str, _: str
) -> None:
    events = played(name, script)
    dice = random.Random(script)
    # Whole strands are moved against one another, and every one is slower.
    apart: dict[str, Events] = {}
    for event in events:
        apart.setdefault(str(event.get("resource", event.get("application", ""))), []).append(event)
    slower, t = [], 0.0
    order = [name for name, every in apart.items() for _ in every]
    dice.shuffle(order)
    # An application's name is known from where it enters a state.
    order.sort(key=lambda strand: apart[strand][0]["kind"] != "enter")
    left = {strand: iter(every) for strand, every in apart.items()}
    for seq, strand in enumerate(order, 1):
        t += dice.random()
        slower.append({**next(left[strand]), "seq": seq, "t": t})
    assert alike(deeds(events), deeds(slower)).differences == []


@given(st.data())
def test_a_deed_that_is_left_out_is_the_one_difference(data: st.DataObject) -> None:
    events: Events = [
        {"kind": "situation", "seq": n, "t": float(n), "cause": None, "from": None, "to": f"s{n}"}
        for n in range(1, 8)
    ]
    gone = data.draw(st.sampled_from(events))
    rest = [event for event in events if event is not gone]
    (one,) = alike(deeds(events), deeds(rest)).differences
    (stretch,) = one.stretches
    assert [deed.seq for deed in stretch.first] == [gone["seq"]]
    assert stretch.second == ()
    before = gone["t"] - 1.0
    assert one.agreed == (before, before)
    assert one.at == (gone["t"], gone["t"])


def test_the_numbers_of_a_modules_commands_do_not_count_but_its_words_do() -> None:
    def steered(*values: Any) -> Deeds:
        events = [{"kind": "enter", "seq": 1, "t": 0.0, "application": "desk", "state": "1"}]
        for n, (module, value) in enumerate(values, 2):
            fields = {"kind": "mapping", "seq": n, "t": float(n), "resource": "base"}
            events.append({**fields, "module": module, "value": value})
        return deeds(events)

    stream = steered(("nav", {"vx": 0.2}), ("nav", None), ("nav", {"vx": 0.25}))
    assert alike(stream, steered(("nav", {"vx": 0.1}))).differences == []
    assert alike(stream, steered(("nav", {"vx": 0.2, "to": "lobby"}))).differences
    assert alike(stream, steered(("other", {"vx": 0.2}))).differences
    # What a designer wrote counts as it stands.
    assert alike(steered(("desk", {"x": 1})), steered(("desk", {"x": 2}))).differences


def test_what_comes_of_one_moment_is_one_difference_states_first() -> None:
    known, second = (
        played("reception", "known-user.jsonl"),
        played("reception", "walked-away.jsonl"),
    )
    found = alike(deeds(known), deeds(second)).differences
    for one in found:
        kinds = [stretch.strand.kind for stretch in one.stretches]
        assert kinds == sorted(kinds, key=["state", "situation", "resource"].index)
    begun = [d.t for one in found for s in one.stretches for d in s.first[:1]]
    parted = [{d.t for s in one.stretches for d in s.first[:1]} for one in found]
    assert len(set(begun)) == sum(map(len, parted))


@pytest.mark.parametrize(
    ("value", "said"),
    [
        ({"text": "Hello"}, "desk says “Hello”"),
        ({"src": "chime.ogg"}, "desk plays chime.ogg"),
        ({"command": "nod"}, "desk lets r nod"),
        ({"vx": 1}, 'desk moves r: {"vx":1}'),
        ({"components": []}, "desk shows another screen"),
    ],
)
def test_what_moves_a_resource_is_told_in_words(value: Any, said: str) -> None:
    event: dict[str, Any] = {"kind": "mapping", "seq": 1, "t": 2.5, "cause": None, "resource": "r"}
    event |= {"module": "desk", "value": value}
    (one,) = alike(deeds([event]), deeds([])).differences
    parting = told(one, (Teller(), Teller()), ({1: event}.__getitem__, {1: event}.__getitem__))
    assert (parting.first, parting.second) == ((said,), ())
    assert lines(parting, ("a", "bcd"))[1:] == [f"  a:   {said}", "  bcd: nothing of that"]
    assert alike(deeds([event]), deeds([])).common is None


# -- the command ---------------------------------------------------------------------------


@pytest.fixture
def trace(tmp_path: Path) -> Callable[[str, str], str]:
    def write(name: str, script: str) -> str:
        file = tmp_path / script
        file.write_text("".join(json.dumps(event) + "\n" for event in played(name, script)))
        return str(file)

    return write


def test_situ_compare_says_what_each_did(
    trace: Callable[[str, str], str], capsys: pytest.CaptureFixture[str]
) -> None:
    a, b = trace("reception", "known-user.jsonl"), trace("reception", "second-thoughts.jsonl")
    assert cli.main(["compare", a, b, "--project", str(ROOT / "examples" / "reception")]) == 1
    said = capsys.readouterr().out
    assert "20 s | 14 s  reception\n  known-user.jsonl:      nothing of that\n" in said
    assert "goes from 5 verify initials to 3 enter initial 1 by clickNo" in said
    assert "reception says “Are your initials M, F?”" in said
    assert cli.main(["compare", a, b, "--json"]) == 1
    found = json.loads(capsys.readouterr().out)
    assert [20.0, 14.0] in [one["at"] for one in found]
    assert all(one["first"] != one["second"] or "screen" in one["strands"] for one in found)


def test_situ_compare_of_one_run_ends_well(
    trace: Callable[[str, str], str], capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    a = trace("conversation", "fig5.jsonl")
    assert cli.main(["compare", a, a]) == 0
    assert capsys.readouterr().out == "They did the same.\n"
    assert cli.main(["compare", a, str(tmp_path / "gone.jsonl")]) == 2
