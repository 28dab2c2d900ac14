"""Every text of a project, where it stands and what kind of text it is: one row each."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal

from msgspec import Struct

from situ.document.catalogue import Translation
from situ.document.finding import Place
from situ.document.folder import PROJECT_FILE
from situ.document.project import Project
from situ.document.texts_shown import ShownText, setting_texts, shown_texts

Kind = Literal["shown", "spoken", "heard", "setting"]
"""On a screen, by the robot, by a person; on the robot's page of settings."""


class TextRow(Struct, frozen=True):
    """A text at one place of one file of the project.

    where: the place in designers' words. lang: the language that a speech asks for: it is said
    as it is written. is_to_translate: whether there is anything in it to be translated.
    """

    file: str
    place: Place
    kind: Kind
    text: str
    where: str
    lang: str | None = None
    is_to_translate: bool = True


def rows(project: Project) -> list[TextRow]:
    """In the order of the project: applications, then parts; ``always``, then state by state;
    then the settings.
    """
    found = [
        TextRow(
            file,
            one.place,
            _kind(one),
            one.text,
            " ".join(one.where.split()),
            one.lang,
            one.is_to_translate,
        )
        for file, application in project.flows.items()
        for one in shown_texts(application)
        if one.text.strip()
    ]
    told = setting_texts(project.settings)
    return found + [TextRow(PROJECT_FILE, t.place, "setting", t.text, t.where) for t in told]


def begun(text: str, every: Iterable[TextRow]) -> Translation:
    """The entry of a text that is not translated yet, as ``situ texts`` makes it."""
    found = [row for row in every if row.text == text]
    return Translation(
        text,
        where="\n".join(dict.fromkeys(row.where for row in found)),
        files=tuple((file, "") for file in dict.fromkeys(row.file for row in found)),
    )


def _kind(one: ShownText) -> Kind:
    if "say" in one.place:
        return "heard"
    return "shown" if "screen" in one.place else "spoken"
