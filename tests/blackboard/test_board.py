"""``situ.connect`` against ``situ run`` as a process of its own, over real sockets."""

from __future__ import annotations

import asyncio
import json
import os
import queue
import random
import re
import select
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
import zmq

import situ
from situ.blackboard.client import Board, Change, Link, Offer, Person
from situ.errors import BlackboardError, Refused, Unreachable, UsageError

DEADLINE = 20.0
DOCUMENT = Path(__file__).parent.parent.parent / "docs" / "protocol.md"


@pytest.fixture
def board(running: Any) -> Iterator[Board]:
    with situ.connect(running.endpoint, timeout=DEADLINE) as connected:
        yield connected


@pytest.fixture
def context() -> Iterator[zmq.Context[zmq.Socket[bytes]]]:
    made: zmq.Context[zmq.Socket[bytes]] = zmq.Context()
    yield made
    made.destroy(linger=0)


def until(changes: Any, value: Any) -> Change:
    """The change that brings the value."""
    while (change := changes.next(DEADLINE)) is not None:
        if change.value == value:
            return change  # type: ignore[no-any-return]
    raise AssertionError(f"{value!r} did not come")


def test_what_one_client_sets_another_gets(running: Any, board: Board) -> None:
    assert board.set("speech.text", "hello") == {"speech.text": 1}
    assert board.set({"face.visible": True, "patient": {"room": 7}})["patient"] == 1
    with situ.connect(running.endpoint) as other:
        assert other.get("speech.text") == "hello"
        assert other.get("patient.room") == 7
        assert other.get("never.set") is None
        assert list(other.entries("face.*")) == ["face.visible"]
        assert str(other.entries("speech.text")["speech.text"].writer).startswith("operator:")


def test_a_set_against_another_version_is_refused(board: Board) -> None:
    version = board.set("counter", 1)["counter"]
    assert board.set("counter", 2, versions={"counter": version}) == {"counter": version + 1}
    with pytest.raises(Refused, match="get it and try again"):
        board.set("counter", 3, versions={"counter": version})
    assert board.get("counter") == 2


def test_a_watch_tells_what_stands_there_and_every_change_in_order(
    running: Any, board: Board
) -> None:
    board.set("count.x", 0)
    with situ.connect(running.endpoint) as other, other.watch("count.*") as changes:
        for count in range(1, 301):
            board.set("count.x", count)
        seen = [changes.next(DEADLINE) for _ in range(301)]
        assert [(c.value, c.version, c.missed) for c in seen if c] == [
            (count, count + 1, 0) for count in range(301)
        ]
        assert other.get("count.x") == 300


def test_a_watch_can_call_back(running: Any, board: Board) -> None:
    told: list[Any] = []
    enough = threading.Event()

    def on_change(change: Change) -> None:
        told.append(change.value)
        if change.value == "fail":
            raise ValueError("a callback of somebody's that fails")
        if len(told) == 4:
            enough.set()

    with situ.connect(running.endpoint) as other:
        watching = other.watch("called.back", on_change)
        for value in ("a", "fail", "b"):
            board.set("called.back", value)
        # While the caller himself waits for answers, too.
        other.set("called.back", "c")
        assert enough.wait(DEADLINE)
        assert told == ["a", "fail", "b", "c"]
        watching.close()


def test_a_pattern_that_is_none_is_refused(board: Board) -> None:
    with pytest.raises(Refused, match="is no tag and no pattern"):
        board.watch("Face.*")


def test_the_trace_has_a_backlog_and_goes_on(running: Any, board: Board) -> None:
    board.set("traced", 1)
    with situ.connect(running.endpoint, role="viewer") as viewer, viewer.trace(1) as events:
        first = events.next(DEADLINE)
        assert first is not None
        assert (first["seq"], first["kind"]) == (1, "data")
        board.set("traced", 2)
        last = first
        while last.get("tag") != "traced" or last["value"] != 2:
            event = events.next(DEADLINE)
            assert event is not None
            assert event["seq"] == last["seq"] + 1
            assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{6}Z", event["time"])
            last = event


