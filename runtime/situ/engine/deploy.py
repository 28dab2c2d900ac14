"""Deploys versions to a robot that runs: checked beside it, swapped by it, remembered here.

The robot itself decides when a version runs (``situ.decide.deploying``) and whether its first
minute went well. Here are the disk, the checking, which is done in a thread of its own, and what
happens where the process dies: docs/deploying.md.
"""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable
from typing import Any, Protocol

from msgspec import Struct
from msgspec.structs import replace

from situ.blackboard import protocol, replies
from situ.decide import trace
from situ.decide.deploying import PROBATION
from situ.decide.deployment import Deployment
from situ.decide.inputs import AnyInput, Deploy
from situ.document.project import Project
from situ.engine import checking
from situ.engine.checking import Checked
from situ.engine.staging import Staging, not_kept
from situ.engine.versions import Current, Version, Versions, before, fingerprint, main_file
from situ.errors import Refused, SituError

IDLE = 10.0
"""Seconds without a piece, after which another operator may send a version."""
PIECE = 1_000_000
SLACK = 1.0
"""Seconds after the first minute, in which what fell due in it has been done."""
ROBOT = "situ"
"""Who goes back by itself."""

_log = logging.getLogger("situ.run")


class Deployable(Protocol):
    """The part of ``situ.decide.robot.Robot`` that is needed here."""

    @property
    def project(self) -> Project: ...

    @property
    def version(self) -> int: ...

    def prepare(self, version: int, project: Project, /) -> None: ...

    def deployment(self) -> Deployment: ...


TurnTo = Callable[[Project, dict[str, str]], None]
"""Is told the project that runs from here on, and its texts."""


class Wish(Struct):
    """A version that an operator wants to run. restart, changed, given: as in ``Checked``.
    problems: why it came to nothing."""

    number: int
    who: str
    did: Any
    force_after: float | None
    stands: replies.Stands = "checking"
    problems: tuple[str, ...] = ()
    restart: tuple[str, ...] = ()
    changed: tuple[str, ...] = ()
    given: str = ""


