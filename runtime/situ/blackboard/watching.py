"""Which patterns are watched, by whom, and what last changed below each."""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import Struct

from situ.document import names


class Watched(Struct):
    """n: number of the last change that fits, or of the last before it was watched."""

    pattern: str
    n: int = 0
    watchers: int = 0


class Watching:
    """An index from tag to the patterns that fit it; ``n`` counts all changes of the board."""

    def __init__(self) -> None:
        self.n = 0
        self._patterns: dict[str, Watched] = {}
        self._by_tag: dict[str, tuple[Watched, ...]] = {}

    def add(self, pattern: str) -> None:
        """One more watches it."""
        watched = self._patterns.get(pattern)
        if watched is None:
            # What changed before is in the snapshot, so the count may begin here.
            watched = self._patterns[pattern] = Watched(pattern, self.n)
            self._by_tag.clear()
        watched.watchers += 1

    def remove(self, pattern: str) -> None:
        """One less watches it."""
        watched = self._patterns[pattern]
        watched.watchers -= 1
        if watched.watchers == 0:
            del self._patterns[pattern]
            self._by_tag.clear()

    def changed(self, tag: str) -> bool:
        """Counts a change; whether anybody watches the tag."""
        self.n += 1
        fitting = self._by_tag.get(tag)
        if fitting is None:
            fitting = self._by_tag[tag] = tuple(
                watched
                for pattern, watched in self._patterns.items()
                if names.matches(pattern, tag)
            )
        for watched in fitting:
            watched.n = self.n
        return bool(fitting)

    def last(self, patterns: Iterable[str]) -> dict[str, int]:
        """Pattern to the number of the last change that fits it."""
        return {pattern: self._patterns[pattern].n for pattern in patterns}
