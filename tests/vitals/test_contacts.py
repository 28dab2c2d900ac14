"""Whom residents of examples/vitals may call: asked by the robot, changed by the nurse."""

from __future__ import annotations

import aiohttp
import pytest
from tests.vitals.ward import ROBOT, over_http

from ward_records.contacts import Contacts
from ward_records.errors import Unfit, Unknown
from ward_records.store import Resident, Store

ANNA = {"contact": "Anna <Nilsen>", "group": "family", "address": "sip:anna@ward.invalid"}


def test_each_resident_has_contacts_of_her_own(store: Store, jack: Resident) -> None:
    other, contacts = store.add(7, "Joan Nikora", "2718"), Contacts(store)
    contacts.add(jack.id, "family", "Anna Nilsen", "sip:1@ward.invalid")
    contacts.add(jack.id, "friends", "Bob Hart", "+644123")
    contacts.add(other.id, "family", "Mere Nikora", "sip:3@ward.invalid")
    assert [one.name for one in contacts.of(jack.id, "family")] == ["Anna Nilsen"]
    assert contacts.of(other.id, "friends") == []
    (mere,) = contacts.of(other.id, "family")
    contacts.remove(jack.id, mere.id)
    assert contacts.of(other.id, "family") == [mere]
    contacts.remove(other.id, mere.id)
    assert contacts.of(other.id, "family") == []
    with pytest.raises(Unknown):
        contacts.of(99, "family")


@pytest.mark.parametrize(
    ("group", "name", "address"),
    [
        ("strangers", "Eve", "sip:eve@ward.invalid"),
        ("family", "", "sip:eve@ward.invalid"),
        ("family", "Eve", ""),
        ("family", "Eve", "--help"),
        ("family", "Eve", "two words"),
        ("family", "Eve", "sip:eve\0"),
        ("family", "Eve", "sip:\u202eeve"),
        ("family", "Eve", "e" * 201),
    ],
)
def test_nobody_is_added_who_can_not_be_called(
    store: Store, jack: Resident, group: str, name: str, address: str
) -> None:
    contacts = Contacts(store)
    with pytest.raises(Unfit):
        contacts.add(jack.id, group, name, address)
    with pytest.raises(Unknown):
        contacts.add(99, "family", "Anna", "sip:1@ward.invalid")
    assert contacts.of(jack.id, "family") == []


def test_before_a_contact_is_removed_the_nurse_is_asked(store: Store, jack: Resident) -> None:
    Contacts(store).add(jack.id, "family", "Anna <Nilsen>", "sip:1@ward.invalid")

    async def asking(session: aiohttp.ClientSession) -> None:
        one = f"/residents/{jack.id}/contacts/1/remove"
        assert f'href="{one}"' in await (await session.get(f"/residents/{jack.id}")).text()
        asked = await (await session.get(one)).text()
        assert "Remove Anna &lt;Nilsen&gt;?" in asked
        assert "sip:1@ward.invalid" in asked
        assert f'action="{one}#contacts"' in asked
        # Nothing has happened yet; one who is there no more is not asked about.
        assert len(Contacts(store).of(jack.id, "family")) == 1
        gone = await session.get(f"/residents/{jack.id}/contacts/2/remove")
        assert gone.url.path == f"/residents/{jack.id}"
        assert (await session.get("/residents/9/contacts/1/remove")).status == 404

    over_http(store, asking, "a-nurse")


def test_nobody_s_name_is_translated(store: Store) -> None:
    someone = store.add(12, "Name", "1234")
    Contacts(store).add(someone.id, "family", "Friends", "sip:1@ward.invalid")

    async def asking(session: aiohttp.ClientSession) -> None:
        asked = await session.get(f"/residents/{someone.id}/contacts/1/remove")
        told = await asked.text()
        assert ">Name</a>" in told
        assert "「Friends」を削除しますか。" in told

    over_http(store, asking, "a-nurse", speaks="ja")


def test_the_robot_may_call_whom_the_nurse_has_added(store: Store, jack: Resident) -> None:
    async def asking(session: aiohttp.ClientSession) -> None:
        page = f"/residents/{jack.id}"
        wrong = await session.post(f"{page}/contacts", data=ANNA | {"address": "-x"})
        assert wrong.status == 400
        told = await wrong.text()
        assert "Not added: an address has no blanks" in told
        assert 'value="Anna &lt;Nilsen&gt;"' in told
        added = await session.post(f"{page}/contacts", data=ANNA)
        assert "Anna &lt;Nilsen&gt;" in await added.text()
        asked = {"user": str(jack.id), "group": "family"}
        answer = await session.post("/contacts", json=asked, headers=ROBOT)
        name = ANNA["contact"]
        anna = {"id": 1, "name": name, "said": name, "address": ANNA["address"]}
        assert await answer.json() == {"contacts": [anna]}
        removed = await session.post(f"{page}/contacts/1/remove")
        assert "Anna &lt;Nilsen&gt;" not in await removed.text()
        assert (await session.post("/residents/99/contacts", data=ANNA)).status == 404

    over_http(store, asking, "a-nurse")


@pytest.mark.parametrize("token", ["a-visitor", "the-robot"])
def test_nobody_else_changes_or_sees_whom_somebody_may_call(
    store: Store, jack: Resident, token: str
) -> None:
    Contacts(store).add(jack.id, "family", "Anna", "sip:1@ward.invalid")

    async def asking(session: aiohttp.ClientSession) -> None:
        page = f"/residents/{jack.id}"
        assert "Anna" not in await (await session.get(page)).text()
        assert (await session.post(f"{page}/contacts", data=ANNA)).status == 403
        assert (await session.post(f"{page}/contacts/1/remove")).status == 403
        assert (await session.get(f"{page}/contacts/1/remove")).status == 403

    over_http(store, asking, token)
    assert len(Contacts(store).of(jack.id, "family")) == 1