def test_a_second_live_client_of_a_name_is_refused(running: Any) -> None:
    with (
        situ.connect(running.endpoint, "nod", ["head"]),
        pytest.raises(Refused, match="a module nod is connected already"),
    ):
        situ.connect(running.endpoint, "nod", ["head"], timeout=DEADLINE)
    # Said goodbye, its name is free at once.
    situ.connect(running.endpoint, "nod", ["head"]).close()


def test_authority_passes_on_and_comes_back_by_itself(running: Any, board: Board) -> None:
    board.set("person.calling", None)
    with (
        situ.connect(running.endpoint, "chase", ["head"]) as chase,
        situ.connect(running.endpoint, "nod", ["head"]) as nod,
        chase.authority("head") as chasing,
        board.watch("robot/head") as head,
    ):
        assert chasing.wait(DEADLINE)
        chasing.command({"yaw": 5})
        assert until(head, {"yaw": 5}).writer == "chase"
        with nod.authority("head") as nodding:
            assert not nodding.held
            board.set("person.calling", True)
            assert nodding.wait(DEADLINE)
            assert chasing.wait_lost(DEADLINE)
            nodding.command({"pitch": 10}, valid=60.0)
            until(head, {"pitch": 10})
        assert chasing.wait(DEADLINE)
        board.set("person.calling", None)


def test_what_a_module_may_not_ask_for_is_refused(running: Any) -> None:
    with situ.connect(running.endpoint, "nod", ["head"]) as nod:
        with pytest.raises(Refused, match="did not declare base"), nod.authority("base"):
            pass
        with (
            nod.authority("head") as head,
            pytest.raises(BlackboardError, match="did not declare"),
        ):
            head.command(1, resource="base")


def test_events_and_touches_reach_the_application(running: Any, board: Board) -> None:
    with board.watch("application/desk") as desk:
        first = desk.next(DEADLINE)
        assert first is not None
        assert first.value["state"] == "1"
        board.touch()
        board.use("go")
        assert until_state(desk, "2")
        board.publish("asked", "desk")
        assert until_state(desk, "1")


def until_state(changes: Any, state: str) -> bool:
    while (change := changes.next(DEADLINE)) is not None:
        if change.value["state"] == state:
            return True
    return False


def test_messages_of_applications_are_heard(running: Any, board: Board) -> None:
    told: queue.Queue[Any] = queue.Queue()
    with (
        board.messages("desk/*") as messages,
        board.messages("spo2/*") as others,
        board.messages("**", told.put),
    ):
        be_busy(board)
        message = messages.next(DEADLINE)
        assert message is not None
        assert (message.topic, message.application) == ("desk/busy", "desk")
        assert told.get(timeout=DEADLINE) == message
        assert others.next(0.0) is None


def test_messages_are_heard_in_asyncio(running: Any) -> None:
    async def go() -> None:
        async with situ.connect_async(running.endpoint) as board:
            called: asyncio.Queue[Any] = asyncio.Queue()
            async with board.messages("desk/busy") as heard, board.messages("desk/**") as all_heard:
                board.messages("desk/*", called.put_nowait)
                await board.publish("go")
                async for message in heard:
                    assert (message.topic, message.application) == ("desk/busy", "desk")
                    break
                assert await all_heard.next(DEADLINE) == message
                assert await called.get() == message
            await board.publish("asked", "desk")

    asyncio.run(asyncio.wait_for(go(), DEADLINE))


def be_busy(board: Board) -> None:
    """The desk's state ``busy`` is entered, and left again."""
    board.publish("go")
    board.publish("asked", "desk")


