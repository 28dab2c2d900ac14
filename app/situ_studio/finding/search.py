"""Finding in the whole project: what is looked for, and where it is, in plain words."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from msgspec import Struct

from situ.document import rbd
from situ.document import words as said
from situ_studio import kinds
from situ_studio.edits import mentions, places, words
from situ_studio.edits.edit import Document, Place
from situ_studio.edits.mentions import Found, Mention, Role
from situ_studio.panels.project_tree import stem
from situ_studio.wording.language import tr, translated

ROLES: dict[Role, str] = {
    "event": "event",
    "tag": "tag",
    "state": "state",
    "situation": "situation",
    "module": "module",
    "resource": "resource",
    "media": "file",
    "part": "part",
}
"""What can be looked for by its exact name, with the word that a person reads and types."""


class Hit(Struct, frozen=True):
    """One place that was found. text: what stands there; where: the place in plain words."""

    file: str
    place: Place
    icon: str
    token: str
    text: str
    where: str


def exact(role: Role, name: str) -> str:
    """What finds exactly this: ``event: clickYes``."""
    return f"{ROLES[role]}: {name}"


def _exactly(query: str) -> tuple[Role, str] | None:
    word, colon, name = query.partition(":")
    role = next((r for r, w in ROLES.items() if w == word.strip().casefold()), None)
    return (role, name.strip()) if colon and role is not None and name.strip() else None


class Hits(Struct, frozen=True):
    """count: of all places; hits: the first of them."""

    count: int
    hits: list[Hit]


def search(
    documents: dict[str, Document],
    every: Iterable[Found],
    query: str,
    file: str = "",
    most: int = 200,
) -> Hits:
    """Every place that has all words of ``query``, in the order of the documents.

    ``event: clickYes`` finds exactly what mentions that event, and so for each of ``ROLES``;
    file: whose states are meant.
    """
    wanted = query.casefold().split()
    called = {f: _called(document) for f, document in documents.items()}
    asked = _exactly(query)
    if asked is not None:
        found = mentions.usages(list(every), *asked, file)
    elif wanted:
        found = [f for f in every if _fits(f.mention, called[f.file], wanted)]
    else:
        found = []
    several = len(documents) > 1
    hits = [_hit(documents[f.file], called[f.file], f, several) for f in found[:most]]
    return Hits(len(found), hits)


def _called(document: Document) -> dict[str, str]:
    """What the states are called, by their numbers."""
    states = document.states if isinstance(document, rbd.Application) else ()
    return {s.no: words.state_called(s.no, s.name) for s in states}


def _fits(mention: Mention, called: dict[str, str], wanted: list[str]) -> bool:
    text = mention.text
    if len(mention.place) == 2 and mention.place[0] == "state":
        # A state is found once, by its number and name together.
        if mention.attribute == "name":
            return False
        if mention.attribute == "no":
            text = called.get(mention.text, mention.text)
    text = text.casefold()
    return all(word in text for word in wanted)


def _hit(document: Document, called: dict[str, str], found: Found, several: bool) -> Hit:
    """A mention as a row. several: the file is named, as the project has more than one."""
    mention = found.mention
    value = places.get(document, mention.place)
    kind = kinds.kind_of(value)
    icon, token = (kind.icon, str(kind.tint)) if kind is not None else ("info", "text2")
    if mention.attribute == mentions.NOTE:
        icon, token = "note", "text2"
    text = " ".join(mention.text.split())
    if mention.attribute == "no":
        text = called.get(mention.text, text)
    where = _where(document, mention, value)
    named = f"{stem(found.file)}: {where}" if several and where else where or stem(found.file)
    return Hit(found.file, mention.place, icon, token, text, named)


def _where(document: Document, mention: Mention, value: Any) -> str:
    """``state 6 show names, button yes: sends``."""
    place = mention.place
    if not place:
        return tr("note") if mention.attribute == mentions.NOTE else ""
    root = places.root(place)
    outer = tr("every state") if root == ("always",) else ""
    if root[0] == "state":
        state = places.get(document, root)
        outer = tr("state {0}").format(said.state(state) if state is not None else root[1])
    outer = outer or words.place_words(document, root)
    inner = words.member_words(value) if len(place) > len(root) else ""
    kind = kinds.kind_of(value)
    sections = (f for s in kind.sections for f in s.fields) if kind is not None else ()
    fields = (*kind.fields, *sections) if kind is not None else ()
    label = next((f.label for f in fields if f.attribute == mention.attribute), "")
    shown = tr(", ").join(w for w in (outer, inner) if w)
    if mention.attribute == mentions.NOTE:
        return f"{shown}: {tr('note')}"
    plain = mention.attribute in ("no", "name", "text") or not label
    return shown if plain else f"{shown}: {translated(label).lower()}"
