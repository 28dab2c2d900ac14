"""Problems: what checks return. One line each: what is wrong, where, what to do."""

from __future__ import annotations

from typing import Literal

from msgspec import Struct

Severity = Literal["error", "warning"]


class Change(Struct, frozen=True):
    """One change to a document, as data (``situ.document.mend`` applies it, ``mend_toml`` those of
    ``situ.toml``).

    path: fields and positions from the document down, ending in what is changed:
    ``("states", 4, "timeout", "idle")``; ``ed:accept`` at its end is that attribute.
    do: ``set`` gives a field the value ``to``; ``insert`` puts ``to`` in at the position in
    which the path ends; ``remove`` takes out what stands there; ``move`` brings it to the
    position ``to``; ``rename``, in ``situ.toml`` only, gives the key in which the path ends the
    name ``to``.
    to: JSON text; a Struct is an object with its class as ``struct``.
    was: what stood there when the mend was made, as JSON; nothing for ``insert``.
    """

    path: tuple[str | int, ...]
    do: Literal["set", "insert", "remove", "move", "rename"] = "set"
    to: str = "null"
    was: str = "null"


class Mend(Struct, frozen=True):
    """How a machine can take a problem away: ``changes``, in order, to the document ``file``.

    file: relative to the project's folder. words: what it does, as a command.
    safe: it is the only sensible mend, and what the robot does stays as it is or was plainly
    meant so: ``situ check --fix`` applies it unasked. All others wait for a person's click.
    """

    file: str
    words: str
    changes: tuple[Change, ...]
    safe: bool = False


class Problem(Struct, frozen=True, kw_only=True):
    """One finding of ``check``.

    file: path as the user gave it. line, column: from 1; 0 where there is no place.
    code: stable, ``kebab-case`` (docs/problems.md has them all). place: the value it is
    about, from the outside in, as the editor's selection names it:
    ``("state", "5", "event", "0")``; in ``situ.toml`` its table, key and position:
    ``("setting", "1", "type")``; empty for the file.
    """

    file: str
    line: int = 0
    column: int = 0
    severity: Severity = "error"
    code: str
    message: str
    place: tuple[str, ...] = ()
    mend: Mend | None = None

    def __str__(self) -> str:
        return f"{self.file}:{self.line}:{self.column}: {self.severity} {self.code} {self.message}"
