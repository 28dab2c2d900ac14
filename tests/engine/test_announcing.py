"""Robots announced and found for real: multicast over the loopback interface."""

from __future__ import annotations

import asyncio
import contextlib
import subprocess
import sys
import uuid
from collections.abc import Awaitable, Callable
from pathlib import Path

import pytest

from situ.blackboard.announced import Announced, fingerprint
from situ.blackboard.keys import new_pair
from situ.blackboard.nearby import Nearby
from situ.document.project import Project
from situ.engine.announcer import HERE, addresses_of, announce, changes_of_network
from situ.engine.announcing import Announcement, Announcing, announcement

DEADLINE = 20.0


class Seen:
    """What ``Nearby`` tells of the robots of one project, which no other test has."""

    def __init__(self) -> None:
        self.project = f"ward-{uuid.uuid4().hex[:12]}"
        self.robots: dict[str, Announced] = {}
        self.names: set[str] = set()
        self.gone: list[str] = []
        self._told = asyncio.Event()

    def told(self, name: str, robot: Announced | None) -> None:
        if robot is None:
            self.names.discard(name)
        else:
            self.names.add(name)
        if robot is None:
            if self.robots.pop(name, None) is not None:
                self.gone.append(name)
        elif robot.project == self.project:
            self.robots[name] = robot
        self._told.set()

    async def until(self, true: Callable[[], bool]) -> None:
        async with asyncio.timeout(DEADLINE):
            while not true():
                self._told.clear()
                await self._told.wait()


def run(test: Callable[[Seen], Awaitable[None]]) -> None:
    async def with_nearby() -> None:
        seen = Seen()
        async with Nearby(seen.told, [HERE]):
            await test(seen)

    asyncio.run(with_nearby())


def test_robots_are_found_with_what_they_tell_two_of_one_name_as_two_and_gone_when_they_end() -> (
    None
):
    key = fingerprint(new_pair("robot").public)
    first, second = Announcing(), Announcing()

    async def both(seen: Seen) -> None:
        keyed = Announced(seen.project, "rob1", 5570, key=key)
        first.begin(Announcement(keyed, HERE))
        # Once is enough, however often a robot was started again.
        first.begin(Announcement(keyed, HERE))
        second.begin(Announcement(Announced(seen.project, "rob1", 5580), HERE))
        await seen.until(lambda: len(seen.robots) == 2)
        assert {one.port: one for one in seen.robots.values()} == {
            5570: Announced(seen.project, "rob1", 5570, (HERE,), key),
            5580: Announced(seen.project, "rob1", 5580, (HERE,)),
        }
        name = next(name for name, one in seen.robots.items() if one.port == 5570)
        first.close()
        await seen.until(lambda: seen.gone == [name])
        assert [one.port for one in seen.robots.values()] == [5580]
        first.close()

    try:
        run(both)
    finally:
        first.close()
        second.close()


def test_a_robot_that_is_started_again_under_another_name_is_announced_by_that_one_alone() -> None:
    announcing = Announcing()

    async def renamed(seen: Seen) -> None:
        before = Announced(f"{seen.project}-before", "rob1", 5570)
        announcing.begin(Announcement(before, HERE))
        announcing.begin(Announcement(Announced(seen.project, "rob1", 5570), HERE))
        await seen.until(lambda: len(seen.robots) == 1)
        # Its goodbye may be heard after.
        await seen.until(lambda: f"{before.project} at rob1" not in seen.names)
        announcing.close()
        await seen.until(lambda: not seen.robots)

    try:
        run(renamed)
    finally:
        announcing.close()


def test_a_robot_that_gets_another_address_is_found_there() -> None:
    async def moves(seen: Seen) -> None:
        there, changed = [(HERE,)], asyncio.Event()
        ward = Announcement(Announced(seen.project, "rob1", 5570), HERE)
        task = asyncio.create_task(announce(ward, lambda: there[0], changed))
        await seen.until(lambda: len(seen.robots) == 1)
        there[0] = ("127.0.0.2",)
        changed.set()
        await seen.until(
            lambda: [one.addresses for one in seen.robots.values()] == [("127.0.0.2",)]
        )
        task.cancel()
        with pytest.raises(asyncio.CancelledError):
            await task
        await seen.until(lambda: not seen.robots)

    run(moves)


