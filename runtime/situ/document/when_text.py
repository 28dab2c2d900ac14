"""A condition as a text of its own: what stands inside of a ``<when>`` (``docs/protocol.md``)."""

from __future__ import annotations

from situ.document import codec
from situ.document.check import check
from situ.document.condition import Condition, Group
from situ.document.project import Project
from situ.document.rbd import Application, Event, State

_AROUND = """<application name="x"><state no="1"><expectedevents><event next="1"><when>
{}
</when></event></expectedevents></state></application>"""


def read(text: str) -> Condition | str:
    """The condition; or in one line why there is none that is judged at a moment."""
    found, problems = codec.read(_AROUND.format(text).encode(), "when")
    if isinstance(found, Application) and not problems:
        problems = check(Project(root=".", name="when", applications={"when": found}))
    for problem in problems:
        if problem.severity == "error":
            return f"the condition can not be read: {problem.message}"
    assert isinstance(found, Application)
    condition = found.states[0].events[0].when
    if condition is None or _counts(condition):
        return "a breakpoint's condition is judged at its moment: it can not have “for”"
    return condition


def write(condition: Condition) -> str:
    """The text that ``read`` reads as this condition."""
    event = Event(next="1", when=condition)
    whole = codec.write(Application(name="x", states=(State(no="1", events=(event,)),))).decode()
    inside = whole.partition("<when>")[2].rpartition("</when>")[0]
    return "\n".join(line.strip() for line in inside.strip().splitlines())


def _counts(part: Condition | Group) -> bool:
    """Whether a test in it has ``for``."""
    return any(
        _counts(child) if isinstance(child, Group) else child.hold is not None
        for child in part.children
    )
