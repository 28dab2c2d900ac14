"""``situ report``: how often each service was used, how long, and where people gave up."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING, Any, TextIO

if TYPE_CHECKING:
    from situ.rehearse.usage import Row


def add(commands: Any) -> None:
    parser = commands.add_parser(
        "report",
        help="how often each service was used, how long, where people gave up",
        description="Counts over recordings (.mcap) and traces (.jsonl): how often each state and "
        "part was used, in how many visits, how long, and how often people gave up there; by "
        "place. One row each, as CSV.",
    )
    parser.add_argument(
        "traces", metavar="F", nargs="+", help="recordings and traces; a ring's files in order"
    )
    parser.add_argument("-o", dest="out", metavar="usage.csv", help="write here; default: stdout")
    parser.add_argument(
        "--place",
        metavar="TAG",
        default="pose.place",
        help="the tag that says where the robot is; pose.place unless given",
    )
    parser.add_argument(
        "--project", metavar="P", help="the project that ran, for the names of states in a .jsonl"
    )
    parser.add_argument("--json", action="store_true", help="a list of objects instead")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    from situ.document.ready import load_ready
    from situ.errors import UsageError
    from situ.rehearse.usage import Usage, count

    project = load_ready(args.project) if args.project is not None else None
    usage = Usage(args.place)
    for trace in args.traces:
        count(usage, trace, project)
    rows = usage.rows()
    if args.out is None:
        _write(args, rows, sys.stdout)
        return 0
    try:
        with open(args.out, "w", encoding="utf-8", newline="") as out:
            _write(args, rows, out)
    except OSError as error:
        raise UsageError(f"{args.out}: {error.strerror or error}") from None
    return 0


def _write(args: argparse.Namespace, rows: list[Row], out: TextIO) -> None:
    import msgspec

    from situ.rehearse.usage import write_csv

    if args.json:
        out.write(msgspec.json.format(msgspec.json.encode(rows), indent=2).decode() + "\n")
        return
    write_csv(rows, out)
