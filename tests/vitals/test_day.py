"""What the records of examples/vitals know of a day: rounds, what is told, who is watched."""

from __future__ import annotations

import asyncio
import runpy
from collections.abc import Callable
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import aiohttp
import pytest
from aiohttp import web
from aiohttp.test_utils import BaseTestServer, TestServer
from tests.vitals import ward
from tests.vitals.ward import ROBOT, TOKENS, Asking, Clock

from situ.blackboard.services import PATIENCE
from ward_records.day import TIMES, Day
from ward_records.errors import Unfit
from ward_records.store import Resident, Store
from ward_records.watching import GONE, WATCHED, Picture, Watching
from ward_records.web import application

VITALS = Path(__file__).resolve().parents[2] / "examples" / "vitals"


@pytest.fixture
def day(store: Store, clock: Clock) -> Day:
    return Day(store.db, clock, UTC)


def visited(jack: Resident, outcome: str, round_: str = "morning") -> dict[str, str]:
    return {"kind": "medication", "user": str(jack.id), "round": round_, "outcome": outcome}


def told(reminder: int, outcome: str) -> dict[str, str]:
    return {"kind": "reminder", "reminder": str(reminder), "outcome": outcome}


def at(found: list[dict[str, Any]]) -> list[tuple[int, str]]:
    return [(one["reminder"], one["at"]) for one in found]


# -- rounds ----------------------------------------------------------------------------


def test_a_round_visits_by_room_who_has_not_taken_it_today(
    store: Store, day: Day, jack: Resident, clock: Clock
) -> None:
    joan = store.add(7, "Joan Nikora", "2718")
    day.prescribe(jack.id, "morning", "two white tablets")
    day.prescribe(joan.id, "morning", "one drop")
    day.prescribe(joan.id, "noon", "one tablet")
    drop = {"id": joan.id, "room": 7, "what": "one drop", "round": "morning"}
    tablets = {"id": jack.id, "room": 12, "what": "two white tablets", "round": "morning"}
    assert day.round("morning") == [drop, tablets]
    day.keep(visited(jack, "taken"))
    day.keep(visited(joan, "refused"))
    assert day.round("morning") == [drop]
    assert [one.outcome for one in day.medicines()] == ["refused", "taken", None]
    clock.on(days=1)
    assert day.round("morning") == [drop, tablets]
    day.prescribe(joan.id, "morning", " ")
    assert day.round("morning") == [tablets]


@pytest.mark.parametrize(
    "wrong",
    [
        {"outcome": "eaten"},
        {"round": "midnight"},
        {"user": "99"},
        {"user": None},
        {"kind": "reminder", "reminder": "99", "outcome": "told"},
    ],
)
def test_a_visit_that_can_not_be_is_not_kept(
    day: Day, jack: Resident, wrong: dict[str, Any]
) -> None:
    with pytest.raises(Unfit):
        day.keep(visited(jack, "taken") | wrong)
    with pytest.raises(Unfit):
        day.round("midnight")
    with pytest.raises(Unfit):
        day.prescribe(jack.id, "midnight", "milk")


# -- what is told -------------------------------------------------------------------------


def test_all_hear_what_is_for_all_and_one_what_is_for_one_ten_minutes_before(
    day: Day, jack: Resident
) -> None:
    day.remind("15:00", "tea", None)
    day.remind("10:30", "bingo", None, daily=True)
    day.remind("14:00", "the doctor", jack.id)
    found = day.schedule()
    assert at(found["notices"]) == [(2, "10:20"), (1, "14:50")]
    (doctor,) = found["reminders"]
    assert doctor == {
        "reminder": 3,
        "at": "13:50",
        "begins": "14:00",
        "id": jack.id,
        "room": 12,
        "what": "the doctor",
    }


