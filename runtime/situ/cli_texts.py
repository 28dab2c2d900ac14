"""``situ texts``: the files in which the texts of a project are translated."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from situ.document.texts_update import Update


def add(commands: Any) -> None:
    parser = commands.add_parser(
        "texts",
        help="extract and update the .po files of a project's languages",
        description="Writes texts/LANG.po for every language of the project but the first, in "
        "which it is written (that one where there is a file of it). Every text that is shown, "
        "spoken or heard gets an entry; translations, comments and the header are kept; what is "
        "gone is kept as obsolete. A new text that is like one that is gone takes over its "
        "translation, marked fuzzy: the robot does not use it before somebody has looked at it.",
    )
    parser.add_argument("project", metavar="PROJECT", help="a project")
    parser.add_argument(
        "--check", action="store_true", help="write nothing; exit 1 when something would change"
    )
    parser.add_argument("--json", action="store_true", help="what changed, as JSON")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    from pathlib import Path

    import msgspec

    from situ.document.folder import TEXTS_FOLDER, called, write
    from situ.document.ready import load_ready
    from situ.document.texts_update import update
    from situ.errors import ProjectError, UsageError

    project = load_ready(args.project)
    if project.toml is None:
        raise UsageError(f"{args.project}: give the project, whose situ.toml names its languages")
    # All are read before one is written: of several files none is half of a run.
    updates = []
    for number, language in enumerate(project.languages):
        file = called(project.root, f"{TEXTS_FOLDER}/{language}.po")
        data = Path(file).read_bytes() if Path(file).exists() else None
        if number == 0 and data is None:
            continue
        made, problems = update(project, language, data, file)
        if made is None:
            raise ProjectError(str(problems[0]))
        updates.append((language, file, made, made.data != data))
    told = []
    for language, file, made, is_changed in updates:
        if is_changed and not args.check:
            Path(file).parent.mkdir(exist_ok=True)
            write(file, made.data)
        told.append(
            {
                "language": language,
                "file": file,
                "changed": is_changed,
                **{name: getattr(made, name) for name in made.__struct_fields__ if name != "data"},
            }
        )
        if not args.json:
            print(f"{file}: {_words(made, is_changed, args.check)}")
    if args.json:
        print(msgspec.json.format(msgspec.json.encode(told), indent=2).decode())
    elif not updates:
        print(f"{args.project}: one language only; name others in languages of situ.toml")
    return int(args.check and any(is_changed for *_, is_changed in updates))


def _words(made: Update, is_changed: bool, is_check: bool) -> str:
    """``16 texts, 14 translated; 2 new (1 to be looked at), 1 gone``."""
    found = f"{made.texts} texts, {made.translated} translated"
    if not is_changed:
        return f"{found}; up to date"
    unsure = f" ({len(made.unsure)} to be looked at)" if made.unsure else ""
    came = f"{len(made.new)} new{unsure}, {len(made.gone)} gone"
    if not made.new and not made.gone:
        came = "places changed"
    return f"{found}; {came}; not written" if is_check else f"{found}; {came}"
