"""A project as it goes to a robot: without what only the editor needs (formats.md)."""

from __future__ import annotations

import os
import re
import shutil
import tempfile
from pathlib import Path
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from situ.document import codec
from situ.document.aside import EDITOR, Aside
from situ.document.check_application import media_of
from situ.document.folder import PROJECT_FILE, TEXTS_FOLDER, resolve
from situ.document.project import Project
from situ.document.writer import XMLNS
from situ.errors import UsageError

_OPENING = re.compile(r"<(?:([^\s:/>!?]+):)?[^\s/>!?]+([^>]*)")


def deployable(project: Project) -> dict[str, bytes]:
    """The files of a project without errors, by their paths in it, as they go to a robot.

    Documents are canonical and without the namespace ``urn:situ:editor``; comments
    and other namespaces stay. Scenarios and ``robot.local.toml`` belong to the
    bench and to one robot: they are left out. UsageError where one cannot be read.
    """
    documents: dict[str, Any] = project.flows
    if project.spds_file is not None:
        documents[project.spds_file] = project.spds
    if project.modules_file is not None:
        documents[project.modules_file] = project.modules
    found = {
        file: codec.write(without_editor(document))
        for file, document in documents.items()
        if document is not None
    }
    copied = [PROJECT_FILE] if project.toml is not None else []
    copied += [f"{TEXTS_FOLDER}/{language}.po" for language in project.texts]
    copied += _media(project)
    for file in copied:
        place = resolve(project.root, file)
        if place is None:
            raise UsageError(f"{file}: leads out of the project")
        if place.exists() and not place.is_file():
            # It could be waited for without end.
            raise UsageError(f"{file}: is no plain file (a pipe, a device): take it out of there")
        if not _is_utf8(file):
            raise UsageError(f"{file!r}: its name is not UTF-8: give it another one")
        found[file] = place.read_bytes()
    return found


def check_free(output: Path) -> None:
    """UsageError where something stands at ``output`` that ``write_out`` would not replace."""
    if output.is_symlink() or (output.exists() and not output.is_dir()):
        raise UsageError(f"{output}: there is a file of this name; name another folder")
    if output.is_dir() and any(output.iterdir()):
        raise UsageError(f"{output}: is not empty; name a new or an empty folder")


def write_out(files: dict[str, bytes], output: Path) -> None:
    """Writes what goes to a robot into a folder that is new, or empty.

    All or nothing: the folder appears when everything is in it. UsageError as ``check_free``;
    OSError where it can not be written.
    """
    check_free(output)
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


def without_editor(value: Any) -> Any:
    """A document, or any value in it, without attributes and elements of the editor."""
    if isinstance(value, Aside):
        return _stripped(value)
    if isinstance(value, tuple):
        return tuple(without_editor(one) for one in value)
    if isinstance(value, Struct):
        # Their names alone: msgspec's fields() reads a class's annotations anew each time.
        held = {name: getattr(value, name) for name in value.__struct_fields__}
        return replace(
            value,
            **{
                name: without_editor(one)
                for name, one in held.items()
                if isinstance(one, (Struct, tuple))
            },
        )
    return value


def _stripped(aside: Aside) -> Aside:
    return replace(
        aside,
        before=tuple(one for one in aside.before if not _is_editors(one)),
        inside=tuple(one for one in aside.inside if not _is_editors(one)),
        attributes=tuple(
            (key, text)
            for key, text in aside.attributes
            if not key.startswith(f"{{{EDITOR}}}")
            and not (key.startswith(f"{{{XMLNS}}}") and text == EDITOR)
        ),
        parts=tuple((name, _stripped(part)) for name, part in aside.parts),
    )


def _is_editors(fragment: str) -> bool:
    """Whether a piece of foreign XML is an element of the editor's namespace."""
    opening = _OPENING.match(fragment)
    if opening is None:
        return False
    name = f"xmlns:{opening[1]}" if opening[1] else "xmlns"
    declared = re.search(rf"\s{re.escape(name)}=(?:\"([^\"]*)\"|'([^']*)')", opening[2])
    if declared is None:
        return opening[1] == "ed"
    return (declared[1] or declared[2]) == EDITOR


def _media(project: Project) -> list[str]:
    """The media folder's files; without one, the files that the applications name."""
    if project.media is None:
        named = {file for application in project.flows.values() for file in media_of(application)}
        return sorted(file for file in named if _is_file(project.root, file))
    found = []
    for folder, inner, files in os.walk(Path(project.root) / project.media):
        inner.sort()
        here = Path(folder).relative_to(project.root)
        found += [(here / name).as_posix() for name in sorted(files)]
    return found


def _is_utf8(name: str) -> bool:
    try:
        name.encode()
    except UnicodeEncodeError:
        return False
    return True


def _is_file(root: str, file: str) -> bool:
    place = resolve(root, file)
    return place is not None and place.is_file()
