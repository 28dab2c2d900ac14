"""The nurse's page: who lives here, what was measured, in her language; and nothing for others."""

from __future__ import annotations

import ast
import asyncio
import csv
import io
import re
from datetime import timedelta
from pathlib import Path

import aiohttp
import pytest
from tests.vitals.ward import NOW, over_http

from ward_records import contacts_page, curves, day_page, page, residents_page
from ward_records.errors import Unfit, Unknown, WrongPin
from ward_records.japanese import JAPANESE
from ward_records.language import speak, wanted
from ward_records.store import LIMITS, Reading, Resident, Store

VITALS = Path(__file__).resolve().parents[2] / "examples" / "vitals"


# -- who lives here ------------------------------------------------------------------


def test_a_resident_gets_another_name_room_and_pin(store: Store, jack: Resident) -> None:
    store.change(jack.id, 14, "Jack Nilsen", None)
    assert store.login(14, "1234").name == "Jack Nilsen"
    store.change(jack.id, 14, "Jack Nilsen", "4321")
    assert store.login(14, "4321").id == jack.id
    with pytest.raises(WrongPin):
        store.login(14, "1234")
    with pytest.raises(Unknown):
        store.change(99, 1, "Nobody", None)


def test_nobody_moves_in_with_a_pin_that_may_be_anothers(store: Store, jack: Resident) -> None:
    other = store.add(7, "Joan Nikora", "1234")
    for pin in (None, "1234"):
        with pytest.raises(Unfit):
            store.change(other.id, 12, "Joan Nikora", pin)
    assert store.resident(other.id) == other
    store.change(other.id, 12, "Joan Nikora", "2718")
    assert (store.login(12, "1234").id, store.login(12, "2718").id) == (jack.id, other.id)
    # Her own PIN is free to be given to her again.
    store.change(other.id, 12, "Joan Nikora", "2718")


@pytest.mark.parametrize("name", ["", "  ", "x" * 81])
def test_nobody_is_without_a_name(store: Store, jack: Resident, name: str) -> None:
    with pytest.raises(Unfit):
        store.add(1, name, "1234")
    with pytest.raises(Unfit):
        store.change(jack.id, 12, name, None)
    assert store.residents() == [jack]


def test_the_nurse_adds_and_changes_residents_by_forms(store: Store, jack: Resident) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        assert 'name="pin"' in await (await session.get("/residents")).text()
        bea = {"name": "Bea <Lee>", "room": "12", "pin": "1234"}
        answer = await session.post("/residents", data=bea)
        said = await answer.text()
        assert answer.status == 400
        assert "somebody in this room has this PIN already" in said
        # What was typed is still there, but for the PIN.
        assert 'value="Bea &lt;Lee&gt;"' in said
        assert "1234" not in said
        answer = await session.post("/residents", data={**bea, "pin": "4321"})
        assert (answer.status, answer.url.path) == (200, "/residents/2")
        answer = await session.post("/residents/2/person", data={**bea, "room": "1O", "pin": ""})
        assert answer.status == 400
        assert "the room must be a number" in await answer.text()
        answer = await session.post("/residents/2/person", data={**bea, "room": "9", "pin": ""})
        assert answer.status == 200
        assert (await session.post("/residents/9/person", data=bea)).status == 404

    over_http(store, asking, "a-nurse")
    assert [(one.name, one.room) for one in store.residents()] == [
        ("Bea <Lee>", 9),
        ("Jack <Nilsen>", 12),
    ]
    assert store.login(9, "4321").id == 2


@pytest.mark.parametrize(
    "headers",
    [
        {"Origin": "http://127.0.0.1:8080"},
        {"Origin": "null"},
        {"Sec-Fetch-Site": "same-site"},
        {"Sec-Fetch-Site": "cross-site"},
    ],
)
def test_a_form_of_another_page_changes_nothing(
    store: Store, jack: Resident, headers: dict[str, str]
) -> None:
    """Another port of the same machine, the robot's screen, is the same site to a cookie."""

    async def asking(session: aiohttp.ClientSession) -> None:
        person = {"name": "Eve", "room": "12", "pin": "6666"}
        for path, data in (
            ("/residents", person),
            ("/residents/1/person", person),
            ("/residents/1", {name: str(value) for name, value in LIMITS.items()}),
        ):
            assert (await session.post(path, data=data, headers=headers)).status == 403
        here = str((await session.get("/")).url.origin())
        own = {"Origin": here, "Sec-Fetch-Site": "same-origin"}
        assert (await session.post("/residents", data=person, headers=own)).status == 200
        # A proxy that speaks TLS to the nurse's browser, and HTTP to the records.
        own = {"Origin": "https://ward.example", "Sec-Fetch-Site": "same-origin"}
        other = person | {"room": "13"}
        assert (await session.post("/residents", data=other, headers=own)).status == 200

    over_http(store, asking, "a-nurse")
    assert [one.name for one in store.residents()] == ["Jack <Nilsen>", "Eve", "Eve"]


