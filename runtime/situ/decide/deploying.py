"""Another version of the project: when it takes over from the one that runs, and when it goes back.

docs/semantics.md, *Deploy*. It waits until no action of any application runs, or until it is
forced; what fails within its first minute is returned from. What is kept is ``replacing``'s.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

from msgspec import Struct

from situ.decide import inputs
from situ.decide.deployment import Deployment, Waits
from situ.decide.effects import Refuse
from situ.decide.machine import Machine
from situ.decide.priorities import RUNTIME
from situ.decide.step import DEPLOY, SECOND, Step, microseconds
from situ.decide.trace import Failed
from situ.document import deployed
from situ.document.project import Project

PROBATION = 60 * SECOND
"""How long a new version is gone back from by itself, in µs."""


class Version(Struct):
    """files: the texts that it is read from, by their paths in the project."""

    number: int
    files: dict[str, str]


class Pending(Struct):
    """A version that waits; forced: as in ``Deployment``. token: of its timers."""

    version: Version
    writer: str
    forced: int | None
    token: int


class DeployingState(Struct):
    """running: what runs; former: what ran before, while it may be gone back to, before
    ``until`` (µs). taken: versions taken so far.
    """

    running: Version
    pending: Pending | None = None
    former: Version | None = None
    until: int = 0
    taken: int = 0


class Replace(Protocol):
    def __call__(
        self,
        project: Project,
        version: int,
        files: tuple[str, ...],
        writer: str,
        cause: int | None,
    ) -> None:
        """Lets a version take over; files: the names of those that changed, sorted."""


class Deploying:
    """The versions of one robot. ``replace`` lets one take over from the one that runs."""

    def __init__(self, step: Step, project: Project, running: Version, replace: Replace) -> None:
        self.state = DeployingState(running)
        self.machines: list[Machine] = []
        self._step = step
        self._replace = replace
        self._projects = {running.number: project}
        self._prepared: dict[int, Project] = {}

    @property
    def active(self) -> bool:
        """Whether a version waits, or may be gone back from."""
        return self.state.pending is not None or self.state.former is not None

    def prepare(self, version: int, project: Project) -> None:
        """This is what the files of a version are, should it come; it is not read again."""
        self._prepared[version] = project

    def deployment(self) -> Deployment:
        """What runs now and what waits for what."""
        state = self.state
        pending, former = state.pending, state.former
        return Deployment(
            version=state.running.number,
            pending=None if pending is None else pending.version.number,
            waits=() if pending is None else self._waits(),
            forced=None if pending is None else pending.forced,
            former=None if former is None else former.number,
            until=None if former is None else state.until,
        )

    def project(self, version: Version) -> Project:
        """What a version is. Raises ValueError where its files can not be run."""
        found = self._prepared.pop(version.number, None) or self._projects.get(version.number)
        self._projects[version.number] = found = found or _read(version)
        return found

    # -- steps ---------------------------------------------------------------

    def accept(self, given: inputs.Deploy) -> str | None:
        """Takes a version; why not, where it can not be run. It takes the place of one that
        waits.
        """
        state, step = self.state, self._step
        version = Version(given.version, given.files)
        try:
            project = self._prepared.pop(version.number, None) or _read(version)
        except ValueError as error:
            return str(error)
        kept = {one.number for one in (state.running, state.former) if one is not None}
        self._projects = {n: one for n, one in self._projects.items() if n in kept}
        self._projects[version.number] = project
        state.taken += 1
        at_once = given.returning or (given.force_after is not None and given.force_after <= 0)
        forced = None
        if given.force_after is not None and not at_once:
            forced = step.now + microseconds(given.force_after)
            step.at(forced, DEPLOY, "deploy:", state.taken)
        state.pending = Pending(version, given.writer, forced, state.taken)
        if at_once or not self._waits():
            self._take_over(keeps_former=not given.returning)
        return None

    def is_live(self, token: int) -> bool:
        """Whether a timer of a version still means something."""
        return self.state.pending is not None and self.state.pending.token == token

    def due(self) -> None:
        """A version that waits may take over, or is forced to."""
        pending = self.state.pending
        assert pending is not None
        if not self._waits() or (pending.forced is not None and self._step.now >= pending.forced):
            self._take_over(keeps_former=True)

    def look(self) -> bool:
        """The end of a step: a version that waits for nothing any longer is to take over next;
        one that has failed has gone back, which is the answer.
        """
        state, step = self.state, self._step
        goes_back = False
        if state.former is not None:
            failed = self._failure()
            if step.now >= state.until:
                state.former = None
            elif failed is not None:
                self._go_back(failed)
                goes_back = True
        if state.pending is not None and (goes_back or not self._waits()):
            step.at(step.now, DEPLOY, "deploy:", state.pending.token)
        return goes_back

    # ------------------------------------------------------------------------

    def _waits(self) -> tuple[Waits, ...]:
        return tuple(
            Waits(machine.name, machine.state.no, running.action, running.name)
            for machine in self.machines
            for running in machine.actions.state.running.values()
        )

    def _failure(self) -> Failed | None:
        """What the version itself did wrong in this step; what it refuses others is not."""
        refused = {one.message for one in self._step.effects if isinstance(one, Refuse)}
        errors = (event for event in self._step.events if isinstance(event, Failed))
        return next((one for one in errors if one.message not in refused), None)

    def _take_over(self, keeps_former: bool) -> None:
        state, pending = self.state, self.state.pending
        assert pending is not None
        state.pending = None
        former = state.running
        changed = self._run(pending.version, pending.writer, None)
        if not keeps_former:
            state.former = None
        elif changed:
            state.former, state.until = former, self._step.now + PROBATION

    def _go_back(self, failed: Failed) -> None:
        state = self.state
        former, state.former = state.former, None
        assert former is not None
        why = f"version {state.running.number} failed: {failed.message}; back to {former.number}"
        self._run(former, RUNTIME, self._step.error(failed.seq, why, "deploy"))

    def _run(self, version: Version, writer: str, cause: int | None) -> bool:
        """Whether any of its files differs from what ran."""
        before, self.state.running = self.state.running.files, version
        changed = changed_files(before, version.files)
        self._replace(self.project(version), version.number, changed, writer, cause)
        return bool(changed)


def changed_files(before: Mapping[str, str], after: Mapping[str, str]) -> tuple[str, ...]:
    """The names of the files that came, went or are others, sorted."""
    names = sorted(before.keys() | after.keys())
    return tuple(name for name in names if before.get(name) != after.get(name))


def _read(version: Version) -> Project:
    project, problems = deployed.read(version.files)
    errors = [problem for problem in problems if problem.severity == "error"]
    if project is None or errors:
        more = f" (and {len(errors) - 1} more)" if len(errors) > 1 else ""
        raise ValueError(f"version {version.number} can not run: {errors[0]}{more}")
    return project
