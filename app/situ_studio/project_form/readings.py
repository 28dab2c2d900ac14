"""How words are said: names and abbreviations that a voice would say wrongly."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import Signal

from situ.document.project import Project
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import Choice
from situ_studio.project_form.boxes import RowsSection
from situ_studio.project_form.checks import free, named
from situ_studio.project_form.rows import Checked, Column
from situ_studio.texts.model import language_name
from situ_studio.wording.language import tr


class ReadingsSection(RowsSection):
    """They stand in the files of texts, and are told by their language."""

    changed = Signal(object, str)
    """By languages all of their readings by their words, and the name of the step."""

    def __init__(self, theme: Theme) -> None:
        self._languages: tuple[str, ...] = ()
        self._readings: dict[str, dict[str, str]] = {}
        columns = (
            Column(
                title=tr("Language"),
                make=Choice,
                share=2,
                help=tr("The language in which the word is said so."),
            ),
            Column(
                title=tr("Written"),
                make=lambda _, p: Checked(named, p),
                share=3,
                help=tr("The word as it stands in texts."),
            ),
            Column(
                title=tr("Said"),
                make=lambda _, p: Checked(named, p),
                share=3,
                help=tr("The word as it sounds, written as it is spoken."),
            ),
        )
        super().__init__(
            theme,
            tr("How words are said"),
            tr(
                "Names and abbreviations that a voice would say wrongly: it says the second where "
                "the first is written. The screen and the trace keep what is written."
            ),
            columns,
            tr("a word"),
        )

    def show_project(self, project: Project) -> None:
        self._languages = project.languages
        self._readings = {
            language: dict(project.readings.get(language, {})) for language in project.languages
        }
        every = self._every()
        self.plus.setEnabled(bool(self._languages))
        if len(self.rows) < len(every):
            # A choice has to know its languages before it shows one.
            self.rows.show_rows([("", "", "")] * len(every))
        for row in range(len(self.rows)):
            field = self.rows.field(row, 0)
            assert isinstance(field, Choice)
            field.offer(tuple((one, language_name(one)) for one in self._languages))
        self.show_values(every)

    def _every(self) -> list[tuple[str, str, str]]:
        return [
            (language, word, said)
            for language, words in self._readings.items()
            for word, said in words.items()
        ]

    def on_changed(self, row: int, column: int, value: Any) -> None:
        language, word, said = self._every()[row]
        wanted = [language, word, said]
        wanted[column] = value
        if column < 2 and wanted[1] in self._readings.get(wanted[0], {}):
            self.refused.emit(tr("{0} is there already.").format(wanted[1]))
            self.show_values(self._every())
            return
        step = tr("Change how {0} is said").format(word)
        if column == 0:
            there = self._readings.get(value, {}) | {word: said}
            self.changed.emit({language: self._without(language, word), value: there}, step)
            return
        words = {
            wanted[1] if one == word else one: wanted[2] if one == word else old
            for one, old in self._readings[language].items()
        }
        self.changed.emit({language: words}, step)

    def on_removed(self, row: int) -> None:
        language, word, _ = self._every()[row]
        step = tr("Remove how {0} is said").format(word)
        self.changed.emit({language: self._without(language, word)}, step)

    def on_added(self) -> None:
        language = self._languages[-1]
        word = free(tr("word"), self._readings[language])
        words = self._readings[language] | {word: word}
        before = len(self.rows)
        self.changed.emit({language: words}, tr("Add {0}").format(self.noun))
        if len(self.rows) > before:
            last = [at for at, one in enumerate(self._every()) if one[:2] == (language, word)]
            self.rows.begin(last[0], 1)

    def _without(self, language: str, word: str) -> dict[str, str]:
        return {one: said for one, said in self._readings[language].items() if one != word}