class Deployer:
    """Of one robot. begun: the version that it begins with. clock: seconds that never go back;
    wall: UNIX time.

    ``prepare`` before a robot is restored, ``begin`` when it is there, ``answer`` what clients ask,
    ``swapped`` from inside of the step in which another version began to run, ``settle`` when what
    that step brought about is written down, ``tend`` when it is due.
    """

    def __init__(
        self,
        versions: Versions,
        begun: int,
        *,
        clock: Callable[[], float] = time.monotonic,
        wall: Callable[[], float] = time.time,
    ) -> None:
        self.begun = begun
        self._versions = versions
        self._clock = clock
        self._wall = wall
        self._robot: Deployable
        self._submit: Callable[[AnyInput], str | None]
        self._soon: Callable[[Callable[[], None]], None]
        self._moment: Callable[[], int]
        self._turn_to: TurnTo
        self._projects: dict[int, Project] = {}
        self._staging: Staging | None = None
        self._sender = ""
        # None: that session has ended, and another one of the same sender may go on.
        self._session: str | None = None
        self._main: str | None = None
        self._heard = 0.0
        self._wish: Wish | None = None
        self._thread: threading.Thread | None = None
        self._swaps: list[tuple[trace.Deployed, str]] = []
        self._confirm: float | None = None
        # When a version of which media alone are others has shown that it does not fail.
        self._until = clock()

    @property
    def version(self) -> int:
        """The one that runs."""
        return self._robot.version

    @property
    def unsettled(self) -> bool:
        """Whether ``settle`` has something to do."""
        return bool(self._swaps)

    def texts(self, project: Project) -> dict[str, str]:
        """As ``Versions.texts``; nothing where they can no longer be read."""
        try:
            return self._versions.texts(project)
        except OSError as error:
            _log.error("%s: %s", error.filename, error.strerror)
            return {}

    def prepare(self, robot: Deployable, version: int) -> None:
        """The robot need not read this version itself, where it is still there."""
        try:
            self._projects[version] = self._versions.project(version)
        except (SituError, OSError):
            return
        robot.prepare(version, self._projects[version])

    def begin(
        self,
        robot: Deployable,
        submit: Callable[[AnyInput], str | None],
        soon: Callable[[Callable[[], None]], None],
        moment: Callable[[], int],
        turn_to: TurnTo,
    ) -> None:
        """submit: one step with this input; why it was refused. soon: calls something in the
        robot's thread, from any thread, and sends what follows. moment: the robot's time in µs.

        Where the robot goes on with a version whose process died in its first minute it goes back
        now.
        """
        self._robot, self._submit, self._soon = robot, submit, soon
        self._moment, self._turn_to = moment, turn_to
        project = self._project(robot.version)
        if robot.version != self.begun:
            turn_to(project, self.texts(project))
        current = self._versions.current
        if current.version != robot.version:
            # The process died between the swap and what is written of it.
            self._choose(Current(robot.version, self._given(), robot.deployment().former))
        elif current.former is not None:
            self._go_back(current.former)
        pending = robot.deployment().pending
        if pending is not None:
            self._wish = Wish(pending, "", "deployed", None, "waiting", given=self._given())

    # -- what clients ask --------------------------------------------------------

    def left(self, session: str) -> None:
        """That session has ended: what it was sending its operator may go on with in another."""
        if session == self._session:
            self._session = None

    def answer(self, request: protocol.Deploying, who: str, session: str) -> replies.Reply:
        """Raises Refused."""
        if isinstance(request, protocol.Stage):
            return self._stage(request, who, session)
        if isinstance(request, protocol.Piece):
            return self._piece(request, who, session)
        if isinstance(request, protocol.Bundle):
            number = self._robot.version
            main, files = self._versions.files(number)
            return replies.Bundled(id=request.id, version=number, main=main, files=files)
        if isinstance(request, protocol.Fetch):
            data = self._versions.read(request.version, request.path, request.offset)
            return replies.Fetched(id=request.id, data=data)
        if isinstance(request, protocol.Deploy):
            self._deploy(request, who, session)
        elif isinstance(request, protocol.Rollback):
            self._roll_back(request, who)
        elif isinstance(request, protocol.History):
            versions = self._versions
            return replies.Turns(
                id=request.id,
                turns=tuple(versions.turns()),
                version=self._robot.version,
                kept=(0, *versions.numbers()),
            )
        return self._progress(request.id)

    def _stage(self, request: protocol.Stage, who: str, session: str) -> replies.Reply:
        self._check_free()
        others = self._staging is not None and not self._is_of(who, session)
        if others and self._clock() < self._heard + IDLE:
            raise Refused(f"{self._sender} is sending a version: try again when that is done")
        self._forget()
        if request.main is not None and request.main not in request.files:
            raise Refused(f"{request.main}: the project is read from it, and it is not there")
        versions = self._versions
        staging = Staging(versions.staging, request.files, versions.contents())
        self._staging, self._main = staging, request.main
        self._sender, self._session = who, session
        self._heard = self._clock()
        return replies.Staged(id=request.id, wanted=tuple(staging.wanted))

    def _piece(self, request: protocol.Piece, who: str, session: str) -> replies.Reply:
        if len(request.data) > PIECE:
            raise Refused(f"a piece has at most {PIECE} bytes: send it in several")
        staging = self._of(who, session)
        self._heard = self._clock()
        try:
            staging.piece(request.path, request.offset, request.data)
        except Refused:
            if not staging.folder.exists():
                self._staging = None
            raise
        return replies.Done(id=request.id)

    def _deploy(self, request: protocol.Deploy, who: str, session: str) -> None:
        staging = self._of(who, session)
        self._check_force(request.force_after)
        self._check_free()
        staging.check_whole()
        number, main, at = self._versions.next(), self._main, self._wall()
        self._staging = None
        running = self._project(self._robot.version)
        self._wish = Wish(number, who, "deployed", request.force_after)

        def check() -> Checked:
            staging.complete()
            files = dict(staging.files)
            if main is None:
                files |= staging.fill(running)
            version = Version(main or main_file(running), who, at, files)
            return checking.add(self._versions, number, staging, version, running)

        self._work(check)

    def _roll_back(self, request: protocol.Rollback, who: str) -> None:
        self._check_force(request.force_after)
        self._check_free()
        number, running = request.version, self._robot.version
        if number is None:
            number = before(self._versions.turns(), running)
            if number is None:
                raise Refused(
                    f"nothing ran before version {running}: situ history tells what there is"
                )
        if number == running and self._robot.deployment().pending is None:
            raise Refused(f"version {number} runs already")
        if not self._versions.has(number):
            raise Refused(f"the robot has no version {number}: situ history tells which it has")
        # What runs already, in place of one that waits, has nothing to wait for.
        force_after = 0.0 if number == running else request.force_after
        versions, wanted, project = self._versions, number, self._project(running)
        self._wish = Wish(wanted, who, "rolled back", force_after)
        self._work(lambda: checking.check(versions, versions.project(wanted), project))

    def _progress(self, number: int) -> replies.Deployment:
        state, wish, now = self._robot.deployment(), self._wish, self._moment()
        left, former = self._minute(), state.former
        if former is None:
            former = self._versions.current.former
        fails = left > 0 and former is not None
        return replies.Deployment(
            id=number,
            version=state.version,
            asked=None if wish is None else wish.number,
            stands="running" if wish is None else wish.stands,
            waits=state.waits,
            forced=None if state.forced is None else max(0.0, (state.forced - now) / 1e6),
            minute=left if fails else None,
            former=former if fails else None,
            problems=() if wish is None else wish.problems,
            restart=() if wish is None else wish.restart,
        )

    def _of(self, who: str, session: str) -> Staging:
        if self._staging is None or not self._is_of(who, session):
            raise Refused("nothing of yours is on its way any more: send it again from its start")
        self._session = session
        return self._staging

    def _is_of(self, who: str, session: str) -> bool:
        """Whether what is on its way is theirs: nobody's other editor, or terminal, sends between
        its pieces."""
        return who == self._sender and self._session in (None, session)

    def _check_free(self) -> None:
        if self._thread is not None:
            raise Refused("a version is being checked: try again in a moment")

    @staticmethod
    def _check_force(force_after: float | None) -> None:
        if force_after is not None and not 0 <= force_after < 1e9:
            raise Refused("it is forced after a number of seconds, 0 or more")

    # -- beside the robot --------------------------------------------------------

    def _work(self, check: Callable[[], Checked]) -> None:
        """Checks in a thread of its own, for it may take a while; then asks the robot."""

        def work() -> None:
            found: Checked | Exception
            try:
                found = check()
            except Exception as error:
                found = error
            self._soon(lambda: self._done(found))

        self._thread = threading.Thread(target=work, name="deploy", daemon=True)
        self._thread.start()

    def _done(self, found: Checked | Exception) -> None:
        self._thread = None
        wish, robot = self._wish, self._robot
        assert wish is not None
        if isinstance(found, Exception):
            if not isinstance(found, (SituError, OSError)):
                _log.error("a version could not be checked", exc_info=found)
            told = not_kept(found) if isinstance(found, OSError) else str(found)
            self._refused(wish, told or type(found).__name__)
            return
        wish.restart, wish.changed, wish.given = found.restart, found.changed, found.given
        if robot.version == wish.number and robot.deployment().pending is None:
            wish.stands = "running"
            return
        wish.stands = "waiting"
        self._projects = {robot.version: self._project(robot.version), wish.number: found.project}
        robot.prepare(wish.number, found.project)
        why = self._submit(Deploy(wish.number, found.texts, wish.who, wish.force_after))
        if why is not None:
            self._refused(wish, why)

    def _refused(self, wish: Wish, why: str) -> None:
        wish.stands, wish.problems = "refused", tuple(why.splitlines())
        self._note(wish.number, wish.who, "refused", wish.problems[0])

    # -- what the robot did ------------------------------------------------------

    def swapped(self, events: list[trace.TraceEvent]) -> None:
        """Another version runs; events: of its step."""
        failure = ""
        for event in events:
            if type(event) is trace.Failed:
                failure = event.message
            elif type(event) is trace.Deployed:
                self._swaps.append((event, failure))
        project = self._project(self._robot.version)
        self._turn_to(project, self.texts(project))

    def settle(self) -> None:
        """Writes down which version runs now."""
        if not self._swaps:
            return
        swaps, self._swaps = self._swaps, []
        wish, current = self._wish, self._versions.current
        given, ran, before_media = self._given(), current.version, current.former
        for event, failure in swaps:
            if event.writer == ROBOT:
                before_media = None
                if wish is not None and wish.number == ran:
                    wish.stands, wish.problems = "returned", (failure,)
                self._note(event.version, ROBOT, "returned", failure)
            elif wish is not None and wish.number == event.version:
                wish.stands, given = "running", wish.given
                if wish.changed:
                    before_media, self._until = ran, self._clock() + PROBATION / 1e6
                self._note(event.version, event.writer, wish.did, "", wish.changed)
            else:
                self._note(event.version, event.writer, "deployed")
            ran = event.version
        state = self._robot.deployment()
        # The robot does not know media: where they alone are others its process may still die of
        # them.
        former = before_media if state.former is None else state.former
        self._choose(Current(state.version, given, former))
        self._versions.forget_old({state.version, current.version, former or 0})

    def tend(self, now: float) -> float | None:
        """Does what is due; when to be called next, None: after a swap."""
        if self._confirm is not None and now >= self._confirm:
            self._confirm = None
            if self._minute() <= 0:
                self._choose(replace(self._versions.current, former=None, starts=0))
            else:
                self._confirm = now + SLACK
        return self._confirm

    def end(self) -> None:
        """The robot is told to end: a version in its first minute has not failed."""
        self._forget()
        current = self._versions.current
        if current.former is not None:
            self._choose(replace(current, former=None, starts=0))

    # ----------------------------------------------------------------------------

    def _go_back(self, former: int) -> None:
        version = self._robot.version
        why = f"version {version} failed: the robot's process died in its first minute"
        try:
            project = self._versions.project(former)
            texts = self._versions.texts(project)
        except (SituError, OSError) as error:
            _log.error("%s; back to version %d is not possible: %s", why, former, error)
            return
        _log.error("%s; back to version %d", why, former)
        self._projects[former] = project
        self._robot.prepare(former, project)
        self._wish = Wish(version, ROBOT, "deployed", None, "running")
        refused = self._submit(Deploy(former, texts, ROBOT, 0.0, True))
        if refused is not None:
            _log.error("%s", refused)
        self._swaps = [(event, failure or why) for event, failure in self._swaps]

    def _choose(self, current: Current) -> None:
        try:
            self._versions.choose(current)
        except (SituError, OSError) as error:
            _log.error("which version runs could not be kept (%s): it runs until the end", error)
        self._confirm = None
        if current.former is not None:
            self._confirm = self._clock() + self._minute() + SLACK

    def _given(self) -> str:
        """What lay in the project's own folder when a version was last chosen."""
        return self._versions.current.given or fingerprint(self._versions.given)

    def _minute(self) -> float:
        """Seconds of its first minute that the version which runs has left."""
        until = self._robot.deployment().until
        if until is None:
            return self._until - self._clock()
        return (until - self._moment()) / 1e6

    def _note(
        self, version: int, who: str, did: Any, why: str = "", changed: tuple[str, ...] = ()
    ) -> None:
        try:
            self._versions.note(replies.Turn(self._wall(), version, who, did, why, changed))
        except OSError as error:
            _log.error("the history of versions could not be written: %s", error)

    def _forget(self) -> None:
        if self._staging is not None:
            self._staging.drop()
            self._staging = None

    def _project(self, version: int) -> Project:
        """As the robot runs it."""
        if version not in self._projects:
            try:
                self._projects[version] = self._versions.project(version)
            except (SituError, OSError) as error:
                _log.error("version %d: %s; its media are missing", version, error)
                return self._robot.project
        return self._projects[version]