def test_modules_and_documents_are_told(running: Any, board: Board) -> None:
    with situ.connect(
        running.endpoint, "eyes", description="Sees.", provides=[Offer("face.direction")]
    ):
        states = {state.name: state for state in board.modules().modules}
        assert states["eyes"].present
        assert states["eyes"].description == "Sees."
        assert not states["carry"].present
    files = board.documents()
    assert files.project == "lab"
    assert sorted(files.files) == ["desk.rbd.xml", "lab.spds.xml", "modules.xml", "situ.toml"]
    lab = Path(__file__).parent / "lab"
    for path, text in files.files.items():
        assert text == (lab / path).read_text("utf-8")


def test_the_asyncio_form_has_the_same_names(running: Any, board: Board) -> None:
    async def go() -> None:
        async with situ.connect_async(running.endpoint, "carry", ["base", "head"]) as carry:
            assert await carry.set("from.asyncio", 1) == {"from.asyncio": 1}
            assert await carry.get("from.asyncio") == 1
            assert "from.asyncio" in await carry.entries("from.*")
            called: list[Any] = []
            carry.watch("from.*", lambda change: called.append(change.value))
            seen = []
            async for change in carry.watch("from.asyncio"):
                seen.append(change.value)
                if change.value == 3:
                    break
                await carry.set("from.asyncio", change.value + 1)
            assert seen == [1, 2, 3]
            async with carry.authority("base") as base:
                assert await base.wait(DEADLINE)
                await base.command({"vx": 0.2}, valid=30.0)
                assert (await carry.get("robot/base")) == {"vx": 0.2}
            assert await base.wait_lost(DEADLINE)
            await carry.publish("nothing.to.anybody")
            with pytest.raises(Refused):
                await carry.watch("Bad Pattern").next(DEADLINE)
            events = carry.trace(1)
            event = await events.next(DEADLINE)
            assert event is not None
            assert event["seq"] == 1
            assert called == [1, 2, 3]

    asyncio.run(asyncio.wait_for(go(), DEADLINE))
    public = {name for name in dir(Board) if not name.startswith("_")}
    from situ.blackboard.client import AsyncBoard

    assert public <= {name for name in dir(AsyncBoard) if not name.startswith("_")}


def test_a_link_can_be_driven_by_any_loop_that_waits_for_descriptors(running: Any) -> None:
    link = Link(running.endpoint, Person(role="operator", user="qt"))
    poll = select.poll()
    for descriptor in link.descriptors():
        poll.register(descriptor, select.POLLIN)
    watch = link.dialog.watch("driven.*")
    call = link.dialog.set({"driven.x": 1})
    values: list[Any] = []
    end = time.monotonic() + DEADLINE
    while len(values) < 2 and time.monotonic() < end:
        link.turn()
        values += [change.value for change in iter(watch.take, None)]
        if call.finished and values == [1]:
            call = link.dialog.set({"driven.x": 2})
            link.turn()
        poll.poll(max(0, link.due() - link.clock()) * 1000)
    assert values == [1, 2]
    link.dialog.bye()
    link.turn()
    link.close()


def test_many_threads_share_one_board(running: Any) -> None:
    failed: list[BaseException] = []
    with situ.connect(running.endpoint, timeout=DEADLINE) as shared:

        def work(number: int) -> None:
            try:
                for count in range(30):
                    shared.set(f"thread.t{number}", count)
                    assert shared.get(f"thread.t{number}") == count
            except BaseException as error:
                failed.append(error)

        threads = [threading.Thread(target=work, args=(n,)) for n in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(DEADLINE)
    assert failed == []


def test_a_closed_board_says_so(running: Any) -> None:
    board = situ.connect(running.endpoint)
    changes = board.watch("x")
    board.close()
    board.close()
    assert changes.next(DEADLINE) is None
    with pytest.raises(Unreachable, match="closed"):
        board.get("y")


def test_nobody_there_is_one_line(context: Any) -> None:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        endpoint = f"tcp://127.0.0.1:{free.getsockname()[1]}"
        with pytest.raises(Unreachable, match=f"^{endpoint}: nobody answers"):
            situ.connect(endpoint, timeout=0.3)


@pytest.mark.parametrize("endpoint", ["", "here", "tcp://", "udp://127.0.0.1:1"])
def test_an_address_that_is_none_is_told(endpoint: str) -> None:
    with pytest.raises(UsageError, match="write it as tcp://"):
        situ.connect(endpoint)


def test_the_snippet_of_the_document_works(running: Any, board: Board) -> None:
    code = DOCUMENT.read_text("utf-8").split("```python\n")[1].split("```")[0]
    code = code.replace("tcp://127.0.0.1:5570", running.endpoint)
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=DEADLINE, check=True
    )
    assert "face.visible" in done.stdout
    assert board.get("face.visible") is True


