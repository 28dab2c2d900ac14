"""Pictures and movies that come into a project: copied into its media folder, under a safe name."""

from __future__ import annotations

import filecmp
import os
import re
import shutil
import unicodedata
from collections.abc import Iterator
from pathlib import Path

from situ.document.folder import resolve
from situ.document.project import Project
from situ.errors import UsageError
from situ_studio.wording.language import tr

PICTURES = (".png", ".jpg", ".jpeg", ".gif", ".webp", ".avif", ".svg")
MOVIES = (".webm", ".mp4", ".ogv")
SOUNDS = (".wav", ".ogg", ".oga", ".mp3", ".m4a")
"""What the robot's page shows and plays (situ.engine.screen.server has the same)."""
ENDINGS = {"image": PICTURES, "movie": MOVIES, "sound": SOUNDS}
"""By the kind of what shows or plays a file."""
LARGEST = 64 * 2**20
"""Bytes of one file: a robot gets a project over the network, in one piece."""
FOLDER = "media"
"""For a project that names no folder of its own."""


def kind_of(path: str | Path) -> str:
    """``image`` or ``movie``; "" where the robot's page can not show such a file."""
    ending = Path(path).suffix.lower()
    return "image" if ending in PICTURES else "movie" if ending in MOVIES else ""


def home_of(project: Project) -> Path | None:
    """The folder from which a project names its media: its media folder, its own without one; None
    where that is outside of it.
    """
    return resolve(project.root, project.media or ".")


def names_of(project: Project) -> tuple[str, ...]:
    """All media that are there, as a project names them, sorted.

    Of one without a media folder those of the folder that ``bring`` fills, and what lies beside
    its documents.
    """
    home = home_of(project)
    if home is None or not home.is_dir():
        return ()
    if project.media is not None:
        return tuple(sorted(_files(home)))
    both = (*_files(home, deep=False), *_files(home / FOLDER, f"{FOLDER}/"))
    endings = (*PICTURES, *MOVIES, *SOUNDS)
    return tuple(sorted(one for one in both if Path(one).suffix.lower() in endings))


def _files(folder: Path | str, above: str = "", deep: bool = True) -> Iterator[str]:
    """As they are called below a folder, which is called ``above``; none where it can not be read.

    Folders say what their entries are: each edit reads these names, and asks no file.
    """
    try:
        with os.scandir(folder) as found:
            entries = list(found)
    except OSError:
        return
    for one in entries:
        if not one.is_dir(follow_symlinks=False):
            if one.is_file():
                yield above + one.name
        elif deep:
            yield from _files(one.path, f"{above}{one.name}/")


def bring(project: Project, source: Path, endings: tuple[str, ...] = (*PICTURES, *MOVIES)) -> str:
    """Copies a file into the project's media; what an ``image`` or ``movie`` calls it there.

    A file whose bytes are there already is not copied again. Raises UsageError, with one line for
    the user, where its name has none of the endings, it is too large or can not be copied.
    """
    _judge(source, endings)
    try:
        size = source.stat().st_size
        if size > LARGEST:
            said = tr("{0}: has {1} MB, and {2} MB is the most: make it smaller first")
            most = LARGEST // 2**20
            raise UsageError(said.format(source.name, f"{size / 2**20:.0f}", most))
    except OSError as error:
        raise UsageError(f"{source}: {error.strerror or error}") from None
    folder, prefix = _folder(project)
    return prefix + put(folder, source)


def put(folder: Path, source: Path) -> str:
    """Copies a file into a folder, unless its bytes are there already; what it is called there.

    Raises UsageError where it can not be copied.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        name = _twin(folder, source, source.stat().st_size)
        if name is None:
            name = free_name(folder, source.name)
            shutil.copyfile(source, folder / name)
    except OSError as error:
        raise UsageError(f"{source}: {error.strerror or error}") from None
    return name


def file_of(project: Project, src: str) -> Path | None:
    """The file that an ``image`` or ``movie`` of a project calls so; None where there is none."""
    root = Path(project.root).resolve()
    found = (root / (project.media or "") / src).resolve()
    return found if src and found.is_relative_to(root) and found.is_file() else None


def bring_bytes(project: Project, data: bytes, name: str) -> str:
    """As ``bring``, of a picture that is in no file yet: one from the clipboard."""
    folder, prefix = _folder(project)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for one in sorted(folder.iterdir()):
            alike = one.suffix == Path(name).suffix and one.is_file()
            if alike and one.stat().st_size == len(data) and one.read_bytes() == data:
                return prefix + one.name
        name = free_name(folder, name)
        (folder / name).write_bytes(data)
    except OSError as error:
        raise UsageError(f"{folder / name}: {error.strerror or error}") from None
    return prefix + name


def free_name(folder: Path, name: str) -> str:
    """A name that every system takes, and that nothing has there: ``My Dog.PNG`` is my-dog.png."""
    stem, _, ending = name.rpartition(".")
    plain = unicodedata.normalize("NFKD", stem).encode("ascii", "ignore").decode()
    stem = re.sub(r"[^a-z0-9]+", "-", plain.lower()).strip("-")[:60] or "picture"
    ending = f".{ending.lower()}"
    taken = {one.name.lower() for one in folder.iterdir()} if folder.is_dir() else set()
    made, number = f"{stem}{ending}", 2
    while made in taken:
        made, number = f"{stem}-{number}{ending}", number + 1
    return made


def _judge(source: Path, endings: tuple[str, ...]) -> None:
    if source.suffix.lower() not in endings:
        said = tr("{0}: the robot takes {1} only")
        raise UsageError(said.format(source.name, " ".join(endings)))
    if not source.is_file():
        raise UsageError(tr("{0}: is no file").format(source))


def _folder(project: Project) -> tuple[Path, str]:
    """Where media lie, and what stands before their names in a document."""
    if project.media is not None:
        return Path(project.root) / project.media, ""
    return Path(project.root) / FOLDER, f"{FOLDER}/"


def _twin(folder: Path, source: Path, size: int) -> str | None:
    """A file there with the same bytes."""
    for one in sorted(folder.iterdir()):
        same = one.suffix.lower() == source.suffix.lower() and one.is_file()
        if same and one.stat().st_size == size and filecmp.cmp(one, source, shallow=False):
            return one.name
    return None
