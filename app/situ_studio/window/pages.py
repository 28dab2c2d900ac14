"""The pages of a project: tabs that show no drawing, but all texts, media, what the project is."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QWidget

from situ.document import beside, catalogue
from situ.document import toml_writing as writing
from situ.document.beside import Toml
from situ.document.catalogue import Catalogue
from situ.document.folder import LOCAL_FILE, PROJECT_FILE, TEXTS_FOLDER
from situ.document.texts import read_out
from situ_studio.edits.edit import Place, Written
from situ_studio.edits.vocabulary import Lexicon
from situ_studio.finding.find import Find
from situ_studio.looks.theme import Theme
from situ_studio.panels.application_list import ApplicationList
from situ_studio.panels.project_tree import MEDIA
from situ_studio.project_form.form import ProjectForm
from situ_studio.project_form.found import sections
from situ_studio.project_form.going import go_to_place
from situ_studio.screens.media_page import MediaPage
from situ_studio.texts.exchange import Exchange
from situ_studio.texts.listening import Listening
from situ_studio.texts.model import language_code, language_name
from situ_studio.texts.page import TextsPage
from situ_studio.texts.settings import in_file
from situ_studio.window.sides import Group

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow

TEXTS = TEXTS_FOLDER
"""What the tab of all texts goes by, as others go by their file."""
KEYS = (TEXTS, PROJECT_FILE, MEDIA)


class PagesSide(QObject):
    """A window's pages: made when they are first shown, up to date while they are."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window, self._session = window, window.session
        self._lexicon = Lexicon()
        self._exchange = Exchange(window)
        self.applications = ApplicationList(window)
        self._voice = Listening(self)
        self._voice.failed.connect(window.say)
        self._voice.changed.connect(self._on_voice)
        window.closed.connect(lambda _: self._voice.end())
        self._session.opened.connect(self._settle)
        self._session.changed.connect(self._settle)
        self._session.listed.connect(self._settle)
        self._session.problems_changed.connect(self._settle_forms)
        window.sides.chosen.connect(self._on_tab)

    def has(self, key: str) -> bool:
        """Whether the project has that page."""
        project = self._session.project
        return project is not None and project.toml is not None and key in KEYS

    def key(self, file: str) -> str:
        """The page on which a file is shown; the file itself where it is a document."""
        if not beside.is_beside(file):
            return file
        return PROJECT_FILE if file in (PROJECT_FILE, LOCAL_FILE) else TEXTS

    def look(self, key: str) -> tuple[str, str, str]:
        """A page's words, icon and its colour, for its tab."""
        if key == TEXTS:
            return self.tr("Texts"), "language", "text2"
        if key == MEDIA:
            return self.tr("Media"), "image", "text2"
        return self.tr("Project"), "folder", "text2"

    def page(self, key: str) -> QWidget | None:
        """The widget of a page, up to date; None where the project has none of that key."""
        if not self.has(key):
            return None
        group = self._window.sides.current
        if key == TEXTS:
            return self._texts_of(group) or self._make_texts(group)
        if key == MEDIA:
            return self._media_of(group) or self._make_media(group)
        return self._form_of(group) or self._make_form(group)

    def _texts_of(self, group: Group) -> TextsPage | None:
        """The page of a group of tabs; None before it was first shown there."""
        return group.documents.findChild(TextsPage)

    def _form_of(self, group: Group) -> ProjectForm | None:
        return group.documents.findChild(ProjectForm)

    def _media_of(self, group: Group) -> MediaPage | None:
        return group.documents.findChild(MediaPage)

    def shows(self, file: str) -> bool:
        """Whether what changed in a file can be seen on the page that is shown."""
        shown = self._window.tabs.chosen_file
        project = self._session.project
        if shown is None or not self.has(shown) or project is None:
            return False
        if shown == TEXTS and file == PROJECT_FILE:
            page = self._texts_of(self._window.sides.current)
            return page is not None and page.has_changed
        return self.key(file) == shown or (shown == TEXTS and file in project.flows)

    def go_to_text(self, file: str, place: tuple[str, ...], language: str) -> None:
        """Shows a text of a document in the table of all texts, in the column of a language."""
        self._window.open_file(TEXTS)
        page = self._texts_of(self._window.sides.current)
        if page is not None:
            page.bring(file, place, language)

    def go_to_field(self, file: str, place: Place) -> None:
        """Shows what stands at a place of ``situ.toml`` in its form."""
        self._window.open_file(PROJECT_FILE)
        form = self._form_of(self._window.sides.current)
        if form is not None:
            form.show_file(file)
            go_to_place(form, place)

    def findable(self) -> list[Find]:
        """What *Find anything* offers of the project's pages."""
        if not self.has(PROJECT_FILE):
            return []
        words, icon, token = self.look(TEXTS)
        more = self.tr("languages, translations")
        texts = Find(words, icon, token, "", partial(self._window.open_file, TEXTS), more)
        words, icon, token = self.look(MEDIA)
        media = Find(
            words, icon, token, "", partial(self._window.open_file, MEDIA), self.tr("pictures")
        )
        project, icon, token = self.look(PROJECT_FILE)
        return [texts, media] + [
            Find(title, icon, token, project, partial(self.go_to_field, PROJECT_FILE, place), more)
            for place, title, more in sections()
        ]

    def unsaved(self) -> list[str]:
        """The pages on which something is not saved."""
        return [self.key(f) for f in self._session.dirty if beside.is_beside(f)]

    def set_theme(self, theme: Theme) -> None:
        for group in self._window.sides.groups:
            for page in (self._texts_of(group), self._form_of(group), self._media_of(group)):
                if page is not None:
                    page.set_theme(theme)

    # -- the texts ---------------------------------------------------------------

    def _make_texts(self, group: Group) -> TextsPage:
        window = self._window
        page = TextsPage(window.theme, self._tags)
        page.edited.connect(self._on_texts)
        page.go_asked.connect(self._on_go)
        page.refused.connect(window.say)
        page.import_asked.connect(lambda: self._exchange.take_in(page.language))
        page.export_asked.connect(self._exchange.give_out)
        page.language_asked.connect(self.add_language)
        page.listen_asked.connect(self._on_listen)
        page.set_listening(self._voice.can, self._voice.going)
        group.documents.addWidget(page)
        return page

    def _on_go(self, file: str, place: Place) -> None:
        project, toml = self._session.project, self._session.value(file)
        if project is None or not isinstance(toml, Toml):
            self._window.go_to(file, place)
        else:
            self.go_to_field(file, in_file(project, toml, place))

    def _on_listen(self, text: str, language: str) -> None:
        project = self._session.project
        words = project.readings.get(language, {}) if project is not None else {}
        self._voice.toggle(read_out(text, words, language), language)

    def _on_voice(self) -> None:
        for group in self._window.sides.groups:
            page = self._texts_of(group)
            if page is not None:
                page.set_listening(self._voice.can, self._voice.going)

    def _on_tab(self, key: str) -> None:
        self._settle()
        group = self._window.sides.current
        every = {TEXTS: self._texts_of, MEDIA: self._media_of}
        page = every.get(key, self._form_of)(group)
        if self.has(key) and page is not None:
            self._window.project_tree.show_current(key)
            page.begin()

    def _settle(self) -> None:
        """Brings the pages that are seen up to date."""
        project = self._session.project
        if project is None:
            return
        for group in self._window.sides.groups:
            texts = self._texts_of(group)
            if texts is not None and group.tabs.chosen_file == TEXTS:
                toml = self._session.value(PROJECT_FILE)
                known = toml if isinstance(toml, Toml) else None
                texts.show_project(project, self._catalogues(), known)
            media = self._media_of(group)
            if media is not None and group.tabs.chosen_file == MEDIA:
                media.show_project(project)
        self._settle_forms()

    def _settle_forms(self) -> None:
        project = self._session.project
        for group in self._window.sides.groups:
            form = self._form_of(group)
            shown = group.tabs.chosen_file == PROJECT_FILE
            if form is not None and project is not None and shown:
                form.show_project(project, self._session.value, self._session.problems_of)

    def _catalogues(self) -> dict[str, Catalogue]:
        project = self._session.project
        found = {}
        for language in project.languages if project is not None else ():
            value = self._session.value(beside.texts_file(language))
            if isinstance(value, Catalogue):
                found[language] = value
        return found

    def _tags(self) -> tuple[str, ...]:
        project = self._session.project
        first = next(iter(project.flows.values()), None) if project is not None else None
        if project is None or first is None:
            return ()
        return self._lexicon.vocabulary(project, first).tags

    def _on_texts(self, files: dict[str, Written], words: str) -> None:
        unread = [file for file in files if self._session.is_incomplete(file)]
        if unread:
            self._window.say(
                self.tr("{0} has errors: mend it first, or they would be lost.").format(unread[0])
            )
            self._settle()
            return
        self._session.commit_all(files, words)

    def add_language(self) -> None:
        """Asks for a language into which the project is to be translated, and adds it."""
        window, session = self._window, self._session
        project, toml = session.project, session.value(PROJECT_FILE)
        label = self.tr("Its name or code, such as Japanese, 日本語, ja or pt-BR")
        words = window.dialogs.name(self.tr("Add a language"), label, "")
        if words is None or project is None or not isinstance(toml, Toml):
            return
        code = language_code(words)
        if code is None:
            told = self.tr("{0} is no language: write its name, or a code such as ja or pt-BR.")
            window.say(told.format(words))
            return
        # The first one is that in which the documents are written.
        written_in = project.languages or (str(project.tags.get("language") or "en"),)
        languages = list(dict.fromkeys((*written_in, code)))
        after = writing.put(toml, "project", "languages", languages)
        changed: dict[str, Written] = {PROJECT_FILE: after}
        file = beside.texts_file(code)
        if session.value(file) is None and session.disk.is_missing(file):
            # What is to be translated is told text by text, and not that there is no file.
            changed[file] = catalogue.empty(project.name, code)
        session.commit_all(changed, self.tr("Add {0}").format(language_name(code)))

    # -- media -------------------------------------------------------------------

    def _make_media(self, group: Group) -> MediaPage:
        page = MediaPage(self._window.theme)
        page.go_asked.connect(self._window.go_to)
        page.import_asked.connect(self._window.media_choice.bring)
        page.dropped.connect(self._window.media_choice.bring_files)
        group.documents.addWidget(page)
        return page

    def settle_media(self, name: str) -> None:
        """A file has come: what shows the project's media shows it, too."""
        window, project = self._window, self._session.project
        if project is not None:
            window.project_tree.show_media(project)
        self._settle()
        for group in window.sides.groups:
            media = self._media_of(group)
            if media is not None:
                media.choose(name)

    # -- the form ----------------------------------------------------------------

    def _make_form(self, group: Group) -> ProjectForm:
        form = ProjectForm(self._window.theme)
        form.edited.connect(self._session.commit)
        form.refused.connect(self._window.say)
        form.language_asked.connect(self.add_language)
        form.readings_changed.connect(self._on_readings)
        form.applications.add_asked.connect(self.applications.ask)
        form.applications.remove_asked.connect(self.applications.remove)
        form.applications.start_asked.connect(self.applications.start)
        form.mend_asked.connect(self._window.mending.mend)
        form.mends_asked.connect(self._window.mending.open_at)
        group.documents.addWidget(form)
        return form

    def _on_readings(self, changed: dict[str, dict[str, str]], step: str) -> None:
        project = self._session.project
        if project is None:
            return
        files: dict[str, Written] = {}
        for language, words in changed.items():
            file = beside.texts_file(language)
            mine = self._session.value(file)
            if not isinstance(mine, Catalogue):
                mine = catalogue.empty(project.name, language)
            files[file] = catalogue.with_readings(mine, words)
        self._on_texts(files, step)
