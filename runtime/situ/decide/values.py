"""Values, templates and tests (formats.md, *Values, references, conditions*).

Values are JSON values: None, bool, int, float, str, list, dict. None is *missing*.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any

import msgspec

from situ.document import names
from situ.document.values import equal as equal
from situ.document.values import is_number as is_number
from situ.document.values import read as read

Look = Callable[[str], Any]
"""Gives the value of a name, None where it is missing."""


def in_text(value: Any) -> str:
    """A value as it stands in a text: strings as they are, all else as compact JSON."""
    if value is None:
        return ""
    if isinstance(value, str):
        return value
    return msgspec.json.encode(_whole(value)).decode()


def _whole(value: Any) -> Any:
    if isinstance(value, float) and value.is_integer() and abs(value) < 2**63:
        return int(value)
    if isinstance(value, list):
        return [_whole(entry) for entry in value]
    if isinstance(value, dict):
        return {key: _whole(entry) for key, entry in value.items()}
    return value


class Template:
    """A text with references, taken apart once and filled as often as needed.

    names: the names it refers to. ``text(look)`` is always a string; ``value(look)``
    reads it as ``set``, ``param`` and ``message`` do. ``missing(look)`` lists the
    names that have no value. White space at both ends does not count.
    """

    __slots__ = ("_alone", "_json", "_pieces", "names")

    def __init__(self, text: str) -> None:
        text = text.strip()
        self._pieces = names.split(text)
        self.names = tuple(dict.fromkeys(name for _, name in self._pieces if name is not None))
        only = [(literal, name) for literal, name in self._pieces if literal or name is not None]
        self._alone = only[0][1] if len(only) == 1 and not only[0][0] else None
        self._json = None if self._alone is not None else _read_template(text)

    def text(self, look: Look) -> str:
        return _fill(self._pieces, look)

    def value(self, look: Look) -> Any:
        if self._alone is not None:
            return look(self._alone)
        if self._json is not None:
            return _fill_strings(self._json[0], look)
        return _fill(self._pieces, look)

    def missing(self, look: Look) -> list[str]:
        return [name for name in self.names if look(name) is None]


@lru_cache(maxsize=4096)
def template(text: str) -> Template:
    """The template of a text; the same text is taken apart once."""
    return Template(text)


def _read_template(text: str) -> tuple[Any] | None:
    try:
        return (msgspec.json.decode(text),)
    except (msgspec.DecodeError, UnicodeEncodeError):
        return None


def _fill(pieces: tuple[tuple[str, str | None], ...], look: Look) -> str:
    if len(pieces) == 1 and pieces[0][1] is None:
        return pieces[0][0]
    return "".join(
        literal + (in_text(look(name)) if name is not None else "") for literal, name in pieces
    )


def _fill_strings(value: Any, look: Look) -> Any:
    if isinstance(value, str):
        return _fill(names.split(value), look)
    if isinstance(value, list):
        return [_fill_strings(entry, look) for entry in value]
    if isinstance(value, dict):
        return {key: _fill_strings(entry, look) for key, entry in value.items()}
    return value


# -- tests -------------------------------------------------------------------


def compile_test(test: str, text: str) -> tuple[Callable[[Any, Look], bool], tuple[str, ...]]:
    """One TEST of a condition as ``holds(value, look)``, and the names its value refers to.

    A text that is exactly one reference (allowed in ``when``) is compared with that
    value; every other text with the JSON value it reads as.
    """
    pieces = names.split(text.strip())
    if len(pieces) == 1 and not pieces[0][0] and pieces[0][1] is not None and test != "exists":
        return _compile_reference(test, pieces[0][1]), (pieces[0][1],)
    wanted = read(text)
    if test == "exists":
        expected = wanted is not False
        return lambda value, look: (value is not None) is expected, ()
    if test == "is":
        return compile_is(wanted, text), ()
    if test == "isnot":
        holds = compile_is(wanted, text)
        return lambda value, look: not holds(value, look), ()
    if test == "in":
        members = wanted if isinstance(wanted, list) else []
        return lambda value, look: _in(value, members), ()
    order = _ORDERS[test]
    if is_number(wanted):
        return lambda value, look: is_number(value) and order(value, wanted), ()
    return lambda value, look: isinstance(value, str) and order(value, text), ()


def compile_is(wanted: Any, text: str) -> Callable[[Any, Look], bool]:
    """Whether a value equals what a test's text reads as, or, a string, the text as written."""
    if wanted is None or isinstance(wanted, bool):
        return lambda value, look: (value is wanted and value is not None) or value == text
    if isinstance(wanted, str):
        return lambda value, look: value in (wanted, text)
    return lambda value, look: value is not None and (equal(value, wanted) or value == text)


def _in(value: Any, members: Any) -> bool:
    return value is not None and any(equal(value, member) for member in members)


def _compile_reference(test: str, name: str) -> Callable[[Any, Look], bool]:
    if test == "isnot":
        return lambda value, look: (
            value is None or (other := look(name)) is None or not equal(value, other)
        )
    if test == "is":
        return lambda value, look: (
            value is not None and (other := look(name)) is not None and equal(value, other)
        )
    if test == "in":
        return lambda value, look: isinstance(other := look(name), list) and _in(value, other)
    order = _ORDERS[test]

    def compare(value: Any, look: Look) -> bool:
        other = look(name)
        if is_number(value) and is_number(other):
            return order(value, other)
        return isinstance(value, str) and isinstance(other, str) and order(value, other)

    return compare


_ORDERS: dict[str, Callable[[Any, Any], bool]] = {
    "above": lambda a, b: bool(a > b),
    "below": lambda a, b: bool(a < b),
    "atleast": lambda a, b: bool(a >= b),
    "atmost": lambda a, b: bool(a <= b),
}
