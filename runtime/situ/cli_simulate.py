"""``situ simulate``: a scenario in virtual time, its trace as JSON lines."""

from __future__ import annotations

import argparse
import sys
from typing import Any


def add(commands: Any) -> None:
    parser = commands.add_parser(
        "simulate",
        help="play a scenario in virtual time and print its trace",
        description="Plays a scenario without a robot. Deterministic: the same input gives the "
        "same bytes. Exit status 1 when an expectation of the scenario fails.",
    )
    parser.add_argument("path", metavar="PATH", help="a project, or one .rbd.xml or .spds.xml file")
    parser.add_argument("--script", required=True, metavar="S.jsonl", help="the scenario")
    parser.add_argument("--trace", metavar="OUT", help="write the trace here; default: to stdout")
    parser.add_argument(
        "--auto-finish", type=above_zero, metavar="S", help="every action ends well after S seconds"
    )
    parser.add_argument("--seed", type=int, default=0, metavar="N", help="of everything random")
    parser.set_defaults(run=run)


def above_zero(text: str) -> float:
    """A time or a speed on the command line."""
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0 < value < 1e9:
        raise argparse.ArgumentTypeError("a number above 0 is needed")
    return value


def run(args: argparse.Namespace) -> int:
    from contextlib import ExitStack

    from situ.decide.trace import TraceEvent, to_line
    from situ.document.ready import load_ready
    from situ.errors import UsageError
    from situ.rehearse import scenario
    from situ.rehearse.simulate import simulate

    project = load_ready(args.path)
    names = [application.name for application in project.applications.values()]
    lines = scenario.load(args.script, names)
    with ExitStack() as stack:
        out = sys.stdout.buffer
        if args.trace is not None:
            try:
                out = stack.enter_context(open(args.trace, "wb"))
            except OSError as error:
                raise UsageError(f"{args.trace}: {error.strerror or error}") from None

        def tell(events: list[TraceEvent]) -> None:
            out.writelines(map(to_line, events))

        verdict = simulate(project, lines, args.seed, args.auto_finish, tell)
        out.flush()
    for failure in verdict.failures:
        print(f"{args.script}: {failure}", file=sys.stderr)
    return 1 if verdict.failures else 0
