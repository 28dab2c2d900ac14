"""Two nurses at one form of examples/vitals: neither undoes what the other did without knowing it,
and nobody types anything twice.
"""

from __future__ import annotations

import asyncio
import re
from collections.abc import Mapping
from html import unescape

import aiohttp
import pytest
from aiohttp.test_utils import TestServer
from hypothesis import given
from hypothesis import strategies as st
from playwright.async_api import Browser, Page, async_playwright, expect
from tests.browser.conftest import ARGUMENTS
from tests.vitals.ward import TOKENS, Clock, over_http

from ward_records.day import Day
from ward_records.errors import WrongPin
from ward_records.forms import settle
from ward_records.store import LIMITS, Resident, Store
from ward_records.watching import Watching
from ward_records.web import application

TEXTS = st.sampled_from(["", "a", "b", "c"])


@given(was=TEXTS, now=TEXTS, typed=TEXTS)
def test_a_field_is_what_one_of_them_made_it_and_told_where_both_did(
    was: str, now: str, typed: str
) -> None:
    settled = settle({"what": typed, "what-was": was}, {"what": now})
    if typed == was:
        assert (settled.values, settled.crossed) == ({"what": now}, {})
    elif now in (was, typed):
        assert (settled.values, settled.crossed) == ({"what": typed}, {})
    else:
        assert settled.crossed == {"what": (was, now)}


def fields(page: str, action: str) -> dict[str, str]:
    """What a browser would send from the form with this action, had nobody typed anything."""
    form = re.split(f'action="{action}(?:#[a-z]+)?"', page)[1].partition("</form>")[0]
    inputs = re.findall(r"<input [^>]*>", form)
    found = {}
    for one in inputs:
        name = re.search(r'name="([^"]*)"', one)
        value = re.search(r'value="([^"]*)"', one)
        assert name is not None
        found[name[1]] = unescape(value[1]) if value else ""
    return found


async def page_of(session: aiohttp.ClientSession) -> str:
    return await (await session.get("/residents/1")).text()


def test_limits_of_another_are_told_and_what_was_typed_stays(store: Store, jack: Resident) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        path = "/residents/1"
        mine = theirs = fields(await page_of(session), path)
        await session.post(path, data={**theirs, "systolic_high": "160", "oxygen_low": "90"})
        # Of what I left as it was nothing is undone.
        await session.post(path, data={**mine, "glucose_low": "4.5"})
        assert store.resident(1).limits["systolic_high"] == 160
        late = await session.post(path, data={**mine, "systolic_high": "145", "pulse": "x"})
        shown = await late.text()
        assert late.status == 409
        assert "Systolic, upper limit, mmHg: 150 → 160" in shown
        again = fields(shown, path)
        assert (again["systolic_high"], again["oxygen_low"]) == ("145", "90")
        assert store.resident(1).limits["systolic_high"] == 160
        assert (await session.post(path, data=again)).status == 200

    over_http(store, asking, "a-nurse")
    changed = {"systolic_high": 145, "oxygen_low": 90, "glucose_low": 4.5}
    assert store.resident(1).limits == LIMITS | changed


def test_limits_that_are_none_stand_there_still(store: Store, jack: Resident) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        path = "/residents/1"
        form = {**fields(await page_of(session), path), "systolic_low": "<170>"}
        wrong = await session.post(path, data=form)
        assert wrong.status == 400
        assert fields(await wrong.text(), path)["systolic_low"] == "<170>"

    over_http(store, asking, "a-nurse")


def test_a_name_a_room_and_a_pin_of_another_are_told(store: Store, jack: Resident) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        path = "/residents/1/person"
        before = fields(await page_of(session), path)
        assert "1234" not in before.values()
        await session.post(path, data={**before, "name": "Jack Nilsson", "pin": "1111"})
        # The room is mine, the name hers.
        await session.post(path, data={**before, "room": "14"})
        assert (store.resident(1).name, store.resident(1).room) == ("Jack Nilsson", 14)
        late = await session.post(path, data={**before, "name": "Jim", "pin": "2222"})
        shown = await late.text()
        assert late.status == 409
        assert "Name: Jack &lt;Nilsen&gt; → Jack Nilsson" in shown
        assert "as it is: ••• → •••" in shown
        assert "2222" not in shown
        with pytest.raises(WrongPin):
            store.login(14, "2222")
        again = fields(shown, path)
        assert (again["name"], again["room"]) == ("Jim", "14")
        assert (await session.post(path, data={**again, "pin": "2222"})).status == 200

    over_http(store, asking, "a-nurse")
    assert store.login(14, "2222").name == "Jim"


