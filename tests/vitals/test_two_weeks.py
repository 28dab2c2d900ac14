"""Two weeks of examples/vitals in virtual time: people, rounds, falls, the red button, a night.

Only with ``SITU_SOAK=1`` (``make soak``). What is random is seeded: ``SITU_SEED``.
"""

from __future__ import annotations

import os
import random
import resource
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from situ.decide.inputs import Finish, Raise, Set, Use
from situ.decide.trace import TraceEvent, to_fields
from situ.document.ready import load_ready
from situ.rehearse.simulate import Rehearsal

VITALS = Path(__file__).resolve().parents[2] / "examples" / "vitals"
SECOND, HOUR, DAYS = 1_000_000, 3600, 14
ROOMS = (3, 7, 12, 21)
LIMITS = {"systolic_low": 100, "systolic_high": 150, "diastolic_low": 55, "diastolic_high": 95}
LIMITS |= {"oxygen_low": 92, "glucose_low": 4, "glucose_high": 10}
TAKES = {"speech": (1, 6), "robot": (3, 30), "launch": (2, 60), "sound": (10, 40)}
"""Seconds that an action takes; all others take less than a second to ten."""

BUSIEST, MORE = 500, 30 * 1024
"""Events of one moment, and KiB that the rest after the first six hours may need."""


class Ward:
    """Who lives there and what answers the robot; told what it does, does something itself."""

    def __init__(self, seed: int) -> None:
        self.chance = random.Random(seed)
        self.pending: dict[tuple[str, str, str | None], float] = {}
        self.screen: list[dict[str, Any]] = []
        self.entered: Counter[str] = Counter()
        self.situations: Counter[str] = Counter()
        self.wrong: list[str] = []
        self.busiest = 0

    def hear(self, events: list[TraceEvent]) -> None:
        self.busiest = max(self.busiest, len(events))
        for event in map(to_fields, events):
            kind = event["kind"]
            if kind == "enter":
                self.entered[f"{event['application']} {event['state']}"] += 1
            elif kind == "situation":
                self.situations[event["to"]] += 1
            elif kind == "mapping" and event["resource"] == "screen":
                self.screen = (event["value"] or {}).get("components", [])
            elif kind == "action" and event["action"] in (*TAKES, "service"):
                least, most = TAKES.get(event["action"], (0.2, 10))
                self.pending[self._which(event)] = event["t"] + self.chance.uniform(least, most)
            elif kind in ("finished", "cancelled"):
                self.pending.pop(self._which(event), None)
            elif kind == "error":
                self.wrong.append(f"{event['t']} s: {event}")

    def done_by(self, now: float) -> list[Finish]:
        over = [which for which, until in self.pending.items() if until <= now]
        return [self._end(*which) for which in over]

    def touch(self) -> Use | None:
        """Somebody touches something of what is shown."""
        there = [one for one in self.screen if one["type"] in ("button", "input", "list")]
        if not there:
            return None
        one = self.chance.choice(there)
        if one["id"] in ("home", "help") and self.chance.random() < 0.8:
            return None
        if one["type"] == "list":
            return Use(one["id"], {"id": 1, "name": "Anna", "address": "sip:1@ward.invalid"})
        if one["type"] == "input":
            return Use(one["id"], self.chance.choice(ROOMS) if one["id"] == "room" else "1234")
        return Use(one["id"])

    def _end(self, application: str, action: str, name: str | None) -> Finish:
        well = self.chance.random() < 0.85
        if action != "service" or not well:
            status = self.chance.choice((401, 410, 429, None)) if action == "service" else None
            return Finish(action, name, application, ok=well, status=status)
        return Finish(action, name, application, result=self._answer(name or ""))

    def _answer(self, name: str) -> Any:
        roll = self.chance.randint
        people = [{"id": n, "room": room, "what": "a tablet"} for n, room in enumerate(ROOMS)]
        person = {"id": roll(0, 3), "name": "Jack", "room": 12, "limits": LIMITS}
        questions = [
            {"text": f"{n}?", "answers": ["a", "b", "c"], "right": 1, "because": "b."}
            for n in range(9)
        ]
        pieces = {
            "music": [{"kind": "music", "title": "A tune", "src": "joy.wav"}],
            "films": [{"kind": "film", "title": "A film", "src": "pond.webm"}],
            "stories": [{"kind": "story", "title": "A story", "pages": ["Once.", "The end."]}],
        }
        told = {"begins": "10:00", "what": "tea", "reminder": 1, "at": "00:00", "id": 2, "room": 12}
        messages = [{"reminder": n, "days": n, "begins": "10:00", "what": "tea"} for n in range(3)]
        answers: dict[str, Any] = {
            "login": {"user": person, "messages": messages[: roll(0, 3)]},
            "visitLogin": {"user": person},
            "whoNeeds": {"round": [{**one, "round": "morning"} for one in people]},
            "schedule": {"notices": [told][: roll(0, 1)], "reminders": [told][: roll(0, 1)]},
            "contacts": {"contacts": [{"id": 1, "name": "Anna"}][: roll(0, 3)]},
            "measurePressure": {"systolic": roll(90, 170), "diastolic": 80, "pulse": 70},
            "measureOxygen": {"oxygen": roll(88, 99), "pulse": 70},
            "readGlucose": {"glucose": roll(3, 12)},
            "questions": {"questions": questions},
            "shelf": pieces,
            "watch": {"ended": roll(0, 4) == 0},
        }
        return answers.get(name)

    @staticmethod
    def _which(event: dict[str, Any]) -> tuple[str, str, str | None]:
        return event["application"], event["action"], event["name"]


