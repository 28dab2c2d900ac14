"""What a form shows, and the measures that its parts share."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from msgspec import Struct
from PySide6.QtCore import QCoreApplication

from situ.document.problem import Problem
from situ_studio.edit import Document, Place
from situ_studio.theme import Theme
from situ_studio.vocabulary import Vocabulary

LABEL = 72
MARGIN = 12


def translated(text: str) -> str:
    """A text of the kinds' table in the user's language."""
    return QCoreApplication.translate("kinds", text) if text else ""


class Subject(Struct, frozen=True, kw_only=True):
    """What a form shows: the value at ``place`` of ``document``, and what it is surrounded by."""

    document: Document
    place: Place
    value: Any
    theme: Theme
    vocabulary: Vocabulary = Vocabulary()
    problems: tuple[Problem, ...] = ()
    media: Path | None = None
