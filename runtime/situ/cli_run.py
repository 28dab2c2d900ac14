"""``situ run``: the robot's side, until it is told to stop or its scenario has ended."""

from __future__ import annotations

import argparse
import contextlib
import logging
import math
import sys
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from situ.blackboard.services import PATIENCE, SERVICES

if TYPE_CHECKING:
    from situ.blackboard.client import AsyncBoard
    from situ.blackboard.journal import DurableTags
    from situ.blackboard.keys import RobotKeys
    from situ.document.project import Project
    from situ.engine.live import Live
    from situ.engine.readiness import Readiness
    from situ.engine.record import Recorder
    from situ.engine.recovery import Recovery
    from situ.engine.script import Script
    from situ.engine.trace_out import TraceOut

_log = logging.getLogger("situ.run")


def add(commands: Any) -> None:
    parser = commands.add_parser(
        "run",
        help="run a project: the robot's side",
        description="Runs a project: the blackboard, situations, priorities and applications, "
        "and what carries out what they decide. Ends with Ctrl-C.",
    )
    parser.add_argument(
        "project", metavar="PROJECT", help="a project's folder, or one of its files"
    )
    parser.add_argument(
        "--endpoint",
        metavar="ADDRESS",
        help="where clients ask; port 0 picks a free one; the project's unless given",
    )
    parser.add_argument(
        "--notify", metavar="ADDRESS", help="where they are told; one port higher unless given"
    )
    parser.add_argument(
        "--http",
        type=_host_and_port,
        metavar="HOST:PORT",
        help="the robot's screen; two ports higher than the endpoint unless given",
    )
    parser.add_argument(
        "--keys",
        type=Path,
        metavar="DIR",
        help="the robot's keys and those that it knows (situ keys); keys in the state folder "
        "unless given",
    )
    parser.add_argument(
        "--insecure",
        action="store_true",
        help="let in everybody who can reach the robot, whether or not there are keys",
    )
    parser.add_argument(
        "--services",
        type=_services,
        default=("core", *SERVICES),
        metavar="NAMES",
        help="what runs here: core, engine, robot, screen, with commas; all unless given. Without "
        "core they carry out what the core at --endpoint decides",
    )
    parser.add_argument(
        "--apart", action="store_true", help="each of the services in a process of its own"
    )
    parser.add_argument(
        "--no-restart", action="store_true", help="do not start again what has died"
    )
    # How the processes are started that are started again.
    parser.add_argument("--supervised", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument(
        "--adapter",
        metavar="NAME",
        help="what moves the robot: sim, pybullet, … (docs/adapters.md); the project's unless "
        "given",
    )
    parser.add_argument("--state", type=Path, metavar="DIR", help="where the robot keeps its state")
    parser.add_argument(
        "--speech",
        default="espeak-ng",
        metavar="ENGINE",
        help="who speaks: espeak-ng, speech-dispatcher, or piper:FILE with a voice's .onnx file; "
        "espeak-ng unless given",
    )
    parser.add_argument(
        "--sync",
        action="store_true",
        help="acknowledge durable tags when the disk has them: they survive power loss",
    )
    parser.add_argument(
        "--fresh",
        action="store_true",
        help="start anew even if the robot was killed; durable tags stay",
    )
    parser.add_argument(
        "--patience",
        type=_seconds,
        default=PATIENCE,
        metavar="S",
        help="how long a web service or a module may take to answer an application; "
        f"{PATIENCE:g} unless given",
    )
    parser.add_argument("--script", metavar="S.jsonl", help="a scenario to play; ends with it")
    parser.add_argument(
        "--speed",
        type=_seconds,
        default=1.0,
        metavar="N",
        help="how many times as fast the scenario is played",
    )
    parser.add_argument(
        "--clients",
        type=_count,
        default=0,
        metavar="N",
        help="the scenario begins when so many clients are connected",
    )
    parser.add_argument("--trace", metavar="OUT", help="write the trace here; - is standard output")
    parser.add_argument(
        "--record",
        type=Path,
        metavar="F.mcap",
        help="record inputs and trace here, to be replayed (situ replay)",
    )
    parser.add_argument(
        "--auto-finish",
        type=_seconds,
        metavar="S",
        help="with --script: every action ends well after S seconds",
    )
    parser.add_argument("--seed", type=int, default=0, metavar="N", help="of everything random")
    parser.add_argument("--json", action="store_true", help="say where it is ready as JSON")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    if args.script is None and not (args.no_restart or args.supervised):
        from situ.engine.again import keep_running

        return keep_running(vars(args))
    from msgspec.structs import replace

    from situ.document.ready import load_ready
    from situ.engine.readiness import Readiness
    from situ.errors import UsageError
    from situ.rehearse import scenario

    if args.apart:
        raise UsageError("--apart goes neither with --script nor with --no-restart")
    args.readiness = Readiness(
        supervised=args.supervised, as_json=args.json, aside=args.trace == "-"
    )
    project = load_ready(args.project)
    if args.adapter is not None:
        project = replace(project, adapter=args.adapter)
    if "core" not in args.services:
        import asyncio

        return asyncio.run(_serve(args, project))
    lines = None
    if args.script is not None:
        names = [application.name for application in project.applications.values()]
        lines = scenario.load(args.script, names)
    elif args.auto_finish is not None:
        raise UsageError("--auto-finish goes with --script: alive, actions end when they end")
    with contextlib.ExitStack() as stack:
        kept = Kept() if lines is not None else _kept(args, project, stack)
        if args.record is not None:
            kept = kept._replace(recorders=(*kept.recorders, _recorder(args, project, kept)))
        out = None
        if args.trace == "-":
            out = sys.stdout.buffer
        elif args.trace is not None:
            try:
                # Without a buffer: what could not be written must not be tried again at the end.
                mode = "ab" if kept.recovery and kept.recovery.found else "wb"
                out = stack.enter_context(open(args.trace, mode, buffering=0))
            except OSError as error:
                raise UsageError(f"{args.trace}: {error.strerror or error}") from None
        if lines is None and args.services == ("core",) and not _has_broker(project):
            return _run_core(args, project, out, kept)
        import asyncio

        return asyncio.run(_run(args, project, lines, out, kept))


class Kept(NamedTuple):
    """What outlives the process; nothing does where a scenario is played."""

    durable: DurableTags | None = None
    recovery: Recovery | None = None
    recorders: tuple[Recorder, ...] = ()


def _kept(args: argparse.Namespace, project: Project, stack: contextlib.ExitStack) -> Kept:
    from situ.blackboard.journal import DurableTags, patterns
    from situ.engine.folder import StateFolder, state_folder
    from situ.engine.record import RING, Recorder, RingFiles, recorded_files
    from situ.engine.recovery import Recovery

    folder = StateFolder(state_folder(args.state, project))
    stack.callback(folder.close)
    durable = None
    if durable_tags := patterns(project):
        durable = DurableTags(folder.path, durable_tags, sync=args.sync)
        stack.callback(durable.close)
    recovery = Recovery(folder.path, project)
    if args.fresh:
        recovery.forget()
    ring = Recorder(RingFiles(folder.path / RING), recorded_files(project))
    return Kept(durable, recovery, (ring,))


def _recorder(args: argparse.Namespace, project: Project, kept: Kept) -> Recorder:
    from situ.engine.record import OneFile, Recorder, recorded_files

    goes_on = kept.recovery is not None and kept.recovery.found is not None
    return Recorder(OneFile(args.record, goes_on=goes_on), recorded_files(project))


def _status(args: argparse.Namespace, kept: Kept, trace: TraceOut | None) -> int:
    """Whether what was asked for could be written."""
    told = kept.recorders[-1].torn if args.record is not None else None
    return (0 if trace is None else trace.status()) or int(told is not None)


def _has_broker(project: Project) -> bool:
    return project.mqtt is not None and bool(project.mqtt.url)


def _run_core(args: argparse.Namespace, project: Project, out: Any, kept: Kept) -> int:
    """The core without anything beside it, until a signal comes."""
    import signal
    import time

    from situ.engine import core_loop
    from situ.engine.deciding import Deciding
    from situ.engine.trace_out import TraceOut
    from situ.engine.waking import Waking

    readiness: Readiness = args.readiness
    endpoint = project.endpoint if args.endpoint is None else args.endpoint
    with Waking(signal.SIGINT, signal.SIGTERM) as waking:
        trace = None
        if out is not None:
            trace = TraceOut(args.trace, out, lambda: waking.came.append(signal.SIGPIPE))
        deciding = Deciding(
            project,
            endpoint,
            args.notify or _beside(endpoint),
            time.monotonic,
            waking.soon,
            files=_files(project),
            seed=args.seed,
            heard=None if trace is None else trace.heard,
            durable=kept.durable,
            recovery=kept.recovery,
            recorders=kept.recorders,
            keys=_keys(args, project),
            insecure=args.insecure,
            patience=args.patience,
        )
        core_loop.run(
            deciding,
            waking,
            readiness.notifier,
            kept.durable,
            partial(readiness.up, project.name),
            readiness.is_the_end,
        )
    return _status(args, kept, trace)


async def _run(args: argparse.Namespace, project: Project, lines: Any, out: Any, kept: Kept) -> int:
    import asyncio
    import signal

    from msgspec.structs import replace

    from situ.blackboard.client import AsyncBoard, Link, Person
    from situ.blackboard.server import check_reach
    from situ.decide.trace import TraceEvent
    from situ.engine.folder import state_folder
    from situ.engine.live import Live
    from situ.engine.perform import Performer
    from situ.engine.script import Script
    from situ.engine.trace_out import TraceOut
    from situ.engine.voices import find

    loop = asyncio.get_running_loop()
    stopped = asyncio.Event()
    for number in (signal.SIGINT, signal.SIGTERM):
        loop.add_signal_handler(number, stopped.set)
    endpoint = project.endpoint if args.endpoint is None else args.endpoint
    screen = args.http or ("127.0.0.1", _higher(endpoint, 2))
    keys = _keys(args, project)
    web = f"http://{screen[0]}:{screen[1]}"
    check_reach(web, keyed=keys is not None, insecure=args.insecure)
    script = None if lines is None else Script(lines, args.speed)

    trace = None if out is None else TraceOut(args.trace, out, stopped.set)

    def heard(events: list[TraceEvent], moment: float) -> None:
        if script is not None:
            script.heard(events, moment)
        if trace is not None:
            trace.heard(events, moment)

    voice = find(args.speech)

    def performer(submit: Any, tag: Any) -> Performer:
        state = state_folder(args.state, project)
        return Performer(
            project,
            submit,
            tag=tag,
            screen=screen,
            state_dir=state,
            services=args.services,
            voice=voice,
            timeout=args.patience,
        )

    def broker(submit: Any) -> Any:
        from situ.engine.mqtt import Bridge
        from situ.engine.secrets import Secrets

        assert project.mqtt is not None
        secrets = Secrets(state_folder(args.state, project))
        # A scenario says itself what comes in.
        mqtt = project.mqtt if script is None else replace(project.mqtt, incoming={})
        return Bridge(mqtt, submit, secrets, loop, logging.getLogger("situ.mqtt"))

    live = Live(
        project,
        endpoint,
        args.notify or _beside(endpoint),
        performer if len(args.services) > 1 else None,
        services=[one for one in args.services if one != "core"],
        files=_files(project),
        scripted=script is not None,
        seed=args.seed,
        auto_finish=args.auto_finish,
        heard=heard,
        durable=kept.durable,
        recovery=kept.recovery,
        recorders=kept.recorders,
        keys=keys,
        insecure=args.insecure,
        patience=args.patience,
        broker=broker if _has_broker(project) else None,
    )
    addresses = await live.start()
    try:
        args.readiness.up(project.name, addresses)
        args.readiness.beat(loop)
        if script is None:
            await stopped.wait()
            return _status(args, kept, trace)
        own = None if keys is None else keys.own()
        board = AsyncBoard(Link(addresses.requests, Person(role="scenario"), keys=own))
        async with board:
            play = asyncio.create_task(_play(script, live, board, args.clients))
            stop = asyncio.create_task(stopped.wait())
            await asyncio.wait({play, stop}, return_when=asyncio.FIRST_COMPLETED)
            stop.cancel()
            if not play.done():
                play.cancel()
                print(f"{args.script}: stopped before its end", file=sys.stderr)
                return 1
            await play
    finally:
        await live.stop(forget=args.readiness.is_the_end())
    for failure in script.verdict.failures:
        print(f"{args.script}: {failure}", file=sys.stderr)
    if script.verdict.failures:
        return 1
    return _status(args, kept, trace)


async def _serve(args: argparse.Namespace, project: Project) -> int:
    """Services without the core, until a signal comes."""
    import asyncio
    import signal

    from situ.blackboard.asynchronous import AsyncBoard
    from situ.blackboard.calls import Person
    from situ.blackboard.keys import client_keys, door_to
    from situ.blackboard.link import Link
    from situ.blackboard.server import check_reach
    from situ.engine.folder import state_folder
    from situ.engine.perform import Performer
    from situ.engine.services import ServicesApart
    from situ.engine.voices import find

    loop = asyncio.get_running_loop()
    stopped = asyncio.Event()
    for number in (signal.SIGINT, signal.SIGTERM):
        loop.add_signal_handler(number, stopped.set)
    endpoint = project.endpoint if args.endpoint is None else args.endpoint
    screen = args.http or ("127.0.0.1", _higher(endpoint, 2))

    voice = find(args.speech)

    def performer(submit: Any, tag: Any) -> Performer:
        state = state_folder(args.state, project)
        return Performer(
            project,
            submit,
            tag=tag,
            screen=screen,
            state_dir=state,
            services=args.services,
            voice=voice,
            timeout=args.patience,
        )

    robot = _keys(args, project)
    keys = robot.own() if robot is not None else None
    if keys is None and not args.insecure:
        keys = client_keys(endpoint, args.keys)
        logging.getLogger("situ.audit").setLevel(logging.INFO)
    web = f"http://{screen[0]}:{screen[1]}"
    check_reach(web, keyed=keys is not None, insecure=args.insecure)
    person = Person(role="service", services=args.services)
    board = AsyncBoard(Link(endpoint, person, keys=keys), math.inf)
    door = robot.door if robot is not None else door_to(keys.robot) if keys is not None else None
    apart = ServicesApart(board, args.services, performer, door)
    # However long the core lets itself be waited for: this is no hanging.
    args.readiness.beat(loop)
    start = asyncio.create_task(apart.start())
    stop = asyncio.create_task(stopped.wait())
    await asyncio.wait({start, stop}, return_when=asyncio.FIRST_COMPLETED)
    if not start.done():
        start.cancel()
        await asyncio.gather(start, return_exceptions=True)
        return 0
    try:
        args.readiness.up(project.name, await start)
        await stop
    finally:
        stop.cancel()
        if start.exception() is None:
            await apart.stop()
    return 0


def _keys(args: argparse.Namespace, project: Project) -> RobotKeys | None:
    """The robot's keys; None: everybody may come in."""
    from situ.blackboard.keys import KNOWN, RobotKeys, has_keys
    from situ.engine.folder import state_folder

    if args.insecure:
        _log.warning("--insecure: whoever can reach this robot may do everything with it")
        return None
    folder = args.keys or state_folder(args.state, project) / "keys"
    if args.keys is None and not has_keys(folder):
        return None
    if "core" not in args.services and not (folder / KNOWN).is_dir():
        # Those of a client of a core elsewhere.
        return None
    # Who came in, and who did not, is always told.
    logging.getLogger("situ.audit").setLevel(logging.INFO)
    return RobotKeys(folder)


async def _play(script: Script, live: Live, board: AsyncBoard, clients: int) -> None:
    await live.clients(clients)
    await script.play(live, board)


def _files(project: Project) -> dict[str, str]:
    """The project's documents as they lie there, by their paths in the project."""
    paths = [*project.applications, project.spds_file, project.modules_file]
    if project.toml is not None:
        paths.insert(0, "situ.toml")
    root = Path(project.root)
    return {path: (root / path).read_text("utf-8") for path in paths if path is not None}


def _beside(endpoint: str) -> str:
    """One port higher, for the same machines."""
    host = endpoint.rpartition(":")[0] if endpoint.startswith("tcp://") else "tcp://127.0.0.1"
    return f"{host}:{_higher(endpoint, 1)}"


def _higher(endpoint: str, by: int) -> int:
    """The port that much above the endpoint's; 0 where that is 0 or has none."""
    port = endpoint.rpartition(":")[2]
    return int(port) + by if port.isdecimal() and int(port) else 0


def _host_and_port(text: str) -> tuple[str, int]:
    host, colon, port = text.rpartition(":")
    if not colon or not port.isdecimal() or int(port) > 65535:
        raise argparse.ArgumentTypeError("HOST:PORT is needed, as 127.0.0.1:5572")
    return host.strip("[]") or "127.0.0.1", int(port)


def _services(text: str) -> tuple[str, ...]:
    named = [name.strip() for name in text.split(",")]
    known = ("core", *SERVICES)
    for name in named:
        if name not in known:
            raise argparse.ArgumentTypeError(f"{name!r} is none of {', '.join(known)}")
    return tuple(name for name in known if name in named)


def _count(text: str) -> int:
    if not text.isdecimal():
        raise argparse.ArgumentTypeError("a whole number is needed")
    return int(text)


def _seconds(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0 < value < 1e9:
        raise argparse.ArgumentTypeError("a number above 0 is needed")
    return value
