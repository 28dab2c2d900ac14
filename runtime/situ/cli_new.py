"""``situ new``: a project to start from."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any


def add(commands: Any) -> None:
    parser = commands.add_parser(
        "new",
        help="a project to start from",
        description="Makes a project that runs as it is, with a scenario that tests it, named "
        "after its folder. Templates: empty, one application of one state; reception, screens "
        "with a question, a way home and a timeout; menu, services to choose from; reminder, a "
        "medication that is asked for once a day; conversation, an application and two modules "
        "that share a robot by situations.",
    )
    parser.add_argument("folder", type=Path, metavar="DIR", help="a new or an empty folder")
    parser.add_argument(
        "--template", default="empty", metavar="NAME", help="what to start from; empty unless given"
    )
    parser.add_argument(
        "--language",
        default="en",
        metavar="LANG",
        help="the language in which it is written: en unless given, or ja",
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    from situ.document.beginning import begin, project_name
    from situ.resources import template

    source = template(args.template)
    begin(source, args.folder, project_name(args.folder.resolve().name), args.language)
    print(f"{args.folder}: made from the template {args.template}; now: situ studio {args.folder}")
    return 0
