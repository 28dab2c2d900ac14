"""The client that blocks where it waits, and calls back from a thread (see ``client``)."""

from __future__ import annotations

import contextlib
import logging
import select
import socket
import threading
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any, Generic, Protocol, TypeVar

from situ.blackboard.calls import Call, which
from situ.blackboard.dialog import Dialog
from situ.blackboard.feeds import Change, Messages, TraceFeed, Watch
from situ.blackboard.link import Link
from situ.blackboard.protocol import (
    Addresses,
    Entry,
    Files,
    Message,
    ModuleStates,
    Need,
    Offer,
)
from situ.errors import BlackboardError, Refused, Unreachable

T = TypeVar("T")
T_co = TypeVar("T_co", covariant=True)

PATIENCE = 5.0
"""Seconds that a request waits for its answer."""
PARKED = 0.05
"""Seconds for which the background leaves the sockets to a caller that used them last."""

_log = logging.getLogger("situ.blackboard")


class Board:
    """The blackboard, blocking; every method may be called from any thread.

    A thread in the background keeps the session alive and calls callbacks. Whoever waits
    for an answer reads the sockets himself, so that no answer passes through two threads.
    """

    def __init__(self, link: Link, timeout: float = PATIENCE) -> None:
        self._link = link
        self._dialog = link.dialog
        self._timeout = timeout
        self._lock = threading.Lock()
        self._news = threading.Condition(self._lock)
        self._parked = threading.Condition(self._lock)
        self._driving = False
        self._waiters = 0
        self._closed = False
        self._wakers = socket.socketpair()
        for waker in self._wakers:
            waker.setblocking(False)
        self._poller = select.poll()
        for descriptor in (*link.descriptors(), self._wakers[0].fileno()):
            self._poller.register(descriptor, select.POLLIN)
        self._thread = threading.Thread(target=self._keep, name="situ blackboard", daemon=True)
        try:
            dialog = self._dialog
            self._until(lambda: dialog.connected or dialog.ended, timeout)
            if dialog.problem is not None and not dialog.connected:
                raise dialog.problem
            if not dialog.connected:
                raise self._unreachable(dialog.unreachable())
        except BaseException:
            self._shut()
            raise
        self._thread.start()

    # -- what stands on the board --------------------------------------------

    def set(
        self,
        tag: str | Mapping[str, Any],
        value: Any = None,
        *,
        versions: Mapping[str, int] | None = None,
    ) -> dict[str, int]:
        """Writes one tag, or all of a mapping at once; None deletes. Gives the new versions.

        versions: nothing is written unless each of these tags is at that version (0: is
        missing); else Refused. Values are JSON values.
        """
        tags = tag if isinstance(tag, Mapping) else {tag: value}
        return self._ask(lambda dialog: dialog.set(tags, versions))

    def get(self, name: str) -> Any:
        """The value of a tag, or of a name that reaches into one; None where it is missing.

        A tag that is watched is not asked for: it is as last heard.
        """
        entry = self._dialog.known(name)
        if entry is not None:
            return entry.value
        return self._ask(lambda dialog: dialog.get(name))

    def entries(self, *names: str) -> dict[str, Entry]:
        """The entries of tags and patterns, with version, writer and time."""
        return self._ask(lambda dialog: dialog.entries(names))

    def watch(
        self, pattern: str, callback: Callable[[Change], None] | None = None
    ) -> Following[Change]:
        """What stands there now, then every change, in order; ends with the board.

        Without ``callback`` to be iterated over; with it, it is called for each change
        from a thread in the background, one at a time.
        """
        with self._lock:
            watch = self._dialog.watch(pattern, callback)
        changes = Following[Change](self, watch, self._dialog.unwatch)
        self._expect(changes, lambda: watch.ready or watch.error is not None)
        if watch.error is not None:
            changes.close()
            raise watch.error
        return changes

    def trace(
        self, since: int | None = None, callback: Callable[[dict[str, Any]], None] | None = None
    ) -> Following[dict[str, Any]]:
        """Trace events from seq ``since`` on (None: from now), as plain objects; as ``watch``."""
        with self._lock:
            feed = self._dialog.trace(since, callback)
        events = Following[dict[str, Any]](self, feed, self._dialog.untrace)
        self._expect(events, lambda: feed.next is not None)
        return events

    # -- what happens --------------------------------------------------------

    def messages(
        self, pattern: str, callback: Callable[[Message], None] | None = None
    ) -> Following[Message]:
        """The messages that applications send (``topic``, ``value``, ``application``) from here
        on; as ``watch``, but not without a gap.

        pattern: of topics, ``*`` for one part between slashes, ``**`` for any number. What is
        sent while the connection is away is lost: what must arrive stands at a tag.
        """
        with self._lock:
            heard = self._dialog.messages(pattern, callback)
        messages = Following[Message](self, heard, self._dialog.unlisten)
        self._expect(messages, lambda: heard.ready)
        return messages

    def publish(self, event: str, application: str | None = None) -> None:
        """An event for an application, or (None) for every one."""
        self._ask(lambda dialog: dialog.publish(event, application))

    def use(self, component: str, *value: Any) -> None:
        """What a person does to a component of the screen shown; no value for a button."""
        self._ask(lambda dialog: dialog.use(component, *value))

    def touch(self) -> None:
        """A touch on no component."""
        self._ask(lambda dialog: dialog.touch())

    def authority(self, *resources: str, optional: Iterable[str] = ()) -> Authority:
        """Asks for resources for the time of a ``with``; see ``Authority``."""
        return Authority(self, resources, tuple(optional))

    # -- who and what is there -----------------------------------------------

    def modules(self) -> ModuleStates:
        """Declared and connected modules, and what is wanted."""
        return self._ask(lambda dialog: dialog.modules())

    def documents(self) -> Files:
        """The project's files as the robot runs them."""
        return self._ask(lambda dialog: dialog.documents())

    def disclose(
        self,
        description: str = "",
        requires: Iterable[Need] = (),
        provides: Iterable[Offer] = (),
    ) -> None:
        """Tells what this module requires and provides, if ``connect`` did not."""
        self._ask(lambda dialog: dialog.disclose(description, requires, provides))

    @property
    def connected(self) -> bool:
        """Whether the core is there; it comes back by itself."""
        return self._dialog.connected

    @property
    def addresses(self) -> Addresses:
        """As the core announced them: ``requests``, ``notifications`` and ``http``."""
        assert self._dialog.welcome is not None
        return self._dialog.welcome.addresses

    def close(self) -> None:
        """Ends the session at once: what the module held passes on. May be called twice."""
        if self._closed:
            return
        with contextlib.suppress(BlackboardError):
            if self._dialog.connected:
                self._ask(lambda dialog: dialog.bye(), patience=1.0)
        self._shut()

    def __enter__(self) -> Board:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    # -- waiting -------------------------------------------------------------

    def _ask(self, begin: Callable[[Dialog], Call[T]], patience: float | None = None) -> T:
        with self._lock:
            if self._closed:
                raise Unreachable("the connection is closed")
            call = begin(self._dialog)
        if not self._until(lambda: call.finished, patience or self._timeout):
            with self._lock:
                self._dialog.lost(call)
        if isinstance(call.error, Unreachable):
            raise self._unreachable(call.error)
        return call.result()

    def _expect(self, following: Following[Any], ready: Callable[[], bool]) -> None:
        if not self._until(ready, self._timeout):
            following.close()
            raise self._unreachable(self._dialog.unreachable())

    def _unreachable(self, error: Unreachable) -> Unreachable:
        return Unreachable(f"{self._link.endpoint}: {error}")

    def _until(self, ready: Callable[[], bool], timeout: float | None) -> bool:
        """Waits until ``ready()``, driving the link; False when ``timeout`` seconds are over."""
        end = None if timeout is None else time.monotonic() + timeout
        with self._lock:
            self._waiters += 1
            try:
                while True:
                    self._turn()
                    if ready():
                        return True
                    if self._closed or (end is not None and time.monotonic() >= end):
                        return False
                    self._rest(end)
            finally:
                self._waiters -= 1

    def _turn(self) -> None:
        """Drives the link one turn, with the lock; wakes those for whom there is news."""
        if self._closed:
            return
        self._link.turn()
        if self._waiters > 1:
            self._news.notify_all()
        if self._calling() and threading.current_thread() is not self._thread:
            self._parked.notify()
            if self._driving:
                self._wake()

    def _rest(self, end: float | None) -> None:
        """Until something may have come: one thread waits on the sockets, others on it."""
        until = self._link.due() if end is None else min(end, self._link.due())
        left = max(until - time.monotonic(), 0)
        if self._driving:
            self._news.wait(left)
            return
        self._driving = True
        self._lock.release()
        try:
            self._poll(left)
        finally:
            self._lock.acquire()
            self._driving = False
            # The seat is free: who else waits must take it or would miss the next news.
            self._news.notify_all()

    def _poll(self, seconds: float) -> None:
        # The sockets themselves are never touched here, only the descriptors they gave.
        for descriptor, _ in self._poller.poll(seconds * 1000):
            if descriptor == self._wakers[0].fileno():
                with contextlib.suppress(BlockingIOError):
                    self._wakers[0].recv(4096)

    def _wake(self) -> None:
        """The thread that waits on the sockets looks about."""
        with contextlib.suppress(BlockingIOError, OSError):
            self._wakers[1].send(b"\0")

    def _calling(self) -> list[Watch | Messages | TraceFeed]:
        """What has something for its callback."""
        return [one for one in self._dialog.following() if one.callback is not None and len(one)]

    def _keep(self) -> None:
        """The background: keeps the session, and tells callbacks."""
        while True:
            told: list[tuple[Callable[[Any], None], Any]] = []
            with self._lock:
                if self._closed:
                    return
                if self._waiters:
                    # A caller drives, and likely will again at once.
                    self._parked.wait(PARKED)
                else:
                    self._turn()
                    if not self._calling():
                        self._rest(None)
                for one in self._calling():
                    assert one.callback is not None
                    while (item := one.take()) is not None:
                        told.append((one.callback, item))
            for callback, item in told:
                try:
                    callback(item)
                except Exception:
                    _log.exception("a callback failed")

    def _shut(self) -> None:
        with self._lock:
            self._closed = True
            self._dialog.ended = True
            self._wake()
            self._news.notify_all()
            self._parked.notify_all()
        if self._thread.is_alive() and self._thread is not threading.current_thread():
            self._thread.join()
        with self._lock:
            # Nobody may wait on descriptors that are closed.
            self._news.wait_for(lambda: not self._driving, 1.0)
            self._link.close()
        for waker in self._wakers:
            waker.close()


