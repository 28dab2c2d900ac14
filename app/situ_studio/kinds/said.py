"""Tests, groups and types in a designer's words."""

from __future__ import annotations

from situ.document.condition import Group, Test

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
    return ", ".join(part for part in (dict(TYPES).get(kind or ""), unit) if part)


def test_words(test: Test) -> str:
    """A test without its tag: ``is true, within 2 s``."""
    if test.test == "exists":
        words = "exists" if test.value == "true" else "is missing"
    else:
        words = f"{dict(TESTS)[test.test]} {test.value}"
    if test.within is not None:
        words += f", within {test.within:g} s"
    if test.hold is not None:
        words += f", for {test.hold:g} s"
    return words


def condition_words(child: Test | Group) -> str:
    """A test or a group in one line: ``patients is not []``."""
    if isinstance(child, Test):
        return f"{child.tag} {test_words(child)}"
    inner = [condition_words(c) for c in child.children]
    if child.kind == "none":
        return f"none of ({'; '.join(inner)})"
    joined = (" and " if child.kind == "all" else " or ").join(inner)
    return f"({joined})" if len(inner) > 1 else joined
