"""Whether a version can run, and what it changes: found beside a robot that runs on meanwhile."""

from __future__ import annotations

from msgspec import Struct
from msgspec.structs import replace

from situ.document.project import Project
from situ.engine.staging import Staging
from situ.engine.versions import Version, Versions, fingerprint
from situ.errors import ProjectError

WORDS = 40
"""Lines of what changed that the history keeps."""


class Checked(Struct):
    """A version that can run. texts: as ``Versions.texts``. restart: the tables of situ.toml that
    differ and count only when the robot is started again; changed: in plain words; given: as in
    ``Current``."""

    project: Project
    texts: dict[str, str]
    restart: tuple[str, ...]
    changed: tuple[str, ...]
    given: str


def add(
    versions: Versions, number: int, staging: Staging, version: Version, running: Project
) -> Checked:
    """Makes what was staged a version. Raises SituError or OSError where it is none; then nothing
    is left of it."""
    try:
        project = versions.load(staging.folder, version.main)
        if project.name != versions.given.name:
            raise ProjectError(
                f"this robot runs {versions.given.name}, and this is {project.name}: deploy it "
                "to its own robot, or give it that name"
            )
        # Before it moves: what differs in media is found by reading them.
        found = check(versions, project, running)
        staging.keep()
        versions.add(number, staging.folder, version)
    except BaseException:
        staging.drop()
        raise
    root = str(versions.folder / str(number) / "project")
    return replace(found, project=replace(project, root=root))


def check(versions: Versions, project: Project, running: Project) -> Checked:
    """What a project would change in the one that runs."""
    # Only a deploy needs them: a small core is to stay small.
    from situ.document.diff import compare
    from situ.document.diff_media import compare_media

    changes = [*compare(running, project), *compare_media(running, project)]
    lines = [f"{one.file}: {one.text}" for one in changes if one.behaviour]
    if len(lines) > WORDS:
        lines[WORDS - 1 :] = [f"and {len(lines) - WORDS + 1} more"]
    given = fingerprint(versions.given)
    restart = _restart(running, project)
    return Checked(project, versions.texts(project), restart, tuple(lines), given)


def _restart(running: Project, project: Project) -> tuple[str, ...]:
    tables = {"[mqtt]": "mqtt", "[durable]": "durable", "[places]": "places"}
    return tuple(
        table for table, name in tables.items() if getattr(running, name) != getattr(project, name)
    )
