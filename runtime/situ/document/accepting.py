"""A warning accepted at a click: the ``ed:accept`` that says that it is known and meant."""

from __future__ import annotations

import json

from situ.document.accept import ACCEPT
from situ.document.check import UNUSED
from situ.document.mend import EDITOR_FIELD, of
from situ.document.place import follow
from situ.document.problem import Change, Mend, Problem
from situ.document.project import Project


def accepting(project: Project, file: str, problem: Problem) -> Mend | None:
    """What accepts a warning about ``file``, on the element that it is about.

    None for what can not be accepted (docs/problems.md, *Accepting a warning*): an error, and what
    is told of no document; for what is accepted in vain, which goes instead; and where nothing
    stands at its place any more.
    """
    document = of(project, file)
    if document is None or problem.severity == "error" or problem.code == UNUSED:
        return None
    way = follow(document, problem.place)
    if way is None:
        return None
    path, values = way
    was = values[-1].aside.attribute(ACCEPT)
    codes = (was or "").split()
    if problem.code in codes:
        return None
    to = json.dumps(" ".join((*codes, problem.code)))
    change = Change((*path, EDITOR_FIELD + ACCEPT), "set", to, json.dumps(was, ensure_ascii=False))
    return Mend(file, "Accept this warning", (change,))
