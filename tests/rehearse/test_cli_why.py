"""``situ why`` as a person types it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from tests.rehearse.asked import DOOR

from situ.cli import main


@pytest.fixture
def files(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> dict[str, str]:
    names = {n: str(tmp_path / n) for n in ("door.rbd.xml", "s.jsonl", "trace.jsonl")}
    Path(names["door.rbd.xml"]).write_text(DOOR, encoding="utf-8")
    Path(names["s.jsonl"]).write_text('{"at":1,"event":"home"}\n{"at":2,"set":{"distance":1}}\n')
    status = main(
        ["simulate", names["door.rbd.xml"], "--script", names["s.jsonl"], "--trace",
         names["trace.jsonl"]]
    )  # fmt: skip
    assert status == 0
    capsys.readouterr()
    return {
        "project": names["door.rbd.xml"],
        "script": names["s.jsonl"],
        "trace": names["trace.jsonl"],
    }


def test_the_chain_is_printed(files: dict[str, str], capsys: pytest.CaptureFixture[str]) -> None:
    last = len(Path(files["trace"]).read_text().splitlines())
    for args in (
        [files["trace"], str(last), "--project", files["project"]],
        [str(last), "--project", files["project"], "--script", files["script"]],
    ):
        assert main(["why", *args]) == 0
        out = capsys.readouterr().out.splitlines()
        assert out[0].endswith("scenario sets distance to 1  (from outside)")
        assert out[-1] == f"2 s  #{last}  door enters 4 inside"
    assert main(["why", files["trace"], str(last), "--json"]) == 0
    assert [event["kind"] for event in json.loads(capsys.readouterr().out)] == [
        "data", "transition", "enter",
    ]  # fmt: skip


def test_what_stood_in_the_way_is_printed(
    files: dict[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    asked = ["--project", files["project"], "--not", '{"kind":"enter","state":"4"}', "--at"]
    for source in ([files["trace"]], ["--script", files["script"]]):
        assert main(["why", *source, *asked, "1.5"]) == 0
        assert capsys.readouterr().out.splitlines()[:2] == [
            "Not at 1.5 s:",
            "- the guard of its unnamed event did not hold: distance below 1.5: it was never set",
        ]
    assert main(["why", files["trace"], *asked, "2"]) == 0
    assert capsys.readouterr().out.startswith("It did happen: 2 s  #")
    assert main(["why", files["trace"], *asked, "3"]) == 0
    assert capsys.readouterr().out.splitlines()[1:] == [
        "By 3 s it had happened:",
        "- door was in 4 inside already, since 2 s  (#13)",
    ]
    assert main(["why", files["trace"], *asked, "1.5", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["reasons"][0]["code"], told["ends"]) == ("guard", None)


def test_a_moment_after_the_end_of_what_is_recorded_is_told_in_one_line(
    files: dict[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    asked = ["--project", files["project"], "--not", '{"kind":"enter","state":"2"}', "--at"]
    with Path(files["script"]).open("a") as script:
        script.write('{"at":5,"end":true}\n')
    # A trace alone is known until its last event.
    for source, end in ([files["trace"]], 2), (["--script", files["script"]], 5):
        said = f"What is recorded ends at {end} s: the rest is so if nothing happened since."
        assert main(["why", *source, *asked, str(end)]) == 0
        assert said not in capsys.readouterr().out
        assert main(["why", *source, *asked, str(end + 0.1)]) == 0
        assert capsys.readouterr().out.splitlines()[:2] == [said, f"Not at {end + 0.1:g} s:"]
        assert main(["why", *source, *asked, "99", "--json"]) == 0
        assert json.loads(capsys.readouterr().out)["ends"] == end


@pytest.mark.parametrize(
    "args",
    [
        [],
        ["{trace}"],
        ["{trace}", "x"],
        ["{trace}", "0"],
        ["{trace}", "1", "--not", "{{}}"],
        ["{trace}", "--not", '{{"kind":"enter"}}'],
        ["{trace}", "--not", "[]", "--at", "1", "--project", "{project}"],
        ["{trace}", "--not", "nonsense", "--at", "1", "--project", "{project}"],
        ["{script}", "1"],
        ["/none", "1"],
        ["{project}", "1"],
        ["1", "--script", "{script}"],
        ["--not", '{{"kind":"enter","state":"1"}}', "--at", "1", "--project", "{project}"],
        ["{trace}", "1", "--project", "/none"],
    ],
)
def test_wrong_usage_is_one_line_and_status_2(
    files: dict[str, str], capsys: pytest.CaptureFixture[str], args: list[str]
) -> None:
    assert main(["why", *(arg.format(**files) for arg in args)]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.count("\n") == 1
