"""Scenarios as tests: each is played, and what failed is told with its causes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import msgspec
from msgspec import Struct

from situ.decide.step import SECOND
from situ.document.folder import resolve
from situ.document.project import Project
from situ.errors import UsageError
from situ.rehearse import expect, scenario
from situ.rehearse.coverage import Coverage
from situ.rehearse.reason import Answer, Reason, lines
from situ.rehearse.recording import Fields, Recording, record
from situ.rehearse.scenario import Line
from situ.rehearse.telling import Teller, moment
from situ.rehearse.why import KINDS, chain, why_not

ENDING = ".jsonl"


class Difference(Struct, frozen=True):
    """A field of an expectation, and what the closest event had there."""

    field: str
    expected: Any
    came: Any


class Failed(Struct, frozen=True):
    """An expectation that no event fulfilled.

    line: its number in the file; at: seconds. came: the closest event of its kind, and
    differences: what it has otherwise. causes: the chain that led to it, outside input
    first. reasons: what kept the expected event from coming, where that can be asked.
    """

    line: int
    at: float
    expected: dict[str, Any]
    came: Fields | None
    differences: tuple[Difference, ...]
    causes: tuple[Fields, ...]
    reasons: tuple[Reason, ...]


class Played(Struct, frozen=True):
    """A scenario. expectations: how many it has; unreadable: why it could not be played.

    seconds: of virtual time that it took.
    """

    file: str
    expectations: int = 0
    seconds: float = 0.0
    failed: tuple[Failed, ...] = ()
    unreadable: str | None = None

    @property
    def well(self) -> bool:
        return not self.failed and self.unreadable is None


class Suite(Struct):
    """What the scenarios of a project have shown."""

    project: str
    played: list[Played]
    coverage: Coverage

    @property
    def status(self) -> int:
        """The exit status: 0 well, 1 an expectation failed, 2 a scenario cannot be played."""
        if any(one.unreadable is not None for one in self.played):
            return 2
        return 0 if all(one.well for one in self.played) else 1


def scenarios(project: Project) -> list[Path]:
    """The project's scenarios, in order of their names. UsageError where there are none."""
    if project.scenarios is None:
        raise UsageError(
            f'{project.root}: no scenarios: add scenarios = "scenarios" to [project] of '
            "situ.toml, and put files of JSON lines there"
        )
    folder = resolve(project.root, project.scenarios)
    found = sorted(folder.rglob(f"*{ENDING}")) if folder is not None else []
    if not found:
        where = Path(project.root, project.scenarios)
        raise UsageError(f"{where}: no scenarios here: no file ends in {ENDING}")
    return found


def run_suite(
    project: Project, files: list[Path], seed: int = 0, auto_finish: float | None = None
) -> Suite:
    """Plays scenarios one after the other, each from the start. The project has no errors.

    One that cannot be read does not keep the others from being played.
    """
    coverage = Coverage(project)
    names = [application.name for application in project.applications.values()]
    played = []
    for path in files:
        recording, one = play_file(project, path, names, seed, auto_finish)
        if recording is not None:
            coverage.add(recording)
        played.append(one)
    return Suite(project.name, played, coverage)


def play_file(
    project: Project,
    path: Path,
    names: list[str],
    seed: int = 0,
    auto_finish: float | None = None,
    unsaved: bytes | None = None,
) -> tuple[Recording | None, Played]:
    """Plays the scenario of a file; None where it cannot be read. names: of the applications.

    unsaved: what the file is to hold, where that is another than it holds now.
    """
    try:
        if unsaved is not None:
            written = scenario.parse(unsaved, str(path), names)
        else:
            written = scenario.load(path, names)
    except UsageError as error:
        return None, Played(_called(project, path), unreadable=str(error))
    return play(project, _called(project, path), written, seed, auto_finish)


def play(
    project: Project,
    file: str,
    written: list[Line],
    seed: int = 0,
    auto_finish: float | None = None,
) -> tuple[Recording, Played]:
    """Plays one scenario."""
    recording, verdict = record(project, written, seed, auto_finish)
    failed = tuple(_failed(project, recording, one) for one in verdict.failures)
    end = written[-1].at / SECOND if written else 0.0
    expectations = verdict.fulfilled + len(verdict.failures)
    return recording, Played(file, expectations, end, failed)


def _called(project: Project, path: Path) -> str:
    try:
        return path.resolve().relative_to(Path(project.root).resolve()).as_posix()
    except ValueError:
        return str(path)


def _failed(project: Project, recording: Recording, failure: expect.Failure) -> Failed:
    at, near = failure.at / SECOND, failure.near
    causes: list[Fields] = []
    differences: list[Difference] = []
    if near is not None:
        causes = chain(recording.events, near["seq"])
        differences = [
            Difference(name, wanted, near.get(name))
            for name, wanted in failure.fields.items()
            if not expect.fits({name: wanted}, near)
        ]
    reasons: tuple[Reason, ...] = ()
    if failure.fields.get("kind") in KINDS:
        try:
            answer: Answer = why_not(project, recording, failure.fields, at)
            # That it came otherwise, as told above, stands in no way.
            if any(one.code != "note" for one in answer.reasons):
                reasons = answer.reasons
        except UsageError:
            pass  # it leaves open what was meant: then the closest event has to do
    return Failed(
        failure.number, at, failure.fields, near, tuple(differences), tuple(causes), reasons
    )


# -- what it says -------------------------------------------------------------


def summary(one: Played) -> str:
    """One line: ``ok    scenarios/fig5.jsonl  18 expectations, 64 s``."""
    if one.unreadable is not None:
        return f"ERROR {one.unreadable}"
    several = f"{one.expectations} expectation{'' if one.expectations == 1 else 's'}"
    if one.failed:
        return f"FAIL  {one.file}  {len(one.failed)} of {several} failed"
    return f"ok    {one.file}  {several}, {moment(one.seconds)}"


def details(one: Failed, project: Project) -> list[str]:
    """A failure in lines: what was expected, what came, what led there, what stood in the way."""
    teller = Teller(project)
    found = [
        f"line {one.line}, at {moment(one.at)}",
        f"  expected  {_json(one.expected)}",
    ]
    if one.came is None:
        found.append(f"  came      no event of kind {one.expected.get('kind')} after the last")
    else:
        found.append(f"  came      {teller.line(one.came)}")
        found += [
            f"            {other.field} was {_json(other.came)}, not {_json(other.expected)}"
            for other in one.differences
        ]
    if one.causes:
        found.append("  causes")
        for event in one.causes:
            note = f"  ({teller.origin(event)})" if event is one.causes[0] else ""
            found.append(f"    {teller.line(event)}{note}")
    if one.reasons:
        found.append("  in the way")
        found += lines(one.reasons, "    ")
    return found


def _json(value: Any) -> str:
    return msgspec.json.encode(value).decode()


def document(suite: Suite) -> dict[str, Any]:
    """The whole result as JSON."""
    return {
        "project": suite.project,
        "ok": suite.status == 0,
        "scenarios": [{**msgspec.to_builtins(one), "ok": one.well} for one in suite.played],
        "coverage": suite.coverage.document(),
    }
