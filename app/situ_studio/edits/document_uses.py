"""What in a project refers to a document's file or to what is called in it: what follows another
name, and what is missing once the file is deleted. Pure; no Qt.

An application's file is named by ``situ.toml``, by states that run it as a part and by the
translations of its texts; its name, as a module, by the script, by tags of the runtime
(``application/NAME``, ``module/NAME/…``) and by scenarios. The files of the script and of the
module information are named by ``situ.toml`` alone, and may be called anything; the script's name
nowhere. What is declared in them is named all over the project (formats.md).
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping

from msgspec import Struct
from msgspec.structs import replace

from situ.document import beside, datatypes
from situ.document import toml_writing as writing
from situ.document.beside import Toml
from situ.document.catalogue import Catalogue
from situ.document.folder import PROJECT_FILE
from situ.document.modules import Modules
from situ.document.project import Project
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ_studio.edits import mentions, new_script, project_documents, renames, scenario_names
from situ_studio.edits.edit import Document, Lines, Written
from situ_studio.edits.mentions import Found
from situ_studio.wording import language
from situ_studio.wording.language import tr

END = ".rbd.xml"
"""Of an application's file."""
Values = Mapping[str, Written]
"""The files beside the documents, and the scenarios, by their paths."""


class Use(Struct, frozen=True):
    """One file, and what in it changes or goes on referring to the document, in words."""

    file: str
    words: str


class Renaming(Struct, frozen=True):
    """changed: file to what it is then, None for the one that goes. uses: what changes where."""

    changed: dict[str, Written | None]
    uses: tuple[Use, ...]


def ending(document: Document) -> str:
    """How the name of such a document's file ends."""
    if isinstance(document, Modules):
        return ".xml"
    return new_script.END if isinstance(document, Spds) else END


def own_name(document: Document) -> str | None:
    """What a document is called in itself; None for module information, which has no name."""
    return None if isinstance(document, Modules) else document.name


def renamed_file(file: str, document: Document, stem: str) -> str:
    """The path of a document's file that is called so, in the folder where it is."""
    folder, slash, _ = file.rpartition("/")
    return f"{folder}{slash}{stem}{ending(document)}"


def wrong_name(document: Document, stem: str) -> str:
    """Why no file of such a document can be called so, in one line; "" where it can."""
    if not stem:
        return tr("Write a name.")
    if stem.startswith(".") or stem != stem.strip() or any(c in '/\\:*?"<>|{}' for c in stem):
        return tr('A name has no / \\ : * ? " < > | {{ }} in it and begins with no dot.').format()
    if isinstance(document, Modules) and f"{stem}.xml".endswith((END, new_script.END)):
        return tr("Files of applications and scripts end so: choose another name.")
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
    """The project's files with the document's file called ``new``; name: what the application or
    script is called itself then, None where that stays. index: the same one for each name that is
    tried. ValueError, with a line for the user, where the name is taken by a module.
    """
    document = project_documents.document(project, file)
    assert document is not None
    uses = [Use(file, tr("becomes {0}").format(new))] if new != file else []
    changed: dict[str, Written | None] = {}
    after = project
    if isinstance(document, Application) and name is not None and name != document.name:
        after, followed = _called(project, index, file, name)
        uses += [Use(file, tr("the application is called {0} in it").format(name))]
        uses += [Use(one, _counted(count)) for one, count in followed.items()]
        for one, value in values.items() if file not in project.parts else ():
            if not isinstance(value, Lines):
                continue
            if (found := scenario_names.renamed(value, document.name, name)) is not None:
                changed[one] = found[0]
                uses.append(Use(one, _lines(found[1])))
    elif isinstance(document, Spds) and name is not None and name != document.name:
        after = project_documents.exchanged(project, file, replace(document, name=name))
        uses.append(Use(file, tr("the script is called {0} in it").format(name)))
    for one, holder in after.flows.items() if new != file else ():
        states = tuple(replace(s, flow=new) if s.flow == file else s for s in holder.states)
        count = sum(s.flow == file for s in holder.states)
        if count:
            moved = replace(holder, states=states)
            after = project_documents.exchanged(after, one, moved)
            uses.append(Use(one, _running(count)))
    own = project_documents.document(after, file)
    changed |= {
        one: other
        for one, other in mentions.documents(after).items()
        if one != file and other is not project_documents.document(project, one)
    }
    for one, value in values.items() if new != file else ():
        if isinstance(value, Toml) and one == PROJECT_FILE:
            toml = listed(value, project, file, new)
            if toml is not value:
                changed[one] = toml
                uses.append(Use(one, _where(document)))
        elif isinstance(value, Catalogue) and (texts := _in_texts(value, file, new)) is not None:
            changed[one] = texts
            uses.append(Use(one, tr("where its texts stand")))
    gone = {file: None} if new != file else {}
    return Renaming({new: own, **changed, **gone}, tuple(uses))


