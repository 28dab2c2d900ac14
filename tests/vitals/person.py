"""Jack of room 12, before a robot of examples/vitals in memory."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import situ.testing
from situ.decide.inputs import Finish, Touch, Use

VITALS = Path(__file__).resolve().parents[2] / "examples" / "vitals"
LIMITS = {"systolic_low": 100, "systolic_high": 150, "diastolic_low": 55, "diastolic_high": 95}
JACK = {"id": 3, "name": "Jack Nilsen", "room": 12}


class Person:
    """Uses what is on the screen; what the records answer is said here too."""

    def __init__(self, robot: situ.testing.Robot) -> None:
        self.robot = robot

    def use(self, *components: str) -> None:
        for component in components:
            self.robot.give(Use(component))

    def answer(self, service: str, result: Any) -> None:
        self.robot.give(Finish(name=service, result=result))

    def log_in(self, limits: dict[str, int] = LIMITS) -> None:
        self.robot.give(Touch())
        self.robot.give(Use("room", 12))
        self.robot.give(Use("pin", "1234"))
        self.answer("login", {"user": {**JACK, "limits": limits}, "messages": []})
        self.use("continue")

    @property
    def at(self) -> str:
        return str(self.robot.value("application/home.state"))