def clock(now: float) -> Set:
    minute = int(now) // 60 + 7 * 60
    time = f"{minute // 60 % 24:02}:{minute % 60:02}"
    date = f"2026-05-{4 + minute // (24 * 60):02}"
    return Set({"clock.time": time, "clock.date": date}, "test")


def memory() -> int:
    """The most that this process has needed so far, in KiB."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


@pytest.mark.skipif(not os.environ.get("SITU_SOAK"), reason="only in make soak")
def test_days_and_nights_go_by_every_state_is_come_to_and_nothing_grows() -> None:
    ward = Ward(int(os.environ.get("SITU_SEED", "0")))
    project = load_ready(VITALS)
    robot = Rehearsal(project, ward.hear)
    now, next_minute, early = 0.0, 0.0, 0
    while now < DAYS * 24 * HOUR:
        now += ward.chance.uniform(0.5, 8)
        at = int(now * SECOND)
        if now >= next_minute:
            robot.give(clock(now), at)
            next_minute = now // 60 * 60 + 60
        for finish in ward.done_by(now):
            robot.give(finish, at)
        ward.pending = {which: until for which, until in ward.pending.items() if until > now}
        roll = ward.chance.random()
        if roll < 0.002:
            robot.give(Set({"fall-heard": {"room": ward.chance.choice(ROOMS)}}, "test"), at)
        elif roll < 0.0025:
            robot.give(Set({"robot.stop": True}, "test"), at)
        elif roll < 0.01:
            robot.give(Set({"robot.stop": False}, "test"), at)
        elif roll < 0.03:
            robot.give(Set({"watched": ward.chance.random() < 0.5}, "test"), at)
        elif roll < 0.032:
            robot.give(Raise("screenTouched"), at)
        elif roll < 0.5 and (use := ward.touch()) is not None:
            robot.give(use, at)
        if not early and now > 6 * HOUR:
            early = memory()
    print(f"{sum(ward.entered.values())} states, {dict(ward.situations)}")
    print(f"at most {ward.busiest} events at once, {memory() - early} KiB more after six hours")
    assert ward.wrong == []
    assert ward.busiest < BUSIEST
    assert memory() - early < MORE
    assert project.spds is not None
    assert set(ward.situations) == {one.name for one in project.spds.situations}
    came = {seen.split("/")[0] for seen in ward.entered}
    every = {f"{one.name} {s.no}" for one in project.applications.values() for s in one.states}
    assert sorted(every - came) == []
