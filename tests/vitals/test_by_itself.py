"""What the robot of examples/vitals begins by itself, in memory: falls and the nurse who watches,
rounds from the ward's records, quiet hours.
"""

from __future__ import annotations

import runpy
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path

import pytest

import situ.testing
from situ.decide.inputs import Finish, Touch, Use
from ward_records.day import Day
from ward_records.store import Store

VITALS = Path(__file__).resolve().parents[2] / "examples" / "vitals"
EIGHT = {"clock.date": "2026-05-04", "clock.time": "08:00"}
MONITOR = runpy.run_path(str(VITALS / "modules" / "monitor.py"))


class Nurse:
    """The records' side of the camera: what a nurse at her page does."""

    def __init__(self) -> None:
        self.rooms: list[str] = []
        self.pictures: list[bytes] = []
        self.looks = self.says_help_is_there = self.is_away = False

    def show(self, room: str, picture: bytes) -> dict[str, bool]:
        if self.is_away:
            raise ConnectionRefusedError("nobody answers")
        self.rooms.append(room)
        self.pictures.append(picture)
        return {"watched": self.looks, "ended": self.says_help_is_there}


@pytest.fixture
def nurse() -> Nurse:
    return Nurse()


@pytest.fixture
def robot(nurse: Nurse) -> Iterator[situ.testing.Robot]:
    with situ.testing.robot(VITALS) as made:
        camera = MONITOR["SimulatedCamera"](3)
        made.start(MONITOR["monitor"], made.connect(module="monitor"), camera, nurse.show)
        yield made


def state(robot: situ.testing.Robot, application: str) -> str:
    return str(robot.value(f"application/{application}.state"))


def shown(robot: situ.testing.Robot) -> str:
    return str(robot.command("screen"))


def spoken(robot: situ.testing.Robot) -> list[str]:
    return [one["text"] for one in robot.events(kind="action", action="speech")]


def arrive(robot: situ.testing.Robot) -> None:
    robot.give(Finish(action="robot", name="goto"))


def fallen(robot: situ.testing.Robot) -> None:
    robot.set("fall-heard", {"room": 7})
    arrive(robot)


def test_a_nurse_sees_who_has_fallen_and_the_robot_says_that_she_does(
    robot: situ.testing.Robot, nurse: Nurse
) -> None:
    robot.pass_time(5.0)
    assert nurse.pictures == []
    fallen(robot)
    robot.pass_time(2.0)
    assert (state(robot, "falls"), set(nurse.rooms)) == ("3", {"7"})
    nurse.looks = True
    robot.pass_time(2.0)
    assert state(robot, "falls") == "5"
    assert spoken(robot)[-1].startswith("A nurse sees you now.")
    nurse.looks = False
    robot.pass_time(2.0)
    assert state(robot, "falls") == "3"
    robot.pass_time(60.0)
    assert len(nurse.pictures) == pytest.approx(66, abs=6)
    assert nurse.pictures[0] != nurse.pictures[1]


def test_no_picture_is_taken_once_help_is_there(robot: situ.testing.Robot, nurse: Nurse) -> None:
    fallen(robot)
    robot.pass_time(2.0)
    robot.publish("fallCleared")
    robot.pass_time(1.0)
    taken = len(nurse.pictures)
    robot.pass_time(30.0)
    assert len(nurse.pictures) == taken


def test_she_lets_the_robot_go_from_her_page(robot: situ.testing.Robot, nurse: Nurse) -> None:
    fallen(robot)
    nurse.looks = nurse.says_help_is_there = True
    robot.pass_time(2.0)
    assert (robot.situation, state(robot, "falls")) == ("day", "1")


def test_a_lost_connection_is_tried_again_and_nobody_is_said_to_see(
    robot: situ.testing.Robot, nurse: Nurse
) -> None:
    fallen(robot)
    nurse.looks = True
    robot.pass_time(2.0)
    assert state(robot, "falls") == "5"
    nurse.is_away = True
    robot.pass_time(4.0)
    assert (state(robot, "falls"), state(robot, "watching")) == ("3", "3")
    nurse.is_away = False
    robot.pass_time(7.0)
    assert (state(robot, "falls"), state(robot, "watching")) == ("5", "2")


def test_the_red_button_takes_no_picture_from_her(robot: situ.testing.Robot, nurse: Nurse) -> None:
    fallen(robot)
    robot.set("robot.stop", True)
    before = len(nurse.pictures)
    robot.pass_time(5.0)
    assert len(nurse.pictures) == before + 5
    assert robot.command("base") is None


def test_whoever_was_being_served_is_gone_back_to(robot: situ.testing.Robot) -> None:
    robot.give(Touch())
    fallen(robot)
    robot.publish("fallCleared")
    assert robot.situation == "fallen"
    assert robot.command("base") == {"command": "goto", "params": {"place": "lobby"}}
    arrive(robot)
    assert (robot.situation, robot.holder("screen")) == ("day", "home")