def test_what_is_told_is_told_once_a_day_and_a_day_has_what_is_daily(
    day: Day, clock: Clock
) -> None:
    day.remind("10:30", "bingo", None, daily=True)
    day.remind("15:00", "tea", None)
    day.keep(told(1, "told"))
    assert at(day.schedule()["notices"]) == [(2, "14:50")]
    clock.on(days=1)
    assert at(day.schedule()["notices"]) == [(1, "10:20")]
    day.forget(1)
    assert day.schedule() == {"notices": [], "reminders": []}


def test_later_is_ten_minutes_later_and_nobody_is_looked_for_three_times(
    day: Day, jack: Resident, clock: Clock
) -> None:
    day.remind("10:30", "the doctor", jack.id)
    clock.at("10:21")
    day.keep(told(1, "later"))
    assert at(day.schedule()["reminders"]) == [(1, "10:31")]
    for absent in range(TIMES):
        assert len(day.schedule()["reminders"]) == 1, absent
        day.keep(told(1, "nobody"))
    assert day.schedule()["reminders"] == []
    assert [one.outcome for one in day.reminders()] == ["nobody"]


def test_what_was_told_is_not_told_again_because_it_is_midnight_meanwhile(store: Store) -> None:
    moments = [datetime(2026, 5, 4, 23, 50, tzinfo=UTC)]

    def now() -> datetime:
        return moments.pop(0) if len(moments) > 1 else moments[0]

    day = Day(store.db, now, UTC)
    day.remind("23:55", "the gate is shut", None, daily=True)
    day.keep(told(1, "told"))
    midnight = datetime(2026, 5, 5, tzinfo=UTC)
    moments[:] = [midnight - timedelta(microseconds=1), midnight]
    assert day.schedule() == {"notices": [], "reminders": []}


def test_half_an_hour_after_its_begin_nothing_is_told_any_more(day: Day, clock: Clock) -> None:
    day.remind("10:30", "bingo", None)
    clock.at("11:00")
    assert len(day.schedule()["notices"]) == 1
    clock.on(seconds=1)
    assert day.schedule()["notices"] == []


def test_what_begins_soon_after_midnight_is_told_at_midnight(day: Day, clock: Clock) -> None:
    clock.at("00:00")
    day.remind("00:05", "fireworks", None)
    assert at(day.schedule()["notices"]) == [(1, "00:00")]


def missed(day: Day, who: Resident) -> list[tuple[int, int]]:
    return [(one["reminder"], one["days"]) for one in day.missed(who.id)]


def test_what_nobody_took_is_kept_a_week_for_whom_it_is(
    store: Store, day: Day, jack: Resident, clock: Clock
) -> None:
    joan = store.add(7, "Joan Nikora", "2718")
    day.remind("10:30", "the doctor", jack.id)
    day.remind("10:00", "your eye drops", jack.id, daily=True)
    day.remind("10:00", "bingo", None)
    day.remind("10:00", "the hairdresser", joan.id)
    assert missed(day, jack) == []
    clock.at("09:50")
    assert day.missed(jack.id) == [
        {"reminder": 2, "days": 0, "begins": "10:00", "what": "your eye drops"}
    ]
    for _ in range(TIMES):
        day.keep(told(1, "nobody"))
    clock.at("23:00")
    assert missed(day, jack) == [(2, 0), (1, 0)]
    clock.on(days=1)
    # What is daily is of today.
    assert missed(day, jack) == [(2, 0), (1, 1)]
    clock.on(days=6)
    assert missed(day, jack) == [(2, 0), (1, 7)]
    clock.on(days=1)
    assert missed(day, jack) == [(2, 0)]
    assert missed(day, joan) == []


def test_what_was_told_is_not_missed_though_it_was_told_late(
    day: Day, jack: Resident, clock: Clock
) -> None:
    day.remind("10:30", "the doctor", jack.id)
    day.remind("10:30", "your eye drops", jack.id, daily=True)
    clock.on(days=1, hours=4)
    day.keep(told(1, "told"))
    day.keep(told(2, "told"))
    assert missed(day, jack) == []
    clock.on(days=1)
    assert missed(day, jack) == [(2, 0)]


