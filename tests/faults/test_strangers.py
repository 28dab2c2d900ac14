"""A robot on a network: whoever is not known gets nothing, whoever is gets what is his, and nobody
takes the robot down (quality, *Faults*)."""

from __future__ import annotations

import asyncio
import contextlib
import json
import random
import shutil
import socket
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
import zmq
from zmq.utils.monitor import parse_monitor_message

import situ
from situ.blackboard import keys
from situ.blackboard.curve import Curve
from situ.blackboard.identity import KeyRole
from situ.blackboard.keys import KnownKey, RobotKey, RobotKeys
from situ.cli import main
from situ.errors import Refused, Unreachable

if TYPE_CHECKING:
    from tests.faults.conftest import Runtime

DEADLINE = 30.0
LAB = Path(__file__).parent.parent / "blackboard" / "lab"
VECTORS = Path(__file__).parent.parent / "vectors" / "requests.json"
FRAMES = 10_000
CONNECTIONS = 300
MORE = 20.0
"""Megabytes that all of it may leave in memory."""


class House:
    """A robot with keys, and the folders of those that it knows."""

    def __init__(self, runtime: Runtime, folder: Path) -> None:
        self.runtime = runtime
        self.keys = runtime.state / "keys"
        self.folder = folder
        runtime.state.mkdir()
        keys.new_robot(self.keys)
        self.public = RobotKeys(self.keys).public

    def let_in(self, name: str, role: KeyRole, *write: str) -> Path:
        pair = keys.new_pair(name)
        keys.add_known(self.keys, name, KnownKey(pair.public, role, write))
        robot = RobotKey(self.public.decode(), ())
        keys.new_client(self.folder / name, pair, "ward", robot)
        return self.folder / name

    @property
    def log(self) -> list[str]:
        lines = self.runtime.log.read_text("utf-8").splitlines()
        return [line for line in lines if "situ.audit" in line]


@pytest.fixture
def house(runtime: Runtime, tmp_path: Path) -> House:
    return House(runtime, tmp_path / "people")


@pytest.fixture
def context() -> Iterator[zmq.Context[zmq.Socket[bytes]]]:
    made: zmq.Context[zmq.Socket[bytes]] = zmq.Context()
    yield made
    made.destroy(linger=0)


def until(ready: Callable[[], bool], board: Any) -> None:
    """Asks the robot something until it is so."""
    end = time.monotonic() + DEADLINE
    while not ready():
        assert time.monotonic() < end
        board.get("clock.time")


# -- who gets in -------------------------------------------------------------


def test_bound_to_a_network_without_keys_it_does_not_start(
    runtime: Runtime, capfd: pytest.CaptureFixture[str]
) -> None:
    where = {"--endpoint": "tcp://127.0.0.1:0", "--http": "127.0.0.1:0"}
    for change in (
        {"--endpoint": "tcp://0.0.0.0:0"},
        {"--notify": "tcp://0.0.0.0:0"},
        {"--http": "0.0.0.0:0"},
        {"--http": "0.0.0.0:0", "--services": "screen"},
    ):
        options = [part for pair in {**where, **change}.items() for part in pair]
        state = ("--state", str(runtime.state), "--no-restart")
        assert main(["run", str(runtime.project), *state, *options]) == 2
        said = capfd.readouterr().err
        assert "situ keys new" in said
        assert said.count("\n") == 1


def test_a_robot_on_a_network_serves_those_whom_it_knows(
    house: House, capsys: pytest.CaptureFixture[str]
) -> None:
    ann = house.let_in("ann", "operator")
    house.runtime.endpoint = "tcp://0.0.0.0:0"
    network = ("--endpoint", "tcp://0.0.0.0:0", "--notify", "tcp://0.0.0.0:0")
    house.runtime.start(*network, "--log-level", "error")
    # It can not tell by which of its addresses we see it.
    where = f"tcp://127.0.0.1:{house.runtime.endpoint.rpartition(':')[2]}"
    with (
        situ.connect(where, keys=ann, timeout=DEADLINE) as board,
        board.watch("user.name") as changes,
    ):
        board.set("user.name", "Ann")
        assert next(iter(changes)).value == "Ann"
        assert board.entries("user.name")["user.name"].writer == "operator:ann"

    async def look() -> Any:
        async with situ.connect_async(where, keys=ann, timeout=DEADLINE) as board:
            return await board.get("user.name")

    assert asyncio.run(look()) == "Ann"
    # On standard error, whatever else is logged.
    assert any("connected socket=requests address=127.0.0.1 name=ann" in x for x in house.log)
    assert any("changed name=ann do=set what=user.name" in x for x in house.log)
    assert main(["get", "user.name", "--at", where, "--keys", str(ann)]) == 0
    assert capsys.readouterr().out == '"Ann"\n'


