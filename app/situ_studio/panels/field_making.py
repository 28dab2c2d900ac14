"""Which field an editor of the kinds' table has, and the words that it offers."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QWidget

from situ.document.rbd import AGAIN, BACK
from situ.document.words import numbered
from situ_studio.edits.vocabulary import Vocabulary
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import (
    Choice,
    FieldWidget,
    Flag,
    Line,
    Number,
    Paragraph,
    Swatch,
    Words,
)
from situ_studio.wording.language import translated


def make_field(
    editor: str, theme: Theme, label: str, unit: str = "", parent: QWidget | None = None
) -> FieldWidget:
    """The widget for an editor of the kinds' table."""
    if editor in ("number", "seconds"):
        return Number(parent, unit, above=editor == "seconds")
    if editor == "whole":
        return Number(parent, unit, whole=True)
    if editor in ("long", "note"):
        return Paragraph(parent)
    if editor == "flag":
        return Flag(theme, label, parent)
    if editor in ("choice", "state", "next", "situation", "module"):
        return Choice(theme, parent)
    if editor == "resources":
        return Words(parent, unit)
    return Swatch(parent) if editor == "color" else Line(parent, unit)


def offer(
    widget: FieldWidget,
    editor: str,
    vocabulary: Vocabulary,
    choices: tuple[tuple[str, str], ...] = (),
    empty: str = "",
) -> None:
    """Gives a field the words that it can complete or choose from."""
    if isinstance(widget, Choice):
        if editor == "choice":
            widget.offer(tuple((value or None, translated(text)) for value, text in choices))
        elif editor == "next":
            widget.offer(next_choices(vocabulary, empty))
        elif editor == "state":
            widget.offer(((None, empty), *_states(vocabulary.states)))
        elif editor == "situation":
            widget.offer(((None, empty), *((s, s) for s in vocabulary.situations)))
        else:
            widget.offer(tuple((m, m) for m in vocabulary.modules))
    elif editor in ("long", "text"):
        assert isinstance(widget, Line | Paragraph)
        widget.complete_tags(vocabulary.tags)
    elif isinstance(widget, Line):
        words = {
            "event": vocabulary.events,
            "tag": vocabulary.tags,
            "resource": vocabulary.resources,
            "media": vocabulary.media,
        }.get(editor)
        if words is not None:
            widget.complete_from(words)


@lru_cache(maxsize=4)
def _states(states: tuple[tuple[str, str], ...]) -> tuple[tuple[str, str], ...]:
    """Numbers, and what stands for each; one list for all fields of a form."""
    return tuple((no, numbered(no, name)) for no, name in states)


def next_choices(vocabulary: Vocabulary, stay: str) -> tuple[tuple[Any, str], ...]:
    """What an event can lead to."""
    return (
        (None, stay),
        *_states(vocabulary.states),
        (AGAIN, QCoreApplication.translate("fields", "the same state, anew")),
        (BACK, QCoreApplication.translate("fields", "back to where it came from")),
    )
