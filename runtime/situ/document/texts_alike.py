"""Of many texts the one that is most like another: what a text was before somebody edited it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from difflib import SequenceMatcher

NEAR = 0.7
"""From which likeness on (difflib's ratio, 0 to 1) a text may be an edited other one."""

LOOKED_AT = 8
"""Texts that are compared in full: those that share the most groups of three characters."""


class Alike:
    """Texts, each of which is taken once."""

    def __init__(self, texts: Iterable[str]) -> None:
        self._by_group: dict[str, list[str]] = {}
        self._taken: set[str] = set()
        for text in texts:
            for group in _groups(text):
                self._by_group.setdefault(group, []).append(text)

    def take(self, text: str) -> str | None:
        """The one most like ``text``, which is then gone; None where none is near."""
        shared: Counter[str] = Counter()
        for group in _groups(text):
            shared.update(self._by_group.get(group, ()))
        for one in self._taken:
            del shared[one]
        best, found = NEAR, None
        # SequenceMatcher remembers what it knows of its second text.
        matcher = SequenceMatcher(None, "", text, autojunk=False)
        for one, _ in shared.most_common(LOOKED_AT):
            matcher.set_seq1(one)
            if matcher.quick_ratio() >= best and matcher.ratio() >= best:
                best, found = matcher.ratio(), one
        if found is not None:
            self._taken.add(found)
        return found


def _groups(text: str) -> dict[str, None]:
    """The groups of three characters in a text, in their order, its ends counting as blanks."""
    padded = f"  {text.casefold()}  "
    return dict.fromkeys(padded[at : at + 3] for at in range(len(padded) - 2))
