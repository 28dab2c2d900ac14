"""A robot on several machines: network namespaces with cables between them that can be pulled."""

from __future__ import annotations

import asyncio
import contextlib
import ctypes
import json
import os
import queue
import shutil
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

import situ
from situ.blackboard import keys
from situ.blackboard.asynchronous import AsyncBoard
from situ.blackboard.calls import Person
from situ.blackboard.identity import KeyRole
from situ.blackboard.keys import KnownKey, RobotKey, client_keys
from situ.blackboard.link import Link
from situ.document.ready import load_ready
from situ.engine.perform import Performer
from situ.engine.robots import Surroundings
from situ.engine.services import ServicesApart
from situ.system_libraries import PATH

DEADLINE = 40.0
HOSTS = ("core", "arms", "module")
NEW_NETWORK = 0x40000000
IP = shutil.which("ip", path=PATH) or "ip"
PROJECT = {
    "situ.toml": '[project]\nname = "hosts"\napplications = ["a.rbd.xml"]\nspds = "s.spds.xml"\n',
    "a.rbd.xml": '<application name="a"><state no="1"/></application>',
    "s.spds.xml": """<spds name="s">
  <modules>
    <module name="near" resources="head"/><module name="far" resources="head"/>
    <module name="a" resources="screen"/>
  </modules>
  <situation name="day">
    <module name="far" priority="20"/><module name="near" priority="10"/>
    <module name="a" priority="5"/>
  </situation>
</spds>""",
}


def ip(*arguments: str) -> None:
    done = subprocess.run([IP, *arguments], capture_output=True, text=True)
    if done.returncode != 0:
        raise OSError(f"ip {' '.join(arguments)}: {done.stderr.strip()}")


class House:
    """Machines of a robot, each on a cable to the same switch; all of it is gone in the end."""

    def __init__(self) -> None:
        self._name = f"situ{os.getpid()}"
        self._all: list[str] = []

    def build(self) -> None:
        """Raises OSError where this machine does not let us."""
        switch = self._add("switch")
        ip("-n", switch, "link", "add", "bridge", "type", "bridge")
        ip("-n", switch, "link", "set", "bridge", "up")
        for host in HOSTS:
            space = self._add(host)
            ip("-n", switch, "link", "add", host, "type", "veth", "peer", "eth0", "netns", space)
            ip("-n", switch, "link", "set", host, "master", "bridge", "up")
            ip("-n", space, "address", "add", f"{self.address(host)}/24", "dev", "eth0")
            ip("-n", space, "link", "set", "lo", "up")
            ip("-n", space, "link", "set", "eth0", "up")

    def _add(self, host: str) -> str:
        space = f"{self._name}-{host}"
        ip("netns", "add", space)
        self._all.append(space)
        return space

    def address(self, host: str) -> str:
        return f"10.77.0.{1 + HOSTS.index(host)}"

    def cable(self, host: str, state: str) -> None:
        """``down`` pulls it, ``up`` puts it back."""
        ip("-n", f"{self._name}-switch", "link", "set", host, state)

    def command(self, host: str, *argv: str) -> list[str]:
        return [
            shutil.which("ip", path=PATH) or "ip",
            "netns",
            "exec",
            f"{self._name}-{host}",
            *argv,
        ]

    @contextlib.contextmanager
    def work(self, host: str, work: Callable[[], None]) -> Iterator[None]:
        """What a thread does on that machine; it must have ended in the end of the block."""
        failed: list[BaseException] = []

        def there() -> None:
            try:
                with open(f"/run/netns/{self._name}-{host}") as space:
                    libc = ctypes.CDLL(None, use_errno=True)
                    if libc.setns(space.fileno(), NEW_NETWORK) != 0:
                        raise OSError(ctypes.get_errno(), "setns")
                work()
            except BaseException as error:
                failed.append(error)

        thread = threading.Thread(target=there)
        thread.start()
        try:
            yield
        finally:
            thread.join(DEADLINE)
        assert not failed, failed

    def raze(self) -> None:
        for space in self._all:
            with contextlib.suppress(OSError):
                ip("netns", "del", space)


