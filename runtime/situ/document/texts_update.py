"""``texts/LANG.po`` brought up to date with the texts of a project (``situ texts``).

What translators wrote is kept: translations, comments, the header. An entry names its files
and, in designers' words, its places, but no lines: a state put in before it does not change it.
"""

from __future__ import annotations

from typing import Any

import polib
from msgspec import Struct

from situ.document.folder import PROJECT_FILE
from situ.document.problem import Problem
from situ.document.project import Project
from situ.document.texts import READING, parse
from situ.document.texts_alike import Alike
from situ.document.texts_shown import setting_texts, shown_texts

_HEADER = (
    ("MIME-Version", "1.0"),
    ("Content-Type", "text/plain; charset=UTF-8"),
    ("Content-Transfer-Encoding", "8bit"),
)


class Update(Struct, frozen=True):
    """A file of texts as it should be.

    data: its bytes; those given, where nothing would change but its layout.
    new, unsure, gone: the texts that came; of these, those with the translation of a text that
        was like them, to be looked at; those that went.
    texts, translated: how many there are, and of how many the translation is used.
    """

    data: bytes
    new: tuple[str, ...]
    unsure: tuple[str, ...]
    gone: tuple[str, ...]
    texts: int
    translated: int


def update(
    project: Project, language: str, data: bytes | None, file: str
) -> tuple[Update | None, list[Problem]]:
    """The file of a language, from what it was (None: there is none yet); None, and why, where
    that is malformed.

    In the order of the project: its applications, then their parts, state by state, then its
    settings. A text that is gone is kept as obsolete where somebody had translated or commented
    it, and taken up again when it comes back.
    """
    before, problems = (_empty(project, language), []) if data is None else parse(data, file)
    if problems:
        return None, problems
    # polib sorts a header; the translator's order is kept.
    before.ordered_metadata = lambda: list(before.metadata.items())
    was = str(before)
    known = _known(before)
    wanted = _wanted(project, language, known)
    left = {text: entry for text, entry in known.items() if text not in wanted}
    gone = tuple(text for text, entry in left.items() if not entry.obsolete)
    alike = Alike(text for text, entry in left.items() if entry.msgstr)
    after, new, unsure = [], [], []
    for text, places in wanted.items():
        entry = known.get(text)
        if entry is None or entry.obsolete:
            new.append(text)
        if entry is None:
            entry = polib.POEntry(msgid=text)
            if (like := alike.take(text)) is not None:
                _take_over(entry, left.pop(like))
                unsure.append(text)
        entry.obsolete = False
        entry.comment = "\n".join(dict.fromkeys(where for _, where in places))
        entry.occurrences = [(name, "") for name in dict.fromkeys(name for name, _ in places)]
        after.append(entry)
    for entry in left.values():
        entry.obsolete = True
    # How words are said is the translator's alone.
    read = [entry for entry in before if entry.msgctxt == READING]
    before[:] = [*after, *read, *(e for e in left.values() if _is_translated(e) or e.tcomment)]
    now = str(before)
    made = now.encode() if data is None or now != was else data
    used = sum(_is_translated(entry) and not entry.fuzzy for entry in after)
    found = Update(made, tuple(new), tuple(unsure), gone, len(after), used)
    return found, []


def _empty(project: Project, language: str) -> Any:
    """A file of texts with nothing but a header. No dates: the same project, the same bytes."""
    made = polib.POFile(wrapwidth=0)
    made.metadata = {"Project-Id-Version": project.name, "Language": language, **dict(_HEADER)}
    return made


def _known(before: Any) -> dict[str, Any]:
    """By text, its entry; of several the one that the robot uses, else one that is not obsolete."""

    def rank(entry: Any) -> tuple[bool, bool]:
        is_used = _is_translated(entry) and not entry.fuzzy
        return not entry.obsolete, is_used

    found: dict[str, Any] = {}
    for entry in before:
        if entry.msgctxt == READING:
            continue
        if entry.msgid not in found or rank(entry) >= rank(found[entry.msgid]):
            found[entry.msgid] = entry
    return found


def _wanted(
    project: Project, language: str, known: dict[str, Any]
) -> dict[str, list[tuple[str, str]]]:
    """Every text that the file has to have, with its files and places.

    What need not be translated (``6``, ``{user.name}``, a speech in this very language) is
    left to the translator: it stays where it is there, as the robot looks for it.
    """
    found: dict[str, list[tuple[str, str]]] = {}
    kept: dict[str, bool] = {}
    for file, application in project.flows.items():
        for one in shown_texts(application):
            if not one.text.strip() or one.lang not in (None, language):
                continue
            entry = known.get(one.text)
            found.setdefault(one.text, []).append((file, " ".join(one.where.split())))
            is_there = entry is not None and not entry.obsolete
            kept[one.text] = kept.get(one.text, is_there) or one.is_to_translate
    for told in setting_texts(project.settings):
        found.setdefault(told.text, []).append((PROJECT_FILE, told.where))
        kept[told.text] = True
    return {text: places for text, places in found.items() if kept[text]}


def _take_over(entry: Any, like: Any) -> None:
    entry.msgstr, entry.tcomment = like.msgstr, like.tcomment
    entry.flags = [*(flag for flag in like.flags if flag != "fuzzy"), "fuzzy"]
    entry.previous_msgid = like.msgid


def _is_translated(entry: Any) -> bool:
    return bool(entry.msgstr or any(entry.msgstr_plural.values()))
