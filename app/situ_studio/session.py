"""The open project and its one undo stack.

Documents are values: an edit exchanges one for another, undo puts the old one
back, and a document is dirty when it is not the very object that was last read
or saved (architecture, idea 1).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from datetime import datetime
from pathlib import Path

from msgspec.structs import replace
from PySide6.QtCore import QObject, QTimer, Signal

from situ.document import beside, folder
from situ.document.beside import Beside, Toml
from situ.document.catalogue import Catalogue
from situ.document.check import check, merge
from situ.document.folder import PROJECT_FILE
from situ.document.problem import Problem
from situ.document.project import Project
from situ.document.rbd import Application
from situ.errors import UsageError
from situ_studio import project_documents, projects
from situ_studio.checking import Checker
from situ_studio.differing import Differing, joined
from situ_studio.edit import Document, Edit, Lines, Written, read, write
from situ_studio.folder_watch import FolderWatch
from situ_studio.undo import Looking, Selection, Step, UndoStack
from situ_studio.waste_basket import thrown_away


class Session(QObject):
    """One project while it is open in a window.

    now: the wall clock, for *Saved 14:02*. throw_away: puts a file into the waste basket, if it
    can.
    """

    opened = Signal()
    """Another project is open."""
    changed = Signal(str)
    """The document of that file, or what stands in a file beside them, is another value now."""
    listed = Signal()
    """The project has a file more, or one less."""
    selected = Signal(str, tuple, object)
    """Undo or redo brought this selection of that file back, and where its canvas looked."""
    stepped = Signal(str)
    """A step was done, or done again: its name."""
    stepped_back = Signal(str)
    """A step was taken back: its name."""
    stack_changed = Signal()
    """What can be undone, redone or saved is not what it was."""
    problems_changed = Signal()
    changed_on_disk = Signal(str)
    """Another program wrote that file, and the document here is not its content."""
    moved = Signal()
    """The project lies in another folder now."""
    left_over = Signal(str)
    """That file was deleted here, and stays in the folder: another program changed it, or the
    system has no waste basket for it."""
    folder_gone = Signal()
    """The project's folder is not where it was."""

    def __init__(
        self,
        parent: QObject | None = None,
        now: Callable[[], datetime] = datetime.now,
        throw_away: Callable[[Path], bool] = thrown_away,
    ) -> None:
        super().__init__(parent)
        self.now, self.throw_away = now, throw_away
        self._project: Project | None = None
        self._read_problems: list[Problem] = []
        self._problems: list[Problem] = []
        self._by_file: dict[str, list[Problem]] = {}
        # By what problems call a file: the path as the user gave it.
        self._called: dict[str, str | None] = {}
        self._incomplete: dict[str, Written] = {}
        self._beside: dict[str, Beside] = {}
        self._scenarios: dict[str, Lines] = {}
        self._apart: dict[str, Application] = {}
        self._read: dict[str, Written] = {}
        self._saved: dict[str, Written] = {}
        self._removed: dict[str, None] = {}
        self._texts: dict[str, bytes] = {}
        self._stack = UndoStack()
        self._saved_at: datetime | None = None
        self._check_soon = QTimer(self)
        self._check_soon.setSingleShot(True)
        self._check_soon.setInterval(0)
        self._check_soon.timeout.connect(self._check)
        self.checker = Checker(self)
        self.checker.found.connect(self._on_found)
        self.disk = FolderWatch(self)
        self.disk.changed.connect(self.changed_on_disk)
        self.disk.settings_changed.connect(self.read_settings)
        self.disk.gone.connect(self.folder_gone)

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
        return project_documents.files(self._project) if self._project is not None else []

    @property
    def problems(self) -> list[Problem]:
        """What ``check`` found last, with what stopped a file from being read."""
        return self._problems

    def document(self, file: str) -> Document | None:
        """The document of ``file`` as it is now; None for a file the project does not have."""
        project = self._project
        return project_documents.document(project, file) if project is not None else None

    def value(self, file: str) -> Written | None:
        """As ``document``, of the files beside the documents too: what the project consists of,
        its texts; None for one that is not there, or can not be read.
        """
        document = self.document(file)
        if document is not None:
            return document
        return self._beside.get(file) or self._scenarios.get(file)

    def open(self, path: str | Path) -> None:
        """Opens a project in place of the one that was open; nothing is saved.

        Raises UsageError, with one line for the user, where there is nothing to open.
        """
        self.take(*folder.load(path), path)

    def take(self, project: Project | None, problems: list[Problem], path: str | Path) -> None:
        """Opens what ``folder.load`` found at ``path``; as ``open``."""
        if project is None:
            raise UsageError(str(problems[0]) if problems else f"{path}: no project could be read")
        self._project = project
        self._called = {}
        self._read_problems = problems
        self._stack = UndoStack()
        self._saved_at = None
        self._read = {file: self._value(file) for file in self.files}
        self._saved, self._removed = dict(self._read), {}
        self._incomplete = {
            file: document
            for file, document in self._read.items()
            if any(p.severity == "error" and self.file_of(p) == file for p in problems)
        }
        self.disk.begin(Path(project.root), self.files, beside.files(project))
        self._beside, self._scenarios, self._apart = {}, {}, {}
        self._read_beside()
        self._keep_texts()
        self._keep_problems(problems)
        self._check()
        self.opened.emit()
        self.stack_changed.emit()

    def is_incomplete(self, file: str) -> bool:
        """Whether the file has errors, so that its document lacks what they name.

        Such a document can not be changed: saving it would lose that for good.
        """
        if beside.is_beside(file):
            return file not in self._beside and not self.disk.is_missing(file)
        document = self._incomplete.get(file)
        return document is not None and document is self.document(file)

    # -- the undo stack ----------------------------------------------------------

    def commit(
        self,
        file: str,
        after: Written,
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
        changed: Mapping[str, Written | None],
        text: str,
        selected: Selection = (),
        looking: Looking | None = None,
    ) -> bool:
        """Changes several documents as one named step, as ``commit`` does one.

        changed: the file in which it was done stands first; an application in a file that the
        project does not have becomes a new part of it, a script its script, texts in one that is
        not there are begun. None takes a file away: it goes into the waste basket when the
        others are written.
        None is changed, and the answer is False, where one of them is incomplete.
        """
        if any(self.is_incomplete(file) for file in changed):
            return False
        return self._commit(changed, text, selected, looking)

    def _commit(
        self,
        changed: Mapping[str, Written | None],
        text: str,
        selected: Selection = (),
        looking: Looking | None = None,
    ) -> bool:
        every = ((file, self.value(file), after) for file, after in changed.items())
        edits = tuple(
            Edit(f, before, after, text) for f, before, after in every if after is not before
        )
        if not edits:
            return False
        self._stack.add(Step(edits, selected, selected, looking))
        for edit in edits:
            self._exchange(edit.file, edit.after)
        self.stepped.emit(text)
        return True

    @property
    def undo_text(self) -> str | None:
        """The name of the step that undo takes back; None where there is none."""
        return self._stack.undo_text

    @property
    def redo_text(self) -> str | None:
        return self._stack.redo_text

    def undo(self, selected: Selection = ()) -> None:
        """Takes the last step back; does nothing where there is none.

        selected: what is selected now, which redo brings back.
        """
        step = self._stack.back()
        if step is None:
            return
        step.after = selected
        for edit in reversed(step.edits):
            self._exchange(edit.file, edit.before)
        self.selected.emit(step.edits[0].file, step.before, step.looking)
        self.stepped_back.emit(step.edits[0].text)

    def redo(self) -> None:
        """Does the step again that undo took back last; does nothing where there is none."""
        step = self._stack.forward()
        if step is None:
            return
        for edit in step.edits:
            self._exchange(edit.file, edit.after)
        self.selected.emit(step.edits[0].file, step.after, step.looking)
        self.stepped.emit(step.edits[0].text)

    @property
    def dirty(self) -> list[str]:
        """The files whose document is not what was last read or saved, and those taken away."""
        return [*self._changed, *self.removed]

    @property
    def _changed(self) -> list[str]:
        every = (*self.files, *self._beside, *self._scenarios)
        return [f for f in every if self.value(f) is not self._saved.get(f)]

    @property
    def removed(self) -> list[str]:
        """The files that were taken away, and lie in the folder until the project is saved."""
        return [f for f in self._removed if f not in self.files]

    # -- saving ------------------------------------------------------------------

    @property
    def saved_at(self) -> datetime | None:
        """When ``save`` last wrote; None before that."""
        return self._saved_at

    def conflicts(self) -> list[str]:
        """The dirty files that another program changed since they were read or saved here."""
        return [f for f in self._changed if self.disk.is_other(f)]

    def save(self) -> None:
        """Writes every dirty document, canonically and atomically; see ``conflicts`` first. Then
        puts what was taken away into the waste basket.

        Raises UsageError where a file can not be written; those written before it count as saved,
        and nothing is thrown away.
        """
        try:
            for file in self._changed:
                document = self._value(file)
                if self.is_incomplete(file):
                    raise UsageError(
                        f"{file} is not saved: it has errors, and what they name would be lost"
                    )
                if beside.language_of(file) is not None:
                    (self.root / file).parent.mkdir(exist_ok=True)
                folder.write(self.root / file, write(document))
                self._saved[file] = document
                self.disk.see(file)
            self._saved_at = self.now()
            for file in self.removed:
                self._throw_away(file)
        finally:
            self.disk.watch()
            self.stack_changed.emit()

    def _throw_away(self, file: str) -> None:
        path = self.root / file
        del self._removed[file]
        if not self.disk.is_missing(file):
            # Where letters' case does not count, another name may be the same file.
            same = any(path.samefile(self.root / f) for f in self.files if f != file)
            if same or self.disk.is_other(file) or not self.throw_away(path):
                if not same:
                    self.left_over.emit(file)
                return
        self._saved.pop(file, None)
        self.disk.forget(file)

    def attend(self, scenarios: Iterable[str]) -> None:
        """Scenarios that are about to be changed here are values like others from now on."""
        for file in scenarios:
            if file not in self._scenarios and not self.disk.is_missing(file):
                value, _ = read(self.disk.read(file), file)
                assert isinstance(value, Lines)
                self._scenarios[file] = self._saved[file] = value
                self.disk.see(file)

    def differing(self, file: str) -> Differing:
        """What was changed here and what by another program since both were the same."""
        mine, base = self._value(file), self._saved.get(file)
        if self.disk.is_missing(file):
            return Differing(file, mine, base, None, self._open_project(), gone=True)
        try:
            theirs = self._on_disk(file)
        except UsageError as error:
            return Differing(file, mine, base, None, self._open_project(), unread=str(error))
        both = joined(base, mine, theirs)
        if both is not None and self._breaks(file, both, (mine, theirs)):
            both = None
        return Differing(file, mine, base, theirs, self._open_project(), both)

    def _breaks(self, file: str, both: Written, sources: tuple[Written, ...]) -> bool:
        """Whether the project has errors with ``both`` that it has with none of the others."""

        def errors(document: Written) -> set[tuple[str, str]]:
            found = check(self._with(file, document))
            return {(p.code, p.message) for p in found if p.severity == "error"}

        return bool(errors(both).difference(*map(errors, sources)))

    def take_from_disk(self, file: str) -> None:
        """Reads ``file`` anew, as a step that can be undone.

        Raises UsageError, naming the first problem, where it can not be read without errors.
        """
        document = self._on_disk(file)
        self._take(file, document, document, self.tr("Take {0} from disk").format(file))

    def take_both(self, file: str) -> None:
        """Joins what was changed here and on disk, as a step that can be undone.

        Raises UsageError where they collide, or the file can not be read without errors.
        """
        found = self.differing(file)
        if found.theirs is None or found.both is None:
            raise UsageError(found.unread or f"{file}: both changed the same thing")
        self._take(file, found.theirs, found.both, self.tr("Join {0} with disk").format(file))

    def _take(self, file: str, theirs: Written, document: Written, text: str) -> None:
        self.disk.see(file)
        self._saved[file] = theirs
        self._commit({file: document}, text)
        self.stack_changed.emit()

    def _on_disk(self, file: str) -> Written:
        document, problems = read(self.disk.read(file), file)
        errors = [p for p in problems if p.severity == "error"]
        if errors:
            raise UsageError(str(errors[0]))
        if document is None or not isinstance(document, type(self._value(file))):
            raise UsageError(f"{file}: of another kind now")
        return document

    def keep_mine(self, file: str) -> None:
        """The document here goes before what another program wrote: the next save overwrites it."""
        self.disk.see(file)
        if not self.is_incomplete(file):
            self._saved.pop(file, None)
        self.stack_changed.emit()

    def read_settings(self) -> None:
        """Reads anew what the project consists of; its documents stay as they are here, and what
        was changed here beside them.

        A file that came is read; one that is named no more goes, unless it is not saved yet.
        Where that can not be read, everything stays as it is.
        """
        for file in self.dirty:
            if file in self._beside and self.disk.is_other(file):
                self.changed_on_disk.emit(file)
        before = self._open_project()
        try:
            project, problems = folder.load(before.root)
        except UsageError:
            return
        if project is None or any(p.severity == "error" for p in problems):
            return
        mine = {file: self._value(file) for file in self.files}
        dirty = self.dirty
        self._project = project
        there = (*self.files, *self._beside, *self._scenarios)
        kept = [file for file in dirty if file not in there]
        other = [f for f in self.files if f in mine and type(mine[f]) is not type(self.document(f))]
        if kept or other:
            # Somebody works on what would go.
            self._project = before
            return
        new = [file for file in self.files if file not in mine]
        for file in self.files:
            if file in new:
                self._read[file] = self._saved[file] = self._value(file)
                self.disk.see(file)
            else:
                self._project = self._with(file, mine[file])
        gone = mine.keys() - set(self.files)
        self._stack.forget(gone)
        self._saved = {f: d for f, d in self._saved.items() if f not in gone}
        self._called = {}
        self._read_beside(kept=dirty)
        self._keep_texts()
        self._check_soon.start()
        self.listed.emit()
        self.stack_changed.emit()

    def _read_beside(self, kept: Sequence[str] = ()) -> None:
        """Takes the files beside the documents as they lie there, but for those to be kept."""
        stay = {file: self._beside[file] for file in kept if file in self._beside}
        if stay:
            # First of all for its languages, whose texts are read here too.
            self._project = beside.settled(self._open_project(), stay)
        self.disk.attend(self.files, beside.files(self._open_project()))
        for file in beside.files(self._open_project()):
            if file not in stay:
                self._take_beside(file)
        self._called = {}
        if stay:
            self._project = beside.settled(self._open_project(), self._beside)

    def _take_beside(self, file: str) -> None:
        """Takes one of them as it lies there; a step more, where steps lead to what it was."""
        found = None
        if not self.disk.is_missing(file):
            found, _ = beside.read(self.disk.read(file), file)
        self.disk.see(file)
        before = self._beside.get(file)
        if found is None:
            if self._beside.pop(file, None) is not None:
                self._stack.forget({file})
            return
        if found == before:
            found = before
        elif self._stack.leads_to(file):
            text = self.tr("Take {0} from disk").format(file)
            self._stack.add(Step((Edit(file, before, found, text),)))
        self._beside[file] = self._saved[file] = self._read[file] = found

    def _keep_texts(self) -> None:
        """What stands beside the documents is known here, whatever becomes of the folder."""
        self._texts = {}
        for file in beside.files(self._open_project()):
            if not self.disk.is_missing(file):
                self._texts[file] = self.disk.read(file)

    def save_copy(self, parent: Path) -> None:
        """Puts the project, as it is here, into a folder of its own below ``parent``, and goes on
        there; where it came from stays as it is.

        Raises UsageError where it can not be made, or where a file of it has errors.
        """
        for file in self.files:
            if self.is_incomplete(file):
                raise UsageError(f"{file} has errors: mend them first, or they would be lost")
        every = (*self.files, *self._beside, *self._scenarios)
        documents = {file: self._value(file) for file in every}
        target = projects.copy_project(self._open_project(), self._texts, parent)
        for file, document in documents.items():
            (target / file).parent.mkdir(parents=True, exist_ok=True)
            folder.write(target / file, write(document))
        first = "" if self._open_project().toml is not None else self.files[0]
        self.move(target / first)
        self._saved.update(documents)
        self.disk.begin(target, self.files, beside.files(self._open_project()))
        self._saved_at = self.now()
        self.stack_changed.emit()

    def move(self, root: Path) -> None:
        """The project lies at ``root`` now: its documents are saved there from here on.

        Raises UsageError where there is no project. Nothing is read from there but the documents
        that are not changed here.
        """
        project, problems = folder.load(root)
        if project is None:
            raise UsageError(str(problems[0]) if problems else f"{root}: no project")
        self._project = replace(self._open_project(), root=project.root)
        self._called = {}
        self.disk.move(Path(project.root))
        self.moved.emit()
        self.stack_changed.emit()

    # -- problems ----------------------------------------------------------------

    def check_now(self) -> None:
        """Finds the problems of the project as it is now, and waits for them."""
        self._check_soon.stop()
        if self._project is not None:
            self._on_found(self._project, check(self._project))

    def _check(self) -> None:
        """Has the problems found; those of a large project come later."""
        if self._project is not None:
            self.checker.ask(self._project)

    def _on_found(self, project: Project, found: list[Problem]) -> None:
        if project is not self._project:
            return
        unread = [p for p in self._read_problems if not self._edited_since(p)]
        for file, value in self._beside.items():
            if value is not self._read.get(file):
                unread += beside.problems(project, file, value)
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
        """The document that a problem is about, or the file beside them; None: another one."""
        if problem.file not in self._called:
            root = self.root
            self._called[problem.file] = next(
                (
                    f
                    for f in (*self.files, *self._beside)
                    if problem.file == f or Path(problem.file) == root / f
                ),
                None,
            )
        return self._called[problem.file]

    def problems_of(self, file: str) -> list[Problem]:
        """The problems of one document, as ``problems`` has them."""
        return self._by_file.get(file, [])

    # -- inside ------------------------------------------------------------------

    def _edited_since(self, problem: Problem) -> bool:
        """Whether a problem of reading is about a document that is not as it was read."""
        file = self.file_of(problem)
        return file is not None and self.value(file) is not self._read.get(file)

    def _open_project(self) -> Project:
        if self._project is None:
            raise UsageError("no project is open")
        return self._project

    def _value(self, file: str) -> Written:
        document = self.value(file)
        if document is None:
            raise UsageError(f"{file} is no document of this project")
        return document

    def _with(self, file: str, document: Written) -> Project:
        """The project with another document in a file that it has."""
        project = self._open_project()
        if isinstance(document, Lines):
            return project
        if isinstance(document, Toml | Catalogue):
            return beside.settled(project, {**self._beside, file: document})
        return project_documents.exchanged(project, file, document)

    def _exchange(self, file: str, document: Written | None) -> None:
        if beside.is_beside(file):
            self._exchange_beside(file, document)
            return
        if isinstance(document, Lines):
            self._scenarios[file] = document
            self.changed.emit(file)
            self.stack_changed.emit()
            return
        project = self._open_project()
        listed = self.document(file) is not None
        if document is None:
            project = project_documents.without(project, file)
            self._apart.pop(file, None)
            if not self.disk.is_missing(file):
                self._removed[file] = None
            self.disk.leave(file)
        elif not listed:
            assert isinstance(document, Document)
            project = project_documents.added(project, file, document)
            if isinstance(document, Application):
                project = self._regrouped(project)
            self._removed.pop(file, None)
            self.disk.see_new(file)
        else:
            project = self._with(file, document)
        self._project = project
        self._check_soon.start()
        if listed != (document is not None):
            self._called = {}
            self.listed.emit()
        self.changed.emit(file)
        self.stack_changed.emit()

    def _exchange_beside(self, file: str, value: Written | None) -> None:
        before = self._open_project()
        if isinstance(value, Toml | Catalogue):
            self._beside[file] = value
        elif self.disk.is_missing(file):
            del self._beside[file]
        else:
            # It was saved before it was taken back.
            is_text = beside.language_of(file) is not None
            self._beside[file] = Catalogue() if is_text else Toml("")
        project = self._regrouped(before) if file == PROJECT_FILE else before
        self._project = project = beside.settled(project, self._beside)
        self._called = {}
        if project.languages != before.languages:
            # A language that came may have had texts here before.
            self.disk.attend(self.files, beside.files(project))
            for other in beside.files(project):
                if other not in self._beside and other not in beside.files(before):
                    self._take_beside(other)
            self._project = beside.settled(project, self._beside)
        self._check_soon.start()
        if [*project.applications] != [*before.applications] or project.name != before.name:
            self.listed.emit()
        self.changed.emit(file)
        self.stack_changed.emit()

    def _regrouped(self, project: Project) -> Project:
        """The project with the applications that its ``situ.toml`` names: those read before, those
        that are read now, not what can not be read. What it has no more is kept for undo.
        """
        toml = self._beside.get(PROJECT_FILE)
        if not isinstance(toml, Toml):
            return project
        for file in beside.applications(toml):
            if file not in project.flows and file not in self._apart:
                self._read_application(file)
        project, gone = beside.grouped(project, toml, self._apart)
        self._apart |= gone
        return project

    def _read_application(self, file: str) -> None:
        if folder.resolve(self.root, file) is None or self.disk.is_missing(file):
            return
        document, problems = read(self.disk.read(file), file)
        if isinstance(document, Application) and not any(p.severity == "error" for p in problems):
            self._apart[file] = self._read[file] = self._saved[file] = document
            self.disk.see(file)
