"""The client's half of the protocol, without sockets, threads or a clock.

Messages of the core come in with the time (seconds, any monotonic clock), frames and
topics to subscribe to go out. It keeps the session alive, takes it up again after a
loss, and asks anew for all that was watched, requested and traced. Every driver
(blocking, asyncio, Qt) is a few lines round it.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Mapping
from typing import Any, TypeVar

from msgspec import UNSET
from msgspec.structs import replace

from situ.blackboard import json_values, notices, protocol, replies, topics, wire
from situ.blackboard.calls import Call, Person
from situ.blackboard.feeds import Feed
from situ.blackboard.holding import Holding
from situ.blackboard.protocol import HEARTBEAT, LEASE, Request
from situ.blackboard.subscriptions import Subscriptions
from situ.blackboard.wire import Malformed
from situ.decide.expected import Expectation
from situ.errors import BlackboardError, Refused, Unreachable

T = TypeVar("T")


class Dialog:
    """One client's session, watches, requests for authority and trace.

    For its driver: ``receive``, ``hear``, ``tick`` and ``due`` by the clock; ``outgoing``
    (bodies to send), ``subscribing`` ((topic, on or off), in order) and ``notifications``
    (the address to subscribe at, None before it is known) after each of them.

    For its user: ``connected``; ``welcome`` (the core's last greeting); ``changed`` is
    called when either changes; ``stopped`` (whether the core has said that it ends, and has
    not come back); the requests, each a ``Call``; ``watch`` and ``trace``.
    ``problem`` says why there is no session, where the core told. ``deployed``: for a service,
    the version that runs, None before it is known.
    """

    def __init__(self, person: Person) -> None:
        self.person = person
        self.connected = False
        self.ended = False
        self.stopped = False
        self.welcome: replies.Welcome | None = None
        self.problem: Refused | None = None
        self.deployed: int | None = None
        self.notifications: str | None = None
        self.outgoing: deque[bytes] = deque()
        self.changed: Callable[[], None] | None = None
        self._ids = 0
        self._hellos: set[int] = set()
        self._calls: dict[int, Call[Any]] = {}
        self._waiting: list[Call[Any]] = []
        self._heard = self._listened = self._lost_at = float("-inf")
        self._next = float("-inf")
        self._turned: float | None = None
        self._subscriptions = Subscriptions(self, person.module)
        self.subscribing = self._subscriptions.topics
        self.subscribing.append((topics.END, True))
        self._holding = Holding(self, person, self.subscribing.append, self._tell)
        self.watch = self._subscriptions.watch
        self.unwatch = self._subscriptions.unwatch
        self.messages = self._subscriptions.listen
        self.unlisten = self._subscriptions.unlisten
        self.trace = self._subscriptions.trace
        self.untrace = self._subscriptions.untrace
        self.perform = self._subscriptions.perform
        self.serve = self._subscriptions.serve
        self.unserve = self._subscriptions.unserve
        self.acquire = self._holding.acquire
        self.withdraw = self._holding.withdraw
        self.abandon = self._holding.abandon

    # -- for its driver ------------------------------------------------------

    @property
    def holds(self) -> frozenset[str]:
        """The resources that the module has, as last heard."""
        return self._holding.holds

    @property
    def situ(self) -> str | None:
        """The version of Situ that the core runs, as it said last; None where it told none."""
        told = self.welcome.situ if self.welcome is not None else UNSET
        return None if told is UNSET else told

    def due(self) -> float:
        """When ``tick`` is to be called next; in the past before the first time."""
        return min(self._next, self._listened + LEASE) if self.connected else self._next

    def tick(self, now: float) -> None:
        """Says that we live; says hello while there is no session."""
        if self.connected and now >= self._listened + LEASE:
            self._fall_silent(now)
        elif not self.connected and now >= self._lost_at + LEASE:
            self._give_up()
        if now < self._next:
            return
        self._next = now + HEARTBEAT
        if self.ended:
            return
        if self.connected:
            self.ask(protocol.Heartbeat(id=self.next_id()), self._alive, again=False)
        else:
            self._say_hello()

    def receive(self, body: bytes, now: float) -> None:
        """A reply. Anything that is none is passed over."""
        try:
            reply = wire.read_reply(body)
        except Malformed:
            return
        self._heard = self._listened = now
        if isinstance(reply, replies.Welcome):
            if not self.connected:
                self._welcomed(reply, now)
            return
        if isinstance(reply, replies.Refused) and reply.id in self._hellos:
            self._turned_away(reply, now)
            return
        call = self._calls.pop(reply.id, None) if reply.id is not None else None
        if call is None:
            return
        if isinstance(reply, replies.Refused) and reply.code == "session":
            # Neither this one nor what was sent after it was done.
            if self.connected:
                self._calls[call.request.id] = call
                self._lose(since=call.request.id)
                self._lost_at = now
            elif not isinstance(call.request, _FLEETING):
                self._waiting.append(call)
            self._next = now
            return
        call.answer(reply)

    def hear(self, frame: bytes, now: float) -> None:
        """A notice, with its topic. Anything that is none is passed over."""
        try:
            notice = wire.read_notice(frame)
        except (Malformed, ValueError):
            return
        if isinstance(notice, notices.Authority):
            # Without a session nothing is held; the next heartbeat tells what is.
            if self.connected:
                self._holding.hear(notice)
        elif isinstance(notice, notices.End):
            self.stopped = True
            if self.connected:
                self._lose()
        else:
            self._subscriptions.hear(notice, frame)

    def lost(self, call: Call[Any]) -> None:
        """Its user waits no longer: the call fails, a later answer is passed over."""
        self.forget(call)
        call.fail(self.unreachable())

    def forget(self, call: Call[Any]) -> None:
        """It is not sent any more, and its answer is passed over."""
        self._calls.pop(call.request.id, None)
        if call in self._waiting:
            self._waiting.remove(call)

    def unreachable(self) -> Unreachable:
        """Why nothing is answered, in one line; who knows the address puts it before."""
        if self.problem is not None:
            return Unreachable(str(self.problem))
        return Unreachable(
            "nobody answers; is situ run going there, and if it has keys, does it know yours?"
        )

    # -- the session ---------------------------------------------------------

    def next_id(self) -> int:
        self._ids += 1
        return self._ids

    def _say_hello(self) -> None:
        number = self.next_id()
        self._hellos.add(number)
        who = self.person
        hello = protocol.Hello(
            id=number,
            version=protocol.VERSION,
            role=who.role,
            module=who.module,
            user=who.user,
            resources=who.resources,
            description=who.description,
            requires=who.requires,
            provides=who.provides,
            session=self.welcome.session if self.welcome is not None else None,
            services=who.services,
        )
        # What could not be sent in the meantime is stale; this hello goes for it.
        self.outgoing.clear()
        self.outgoing.append(wire.encode(hello))

    def _welcomed(self, welcome: replies.Welcome, now: float) -> None:
        restarted = self.welcome is not None and self.welcome.runtime != welcome.runtime
        self.welcome, self.problem, self._turned = welcome, None, None
        self.connected, self.stopped = True, False
        self._hellos.clear()
        self.notifications = welcome.addresses.notifications
        self._next = now + HEARTBEAT
        if not welcome.resumed:
            self._holding.renewed()
        waiting, self._waiting = self._waiting, []
        self._subscriptions.mask(topics.masked(self.person.role) if welcome.masked else ())
        self._subscriptions.renewed(restarted)
        for call in waiting:
            if restarted and call.otherwise is not None:
                call.fail(call.otherwise)
            elif restarted and isinstance(call.request, protocol.Finish):
                # The action has ended with its robot; by now its id may be another's.
                call.fail(self.unreachable())
            else:
                self._send(call)
        self._tell()

    def _turned_away(self, refused: replies.Refused, now: float) -> None:
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

    def _fall_silent(self, now: float) -> None:
        """Nothing was heard for a lease, of a core that may have been asked nothing."""
        assert self.welcome is not None
        stood = now >= self._next + HEARTBEAT
        if stood and now < self._heard + self.welcome.lease:
            # It was ours to ask: it has as long to answer as ever.
            self._listened = now
            return
        self._lose(stood=stood)
        self._lost_at = now

    def _give_up(self) -> None:
        """Of what is meant for the robot as it was, nothing waits for one that does not come."""
        waiting = self._waiting
        self._waiting = [call for call in waiting if call.otherwise is None]
        for call in waiting:
            if call.otherwise is not None:
                call.fail(call.otherwise)

    def _lose(self, since: int | None = None, stood: bool = False) -> None:
        """since: requests from this id on are known not to have been done. stood: whether it was
        ourselves who said nothing, so that the robot may be there.
        """
        self.connected = False
        calls, self._calls = self._calls, {}
        unsent = {id(body) for body in self.outgoing}
        for call in calls.values():
            undone = id(call.body) in unsent or (since is not None and call.request.id >= since)
            there = undone and (stood or since is not None)
            if isinstance(call.request, protocol.Command):
                call.drop()
            elif call.otherwise is not None and not there:
                call.fail(call.otherwise)
            elif isinstance(call.request, _FLEETING):
                call.fail(self.unreachable())
            elif call.again or undone:
                self._waiting.append(call)
            else:
                what = call.request.__struct_config__.tag
                call.fail(
                    Unreachable(f"the connection was lost; whether {what} was done is not known")
                )
        self.outgoing.clear()
        self._subscriptions.lost()
        self._holding.lost()
        self._tell()

    def _alive(self, alive: replies.Alive) -> None:
        if self.person.module is not None:
            self._holding.stands(alive.holds, alive.seq)
        self._subscriptions.check(alive)
        if alive.deployed is not UNSET and alive.deployed != self.deployed:
            self.deployed = alive.deployed
            self._tell()

    def _tell(self) -> None:
        if self.changed is not None:
            self.changed()

    # -- requests ------------------------------------------------------------

    def ask(self, request: Request, read: Callable[[Any], T], again: bool) -> Call[T]:
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
            body = json_values.encode(call.request)
        except BlackboardError as error:
            call.fail(error)
            return
        call.body = body
        self._calls[call.request.id] = call
        self.outgoing.append(body)

    def set(
        self, tags: Mapping[str, Any], versions: Mapping[str, int] | None = None
    ) -> Call[dict[str, int]]:
        """One write; gives the new version of each tag that changed."""
        wanted = None if versions is None else dict(versions)
        request = protocol.Set(id=self.next_id(), tags=dict(tags), versions=wanted)
        # Twice is as good as once, unless a version is to be met.
        return self.ask(request, _versions, again=versions is None)

    def get(self, name: str) -> Call[Any]:
        """The value of a tag or of a name that reaches into one; None where it is missing."""
        request = protocol.Get(id=self.next_id(), names=(name,))
        return self.ask(request, lambda reply: reply.entries[name].value, again=True)

    def entries(self, names: Iterable[str]) -> Call[dict[str, replies.Entry]]:
        """Entries of names and patterns, with version, writer and time."""
        request = protocol.Get(id=self.next_id(), names=tuple(names))
        return self.ask(request, _entries, again=True)

    def known(self, name: str) -> replies.Entry | None:
        """The entry at a watched tag as last heard, without asking; None: ask."""
        if not self.connected:
            return None
        for watch in self._subscriptions.watching(name):
            if watch.ready and (entry := watch.known.get(name)) is not None:
                return entry
        return None

    def publish(self, event: str, application: str | None = None) -> Call[None]:
        request = protocol.Publish(id=self.next_id(), event=event, application=application)
        return self.ask(request, _nothing, again=False)

    def debug(self, verb: protocol.DebugVerb, **fields: Any) -> Call[None]:
        request = protocol.DEBUGGING[verb](id=self.next_id(), **fields)
        return self.ask(request, _nothing, again=False)

    def command(self, resource: str, value: Any, valid: float | None = None) -> Call[None]:
        """A command. Without a connection there is no authority either: it is left out, for
        later it would be stale."""
        request = protocol.Command(id=self.next_id(), resource=resource, value=value, valid=valid)
        call: Call[None] = Call(request, _nothing, again=False)
        if self.connected and not self.ended:
            self._send(call)
        else:
            call.drop()
        return call

    def use(self, component: str, *value: Any) -> Call[None]:
        """What a person does to a component; the value is left out for a button."""
        request = (
            protocol.Use(id=self.next_id(), component=component, value=value[0])
            if value
            else protocol.Use(id=self.next_id(), component=component)
        )
        return self.ask(request, _nothing, again=False)

    def touch(self) -> Call[None]:
        return self.ask(protocol.Touch(id=self.next_id()), _nothing, again=False)

    def documents(self) -> Call[replies.Files]:
        return self.ask(protocol.Documents(id=self.next_id()), _same, again=True)

    def expected(self) -> Call[dict[str, Expectation]]:
        request = protocol.Expected(id=self.next_id())
        return self.ask(request, lambda reply: reply.applications, again=True)

    def modules(self) -> Call[replies.ModuleStates]:
        return self.ask(protocol.Modules(id=self.next_id()), _same, again=True)

    def disclose(
        self,
        description: str,
        requires: Iterable[protocol.Need],
        provides: Iterable[protocol.Offer],
    ) -> Call[None]:
        """Tells what the module requires and provides; told again after a reconnect."""
        request = protocol.Disclose(
            id=self.next_id(),
            description=description,
            requires=tuple(requires),
            provides=tuple(provides),
        )
        self.person = replace(
            self.person,
            description=description or self.person.description,
            requires=request.requires,
            provides=request.provides,
        )
        return self.ask(request, _nothing, again=True)

    def give(
        self, request: Callable[[int], Request], again: bool = False
    ) -> Call[replies.AnyReply]:
        """Any other request, made with the id that it must carry. again: as of ``Call``."""
        return self.ask(request(self.next_id()), _same, again)

    def bye(self) -> Call[None]:
        """Ends the session at once; nothing can be asked any longer."""
        call = self.ask(protocol.Bye(id=self.next_id()), _nothing, again=False)
        self.ended = True
        return call

    def following(self) -> list[Feed[Any]]:
        """All that is watched, listened to, traced, carried out and answered."""
        one = self._subscriptions
        return [*one.watches, *one.messages, *one.feeds, *one.effects, *one.requests]


def _nothing(reply: replies.Done) -> None:
    return None


def _same(reply: Any) -> Any:
    return reply


def _versions(reply: replies.Written) -> dict[str, int]:
    return reply.versions


def _entries(reply: replies.Values) -> dict[str, replies.Entry]:
    return reply.entries


_FLEETING = (
    protocol.Heartbeat,
    protocol.Bye,
    protocol.Watch,
    protocol.Trace,
    protocol.Serve,
    # To be given again only where the question still stands.
    protocol.Answer,
)
"""What another session asks for by itself, or no more."""
