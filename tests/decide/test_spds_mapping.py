"""formats.md, *SPDS*: commands, and what moves the robot."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from situ.decide.effects import Map
from situ.decide.inputs import Acquire, Command, Start
from situ.decide.robot import Robot

if TYPE_CHECKING:
    from tests.decide.conftest import Build, Play

SPDS = """<modules><module name="a" resources="head base"/><module name="b" resources="head base"/>
  </modules><situation name="s"><module name="a" priority="1"/><module name="b" priority="2"/>
  </situation>"""
END: dict[str, Any] = {"at": 100, "end": True}


def acquire(at: float, module: str, *resources: str) -> dict[str, Any]:
    return {"at": at, "acquire": {"module": module, "resources": list(resources) or ["head"]}}


def abandon(at: float, module: str, resource: str = "head") -> dict[str, Any]:
    return {"at": at, "abandon": {"module": module, "resources": [resource]}}


def command(
    at: float, module: str, value: Any, valid: float | None = None, resource: str = "head"
) -> dict[str, Any]:
    made = {"module": module, "resource": resource, "value": value}
    if valid is not None:
        made["for"] = valid
    return {"at": at, "command": made}


# -- what stands where -------------------------------------------------------


def test_a_command_of_nothing_stands_nowhere(build: Build) -> None:
    robot = Robot(build((), SPDS))
    robot.step(Start(), 0)
    robot.step(Acquire("a", ("head",)), 1)
    assert robot.step(Command("a", "head", None), 2) == ([], [])
    assert robot.board.look("module/a/head") is None


def test_what_a_module_commands_stands_under_its_name(build: Build) -> None:
    robot = Robot(build((), SPDS))
    robot.step(Start(), 0)
    robot.step(Command("a", "head", {"pitch": 1}), 1)
    entry = robot.board.get("module/a/head")
    assert entry is not None
    assert (entry.value, entry.writer) == ({"pitch": 1}, "a")
    assert robot.board.get("robot/head") is None


def test_the_holders_command_moves_the_robot(play: Play) -> None:
    lines = [acquire(1, "a"), command(2, "a", {"pitch": 1}), command(3, "a", {"pitch": 2})]
    assert play((), lines, spds=SPDS).lines(since=2) == [
        '2 mapping head a {"pitch":1} <-',
        '3 mapping head a {"pitch":2} <-',
    ]


def test_nobody_elses_command_moves_the_robot(play: Play) -> None:
    lines = [acquire(1, "a"), command(2, "b", 1), command(3, "b", 2, 9)]
    assert play((), lines, spds=SPDS).lines(since=2) == []


def test_a_mapping_is_traced_when_the_value_changes(play: Play) -> None:
    lines = [acquire(1, "a"), command(2, "a", 1), command(3, "a", 1.0), command(4, "a", True)]
    assert play((), lines, spds=SPDS).lines("mapping") == [
        "2 mapping head a 1 <-",
        "4 mapping head a true <-",
    ]


def test_each_resource_has_its_own_command(play: Play) -> None:
    lines = [acquire(1, "a", "head", "base"), command(2, "a", 1), command(3, "a", 2, None, "base")]
    lines.append(abandon(4, "a", "base"))
    assert play((), lines, spds=SPDS).lines("mapping") == [
        "2 mapping head a 1 <-",
        "3 mapping base a 2 <-",
        "4 mapping base - null <authority",
    ]


# -- commands without for ----------------------------------------------------


def test_without_for_a_command_is_valid_until_the_holder_loses_the_resource(play: Play) -> None:
    lines = [acquire(1, "a"), command(2, "a", 1), acquire(50, "b"), abandon(60, "b"), END]
    assert play((), lines, spds=SPDS).lines("mapping", "authority", since=2) == [
        "2 mapping head a 1 <-",
        "50 authority head a b <acquire",
        "50 mapping head b null <authority",
        # a is the holder again, but has to command again.
        "60 authority head b a <abandon",
    ]


def test_without_for_one_made_before_holding_never_counts(play: Play) -> None:
    lines = [command(1, "a", 1), acquire(2, "a"), command(3, "a", 1)]
    assert play((), lines, spds=SPDS).lines("mapping") == ["3 mapping head a 1 <-"]


def test_when_it_loses_the_resource_its_command_stands_no_longer(build: Build) -> None:
    robot = Robot(build((), SPDS))
    robot.step(Start(), 0)
    robot.step(Acquire("a", ("head",)), 1)
    robot.step(Command("a", "head", 1), 2)
    robot.step(Acquire("b", ("head",)), 3)
    assert robot.board.get("module/a/head") is None
    assert robot.board.get("robot/head") is None


# -- commands with for -------------------------------------------------------


def test_with_for_a_command_is_valid_so_long_from_when_it_was_made(play: Play) -> None:
    lines = [acquire(1, "a"), command(2, "a", 1, 0.5), END]
    assert play((), lines, spds=SPDS).lines("mapping") == [
        "2 mapping head a 1 <-",
        "2.5 mapping head a null <mapping",
    ]


def test_a_stream_of_commands_goes_on(play: Play) -> None:
    lines = [acquire(1, "a"), *(command(2 + i / 4, "a", i, 0.5) for i in range(4)), END]
    assert [(e["t"], e["value"]) for e in play((), lines, spds=SPDS).of("mapping")] == [
        (2, 0), (2.25, 1), (2.5, 2), (2.75, 3), (3.25, None),
    ]  # fmt: skip


def test_the_same_command_again_lasts_longer(play: Play) -> None:
    lines = [acquire(1, "a"), command(2, "a", 1, 0.5), command(2.3, "a", 1, 0.5), END]
    assert play((), lines, spds=SPDS).lines("mapping") == [
        "2 mapping head a 1 <-",
        "2.8 mapping head a null <mapping",
    ]


def test_a_stream_with_for_is_taken_over_without_delay(play: Play) -> None:
    """Made while another held the resource, it moves the robot at the hand-over."""
    lines = [
        acquire(1, "b"),
        acquire(1, "a"),
        command(2, "b", "b", 9),
        command(2, "a", "a", 5),
        abandon(4, "b"),
        END,
    ]
    assert play((), lines, spds=SPDS).lines("mapping", "authority", since=2) == [
        '2 mapping head b "b" <-',
        "4 authority head b a <abandon",
        '4 mapping head a "a" <authority',
        "7 mapping head a null <mapping",
    ]


def test_with_for_it_outlasts_the_loss_of_the_resource(play: Play) -> None:
    lines = [acquire(1, "a"), command(2, "a", 1, 10), acquire(3, "b"), abandon(5, "b"), END]
    assert play((), lines, spds=SPDS).lines("mapping") == [
        "2 mapping head a 1 <-",
        "3 mapping head b null <authority",
        "5 mapping head a 1 <authority",
        # What made the command.
        "12 mapping head a null <mapping^2",
    ]


def test_a_stale_one_is_not_taken_over(play: Play) -> None:
    lines = [acquire(1, "b"), acquire(1, "a"), command(2, "a", 1, 2), abandon(4, "b"), END]
    assert play((), lines, spds=SPDS).lines("mapping") == []


def test_a_command_without_for_replaces_one_with_for(play: Play) -> None:
    lines = [acquire(1, "a"), command(2, "a", 1, 1), command(2.5, "a", 2), END]
    assert play((), lines, spds=SPDS).lines("mapping") == [
        "2 mapping head a 1 <-",
        "2.5 mapping head a 2 <-",
    ]


# -- what ends both ----------------------------------------------------------


def test_abandoning_ends_both(play: Play) -> None:
    for valid in (None, 20):
        lines = [acquire(1, "a"), command(2, "a", 1, valid), abandon(3, "a"), acquire(4, "a"), END]
        assert play((), lines, spds=SPDS).lines("mapping", "authority", since=2) == [
            "2 mapping head a 1 <-",
            "3 authority head a - <abandon",
            "3 mapping head - null <authority",
            "4 authority head - a <acquire",
        ]


def test_abandoning_ends_a_command_for_what_was_not_asked_for(play: Play) -> None:
    lines = [command(1, "a", 1, 20), abandon(2, "a"), acquire(3, "a")]
    assert play((), lines, spds=SPDS).lines("mapping") == []


def test_being_lost_ends_both(play: Play) -> None:
    for valid in (None, 20):
        lines = [
            acquire(1, "a"),
            command(2, "a", 1, valid),
            {"at": 3, "lost": {"module": "a"}},
            acquire(4, "a"),
        ]
        assert play((), lines, spds=SPDS).lines("mapping", "authority", since=2) == [
            "2 mapping head a 1 <-",
            "3 authority head a - <lost",
            "3 mapping head - null <authority",
            "4 authority head - a <acquire",
        ]


def test_adapters_are_told_to_stop_and_hold(build: Build) -> None:
    robot = Robot(build((), SPDS))
    robot.step(Start(), 0)
    robot.step(Acquire("a", ("head",)), 1)
    _, effects = robot.step(Command("a", "head", 1, 2), 2)
    assert [e for e in effects if isinstance(e, Map)] == [Map("head", "a", 1)]
    _, effects = robot.step(None, 2_000_002)
    assert [e for e in effects if isinstance(e, Map)] == [Map("head", "a", None)]


# -- hand-over ---------------------------------------------------------------


def test_a_hand_over_happens_in_the_step_of_its_cause(play: Play) -> None:
    lines = [
        acquire(1, "a"),
        command(1, "a", 1),
        acquire(2, "b"),
        {"at": 3, "lost": {"module": "b"}},
    ]
    assert play((), lines, spds=SPDS).lines(since=2) == [
        "2 acquire b [head] <-",
        "2 authority head a b <acquire",
        "2 mapping head b null <authority",
        "3 lost b [head] <-",
        "3 authority head b a <lost",
    ]


# -- an application's commands -----------------------------------------------


def test_what_an_application_commands(play: Play) -> None:
    rbd = """<state no="1">
      <screen><components><text id="t" x="1" y="1" width="1" height="1">T</text></components>
      </screen>
      <backgroundactions><robot resource="head" command="nod"><param name="times">2</param></robot>
      <speech lang="en">Hi</speech><sound src="a.ogg"/></backgroundactions></state>"""
    lines = [
        {"at": 1, "finish": {"action": "robot", "name": "nod"}},
        {"at": 2, "finish": {"action": "speech"}},
        {"at": 3, "finish": {"action": "sound", "ok": False}},
    ]
    trace = play(rbd, lines)
    assert trace.lines("mapping") == [
        "0 mapping screen app [t=T] <screen",
        '0 mapping head app {"command":"nod","params":{"times":2}} <action',
        '0 mapping speech app {"text":"Hi","lang":"en"} <action',
        "1 mapping head app null <finished",
        "2 mapping speech app null <finished",
        '2 mapping speech app {"src":"a.ogg"} <action',
        "3 mapping speech app null <finished",
    ]
    assert trace.of("mapping")[0]["value"] == {
        "components": trace.one("screen")["components"],
        "background": None,
    }


def test_a_command_ends_when_its_state_is_left(play: Play) -> None:
    rbd = """<state no="1"><backgroundactions><robot resource="head" command="nod"/>
      </backgroundactions><expectedevents><event name="go" next="2"/></expectedevents></state>
      <state no="2"><backgroundactions><robot resource="head" command="shake"/>
      </backgroundactions></state>"""
    assert play(rbd, [{"at": 1, "event": "go"}]).lines(since=1) == [
        "1 event app go <-",
        "1 exit app 1 <event",
        "1 cancelled app robot nod <exit",
        "1 mapping head app null <cancelled",
        "1 transition app 1 2 go <event",
        "1 enter app 2 <transition",
        '1 action app 2 robot shake resource="head" <enter',
        '1 mapping head app {"command":"shake","params":{}} <action',
    ]
