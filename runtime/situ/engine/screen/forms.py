"""What the pages beside the screen know of a project before they ask the robot."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct

from situ.document.project import Project, Setting
from situ.document.rbd import Application
from situ.document.texts_shown import setting_texts

_TYPES = {"boolean": "boolean", "number": "number", "text": "text"}


class Datum(Struct, frozen=True):
    """A tag that a person can fill in by its type; type and choices as of a ``Setting``."""

    tag: str
    type: str
    label: str = ""
    unit: str | None = None
    choices: tuple[str, ...] = ()


class Place(Struct, frozen=True):
    """A state that an application can be sent to: its path (``5/q``) and its name."""

    path: str
    name: str


class Forms(Struct, frozen=True):
    """settings: in the project's order. data: the settings, then what the script observes and
    what modules provide, each tag once. states: by application, in document order. texts: by
    language, what is written in the settings to its translation, where there is one."""

    settings: tuple[Setting, ...] = ()
    data: tuple[Datum, ...] = ()
    states: dict[str, tuple[Place, ...]] = {}
    texts: dict[str, dict[str, str]] = {}


def forms(project: Project) -> Forms:
    data: dict[str, Datum] = {}
    for datum in _data(project):
        data.setdefault(datum.tag, datum)
    written = [one.text for one in setting_texts(project.settings)]
    return Forms(
        settings=project.settings,
        data=tuple(data.values()),
        states={one.name: tuple(_states(project, one)) for one in project.applications.values()},
        texts={
            language: {text: known[text] for text in written if text in known}
            for language, known in project.texts.items()
        },
    )


def _data(project: Project) -> Iterator[Datum]:
    for one in project.settings:
        yield Datum(one.tag, one.type, one.label, None, one.choices)
    for observed in project.spds.observe if project.spds is not None else ():
        if observed.type in _TYPES:
            yield Datum(observed.tag, _TYPES[observed.type], unit=observed.unit)
    for module in project.modules.modules if project.modules is not None else ():
        for offer in module.provides:
            if offer.type in _TYPES:
                yield Datum(offer.data, _TYPES[offer.type], unit=offer.unit)


def _states(project: Project, application: Application, before: str = "") -> Iterator[Place]:
    for state in application.states:
        part = project.flow(state.flow) if state.flow is not None else None
        if part is None:
            yield Place(before + state.no, state.name)
        else:
            yield from _states(project, part, f"{before}{state.no}/")
