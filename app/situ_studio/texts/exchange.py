"""Texts to and from a translator, as ``.po`` files."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from situ.document import beside, catalogue, folder
from situ.document.catalogue import Catalogue
from situ.document.texts_import import Imported, take_in
from situ.document.texts_table import TextRow, begun, rows
from situ.document.texts_update import update
from situ.errors import UsageError
from situ_studio.texts.model import language_name
from situ_studio.wording.language import said

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow


class Exchange(QObject):
    """Asks for files and says in words what became of what was in them."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window, self._session = window, window.session

    def give_out(self, language: str) -> None:
        """Writes every text with its translation, those that lack one too, into a file."""
        window, project = self._window, self._session.project
        if project is None:
            return
        path = window.dialogs.translations_to(f"{project.name}-{language}.po")
        if path is None:
            return
        mine = self._session.value(beside.texts_file(language))
        data = beside.write(mine) if isinstance(mine, Catalogue) else None
        made, problems = update(project, language, data, path)
        if made is None:
            window.dialogs.tell(said(problems[0].message))
            return
        try:
            folder.write(path, made.data)
        except UsageError as error:
            window.dialogs.tell(said(str(error)))
            return
        left = made.texts - made.translated
        window.say(
            self.tr("{0} texts in {1} are in {2}; {3} of them are to be translated.").format(
                made.texts, language_name(language), Path(path).name, left
            )
        )

    def take_in(self, usual: str | None) -> None:
        """Takes translations in, as one step; usual: their language, where the file says none."""
        window, project = self._window, self._session.project
        if project is None:
            return
        path = window.dialogs.translations_from()
        if path is None:
            return
        try:
            data = Path(path).read_bytes()
        except OSError as error:
            window.dialogs.tell(
                self.tr("{0} can not be read: {1}").format(path, error.strerror or error)
            )
            return
        theirs, problems = catalogue.read(data, path)
        if theirs is None:
            told = self.tr("{0}, line {1}: {2}")
            window.dialogs.tell(told.format(path, problems[0].line, said(problems[0].message)))
            return
        language = self._language(theirs, Path(path), usual)
        if language is None:
            told = self.tr(
                "{0} does not say which of the project's languages it is: name the file as one, "
                "such as {1}.po, or choose a text in its column first."
            )
            known = project.languages[1] if len(project.languages) > 1 else "ja"
            window.dialogs.tell(told.format(Path(path).name, known))
            return
        self._take(theirs, language, Path(path).name)

    def _take(self, theirs: Catalogue, language: str, name: str) -> None:
        project = self._session.project
        assert project is not None
        file = beside.texts_file(language)
        if self._session.is_incomplete(file):
            told = self.tr("{0} has errors: mend it first, or they would be lost.")
            self._window.dialogs.tell(told.format(file))
            return
        mine = self._session.value(file)
        if not isinstance(mine, Catalogue):
            mine = catalogue.empty(project.name, language)
        every: dict[str, list[TextRow]] = {}
        for row in rows(project):
            if row.lang is None:
                every.setdefault(row.text, []).append(row)
        known = mine.by_text()
        wanted = {
            text: known[text] if text in known else begun(text, there)
            for text, there in every.items()
        }
        found = take_in(mine, theirs, wanted, list(wanted))
        step = self.tr("Import {0} from {1}").format(language_name(language), name)
        self._session.commit(file, found.catalogue, step)
        words, details = self._told(found, language, name)
        self._window.dialogs.details(self.tr("Imported"), words, details)

    def _told(self, found: Imported, language: str, name: str) -> tuple[str, str]:
        """What became of it in a sentence, and text by text."""
        groups = (
            (self.tr("{0} new"), self.tr("New"), found.new),
            (self.tr("{0} changed"), self.tr("Changed"), found.changed),
            (self.tr("{0} the same as before"), "", found.same),
            (
                self.tr("{0} to be looked at, not used yet"),
                self.tr("To be looked at (fuzzy)"),
                found.unsure,
            ),
            (
                self.tr("{0} unknown to this project, kept aside"),
                self.tr("Unknown to this project, kept in the file as obsolete"),
                found.unknown,
            ),
            (
                self.tr("{0} not translated"),
                self.tr("Not translated: what was here stays"),
                found.empty,
            ),
            (
                self.tr("{0} leave out a tag of the text"),
                self.tr("Leave out a tag of the text"),
                found.lacking,
            ),
            (
                self.tr("{0} words that are said otherwise"),
                self.tr("Words that are said otherwise now"),
                found.readings,
            ),
        )
        parts = [count.format(len(texts)) for count, _, texts in groups if texts]
        words = self.tr("{0} from {1}: {2}.").format(
            language_name(language), name, ", ".join(parts) or self.tr("nothing")
        )
        lines = [
            "\n".join((title, *(f"  {text}" for text in texts)))
            for _, title, texts in groups
            if title and texts
        ]
        return words, "\n\n".join(lines)

    def _language(self, theirs: Catalogue, path: Path, usual: str | None) -> str | None:
        project = self._session.project
        assert project is not None
        others = {one.replace("_", "-").lower(): one for one in project.languages[1:]}
        named = dict(theirs.metadata).get("Language", "")
        endings = [path.stem, *path.stem.replace("_", "-").rsplit("-", 1)[1:]]
        for one in (named, *endings):
            if one.replace("_", "-").lower() in others:
                return others[one.replace("_", "-").lower()]
        # What says that it is another language is not taken for this one.
        return usual if not named else None
