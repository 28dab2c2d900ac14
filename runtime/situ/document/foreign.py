"""Elements that are not ours, read past or kept as text (``situ.document.aside``)."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

from situ.document.writer import ATTRIBUTE

_START_TAG = re.compile(rb"<[^\s/>]+(?:\s+[^\s=]+\s*=\s*(?:\"[^\"]*\"|'[^']*'))*\s*/?>")
_NAME = re.compile(r"<[^\s/>]+")


def declared(given: Mapping[str, str]) -> dict[str, str]:
    """The namespaces that a start tag declares, by prefix."""
    return {key[6:]: uri for key, uri in given.items() if key.startswith("xmlns:")}


class Foreign:
    """One element that is not ours, from its start tag at byte ``at`` to its end tag.

    bound: gives the namespace of a prefix where the element stands. keep: whether
    its text is wanted; else it is only read past.
    """

    def __init__(self, data: bytes, at: int, bound: Callable[[str], str], *, keep: bool) -> None:
        self._data = data
        self._at = at
        self._bound = bound
        self._keep = keep
        self._scopes: list[dict[str, str]] = []
        self._needed: dict[str, str] = {}

    @property
    def depth(self) -> int:
        """How many elements are open, its own included."""
        return len(self._scopes)

    def start(self, name: str, given: Mapping[str, str]) -> None:
        self._scopes.append(declared(given))
        if not self._keep:
            return
        for used in (name, *given):
            prefix, colon, _ = used.partition(":")
            if not colon or prefix in ("xml", "xmlns") or prefix in self._needed:
                continue
            if not any(prefix in scope for scope in self._scopes):
                self._needed[prefix] = self._bound(prefix)

    def end(self) -> bool:
        """Takes an end tag; True where it was the element's own."""
        self._scopes.pop()
        return not self._scopes

    def text(self, end: int) -> str | None:
        """The element as XML that stands for itself: every prefix it uses is declared in it.

        end: the byte at which the parser met its end.
        """
        if not self._keep:
            return None
        data = self._data
        match = _START_TAG.match(data, self._at)
        assert match is not None
        empty = match[0].endswith(b"/>")
        stop = match.end() if empty else data.index(b">", end) + 1
        text = data[self._at : stop].decode().replace("\r\n", "\n").replace("\r", "\n")
        if not self._needed:
            return text
        name = _NAME.match(text)
        assert name is not None
        added = "".join(
            f' xmlns:{prefix}="{uri.translate(ATTRIBUTE)}"' for prefix, uri in self._needed.items()
        )
        return name[0] + added + text[name.end() :]
