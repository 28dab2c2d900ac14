"""The client for asyncio: the names of ``blocking``, to be awaited (see ``client``)."""

from __future__ import annotations

import asyncio
import contextlib
import logging
from collections.abc import AsyncIterator, Callable, Coroutine, Generator, Iterable, Mapping
from typing import Any, Generic, TypeVar

from situ.blackboard import sending
from situ.blackboard.authority import Asked
from situ.blackboard.blocking import PATIENCE, told
from situ.blackboard.calls import Call
from situ.blackboard.driving import Line
from situ.blackboard.feeds import Change, Feed
from situ.blackboard.notices import Message
from situ.blackboard.protocol import DebugVerb, Need, Offer, Request
from situ.blackboard.replies import (
    Addresses,
    AnyReply,
    Deployment,
    Entry,
    Files,
    ModuleStates,
    Outstanding,
    Turns,
)
from situ.blackboard.services import Carried
from situ.blackboard.serving import ServiceRequest
from situ.decide.expected import Expectation
from situ.errors import BlackboardError, Refused, Unreachable

T = TypeVar("T")

_log = logging.getLogger("situ.blackboard")


class AsyncBoard:
    """The blackboard in one asyncio loop; ``async with`` it, or ``await`` and ``close`` it where
    there is no block (in a notebook). See ``Board`` for what each method does."""

    def __init__(self, link: Line, timeout: float = PATIENCE) -> None:
        self.link = link
        self._dialog = link.dialog
        self._timeout = timeout
        self._loop: asyncio.AbstractEventLoop | None = None
        self._timer: asyncio.TimerHandle | None = None
        self._waiting: list[tuple[Callable[[], bool], asyncio.Future[None]]] = []

    async def __aenter__(self) -> AsyncBoard:
        self._loop = asyncio.get_running_loop()
        for descriptor in self.link.descriptors():
            self._loop.add_reader(descriptor, self._turn)
        dialog = self._dialog
        try:
            await self._until(lambda: dialog.connected or dialog.ended, self._timeout)
            if dialog.problem is not None and not dialog.connected:
                raise dialog.problem
            if not dialog.connected:
                raise self._unreachable(dialog.unreachable())
        except BaseException:
            self._shut()
            raise
        return self

    def __await__(self) -> Generator[Any, None, AsyncBoard]:
        return self.__aenter__().__await__()

    async def __aexit__(self, *_: object) -> None:
        await self.close()

    def __repr__(self) -> str:
        state = "closed" if self._dialog.ended else told(self._dialog)
        return f"<{type(self).__name__} {self.link.endpoint}, {state}>"

    # -- what stands on the board --------------------------------------------

    async def set(
        self,
        tag: str | Mapping[str, Any],
        value: Any = None,
        *,
        versions: Mapping[str, int] | None = None,
    ) -> dict[str, int]:
        tags = tag if isinstance(tag, Mapping) else {tag: value}
        return await self._answer(self._dialog.set(tags, versions))

    async def get(self, name: str) -> Any:
        entry = self._dialog.known(name)
        if entry is not None:
            return entry.value
        return await self._answer(self._dialog.get(name))

    async def entries(self, *names: str) -> dict[str, Entry]:
        return await self._answer(self._dialog.entries(names))

    def watch(
        self, pattern: str, callback: Callable[[Change], None] | None = None
    ) -> AsyncFollowing[Change]:
        """Not awaited: ``async for change in board.watch("face.*")``. With ``async with`` it stands
        from there on. What is wrong with the pattern is raised there, or at the first change."""
        watch = self._dialog.watch(pattern, callback)
        self._soon()
        return AsyncFollowing(self, watch, self._dialog.unwatch)

    def trace(
        self, since: int | None = None, callback: Callable[[dict[str, Any]], None] | None = None
    ) -> AsyncFollowing[dict[str, Any]]:
        """Not awaited, as ``watch``."""
        feed = self._dialog.trace(since, callback)
        self._soon()
        return AsyncFollowing(self, feed, self._dialog.untrace)

    # -- what happens --------------------------------------------------------

    def messages(
        self, pattern: str, callback: Callable[[Message], None] | None = None
    ) -> AsyncFollowing[Message]:
        """Not awaited, as ``watch``; heard for certain from its ``async with`` on."""
        heard = self._dialog.messages(pattern, callback)
        self._soon()
        return AsyncFollowing(self, heard, self._dialog.unlisten)

    def perform(
        self, http: str | None, callback: Callable[[Outstanding | Carried], None]
    ) -> AsyncFollowing[Outstanding | Carried]:
        """What a service (role ``service``) is to carry out. Not awaited, as ``watch``."""
        effects = self._dialog.perform(self._dialog.person.services, http, callback)
        self._soon()
        return AsyncFollowing(self, effects, lambda _: None)

    def tell(self, request: Callable[[int], Request], *, again: bool = True) -> Call[AnyReply]:
        """Any request of the protocol; not awaited. again: as of ``Call``; it waits for the next
        connection then, where there is none."""
        call = self._dialog.give(request, again)
        self._soon()
        return call

    async def publish(self, event: str, application: str | None = None) -> None:
        await self._answer(self._dialog.publish(event, application))

    async def debug(self, verb: DebugVerb, **fields: Any) -> None:
        await self._answer(self._dialog.debug(verb, **fields))

    async def use(self, component: str, *value: Any) -> None:
        await self._answer(self._dialog.use(component, *value))

    async def touch(self) -> None:
        await self._answer(self._dialog.touch())

    def requests(
        self, *names: str, callback: Callable[[ServiceRequest], None] | None = None
    ) -> AsyncFollowing[ServiceRequest]:
        """Not awaited, as ``watch``."""
        asked = self._dialog.serve(names, callback, self._do)
        self._soon()
        return AsyncFollowing(self, asked, self._dialog.unserve)

    async def serve(
        self, name: str, function: Callable[[dict[str, Any]], Coroutine[Any, Any, Any]]
    ) -> None:
        """As ``Board.serve``, several at a time; what nobody waits for any more is cancelled."""
        running: set[asyncio.Task[None]] = set()
        try:
            async with self.requests(name) as requests:
                async for request in requests:
                    task = asyncio.ensure_future(_answered(request, function))
                    running.add(task)
                    task.add_done_callback(running.discard)
                    request.withdrawn = task.cancel
        finally:
            for task in running:
                task.cancel()
            await asyncio.gather(*running, return_exceptions=True)

    def authority(self, *resources: str, optional: Iterable[str] = ()) -> AsyncAuthority:
        return AsyncAuthority(self, resources, tuple(optional))

    # -- who and what is there -----------------------------------------------

    async def modules(self) -> ModuleStates:
        return await self._answer(self._dialog.modules())

    async def documents(self) -> Files:
        return await self._answer(self._dialog.documents())

    async def deploy(
        self,
        files: Mapping[str, bytes],
        main: str | None = None,
        *,
        force_after: float | None = None,
    ) -> Deployment:
        staged = await self._answer(sending.stage(self._dialog, files, main))
        for piece in sending.pieces(files, staged.wanted):
            await self._answer(sending.send(self._dialog, piece))
        return await self._answer(sending.deploy(self._dialog, force_after))

    async def rollback(
        self, version: int | None = None, *, force_after: float | None = None
    ) -> Deployment:
        return await self._answer(sending.rollback(self._dialog, version, force_after))

    async def progress(self) -> Deployment:
        return await self._answer(sending.progress(self._dialog))

    async def history(self) -> Turns:
        return await self._answer(sending.history(self._dialog))

    async def expected(self) -> dict[str, Expectation]:
        return await self._answer(self._dialog.expected())

    async def disclose(
        self,
        description: str = "",
        requires: Iterable[Need] = (),
        provides: Iterable[Offer] = (),
    ) -> None:
        await self._answer(self._dialog.disclose(description, requires, provides))

    async def give(self, request: Callable[[int], Request]) -> AnyReply:
        """Any request of the protocol, made with the id that it must carry."""
        return await self._answer(self._dialog.give(request))

    @property
    def connected(self) -> bool:
        return self._dialog.connected

    @property
    def stopped(self) -> bool:
        return self._dialog.stopped

    @property
    def addresses(self) -> Addresses:
        assert self._dialog.welcome is not None
        return self._dialog.welcome.addresses

    @property
    def situ(self) -> str | None:
        return self._dialog.situ

    def clock(self) -> float:
        return self.link.clock()

    async def sleep(self, seconds: float) -> None:
        await self._until(lambda: False, seconds)

    async def close(self) -> None:
        if self._loop is None:
            return
        if self._dialog.connected:
            with contextlib.suppress(BlackboardError, TimeoutError):
                async with asyncio.timeout(1.0):
                    await self._answer(self._dialog.bye())
        self._shut()

    # -- waiting -------------------------------------------------------------

    async def _answer(self, call: Call[T]) -> T:
        if self._loop is None and not self._dialog.ended:
            self._dialog.lost(call)
            raise BlackboardError(
                "not connected yet: enter it first (async with situ.connect_async(…) as board)"
            )
        if not await self._until(lambda: call.finished, self._timeout):
            self._dialog.lost(call)
        if isinstance(call.error, Unreachable):
            raise self._unreachable(call.error)
        return call.result()

    def _unreachable(self, error: Unreachable) -> Unreachable:
        return Unreachable(f"{self.link.endpoint}: {error}")

    async def _until(self, ready: Callable[[], bool], within: float | None) -> bool:
        """False when ``within`` seconds are over, or the board was closed."""
        if self._loop is None:
            return ready()
        self._turn()
        if ready():
            return True
        wait = (ready, self._loop.create_future())
        self._waiting.append(wait)
        try:
            async with asyncio.timeout(within):
                await wait[1]
        except TimeoutError:
            return False
        finally:
            if wait in self._waiting:
                self._waiting.remove(wait)
        return ready()

    def _turn(self) -> None:
        """Drives the link one turn; ends the waits for what has come."""
        if self._loop is None:
            return
        if self._timer is not None:
            self._timer.cancel()
        self.link.turn()
        left = max(self.link.due() - self.link.clock(), 0)
        self._timer = self._loop.call_later(left, self._turn)
        for feed in self._dialog.following():
            callback: Callable[[Any], None] | None = feed.callback
            while callback is not None and (item := feed.take()) is not None:
                # Never from inside a turn: the callback may ask for something.
                self._loop.call_soon(callback, item)
        for ready, future in self._waiting:
            if ready() and not future.done():
                future.set_result(None)

    def _do(self, act: Callable[[], None]) -> None:
        act()
        self._soon()

    def _soon(self) -> None:
        if self._loop is not None:
            self._loop.call_soon(self._turn)

    def _shut(self) -> None:
        loop, self._loop = self._loop, None
        self._dialog.ended = True
        if loop is not None:
            for descriptor in self.link.descriptors():
                loop.remove_reader(descriptor)
        if self._timer is not None:
            self._timer.cancel()
        for _, future in self._waiting:
            if not future.done():
                future.set_result(None)
        self.link.close()


