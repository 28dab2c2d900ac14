"""What the panel of the problems says of where each is, in few words."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from situ.document.problem import Problem
from situ_studio.edits import words
from situ_studio.edits.edit import Document, Place
from situ_studio.panels.project_tree import stem
from situ_studio.wording.language import tr

if TYPE_CHECKING:
    from situ_studio.project.session import Session


def rows(session: Session, current_file: str | None) -> list[tuple[Problem, str]]:
    """The problems of the project, each with its place; places in other documents name them."""
    return [(problem, where(session, problem, current_file)) for problem in session.problems]


def where(session: Session, problem: Problem, current_file: str | None) -> str:
    """The place of one of the problems, as ``rows`` has it."""
    file = session.file_of(problem)
    document = session.document(file) if file is not None else None
    if document is None:
        return Path(problem.file).name
    if not problem.place:
        return stem(file or "")
    short = _short(document, problem.place)
    other = file != current_file and len(session.files) > 1
    return f"{stem(file or '')}: {short}" if other else short


def _short(document: Document, place: Place) -> str:
    """A problem's place in few words: ``12 SPO2``."""
    if place[0] == "state" and len(place) > 1:
        return words.state_words(document, place[1])
    if place[0] == "always":
        return tr("In every state")
    return place[1] if len(place) > 1 else place[0]