def listed(toml: Toml, project: Project, file: str, new: str | None = None) -> Toml:
    """``situ.toml`` with another file where it names that one; without it where there is none."""
    for key, named in (("spds", project.spds_file), ("modules", project.modules_file)):
        if file == named:
            return writing.put(toml, "project", key, new)
    there = beside.applications(toml)
    if file not in there:
        return toml
    left = [new if one == file else one for one in there]
    return writing.put(toml, "project", "applications", [one for one in left if one is not None])


def _called(
    project: Project, index: mentions.Index, file: str, name: str
) -> tuple[Project, dict[str, int]]:
    """The project with the application of a file called ``name``, and in how many places of which
    other files it is named."""
    application = project.flows[file]
    old, after = application.name, project
    every: list[Found] = []
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
    return project_documents.exchanged(after, file, called), _naming(every, file, (old,))


def uses(project: Project, values: Values, file: str) -> tuple[Use, ...]:
    """What still refers to a document, or to what is called in it, if its file is gone."""
    document = project_documents.document(project, file)
    assert document is not None
    found: list[Use] = []
    for one, holder in project.flows.items():
        count = sum(s.flow == file for s in holder.states)
        if count and one != file:
            found.append(Use(one, _lacking(count)))
    every = list(mentions.Index().every(project))
    if isinstance(document, Spds):
        asked = _counts(every, file, _is_situation)
        found += [Use(one, _asking(count)) for one, count in asked.items()]
    names = _names_of(project, file, document)
    naming = _naming(every, file, names)
    if isinstance(document, Application):
        found += [Use(one, _counted(count)) for one, count in naming.items()]
    else:
        found += [Use(one, _declared(count)) for one, count in naming.items()]
    for one, value in values.items():
        if isinstance(value, Lines):
            lines = scenario_names.naming(value, names, isinstance(document, Spds))
            found += [Use(one, _lines(lines))] if lines else []
    return tuple(found)


def _names_of(project: Project, file: str, document: Document) -> Collection[str]:
    """The modules that are there no more without a document."""
    if isinstance(document, Application):
        return () if file in project.parts else (document.name,)
    left = project_documents.without(project, file)
    gone = project.declared().keys() - left.declared().keys()
    # Without a script no application needs to be declared.
    return gone if left.spds else gone - {one.name for one in project.applications.values()}


def _naming(every: Iterable[Found], file: str, names: Collection[str]) -> dict[str, int]:
    """In how many places of which files but its own one of these modules is named."""
    return _counts(every, file, lambda role, n: any(_is_of(role, n, name) for name in names))


def _counts(
    every: Iterable[Found], file: str, meant: Callable[[mentions.Role, str], bool]
) -> dict[str, int]:
    """In how many places of which files but one something is mentioned that is meant."""
    counts = dict[str, int]()
    for place in every:
        if place.file != file and any(meant(role, n) for role, n in place.mention.names):
            counts[place.file] = counts.get(place.file, 0) + 1
    return counts


def _is_of(role: mentions.Role, written: str, name: str) -> bool:
    if role == "module":
        return written == name
    return role == "tag" and (
        written == f"application/{name}"
        or written.startswith((f"application/{name}.", f"module/{name}/"))
    )


def _is_situation(role: mentions.Role, written: str) -> bool:
    return role == "tag" and (written == "situation" or written.startswith("situation."))


def _in_texts(texts: Catalogue, file: str, new: str) -> Catalogue | None:
    """The translations, which say where each text stands, with another file's name."""
    if not any(name == file for one in texts.translations for name, _ in one.files):
        return None
    moved = (
        replace(one, files=tuple((new if n == file else n, line) for n, line in one.files))
        for one in texts.translations
    )
    return replace(texts, translations=tuple(moved))


def _counted(number: int) -> str:
    one = tr("1 place that names it as a module")
    return language.count(number, one, tr("{0} places that name it as a module"))


def _lines(number: int) -> str:
    one = tr("1 line of the scenario")
    return language.count(number, one, tr("{0} lines of the scenario"))


def _running(number: int) -> str:
    return language.count(number, tr("1 state that runs it"), tr("{0} states that run it"))


def _lacking(number: int) -> str:
    one = tr("1 state runs it, and will have nothing to run")
    return language.count(number, one, tr("{0} states run it, and will have nothing to run"))


def _asking(number: int) -> str:
    one = tr("1 place that asks for the situation")
    return language.count(number, one, tr("{0} places that ask for the situation"))


def _declared(number: int) -> str:
    one = tr("1 place that names a module declared in it")
    return language.count(number, one, tr("{0} places that name a module declared in it"))


def _where(document: Document) -> str:
    if isinstance(document, Application):
        return tr("the list of applications")
    if isinstance(document, Spds):
        return tr("which file is its script")
    return tr("which file is its module information")