def test_what_begins_soon_after_midnight_is_missed_from_midnight_on(
    day: Day, jack: Resident, clock: Clock
) -> None:
    clock.at("00:00")
    day.remind("00:05", "fireworks", jack.id)
    assert missed(day, jack) == [(1, 0)]


@pytest.mark.parametrize("begins", ["", "9:30", "24:00", "soon", "10:3x"])
def test_a_time_is_written_as_08_05(day: Day, begins: str) -> None:
    with pytest.raises(Unfit):
        day.remind(begins, "bingo", None)
    with pytest.raises(Unfit):
        day.remind("08:05", " ", None)


# -- who is watched ------------------------------------------------------------------------

PICTURE = Picture("image/png", b"one")


def test_a_nurse_looks_while_she_asks_for_pictures(clock: Clock) -> None:
    watching = Watching(clock)
    assert watching.look("7") is None
    assert watching.show("7", PICTURE) == {"watched": False, "ended": False}
    assert watching.look("7") == PICTURE
    assert watching.show("7", PICTURE) == {"watched": True, "ended": False}
    clock.on(seconds=WATCHED.total_seconds())
    assert watching.show("7", PICTURE) == {"watched": False, "ended": False}


def test_no_picture_stays_when_none_comes_any_more(clock: Clock) -> None:
    watching = Watching(clock)
    watching.show("7", PICTURE)
    assert watching.rooms() == ["7"]
    clock.on(seconds=GONE.total_seconds())
    assert watching.rooms() == []
    assert watching.look("7") is None


def test_with_a_clock_that_is_set_back_no_picture_stays_and_nobody_seems_to_look(
    clock: Clock,
) -> None:
    watching = Watching(clock)
    watching.show("7", PICTURE)
    clock.on(hours=-3)
    assert watching.look("7") is None
    assert watching.rooms() == []
    watching.show("7", PICTURE)
    watching.look("7")
    clock.on(seconds=-2)
    assert watching.show("7", PICTURE) == {"watched": False, "ended": False}


def test_of_a_room_that_the_robot_has_left_nothing_is_kept(clock: Clock) -> None:
    gone: list[bytes] = []

    class Content(bytes):
        """Bytes that tell when nobody has them any more."""

        def __del__(self) -> None:
            gone.append(self)

    watching = Watching(clock)
    watching.show("7", Picture(PICTURE.kind, Content(PICTURE.content)))
    assert gone == []
    clock.on(seconds=GONE.total_seconds())
    watching.rooms()
    assert gone == [PICTURE.content]


def test_that_help_is_there_is_told_once(clock: Clock) -> None:
    watching = Watching(clock)
    watching.end("7")
    watching.show("7", PICTURE)
    watching.look("7")
    watching.end("7")
    assert watching.show("7", PICTURE) == {"watched": False, "ended": True}
    assert watching.show("7", PICTURE) == {"watched": False, "ended": False}


# -- over HTTP -------------------------------------------------------------------------

Over = Callable[[Asking], None]


@pytest.fixture
def over_http(store: Store, clock: Clock) -> Over:
    return lambda asking: ward.over_http(store, asking, clock=clock)


def test_the_robot_asks_what_is_to_be_done_and_tells_how_it_ended(
    over_http: Over, day: Day, jack: Resident
) -> None:
    day.prescribe(jack.id, "morning", "two white tablets")
    day.remind("10:30", "bingo", None)

    async def asking(session: aiohttp.ClientSession) -> None:
        answer = await session.post("/rounds", json={"round": "morning"}, headers=ROBOT)
        assert [one["room"] for one in (await answer.json())["round"]] == [12]
        for reading in (visited(jack, "taken"), told(1, "told")):
            answer = await session.post("/readings", json={"reading": reading}, headers=ROBOT)
            assert answer.status == 200
        answer = await session.post("/rounds", json={"round": "morning"}, headers=ROBOT)
        assert await answer.json() == {"round": []}
        answer = await session.post("/schedule", headers=ROBOT)
        assert await answer.json() == {"notices": [], "reminders": []}
        answer = await session.post("/rounds", json={"round": "tea"}, headers=ROBOT)
        assert answer.status == 400

    over_http(asking)


