"""``ed:accept="code code"`` on an element: warnings that a designer knows and means.

They are about the element, or about anything inside it. Errors are never silenced, nor what
is told of ``situ.toml``, which has no elements (docs/semantics.md).
"""

from __future__ import annotations

from collections.abc import Iterator

from situ.document.aside import Aside

ACCEPT = "accept"

Place = tuple[str, ...]


class Accepts:
    """What one file accepts, and which of it has silenced something."""

    def __init__(self) -> None:
        self._codes: dict[Place, dict[str, bool]] = {}
        self._asides: dict[Place, Aside] = {}
        self.misplaced: list[tuple[Place, str, Aside]] = []
        """Where it stands on what only groups others (``<expectedevents>``), by name."""

    def note(self, place: Place, aside: Aside) -> None:
        """Takes note of what is accepted at a place."""
        written = aside.attribute(ACCEPT)
        if written is not None:
            self._codes[place] = dict.fromkeys(written.split(), False)
            self._asides[place] = aside
        for name, part in aside.parts:
            if part.attribute(ACCEPT) is not None:
                self.misplaced.append((place, name, part))

    def silences(self, code: str, place: Place) -> bool:
        """Whether a warning about a place is accepted there, or further out."""
        found = False
        if self._codes:
            for size in range(len(place) + 1):
                codes = self._codes.get(place[:size])
                if codes is not None and code in codes:
                    codes[code] = found = True
        return found

    def unused(self) -> Iterator[tuple[Place, Aside, list[str], list[str]]]:
        """Places where something accepted has silenced nothing: these codes, and the others."""
        for place, codes in self._codes.items():
            used = [code for code, is_used in codes.items() if is_used]
            if len(used) < len(codes) or not codes:
                yield place, self._asides[place], [c for c in codes if c not in used], used
