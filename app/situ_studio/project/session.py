"""The open project and its one undo stack.

Documents are values: an edit exchanges one for another, undo puts the old one
back, and a document is dirty when it is not the very object that was last read
or saved (architecture, idea 1).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from datetime import datetime
from pathlib import Path

from msgspec.structs import replace
from PySide6.QtCore import QObject, QTimer, Signal

from situ.document import beside, folder
from situ.document.beside import Beside
from situ.document.check import check, merge
from situ.document.problem import Problem
from situ.document.project import Project
from situ.errors import UsageError
from situ_studio.edits.edit import Document, Edit, Written, write
from situ_studio.problems.checking import Checker
from situ_studio.project import projects
from situ_studio.project.contents import Contents
from situ_studio.project.folder_watch import FolderWatch
from situ_studio.project.reconciling import Reconciling
from situ_studio.project.undo import Looking, Selection, Step, UndoStack
from situ_studio.project.waste_basket import thrown_away
from situ_studio.wording.language import tr


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
        self._contents: Contents | None = None
        self._read_problems: list[Problem] = []
        self._problems: list[Problem] = []
        self._by_file: dict[str, list[Problem]] = {}
        # By what problems call a file: the path as the user gave it.
        self._called: dict[str, str | None] = {}
        self._incomplete: dict[str, Written] = {}
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
        self.reconciling = Reconciling(self)

    # -- the project -------------------------------------------------------------

    @property
    def contents(self) -> Contents:
        """The values of the open project. UsageError while none is open."""
        if self._contents is None:
            raise UsageError(tr("no project is open"))
        return self._contents

    @property
    def project(self) -> Project | None:
        return self._contents.project if self._contents is not None else None

    @property
    def root(self) -> Path:
        """The project's folder. UsageError while none is open."""
        return self.contents.root

    @property
    def files(self) -> list[str]:
        """The files of all documents: applications in their order, their parts, script, modules."""
        return self._contents.files if self._contents is not None else []

    @property
    def problems(self) -> list[Problem]:
        """What ``check`` found last, with what stopped a file from being read."""
        return self._problems

    def document(self, file: str) -> Document | None:
        """The document of ``file`` as it is now; None for a file the project does not have."""
        return self._contents.document(file) if self._contents is not None else None

    def value(self, file: str) -> Written | None:
        """As ``document``, of the files beside the documents too: what the project consists of,
        its texts; None for one that is not there, or can not be read.
        """
        return self._contents.value(file) if self._contents is not None else None

    def open(self, path: str | Path) -> None:
        """Opens a project in place of the one that was open; nothing is saved.

        Raises UsageError, with one line for the user, where there is nothing to open.
        """
        self.take(*folder.load(path), path)

    def take(self, project: Project | None, problems: list[Problem], path: str | Path) -> None:
        """Opens what ``folder.load`` found at ``path``; as ``open``."""
        if project is None:
            raise UsageError(
                str(problems[0]) if problems else tr("{0}: no project could be read").format(path)
            )
        self._contents = contents = Contents(project, self.disk, self._on_taken)
        self._called = {}
        self._read_problems = problems
        self._stack = UndoStack()
        self._saved_at = None
        self._incomplete = {
            file: contents.need(file)
            for file in contents.files
            if any(p.severity == "error" and self.file_of(p) == file for p in problems)
        }
        self.disk.begin(contents.root, contents.files, beside.files(project))
        contents.read_beside()
        self._called = {}
        self._keep_problems(problems)
        self._check()
        self.opened.emit()
        self.stack_changed.emit()

    def is_incomplete(self, file: str) -> bool:
        """Whether the file has errors, so that its document lacks what they name.

        Such a document can not be changed: saving it would lose that for good.
        """
        if beside.is_beside(file):
            return file not in self.contents.beside and not self.disk.is_missing(file)
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
        return self.put(changed, text, selected, looking)

    def put(
        self,
        changed: Mapping[str, Written | None],
        text: str,
        selected: Selection = (),
        looking: Looking | None = None,
    ) -> bool:
        """As ``commit_all``, of incomplete documents too: what lies on disk may be whole again."""
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
        self.selected.emit(step.file, step.before, step.looking)
        self.stepped_back.emit(step.edits[0].text)

    def redo(self) -> None:
        """Does the step again that undo took back last; does nothing where there is none."""
        step = self._stack.forward()
        if step is None:
            return
        for edit in step.edits:
            self._exchange(edit.file, edit.after)
        self.selected.emit(step.file, step.after, step.looking)
        self.stepped.emit(step.edits[0].text)

    @property
    def dirty(self) -> list[str]:
        """The files whose document is not what was last read or saved, and those taken away."""
        contents = self._contents
        return [*contents.changed, *contents.removed] if contents is not None else []

    # -- saving ------------------------------------------------------------------

    @property
    def saved_at(self) -> datetime | None:
        """When ``save`` last wrote; None before that."""
        return self._saved_at

    def save(self) -> None:
        """Writes every dirty document, canonically and atomically; see ``Reconciling.conflicts``
        first. Then puts what was taken away into the waste basket.

        Raises UsageError where a file can not be written; those written before it count as saved,
        and nothing is thrown away.
        """
        contents = self.contents
        try:
            for file in contents.changed:
                document = contents.need(file)
                if self.is_incomplete(file):
                    raise UsageError(
                        tr(
                            "{0} is not saved: it has errors, and what they name would be lost"
                        ).format(file)
                    )
                if beside.language_of(file) is not None:
                    (self.root / file).parent.mkdir(exist_ok=True)
                folder.write(self.root / file, write(document))
                contents.see_saved(file, document)
                self.disk.see(file)
            self._saved_at = self.now()
            for file in contents.removed:
                self._throw_away(file)
            contents.settle_removed()
        finally:
            self.disk.watch()
            self.stack_changed.emit()

    def _throw_away(self, file: str) -> None:
        path = self.root / file
        self.contents.let_go(file)
        if not self.disk.is_missing(file):
            # Where letters' case does not count, another name may be the same file.
            others = (f for f in self.files if f != file and not self.disk.is_missing(f))
            same = any(path.samefile(self.root / f) for f in others)
            if same or self.disk.is_other(file) or not self.throw_away(path):
                if not same:
                    self.left_over.emit(file)
                return
        self.contents.forget_saved(file)
        self.disk.forget(file)

    def read_settings(self) -> None:
        """Reads anew what the project consists of; its documents stay as they are here, and what
        was changed here beside them.

        A file that came is read; one that is named no more goes, unless it is not saved yet.
        Where that can not be read, everything stays as it is.
        """
        contents = self.contents
        for file in self.dirty:
            if file in contents.beside and self.disk.is_other(file):
                self.changed_on_disk.emit(file)
        try:
            project, problems = folder.load(contents.root)
        except UsageError:
            return
        if project is None or any(p.severity == "error" for p in problems):
            return
        dirty = self.dirty
        gone = contents.adopt(project)
        if gone is None:
            return
        self._stack.forget(gone)
        contents.read_beside(kept=dirty)
        self._called = {}
        self._check_soon.start()
        self.listed.emit()
        self.stack_changed.emit()

    def _on_taken(self, file: str, before: Beside | None, after: Beside | None) -> None:
        """A file beside the documents is as it lies on disk: a step more, if steps lead to it."""
        if after is None:
            if before is not None:
                self._stack.forget({file})
        elif after is not before and self._stack.leads_to(file):
            text = tr("Take {0} from disk").format(file)
            self._stack.add(Step((Edit(file, before, after, text),)))

    def save_copy(self, parent: Path) -> None:
        """Puts the project, as it is here, into a folder of its own below ``parent``, and goes on
        there; where it came from stays as it is.

        Raises UsageError where it can not be made, or where a file of it has errors.
        """
        for file in self.files:
            if self.is_incomplete(file):
                lost = tr("{0} has errors: mend them first, or they would be lost")
                raise UsageError(lost.format(file))
        contents = self.contents
        documents = {file: contents.need(file) for file in contents.every}
        target = projects.copy_project(contents.project, contents.texts, parent)
        for file in contents.removed:
            (target / file).unlink(missing_ok=True)
            contents.let_go(file)
            contents.forget_saved(file)
        for file, document in documents.items():
            (target / file).parent.mkdir(parents=True, exist_ok=True)
            folder.write(target / file, write(document))
        for file, document in documents.items():
            contents.see_saved(file, document)
        # Before it is looked for what is other there: that is how it was written here.
        watched = [file for file in documents if not beside.is_beside(file)]
        self.disk.begin(target, watched, beside.files(contents.project))
        self.move(target if contents.project.toml is not None else target / contents.files[0])
        self._saved_at = self.now()
        self.stack_changed.emit()

    def move(self, root: Path) -> None:
        """The project lies at ``root`` now: its documents are saved there from here on.

        Raises UsageError where there is no project. Nothing is read from there but the documents
        that are not changed here.
        """
        project, problems = folder.load(root)
        if project is None:
            raise UsageError(str(problems[0]) if problems else tr("{0}: no project").format(root))
        contents = self.contents
        contents.project = replace(contents.project, root=project.root)
        self._called = {}
        self.disk.move(contents.root)
        self.moved.emit()
        self.stack_changed.emit()

    # -- problems ----------------------------------------------------------------

    def check_now(self) -> None:
        """Finds the problems of the project as it is now, and waits for them."""
        self._check_soon.stop()
        if self.project is not None:
            self._on_found(self.project, check(self.project))

    def _check(self) -> None:
        """Has the problems found; those of a large project come later."""
        if self.project is not None:
            self.checker.ask(self.project)

    def _on_found(self, project: Project, found: list[Problem]) -> None:
        contents = self.contents
        if project is not contents.project:
            return
        unread = [p for p in self._read_problems if not self._edited_since(p)]
        for file, value in contents.beside.items():
            if not contents.is_as_read(file):
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
            contents, root = self.contents, self.root
            self._called[problem.file] = next(
                (
                    f
                    for f in (*contents.files, *contents.beside)
                    if problem.file == f or Path(problem.file) == root / f
                ),
                None,
            )
        return self._called[problem.file]

    def problems_of(self, file: str) -> list[Problem]:
        """The problems of one document, as ``problems`` has them."""
        return self._by_file.get(file, [])

    def _edited_since(self, problem: Problem) -> bool:
        """Whether a problem of reading is about a document that is not as it was read."""
        file = self.file_of(problem)
        return file is not None and not self.contents.is_as_read(file)

    # -- inside ------------------------------------------------------------------

    def _exchange(self, file: str, value: Written | None) -> None:
        contents = self.contents
        before, listing = contents.project, contents.listing
        contents.exchange(file, value)
        if contents.project is not before:
            self._check_soon.start()
        listed = contents.listing != listing
        if listed or beside.is_beside(file):
            self._called = {}
        if listed:
            self.listed.emit()
        self.changed.emit(file)
        self.stack_changed.emit()
