"""Finding in the whole project: what is looked for, and where it is, in plain words."""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import Struct

from situ.document import rbd
from situ_studio import kinds, mentions, places, words
from situ_studio.edit import Document, Place
from situ_studio.mentions import Found, Mention, Role
from situ_studio.panels.project_tree import stem

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


def search(
    documents: dict[str, Document], every: Iterable[Found], query: str, file: str = ""
) -> list[Hit]:
    """Every place that has all words of ``query``, in the order of the documents.

    ``event: clickYes`` finds exactly what mentions that event, and so for each of ``ROLES``;
    file: whose states are meant.
    """
    asked = _exactly(query)
    if asked is not None:
        found: Iterable[Found] = mentions.usages(list(every), *asked, file)
    else:
        wanted = query.casefold().split()
        if not wanted:
            return []
        found = (f for f in every if _fits(documents[f.file], f.mention, wanted))
    several = len(documents) > 1
    return [hit(documents[f.file], f, several) for f in found]


def _fits(document: Document, mention: Mention, wanted: list[str]) -> bool:
    text = mention.text.casefold()
    if all(word in text for word in wanted):
        # A state is found by its number and name together; once is enough.
        return not (_is_named_state(document, mention) and mention.attribute == "name") or not all(
            word in _called(document, mention).casefold() for word in wanted
        )
    return (
        mention.attribute == "no"
        and _is_named_state(document, mention)
        and all(word in _called(document, mention).casefold() for word in wanted)
    )


def _is_named_state(document: Document, mention: Mention) -> bool:
    return (
        isinstance(document, rbd.Application)
        and mention.attribute in ("no", "name")
        and (len(mention.place) == 2 and mention.place[0] == "state")
    )


def _called(document: Document, mention: Mention) -> str:
    return words.state_words(document, mention.place[1])


def hit(document: Document, found: Found, several: bool = True) -> Hit:
    """A mention as a row. several: the file is named, as the project has more than one."""
    mention = found.mention
    value = places.get(document, mention.place)
    kind = kinds.kind_of(value)
    icon, token = (kind.icon, str(kind.tint)) if kind is not None else ("info", "text2")
    text = " ".join(mention.text.split())
    if mention.attribute == "no":
        text = _called(document, mention)
    where = _where(document, mention)
    named = f"{stem(found.file)}: {where}" if several and where else where or stem(found.file)
    return Hit(found.file, mention.place, icon, token, text, named)


def _where(document: Document, mention: Mention) -> str:
    """``state 6 show names, button yes: Event``."""
    place = mention.place
    if not place:
        return ""
    root = places.root(place)
    outer = "every state" if root == ("always",) else words.place_words(document, root)
    if root[0] == "state":
        outer = f"state {words.state_words(document, root[1])}"
    value = places.get(document, place)
    inner = words.member_words(value) if len(place) > len(root) else ""
    kind = kinds.kind_of(value)
    sections = (f for s in kind.sections for f in s.fields) if kind is not None else ()
    fields = (*kind.fields, *sections) if kind is not None else ()
    label = next((f.label for f in fields if f.attribute == mention.attribute), "")
    shown = ", ".join(w for w in (outer, inner) if w)
    plain = mention.attribute in ("no", "name", "text") or not label
    return shown if plain else f"{shown}: {label.lower()}"
