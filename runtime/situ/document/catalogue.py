"""``texts/LANG.po`` as a value (formats.md, *A project*): what the editor changes entry by entry.

Nothing that a translator or another program wrote into the file is lost: its header, comments,
flags, plurals, contexts, and what is kept as obsolete.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import polib
from msgspec import Struct
from msgspec.structs import replace

from situ.document import names
from situ.document.problem import Problem
from situ.document.texts import READING, parse

FUZZY = "fuzzy"


class Translation(Struct, frozen=True):
    """One entry of a catalogue; the robot uses it where ``is_used``.

    text: as it is written in the project (``msgid``). said: in this language, ``""`` for not yet.
    note: what a translator wrote beside it. where: the places of the text, in designers' words,
    one a line. files: in which it stands. was: the text that was translated, where another
    stands there now.
    """

    text: str
    said: str = ""
    flags: tuple[str, ...] = ()
    note: str = ""
    where: str = ""
    files: tuple[tuple[str, str], ...] = ()
    obsolete: bool = False
    was: str | None = None
    context: str | None = None
    was_context: str | None = None
    was_plural: str | None = None
    plural: str = ""
    plurals: tuple[tuple[int, str], ...] = ()

    @property
    def key(self) -> tuple[str, str | None]:
        """By what it is the same entry in another version of the file."""
        return self.text, self.context

    @property
    def is_unsure(self) -> bool:
        """Whether somebody has to look at it first (``fuzzy``)."""
        return FUZZY in self.flags

    @property
    def is_used(self) -> bool:
        """Whether the robot says it, as ``texts.read`` decides."""
        return bool(self.said) and not self.obsolete and not self.is_unsure

    @property
    def lacks(self) -> tuple[str, ...]:
        """The references of the text that its translation leaves out."""
        return lacks(self.text, self.said)


class Catalogue(Struct, frozen=True):
    """A file of texts. header: the comment at its top; metadata: the header's own lines."""

    header: str = ""
    metadata: tuple[tuple[str, str], ...] = ()
    unsure_header: bool = False
    translations: tuple[Translation, ...] = ()

    def entry(self, text: str) -> Translation | None:
        """The entry of a text: of several the one that the robot uses, else one not obsolete."""
        found = [e for e in self.translations if e.text == text and e.context != READING]
        return max(found, key=_rank, default=None)

    def by_text(self) -> dict[str, Translation]:
        """Every text with its entry, as ``entry`` gives it."""
        found: dict[str, Translation] = {}
        for one in self.translations:
            if one.context == READING:
                continue
            if one.text not in found or _rank(one) > _rank(found[one.text]):
                found[one.text] = one
        return found

    @property
    def used(self) -> dict[str, str]:
        """Texts as written to what the robot says."""
        return {e.text: e.said for e in self.translations if e.is_used and e.context != READING}

    @property
    def readings(self) -> dict[str, str]:
        """Words to how the voice says them."""
        return {e.text: e.said for e in self.translations if e.is_used and e.context == READING}


def lacks(text: str, said: str) -> tuple[str, ...]:
    """The references of ``text`` that ``said``, its translation, leaves out; none where there is
    no translation.
    """
    if not said:
        return ()
    there = set(names.references(said))
    return tuple(dict.fromkeys(name for name in names.references(text) if name not in there))


def read(data: bytes, file: str) -> tuple[Catalogue | None, list[Problem]]:
    """The catalogue in a .po file; None, and why, where it is none."""
    found, problems = parse(data, file)
    if problems:
        return None, problems
    return Catalogue(
        header=found.header,
        metadata=tuple(found.metadata.items()),
        unsure_header=bool(found.metadata_is_fuzzy),
        translations=tuple(map(_value, found)),
    ), []


def write(catalogue: Catalogue) -> bytes:
    """The bytes of the .po file: each text on one line, what is obsolete last."""
    made = polib.POFile(wrapwidth=0)
    made.header = catalogue.header
    made.metadata = dict(catalogue.metadata)
    made.metadata_is_fuzzy = [FUZZY] if catalogue.unsure_header else []
    # polib sorts a header; the translator's order is kept.
    made.ordered_metadata = lambda: list(catalogue.metadata)
    # By its list: what stands twice in a file is kept too.
    list.extend(made, map(_entry, catalogue.translations))
    return str(made).encode()


def empty(project: str, language: str) -> Catalogue:
    """What a file of texts begins with; without dates: the same project, the same bytes."""
    return Catalogue(
        metadata=(
            ("Project-Id-Version", project),
            ("Language", language),
            ("MIME-Version", "1.0"),
            ("Content-Type", "text/plain; charset=UTF-8"),
            ("Content-Transfer-Encoding", "8bit"),
        )
    )