class Followed(Protocol[T_co]):
    """A ``Watch``, ``Messages`` or a ``TraceFeed``."""

    ended: bool

    def take(self) -> T_co | None: ...

    def __len__(self) -> int: ...


class Following(Generic[T]):
    """What comes, one after the other: iterate over it, or ``close`` it where it calls back."""

    def __init__(self, board: Board, feed: Any, stop: Callable[[Any], None]) -> None:
        self._board = board
        self._feed: Followed[T] = feed
        self._stop = stop

    def next(self, within: float | None = None) -> T | None:
        """The next one; None when ``within`` seconds are over (None: waits for ever), or
        it or the board was closed."""
        feed = self._feed
        if not len(feed):
            self._board._until(lambda: len(feed) > 0 or feed.ended, within)
        with self._board._lock:
            return feed.take()

    def __iter__(self) -> Iterator[T]:
        while (item := self.next()) is not None:
            yield item

    def close(self) -> None:
        """Nothing more comes."""
        with self._board._lock:
            self._stop(self._feed)
        self._board._wake()

    def __enter__(self) -> Following[T]:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


class Authority:
    """A request for resources: from entering the ``with`` until leaving it.

    Authority comes and goes with situations and priorities, without asking again; what
    is commanded moves the robot only while it is held.
    """

    def __init__(self, board: Board, resources: tuple[str, ...], optional: tuple[str, ...]) -> None:
        self._board = board
        self.resources = resources
        self.optional = optional

    def __enter__(self) -> Authority:
        try:
            self._board._ask(lambda d: d.acquire(self, self.resources, self.optional))
        except Refused:
            self._board._dialog.withdraw(self)
            raise
        return self

    def __exit__(self, *_: object) -> None:
        with contextlib.suppress(BlackboardError):
            self._board._ask(lambda d: d.abandon(self))

    @property
    def held(self) -> bool:
        """Whether the module holds all of these resources (the optional ones aside) now."""
        return self._board._dialog.holds.issuperset(self.resources)

    def wait(self, within: float | None = None) -> bool:
        """Waits until it is held; False when ``within`` seconds are over before."""
        return self._board._until(lambda: self.held, within)

    def wait_lost(self, within: float | None = None) -> bool:
        """Waits until it is not held; False when ``within`` seconds are over before."""
        return self._board._until(lambda: not self.held, within)

    def command(self, value: Any, valid: float | None = None, resource: str | None = None) -> None:
        """Commands a resource. valid: seconds it is good for; None: until it is lost.

        While the connection is away nothing is commanded, now or later, and nothing
        raised: authority is lost with it (``held``) and comes back by itself.
        resource: which one; may be left out where only one was asked for.
        """
        self._board._ask(
            lambda d: d.command(which((*self.resources, *self.optional), resource), value, valid)
        )
