"""``situ check``: what is wrong with projects and documents, as lines or as JSON."""

from __future__ import annotations

import argparse
import sys
from typing import Any


def add(commands: Any) -> None:
    parser = commands.add_parser(
        "check",
        help="find what is wrong in projects and files",
        description="Prints what is wrong, one problem a line: file:line:column: severity code "
        "message. Exit status 1 when there is an error, 2 when a path cannot be read.",
    )
    parser.add_argument(
        "paths", nargs="+", metavar="PATH", help="a project, or one .rbd.xml or .spds.xml file"
    )
    parser.add_argument(
        "--json",
        action="store_true",
        help="a list of {file, line, column, severity, code, message}",
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    import json

    from situ.document.check import check, merge
    from situ.document.folder import load
    from situ.document.problem import Problem
    from situ.errors import UsageError

    problems: list[Problem] = []
    unreadable = False
    for path in args.paths:
        try:
            project, found = load(path)
        except UsageError as error:
            print(f"situ: {error}", file=sys.stderr)
            unreadable = True
            continue
        if project is not None:
            found = merge(found, check(project))
        problems += [one for one in found if one not in problems]
    if args.json:
        keys = ("file", "line", "column", "severity", "code", "message")
        listed = [{key: getattr(one, key) for key in keys} for one in problems]
        print(json.dumps(listed, ensure_ascii=False, indent=2))
    else:
        for problem in problems:
            print(problem)
    if unreadable:
        return 2
    return 1 if any(problem.severity == "error" for problem in problems) else 0
