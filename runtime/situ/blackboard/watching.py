"""Which patterns are watched, by how many, and how many changes fitted each."""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import Struct

from situ.document import names


class Watched(Struct):
    """changes: how many fitted the pattern since somebody began to watch it. masked: how many of
    the watchers are not shown what is private."""

    pattern: str
    changes: int = 0
    watchers: int = 0
    masked: int = 0


class Watching:
    """An index from tag to the patterns that fit it."""

    def __init__(self) -> None:
        self._patterns: dict[str, Watched] = {}
        self._by_tag: dict[str, tuple[Watched, ...]] = {}

    def add(self, pattern: str, masked: bool = False) -> None:
        """One more watches it."""
        watched = self._patterns.get(pattern)
        if watched is None:
            watched = self._patterns[pattern] = Watched(pattern)
            self._by_tag.clear()
        watched.watchers += 1
        watched.masked += masked

    def remove(self, pattern: str, masked: bool = False) -> None:
        """One less watches it."""
        watched = self._patterns[pattern]
        watched.watchers -= 1
        watched.masked -= masked
        if watched.watchers == 0:
            del self._patterns[pattern]
            self._by_tag.clear()

    def state(self) -> dict[str, int]:
        """Every pattern that is watched, to how many changes fitted it."""
        return {pattern: watched.changes for pattern, watched in self._patterns.items()}

    def restore(self, changes: dict[str, int]) -> None:
        """Counts on from there; every one of the patterns must be watched."""
        for pattern, count in changes.items():
            self._patterns[pattern].changes = count

    def changed(self, tag: str) -> bool:
        """Counts a change; whether anybody watches the tag."""
        fitting = self._by_tag.get(tag)
        if fitting is None:
            fitting = self._by_tag[tag] = tuple(
                watched
                for pattern, watched in self._patterns.items()
                if names.matches(pattern, tag)
            )
        for watched in fitting:
            watched.changes += 1
        return bool(fitting)

    def is_masked(self, tag: str) -> bool:
        """Whether some of those who watch the tag, whose change was counted, are masked."""
        return any(watched.masked for watched in self._by_tag[tag])

    def changes(self, patterns: Iterable[str]) -> dict[str, int]:
        """Pattern to how many changes fitted it; all of them must be watched."""
        return {pattern: self._patterns[pattern].changes for pattern in patterns}