def test_insecure_is_open_to_a_network_and_says_so(house: House) -> None:
    house.runtime.start(
        *("--insecure", "--endpoint", "tcp://0.0.0.0:0", "--notify", "tcp://0.0.0.0:0")
    )
    port = house.runtime.endpoint.rpartition(":")[2]
    with situ.connect(f"tcp://127.0.0.1:{port}", timeout=DEADLINE) as board:
        board.set("user.name", "anybody")
    assert "--insecure: whoever can reach this robot" in house.runtime.log.read_text("utf-8")


def test_a_stranger_is_refused_and_written_down(
    house: House, context: zmq.Context[zmq.Socket[bytes]]
) -> None:
    ann = house.let_in("ann", "operator")
    house.runtime.start()
    other, robot = keys.new_pair("x"), keys.new_pair("y")
    mine = (other.public.encode(), other.secret.encode())

    def plain(stranger: zmq.Socket[bytes]) -> None:
        stranger.plain_username, stranger.plain_password = b"ann", b"ann"

    for put_on in (
        lambda _: None,
        plain,
        Curve(*mine, robot.public.encode()).put_on,
        Curve(*mine, house.public).put_on,
    ):
        for kind in (zmq.DEALER, zmq.SUB):
            knock(context, house.runtime.endpoint, put_on, kind)
    with situ.connect(house.runtime.endpoint, keys=ann, timeout=DEADLINE) as board:
        until(lambda: sum("does not speak CURVE" in line for line in house.log) > 0, board)
        until(lambda: any(other.public in line for line in house.log), board)
        assert board.get("user.name") is None
    refused = next(line for line in house.log if other.public in line)
    assert "address=127.0.0.1" in refused
    assert "nobody known has this key" in refused


def knock(
    context: zmq.Context[zmq.Socket[bytes]],
    endpoint: str,
    put_on: Callable[[zmq.Socket[bytes]], None],
    kind: int,
) -> None:
    """Tries to come in, and is turned away; returns when it is."""
    stranger = context.socket(kind)
    put_on(stranger)
    failed = int(zmq.EVENT_HANDSHAKE_FAILED_AUTH) | int(zmq.EVENT_HANDSHAKE_FAILED_PROTOCOL)
    events = failed | int(zmq.EVENT_HANDSHAKE_FAILED_NO_DETAIL) | int(zmq.EVENT_DISCONNECTED)
    monitor = stranger.get_monitor_socket(events | int(zmq.EVENT_HANDSHAKE_SUCCEEDED))
    stranger.connect(endpoint)
    if kind == zmq.DEALER:
        hello = {"do": "hello", "id": 1, "version": 1, "role": "viewer"}
        # Who has been turned away already has nobody to say it to, and would wait for ever.
        with contextlib.suppress(zmq.Again):
            stranger.send(json.dumps(hello).encode(), zmq.DONTWAIT)
    assert monitor.poll(round(DEADLINE * 1000))
    event = parse_monitor_message(monitor.recv_multipart())
    assert event["event"] != zmq.EVENT_HANDSHAKE_SUCCEEDED
    assert not stranger.poll(0)
    stranger.disable_monitor()
    monitor.close(0)
    stranger.close(0)


def test_the_client_of_a_stranger_says_what_may_be_wrong(house: House) -> None:
    house.runtime.start()
    with pytest.raises(Unreachable, match="keys"):
        situ.connect(house.runtime.endpoint, role="viewer", timeout=0.5)


def test_who_is_removed_is_let_in_no_longer(house: House) -> None:
    house.runtime.start()
    # Who is added while it runs is let in at once.
    ann, bob = house.let_in("ann", "operator"), house.let_in("bob", "viewer")
    with (
        situ.connect(house.runtime.endpoint, keys=ann, timeout=3.0) as board,
        situ.connect(house.runtime.endpoint, keys=bob, role="viewer", timeout=DEADLINE) as looker,
    ):
        written: list[int] = []
        board.set("count", 0)
        keys.remove_known(house.keys, "ann")
        # Ann has got a new key: whoever has the old one is not Ann.
        new = keys.new_pair("ann").public
        keys.add_known(house.keys, "ann", KnownKey(new, "operator"))
        with pytest.raises(Unreachable, match="does it know yours"):
            count(board, written)
        # The last one may have been done without an answer.
        assert looker.get("count") in (len(written), len(written) + 1)


