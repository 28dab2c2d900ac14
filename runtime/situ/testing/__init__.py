"""A robot in memory, for the tests of module authors; docs/modules.md shows how.

::

    def test_it_nods():
        with situ.testing.robot(modules={"nod": ["head"]}) as robot:
            robot.start(nod, robot.connect(module="nod", resources=["head"]))
            robot.set("speech.acceptable", True)
            assert robot.command("head") == {"pitch": -12}
            robot.pass_time(0.5)

Blackboard, situations, priorities and the client are those of a real robot; only sockets and
the clock are not. Time moves when the test says so, or waits.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

from situ.document.project import Project
from situ.document.ready import load_ready
from situ.document.spds import Declaration, Entry, Situation, Spds
from situ.errors import UsageError
from situ.testing.robot import Robot

__all__ = ["Robot", "robot"]


def robot(
    project: str | Path | Project | None = None,
    *,
    modules: Mapping[str, Iterable[str]] | None = None,
    seed: int = 0,
    auto_finish: float | None = None,
) -> Robot:
    """A robot that runs; end it with ``close`` or by ``with``.

    project: a folder with ``situ.toml``, one ``.rbd.xml`` or ``.spds.xml``, or what was read
    from one. Else modules: name to resources, in one situation that always holds, in which
    the first goes before the second and so on. seed: of everything random. auto_finish:
    seconds after which every action of an application ends well; None: none ever ends.

    Raises UsageError where both are given, or what can not be run.
    """
    if project is None:
        return Robot(_of_modules(modules or {}), seed, auto_finish)
    if modules is not None:
        raise UsageError("give a project, which says what its modules may, or modules, not both")
    ready = project if isinstance(project, Project) else load_ready(project)
    return Robot(ready, seed, auto_finish)


def _of_modules(modules: Mapping[str, Iterable[str]]) -> Project:
    declared = tuple(Declaration(name, tuple(resources)) for name, resources in modules.items())
    entries = tuple(Entry(one.name, len(declared) - number) for number, one in enumerate(declared))
    spds = Spds("test", modules=declared, situations=(Situation("always", entries=entries),))
    return Project(root="", name="test", spds=spds)