def test_malformed_frames_never_keep_the_server_from_answering(
    running: Any, board: Board, context: Any
) -> None:
    chance = random.Random(1)
    good = [
        b'{"do":"hello","id":1,"version":1,"role":"operator"}',
        b'{"do":"set","id":2,"tags":{"fuzz.x":1}}',
        b'{"do":"watch","id":3,"patterns":["fuzz.*"]}',
        b'{"do":"trace","id":4,"since":1}',
    ]
    stranger = context.socket(zmq.DEALER)
    stranger.connect(running.endpoint)
    stranger.send(good[0])
    for _ in range(400):
        frame = bytearray(chance.choice(good))
        for _ in range(chance.randint(1, 5)):
            frame[chance.randrange(len(frame))] = chance.randrange(256)
        frame = frame[: chance.randint(0, len(frame))]
        if chance.random() < 0.1:
            stranger.send_multipart([bytes(frame)] * chance.randint(2, 4))
        else:
            stranger.send(bytes(frame))
    others = [context.socket(sort) for sort in (zmq.PUSH, zmq.SUB, zmq.REQ)]
    for other in others:
        other.connect(running.endpoint)
        other.connect(running.notifications)
    for _ in range(50):
        others[1].setsockopt(zmq.SUBSCRIBE, bytes(chance.randrange(256) for _ in range(20)))
    parts = running.endpoint.rpartition(":")[2]
    for _ in range(20):
        with socket.create_connection(("127.0.0.1", int(parts))) as raw:
            raw.sendall(bytes(chance.randrange(256) for _ in range(64)))
    assert board.set("after.fuzz", 1)["after.fuzz"] >= 1
    stranger.send(b'{"do":"get","id":999,"names":["after.fuzz"]}')
    deadline = time.monotonic() + DEADLINE
    answers: list[Any] = []
    while time.monotonic() < deadline and 999 not in [a.get("id") for a in answers]:
        assert stranger.poll(DEADLINE * 1000)
        answers.append(json.loads(stranger.recv()))
    assert answers[-1]["re"] == "values"
    for one in (stranger, *others):
        one.close(linger=0)


MODULE = """
import os, sys, situ
board = situ.connect(sys.argv[1], "chase", ["head"])
with board.authority("head") as head:
    head.wait(20)
    head.command({"yaw": 1})
    print(head.held, flush=True)
    sys.stdin.read()
"""


def test_a_module_that_is_killed_hands_over_in_the_step_of_its_loss(
    running: Any, board: Board
) -> None:
    with (
        subprocess.Popen(
            [sys.executable, "-c", MODULE, running.endpoint],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env=os.environ,
        ) as module,
        situ.connect(running.endpoint, "carry", ["base", "head"]) as carry,
        board.trace() as events,
    ):
        assert module.stdout is not None
        assert module.stdout.readline() == b"True\n"
        with carry.authority("base", "head") as both:
            assert not both.held
            module.send_signal(signal.SIGKILL)
            assert both.wait(DEADLINE)
        lost = None
        while lost is None or lost["kind"] != "lost":
            lost = events.next(DEADLINE)
            assert lost is not None
        passed = events.next(DEADLINE), events.next(DEADLINE)
        assert [(e["kind"], e["resource"], e["to"], e["t"]) for e in passed if e] == [
            ("authority", "base", "carry", lost["t"]),
            ("authority", "head", "carry", lost["t"]),
        ]


