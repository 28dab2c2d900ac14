"""Who carries out what a core decides, as those who drive him know him."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from situ.blackboard.curve import KeysOf
from situ.blackboard.replies import Addresses
from situ.blackboard.services import Carried
from situ.decide import inputs
from situ.document.project import Project

Submit = Callable[[inputs.AnyInput], None]


class Performing(Protocol):
    """The part of ``situ.engine.perform.Performer`` that every driver needs."""

    @property
    def screen_url(self) -> str | None: ...

    async def start(self) -> None: ...

    def open_door(self, addresses: Addresses, keys: KeysOf | None) -> None: ...

    def turn_to(self, project: Project) -> None: ...

    def perform(self, effect: Carried) -> None: ...

    async def close(self) -> None: ...
