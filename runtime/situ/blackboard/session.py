"""Sessions and leases round a core: who is connected, and for how long they are believed.

No I/O. What comes in: messages of peers, with the time. A peer is any hashable name of a
connection; nothing here knows ZeroMQ.
"""

from __future__ import annotations

import secrets
from collections.abc import Collection, Hashable, Iterable, Mapping
from typing import Any

from msgspec.structs import replace

from situ import __version__
from situ.blackboard import protocol, replies, topics, wire
from situ.blackboard.acting import OPERATOR, No, Session
from situ.blackboard.admission import check, writer
from situ.blackboard.core import Core, Outgoing
from situ.blackboard.guard import Guard
from situ.blackboard.history import Ended, Opened, Past, SessionEvent, SessionsState
from situ.blackboard.identity import Identity
from situ.blackboard.protocol import HEARTBEAT, LEASE
from situ.blackboard.register import Register
from situ.blackboard.replies import Addresses
from situ.blackboard.requests import answer
from situ.blackboard.rights import Rights
from situ.blackboard.services import carried_by, may_repeat
from situ.blackboard.wire import Malformed
from situ.decide import inputs
from situ.decide.effects import Begin
from situ.decide.step import SECOND
from situ.document.project import Project

_LEASE = int(LEASE * SECOND)
_LATE = int(HEARTBEAT * SECOND)
MOST = 1_000
"""Sessions at once; who leaks connections must not take the robot down."""