@pytest.fixture
def house() -> Iterator[House]:
    """Needs root and iproute2: skips without them, and fails in CI."""
    made = House()
    try:
        made.build()
    except OSError as error:
        made.raze()
        why = f"no network namespaces here ({error}): be root, and sudo apt-get install iproute2"
        if os.environ.get("CI") == "true":
            pytest.fail(why)
        pytest.skip(why)
    yield made
    made.raze()


class Head:
    """A head that tells what it is told."""

    resources = frozenset({"head"})

    def __init__(self, told: queue.Queue[Any]) -> None:
        self._told = told

    def apply(self, resource: str, value: Any) -> None:
        self._told.put(value)

    async def start(self) -> None:
        pass

    async def close(self) -> None:
        pass


class Robot:
    """The core on one machine, its head on a second, a module on each of two."""

    def __init__(self, house: House, folder: Path) -> None:
        self.house = house
        self.folder = folder
        self.state = folder / "state"
        self.project = folder / "project"
        self.project.mkdir()
        for name, text in PROJECT.items():
            (self.project / name).write_text(text)
        self.state.mkdir()
        self.public = keys.new_robot(self.state / "keys").public
        self.told: queue.Queue[Any] = queue.Queue()
        self.over = threading.Event()

    def let_in(self, name: str, role: KeyRole) -> Path:
        pair = keys.new_pair(name)
        keys.add_known(self.state / "keys", name, KnownKey(pair.public, role))
        keys.new_client(self.folder / name, pair, "hosts", RobotKey(self.public, ()))
        return self.folder / name

    @contextlib.contextmanager
    def core(self) -> Iterator[None]:
        address = self.house.address("core")
        options = ("--services", "core", "--no-restart", "--json", "--state", str(self.state))
        argv = (sys.executable, "-m", "situ", "run", str(self.project), *options)
        with subprocess.Popen(
            self.house.command("core", *argv, "--endpoint", f"tcp://{address}:0"),
            stdout=subprocess.PIPE,
            text=True,
        ) as process:
            try:
                assert process.stdout is not None
                self.endpoint = json.loads(process.stdout.readline())["requests"]
                yield
            finally:
                self.over.set()
                process.terminate()

    def head(self) -> None:
        """The service robot, until it is over."""
        folder = self.folder / "arms"
        project = load_ready(self.project)

        def adapter(_: Surroundings) -> Head:
            return Head(self.told)

        async def serve() -> None:
            person = Person(role="service", services=("robot",))
            link = Link(self.endpoint, person, keys=client_keys(self.endpoint, folder))
            apart = ServicesApart(
                AsyncBoard(link, DEADLINE),
                ("robot",),
                lambda submit, tag: Performer(
                    project, submit, tag=tag, services=("robot",), adapter=adapter
                ),
            )
            await apart.start()
            await asyncio.to_thread(self.over.wait)
            await apart.stop()

        asyncio.run(serve())

    def module(self, name: str, value: Any) -> None:
        """Looks there whenever it may, until it is over. Nothing here knows of a network."""
        folder = self.folder / name
        with (
            situ.connect(self.endpoint, name, ["head"], keys=folder, timeout=DEADLINE) as board,
            board.authority("head") as head,
        ):
            while not self.over.is_set():
                if head.wait(0.2):
                    head.command(value)
                    while head.held and not self.over.is_set():
                        head.wait_lost(0.2)

    def until(self, value: Any) -> None:
        while self.told.get(timeout=DEADLINE) != value:
            pass


def test_a_pulled_cable_costs_what_it_carries_and_nothing_else(
    house: House, tmp_path: Path
) -> None:
    """Authority passes at the lease's end and comes back with the cable; a robot that hears
    nothing stops. Nobody is restarted."""
    robot = Robot(house, tmp_path)
    robot.let_in("arms", "service")
    robot.let_in("near", "module")
    robot.let_in("far", "module")
    far, near = {"yaw": 20}, {"yaw": -20}
    with (
        robot.core(),
        house.work("arms", robot.head),
        house.work("core", lambda: robot.module("near", near)),
        house.work("module", lambda: robot.module("far", far)),
    ):
        try:
            robot.until(far)
            house.cable("module", "down")
            robot.until(near)
            house.cable("module", "up")
            robot.until(far)
            house.cable("arms", "down")
            robot.until(None)
            house.cable("arms", "up")
            robot.until(far)
        finally:
            robot.over.set()
