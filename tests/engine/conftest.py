"""A clock moved by hand, and a robot's side whose answers can be waited for."""

from __future__ import annotations

import asyncio
import heapq
import itertools
import os
from collections.abc import AsyncIterator, Awaitable, Callable, Iterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest

from situ.decide.inputs import AnyInput, Finish
from situ.document.project import Project
from situ.engine.perform import Performer
from situ.engine.voices.espeak import EspeakNg

DEADLINE = 20.0


class Call:
    def __init__(self, callback: Callable[[], None]) -> None:
        self.callback: Callable[[], None] | None = callback

    def cancel(self) -> None:
        self.callback = None


class HandClock:
    """A ``Clock`` whose time passes only by ``advance``; ``asked`` is set by every call_at."""

    def __init__(self) -> None:
        self.now = 100.0
        self.asked = asyncio.Event()
        self._calls: list[tuple[float, int, Call]] = []
        self._count = itertools.count()

    def time(self) -> float:
        return self.now

    def call_at(self, when: float, callback: Callable[[], None], /) -> Call:
        call = Call(callback)
        heapq.heappush(self._calls, (when, next(self._count), call))
        self.asked.set()
        return call

    @property
    def waiting(self) -> list[float]:
        """Seconds from now until each call that still stands."""
        return sorted(w - self.now for w, _, call in self._calls if call.callback is not None)

    async def asked_for_time(self) -> float:
        """Waits until somebody waits for time to pass; gives how long the first has to."""
        async with asyncio.timeout(DEADLINE):
            while not self.waiting:
                self.asked.clear()
                await self.asked.wait()
        return self.waiting[0]

    async def advance(self, seconds: float) -> None:
        """Lets time pass, each call at its moment, and the loop do what follows from it."""
        end = self.now + seconds
        while self._calls and self._calls[0][0] <= end:
            when, _, call = heapq.heappop(self._calls)
            self.now = max(self.now, when)
            if call.callback is not None:
                call.callback()
            await settle()
        self.now = end
        await settle()


async def settle() -> None:
    """Lets everything that can go on without waiting for anything go on."""
    for _ in range(8):
        await asyncio.sleep(0)


class Answers:
    """What the robot's side submits, in order."""

    def __init__(self) -> None:
        self.inputs: list[AnyInput] = []
        self._more = asyncio.Event()

    def submit(self, given: AnyInput) -> None:
        self.inputs.append(given)
        self._more.set()

    @property
    def finishes(self) -> list[Finish]:
        return [one for one in self.inputs if isinstance(one, Finish)]

    async def finish(self, action: int) -> Finish:
        """Waits for the Finish of an action."""
        async with asyncio.timeout(DEADLINE):
            while True:
                for one in self.finishes:
                    if one.id == action:
                        return one
                self._more.clear()
                await self._more.wait()

    async def first(self, count: int) -> list[AnyInput]:
        """Waits until so many inputs have been submitted, and what was on its way with them."""
        async with asyncio.timeout(DEADLINE):
            while len(self.inputs) < count:
                self._more.clear()
                await self._more.wait()
        await settle()
        return self.inputs


class Side:
    """One performer with its answers, its clock and the tags that it may read."""

    def __init__(self, performer: Performer, answers: Answers, clock: HandClock) -> None:
        self.performer = performer
        self.answers = answers
        self.clock = clock


class Situation:
    """Makes performers for one folder: a project with media, a state folder and tags."""

    def __init__(self, folder: Path) -> None:
        self.media = folder / "project" / "media"
        self.media.mkdir(parents=True)
        self.state = folder / "state"
        self.state.mkdir()
        self.tags: dict[str, Any] = {}
        self.places: dict[str, tuple[float, float, float]] = {}

    @asynccontextmanager
    async def side(self, **options: Any) -> AsyncIterator[Side]:
        project = Project(
            root=str(self.media.parent), name="test", media="media", places=self.places
        )
        answers, clock = Answers(), HandClock()
        given: dict[str, Any] = {
            "tag": self.tags.get,
            "state_dir": self.state,
            "services": ("engine", "robot"),
            "sound": False,
            "voice": EspeakNg(None),
            "clock": clock,
        }
        performer = Performer(project, answers.submit, **(given | options))
        await performer.start()
        try:
            yield Side(performer, answers, clock)
        finally:
            await performer.close()


class Started:
    """Tells when programs have started: each writes its process id into ``path``, a pipe."""

    def __init__(self, path: Path) -> None:
        self.path = path
        os.mkfifo(path)
        # Also open for writing, so that the pipe never ends.
        self._pipe = os.open(path, os.O_RDWR | os.O_NONBLOCK)

    async def pid(self) -> int:
        """Waits for the next process id."""
        await readable(self._pipe)
        return int(os.read(self._pipe, 4096).split()[-1])

    def close(self) -> None:
        os.close(self._pipe)


async def readable(descriptor: int) -> None:
    loop = asyncio.get_running_loop()
    ready = asyncio.Event()
    loop.add_reader(descriptor, ready.set)
    try:
        async with asyncio.timeout(DEADLINE):
            await ready.wait()
    finally:
        loop.remove_reader(descriptor)


async def gone(pid: int) -> None:
    """Waits until a process has ended."""
    try:
        process = os.pidfd_open(pid)
    except ProcessLookupError:
        return
    try:
        await readable(process)
    finally:
        os.close(process)


@pytest.fixture
def started(tmp_path: Path) -> Iterator[Started]:
    made = Started(tmp_path / "started")
    yield made
    made.close()


@pytest.fixture
def ended() -> Callable[[int], Awaitable[None]]:
    return gone


@pytest.fixture
def hand_clock() -> HandClock:
    return HandClock()


@pytest.fixture
def situation(tmp_path: Path) -> Situation:
    return Situation(tmp_path)


@pytest.fixture
def program(tmp_path: Path) -> Callable[[str, str], Path]:
    """Writes an executable shell script of that name; ``$0.…`` are files beside it."""

    def write(name: str, script: str) -> Path:
        file = tmp_path / name
        file.write_text("#!/bin/sh\n" + script + "\n", "utf-8")
        file.chmod(0o755)
        return file

    return write
