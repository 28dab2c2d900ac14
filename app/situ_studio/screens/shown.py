"""What is on a screen as the robot's page gets it: components with their texts filled in."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import Any, NamedTuple

from situ.decide.board import Board
from situ.decide.screens import ComponentProgram, Shown
from situ.decide.values import template
from situ.document import rbd
from situ_studio.screens.samples import LANGUAGE

Texts = Mapping[str, Mapping[str, str]]
"""Language to text as it is written to its translation."""


class Values(dict[str, Any]):
    """Tag to value, as they may stand on the robot's blackboard.

    texts: the project's; those of the language that the tag ``language`` names are shown.
    """

    def __init__(self, tags: Mapping[str, Any], texts: Texts | None = None) -> None:
        super().__init__(tags)
        self.texts: Texts = texts or {}

    def written(self, tag: str, value: Any) -> Values:
        """These, with another value of one tag."""
        return Values({**self, tag: value}, self.texts)

    def translate(self, text: str, missing: list[str] | None) -> str:
        """A text in that language; as it is written where it has none."""
        language = self.get(LANGUAGE)
        found = self.texts.get(language, {}) if isinstance(language, str) else {}
        return found.get(text) or text


class Content(NamedTuple):
    """All that is on a screen, back to front, as the trace and the page have it.

    A list's ``items`` is None where it is not known what it shows. language: of the people before
    it, who write dates in their order.
    """

    components: tuple[Shown, ...]
    background: str | None = None
    language: str = "en"


def content(
    screen: rbd.Screen,
    above: tuple[rbd.Component, ...] = (),
    values: Mapping[str, Any] | None = None,
) -> Content:
    """What a screen shows with these values; without them, texts as they are written.

    above: the components that Always adds. Only ``Values`` have texts in other languages.
    """
    kept: dict[str, rbd.Component] = {}
    for one in (*screen.components, *above):
        kept.setdefault(one.id, one)  # the robot leaves out what has the id of another
    components = tuple(kept.values())
    if values is None:
        return Content(tuple(_written(one) for one in components), screen.background)
    board = board_of(values)
    translate = values.translate if isinstance(values, Values) else _as_written
    shown = tuple(_program(one).show(board, translate, None) for one in components)
    background = screen.background
    if background:
        background = template(background).text(board.look)
    language = board.look(LANGUAGE)
    return Content(shown, background, language if isinstance(language, str) else "en")


def board_of(values: Mapping[str, Any]) -> Board:
    """A blackboard of its own with these values."""
    board = Board()
    for tag, value in values.items():
        board.write(tag, value, "", 0, None)
    return board


def _written(component: rbd.Component) -> Shown:
    shown = dict(_program(component).fixed)
    match component:
        case rbd.Text(text=text) | rbd.Button(text=text):
            shown["text"] = text.strip()
        case rbd.Image(src=src) | rbd.Movie(src=src):
            shown["src"] = src
        case rbd.List():
            shown["items"] = None
        case _:
            shown["value"] = None
    return shown


@lru_cache(maxsize=2048)
def _program(component: rbd.Component) -> ComponentProgram:
    return ComponentProgram(component)


def _as_written(text: str, missing: list[str] | None) -> str:
    return text