def test_situ_run_on_a_network_is_announced_and_gone_though_it_was_killed(tmp_path: Path) -> None:
    async def runs(seen: Seen) -> None:
        project = tmp_path / "project"
        project.mkdir()
        (project / "situ.toml").write_text(f'[project]\nname = "{seen.project}"\n')
        process = await asyncio.create_subprocess_exec(
            *(sys.executable, "-m", "situ", "run", str(project), "--insecure"),
            *("--endpoint", "tcp://0.0.0.0:0", "--notify", "tcp://127.0.0.1:0"),
            *("--services", "core", "--json", "--state", str(tmp_path / "state")),
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
        )
        try:
            assert process.stdout is not None
            line = await process.stdout.readline()
            assert b"announcement" not in line
            await seen.until(lambda: len(seen.robots) == 1)
            (robot,) = seen.robots.values()
            assert f":{robot.port}".encode() in line
            assert robot.key == ""
            assert set(robot.addresses) == set(addresses_of("0.0.0.0"))
            process.kill()
            await seen.until(lambda: not seen.robots)
        finally:
            with contextlib.suppress(ProcessLookupError):
                process.kill()
            await process.communicate()

    run(runs)


def test_only_who_can_be_reached_and_may_be_told_of_is_announced() -> None:
    ward, public = Project(root=".", name="ward"), new_pair("robot").public.encode()
    told = announcement(ward, "tcp://10.0.0.5:5570", public)
    assert told is not None
    assert (told.bound, told.robot.project, told.robot.port) == ("10.0.0.5", "ward", 5570)
    assert told.robot.key == fingerprint(public)
    for here in ("tcp://127.0.0.1:5570", "tcp://localhost:5570", "ipc:///tmp/x", "tcp://[::1]:1"):
        assert announcement(ward, here, public) is None
    quiet = Project(root=".", name="ward", announce=False)
    assert announcement(quiet, "tcp://10.0.0.5:5570", public) is None
    assert announcement(quiet, "tcp://0.0.0.0:5570", None) is None


def test_where_it_can_not_be_announced_one_line_says_so(
    capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    # On a busy machine it may take longer to begin than it is given for its goodbye.
    monkeypatch.setattr("situ.engine.announcing.PATIENCE", DEADLINE)
    announcing = Announcing()
    # An address for documents, which no machine has.
    announcing.begin(Announcement(Announced("ward", "rob1", 5570), "198.51.100.1"))
    announcing.close()
    said = capfd.readouterr().err
    assert said.startswith("situ run: the robot is not announced in the network: ")
    assert said.count("\n") == 1


def test_where_no_process_can_be_begun_the_robot_runs_all_the_same(
    capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def no_more(*_: object, **__: object) -> None:
        raise BlockingIOError(11, "Resource temporarily unavailable")

    monkeypatch.setattr(subprocess, "Popen", no_more)
    announcing = Announcing()
    announcing.begin(Announcement(Announced("ward", "rob1", 5570), HERE))
    announcing.close()
    assert capfd.readouterr().err == (
        "situ run: the robot is not announced in the network: Resource temporarily unavailable\n"
    )


def test_the_system_tells_of_other_addresses() -> None:
    told = changes_of_network()
    assert (told is None) == (sys.platform != "linux")
    if told is not None:
        with told, pytest.raises(BlockingIOError):
            told.recv(1)


def test_bound_to_one_address_it_is_told_as_that_one() -> None:
    assert addresses_of("10.0.0.5") == ("10.0.0.5",)
    every = addresses_of("0.0.0.0")
    assert every
    assert every == (HERE,) or not any(one.startswith("127.") for one in every)
