"""Renaming an event, a tag or a module everywhere in a project."""

from __future__ import annotations

from collections import defaultdict

from msgspec import Struct

from situ.document import datatypes, names
from situ.document.project import Project
from situ_studio.edits import mentions, places
from situ_studio.edits.edit import Document
from situ_studio.edits.mentions import Found, Mention, Role
from situ_studio.wording.language import said, tr

ROLES: tuple[Role, ...] = ("event", "tag", "module")
"""What can be renamed everywhere: states and situations are known in their own document only,
where ``changes.set_field`` follows them."""

_TYPES = {
    "event": datatypes.SOME,
    "tag": datatypes.TAG,
    "module": datatypes.TITLE,
}


class Renamed(Struct, frozen=True):
    """changed: file to its document then. count: how many mentions follow.

    left: how many keep the old name, as they are patterns that mean other tags too.
    """

    changed: dict[str, Document]
    count: int
    left: int = 0


def rename(project: Project, every: list[Found], role: Role, old: str, new: str) -> Renamed:
    """The documents in which ``old`` is called ``new``.

    ValueError, with a line for the user, where the name means nothing
    or is taken: two things would become one.
    """
    rule = _TYPES[role].rule
    wrong = rule(new) if rule is not None else None
    if wrong is not None:
        raise ValueError(tr("The {0} {1}.").format(called(role), said(wrong)))
    known = mentions.tags(every, project)
    if any(_names(f.mention, role, new, known) for f in every):
        raise ValueError(_taken(role).format(new))
    found: dict[str, list[Mention]] = defaultdict(list)
    for one in every:
        if _names(one.mention, role, old, known):
            found[one.file].append(one.mention)
    left = sum(not f.mention.names for f in mentions.usages(every, role, old))
    documents = mentions.documents(project)
    changed: dict[str, Document] = {}
    for name, those in found.items():
        changed[name] = _renamed(documents[name], those, role, old, new, known)
    return Renamed(changed, sum(map(len, found.values())), left)


def called(role: Role) -> str:
    """What one of ``ROLES`` is called where a person reads it."""
    return {"event": tr("event"), "tag": tr("tag"), "module": tr("module")}[role]


def _taken(role: Role) -> str:
    return {
        "event": tr("There is an event {0} already: choose another name."),
        "tag": tr("There is a tag {0} already: choose another name."),
        "module": tr("There is a module {0} already: choose another name."),
    }[role]


def _names(mention: Mention, role: Role, name: str, known: frozenset[str]) -> bool:
    """Whether it is that very thing which is mentioned, not another tag that begins so."""
    return any(
        r == role and (_is_it(n, name, known) if role == "tag" else n == name)
        for r, n in mention.names
    )


def _is_it(name: str, tag: str, known: frozenset[str]) -> bool:
    return mentions.tag_of(name, known | {tag}) == tag


def _renamed(
    document: Document,
    those: list[Mention],
    role: Role,
    old: str,
    new: str,
    known: frozenset[str],
) -> Document:
    # From the last to the first: what is known by its name keeps it until all in it is done.
    for mention in reversed(those):
        value = places.get(document, mention.place)
        written = getattr(value, mention.attribute)
        if isinstance(written, tuple):
            after: object = tuple(new if word == old else word for word in written)
        elif role == "tag":
            after = _with_tag(mention, old, new, known)
        elif mention.attribute == "url":
            after = new.join(written.split(old, 1))
        else:
            after = new
        if after != written:
            document = places.change(document, mention.place, **{mention.attribute: after})
    return document


def _with_tag(mention: Mention, old: str, new: str, known: frozenset[str]) -> str:
    """What is written, in which the tag has another name."""

    def change(name: str) -> str:
        return new + name.removeprefix(old) if _is_it(name, old, known) else name

    if mention.names == (("tag", mention.text),):
        return change(mention.text)
    return names.with_references(mention.text, change)
