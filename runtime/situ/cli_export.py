"""``situ export``: the files of a project that go to a robot."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any


def add(commands: Any) -> None:
    parser = commands.add_parser(
        "export",
        help="write the files that go to a robot",
        description="Writes a project's documents without what only the editor needs, its media "
        "and texts. A project with errors is refused.",
    )
    parser.add_argument("project", metavar="PROJECT", help="a project, or one document")
    parser.add_argument(
        "-o",
        "--output",
        required=True,
        type=Path,
        metavar="DIR",
        help="a folder that does not exist yet, or is empty",
    )
    parser.add_argument(
        "--flat",
        action="store_true",
        help="write applications without parts and without <always> that do the same",
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    from situ.document.export import check_free, deployable, write_out
    from situ.document.flatten import flatten
    from situ.document.ready import load_ready

    check_free(args.output)
    project = load_ready(args.project)
    write_out(deployable(flatten(project) if args.flat else project), args.output)
    return 0
