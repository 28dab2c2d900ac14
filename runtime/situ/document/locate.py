"""Lines and columns of elements, found when a problem is printed and never before."""

from __future__ import annotations

from xml.parsers import expat


class _Found(Exception):
    """Everything wanted is found."""


def locate_all(data: bytes, indices: set[int]) -> dict[int, tuple[int, int]]:
    """Line and column, from 1, of the elements with these places in the file (``Aside.index``).

    One pass of the parser, up to the last of them; those that are not there are left out.
    """
    found: dict[int, tuple[int, int]] = {}
    if not indices:
        return found
    last = max(indices)
    count = -1
    parser = expat.ParserCreate("utf-8")

    def start(_name: str, _given: dict[str, str]) -> None:
        nonlocal count
        count += 1
        if count in indices:
            found[count] = (parser.CurrentLineNumber, parser.CurrentColumnNumber + 1)
        if count >= last:
            raise _Found

    def doctype(*_: object) -> None:
        raise _Found

    parser.StartElementHandler = start
    parser.StartDoctypeDeclHandler = doctype
    try:
        parser.Parse(data, True)
    except (_Found, expat.ExpatError):
        return found
    return found
