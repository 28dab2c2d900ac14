"""The grammar of tags, names, patterns and references (formats.md, *Values, references*).

A *tag* is where a value stands on the blackboard: dotted words (``user.name``), or
a path under a reserved root (``robot/head``). A *name* is what a designer may
write for a value: a tag, or a tag followed by fields and 0-based places
(``patients.0.roomNumber``). A *pattern* is a tag in which ``*`` stands for one
word or path part and ``**`` for any number of them, none too. A *template* is
text in which ``{name}`` stands for a value.

None of the first three has more than ``LONGEST`` characters: nobody means longer ones, and to
look for the longest tag that begins a name would cost the square of its length.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import lru_cache

RESERVED_ROOTS = ("robot/", "module/", "application/", "service/")
"""Paths below these are the runtime's; ``clear`` never touches them."""

LONGEST = 500

_WORD = r"[a-z][a-z0-9_-]*"
_FIELD = r"[\w-]+"
_PART = r"[\w-]+(?: [\w-]+)*"
_ROOTS = "|".join(root[:-1] for root in RESERVED_ROOTS)
_PATH = rf"(?:{_ROOTS})(?:/{_PART})+"

_TAG = re.compile(rf"{_WORD}(?:\.{_WORD})*|{_PATH}")
_NAME = re.compile(rf"(?:{_PATH}|{_WORD})(?:\.{_FIELD})*")
_PATTERN_WORDS = re.compile(rf"(?:\*\*?|{_WORD})(?:\.(?:\*\*?|{_WORD}))*")
_PATTERN_PATH = re.compile(rf"(?:{_ROOTS})(?:/(?:\*\*?|{_PART}))+")
_PIECE = re.compile(r"\{\{|\}\}|\{([^{}]*)\}")


def is_tag(text: str) -> bool:
    """Whether ``text`` is a tag: something that can be set on the blackboard."""
    return len(text) <= LONGEST and _TAG.fullmatch(text) is not None


def is_name(text: str) -> bool:
    """Whether ``text`` names a value: a tag, perhaps with fields and places behind it."""
    return len(text) <= LONGEST and _NAME.fullmatch(text) is not None


def is_pattern(text: str) -> bool:
    """Whether ``text`` is a pattern; every tag is one too."""
    return len(text) <= LONGEST and bool(
        _PATTERN_WORDS.fullmatch(text) or _PATTERN_PATH.fullmatch(text)
    )


def is_reserved(text: str) -> bool:
    """Whether a tag or pattern stands under a reserved root."""
    return text.startswith(RESERVED_ROOTS)


@lru_cache(maxsize=4096)
def _words(text: str) -> tuple[str, ...]:
    return tuple(text.replace("/", ".").split("."))


def matches(pattern: str, name: str) -> bool:
    """Whether the tag ``name`` fits ``pattern``; linear but for the number of ``**``.

    ``face.*`` fits ``face.visible`` but not ``face``; ``user.**`` fits ``user``,
    ``user.name`` and ``user.name.first``; ``**`` fits every tag.
    """
    if "*" not in pattern:
        return pattern == name
    wanted, given = _words(pattern), name.replace("/", ".").split(".")
    at = to = 0
    star, mark = -1, 0
    while to < len(given):
        if at < len(wanted) and wanted[at] == "**":
            star, mark = at, to
            at += 1
        elif at < len(wanted) and wanted[at] in ("*", given[to]):
            at += 1
            to += 1
        elif star >= 0:
            mark += 1
            at, to = star + 1, mark
        else:
            return False
    return all(word == "**" for word in wanted[at:])


pattern_matches = matches


@lru_cache(maxsize=4096)
def split(text: str) -> tuple[tuple[str, str | None], ...]:
    """A template as pieces ``(literal, name)``: the literal comes first, then the value.

    The last piece has None for its name where literal text ends the template; no
    piece is empty on both sides. ``{{`` and ``}}`` are braces, and braces that
    hold no name are plain text. White space is left as it is: the codec has
    taken it off both ends of what stood between tags.

    >>> split("Hello {user.name}!")
    (('Hello ', 'user.name'), ('!', None))
    """
    pieces: list[tuple[str, str | None]] = []
    literal: list[str] = []
    end = 0
    for match in _PIECE.finditer(text):
        literal.append(text[end : match.start()])
        end = match.end()
        name = match[1]
        if name is None:
            literal.append(match[0][0])
        elif is_name(name):
            pieces.append(("".join(literal), name))
            literal = []
        else:
            literal.append(match[0])
    literal.append(text[end:])
    rest = "".join(literal)
    if rest:
        pieces.append((rest, None))
    return tuple(pieces)


def references(text: str) -> tuple[str, ...]:
    """The names that a template refers to, in the order written, each time it does."""
    return tuple(name for _, name in split(text) if name is not None)


def with_references(text: str, change: Callable[[str], str]) -> str:
    """A template in which every name it refers to is what ``change`` makes of it.

    >>> with_references("Hello {user.name}!", str.upper)
    'Hello {USER.NAME}!'
    """

    def piece(match: re.Match[str]) -> str:
        name = match[1]
        return f"{{{change(name)}}}" if name is not None and is_name(name) else match[0]

    return _PIECE.sub(piece, text)


def only_reference(text: str) -> str | None:
    """The name, where ``text`` is exactly one reference but for white space at both ends."""
    pieces = split(text.strip(" \t\r\n"))
    if len(pieces) == 1 and pieces[0][0] == "":
        return pieces[0][1]
    return None
