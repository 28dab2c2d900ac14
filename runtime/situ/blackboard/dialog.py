"""The client's half of the protocol, without sockets, threads or a clock.

Messages of the core come in with the time (seconds, any monotonic clock), frames and
topics to subscribe to go out. It keeps the session alive, takes it up again after a
loss, and asks anew for all that was watched, requested and traced. Every driver
(blocking, asyncio, Qt) is a few lines round it.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Mapping
from typing import Any, Generic, TypeVar

from msgspec import Struct

from situ.blackboard import protocol
from situ.blackboard.feeds import TraceFeed, Watch
from situ.blackboard.protocol import HEARTBEAT, LEASE, Malformed, Request
from situ.errors import BlackboardError, Refused, Unreachable

T = TypeVar("T")


class Person(Struct, frozen=True, kw_only=True):
    """Who a client is; as in ``protocol.Hello``."""

    role: protocol.Role
    module: str | None = None
    user: str | None = None
    resources: tuple[str, ...] = ()
    description: str = ""
    requires: tuple[protocol.Need, ...] = ()
    provides: tuple[protocol.Offer, ...] = ()


class Call(Generic[T]):
    """One request and, later, what came of it: then ``done`` is called once.

    again: whether it may be asked once more when the connection was lost before an
    answer came, because twice is as good as once.
    """

    def __init__(self, request: Request, read: Callable[[Any], T], again: bool) -> None:
        self.request = request
        self.again = again
        self.finished = False
        self.error: BlackboardError | None = None
        self.done: Callable[[], None] | None = None
        self._read = read
        self._value: T | None = None

    def result(self) -> T:
        """Raises what went wrong: ``Refused``, or ``Unreachable`` where nobody answered."""
        if self.error is not None:
            raise self.error
        assert self.finished, "not answered yet"
        return self._value  # type: ignore[return-value]

    def answer(self, reply: protocol.AnyReply) -> None:
        if isinstance(reply, protocol.Refused):
            self.fail(Refused(reply.message))
            return
        try:
            self._value = self._read(reply)
        except (AttributeError, TypeError, KeyError):
            self.fail(BlackboardError(f"the blackboard answered {type(reply).__name__}"))
            return
        self._end()

    def fail(self, error: BlackboardError) -> None:
        self.error = error
        self._end()

    def _end(self) -> None:
        if not self.finished:
            self.finished = True
            if self.done is not None:
                self.done()


class Dialog:
    """One client's session, watches, requests for authority and trace.

    For its driver: ``receive``, ``hear``, ``tick`` and ``due`` by the clock; ``outgoing``
    (bodies to send), ``subscribing`` ((topic, on or off), in order) and ``notifications``
    (the address to subscribe at, None before it is known) after each of them.

    For its user: ``connected``; ``welcome`` (the core's last greeting); ``changed`` is
    called when either changes; the requests, each a ``Call``; ``watch`` and ``trace``.
    ``problem`` says why there is no session, where the core told.
    """

    def __init__(self, person: Person) -> None:
        self.person = person
        self.connected = False
        self.ended = False
        self.welcome: protocol.Welcome | None = None
        self.problem: Refused | None = None
        self.notifications: str | None = None
        self.outgoing: deque[bytes] = deque()
        self.subscribing: deque[tuple[bytes, bool]] = deque()
        self.changed: Callable[[], None] | None = None
        self.holds: frozenset[str] = frozenset()
        self.watches: list[Watch] = []
        self.feeds: list[TraceFeed] = []
        self._ids = 0
        self._hello = 0
        self._calls: dict[int, Call[Any]] = {}
        self._waiting: list[Call[Any]] = []
        self._heard = float("-inf")
        self._next = float("-inf")
        self._turned: float | None = None
        self._holds_seq = 0
        self._asked: dict[object, tuple[tuple[str, ...], tuple[str, ...]]] = {}
        self._echo: dict[bytes, list[Watch]] = {}
        self._up = False
        self._by_tag: dict[str, tuple[Watch, ...]] = {}
        self.subscribing.append((protocol.END, True))
        for resource in person.resources:
            self.subscribing.append((protocol.authority_topic(resource), True))

    # -- for its driver ------------------------------------------------------

    def due(self) -> float:
        """When ``tick`` is to be called next; in the past before the first time."""
        return self._next

    def tick(self, now: float) -> None:
        """Says that we live; says hello while there is no session."""
        if self.connected and now >= self._heard + LEASE:
            self._lose()
        if now < self._next:
            return
        self._next = now + HEARTBEAT
        if self.ended:
            return
        if self.connected:
            self._call(protocol.Heartbeat(id=self._id()), self._alive, again=False)
        else:
            self._say_hello()

    def receive(self, body: bytes, now: float) -> None:
        """A reply. Anything that is none is passed over."""
        try:
            reply = protocol.read_reply(body)
        except Malformed:
            return
        self._heard = now
        if isinstance(reply, protocol.Welcome):
            if reply.id == self._hello and not self.connected:
                self._welcomed(reply, now)
            return
        if reply.id == self._hello and isinstance(reply, protocol.Refused):
            self._turned_away(reply, now)
            return
        call = self._calls.pop(reply.id, None) if reply.id is not None else None
        if call is None:
            return
        if isinstance(reply, protocol.Refused) and reply.code == "session":
            # It was not done, so it may be asked once more in the next session.
            if not isinstance(call.request, (protocol.Heartbeat, protocol.Bye)):
                self._waiting.append(call)
            if self.connected:
                self._lose()
            self._next = now
            return
        call.answer(reply)

    def hear(self, frame: bytes, now: float) -> None:
        """A notice, with its topic. Anything that is none is passed over."""
        try:
            notice = protocol.read_notice(frame)
        except (Malformed, ValueError):
            return
        if isinstance(notice, protocol.Change):
            for watch in self._watching(notice.tag):
                if not watch.change(notice):
                    self._sync([watch])
        elif isinstance(notice, protocol.Events):
            for feed in self.feeds:
                if not feed.add(notice.events):
                    self._fetch(feed)
        elif isinstance(notice, protocol.Authority):
            if notice.seq > self._holds_seq:
                passed = {notice.resource}
                mine = notice.to is not None and notice.to == self.person.module
                self._hold(self.holds | passed if mine else self.holds - passed, notice.seq)
        elif isinstance(notice, protocol.Echo):
            self._echoed(frame[: frame.index(b"\n")])
        elif isinstance(notice, protocol.End) and self.connected:
            self._lose()

    def lost(self, call: Call[Any]) -> None:
        """Its user waits no longer: the call fails, a later answer is passed over."""
        self._calls.pop(call.request.id, None)
        if call in self._waiting:
            self._waiting.remove(call)
        call.fail(self.unreachable())

    def unreachable(self) -> Unreachable:
        """Why nothing is answered, in one line; who knows the address puts it before."""
        if self.problem is not None:
            return Unreachable(str(self.problem))
        return Unreachable("nobody answers; is situ run going there?")

    def settled(self) -> bool:
        """Whether all that was watched and traced stands as the core has it."""
        return self.connected and all(w.ready for w in self.watches) and not self._echo

    # -- the session ---------------------------------------------------------

    def _id(self) -> int:
        self._ids += 1
        return self._ids

    def _say_hello(self) -> None:
        self._hello = self._id()
        who = self.person
        hello = protocol.Hello(
            id=self._hello,
            version=protocol.VERSION,
            role=who.role,
            module=who.module,
            user=who.user,
            resources=who.resources,
            description=who.description,
            requires=who.requires,
            provides=who.provides,
            session=self.welcome.session if self.welcome is not None else None,
        )
        # What could not be sent in the meantime is stale; this hello goes for it.
        self.outgoing.clear()
        self.outgoing.append(protocol.encode(hello))

    def _welcomed(self, welcome: protocol.Welcome, now: float) -> None:
        restarted = self.welcome is not None and self.welcome.runtime != welcome.runtime
        self.welcome, self.problem, self._turned = welcome, None, None
        self.connected = True
        self.notifications = welcome.addresses.notifications
        self._next = now + HEARTBEAT
        if not welcome.resumed:
            self._hold(frozenset(), 0)
        if restarted:
            for feed in self.feeds:
                feed.restart()
        waiting, self._waiting = self._waiting, []
        if not welcome.resumed:
            self._request_again()
            self._sync(self.watches)
            for feed in self.feeds:
                self._fetch(feed)
        for call in waiting:
            self._send(call)
        self._tell()

    def _turned_away(self, refused: protocol.Refused, now: float) -> None:
        self.problem = Refused(refused.message)
        if self._turned is None:
            self._turned = now
        # A module that died may still hold its name until its lease ends. Once let in,
        # we come back by ourselves however long it takes.
        patient = refused.code == "name" and now < self._turned + LEASE + HEARTBEAT
        if self.welcome is None and not patient:
            self.ended = True
            for call in (*self._calls.values(), *self._waiting):
                call.fail(self.problem)
            self._calls.clear()
            self._waiting.clear()
        self._tell()

    def _lose(self) -> None:
        self.connected = False
        calls, self._calls = self._calls, {}
        for call in calls.values():
            if isinstance(call.request, protocol.Heartbeat):
                continue
            if call.again:
                self._waiting.append(call)
            else:
                what = call.request.__struct_config__.tag
                call.fail(
                    Unreachable(f"the connection was lost; whether {what} was done is not known")
                )
        self.outgoing.clear()
        self.subscribing.extend((topic, False) for topic in self._echo)
        self._echo.clear()
        self._up = False
        for watch in self.watches:
            watch.ready = watch.asking = False
        for feed in self.feeds:
            feed.asking = False
        self._hold(frozenset(), 0)
        self._tell()

    def _alive(self, alive: protocol.Alive) -> None:
        if self.person.module is not None and alive.seq >= self._holds_seq:
            self._hold(frozenset(alive.holds), alive.seq)
        stale = [w for w in self.watches if w.ready and w.behind(alive.changes.get(w.pattern, 0))]
        self._sync([*stale, *(w for w in self.watches if not w.ready and not w.asking)])
        for feed in self.feeds:
            if feed.behind(alive.seq):
                self._fetch(feed)

    def _tell(self) -> None:
        if self.changed is not None:
            self.changed()

    def _hold(self, holds: frozenset[str], seq: int) -> None:
        self._holds_seq = seq
        if holds != self.holds:
            self.holds = holds
            self._tell()

    # -- requests ------------------------------------------------------------

    def _call(self, request: Request, read: Callable[[Any], T], again: bool) -> Call[T]:
        call = Call(request, read, again)
        if self.ended:
            call.fail(self.problem or Unreachable("the connection is closed"))
        elif self.connected:
            self._send(call)
        else:
            self._waiting.append(call)
        return call

    def _send(self, call: Call[Any]) -> None:
        try:
            body = protocol.encode(call.request)
        except (TypeError, ValueError, OverflowError, RecursionError) as error:
            call.fail(BlackboardError(f"no JSON value: {error}"))
            return
        self._calls[call.request.id] = call
        self.outgoing.append(body)

    def set(
        self, tags: Mapping[str, Any], versions: Mapping[str, int] | None = None
    ) -> Call[dict[str, int]]:
        """One write; gives the new version of each tag that changed."""
        wanted = None if versions is None else dict(versions)
        request = protocol.Set(id=self._id(), tags=dict(tags), versions=wanted)
        return self._call(request, _versions, again=False)

    def get(self, name: str) -> Call[Any]:
        """The value of a tag or of a name that reaches into one; None where it is missing."""
        request = protocol.Get(id=self._id(), names=(name,))
        return self._call(request, lambda reply: reply.entries[name].value, again=True)

    def entries(self, names: Iterable[str]) -> Call[dict[str, protocol.Entry]]:
        """Entries of names and patterns, with version, writer and time."""
        request = protocol.Get(id=self._id(), names=tuple(names))
        return self._call(request, _entries, again=True)

    def known(self, name: str) -> protocol.Entry | None:
        """The entry at a watched tag as last heard, without asking; None: ask."""
        if not self.connected:
            return None
        for watch in self._watching(name):
            if watch.ready and (entry := watch.known.get(name)) is not None:
                return entry
        return None

    def publish(self, event: str, application: str | None = None) -> Call[None]:
        request = protocol.Publish(id=self._id(), event=event, application=application)
        return self._call(request, _nothing, again=False)

    def command(self, resource: str, value: Any, valid: float | None = None) -> Call[None]:
        request = protocol.Command(id=self._id(), resource=resource, value=value, valid=valid)
        return self._call(request, _nothing, again=False)

    def use(self, component: str, *value: Any) -> Call[None]:
        """What a person does to a component; the value is left out for a button."""
        request = (
            protocol.Use(id=self._id(), component=component, value=value[0])
            if value
            else protocol.Use(id=self._id(), component=component)
        )
        return self._call(request, _nothing, again=False)

    def touch(self) -> Call[None]:
        return self._call(protocol.Touch(id=self._id()), _nothing, again=False)

    def documents(self) -> Call[protocol.Files]:
        return self._call(protocol.Documents(id=self._id()), _same, again=True)

    def modules(self) -> Call[protocol.ModuleStates]:
        return self._call(protocol.Modules(id=self._id()), _same, again=True)

    def disclose(
        self,
        description: str,
        requires: Iterable[protocol.Need],
        provides: Iterable[protocol.Offer],
    ) -> Call[None]:
        """Tells what the module requires and provides; told again after a reconnect."""
        request = protocol.Disclose(
            id=self._id(),
            description=description,
            requires=tuple(requires),
            provides=tuple(provides),
        )
        who = self.person
        self.person = Person(
            role=who.role,
            module=who.module,
            user=who.user,
            resources=who.resources,
            description=description or who.description,
            requires=request.requires,
            provides=request.provides,
        )
        return self._call(request, _nothing, again=True)

    def give(self, request: Callable[[int], Request]) -> Call[protocol.AnyReply]:
        """Any other request, made with the id that it must carry."""
        return self._call(request(self._id()), _same, again=False)

    def bye(self) -> Call[None]:
        """Ends the session at once; nothing can be asked any longer."""
        call = self._call(protocol.Bye(id=self._id()), _nothing, again=False)
        self.ended = True
        return call

    # -- authority -----------------------------------------------------------

    def acquire(
        self, key: object, resources: tuple[str, ...], optional: tuple[str, ...] = ()
    ) -> Call[None]:
        """Asks for what ``key`` wants beside all that other keys ask for."""
        for resource in (*resources, *optional):
            if resource not in self.person.resources:
                self.subscribing.append((protocol.authority_topic(resource), True))
        self._asked[key] = (resources, optional)
        return self._acquire(again=True)

    def abandon(self, key: object) -> Call[None]:
        """Gives back what only ``key`` asked for."""
        gone = self._asked.pop(key, ((), ()))
        if not self._asked:
            request = protocol.Abandon(id=self._id())
            return self._call(request, self._granted, again=True)
        kept = {r for one in self._asked.values() for r in (*one[0], *one[1])}
        given_back = tuple(r for r in (*gone[0], *gone[1]) if r not in kept)
        if not given_back:
            return self._acquire(again=True)
        request = protocol.Abandon(id=self._id(), resources=given_back)
        return self._call(request, self._granted, again=True)

    def _acquire(self, again: bool) -> Call[None]:
        wanted = dict.fromkeys(r for one in self._asked.values() for r in one[0])
        able = dict.fromkeys(r for one in self._asked.values() for r in one[1] if r not in wanted)
        request = protocol.Acquire(id=self._id(), resources=tuple(wanted), optional=tuple(able))
        return self._call(request, self._granted, again)

    def _request_again(self) -> None:
        if self._asked:
            self._acquire(again=False)

    def _granted(self, granted: protocol.Granted) -> None:
        if granted.seq >= self._holds_seq:
            self._hold(frozenset(granted.holds), granted.seq)

    # -- watches -------------------------------------------------------------

    def watch(self, pattern: str, callback: Callable[[Any], None] | None = None) -> Watch:
        """What stands there, then every change; kept up over losses of the connection."""
        watch = Watch(pattern, callback)
        if all(one.pattern != pattern for one in self.watches):
            self.subscribing.append((protocol.pattern_topic(pattern), True))
        self.watches.append(watch)
        self._by_tag.clear()
        if self.connected:
            self._sync([watch])
        return watch

    def unwatch(self, watch: Watch) -> None:
        """No more of it is heard; asking twice is no fault."""
        watch.ended = True
        if watch not in self.watches:
            return
        self.watches.remove(watch)
        self._by_tag.clear()
        if any(one.pattern == watch.pattern for one in self.watches):
            return
        self.subscribing.append((protocol.pattern_topic(watch.pattern), False))
        if self.connected:
            request = protocol.Unwatch(id=self._id(), patterns=(watch.pattern,))
            self._call(request, _nothing, again=False)

    def _watching(self, tag: str) -> tuple[Watch, ...]:
        found = self._by_tag.get(tag)
        if found is None:
            found = self._by_tag[tag] = tuple(w for w in self.watches if w.fits(tag))
        return found

    def _sync(self, watches: Iterable[Watch]) -> None:
        """Asks for snapshots, when it is sure that changes are heard by then."""
        asked = [watch for watch in watches if not watch.asking]
        if not asked:
            return
        for watch in asked:
            watch.ready, watch.asking = False, True
        self._ask_echo(asked)

    def _ask_echo(self, asked: list[Watch]) -> None:
        topic = protocol.ECHO + f"{self._id()}:{id(self):x}".encode()
        self._echo[topic] = asked
        self.subscribing.append((topic, True))

    def _echoed(self, topic: bytes) -> None:
        watches = self._echo.pop(topic, None)
        self.subscribing.append((topic, False))
        if watches is None or not self.connected:
            return
        if not self._up:
            # Topics subscribed to before the connection stood arrive in any order, those
            # after in theirs: only an echo of the second kind tells of those before it.
            self._up = True
            self._ask_echo(watches)
            return
        patterns = tuple(dict.fromkeys(w.pattern for w in watches if not w.ended))
        if not patterns:
            return

        def read(reply: protocol.Snapshot) -> None:
            for watch in watches:
                watch.snapshot(reply)

        call = self._call(protocol.Watch(id=self._id(), patterns=patterns), read, again=False)
        call.done = lambda: _refused(watches, call)

    # -- trace ---------------------------------------------------------------

    def trace(
        self, since: int | None = None, callback: Callable[[Any], None] | None = None
    ) -> TraceFeed:
        """Trace events from seq ``since`` on (None: from now), without a gap."""
        feed = TraceFeed(since, callback)
        if not self.feeds:
            self.subscribing.append((protocol.TRACE, True))
        self.feeds.append(feed)
        if self.connected:
            self._fetch(feed)
        return feed

    def untrace(self, feed: TraceFeed) -> None:
        feed.ended = True
        if feed in self.feeds:
            self.feeds.remove(feed)
            if not self.feeds:
                self.subscribing.append((protocol.TRACE, False))

    def _fetch(self, feed: TraceFeed) -> None:
        if feed.asking or feed.ended or not self.connected:
            return
        feed.asking = True

        def read(reply: protocol.Traced) -> None:
            feed.asking = False
            if feed.page(reply):
                self._fetch(feed)

        call = self._call(protocol.Trace(id=self._id(), since=feed.next), read, again=False)
        call.done = lambda: _not_traced(feed, call)


def which(resources: tuple[str, ...], named: str | None) -> str:
    """The resource that a command is for, where only one can be meant."""
    if named is not None:
        return named
    if len(resources) != 1:
        raise BlackboardError(f"say which resource the command is for: {', '.join(resources)}")
    return resources[0]


def _refused(watches: list[Watch], call: Call[None]) -> None:
    for watch in watches:
        watch.asking = False
        if isinstance(call.error, Refused):
            watch.error = call.error


def _not_traced(feed: TraceFeed, call: Call[None]) -> None:
    if call.error is not None:
        feed.asking = False


def _nothing(reply: protocol.Done) -> None:
    return None


def _same(reply: Any) -> Any:
    return reply


def _versions(reply: protocol.Written) -> dict[str, int]:
    return reply.versions


def _entries(reply: protocol.Values) -> dict[str, protocol.Entry]:
    return reply.entries
