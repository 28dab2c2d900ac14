"""The table of texts as a value, and what typing into it makes of the project's files."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Literal

from msgspec import Struct
from msgspec.structs import replace

from situ.document import beside, catalogue, rbd
from situ.document.beside import Toml
from situ.document.catalogue import FUZZY, Catalogue, Translation
from situ.document.folder import PROJECT_FILE
from situ.document.project import Project
from situ.document.texts_table import TextRow, begun, rows
from situ_studio.edits import places
from situ_studio.edits.edit import Written
from situ_studio.texts import settings
from situ_studio.wording.language import tr

Standing = Literal["written", "done", "missing", "unsure", "lacking", "as_is", "own"]
"""How a cell stands: the text as written; translated; not yet; somebody has to look at it first,
the robot does not use it; leaves out a {tag} of the text; nothing to translate; a speech that is
always said in one language."""


class Cell(Struct, frozen=True):
    """was: the text that was translated, where it is another now. lacks: tags left out."""

    text: str
    standing: Standing
    was: str = ""
    lacks: tuple[str, ...] = ()


class Counts(Struct, frozen=True):
    """Texts of one language; each text counts once, wherever it stands."""

    every: int
    done: int
    missing: int
    unsure: int
    lacking: int


class Sheet:
    """The texts of a project as they are at one moment.

    catalogues: by language, those that are there. The first of the project's languages is the one
    in which its documents are written. toml: ``situ.toml``, where its settings are written.
    """

    def __init__(
        self, project: Project, catalogues: Mapping[str, Catalogue], toml: Toml | None = None
    ) -> None:
        self.project = project
        self.catalogues = catalogues
        self.toml = toml
        self.rows = rows(project)
        self.written_in = project.languages[0] if project.languages else ""
        self.languages = project.languages[1:]
        self._counts: dict[str, Counts] = {}
        self._entries = {language: one.by_text() for language, one in catalogues.items()}

    def entry(self, row: TextRow, language: str) -> Translation | None:
        return self._entries.get(language, {}).get(row.text)

    def cell(self, row: TextRow, language: str | None) -> Cell:
        """language: None for the text as it is written."""
        if language is None:
            return Cell(row.text, "written")
        if row.lang is not None:
            return Cell("", "own")
        entry = self.entry(row, language)
        if entry is None or not entry.said:
            return Cell("", "missing" if row.is_to_translate else "as_is")
        if entry.is_unsure or entry.obsolete:
            was = entry.was if entry.was is not None and entry.was != row.text else ""
            return Cell(entry.said, "unsure", was, entry.lacks)
        return Cell(entry.said, "lacking" if entry.lacks else "done", lacks=entry.lacks)

    def counts(self, language: str) -> Counts:
        if language not in self._counts:
            self._counts[language] = self._counted(language)
        return self._counts[language]

    def _counted(self, language: str) -> Counts:
        by_text = {row.text: row for row in self.rows if row.lang is None and row.is_to_translate}
        found = [self.cell(row, language).standing for row in by_text.values()]
        return Counts(
            every=len(found),
            done=found.count("done"),
            missing=found.count("missing"),
            unsure=found.count("unsure"),
            lacking=found.count("lacking"),
        )

    def is_open(self, row: TextRow) -> bool:
        """Whether something is left to do for a row, in some language."""
        return any(
            self.cell(row, language).standing in ("missing", "unsure", "lacking")
            for language in self.languages
        )

    def places_of(self, text: str) -> int:
        """How often a text stands in the project."""
        return sum(row.text == text for row in self.rows)


class Typed(Struct, frozen=True):
    """What was typed into one cell. language: None for the text as it is written."""

    row: TextRow
    language: str | None
    text: str


class Refused(Exception):
    """What was typed can not stand there, in a sentence for who typed it."""


def changed(sheet: Sheet, typed: Sequence[Typed]) -> dict[str, Written]:
    """The project's files after all of ``typed``, those only that change; a document's text takes
    its translations along, unsure, where nobody typed others.

    Raises Refused, and then nothing of it is done.
    """
    files: dict[str, Written] = {}
    texts = dict(sheet.catalogues)
    renamed = _written(sheet, [one for one in typed if one.language is None], files, texts)
    known = {language: one.by_text() for language, one in texts.items()}
    entries: dict[str, dict[str, Translation]] = {}
    given: dict[tuple[str, str], str] = {}
    for one in typed:
        if one.language is None:
            continue
        if one.row.lang is not None:
            raise Refused(
                tr("This speech is always said in {0}: it is not translated.").format(one.row.lang)
            )
        text = renamed.get((one.row.file, one.row.place), one.row.text)
        entry = known.get(one.language, {}).get(text)
        said = one.text.strip()
        if given.setdefault((one.language, text), said) != said:
            raise Refused(
                tr("{0} stands at several places and is translated once: {1} or {2}?").format(
                    text, given[one.language, text], said
                )
            )
        made = _typed(sheet, text, entry, said)
        if made is not None:
            entries.setdefault(one.language, {})[text] = made
    order = [row.text for row in sheet.rows]
    for language, new in entries.items():
        mine = texts.get(language) or catalogue.empty(sheet.project.name, language)
        texts[language] = catalogue.with_entries(mine, new, order)
    for language, now in texts.items():
        if now != sheet.catalogues.get(language):
            files[beside.texts_file(language)] = now
    return files


def confirmed(sheet: Sheet, row: TextRow, language: str) -> dict[str, Written]:
    """The files once somebody has said that an unsure translation is right."""
    cell = sheet.cell(row, language)
    if cell.standing != "unsure":
        return {}
    return changed(sheet, [Typed(row, language, cell.text)])


def _typed(sheet: Sheet, text: str, entry: Translation | None, said: str) -> Translation | None:
    """The entry after typing; None where nothing changes."""
    if not said:
        if entry is None or not entry.said:
            return None
        flags = tuple(flag for flag in entry.flags if flag != FUZZY)
        return replace(entry, said="", flags=flags, was=None)
    made = catalogue.translated(entry if entry is not None else begun(text, sheet.rows), said)
    return made if made != entry else None


def _written(
    sheet: Sheet,
    typed: Sequence[Typed],
    files: dict[str, Written],
    texts: dict[str, Catalogue],
) -> dict[tuple[str, tuple[str, ...]], str]:
    """Changes the documents; the new text of each place that has another one."""
    found: dict[tuple[str, tuple[str, ...]], str] = {}
    flows = dict(sheet.project.flows)
    for one in typed:
        row, text = one.row, one.text.strip()
        if text == row.text:
            continue
        if not text:
            raise Refused(tr("A text can not be left empty here: delete it where it stands."))
        found[row.file, row.place] = text
        if row.kind == "setting":
            files[PROJECT_FILE] = _setting(sheet, files, row, text)
            continue
        value = places.get(flows[row.file], row.place)
        attribute = "label" if isinstance(value, rbd.List) else "text"
        flows[row.file] = places.change(flows[row.file], row.place, **{attribute: text})
        files[row.file] = flows[row.file]
    still = {r.text for r in sheet.rows if (r.file, r.place) not in found}
    new: dict[str, dict[str, None]] = {}
    for r in sheet.rows:
        if (r.file, r.place) in found:
            new.setdefault(r.text, {})[found[r.file, r.place]] = None
    for old, others in new.items():
        *first, last = others
        for text in (*first, last):
            for language, mine in texts.items():
                # A text that becomes several is translated as it was in each of them.
                stays = old in still or text != last
                texts[language] = catalogue.reworded(mine, old, text, stays)
    return found


def _setting(sheet: Sheet, files: Mapping[str, Written], row: TextRow, text: str) -> Toml:
    toml = files.get(PROJECT_FILE, sheet.toml)
    if not isinstance(toml, Toml):
        raise Refused(tr("{0} has errors: mend it first.").format(PROJECT_FILE))
    try:
        return settings.reworded(sheet.project, toml, row.place, text)
    except ValueError as wrong:
        raise Refused(str(wrong)) from wrong
