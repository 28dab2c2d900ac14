"""Edits: what every gesture, form and command makes of a document (architecture, idea 1)."""

from __future__ import annotations

from msgspec import Struct

from situ.document import beside, codec
from situ.document.beside import Beside, Toml
from situ.document.catalogue import Catalogue
from situ.document.modules import Modules
from situ.document.problem import Problem
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ.rehearse.suite import ENDING

Document = Application | Spds | Modules
"""Any value that is one file of a project and is drawn."""


class Lines(Struct, frozen=True):
    """A scenario, letter for letter: changed here only where it names what is renamed."""

    text: str


Written = Document | Beside | Lines
"""Any value that is one file of a project: what it consists of, its texts and scenarios, too."""

Place = tuple[str, ...]
"""What a selection or a problem points at, from the outside in, as ``Problem.place``:
``("state", "5")``, ``("state", "5", "event", "0")``, ``("situation", "sound")``; () is the file."""


class Edit(Struct, frozen=True):
    """One named step of the undo stack: ``file`` turned from ``before`` into ``after``.

    before, after: None where the project did not have, or has no more, that file.
    text: what a designer reads in the Edit menu and the history, such as ``Rename state 5``.
    """

    file: str
    before: Written | None
    after: Written | None
    text: str


def read(data: bytes, file: str) -> tuple[Written | None, list[Problem]]:
    """The value of a file of a project by its path; None where there is none, and what is wrong."""
    if file.endswith(ENDING):
        try:
            return Lines(data.decode()), []
        except UnicodeDecodeError:
            # No scenario at all, and what is unsaved of it could not be kept as text.
            return None, []
    return codec.read(data, file) if file.endswith(".xml") else beside.read(data, file)


def write(value: Written) -> bytes:
    """The bytes of a value's file."""
    if isinstance(value, Lines):
        return value.text.encode()
    return beside.write(value) if isinstance(value, Toml | Catalogue) else codec.write(value)
