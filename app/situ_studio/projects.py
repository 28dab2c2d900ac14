"""Projects that the studio makes: empty new ones, and copies of the examples."""

from __future__ import annotations

import re
import shutil
import unicodedata
from pathlib import Path

from situ.document import codec, folder, rbd
from situ.document.aside import NOTHING
from situ.errors import UsageError
from situ.resources import example

_TOML = """\
[project]
name = "{name}"
applications = ["{name}.rbd.xml"]
"""


def file_name(title: str) -> str:
    """A project's name for what a person typed: ``robot-nurse-2`` for ``Robot nurse 2``.

    What they typed itself where nothing in it fits into a name.
    """
    plain = unicodedata.normalize("NFKD", title).encode("ascii", "ignore").decode().lower()
    made = re.sub(r"[^a-z0-9_]+", "-", plain).strip("-_")
    made = re.sub(r"^[^a-z]+", "", made)
    return made or title


def new_project(parent: Path, name: str) -> Path:
    """Makes the folder ``name`` in ``parent`` with one application of one state.

    Raises UsageError where the name is none, the folder exists, or it can not be made.
    """
    if not re.fullmatch(r"[a-z][a-z0-9_-]*", name):
        raise UsageError(
            f"{name!r} is no name for a project: use small letters, digits, - and _, a letter first"
        )
    target = parent / name
    if target.exists():
        raise UsageError(f"{target} exists already: choose another name")
    state = rbd.State(
        no="1",
        name="start",
        screen=rbd.Screen(
            components=(
                rbd.Text(
                    id="hello",
                    x=10,
                    y=20,
                    width=80,
                    height=20,
                    size=9,
                    align="center",
                    text="Hello",
                ),
            )
        ),
        actions=(rbd.Speech(text="Hello"),),
        aside=NOTHING.at(24, 56),
    )
    application = rbd.Application(name=name, start="1", states=(state,))
    try:
        target.mkdir(parents=True)
        folder.write(target / f"{name}.rbd.xml", codec.write(application))
        folder.write(target / folder.PROJECT_FILE, _TOML.format(name=name).encode())
    except OSError as error:
        raise UsageError(f"{target}: can not be made: {error.strerror or error}") from error
    return target


def copy_example(name: str, parent: Path) -> Path:
    """Copies an example into ``parent``, under a name that is free there; its folder.

    Raises UsageError where there is no such example, or it can not be copied.
    """
    source = example(name)
    target, number = parent / name, 2
    while target.exists():
        target, number = parent / f"{name}-{number}", number + 1
    try:
        shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__", ".*"))
    except (OSError, shutil.Error) as error:
        raise UsageError(f"{target}: can not be made: {error}") from error
    return target
