"""The records of examples/vitals: what is kept, and who sees what over HTTP."""

from __future__ import annotations

from datetime import UTC, timedelta
from pathlib import Path
from typing import Any

import aiohttp
import pytest
from tests.vitals.ward import ROBOT, Clock, over_http

from ward_records.access import Tokens
from ward_records.day import Day
from ward_records.errors import Locked, Unfit, Unknown, WrongPin
from ward_records.store import LIMITS, Resident, Store

PRESSURE = {"kind": "pressure", "systolic": "128", "diastolic": "76", "pulse": 68}


# -- what is kept --------------------------------------------------------------------


def test_a_room_and_a_pin_are_one_resident(store: Store, jack: Resident) -> None:
    other = store.add(12, "Joan Nikora", "9999")
    assert store.login(12, "1234") == jack
    assert store.login(12, "9999") == other
    with pytest.raises(WrongPin):
        store.login(7, "1234")
    with pytest.raises(Unfit):
        store.add(12, "Somebody else", "1234")


def test_who_tries_a_neighbours_pin_is_not_forgiven_for_knowing_an_own_one(
    store: Store, jack: Resident
) -> None:
    store.add(12, "Joan Nikora", "9999")
    for _ in range(4):
        with pytest.raises(WrongPin):
            store.login(12, "0000")
        store.login(12, "9999")
    with pytest.raises(WrongPin):
        store.login(12, "0000")
    with pytest.raises(Locked):
        store.login(12, "1234")


def test_a_clock_that_is_set_back_locks_no_room_for_longer(
    store: Store, jack: Resident, clock: Clock
) -> None:
    for _ in range(5):
        with pytest.raises(WrongPin):
            store.login(12, "0000")
    clock.on(days=-1)
    assert store.login(12, "1234") == jack


@pytest.mark.parametrize("pin", ["", "123", "12345", "12a4", "１２３４"])
def test_a_pin_is_four_digits(store: Store, pin: str) -> None:
    with pytest.raises(Unfit):
        store.add(1, "Ann", pin)


def test_after_five_wrong_pins_a_room_is_not_looked_at_for_five_minutes(
    store: Store, jack: Resident, clock: Clock
) -> None:
    store.add(7, "Joan Nikora", "2718")
    for _ in range(5):
        with pytest.raises(WrongPin):
            store.login(12, "0000")
        clock.on(seconds=10)
    with pytest.raises(Locked):
        store.login(12, "1234")
    assert store.login(7, "2718").name == "Joan Nikora"
    clock.on(minutes=5)
    assert store.login(12, "1234") == jack


def test_where_one_lives_alone_a_right_pin_forgets_the_wrong_ones(
    store: Store, jack: Resident
) -> None:
    for _ in range(3):
        for _ in range(4):
            with pytest.raises(WrongPin):
                store.login(12, "0000")
        assert store.login(12, "1234") == jack


def test_no_file_holds_a_pin_and_nobody_else_reads_it(tmp_path: Path, clock: Clock) -> None:
    file = tmp_path / "ward.db"
    kept = Store(file, clock)
    kept.add(12, "Jack Nilsen", "1234")
    kept.keep({**PRESSURE, "user": 1})
    kept.close()
    assert b"1234" not in file.read_bytes()
    assert file.stat().st_mode & 0o077 == 0
    again = Store(file, clock)
    assert again.login(12, "1234").name == "Jack Nilsen"
    assert [one.kind for one in again.readings()] == ["pressure"]
    again.close()


def test_readings_are_kept_with_numbers_that_the_robot_wrote_as_texts(
    store: Store, jack: Resident, clock: Clock
) -> None:
    store.keep({**PRESSURE, "user": str(jack.id)})
    clock.on(minutes=1)
    store.keep({"kind": "oxygen", "oxygen": 97, "pulse": 70, "user": jack.id})
    last, first = store.readings(jack.id)
    assert (first.kind, first.measured) == (
        "pressure",
        {"systolic": 128, "diastolic": 76, "pulse": 68},
    )
    assert (last.kind, last.at - first.at) == ("oxygen", timedelta(minutes=1))
    assert store.readings(99) == []


@pytest.mark.parametrize(
    "wrong",
    [
        {"kind": "nonsense"},
        {"kind": ["pressure"]},
        {},
        {"systolic": None},
        {"systolic": "high"},
        {"systolic": 999},
        {"diastolic": "nan"},
        {"pulse": True},
        {"user": ""},
        {"user": "1.5"},
    ],
)
def test_what_nobody_can_have_is_not_kept(
    store: Store, jack: Resident, wrong: dict[str, Any]
) -> None:
    told = {**PRESSURE, "user": jack.id, **wrong} if wrong else {}
    with pytest.raises(Unfit):
        store.keep(told)
    assert store.readings() == []


