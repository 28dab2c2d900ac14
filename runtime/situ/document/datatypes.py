"""The types of attributes and texts: read, write, rule, and RELAX NG pattern of each.

Reading (``parse``) refuses only what a value cannot hold: ``x="abc"``. What it
can hold but must not be (``timeout`` 0, a tag with a blank) is the ``rule``,
which ``situ.document.check`` applies, so that a value made by the editor is
judged like one that was read.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from decimal import Decimal
from typing import Any

from msgspec import Struct

from situ.document import names

_DECIMAL = re.compile(r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)")
_INTEGER = re.compile(r"[+-]?[0-9]{1,18}")

WHITE = " \t\r\n"
"""White space as XML has it; what stands at both ends of a text does not count."""


class Type(Struct, frozen=True):
    """What an attribute or text holds.

    parse: text to value, ValueError with plain words where it cannot be; None: as it is.
    write: value to text, in the shortest form; None: as it is.
    rule: why a value may not stand here, in plain words that follow what it is
        (``is no tag: …``), or None where it may; None: everything may.
    schema: RELAX NG pattern for the text.
    blank: what stands in for a missing required one, so that reading can go on.
    code: that of the problem where the rule is broken.
    """

    schema: str
    parse: Callable[[str], Any] | None = None
    write: Callable[[Any], str] | None = None
    rule: Callable[[Any], str | None] | None = None
    blank: Any = ""
    code: str = "bad-value"


def shown(text: str) -> str:
    """A piece of the user's text as problems quote it: one line, not long."""
    return f'"{short(" ".join(text.split()))}"'


def short(text: str) -> str:
    """At most 40 characters of a text."""
    return text if len(text) <= 40 else text[:37] + "..."


def number(text: str) -> float:
    """A decimal number without exponent; ValueError for anything else."""
    if _DECIMAL.fullmatch(text) is None:
        raise ValueError(f"is no number: {shown(text)}")
    value = float(text)
    if not math.isfinite(value):
        raise ValueError(f"is too large a number: {shown(text)}")
    return value


def _integer(text: str) -> int:
    if _INTEGER.fullmatch(text) is None:
        raise ValueError(f"is no whole number: {shown(text)}")
    return int(text)


def write_number(value: float) -> str:
    """The shortest decimal that reads as the same number: ``10``, ``1.5``."""
    if value == int(value):
        return str(int(value))
    return format(Decimal(repr(float(value))), "f")


def _boolean(text: str) -> bool:
    if text == "true":
        return True
    if text == "false":
        return False
    raise ValueError(f'is neither "true" nor "false": {shown(text)}')


def _write_boolean(value: bool) -> str:
    return "true" if value else "false"


def _priority(text: str) -> int | None:
    if text == "none":
        return None
    if _INTEGER.fullmatch(text) is None:
        raise ValueError(f'is neither a whole number nor "none": {shown(text)}')
    return int(text)


def _write_priority(value: int | None) -> str:
    return "none" if value is None else str(value)


def _resources(text: str) -> tuple[str, ...]:
    return tuple(text.split())


def _pattern(text: str) -> str:
    return f'<data type="string"><param name="pattern">{text}</param></data>'


def _number(limit: str = "") -> str:
    # Not xsd:decimal: libxml2 takes at most 24 digits of one.
    pattern = r"[+\-]?([0-9]+(\.[0-9]*)?|\.[0-9]+)"
    return f'<data type="double"><param name="pattern">{pattern}</param>{limit}</data>'


def _tag_rule(value: str) -> str | None:
    if names.is_tag(value):
        return None
    return (
        f"is no tag: {shown(value)}; a tag is words of a-z, 0-9, _ and - joined by dots, "
        "each beginning with a letter"
    )


def _name_rule(value: str) -> str | None:
    if names.is_name(value):
        return None
    return (
        f"is no name of a value: {shown(value)}; write a tag, or a tag and fields, "
        "such as patient.room"
    )


def _pattern_rule(value: str) -> str | None:
    if names.is_pattern(value):
        return None
    return f"is no tag or pattern: {shown(value)}; write a tag, or one with * or ** for words"