def test_everything_comes_back_after_the_core_was_killed_and_started_anew(
    run_lab: Callable[..., Any],
) -> None:
    first = run_lab()
    endpoint, notifications = first.endpoint, first.notifications
    with (
        situ.connect(endpoint, "chase", ["head"], timeout=DEADLINE) as chase,
        situ.connect(endpoint, timeout=DEADLINE) as board,
        board.watch("kept.*") as changes,
        board.trace() as events,
        chase.authority("head") as head,
    ):
        assert head.wait(DEADLINE)
        board.set("kept.x", 1)
        until(changes, 1)
        first.kill()
        assert head.wait_lost(DEADLINE)
        again = ("--endpoint", endpoint, "--notify", notifications, "--http", "127.0.0.1:0")
        run_lab(*again, "--fresh")
        assert head.wait(DEADLINE)
        # What stood there is gone with the core that kept it, and told so.
        until(changes, None)
        board.set("kept.x", 2)
        until(changes, 2)
        seqs: list[int] = []
        while not seqs or seqs[-1] != 1:
            event = events.next(DEADLINE)
            assert event is not None
            seqs.append(event["seq"])
        head.command({"yaw": 2})
        assert board.get("robot/head") == {"yaw": 2}


def test_a_watcher_that_stalls_finds_the_gap_and_is_whole_again(
    running: Any, board: Board, monkeypatch: Any
) -> None:
    monkeypatch.setattr("situ.blackboard.link.HELD", 50)
    link = Link(running.endpoint, Person(role="viewer"))
    watch = link.dialog.watch("stalled.*")
    poll = select.poll()
    for descriptor in link.descriptors():
        poll.register(descriptor, select.POLLIN)

    def drive(ready: Callable[[], bool]) -> None:
        end = time.monotonic() + DEADLINE
        while not ready() and time.monotonic() < end:
            link.turn()
            poll.poll(max(0, link.due() - link.clock()) * 1000)

    drive(lambda: watch.ready)
    tags = [f"stalled.t{number}" for number in range(9)]
    with board.watch("stalled.end") as others:
        # More than the core keeps for who does not read, and than fits into the buffers.
        text = "x" * 1000
        for count in range(1600):
            board.set({**dict.fromkeys(tags, text), "stalled.end": count})
        assert until_end(others, 1599) == list(range(1, 1601))
    drive(lambda: "stalled.end" in watch.known and watch.known["stalled.end"].value == 1599)
    changes = list(iter(watch.take, None))
    versions: dict[str, int] = {}
    for change in changes:
        assert change.version == versions.get(change.tag, 0) + 1 + change.missed
        versions[change.tag] = change.version
    assert versions == dict.fromkeys([*tags, "stalled.end"], 1600)
    assert any(change.missed for change in changes)
    link.close()


def until_end(changes: Any, value: int) -> list[int]:
    """The versions of ``stalled.end`` until it has the value."""
    versions = []
    while (change := changes.next(DEADLINE)) is not None:
        if change.tag == "stalled.end":
            assert change.missed == 0
            versions.append(change.version)
            if change.value == value:
                return versions
    return versions


def test_situ_itself_stays_light_until_it_connects() -> None:
    code = """
import sys, situ
heavy = {"zmq", "msgspec", "lxml"} & set(sys.modules)
assert not heavy, heavy
situ.connect
assert "zmq" in sys.modules
"""
    subprocess.run([sys.executable, "-c", code], check=True, timeout=DEADLINE)
    with pytest.raises(AttributeError, match="has no attribute 'konnect'"):
        situ.konnect  # noqa: B018
