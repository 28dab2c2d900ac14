"""One run of a project: the core alone, the core with its services, or services alone.

What ``situ run`` was asked for, with what it needs of a state folder, keys, a trace and a
recording. What only one way of running needs is imported there: the core alone stays small.
"""

from __future__ import annotations

import contextlib
import logging
import math
import sys
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from msgspec import Struct
from msgspec.structs import replace

from situ.document.folder import sources
from situ.engine.folder import state_folder
from situ.engine.readiness import Readiness
from situ.errors import SituError, UsageError

if TYPE_CHECKING:
    import asyncio

    from situ.blackboard.client import AsyncBoard
    from situ.blackboard.core import Heard
    from situ.blackboard.journal import DurableTags
    from situ.blackboard.keys import RobotKeys
    from situ.blackboard.replies import Addresses
    from situ.document.project import Project
    from situ.engine.deciding import Setup
    from situ.engine.deploy import Deployer
    from situ.engine.live import Live
    from situ.engine.perform import Performer
    from situ.engine.record import Recorder
    from situ.engine.recovery import Recovery
    from situ.engine.script import Script
    from situ.engine.trace_out import TraceOut
    from situ.engine.versions import Versions
    from situ.rehearse.scenario import Line

_log = logging.getLogger("situ.run")


class Options(Struct, frozen=True, kw_only=True):
    """What ``situ run`` was told, by the names of its options."""

    endpoint: str | None
    notify: str | None
    http: tuple[str, int] | None
    keys: Path | None
    insecure: bool
    services: tuple[str, ...]
    supervised: bool
    state: Path | None
    speech: str
    sync: bool
    fresh: bool
    as_given: bool
    patience: float
    script: str | None
    speed: float
    clients: int
    trace: str | None
    record: Path | None
    auto_finish: float | None
    seed: int
    json: bool


class Kept(Struct, frozen=True):
    """What outlives the process; nothing does where a scenario is played."""

    durable: DurableTags | None = None
    recovery: Recovery | None = None
    recorders: tuple[Recorder, ...] = ()
    versions: Versions | None = None
    version: int = 0


