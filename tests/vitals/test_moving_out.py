"""Who moves out of the ward of examples/vitals: what is kept of them, and what nobody reads."""

from __future__ import annotations

import csv
import io
from datetime import UTC
from pathlib import Path

import aiohttp
import pytest
from tests.vitals.ward import ROBOT, Clock, over_http

from ward_records.contacts import Contacts
from ward_records.day import Day
from ward_records.errors import MovedOut, Unfit, Unknown, WrongPin
from ward_records.moving_out import Former, MovingOut
from ward_records.store import Resident, Store

PRESSURE = {"kind": "pressure", "systolic": 128, "diastolic": 76, "pulse": 68}


class Office:
    """The whole of what is kept of residents, in one store."""

    def __init__(self, store: Store, clock: Clock) -> None:
        self.store = store
        self.day = Day(store.db, clock, UTC)
        self.contacts = Contacts(store)
        self.moving_out = MovingOut(store, self.day, self.contacts)

    def has_much_of(self, who: Resident) -> None:
        self.store.keep({**PRESSURE, "user": who.id})
        self.store.keep({"kind": "call", "why": "help", "room": who.room})
        self.store.see(1)
        self.store.keep({"kind": "call", "why": "fall", "room": who.room})
        self.day.prescribe(who.id, "morning", "two white tablets")
        self.day.keep(
            {"kind": "medication", "user": who.id, "round": "morning", "outcome": "taken"}
        )
        self.day.remind("10:30", "the doctor", who.id)
        self.day.keep({"kind": "reminder", "reminder": 1, "outcome": "nobody"})
        self.contacts.add(who.id, "family", "Anna Nilsen", "sip:1@ward.invalid")

    def tables_with(self, who: Resident) -> set[str]:
        """Those that still name the person by number, but for who has moved out."""
        db, found = self.store.db, set()
        for (table,) in db.execute("SELECT name FROM sqlite_master WHERE type = 'table'"):
            columns = {row[1] for row in db.execute(f"PRAGMA table_info({table})")}
            if "resident" in columns and table != "moved_out":
                of = f"SELECT count(*) FROM {table} WHERE resident = ?"
                if db.execute(of, (who.id,)).fetchone()[0]:
                    found.add(table)
        return found


@pytest.fixture
def office(store: Store, clock: Clock) -> Office:
    return Office(store, clock)


@pytest.mark.parametrize("readings", [True, False])
def test_nobody_logs_in_with_the_pin_of_who_has_moved_out(
    office: Office, jack: Resident, readings: bool
) -> None:
    office.moving_out.remove(jack.id, readings=readings)
    for pin in ("1234", ""):
        with pytest.raises(WrongPin):
            office.store.login(12, pin)
    assert office.store.residents() == []
    with pytest.raises(MovedOut):
        office.store.resident(jack.id)
    with pytest.raises(MovedOut):
        office.store.pin_mark(jack.id)
    with pytest.raises(Unknown):
        office.moving_out.remove(jack.id, readings=readings)
    # Whoever comes to live there may have the same PIN, and is somebody else.
    assert office.store.add(12, "Joan Nikora", "1234").id != jack.id


def test_with_the_readings_nothing_is_left_but_a_number(office: Office, jack: Resident) -> None:
    office.has_much_of(jack)
    assert office.tables_with(jack) == {"prescription", "visit", "reminder", "reading", "contact"}
    office.moving_out.remove(jack.id, readings=False)
    assert office.tables_with(jack) == set()
    assert office.moving_out.all() == []
    # One that nobody has seen is still gone to; then nothing is left of it, either.
    (unseen,) = office.store.calls()
    assert (unseen.why, unseen.left) == ("fall", True)
    office.store.see(unseen.id)
    assert office.store.calls() == []


