"""``situ test``: every scenario as a test, failures told with their causes (issue 3, point 4)."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as Tree

import pytest

from situ.cli import main
from situ.document import folder
from situ.rehearse.suite import play_file

RBD = """<application name="door"><state no="1" name="shut"><screen><components>
<button id="open" x="1" y="1" width="9" height="9" event="open">Open</button></components></screen>
<expectedevents><event name="open" next="2"><when><data tag="key" is="true"/></when></event>
</expectedevents></state>
<state no="2" name="open"><backgroundactions><speech done="said">Come in</speech>
</backgroundactions><expectedevents><event name="said" next="1"/></expectedevents></state>
</application>"""
TOML = """[project]
name = "house"
applications = ["door.rbd.xml"]
scenarios = "scenarios"
"""
OPENS: list[dict[str, Any]] = [
    {"at": 1, "set": {"key": True}},
    {"at": 2, "use": {"component": "open"}},
    {"at": 2, "expect": {"kind": "enter", "state": "2"}},
    {"at": 3, "expect": {"kind": "action", "action": "speech", "text": "Come in"}},
    {"at": 5, "end": True},
]
LOCKED: list[dict[str, Any]] = [
    {"at": 1, "set": {"key": False}},
    {"at": 2, "use": {"component": "open"}},
    {"at": 2, "expect": {"kind": "enter", "state": "2"}},
]


class House:
    """A project in a folder, and the command as a person types it."""

    def __init__(self, root: Path, capsys: pytest.CaptureFixture[str]) -> None:
        self.root = root
        self._capsys = capsys
        (root / "scenarios").mkdir()
        (root / "situ.toml").write_text(TOML, encoding="utf-8")
        (root / "door.rbd.xml").write_text(RBD, encoding="utf-8")

    def write(self, name: str, lines: list[dict[str, Any]] | str) -> str:
        text = lines if isinstance(lines, str) else "".join(json.dumps(x) + "\n" for x in lines)
        path = self.root / "scenarios" / name
        path.write_text(text, encoding="utf-8")
        return str(path)

    def test(self, *args: str) -> tuple[int, list[str], str]:
        status = main(["test", str(self.root), *args])
        out, err = self._capsys.readouterr()
        return status, out.splitlines(), err


@pytest.fixture
def house(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> House:
    return House(tmp_path, capsys)


def test_a_line_a_scenario_and_what_was_covered(house: House) -> None:
    house.write("b.jsonl", OPENS)
    house.write("a.jsonl", LOCKED[:2])
    status, out, err = house.test()
    assert (status, err) == (0, "")
    assert out == [
        "ok    scenarios/a.jsonl  0 expectations, 2 s",
        "ok    scenarios/b.jsonl  2 expectations, 5 s",
        "",
        "states       2 of 2 (100 %)",
        "transitions  1 of 2 (50 %)",
        "  not door, 2 open – said → 1 shut",
        "conditions   1 of 1 (100 %)",
    ]


def test_a_failure_tells_what_was_expected_what_came_its_causes_and_what_was_in_the_way(
    house: House,
) -> None:
    house.write("a.jsonl", LOCKED)
    status, out, _ = house.test()
    assert status == 1
    assert out[: out.index("")] == [
        "FAIL  scenarios/a.jsonl  1 of 1 expectation failed",
        "      line 3, at 2 s",
        '        expected  {"kind":"enter","state":"2"}',
        "        came      0 s  #1  door enters 1 shut",
        '                  state was "1", not "2"',
        "        causes",
        "          0 s  #1  door enters 1 shut  (the start)",
        "        in the way",
        (
            "          - open came at 2 s, but its guard did not hold: "
            "key is true: it was false, set at 1 s by scenario  (#7)"
        ),
    ]


def test_where_it_came_by_another_event_nothing_was_in_the_way(house: House) -> None:
    wanted = {"kind": "transition", "from": "1", "to": "2", "event": "opened"}
    house.write("a.jsonl", [*OPENS[:2], {"at": 2, "expect": wanted}])
    status, out, _ = house.test()
    assert status == 1
    assert any('event was "open", not "opened"' in line for line in out)
    assert not any("in the way" in line for line in out)


def test_the_chain_of_causes_goes_back_to_the_outside_input(house: House) -> None:
    expected = {"kind": "action", "action": "speech", "text": "Go away"}
    house.write("a.jsonl", [*OPENS[:2], {"at": 2, "expect": expected}])
    _, out, _ = house.test()
    causes = out[out.index("        causes") + 1 :][:4]
    assert [line.split("  ")[-1] for line in causes[1:]] == [
        "door goes from 1 shut to 2 open by open",
        "door enters 2 open",
        "door begins speech “Come in”",
    ]
    assert causes[0].endswith("event open comes to door  (from outside)")


def test_an_expectation_of_which_nothing_came(house: House) -> None:
    house.write("a.jsonl", [{"at": 1, "expect": {"kind": "lost", "module": "m"}}])
    status, out, _ = house.test()
    assert status == 1
    assert "        came      no event of kind lost after the last" in out


def test_auto_finish_and_seed_are_given_on_the_command_line(house: House) -> None:
    house.write("a.jsonl", [*OPENS[:4], {"at": 4, "expect": {"kind": "enter", "state": "1"}}])
    assert house.test()[0] == 1
    status, out, _ = house.test("--auto-finish", "1", "--seed", "3")
    assert (status, out[0]) == (0, "ok    scenarios/a.jsonl  3 expectations, 4 s")
    assert house.test("--auto-finish", "0")[0] == 2


def test_a_scenario_that_can_not_be_read_is_2_and_the_others_are_played(house: House) -> None:
    house.write("a.jsonl", "nonsense\n")
    house.write("b.jsonl", OPENS)
    status, out, _ = house.test()
    assert status == 2
    assert out[0].startswith("ERROR ")
    assert out[0].count("scenarios/a.jsonl:1: ") == 1
    assert out[1].startswith("ok    scenarios/b.jsonl")


def test_single_scenarios(house: House) -> None:
    house.write("a.jsonl", LOCKED)
    status, out, _ = house.test(house.write("b.jsonl", OPENS))
    assert status == 0
    assert out[0].startswith("ok    scenarios/b.jsonl")
    assert "a.jsonl" not in out[1]


@pytest.mark.parametrize("text", [None, 'scenarios = "none"\n', 'scenarios = "scenarios"\n'])
def test_no_scenario_at_all_is_2_in_one_line(house: House, text: str | None) -> None:
    toml = TOML.replace('scenarios = "scenarios"\n', text or "")
    (house.root / "situ.toml").write_text(toml, encoding="utf-8")
    status, out, err = house.test()
    assert (status, out, err.count("\n")) == (2, [], 1)
    assert "scenarios" in err


def test_a_project_with_errors_is_2_in_one_line(house: House) -> None:
    (house.root / "door.rbd.xml").write_text(RBD.replace('next="2"', 'next="9"'))
    house.write("a.jsonl", OPENS)
    status, out, err = house.test()
    assert (status, out, err.count("\n")) == (2, [], 1)


def test_junit(house: House) -> None:
    house.write("a.jsonl", LOCKED)
    house.write("b.jsonl", OPENS)
    house.write("c.jsonl", '{"at":1,"set":{"x":"\x01"}}\n')
    target = house.root / "result.xml"
    assert house.test("--junit", str(target))[0] == 2
    root = Tree.parse(target).getroot()
    suite = root.find("testsuite")
    assert suite is not None
    told = {key: suite.get(key) for key in ("name", "tests", "failures", "errors", "time")}
    assert told == {"name": "house", "tests": "3", "failures": "1", "errors": "1", "time": "7"}
    failed, well, unreadable = suite
    assert failed.get("name") == "scenarios/a.jsonl"
    failure = failed.find("failure")
    assert failure is not None
    assert failure.get("message") == "1 of 1 expectations failed: line 3, at 2 s"
    assert failure.text is not None
    assert "its guard did not hold: key is true: it was false" in failure.text
    assert (well.get("assertions"), list(well)) == ("2", [])
    assert unreadable.find("error") is not None


def test_coverage_and_the_result_as_json(house: House) -> None:
    house.write("a.jsonl", LOCKED)
    target = house.root / "coverage.json"
    status, out, _ = house.test("--json", "--coverage", str(target))
    assert status == 1
    told = json.loads("\n".join(out))
    assert (told["project"], told["ok"]) == ("house", False)
    (played,) = told["scenarios"]
    assert (played["file"], played["ok"], played["expectations"]) == ("scenarios/a.jsonl", False, 1)
    (failed,) = played["failed"]
    assert (failed["line"], failed["at"]) == (3, 2.0)
    assert failed["differences"] == [{"field": "state", "expected": "2", "came": "1"}]
    assert failed["reasons"][0]["values"] == {"key": False}
    assert json.loads(target.read_text()) == told["coverage"]


def test_a_place_that_can_not_be_written_is_2(house: House) -> None:
    house.write("a.jsonl", OPENS)
    status, _, err = house.test("--junit", str(house.root / "none" / "x.xml"))
    assert (status, err.count("\n")) == (2, 1)


def test_a_scenario_elsewhere_and_an_expectation_that_leaves_open_what_it_means(
    house: House, tmp_path_factory: pytest.TempPathFactory
) -> None:
    path = tmp_path_factory.mktemp("elsewhere") / "x.jsonl"
    path.write_text('{"at":1,"expect":{"kind":"enter","application":"none"}}\n')
    status, out, _ = house.test(str(path))
    assert status == 1
    assert out[0] == f"FAIL  {path}  1 of 1 expectation failed"
    assert not any("in the way" in line for line in out)


def test_what_is_not_saved_yet_is_played_in_place_of_what_the_file_holds(house: House) -> None:
    path = Path(house.write("a.jsonl", LOCKED))
    project, _ = folder.load(house.root)
    assert project is not None
    unsaved = b'{"at": 1, "event": "open", "application": "door"}\n'
    _, played = play_file(project, path, ["door"], unsaved=unsaved)
    assert (played.file, played.expectations, played.well) == ("scenarios/a.jsonl", 0, True)
    _, played = play_file(project, path, ["door"], unsaved=b"no scenario\n")
    assert played.unreadable is not None
    assert played.unreadable.startswith(f"{path}:1:")
    assert play_file(project, path, ["door"])[1].expectations == 1