@pytest.mark.parametrize("token", ["a-visitor", "guessed", "the-robot"])
def test_nobody_else_sees_a_form_a_curve_or_a_table_or_changes_anybody(
    store: Store, jack: Resident, token: str
) -> None:
    measure(store, jack, 3)

    async def asking(session: aiohttp.ClientSession) -> None:
        for path in ("/residents", "/readings.csv", "/residents/1/readings.csv"):
            assert (await session.get(path)).status == 403
        person = {"name": "Eve", "room": "12", "pin": "6666"}
        for path in ("/residents", "/residents/1/person"):
            assert (await session.post(path, data=person)).status == 403
        shown = await (await session.get("/residents/1")).text()
        for private in ("<svg", '<form method="post"', "csv", "Nilsen"):
            assert private not in shown

    over_http(store, asking, token)
    assert store.residents() == [jack]


# -- what was measured ---------------------------------------------------------------


def measure(store: Store, who: Resident, times: int) -> None:
    for at in range(times):
        told = {"systolic": 120 + at, "diastolic": 80, "pulse": 70}
        store.keep({"kind": "pressure", "user": who.id, **told})


def points(drawn: str) -> list[tuple[float, float]]:
    line = re.search(r'class="line" d="M([^"]+)"', drawn)
    assert line is not None
    return [(float(x), float(y)) for x, y in (one.split() for one in line[1].split(" L"))]


def readings(*systolic: float) -> list[Reading]:
    """The newest first."""
    return [
        Reading(1, NOW - timedelta(hours=at), "pressure", {"systolic": one, "diastolic": 80.0})
        for at, one in enumerate(systolic)
    ]


def test_a_curve_has_the_last_30_readings_from_left_to_right_and_up() -> None:
    drawn = curves.curve("pressure", "P", readings(*range(160, 100, -1)), LIMITS, "")
    found = points(drawn)
    assert len(found) == 30
    assert found == sorted(found, key=lambda one: one[0])
    assert [y for _, y in found] == sorted((y for _, y in found), reverse=True)
    assert all(0 <= x <= 100 and 0 <= y <= 100 for x, y in found)
    # Those above 150, each as a point of its own.
    assert drawn.count("point outside") == 10
    assert drawn.count('class="limit"') == 4
    assert "style=" not in drawn


def test_one_reading_is_no_curve_and_equal_ones_are_a_line() -> None:
    assert curves.curve("pressure", "P", readings(120), LIMITS, "") == ""
    first, second = points(curves.curve("pressure", "P", readings(120, 120), {}, ""))
    assert first[1] == second[1]


def test_the_page_has_a_curve_of_each_kind_that_was_measured_twice(
    store: Store, jack: Resident
) -> None:
    measure(store, jack, 40)
    store.keep({"kind": "oxygen", "user": jack.id, "oxygen": 97, "pulse": 70})

    async def asking(session: aiohttp.ClientSession) -> None:
        shown = await (await session.get("/residents/1")).text()
        assert re.findall(r'id="(curve-\w+)"', shown) == ["curve-pressure"]
        assert 'aria-label="Blood pressure: 30 readings, the last one 159 / 80"' in shown
        assert "<script" not in shown

    over_http(store, asking, "a-nurse")


def test_all_readings_are_taken_away_as_a_table(store: Store, jack: Resident) -> None:
    measure(store, jack, 2)
    formula = store.add(3, "=1+1", "1111")
    store.keep({"kind": "glucose", "user": formula.id, "glucose": 5.5})

    async def asking(session: aiohttp.ClientSession) -> None:
        answer = await session.get("/readings.csv")
        assert answer.headers["Content-Disposition"] == 'attachment; filename="readings.csv"'
        body = await answer.read()
        assert body.startswith(b"\xef\xbb\xbf")
        rows = list(csv.DictReader(io.StringIO(body.decode("utf-8-sig"))))
        assert [(one["room"], one["systolic"], one["glucose"]) for one in rows] == [
            ("12", "120", ""),
            ("12", "121", ""),
            ("3", "", "5.5"),
        ]
        assert rows[0]["name"] == "Jack <Nilsen>"
        # No spreadsheet takes a name for a formula.
        assert rows[2]["name"] == "'=1+1"
        own = await (await session.get("/residents/2/readings.csv")).text()
        assert own.count("\n") == 2
        assert (await session.get("/residents/9/readings.csv")).status == 404

    over_http(store, asking, "a-nurse")


