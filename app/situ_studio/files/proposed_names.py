"""What another name of a document leads to, while somebody writes it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from situ.document import beside
from situ.document.project import Project
from situ.document.rbd import Application
from situ.errors import UsageError
from situ.rehearse.suite import scenarios
from situ_studio.edits import document_uses as uses
from situ_studio.edits import mentions
from situ_studio.edits.edit import Written, read
from situ_studio.project.session import Session
from situ_studio.wording.language import said, tr


class ProposedNames:
    """Of one file. What does not hang on the name is found once, and not with each key.

    is_own: whether a path is one that the file had here before, and that it may have again.
    """

    def __init__(self, session: Session, file: str, is_own: Callable[[str], bool]) -> None:
        self._session, self._file, self._is_own = session, file, is_own
        self._index = mentions.Index()
        self._values: uses.Values | None = None

    def look_again(self) -> None:
        """What other programs wrote meanwhile counts from here on."""
        self._values = None

    def of(self, name: str, too: bool) -> uses.Renaming | str:
        """What changes where; a line for the user where that can not be. too: the document takes
        the name as its own too.
        """
        file, project = self._file, self._session.project
        document = self._session.document(file)
        if project is None or document is None:
            return tr("{0} is not in this project.").format(file)
        new = uses.renamed_file(file, document, name)
        own = name if too and uses.own_name(document) not in (None, name) else None
        if new == file and own is None:
            return tr("Write another name.")
        wrong = uses.wrong_name(document, name)
        if wrong:
            return wrong
        if new != file and self._is_taken(new):
            return tr("There is a file {0} already: choose another name.").format(new)
        is_module = isinstance(document, Application) and file not in project.parts
        if own is not None and is_module and self._is_module(project, own):
            return tr("There is a module {0} already: choose another name.").format(own)
        try:
            if self._values is None:
                self._values = values(self._session, project)
            return uses.rename(project, self._values, self._index, file, new, own)
        except (UsageError, ValueError) as error:
            return said(str(error))

    def _is_taken(self, new: str) -> bool:
        """Whether the project has such a file, or its folder, where letters' case may not count."""
        others = {one.casefold() for one in self._session.files if one != self._file}
        if new.casefold() in others:
            return True
        path = self._session.root / new
        # Saving would write over one that was deleted, before it is in the waste basket.
        is_own = self._is_own(new) and new in self._session.contents.removed
        if not path.exists() or is_own:
            return False
        here = self._session.root / self._file
        return not (here.exists() and path.samefile(here))

    def _is_module(self, project: Project, name: str) -> bool:
        names = {one.name for one in project.applications.values()}
        return name in names or name in project.declared()


def values(session: Session, project: Project) -> dict[str, Written]:
    """What stands beside the documents, scenarios too.

    UsageError, with one line for the user, where one can not be read or lies elsewhere.
    """
    try:
        every = scenarios(project)
    except UsageError:
        every = []
    root = Path(project.root).resolve()
    named = []
    for one in every:
        there = one.resolve()
        if not there.is_relative_to(root):
            raise UsageError(tr("{0} is not in this project.").format(one.name))
        named.append(there.relative_to(root).as_posix())
    found = {file: session.value(file) for file in (*beside.files(project), *named)}
    for file in named:
        if found[file] is None:
            found[file], _ = read(session.disk.read(file), file)
    return {file: value for file, value in found.items() if value is not None}
