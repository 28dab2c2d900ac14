"""Translations that come back from a translator, taken into a project's own."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from msgspec import Struct
from msgspec.structs import replace

from situ.document.catalogue import Catalogue, Translation, translated, with_entries, with_readings


class Imported(Struct, frozen=True):
    """What became of each text of the file that came; every one is in exactly one of these.

    new: translated for the first time. changed: translated otherwise before. same: as it was.
    unsure: not looked at by the translator (fuzzy), so not used; what was sure before stays.
    unknown: texts that the project does not have; their translations are kept as obsolete.
    empty: without a translation; what was there stays.
    lacking: those of new and changed that leave out a reference of the text.
    readings: words of which the file says how they are said, otherwise than before.
    """

    catalogue: Catalogue
    new: tuple[str, ...] = ()
    changed: tuple[str, ...] = ()
    same: tuple[str, ...] = ()
    unsure: tuple[str, ...] = ()
    unknown: tuple[str, ...] = ()
    empty: tuple[str, ...] = ()
    lacking: tuple[str, ...] = ()
    readings: tuple[str, ...] = ()


def take_in(
    mine: Catalogue, theirs: Catalogue, wanted: Mapping[str, Translation], order: Sequence[str]
) -> Imported:
    """The catalogue ``mine`` with the translations of ``theirs``.

    wanted: the project's texts, each with the entry with which it would begin; order: as they
    stand in the project. Nothing of ``mine`` is lost but translations and readings that changed.
    """
    told: dict[str, list[str]] = {name: [] for name in Imported.__struct_fields__[1:]}
    entries: dict[str, Translation] = {}
    known = mine.by_text()
    for text, one in theirs.by_text().items():
        if not one.said:
            if not one.obsolete:
                told["empty"].append(text)
            continue
        before = known.get(text)
        if text not in wanted:
            told["unknown"].append(text)
            if before is None or not before.said:
                entries[text] = replace(one, obsolete=True, was=None)
            continue
        entry = before if before is not None else wanted[text]
        if one.is_unsure:
            told["unsure"].append(text)
            if not entry.is_used:
                entries[text] = replace(one, where=entry.where, files=entry.files, obsolete=False)
            continue
        if entry.is_used and entry.said == one.said:
            told["same"].append(text)
        else:
            told["changed" if entry.said and entry.said != one.said else "new"].append(text)
            entry = translated(entry, one.said)
            if entry.lacks:
                told["lacking"].append(text)
        entry = replace(entry, note=one.note or entry.note)
        if entry != before:
            entries[text] = entry
    made = with_entries(mine, entries, order) if entries else mine
    words = {w: said for w, said in theirs.readings.items() if mine.readings.get(w) != said}
    if words:
        told["readings"] = list(words)
        made = with_readings(made, {**mine.readings, **words})
    return Imported(made, **{name: tuple(texts) for name, texts in told.items()})
