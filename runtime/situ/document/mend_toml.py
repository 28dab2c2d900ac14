"""Mends of ``situ.toml`` and ``robot.local.toml``: its text changed, everything else as it stands.

The path of a change leads through tables, keys and positions: ``("setting", 1, "type")``. ``set``
takes out what it gives null.
"""

from __future__ import annotations

import json
import tomllib
from collections.abc import Iterable, Sequence
from typing import Any

from situ.document import toml_writing as writing
from situ.document.beside import Toml
from situ.document.folder import LOCAL_FILE, PROJECT_FILE
from situ.document.mend import Stale
from situ.document.problem import Change, Mend, Problem

FILES = (PROJECT_FILE, LOCAL_FILE)


def apply(toml: Toml, mend: Mend) -> Toml:
    """The file with the mend applied. Stale where what it changes is not there any more."""
    for one in mend.changes:
        toml = _changed(toml, one)
    return toml


def every(
    values: dict[str, Toml], problems: Iterable[Problem]
) -> tuple[dict[str, Toml], list[Problem]]:
    """The files, by their names, with every mend of theirs applied that still can be; and the
    problems it took away. What two problems have as the very same mend is done once.
    """
    values = dict(values)
    done: list[Problem] = []
    made: set[Mend] = set()
    # From the end, so that the positions of what stands before stay.
    for problem in reversed(list(problems)):
        mend = problem.mend
        if mend is None or mend.file not in values:
            continue
        if mend not in made:
            try:
                values[mend.file] = apply(values[mend.file], mend)
            except Stale:
                continue
            made.add(mend)
        done.append(problem)
    return values, done[::-1]


def _changed(toml: Toml, change: Change) -> Toml:
    try:
        tables: Any = tomllib.loads(toml.text)
    except tomllib.TOMLDecodeError as error:
        raise Stale(str(error)) from error
    way, last = change.path[:-1], change.path[-1]
    holder = tables
    try:
        for step in way:
            holder = holder[step]
    except (KeyError, IndexError, TypeError) as error:
        raise Stale(f"{step} is not there any more") from error
    if change.do == "insert":
        if not isinstance(holder, list) or not isinstance(last, int) or last > len(holder):
            raise Stale("there is no such position any more")
        value = json.loads(change.to)
        if value in holder:
            return toml
        return _put(toml, way, [*holder[:last], value, *holder[last:]])
    there = holder[last] if _has(holder, last) else None
    if json.dumps(there, ensure_ascii=False, default=str) != change.was:
        raise Stale(f"{last} is another now")
    if isinstance(last, int):
        instead = [] if change.do == "remove" else [json.loads(change.to)]
        return _put(toml, way, [*holder[:last], *instead, *holder[last + 1 :]])
    if change.do == "rename":
        new = json.loads(change.to)
        if new in holder:
            raise Stale(f"{new} is there already")
        return writing.rename_at(toml, change.path, new)
    return _put(toml, change.path, json.loads(change.to))


def _has(holder: Any, last: str | int) -> bool:
    if isinstance(holder, list):
        return isinstance(last, int) and 0 <= last < len(holder)
    return isinstance(holder, dict) and last in holder


def _put(toml: Toml, way: Sequence[Any], value: Any) -> Toml:
    if len(way) == 1:
        return writing.take_out(toml, way[0])
    if len(way) == 2:
        return writing.put(toml, way[0], way[1], value)
    table, key, inner = way
    if table == writing.SETTING:
        return writing.put_setting(toml, key, inner, value)
    return writing.put_in(toml, table, key, inner, value)
