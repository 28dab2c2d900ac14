"""The blackboard's store: entries by tag, names that reach into values, who is told.

Seed 000, 5.3; formats.md, *Blackboard*. No clock: every write carries its time.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any

from msgspec import Struct

from situ.document import names
from situ.document.values import reach as reach


class Entry(Struct, gc=False):
    """value None: deleted; version then still counts on. time: µs of the last write.

    cause: seq of the trace event that tells of the write, or of what led to it.
    """

    value: Any
    version: int
    writer: str
    time: int
    cause: int | None


Listener = Callable[[str, int | None], None]


class Board:
    """One store. Listeners (by tag) hear the tags of a write after all of them are written."""

    def __init__(self) -> None:
        self.state: dict[str, Entry] = {}
        self.listeners: dict[str, list[Listener]] = {}

    def get(self, tag: str) -> Entry | None:
        """The entry at exactly ``tag``; None where there is none or it is deleted."""
        entry = self.state.get(tag)
        return None if entry is None or entry.value is None else entry

    def entries(self, pattern: str = "**") -> Iterator[tuple[str, Entry]]:
        """Every entry there is whose tag the pattern matches, in order of tag."""
        for tag in sorted(self.state):
            entry = self.state[tag]
            if entry.value is not None and names.matches(pattern, tag):
                yield tag, entry

    def look(self, name: str) -> Any:
        """The value of a name: a tag, or the longest tag that begins it, then fields."""
        entry = self.state.get(name)
        if entry is not None and entry.value is not None:
            return entry.value
        cut = name.rfind(".")
        while cut > 0:
            entry = self.state.get(name[:cut])
            if entry is not None and entry.value is not None:
                return reach(entry.value, name[cut + 1 :])
            cut = name.rfind(".", 0, cut)
        return None

    def last_set(self, name: str) -> Entry | None:
        """The entry that ``within`` counts from: the one that ``look`` reads, or a deleted one."""
        cut = len(name)
        while cut > 0:
            entry = self.state.get(name[:cut])
            if entry is not None and entry.value is not None:
                return entry
            cut = name.rfind(".", 0, cut)
        return self.state.get(name)

    def write(self, tag: str, value: Any, writer: str, time: int, cause: int | None) -> int:
        """Writes without telling anybody; gives the version, 0 where nothing changes (a
        missing tag deleted).
        """
        old = self.state.get(tag)
        if value is None and (old is None or old.value is None):
            return 0
        version = 1 if old is None else old.version + 1
        self.state[tag] = Entry(value, version, writer, time, cause)
        return version

    def listen(self, tags: Iterable[str], listener: Listener) -> None:
        """``listener(tag, cause)`` is called for each write of one of ``tags``, once a write."""
        for tag in dict.fromkeys(tags):
            self.listeners.setdefault(tag, []).append(listener)

    def tell(self, tag: str, cause: int | None) -> None:
        """Calls the listeners of a tag, once all that one write writes is written."""
        told = self.listeners.get(tag)
        if told is not None:
            for listener in told:
                listener(tag, cause)


def prefixes(name: str) -> list[str]:
    """Every tag that can begin a name, itself included: a.b.c -> a, a.b, a.b.c."""
    found = [name]
    cut = name.rfind(".")
    while cut > 0:
        found.append(name[:cut])
        cut = name.rfind(".", 0, cut)
    return found
