"""What one client follows, and how it stays without a gap over losses of every kind.

Changes and snapshots come on two connections that know nothing of each other's order.
So a snapshot is asked for only when an echo has come back over the one for notices: all
that was subscribed to before it is heard from then on. Whatever is lost later shows in a
version or seq that jumps, or at the next but one heartbeat.
"""

from __future__ import annotations

import secrets
from collections import deque
from collections.abc import Callable, Iterable
from typing import Any, Protocol, TypeVar

from situ.blackboard import notices, protocol, replies, topics
from situ.blackboard.calls import Call
from situ.blackboard.feeds import Change, Effects, Feed, Messages, TraceFeed, Watch
from situ.blackboard.services import Carried
from situ.blackboard.serving import Enter, Requests, ServiceRequest
from situ.errors import Refused

T = TypeVar("T")
F = TypeVar("F", bound=Feed[Any])
H = TypeVar("H", Watch, Messages, Effects, Requests)

PATIENCE = 4
"""Heartbeats for which an echo is waited for."""


class Talk(Protocol):
    """The part of a ``Dialog`` that asks."""

    connected: bool

    def next_id(self) -> int: ...

    def ask(self, request: protocol.Request, read: Callable[[Any], T], again: bool) -> Call[T]: ...


class Subscriptions:
    """Watches, messages, trace feeds, effects and requests of one client.

    topics: (topic, on or off), to be subscribed to in this order.
    """

    def __init__(self, talk: Talk, module: str | None = None) -> None:
        self.topics: deque[tuple[bytes, bool]] = deque()
        self.watches: list[Watch] = []
        self.messages: list[Messages] = []
        self.feeds: list[TraceFeed] = []
        self.effects: list[Effects] = []
        self.requests: list[Requests] = []
        self._talk = talk
        self._module = module
        # Nobody else may ask for the same echo: only the first would get it.
        self._token = secrets.token_hex(6)
        # Topic to who waits for it, the heartbeat at which it was asked for, and whether the
        # connection for notices stood already.
        self._echo: dict[bytes, tuple[list[_Heard], int, bool]] = {}
        self._beats = 0
        self._up = False
        self._by_tag: dict[str, tuple[Watch, ...]] = {}
        # The topics followed, and the beginnings of those that are heard masked.
        self._followed: dict[bytes, None] = {}
        self._masked: tuple[bytes, ...] = ()

    # -- for the dialog ------------------------------------------------------

    def hear(self, notice: notices.AnyNotice, frame: bytes) -> None:
        """A notice has come, in this frame."""
        if isinstance(notice, notices.Change):
            for watch in self.watching(notice.tag):
                if not watch.change(notice):
                    self._sync([watch])
        elif isinstance(notice, notices.Events):
            for feed in self.feeds:
                if not feed.add(notice.events):
                    self._fetch(feed)
        elif isinstance(notice, notices.Message):
            for messages in self.messages:
                messages.hear(notice)
        elif isinstance(notice, notices.Effect):
            for effects in self.effects:
                if not effects.hear(notice):
                    self._sync([effects])
        elif isinstance(notice, notices.Asked):
            self._look_again(notice.count)
        elif isinstance(notice, notices.Echo):
            self._echoed(frame[: frame.index(b"\n")])

    def mask(self, beginnings: tuple[bytes, ...]) -> None:
        """Of topics that begin so only what is not private is heard."""
        if beginnings == self._masked:
            return
        before = [self._heard_as(topic) for topic in self._followed]
        self._masked = beginnings
        for old, topic in zip(before, self._followed, strict=True):
            if (new := self._heard_as(topic)) != old:
                self.topics.extend(((old, False), (new, True)))

    def _heard_as(self, topic: bytes) -> bytes:
        return topics.MASKED + topic if topic.startswith(self._masked) else topic

    def _turn(self, topic: bytes, on: bool) -> None:
        """Begins to hear it, or ends to."""
        if on:
            self._followed[topic] = None
        else:
            self._followed.pop(topic, None)
        self.topics.append((self._heard_as(topic), on))

    def lost(self) -> None:
        """The session is lost: nothing is asked for any longer."""
        self.topics.extend((topic, False) for topic in self._echo)
        self._echo.clear()
        self._up = False
        for one in self._heard():
            one.ready = one.asking = False
        for feed in self.feeds:
            feed.lost()
        for requests in self.requests:
            requests.lost()

    def renewed(self, restarted: bool) -> None:
        """There is a new session, perhaps with a core that was started anew."""
        if restarted:
            for feed in self.feeds:
                feed.restart()
            for requests in self.requests:
                requests.restart()
        self._sync(self._heard())
        for feed in self.feeds:
            self._fetch(feed)

    def check(self, alive: replies.Alive) -> None:
        """What a heartbeat told: asks for what must have been lost."""
        self._beats += 1
        for topic, (asked, beat, _) in list(self._echo.items()):
            if self._beats > beat + PATIENCE:
                # It was lost, or came before anybody listened.
                del self._echo[topic]
                self.topics.append((topic, False))
                self._ask_echo(asked)
        lost: list[_Heard] = [
            w for w in self.watches if w.ready and w.behind(alive.changes.get(w.pattern, 0))
        ]
        lost += [e for e in self.effects if e.ready and e.behind(alive.effects or {})]
        self._sync([*lost, *(one for one in self._heard() if not one.ready)])
        for feed in self.feeds:
            if feed.behind(alive.seq):
                self._fetch(feed)
        self._look_again(alive.asked or 0)

    def watching(self, tag: str) -> tuple[Watch, ...]:
        """The watches that the tag fits."""
        found = self._by_tag.get(tag)
        if found is None:
            found = self._by_tag[tag] = tuple(w for w in self.watches if w.fits(tag))
        return found

    # -- watches -------------------------------------------------------------

    def watch(self, pattern: str, callback: Callable[[Change], None] | None = None) -> Watch:
        """What stands there, then every change; kept up over losses of the connection."""
        new = all(one.pattern != pattern for one in self.watches)
        topic = topics.changes(pattern)
        watch = self._follow(Watch(pattern, callback), self.watches, [topic] if new else [])
        # Last: another thread may look in the meantime (``Dialog.known``).
        self._by_tag.clear()
        return watch

    def unwatch(self, watch: Watch) -> None:
        """No more of it is heard; asking twice is no fault."""
        if not _leave(watch, self.watches):
            return
        self._by_tag.clear()
        if any(one.pattern == watch.pattern for one in self.watches):
            return
        self._turn(topics.changes(watch.pattern), False)
        if self._talk.connected:
            request = protocol.Unwatch(id=self._talk.next_id(), patterns=(watch.pattern,))
            self._talk.ask(request, _nothing, again=False)

    def _follow(self, one: H, among: list[H], new: Iterable[bytes]) -> H:
        """new: topics that nobody needed before it."""
        for topic in new:
            self._turn(topic, True)
        among.append(one)
        if self._talk.connected:
            self._sync([one])
        return one

    def _heard(self) -> list[_Heard]:
        return [*self.watches, *self.messages, *self.effects, *self.requests]

    def _sync(self, feeds: Iterable[_Heard]) -> None:
        """Asks for snapshots, when it is sure that changes are heard by then."""
        asked = [one for one in feeds if not one.asking]
        if not asked:
            return
        for one in asked:
            one.ready, one.asking = False, True
        self._ask_echo(asked)

    def _ask_echo(self, asked: list[_Heard]) -> None:
        topic = topics.ECHO + f"{self._token}:{self._talk.next_id()}".encode()
        self._echo[topic] = asked, self._beats, self._up
        self.topics.append((topic, True))

    def _echoed(self, topic: bytes) -> None:
        if topic not in self._echo or not self._talk.connected:
            return
        asked, _, certain = self._echo.pop(topic)
        self.topics.append((topic, False))
        if not certain:
            # Topics subscribed to before the connection stood arrive in any order, those
            # after in theirs: only an echo of the second kind tells of those before it.
            self._up = True
            self._ask_echo(asked)
            return
        for one in asked:
            if isinstance(one, Messages):
                # Nothing stands anywhere that could be asked for.
                one.ready, one.asking = True, False
        watches = [one for one in asked if isinstance(one, Watch)]
        if any(not watch.ended for watch in watches):
            self._ask_snapshot(watches)
        for one in asked:
            # Last: how something is carried out may depend on what is watched.
            if isinstance(one, Effects):
                self._ask_outstanding(one)
            elif isinstance(one, Requests):
                self._ask_questions(one)

    def _ask_snapshot(self, watches: list[Watch]) -> None:
        patterns = tuple(dict.fromkeys(w.pattern for w in watches if not w.ended))

        def read(reply: replies.Snapshot) -> None:
            for watch in watches:
                watch.snapshot(reply)

        request = protocol.Watch(id=self._talk.next_id(), patterns=patterns)
        call = self._talk.ask(request, read, again=False)
        call.then(lambda: _failed(watches, call))

    # -- messages ------------------------------------------------------------

    def listen(
        self, pattern: str, callback: Callable[[notices.Message], None] | None = None
    ) -> Messages:
        """Messages of applications from when ``ready``; kept up over losses of the connection,
        in which those that are sent meanwhile are lost."""
        messages = Messages(pattern, callback)
        new = all(one.pattern != messages.pattern for one in self.messages)
        topic = topics.messages(messages.pattern)
        return self._follow(messages, self.messages, [topic] if new else [])

    def unlisten(self, messages: Messages) -> None:
        """No more of them is heard; asking twice is no fault."""
        if not _leave(messages, self.messages):
            return
        if all(one.pattern != messages.pattern for one in self.messages):
            self._turn(topics.messages(messages.pattern), False)

    # -- effects -------------------------------------------------------------

    def perform(
        self,
        services: Iterable[str],
        http: str | None,
        callback: Callable[[replies.Outstanding | Carried], None] | None = None,
    ) -> Effects:
        """What these services (those told in hello) are to carry out, from now on."""
        effects = Effects(tuple(services), http, callback)
        return self._follow(effects, self.effects, map(topics.effect, effects.services))

    def _ask_outstanding(self, effects: Effects) -> None:
        request = protocol.Perform(id=self._talk.next_id(), http=effects.http)
        call = self._talk.ask(request, effects.stands, again=False)
        call.then(lambda: _failed([effects], call))

    # -- requests ------------------------------------------------------------

    def serve(
        self,
        names: tuple[str, ...],
        callback: Callable[[ServiceRequest], None] | None = None,
        enter: Enter = lambda do: do(),
    ) -> Requests:
        """What applications ask of this module by these names, from now on."""
        requests = Requests(names, callback, self._answer, enter)
        new = [topics.asked(self._module)] if self._module is not None else []
        return self._follow(requests, self.requests, [] if self.requests else new)

    def unserve(self, requests: Requests) -> None:
        """No more of them are answered; asking twice is no fault."""
        if not _leave(requests, self.requests):
            return
        if self._talk.connected:
            self._ask_questions(requests)
        if not self.requests and self._module is not None:
            self._turn(topics.asked(self._module), False)

    def _look_again(self, count: int) -> None:
        for requests in self.requests:
            if not requests.hear(count) and not requests.asking:
                self._ask_questions(requests)

    def _ask_questions(self, requests: Requests) -> None:
        requests.asking = True
        names = tuple(dict.fromkeys(name for one in self.requests for name in one.names))

        def read(reply: replies.Questions) -> None:
            if not requests.stands(reply) and not requests.ended:
                self._ask_questions(requests)

        request = protocol.Serve(id=self._talk.next_id(), requests=names)
        call = self._talk.ask(request, read, again=False)
        call.then(lambda: _failed([requests], call))

    def _answer(self, made: Callable[[int], protocol.Answer]) -> Call[None] | None:
        if not self._talk.connected:
            return None
        return self._talk.ask(made(self._talk.next_id()), _nothing, again=False)

    # -- trace ---------------------------------------------------------------

    def trace(
        self,
        since: int | None = None,
        callback: Callable[[dict[str, Any]], None] | None = None,
    ) -> TraceFeed:
        """Trace events from seq ``since`` on (None: from now), without a gap."""
        feed = TraceFeed(since, callback)
        if not self.feeds:
            self._turn(topics.TRACE, True)
        self.feeds.append(feed)
        if self._talk.connected:
            self._fetch(feed)
        return feed

    def untrace(self, feed: TraceFeed) -> None:
        if _leave(feed, self.feeds) and not self.feeds:
            self._turn(topics.TRACE, False)

    def _fetch(self, feed: TraceFeed) -> None:
        if feed.asking or feed.ended or not self._talk.connected:
            return
        feed.asking = True

        def read(reply: replies.Traced) -> None:
            feed.asking = False
            if feed.page(reply):
                self._fetch(feed)

        request = protocol.Trace(id=self._talk.next_id(), since=feed.next)
        call = self._talk.ask(request, read, again=False)
        call.then(lambda: _failed([feed], call))


_Heard = Watch | Messages | Effects | Requests
"""What an echo is waited for."""


def _leave(one: F, among: list[F]) -> bool:
    """Whether it was followed until now."""
    one.ended = True
    if one not in among:
        return False
    among.remove(one)
    return True


def _failed(feeds: Iterable[Feed[Any]], call: Call[None]) -> None:
    """Where it is: they ask no longer, and know why where they were refused."""
    if call.error is None:
        return
    for one in feeds:
        one.asking = False
        if isinstance(call.error, Refused):
            one.error = call.error


def _nothing(reply: replies.Done) -> None:
    return None
