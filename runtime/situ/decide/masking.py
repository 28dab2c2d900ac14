"""What those are shown who may not see private values: ``•••`` in their place.

What is private is told by its tag, ``[privacy] private`` (formats.md, *A project*). What is filled
with it, a speech, a screen, the address of a service, does not say so in a trace; so what equals a
private value, or holds one, is hidden whole wherever it stands; of a service's result all of it.
Rather too much is hidden than too little. Shown, for no private value can have come there: what
the runtime itself says of its states, situations and clock, the project's texts as they are
written, and numbers that a module, a person or the project sets, unless they are so long that they
can be no others.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator
from typing import Any
from urllib.parse import unquote_plus

from situ.decide.priorities import RUNTIME
from situ.decide.values import in_text
from situ.document import names
from situ.document.project import Project
from situ.document.texts_shown import shown_texts

HIDDEN = "•••"
MANY = 2_000
"""Private texts, and private numbers, known at once; those not seen for longest are forgotten."""

LONG = 6
"""Digits of a number that is no other one by chance: there are 500 times as many as ``MANY``."""

# What is the project's or the runtime's own: it is never filled in.
_OWN = frozenset(
    {"kind", "seq", "t", "cause", "time", "application", "state", "from", "to", "event", "action"}
    | {"name", "resource", "resources", "optional", "module", "missing", "reason", "situation"}
    | {"holds", "ok", "timeout", "tag", "writer", "version", "lang", "where"}
)
_LAID_OUT = frozenset(
    {"type", "id", "x", "y", "width", "height", "size", "max", "align", "tag", "color", "fill"}
    | {"event", "done", "kind"}
)
# Of what the runtime itself has set: ``application.note`` and ``clock.note`` anybody may set.
_KEPT = ("application/", "situation", "clock.")
# Of ``service/<name>``; its ``error`` may repeat what was asked.
_ANSWER = frozenset({"ok", "status"})


def written(project: Project) -> frozenset[str]:
    """The texts that the robot shows and says as they are written, in all languages."""
    found = {
        each
        for application in (*project.applications.values(), *project.parts.values())
        for one in shown_texts(application)
        for each in (one.text, *(texts.get(one.text, "") for texts in project.texts.values()))
    }
    return frozenset(
        literal
        for pieces in map(names.split, map(str.strip, found))
        for literal, name in pieces
        if name is None and len(pieces) == 1
    )


class Mask:
    """Hides what is private in the events of one trace, which it must be given in order.

    written: texts that are shown though they hold a private value, but not where they are one.
    applications: those known from the beginning; more are learned from the trace.
    """

    def __init__(
        self,
        private: Iterable[str],
        written: Collection[str] = frozenset(),
        applications: Iterable[str] = (),
    ) -> None:
        self._private = tuple(private)
        self._written = written
        # Who fills in what is private; ``screen`` sets an entry that was chosen from a list.
        self._filling = {"screen", *applications}
        # In order of when they were last seen. No patterns are made of them: they change with
        # every write, and a search each is cheaper.
        self._within: dict[str, None] = {}
        self._alone: dict[str, None] = {}

    @classmethod
    def of(cls, project: Project) -> Mask:
        """That of what a project says is private, with its texts and applications."""
        applications = (application.name for application in project.applications.values())
        return cls(project.private, written(project), applications)

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

    def shown(self, tag: str, value: Any, writer: str = "screen") -> Any:
        """What is to be seen of the value of a tag that ``writer`` has set."""
        return self._seen(tag, self.know(tag, value), writer)

    def text(self, text: str) -> str:
        """What is to be seen of a text."""
        return HIDDEN if self._holds(text) else text

    def step(self, events: list[dict[str, Any]]) -> list[dict[str, Any]]:
        """The events of one step, or of several, without what is private."""
        known = []
        for event in events:
            if event["kind"] == "data":
                event = {**event, "value": self.know(event["tag"], event.get("value"))}
            elif name := event.get("application"):
                self._filling.add(name)
            known.append(event)
        # A service's result stands before the tags that it goes to.
        return [
            {key: self._field(event, key, value) for key, value in event.items()} for event in known
        ]

    def _seen(self, tag: str, known: Any, writer: str) -> Any:
        """As ``shown``, of what ``know`` has left of the value."""
        if writer == RUNTIME and tag.startswith(_KEPT):
            return known
        if tag.startswith("service/") and isinstance(known, dict):
            return {
                key: inner if key in _ANSWER else self._shown(inner) for key, inner in known.items()
            }
        return self._shown(known, counts=writer not in self._filling)

    def _field(self, event: dict[str, Any], key: str, value: Any) -> Any:
        if key in _OWN:
            return value
        if key == "value" and event["kind"] == "data":
            return self._seen(event["tag"], value, event.get("writer", "screen"))
        if key == "value" and event["kind"] == "mapping" and "module" in event:
            return self._shown(value, counts=event["module"] not in self._filling)
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
            known = self._alone if len(text) == 1 or _is_number(text) else self._within
            known.pop(text, None)
            known[text] = None
            if len(known) > MANY:
                del known[next(iter(known))]

    def _shown(self, value: Any, component: bool = False, *, counts: bool = False) -> Any:
        """component: it is one of a screen, or all of them. counts: its numbers are nobody's."""
        if isinstance(value, str):
            return HIDDEN if self._holds(value) else value
        if isinstance(value, dict):
            return {
                HIDDEN if self._holds(key) and not component else key: (
                    inner
                    if component and key in _LAID_OUT
                    else self._shown(inner, key == "components", counts=counts)
                )
                for key, inner in value.items()
            }
        if isinstance(value, list):
            return [self._shown(inner, component, counts=counts) for inner in value]
        if not isinstance(value, (int, float)) or isinstance(value, bool):
            return value
        plain = _plain(value)
        if counts and _digits(plain) < LONG:
            return value
        return HIDDEN if plain in self._alone or plain in self._within else value

    def _holds(self, text: str) -> bool:
        if text in self._written:
            plain = _plain(text)
            return plain in self._within or plain in self._alone
        # In an address it is written with signs of its own.
        for one in {text, unquote_plus(text)}:
            folded = one.casefold()
            if any(known in folded for known in self._within):
                return True
            if self._alone and any(part in self._alone for part in _standing_alone(one)):
                return True
        return False


def _standing_alone(text: str) -> Iterator[str]:
    """The words and numbers of a text, and the signs that touch no word."""
    for found in _WORD.finditer(text):
        word, fraction = found[0], found[1] or ""
        minus = "-" if text[max(found.start() - 1, 0)] == "-" else ""
        yield from (word, word + fraction, minus + word, minus + word + fraction)
    yield from _SIGN.findall(text)


_WORD = re.compile(r"\w+(?=(\.\w+)?)")
_SIGN = re.compile(r"(?<!\w)[^\w\s](?!\w)")
_NUMBER = re.compile(r"-?\d+(\.\d+)?")


def _plain(value: Any) -> str:
    """As it is looked for: in any case of letters, but for one that stands alone."""
    text = in_text(value).strip()
    return text if len(text) == 1 else text.casefold()


def _digits(number: str) -> int:
    """How many digits tell it from others: those before and behind which there are only zeros."""
    return len(number.lstrip("-").replace(".", "").strip("0"))


def _is_number(text: str) -> bool:
    return _NUMBER.fullmatch(text) is not None
