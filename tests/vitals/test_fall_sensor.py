"""The fall sensor: what it takes for a fall, and what the robot hears of it over a real broker."""

from __future__ import annotations

import asyncio
import json
import logging
import runpy
from collections.abc import AsyncIterator, Iterator
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace
from tests.engine.test_mqtt import DEADLINE, Broker

from situ.decide.inputs import AnyInput, Set
from situ.document.ready import load_ready
from situ.engine.mqtt import Bridge
from situ.engine.secrets import Secrets

VITALS = Path(__file__).resolve().parents[2] / "examples" / "vitals"
SENSOR: dict[str, Any] = runpy.run_path(str(VITALS / "modules" / "fall_sensor.py"))


def told(seconds: float, **wearer: Any) -> list[float]:
    """When the sensor is certain of a fall."""
    worn, detector, rate = SENSOR["SimulatedWearer"](**wearer), SENSOR["FallDetector"](), 25
    times = [count / rate for count in range(int(seconds * rate))]
    return [at for at in times if detector.feed(at, worn.acceleration(at))]


@pytest.mark.parametrize("seed", range(5))
def test_a_fall_is_told_once_soon_after_it_and_walking_never_is(seed: int) -> None:
    (at,) = told(60, seed=seed, falls=[20])
    assert 22 < at < 24
    assert told(60, seed=seed) == []


def test_who_sits_down_hard_has_not_fallen() -> None:
    assert told(60, stumbles=[10, 30]) == []


def test_two_falls_are_told_twice() -> None:
    assert len(told(90, falls=[10, 60])) == 2


def test_who_is_light_and_hit_but_walks_on_has_not_fallen() -> None:
    detector = SENSOR["FallDetector"]()
    pushed = [0.2] * 10 + [3.0] + [1.4, 0.6] * 50
    assert not any(detector.feed(count / 25, one) for count, one in enumerate(pushed))


# -- over the broker ---------------------------------------------------------------


@pytest.fixture
def broker(mosquitto: str, tmp_path: Path) -> Iterator[Broker]:
    made = Broker(mosquitto, tmp_path, "allow_anonymous true")
    yield made
    made.stop()


async def walked(*falls: float) -> AsyncIterator[tuple[float, float]]:
    """A minute of it, at once."""
    worn = SENSOR["SimulatedWearer"](falls=falls)
    for count in range(60 * 25):
        yield count / 25, worn.acceleration(count / 25)


class Robot:
    """What a robot of the project hears from the broker."""

    def __init__(self, port: int, folder: Path) -> None:
        self.heard: list[AnyInput] = []
        self._more = asyncio.Event()
        mqtt = load_ready(VITALS).mqtt
        assert mqtt is not None
        here = replace(mqtt, url=f"mqtt://127.0.0.1:{port}")
        loop, log = asyncio.get_running_loop(), logging.Logger("robot")
        self.bridge = Bridge(here, self._submit, Secrets(folder), loop, log)

    def _submit(self, given: AnyInput) -> None:
        self.heard.append(given)
        self._more.set()

    async def until(self, count: int) -> None:
        while len(self.heard) < count:
            self._more.clear()
            await self._more.wait()


def test_a_robot_that_was_away_hears_of_a_fall_until_it_has_said_that_it_knows(
    broker: Broker, tmp_path: Path
) -> None:
    async def run() -> list[AnyInput]:
        async with asyncio.timeout(DEADLINE), broker.client() as worn, broker.client() as other:
            await other.subscribe("ward/7/fall")
            sensor = asyncio.ensure_future(SENSOR["fall_sensor"](worn, 7, walked(20)))
            message = await anext(aiter(other.messages))
            assert json.loads(message.payload) == {"room": 7}
            # Only now the robot is there: it hears of it, says so, and it is taken back.
            robot = Robot(broker.port, tmp_path)
            robot.bridge.start()
            await robot.until(1)
            robot.bridge.send("ward/7/fall/seen", "seen")
            await sensor
            await robot.until(2)
            await robot.bridge.close()
            # Who comes later hears only of what is new.
            await other.publish("ward/12/fall", '{"room": 12}', qos=1, retain=True)
            later = Robot(broker.port, tmp_path)
            later.bridge.start()
            await later.until(1)
            await later.bridge.close()
            return [*robot.heard, *later.heard]

    assert asyncio.run(run()) == [
        Set({"fall-heard": {"room": 7}}, "mqtt"),
        Set({"fall-heard": None}, "mqtt"),
        Set({"fall-heard": {"room": 12}}, "mqtt"),
    ]