def test_a_score_is_kept_and_hides_no_reading_of_the_body(store: Store, jack: Resident) -> None:
    store.keep({**PRESSURE, "user": jack.id})
    store.keep({"kind": "game", "score": "4", "user": str(jack.id)})
    with pytest.raises(Unfit):
        store.keep({"kind": "game", "score": 6, "user": jack.id})

    async def asking(session: aiohttp.ClientSession) -> None:
        shown = await (await session.get("/", params={"token": "a-nurse"})).text()
        assert "128 / 76" in shown
        assert "4 of 5" not in shown
        assert "4 of 5" in await (await session.get(f"/residents/{jack.id}")).text()

    over_http(store, asking)


def test_a_reading_of_nobody_is_not_kept(store: Store) -> None:
    with pytest.raises(Unknown):
        store.keep({**PRESSURE, "user": 5})


def test_a_call_is_open_until_a_nurse_has_seen_it(store: Store, clock: Clock) -> None:
    store.keep({"kind": "call", "why": "fall", "room": 12})
    clock.on(minutes=1)
    store.keep({"kind": "call", "why": "help", "room": ""})
    last, first = store.calls()
    assert (first.why, first.room, first.seen) == ("fall", "12", None)
    assert last.room == "place not known"
    store.see(last.id)
    seen_at = clock.now
    clock.on(minutes=1)
    store.see(last.id)
    assert [(one.why, one.seen) for one in store.calls()] == [("fall", None), ("help", seen_at)]


def test_who_has_fallen_stands_before_who_has_not_taken_a_medicine(
    store: Store, clock: Clock
) -> None:
    for why in ("fall", "medicine not taken, three times", "help at night"):
        store.keep({"kind": "call", "why": why, "room": 12})
        clock.on(minutes=1)
    urgent = ["help at night", "fall", "medicine not taken, three times"]
    assert [one.why for one in store.calls()] == urgent
    store.see(1)
    assert [one.id for one in store.calls()] == [3, 2, 1]


def test_a_call_without_a_reason_is_none(store: Store) -> None:
    with pytest.raises(Unfit):
        store.keep({"kind": "call", "room": "12"})


def test_limits_are_the_persons_own(store: Store, jack: Resident) -> None:
    other = store.add(7, "Joan Nikora", "2718")
    own = {**LIMITS, "systolic_high": 165.0}
    store.set_limits(jack.id, own)
    assert store.login(12, "1234").limits == own
    assert store.resident(other.id).limits == LIMITS


@pytest.mark.parametrize(
    "wrong",
    [{"systolic_low": 170}, {"diastolic_high": 900}, {"oxygen_low": 100}, {"pulse_low": 50}],
)
def test_limits_that_are_none_change_nothing(
    store: Store, jack: Resident, wrong: dict[str, float]
) -> None:
    with pytest.raises(Unfit):
        store.set_limits(jack.id, LIMITS | wrong)
    with pytest.raises(Unknown):
        store.set_limits(99, LIMITS)
    assert store.resident(jack.id).limits == LIMITS


# -- over HTTP -------------------------------------------------------------------------


def test_no_number_of_games_hides_what_was_measured_of_the_body(
    store: Store, jack: Resident, clock: Clock
) -> None:
    store.keep({**PRESSURE, "user": jack.id})
    store.keep({**PRESSURE, "user": jack.id})
    for score in range(130):
        clock.on(hours=1)
        store.keep({"kind": "game", "score": score % 6, "user": jack.id})

    async def asking(session: aiohttp.ClientSession) -> None:
        await session.get("/", params={"token": "a-nurse"})
        assert "128 / 76" in await (await session.get("/")).text()
        shown = await (await session.get("/residents/1")).text()
        assert 'id="curve-pressure"' in shown

    over_http(store, asking)


def test_the_robot_logs_people_in_and_writes_down(
    store: Store, jack: Resident, clock: Clock
) -> None:
    Day(store.db, clock, UTC).remind("08:00", "the doctor", jack.id)

    async def asking(session: aiohttp.ClientSession) -> None:
        answer = await session.post("/login", json={"room": 12, "pin": "1234"}, headers=ROBOT)
        name = "Jack <Nilsen>"
        assert await answer.json() == {
            "user": {"id": 1, "name": name, "said": name, "room": 12, "limits": LIMITS},
            "messages": [{"reminder": 1, "days": 0, "begins": "08:00", "what": "the doctor"}],
        }
        reading = {"reading": {**PRESSURE, "user": "1"}}
        answer = await session.post("/readings", json=reading, headers=ROBOT)
        assert (answer.status, await answer.json()) == (200, {"kept": True})

    over_http(store, asking)
    assert len(store.readings()) == 1


