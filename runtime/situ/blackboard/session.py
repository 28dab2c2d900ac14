"""Sessions and leases round a ``Robot``: the core's side of the protocol, without I/O.

What comes in: messages of peers, with the time. What comes out: replies to peers,
notices for whoever subscribed, and the robot's effects for who carries them out.
A peer is any hashable name of a connection; nothing here knows ZeroMQ.
"""

from __future__ import annotations

import secrets
from collections.abc import Callable, Hashable, Mapping
from typing import Any, Protocol

from msgspec import UNSET, Raw, Struct

from situ.blackboard import presence, protocol
from situ.blackboard.backlog import Backlog, stamped
from situ.blackboard.protocol import LEASE, Addresses, Malformed, Need, Offer
from situ.blackboard.watching import Watching
from situ.decide import inputs, trace
from situ.decide.board import Board
from situ.decide.effects import AnyEffect, Begin, Cancel, Changed, Map, Refuse
from situ.document import names
from situ.document.project import Project

SECOND = 1_000_000
PAGE = 500
"""Trace events in one reply."""

Carried = Map | Begin | Cancel


class Decider(Protocol):
    """The part of ``situ.decide.robot.Robot`` that sessions need."""

    @property
    def board(self) -> Board: ...

    def step(
        self, given: inputs.AnyInput | None, now: int, /
    ) -> tuple[list[trace.TraceEvent], list[AnyEffect]]: ...

    def due(self) -> int | None: ...


class Session(Struct):
    """One client. heard: µs, when it was last heard of."""

    id: str
    peer: Hashable
    role: protocol.Role
    module: str | None
    writer: str
    heard: int
    resources: tuple[str, ...]
    description: str
    requires: tuple[Need, ...]
    provides: tuple[Offer, ...]
    patterns: set[str] = set()
    tracing: bool = False


class Outgoing(Struct):
    """In the order in which they must leave, each list by itself."""

    replies: list[tuple[Hashable, bytes]] = []
    notices: list[bytes] = []
    effects: list[Carried] = []


class No(Exception):
    """A request is refused."""

    def __init__(self, code: protocol.Code, message: str) -> None:
        super().__init__(message)
        self.code = code