class Ward:
    """The ward's own records behind the services that the robot asks."""

    def __init__(self, robot: situ.testing.Robot) -> None:
        def now() -> datetime:
            return datetime(2026, 5, 4, 8, 0, tzinfo=UTC)

        self.robot = robot
        self.store = Store(None, now)
        self.day = Day(self.store.db, now, UTC)
        for room, pin in ((3, "3141"), (12, "1234")):
            who = self.store.add(room, f"Who lives in {room}", pin)
            self.day.prescribe(who.id, "morning", f"the tablet of {room}")

    def answer_round(self) -> None:
        self.robot.give(Finish(name="whoNeeds", result={"round": self.day.round("morning")}))

    def log_in(self, room: int, pin: str) -> None:
        user = self.store.login(room, pin)
        found = {"id": user.id, "name": user.name, "room": user.room}
        self.robot.give(Finish(name="visitLogin", result={"user": found}))

    def keep(self) -> None:
        """What the robot has written down since."""
        while state(self.robot, "keeping") == "2":
            told = self.robot.value("readings.current")
            (self.day if told["kind"] == "medication" else self.store).keep(told)
            self.robot.give(Finish(name="keepReading"))


def take_or_not(ward: Ward, room: int, pin: str, what: str) -> None:
    arrive(ward.robot)
    ward.robot.give(Touch())
    ward.robot.give(Use("pin", pin))
    ward.log_in(room, pin)
    assert f"the tablet of {room}" in shown(ward.robot)
    ward.robot.give(Use(what))
    ward.robot.give(Use("bye"))
    ward.keep()


def test_who_refuses_is_asked_three_times_then_the_nurse_is_called(
    robot: situ.testing.Robot,
) -> None:
    ward = Ward(robot)
    robot.set(EIGHT)
    ward.answer_round()
    assert robot.situation == "round"
    take_or_not(ward, 3, "3141", "no")
    take_or_not(ward, 12, "1234", "taken")
    for time in (2, 3):
        assert robot.situation == "day"
        robot.pass_time(601.0)
        assert robot.situation == "round", time
        take_or_not(ward, 3, "3141", "no")
    assert robot.situation == "day"
    (call,) = robot.events(kind="action", action="message", topic="nurse/call")
    assert call["value"] == {"why": "medicine not taken, three times", "room": "3"}
    assert [one.outcome for one in ward.day.medicines()] == ["refused", "taken"]
    robot.pass_time(1300.0)
    assert robot.situation == "day"


def test_a_round_broken_off_by_a_fall_asks_for_the_pin_again(robot: situ.testing.Robot) -> None:
    ward = Ward(robot)
    robot.set(EIGHT)
    ward.answer_round()
    arrive(robot)
    robot.give(Touch())
    robot.give(Use("pin", "3141"))
    ward.log_in(3, "3141")
    assert state(robot, "medication") == "4"
    fallen(robot)
    assert "tablet" not in shown(robot)
    robot.publish("fallCleared")
    assert robot.command("base") == {"command": "goto", "params": {"place": "room-3"}}
    assert "tablet" not in shown(robot)
    take_or_not(ward, 3, "3141", "taken")
    assert ward.day.medicines()[0].outcome == "taken"


def test_a_round_waits_for_who_is_being_served(robot: situ.testing.Robot) -> None:
    ward = Ward(robot)
    robot.give(Touch())
    robot.set(EIGHT)
    ward.answer_round()
    assert (robot.situation, robot.holder("screen")) == ("day", "home")
    robot.give(Use("home"))
    assert robot.situation == "round"


def test_a_round_is_begun_once_a_day(robot: situ.testing.Robot) -> None:
    robot.set(EIGHT)
    robot.give(Finish(name="whoNeeds", result={"round": []}))
    robot.set("clock.time", "08:01")
    assert len(robot.events(kind="action", name="whoNeeds")) == 1
    robot.set({"clock.date": "2026-05-05"})
    assert len(robot.events(kind="action", name="whoNeeds")) == 2


def test_at_night_the_robot_stands_at_its_dock_and_speaks_low(robot: situ.testing.Robot) -> None:
    robot.set({"clock.date": "2026-05-04", "clock.time": "21:00"})
    assert robot.command("base") == {"command": "goto", "params": {"place": "dock"}}
    assert robot.value("speech.volume") < 100
    arrive(robot)
    fallen(robot)
    robot.publish("fallCleared")
    assert robot.command("base") == {"command": "goto", "params": {"place": "dock"}}
    robot.set("clock.time", "07:00")
    assert robot.command("base") == {"command": "goto", "params": {"place": "lobby"}}
    assert robot.value("speech.volume") == 100


def test_what_is_for_all_is_told_in_the_day_only(robot: situ.testing.Robot) -> None:
    notice = {"reminder": 1, "at": "21:20", "begins": "21:30", "what": "fireworks"}
    robot.set({"clock.date": "2026-05-04", "clock.time": "21:20"})
    robot.give(Finish(name="schedule", result={"notices": [notice], "reminders": []}))
    assert robot.situation == "quiet"
    assert spoken(robot) == []
    robot.set("quiet.from", "22:00")
    assert robot.situation == "reminder"
    assert spoken(robot) == ["Today at 21:30: fireworks."]
