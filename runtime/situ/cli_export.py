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
    import shutil
    import tempfile

    from situ.document.export import deployable
    from situ.document.flatten import flatten
    from situ.document.ready import load_ready
    from situ.errors import UsageError

    output: Path = args.output
    if output.is_symlink() or (output.exists() and not output.is_dir()):
        raise UsageError(f"{output}: there is a file of this name; name another folder with -o")
    if output.is_dir() and any(output.iterdir()):
        raise UsageError(f"{output}: is not empty; name a new or an empty folder with -o")
    project = load_ready(args.project)
    files = deployable(flatten(project) if args.flat else project)
    # All or nothing: the folder appears when everything is in it.
    parent = output.absolute().parent
    parent.mkdir(parents=True, exist_ok=True)
    whole = Path(tempfile.mkdtemp(prefix=f".{output.name}.", dir=parent))
    try:
        for file, data in files.items():
            target = whole / file
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(data)
        whole.chmod(0o755)
        whole.rename(output)
    except BaseException:
        shutil.rmtree(whole, ignore_errors=True)
        raise
    return 0
