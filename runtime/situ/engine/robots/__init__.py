"""Adapters: what moves a robot. One a file; found by entry points ``situ.robots``.

An entry point names a class (or function) that takes ``Surroundings`` and gives
an ``Adapter``. An adapter lives in the engine's event loop and never blocks it.
"""

from __future__ import annotations

import logging
from collections.abc import Callable
from importlib.metadata import entry_points
from typing import Any, Protocol

from msgspec import Struct

from situ.document.project import Project
from situ.engine.clock import Clock
from situ.errors import UsageError


class Surroundings(Struct, frozen=True):
    """What an adapter gets.

    finished(resource, ok, error): to be called once when what was last applied to the
    resource has ended by itself; ``error`` is one line in plain words, or None.
    report(tags): writes tags of the robot's own on the blackboard; None where nobody
    wants them.
    """

    project: Project
    clock: Clock
    finished: Callable[[str, bool, str | None], None]
    report: Callable[[dict[str, Any]], None] | None
    log: logging.Logger


class Adapter(Protocol):
    """Carries out what stands at ``robot/<resource>``.

    resources: those that it has. apply(resource, value): replaces what was applied
    before; None means stop and hold. A value is a command of an application,
    ``{"command": name, "params": {…}}``, or whatever the robot's modules send; one
    that the adapter does not understand is answered with ``finished(…, False, why)``.
    """

    @property
    def resources(self) -> frozenset[str]: ...

    def apply(self, resource: str, value: Any) -> None: ...

    async def start(self) -> None: ...

    async def close(self) -> None: ...


def find(name: str) -> Callable[[Surroundings], Adapter]:
    """The adapter of that name. Raises UsageError naming those installed."""
    if name == "sim":
        # Works without an installed distribution too.
        from situ.engine.robots.sim import SimulatedRobot

        return SimulatedRobot
    installed = entry_points(group="situ.robots")
    for entry in installed:
        if entry.name == name:
            try:
                made: Callable[[Surroundings], Adapter] = entry.load()
            except (ImportError, AttributeError) as error:
                raise UsageError(f"the robot adapter {name} can not be loaded: {error}") from error
            return made
    names = ", ".join(sorted({entry.name for entry in installed} | {"sim"}))
    raise UsageError(f"there is no robot adapter {name!r}; installed: {names}")
