"""What ``situ.document`` and ``situ.rehearse`` say in English, in the user's language.

The runtime knows no languages: problems, mends, differences, what happened and why are English
sentences with values in them. ``resources/i18n/runtime.txt`` has their templates
(packaging/runtime_texts.py gathers them), which are translated like all texts of the studio, in the
context ``runtime``.
"""

from __future__ import annotations

import functools
import re
from collections.abc import Callable, Iterator

from msgspec import Struct

from situ.resources import resource

Translate = Callable[[str], str]
"""Gives a template in the user's language; what it does not know as it is."""
HOLE = re.compile(r"\{(\d)\}")
QUOTED = re.compile(r'“[^“”]*”|"[^"]*"')
"""What a person wrote: never translated, though it may read like one of the runtime's texts."""
DATA = ('{"', "[{", '["', "{}", "[]")
"""How a value as JSON begins, which is never translated either."""
TAG = re.compile(r"[a-z]\w*(\.[\w-]+)+")
"""What stands before a test: ``human.distance above 3``."""
GLUE = (": ", "; ", ", ", " → ", " and ")
"""What the runtime puts between sentences and values of its own making."""
LISTING = re.compile(r", | and | or ")
"""What ``words.listed`` puts between things."""
THINGS = (re.compile(r"\d+ .+"), re.compile(r'“[^“”]*”|"[^"]*"'), TAG)
"""What it lists, all of a kind: states by number and name, what a person wrote, tags."""
RESOURCES = re.compile(r"(?:asks for|gives back|not hold|declare \{\d\}, only) \{(\d)\}")
"""Where templates have a list of resources: their names look like any other words."""
DEEPEST = 6


class _Template(Struct, frozen=True):
    text: str
    pattern: re.Pattern[str]
    longest: str
    """The longest piece without a value: whoever lacks it does not fit."""
    weight: int


class RuntimeWords:
    """The runtime's sentences in one language.

    translate: as Qt's for the context ``runtime``.
    """

    def __init__(self, templates: list[str], translate: Translate) -> None:
        self._translate = translate
        self._whole = {one for one in templates if not HOLE.search(one)}
        self._templates = sorted(
            (_compiled(one) for one in templates if HOLE.search(one)),
            key=lambda one: -one.weight,
        )
        self._speaks = any(translate(one) != one for one in templates)
        self.said = functools.lru_cache(maxsize=4096)(self._said)

    def _said(self, text: str, depth: int = 0) -> str:
        """The text in the user's language; what fits no template stays as it is."""
        if not self._speaks:
            return text
        if text in self._whole:
            return self._translate(text)
        if QUOTED.fullmatch(text) or text.startswith(DATA):
            return text
        if depth < DEEPEST:
            for template, values in self._fitting(text):
                meant = self._translate(template.text)
                if meant != template.text:
                    return self._filled(meant, self._with_lists(template, values), depth)
            for glue in GLUE:
                first, found, rest = text.partition(glue)
                if found:
                    told = [self.said(first, depth + 1), self.said(rest, depth + 1)]
                    if told != [first, rest]:
                        return self._translate(glue).join(told)
            things = LISTING.split(text)
            if len(things) > 1 and any(all(map(one.fullmatch, things)) for one in THINGS):
                return LISTING.sub(lambda joint: self._translate(joint[0]), text)
            tag, _, rest = text.partition(" ")
            if TAG.fullmatch(tag) and self.said(rest, depth + 1) != rest:
                return f"{tag} {self.said(rest, depth + 1)}"
        return text

    def _filled(self, meant: str, values: tuple[str, ...], depth: int) -> str:
        return HOLE.sub(lambda hole: self.said(values[int(hole[1])], depth + 1), meant)

    def _with_lists(self, template: _Template, values: tuple[str, ...]) -> tuple[str, ...]:
        """The values, with what joins those that are resources in the user's language."""
        lists = {int(hole[1]) for hole in RESOURCES.finditer(template.text)}
        return tuple(
            LISTING.sub(lambda joint: self._translate(joint[0]), one)
            if index in lists and all(" " not in name for name in LISTING.split(one))
            else one
            for index, one in enumerate(values)
        )

    def _fitting(self, text: str) -> Iterator[tuple[_Template, tuple[str, ...]]]:
        for one in self._templates:
            if one.longest in text:
                match = one.pattern.fullmatch(text)
                if match is not None:
                    yield one, match.groups()


def _compiled(text: str) -> _Template:
    pieces = HOLE.split(text)[::2]
    pattern = "(.+?)".join(re.escape(piece) for piece in pieces)
    return _Template(
        text,
        re.compile(pattern, re.DOTALL),
        max(pieces, key=len),
        sum(len(piece.strip(" ,:;()")) for piece in pieces),
    )


def templates() -> list[str]:
    """The templates of ``resources/i18n/runtime.txt``."""
    return resource("i18n", "runtime.txt").read_text(encoding="utf-8").splitlines()
