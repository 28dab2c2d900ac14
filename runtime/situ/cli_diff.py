"""``situ diff``: what changed between two projects or documents, in plain words."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from situ.document.change import Change
    from situ.document.project import Project

SHOWN = 3
"""Things moved in the drawing that are named one by one."""


def add(commands: Any) -> None:
    parser = commands.add_parser(
        "diff",
        help="what changed between two projects or files, in plain words",
        description="Compares by meaning, not by line. Exit status 0 when the robot would act "
        "the same, also where things only moved in the drawing; 1 when it may act differently; "
        "2 when one of the two cannot be read.",
    )
    parser.add_argument("before", metavar="A", help="a project, or one .xml document")
    parser.add_argument("after", metavar="B", help="the same later, or elsewhere")
    parser.add_argument(
        "--json", action="store_true", help="a list of {file, place, text, behaviour, kind}"
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    import msgspec

    from situ.document.diff import compare
    from situ.document.diff_media import compare_media

    before, after = _load(args.before), _load(args.after)
    changes = [*compare(before, after), *compare_media(before, after)]
    if args.json:
        print(msgspec.json.format(msgspec.json.encode(changes), indent=2).decode())
    else:
        for line in told(changes):
            print(line)
    return 1 if any(change.behaviour for change in changes) else 0


def told(changes: list[Change]) -> list[str]:
    """The changes as lines: behaviour first, what moved in the drawing summed up."""
    files = {change.file for change in changes}
    lines = [_line(change, files) for change in changes if change.behaviour]
    if not changes:
        return ["No differences."]
    if not lines:
        lines.append("The robot acts the same; only what people see of the project changed:")
    silent = [change for change in changes if not change.behaviour]
    lines += [_line(change, files) for change in silent if change.kind != "moved"]
    for file in dict.fromkeys(change.file for change in silent):
        moved = [c for c in silent if c.kind == "moved" and c.file == file]
        if len(moved) <= SHOWN:
            lines += [_line(change, files) for change in moved]
        else:
            start = f"{file}: " if len(files) > 1 else ""
            lines.append(f"{start}{len(moved)} things moved in the drawing")
    return lines


def _line(change: Change, files: set[str]) -> str:
    return f"{change.file}: {change.text}" if len(files) > 1 else change.text


def _load(path: str) -> Project:
    """A project that can be read; what ``check`` would find wrong in it does not matter here."""
    from situ.document.folder import load
    from situ.errors import ProjectError

    project, problems = load(path)
    errors = [problem for problem in problems if problem.severity == "error"]
    if project is None or errors:
        raise ProjectError(str(errors[0]) if errors else f"{path}: not a project")
    return project
