"""``situ run``: the robot's side, until it is told to stop or its scenario has ended."""

from __future__ import annotations

import argparse
import secrets
from pathlib import Path
from typing import Any

from situ.blackboard.services import PATIENCE, SERVICES
from situ.cli_simulate import above_zero


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
        "--as-given",
        action="store_true",
        help="run PROJECT as it lies there, whatever has been deployed since",
    )
    parser.add_argument(
        "--patience",
        type=above_zero,
        default=PATIENCE,
        metavar="S",
        help="how long a web service or a module may take to answer an application; "
        f"{PATIENCE:g} unless given",
    )
    parser.add_argument("--script", metavar="S.jsonl", help="a scenario to play; ends with it")
    parser.add_argument(
        "--speed",
        type=above_zero,
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
        type=above_zero,
        metavar="S",
        help="with --script: every action ends well after S seconds",
    )
    parser.add_argument(
        "--seed",
        type=int,
        metavar="N",
        help="of everything random; unless given, 0 with --script and else another each time",
    )
    parser.add_argument("--json", action="store_true", help="say where it is ready as JSON")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    args.seed = seed_for(args.script, args.seed)
    if args.script is None and not (args.no_restart or args.supervised):
        from situ.engine.again import keep_running

        return keep_running(vars(args))
    from msgspec.structs import replace

    from situ.document.ready import load_ready
    from situ.engine.running import Options, Run
    from situ.errors import UsageError
    from situ.rehearse import scenario

    if args.apart:
        raise UsageError("--apart goes neither with --script nor with --no-restart")
    project = load_ready(args.project)
    if args.adapter is not None:
        project = replace(project, adapter=args.adapter)
    lines = None
    # Services without their core play no scenario.
    if args.script is not None and "core" in args.services:
        names = [application.name for application in project.applications.values()]
        lines = scenario.load(args.script, names)
    elif args.auto_finish is not None and args.script is None:
        raise UsageError("--auto-finish goes with --script: alive, actions end when they end")
    options = Options(**{name: getattr(args, name) for name in Options.__struct_fields__})
    return Run(project, options, lines).run()


def seed_for(script: str | None, given: int | None) -> int:
    """A scenario is played as it is simulated; who plays with a robot is not asked the same every
    morning. A recording keeps which it was."""
    if given is not None:
        return given
    return 0 if script is not None else secrets.randbits(32)


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