def _token_rule(value: str) -> str | None:
    if value and not value.startswith("#") and not any(c.isspace() for c in value):
        return None
    return f"cannot be {shown(value)}: write something without blanks that does not begin with #"


def _title_rule(value: str) -> str | None:
    if value and value == value.strip() and not any(c in "/{}*" or c < " " for c in value):
        return None
    return f"cannot be {shown(value)}: write a name without / {{ }} * and blanks at its ends"


def _resources_rule(value: tuple[str, ...]) -> str | None:
    for one in value:
        problem = _title_rule(one)
        if problem is not None:
            return problem
        if value.count(one) > 1:
            return f"name {shown(one)} twice: once is enough"
    return None


def _some_rule(value: str) -> str | None:
    return None if value.strip() else "is empty: write something, or leave it out"


def _seconds_rule(value: float) -> str | None:
    if value > 0:
        return None
    return f"must be above 0 seconds, not {write_number(value)}"


def _count_rule(value: int) -> str | None:
    return None if value > 0 else f"must be at least 1, not {value}"


def _size_rule(value: float) -> str | None:
    return None if value >= 0 else f"must not be below 0: {write_number(value)}"


_TAG = r"[a-z][a-z0-9_\-]*(\.[a-z][a-z0-9_\-]*)*"
_PART = r"[\w_\-]+( [\w_\-]+)*"
_ROOT = r"(robot|module|application|service)"
_WORD = r"(\*\*?|[a-z][a-z0-9_\-]*)"

TEXT = Type("<text/>")
SOME = Type(
    '<data type="string"><param name="minLength">1</param></data>',
    rule=_some_rule,
)
TAG = Type(_pattern(rf"{_TAG}|{_ROOT}(/{_PART})+"), rule=_tag_rule, code="bad-tag")
NAME = Type(
    _pattern(rf"([a-z][a-z0-9_\-]*|{_ROOT}(/{_PART})+)(\.[\w_\-]+)*"),
    rule=_name_rule,
    code="bad-name",
)
PATTERN = Type(
    _pattern(rf"{_WORD}(\.{_WORD})*|{_ROOT}(/(\*\*?|{_PART}))+"),
    rule=_pattern_rule,
    code="bad-tag",
)
TOKEN = Type(_pattern(r"[^\s#]\S*"), rule=_token_rule)
TARGET = Type(_pattern(r"[^\s#]\S*|#again|#back"))
TITLE = Type(_pattern(r"[^\s/{}*]([^/{}*]*[^\s/{}*])?"), rule=_title_rule, code="bad-name")
RESOURCES = Type(
    "<list><zeroOrMore>" + _pattern(r"[^\s/{}*]+") + "</zeroOrMore></list>",
    parse=_resources,
    write=" ".join,
    rule=_resources_rule,
    blank=(),
)
NUMBER = Type(_number(), parse=number, write=write_number, blank=0.0)
SIZE = Type(
    _number('<param name="minInclusive">0</param>'),
    parse=number,
    write=write_number,
    rule=_size_rule,
    blank=0.0,
)
SECONDS = Type(
    _number('<param name="minExclusive">0</param>'),
    parse=number,
    write=write_number,
    rule=_seconds_rule,
    code="bad-time",
    blank=1.0,
)
COUNT = Type('<data type="positiveInteger"/>', parse=_integer, write=str, rule=_count_rule, blank=1)
PRIORITY = Type(
    '<choice><value>none</value><data type="integer"/></choice>',
    parse=_priority,
    write=_write_priority,
    blank=None,
)
BOOLEAN = Type(
    "<choice><value>true</value><value>false</value></choice>",
    parse=_boolean,
    write=_write_boolean,
    blank=False,
)


def choice(*allowed: str) -> Type:
    """One of a few words."""

    def parse(text: str) -> str:
        if text in allowed:
            return text
        *most, last = (f'"{word}"' for word in allowed)
        raise ValueError(f"must be {', '.join(most)} or {last}, not {shown(text)}")

    values = "".join(f"<value>{word}</value>" for word in allowed)
    return Type(f"<choice>{values}</choice>", parse=parse, blank=allowed[0])
