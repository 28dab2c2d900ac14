"""A ``Robot`` with those who look at it: each step's effects become notices.

No I/O. One of these is the core of a running robot; sessions stand round it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from typing import Any, Protocol

from msgspec import Raw, Struct

from situ.blackboard import masked, notices, protocol, replies, topics, wire
from situ.blackboard.asking import Asking
from situ.blackboard.backlog import Backlog, stamped
from situ.blackboard.history import AnySessionEvent, Past
from situ.blackboard.presence import Disclosed
from situ.blackboard.services import PATIENCE, Carried, asked_of, carried_by
from situ.blackboard.watching import Watching
from situ.decide import inputs, trace
from situ.decide.board import Board
from situ.decide.effects import AnyEffect, Begin, Changed, Refuse
from situ.decide.expected import Expectation
from situ.decide.masking import Mask
from situ.decide.step import SECOND
from situ.document.project import Project

Heard = Callable[[list[trace.TraceEvent], float], None]
"""Is told each step's trace events, with the UNIX time."""

Taken = Callable[[int, inputs.AnyInput | None, list[trace.TraceEvent], float], None]
"""Is told each step: the robot's time in µs, its input, its trace events, the UNIX time."""


class Decider(Protocol):
    """The part of ``situ.decide.robot.Robot`` that sessions need."""

    @property
    def board(self) -> Board: ...

    def step(
        self, given: inputs.AnyInput | None, now: int, /
    ) -> tuple[list[trace.TraceEvent], list[AnyEffect]]: ...

    def due(self) -> int | None: ...

    def outstanding(self) -> Sequence[Carried]: ...

    def expected(self) -> dict[str, Expectation]: ...


class Durability(Protocol):
    """The part of ``situ.blackboard.journal.DurableTags`` that the core needs."""

    @property
    def durable(self) -> Mapping[str, bool]: ...

    def refusal(self, tags: Iterable[str], /) -> str | None: ...


class Deployer(Protocol):
    """The part of ``situ.engine.deploy.Deployer`` that the core needs."""

    @property
    def version(self) -> int: ...

    def answer(self, request: protocol.Deploying, who: str, session: str, /) -> replies.Reply:
        """Raises Refused."""

    def left(self, session: str, /) -> None:
        """That session has ended."""

    def swapped(self, events: list[trace.TraceEvent], /) -> None:
        """Another version runs; events: of the step."""


class Held(Struct):
    """A reply that leaves when what it acknowledges is kept; ``no`` if that fails."""

    peer: Hashable
    reply: bytes
    request: int | None

    def no(self, why: str) -> bytes:
        """The reply in its place."""
        message = (
            f"durable tags could not be kept ({why}): what was set stands on the blackboard, "
            "but not after a restart; make room on the robot's disk and set it again"
        )
        return wire.encode(replies.Refused(id=self.request, code="refused", message=message))


class Outgoing(Struct):
    """In the order in which they must leave, each list by itself.

    past: what happened, to be written down before anything leaves. durable: changes to be
    kept, before which nothing of ``held`` may leave.
    """

    replies: list[tuple[Hashable, bytes]] = []
    notices: list[bytes] = []
    effects: list[Carried] = []
    past: list[Past] = []
    durable: list[Changed] = []
    held: list[Held] = []


