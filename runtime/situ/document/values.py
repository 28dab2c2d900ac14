"""JSON values: compared and read (formats.md, *Values, references, conditions*).

Values are None (missing), bool, int, float, str, list, dict.
"""

from __future__ import annotations

from typing import Any

import msgspec


def equal(one: Any, other: Any) -> bool:
    """Deep equality: numbers by value (``1.0`` is ``1``), ``true`` is never ``1``."""
    if isinstance(one, bool) or isinstance(other, bool):
        return one is other
    if isinstance(one, dict):
        return (
            isinstance(other, dict)
            and one.keys() == other.keys()
            and all(equal(value, other[key]) for key, value in one.items())
        )
    if isinstance(one, list):
        return (
            isinstance(other, list)
            and len(one) == len(other)
            and all(equal(a, b) for a, b in zip(one, other, strict=True))
        )
    return bool(one == other)


def is_number(value: Any) -> bool:
    """Whether the value is a JSON number; true and false are none."""
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def read(text: str) -> Any:
    """The JSON value that ``text`` reads as; the text itself where it reads as none."""
    try:
        return msgspec.json.decode(text)
    except (msgspec.DecodeError, UnicodeEncodeError):
        return text


def reach(value: Any, path: str) -> Any:
    """The value at dotted fields and 0-based places; None where there is none."""
    for part in path.split(".") if path else ():
        if isinstance(value, dict):
            value = value.get(part)
        elif (
            isinstance(value, list) and part.isascii() and part.isdigit() and int(part) < len(value)
        ):
            value = value[int(part)]
        else:
            return None
    return value
