"""architecture, idea 2: what a driver is asked to carry out, and how it answers."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from situ.decide.effects import AnyEffect, Begin, Cancel, Changed, Map
from situ.decide.inputs import (
    Acquire,
    Attend,
    Command,
    Finish,
    Raise,
    Set,
    Start,
    Touch,
)
from situ.decide.robot import Robot
from situ.decide.trace import Warned

if TYPE_CHECKING:
    from tests.decide.conftest import Build

AT = 'x="1" y="1" width="9" height="9"'
RBD = f"""<state no="1"><screen><components><movie id="m" {AT} src="m.webm" done="seen"/>
  </components></screen><backgroundactions><speech>A</speech><sound src="b.ogg"/>
  <service name="s" method="POST" url="http://x/"><param name="n">1</param></service>
  <launch program="p" keep="true"/><message topic="t">2</message><set tag="x">1</set>
  </backgroundactions><expectedevents><event name="go" next="2"/></expectedevents></state>
  <state no="2"/>"""


def started(build: Build, rbd: str = RBD) -> tuple[Robot, list[AnyEffect]]:
    robot = Robot(build(rbd))
    _, effects = robot.step(Start(), 0)
    return robot, effects


def begun(effects: list[AnyEffect], action: str) -> int:
    (found,) = [e.id for e in effects if isinstance(e, Begin) and e.action == action]
    return found


def test_what_uses_no_resource_is_begun_with_its_fields(build: Build) -> None:
    _, effects = started(build)
    fields = {e.action: (e.name, e.fields) for e in effects if isinstance(e, Begin)}
    assert fields == {
        "service": ("s", {"method": "POST", "url": "http://x/", "params": {"n": 1}}),
        "launch": ("p", {"program": "p", "params": {}}),
        "message": (None, {"topic": "t", "value": 2}),
    }


def test_what_uses_a_resource_is_mapped_with_the_actions_to_be_answered(build: Build) -> None:
    robot, effects = started(build)
    mapped = {e.resource: e for e in effects if isinstance(e, Map)}
    assert mapped["speech"].value == {"text": "A", "lang": None}
    assert mapped["screen"].value["components"][0]["id"] == "m"
    (speech,), (movie,) = mapped["speech"].actions, mapped["screen"].actions
    events, effects = robot.step(Finish(id=speech), 1)
    assert type(events[0]).__name__ == "Finished"
    assert [e.value for e in effects if isinstance(e, Map)] == [None, {"src": "b.ogg"}]
    events, _ = robot.step(Finish(id=movie), 2)
    assert [type(event).__name__ for event in events] == ["Finished", "Event", "Ignored"]


def test_what_could_not_be_carried_out_is_warned_of_but_not_what_a_scenario_fails(
    build: Build,
) -> None:
    robot, effects = started(build)
    events, _ = robot.step(Finish(id=begun(effects, "service"), ok=False, error="nobody there"), 1)
    (finished,) = [event for event in events if type(event).__name__ == "Finished"]
    warnings = [event for event in events if isinstance(event, Warned)]
    assert [(one.message, one.where, one.cause) for one in warnings] == [
        ("service s failed: nobody there", "app", finished.seq)
    ]
    events, _ = robot.step(Finish(action="launch", ok=False, error="was meant"), 2)
    assert [event for event in events if isinstance(event, Warned)] == []


def test_an_answer_that_comes_late_is_passed_over(build: Build) -> None:
    robot, effects = started(build)
    service = begun(effects, "service")
    robot.step(Raise("go"), 1)
    assert robot.step(Finish(id=service), 2) == ([], [])


def test_what_is_cancelled_is_stopped_but_for_what_is_kept(build: Build) -> None:
    robot, effects = started(build)
    _, after = robot.step(Raise("go"), 1)
    assert [e.id for e in after if isinstance(e, Cancel)] == [begun(effects, "service")]
    assert [e.value for e in after if isinstance(e, Map) and e.resource == "speech"] == [None]


def test_every_change_of_the_blackboard_is_told(build: Build) -> None:
    robot, effects = started(build)
    told = {e.tag: e for e in effects if isinstance(e, Changed)}
    assert {"x", "listen", "application/app", "module/app/speech", "robot/speech"} <= told.keys()
    assert (told["x"].value, told["x"].version, told["x"].writer) == (1, 1, "app")
    _, effects = robot.step(Set({"x": None, "gone": None}, "m"), 7)
    assert effects == [Changed("x", None, 2, "m", 7)]


def test_equal_commands_of_two_actions_are_both_carried_out(build: Build) -> None:
    """The value does not change, but the second has to be answered too."""
    rbd = """<state no="1"><backgroundactions><robot resource="head" command="nod"/>
      </backgroundactions><expectedevents><event name="go"/></expectedevents></state>"""
    twice = rbd.replace('<robot resource="head" command="nod"/>', '<robot resource="head" '
                        'command="nod"/><robot resource="head" command="nod"/>')  # fmt: skip
    _, effects = started(build, twice)
    ids = [e.actions for e in effects if isinstance(e, Map)]
    assert len(ids) == 2
    assert ids[0] != ids[1]


def test_an_event_for_an_application_that_is_not_there_is_refused(build: Build) -> None:
    robot, _ = started(build)
    events, effects = robot.step(Raise("go", "nobody"), 1)
    assert [type(event).__name__ for event in events] == ["Failed"]
    assert [type(effect).__name__ for effect in effects] == ["Refuse"]


@pytest.mark.parametrize("typing", [True, False])
def test_typing_counts_an_idle_timeout_anew(build: Build, typing: bool) -> None:
    rbd = f"""<state no="1"><timeout next="2" idle="true">3</timeout><screen><components>
      <input id="i" {AT} tag="x" kind="text"/></components></screen></state><state no="2"/>"""
    robot, _ = started(build, rbd)
    if typing:
        assert robot.step(Attend(), 2_000_000) == ([], [])
    assert robot.due() == (5_000_000 if typing else 3_000_000)


@pytest.mark.parametrize("given", [Attend(), Touch()])
def test_what_a_person_does_where_no_screen_is_shown_means_nothing(
    build: Build, given: Attend | Touch
) -> None:
    rbd = '<state no="1"><timeout next="2" idle="true">3</timeout></state><state no="2"/>'
    robot, _ = started(build, rbd)
    assert robot.step(given, 2_000_000) == ([], [])
    assert robot.due() == 3_000_000


def test_the_seq_of_a_robot_is_that_of_its_last_event(build: Build) -> None:
    robot = Robot(build(RBD))
    assert robot.seq == 0
    events, _ = robot.step(Start(), 0)
    assert robot.seq == events[-1].seq


# -- what a driver has to take up after a restore ----------------------------


def outstanding(robot: Robot) -> tuple[dict[str, Map], list[Begin]]:
    effects = robot.outstanding()
    maps = [effect for effect in effects if isinstance(effect, Map)]
    begins = [effect for effect in effects if isinstance(effect, Begin)]
    assert effects == [*maps, *begins]
    return {effect.resource: effect for effect in maps}, begins


def test_what_is_outstanding_is_what_was_asked_for_and_has_not_ended(build: Build) -> None:
    robot, effects = started(build)
    maps, begins = outstanding(robot)
    last = {effect.resource: effect for effect in effects if isinstance(effect, Map)}
    assert maps == last
    assert begins == [e for e in effects if isinstance(e, Begin) and e.action != "message"]


def test_a_restored_robot_judges_situations_from_what_stood_there(build: Build) -> None:
    """Of thresholds only those between the value before and the value now are looked at."""
    spds = """<situation name="hot"><condition><data tag="x" above="30"/></condition></situation>
      <situation name="warm"><condition><data tag="x" above="20"/></condition></situation>
      <situation name="cold"/>"""
    robot, other = Robot(build((), spds)), Robot(build((), spds))
    robot.step(Start(), 0)
    robot.step(Set({"x": 25}, "m"), 1)
    other.restore(robot.snapshot())
    assert other.step(Set({"x": 15}, "m"), 2) == robot.step(Set({"x": 15}, "m"), 2)
    assert other.board.look("situation.name") == "cold"


def test_what_was_filled_in_when_a_service_began_stays(build: Build) -> None:
    rbd = """<state no="1"><backgroundactions><service name="s" method="POST" url="http://{x}/">
      </service></backgroundactions></state>"""
    robot = Robot(build(rbd, tags={"x": "a"}))
    robot.step(Start(), 0)
    robot.step(Set({"x": "b"}, "m"), 1)
    (begin,) = outstanding(robot)[1]
    assert begin.fields["url"] == "http://a/"


def test_what_has_ended_is_not_outstanding(build: Build) -> None:
    """A movie that has ended keeps its place on the screen, with 0 for its id."""
    robot, effects = started(build)
    maps, _ = outstanding(robot)
    robot.step(Finish(id=maps["screen"].actions[0]), 1)
    robot.step(Finish(id=begun(effects, "service")), 2)
    maps, begins = outstanding(robot)
    assert maps["screen"].actions == (0,)
    assert [begin.action for begin in begins] == ["launch"]
    robot.step(Raise("go"), 3)
    maps, begins = outstanding(robot)
    assert (maps["speech"].value, maps["speech"].actions) == (None, ())
    assert [begin.action for begin in begins] == ["launch"]


def test_a_modules_equal_command_does_not_carry_out_an_action(build: Build) -> None:
    """The module has taken over with the very value that the application's action had."""
    rbd = """<state no="1"><backgroundactions><robot resource="head" command="nod"/>
      </backgroundactions></state>"""
    spds = """<modules><module name="m" resources="head"/><module name="app" resources="head"/>
      </modules><situation name="busy"><condition><data tag="busy" is="true"/></condition>
      <module name="m" priority="1"/></situation><situation name="rest">
      <module name="app" priority="1"/></situation>"""
    robot = Robot(build(rbd, spds))
    _, effects = robot.step(Start(), 0)
    (nod,) = [effect for effect in effects if isinstance(effect, Map) and effect.actions]
    robot.step(Acquire("m", ("head",)), 1)
    robot.step(Command("m", "head", nod.value, 10), 2)
    _, effects = robot.step(Set({"busy": True}, "m"), 3)
    assert [effect for effect in effects if isinstance(effect, Map)] == []
    assert outstanding(robot)[0] == {"head": Map("head", "m", nod.value)}
