"""What a form shows, and the measures that its parts share."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from msgspec import Struct

from situ.document.problem import Problem
from situ.document.project import Project
from situ_studio.edits.edit import Document, Place
from situ_studio.edits.vocabulary import Vocabulary
from situ_studio.looks.theme import Theme
from situ_studio.screens.devices import USUAL, Device
from situ_studio.screens.media_import import home_of

LABEL = 72
MARGIN = 12


class Subject(Struct, frozen=True, kw_only=True):
    """What a form shows: the value at ``place`` of ``document``, and what it is surrounded by."""

    document: Document
    place: Place
    value: Any
    theme: Theme
    vocabulary: Vocabulary = Vocabulary()
    problems: tuple[Problem, ...] = ()
    project: Project | None = None
    device: Device = USUAL
    """The screen that is looked at."""

    @property
    def media(self) -> Path | None:
        """The folder from which the project names its pictures."""
        return home_of(self.project) if self.project is not None else None
