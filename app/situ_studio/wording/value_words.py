"""Values of the blackboard as people read them: a record by its names, a list entry by entry."""

from __future__ import annotations

from typing import Any

from situ.decide.values import in_text
from situ.document.values import is_number
from situ_studio.wording.language import tr

LINES = 24
"""Of a long value so many lines are told."""
_SIGNS = {"deg": "°", "%": " %"}


def value_words(value: Any) -> str:
    """In one line: ``text: Yes please, confidence: 0.9``; entries that are records are parted by
    a semicolon.
    """
    return _words(value) if isinstance(value, dict | list) else in_text(value)


def _words(value: Any) -> str:
    if isinstance(value, dict) and value:
        return ", ".join(tr("{0}: {1}").format(key, _inner(one)) for key, one in value.items())
    if isinstance(value, list) and value:
        parted = "; " if any(isinstance(one, dict | list) for one in value) else ", "
        return parted.join(map(_words, value))
    return tr("empty") if value in ({}, [], "") else in_text(value)


def _inner(value: Any) -> str:
    """A value within a record: what has commas of its own stands in brackets."""
    several = isinstance(value, dict | list) and len(value) > 1
    return f"({_words(value)})" if several else _words(value)


def value_lines(value: Any) -> str:
    """In several lines: a name or an entry each, what lies deeper further to the right."""
    lines = _lines(value, "")
    kept = lines[:LINES]
    if len(lines) > LINES:
        kept.append(tr("… and {0} lines more").format(len(lines) - LINES))
    return "\n".join(kept)


def _lines(value: Any, before: str) -> list[str]:
    if isinstance(value, dict) and value:
        named = [(tr("{0}:").format(key), one) for key, one in value.items()]
    elif isinstance(value, list) and value:
        named = [(f"{number}.", one) for number, one in enumerate(value, 1)]
    else:
        return [before + _words(value)]
    found = []
    for name, one in named:
        if isinstance(one, dict | list) and one:
            found.append(before + name)
            found += _lines(one, before + "    ")
        else:
            found.append(f"{before}{name} {_words(one)}")
    return found


def number(value: float) -> str:
    """Four digits tell most apart; what stands before the point is written whole up to a million:
    ``0.25``, ``1200``, ``65535``.
    """
    return f"{value:.0f}" if 1e3 <= abs(value) < 1e6 else f"{value:.4g}"


def with_unit(value: Any, unit: str) -> str:
    """A number with its unit: ``2.21 m``, ``40°``; all else as ``value_words``."""
    if not is_number(value):
        return value_words(value)
    written = number(value) if isinstance(value, float) else str(value)
    return written + _SIGNS.get(unit, f" {unit}".rstrip())
