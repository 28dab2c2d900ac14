"""What in a project refers to an application's file or to its name: what follows another name,
and what is missing once the file is deleted. Pure; no Qt.

An application's file is named by ``situ.toml``, by states that run it as a part and by the
translations of its texts; its name, as a module, by the script, by tags of the runtime
(``application/NAME``, ``module/NAME/…``) and by scenarios (formats.md).
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from functools import partial

from msgspec import Struct
from msgspec.structs import replace

from situ.document import beside, datatypes
from situ.document import toml_writing as writing
from situ.document.beside import Toml
from situ.document.catalogue import Catalogue
from situ.document.folder import PROJECT_FILE
from situ.document.project import Project
from situ_studio.edits import mentions, renames
from situ_studio.edits.edit import Lines, Written
from situ_studio.project import project_documents
from situ_studio.wording.language import tr

END = ".rbd.xml"
"""Of an application's file."""
Values = Mapping[str, Written]
"""The files beside the documents, and the scenarios, by their paths."""
_NAMING = ("application", "module", "writer")
"""Keys of a scenario under which a module stands by its name."""


class Use(Struct, frozen=True):
    """One file, and what in it changes or goes on referring to the application, in words."""

    file: str
    words: str


class Renaming(Struct, frozen=True):
    """changed: file to what it is then, None for the one that goes. uses: what changes where."""

    changed: dict[str, Written | None]
    uses: tuple[Use, ...]


def renamed_file(file: str, stem: str) -> str:
    """The path of an application's file that is called so, in the folder where it is."""
    folder, slash, _ = file.rpartition("/")
    return f"{folder}{slash}{stem}{END}"


def wrong_name(stem: str) -> str:
    """Why no file can be called so, in one line; "" where it can."""
    if not stem:
        return tr("Write a name.")
    if stem.startswith(".") or stem != stem.strip() or any(c in '/\\:*?"<>|{}' for c in stem):
        return tr('A name has no / \\ : * ? " < > | {{ }} in it and begins with no dot.').format()
    rule = datatypes.TITLE.rule
    assert rule is not None
    return tr("A name has no signs in it that can not be seen.") if rule(stem) else ""


def rename(
    project: Project,
    values: Values,
    index: mentions.Index,
    file: str,
    new: str,
    name: str | None = None,
) -> Renaming:
    """The project's files with the application's file called ``new``; name: what it is called
    itself then, None where that stays. index: the same one for each name that is tried.
    ValueError, with a line for the user, where the name is taken by a module.
    """
    application = project.flows[file]
    old = application.name
    uses = [Use(file, tr("becomes {0}").format(new))] if new != file else []
    changed: dict[str, Written | None] = {}
    after = project
    if name is not None and name != old:
        after, followed = _called(project, index, file, name)
        uses += [Use(file, tr("the application is called {0} in it").format(name))]
        uses += [Use(one, _counted(count)) for one, count in followed.items()]
        if file not in project.parts:
            for one, value in values.items():
                if isinstance(value, Lines) and (found := _in_scenario(value, old, name)):
                    changed[one] = found[0]
                    uses.append(Use(one, _lines(found[1])))
    for one, holder in after.flows.items() if new != file else ():
        states = tuple(replace(s, flow=new) if s.flow == file else s for s in holder.states)
        count = sum(s.flow == file for s in holder.states)
        if count:
            moved = replace(holder, states=states)
            after = project_documents.exchanged(after, one, moved)
            uses.append(Use(one, _running(count)))
    own = after.flows[file]
    changed |= {
        one: document
        for one, document in mentions.documents(after).items()
        if one != file and document is not project_documents.document(project, one)
    }
    for one, value in values.items():
        if isinstance(value, Toml) and one == PROJECT_FILE:
            listed = beside.applications(value)
            if file in listed and new != file:
                named = [new if other == file else other for other in listed]
                changed[one] = writing.put(value, "project", "applications", named)
                uses.append(Use(one, tr("the list of applications")))
        elif (
            new != file
            and isinstance(value, Catalogue)
            and (texts := _in_texts(value, file, new)) is not None
        ):
            changed[one] = texts
            uses.append(Use(one, tr("where its texts stand")))
    gone = {file: None} if new != file else {}
    return Renaming({new: own, **changed, **gone}, tuple(uses))


def unlisted(toml: Toml, file: str) -> Toml:
    """``situ.toml`` without that application."""
    left = [one for one in beside.applications(toml) if one != file]
    return writing.put(toml, "project", "applications", left)


