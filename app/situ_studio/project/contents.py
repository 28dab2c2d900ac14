"""What the open project consists of, as values: its documents and the files beside them, and what
each of them was when it was read and when it was saved. No undo, no signals.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from pathlib import Path

from situ.document import beside, folder
from situ.document.beside import Beside, Toml
from situ.document.catalogue import Catalogue
from situ.document.folder import PROJECT_FILE
from situ.document.project import Project
from situ.document.rbd import Application
from situ.errors import UsageError
from situ_studio.edits import project_documents
from situ_studio.edits.edit import Document, Lines, Written, read
from situ_studio.project.folder_watch import FolderWatch
from situ_studio.wording.language import tr

Taken = Callable[[str, Beside | None, Beside | None], None]
"""Told of a file beside the documents, what it was here, and what it is now."""


class Contents:
    """Exchanges one value for another and keeps the project true to all of them.

    A value is dirty when it is not the very object that was last read or saved. project: as it
    was read, of which all documents count as read and saved. disk: its folder, for what is read
    later. taken: told of each file beside the documents that was taken as it lies there. texts:
    what stood in those files, whatever becomes of the folder.
    """

    def __init__(self, project: Project, disk: FolderWatch, taken: Taken) -> None:
        self.project = project
        self.beside: dict[str, Beside] = {}
        self.texts: dict[str, bytes] = {}
        self._disk, self._taken = disk, taken
        self._scenarios: dict[str, Lines] = {}
        self._apart: dict[str, Application] = {}
        self._read: dict[str, Written] = {file: self.need(file) for file in self.files}
        self._saved = dict(self._read)
        self._removed: dict[str, None] = {}

    @property
    def root(self) -> Path:
        """The project's folder."""
        return Path(self.project.root)

    @property
    def files(self) -> list[str]:
        """The files of all documents: applications in their order, their parts, script, modules."""
        return project_documents.files(self.project)

    @property
    def every(self) -> list[str]:
        """The files of all values: of documents, and those that are there beside them."""
        return [*self.files, *self.beside, *self._scenarios]

    @property
    def scenarios(self) -> Mapping[str, Lines]:
        """Those that are values here (``attend``), by their files."""
        return self._scenarios

    @property
    def listing(self) -> tuple[str, ...]:
        """What the project is called, and which documents it has."""
        return (self.project.name, *self.files)

    def document(self, file: str) -> Document | None:
        """None for a file the project does not have."""
        return project_documents.document(self.project, file)

    def value(self, file: str) -> Written | None:
        """As ``document``, of the files beside the documents too."""
        document = self.document(file)
        if document is not None:
            return document
        return self.beside.get(file) or self._scenarios.get(file)

    def need(self, file: str) -> Written:
        """As ``value``. UsageError where there is none."""
        value = self.value(file)
        if value is None:
            raise UsageError(tr("{0} is no document of this project").format(file))
        return value

    # -- what was read and saved -----------------------------------------------------

    @property
    def changed(self) -> list[str]:
        """The files whose value is not what was last read or saved."""
        return [f for f in self.every if self.value(f) is not self._saved.get(f)]

    @property
    def removed(self) -> list[str]:
        """The files that were taken away, and lie in the folder until the project is saved."""
        return [f for f in self._removed if f not in self.files]

    def is_as_read(self, file: str) -> bool:
        return self.value(file) is self._read.get(file)

    def saved(self, file: str) -> Written | None:
        """What was last read or saved; None where nothing was, or that counts no more."""
        return self._saved.get(file)

    def see_saved(self, file: str, value: Written) -> None:
        """``value`` is what lies on disk."""
        self._saved[file] = value

    def forget_saved(self, file: str) -> None:
        """What lies on disk counts no more: the value here, if there is one, is another."""
        self._saved.pop(file, None)

    def let_go(self, file: str) -> None:
        """What becomes on disk of a file that was taken away is decided."""
        del self._removed[file]

    def take_away(self, files: Iterable[str]) -> None:
        """Files that a project which was saved in part has no more go too, where they still lie."""
        for file in files:
            if self.document(file) is None and not self._disk.is_missing(file):
                self._disk.see(file)
                self._disk.leave(file)
                self._removed[file] = None

    def settle_removed(self) -> None:
        """What was taken away and is here again lies on disk like all else."""
        self._removed.clear()

    # -- exchanging values -----------------------------------------------------------

    def having(self, file: str, value: Written) -> Project:
        """The project with another value in a file that it has."""
        if isinstance(value, Lines):
            return self.project
        if isinstance(value, Toml | Catalogue):
            return beside.settled(self.project, {**self.beside, file: value})
        return project_documents.exchanged(self.project, file, value)

    def exchange(self, file: str, value: Written | None) -> None:
        """Puts ``value`` into ``file``, which may be a new one; None takes a document away, and
        leaves of a file beside the documents what was there before it was written here.
        """
        if beside.is_beside(file):
            self._exchange_beside(file, value)
        elif isinstance(value, Lines):
            self._scenarios[file] = value
        elif value is None:
            self.project = project_documents.without(self.project, file)
            self._apart.pop(file, None)
            if not self._disk.is_missing(file):
                self._removed[file] = None
            self._disk.leave(file)
        elif self.document(file) is not None:
            self.project = self.having(file, value)
        else:
            assert isinstance(value, Document)
            self.project = project_documents.added(self.project, file, value)
            if isinstance(value, Application):
                self._regroup()
            self._removed.pop(file, None)
            self._disk.see_new(file)

    def _exchange_beside(self, file: str, value: Written | None) -> None:
        before = self.project
        if isinstance(value, Toml | Catalogue):
            self.beside[file] = value
        elif self._disk.is_missing(file):
            del self.beside[file]
        else:
            # It was saved before it was taken back.
            is_text = beside.language_of(file) is not None
            self.beside[file] = Catalogue() if is_text else Toml("")
        if file == PROJECT_FILE:
            self._regroup()
        self._settle()
        if self.project.languages != before.languages:
            # A language that came may have had texts here before.
            wanted = beside.files(self.project)
            self._attend_to(wanted)
            for other in wanted:
                if other not in self.beside and other not in beside.files(before):
                    self._take_beside(other)
            self._settle()

    def _settle(self) -> None:
        """The project is what the files beside its documents say of it."""
        self.project = beside.settled(self.project, self.beside)

    def _regroup(self) -> None:
        """The project has the applications that its ``situ.toml`` names: those read before, those
        that are read now, not what can not be read. What it has no more is kept for undo.
        """
        toml = self.beside.get(PROJECT_FILE)
        if not isinstance(toml, Toml):
            return
        for file in beside.applications(toml):
            if file not in self.project.flows and file not in self._apart:
                self._read_application(file)
        self.project, gone = beside.grouped(self.project, toml, self._apart)
        self._apart |= gone

    def _read_application(self, file: str) -> None:
        if folder.resolve(self.root, file) is None or self._disk.is_missing(file):
            return
        document, problems = read(self._disk.read(file), file)
        if isinstance(document, Application) and not any(p.severity == "error" for p in problems):
            self._apart[file] = self._read[file] = self._saved[file] = document
            self._disk.see(file)

    # -- what lies on disk -----------------------------------------------------------

    def attend(self, scenarios: Iterable[str]) -> None:
        """Scenarios that are about to be changed here are values like others from now on."""
        for file in scenarios:
            if file not in self._scenarios and not self._disk.is_missing(file):
                value, _ = read(self._disk.read(file), file)
                if isinstance(value, Lines):
                    self._scenarios[file] = self._saved[file] = value
                    self._disk.see(file)

    def read_beside(self, kept: Collection[str] = ()) -> None:
        """Takes the files beside the documents as they lie there, but for those to be kept."""
        stay = {file: self.beside[file] for file in kept if file in self.beside}
        if stay:
            # First of all for its languages, whose texts are read here too.
            self.project = beside.settled(self.project, stay)
        found = beside.files(self.project)
        self._attend_to(found)
        for file in found:
            if file not in stay:
                self._take_beside(file)
        if stay:
            self._settle()
        self.texts = {f: self._disk.read(f) for f in found if not self._disk.is_missing(f)}

    def _attend_to(self, found: Iterable[str]) -> None:
        # A scenario that is a value here is looked at on disk like a document.
        self._disk.attend([*self.files, *self._scenarios], found)

    def _take_beside(self, file: str) -> None:
        """The value here stays the very object where it is equal."""
        found = None
        if not self._disk.is_missing(file):
            found, _ = beside.read(self._disk.read(file), file)
        self._disk.see(file)
        before = self.beside.get(file)
        if found is None:
            self.beside.pop(file, None)
        else:
            found = before if before is not None and found == before else found
            self.beside[file] = self._saved[file] = self._read[file] = found
        self._taken(file, before, found)

    def adopt(self, project: Project) -> set[str] | None:
        """Takes the list of documents of ``project``, which was read anew, and with it those that
        came; documents that are here stay as they are, and what was taken away here stays away.
        Gives the files that are gone.

        None, and nothing is done, where that would take away what is not saved, or make it
        another kind of document.
        """
        before, mine = self.project, {file: self.need(file) for file in self.files}
        dirty, toml = self.changed, self.beside.get(PROJECT_FILE)
        for file in self.removed:
            project = project_documents.without(project, file)
        if PROJECT_FILE in dirty and isinstance(toml, Toml):
            project, _ = beside.grouped(project, toml, {})
        self.project = project
        lost = [file for file in dirty if file not in self.every]
        other = [f for f in self.files if f in mine and type(mine[f]) is not type(self.document(f))]
        if lost or other:
            # Somebody works on what would go.
            self.project = before
            return None
        for file in self.files:
            if file in mine:
                self.project = self.having(file, mine[file])
            else:
                self._read[file] = self._saved[file] = self.need(file)
                self._disk.see(file)
        gone = mine.keys() - set(self.files)
        self._saved = {f: d for f, d in self._saved.items() if f not in gone}
        return gone
