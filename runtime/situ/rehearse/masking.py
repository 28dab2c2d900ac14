"""Traces for those who may not see private values: ``•••`` in their place.

What is private is told by its tag, ``[privacy] private`` (formats.md, *A project*). What is filled
with it, a speech, a screen, the address of a service, does not say so in a trace; so what equals a
private value, or holds one, is hidden whole wherever it stands; of a service's result all of it.
Rather too much is hidden than too little.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import Any
from urllib.parse import unquote_plus

import msgspec

from situ.decide.values import in_text
from situ.document import names
from situ.rehearse.recorded import Heading, Line, Piece, Snapshot, Torn
from situ.rehearse.recording import Fields

HIDDEN = "•••"
MANY = 2_000
"""Private values that are known at once; those not seen for longest are forgotten."""

# What is the project's or the runtime's own: it is never filled in.
_OWN = frozenset(
    {"kind", "seq", "t", "cause", "time", "application", "state", "from", "to", "event", "action"}
    | {"name", "resource", "resources", "optional", "module", "missing", "reason", "situation"}
    | {"holds", "ok", "timeout", "tag", "writer", "version", "lang", "where"}
)
_LAID_OUT = frozenset({"type", "id", "x", "y", "width", "height", "size", "max", "align", "tag"})


class Mask:
    """Hides what is private in the events of one trace, which it must be given in order."""

    def __init__(self, private: Iterable[str]) -> None:
        self._private = tuple(private)
        self._known: dict[str, None] = {}
        self._inside: re.Pattern[str] | None = None
        self._alone: re.Pattern[str] | None = None

    def know(self, tag: str, value: Any) -> Any:
        """Learns what is private in a tag's value; the value without it."""
        if self._is_private(tag):
            if value is None:
                return None
            self._learn(value)
            return HIDDEN
        if isinstance(value, dict):
            return {key: self.know(f"{tag}.{key}", inner) for key, inner in value.items()}
        if isinstance(value, list):
            return [self.know(f"{tag}.{n}", inner) for n, inner in enumerate(value)]
        return value

    def step(self, events: list[Fields]) -> list[Fields]:
        """The events of one step, or of several, without what is private."""
        told = [
            {**event, "value": self.know(event["tag"], event.get("value"))}
            if event["kind"] == "data"
            else event
            for event in events
        ]
        # A service's result stands before the tags that it goes to.
        return [{key: self._field(key, value) for key, value in event.items()} for event in told]

    def _field(self, key: str, value: Any) -> Any:
        if key in _OWN:
            return value
        shown = self._shown(value, key == "components")
        return HIDDEN if key == "result" and shown != value else shown

    def _is_private(self, tag: str) -> bool:
        return any(names.matches(pattern, tag) for pattern in self._private)

    def _learn(self, value: Any) -> None:
        if isinstance(value, dict):
            for inner in value.values():
                self._learn(inner)
        elif isinstance(value, list):
            for inner in value:
                self._learn(inner)
        elif not isinstance(value, bool) and (text := _plain(value)):
            if text not in self._known:
                self._inside = self._alone = None
            self._known.pop(text, None)
            self._known[text] = None
            if len(self._known) > MANY:
                del self._known[next(iter(self._known))]

    def _shown(self, value: Any, component: bool = False) -> Any:
        """component: it is one of a screen, or all of them."""
        if isinstance(value, str):
            return HIDDEN if self._holds(value) else value
        if isinstance(value, dict):
            return {
                HIDDEN if self._holds(key) and not component else key: (
                    inner
                    if component and key in _LAID_OUT
                    else self._shown(inner, key == "components")
                )
                for key, inner in value.items()
            }
        if isinstance(value, list):
            return [self._shown(inner, component) for inner in value]
        number = isinstance(value, (int, float)) and not isinstance(value, bool)
        return HIDDEN if number and _plain(value) in self._known else value

    def _holds(self, text: str) -> bool:
        if self._inside is None or self._alone is None:
            long = [one for one in self._known if len(one) > 1 and not _is_number(one)]
            short = [one for one in self._known if len(one) == 1 or _is_number(one)]
            self._inside = re.compile("|".join(re.escape(one) for one in long) or r"(?!)")
            alone = "|".join(re.escape(one) for one in short)
            self._alone = re.compile(rf"(?<!\w)(?:{alone})(?!\w)" if alone else r"(?!)")
        # In an address it is written with signs of its own.
        return any(
            self._inside.search(one.casefold()) or self._alone.search(one)
            for one in (text, unquote_plus(text))
        )


def _plain(value: Any) -> str:
    """As it is looked for: in any case of letters, but for one that stands alone."""
    text = in_text(value).strip()
    return text if len(text) == 1 else text.casefold()


def _is_number(text: str) -> bool:
    return text.replace(".", "", 1).lstrip("-").isdigit()


def masked(recording: Iterable[Piece]) -> Iterator[Piece]:
    """The same recording as a viewer may see it: its trace, without what is private."""
    mask = Mask(())
    ended: list[Piece] = []
    moment: list[tuple[Line, Fields]] = []
    for piece in recording:
        if isinstance(piece, Line):
            event = msgspec.json.decode(piece.text)
            if moment and moment[0][1]["t"] != event["t"]:
                yield from _shown(mask, moment)
                moment = []
            moment.append((piece, event))
        elif isinstance(piece, Heading):
            mask = Mask(piece.private)
            yield msgspec.structs.replace(piece, tags={}, masked=True)
        elif isinstance(piece, Snapshot):
            for tag, entry in _board.decode(piece.state).board.items():
                mask.know(tag, entry.value)
        elif isinstance(piece, Torn):
            ended.append(piece)
    yield from _shown(mask, moment)
    yield from ended


def _shown(mask: Mask, moment: list[tuple[Line, Fields]]) -> Iterator[Line]:
    events = mask.step([event for _, event in moment])
    for (line, _), event in zip(moment, events, strict=True):
        yield Line(msgspec.json.encode(event), line.at)


class _Entry(msgspec.Struct):
    value: Any = None


class _Board(msgspec.Struct):
    board: dict[str, _Entry] = {}


_board = msgspec.json.Decoder(_Board)