@pytest.mark.parametrize(
    ("path", "body", "status"),
    [
        ("/login", {"room": 12, "pin": "0000"}, 401),
        ("/login", {"room": "no", "pin": "1234"}, 400),
        ("/login", {"room": 12, "pin": 1234}, 400),
        ("/readings", {"reading": {"kind": "nonsense"}}, 400),
        ("/readings", {"reading": 7}, 400),
        ("/readings", {"reading": {"kind": ["medication"]}}, 400),
        ("/readings", {"reading": {"kind": "call", "why": "\ud800"}}, 400),
        ("/login", {"room": 12, "pin": "\ud800"}, 400),
        ("/login", {"room": 10**400, "pin": "1234"}, 400),
        ("/readings", [], 400),
        ("/contacts", {"user": "x", "group": "family"}, 400),
        ("/contacts", {"user": 1}, 400),
        ("/contacts", {"user": 99, "group": "family"}, 404),
        ("/readings", {"reading": {**PRESSURE, "user": 99}}, 404),
        ("/readings", {"reading": "x" * 100_000}, 413),
    ],
)
def test_what_can_not_be_answered_says_why(
    store: Store, jack: Resident, path: str, body: Any, status: int
) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        answer = await session.post(path, json=body, headers=ROBOT)
        assert answer.status == status
        assert await answer.text()

    over_http(store, asking)


def test_too_many_wrong_pins_are_429(store: Store, jack: Resident) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        given = {"room": 12, "pin": "0000"}
        found = [(await session.post("/login", json=given, headers=ROBOT)).status for _ in "123456"]
        assert found == [401] * 5 + [429]

    over_http(store, asking)


@pytest.mark.parametrize("token", [None, "a-nurse", "a-visitor", "guessed"])
def test_nobody_but_the_robot_logs_in_or_writes(
    store: Store, jack: Resident, token: str | None
) -> None:
    headers = {"Authorization": f"Bearer {token}"} if token else {}

    async def asking(session: aiohttp.ClientSession) -> None:
        for path in ("/login", "/readings"):
            answer = await session.post(path, json={"room": 12, "pin": "1234"}, headers=headers)
            assert answer.status == 403

    over_http(store, asking)


def test_a_token_that_was_emptied_is_nobodys() -> None:
    tokens = Tokens("the-robot", "", "a-visitor")
    assert [tokens.role(one) for one in (None, "", "a-visitor")] == [None, None, "viewer"]


@pytest.mark.parametrize("token", ["", "guessed", "the-robot"])
def test_without_a_nurses_or_visitors_token_no_page_is_shown(
    store: Store, jack: Resident, token: str
) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        await session.get("/", params={"token": token})
        for path in ("/", "/residents/1"):
            answer = await session.get(path)
            assert answer.status == 403
            assert "Nilsen" not in await answer.text()
        assert (await session.post("/residents/1", data=LIMITS)).status == 403

    over_http(store, asking)


def test_a_visitor_sees_no_name_room_or_value_and_changes_nothing(
    store: Store, jack: Resident
) -> None:
    store.keep({**PRESSURE, "user": jack.id})
    store.keep({"kind": "call", "why": "fall", "room": 12})

    async def asking(session: aiohttp.ClientSession) -> None:
        await session.get("/", params={"token": "a-visitor"})
        for path in ("/", "/residents/1"):
            shown = (await (await session.get(path)).text()).partition("</head>")[2]
            assert "•••" in shown
            for private in ("Nilsen", "128", "76 ", "fall", "<td>12", "Room 12", "room 12"):
                assert private not in shown
            assert "<button" not in shown
        assert (await session.post("/residents/1", data=LIMITS)).status == 403
        assert (await session.post("/calls/1")).status == 403

    over_http(store, asking)
    assert store.calls()[0].seen is None


def test_the_token_leaves_the_address_and_no_page_is_kept_or_framed(
    store: Store, jack: Resident
) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        answer = await session.get("/", params={"token": "a-nurse"}, allow_redirects=False)
        assert (answer.status, answer.headers["Location"]) == (303, "/")
        assert "HttpOnly" in answer.headers["Set-Cookie"]
        assert "SameSite=Strict" in answer.headers["Set-Cookie"]
        page = await session.get("/")
        assert page.headers["Cache-Control"] == "no-store"
        assert "frame-ancestors 'none'" in page.headers["Content-Security-Policy"]
        shown = await page.text()
        assert "Jack &lt;Nilsen&gt;" in shown
        assert "<Nilsen>" not in shown

    over_http(store, asking)


def test_who_is_not_there_is_404(store: Store) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        await session.get("/", params={"token": "a-nurse"})
        assert (await session.get("/residents/9")).status == 404
        assert (await session.post("/residents/9", data=LIMITS)).status == 404
        assert (await session.get("/nothing")).status == 404

    over_http(store, asking)
