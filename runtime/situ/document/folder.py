"""A project's files: read as one value, written one by one (formats.md, *A project*).

Paths in a project never leave its folder: no ``..``, no absolute ones, no links
that lead out.
"""

from __future__ import annotations

import contextlib
import os
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Protocol, TypeVar, cast

from msgspec.structs import replace

from situ.document import codec, texts
from situ.document.datatypes import shown
from situ.document.modules import Modules
from situ.document.problem import Problem
from situ.document.project import Project
from situ.document.projectfile import ProjectFile
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ.errors import UsageError

T = TypeVar("T")

PROJECT_FILE = "situ.toml"
LOCAL_FILE = "robot.local.toml"
TEXTS_FOLDER = "texts"
UNFINISHED = ".unfinished-"
"""In the names of files that ``write`` has not put in their places yet."""

_KINDS: dict[str, tuple[type, str]] = {
    "applications": (Application, "an application"),
    "spds": (Spds, "a situated priority description script"),
    "modules": (Modules, "module information"),
}


def load(path: str | Path) -> tuple[Project | None, list[Problem]]:
    """The project at ``path``, or None where there is none, and what is wrong with its files.

    ``path``: a folder with ``situ.toml``, that file, or a single document
    (``*.xml``). What a file with errors holds as far as it could be read is in
    the project; a file without a document is not. UsageError where ``path``
    itself is not there, cannot be read, or is nothing of the kind.
    """
    given = Path(path)
    # Path.is_dir raises for names that no system has, in some Pythons.
    if not os.path.exists(given):
        raise UsageError(f"{path}: no such file or folder")
    if os.path.isdir(given):
        return _Loading(given).project(_bytes(given / PROJECT_FILE, path))
    if given.name == PROJECT_FILE:
        return _Loading(given.parent).project(_bytes(given, path))
    if given.suffix != ".xml":
        raise UsageError(
            f"{path}: neither a project's folder, its situ.toml, nor a document "
            "(.rbd.xml, .spds.xml, modules.xml)"
        )
    return _Loading(given.parent).single(given.name, _bytes(given, path))


def load_texts(texts: Mapping[str, str], root: str = ".") -> tuple[Project | None, list[Problem]]:
    """As ``load``, of the texts of a project's files by their paths in it, as ``sources`` gives
    them, ``robot.local.toml`` too where there is one. root: where it would lie; nothing is read
    there. Without a ``situ.toml`` the first is the document.
    """
    loading = _Loading(Path(root), _Held(texts))
    if PROJECT_FILE in texts:
        return loading.project(_Held(texts).read(PROJECT_FILE))
    for first in texts:
        return loading.single(first, _Held(texts).read(first))
    said = f"There are no files: give the texts of a project, its {PROJECT_FILE} among them"
    return None, [Problem(file=root, code="missing-file", message=said)]


def sources(project: Project) -> dict[str, str]:
    """The texts of a project's files as they lie there, by their paths in it: settings, documents,
    parts, translations. OSError where one is gone.
    """
    found = [project.toml, *project.applications, *project.parts]
    found += [project.spds_file, project.modules_file]
    found += [f"{TEXTS_FOLDER}/{language}.po" for language in project.texts]
    root = Path(project.root)
    return {path: (root / path).read_text("utf-8") for path in found if path is not None}


def resolve(root: str | Path, path: str) -> Path | None:
    """Where a path of a project lies, links followed; None where it leaves the folder ``root``."""
    if not stays_inside(path):
        return None
    # Path.resolve raises where links go in a circle, in some Pythons.
    home = os.path.realpath(root)
    found = Path(os.path.realpath(os.path.join(home, path)))
    return found if found.is_relative_to(home) else None


def media_of(project: Project) -> Path | None:
    """The folder of a project's pictures and movies; None where it has none inside of its own."""
    return None if project.media is None else resolve(project.root, project.media)


def stays_inside(path: str) -> bool:
    """Whether a path, by its words alone, is one of a project."""
    if not path or "\\" in path or "\0" in path or Path(path).is_absolute():
        return False
    return ".." not in Path(path).parts


def called(root: str, file: str) -> str:
    """A file as the user would name it, who named the project's folder as ``root``."""
    return os.path.join(root, file) if root != "." else file


def settings(root: str, toml: ProjectFile, local: ProjectFile | None) -> dict[str, Any]:
    """The fields of a project in ``root`` that its settings alone say; ``local`` laid over them."""
    return {
        "name": toml.get("project", "name") or Path(root).resolve().name,
        "languages": tuple(toml.get("project", "languages") or ()),
        "endpoint": _first(local, toml, "robot", "endpoint", "tcp://127.0.0.1:5570"),
        "adapter": _first(local, toml, "robot", "adapter", "sim"),
        "announce": _first(local, toml, "robot", "announce", True),
        "tags": _merged(local, toml, "tags"),
        "durable": tuple(toml.get("durable", "tags") or ()),
        "places": {
            place: (float(x), float(y), float(heading))
            for place, (x, y, heading) in _merged(local, toml, "places").items()
        },
        "mqtt": (local and local.mqtt()) or toml.mqtt(),
        "private": tuple(toml.get("privacy", "private") or ()),
        "settings": toml.settings(),
    }