class Sessions:
    """All clients of one core.

    ``start``, ``receive``, ``submit`` and ``advance`` do what they are asked at the time
    they are given (µs since the start, never decreasing); ``take`` gives what is to be
    sent and carried out because of it; ``due`` says when ``advance`` must be called.

    With ``scripted`` the robot's time is the scenario's: it moves only with the ``at`` of
    the scenario's requests and with ``Core.move``; leases still run by the time given.

    own: the services that are carried out here; all others may be by clients.

    guard: holds every session to the key that its messages come with; None: there are no keys.

    ``state`` and ``restore`` take all of it over into another process.
    """

    def __init__(
        self,
        core: Core,
        addresses: Addresses,
        *,
        scripted: bool = False,
        own: Collection[str] = (),
        guard: Guard | None = None,
    ) -> None:
        self.runtime = secrets.token_hex(8)
        self._core = core
        self._addresses = addresses
        self._scripted = scripted
        # A scenario says itself what ends.
        core.asking.heeds = not scripted
        self._guard = guard
        self._own = frozenset(own)
        self._register = Register(core)
        # The same, for each message asks for it.
        self._sessions = self._register.sessions
        # No lease ends before: every message only puts one off.
        self._look: int | None = None

    # -- for who drives it ---------------------------------------------------

    @property
    def clients(self) -> int:
        """How many clients are connected, who plays the scenario not counted."""
        return sum(session.role != "scenario" for session in self._sessions.values())

    def start(
        self,
        seed: int = 0,
        auto_finish: float | None = None,
        restored: Mapping[str, tuple[Any, int, str]] | None = None,
    ) -> None:
        """The first step of the run, at 0. restored: what durable tags held before."""
        # A scenario plays every module; alive, only those that are connected are there.
        self._core.begin(
            inputs.Start(
                seed=seed,
                auto_finish=auto_finish,
                everyone=self._scripted,
                restored=dict(restored or {}),
            )
        )

    def receive(
        self, peer: Hashable, body: bytes, now: int, identity: Identity | None = None
    ) -> None:
        """A message of a peer, by whose key it came; it is always answered."""
        self._move(now)
        try:
            reply = self._answer(peer, body, identity)
        except Exception as fault:
            # A fault of ours: whoever asked is not left waiting, and the driver is told.
            message = f"a fault in situ itself ({type(fault).__name__}); please report it"
            refused = replies.Refused(id=wire.read_id(body), code="refused", message=message)
            self._core.reply(peer, refused)
            raise
        self._core.reply(peer, reply)

    def submit(self, given: inputs.AnyInput, now: int) -> str | None:
        """An input from the runtime's own parts; why it was refused, or None."""
        self._move(now)
        return self._core.step(given)

    def turn_to(self, project: Project, files: Mapping[str, str]) -> None:
        """The robot runs this from here on; who is connected stays. files: as in ``Core``."""
        self._core.project, self._core.files = project, files
        if self._guard is not None:
            self._guard.rights = Rights(project)

    def advance(self, now: int) -> None:
        """Does what has fallen due: the robot's own, and the ends of leases.

        To be called when all messages that have come are received: who sent one lives.
        """
        due = self.due()
        self._move(now)
        if due is not None and now > due + _LATE:
            # We stood still ourselves: what was sent to us meanwhile may yet be on its way.
            for session in self._sessions.values():
                session.heard = max(session.heard, now - _lease(session) + _LATE)
        for finish in self._core.asking.overdue(now):
            self._core.step(finish)
        if self._look is None or now < self._look:
            return
        for session in [s for s in self._sessions.values() if now >= s.heard + _lease(s)]:
            self._end(session)
        ends = (session.heard + _lease(session) for session in self._sessions.values())
        # Who comes meanwhile, or begins to act, has a lease that may end before.
        self._look = min((now + _LEASE, *ends)) if self._sessions else None

    def due(self) -> int | None:
        """When ``advance`` is to be called next, in µs; None: not before a message comes."""
        core, due = self._core, self._look
        # Without a list: it is asked twice a message.
        for one in (None if self._scripted else core.due(), core.asking.due()):
            if one is not None and (due is None or one < due):
                due = one
        return due

    def take(self) -> Outgoing:
        """What is to be sent and carried out since the last call."""
        return self._core.take()

    # -- after a restart -----------------------------------------------------

    def state(self) -> SessionsState:
        """All that is known here, but for the connections."""
        core = self._core
        return SessionsState(
            runtime=self.runtime,
            sessions=self._register.standing(),
            modules=core.modules,
            holders=core.holders,
            changes=core.watching.state(),
            moment=core.moment,
            effects=dict(core.effects),
        )

    def restore(self, state: SessionsState, past: Iterable[Past], now: int) -> None:
        """Goes on from ``state`` with what happened after it, in a core whose robot was restored
        to the same moment; what would leave again because of it is left out.

        Sessions are then without a connection; each is believed for a lease from ``now`` on.
        """
        core = self._core
        self.runtime = state.runtime
        core.moment = state.moment
        core.modules.update(state.modules)
        core.holders.update(state.holders)
        core.effects.update(state.effects)
        for one in state.sessions:
            self._register.stand(one)
        core.watching.restore(state.changes)
        for moment, event in past:
            core.now = moment
            core.move(moment)
            if isinstance(event, SessionEvent):
                self._register.do_again(event)
            elif event is not None:
                core.step(event)
        core.now = now
        core.ask_again()
        core.take()
        for session in self._sessions.values():
            session.heard = now
        self._look = now + _LEASE if self._sessions else None

    def _move(self, now: int) -> None:
        self._core.now = now
        if not self._scripted:
            self._core.move(now)

    def may_subscribe(self, who: Identity | None, topic: bytes) -> bool:
        """Whether somebody with this key may hear what is published under topics that begin so."""
        if self._guard is None:
            return True
        if who is None:
            return False
        return not self._core.hides(who.role) or topics.is_open(who.role, topic)

    # -- requests ------------------------------------------------------------

    def _answer(self, peer: Hashable, body: bytes, identity: Identity | None) -> replies.Reply:
        session = self._sessions.get(peer)
        if session is not None and (
            session.identity != identity or session.masked != self._core.hides(session.role)
        ):
            # The name of the connection is another's now, the key is not what it was, or another
            # project that was deployed hides what this one did not.
            self._end(session)
            session = None
        if session is not None:
            session.heard = self._core.now
        try:
            request = wire.read_request(body)
        except Malformed as error:
            return replies.Refused(id=error.id, code="malformed", message=str(error))
        try:
            if isinstance(request, protocol.Hello):
                return self._hello(peer, request, identity)
            if session is None:
                raise No("session", "there is no session of this connection: say hello first")
            if self._guard is None:
                return self._do(session, request)
            who = self._guard.check(identity, session.role, request)
            reply = self._do(session, request)
            self._guard.done(who, session.role, request)
            return reply
        except No as no:
            if self._guard is not None:
                self._guard.refused(identity, request, no)
            return replies.Refused(id=request.id, code=no.code, message=str(no))

    def _do(self, session: Session, request: protocol.Request) -> replies.Reply:
        self._time(session, request)
        if isinstance(request, protocol.Bye) and request.module is None:
            self._end(session)
            return replies.Done(id=request.id)
        return answer(self._core, session, request)

    def _time(self, session: Session, request: protocol.Request) -> None:
        if request.at is None:
            return
        if session.role != "scenario":
            raise No("clock", "only a scenario tells the time: leave out at")
        past, now = request.at / SECOND, self._core.moment / SECOND
        if past < now:
            raise No("clock", f"{past} s is past; it is {now} s already")
        self._core.move(request.at)

    def _hello(
        self, peer: Hashable, hello: protocol.Hello, identity: Identity | None
    ) -> replies.Reply:
        if hello.version != protocol.VERSION:
            raise No(
                "version",
                f"version {hello.version} of the protocol is not spoken here, "
                f"only {protocol.VERSION}",
            )
        if self._guard is not None:
            hello = self._guard.greet(identity, hello)
        session = self._resumed(peer, hello, identity)
        resumed = session is not None
        if session is None:
            check(hello, self._core, self._sessions.values(), self._own, scripted=self._scripted)
            if len(self._sessions) >= MOST:
                raise No("limit", f"{MOST} clients are connected already: end some of them")
            session = Session(
                id=secrets.token_hex(8),
                peer=peer,
                role=hello.role,
                module=hello.module,
                writer=writer(hello),
                heard=self._core.now,
                services=hello.services,
                heeded=not (hello.services and self._scripted),
                identity=identity,
            )
            self._register.add(session)
            if self._look is None:
                self._look = session.heard + _LEASE
            said = (hello.resources, hello.description, hello.requires, hello.provides)
            self._core.remember(
                Opened(
                    session.id,
                    session.role,
                    session.module,
                    session.writer,
                    said if session.module is not None else None,
                    session.services,
                )
            )
            if session.module is not None:
                self._core.modules[session.module] = said
                self._core.step(inputs.Connected(session.module, hello.resources))
        return replies.Welcome(
            id=hello.id,
            session=session.id,
            resumed=resumed,
            runtime=self.runtime,
            version=protocol.VERSION,
            heartbeat=protocol.HEARTBEAT,
            lease=session.lease,
            project=self._core.project.name,
            addresses=self._where(),
            time=self._core.moment,
            seq=self._core.backlog.last,
            masked=session.masked,
            situ=__version__,
        )

    def _resumed(
        self, peer: Hashable, hello: protocol.Hello, identity: Identity | None
    ) -> Session | None:
        """The living session that the client had before, now on this connection."""
        session = self._sessions.get(peer)
        if session is None and hello.session is not None:
            alive = self._sessions.values()
            session = next((one for one in alive if one.id == hello.session), None)
        if session is None:
            return None
        said = (hello.module, hello.role, hello.services, writer(hello))
        if (session.module, session.role, session.services, session.writer) != said:
            raise No("name", "this connection has another session already: say bye first")
        del self._sessions[session.peer]
        session.peer, session.heard, session.identity = peer, self._core.now, identity
        self._sessions[peer] = session
        return session

    def _where(self) -> Addresses:
        """The addresses, with the screen's where another process serves it."""
        shown = (s.http for s in self._sessions.values() if s.http is not None)
        http = next(shown, None)
        return self._addresses if http is None else replace(self._addresses, http=http)

    def _end(self, session: Session) -> None:
        self._register.remove(session)
        self._core.remember(Ended(session.id))
        if self._core.deployer is not None:
            self._core.deployer.left(session.id)
        if session.module is not None:
            self._core.asking.lost(session.module, self._core.now)
            self._core.step(inputs.Lost(session.module))
        if session.acts and not any(one.acts for one in self._sessions.values()):
            self._core.step(inputs.Abandon(OPERATOR, ()))
        if session.performing and "engine" in session.services:
            for effect in self._core.outstanding():
                if isinstance(effect, Begin) and carried_by(effect) and not may_repeat(effect):
                    self._core.step(lost(effect, "the service engine was lost"))


def _lease(session: Session) -> int:
    return int(session.lease * SECOND)


def lost(begun: Begin, why: str) -> inputs.Finish:
    """The end of what nobody knows whether it was done; why: what happened to who did it."""
    error = f"{why} while {begun.name or begun.action} was under way"
    return inputs.Finish(id=begun.id, ok=False, error=f"{error}; whether it was done is not known")