def with_entries(
    catalogue: Catalogue, entries: Mapping[str, Translation], order: Sequence[str] = ()
) -> Catalogue:
    """The catalogue with these entries, by their texts, in place of those of the same texts.

    One that is new stands behind the text that goes before it in ``order``, the project's texts;
    what is not there at the end.
    """
    known = catalogue.by_text()
    behind: dict[str | None, list[Translation]] = {}
    last: str | None = None
    # What stands in several places is one text.
    for text in dict.fromkeys(order):
        if text in known:
            last = text
        elif text in entries:
            behind.setdefault(last, []).append(entries[text])
    made = list(behind.get(None, ()))
    for one in catalogue.translations:
        is_it = known.get(one.text) is one
        made.append(entries.get(one.text, one) if is_it else one)
        made += behind.get(one.text, ()) if is_it else ()
    placed = set(order)
    made += [e for text, e in entries.items() if text not in known and text not in placed]
    return replace(catalogue, translations=tuple(made))


def with_readings(catalogue: Catalogue, words: Mapping[str, str]) -> Catalogue:
    """The catalogue with these readings, in their order, in place of those that are in use."""
    old = {e.text: e for e in catalogue.translations if e.context == READING}
    made = [
        translated(old.get(word) or Translation(word, context=READING), said)
        for word, said in words.items()
    ]
    rest = [
        e
        for e in catalogue.translations
        if e.context != READING or not (e.is_used or e.text in words)
    ]
    end = next((at for at, e in enumerate(rest) if e.obsolete), len(rest))
    return replace(catalogue, translations=(*rest[:end], *made, *rest[end:]))


def translated(entry: Translation, said: str) -> Translation:
    """The entry as a person translated it just now: nothing is unsure about it any more."""
    return replace(
        entry,
        said=said,
        flags=tuple(flag for flag in entry.flags if flag != FUZZY),
        was=None,
        was_context=None,
        was_plural=None,
        obsolete=False,
    )


def unsure(entry: Translation, text: str) -> Translation:
    """The entry of a text that is ``text`` now: its translation is kept, to be looked at."""
    if not entry.said:
        return replace(entry, text=text)
    flags = (*(flag for flag in entry.flags if flag != FUZZY), FUZZY)
    was = entry.was if entry.was is not None and entry.is_unsure else entry.text
    if was == text:
        # It is again what was translated.
        return replace(entry, text=text, flags=flags[:-1], was=None)
    return replace(entry, text=text, flags=flags, was=was)


def reworded(catalogue: Catalogue, old: str, new: str, stays: bool) -> Catalogue:
    """The catalogue of a project in which a text was changed; the same one where that is no
    matter to it.

    The translation goes along, unsure; one that the new text has already stays as it is. stays:
    the old text stands somewhere else still.
    """
    entry = catalogue.entry(old)
    if entry is None or entry.obsolete:
        return catalogue
    known = catalogue.entry(new)
    entries = list(catalogue.translations)
    at = _index(entries, entry)
    if known is not None and (known.said or not known.obsolete):
        if known.obsolete:
            entries[_index(entries, known)] = replace(known, obsolete=False)
        if not stays:
            if entry.said or entry.note:
                entries[at] = replace(entry, obsolete=True, was=None)
            else:
                del entries[at]
    elif stays:
        entries.insert(at + 1, unsure(entry, new))
    else:
        entries[at] = unsure(entry, new)
    return replace(catalogue, translations=tuple(entries))


def _rank(entry: Translation) -> tuple[bool, bool]:
    return not entry.obsolete, entry.is_used


def _index(entries: list[Translation], wanted: Translation) -> int:
    return next(at for at, one in enumerate(entries) if one is wanted)


def _value(entry: Any) -> Translation:
    return Translation(
        text=entry.msgid,
        said=entry.msgstr,
        flags=tuple(entry.flags),
        note=entry.tcomment,
        where=entry.comment,
        files=tuple((name, str(line)) for name, line in entry.occurrences),
        obsolete=bool(entry.obsolete),
        was=entry.previous_msgid,
        context=entry.msgctxt,
        was_context=entry.previous_msgctxt,
        was_plural=entry.previous_msgid_plural,
        plural=entry.msgid_plural,
        plurals=tuple(entry.msgstr_plural.items()),
    )


def _entry(one: Translation) -> Any:
    return polib.POEntry(
        msgid=one.text,
        msgstr=one.said,
        flags=list(one.flags),
        tcomment=one.note,
        comment=one.where,
        occurrences=list(one.files),
        obsolete=one.obsolete,
        previous_msgid=one.was,
        msgctxt=one.context,
        previous_msgctxt=one.was_context,
        previous_msgid_plural=one.was_plural,
        msgid_plural=one.plural,
        msgstr_plural=dict(one.plurals),
    )
