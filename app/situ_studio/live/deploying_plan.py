"""What a deploy would send, what it would change, and what hinders it: before anything is sent."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from msgspec import Struct

from situ.document import deployed, folder
from situ.document.change import Change
from situ.document.diff import compare
from situ.document.export import deployable
from situ.document.folder import PROJECT_FILE
from situ.document.problem import Problem
from situ.document.project import Project
from situ.errors import UsageError
from situ_studio.wording.language import said, tr

_TEXTS = (".xml", ".toml", ".po")


class Plan(Struct, frozen=True):
    """files: by their paths in the project, as they go to the robot. main: what it reads the
    project from. changes: what it would do differently, media aside: those it tells nothing of.
    hindrances: why it can not be sent, one line each; where there are any, ``files`` may lack some.
    """

    files: dict[str, bytes]
    main: str
    changes: tuple[Change, ...] = ()
    hindrances: tuple[str, ...] = ()

    @property
    def media(self) -> dict[str, bytes]:
        """Those of ``files`` that are no texts."""
        return {file: data for file, data in self.files.items() if not file.endswith(_TEXTS)}


def plan(
    project: Project,
    unsaved: Mapping[str, bytes],
    robots: Mapping[str, str],
    problems: Iterable[Problem],
) -> Plan:
    """The open project, as it is open, against what the robot runs.

    unsaved: settings and texts that are other here than on disk. robots: the texts of what the
    robot runs. problems: those that are known of the project.
    """
    hindrances = [said(one.message) for one in problems if one.severity == "error"]
    try:
        files = deployable(project)
    except (UsageError, OSError) as error:
        return Plan({}, "", (), (*hindrances, said(str(error))))
    files.update({file: data for file, data in unsaved.items() if file in files})
    main = PROJECT_FILE if project.toml is not None else next(iter(files))
    texts = {file: data.decode() for file, data in files.items() if file.endswith(_TEXTS)}
    # As the robot will look at it.
    _, found = deployed.read(texts)
    hindrances += [said(one.message) for one in found if one.severity == "error"]
    before, _ = folder.load_texts(robots)
    after, _ = folder.load_texts(texts)
    if before is None or after is None:
        return Plan(files, main, (), tuple(dict.fromkeys(hindrances)))
    if main != PROJECT_FILE and PROJECT_FILE in robots:
        hindrances.append(tr("This is one document, and the robot runs a whole project."))
    elif before.name != after.name:
        words = tr("This is the project {0}, and the robot runs {1}: it is another robot's.")
        hindrances.append(words.format(after.name, before.name))
    changes = tuple(change for change in compare(before, after) if change.behaviour)
    return Plan(files, main, changes, tuple(dict.fromkeys(hindrances)))
