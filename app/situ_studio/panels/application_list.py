"""Which applications a project has: made new, taken from its folder, taken away.

With a second one comes the script that says which goes first; with one more, its priority there.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from msgspec.structs import replace
from PySide6.QtCore import QObject, QPoint
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QMenu

from situ.document import beside, codec
from situ.document import toml_writing as writing
from situ.document.aside import NOTHING
from situ.document.beginning import project_name
from situ.document.beside import Toml
from situ.document.check import give_priority
from situ.document.folder import PROJECT_FILE
from situ.document.mend import apply
from situ.document.project import Project
from situ.document.rbd import Application, State
from situ.document.spds import Spds
from situ.errors import UsageError
from situ_studio.canvas.gestures import mark_start
from situ_studio.edits import new_script
from situ_studio.edits.document_uses import END, listed
from situ_studio.edits.edit import Written
from situ_studio.looks import icons
from situ_studio.wording.language import said

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow

MOST = 20
"""So many files of the folder a menu offers at most."""


class ApplicationList(QObject):
    """The applications of one window's project."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window, self._session = window, window.session
        self.shown: QMenu | None = None

    def ask(self, at: QPoint) -> None:
        """Opens a menu of what can be added at a place of the screen."""
        menu = QMenu(self._window)
        self.fill(menu)
        menu.aboutToHide.connect(self._on_hidden)
        self.shown = menu
        menu.popup(at)
        menu.setActiveAction(menu.actions()[0])

    def fill(self, menu: QMenu) -> None:
        """Puts what can be added into a menu."""
        new = menu.addAction(self._icon("plus", "accent"), self.tr("New application…"))
        new.triggered.connect(lambda _=False: self.make())
        others = self.others()
        if others:
            menu.addSeparator()
        for file in others[:MOST]:
            made = menu.addAction(self._icon("state", "text2"), file.replace("&", "&&"))
            made.triggered.connect(lambda _=False, file=file: self.add(file))

    def _on_hidden(self) -> None:
        menu, self.shown = self.shown, None
        if menu is not None:
            menu.deleteLater()

    def others(self) -> list[str]:
        """The files of applications in the project's folder that are none of the project's."""
        project = self._session.project
        if project is None:
            return []
        root = Path(project.root)
        found = sorted(path.relative_to(root).as_posix() for path in root.rglob(f"*{END}"))
        return [
            file
            for file in dict.fromkeys([*project.parts, *found])
            if file not in project.applications and not file.startswith(".")
        ]

    def make(self) -> None:
        """Asks for a name, and adds a new application of one state."""
        project = self._session.project
        given = self._window.dialogs.name(
            self.tr("New application"), self.tr("Name"), self.tr("round")
        )
        if given is None or project is None:
            return
        name = project_name(given)
        if name in {one.name for one in project.applications.values()} | project.declared().keys():
            self._window.say(self.tr("{0} is there already.").format(name))
            return
        first = State(no="1", name=self.tr("start"), final=True, aside=NOTHING.at(24, 56))
        self._add(self._free(name), Application(name=name, start="1", states=(first,)), new=True)

    def add(self, file: str) -> None:
        """Adds an application whose file lies in the project's folder."""
        window = self._window
        found = self._session.document(file)
        if found is None:
            try:
                found, problems = codec.read(self._session.disk.read(file), file)
            except UsageError as error:
                window.say(said(str(error)))
                return
            errors = [said(one.message) for one in problems if one.severity == "error"]
            if errors:
                told = self.tr("{0} can not be read: {1}")
                window.say(told.format(file, errors[0]))
                return
            if not isinstance(found, Application):
                window.say(self.tr("{0} is no application.").format(file))
                return
        if isinstance(found, Application):
            self._add(file, found)

    def copy(self, file: str) -> None:
        """Adds another application that is like this one, with a name of its own, as one step."""
        project, found = self._session.project, self._session.document(file)
        if project is None or not isinstance(found, Application):
            return
        if self._session.is_incomplete(file):
            told = self.tr("{0} has errors: mend them first, or what they name would be lost.")
            self._window.say(told.format(file))
            return
        taken = {one.name for one in project.applications.values()} | project.declared().keys()
        number = 2
        while (name := f"{found.name}-{number}") in taken:
            number += 1
        words = self.tr("Duplicate application {0}").format(found.name)
        self._add(self._free(name), replace(found, name=name), True, words)

    def remove(self, file: str) -> None:
        """Takes an application out of the project; its file stays."""
        project, toml = self._session.project, self._session.value(PROJECT_FILE)
        if project is not None and isinstance(toml, Toml):
            after = listed(toml, project, file)
            self._session.commit(PROJECT_FILE, after, self.tr("Remove {0}").format(file))

    def start(self, file: str, no: str) -> None:
        """Has an application start in one of its states."""
        document = self._session.document(file)
        if isinstance(document, Application):
            after, text = mark_start(document, no)
            if text:
                self._session.commit(file, after, text)

    def _add(self, file: str, application: Application, new: bool = False, words: str = "") -> None:
        project, toml = self._session.project, self._session.value(PROJECT_FILE)
        if project is None or not isinstance(toml, Toml):
            return
        named = [*beside.applications(toml), file]
        after = writing.put(toml, "project", "applications", named)
        changed: dict[str, Written] = {PROJECT_FILE: after}
        if new:
            changed[file] = application
        changed |= self._script(project, after, file, application)
        words = words or self.tr("Add application {0}").format(application.name)
        if self._session.commit_all(changed, words) and new:
            self._window.open_file(file)
        elif new:
            self._window.say(self.tr("There are errors in the project: mend them first."))

    def _script(
        self, project: Project, toml: Toml, file: str, application: Application
    ) -> dict[str, Written]:
        """What the script needs for one more application: a priority, or to be there at all."""
        after = replace(project, applications={**project.applications, file: application})
        if project.spds is None:
            if len(after.applications) < 2 or not new_script.can_begin(after):
                return {}
            there = new_script.taken(self._session.root, self._session.files)
            return new_script.begun(after, toml, there)
        script, spds_file = project.spds, project.spds_file
        asked = any(
            entry.module == application.name for one in script.situations for entry in one.entries
        )
        mend = None if asked else give_priority(after, script, application)
        if mend is None or spds_file is None:
            return {}
        mended = apply(script, mend)
        return {spds_file: mended} if isinstance(mended, Spds) else {}

    def _free(self, name: str) -> str:
        """A file that neither the project nor the disk has."""
        found, number = f"{name}{END}", 2
        while found in self._session.files or (self._session.root / found).exists():
            found, number = f"{name}-{number}{END}", number + 1
        return found

    def _icon(self, name: str, token: str) -> QIcon:
        return icons.icon(name, self._window.theme.color(token), 18)
