"""The rows of the table of texts that are written in ``situ.toml``: labels and choices of settings.

Their places count the settings of the project; the file may have others, with errors.
"""

from __future__ import annotations

import tomllib
from typing import Any

from situ.document import toml_writing as writing
from situ.document.beside import Toml
from situ.document.project import Project
from situ_studio.edits.edit import Place
from situ_studio.wording.language import tr


def words(project: Project, place: Place) -> tuple[str, str]:
    """The setting, and what the text is there."""
    tag = project.settings[int(place[1])].tag
    return tr("Setting {0}").format(tag), tr("Label") if place[2] == "label" else tr("Choice")


def in_file(project: Project, toml: Toml, place: Place) -> Place:
    """The place in the file of what stands at a place among the project's settings."""
    every, at = project.settings, int(place[1])
    before = sum(one.tag == every[at].tag for one in every[:at])
    same = [n for n, one in enumerate(_written(toml)) if one.get("tag") == every[at].tag]
    return ("setting", str(same[before]), *place[2:])


def reworded(project: Project, toml: Toml, place: Place, text: str) -> Toml:
    """The file with another text there; ValueError, in a sentence, where it can not be one."""
    _, at, key, *choice = in_file(project, toml, place)
    if not choice:
        return writing.put_setting(toml, int(at), key, text)
    choices = list(_written(toml)[int(at)][key])
    if "," in text or text in choices:
        raise ValueError(tr("Choices differ from each other, and have no comma in them."))
    choices[int(choice[0])] = text
    return writing.put_setting(toml, int(at), key, choices)


def _written(toml: Toml) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = tomllib.loads(toml.text)[writing.SETTING]
    return found