def write(path: str | Path, data: bytes) -> None:
    """Puts ``data`` into a file: the old content or the new one whole, whatever happens.

    The file keeps its mode, a link stays a link. UsageError where it cannot be written, and
    where it is read-only, though its folder would let another be put in its place.
    """
    try:
        target = Path(path).resolve()
        mode = _mode(target)
        if not mode & 0o222:
            raise UsageError(f"{path}: is read-only: allow it to be written, or write a copy")
        # The name says who writes, for ``clear_unfinished``.
        begun = f".{target.name}.{os.getpid()}{UNFINISHED}"
        handle, temporary = tempfile.mkstemp(prefix=begun, dir=target.parent)
        try:
            with os.fdopen(handle, "wb") as file:
                file.write(data)
                file.flush()
                os.fsync(file.fileno())
            os.chmod(temporary, mode)
            os.replace(temporary, target)
        except BaseException:
            Path(temporary).unlink(missing_ok=True)
            raise
        folder = os.open(target.parent, os.O_RDONLY)
        try:
            os.fsync(folder)
        finally:
            os.close(folder)
    except OSError as error:
        raise UsageError(f"{path}: cannot be written: {_reason(error)}") from error


def clear_unfinished(folder: str | Path) -> None:
    """Takes away what ``write`` left in a folder of writers that were killed meanwhile.

    Only what lies in it and in its folders, not deeper; what can not be taken away stays.
    """
    root = Path(folder)
    for pattern in (f".*{UNFINISHED}*", f"*/.*{UNFINISHED}*"):
        for file in root.glob(pattern):
            writer = file.name.rpartition(UNFINISHED)[0].rpartition(".")[2]
            if writer.isdecimal() and not _runs(int(writer)):
                with contextlib.suppress(OSError):
                    file.unlink()