def test_who_is_removed_hears_nothing_any_longer(
    house: House, context: zmq.Context[zmq.Socket[bytes]]
) -> None:
    ann, bob = house.let_in("ann", "viewer"), house.let_in("bob", "operator")
    house.runtime.start()
    with (
        situ.connect(house.runtime.endpoint, keys=bob, timeout=DEADLINE) as board,
        context.socket(zmq.SUB) as ear,
    ):
        curve = keys.client_keys(house.runtime.endpoint, ann)
        assert curve is not None
        curve.put_on(ear)
        ear.subscribe(b"")
        ear.connect(board.addresses.notifications)
        with board.watch("count") as changes:
            heard = iter(changes)
            while not ear.poll(0):
                board.set("count", -1)
                board.set("count", 0)
            keys.remove_known(house.keys, "ann")
            until(lambda: any("nobody known has this key" in line for line in house.log), board)
            while ear.poll(0):
                ear.recv()
            # Bob, whose connections were closed too, has missed nothing.
            board.set("count", 1)
            while next(heard).value != 1:
                pass
            assert not ear.poll(0)


def count(board: Any, written: list[int]) -> None:
    end = time.monotonic() + DEADLINE
    while time.monotonic() < end:
        board.set("count", len(written) + 1)
        written.append(len(written) + 1)


# -- what they may do --------------------------------------------------------


def test_each_does_what_its_role_and_rights_allow(house: House) -> None:
    people = {
        "tablet": house.let_in("tablet", "viewer"),
        "face": house.let_in("face", "module", "face.*"),
    }
    house.runtime.start()
    where = house.runtime.endpoint
    with pytest.raises(Refused, match="the key of tablet is for the role viewer"):
        situ.connect(where, keys=people["tablet"], timeout=DEADLINE)
    with pytest.raises(Refused, match="is not the module nod's"):
        situ.connect(where, "nod", keys=people["face"], timeout=DEADLINE)
    with (
        situ.connect(where, role="viewer", keys=people["tablet"], timeout=DEADLINE) as tablet,
        situ.connect(where, "face", keys=people["face"], timeout=DEADLINE) as face,
    ):
        with pytest.raises(Refused, match="tablet is a viewer here"):
            tablet.set("user.name", "x")
        for tag in ("user.name", "robot/head", "module/nod/head"):
            with pytest.raises(Refused, match="face may not set"):
                face.set(tag, 1)
        face.set("face.visible", True)
        assert tablet.get("face.visible") is True
        assert tablet.get("user.name") is None
        said = "\n".join(house.log)
        for what in (
            "refused name=tablet do=hello",
            "refused name=face do=hello what=nod",
            "refused name=tablet do=set what=user.name",
            "refused name=face do=set what=user.name",
            "refused name=face do=set what=robot/head",
            "refused name=face do=set what=module/nod/head",
        ):
            assert what in said


def test_a_robot_and_its_seven_computers_are_set_up_in_one_command(
    runtime: Runtime, tmp_path: Path
) -> None:
    runtime.project = shutil.copytree(LAB, tmp_path / "project")
    out = tmp_path / "out"
    people = ("eyes", "chase", "ann:operator", *(f"t{number}:viewer" for number in range(4)))
    project = ("--project", str(runtime.project), "--robot", "tcp://robot.lab:5570")
    assert main(["keys", "lab", str(out), *people, *project]) == 0
    runtime.start("--keys", str(out / "robot"))
    with contextlib.ExitStack() as stack:
        boards = {}
        for name, _, role in (one.partition(":") for one in people):
            who: dict[str, Any] = {"role": role} if role else {"module": name}
            if name == "chase":
                who["resources"] = ["head"]
            board = situ.connect(runtime.endpoint, keys=out / name, timeout=DEADLINE, **who)
            boards[name] = stack.enter_context(board)
        # By its module information eyes provides it.
        boards["eyes"].set("face.direction", 10)
        with pytest.raises(Refused, match="chase may not set"):
            boards["chase"].set("face.direction", 20)
        boards["ann"].set("anything", 1)
        with situ.connect(runtime.endpoint, keys=out / "t0", timeout=DEADLINE) as looker:
            assert looker.get("anything") == 1
        for name in boards:
            assert boards[name].get("face.direction") == 10
        with boards["chase"].authority("head") as head:
            head.command({"yaw": 10})


def test_a_core_that_was_killed_knows_them_again(house: House) -> None:
    face = house.let_in("face", "module", "face.*")
    house.runtime.start()
    with situ.connect(house.runtime.endpoint, "face", keys=face, timeout=DEADLINE) as board:
        board.set("face.visible", True)
        house.runtime.kill()
        house.runtime.start()
        board.set("face.visible", False)
        with pytest.raises(Refused, match="face may not set"):
            board.set("user.name", "x")