async def _answered(
    request: ServiceRequest, function: Callable[[dict[str, Any]], Coroutine[Any, Any, Any]]
) -> None:
    try:
        result = await function(request.params)
    except Exception as error:  # a fault of the module's: who asked is told, the board goes on
        _log.exception("%s failed", request.request)
        request.fail(str(error) or type(error).__name__)
    else:
        request.answer(result)


class AsyncFollowing(Generic[T]):
    """As ``Following``: ``async for`` over it, or ``close`` it where it calls back."""

    def __init__(self, board: AsyncBoard, feed: Feed[T], stop: Callable[[Any], None]) -> None:
        self._board = board
        self._feed = feed
        self._stop = stop

    async def next(self, within: float | None = None) -> T | None:
        feed = self._feed
        await self._board._until(
            lambda: len(feed) > 0 or feed.ended or feed.error is not None, within
        )
        self._check()
        return feed.take()

    async def __aenter__(self) -> AsyncFollowing[T]:
        """Waits until it is sure that nothing is missed from here on."""
        board, feed = self._board, self._feed
        heard = await board._until(lambda: feed.ready or feed.error is not None, board._timeout)
        if not heard:
            self.close()
            raise board._unreachable(board.link.dialog.unreachable())
        self._check()
        return self

    async def __aexit__(self, *_: object) -> None:
        self.close()

    async def __aiter__(self) -> AsyncIterator[T]:
        while (item := await self.next()) is not None:
            yield item

    def close(self) -> None:
        self._stop(self._feed)
        self._board._soon()

    def _check(self) -> None:
        if self._feed.error is not None:
            self.close()
            raise self._feed.error

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self._feed!r}>"


class AsyncAuthority(Asked):
    """As ``Authority``, with ``async with``."""

    def __init__(
        self, board: AsyncBoard, resources: tuple[str, ...], optional: tuple[str, ...]
    ) -> None:
        super().__init__(board.link.dialog, resources, optional)
        self._board = board

    async def __aenter__(self) -> AsyncAuthority:
        try:
            await self._board._answer(self._begin())
        except Refused:
            self._refused()
            raise
        return self

    async def __aexit__(self, *_: object) -> None:
        board, given_back = self._board, self._end()
        # Where the connection is away it is held no longer; the core is told when it is back.
        await board._until(lambda: given_back.finished or not board.connected, board._timeout)

    async def wait(self, within: float | None = None) -> bool:
        self._check()
        # Others have their turn even where nothing is to be waited for.
        await asyncio.sleep(0)
        return await self._board._until(lambda: self.held, within)

    async def wait_lost(self, within: float | None = None) -> bool:
        await asyncio.sleep(0)
        return await self._board._until(lambda: not self.held, within)

    async def command(
        self, value: Any, valid: float | None = None, resource: str | None = None
    ) -> None:
        named = self._named(resource)
        await self._board._answer(self._dialog.command(named, value, valid))
