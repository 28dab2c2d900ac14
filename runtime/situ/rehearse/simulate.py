"""Virtual time: a scenario through ``Robot.step``. The same input gives the same trace."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from situ.decide.effects import AnyEffect
from situ.decide.inputs import AnyInput, Start
from situ.decide.robot import Robot
from situ.decide.trace import TraceEvent
from situ.document.project import Project
from situ.rehearse.expect import Expect, Expectations
from situ.rehearse.scenario import End, Line

Carry = Callable[[list[AnyEffect]], None]
"""Gets the effects of each step, before its events are told."""


class Rehearsal:
    """A robot and its virtual time. ``tell`` gets the trace events of each step.

    files: the project's texts, as in ``inputs.Deploy``, where other versions are to be deployed.
    """

    def __init__(
        self,
        project: Project,
        tell: Callable[[list[TraceEvent]], None],
        seed: int = 0,
        auto_finish: float | None = None,
        carry: Carry | None = None,
        files: Mapping[str, str] | None = None,
    ) -> None:
        self.robot = Robot(project, files=files)
        self.now = 0
        self._tell = tell
        self._carry = carry
        self._do(Start(seed, auto_finish), 0)

    def advance(self, to: int) -> None:
        """Does all that falls due up to and at ``to`` (µs)."""
        while (due := self.robot.due()) is not None and due <= to:
            self._do(None, due)
        self.now = to

    def give(self, given: AnyInput, at: int) -> None:
        """An input at ``at``, after what falls due by then."""
        self.advance(at)
        self._do(given, at)

    def _do(self, given: AnyInput | None, now: int) -> None:
        events, effects = self.robot.step(given, now)
        if self._carry is not None:
            self._carry(effects)
        self._tell(events)


def simulate(
    project: Project,
    scenario: list[Line],
    seed: int = 0,
    auto_finish: float | None = None,
    tell: Callable[[list[TraceEvent]], None] | None = None,
    carry: Carry | None = None,
) -> Expectations:
    """Plays a scenario to its end; the expectations tell what failed.

    The project must have no errors. ``tell`` gets every trace event as it comes, also
    when an expectation fails; ``carry`` the effects.
    """
    verdict = Expectations()

    def heard(events: list[TraceEvent]) -> None:
        verdict.add(events)
        if tell is not None:
            tell(events)

    rehearsal = Rehearsal(project, heard, seed, auto_finish, carry)
    for line in scenario:
        if line.at > rehearsal.now:
            # The moment before is over: nothing more can come to it.
            verdict.judge()
        rehearsal.advance(line.at)
        if isinstance(line.does, Expect):
            verdict.expect(line.number, line.at, line.does)
        elif not isinstance(line.does, End):
            rehearsal.give(line.does, line.at)
    verdict.judge()
    return verdict
