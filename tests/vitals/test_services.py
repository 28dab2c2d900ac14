"""examples/vitals in memory: its scenarios go everywhere, and what must hold in each of them."""

from __future__ import annotations

import runpy
from collections.abc import Iterator

import pytest
from tests.vitals.person import LIMITS, VITALS, Person

import situ.testing
from situ.decide.inputs import Finish
from situ.decide.masking import Mask
from situ.document.ready import load_ready
from situ.rehearse.suite import run_suite, scenarios


def test_the_scenarios_go_through_every_state_transition_situation_and_condition() -> None:
    project = load_ready(VITALS)
    suite = run_suite(project, scenarios(project))
    assert [one.file for one in suite.played if not one.well] == []
    every = [seen for group in suite.coverage.groups().values() for seen in group]
    assert [seen.label for seen in every if not seen.covered] == []


@pytest.fixture
def person() -> Iterator[Person]:
    cuff = runpy.run_path(str(VITALS / "modules" / "cuff.py"))
    with situ.testing.robot(VITALS) as robot:
        device = cuff["SimulatedCuff"](seed=7)
        robot.start(cuff["cuff"], robot.connect(module="cuff"), device)
        yield Person(robot)


def test_what_the_cuff_measured_is_shown_and_written_down(person: Person) -> None:
    person.log_in(LIMITS | {"systolic_high": 300, "diastolic_high": 200, "diastolic_low": 20})
    person.use("pressure", "start")
    person.robot.pass_time(25.0)
    assert person.at == "10/3"
    (asked,) = person.robot.events(kind="action", name="keepReading")
    names = ("systolic", "diastolic", "pulse")
    measured = {name: str(person.robot.value(f"bp.{name}")) for name in names}
    assert asked["params"]["reading"] == {"kind": "pressure", "user": "3", **measured}


def test_outside_of_the_persons_own_limits_the_nurse_is_called_after_the_second_time(
    person: Person,
) -> None:
    person.log_in(LIMITS | {"systolic_high": 101, "systolic_low": 41})
    person.use("pressure", "start")
    person.robot.pass_time(25.0)
    assert person.at == "10/4"
    assert person.robot.events(kind="action", action="message") == []
    person.use("now")
    person.robot.pass_time(25.0)
    assert person.at == "10/5"
    (call,) = person.robot.events(kind="action", action="message", topic="nurse/call")
    assert call["value"] == {"why": "blood pressure", "room": "12"}


def test_the_red_button_takes_everything_away_but_a_call_goes_out(person: Person) -> None:
    person.robot.set({"fall-heard": {"room": 7}})
    assert person.robot.command("base") == {"command": "goto", "params": {"place": "room-7"}}
    person.robot.set("robot.stop", True)
    holders = {one: person.robot.holder(one) for one in ("base", "screen", "speech")}
    assert set(holders.values()) == {None}
    assert person.robot.command("base") is None
    person.robot.set("fall-heard", {"room": 21})
    person.robot.pass_time(2.0)
    calls = person.robot.events(kind="action", action="message", topic="nurse/call")
    assert [call["value"]["room"] for call in calls] == ["7", "21"]
    person.robot.set("robot.stop", False)
    assert person.robot.command("base") == {"command": "goto", "params": {"place": "room-7"}}


def test_a_measurement_goes_on_after_a_fall(person: Person) -> None:
    person.log_in()
    person.use("pressure", "start")
    person.robot.pass_time(5.0)
    person.robot.set("fall-heard", {"room": 7})
    assert (person.robot.situation, person.robot.holder("screen")) == ("fallen", "falls")
    person.robot.pass_time(25.0)
    assert person.at == "10/2"
    person.robot.publish("fallCleared")
    person.robot.give(Finish(action="robot", name="goto"))
    assert (person.robot.situation, person.robot.holder("screen")) == ("day", "home")
    assert person.at in ("10/3", "10/4")


def test_who_has_gone_leaves_nothing_behind(person: Person) -> None:
    person.log_in()
    person.use("pressure", "start")
    person.robot.pass_time(25.0)
    person.use("home")
    assert person.at == "1"
    for tag in ("user", "login.pin", "login.room", "bp.systolic", "home.busy"):
        assert person.robot.value(tag) is None


def test_a_private_value_stands_in_no_trace_that_others_see(person: Person) -> None:
    person.log_in()
    mask = Mask(person.robot.project.private)
    shown = str([mask.step([event]) for event in person.robot.trace])
    assert "•••" in shown
    assert "Nilsen" not in shown
    assert "1234" not in shown
