"""Screens made ready to show: components with their references filled in (formats.md, *Screen*)."""

from __future__ import annotations

from typing import Any

from situ.decide.board import Board, prefixes, reach
from situ.decide.texts import Translator
from situ.decide.values import Look, Template, template
from situ.document.rbd import (
    Button,
    Component,
    Image,
    Input,
    List,
    Movie,
    Screen,
    Text,
)

Shown = dict[str, Any]
"""A component as the screen page and the trace have it: ``type``, its attributes, resolved."""

_PLAIN = ("id", "x", "y", "width", "height", "size", "align", "color", "fill")
_MORE: dict[str, tuple[str, ...]] = {
    "button": ("event", "tag"),
    "movie": ("done",),
    "input": ("tag", "kind", "max", "event"),
    "list": ("tag", "event"),
}


class ComponentProgram:
    """One component; ``names`` are those whose change may change what it shows, ``fixed`` what no
    value changes.
    """

    def __init__(self, source: Component) -> None:
        self.source = source
        self.fixed: Shown = {"type": source.element}
        for field in (*_PLAIN, *_MORE.get(source.element, ())):
            value = getattr(source, field)
            if value is not None:
                whole = isinstance(value, float) and value.is_integer()
                self.fixed[field] = int(value) if whole else value
        texts = {
            Text: "text", Button: "text", Image: "src", Movie: "src", List: "label"
        }  # fmt: skip
        self._field = texts.get(type(source))
        self.names: tuple[str, ...] = ()
        if self._field is not None:
            own = [n for n in template(getattr(source, self._field)).names if not _is_item(n)]
            self.names = tuple(own)
        if isinstance(source, Input):
            self.names = (source.tag,)
        elif isinstance(source, List):
            self.names = (*self.names, source.items)

    def show(self, board: Board, translate: Translator, missing: list[str] | None) -> Shown:
        """What it shows now. Names without a value, and texts without a translation, are
        appended to ``missing`` as sentences, where a list is given.
        """
        source, look = self.source, board.look
        shown = dict(self.fixed)
        if isinstance(source, Input):
            shown["value"] = look(source.tag)
            return shown
        assert self._field is not None
        written = getattr(source, self._field)
        if isinstance(source, (Image, Movie)):
            shown["src"] = self._fill(written, look, missing)
            return shown
        text = translate(written, missing)
        if isinstance(source, List):
            entries = look(source.items)
            shown["items"] = [
                {"label": self._fill(text, _with_item(look, entry), missing), "value": entry}
                for entry in (entries if isinstance(entries, list) else ())
            ]
            return shown
        shown["text"] = self._fill(text, look, missing)
        return shown

    @staticmethod
    def _fill(text: str, look: Look, missing: list[str] | None) -> str:
        filled = template(text)
        if missing is not None and filled.names:
            missing += [f"{name} has no value" for name in filled.missing(look)]
        return filled.text(look)


class ScreenProgram:
    """What a state's own screen, or that of ``always``, adds to the robot's screen."""

    def __init__(self, source: Screen) -> None:
        self.source = source
        self.components = [ComponentProgram(component) for component in source.components]
        self.background = None if source.background is None else Template(source.background)

    def tags(self) -> set[str]:
        """Every tag whose write may change what is shown."""
        found = {t for one in self.components for n in one.names for t in prefixes(n)}
        if self.background is not None:
            found.update(t for n in self.background.names for t in prefixes(n))
        return found

    def component(self, component_id: str) -> Component | None:
        return next((one.source for one in self.components if one.source.id == component_id), None)

    def movies(self) -> list[Movie]:
        return [one.source for one in self.components if isinstance(one.source, Movie)]


def _is_item(name: str) -> bool:
    return name == "item" or name.startswith("item.")


def _with_item(look: Look, entry: Any) -> Look:
    def inner(name: str) -> Any:
        if name == "item":
            return entry
        return reach(entry, name[5:]) if name.startswith("item.") else look(name)

    return inner
