"""What a client follows: the changes of watched tags, and the trace; each without a gap.

Both hold what has come until it is taken, bounded: of a tag that nobody takes changes
of, only the last is kept in the end, and the trace waits at the core.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Mapping
from typing import Any, Generic, TypeVar

import msgspec
from msgspec import Struct

from situ.blackboard import notices, replies, topics
from situ.blackboard.services import Carried
from situ.document import names
from situ.errors import Refused

T = TypeVar("T")

KEPT = 10_000
"""Changes or events held for who does not take them."""


class Feed(Generic[T]):
    """What has come and is to be taken, by its user or for ``callback``.

    ready: whether nothing that comes from here on is missed. asking: whether the core is being
    asked. ended: nothing comes any more. error: why the core refused it.
    """

    def __init__(self, callback: Callable[[T], None] | None, most: int | None = None) -> None:
        self.callback = callback
        self.ready = False
        self.asking = False
        self.ended = False
        self.error: Refused | None = None
        self._queue: deque[T] = deque(maxlen=most)

    def take(self) -> T | None:
        """The next one; None where there is none yet."""
        return self._queue.popleft() if self._queue else None

    def __len__(self) -> int:
        return len(self._queue)


class Change(Struct, frozen=True):
    """A watched tag as it now stands. value None: it was deleted. time: µs of the runtime.

    missed: how many changes of this tag since the last one told were passed over,
    because they came faster than they were taken, or while the connection was away.
    """

    tag: str
    value: Any
    version: int
    writer: str | None
    time: int
    missed: int = 0


class Watch(Feed[Change]):
    """The changes of what ``pattern`` fits, and ``known``: entry by tag, as last heard.

    ready: whether ``known`` is what the core has.
    """

    def __init__(self, pattern: str, callback: Callable[[Change], None] | None = None) -> None:
        super().__init__(callback)
        self.pattern = pattern
        self.known: dict[str, replies.Entry] = {}
        self._early: list[notices.Change] = []
        self._first = True
        self._seen = self._told = 0

    def fits(self, tag: str) -> bool:
        return names.matches(self.pattern, tag)

    def __repr__(self) -> str:
        return f"<Watch {self.pattern}, {len(self)} to be taken>"

    # -- for the dialog ------------------------------------------------------

    def change(self, notice: notices.Change) -> bool:
        """False where changes of this tag were lost: then a snapshot is needed."""
        if not self.ready:
            if self.asking:
                self._early.append(notice)
            return True
        before = self.known.get(notice.tag)
        last = before.version if before is not None else 0
        if notice.version <= last:
            return True
        if notice.version > last + 1:
            self.ready = False
            return False
        self._known(
            notice.tag,
            replies.Entry(notice.value, notice.version, notice.writer, notice.time),
        )
        self._seen += 1
        return True

    def snapshot(self, reply: replies.Snapshot) -> None:
        """Tells what differs from what was known, then what came meanwhile."""
        self.asking = False
        entries = {tag: entry for tag, entry in reply.entries.items() if self.fits(tag)}
        for tag in [tag for tag in self.known if tag not in entries]:
            # The core began anew and has never heard of it.
            if self.known[tag].value is not None:
                self._queue.append(Change(tag, None, 0, None, 0))
            del self.known[tag]
        for tag, entry in entries.items():
            if self._first and entry.value is None:
                self.known[tag] = entry
            elif self.known.get(tag) != entry:
                self._known(tag, entry)
        self._first = False
        self.ready = True
        self._seen = self._told = reply.changes.get(self.pattern, 0)
        early, self._early = self._early, []
        for notice in early:
            self.change(notice)

    def behind(self, changes: int) -> bool:
        """Whether one of the changes counted at the last heartbeat already never came."""
        late = self._told > self._seen
        self._told = changes
        return late

    def _known(self, tag: str, entry: replies.Entry) -> None:
        before = self.known.get(tag)
        # A version below the one before is of a core that began anew, and counts from there.
        last = before.version if before is not None else entry.version - 1
        missed = max(entry.version - 1 - (last if last <= entry.version else 0), 0)
        self.known[tag] = entry
        self._queue.append(
            Change(tag, entry.value, entry.version, entry.writer, entry.time, missed)
        )
        if len(self._queue) > KEPT + 2 * len(self.known):
            self._conflate()

    def _conflate(self) -> None:
        """Keeps the last change of each tag."""
        last: dict[str, Change] = {}
        for change in self._queue:
            before = last.pop(change.tag, None)
            missed = change.missed + (0 if before is None else before.missed + 1)
            last[change.tag] = msgspec.structs.replace(change, missed=missed)
        self._queue = deque(last.values())


class Messages(Feed[notices.Message]):
    """The messages whose topic ``pattern`` fits, from when ``ready`` on.

    What is sent while the connection is away is not heard; of more than ``KEPT`` that
    nobody takes the oldest are dropped.
    """

    def __init__(
        self, pattern: str, callback: Callable[[notices.Message], None] | None = None
    ) -> None:
        super().__init__(callback, most=KEPT)
        self.pattern = topics.one_line(pattern)

    def __repr__(self) -> str:
        return f"<Messages {self.pattern}, {len(self)} to be taken>"

    # -- for the dialog ------------------------------------------------------

    def hear(self, message: notices.Message) -> None:
        if names.matches(self.pattern, topics.one_line(message.topic)):
            self._queue.append(message)


class Effects(Feed[replies.Outstanding | Carried]):
    """What services are to carry out: first ``Outstanding``, all of it, then each effect.

    ``Outstanding`` comes again after every loss, of an effect or of the connection: what is in
    it may have been carried out already, what is not has ended.
    """

    def __init__(
        self,
        services: tuple[str, ...],
        http: str | None,
        callback: Callable[[replies.Outstanding | Carried], None] | None = None,
    ) -> None:
        super().__init__(callback)
        self.services = services
        self.http = http
        self._early: list[notices.Effect] = []
        self._next: dict[str, int] = {}
        self._told: dict[str, int] = {}

    # -- for the dialog ------------------------------------------------------

    def hear(self, notice: notices.Effect) -> bool:
        """False where effects before this one were lost: then all must be asked for."""
        if not self.ready:
            if self.asking:
                self._early.append(notice)
            return True
        awaited = self._next[notice.service]
        if notice.number < awaited:
            return True
        if notice.number > awaited:
            self.ready = False
            return False
        self._next[notice.service] = awaited + 1
        self._queue.append(notice.does)
        return True

    def stands(self, reply: replies.Outstanding) -> None:
        """The answer to ``perform``; what came meanwhile follows."""
        self.asking, self.ready = False, True
        self._next = dict(reply.next)
        self._told = {}
        # What waits is in it, or has ended.
        self._queue.clear()
        self._queue.append(reply)
        early, self._early = self._early, []
        for notice in early:
            self.hear(notice)

    def behind(self, effects: Mapping[str, int]) -> bool:
        """Whether one of those counted at the last heartbeat already never came."""
        late = any(self._next[service] <= told for service, told in self._told.items())
        self._told = dict(effects)
        return late


class TraceFeed(Feed[dict[str, Any]]):
    """Trace events as plain objects (formats.md, *Trace*, with ``time``), in order of seq.

    missed: how many the core no longer had when they were asked for. A seq that is not
    above the one before comes from a core that was started anew (``restarts`` counts).
    """

    def __init__(
        self, since: int | None, callback: Callable[[dict[str, Any]], None] | None = None
    ) -> None:
        super().__init__(callback)
        self.next = since
        # Asked for from there on, whenever that is.
        self.ready = since is not None
        self.missed = 0
        self.restarts = 0
        self._early: list[dict[str, Any]] = []
        self._told = 0

    def __repr__(self) -> str:
        return f"<TraceFeed from {self.next}, {len(self)} to be taken>"

    # -- for the dialog ------------------------------------------------------

    def add(self, lines: Iterable[msgspec.Raw]) -> bool:
        """False where events before these were lost: then a page is needed."""
        if self._full():
            return True
        events = [msgspec.json.decode(line) for line in lines]
        if self.next is None or self.asking:
            self._early += events
            return True
        return self._append(events)

    def page(self, reply: replies.Traced) -> bool:
        """True where the core has more."""
        if self.next is None:
            self.next = reply.next
            self.ready = True
        if reply.first > self.next:
            self.missed += reply.first - self.next
            self.next = reply.first
        self._append(msgspec.json.decode(line) for line in reply.events)
        self.next = max(self.next, reply.next)
        early, self._early = self._early, []
        complete = self._append(early)
        return self.next <= reply.last or not complete

    def behind(self, seq: int) -> bool:
        """Whether the event ``seq``, told at the last heartbeat already, never came."""
        late = self.next is not None and self._told >= self.next and not self._full()
        self._told = seq
        return late

    def lost(self) -> None:
        """What was asked for never comes; of what came meanwhile all that follows stands."""
        self.asking = False
        early, self._early = self._early, []
        if self.next is not None:
            self._append(early)

    def restart(self) -> None:
        """The core was started anew: its trace begins at 1."""
        self.next, self._told, self.asking, self.ready = 1, 0, False, True
        self._early.clear()
        self.restarts += 1

    def _append(self, events: Iterable[dict[str, Any]]) -> bool:
        assert self.next is not None
        for event in events:
            if event["seq"] > self.next:
                return False
            if event["seq"] == self.next:
                self._queue.append(event)
                self.next += 1
        return True

    def _full(self) -> bool:
        return len(self._queue) >= KEPT