class Core:
    """The robot's time, and what leaves it.

    moment: its time in µs. epoch: UNIX time of 0 µs by the clock that ``now`` (µs) is read
    from; both differ from ``moment`` only where a scenario gives the time. files: path to
    text of the project's files. modules: those connected; holders: resource to module.
    tracing: how many follow the trace, by whether it is masked. performing: how many carry out
    each service elsewhere;
    effects: how many effects each service was given, by whomever it is carried out. asking: what
    modules are asked; patience: seconds that they have to answer. heard: as ``Heard``, None:
    nobody is told; taken: as ``Taken``. deployer: None where nothing can be deployed. remembers:
    whether what happens is put into ``Outgoing.past``.
    """

    def __init__(
        self,
        robot: Decider,
        project: Project,
        *,
        epoch: float = 0.0,
        files: Mapping[str, str] | None = None,
        heard: Heard | None = None,
        backlog: Backlog | None = None,
        durability: Durability | None = None,
        patience: float = PATIENCE,
    ) -> None:
        self.project = project
        self.files = files or {}
        self.backlog = backlog if backlog is not None else Backlog()
        self.watching = Watching()
        self.modules: dict[str, Disclosed] = {}
        self.holders: dict[str, str | None] = {}
        self.tracing: Counter[bool] = Counter()
        self.performing: Counter[str] = Counter()
        self.effects: Counter[str] = Counter()
        self.asking = Asking(self._is_asked, patience)
        self.moment = 0
        self.now = 0
        self.epoch = epoch
        self.heard = heard
        self.taken: Taken | None = None
        self.deployer: Deployer | None = None
        self.remembers = False
        self._robot = robot
        self._durability = durability
        self._durable = durability.durable if durability is not None else None
        self._out = Outgoing()
        self._mask: Mask | None = None
        self._private: tuple[str, ...] = ()

    def hides(self, role: protocol.Role) -> bool:
        """Whether there is something that this role is not shown everywhere."""
        return bool(self.project.private) and bool(topics.masked(role))

    def mask(self) -> Mask:
        """Hides what is private; made when it is first asked for, and kept up from then on."""
        if self._mask is None or self._private is not self.project.private:
            self._private = self.project.private
            self._mask = masked.learned(self.project, self.board, self.backlog)
        return self._mask

    @property
    def board(self) -> Board:
        return self._robot.board

    def expected(self) -> dict[str, Expectation]:
        """What each application expects now."""
        return self._robot.expected()

    def due(self) -> int | None:
        """When the robot does something by itself, in µs of its time."""
        return self._robot.due()

    def move(self, moment: int) -> None:
        """Moves the robot's time there, doing what falls due up to and at it, in order."""
        while (due := self._robot.due()) is not None and due <= moment:
            self.moment = max(self.moment, due)
            self.step(None)
        self.moment = max(self.moment, moment)

    def begin(self, start: inputs.Start) -> None:
        """The first step of a run. What it only restores, and what the project's files say,
        need not be kept again."""
        self.step(start)
        out = self._out
        given = {tag: entry[1] for tag, entry in start.restored.items()}
        given |= {tag: 1 for tag in self.project.tags if tag not in given}
        out.durable = [change for change in out.durable if change.version != given.get(change.tag)]

    def step(self, given: inputs.AnyInput | None) -> str | None:
        """One step of the robot; why the input was refused, or None."""
        events, effects = self._robot.step(given, self.moment)
        if events:
            self._traced(events)
        if self.taken is not None:
            self.taken(self.moment, given, events, self.epoch + self.now / SECOND)
        refused = None
        out = self._out
        if self.remembers:
            out.past.append((self.moment, given))
        for effect in effects:
            if isinstance(effect, Changed):
                if self._durable is not None and self._durable[effect.tag]:
                    out.durable.append(effect)
                if self.watching.changed(effect.tag):
                    out.notices.append(_change(effect))
                    if self._mask is not None and self.watching.is_masked(effect.tag):
                        out.notices.append(_masked_change(self.mask(), effect))
            elif isinstance(effect, Refuse):
                refused = effect.message
            else:
                out.effects.append(effect)
                self._hand_on(effect)
                if isinstance(effect, Begin) and effect.action == "message":
                    out.notices.append(_message(effect))
                    if self._mask is not None:
                        out.notices.append(_masked_message(self.mask(), effect))
                elif isinstance(effect, Begin) and asked_of(effect) is not None:
                    self.asking.begin(effect, self.now, self.modules)
        if self.asking and any(type(event) in _ENDS for event in events):
            self.asking.keep(self._robot.outstanding())
        return refused

    def outstanding(self) -> Sequence[Carried]:
        """What is to be carried out by who has carried out nothing yet."""
        return self._robot.outstanding()

    def ask_again(self) -> None:
        """After a restore: what modules were being asked."""
        self.asking.clear()
        for effect in self._robot.outstanding():
            if isinstance(effect, Begin) and asked_of(effect) is not None:
                self.asking.begin(effect, self.now, self.modules)

    def _is_asked(self, module: str) -> None:
        body = notices.Asked(count=self.asking.counts[module])
        self._out.notices.append(wire.notice(topics.asked(module), body))

    def holds(self, module: str | None) -> tuple[str, ...]:
        """The resources that the module holds, sorted."""
        if module is None:
            return ()
        return tuple(sorted(r for r, holder in self.holders.items() if holder == module))

    def remember(self, event: AnySessionEvent) -> None:
        """A session changed."""
        if self.remembers:
            self._out.past.append((self.moment, event))

    def unkeepable(self, tags: Iterable[str]) -> str | None:
        """Why these tags can not be set because they are durable; None where they can."""
        return self._durability.refusal(tags) if self._durability is not None else None

    def reply(self, peer: Hashable, reply: replies.Reply) -> None:
        """A reply leaves after the notices of what it answers; one that acknowledges durable
        tags when they are kept."""
        body = wire.encode(reply)
        if self._out.durable and isinstance(reply, replies.Written) and self._is_held(reply):
            self._out.held.append(Held(peer, body, reply.id))
        else:
            self._out.replies.append((peer, body))

    def _is_held(self, reply: replies.Written) -> bool:
        return self._durable is not None and any(self._durable[tag] for tag in reply.versions)

    def end(self) -> None:
        """Tells all that the runtime stops."""
        self._out.notices.append(wire.notice(topics.END, notices.End()))

    def take(self) -> Outgoing:
        """What is to be sent and carried out since the last call."""
        out = self._out
        self._out = Outgoing()
        return out

    def _hand_on(self, effect: Carried) -> None:
        for service in carried_by(effect):
            self.effects[service] += 1
            if self.performing[service]:
                number = self.effects[service]
                body = notices.Effect(service=service, number=number, does=effect)
                self._out.notices.append(wire.notice(topics.effect(service), body))

    def _traced(self, events: list[trace.TraceEvent]) -> None:
        at = self.epoch + self.now / SECOND
        self.backlog.add(events, at)
        if self._mask is not None:
            for event in events:
                if type(event) is trace.Data:
                    self._mask.know(event.tag, event.value)
        if self.heard is not None:
            self.heard(events, at)
        swapped = False
        for event in events:
            if type(event) is trace.Deployed:
                swapped = True
            elif type(event) is trace.Authority:
                self.holders[event.resource] = event.to
                passed = notices.Authority(
                    resource=event.resource, source=event.source, to=event.to, seq=event.seq
                )
                topic = topics.authority(event.resource)
                self._out.notices.append(wire.notice(topic, passed))
        if swapped and self.deployer is not None:
            self.deployer.swapped(events)
        if self.tracing[False]:
            lines = tuple(Raw(stamped(event, at)) for event in events)
            body = notices.Events(events=lines)
            self._out.notices.append(wire.notice(topics.TRACE, body))
        if self.tracing[True]:
            shown = masked.events(self.mask(), (stamped(event, at) for event in events))
            body = notices.Events(events=shown)
            self._out.notices.append(wire.notice(topics.MASKED + topics.TRACE, body))


_ENDS = (trace.Finished, trace.Cancelled)


def _change(effect: Changed) -> bytes:
    return wire.notice(topics.change(effect.tag), _changed(effect, effect.value))


def _masked_change(mask: Mask, effect: Changed) -> bytes:
    body = _changed(effect, mask.shown(effect.tag, effect.value, effect.writer))
    return wire.notice(topics.MASKED + topics.change(effect.tag), body)


def _changed(effect: Changed, value: Any) -> notices.Change:
    return notices.Change(
        tag=effect.tag,
        value=value,
        version=effect.version,
        writer=effect.writer,
        time=effect.time,
    )


def _message(effect: Begin) -> bytes:
    topic, body = _sent(effect, effect.fields.get("value"))
    return wire.notice(topic, body)


def _masked_message(mask: Mask, effect: Begin) -> bytes:
    topic, body = _sent(effect, mask.shown("", effect.fields.get("value")))
    return wire.notice(topics.MASKED + topic, body)


def _sent(effect: Begin, value: Any) -> tuple[bytes, notices.Message]:
    topic = str(effect.fields.get("topic", ""))
    body = notices.Message(topic=topic, value=value, application=effect.application)
    return topics.message(topic), body
