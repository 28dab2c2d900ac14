"""A robot with keys and something private: nobody hears what is not for him, by either door."""

from __future__ import annotations

import asyncio
import json
import shutil
import time
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import aiohttp
import pytest
import zmq

import situ
from situ.blackboard import keys
from situ.blackboard.identity import KeyRole
from situ.blackboard.keys import KnownKey, RobotKey, RobotKeys, token_keys
from situ.document.export import deployable
from situ.document.ready import load_ready

if TYPE_CHECKING:
    from tests.faults.conftest import Runtime

DEADLINE = 30.0
LAB = Path(__file__).parent.parent / "blackboard" / "lab"
SECRET = "Bea Lee"


@pytest.fixture
def people(runtime: Runtime, tmp_path: Path) -> dict[str, Path]:
    """Folders with keys of an operator, a viewer and a module, whom the robot knows."""
    runtime.project = shutil.copytree(LAB, tmp_path / "project")
    runtime.state.mkdir()
    keys.new_robot(runtime.state / "keys")
    public = RobotKeys(runtime.state / "keys").public.decode()
    made = {}
    roles: dict[str, KeyRole] = {"ann": "operator", "tablet": "viewer", "face": "module"}
    for name, role in roles.items():
        pair = keys.new_pair(name)
        keys.add_known(runtime.state / "keys", name, KnownKey(pair.public, role))
        made[name] = tmp_path / name
        keys.new_client(made[name], pair, "ward", RobotKey(public, ()))
    token = KnownKey(token_keys("token")[0].decode(), "viewer", door=True)
    keys.add_known(runtime.state / "keys", "wall", token)
    return made


def hide(project: Path) -> None:
    with (project / "situ.toml").open("a") as text:
        text.write('[privacy]\nprivate = ["user.**"]\n')


@pytest.fixture
def context() -> Iterator[zmq.Context[zmq.Socket[bytes]]]:
    made: zmq.Context[zmq.Socket[bytes]] = zmq.Context()
    yield made
    made.destroy(linger=0)


def listen(
    context: zmq.Context[zmq.Socket[bytes]], runtime: Runtime, folder: Path, board: situ.Board
) -> zmq.Socket[bytes]:
    """Somebody who subscribes to all that there is, with the keys of this folder."""
    ear = context.socket(zmq.SUB)
    curve = keys.client_keys(runtime.endpoint, folder)
    assert curve is not None
    curve.put_on(ear)
    for topic in ("", "t", "t:user.", "trace\n", "m:", "x:", "masked:", "echo:x\n"):
        ear.subscribe(topic)
    ear.connect(board.addresses.notifications)
    return ear


def test_who_subscribes_to_everything_hears_what_he_may(
    people: dict[str, Path], runtime: Runtime, context: zmq.Context[zmq.Socket[bytes]]
) -> None:
    hide(runtime.project)
    runtime.start()
    with (
        situ.connect(runtime.endpoint, keys=people["ann"], timeout=DEADLINE) as ann,
        situ.connect(runtime.endpoint, "face", keys=people["face"], timeout=DEADLINE) as face,
        situ.connect(
            runtime.endpoint, role="viewer", keys=people["tablet"], timeout=DEADLINE
        ) as it,
        ann.trace(),
        face.trace(),
        face.watch("user.*"),
        it.trace(),
        it.watch("user.*"),
    ):
        ears = [listen(context, runtime, folder, ann) for folder in people.values()]
        heard: dict[str, list[bytes]] = {name: [] for name in people}
        topics: dict[str, set[bytes]] = {name: set() for name in people}
        may = {
            "ann": {b"trace"},
            "face": {b"t:user.name", b"masked:trace"},
            "tablet": {b"masked:trace", b"masked:t:user.name"},
        }
        end = time.monotonic() + DEADLINE
        while any(not may[who] <= topics[who] for who in people):
            assert time.monotonic() < end, topics
            ann.set("user.name", SECRET)
            ann.publish("go")
            for name, ear in zip(people, ears, strict=True):
                while ear.poll(0):
                    heard[name].append(ear.recv())
                    topics[name].add(heard[name][-1].partition(b"\n")[0])
        for ear in ears:
            ear.close()
    assert b"trace" not in topics["face"]
    assert all(one.startswith((b"masked:", b"echo:", b"a:")) for one in topics["tablet"])
    assert SECRET not in b"".join(heard["tablet"]).decode()
    assert SECRET not in b"".join(f for f in heard["face"] if f.startswith(b"masked:")).decode()


def test_a_viewer_by_the_websocket_door_hears_no_more(
    people: dict[str, Path], runtime: Runtime
) -> None:
    hide(runtime.project)
    runtime.start()
    with situ.connect(runtime.endpoint, keys=people["ann"], timeout=DEADLINE) as ann:
        assert ann.addresses.http is not None
        door = ann.addresses.http.partition("?")[0] + "board?token=token"

        async def look() -> list[str]:
            heard: list[str] = []
            async with (
                asyncio.timeout(DEADLINE),
                aiohttp.ClientSession() as client,
                client.ws_connect(door) as socket,
            ):
                numbers = iter(range(1, 1000))

                async def ask(**fields: Any) -> Any:
                    number = next(numbers)
                    await socket.send_str(json.dumps({"id": number, **fields}))
                    while True:
                        frame = str((await socket.receive()).data)
                        heard.append(frame)
                        if frame[0] == "{" and json.loads(frame)["id"] == number:
                            return json.loads(frame)

                assert (await ask(do="hello", version=1, role="viewer"))["masked"]
                for topic in ("", "t:", "trace\n", "masked:"):
                    await socket.send_str("+" + topic)
                await ask(do="watch", patterns=["user.*"])
                await ask(do="trace", since=1)
                while not any("masked:t:user.name" in one for one in heard):
                    await asyncio.to_thread(ann.set, "user.name", SECRET)
                    await ask(do="get", names=["user.name"])
            return heard

        heard = asyncio.run(look())
    assert SECRET not in "".join(heard)
    assert "•••" in "".join(heard)
    assert not any(one.startswith(("t:", "trace")) for one in heard)


def test_what_is_private_from_a_deploy_on_is_hidden_from_who_was_there_before(
    people: dict[str, Path], runtime: Runtime, context: zmq.Context[zmq.Socket[bytes]]
) -> None:
    runtime.start()
    where = runtime.endpoint
    with (
        situ.connect(where, keys=people["ann"], timeout=DEADLINE) as ann,
        situ.connect(where, role="viewer", keys=people["tablet"], timeout=DEADLINE) as tablet,
        tablet.watch("user.*") as changes,
        listen(context, runtime, people["tablet"], ann) as ear,
    ):
        end = time.monotonic() + DEADLINE
        while not ear.poll(0):
            assert time.monotonic() < end
            ann.set("user.name", "Cyd")
        hide(runtime.project)
        ann.deploy(deployable(load_ready(runtime.project)), "situ.toml", force_after=0)
        while ann.progress().version != 1:
            assert time.monotonic() < end
        ann.set("user.name", SECRET)
        while (change := changes.next(DEADLINE)) is not None and change.value != "•••":
            assert change.value != SECRET
        # It has come back, and hears what it may.
        heard: list[bytes] = []
        while not any(frame.startswith(b"masked:t:") for frame in heard):
            assert time.monotonic() < end
            ann.set("user.name", SECRET)
            while ear.poll(0):
                heard.append(ear.recv())
    assert SECRET not in b"".join(heard).decode()