def test_a_nurse_looks_and_lets_the_robot_go(over_http: Over) -> None:
    png = ROBOT | {"Content-Type": "image/png"}

    async def asking(session: aiohttp.ClientSession) -> None:
        wrong = ROBOT | {"Content-Type": "text/html"}
        assert (await session.put("/watch/7", data=b"<p>", headers=wrong)).status == 415
        await session.put("/watch/7", data=b"one", headers=png)
        await session.get("/", params={"token": "a-nurse"})
        assert "/watch/7" in await (await session.get("/")).text()
        assert "/watch/7/live" in await (await session.get("/watch/7")).text()
        inside = await session.get("/watch/7/live")
        assert "frame-ancestors 'self'" in inside.headers["Content-Security-Policy"]
        assert "/watch/7/picture" in await inside.text()
        picture = await session.get("/watch/7/picture")
        assert (picture.content_type, await picture.read()) == ("image/png", b"one")
        answer = await session.put("/watch/7", data=b"two", headers=png)
        assert await answer.json() == {"watched": True, "ended": False}
        assert (await session.post("/watch/7")).status == 200
        answer = await session.put("/watch/7", data=b"three", headers=png)
        assert await answer.json() == {"watched": False, "ended": True}
        assert (await session.get("/watch/3/picture")).status == 404
        assert "nothing" in await (await session.get("/watch/3/live")).text()

    over_http(asking)


def test_the_camera_shows_its_pictures_to_the_records_and_to_nobody_else(
    store: Store, day: Day, clock: Clock
) -> None:
    records = runpy.run_path(str(VITALS / "modules" / "monitor.py"))["records"]
    watching = Watching(clock)

    async def strange(request: web.Request) -> web.Response:
        return web.Response(text=request.path.rpartition("/")[2])

    async def show(server: BaseTestServer, token: str, room: str = "7") -> object:
        url = str(server.make_url("")).rstrip("/")
        return await asyncio.to_thread(records(url, token), room, b"<svg/>")

    async def run() -> None:
        other = web.Application()
        other.router.add_put("/watch/{room}", strange)
        async with (
            TestServer(application(store, day, watching, TOKENS)) as ward,
            TestServer(other) as strangers,
        ):
            assert await show(ward, TOKENS.service) == {"watched": False, "ended": False}
            with pytest.raises(OSError, match="403"):
                await show(ward, "guessed")
            for text in ("<p>", "7", "[]", "null"):
                with pytest.raises(OSError, match="is not the records"):
                    await show(strangers, TOKENS.service, text)

    asyncio.run(run())
    assert watching.look("7") == Picture("image/svg+xml", b"<svg/>")


