"""Names in the records of examples/vitals, and how the robot says them."""

from __future__ import annotations

import re
import sqlite3
from pathlib import Path
from typing import Any

import aiohttp
import pytest
from tests.vitals.ward import ROBOT, Clock, over_http

from ward_records.contacts import Contacts
from ward_records.errors import Unfit
from ward_records.names import as_kana, latin, must_be_a_name, said
from ward_records.store import Resident, Store

HARU = {"name": "木村はる", "room": "21", "pin": "2121"}


@pytest.mark.parametrize(
    ("name", "kana"),
    [
        ("木村はる", ""),
        ("佐々木", ""),
        ("𠮷田", ""),
        ("木村はる", "木村はる"),
        ("木村はる", "Kimura"),
        ("木村はる", "ー・ー"),
        ("木村はる", "き" * 81),
        ("Jack", "123"),
        ("", "きむら"),
        ("き" * 81, ""),
    ],
)
def test_a_name_in_kanji_needs_kana_and_kana_is_nothing_else(name: str, kana: str) -> None:
    with pytest.raises(Unfit):
        must_be_a_name(name, as_kana(kana))


@pytest.mark.parametrize(
    ("name", "kana", "kept"),
    [
        ("木村はる", " きむら　はる ", "きむら はる"),
        ("木村はる", "ｷﾑﾗ", "キムラ"),
        ("はる", "", ""),
        ("Jack Nilsen", "", ""),
        ("Jack Nilsen", "ジャック・ニルセン", "ジャック・ニルセン"),
    ],
)
def test_kana_is_kept_as_it_is_usual(name: str, kana: str, kept: str) -> None:
    assert as_kana(kana) == kept
    must_be_a_name(name, kept)


@pytest.mark.parametrize(
    ("name", "kana", "japanese", "english"),
    [
        ("木村はる", "きむら はる", "きむら はる", "Kimura Haru"),
        ("はる", "", "はる", "Haru"),
        ("Jack Nilsen", "", "Jack Nilsen", "Jack Nilsen"),
        ("Jack Nilsen", "ジャック", "ジャック", "Jack Nilsen"),
        ("Zoë", "", "Zoë", "Zoë"),
        # From records of before: nothing better is known.
        ("木村", "", "木村", "木村"),
    ],
)
def test_a_voice_is_given_what_it_can_say(
    name: str, kana: str, japanese: str, english: str
) -> None:
    assert (said(name, kana, "ja"), said(name, kana, "en")) == (japanese, english)


@pytest.mark.parametrize(
    ("kana", "written"),
    [
        ("しんじ つちや", "Shinji Tsuchiya"),
        ("りょうこ", "Ryouko"),
        ("ジャック・ニルセン", "Jakku Nirusen"),
        ("はっちょう", "Hatchou"),
        ("しゅん ちょう じゅん", "Shun Chou Jun"),
        ("ふみ", "Fumi"),
        ("ユーコ", "Yuko"),
        ("ティナ ファン ウィン ヴァン", "Tina Fan Win Van"),
        ("ジェーン シェリー チェン", "Jen Sheri Chen"),
        ("デュポン ドゥーガル トゥイ テューダー", "Dupon Dugaru Tui Tuda"),
        ("フュー レヴュー イェンセン", "Fyu Revyu Yensen"),
        ("クォン グェン", "Kwon Gwen"),
        # Kana of full size are letters of their own.
        ("とうこ いえ", "Touko Ie"),
        ("あっ", "A"),
        ("ゃ ぃ", "Ya I"),
    ],
)
def test_kana_is_written_in_latin_letters(kana: str, written: str) -> None:
    assert latin(kana) == written


def test_the_nurse_is_asked_for_kana_where_a_name_needs_it(store: Store) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        assert 'name="kana"' not in await (await session.get("/residents")).text()
        asked = await session.post("/residents", data=HARU)
        told = await asked.text()
        assert asked.status == 400
        assert "the robot can not read 木村" in told
        assert 'name="kana"' in told
        assert 'value="木村はる"' in told
        made = await session.post("/residents", data=HARU | {"kana": "きむら　はる"})
        assert made.url.path == "/residents/1"
        assert 'value="きむら はる"' in await made.text()
        # It is hers until somebody types another.
        changed = {"name": "木村ゆき", "room": "21", "kana": "ゆき-"}
        wrong = await session.post("/residents/1/person", data=changed)
        assert (wrong.status, "ゆき-" in await wrong.text()) == (400, True)
        assert (await session.post("/residents/1/person", data=HARU)).status == 400
        await session.post("/residents/1/person", data=changed | {"kana": "きむら ゆき"})
        (haru,) = store.residents()
        assert (haru.name, haru.kana) == ("木村ゆき", "きむら ゆき")

    over_http(store, asking, "a-nurse")


