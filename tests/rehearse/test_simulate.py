"""formats.md, *Command line*: ``situ simulate``."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from situ import cli

if TYPE_CHECKING:
    from tests.rehearse.conftest import Simulate

SPEAKING = """<application name="app"><state no="1"><backgroundactions>
  <speech done="said">A</speech><speech>B</speech><service name="s" url="http://x/"/>
  </backgroundactions><expectedevents><event name="go" next="#again"/></expectedevents></state>
  </application>"""
FILL = """<application name="app"><state no="1"><backgroundactions>
  <set tag="l">[1, 2, 3, 4, 5, 6, 7, 8]</set>
  <take from="l" tag="x" order="random"/><take from="l" tag="y" order="random"/>
  </backgroundactions></state></application>"""
WRONG = '<application name="app"><state no="1"><timeout next="9">5</timeout></state></application>'


# -- exit status -------------------------------------------------------------


def test_well_is_0_a_failed_expectation_1_wrong_input_2(simulate: Simulate) -> None:
    assert simulate([]).status == 0
    assert simulate([{"at": 0, "expect": {"kind": "enter", "state": "1"}}]).status == 0
    assert simulate([{"at": 0, "expect": {"kind": "enter", "state": "2"}}]).status == 1
    assert simulate("nonsense").status == 2


def test_a_project_with_errors_is_2(simulate: Simulate) -> None:
    for rbd in (WRONG, "<application", "<nonsense/>"):
        run = simulate([], rbd=rbd)
        assert (run.status, run.raw) == (2, b"")
        assert "Traceback" not in run.told


def test_files_that_are_not_there_are_2(
    tmp_path: Path, simulate: Simulate, capsysbinary: pytest.CaptureFixture[bytes]
) -> None:
    simulate([])
    app, script, none = (str(tmp_path / name) for name in ("app.rbd.xml", "s.jsonl", "none"))
    for line in (
        ["simulate", none, "--script", script],
        ["simulate", app, "--script", none],
        ["simulate", app, "--script", script, "--trace", f"{none}/t.jsonl"],
        ["simulate", app],
        ["simulate", app, "--script", script, "--auto-finish", "0"],
        ["simulate", app, "--script", script, "--auto-finish", "soon"],
        ["simulate", app, "--script", script, "--seed", "x"],
    ):
        assert cli.main(line) == 2, line
        assert len(capsysbinary.readouterr().err.splitlines()) == 1


# -- what may be given -------------------------------------------------------


def test_a_script_alone_or_a_whole_folder_may_be_given(
    tmp_path: Path, capsysbinary: pytest.CaptureFixture[bytes]
) -> None:
    (tmp_path / "s.spds.xml").write_text(
        """<spds name="s"><observe><data tag="x"/></observe><modules>
        <module name="app" resources="speech"/></modules><situation name="a"><condition>
        <data tag="x" is="1"/></condition></situation><situation name="b">
        <module name="app" priority="1"/></situation></spds>"""
    )
    (tmp_path / "a.rbd.xml").write_text(SPEAKING)
    (tmp_path / "situ.toml").write_text(
        """[project]\nname = "p"\napplications = ["a.rbd.xml"]\nspds = "s.spds.xml"
        [tags]\n"x" = 1\n"""
    )
    (tmp_path / "s.jsonl").write_text('{"at": 1, "set": {"x": 2}}\n')
    script = ["--script", str(tmp_path / "s.jsonl")]

    def kinds(path: Path) -> list[str]:
        assert cli.main(["simulate", str(path), *script]) == 0
        return [json.loads(line)["kind"] for line in capsysbinary.readouterr().out.splitlines()]

    assert kinds(tmp_path / "s.spds.xml") == ["situation", "data"]
    assert kinds(tmp_path)[:5] == ["data", "condition", "situation", "enter", "acquire"]
    assert kinds(tmp_path / "situ.toml") == kinds(tmp_path)


# -- the trace ---------------------------------------------------------------


def test_the_trace_goes_to_standard_output_as_json_lines(simulate: Simulate) -> None:
    run = simulate([{"at": 1, "event": "go"}])
    assert [e["seq"] for e in run.trace] == list(range(1, len(run.trace) + 1))
    assert run.raw.count(b"\n") == len(run.trace)


def test_or_to_a_file(tmp_path: Path, simulate: Simulate) -> None:
    run = simulate([{"at": 1, "event": "go"}], "--trace", str(tmp_path / "t.jsonl"))
    assert run.raw == b""
    assert (tmp_path / "t.jsonl").read_bytes() == simulate([{"at": 1, "event": "go"}]).raw


def test_the_trace_is_written_also_when_an_expectation_fails(
    tmp_path: Path, simulate: Simulate
) -> None:
    lines = [{"at": 1, "expect": {"kind": "lost"}}, {"at": 2, "event": "go"}]
    run = simulate(lines, "--trace", str(tmp_path / "t.jsonl"))
    assert run.status == 1
    written = [json.loads(line) for line in (tmp_path / "t.jsonl").read_text().splitlines()]
    assert written[-2]["kind"] == "event"
    assert simulate(lines).trace == written


# -- determinism -------------------------------------------------------------


def test_the_same_input_gives_the_same_bytes(simulate: Simulate) -> None:
    lines: list[dict[str, Any]] = [
        {"at": 1, "event": "go"},
        {"at": 2, "set": {"x": {"b": 1, "a": [1.5, None]}}},
    ]
    assert simulate(lines, rbd=SPEAKING).raw == simulate(lines, rbd=SPEAKING).raw


def test_the_seed_decides_what_is_random(simulate: Simulate) -> None:
    runs = {seed: simulate([], "--seed", str(seed), rbd=FILL).raw for seed in range(8)}
    assert len(set(runs.values())) > 1
    assert simulate([], "--seed", "3", rbd=FILL).raw == runs[3]
    assert simulate([], rbd=FILL).raw == runs[0]


# -- automatic finishes ------------------------------------------------------


def test_actions_do_not_end_by_themselves(simulate: Simulate) -> None:
    assert simulate([{"at": 1000, "end": True}], rbd=SPEAKING).of("finished") == []


def test_with_auto_finish_every_action_ends_well_so_long_after_it_began(
    simulate: Simulate,
) -> None:
    run = simulate([{"at": 9, "end": True}], "--auto-finish", "1.5", rbd=SPEAKING)
    assert [(e["t"], e["action"], e["ok"], e["result"]) for e in run.of("finished")] == [
        (1.5, "speech", True, None), (1.5, "service", True, None), (3, "speech", True, None),
    ]  # fmt: skip


def test_what_was_cancelled_or_finished_does_not_end_again(simulate: Simulate) -> None:
    lines: list[dict[str, Any]] = [
        {"at": 0.5, "finish": {"action": "service"}},
        {"at": 1, "event": "go"},
        {"at": 9, "end": True},
    ]
    run = simulate(lines, "--auto-finish", "2", rbd=SPEAKING)
    assert [(e["t"], e["action"]) for e in run.of("finished")] == [
        (0.5, "service"), (3, "speech"), (3, "service"), (5, "speech"),
    ]  # fmt: skip
