"""Whom residents may call, over HTTP.

======================================  =====================================================
``POST /contacts`` {user, group,        {contacts: [{id, name, said, address}, …]}, for the robot:
language}                               the voice of the language has the name ``said``; 404: no
                                        such resident
``POST /residents/ID/contacts``         one more, from the form on her page
``POST /residents/ID/contacts/C/remove``  one less; ``GET`` asks whether
======================================  =====================================================

The forms are for operators only.
"""

from __future__ import annotations

from collections.abc import Callable

from aiohttp import web

from ward_records import contacts_page
from ward_records.access import Tokens
from ward_records.answers import refused, shown
from ward_records.contacts import GROUPS, Contacts
from ward_records.errors import Unfit, Unknown
from ward_records.forms import Entry, not_taken, texts
from ward_records.language import why
from ward_records.names import said
from ward_records.store import Store, number_in

_FIELDS = ("group", "contact", "address", "contact-kana")


class ContactsWeb:
    """resident: her page, with the contact that was not taken."""

    def __init__(
        self,
        store: Store,
        contacts: Contacts,
        tokens: Tokens,
        resident: Callable[[int, Entry], web.Response],
    ) -> None:
        self._store = store
        self._contacts = contacts
        self._tokens = tokens
        self._resident = resident

    def add_to(self, router: web.UrlDispatcher) -> None:
        router.add_post("/contacts", self._asked)
        router.add_post("/residents/{id:[0-9]{1,9}}/contacts", self._add)
        one = "/residents/{id:[0-9]{1,9}}/contacts/{one:[0-9]{1,9}}/remove"
        router.add_get(one, self._ask)
        router.add_post(one, self._remove)

    def form(self, number: int, entry: Entry) -> str:
        """Raises Unknown."""
        those = {group: self._contacts.of(number, group) for group in GROUPS}
        return contacts_page.form(number, those, entry)

    async def _asked(self, request: web.Request) -> web.Response:
        asked = await self._tokens.asked(request)
        who, group = number_in(asked.get("user")), asked.get("group")
        if who is None or not who.is_integer() or not isinstance(group, str):
            return refused(400, "user must be the id that login gave, and group a text")
        try:
            found = self._contacts.of(int(who), group)
        except Unknown as unknown:
            return refused(404, str(unknown))
        language = str(asked.get("language"))
        told = [
            {
                "id": one.id,
                "name": one.name,
                "said": said(one.name, one.kana, language),
                "address": one.address,
            }
            for one in found
        ]
        return web.json_response({"contacts": told})

    async def _add(self, request: web.Request) -> web.Response:
        self._tokens.must_be_operator(request)
        number, form = int(request.match_info["id"]), await texts(request)
        given = {field: form.get(field, "") for field in _FIELDS}
        try:
            self._contacts.add(number, *given.values())
        except Unfit as unfit:
            return self._resident(number, not_taken(given, why(unfit), "Not added: {0}"))
        except Unknown as unknown:
            raise web.HTTPNotFound(text=str(unknown)) from None
        raise web.HTTPSeeOther(f"/residents/{number}")

    async def _ask(self, request: web.Request) -> web.Response:
        self._tokens.must_be_operator(request)
        number, wanted = int(request.match_info["id"]), int(request.match_info["one"])
        try:
            resident = self._store.resident(number)
        except Unknown as unknown:
            raise web.HTTPNotFound(text=str(unknown)) from None
        for one in (each for group in GROUPS for each in self._contacts.of(number, group)):
            if one.id == wanted:
                return shown(contacts_page.remove(resident, one))
        raise web.HTTPSeeOther(f"/residents/{number}#contacts")

    async def _remove(self, request: web.Request) -> web.Response:
        self._tokens.must_be_operator(request)
        number = int(request.match_info["id"])
        self._contacts.remove(number, int(request.match_info["one"]))
        raise web.HTTPSeeOther(f"/residents/{number}")
