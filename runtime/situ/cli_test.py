"""``situ test``: every scenario of a project, what failed and why, what was covered."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from situ.cli_simulate import above_zero


def add(commands: Any) -> None:
    parser = commands.add_parser(
        "test",
        help="play every scenario of a project",
        description="Plays the scenarios of the project's folder in virtual time and prints a "
        "line for each, what failed with its causes, and what was covered. Exit status 1 when "
        "an expectation fails, 2 when a scenario cannot be read or there is none.",
    )
    parser.add_argument("project", metavar="PROJECT", help="a project")
    parser.add_argument(
        "scenarios", nargs="*", metavar="S.jsonl", help="only these; all of the folder unless given"
    )
    parser.add_argument("--junit", metavar="F", help="write the result as JUnit XML")
    parser.add_argument("--coverage", metavar="OUT.json", help="write what was covered as JSON")
    parser.add_argument("--json", action="store_true", help="the whole result as JSON")
    parser.add_argument(
        "--auto-finish", type=above_zero, metavar="S", help="every action ends well after S seconds"
    )
    parser.add_argument("--seed", type=int, default=0, metavar="N", help="of everything random")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    import msgspec

    from situ.document.folder import write
    from situ.document.ready import load_ready
    from situ.rehearse.junit import junit
    from situ.rehearse.suite import details, document, run_suite, scenarios, summary

    project = load_ready(args.project)
    files = [Path(file) for file in args.scenarios] or scenarios(project)
    suite = run_suite(project, files, args.seed, args.auto_finish)
    if args.junit is not None:
        write(args.junit, junit(suite, project))
    if args.coverage is not None:
        write(args.coverage, _json(suite.coverage.document()))
    if args.json:
        print(msgspec.json.format(msgspec.json.encode(document(suite)), indent=2).decode())
        return suite.status
    for one in suite.played:
        print(summary(one))
        for failed in one.failed:
            for line in details(failed, project):
                print(f"      {line}")
    print()
    for line in suite.coverage.lines():
        print(line)
    return suite.status


def _json(value: Any) -> bytes:
    import msgspec

    return msgspec.json.format(msgspec.json.encode(value), indent=2) + b"\n"
