"""XML to values and back (formats.md): the one door to reader and writer.

``write`` is canonical: one order, one indentation, UTF-8, ``\\n``; saving an
unchanged document changes no byte after the first save. ``read`` keeps comments,
processing instructions and what is of foreign namespaces beside the element it
stood at (``situ.document.aside``).

Text: white space (blank, tab, line end) at both ends of an element's text is
taken off; inside it is kept as written. A comment inside a text survives behind it.
"""

from __future__ import annotations

from situ.document.locate import locate_all
from situ.document.modules import Modules
from situ.document.problem import Problem
from situ.document.rbd import Application
from situ.document.reader import MAX_BYTES, MAX_ELEMENTS
from situ.document.reader import read as _read
from situ.document.spds import Spds
from situ.document.writer import write

__all__ = ["Document", "locate", "locate_all", "read", "write"]

Document = Application | Spds | Modules


def read(data: bytes, file: str) -> tuple[Document | None, list[Problem]]:
    """The document in ``data``, or None, and what is wrong with it; never raises.

    ``file`` is what the problems call it. A document that comes with errors lacks
    what they name: good to look at and to check further, never to be saved.
    """
    if _may_be_crowded(data):
        # Counting takes a moment; making all of them, to tell then that it was in vain, seconds.
        place = locate(data, MAX_ELEMENTS)
        if place != (0, 0):
            said = f"The file holds more than {MAX_ELEMENTS} elements: split it into parts"
            line, column = place
            return None, [
                Problem(file=file, line=line, column=column, code="too-many", message=said)
            ]
    return _read(data, file)


def _may_be_crowded(data: bytes) -> bool:
    """Whether there are tags enough for more elements than are read."""
    shortest = len("<a/>")
    if not shortest * MAX_ELEMENTS < len(data) <= MAX_BYTES:
        return False
    return data.count(b"<") - data.count(b"</") > MAX_ELEMENTS


def locate(data: bytes, index: int) -> tuple[int, int]:
    """Line and column, from 1, of the element with this ``Aside.index``; (0, 0): not there."""
    return locate_all(data, {index}).get(index, (0, 0))
