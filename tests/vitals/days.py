"""Days of examples/vitals from a seed: people, rounds, falls, the red button, nights."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from situ.decide.inputs import AnyInput, Finish, Raise, Set, Use
from situ.decide.trace import TraceEvent, to_fields

VITALS = Path(__file__).resolve().parents[2] / "examples" / "vitals"
SECOND, HOUR = 1_000_000, 3600
ROOMS = (3, 7, 12, 21)
LIMITS = {"systolic_low": 100, "systolic_high": 150, "diastolic_low": 55, "diastolic_high": 95}
LIMITS |= {"oxygen_low": 92, "glucose_low": 4, "glucose_high": 10}
TAKES = {"speech": (1, 6), "robot": (3, 30), "launch": (2, 60), "sound": (10, 40)}
"""Seconds that an action takes; all others take less than a second to ten."""

BUSIEST = 500
"""So many events come of one moment at most."""


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

    def inputs(self, days: float) -> Iterator[tuple[int, AnyInput]]:
        """What is done and what ends, each with its µs; the next is chosen when the robot has
        been given the one before, and ``hear`` told what came of it."""
        now, next_minute = 0.0, 0.0
        while now < days * 24 * HOUR:
            now += self.chance.uniform(0.5, 8)
            at = int(now * SECOND)
            if now >= next_minute:
                yield at, _clock(now)
                next_minute = now // 60 * 60 + 60
            for finish in self.done_by(now):
                yield at, finish
            self.pending = {which: until for which, until in self.pending.items() if until > now}
            does = self._whim()
            if does is not None:
                yield at, does

    def _whim(self) -> AnyInput | None:
        roll = self.chance.random()
        if roll < 0.002:
            return Set({"fall-heard": {"room": self.chance.choice(ROOMS)}}, "scenario")
        if roll < 0.0025:
            return Set({"robot.stop": True}, "scenario")
        if roll < 0.01:
            return Set({"robot.stop": False}, "scenario")
        if roll < 0.03:
            return Set({"watched": self.chance.random() < 0.5}, "scenario")
        if roll < 0.032:
            return Raise("screenTouched")
        return self.touch() if roll < 0.5 else None

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
            return Use(
                one["id"],
                {"id": 1, "name": "Anna", "said": "Anna", "address": "sip:1@ward.invalid"},
            )
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
        people = [{"id": n, "room": room, "what": "a tablet"} for n, room in enumerate(ROOMS, 1)]
        person = {"id": roll(1, 4), "name": "Jack", "said": "Jack", "room": 12, "limits": LIMITS}
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
        messages = [{"reminder": 1, "days": n, "begins": "10:00", "what": "tea"} for n in range(3)]
        answers: dict[str, Any] = {
            "login": {"user": person, "messages": messages[: roll(0, 3)]},
            "visitLogin": {"user": person},
            "whoNeeds": {"round": [{**one, "round": "morning"} for one in people]},
            "schedule": {"notices": [told][: roll(0, 1)], "reminders": [told][: roll(0, 1)]},
            "contacts": {"contacts": [{"id": 1, "name": "Anna", "said": "Anna"}][: roll(0, 3)]},
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


def _clock(now: float) -> Set:
    minute = int(now) // 60 + 7 * 60
    time = f"{minute // 60 % 24:02}:{minute % 60:02}"
    date = f"2026-05-{4 + minute // (24 * 60):02}"
    return Set({"clock.time": time, "clock.date": date}, "scenario")
