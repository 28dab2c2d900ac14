"""Tests, groups and types as a designer chooses them.

Whole conditions in words: ``situ.document.words``.
"""

from __future__ import annotations

from situ_studio.wording.language import translated

TESTS: tuple[tuple[str, str], ...] = (
    ("is", "is"),
    ("isnot", "is not"),
    ("above", "above"),
    ("below", "below"),
    ("atleast", "at least"),
    ("atmost", "at most"),
    ("in", "is one of"),
    ("exists", "exists"),
)
GROUPS: tuple[tuple[str, str], ...] = (
    ("all", "all of these"),
    ("any", "any of these"),
    ("none", "none of these"),
)
TYPES: tuple[tuple[str, str], ...] = (
    ("boolean", "yes or no"),
    ("number", "number"),
    ("text", "text"),
    ("list", "list"),
    ("object", "object"),
)
"""Types of data, and what a designer reads."""


def type_words(kind: str | None, unit: str | None) -> str:
    """``yes or no``, ``number, deg``."""
    called = translated(dict(TYPES).get(kind or "", ""))
    return ", ".join(part for part in (called, unit) if part)
