"""What designers write about a thing: the comments that stand before it in its file."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any

from msgspec.structs import replace

from situ_studio.edits import places
from situ_studio.edits.edit import Place
from situ_studio.edits.places import D
from situ_studio.wording.language import tr


def note_of(value: Any) -> str:
    """What somebody wrote about it, in one line; "" for nothing."""
    return _told(_comments(value))


def comments_on(value: Any) -> str:
    """Every comment that stands before a thing in its file or inside of it, in one line; ""
    for none. Of what is in it, each thing has its own.
    """
    aside = value.aside
    held = [*aside.before, *aside.inside, *aside.after]
    for _, part in aside.parts:
        held += [*part.before, *part.inside]
    return _told(one for one in held if one.startswith("<!--"))


def annotate(document: D, place: Place, note: str) -> tuple[D, str]:
    """Another note on what stands at a place, and the step's name; the document as it is and ""
    where nothing changes. () is the document itself, "" takes the note away.
    """
    value = places.get(document, place)
    # Two hyphens would end the comment.
    note = re.sub("-{2,}", "–", " ".join(note.split())).rstrip("-")
    if value is None or note_of(value) == note:
        return document, ""
    comments = _comments(value)
    others = tuple(one for one in value.aside.before if one not in comments)
    before = (*others, f"<!-- {note} -->") if note else others
    aside = replace(value.aside, before=before)
    after = places.change(document, place, aside=aside)
    return after, tr("Change a note")


def _told(comments: Iterable[str]) -> str:
    told = (one.removeprefix("<!--").removesuffix("-->") for one in comments)
    return " ".join(" ".join(told).split())


def _comments(value: Any) -> list[str]:
    return [one for one in value.aside.before if one.startswith("<!--")]
