"""``situ report``: what people used, how long, and where they gave up (formats.md, *Command line*;
Table I of seed 001)."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.rehearse.recorded_robot import LAB, ROOT, Recorded, recorder, ring

from situ import cli
from situ.decide import inputs
from situ.decide.step import SECOND
from situ.rehearse import usage as counts
from situ.rehearse.usage import Crossed, Lasted, Row, Usage, count, counting

RECEPTION = ROOT / "examples" / "reception"
BUTTON = {"type": "button", "id": "go"}
TEXT = {"type": "text", "id": "hello"}


class Trace:
    """A trace made by hand, of one application."""

    def __init__(self, first: int = 1) -> None:
        self.events: list[dict[str, Any]] = []
        self.first = first

    def add(self, t: float, kind: str, **fields: Any) -> Trace:
        seq = self.first + len(self.events)
        self.events.append({"kind": kind, "seq": seq, "t": t, "cause": None, **fields})
        return self

    def place(self, t: float, value: Any, tag: str = "pose.place") -> Trace:
        return self.add(t, "data", tag=tag, value=value, writer="nav", version=1)

    def enter(self, t: float, state: str, *components: dict[str, Any]) -> Trace:
        self.add(t, "enter", application="desk", state=state)
        return self.add(t, "screen", application="desk", state=state, components=list(components))

    def go(
        self, t: float, source: str, to: str, *components: dict[str, Any], timeout: bool = False
    ) -> Trace:
        """From one state to another."""
        self.add(t, "exit", application="desk", state=source)
        how = {"event": None, "timeout": True} if timeout else {"event": "e"}
        self.add(t, "transition", application="desk", **{"from": source}, to=to, **how)
        return self.enter(t, to, *components)

    def file(self, path: Path) -> str:
        path.write_text("".join(json.dumps(event) + "\n" for event in self.events) + "\n")
        return str(path)


Report = Callable[..., dict[tuple[str, str], dict[str, Any]]]


@pytest.fixture
def report(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Report:
    """The rows of a report, by place and state."""

    def run(*traces: Trace | Path, options: tuple[str, ...] = ()) -> Any:
        files = [
            str(one) if isinstance(one, Path) else one.file(tmp_path / f"{n}.jsonl")
            for n, one in enumerate(traces)
        ]
        capsys.readouterr()
        assert cli.main(["report", *files, "--json", *options]) == 0
        rows = json.loads(capsys.readouterr().out)
        return {(row["place"], row["state"]): row for row in rows}

    return run


def test_times_visits_and_time_are_counted(report: Report) -> None:
    trace = (
        Trace().enter(0, "1").go(10, "1", "2").go(12, "2", "3").go(17, "3", "2").go(18, "2", "1")
    )
    trace.go(20, "1", "2").go(23, "2", "1").add(30, "warning", message="", where="")
    rows = report(trace)
    two, three = rows["", "2"], rows["", "3"]
    assert (two["times"], two["visits"], two["percent"]) == (3, 2, 100.0)
    assert (two["seconds"], two["mean"]) == (6.0, 2.0)
    assert (three["times"], three["visits"], three["percent"], three["seconds"]) == (1, 1, 50.0, 5)
    # The start state is between two visits; what is not over ends with the trace.
    one = rows["", "1"]
    assert (one["times"], one["visits"], one["percent"], one["seconds"]) == (3, 0, 0.0, 19.0)


def test_it_is_counted_by_place(report: Report) -> None:
    trace = Trace().place(0, "lobby").enter(0, "1").go(1, "1", "2").go(3, "2", "1")
    trace.place(4, "room 7").go(5, "1", "2").go(9, "2", "3").place(9, None).go(10, "3", "1")
    trace.place(11, {"x": 1}).go(12, "1", "2").go(14, "2", "1", timeout=True)
    rows = report(trace)
    assert {key: rows[key]["seconds"] for key in rows if key[1] == "2"} == {
        ("lobby", "2"): 2.0,
        ("room 7", "2"): 4.0,
        ('{"x": 1}', "2"): 2.0,
    }
    assert rows["lobby", "2"]["percent"] == rows["room 7", "3"]["percent"] == 100.0
    assert ("", "1") in rows
    assert rows['{"x": 1}', "2"]["timeouts"] == 1


def test_another_tag_may_say_the_place(report: Report) -> None:
    trace = Trace().place(0, "ward 3", "where.am.i").enter(0, "1")
    assert list(report(trace, options=("--place", "where.am.i"))) == [("ward 3", "1")]


def test_who_lets_the_time_run_out_before_a_button_gave_up(report: Report) -> None:
    trace = Trace().enter(0, "1", BUTTON).go(5, "1", "1", BUTTON, timeout=True)
    trace.go(6, "1", "2", TEXT).go(7, "2", "3", TEXT, BUTTON, timeout=True)
    trace.go(9, "3", "1", BUTTON, timeout=True)
    rows = report(trace)
    said = {state: (row["timeouts"], row["gave_up"]) for (_, state), row in rows.items()}
    # Nobody is there in the start state, and 2 offers nothing.
    assert said == {"1": (1, 0), "2": (1, 0), "3": (1, 1)}


def test_what_was_suspended_is_not_use(report: Report) -> None:
    trace = Trace().enter(0, "1").go(1, "1", "2")
    trace.add(3, "suspend", application="desk", missing=["screen"])
    trace.add(4, "suspend", application="desk", missing=["screen", "speech"])
    trace.add(10, "resume", application="desk", missing=[]).go(11, "2", "3")
    trace.add(12, "suspend", application="desk", missing=["screen"]).go(15, "3", "1")
    rows = report(trace)
    assert (rows["", "2"]["seconds"], rows["", "3"]["seconds"]) == (3.0, 1.0)


def test_a_part_is_a_service_and_so_are_its_states(report: Report) -> None:
    trace = Trace().enter(0, "1").go(1, "1", "2").enter(1, "2/1").go(3, "2/1", "2/2")
    trace.add(7, "exit", application="desk", state="2/2").go(7, "2", "1")
    rows = report(trace)
    said = {state: (row["kind"], row["seconds"]) for (_, state), row in rows.items()}
    assert said["2"] == ("part", 6.0)
    assert said["2/1"] == ("state", 2.0)
    assert said["2/2"] == ("state", 4.0)


def test_several_traces_are_added_up(report: Report) -> None:
    one = Trace().enter(0, "1").go(1, "1", "2").go(3, "2", "1")
    rows = report(one, Trace().enter(0, "1").go(1, "1", "2").go(9, "2", "1"))
    assert (rows["", "2"]["times"], rows["", "2"]["visits"], rows["", "2"]["seconds"]) == (2, 2, 10)


def test_what_lies_in_a_gap_is_not_counted(report: Report) -> None:
    before = Trace().enter(0, "1").go(1, "1", "2")
    after = Trace(100).add(50, "exit", application="desk", state="2").enter(50, "3")
    before.events += after.add(52, "error", message="", where="").events
    rows = report(before)
    assert (rows["", "2"]["seconds"], rows["", "3"]["seconds"]) == (0.0, 2.0)
    # Where it starts is not known any longer: what comes is a visit.
    assert rows["", "3"]["visits"] == 1


def test_names_come_from_the_project(report: Report, tmp_path: Path) -> None:
    script = RECEPTION / "scenarios" / "new-user.jsonl"
    trace = tmp_path / "t.jsonl"
    cli.main(["simulate", str(RECEPTION), "--script", str(script), "--trace", str(trace)])
    rows = report(trace, options=("--project", str(RECEPTION)))
    assert rows["", "16"]["name"] == "register"
    assert rows["", "16/1"]["name"] == "first name"
    assert {row["project"] for row in rows.values()} == {"reception"}


def test_recordings_of_one_run_are_counted_once(report: Report, tmp_path: Path) -> None:
    def play(run: Recorded) -> None:
        for n in range(1, 21):
            run.at(n * 60 * SECOND, inputs.Raise("go" if n % 2 else "asked"))
            run.recorder.tend(n * 60 + 1.0)
        run.recorder.close()

    play(Recorded(LAB, recorder(tmp_path / "whole.mcap")))
    play(Recorded(LAB, ring(tmp_path / "ring")))
    files = sorted((tmp_path / "ring").iterdir())
    assert len(files) > 2
    whole = report(tmp_path / "whole.mcap")
    assert whole["", "2"]["times"] == whole["", "2"]["visits"] == 10
    assert report(*files) == whole
    assert report(files[0], *files, tmp_path / "whole.mcap") == whole


def test_csv_has_a_row_for_each(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    trace = Trace().place(0, "lobby, left").enter(0, "1").enter(0, "2").file(tmp_path / "t.jsonl")
    out = tmp_path / "usage.csv"
    assert cli.main(["report", trace, "-o", str(out)]) == 0
    assert cli.main(["report", trace]) == 0
    assert capsys.readouterr().out == out.read_text()
    head, *rows = csv.reader(io.StringIO(out.read_text()))
    assert tuple(head) == Row.__struct_fields__
    assert [row[:4] for row in rows] == [["", "lobby, left", "desk", n] for n in "12"]


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"nonsense\n", ":1: not an event of a trace"),
        (b'{"seq":2,"t":0,"kind":"x"}\n{"seq":1,"t":0,"kind":"x"}\n', ":2: seq 1 after 2"),
        (b'\n{"seq":1,"t":0}\n', ":2: not an event of a trace"),
    ],
)
def test_what_is_no_trace_is_2(
    content: bytes, said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "t").write_bytes(content)
    assert cli.main(["report", str(tmp_path / "t")]) == 2
    assert said in capsys.readouterr().err


def test_files_that_can_not_be_read_or_written_are_2(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    trace = Trace().enter(0, "1").file(tmp_path / "t.jsonl")
    for line in ([str(tmp_path / "none")], [trace, "-o", str(tmp_path / "none" / "x.csv")]):
        assert cli.main(["report", *line]) == 2
        assert len(capsys.readouterr().err.splitlines()) == 1


def test_a_recording_with_something_else_on_its_trace_is_2(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "run.mcap"
    run = Recorded(LAB, recorder(file))
    run.recorder._waiting.append(("/trace", 1.0, b"{}"))
    run.recorder.close()
    assert cli.main(["report", str(file)]) == 2
    assert "not an event of a trace" in capsys.readouterr().err


def test_a_recording_without_events_has_no_rows(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "run.mcap"
    run = Recorded(
        LAB, recorder(file), state=Recorded(LAB, recorder(tmp_path / "x")).robot.snapshot()
    )
    run.recorder.close()
    assert cli.main(["report", str(file), "--json"]) == 0
    assert capsys.readouterr().out == "[]\n"


# -- what the drawings show of it ----------------------------------------------------------


def test_ways_and_situations_are_counted_over_all_runs(tmp_path: Path) -> None:
    usage = Usage()
    for n in range(2):
        trace = Trace().enter(0, "1").go(1, "1", "2").go(4, "2", "1", timeout=True)
        for t, source, to in ((5, None, "calm"), (7, "calm", "busy"), (8, "busy", None)):
            trace.add(t, "situation", **{"from": source}, to=to)
        trace.add(9, "situation", **{"from": None}, to="calm").add(9.5, "lost", module="m")
        count(usage, trace.file(tmp_path / f"{n}.jsonl"))
    usage.rows()
    assert usage.crossed == {
        Crossed("desk", "1", "2", "e", False): 2,
        Crossed("desk", "2", "1", None, True): 2,
    }
    assert usage.situations == {"calm": Lasted(4, 5.0), "busy": Lasted(2, 2.0)}


@pytest.mark.parametrize("kind", ["mcap", "jsonl"])
def test_it_is_told_how_much_of_a_file_is_read(
    kind: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(counts, "STEP", 10)
    trace = Trace()
    for n in range(30):
        trace.go(n, "1", "2")
    file: str | Path = trace.file(tmp_path / "a.jsonl")
    if kind == "mcap":
        file = tmp_path / "a.mcap"
        run = Recorded(LAB, recorder(file))
        for n in range(40):
            run.at(n * SECOND, inputs.Raise("nothing"))
        run.recorder.close()
    told = list(counting(Usage(), file))
    assert len(told) > 2
    assert told == sorted(told)
    assert 0 < told[0] <= told[-1] <= 1
