"""Modules in a scenario by their names, letter for letter. Pure; no Qt."""

from __future__ import annotations

import json
import re
from collections.abc import Collection
from functools import partial

from situ_studio.edits.edit import Lines

_NAMING = ("application", "module", "writer")
"""Keys of a scenario under which a module stands by its name."""
_OF_SCRIPT = ("condition", "situation")
"""Kinds of what is expected that there are with a script only."""


def renamed(scenario: Lines, old: str, new: str) -> tuple[Lines, int] | None:
    """The scenario with another name of a module, and in how many lines; None where it names none.

    Only the names change: each line is otherwise written as it was.
    """
    found, count, ways = [], 0, _ways(old)
    for line in scenario.text.split("\n"):
        after = _in_line(line, ways, new)
        found.append(after)
        count += after != line
    return (Lines("\n".join(found)), count) if count else None


def naming(scenario: Lines, names: Collection[str], script: bool = False) -> int:
    """How many of its lines name one of these modules; script: or expect what a script decides."""
    every = {name: _ways(name) for name in names}
    return sum(
        any(_in_line(line, ways, f"{name}-") != line for name, ways in every.items())
        or (script and _expected(line) in _OF_SCRIPT)
        for line in scenario.text.split("\n")
    )


def _ways(name: str) -> dict[str, bool]:
    """How a name is written in JSON, with whether that has ASCII only: each way once, as the new
    name may begin with the old one.
    """
    return {json.dumps(name, ensure_ascii=one)[1:-1]: one for one in (True, False)}


def _in_line(line: str, ways: dict[str, bool], new: str) -> str:
    # Most lines name no module: they need not be read.
    if not any(before in line for before in ways) or _told(line) is None:
        return line
    keys = "|".join((*_NAMING, *(("from", "to") if _expected(line) == "authority" else ())))
    for before, ascii_only in ways.items():
        # A name may have a backslash: no template of a substitution.
        told_as = partial(_put, json.dumps(new, ensure_ascii=ascii_only)[1:-1])
        line = re.sub(rf'("(?:{keys})"\s*:\s*"){re.escape(before)}(?=")', told_as, line)
        line = re.sub(rf'("(?:application|module)/){re.escape(before)}(?=["/.])', told_as, line)
    return line


def _put(name: str, found: re.Match[str]) -> str:
    return found[1] + name


def _told(line: str) -> object:
    """What a line says; None where it can not be read."""
    try:
        return json.loads(line)
    except ValueError:
        return None


def _expected(line: str) -> object:
    """The kind of event that a line expects: of one of authority, ``from`` and ``to`` are modules,
    no states; None where it expects none.
    """
    told = _told(line)
    expected = told.get("expect") if isinstance(told, dict) else None
    return expected.get("kind") if isinstance(expected, dict) else None
