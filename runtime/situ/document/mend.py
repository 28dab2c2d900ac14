"""Mends applied: problems taken away by machine.

A mend is data (``situ.document.problem.Mend``); here it becomes another document. What is
not touched, comments and positions included, stays the very object that it was.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any, cast

from msgspec import Struct, structs

from situ.document import condition, modules, rbd, spds
from situ.document.codec import Document
from situ.document.place import Path
from situ.document.problem import Change, Mend, Problem
from situ.document.project import Project

STRUCTS: dict[str, type[Struct]] = {
    one.__name__: one
    for one in (
        condition.Condition,
        condition.Group,
        condition.Test,
        modules.Module,
        rbd.Always,
        rbd.Button,
        rbd.Event,
        rbd.Param,
        rbd.Repeat,
        rbd.Robot,
        rbd.Say,
        rbd.Screen,
        rbd.Sound,
        rbd.Speech,
        rbd.State,
        rbd.Timeout,
        spds.Declaration,
        spds.Entry,
        spds.Observed,
        spds.Situation,
    )
}
"""What a mend may put in."""


EDITOR_FIELD = "ed:"
"""A path that ends in ``ed:NAME`` means that attribute of the editor's namespace."""


class Stale(ValueError):
    """The document is no longer the one that the mend was made for."""


def written(value: Any) -> str:
    """A field's value as JSON text, asides left out."""
    return json.dumps(_plain(value), ensure_ascii=False)


def put_in(path: Path, value: Any) -> Change:
    """The change that puts a value in at the position in which ``path`` ends."""
    return Change(path, "insert", written(value))


def take_out(path: Path, value: Any) -> Change:
    """The change that takes out the value at ``path``."""
    return Change(path, "remove", was=written(value))


def change(path: Path, value: Any, field: str, to: Any) -> Change:
    """The change that gives a field of the value at ``path`` another value."""
    return Change((*path, field), "set", written(to), written(getattr(value, field)))


def apply(document: Document, mend: Mend) -> Document:
    """The document with the mend applied. Stale where what it changes is not there any more."""
    found: Any = document
    for one in mend.changes:
        try:
            found = _changed(found, one.path, one)
        except (AttributeError, IndexError, TypeError) as error:
            raise Stale(str(error)) from error
    return cast("Document", found)


def mends(project: Project, problem: Problem) -> list[tuple[str, Document]]:
    """What can be done about a problem at a click: words, and the document after it.

    The document is that of ``problem.mend.file``. Empty where there is no mend, or where the
    project is no longer the one in which the problem was found.
    """
    mend = problem.mend
    document = of(project, mend.file) if mend is not None else None
    if mend is None or document is None:
        return []
    try:
        return [(mend.words, apply(document, mend))]
    except Stale:
        return []


def safe(project: Project, problems: Iterable[Problem]) -> tuple[Project, list[Problem]]:
    """The project with every safe mend applied that still can be; and the problems it took away."""
    return every(project, [one for one in problems if one.mend is not None and one.mend.safe])


def every(project: Project, problems: Iterable[Problem]) -> tuple[Project, list[Problem]]:
    """The project with every mend applied that still can be; and the problems it took away.

    What two problems have as the very same mend is done once.
    """
    done: list[Problem] = []
    made: set[Mend] = set()
    # From the end of each file, so that the positions of what stands before stay.
    for problem in reversed(list(problems)):
        mend = problem.mend
        document = of(project, mend.file) if mend is not None else None
        if mend is None or document is None:
            continue
        if mend not in made:
            try:
                project = put(project, mend.file, apply(document, mend))
            except Stale:
                continue
            made.add(mend)
        done.append(problem)
    return project, done[::-1]


def of(project: Project, file: str) -> Document | None:
    """The document of a file; None for one that the project does not have."""
    if file == project.spds_file:
        return project.spds
    if file == project.modules_file:
        return project.modules
    return project.applications.get(file) or project.parts.get(file)


def put(project: Project, file: str, document: Document) -> Project:
    """The project with another document in a file that it has."""
    if isinstance(document, rbd.Application):
        kind = "parts" if file in project.parts else "applications"
        return structs.replace(project, **{kind: {**getattr(project, kind), file: document}})
    field = "spds" if isinstance(document, spds.Spds) else "modules"
    return structs.replace(project, **{field: document})


# ------------------------------------------------------------------------------


def _changed(value: Any, path: tuple[str | int, ...], change: Change) -> Any:
    """``value`` with the change made at the end of ``path``, which leads on from it."""
    if len(path) <= 1:
        return _do(value, change)
    step, rest = path[0], path[1:]
    if isinstance(step, int):
        return (*value[:step], _changed(value[step], rest, change), *value[step + 1 :])
    return structs.replace(value, **{step: _changed(getattr(value, step), rest, change)})


def _do(held: Any, change: Change) -> Any:
    last = change.path[-1]
    if change.do == "set":
        assert isinstance(last, str)
        if last.startswith(EDITOR_FIELD):
            return _with_attribute(held, last.removeprefix(EDITOR_FIELD), change)
        if written(getattr(held, last)) != change.was:
            raise Stale(f"{last} is another now")
        return structs.replace(held, **{last: _made(json.loads(change.to))})
    assert isinstance(last, int)
    if change.do == "insert":
        if not 0 <= last <= len(held):
            raise Stale("there is no such position any more")
        return (*held[:last], _made(json.loads(change.to)), *held[last:])
    one = held[last]
    if written(one) != change.was:
        raise Stale("something else stands there now")
    rest = (*held[:last], *held[last + 1 :])
    if change.do == "move":
        to = json.loads(change.to)
        return (*rest[:to], one, *rest[to:])
    if one.aside.before and last < len(rest):
        # A comment that stood before it is kept before what comes now.
        next_ = rest[last]
        aside = structs.replace(next_.aside, before=(*one.aside.before, *next_.aside.before))
        rest = (*rest[:last], structs.replace(next_, aside=aside), *rest[last + 1 :])
    return rest


def _with_attribute(held: Any, name: str, change: Change) -> Any:
    if json.dumps(held.aside.attribute(name), ensure_ascii=False) != change.was:
        raise Stale(f"{name} is another now")
    return structs.replace(held, aside=held.aside.with_attribute(name, json.loads(change.to)))


def _made(value: Any) -> Any:
    if isinstance(value, list):
        return tuple(_made(one) for one in value)
    if isinstance(value, dict):
        fields = {key: _made(one) for key, one in value.items() if key != "struct"}
        return STRUCTS[value["struct"]](**fields)
    return value


def _plain(value: Any) -> Any:
    if isinstance(value, tuple):
        return [_plain(one) for one in value]
    if isinstance(value, Struct):
        held = {
            name: _plain(getattr(value, name))
            for name in value.__struct_fields__
            if name != "aside"
        }
        return {"struct": type(value).__name__, **held}
    return value