# -- floods ------------------------------------------------------------------


def bodies(chance: random.Random) -> Iterator[bytes]:
    """Random ones, truncated ones, and good ones with bytes changed, doubled and left out."""
    vectors = [json.dumps(one).encode() for one in _requests()]
    while True:
        body = bytearray(chance.choice(vectors))
        match chance.randrange(5):
            case 0:
                yield chance.randbytes(chance.randrange(2000))
            case 1:
                yield bytes(body[: chance.randrange(len(body))])
            case 2:
                for _ in range(chance.randint(1, 4)):
                    body[chance.randrange(len(body))] = chance.randrange(256)
                yield bytes(body)
            case 3:
                at = chance.randrange(len(body))
                yield bytes(body[:at] + body[at:] * chance.randint(2, 20))
            case _:
                yield b'{"do":"set","id":1,"tags":{"a":' + b"[" * chance.randrange(50_000)


def _requests() -> list[Any]:
    found = json.loads(VECTORS.read_text("utf-8"))
    rows = found if isinstance(found, list) else list(found.values())
    return [row.get("body", row) if isinstance(row, dict) else row for row in rows]


@pytest.mark.parametrize("keyed", [True, False], ids=["with keys", "without"])
def test_frames_that_make_no_sense_are_answered_and_leave_nothing(
    runtime: Runtime,
    tmp_path: Path,
    context: zmq.Context[zmq.Socket[bytes]],
    chance: random.Random,
    often: Callable[[int, int], int],
    keyed: bool,
) -> None:
    # What is done with a frame is the same without keys.
    hundreds = FRAMES // 100 if keyed else often(10, FRAMES // 100)
    house = House(runtime, tmp_path / "people") if keyed else None
    ann = None if house is None else house.let_in("ann", "operator")
    runtime.start()
    with (
        situ.connect(runtime.endpoint, keys=ann, timeout=DEADLINE) as board,
        context.socket(zmq.DEALER) as dealer,
    ):
        dealer.linger = 0
        curve = keys.client_keys(runtime.endpoint, ann)
        if curve is not None:
            curve.put_on(dealer)
        dealer.connect(runtime.endpoint)
        source = bodies(chance)
        before = 0.0
        for number in range(hundreds):
            for _ in range(100):
                # Some in two frames, which no request is.
                dealer.send_multipart([next(source)] * (1 + (chance.random() < 0.05)))
            for _ in range(100):
                assert dealer.poll(round(DEADLINE * 1000))
                reply = json.loads(dealer.recv())
                assert reply["re"]
            if number == 0:
                before = runtime.memory
        assert board.get("clock.time") is not None
        assert runtime.memory <= before + MORE


@pytest.mark.parametrize("keyed", [True, False], ids=["with keys", "without"])
def test_connections_that_say_nothing_or_nonsense_take_nothing_down(
    runtime: Runtime, tmp_path: Path, chance: random.Random, keyed: bool
) -> None:
    house = House(runtime, tmp_path / "people") if keyed else None
    ann = None if house is None else house.let_in("ann", "operator")
    runtime.start()
    host, _, port = runtime.endpoint.partition("://")[2].rpartition(":")
    before = runtime.memory
    with (
        situ.connect(runtime.endpoint, keys=ann, timeout=DEADLINE) as board,
        contextlib.ExitStack() as stack,
    ):
        strangers = []
        for number in range(CONNECTIONS):
            stranger = socket.create_connection((host, int(port)), DEADLINE)
            strangers.append(stack.enter_context(stranger))
            if number % 3 == 1:
                stranger.sendall(chance.randbytes(chance.randint(1, 500)))
            elif number % 3 == 2:
                # A greeting as ZMTP 3 has it, then nonsense.
                mechanism = chance.choice([b"NULL", b"CURVE", b"PLAIN"]).ljust(20, b"\0")
                greeting = b"\xff" + b"\0" * 8 + b"\x7f\x03\x00" + mechanism + b"\0" * 32
                stranger.sendall(greeting + chance.randbytes(chance.randint(1, 500)))
            board.get("clock.time")
        # Without keys nonsense may be that of a client of ZMTP 1, which has no handshake.
        for stranger in strangers if keyed else strangers[::3]:
            ended(stranger)
        assert board.get("clock.time") is not None
        assert runtime.memory <= before + MORE


def ended(stranger: socket.socket) -> None:
    """Reads what it is told until the other side ends it, by the deadline."""
    with contextlib.suppress(ConnectionError):
        while stranger.recv(4096):
            pass