def test_medicine_of_another_is_told(store: Store, jack: Resident, clock: Clock) -> None:
    day = Day(store.db, clock)
    day.prescribe(jack.id, "morning", "one")

    async def asking(session: aiohttp.ClientSession) -> None:
        path = "/residents/1/medicine"
        before = fields(await page_of(session), path)
        assert (await session.post(path, data={**before, "noon": "a drop"})).status == 200
        # The other one's page is from before: it says nothing of noon that she has changed.
        assert (await session.post(path, data={**before, "evening": "two"})).status == 200
        late = await session.post(path, data={**before, "noon": "three", "morning": "none"})
        shown = await late.text()
        assert (late.status, "Noon: – → a drop" in shown) == (409, True)
        again = fields(shown, path)
        assert [again[name] for name in ("morning", "noon", "evening")] == ["none", "three", "two"]

    over_http(store, asking, "a-nurse", clock=clock)
    given = {one.round: one.what for one in day.medicines(jack.id)}
    assert given == {"morning": "one", "noon": "a drop", "evening": "two"}


def test_what_the_robot_is_to_tell_stands_there_still_where_it_was_not_taken(
    store: Store, jack: Resident
) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        told = {"begins": "soon", "what": "the <doctor>", "whom": "1", "daily": "yes"}
        shown = await (await session.post("/reminders", data=told)).text()
        assert fields(shown, "/reminders")["what"] == "the <doctor>"
        assert '<option value="1" selected>' in shown
        assert 'value="yes" checked' in shown

    over_http(store, asking, "a-nurse")


# -- in a real browser -----------------------------------------------------------------------


async def nurse_of(browser: Browser, ward: str) -> Page:
    page = await browser.new_page(viewport={"width": 1280, "height": 800}, locale="en-GB")
    page.set_default_timeout(10_000)
    await page.goto(f"{ward}/?token={TOKENS.operator}")
    await page.get_by_role("link", name="Jack").click()
    return page


async def saves(page: Page, label: str, typed: Mapping[str, str]) -> None:
    for field, value in typed.items():
        await page.get_by_label(field, exact=True).fill(value)
    await page.get_by_role("button", name=label, exact=True).click()


@pytest.mark.chromium
@pytest.mark.timeout(60)
def test_two_nurses_change_and_one_removes(
    store: Store, jack: Resident, clock: Clock, chromium: str
) -> None:
    store.keep({"kind": "oxygen", "user": jack.id, "oxygen": 97, "pulse": 70})
    made = application(store, Day(store.db, clock), Watching(clock), TOKENS)
    limit = "Systolic, upper limit, mmHg"

    async def run() -> None:
        async with TestServer(made) as server, async_playwright() as playwright:
            browser = await playwright.chromium.launch(executable_path=chromium, args=ARGUMENTS)
            try:
                ward = str(server.make_url("")).rstrip("/")
                mine, hers = await nurse_of(browser, ward), await nurse_of(browser, ward)
                await saves(hers, "Save", {limit: "160"})
                await saves(hers, "Save resident", {"Room": "14"})
                await expect(hers.get_by_text("Room 14")).to_be_visible()
                await saves(mine, "Save", {limit: "145", "Oxygen, lower limit, %": "90"})
                told = mine.get_by_role("alert")
                await expect(told).to_contain_text(f"{limit}: 150 → 160")
                # Not far below what she sees.
                await expect(told).to_be_in_viewport()
                await expect(mine.get_by_label(limit)).to_have_value("145")
                await saves(mine, "Save", {})
                await expect(mine.get_by_role("alert")).to_have_count(0)
                assert store.resident(1).limits["systolic_high"] == 145
                await mine.get_by_role("link", name="Remove this resident").click()
                remove = mine.get_by_role("button", name="Remove Jack")
                # Her browser asks for the choice.
                await remove.click()
                await expect(remove).to_be_visible()
                assert len(store.residents()) == 1
                await mine.get_by_label("Take them away now").check()
                await remove.click()
                await expect(mine.get_by_role("heading", name="Ward")).to_be_visible()
                assert (store.residents(), store.readings()) == ([], [])
            finally:
                await browser.close()

    asyncio.run(run())
