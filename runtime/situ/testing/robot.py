"""The robot in memory (``situ.testing``)."""

from __future__ import annotations

import asyncio
import contextlib
import inspect
import threading
from collections.abc import Callable, Coroutine, Iterable, Mapping
from functools import partial
from typing import Any, TypeVar

from situ.blackboard.blocking import PATIENCE
from situ.blackboard.client import AsyncBoard, Board, Need, Offer, person
from situ.blackboard.protocol import HEARTBEAT, LEASE, Role
from situ.decide import inputs
from situ.document.project import Project
from situ.errors import BlackboardError, Refused
from situ.testing.memory import MemoryDriver
from situ.testing.shared_time import COMPUTING, Loop
from situ.testing.world import World

T = TypeVar("T")


class Robot:
    """A core with its sessions, and virtual time that a test moves.

    What the test does has its consequences before the call returns: every module that was
    started has computed until it waits again. Time passes only by ``pass_time``, ``until``,
    ``lose`` and the like, and where the test's own thread waits on a board of its own. Threads
    that a module starts itself take part only while they wait on a board.
    """

    def __init__(self, project: Project, seed: int = 0, auto_finish: float | None = None) -> None:
        self.project = project
        self._world = World(project, seed, auto_finish)
        self._time = self._world.time
        self._threads: list[threading.Thread] = []
        self._ends: list[Callable[[], None]] = []

    # -- modules -------------------------------------------------------------

    def connect(
        self,
        module: str | None = None,
        resources: Iterable[str] = (),
        *,
        role: Role | None = None,
        description: str = "",
        requires: Iterable[Need] = (),
        provides: Iterable[Offer] = (),
        timeout: float = PATIENCE,
    ) -> Board:
        """As ``situ.connect``; timeout counts in the robot's time."""
        line = self._world.line(
            person(
                module,
                resources,
                role=role,
                description=description,
                requires=requires,
                provides=provides,
            ),
            looped=False,
        )
        return Board(MemoryDriver(line, self._time), timeout)

    def connect_async(
        self,
        module: str | None = None,
        resources: Iterable[str] = (),
        *,
        role: Role | None = None,
        description: str = "",
        requires: Iterable[Need] = (),
        provides: Iterable[Offer] = (),
        timeout: float = PATIENCE,
    ) -> AsyncBoard:
        """As ``situ.connect_async``, for what ``start`` or ``run`` runs."""
        line = self._world.line(
            person(
                module,
                resources,
                role=role,
                description=description,
                requires=requires,
                provides=provides,
            ),
            looped=True,
        )
        return AsyncBoard(line, timeout)

    def start(self, program: Callable[..., Any], board: Board | AsyncBoard, *more: Any) -> None:
        """Runs ``program(board, *more)`` beside the test, in a thread of its own, until it ends or
        the robot is closed; a coroutine function in a loop of its own, within ``async with
        board``. What it raises is raised in the test."""
        main = (
            partial(self._looped, program, board, *more)
            if isinstance(board, AsyncBoard)
            else partial(self._threaded, program, board, *more)
        )
        started = threading.Event()

        def run() -> None:
            self._time.join()
            started.set()
            try:
                main()
            except BaseException as error:
                if not self._time.over:
                    self._world.failures.append(error)
            finally:
                self._time.leave()

        name = board.__class__.__name__
        thread = threading.Thread(target=run, name=f"{program.__name__} of {name}", daemon=True)
        self._threads.append(thread)
        thread.start()
        started.wait(COMPUTING)
        self._settle()

    def run(self, test: Coroutine[Any, Any, T]) -> T:
        """Runs a test that awaits. In it time passes with ``await asyncio.sleep(…)``."""
        with asyncio.Runner(loop_factory=lambda: Loop(self._time)) as runner:
            return runner.run(test)

    # -- the world -----------------------------------------------------------

    def set(self, tag: str | Mapping[str, Any], value: Any = None) -> None:
        """What sensors would write: one tag, or all of a mapping at once; None deletes."""
        self.give(inputs.Set(dict(tag) if isinstance(tag, Mapping) else {tag: value}, "scenario"))

    def publish(self, event: str, application: str | None = None) -> None:
        """An event for an application, or (None) for every one."""
        self.give(inputs.Raise(event, application))

    def give(self, given: inputs.AnyInput) -> None:
        """Any other input of ``situ.decide.inputs``. Raises Refused where it is refused."""
        refused = self._world.submit(given)
        if refused is not None:
            raise Refused(refused)
        self._settle()

    def pass_time(self, seconds: float) -> None:
        """Lets so much time pass, doing all that falls due."""
        self._wait(lambda: False, seconds)

    def until(self, ready: Callable[[], bool], within: float) -> None:
        """Lets time pass until ``ready()``, at most ``within`` seconds; then AssertionError."""
        if not self._wait(ready, within):
            raise AssertionError(f"it did not come about within {within:g} s of the robot's time")

    def lose(self, module: str) -> None:
        """Cuts the module's connection, and passes the time after which core and module know."""
        with self._time.lock:
            for line in self._world.of(module):
                line.lose()
        self.pass_time(LEASE + HEARTBEAT)

    def regain(self, module: str) -> None:
        """The module's connection is there again; within a heartbeat so is the module."""
        with self._time.lock:
            for line in self._world.of(module):
                self._world.regain(line)
        self.pass_time(HEARTBEAT)

    def restart(self) -> None:
        """The robot is switched off and on: its blackboard begins anew, its clients come back."""
        with self._time.lock:
            self._world.begin()
        self.pass_time(HEARTBEAT)

    # -- what came of it -----------------------------------------------------

    @property
    def trace(self) -> list[dict[str, Any]]:
        """Every event so far, as in a trace file; the last are those before ``close``."""
        return self._world.trace

    @property
    def now(self) -> float:
        """Seconds since the start."""
        return self._time.now

    @property
    def situation(self) -> str | None:
        """The current situation."""
        named = [event["to"] for event in self.trace if event["kind"] == "situation"]
        return named[-1] if named else None

    def command(self, resource: str) -> Any:
        """What moves a resource now: the valid command of who holds it; None: it stands still."""
        return self.value(f"robot/{resource}")

    def holder(self, resource: str) -> str | None:
        """Who has authority over it."""
        return self._world.core.holders.get(resource)

    def value(self, name: str) -> Any:
        """What stands at a tag, or a name that reaches into one; None where it is missing."""
        return self._world.core.board.look(name)

    def events(self, **fields: Any) -> list[dict[str, Any]]:
        """Those of ``trace`` that have these fields."""
        return [event for event in self.trace if fields.items() <= event.items()]

    def close(self) -> None:
        """Ends all modules. Raises what one of them raised; may be called twice.

        They end in no order that could be told, so ``trace`` ends before they do.
        """
        if self._time.over:
            return
        self._time.end(self._ends)
        for thread in self._threads:
            thread.join(COMPUTING)
        left = [thread.name for thread in self._threads if thread.is_alive()]
        for line in self._world.lines():
            line.close()
        if left:
            raise BlackboardError(f"{', '.join(left)} did not end with the robot")
        self._raise()

    def __enter__(self) -> Robot:
        return self

    def __exit__(self, failed: type[BaseException] | None, *_: object) -> None:
        try:
            self.close()
        except BaseException:
            # What the test itself found goes before.
            if failed is None:
                raise

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.project.name} at {self.now:g} s>"

    # -- waiting -------------------------------------------------------------

    def _wait(self, ready: Callable[[], bool], seconds: float) -> bool:
        if asyncio._get_running_loop() is not None:
            raise BlackboardError("in a coroutine time passes with: await asyncio.sleep(seconds)")
        came = self._time.until(lambda: bool(self._world.failures) or ready(), seconds)
        self._settle()
        return came

    def _settle(self) -> None:
        self._time.settle()
        self._raise()

    def _raise(self) -> None:
        if self._world.failures:
            raise self._world.failures.pop(0)

    def _threaded(self, program: Callable[..., Any], board: Board, *more: Any) -> None:
        if inspect.iscoroutinefunction(program):
            raise BlackboardError(f"{program.__name__} awaits: give it a board of connect_async")
        with board:
            program(board, *more)

    def _looped(self, program: Callable[..., Any], board: AsyncBoard, *more: Any) -> None:
        async def main() -> None:
            loop, task = asyncio.get_running_loop(), asyncio.current_task()
            assert task is not None
            self._ends.append(lambda: _cancel(loop, task))
            async with board:
                await program(board, *more)

        try:
            with asyncio.Runner(loop_factory=lambda: Loop(self._time)) as runner:
                runner.run(main())
        except asyncio.CancelledError:
            if not self._time.over:
                raise


def _cancel(loop: asyncio.AbstractEventLoop, task: asyncio.Task[Any]) -> None:
    # One that has ended meanwhile is closed.
    with contextlib.suppress(RuntimeError):
        loop.call_soon_threadsafe(task.cancel)
