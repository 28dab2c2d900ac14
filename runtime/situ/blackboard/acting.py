"""One client of a core, and in whose name it does what it asks (docs/protocol.md, *Sessions*)."""

from __future__ import annotations

from collections.abc import Hashable, Iterable

from msgspec import Struct

from situ.blackboard import protocol, replies
from situ.blackboard.core import Core
from situ.blackboard.history import Acting
from situ.blackboard.identity import Identity
from situ.blackboard.protocol import LEASE, LONG_LEASE
from situ.blackboard.watching import Watching

OPERATOR = "operator"
"""The module for which operators may ask for authority, where the script knows it."""


class Session(Struct):
    """One client. heard: µs, when it was last heard of. performing: whether it is told what its
    services are to carry out; heeded: whether its answers count, which they do not where a
    scenario says what ends and what is measured. http: where its screen is. identity: by whose
    key it came, None without keys. masked: whether it is not shown what is private: a viewer
    nowhere, a module not in the trace. acts: whether this operator has asked for authority."""

    id: str
    peer: Hashable
    role: protocol.Role
    module: str | None
    writer: str
    heard: int
    patterns: set[str] = set()
    tracing: bool = False
    services: tuple[str, ...] = ()
    performing: bool = False
    heeded: bool = True
    http: str | None = None
    identity: Identity | None = None
    masked: bool = False
    acts: bool = False

    @property
    def lease(self) -> float:
        """Seconds that it is believed after it was last heard of; less once it acts."""
        long = self.role in ("viewer", "operator") and not self.acts
        return LONG_LEASE if long else LEASE

    @property
    def is_blind(self) -> bool:
        """Whether private values are hidden from it wherever they stand."""
        return self.masked and self.role == "viewer"

    def watch(self, patterns: Iterable[str], watching: Watching) -> None:
        """patterns: none that it watches already."""
        for pattern in patterns:
            self.patterns.add(pattern)
            watching.add(pattern, self.is_blind)

    def unwatch(self, patterns: Iterable[str], watching: Watching) -> None:
        for pattern in patterns:
            self.patterns.remove(pattern)
            watching.remove(pattern, self.is_blind)


class No(Exception):
    """A request is refused."""

    def __init__(self, code: replies.Code, message: str) -> None:
        super().__init__(message)
        self.code = code


def may_write(session: Session) -> None:
    """Raises ``No`` where it may only look."""
    if session.role == "viewer":
        raise No("role", "a viewer changes nothing: connect as a module or an operator")


def has_a_screen(session: Session) -> None:
    """Raises ``No`` where nobody can use a screen there."""
    may_write(session)
    if session.services and "screen" not in session.services:
        raise No("role", "this service has no screen that anybody could use")


def writes_as(core: Core, session: Session, request: protocol.Set) -> str:
    """In whose name it is written. Raises ``No``."""
    may_write(session)
    if not session.services:
        if request.writer is not None:
            raise No("role", "only a service writes in another's name: leave out writer")
        return session.writer
    names = {"robot": core.project.adapter, "screen": "screen"}
    able = [names[service] for service in session.services if service in names]
    if request.writer not in able:
        raise No(
            "role", f"this service writes as {' or '.join(able) or 'nobody'}: say so in writer"
        )
    assert request.writer is not None
    return request.writer


def acts_as(core: Core, session: Session, named: str | None) -> str:
    """The module that a request is for. Raises ``No``."""
    if session.role == "scenario":
        if named is None:
            raise No("role", "a scenario names the module that it plays")
        return named
    if named == OPERATOR and session.role == "operator":
        if OPERATOR in core.modules:
            raise No("name", f"a module {OPERATOR} is connected: it speaks for itself")
        if not session.acts:
            session.acts = True
            core.remember(Acting(session.id))
        return OPERATOR
    if named is not None:
        raise No("role", "only a scenario speaks for other modules: leave out module")
    if session.module is None:
        raise No("role", "only a module asks for authority: connect with its name")
    return session.module