def test_readings_are_kept_with_name_and_room_until_they_are_taken_away(
    office: Office, jack: Resident, clock: Clock
) -> None:
    office.has_much_of(jack)
    office.moving_out.remove(jack.id, readings=True)
    assert office.tables_with(jack) == {"visit", "reading"}
    assert office.moving_out.all() == [Former(jack.id, jack.name, 12, clock.now)]
    # What the robot could not tell before is of them, too.
    office.store.keep({**PRESSURE, "user": jack.id})
    assert len(office.store.readings(jack.id)) == 2
    office.moving_out.take_away(jack.id)
    assert office.tables_with(jack) == set()
    with pytest.raises(MovedOut):
        office.moving_out.take_away(jack.id)


def test_what_the_robot_still_has_of_who_is_gone_is_kept_of_nobody(
    office: Office, jack: Resident
) -> None:
    office.moving_out.remove(jack.id, readings=False)
    with pytest.raises(MovedOut):
        office.store.keep({**PRESSURE, "user": jack.id})
    visit = {"kind": "medication", "user": jack.id, "round": "morning", "outcome": "taken"}
    with pytest.raises(MovedOut):
        office.day.keep(visit)
    with pytest.raises(Unfit):
        office.day.keep({**visit, "user": 99})
    assert office.tables_with(jack) == set()


def test_who_lives_in_the_same_room_keeps_its_calls(office: Office, jack: Resident) -> None:
    office.store.add(12, "Joan Nikora", "2718")
    office.has_much_of(jack)
    office.moving_out.remove(jack.id, readings=False)
    assert len(office.store.calls()) == 2
    assert office.store.login(12, "2718").name == "Joan Nikora"


def test_what_comes_from_the_room_afterwards_is_a_call_as_any(
    office: Office, jack: Resident
) -> None:
    """Of whoever is there by then: the next who lives there, or who cleans the room."""
    office.has_much_of(jack)
    office.moving_out.remove(jack.id, readings=True)
    office.store.add(12, "Joan Nikora", "2718")
    office.store.keep({"kind": "call", "why": "help", "room": 12})
    for one in office.store.calls():
        office.store.see(one.id)
    assert [(one.why, one.left) for one in office.store.calls()] == [("help", False)]


@pytest.mark.parametrize("readings", [True, False])
def test_a_call_that_the_robot_had_still_is_one_of_who_has_moved_out(
    office: Office, jack: Resident, readings: bool
) -> None:
    joan = office.store.add(7, "Joan Nikora", "2718")
    office.moving_out.remove(jack.id, readings=readings)
    for user in (str(jack.id), jack.id, joan.id, "", None, "Jack"):
        office.store.keep({"kind": "call", "why": "help", "room": 12, "user": user})
    assert sorted(one.id for one in office.store.calls() if one.left) == [1, 2]
    for one in office.store.calls():
        office.store.see(one.id)
    assert sorted(one.id for one in office.store.calls()) == [3, 4, 5, 6]


def test_who_lived_together_leaves_no_call_with_the_last_of_them(
    office: Office, jack: Resident
) -> None:
    joan = office.store.add(12, "Joan Nikora", "2718")
    office.has_much_of(jack)
    office.moving_out.remove(jack.id, readings=False)
    assert [one.left for one in office.store.calls()] == [False, False]
    office.moving_out.remove(joan.id, readings=False)
    assert [(one.why, one.left) for one in office.store.calls()] == [("fall", True)]


def test_the_nurse_is_told_that_who_called_has_moved_out(office: Office, jack: Resident) -> None:
    office.has_much_of(jack)
    office.moving_out.remove(jack.id, readings=False)
    told = "who lived there has moved out"

    async def asking(session: aiohttp.ClientSession) -> None:
        await session.get("/", params={"token": "a-visitor"})
        assert told not in await (await session.get("/")).text()
        await session.get("/", params={"token": "a-nurse"})
        assert told in await (await session.get("/")).text()
        ward = await (await session.post("/calls/2")).text()
        assert told not in ward
        assert "Nobody has called." in ward
        # Another nurse's page showed it still.
        assert (await session.post("/calls/2")).status == 200

    over_http(office.store, asking)


