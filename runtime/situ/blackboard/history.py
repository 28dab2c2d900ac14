"""What happened in a core and its sessions, as values that can be written and done again.

A core that was killed comes back as its last snapshot with the history since (docs,
*How the core comes back*). Only what changes something is in it: no heartbeat, no question.
"""

from __future__ import annotations

from msgspec import Struct

from situ.blackboard.presence import Disclosed
from situ.blackboard.protocol import Role
from situ.decide.inputs import AnyInput


class SessionEvent(
    Struct, frozen=True, tag_field="verb", tag=lambda name: f"session {name.lower()}"
):
    """The base: something that changed a session. The robot's inputs stand beside it."""

    session: str


class Opened(SessionEvent, frozen=True):
    role: Role
    module: str | None
    writer: str
    disclosed: Disclosed | None
    services: tuple[str, ...] = ()


class Ended(SessionEvent, frozen=True):
    pass


class Watched(SessionEvent, frozen=True):
    patterns: tuple[str, ...]


class Unwatched(SessionEvent, frozen=True):
    patterns: tuple[str, ...]


class Traced(SessionEvent, frozen=True):
    pass


class Performing(SessionEvent, frozen=True):
    """A service is told what to carry out from here on."""


class Acting(SessionEvent, frozen=True):
    """An operator asks for authority."""


class Told(SessionEvent, frozen=True):
    """A module disclosed more of itself."""

    disclosed: Disclosed


AnySessionEvent = Opened | Ended | Watched | Unwatched | Traced | Performing | Acting | Told

Past = tuple[int, AnyInput | AnySessionEvent | None]
"""The robot's moment, and what happened then; None: time alone brought something about."""


class Standing(Struct):
    """A session without its connection."""

    id: str
    role: Role
    module: str | None
    writer: str
    patterns: tuple[str, ...]
    tracing: bool
    services: tuple[str, ...] = ()
    performing: bool = False
    acts: bool = False


class SessionsState(Struct):
    """All that a core's sessions know. changes: as ``Watching`` counts them; effects: as ``Core``
    does."""

    runtime: str
    sessions: list[Standing]
    modules: dict[str, Disclosed]
    holders: dict[str, str | None]
    changes: dict[str, int]
    moment: int
    effects: dict[str, int] = {}
