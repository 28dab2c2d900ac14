"""What a check of one file has found, until it becomes problems with line and column."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol

from msgspec import Struct

from situ.document.accept import Accepts, Place
from situ.document.aside import NOTHING, Aside
from situ.document.folder import called, resolve
from situ.document.locate import locate_all
from situ.document.problem import Mend, Problem, Severity

__all__ = ["Disk", "Files", "Finding", "Findings", "Place"]


class Files(Protocol):
    """The files of a project, by their paths relative to its folder."""

    def read(self, file: str) -> bytes | None:
        """What is in a file; None where it cannot be read or lies outside the folder."""

    def inside(self, file: str) -> bool:
        """Whether the path stays in the folder."""

    def has(self, file: str) -> bool:
        """Whether there is such a file in the folder."""


class Disk:
    """The files of a project where they lie."""

    def __init__(self, root: str) -> None:
        self._root = root
        # The same few pictures stand on many screens; the folder is asked once for each.
        self._inside: dict[str, bool] = {}
        self._there: dict[str, bool] = {}

    def read(self, file: str) -> bytes | None:
        place = resolve(self._root, file)
        try:
            return place.read_bytes() if place is not None else None
        except OSError:
            return None

    def inside(self, file: str) -> bool:
        found = self._inside.get(file)
        if found is None:
            found = self._inside[file] = resolve(self._root, file) is not None
        return found

    def has(self, file: str) -> bool:
        found = self._there.get(file)
        if found is None:
            place = resolve(self._root, file)
            found = self._there[file] = place is not None and place.is_file()
        return found


class Finding(Struct, frozen=True):
    code: str
    message: str
    aside: Aside
    place: Place
    severity: Severity
    mend: Mend | None = None


class Findings:
    """Gathers what is wrong in one file of a project."""

    def __init__(self, root: str, file: str) -> None:
        self._root = root
        self.file = file
        self.accepts = Accepts()
        self._found: list[Finding] = []

    @property
    def has_errors(self) -> bool:
        return any(one.severity == "error" for one in self._found)

    def has(self, code: str) -> bool:
        return any(one.code == code for one in self._found)

    def error(
        self,
        code: str,
        message: str,
        aside: Aside = NOTHING,
        place: Place = (),
        mend: Mend | None = None,
    ) -> None:
        self._found.append(Finding(code, message, aside, place, "error", mend))

    def warning(
        self,
        code: str,
        message: str,
        aside: Aside = NOTHING,
        place: Place = (),
        mend: Mend | None = None,
    ) -> None:
        """Unless it is accepted there."""
        if not self.accepts.silences(code, place):
            self._found.append(Finding(code, message, aside, place, "warning", mend))

    def add(self, findings: Iterable[Finding]) -> None:
        """Adds warnings, but for those that are accepted, and those about something that holds
        an error: they may follow from it, and the error comes first.
        """
        wrong = {
            one.place[:size]
            for one in self._found
            if one.severity == "error"
            for size in range(len(one.place) + 1)
        }
        for finding in findings:
            if finding.place not in wrong and not self.accepts.silences(
                finding.code, finding.place
            ):
                self._found.append(finding)

    def problems(self, files: Files) -> list[Problem]:
        """In the order of the file; what was never in it comes last, without a line."""
        if not self._found:
            return []
        wanted = {one.aside.index for one in self._found if one.aside.index >= 0}
        data = files.read(self.file) if wanted else None
        lines = locate_all(data, wanted) if data is not None else {}
        name = called(self._root, self.file)
        made = []
        for one in self._found:
            line, column = lines.get(one.aside.index, (0, 0))
            made.append(
                Problem(
                    file=name,
                    line=line,
                    column=column,
                    severity=one.severity,
                    code=one.code,
                    message=one.message,
                    place=one.place,
                    mend=one.mend,
                )
            )
        return sorted(made, key=lambda p: (p.line == 0, p.line, p.column))