def test_no_byte_of_who_is_gone_is_left_in_the_file(tmp_path: Path, clock: Clock) -> None:
    file = tmp_path / "ward.db"
    office = Office(Store(file, clock), clock)
    jack = office.store.add(12, "Jack Nilsen", "1234")
    office.has_much_of(jack)
    assert b"Jack Nilsen" in file.read_bytes()
    office.moving_out.remove(jack.id, readings=False)
    office.store.close()
    for private in (b"Nilsen", b"systolic", b"tablets", b"doctor"):
        assert private not in file.read_bytes()


def test_the_nurse_is_asked_and_chooses_what_becomes_of_the_readings(
    store: Store, jack: Resident
) -> None:
    store.keep({**PRESSURE, "user": jack.id})

    async def asking(session: aiohttp.ClientSession) -> None:
        assert "/residents/1/remove" in await (await session.get("/residents/1")).text()
        asked = await (await session.get("/residents/1/remove")).text()
        assert "Remove Jack &lt;Nilsen&gt;, room 12?" in asked
        assert "1 readings" in asked
        assert "checked" not in asked
        # Without a choice nobody is removed.
        again = await session.post("/residents/1/remove")
        assert (again.url.path, store.residents()) == ("/residents/1/remove", [jack])
        done = await session.post("/residents/1/remove", data={"readings": "keep"})
        ward = await done.text()
        assert (done.url.path, "Nilsen" in ward) == ("/", False)
        assert "/moved-out" in ward
        assert (await session.get("/residents/1")).status == 404
        assert (await session.post("/residents/1/remove", data={"readings": "keep"})).status == 404
        assert "Jack &lt;Nilsen&gt;" in await (await session.get("/moved-out")).text()
        for path in ("/readings.csv", "/residents/1/readings.csv"):
            table = (await (await session.get(path)).read()).decode("utf-8-sig")
            (row,) = csv.DictReader(io.StringIO(table))
            assert (row["room"], row["name"]) == ("12", "Jack <Nilsen>")
        assert "Jack &lt;Nilsen&gt;" in await (await session.get("/moved-out/1")).text()
        assert (await session.post("/moved-out/1")).url.path == "/moved-out"
        assert (await session.get("/moved-out/1")).status == 404
        assert (await session.post("/moved-out/1")).status == 404
        assert (await session.get("/residents/1/readings.csv")).status == 404
        assert "/moved-out" not in await (await session.get("/")).text()

    over_http(store, asking, "a-nurse")
    assert store.readings() == []


def test_of_whom_nothing_was_measured_nothing_is_asked(store: Store, jack: Resident) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        asked = await (await session.get("/residents/1/remove")).text()
        assert 'type="radio"' not in asked
        assert 'type="hidden" name="readings" value="erase"' in asked
        assert (await session.get("/residents/9/remove")).status == 404

    over_http(store, asking, "a-nurse")


@pytest.mark.parametrize("token", ["a-visitor", "guessed", "the-robot"])
def test_nobody_but_a_nurse_removes_anybody(store: Store, jack: Resident, token: str) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        for path in ("/residents/1/remove", "/moved-out", "/moved-out/1"):
            assert (await session.get(path)).status == 403
        for path in ("/residents/1/remove", "/moved-out/1"):
            assert (await session.post(path, data={"readings": "erase"})).status == 403

    over_http(store, asking, token)
    assert store.residents() == [jack]


def test_the_robot_is_told_who_lives_here_no_more(office: Office, jack: Resident) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        async def status(path: str, body: object) -> int:
            return (await session.post(path, json=body, headers=ROBOT)).status

        assert await status("/lives", {"user": jack.id}) == 200
        office.moving_out.remove(jack.id, readings=False)
        assert await status("/lives", {"user": str(jack.id)}) == 410
        assert await status("/lives", {"user": 99}) == 404
        assert await status("/lives", {"user": "Jack"}) == 400
        assert await status("/readings", {"reading": {**PRESSURE, "user": jack.id}}) == 410
        assert (await session.post("/lives", json={"user": 1})).status == 403

    over_http(office.store, asking)