class Sessions:
    """All clients of one robot.

    ``receive``, ``submit``, ``advance`` and ``start`` do what they are asked at the time
    they are given (µs since the start, never decreasing); ``take`` gives what is to be
    sent and carried out because of it; ``due`` says when ``advance`` must be called.

    With ``scripted`` the robot's time is the scenario's: it moves only with the ``at`` of
    the scenario's requests and with ``move``; leases still run by the time given.

    epoch: UNIX time of 0 µs, for ``time`` in the trace. heard: is told each step's trace
    events (with the UNIX time), before anybody else. documents: path to text of the
    files the robot runs.
    """

    def __init__(
        self,
        robot: Decider,
        project: Project,
        *,
        addresses: Addresses,
        documents: Mapping[str, str] | None = None,
        scripted: bool = False,
        epoch: float = 0.0,
        heard: Callable[[list[trace.TraceEvent], float], None] | None = None,
        backlog: Backlog | None = None,
    ) -> None:
        self.addresses = addresses
        self.epoch = epoch
        self.runtime = secrets.token_hex(8)
        self.backlog = backlog if backlog is not None else Backlog()
        self.moment = 0
        self._robot = robot
        self._project = project
        self._files = dict(documents or {})
        self._scripted = scripted
        self._heard = heard
        self._now = 0
        self._sessions: dict[Hashable, Session] = {}
        self._modules: dict[str, Session] = {}
        self._applications = {a.name for a in project.applications.values()}
        self._holders: dict[str, str | None] = {}
        self._watching = Watching()
        self._tracing = 0
        self._out = Outgoing()

    # -- for who drives it ---------------------------------------------------

    def start(self, seed: int = 0, auto_finish: float | None = None) -> None:
        """The first step of the run, at 0."""
        # A scenario plays every module; alive, only those that are connected are there.
        start = inputs.Start(seed=seed, auto_finish=auto_finish, everyone=self._scripted)
        self._step(start)

    def receive(self, peer: Hashable, body: bytes, now: int) -> None:
        """A message of a peer; it is always answered."""
        self.advance(now)
        self._out.replies.append((peer, protocol.encode(self._answer(peer, body))))

    def submit(self, given: inputs.AnyInput, now: int) -> str | None:
        """An input from the runtime's own parts; why it was refused, or None."""
        self.advance(now)
        return self._step(given)

    def advance(self, now: int) -> None:
        """Does what has fallen due: the robot's own, and the ends of leases."""
        self._now = now
        if not self._scripted:
            self.move(now)
        if any(now >= session.heard + LEASE * SECOND for session in self._sessions.values()):
            for session in list(self._sessions.values()):
                if now >= session.heard + LEASE * SECOND:
                    self._end(session)

    def move(self, moment: int) -> None:
        """Moves the robot's time there, doing what falls due up to and at it, in order."""
        while (due := self._robot.due()) is not None and due <= moment:
            self.moment = max(self.moment, due)
            self._step(None)
        self.moment = max(self.moment, moment)

    def due(self) -> int | None:
        """When ``advance`` is to be called next, in µs; None: not before a message comes."""
        ends = [session.heard + int(LEASE * SECOND) for session in self._sessions.values()]
        robot = None if self._scripted else self._robot.due()
        if robot is not None:
            ends.append(robot)
        return min(ends, default=None)

    def take(self) -> Outgoing:
        """What is to be sent and carried out since the last call."""
        out = self._out
        self._out = Outgoing()
        return out

    def end(self) -> None:
        """Tells all that the runtime stops."""
        self._out.notices.append(protocol.notice(protocol.END, protocol.End()))

    # -- steps of the robot --------------------------------------------------

    def _step(self, given: inputs.AnyInput | None) -> str | None:
        events, effects = self._robot.step(given, self.moment)
        if events:
            self._traced(events)
        refused = None
        out = self._out
        for effect in effects:
            if isinstance(effect, Changed):
                if self._watching.changed(effect.tag):
                    out.notices.append(_change(effect, self._watching.n))
            elif isinstance(effect, Refuse):
                refused = effect.message
            else:
                out.effects.append(effect)
                if isinstance(effect, Begin) and effect.action == "message":
                    out.notices.append(_message(effect))
        return refused

    def _traced(self, events: list[trace.TraceEvent]) -> None:
        at = self.epoch + self._now / SECOND
        self.backlog.add(events, at)
        if self._heard is not None:
            self._heard(events, at)
        for event in events:
            if type(event) is trace.Authority:
                self._holders[event.resource] = event.to
                passed = protocol.Authority(
                    resource=event.resource, source=event.source, to=event.to, seq=event.seq
                )
                topic = protocol.authority_topic(event.resource)
                self._out.notices.append(protocol.notice(topic, passed))
        if self._tracing:
            lines = tuple(Raw(stamped(event, at)) for event in events)
            body = protocol.Events(events=lines)
            self._out.notices.append(protocol.notice(protocol.TRACE, body))

    def _do(self, given: inputs.AnyInput) -> None:
        refused = self._step(given)
        if refused is not None:
            raise No("refused", refused)

    # -- requests ------------------------------------------------------------

    def _answer(self, peer: Hashable, body: bytes) -> protocol.Reply:
        number: int | None = None
        session = self._sessions.get(peer)
        if session is not None:
            session.heard = self._now
        try:
            request = protocol.read_request(body)
            number = request.id
            if isinstance(request, protocol.Hello):
                return self._hello(peer, request)
            if session is None:
                raise No("session", "there is no session of this connection: say hello first")
            self._time(session, request)
            return _HANDLERS[type(request)](self, session, request)
        except Malformed as error:
            return protocol.Refused(id=error.id, code="malformed", message=str(error))
        except No as no:
            return protocol.Refused(id=number, code=no.code, message=str(no))

    def _time(self, session: Session, request: protocol.Request) -> None:
        if request.at is None:
            return
        if session.role != "scenario":
            raise No("clock", "only a scenario tells the time: leave out at")
        if request.at < self.moment:
            raise No(
                "clock", f"{request.at / SECOND} s is past; it is {self.moment / SECOND} s already"
            )
        self.move(request.at)

    def _hello(self, peer: Hashable, hello: protocol.Hello) -> protocol.Reply:
        if hello.version != protocol.VERSION:
            raise No(
                "version",
                f"version {hello.version} of the protocol is not spoken here, "
                f"only {protocol.VERSION}",
            )
        session = self._resumed(peer, hello)
        resumed = session is not None
        if session is None:
            self._check_hello(hello)
            session = Session(
                id=secrets.token_hex(8),
                peer=peer,
                role=hello.role,
                module=hello.module,
                writer=_writer(hello),
                heard=self._now,
                resources=hello.resources,
                description=hello.description,
                requires=hello.requires,
                provides=hello.provides,
            )
            self._sessions[peer] = session
            if session.module is not None:
                self._modules[session.module] = session
                self._step(inputs.Connected(session.module, session.resources))
        return protocol.Welcome(
            id=hello.id,
            session=session.id,
            resumed=resumed,
            runtime=self.runtime,
            version=protocol.VERSION,
            heartbeat=protocol.HEARTBEAT,
            lease=LEASE,
            project=self._project.name,
            addresses=self.addresses,
            time=self.moment,
            seq=self.backlog.last,
        )

    def _resumed(self, peer: Hashable, hello: protocol.Hello) -> Session | None:
        """The living session that the client had before, now on this connection."""
        session = self._sessions.get(peer)
        if session is None and hello.session is not None:
            alive = self._sessions.values()
            session = next((one for one in alive if one.id == hello.session), None)
        if session is None:
            return None
        if session.module != hello.module or session.role != hello.role:
            raise No("name", "this connection has another session already: say bye first")
        del self._sessions[session.peer]
        session.peer, session.heard = peer, self._now
        self._sessions[peer] = session
        return session

    def _check_hello(self, hello: protocol.Hello) -> None:
        if hello.role == "scenario" and not self._scripted:
            raise No("role", "a scenario is played only by situ run --script")
        if (hello.module is not None) != (hello.role == "module"):
            raise No("role", "a module gives its name, and only a module does")
        if hello.module is None:
            return
        name = hello.module
        if not names.is_tag(f"module/{name}/x") or "/" in name:
            raise No("name", f"{name!r} can be no module's name: use letters, digits, - and _")
        if name in self._applications:
            raise No("name", f"{name} is an application of this project: choose another name")
        if name in self._modules:
            raise No(
                "name",
                f"a module {name} is connected already: end it, or choose another name",
            )

    def _end(self, session: Session) -> None:
        del self._sessions[session.peer]
        for pattern in session.patterns:
            self._watching.remove(pattern)
        self._tracing -= session.tracing
        if session.module is not None:
            del self._modules[session.module]
            self._step(inputs.Lost(session.module))

    def _heartbeat(self, session: Session, request: protocol.Heartbeat) -> protocol.Reply:
        return protocol.Alive(
            id=request.id,
            time=self.moment,
            seq=self.backlog.last,
            changes=self._watching.last(session.patterns),
            holds=self._holds(session.module),
        )

    def _set(self, session: Session, request: protocol.Set) -> protocol.Reply:
        _may_write(session)
        board = self._robot.board
        for tag, wanted in (request.versions or {}).items():
            entry = board.get(tag)
            found = 0 if entry is None else entry.version
            if found != wanted:
                raise No(
                    "conflict",
                    f"{tag} is at version {found}, not {wanted}: get it and try again",
                )
        before = {tag: _version(board, tag) for tag in request.tags}
        self._do(inputs.Set(request.tags, session.writer))
        after = {tag: _version(board, tag) for tag in request.tags}
        versions = {tag: version for tag, version in after.items() if version != before[tag]}
        return protocol.Written(id=request.id, versions=versions)

    def _get(self, session: Session, request: protocol.Get) -> protocol.Reply:
        board = self._robot.board
        found: dict[str, protocol.Entry] = {}
        for name in request.names:
            if "*" in name:
                _check_pattern(name)
                found.update((tag, _entry(entry)) for tag, entry in board.entries(name))
            elif not names.is_name(name):
                raise No("invalid", f"{name!r} is no tag and no pattern")
            else:
                entry = board.last_set(name)
                found[name] = protocol.Entry(
                    value=board.look(name),
                    version=0 if entry is None else entry.version,
                    writer=None if entry is None else entry.writer,
                    time=0 if entry is None else entry.time,
                )
        return protocol.Values(id=request.id, entries=found)

    def _watch(self, session: Session, request: protocol.Watch) -> protocol.Reply:
        for pattern in request.patterns:
            _check_pattern(pattern)
        found: dict[str, protocol.Entry] = {}
        state = self._robot.board.state
        for pattern in request.patterns:
            if pattern not in session.patterns:
                session.patterns.add(pattern)
                self._watching.add(pattern)
            if "*" not in pattern:
                if (entry := state.get(pattern)) is not None:
                    found[pattern] = _entry(entry)
                continue
            # Deleted ones too: their versions count on.
            for tag in sorted(state):
                if names.matches(pattern, tag):
                    found[tag] = _entry(state[tag])
        changes = dict.fromkeys(request.patterns, self._watching.n)
        return protocol.Snapshot(id=request.id, entries=found, changes=changes)

    def _unwatch(self, session: Session, request: protocol.Unwatch) -> protocol.Reply:
        for pattern in session.patterns.intersection(request.patterns):
            session.patterns.remove(pattern)
            self._watching.remove(pattern)
        return protocol.Done(id=request.id)

    def _publish(self, session: Session, request: protocol.Publish) -> protocol.Reply:
        _may_write(session)
        if not request.event.strip():
            raise No("invalid", "an event has a name")
        self._do(inputs.Raise(request.event, request.application))
        return protocol.Done(id=request.id)

    def _acquire(self, session: Session, request: protocol.Acquire) -> protocol.Reply:
        module = _acting(session, request.module)
        self._do(inputs.Acquire(module, request.resources, request.optional))
        return self._granted(request.id, module)

    def _abandon(self, session: Session, request: protocol.Abandon) -> protocol.Reply:
        module = _acting(session, request.module)
        self._do(inputs.Abandon(module, request.resources))
        return self._granted(request.id, module)

    def _granted(self, number: int, module: str) -> protocol.Reply:
        holds = self._holds(module)
        return protocol.Granted(id=number, holds=holds, seq=self.backlog.last)

    def _command(self, session: Session, request: protocol.Command) -> protocol.Reply:
        module = _acting(session, request.module)
        if request.valid is not None and request.valid <= 0:
            raise No("invalid", "for is a number of seconds above 0")
        self._do(inputs.Command(module, request.resource, request.value, request.valid))
        return protocol.Done(id=request.id)

    def _use(self, session: Session, request: protocol.Use) -> protocol.Reply:
        _may_write(session)
        self._do(inputs.Use(request.component, request.value))
        return protocol.Done(id=request.id)

    def _touch(self, session: Session, request: protocol.Touch) -> protocol.Reply:
        _may_write(session)
        self._do(inputs.Touch())
        return protocol.Done(id=request.id)

    def _finish(self, session: Session, request: protocol.Finish) -> protocol.Reply:
        _may_write(session)
        self._do(
            inputs.Finish(
                action=request.action,
                name=request.name,
                application=request.application,
                ok=request.ok,
                result=request.result,
                error=request.error,
                status=UNSET if request.status is None else request.status,
                id=request.action_id,
            )
        )
        return protocol.Done(id=request.id)

    def _trace(self, session: Session, request: protocol.Trace) -> protocol.Reply:
        self._tracing += not session.tracing
        session.tracing = True
        last = self.backlog.last
        since = last + 1 if request.since is None else max(request.since, self.backlog.first)
        lines = tuple(Raw(line) for line in self.backlog.since(since, PAGE))
        return protocol.Traced(
            id=request.id,
            events=lines,
            first=self.backlog.first,
            next=since + len(lines),
            last=last,
        )

    def _documents(self, session: Session, request: protocol.Documents) -> protocol.Reply:
        return protocol.Files(id=request.id, project=self._project.name, files=dict(self._files))

    def _modules_(self, session: Session, request: protocol.Modules) -> protocol.Reply:
        connected = {
            name: (one.resources, one.description, one.requires, one.provides)
            for name, one in self._modules.items()
        }
        states = presence.modules(self._project, connected, self._holders)
        wanted = presence.wanted(states, lambda tag: self._robot.board.get(tag) is not None)
        return protocol.ModuleStates(id=request.id, modules=states, wanted=wanted)

    def _disclose(self, session: Session, request: protocol.Disclose) -> protocol.Reply:
        if session.module is None:
            raise No("role", "only a module discloses")
        session.description = request.description or session.description
        session.requires = request.requires
        session.provides = request.provides
        return protocol.Done(id=request.id)

    def _bye(self, session: Session, request: protocol.Bye) -> protocol.Reply:
        if request.module is not None:
            if session.role != "scenario":
                raise No("role", "only a scenario speaks for other modules: leave out module")
            self._do(inputs.Lost(request.module))
        else:
            self._end(session)
        return protocol.Done(id=request.id)

    def _holds(self, module: str | None) -> tuple[str, ...]:
        if module is None:
            return ()
        return tuple(sorted(r for r, holder in self._holders.items() if holder == module))


