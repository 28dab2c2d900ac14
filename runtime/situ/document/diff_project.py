"""What changed between two projects: their documents, texts and settings."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from situ.document import words
from situ.document.change import Change
from situ.document.codec import Document
from situ.document.diff import compare
from situ.document.diff_match import content
from situ.document.diff_words import shown
from situ.document.folder import PROJECT_FILE, TEXTS_FOLDER
from situ.document.pairing import pair
from situ.document.project import Project
from situ.document.rbd import Application, State

Files = dict[str, Application]


def compare_projects(before: Project, after: Project) -> list[Change]:
    """Every difference between two projects but for what lies in their media.

    A single document is compared as that: what its name says and a project has besides
    does not count where one of the two is none.
    """
    changes: list[Change] = []
    whole = before.toml is not None and after.toml is not None
    if whole:
        changes += _settings(before, after)
    changes += _applications(before.applications, after.applications, whole)
    changes += _parts(before.parts, after.parts)
    changes = _between_files(before, after, changes)
    changes += _document(before.spds_file, before.spds, after.spds_file, after.spds, whole)
    changes += _document(
        before.modules_file, before.modules, after.modules_file, after.modules, whole
    )
    return changes + _texts(before, after)


# -- documents ---------------------------------------------------------------


def _applications(before: Files, after: Files, whole: bool) -> list[Change]:
    old, new = list(before.items()), list(after.items())
    paired = pair(
        old,
        new,
        [
            lambda _, one: one,
            lambda _, one: one[0],
            lambda _, one: one[1].name,
            lambda index, one: None if whole else index,
        ],
    )
    changes = [_file(old[index], "application", "gone") for index in paired.gone]
    changes += [_file(new[index], "application", "added") for index in paired.new]
    for first, then in paired.both:
        (file, application), (name, now) = old[first], new[then]
        if file != name and whole:
            said = f"application {now.name}: its file is {name}, was {file}"
            changes.append(Change(file=name, place=(), text=said, behaviour=False))
        changes += compare(application, now, name)
    for _, then in paired.moved:
        after_ = f"after {new[then - 1][1].name}" if then else "first"
        said = f"application {new[then][1].name} now comes {after_}"
        changes.append(Change(file=new[then][0], place=(), text=said, kind="order"))
    return changes


def _file(one: tuple[str, Application], word: str, what: str) -> Change:
    file, application = one
    said = f"{word} {application.name} {what}"
    return Change(file=file, place=(), text=said, kind="gone" if what == "gone" else "new")


def _parts(before: Files, after: Files) -> list[Change]:
    old, new = list(before.items()), list(after.items())
    paired = pair(old, new, [lambda _, one: one[0], lambda _, one: one[1]])
    changes = [_file(old[index], "part", "gone") for index in paired.gone]
    for first, then in paired.both:
        (file, part), (name, now) = old[first], new[then]
        if file != name:
            said = f"part {now.name}: its file is {name}, was {file}"
            changes.append(Change(file=name, place=(), text=said, behaviour=False))
        changes += compare(part, now, name)
    return changes + [_file(new[index], "part", "added") for index in paired.new]


def _between_files(before: Project, after: Project, changes: list[Change]) -> list[Change]:
    """The changes, with states that went into another file, as into a part, told as that."""
    gone, came = _states(before, changes, "gone"), _states(after, changes, "new")
    paired = pair(gone, came, [lambda _, one: one[1].name and (one[1].name, content(one[1]))])
    moved = {}
    for first, then in paired.both:
        (file, state), (other, now) = gone[first], came[then]
        place = ("state", state.no)
        said = f"state {words.state(state)}: now in {other}, as {words.state(now)}"
        moved[file, place] = Change(file=file, place=place, text=said)
    new = {(came[then][0], ("state", came[then][1].no)) for _, then in paired.both}
    found = []
    for one in changes:
        at = (one.file, one.place)
        if one.kind == "gone" and at in moved:
            found.append(moved.pop(at))
        elif one.kind != "new" or at not in new:
            found.append(one)
    # Of a file that is gone whole no state was told yet.
    return [*found, *moved.values()]


def _states(project: Project, changes: list[Change], kind: str) -> list[tuple[str, State]]:
    """The states that are gone or new, with their files; those of whole files too."""
    files = project.flows
    return [
        (one.file, state)
        for one in changes
        if one.kind == kind and one.file in files
        for state in files[one.file].states
        if one.place in ((), ("state", state.no))
    ]


def _document(
    old_file: str | None,
    old: Document | None,
    new_file: str | None,
    new: Document | None,
    whole: bool,
) -> list[Change]:
    file = new_file or old_file or ""
    if old is None and new is None:
        return []
    if new is None:
        return [Change(file=file, place=(), text=f"{file} gone", kind="gone")]
    if old is None:
        return [Change(file=file, place=(), text=f"{file} added", kind="new")]
    changes = compare(old, new, file)
    if old_file != new_file and whole:
        said = f"its file is {new_file}, was {old_file}"
        changes.insert(0, Change(file=file, place=(), text=said, behaviour=False))
    return changes


def _texts(before: Project, after: Project) -> list[Change]:
    changes = []
    for language in dict.fromkeys((*before.texts, *after.texts)):
        file = f"{TEXTS_FOLDER}/{language}.po"
        old, new = before.texts.get(language, {}), after.texts.get(language, {})
        for text in dict.fromkeys((*old, *new)):
            if old.get(text) == new.get(text):
                continue
            first, then = (
                None if one is None else words.quoted(one) for one in (old.get(text), new.get(text))
            )
            if first is not None and first == then:
                first, then = old[text], new[text]
            said = f"in {language}, {words.quoted(text)}: {first or 'none'} → {then or 'none'}"
            changes.append(Change(file=file, place=("text", language, text), text=said))
        changes += _readings(language, before, after)
    return changes


def _readings(language: str, before: Project, after: Project) -> list[Change]:
    changes = []
    old, new = before.readings.get(language, {}), after.readings.get(language, {})
    for word in dict.fromkeys((*old, *new)):
        if old.get(word) == new.get(word):
            continue
        first, then = (
            "as written" if one is None else words.quoted(one)
            for one in (old.get(word), new.get(word))
        )
        said = f"in {language}, {words.quoted(word)} is said {first} → {then}"
        file = f"{TEXTS_FOLDER}/{language}.po"
        changes.append(Change(file=file, place=("reading", language, word), text=said))
    return changes


# -- situ.toml ---------------------------------------------------------------


def _settings(before: Project, after: Project) -> list[Change]:
    changes: list[Change] = []

    def add(place: Sequence[str], text: str, behaviour: bool = True) -> None:
        changes.append(
            Change(file=PROJECT_FILE, place=tuple(place), text=text, behaviour=behaviour)
        )

    for table, field, label, behaviour in _VALUES:
        old, new = getattr(before, field), getattr(after, field)
        if old != new:
            add((table, field), f"{label} {shown(old)} → {shown(new)}", behaviour)
    for table, field, label in _SETS:
        old, new = getattr(before, field), getattr(after, field)
        for one in dict.fromkeys((*old, *new)):
            if (one in old) != (one in new):
                add((table, field), f"{label} {one} {'gone' if one in old else 'added'}")
    if _same_but_order(before.languages, after.languages):
        first, then = ", ".join(before.languages), ", ".join(after.languages)
        add(("project", "languages"), f"order of languages {first} → {then}")
    for table, of in _TABLES:
        _table(of(before), of(after), table, add)
    old_forms = {one.tag: one for one in before.settings}
    new_forms = {one.tag: one for one in after.settings}
    for tag in dict.fromkeys((*old_forms, *new_forms)):
        old_form, new_form = old_forms.get(tag), new_forms.get(tag)
        if old_form == new_form:
            continue
        if old_form is None or new_form is None:
            add(("setting", tag), f"setting {tag} {'added' if old_form is None else 'gone'}")
            continue
        for field in ("label", "type"):
            first, then = getattr(old_form, field), getattr(new_form, field)
            if first != then:
                said = f"setting {tag}: {field} {shown(first)} → {shown(then)}"
                add(("setting", tag), said, field != "label")
        if old_form.choices != new_form.choices:
            first, then = ", ".join(old_form.choices), ", ".join(new_form.choices)
            add(("setting", tag), f"setting {tag}: choices {shown(first)} → {shown(then)}")
    return changes


def _same_but_order(old: Sequence[str], new: Sequence[str]) -> bool:
    return old != new and sorted(old) == sorted(new)


def _table(
    old: Mapping[str, Any], new: Mapping[str, Any], table: str, add: Callable[..., None]
) -> None:
    label = {"tags": "tag at the start", "places": "place"}.get(table, table)
    for key in dict.fromkeys((*old, *new)):
        if key not in new:
            add((table, key), f"{label} {key} gone, was {shown(old[key])}")
        elif key not in old:
            add((table, key), f"{label} {key} added: {shown(new[key])}")
        elif old[key] != new[key] or type(old[key]) is not type(new[key]):
            add((table, key), f"{label} {key} {shown(old[key])} → {shown(new[key])}")


_VALUES = (
    ("project", "name", "project's name", False),
    ("project", "media", "folder of media", True),
    ("project", "scenarios", "folder of scenarios", False),
    ("robot", "endpoint", "endpoint", True),
    ("robot", "adapter", "adapter", True),
    ("robot", "announce", "announced in the network", False),
)
_SETS = (
    ("project", "languages", "language"),
    ("durable", "durable", "durable tags"),
    ("privacy", "private", "private tags"),
)
_TABLES: tuple[tuple[str, Callable[[Project], Mapping[str, Any]]], ...] = (
    ("tags", lambda project: project.tags),
    ("places", lambda project: project.places),
    ("mqtt", lambda project: {} if project.mqtt is None else {"url": project.mqtt.url}),
    ("mqtt", lambda project: {} if project.mqtt is None else project.mqtt.incoming),
)
