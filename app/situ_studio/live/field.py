"""What recordings from the field tell of a project: of its drawings, and in a table. No Qt."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from msgspec import Struct
from msgspec.structs import replace

from situ.document.project import Project
from situ.document.rbd import Application
from situ.errors import UsageError
from situ.rehearse.usage import PLACE, Crossed, Lasted, Row, Usage, counting
from situ.rehearse.ways import label, states
from situ_studio.canvas.live import LiveScript, LiveView
from situ_studio.live.moment import ApplicationMoment, Moment
from situ_studio.live.views import TIMEOUT, live_part, live_view, runs_of

ENDING = ".mcap"


class Asked(Struct, frozen=True):
    """Recordings to be counted, and folders of them. place: the tag that says where the robot
    is."""

    paths: tuple[Path, ...]
    place: str = PLACE


class Field(Struct, frozen=True):
    """What was counted over so many recordings. refused: those that could not be read, why."""

    recordings: int
    rows: tuple[Row, ...]
    crossed: dict[Crossed, int]
    situations: dict[str, Lasted]
    refused: tuple[str, ...] = ()


def recordings_in(folder: Path) -> list[Path]:
    """Every recording in the folder and those below it, a ring's in their order."""
    return sorted(path for path in folder.rglob(f"*{ENDING}") if path.is_file())


def counted(asked: Asked) -> Iterator[float | Field]:
    """How much of all is read, again and again, and in the end what came of it."""
    usage, refused = Usage(asked.place), []
    paths = [
        file for path in asked.paths for file in (recordings_in(path) if path.is_dir() else [path])
    ]
    every = len(paths)
    for number, path in enumerate(paths):
        try:
            for done in counting(usage, path):
                yield (number + done) / every
        except UsageError as error:
            refused.append(str(error))
        yield (number + 1) / every
    rows = tuple(usage.rows())
    read = every - len(refused)
    yield Field(read, rows, dict(usage.crossed), usage.situations, tuple(refused))


def whole(project: Project, field: Field) -> list[Row]:
    """The rows, and one with nothing in it for each state of the project that nobody came to."""
    seen = {(row.application, row.state) for row in field.rows}
    found = list(field.rows)
    for application in project.applications.values():
        for frame in states(project, application.name):
            if (application.name, frame.no) not in seen:
                name = label(project, application.name, frame.no)
                kind = "state" if frame.state.flow is None else "part"
                found.append(Row(project.name, "", application.name, frame.no, name, kind))
    return found


def painted(project: Project, field: Field) -> dict[str, LiveView | LiveScript]:
    """How the drawings show it, by file; states that nobody came to count 0."""
    moments = {
        application.name: ApplicationMoment(
            entered={frame.no: 0 for frame in states(project, application.name)}
        )
        for application in project.applications.values()
    }
    for row in field.rows:
        one = moments.get(row.application)
        if one is not None and row.state in one.entered:
            one.entered[row.state] += row.times
            one.spent[row.state] = one.spent.get(row.state, 0.0) + row.seconds
    for way, times in field.crossed.items():
        if way.application in moments:
            moments[way.application].crossed[way.source, way.to, way.event, way.timeout] = times
    whole_moment = Moment(applications=moments)
    found: dict[str, LiveView | LiveScript] = {}
    for file, runs in runs_of(project).items():
        document = project.applications.get(file)
        if document is not None:
            view = live_view(document, moments[document.name], 0.0)
        else:
            document = project.parts[file]
            view = live_part(document, whole_moment, runs, 0.0)
        found[file] = replace(view, transitions={**_untaken(document), **view.transitions})
    if project.spds_file is not None:
        found[project.spds_file] = LiveScript(
            holds=frozenset(field.situations),
            counts=_of_situations(project, field),
            times={name: lasted.seconds for name, lasted in field.situations.items()},
        )
    return found


def _untaken(document: Application) -> dict[tuple[str, str], int]:
    """Every way out of a state, as drawings call it, taken 0 times."""
    found: dict[tuple[str, str], int] = {}
    for state in document.states:
        ways = [str(n) for n, event in enumerate(state.events) if event.next is not None]
        if state.timeout is not None and state.timeout.next is not None:
            ways.append(TIMEOUT)
        found |= {(state.no, way): 0 for way in ways}
    return found


def _of_situations(project: Project, field: Field) -> dict[str, int]:
    script = project.spds
    every = {one.name: 0 for one in script.situations} if script is not None else {}
    return {**every, **{name: lasted.times for name, lasted in field.situations.items()}}
