"""Edits: what every gesture, form and command makes of a document (architecture, idea 1)."""

from __future__ import annotations

from msgspec import Struct

from situ.document.modules import Modules
from situ.document.rbd import Application
from situ.document.spds import Spds

Document = Application | Spds | Modules
"""Any value that is one file of a project."""

Place = tuple[str, ...]
"""What a selection or a problem points at, from the outside in, as ``Problem.place``:
``("state", "5")``, ``("state", "5", "event", "0")``, ``("situation", "sound")``; () is the file."""


class Edit(Struct, frozen=True):
    """One named step of the undo stack: ``file`` turned from ``before`` into ``after``.

    before, after: None where the project did not have, or has no more, that file.
    text: what a designer reads in the Edit menu and the history, such as ``Rename state 5``.
    """

    file: str
    before: Document | None
    after: Document | None
    text: str