def test_a_form_that_was_taken_says_so(store: Store, jack: Resident) -> None:
    page = f"/residents/{jack.id}"
    limits = {name: f"{value:g}" for name, value in jack.limits.items()}

    async def asking(session: aiohttp.ClientSession) -> None:
        assert "Saved." not in await (await session.get(page)).text()
        for path, data in (
            (page, limits),
            (f"{page}/medicine", {"morning": "one tablet"}),
            (f"{page}/person", {"name": "Jack", "room": "12"}),
        ):
            told = await (await session.post(path, data=data)).text()
            assert told.count("Saved.") == 1
        wrong = await (await session.post(page, data={})).text()
        assert ("Saved." in wrong, "Not saved" in wrong) == (False, True)

    over_http(store, asking, "a-nurse")


# -- in her language -----------------------------------------------------------------


@pytest.mark.parametrize(
    ("accept", "language"),
    [
        ("ja", "ja"),
        ("ja-JP,ja;q=0.9,en;q=0.8", "ja"),
        ("en-GB,en;q=0.9,ja;q=0.8", "en"),
        ("de, ja;q=0.5", "ja"),
        ("en;q=0.1, ja;q=0.9", "ja"),
        ("ja;q=0, de", "en"),
        ("fr", "en"),
        ("", "en"),
        ("ja;q=x,;;,", "en"),
    ],
)
def test_the_language_is_what_the_browser_asks_for_first(accept: str, language: str) -> None:
    assert wanted(accept) == language


def test_the_page_is_japanese_where_the_browser_asks_for_it(store: Store, jack: Resident) -> None:
    measure(store, jack, 2)
    store.keep({"kind": "call", "why": "fall", "room": 12})

    async def asking(session: aiohttp.ClientSession) -> None:
        ward = await (await session.get("/")).text()
        assert '<html lang="ja">' in ward
        assert "12号室</strong>: 転倒, " in ward
        assert ">5月4日 " in ward
        refused = await session.post("/residents", data={"name": "A", "room": "12", "pin": "1"})
        assert "保存できませんでした：暗証番号は数字4桁です" in await refused.text()
        wrong = {name: str(value) for name, value in LIMITS.items()} | {"systolic_low": "170"}
        limits = await session.post("/residents/1", data=wrong)
        assert "最高血圧：下限は上限より低く、40から300までです" in await limits.text()
        english = await session.get("/", headers={"Accept-Language": "en"})
        assert "room 12</strong>: fall" in await english.text()

    over_http(store, asking, "a-nurse", speaks="ja-JP,en;q=0.5")


def test_every_text_of_the_page_has_a_japanese_one() -> None:
    """Those said by name and from tables, what is wrong, and why the robot calls."""
    texts: set[str] = set()
    for file in (VITALS / "ward_records").glob("*.py"):
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.args:
                given = [str(one.value) for one in node.args if isinstance(one, ast.Constant)]
                heads = [one for one in node.args if isinstance(one, ast.Tuple)]
                if node.func.id == "say":
                    texts.update(given)
                elif node.func.id == "table":
                    texts.update(
                        str(one.value)
                        for each in heads
                        for one in each.elts
                        if isinstance(one, ast.Constant)
                    )
    for table in (
        page.LABELS,
        page._KINDS,
        day_page.ROUND,
        residents_page.LABELS,
        day_page._OUTCOME,
        contacts_page._GROUPS,
    ):
        texts.update(table.values())
    calls = "".join(one.read_text("utf-8") for one in VITALS.glob("*.rbd.xml"))
    texts.update(one for one in re.findall(r'"(?:why|room)": "([^"{]+)"', calls))
    texts -= {""}
    assert len(texts) > 60
    assert sorted(texts - JAPANESE.keys()) == []
    for english, japanese in JAPANESE.items():
        assert re.findall(r"\{\d\}", english) == sorted(re.findall(r"\{\d\}", japanese)), english


def test_a_language_is_of_one_request() -> None:
    async def other() -> None:
        speak("ja")

    async def run() -> str:
        speak("en")
        await asyncio.create_task(other())
        return page.entrance()

    assert "Your token" in asyncio.run(run())
