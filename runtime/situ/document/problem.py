"""Problems: what checks return. One line each: what is wrong, where, what to do."""

from __future__ import annotations

from typing import Literal

from msgspec import Struct

Severity = Literal["error", "warning"]


class Problem(Struct, frozen=True, kw_only=True):
    """One finding of ``check``.

    file: path as the user gave it. line, column: from 1; 0 where there is no place.
    code: stable, ``kebab-case``. place: the value it is about, from the outside in,
    as the editor's selection names it: ``("state", "5", "event", "0")``; empty for the file.
    """

    file: str
    line: int = 0
    column: int = 0
    severity: Severity = "error"
    code: str
    message: str
    place: tuple[str, ...] = ()

    def __str__(self) -> str:
        return f"{self.file}:{self.line}:{self.column}: {self.severity} {self.code} {self.message}"
