"""Whom residents may call, over HTTP.

======================================  =====================================================
``POST /contacts`` {user, group,        {contacts: [{id, name, said, address}, …]}, for the robot:
language}                               the voice of the language has the name ``said``; 404: no
                                        such resident
``POST /residents/ID/contacts``         one more, from the form on her page
``POST /residents/ID/contacts/C/remove``  one less
======================================  =====================================================

The forms are for operators only.
"""

from __future__ import annotations

from collections.abc import Callable

from aiohttp import web

from ward_records import contacts_page
from ward_records.access import Tokens
from ward_records.answers import refused
from ward_records.contacts import GROUPS, Contacts
from ward_records.errors import Unfit, Unknown
from ward_records.forms import Entry, not_taken, texts
from ward_records.language import why
from ward_records.names import said
from ward_records.store import number_in

_FIELDS = ("group", "contact", "address", "contact-kana")


class ContactsWeb:
    """resident: her page, with the contact that was not taken."""

    def __init__(
        self,
        contacts: Contacts,
        tokens: Tokens,
        resident: Callable[[int, Entry], web.Response],
    ) -> None:
        self._contacts = contacts
        self._tokens = tokens
        self._resident = resident

    def add_to(self, router: web.UrlDispatcher) -> None:
        router.add_post("/contacts", self._asked)
        router.add_post("/residents/{id:[0-9]{1,9}}/contacts", self._add)
        router.add_post("/residents/{id:[0-9]{1,9}}/contacts/{one:[0-9]{1,9}}/remove", self._remove)

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

    async def _remove(self, request: web.Request) -> web.Response:
        self._tokens.must_be_operator(request)
        number = int(request.match_info["id"])
        self._contacts.remove(number, int(request.match_info["one"]))
        raise web.HTTPSeeOther(f"/residents/{number}")
