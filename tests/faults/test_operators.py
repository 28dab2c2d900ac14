"""What operators do to a robot that is a process of its own, and what its recording tells of it."""

from __future__ import annotations

import asyncio
import csv
import json
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, Any

import aiohttp
import pytest

import situ
from situ import cli

if TYPE_CHECKING:
    from tests.faults.conftest import Runtime

DEADLINE = 30.0
PROJECT = {
    "situ.toml": """\
[project]
name = "desk"
applications = ["desk.rbd.xml"]
spds = "desk.spds.xml"
[[setting]]
tag = "morning"
type = "time"
""",
    "desk.rbd.xml": """\
<application name="desk" start="1">
  <state no="1" name="waits"><expectedevents><event name="go" next="2"/></expectedevents></state>
  <state no="2" name="serves">
    <timeout next="1">3600</timeout>
    <expectedevents><event name="over" next="1"/></expectedevents>
  </state>
</application>
""",
    "desk.spds.xml": """\
<spds name="desk">
  <modules><module name="desk" resources="screen"/></modules>
  <situation name="alarm" extends="calm">
    <condition><data tag="fall" is="true"/></condition>
  </situation>
  <situation name="calm"><module name="desk" priority="1"/></situation>
</spds>
""",
}


@pytest.fixture
def desk(runtime: Runtime, tmp_path: Path) -> Runtime:
    runtime.project = tmp_path / "desk"
    runtime.project.mkdir()
    for name, text in PROJECT.items():
        (runtime.project / name).write_text(text)
    return runtime


def test_what_an_operator_does_stands_in_the_trace_with_who_did_it_and_is_decided_again(
    desk: Runtime, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    record = tmp_path / "run.mcap"
    desk.start("--record", str(record))

    def do(*command: str) -> None:
        assert cli.main([*command, "--at", desk.endpoint]) == 0

    with situ.connect(desk.endpoint, timeout=DEADLINE) as board, board.trace(1) as events:
        do("debug", "break", "--state", "2", "--when", '<data tag="x" is="1"/>')
        do("debug", "break", "--from", "2", "--to", "1")
        do("debug", "break", "--situation", "alarm")
        do("set", "x", "1")
        do("event", "go", "--application", "desk")
        do("event", "over")
        do("debug", "resume")
        do("debug", "step")
        do("debug", "resume")
        do("set", "fall", "true")
        do("debug", "unbreak")
        do("debug", "resume")
        do("debug", "pause", "--application", "desk")
        do("debug", "goto", "2")
        do("set", "last", "1")
        told: list[dict[str, Any]] = []
        while not told or told[-1].get("tag") != "last":
            event = events.next(DEADLINE)
            assert event is not None
            told.append(event)
    assert desk.stop() == 0
    who = next(one["writer"] for one in told if one.get("tag") == "x")
    assert who.startswith("operator:")
    done = [
        (one["kind"], one.get("tag") or one.get("name") or one.get("breakpoint") or one.get("to"))
        for one in told
        if one.get("writer") == who or one["kind"] == "paused"
    ]
    stops = ("data", "debugger.breakpoints")
    assert done == [
        *(stops, stops, stops, ("data", "x"), ("event", "go"), ("paused", 1)),
        # What was raised meanwhile waited, and stops before the way that it takes.
        *(("resumed", 1), ("paused", 2), ("event", "over"), ("paused", None), ("resumed", None)),
        *(("data", "fall"), ("paused", 3), stops, ("resumed", 3), ("paused", None)),
        *(("transition", "2"), ("data", "last")),
    ]
    capfd.readouterr()
    assert cli.main(["replay", str(record)]) == 0
    replayed = [json.loads(line) for line in capfd.readouterr().out.splitlines()]
    assert replayed[: len(told)] == told
    assert cli.main(["replay", str(record), "--decide"]) == 0
    entered = [one["seq"] for one in told if one["kind"] == "enter"]
    capfd.readouterr()
    assert cli.main(["why", str(record), str(entered[1])]) == 0
    assert "go" in capfd.readouterr().out
    usage = tmp_path / "usage.csv"
    assert cli.main(["report", str(record), "-o", str(usage)]) == 0
    with usage.open(newline="") as file:
        assert "desk" in {row["application"] for row in csv.DictReader(file)}


def test_a_setting_that_was_saved_on_the_page_outlives_a_kill(desk: Runtime) -> None:
    desk.start()

    async def visit(*asked: dict[str, Any]) -> list[dict[str, Any]]:
        with situ.connect(desk.endpoint, timeout=DEADLINE) as board:
            root, _, token = (board.addresses.http or "").partition("/?token=")
        headers = {"Authorization": f"Bearer {token}"}
        async with asyncio.timeout(DEADLINE), aiohttp.ClientSession(headers=headers) as client:
            async with client.get(f"{root}/settings.json") as answer:
                (form,) = (await answer.json())["settings"]
                assert (form["tag"], form["type"]) == ("morning", "time")
            async with client.ws_connect(f"{root}/board") as socket:
                replies = []
                hello = {"do": "hello", "version": 1, "role": "operator", "user": "settings"}
                for number, request in zip(count(1), (hello, *asked), strict=False):
                    await socket.send_str(json.dumps({"id": number, **request}))
                    replies.append(json.loads((await socket.receive()).data))
                return replies[1:]

    save = {"do": "set", "tags": {"morning": "08:30"}, "versions": {"morning": 0}}
    (kept,) = asyncio.run(visit(save))
    assert kept["re"] == "written"
    desk.kill()
    desk.start("--fresh")
    (found,) = asyncio.run(visit({"do": "get", "names": ["morning"]}))
    entry = found["entries"]["morning"]
    assert (entry["value"], entry["writer"]) == ("08:30", "operator:settings")