def _runs(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except (OSError, OverflowError):
        # It is another user's, or no number that a process can have.
        return True
    return True


def _mode(target: Path) -> int:
    try:
        return target.stat().st_mode & 0o7777
    except FileNotFoundError:
        return 0o644


def _reason(error: Exception) -> str:
    return getattr(error, "strerror", None) or str(error)


def _bytes(file: Path, given: str | Path) -> bytes:
    try:
        return file.read_bytes()
    except FileNotFoundError as error:
        raise UsageError(
            f"{given}: no {PROJECT_FILE} here; give the folder of a project, or a document"
        ) from error
    except OSError as error:
        raise UsageError(f"{file}: cannot be read: {_reason(error)}") from error


class _Files(Protocol):
    """Where the files of a project are, by their paths in it."""

    def inside(self, path: str) -> bool: ...

    def has(self, path: str) -> bool: ...

    def read(self, path: str) -> bytes:
        """Raises OSError."""


class _Lying:
    """In their folder."""

    def __init__(self, root: Path) -> None:
        self._root = root

    def inside(self, path: str) -> bool:
        return resolve(self._root, path) is not None

    def has(self, path: str) -> bool:
        place = resolve(self._root, path)
        return place is not None and place.is_file()

    def read(self, path: str) -> bytes:
        return (self._root / path).read_bytes()


class _Held:
    """As texts."""

    def __init__(self, texts: Mapping[str, str]) -> None:
        self._texts = texts

    def inside(self, path: str) -> bool:
        return stays_inside(path)

    def has(self, path: str) -> bool:
        return path in self._texts

    def read(self, path: str) -> bytes:
        if path not in self._texts:
            raise FileNotFoundError(path)
        return self._texts[path].encode(errors="replace")


class _Loading:
    """One ``load``: gathers the problems of all files."""

    def __init__(self, root: Path, files: _Files | None = None) -> None:
        self.root = root
        self.files = files if files is not None else _Lying(root)
        self.problems: list[Problem] = []

    def called(self, file: str) -> str:
        return called(str(self.root), file)

    def single(self, name: str, data: bytes) -> tuple[Project | None, list[Problem]]:
        document, self.problems = codec.read(data, self.called(name))
        root = str(self.root)
        if isinstance(document, Application):
            found = Project(root=root, name=document.name, applications={name: document})
            return self.with_parts(found), self.problems
        if isinstance(document, Spds):
            found = Project(root=root, name=document.name, spds_file=name, spds=document)
            return found, self.problems
        if isinstance(document, Modules):
            found = Project(
                root=root, name=name.removesuffix(".xml"), modules_file=name, modules=document
            )
            return found, self.problems
        return None, self.problems

    def project(self, data: bytes) -> tuple[Project | None, list[Problem]]:
        toml = ProjectFile(data, self.called(PROJECT_FILE))
        if toml.tables is None:
            return None, toml.problems
        local = self.local()
        applications: dict[str, Application] = {}
        for file in toml.get("project", "applications") or ():
            if file in applications:
                toml.twice(file)
                continue
            document = self.document(toml, "applications", file)
            if document is not None:
                applications[file] = document
        spds_file = toml.get("project", "spds")
        modules_file = toml.get("project", "modules")
        project = Project(
            root=str(self.root),
            toml=PROJECT_FILE,
            applications=applications,
            spds_file=spds_file,
            spds=self.document(toml, "spds", spds_file),
            modules_file=modules_file,
            modules=self.document(toml, "modules", modules_file),
            media=self.inner_folder(toml, "media"),
            scenarios=self.inner_folder(toml, "scenarios"),
            **settings(str(self.root), toml, local),
        )
        found, readings = self.texts(toml, project.languages)
        project = replace(project, texts=found, readings=readings)
        project = self.with_parts(project)
        self.problems = [*toml.problems, *(local.problems if local else ()), *self.problems]
        return project, self.problems

    def local(self) -> ProjectFile | None:
        try:
            data = self.files.read(LOCAL_FILE)
        except FileNotFoundError:
            return None
        except OSError as error:
            self.unreadable(LOCAL_FILE, error)
            return None
        found = ProjectFile(data, self.called(LOCAL_FILE), local=True)
        if found.tables is None:
            self.problems += found.problems
            return None
        return found

    def unreadable(self, file: str, error: Exception) -> None:
        self.problems.append(
            Problem(
                file=self.called(file),
                code="unreadable-file",
                message=f"The file cannot be read: {_reason(error)}",
            )
        )

    def document(self, toml: ProjectFile, key: str, file: str | None) -> Any:
        """The document in a file that ``[project]`` names, None where there is none."""
        if file is None:
            return None
        if not self.files.inside(file):
            said = f"{file} leads out of the project: its files lie inside its folder"
            toml.listed("path-outside", said, key, file)
            return None
        try:
            data = self.files.read(file)
        except (FileNotFoundError, IsADirectoryError, NotADirectoryError):
            toml.missing(key, file)
            return None
        except OSError as error:
            self.unreadable(file, error)
            return None
        document, problems = codec.read(data, self.called(file))
        self.problems += problems
        kind, words = _KINDS[key]
        if document is not None and not isinstance(document, kind):
            said = f"{file} is not {words}: name another file here"
            toml.listed("wrong-document", said, key, file)
            return None
        return document

    def inner_folder(self, toml: ProjectFile, key: str) -> str | None:
        path: str | None = toml.get("project", key)
        if path is None:
            return None
        if not self.files.inside(path):
            said = f"{path} leads out of the project: its files lie inside its folder"
            toml.listed("path-outside", said, key, path)
            return None
        return path

    def texts(
        self, toml: ProjectFile, languages: tuple[str, ...]
    ) -> tuple[dict[str, dict[str, str]], dict[str, dict[str, str]]]:
        """By language, the translations and the readings."""
        found: dict[str, dict[str, str]] = {}
        read: dict[str, dict[str, str]] = {}
        for language in languages:
            file = f"{TEXTS_FOLDER}/{language}.po"
            is_code = language.replace("-", "").replace("_", "").isalnum()
            if not is_code or not self.files.inside(file):
                said = f"{shown(language)} is no language: write a code such as ja or pt-BR"
                toml.listed("bad-value", said, "languages", language)
                continue
            try:
                data = self.files.read(file)
            except FileNotFoundError:
                continue
            except OSError as error:
                self.unreadable(file, error)
                continue
            found[language], words, problems = texts.read(data, self.called(file))
            self.problems += problems
            if words:
                read[language] = words
        return found, read

    def with_parts(self, project: Project) -> Project:
        """The project with every application that a ``flow`` names, however deep."""
        parts: dict[str, Application] = {}
        seen = set(project.applications)
        waiting = list(project.applications.values())
        while waiting:
            for state in waiting.pop().states:
                file = state.flow
                if file is None or file in seen:
                    continue
                seen.add(file)
                if not (self.files.inside(file) and self.files.has(file)):
                    continue
                try:
                    data = self.files.read(file)
                except OSError as error:
                    self.unreadable(file, error)
                    continue
                document, problems = codec.read(data, self.called(file))
                self.problems += problems
                if isinstance(document, Application):
                    parts[file] = document
                    waiting.append(document)
        return replace(project, parts=parts) if parts else project


def _first(local: ProjectFile | None, toml: ProjectFile, table: str, key: str, default: T) -> T:
    """What stands there, which is of the default's type: the file has been judged."""
    for one in (local, toml):
        if one is not None and (found := one.get(table, key)) is not None:
            return cast(T, found)
    return default


def _merged(local: ProjectFile | None, toml: ProjectFile, table: str) -> dict[str, Any]:
    found = dict((toml.tables or {}).get(table, {}))
    if local is not None:
        found.update((local.tables or {}).get(table, {}))
    return found