def test_a_nurse_changes_what_is_given_and_what_is_told(
    over_http: Over, day: Day, jack: Resident
) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        await session.get("/", params={"token": "a-nurse"})
        path = f"/residents/{jack.id}/medicine"
        shown = await session.post(path, data={"morning": "<b>one</b> tablet", "noon": ""})
        assert "&lt;b&gt;one&lt;/b&gt; tablet" in await shown.text()
        assert (await session.post("/residents/99/medicine")).status == 404
        new = {"begins": "10:30", "what": "the <b>doctor</b>", "whom": str(jack.id)}
        shown = await session.post("/reminders", data=new)
        assert (shown.status, shown.url.path) == (200, "/today")
        text = await shown.text()
        assert "the &lt;b&gt;doctor&lt;/b&gt;" in text
        assert "&lt;b&gt;one&lt;/b&gt; tablet" in text
        wrong = await session.post("/reminders", data={**new, "begins": "soon"})
        assert (wrong.status, "Not added" in await wrong.text()) == (400, True)
        for whom in ("99", "all", "1.5", "9" * 5000):
            assert (await session.post("/reminders", data={**new, "whom": whom})).status == 400
        nobody = {"begins": "10:30", "what": "the doctor"}
        assert (await session.post("/reminders", data=nobody)).status == 400
        # She is asked first.
        assert 'href="/reminders/1"' in text
        sure = await (await session.get("/reminders/1")).text()
        assert "10:30, room 12: the &lt;b&gt;doctor&lt;/b&gt;" in sure
        assert len(day.reminders()) == 1
        await session.post("/reminders/1")
        assert (await session.get("/reminders/1")).url.path == "/today"

    over_http(asking)
    assert [one.what for one in day.medicines(jack.id)] == ["<b>one</b> tablet"]
    assert day.reminders() == []


@pytest.mark.parametrize("takes", [0.0, 0.5, 3.9, 5.0])
def test_the_camera_answers_in_the_time_of_a_service_though_the_records_are_slow(
    takes: float,
) -> None:
    monitor = runpy.run_path(str(VITALS / "modules" / "monitor.py"))

    class Asked:
        """A board and a request to it, which stand still but for what takes time."""

        now, cancelled, params = 0.0, False, {"room": "7"}

        def __init__(self) -> None:
            self.answered: list[float] = []

        def clock(self) -> float:
            return self.now

        def sleep(self, seconds: float) -> None:
            self.now += seconds

        def set(self, *_: object) -> None: ...

        def answer(self, _: object) -> None:
            self.answered.append(self.now)

    asked = Asked()

    def show(*_: object) -> dict[str, bool]:
        asked.sleep(takes)
        return {"watched": False, "ended": False}

    monitor["watch"](asked, monitor["SimulatedCamera"](), show, asked)
    assert asked.answered == [asked.now]
    assert 20.0 <= asked.now <= 26.0 < PATIENCE


@pytest.mark.parametrize(("size", "status"), [(300_000, 200), (600_000, 413)])
def test_a_real_cameras_picture_is_taken_and_one_without_end_is_not(
    over_http: Over, size: int, status: int
) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        headers = {**ROBOT, "Content-Type": "image/jpeg"}
        shown = await session.put("/watch/7", data=b"\xff" * size, headers=headers)
        assert shown.status == status

    over_http(asking)


def test_a_visitor_sees_no_medicine_no_camera_and_changes_nothing(
    over_http: Over, day: Day, jack: Resident
) -> None:
    day.prescribe(jack.id, "morning", "two white tablets")
    day.remind("10:30", "the doctor", jack.id)
    day.remind("15:00", "tea", None)

    async def asking(session: aiohttp.ClientSession) -> None:
        picture = ROBOT | {"Content-Type": "image/png"}
        await session.put("/watch/7", data=b"one", headers=picture)
        assert (await session.get("/today")).status == 403
        assert (await session.put("/watch/7", data=b"one")).status == 403
        assert (await session.post("/rounds", json={"round": "noon"})).status == 403
        assert (await session.post("/schedule")).status == 403
        await session.get("/", params={"token": "a-visitor"})
        assert "/watch/7" not in await (await session.get("/")).text()
        shown = await (await session.get("/today")).text()
        for hidden in ("tablets", "doctor", "12", "<form", "Remove"):
            assert hidden not in shown
        assert "tea" in shown
        for path in ("/watch/7", "/watch/7/live", "/watch/7/picture", "/reminders/2"):
            assert (await session.get(path)).status == 403
        for path in ("/watch/7", "/reminders", "/reminders/1", f"/residents/{jack.id}/medicine"):
            assert (await session.post(path)).status == 403

    over_http(asking)
    assert len(day.reminders()) == 2