def _called(
    project: Project, index: mentions.Index, file: str, name: str
) -> tuple[Project, dict[str, int]]:
    """The project with the application of a file called ``name``, and in how many places of which
    other files it is named."""
    application = project.flows[file]
    old, after = application.name, project
    every: list[mentions.Found] = []
    if file not in project.parts:
        every = list(index.every(project))
        known = mentions.tags(every, project) | {f"application/{old}"}
        tags = {
            mentions.tag_of(n, known)
            for found in every
            for role, n in found.mention.names
            if role == "tag" and _is_of(role, n, old)
        }
        wanted: list[tuple[mentions.Role, str, str]] = [("module", old, name)]
        wanted += [("tag", tag, tag.replace(f"/{old}", f"/{name}", 1)) for tag in sorted(tags)]
        for role, one, other in wanted:
            found_now = list(index.every(after))
            for changed, document in renames.rename(
                after, found_now, role, one, other
            ).changed.items():
                after = project_documents.exchanged(after, changed, document)
    called = replace(after.flows[file], name=name)
    return project_documents.exchanged(after, file, called), _naming(every, file, old)


def uses(project: Project, values: Values, file: str) -> tuple[Use, ...]:
    """What still refers to an application, or to its name, if its file is not there any more."""
    application = project.flows[file]
    found: list[Use] = []
    for one, holder in project.flows.items():
        count = sum(s.flow == file for s in holder.states)
        if count and one != file:
            found.append(Use(one, _lacking(count)))
    if file not in project.parts:
        name = application.name
        naming = _naming(mentions.Index().every(project), file, name)
        found += [Use(one, _counted(count)) for one, count in naming.items()]
        for one, value in values.items():
            if isinstance(value, Lines) and (lines := _in_scenario(value, name, f"{name}-")):
                found.append(Use(one, _lines(lines[1])))
    return tuple(found)


def _naming(every: Iterable[mentions.Found], file: str, name: str) -> dict[str, int]:
    """In how many places of which files but its own an application is named as a module."""
    counts = dict[str, int]()
    for place in every:
        if place.file != file and any(_is_of(role, n, name) for role, n in place.mention.names):
            counts[place.file] = counts.get(place.file, 0) + 1
    return counts


def _is_of(role: mentions.Role, written: str, name: str) -> bool:
    if role == "module":
        return written == name
    return role == "tag" and (
        written == f"application/{name}"
        or written.startswith((f"application/{name}.", f"module/{name}/"))
    )


def _in_texts(texts: Catalogue, file: str, new: str) -> Catalogue | None:
    """The translations, which say where each text stands, with another file's name."""
    if not any(name == file for one in texts.translations for name, _ in one.files):
        return None
    moved = (
        replace(one, files=tuple((new if n == file else n, line) for n, line in one.files))
        for one in texts.translations
    )
    return replace(texts, translations=tuple(moved))


def _in_scenario(scenario: Lines, old: str, new: str) -> tuple[Lines, int] | None:
    """The scenario with another name of a module, and in how many lines; None where it names none.

    Only the names change: each line is otherwise written as it was.
    """
    found, count = [], 0
    for line in scenario.text.split("\n"):
        after = _in_line(line, old, new)
        found.append(after)
        count += after != line
    return (Lines("\n".join(found)), count) if count else None


def _in_line(line: str, old: str, new: str) -> str:
    try:
        told = json.loads(line)
    except ValueError:
        return line
    keys = "|".join((*_NAMING, *(("from", "to") if _expects_authority(told) else ())))
    # Each way of writing it once: the new name may begin with the old one.
    ways = {json.dumps(old, ensure_ascii=one)[1:-1]: one for one in (True, False)}
    for before, ascii_only in ways.items():
        # A name may have a backslash: no template of a substitution.
        told_as = partial(_put, json.dumps(new, ensure_ascii=ascii_only)[1:-1])
        line = re.sub(rf'("(?:{keys})"\s*:\s*"){re.escape(before)}(?=")', told_as, line)
        line = re.sub(rf'("(?:application|module)/){re.escape(before)}(?=["/.])', told_as, line)
    return line


def _put(name: str, found: re.Match[str]) -> str:
    return found[1] + name


def _expects_authority(told: object) -> bool:
    """Whether ``from`` and ``to`` of a line are modules, no states."""
    expected = told.get("expect") if isinstance(told, dict) else None
    return isinstance(expected, dict) and expected.get("kind") == "authority"


def _counted(count: int) -> str:
    if count == 1:
        return tr("1 place that names it as a module")
    return tr("{0} places that name it as a module").format(count)


def _lines(count: int) -> str:
    return (
        tr("1 line of the scenario")
        if count == 1
        else tr("{0} lines of the scenario").format(count)
    )


def _running(count: int) -> str:
    return tr("1 state that runs it") if count == 1 else tr("{0} states that run it").format(count)


def _lacking(count: int) -> str:
    if count == 1:
        return tr("1 state runs it, and will have nothing to run")
    return tr("{0} states run it, and will have nothing to run").format(count)
