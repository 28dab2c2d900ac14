"""Problems that a file takes away which is not there yet: a script, texts in a language."""

from __future__ import annotations

from typing import TYPE_CHECKING

from msgspec import Struct

from situ.document import beside, catalogue
from situ.document.beside import Toml
from situ.document.folder import PROJECT_FILE
from situ.document.problem import Problem
from situ_studio.edits import new_script
from situ_studio.edits.edit import Written
from situ_studio.texts.model import language_name
from situ_studio.wording.language import tr

if TYPE_CHECKING:
    from situ_studio.project.session import Session


class Begun(Struct, frozen=True):
    """What begins, as a command, and the files that change: the one that is new first."""

    words: str
    files: dict[str, Written]


def begun(session: Session, problem: Problem) -> Begun | None:
    """What takes a problem away; None where that is no new file, or the file is there."""
    project, toml = session.project, session.value(PROJECT_FILE)
    if project is None or not isinstance(toml, Toml):
        return None
    if problem.code == "spds-needed" and new_script.can_begin(project):
        there = new_script.taken(session.root, session.files)
        files = new_script.begun(project, toml, there)
        return Begun(tr("Begin a script of situations"), files)
    if problem.code == "missing-texts" and problem.place[-1:] and problem.place[-1].isdecimal():
        at = int(problem.place[-1])
        language = project.languages[at] if at < len(project.languages) else ""
        file = beside.texts_file(language)
        if language and session.value(file) is None and session.disk.is_missing(file):
            words = tr("Begin the texts in {0}").format(language_name(language))
            return Begun(words, {file: catalogue.empty(project.name, language)})
    return None
