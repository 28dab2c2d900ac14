"""formats.md, *Blackboard*: entries, patterns, what the runtime keeps."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

from situ.decide.board import Board
from situ.decide.effects import Changed
from situ.decide.inputs import Raise, Set, Start, Use
from situ.decide.robot import Robot
from situ.decide.trace import Data, Enter
from situ.document.names import matches

if TYPE_CHECKING:
    from tests.decide.conftest import Build, Play

SPEAKING = (
    '<state no="1" name="hall"><backgroundactions><speech>A</speech></backgroundactions></state>'
)


def test_an_entry_has_value_version_writer_and_time(build: Build) -> None:
    robot = Robot(build((), '<situation name="s"/>'))
    robot.step(Start(), 0)
    robot.step(Set({"x": 1}, "m"), 5)
    robot.step(Set({"x": 2}, "n"), 7)
    entry = robot.board.get("x")
    assert entry is not None
    assert (entry.value, entry.version, entry.writer, entry.time) == (2, 2, "n", 7)


def test_the_version_counts_up_over_a_deletion(build: Build) -> None:
    robot = Robot(build((), '<situation name="s"/>'))
    robot.step(Start(), 0)
    versions = []
    for value in (1, None, 2):
        _, effects = robot.step(Set({"x": value}, "m"), 1)
        versions += [e.version for e in effects if isinstance(e, Changed) and e.tag == "x"]
    assert versions == [1, 2, 3]
    assert robot.board.get("y") is None


@pytest.mark.parametrize(
    ("pattern", "fits", "fits_not"),
    [
        ("a", "a", "a.b ab"),
        ("*", "a b", "a.b"),
        ("a.*", "a.b a.c", "a a.b.c b.a"),
        ("*.b", "a.b c.b", "b a.b.c"),
        ("a.*.c", "a.b.c", "a.c a.b.b.c"),
        ("**", "a a.b.c robot/head", ""),
        ("a.**", "a a.b a.b.c", "ab b.a"),
        ("**.c", "c a.c a.b.c", "c.a"),
        ("a.**.c", "a.c a.b.c a.b.b.c", "a.b ac"),
        ("robot/*", "robot/head", "robot robot/head/x"),
        ("module/*/head", "module/nod/head", "module/head module/nod/base"),
    ],
)
def test_a_star_is_one_word_and_two_are_any_number(pattern: str, fits: str, fits_not: str) -> None:
    assert [tag for tag in fits.split() if not matches(pattern, tag)] == []
    assert [tag for tag in fits_not.split() if matches(pattern, tag)] == []


def test_entries_are_found_by_pattern_in_order_of_tag() -> None:
    board = Board()
    for tag in ("b.y", "a", "b.x", "b"):
        board.write(tag, 1, "m", 0, None)
    board.write("b.y", None, "m", 0, None)
    assert [tag for tag, _ in board.entries("b.**")] == ["b", "b.x"]


# -- what the runtime keeps --------------------------------------------------


def test_the_runtime_keeps_the_application_and_its_state(build: Build) -> None:
    rbd = SPEAKING.replace(
        "</state>", '<expectedevents><event name="go" next="2"/></expectedevents></state>'
    )
    robot = Robot(build(rbd + '<state no="2"/>'))
    robot.step(Start(), 0)
    kept = {"state": "1", "name": "hall", "suspended": False}
    assert robot.board.look("application/app") == kept
    robot.step(Raise("go"), 1)
    assert robot.board.look("application/app") == {"state": "2", "name": "", "suspended": False}


def test_the_runtime_keeps_the_situation_and_its_priorities(build: Build) -> None:
    spds = """<modules><module name="m" resources=""/></modules><situation name="a"><condition>
      <data tag="x" is="1"/></condition></situation><situation name="b">
      <module name="m" priority="3"/></situation>"""
    robot = Robot(build((), spds))
    robot.step(Start(), 0)
    assert robot.board.look("situation") == {"name": "b", "priorities": {"m": 3}}
    robot.step(Set({"x": 1}, "m"), 1)
    assert robot.board.look("situation") == {"name": "a", "priorities": {}}


def test_what_the_runtime_keeps_is_not_traced_as_data(play: Play) -> None:
    rbd = SPEAKING.replace(
        "</state>", '<expectedevents><event name="a"><say>a</say></event></expectedevents></state>'
    )
    lines: list[dict[str, Any]] = [
        {"at": 1, "finish": {"action": "speech"}},
        {"at": 2, "set": {"clock.time": "08:00"}},
    ]
    trace = play(rbd, lines, pauses="speech")
    assert trace.of("data") == []


def test_what_happened_to_a_service_is_traced_as_data(play: Play) -> None:
    rbd = """<state no="1"><backgroundactions><service name="s" url="http://x/"/>
      </backgroundactions></state>"""
    trace = play(rbd, [{"at": 1, "finish": {"action": "service"}}])
    assert [e["tag"] for e in trace.of("data")] == ["service/s"]


def test_the_clock_is_absent_in_the_simulator_unless_set(play: Play) -> None:
    rbd = """<state no="1"><expectedevents><event next="2"><when>
      <data tag="clock.time" atleast="08:00"/></when></event></expectedevents></state>
      <state no="2"/>"""
    trace = play(rbd, [{"at": 90, "set": {"clock.time": "07:59"}}, {"at": 99, "set": {
        "clock.time": "08:00"}}])  # fmt: skip
    assert trace.states() == [(0, "1"), (99, "2")]


# -- who may write what ------------------------------------------------------


@pytest.mark.parametrize(
    "tag", ["robot/head", "module/other/head", "application/app", "situation", "listen"]
)
def test_what_the_runtime_keeps_can_not_be_set(play: Play, tag: str) -> None:
    trace = play(SPEAKING, [{"at": 1, "set": {"fine": 1, tag: 1}}])
    assert [e["kind"] for e in trace if e["t"] == 1] == ["error"]


def test_a_module_may_write_below_its_own_name(build: Build) -> None:
    robot = Robot(build((), '<situation name="s"/>'))
    robot.step(Start(), 0)
    robot.step(Set({"module/m/mood": "fine"}, "m"), 1)
    assert robot.board.look("module/m/mood") == "fine"


@pytest.mark.parametrize("tag", ["situation", "listen"])
def test_no_action_and_no_component_may_set_it_either(build: Build, tag: str) -> None:
    rbd = f"""<state no="1"><screen><components><button id="b" x="1" y="1" width="1" height="1"
      tag="{tag}" value="1">B</button></components></screen><backgroundactions>
      <set tag="{tag}">1</set></backgroundactions></state>"""
    robot = Robot(build(rbd))
    events, _ = robot.step(Start(), 0)
    assert [e for e in events if type(e).__name__ == "Failed"]
    events, _ = robot.step(Use("b"), 1)
    assert [type(e).__name__ for e in events] == ["Failed"]
    assert robot.board.look(tag) != 1


def test_what_was_restored_goes_before_the_tags_of_the_project(build: Build) -> None:
    project = build((), '<situation name="s"/>', tags={"pill": "08:00", "lamp": "off"})
    robot = Robot(project)
    events, effects = robot.step(Start(restored={"pill": ("09:30", 4, "operator:ann")}), 0)
    told = [(e.tag, e.value, e.writer, e.version) for e in events if isinstance(e, Data)]
    assert told == [("lamp", "off", "project", 1), ("pill", "09:30", "operator:ann", 4)]
    assert [e.version for e in effects if isinstance(e, Changed) and e.tag == "pill"] == [4]
    entry = robot.board.get("pill")
    assert entry is not None
    assert (entry.value, entry.version, entry.writer) == ("09:30", 4, "operator:ann")


def test_what_was_restored_counts_on_and_is_judged_from_the_start(build: Build) -> None:
    waits = '<event next="2"><when><data tag="n" is="7"/></when></event>'
    rbd = f'<state no="1"><expectedevents>{waits}</expectedevents></state><state no="2"/>'
    robot = Robot(build(rbd))
    events, _ = robot.step(Start(restored={"n": (7, 3, "m")}), 0)
    assert [e.state for e in events if isinstance(e, Enter)] == ["1", "2"]
    _, effects = robot.step(Set({"n": 8}, "m"), 1)
    assert [e.version for e in effects if isinstance(e, Changed) and e.tag == "n"] == [4]


def test_what_was_deleted_before_stays_deleted_and_keeps_its_version(build: Build) -> None:
    robot = Robot(build((), '<situation name="s"/>', tags={"pill": "08:00"}))
    events, _ = robot.step(Start(restored={"pill": (None, 5, "operator:ann")}), 0)
    assert not [e for e in events if isinstance(e, Data)]
    assert robot.board.get("pill") is None
    _, effects = robot.step(Set({"pill": "10:00"}, "m"), 1)
    assert [e.version for e in effects if isinstance(e, Changed)] == [6]