_HANDLERS: dict[type[protocol.Request], Callable[[Sessions, Session, Any], protocol.Reply]] = {
    protocol.Heartbeat: Sessions._heartbeat,
    protocol.Set: Sessions._set,
    protocol.Get: Sessions._get,
    protocol.Watch: Sessions._watch,
    protocol.Unwatch: Sessions._unwatch,
    protocol.Publish: Sessions._publish,
    protocol.Acquire: Sessions._acquire,
    protocol.Abandon: Sessions._abandon,
    protocol.Command: Sessions._command,
    protocol.Use: Sessions._use,
    protocol.Touch: Sessions._touch,
    protocol.Finish: Sessions._finish,
    protocol.Trace: Sessions._trace,
    protocol.Documents: Sessions._documents,
    protocol.Modules: Sessions._modules_,
    protocol.Disclose: Sessions._disclose,
    protocol.Bye: Sessions._bye,
}


def _writer(hello: protocol.Hello) -> str:
    """formats.md, *Trace*: the writers."""
    if hello.role == "operator":
        return f"operator:{hello.user or 'unknown'}"
    return hello.module or hello.role


def _may_write(session: Session) -> None:
    if session.role == "viewer":
        raise No("role", "a viewer changes nothing: connect as a module or an operator")


def _acting(session: Session, named: str | None) -> str:
    """The module that a request is for."""
    if session.role == "scenario":
        if named is None:
            raise No("role", "a scenario names the module that it plays")
        return named
    if named is not None:
        raise No("role", "only a scenario speaks for other modules: leave out module")
    if session.module is None:
        raise No("role", "only a module asks for authority: connect with its name")
    return session.module


def _check_pattern(pattern: str) -> None:
    if not names.is_pattern(pattern):
        raise No("invalid", f"{pattern!r} is no tag and no pattern")


def _version(board: Board, tag: str) -> int:
    entry = board.state.get(tag)
    return 0 if entry is None else entry.version


def _entry(entry: Any) -> protocol.Entry:
    return protocol.Entry(entry.value, entry.version, entry.writer, entry.time)


def _change(effect: Changed, n: int) -> bytes:
    body = protocol.Change(
        tag=effect.tag,
        value=effect.value,
        version=effect.version,
        writer=effect.writer,
        time=effect.time,
        n=n,
    )
    return protocol.notice(protocol.change_topic(effect.tag), body)


def _message(effect: Begin) -> bytes:
    topic = str(effect.fields.get("topic", ""))
    body = protocol.Message(
        topic=topic, value=effect.fields.get("value"), application=effect.application
    )
    return protocol.notice(protocol.message_topic(topic), body)
