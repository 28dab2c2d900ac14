"""The open project and its one undo stack.

Documents are values: an edit exchanges one for another, undo puts the old one
back, and a document is dirty when it is not the very object that was last read
or saved (architecture, idea 1).
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping
from datetime import datetime
from pathlib import Path

from msgspec import Struct
from msgspec.structs import replace
from PySide6.QtCore import QFileSystemWatcher, QObject, QTimer, Signal

from situ.document import codec, folder
from situ.document.check import check, merge
from situ.document.modules import Modules
from situ.document.problem import Problem
from situ.document.project import Project
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ.errors import UsageError
from situ_studio.checking import Checker
from situ_studio.edit import Document, Edit, Place

Selection = tuple[Place, ...]

Looking = tuple[float, float, float]
"""Where a canvas looks: its zoom, and the scene's point in its upper left corner."""


class Step(Struct):
    """What one gesture changed, with what was selected before and after it and where the canvas
    looked, so that undo and redo bring that back too.

    edits: one a document; the first is that of the document in which it was done.
    """

    edits: tuple[Edit, ...]
    before: Selection = ()
    after: Selection = ()
    looking: Looking | None = None


class Session(QObject):
    """One project while it is open in a window.

    now: the wall clock, for *Saved 14:02*.
    """

    opened = Signal()
    """Another project is open."""
    changed = Signal(str)
    """The document of that file is another value now."""
    listed = Signal()
    """The project has a file more, or one less."""
    selected = Signal(str, tuple, object)
    """Undo or redo brought this selection of that file back, and where its canvas looked."""
    stack_changed = Signal()
    """What can be undone, redone or saved is not what it was."""
    problems_changed = Signal()
    changed_on_disk = Signal(str)
    """Another program wrote that file, and the document here is not its content."""

    def __init__(
        self, parent: QObject | None = None, now: Callable[[], datetime] = datetime.now
    ) -> None:
        super().__init__(parent)
        self._now = now
        self._project: Project | None = None
        self._read_problems: list[Problem] = []
        self._problems: list[Problem] = []
        self._by_file: dict[str, list[Problem]] = {}
        # By what problems call a file: the path as the user gave it.
        self._called: dict[str, str | None] = {}
        self._incomplete: dict[str, Document] = {}
        self._read: dict[str, Document] = {}
        self._saved: dict[str, Document] = {}
        self._on_disk: dict[str, bytes] = {}
        self._steps: list[Step] = []
        self._at = 0
        self._saved_at: datetime | None = None
        self._check_soon = QTimer(self)
        self._check_soon.setSingleShot(True)
        self._check_soon.setInterval(0)
        self._check_soon.timeout.connect(self._check)
        self._checker = Checker(self)
        self._checker.found.connect(self._on_found)
        self._watcher = QFileSystemWatcher(self)
        self._watcher.fileChanged.connect(self.on_file_changed)

    # -- the project -------------------------------------------------------------

    @property
    def project(self) -> Project | None:
        return self._project

    @property
    def root(self) -> Path:
        """The project's folder. UsageError while none is open."""
        return Path(self._open_project().root)

    @property
    def files(self) -> list[str]:
        """The files of all documents: applications in their order, their parts, script, modules."""
        if self._project is None:
            return []
        found = [*self._project.applications, *self._project.parts]
        if self._project.spds_file is not None and self._project.spds is not None:
            found.append(self._project.spds_file)
        if self._project.modules_file is not None and self._project.modules is not None:
            found.append(self._project.modules_file)
        return found

    @property
    def problems(self) -> list[Problem]:
        """What ``check`` found last, with what stopped a file from being read."""
        return self._problems

    def document(self, file: str) -> Document | None:
        """The document of ``file`` as it is now; None for a file the project does not have."""
        project = self._project
        if project is None:
            return None
        if file in project.applications:
            return project.applications[file]
        if file in project.parts:
            return project.parts[file]
        if file == project.spds_file:
            return project.spds
        return project.modules if file == project.modules_file else None

    def open(self, path: str | Path) -> None:
        """Opens a project in place of the one that was open; nothing is saved.

        Raises UsageError, with one line for the user, where there is nothing to open.
        """
        project, problems = folder.load(path)
        if project is None:
            raise UsageError(str(problems[0]) if problems else f"{path}: no project could be read")
        self._project = project
        self._called = {}
        self._read_problems = problems
        self._steps = []
        self._at = 0
        self._saved_at = None
        self._read = {file: self._value(file) for file in self.files}
        self._saved = dict(self._read)
        self._incomplete = {
            file: document
            for file, document in self._read.items()
            if any(p.severity == "error" and self.file_of(p) == file for p in problems)
        }
        self._on_disk = {file: self._digest(file) for file in self.files}
        self._watch()
        self._keep_problems(problems)
        self._check()
        self.opened.emit()
        self.stack_changed.emit()

    def is_incomplete(self, file: str) -> bool:
        """Whether the file has errors, so that its document lacks what they name.

        Such a document can not be changed: saving it would lose that for good.
        """
        document = self._incomplete.get(file)
        return document is not None and document is self.document(file)

    # -- the undo stack ----------------------------------------------------------

    def commit(
        self,
        file: str,
        after: Document,
        text: str,
        selected: Selection = (),
        looking: Looking | None = None,
    ) -> bool:
        """Makes ``after`` the document of ``file``, as one named step; False where it already is,
        or where the document is incomplete.

        selected, looking: as it was before. Documents that differ only in positions or notes are
        equal, so identity decides.
        """
        return self.commit_all({file: after}, text, selected, looking)

    def commit_all(
        self,
        changed: Mapping[str, Document],
        text: str,
        selected: Selection = (),
        looking: Looking | None = None,
    ) -> bool:
        """Changes several documents as one named step, as ``commit`` does one.

        changed: the file in which it was done stands first; an application in a file that the
        project does not have becomes a new part of it. None is changed, and the answer is False,
        where one of them is incomplete.
        """
        if any(self.is_incomplete(file) for file in changed):
            return False
        return self._commit(changed, text, selected, looking)

    def _commit(
        self,
        changed: Mapping[str, Document],
        text: str,
        selected: Selection = (),
        looking: Looking | None = None,
    ) -> bool:
        every = ((file, self.document(file), after) for file, after in changed.items())
        edits = tuple(
            Edit(f, before, after, text) for f, before, after in every if after is not before
        )
        if not edits:
            return False
        del self._steps[self._at :]
        self._steps.append(Step(edits, selected, selected, looking))
        self._at += 1
        for edit in edits:
            self._exchange(edit.file, edit.after)
        return True

    @property
    def undo_text(self) -> str | None:
        """The name of the step that undo takes back; None where there is none."""
        return self._steps[self._at - 1].edits[0].text if self._at else None

    @property
    def redo_text(self) -> str | None:
        return self._steps[self._at].edits[0].text if self._at < len(self._steps) else None

    def undo(self, selected: Selection = ()) -> None:
        """Takes the last step back; does nothing where there is none.

        selected: what is selected now, which redo brings back.
        """
        if not self._at:
            return
        self._at -= 1
        step = self._steps[self._at]
        step.after = selected
        for edit in reversed(step.edits):
            self._exchange(edit.file, edit.before)
        self.selected.emit(step.edits[0].file, step.before, step.looking)

    def redo(self) -> None:
        """Does the step again that undo took back last; does nothing where there is none."""
        if self._at == len(self._steps):
            return
        step = self._steps[self._at]
        self._at += 1
        for edit in step.edits:
            self._exchange(edit.file, edit.after)
        self.selected.emit(step.edits[0].file, step.after, step.looking)

    @property
    def dirty(self) -> list[str]:
        """The files whose document is not what was last read or saved."""
        return [f for f in self.files if self.document(f) is not self._saved.get(f)]

    # -- saving ------------------------------------------------------------------

    @property
    def saved_at(self) -> datetime | None:
        """When ``save`` last wrote; None before that."""
        return self._saved_at

    def conflicts(self) -> list[str]:
        """The dirty files that another program changed since they were read or saved here."""
        return [f for f in self.dirty if self._digest(f) != self._on_disk.get(f)]

    def save(self) -> None:
        """Writes every dirty document, canonically and atomically; see ``conflicts`` first.

        Raises UsageError where a file can not be written; those written before it count as saved.
        """
        for file in self.dirty:
            document = self._value(file)
            if self.is_incomplete(file):
                raise UsageError(
                    f"{file} is not saved: it has errors, and what they name would be lost"
                )
            folder.write(self.root / file, codec.write(document))
            self._saved[file] = document
            self._on_disk[file] = self._digest(file)
        self._saved_at = self._now()
        self._watch()
        self.stack_changed.emit()

    def take_from_disk(self, file: str) -> None:
        """Reads ``file`` anew, as a step that can be undone.

        Raises UsageError, naming the first problem, where it can not be read without errors.
        """
        try:
            data = (self.root / file).read_bytes()
        except OSError as error:
            raise UsageError(f"{file}: cannot be read: {error.strerror or error}") from error
        document, problems = codec.read(data, file)
        errors = [p for p in problems if p.severity == "error"]
        if errors:
            raise UsageError(str(errors[0]))
        if document is None or not isinstance(document, type(self._value(file))):
            raise UsageError(f"{file}: of another kind now")
        self._on_disk[file] = hashlib.sha256(data).digest()
        self._saved[file] = document
        self._commit({file: document}, self.tr("Take {0} from disk").format(file))

    def keep_mine(self, file: str) -> None:
        """The document here goes before what another program wrote: the next save overwrites it."""
        self._on_disk[file] = self._digest(file)
        if not self.is_incomplete(file):
            self._saved.pop(file, None)
        self.stack_changed.emit()

    def on_file_changed(self, path: str) -> None:
        """A file of the project may have changed on disk; tells those that really did."""
        self._watch()
        if self._project is None:
            return
        for file in self.files:
            if self.root / file != Path(path) or self._digest(file) == self._on_disk.get(file):
                continue
            self.changed_on_disk.emit(file)

    # -- problems ----------------------------------------------------------------

    def check_now(self) -> None:
        """Finds the problems of the project as it is now, and waits for them."""
        self._check_soon.stop()
        if self._project is not None:
            self._on_found(self._project, check(self._project))

    def _check(self) -> None:
        """Has the problems found; those of a large project come later."""
        if self._project is not None:
            self._checker.ask(self._project)

    def _on_found(self, project: Project, found: list[Problem]) -> None:
        if project is not self._project:
            return
        unread = [p for p in self._read_problems if not self._edited_since(p)]
        self._keep_problems(merge(unread, found))
        self.problems_changed.emit()

    def _keep_problems(self, problems: list[Problem]) -> None:
        self._problems = problems
        self._by_file = {}
        for problem in problems:
            file = self.file_of(problem)
            if file is not None:
                self._by_file.setdefault(file, []).append(problem)

    def file_of(self, problem: Problem) -> str | None:
        """The document that a problem is about; None for one about the project itself."""
        if problem.file not in self._called:
            root = self.root
            self._called[problem.file] = next(
                (f for f in self.files if problem.file == f or Path(problem.file) == root / f), None
            )
        return self._called[problem.file]

    def problems_of(self, file: str) -> list[Problem]:
        """The problems of one document, as ``problems`` has them."""
        return self._by_file.get(file, [])

    # -- inside ------------------------------------------------------------------

    def _edited_since(self, problem: Problem) -> bool:
        """Whether a problem of reading is about a document that is not as it was read."""
        file = self.file_of(problem)
        return file is not None and self.document(file) is not self._read.get(file)

    def _open_project(self) -> Project:
        if self._project is None:
            raise UsageError("no project is open")
        return self._project

    def _value(self, file: str) -> Document:
        document = self.document(file)
        if document is None:
            raise UsageError(f"{file} is no document of this project")
        return document

    def _exchange(self, file: str, document: Document | None) -> None:
        project = self._open_project()
        listed = self.document(file) is not None
        if document is None:
            project = replace(project, parts={f: a for f, a in project.parts.items() if f != file})
        elif not listed:
            assert isinstance(document, Application)
            project = replace(project, parts={**project.parts, file: document})
            self._on_disk.setdefault(file, self._digest(file))
        elif isinstance(document, Application):
            kind = "parts" if file in project.parts else "applications"
            project = replace(project, **{kind: {**getattr(project, kind), file: document}})
        elif isinstance(document, Spds):
            project = replace(project, spds=document)
        else:
            assert isinstance(document, Modules)
            project = replace(project, modules=document)
        self._project = project
        self._check_soon.start()
        if listed != (document is not None):
            self._called = {}
            self.listed.emit()
        self.changed.emit(file)
        self.stack_changed.emit()

    def _digest(self, file: str) -> bytes:
        try:
            return hashlib.sha256((self.root / file).read_bytes()).digest()
        except OSError:
            return b""

    def _watch(self) -> None:
        # A file that was exchanged as a whole (as we save) drops out of the watcher.
        wanted = [str(self.root / file) for file in self.files]
        unwanted = [f for f in self._watcher.files() if f not in wanted]
        if unwanted:
            self._watcher.removePaths(unwanted)
        new = [f for f in wanted if f not in self._watcher.files() and Path(f).exists()]
        if new:
            self._watcher.addPaths(new)