class Run:
    """One run. lines: the scenario that is played; None: alive, until a signal comes."""

    def __init__(self, project: Project, options: Options, lines: list[Line] | None = None) -> None:
        self._project = project
        self._options = options
        self._lines = lines
        self._endpoint = project.endpoint if options.endpoint is None else options.endpoint
        self._screen = options.http or ("127.0.0.1", _higher(self._endpoint, 2))
        self._kept = Kept()
        self._readiness = Readiness(
            supervised=options.supervised, as_json=options.json, aside=options.trace == "-"
        )

    def run(self) -> int:
        """The exit status. Raises UsageError where it can not begin."""
        try:
            return self._run()
        finally:
            self._readiness.close()

    def _run(self) -> int:
        if "core" not in self._options.services:
            import asyncio

            return asyncio.run(self._serve())
        with contextlib.ExitStack() as stack:
            if self._lines is None:
                self._kept = self._keep(stack)
            if self._options.record is not None:
                recorders = (*self._kept.recorders, self._recorder(self._options.record))
                self._kept = replace(self._kept, recorders=recorders)
            out = self._trace_file(stack)
            if (
                self._lines is None
                and self._options.services == ("core",)
                and not _has_broker(self._project)
            ):
                return self._decide(out)
            import asyncio

            return asyncio.run(self._live(out))

    # -- what is kept ------------------------------------------------------------

    def _folder(self) -> Path:
        return state_folder(self._options.state, self._project)

    def _keep(self, stack: contextlib.ExitStack) -> Kept:
        from situ.blackboard.journal import DurableTags, patterns
        from situ.engine.folder import StateFolder
        from situ.engine.record import RING, Recorder, RingFiles

        folder = StateFolder(self._folder())
        stack.callback(folder.close)
        versions, version, recovery = self._version(folder.path)
        durable = None
        if durable_tags := patterns(self._project):
            durable = DurableTags(folder.path, durable_tags, sync=self._options.sync)
            stack.callback(durable.close)
        ring = Recorder(RingFiles(folder.path / RING), versions.texts(self._project))
        return Kept(durable, recovery, (ring,), versions, version)

    def _version(self, folder: Path) -> tuple[Versions, int, Recovery]:
        """Which version of the project runs, from here on ``_project``, and what a core that was
        killed has left of it."""
        from situ.engine.recovery import Recovery, version_left
        from situ.engine.versions import Versions, version_to_run

        versions, left = Versions(folder, self._project), version_left(folder)
        if self._options.fresh:
            left = None
        number, goes_on = version_to_run(versions, left, anew=self._options.as_given)
        for version in dict.fromkeys((number, versions.current.version, 0)):
            try:
                project = versions.project(version)
            except (SituError, OSError) as error:
                _log.error("version %d can not run: %s", version, error)
                continue
            recovery = Recovery(folder, project)
            if self._options.fresh or not goes_on:
                recovery.forget()
            if version == versions.current.version or recovery.found is not None or not version:
                break
        self._project = project
        return versions, version, recovery

    def _recorder(self, file: Path) -> Recorder:
        from situ.engine.record import OneFile, Recorder

        versions, project = self._kept.versions, self._project
        texts = sources(project) if versions is None else versions.texts(project)
        return Recorder(OneFile(file, goes_on=self._goes_on()), texts)

    def _goes_on(self) -> bool:
        """Whether a run that was killed is taken up again."""
        return self._kept.recovery is not None and self._kept.recovery.found is not None

    def _trace_file(self, stack: contextlib.ExitStack) -> Any:
        name = self._options.trace
        if name is None or name == "-":
            return None if name is None else sys.stdout.buffer
        try:
            # Without a buffer: what could not be written must not be tried again at the end.
            mode = "ab" if self._goes_on() else "wb"
            return stack.enter_context(open(name, mode, buffering=0))
        except OSError as error:
            raise UsageError(f"{name}: {error.strerror or error}") from None

    def _status(self, trace: TraceOut | None) -> int:
        """Whether what was asked for could be written."""
        torn = self._options.record is not None and self._kept.recorders[-1].torn is not None
        return (0 if trace is None else trace.status()) or int(torn)

    def _keys(self) -> RobotKeys | None:
        """The robot's keys; None: everybody may come in."""
        from situ.blackboard.keys import KNOWN, RobotKeys, has_keys

        if self._options.insecure:
            _log.warning("--insecure: whoever can reach this robot may do everything with it")
            return None
        folder = self._options.keys or self._folder() / "keys"
        if self._options.keys is None and not has_keys(folder):
            return None
        if "core" not in self._options.services and not (folder / KNOWN).is_dir():
            # Those of a client of a core elsewhere.
            return None
        # Who came in, and who did not, is always told.
        logging.getLogger("situ.audit").setLevel(logging.INFO)
        return RobotKeys(folder)

    def _setup(self, keys: RobotKeys | None, heard: Heard | None) -> Setup:
        from situ.engine.deciding import Setup

        options, kept = self._options, self._kept
        return Setup(
            endpoint=self._endpoint,
            notify=options.notify or _beside(self._endpoint),
            keys=keys,
            insecure=options.insecure,
            files=sources(self._project),
            patience=options.patience,
            scripted=self._lines is not None,
            seed=options.seed,
            auto_finish=options.auto_finish,
            heard=heard,
            durable=kept.durable,
            recovery=kept.recovery,
            recorders=kept.recorders,
            deployer=self._deployer(),
        )

    # -- the three ways ----------------------------------------------------------

    def _decide(self, out: Any) -> int:
        """The core without anything beside it, until a signal comes."""
        import signal
        import time

        from situ.engine import core_loop
        from situ.engine.deciding import Deciding
        from situ.engine.trace_out import TraceOut
        from situ.engine.waking import Waking

        options, kept, readiness = self._options, self._kept, self._readiness
        keys = self._keys()
        with Waking(signal.SIGINT, signal.SIGTERM) as waking:
            trace = None
            if out is not None:
                name = options.trace or ""
                trace = TraceOut(name, out, lambda: waking.came.append(signal.SIGPIPE))
            heard = None if trace is None else trace.heard
            deciding = Deciding(
                self._project, self._setup(keys, heard), time.monotonic, waking.soon
            )
            core_loop.run(
                deciding,
                waking,
                readiness.notifier,
                kept.durable,
                partial(self._up, keys),
                readiness.is_the_end,
            )
        return self._status(trace)

    async def _live(self, out: Any) -> int:
        """The core with services, in one asyncio loop."""
        import asyncio

        from situ.engine.live import Live
        from situ.engine.trace_out import TraceOut

        loop, stopped = asyncio.get_running_loop(), _until_signal()
        options, project = self._options, self._project
        keys = self._keys()
        self._check_screen(keyed=keys is not None)
        script = None if self._lines is None else _script(self._lines, options.speed)
        trace = None if out is None else TraceOut(options.trace or "", out, stopped.set)

        def heard(events: Any, moment: float) -> None:
            if script is not None:
                script.heard(events, moment)
            if trace is not None:
                trace.heard(events, moment)

        live = Live(
            project,
            self._setup(keys, heard),
            self._performer() if len(options.services) > 1 else None,
            [one for one in options.services if one != "core"],
            partial(self._broker, loop) if _has_broker(project) else None,
        )
        addresses = await live.start()
        try:
            self._up(keys, addresses)
            self._readiness.beat(loop)
            if script is None:
                await stopped.wait()
                return self._status(trace)
            from situ.blackboard.client import AsyncBoard, Link, Person

            own = None if keys is None else keys.own()
            board = AsyncBoard(Link(addresses.requests, Person(role="scenario"), keys=own))
            async with board:
                play = asyncio.create_task(_play(script, live, board, options.clients))
                stop = asyncio.create_task(stopped.wait())
                await asyncio.wait({play, stop}, return_when=asyncio.FIRST_COMPLETED)
                stop.cancel()
                if not play.done():
                    play.cancel()
                    print(f"{options.script}: stopped before its end", file=sys.stderr)
                    return 1
                await play
        finally:
            await live.stop(forget=self._readiness.is_the_end())
        for failure in script.verdict.failures:
            print(f"{options.script}: {failure}", file=sys.stderr)
        return 1 if script.verdict.failures else self._status(trace)

    async def _serve(self) -> int:
        """Services without the core, until a signal comes."""
        import asyncio

        from situ.blackboard.asynchronous import AsyncBoard
        from situ.blackboard.calls import Person
        from situ.blackboard.keys import client_keys, door_to
        from situ.blackboard.link import Link
        from situ.engine.fetching import fetch
        from situ.engine.services import ServicesApart

        loop, stopped = asyncio.get_running_loop(), _until_signal()
        options = self._options
        performer = self._performer()
        robot = self._keys()
        keys = robot.own() if robot is not None else None
        if keys is None and not options.insecure:
            keys = client_keys(self._endpoint, options.keys)
            logging.getLogger("situ.audit").setLevel(logging.INFO)
        self._check_screen(keyed=keys is not None)
        person = Person(role="service", services=options.services)
        board = AsyncBoard(Link(self._endpoint, person, keys=keys), math.inf)
        door = (
            robot.door if robot is not None else door_to(keys.robot) if keys is not None else None
        )
        fetched = self._folder() / "fetched" / "-".join(options.services)
        getting = partial(fetch, folder=fetched, own=self._project)
        apart = ServicesApart(board, options.services, performer, door, getting)
        # However long the core lets itself be waited for: this is no hanging.
        self._readiness.beat(loop)
        start = asyncio.create_task(apart.start())
        stop = asyncio.create_task(stopped.wait())
        await asyncio.wait({start, stop}, return_when=asyncio.FIRST_COMPLETED)
        if not start.done():
            start.cancel()
            await asyncio.gather(start, return_exceptions=True)
            return 0
        try:
            self._readiness.up(self._project.name, 0, await start)
            await stop
        finally:
            stop.cancel()
            if start.exception() is None:
                await apart.stop()
        return 0

    def _up(self, keys: RobotKeys | None, addresses: Addresses) -> None:
        """The core, with what runs beside it here, is ready."""
        project, announced = self._project, None
        if self._lines is None:
            from situ.engine.announcing import announcement

            public = None if keys is None else keys.public
            announced = announcement(project, addresses.requests, public)
        self._readiness.up(project.name, self._kept.version, addresses, announced)

    # -- what they are made of ---------------------------------------------------

    def _performer(self) -> Any:
        """Makes who carries out effects. Raises UsageError for a voice that is none."""
        from situ.engine.perform import Performer
        from situ.engine.voices import find

        voice = find(self._options.speech)

        def make(submit: Any, tag: Any) -> Performer:
            return Performer(
                self._project,
                submit,
                tag=tag,
                screen=self._screen,
                state_dir=self._folder(),
                services=self._options.services,
                voice=voice,
                timeout=self._options.patience,
            )

        return make

    def _deployer(self) -> Deployer | None:
        from situ.engine.deploy import Deployer

        if self._kept.versions is None:
            return None
        return Deployer(self._kept.versions, self._kept.version)

    def _broker(self, loop: asyncio.AbstractEventLoop, submit: Any) -> Any:
        from situ.engine.mqtt import Bridge
        from situ.engine.secrets import Secrets

        mqtt = self._project.mqtt
        assert mqtt is not None
        if self._lines is not None:
            # A scenario says itself what comes in.
            mqtt = replace(mqtt, incoming={})
        return Bridge(mqtt, submit, Secrets(self._folder()), loop, logging.getLogger("situ.mqtt"))

    def _check_screen(self, *, keyed: bool) -> None:
        from situ.blackboard.server import check_reach

        web = f"http://{self._screen[0]}:{self._screen[1]}"
        check_reach(web, keyed=keyed, insecure=self._options.insecure)


def _until_signal() -> asyncio.Event:
    """Is set when somebody asks for the end."""
    import asyncio
    import signal

    loop, stopped = asyncio.get_running_loop(), asyncio.Event()
    for number in (signal.SIGINT, signal.SIGTERM):
        loop.add_signal_handler(number, stopped.set)
    return stopped


def _has_broker(project: Project) -> bool:
    return project.mqtt is not None and bool(project.mqtt.url)


def _script(lines: list[Line], speed: float) -> Script:
    from situ.engine.script import Script

    return Script(lines, speed)


async def _play(script: Script, live: Live, board: AsyncBoard, clients: int) -> None:
    await live.clients(clients)
    await script.play(live, board)


def _beside(endpoint: str) -> str:
    """One port higher, for the same machines."""
    host = endpoint.rpartition(":")[0] if endpoint.startswith("tcp://") else "tcp://127.0.0.1"
    return f"{host}:{_higher(endpoint, 1)}"


def _higher(endpoint: str, by: int) -> int:
    """The port that much above the endpoint's; 0 where that is 0 or has none."""
    port = endpoint.rpartition(":")[2]
    return int(port) + by if port.isdecimal() and int(port) else 0
