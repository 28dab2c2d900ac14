"""The devices of examples/vitals before a robot in memory."""

from __future__ import annotations

import runpy
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import situ.testing

VITALS = Path(__file__).resolve().parents[2] / "examples" / "vitals"

ASKING = """<application name="ask">
  <state no="1">
    <expectedevents>
      <event name="ask" next="2"/>
    </expectedevents>
  </state>
  <state no="2">
    <backgroundactions>
      <service name="measure" url="board:{module}/{request}" done="ended" failed="ended">
        <param name="arm">{arm}</param>
      </service>
    </backgroundactions>
    <expectedevents>
      <event name="ended" next="1"/>
      <event name="leave" next="1"/>
    </expectedevents>
  </state>
</application>
"""

Ask = Callable[..., situ.testing.Robot]


def program(name: str) -> dict[str, Any]:
    return runpy.run_path(str(VITALS / "modules" / f"{name}.py"))


@pytest.fixture
def ask(tmp_path: Path) -> Ask:
    """A robot in memory that has just asked a module, with this device, to measure."""

    def begin(
        module: str, device: Any, arm: str = "left", request: str = "measure"
    ) -> situ.testing.Robot:
        file = tmp_path / "ask.rbd.xml"
        file.write_text(ASKING.format(module=module, arm=arm, request=request), "utf-8")
        robot = situ.testing.robot(file)
        name = module.replace("-", "_")
        robot.start(program(name)[name], robot.connect(module=module), device)
        robot.publish("ask")
        return robot

    return begin


def results(robot: situ.testing.Robot) -> list[Any]:
    every = robot.events(kind="finished", name="measure")
    return [one["result"] if one["ok"] else one["error"] for one in every]


def test_a_cuff_measures_in_the_time_of_a_service_and_by_its_seed(ask: Ask) -> None:
    made = program("cuff")["SimulatedCuff"]
    found = []
    for seed in (7, 7, 8):
        with ask("cuff", made(seed)) as robot:
            robot.pass_time(29.0)
            found += results(robot)
    first, again, other = found
    assert first == again != other
    assert 40 < first["diastolic"] < first["systolic"] < 300


def test_the_cuff_tells_how_far_it_is_and_lets_the_air_out_at_the_end(ask: Ask) -> None:
    with ask("cuff", program("cuff")["SimulatedCuff"]()) as robot:
        robot.pass_time(3.0)
        assert robot.value("cuff.pressure") == pytest.approx(90, abs=15)
        before = robot.value("cuff.progress")
        robot.pass_time(10.0)
        assert 0 < before < robot.value("cuff.progress") < 100
        robot.until(lambda: bool(results(robot)), within=15.0)
        assert (robot.value("cuff.pressure"), robot.value("cuff.progress")) == (0, 0)


def test_the_cuff_lets_the_air_out_as_soon_as_nobody_waits(ask: Ask) -> None:
    with ask("cuff", program("cuff")["SimulatedCuff"]()) as robot:
        robot.pass_time(6.0)
        assert robot.value("cuff.pressure") > 100
        robot.publish("leave")
        robot.pass_time(1.0)
        assert robot.value("cuff.pressure") == 0
        robot.publish("ask")
        robot.pass_time(25.0)
        assert len(results(robot)) == 1


def test_a_loose_cuff_finds_no_pulse_and_the_next_try_may(ask: Ask) -> None:
    with ask("cuff", program("cuff")["SimulatedCuff"](loose=(1,))) as robot:
        robot.pass_time(25.0)
        robot.publish("ask")
        robot.pass_time(25.0)
        first, second = results(robot)
        assert first == "cuff: no pulse was found: the cuff sits loosely"
        assert set(second) == {"systolic", "diastolic", "pulse"}


def test_a_cuff_knows_two_arms(ask: Ask) -> None:
    with ask("cuff", program("cuff")["SimulatedCuff"](), arm="third") as robot:
        assert results(robot) == ["cuff: there is no arm 'third': left or right"]


def test_an_oximeter_believes_readings_that_agree(ask: Ask) -> None:
    with ask("oximeter", program("oximeter")["SimulatedOximeter"](3)) as robot:
        robot.pass_time(1.0)
        assert robot.value("oximeter.finger") is False
        robot.until(lambda: bool(results(robot)), within=15.0)
        (found,) = results(robot)
        assert robot.value("oximeter.finger") is True
        # At first it sees too little: what it says is what it saw in the end.
        assert 89 <= found["oxygen"] <= 99
        assert 50 < found["pulse"] < 100


def test_without_a_finger_the_oximeter_says_so(ask: Ask) -> None:
    with ask("oximeter", program("oximeter")["SimulatedOximeter"](nobody=True)) as robot:
        robot.pass_time(25.0)
        assert results(robot) == ["oximeter: no finger was found in the clip"]


@pytest.mark.parametrize(("what", "longest"), [("strip", 7.0), ("blood", 9.0), ("read", 6.0)])
def test_a_glucose_meter_answers_each_step_when_it_is_done(
    ask: Ask, what: str, longest: float
) -> None:
    meter = program("glucose_meter")["SimulatedMeter"](5)
    with ask("glucose-meter", meter, request=what) as robot:
        robot.pass_time(2.0)
        assert results(robot) == []
        robot.pass_time(longest - 2.0)
        (found,) = results(robot)
        assert list(found) == (["glucose"] if what == "read" else [])


def test_a_used_strip_is_refused_and_a_new_one_is_taken(ask: Ask) -> None:
    meter = program("glucose_meter")["SimulatedMeter"](used=(1,))
    with ask("glucose-meter", meter, request="strip") as robot:
        robot.pass_time(10.0)
        robot.publish("ask")
        robot.pass_time(10.0)
        refused = "glucose-meter: this strip was used before: a new one is needed"
        assert results(robot) == [refused, {}]


def test_without_a_strip_the_meter_gives_up_in_the_time_of_a_service(ask: Ask) -> None:
    meter = program("glucose_meter")["SimulatedMeter"](nobody=True)
    with ask("glucose-meter", meter, request="strip") as robot:
        robot.pass_time(29.5)
        assert results(robot) == ["glucose-meter: nobody gave it what it waits for: strip"]


def test_who_leaves_before_blood_is_on_the_strip_is_not_waited_for(ask: Ask) -> None:
    meter = program("glucose_meter")["SimulatedMeter"](5)
    with ask("glucose-meter", meter, request="blood") as robot:
        robot.pass_time(1.0)
        robot.publish("leave")
        robot.publish("ask")
        robot.pass_time(12.0)
        assert results(robot) == [{}]
