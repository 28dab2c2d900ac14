"""What an application expects now, as an operator is told it."""

from __future__ import annotations

from typing import Any

from situ.decide.expected import ExpectedEvent
from situ.decide.inputs import Pause, Raise, Set, Start
from situ.decide.robot import Robot

FLOW = """
<always><expectedevents><event name="stop" next="1"/></expectedevents></always>
<state no="1" name="waiting">
  <expectedevents>
    <event name="yes" next="2"><say>Yes</say><say>Gladly, {user.name}</say>
      <when><data tag="user.name" exists="true"/></when></event>
    <event name="yes" next="2"><say>Yes</say><when><data tag="ready" is="true"/></when></event>
    <event next="2"><when><data tag="gone" is="true"/></when></event>
  </expectedevents>
</state>
<state no="2"><expectedevents><event name="return" next="#back"/></expectedevents></state>"""


def begun(build: Any) -> Robot:
    robot = Robot(build(FLOW))
    robot.step(Start(), 0)
    return robot


def events(robot: Robot) -> dict[str, ExpectedEvent]:
    told = robot.expected()["app"]
    return {one.name: one for one in told.events}


def test_the_state_and_its_named_events_are_told_its_own_before_those_of_always(
    build: Any,
) -> None:
    robot = begun(build)
    told = robot.expected()["app"]
    assert (told.state, told.name) == ("1", "waiting")
    assert (told.time, told.suspended, told.paused) == (0, False, False)
    assert [one.name for one in told.events] == ["yes", "stop"]
    robot.step(Raise("stop"), 7)
    robot.step(Set({"gone": True}, "ann"), 9)
    told = robot.expected()["app"]
    assert (told.state, told.name, told.time) == ("2", "", 9)


def test_an_event_holds_where_one_of_its_guards_does(build: Any) -> None:
    robot = begun(build)
    yes = events(robot)["yes"]
    assert not yes.holds
    assert yes.when == ("user.name exists", "ready is true")
    for tags, holds in (({"ready": True}, True), ({"ready": False}, False)):
        robot.step(Set(tags, "ann"), 1)
        assert events(robot)["yes"].holds is holds
    assert events(robot)["stop"].holds
    assert events(robot)["stop"].when == ()


def test_what_people_may_say_is_told_once_with_its_references_filled_in(build: Any) -> None:
    robot = begun(build)
    robot.step(Set({"user.name": "Ann"}, "ann"), 1)
    assert events(robot)["yes"].says == ("Yes", "Gladly, Ann")


def test_to_go_back_holds_only_where_there_is_a_state_to_go_back_to(build: Any) -> None:
    robot = Robot(build('<state no="1"><expectedevents><event name="return" next="#back"/>'
                        "</expectedevents></state>"))  # fmt: skip
    robot.step(Start(), 0)
    assert not events(robot)["return"].holds
    robot = begun(build)
    robot.step(Set({"gone": True}, "ann"), 1)
    assert events(robot)["return"].holds


def test_to_ask_changes_nothing(build: Any) -> None:
    robot = begun(build)
    before = robot.snapshot()
    robot.expected()
    assert robot.snapshot() == before


def test_who_is_paused_by_the_debugger_is_told_so(build: Any) -> None:
    robot = begun(build)
    robot.step(Pause("operator:ann"), 1)
    assert robot.expected()["app"].paused


def test_what_the_state_says_is_told_filled_in_and_translated(build: Any) -> None:
    state = (
        '<state no="1"><backgroundactions><speech>Hello {user.name}</speech><set tag="x">1</set>'
        '<speech lang="ja">Hello {user.name}</speech><speech>Hello {user.name}</speech>'
        "</backgroundactions></state>"
    )
    robot = Robot(build(state, texts={"ja": {"Hello {user.name}": "{user.name}さん"}}))
    robot.step(Start(), 0)
    robot.step(Set({"user.name": "Ann"}, "ann"), 1)
    assert robot.expected()["app"].speeches == ("Hello Ann", "Annさん")
