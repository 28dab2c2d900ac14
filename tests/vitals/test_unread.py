"""What the robot of examples/vitals can not read of what a nurse types is told to her."""

from __future__ import annotations

import aiohttp
import pytest
from tests.vitals.ward import over_http

from ward_records.__main__ import MEDICINE, TOLD
from ward_records.store import Resident, Store
from ward_records.unread import told, unread


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("two tablets, with water", []),
        ("おくすりを ふたつ", []),
        ("青い錠剤を二錠、青い", ["青", "錠剤", "二錠"]),
        ("青い（あおい）錠剤（じょうざい）を2つ", []),
        ("白い粉", []),
    ],
)
def test_it_is_what_neither_it_nor_the_project_says_how_to_say(text: str, found: list[str]) -> None:
    assert unread(text, {"白い": "しろい", "粉": "こな"}) == found


def test_the_nurse_is_told_of_medicine_and_of_messages(store: Store, jack: Resident) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        async def given(path: str, **data: str) -> str:
            return await (await session.post(path, data=data)).text()

        medicine = f"/residents/{jack.id}/medicine"
        assert "can not read" not in await given(medicine, morning="one <b>tablet</b>")
        kept = await given(medicine, morning="鼈甲を")
        # It is kept all the same: another voice may read it.
        assert "Saved." in kept
        assert "The robot can not read 鼈甲: type behind it" in kept
        assert "can not read" not in await given(medicine, morning="鼈甲（べっこう）を")
        message = {"begins": "10:30", "what": "鼈甲です", "whom": ""}
        assert "10:30: The robot can not read 鼈甲" in await given("/reminders", **message)

    over_http(store, asking, "a-nurse")


def test_what_the_example_begins_with_can_be_read() -> None:
    assert [what for *_, what in (*MEDICINE, *TOLD) if told(what)] == []


def test_on_a_japanese_page_it_is_told_in_japanese(store: Store, jack: Resident) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        kept = await session.post(f"/residents/{jack.id}/medicine", data={"noon": "鼈甲"})
        assert "ロボットは鼈甲を読めません。" in await kept.text()

    over_http(store, asking, "a-nurse", speaks="ja")


def test_who_sees_nothing_private_is_told_nothing_of_it(store: Store) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        await session.get("/", params={"token": "a-nurse"})
        message = {"begins": "10:30", "what": "鼈甲です", "whom": ""}
        await session.post("/reminders", data=message)
        await session.get("/", params={"token": "a-visitor"})
        shown = await (await session.get("/today")).text()
        assert ("鼈甲です" in shown, "can not read" in shown) == (True, False)

    over_http(store, asking)
