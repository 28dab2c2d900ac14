"""``situ check``: what is wrong with projects and documents, as lines or as JSON."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from situ.document.problem import Problem

KEYS = ("file", "line", "column", "severity", "code", "message")


def add(commands: Any) -> None:
    parser = commands.add_parser(
        "check",
        help="find what is wrong in projects and files",
        description="Prints what is wrong, one problem a line: file:line:column: severity code "
        "message. Exit status 1 when there is an error, 2 when a path cannot be read, or with "
        "--fix be written.",
    )
    parser.add_argument(
        "paths", nargs="+", metavar="PATH", help="a project, or one .rbd.xml or .spds.xml file"
    )
    parser.add_argument(
        "--json",
        action="store_true",
        help="a list of {file, line, column, severity, code, message}; with --fix each has "
        "mended, too: whether it has been",
    )
    parser.add_argument(
        "--fix",
        action="store_true",
        help="mend what has one sensible mend that changes nothing of what the robot does, "
        "write the files, and print what was mended and what is left",
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    from situ.errors import UsageError

    mended: list[Problem] = []
    problems: list[Problem] = []
    unreadable: list[str] = []
    for path in args.paths:
        try:
            found = _fixed(path, mended, unreadable) if args.fix else _checked(path)
        except UsageError as error:
            unreadable.append(str(error))
            continue
        problems += [one for one in found if one not in problems]
    for line in unreadable:
        print(f"situ: {line}", file=sys.stderr)
    if args.json:
        _print_json(problems, mended if args.fix else None)
    else:
        for problem in mended:
            assert problem.mend is not None
            where = f"{problem.file}:{problem.line}:{problem.column}"
            print(f"{where}: mended {problem.code} {problem.mend.words}")
        for problem in problems:
            print(problem)
    if unreadable:
        return 2
    return 1 if any(problem.severity == "error" for problem in problems) else 0


def _checked(path: str) -> list[Problem]:
    from situ.document.check import check, merge
    from situ.document.folder import load

    project, found = load(path)
    return merge(found, check(project)) if project is not None else found


def _fixed(path: str, mended: list[Problem], unreadable: list[str]) -> list[Problem]:
    """What is left of a path's problems; what was mended, and what was not written, is added."""
    from situ.document.fix import fix

    found = fix(path)
    mended += found.mended
    unreadable += found.refused
    return found.left


def _print_json(problems: list[Problem], mended: list[Problem] | None) -> None:
    import json

    listed = [{key: getattr(one, key) for key in KEYS} for one in (*(mended or ()), *problems)]
    if mended is not None:
        for at, one in enumerate(listed):
            one["mended"] = at < len(mended)
    print(json.dumps(listed, ensure_ascii=False, indent=2))