def test_a_name_that_is_in_kanji_no_more_needs_no_kana(store: Store) -> None:
    store.add(21, "木村はる", "2121", "きむら はる")

    async def asking(session: aiohttp.ClientSession) -> None:
        page = await (await session.get("/residents/1")).text()
        (field,) = re.findall(r'<input id="kana"[^>]*>', page)
        # The browser would let nobody send the form with this field emptied.
        assert "required" not in field
        changed = {"name": "Haru Kimura", "room": "21", "kana": ""}
        assert (await session.post("/residents/1/person", data=changed)).status == 200
        (haru,) = store.residents()
        assert (haru.name, haru.kana) == ("Haru Kimura", "")

    over_http(store, asking, "a-nurse")


def test_where_names_are_japanese_kana_is_asked_for_from_the_first(
    store: Store, jack: Resident
) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        for page in ("/residents", f"/residents/{jack.id}"):
            assert "お名前の読み（かな）" in await (await session.get(page)).text()
        told = await (await session.post("/residents", data=HARU)).text()
        assert "ロボットは「木村」を読めません" in told

    over_http(store, asking, "a-nurse", speaks="ja")


def test_the_robot_is_told_how_a_name_is_said_in_its_language(store: Store) -> None:
    haru = store.add(21, "木村はる", "2121", "きむら はる")
    Contacts(store).add(haru.id, "family", "木村ゆき", "sip:1@ward.invalid", "きむら ゆき")

    async def asking(session: aiohttp.ClientSession) -> None:
        async def ask(path: str, body: dict[str, Any]) -> Any:
            return await (await session.post(path, json=body, headers=ROBOT)).json()

        for language, first, second in (
            ("ja", "きむら はる", "きむら ゆき"),
            ("en", "Kimura Haru", "Kimura Yuki"),
        ):
            user = await ask("/login", {"room": 21, "pin": "2121", "language": language})
            assert (user["user"]["name"], user["user"]["said"]) == ("木村はる", first)
            asked = {"user": haru.id, "group": "family", "language": language}
            (contact,) = (await ask("/contacts", asked))["contacts"]
            assert (contact["name"], contact["said"]) == ("木村ゆき", second)

    over_http(store, asking)


def test_a_contact_in_kanji_needs_kana_too(store: Store, jack: Resident) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        page = f"/residents/{jack.id}/contacts"
        given = {"group": "family", "contact": "佐藤ふみ", "address": "sip:1@ward.invalid"}
        wrong = await session.post(page, data=given)
        told = await wrong.text()
        assert (wrong.status, 'name="contact-kana"' in told) == (400, True)
        assert (await session.post(page, data=given | {"contact-kana": "さとう"})).status == 200

    over_http(store, asking, "a-nurse")
    (fumi,) = Contacts(store).of(jack.id, "family")
    assert (fumi.name, fumi.kana) == ("佐藤ふみ", "さとう")


def test_records_of_an_earlier_version_are_opened(tmp_path: Path, clock: Clock) -> None:
    file = tmp_path / "ward.db"
    old = sqlite3.connect(file)
    old.executescript(
        "CREATE TABLE resident (id INTEGER PRIMARY KEY, room INTEGER NOT NULL, name TEXT NOT NULL,"
        " salt BLOB NOT NULL, pin BLOB NOT NULL, limits TEXT NOT NULL);"
        "CREATE TABLE contact (id INTEGER PRIMARY KEY, resident INTEGER NOT NULL,"
        " kind TEXT NOT NULL, name TEXT NOT NULL, address TEXT NOT NULL);"
        "INSERT INTO resident VALUES (1, 21, '木村はる', x'', x'', '{}');"
        "INSERT INTO contact VALUES (1, 1, 'family', '木村ゆき', 'sip:1@ward.invalid');"
    )
    old.close()
    for _ in range(2):
        store = Store(file, clock)
        assert [(one.name, one.kana) for one in store.residents()] == [("木村はる", "")]
        assert [one.kana for one in Contacts(store).of(1, "family")] == [""]
        store.close()
