"""Services apart: carries out here what a core in another process, or on another machine, decides.

The effects come over the blackboard (docs/protocol.md, *Carrying out what the robot decides*)
and go to the same performer as in the core's own process; what that answers goes back.
"""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Awaitable, Callable, Collection
from typing import Any, Protocol

from msgspec.structs import replace

from situ.blackboard import protocol, replies
from situ.blackboard.asynchronous import AsyncBoard
from situ.blackboard.curve import KeysOf
from situ.blackboard.feeds import Change
from situ.blackboard.link import reachable
from situ.blackboard.replies import Addresses
from situ.blackboard.services import Carried
from situ.decide import inputs
from situ.decide.effects import Begin, Cancel, Map
from situ.document.project import Project
from situ.engine.performing import Performing, Submit
from situ.errors import SituError

PATIENCE = 4.0
"""Seconds after which it is told that no core answers yet."""

_MEDIA = frozenset({"engine", "screen"})
"""The services that need the files of the project."""
Fetch = Callable[[AsyncBoard], Awaitable[tuple[int, Project]]]

_log = logging.getLogger("situ.run")


class PerformingApart(Performing, Protocol):
    """The part that is needed here."""

    def hold(self) -> None: ...

    def caption(self, said: Any) -> None: ...


class ServicesApart:
    """Some services in this process, from ``start`` to ``stop``; the core may come and go.

    board: not yet entered, of a ``Person`` with the role service and these services.
    performer(submit, tag) makes who carries out effects; tag reads what it must know of the
    blackboard. door: whose keys the screen's WebSocket door takes. fetch: gives the version that
    the core runs, and its project here (``situ.engine.fetching``).

    While the core is away what runs goes on, but for the robot: it stops and holds. What was
    carried out in vain is carried out again when the core is back; what goes on is left alone.
    """

    def __init__(
        self,
        board: AsyncBoard,
        services: Collection[str],
        performer: Callable[[Submit, Callable[[str], Any]], PerformingApart],
        door: KeysOf | None = None,
        fetch: Fetch | None = None,
    ) -> None:
        self._board = board
        self._fetch = fetch
        self._fetching: asyncio.Task[None] | None = None
        # Of which the performer has the files.
        self._version = 0
        self._dialog = board.link.dialog
        self._services = frozenset(services)
        self._make = performer
        self._door = door
        self._performer: PerformingApart
        self._runtime: str | None = None
        # Why there is no core, as it was told last; None while there is one.
        self._problem: str | None = None
        # What was last applied to each resource, and all actions that were given to the
        # performer and have not ended.
        self._applied: dict[str, Map] = {}
        self._given: set[int] = set()
        self._begun: set[int] = set()

    async def start(self) -> Addresses:
        """Opens what the services need and waits for the core, however long that takes; the
        addresses that clients need.

        Raises Refused where the core will not have these services, and what the performer's
        start raises.
        """
        dialog = self._dialog
        self._tags = [dialog.watch(name, _nothing) for name in ("language", "speech.*")]
        if "screen" in self._services and "engine" not in self._services:
            dialog.watch("robot/speech", self._said)
        self._performer = self._make(self._submit, self._tag)
        await self._performer.start()
        late = asyncio.get_running_loop().call_later(
            PATIENCE, _log.warning, "%s: no core answers yet; waiting", self._board.link.endpoint
        )
        try:
            dialog.changed = self._changed
            effects = self._board.perform(self._performer.screen_url, self._do)
            await self._board.__aenter__()
            await effects.__aenter__()
        except BaseException:
            await self._performer.close()
            raise
        finally:
            late.cancel()
        return self._addresses()

    async def stop(self) -> None:
        """Holds the robot, ends what runs, and says goodbye to the core."""
        self._dialog.changed = None
        if self._fetching is not None:
            self._fetching.cancel()
            await asyncio.gather(self._fetching, return_exceptions=True)
        await self._performer.close()
        await self._board.close()

    def _addresses(self) -> Addresses:
        welcome = self._dialog.welcome
        assert welcome is not None
        endpoint = self._board.link.endpoint
        told = welcome.addresses
        http = self._performer.screen_url
        return replace(
            told,
            requests=endpoint,
            notifications=reachable(told.notifications, endpoint),
            http=told.http if http is None else http,
        )

    def _changed(self) -> None:
        """The connection came or went, or the core is another one."""
        if not self._dialog.connected:
            self._alone()
            return
        welcome = self._dialog.welcome
        assert welcome is not None
        self._problem = None
        if self._runtime not in (None, welcome.runtime):
            # The robot began anew: nothing of before means anything any longer.
            _log.warning("the core was started anew: what the one before had begun is ended")
            self._end_all()
        self._runtime = welcome.runtime
        self._performer.open_door(self._addresses(), self._door)
        self._look_for_version()

    def _look_for_version(self) -> None:
        """Another version runs at the core: its files are needed here."""
        if self._fetch is None or self._fetching is not None:
            return
        if _MEDIA & self._services and self._dialog.deployed not in (None, self._version):
            self._fetching = asyncio.create_task(self._turn_to(self._fetch))

    async def _turn_to(self, fetch: Fetch) -> None:
        wanted = self._dialog.deployed
        try:
            self._version, project = await fetch(self._board)
            self._performer.turn_to(project)
        except (SituError, OSError) as error:
            _log.error("the media of version %s are missing here: %s", wanted, error)
            return
        finally:
            self._fetching = None
        self._look_for_version()

    def _alone(self) -> None:
        problem = str(self._dialog.problem or "it does not answer")
        if problem != self._problem:
            _log.warning("%s: without the core: %s", self._board.link.endpoint, problem)
        first, self._problem = self._problem is None, problem
        if first and "robot" in self._services:
            self._hold()

    def _hold(self) -> None:
        self._performer.hold()
        for resource in [r for r in self._applied if r not in ("speech", "screen")]:
            del self._applied[resource]

    def _end_all(self) -> None:
        for number in self._begun:
            self._performer.perform(Cancel(number))
        for resource in self._applied:
            self._performer.perform(Map(resource, None, None))
        self._applied.clear()
        self._begun.clear()
        self._given.clear()

    # -- what the core decides -----------------------------------------------

    def _do(self, item: replies.Outstanding | Carried) -> None:
        if not self._dialog.connected:
            # It is in what will be outstanding.
            return
        if isinstance(item, replies.Outstanding):
            self._take_up(item)
        elif isinstance(item, Map):
            self._apply(item)
        elif isinstance(item, Begin):
            self._begin(item)
        else:
            self._begun.discard(item.id)
            self._given.discard(item.id)
            self._performer.perform(item)

    def _take_up(self, outstanding: replies.Outstanding) -> None:
        """Makes what runs here what is outstanding."""
        stands = {e.resource: e for e in outstanding.effects if isinstance(e, Map)}
        begun = {e.id: e for e in outstanding.effects if isinstance(e, Begin)}
        for number in self._begun - begun.keys():
            self._do(Cancel(number))
        for resource, last in self._applied.items():
            if resource not in stands and last.value is not None:
                stands[resource] = Map(resource, None, None)
        for resource, effect in stands.items():
            before = self._applied.get(resource)
            going_on = (
                before is not None
                and before.value == effect.value
                and set(effect.actions) <= {0, *before.actions}
            )
            if not going_on:
                self._apply(effect)
        for number, begin in begun.items():
            if number not in self._begun:
                self._begin(begin)

    def _apply(self, effect: Map) -> None:
        self._applied[effect.resource] = effect
        self._given.update(effect.actions)
        self._performer.perform(effect)

    def _begin(self, effect: Begin) -> None:
        self._begun.add(effect.id)
        self._given.add(effect.id)
        self._performer.perform(effect)

    # -- what is answered ----------------------------------------------------

    def _submit(self, given: inputs.AnyInput) -> None:
        tell = self._board.tell
        if isinstance(given, inputs.Finish):
            self._finish(given)
        elif isinstance(given, inputs.Set):
            tags, writer = given.tags, given.writer
            tell(lambda number: protocol.Set(id=number, tags=tags, writer=writer))
        elif not self._dialog.connected:
            # What a person did to a screen that is no longer the robot's.
            return
        elif isinstance(given, inputs.Use):
            component, value = given.component, given.value
            tell(
                lambda number: protocol.Use(id=number, component=component, value=value),
                again=False,
            )
        elif isinstance(given, inputs.Touch):
            tell(lambda number: protocol.Touch(id=number), again=False)
        elif isinstance(given, inputs.Attend):
            tell(lambda number: protocol.Attend(id=number), again=False)

    def _finish(self, given: inputs.Finish) -> None:
        number = given.id
        if number is None or number not in self._given:
            return

        def ended() -> None:
            if call.error is None and self._runtime == runtime:
                self._given.discard(number)
                self._begun.discard(number)

        runtime = self._runtime
        call = self._board.tell(
            lambda id: protocol.Finish(
                id=id,
                action_id=number,
                ok=given.ok,
                result=given.result,
                error=given.error,
                status=given.status,
            )
        )
        call.then(ended)

    def _tag(self, name: str) -> Any:
        for watch in self._tags:
            entry = watch.known.get(name)
            if entry is not None:
                return entry.value
        return None

    def _said(self, change: Change) -> None:
        self._performer.caption(change.value)


def _nothing(change: Change) -> None:
    """It is read where it is needed."""
