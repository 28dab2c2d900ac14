"""Small projects for the care lints, and what is told of them."""

from __future__ import annotations

from typing import Any

from situ.document import codec, mend
from situ.document.check import check
from situ.document.problem import Problem
from situ.document.project import Project
from situ.document.rbd import Application
from situ.document.spds import Spds

WIDE = 'x="10" y="30" width="80" height="30"'
BUTTON = f'<button id="b" {WIDE} event="click">Yes</button>'
MORNING = "<speech>Good morning, I bring you the newspaper.</speech>"  # 7 words: 2.75 s
TOUCHED = '<event name="click" next="2"/>'
END = '<state no="2" final="true"/>'


def read(text: str) -> Any:
    document, problems = codec.read(text.encode(), "a.xml")
    assert document is not None, problems
    assert not [one for one in problems if one.severity == "error"]
    return document


def app(states: str, name: str = "a") -> Application:
    found: Application = read(
        f'<application name="{name}" xmlns:ed="urn:situ:editor">{states}</application>'
    )
    return found


def state(
    screen: str = "",
    acts: str = "",
    events: str = "",
    rest: str = "",
    no: str = "1",
    attributes: str = "",
) -> str:
    """A state; ``screen``: its components, or a whole ``<screen``."""
    if screen and not screen.startswith("<screen"):
        screen = f"<screen><components>{screen}</components></screen>"
    acts = f"<backgroundactions>{acts}</backgroundactions>" if acts else ""
    events = f"<expectedevents>{events}</expectedevents>" if events else ""
    return f'<state no="{no}" {attributes}>{rest}{screen}{acts}{events}</state>'


def always(screen: str = "", events: str = "", rest: str = "") -> str:
    inner = state(screen, "", events, rest)
    return inner.replace('<state no="1" >', "<always>").replace("</state>", "</always>")


def whole(*applications: str | Application, script: str = "", **fields: Any) -> Project:
    """A whole project; the applications after the first are parts."""
    documents = [one if isinstance(one, Application) else app(one) for one in applications]
    files = {f"{one.name}{at}.rbd.xml": one for at, one in enumerate(documents)}
    first = dict(list(files.items())[:1])
    spds: Spds | None = read(f'<spds name="s">{script}</spds>') if script else None
    return Project(
        root="nowhere",
        name="p",
        toml="situ.toml",
        **{
            "applications": first,
            "parts": {name: one for name, one in files.items() if name not in first},
            "spds": spds,
            "spds_file": "s.spds.xml" if spds is not None else None,
            **fields,
        },
    )


def told(project: Project, code: str) -> list[Problem]:
    found = [problem for problem in check(project) if problem.code == code]
    assert all(problem.severity == "warning" for problem in found)
    return found


def places(project: Project, code: str) -> list[tuple[str, ...]]:
    return [problem.place for problem in told(project, code)]


def mended(project: Project, problem: Problem) -> Project:
    """After the one mend of a problem, which is for a person to decide."""
    assert problem.mend is not None
    assert not problem.mend.safe
    ((_, document),) = mend.mends(project, problem)
    return mend.put(project, problem.mend.file, document)
