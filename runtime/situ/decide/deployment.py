"""How it is with the versions of a robot: which one runs, what another waits for."""

from __future__ import annotations

from msgspec import Struct


class Waits(Struct, frozen=True):
    """An action that runs: a new version waits for its end. state: where the application is.

    action, name: as in the trace.
    """

    application: str
    state: str
    action: str
    name: str | None


class Deployment(Struct, frozen=True):
    """Which version runs, and which is to.

    pending: the version that waits, for ``waits``; forced: the moment (µs) at which it does not
    any longer. former: the version that is gone back to if this one fails before ``until`` (µs).
    """

    version: int
    pending: int | None = None
    waits: tuple[Waits, ...] = ()
    forced: int | None = None
    former: int | None = None
    until: int | None = None
