"""What another program made of a project's files, and which of both stays."""

from __future__ import annotations

from typing import TYPE_CHECKING

from situ.document.check import check
from situ.errors import UsageError
from situ_studio.edits.edit import Written, read
from situ_studio.project.differing import Differing, joined
from situ_studio.wording.language import tr

if TYPE_CHECKING:
    from situ_studio.project.session import Session


class Reconciling:
    """Between the values of one session and what lies on disk of them."""

    def __init__(self, session: Session) -> None:
        self._session = session

    def conflicts(self) -> list[str]:
        """The dirty files that another program changed since they were read or saved here."""
        session = self._session
        return [f for f in session.contents.changed if session.disk.is_other(f)]

    def differing(self, file: str) -> Differing:
        """What was changed here and what by another program since both were the same."""
        contents = self._session.contents
        mine, base, project = contents.need(file), contents.saved(file), contents.project
        if self._session.disk.is_missing(file):
            return Differing(file, mine, base, None, project, gone=True)
        try:
            theirs = self._on_disk(file)
        except UsageError as error:
            return Differing(file, mine, base, None, project, unread=str(error))
        both = joined(base, mine, theirs)
        if both is not None and self._breaks(file, both, (mine, theirs)):
            both = None
        return Differing(file, mine, base, theirs, project, both)

    def _breaks(self, file: str, both: Written, sources: tuple[Written, ...]) -> bool:
        """Whether the project has errors with ``both`` that it has with none of the others."""

        def errors(document: Written) -> set[tuple[str, str]]:
            found = check(self._session.contents.having(file, document))
            return {(p.code, p.message) for p in found if p.severity == "error"}

        return bool(errors(both).difference(*map(errors, sources)))

    def take_theirs(self, file: str) -> None:
        """Reads ``file`` anew, as a step that can be undone.

        Raises UsageError, naming the first problem, where it can not be read without errors.
        """
        document = self._on_disk(file)
        self._take(file, document, document, tr("Take {0} from disk").format(file))

    def take_both(self, file: str) -> None:
        """Joins what was changed here and on disk, as a step that can be undone.

        Raises UsageError where they collide, or the file can not be read without errors.
        """
        found = self.differing(file)
        if found.theirs is None or found.both is None:
            raise UsageError(found.unread or tr("{0}: both changed the same thing").format(file))
        self._take(file, found.theirs, found.both, tr("Join {0} with disk").format(file))

    def keep_mine(self, file: str) -> None:
        """The document here goes before what another program wrote: the next save overwrites it."""
        session = self._session
        session.disk.see(file)
        if not session.is_incomplete(file):
            session.contents.forget_saved(file)
        session.stack_changed.emit()

    def _take(self, file: str, theirs: Written, document: Written, text: str) -> None:
        session = self._session
        session.disk.see(file)
        session.contents.see_saved(file, theirs)
        session.put({file: document}, text)
        session.stack_changed.emit()

    def _on_disk(self, file: str) -> Written:
        document, problems = read(self._session.disk.read(file), file)
        errors = [p for p in problems if p.severity == "error"]
        if errors:
            raise UsageError(str(errors[0]))
        if document is None or not isinstance(document, type(self._session.contents.need(file))):
            raise UsageError(tr("{0} is of another kind now").format(file))
        return document
