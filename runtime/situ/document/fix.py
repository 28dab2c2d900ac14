"""``situ check --fix``: all that a machine may mend unasked is mended, and written.

Only files that change are written, documents canonically and whole. A document with errors of
reading stays as it is: it lacks what could not be read. Of ``situ.toml`` all else stays as it is
written, with errors too.
"""

from __future__ import annotations

from pathlib import Path

from msgspec import Struct

from situ.document import beside, codec, folder, mend, mend_toml
from situ.document.beside import Toml
from situ.document.check import check, merge
from situ.document.codec import Document
from situ.document.mend_toml import FILES as SETTINGS
from situ.document.problem import Mend, Problem
from situ.document.project import Project
from situ.errors import UsageError

ROUNDS = 20
"""How often mends are looked for anew after some were applied: one can make room for the next."""


class Fixed(Struct, frozen=True):
    """What was mended, in the lines of before; what is left, in those of now; and a line for
    each file that could not be written, in which nothing was mended.
    """

    mended: list[Problem]
    left: list[Problem]
    refused: list[str]


def fix(path: str | Path) -> Fixed:
    """Mends the project or document at ``path`` on disk. UsageError where it cannot be read."""
    project, read = folder.load(path)
    found = merge(read, check(project)) if project is not None else read
    first: list[Problem] = []
    refused: list[str] = []
    for _ in range(ROUNDS):
        # Before the documents: what is said there decides by what they are judged.
        mended = _mend_settings(project, found, refused) if project is not None else []
        if not mended:
            break
        first += mended
        project, read = folder.load(path)
        found = merge(read, check(project)) if project is not None else read
    if project is None:
        return Fixed(first, read, refused)
    before = project
    unread = {problem.file for problem in read}
    done: list[tuple[Problem, Mend]] = []
    for _ in range(ROUNDS):
        wanted = [
            problem
            for problem in found
            if problem.mend is not None
            and folder.called(project.root, problem.mend.file) not in unread
        ]
        project, mended = mend.safe(project, wanted)
        if not mended:
            break
        done += [(problem, problem.mend) for problem in mended if problem.mend is not None]
        found = merge(read, check(project))
    if not done:
        return Fixed(first, found, refused)
    kept: set[str] = set()
    for file in dict.fromkeys(made.file for _, made in done):
        try:
            _write(before, project, file)
        except UsageError as error:
            refused.append(str(error))
            kept.add(file)
    now, read = folder.load(path)
    left = merge(read, check(now)) if now is not None else read
    mended = [problem for problem, made in done if made.file not in kept]
    return Fixed([*first, *mended], left, refused)


def _mend_settings(project: Project, found: list[Problem], refused: list[str]) -> list[Problem]:
    """What was mended in the files of the settings; ``refused`` gets why a file could not be."""
    wanted = [p for p in found if p.mend is not None and p.mend.safe and p.mend.file in SETTINGS]
    files = {p.mend.file for p in wanted if p.mend is not None}
    names = {file: folder.called(project.root, file) for file in sorted(files)}
    before = {file: Toml(Path(name).read_text("utf-8")) for file, name in names.items()}
    after, mended = mend_toml.every(before, wanted)
    kept: set[str] = set()
    for file, toml in after.items():
        try:
            folder.write(names[file], beside.write(toml))
        except UsageError as error:
            kept.add(file)
            # It is tried anew in every round.
            if str(error) not in refused:
                refused.append(str(error))
    return [p for p in mended if p.mend is not None and p.mend.file not in kept]


def _write(before: Project, after: Project, file: str) -> None:
    was, is_now = mend.of(before, file), mend.of(after, file)
    assert was is not None
    assert is_now is not None
    name = folder.called(before.root, file)
    if not _is_still(name, was):
        raise UsageError(
            f"{name}: changed while it was being mended, so it was left as it is; "
            "run the check again"
        )
    folder.write(name, codec.write(is_now))


def _is_still(name: str, document: Document) -> bool:
    """Whether the file on disk holds this document, comments and positions included."""
    try:
        found, problems = codec.read(Path(name).read_bytes(), name)
    except OSError:
        return False
    return found is not None and not problems and codec.write(found) == codec.write(document)
