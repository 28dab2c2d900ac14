"""Who is connected to a core, and all that the core does because of it.

A core that comes back after it was killed has its register again: as it stood, and with every
``SessionEvent`` since.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import Any

from situ.blackboard.acting import Session
from situ.blackboard.core import Core
from situ.blackboard.history import (
    Acting,
    Ended,
    Opened,
    Performing,
    SessionEvent,
    Standing,
    Told,
    Traced,
    Unwatched,
    Watched,
)


class Register:
    """sessions: by their connections; one that came back and has none yet stands at a name of its
    own."""

    def __init__(self, core: Core) -> None:
        self.sessions: dict[Hashable, Session] = {}
        self._core = core

    def add(self, session: Session) -> None:
        """A session begins; what it is not to see is hidden from it from here on."""
        session.masked = self._core.hides(session.role)
        if session.is_blind:
            # Messages are heard without asking.
            self._core.mask()
        self.sessions[session.peer] = session

    def remove(self, session: Session) -> None:
        """A session is over; nothing is watched, traced or performed for it any longer."""
        del self.sessions[session.peer]
        session.unwatch(tuple(session.patterns), self._core.watching)
        self._core.tracing[session.masked] -= session.tracing
        if session.performing:
            self._core.performing.subtract(session.services)
        if session.module is not None:
            del self._core.modules[session.module]

    # -- after a restart -----------------------------------------------------

    def standing(self) -> list[Standing]:
        """All sessions, without their connections."""
        return [
            Standing(
                one.id,
                one.role,
                one.module,
                one.writer,
                tuple(sorted(one.patterns)),
                one.tracing,
                one.services,
                one.performing,
                one.acts,
            )
            for one in self.sessions.values()
        ]

    def stand(self, one: Standing) -> None:
        """Has the session again, without a connection; what its module disclosed stands apart."""
        session = Session(
            id=one.id,
            peer=("gone", one.id),
            role=one.role,
            module=one.module,
            writer=one.writer,
            heard=0,
            tracing=one.tracing,
            services=one.services,
            performing=one.performing,
            acts=one.acts,
        )
        self.add(session)
        session.watch(one.patterns, self._core.watching)
        self._core.tracing[session.masked] += one.tracing
        if one.performing:
            self._core.performing.update(one.services)

    def do_again(self, event: SessionEvent) -> None:
        """What had changed a session changes it once more."""
        _AGAIN[type(event)](self, event)

    def _find(self, event: SessionEvent) -> Session:
        return next(one for one in self.sessions.values() if one.id == event.session)

    def _opened(self, event: Opened) -> None:
        self.stand(
            Standing(
                event.session, event.role, event.module, event.writer, (), False, event.services
            )
        )
        if event.module is not None and event.disclosed is not None:
            self._core.modules[event.module] = event.disclosed

    def _ended(self, event: Ended) -> None:
        self.remove(self._find(event))

    def _watched(self, event: Watched) -> None:
        self._find(event).watch(event.patterns, self._core.watching)

    def _unwatched(self, event: Unwatched) -> None:
        self._find(event).unwatch(event.patterns, self._core.watching)

    def _traced(self, event: Traced) -> None:
        session = self._find(event)
        session.tracing = True
        self._core.tracing[session.masked] += 1

    def _performing(self, event: Performing) -> None:
        session = self._find(event)
        session.performing = True
        self._core.performing.update(session.services)

    def _acting(self, event: Acting) -> None:
        self._find(event).acts = True

    def _told(self, event: Told) -> None:
        module = self._find(event).module
        assert module is not None
        self._core.modules[module] = event.disclosed


_AGAIN: dict[type[SessionEvent], Callable[[Register, Any], None]] = {
    Opened: Register._opened,
    Ended: Register._ended,
    Watched: Register._watched,
    Unwatched: Register._unwatched,
    Traced: Register._traced,
    Performing: Register._performing,
    Acting: Register._acting,
    Told: Register._told,
}
