"""Applications are modules among others: a higher situation interrupts what they really do, and
gives it back.

Two applications and a module, with everything real but the patience of the one who looks: a voice
that renders what it says, a simulated robot that drives, a web service that lets wait, a page that
shows a film.
"""

from __future__ import annotations

import asyncio
import json
import shutil
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import aiohttp
import pytest
from aiohttp import web
from msgspec import UNSET, Struct

from situ.blackboard.client import connect_async
from situ.blackboard.replies import Addresses
from situ.decide import inputs
from situ.decide.trace import TraceEvent, to_fields
from situ.document.project import Project
from situ.document.ready import load_ready
from situ.engine.deciding import Setup
from situ.engine.live import Live
from situ.engine.perform import Performer
from situ.engine.robots import Surroundings
from situ.engine.robots.sim import SimulatedRobot
from situ.engine.voices.espeak import EspeakNg
from situ.rehearse.scenario import Line
from situ.rehearse.simulate import simulate

WARD = Path(__file__).parent / "ward"
CLIP = Path(__file__).parents[2] / "examples" / "reception" / "media" / "clip.webm"
DEADLINE = 40.0

Event = dict[str, Any]


class Ward:
    """The robot's side on one loop: its trace, its body, its voice and its screen."""

    def __init__(self, project: Project, voice: EspeakNg) -> None:
        self.trace: list[Event] = []
        self._voice = voice
        self._more = asyncio.Event()
        self._project = project
        self.live = Live(
            project,
            Setup(heard=self._heard),
            self._performer,
        )

    def _performer(self, submit: Any, tag: Any) -> Performer:
        def adapter(around: Surroundings) -> SimulatedRobot:
            self.body = SimulatedRobot(around)
            return self.body

        return Performer(
            self._project, submit, tag=tag, sound=False, voice=self._voice, adapter=adapter
        )

    def _heard(self, events: list[TraceEvent], _: float) -> None:
        self.trace += map(to_fields, events)
        self._more.set()

    def told(self, **fields: Any) -> list[Event]:
        """The events so far that have these fields."""
        return [e for e in self.trace if all(e.get(name) == fields[name] for name in fields)]

    async def until(self, count: int = 1, **fields: Any) -> Event:
        """Waits for so many events with these fields; the last of them."""
        while len(found := self.told(**fields)) < count:
            self._more.clear()
            await self._more.wait()
        return found[-1]


class Page:
    """What stands on the robot's screen, for one who is let in; films end when it says so."""

    def __init__(self, socket: aiohttp.ClientWebSocketResponse) -> None:
        self._socket = socket

    async def showing(self, name: str) -> dict[str, Any]:
        """Waits until the component of that name is shown; it as the page gets it."""
        while True:
            message = json.loads((await self._socket.receive()).data)
            screen = message.get("show", {}).get("screen")
            for component in screen["components"] if screen else ():
                if component["id"] == name:
                    return dict(component)

    async def empty(self) -> None:
        while True:
            message = json.loads((await self._socket.receive()).data)
            if "show" in message and message["show"]["screen"] is None:
                return

    async def ended(self, film: dict[str, Any]) -> None:
        await self._socket.send_json({"revision": 1, "ended": {"action": film["action"]}})


@asynccontextmanager
async def page(url: str) -> AsyncIterator[Page]:
    root = url.partition("/?")[0]
    async with aiohttp.ClientSession(cookie_jar=aiohttp.CookieJar(unsafe=True)) as client:
        async with client.get(url) as answer:
            assert answer.status == 200
        async with client.ws_connect(f"{root}/ws", origin=root) as socket:
            yield Page(socket)


class Log:
    """A web service that answers when it may."""

    def __init__(self) -> None:
        self.asked = 0
        self.may = asyncio.Event()

    async def answer(self, _: web.Request) -> web.Response:
        self.asked += 1
        await self.may.wait()
        return web.json_response({"number": 7})

    @asynccontextmanager
    async def served(self) -> AsyncIterator[str]:
        application = web.Application()
        application.router.add_get("/log", self.answer)
        runner = web.AppRunner(application)
        await runner.setup()
        site = web.TCPSite(runner, "127.0.0.1", 0)
        await site.start()
        assert runner.addresses
        try:
            yield f"http://127.0.0.1:{runner.addresses[0][1]}/log"
        finally:
            self.may.set()
            await runner.cleanup()


class Lived(Struct):
    """A run that is over. spoken: how many times espeak-ng began to speak."""

    project: Project
    trace: list[Event]
    spoken: int

    def of(self, *kinds: str, **fields: Any) -> list[Event]:
        """The events of these kinds that have these fields."""
        found = [event for event in self.trace if event["kind"] in kinds]
        return [e for e in found if all(e.get(name) == fields[name] for name in fields)]


@pytest.fixture(scope="module")
def lived(espeak: str, tmp_path_factory: pytest.TempPathFactory) -> Lived:
    """An emergency in the middle of everything; what can only be seen meanwhile is judged here."""
    folder = tmp_path_factory.mktemp("many") / "ward"
    shutil.copytree(WARD, folder)
    (folder / "media").mkdir()
    shutil.copy(CLIP, folder / "media")
    begun = folder / "begun"
    program = folder / "espeak"
    program.write_text(f'#!/bin/sh\necho begun >> "{begun}"\nexec {espeak} "$@"\n', "utf-8")
    program.chmod(0o755)

    async def interrupt(ward: Ward, addresses: Addresses, log: Log) -> None:
        assert addresses.http is not None
        async with (
            page(addresses.http) as screen,
            connect_async(addresses.requests, "nurse", ["base", "screen", "speech"]) as nurse,
            nurse.authority("base", "screen", "speech") as body,
        ):
            film = await screen.showing("clip")
            # It drives, it speaks, the film runs, and nobody has answered yet.
            await ward.until(tag="pose.x")
            assert not body.held
            assert ward.told(kind="finished") == []
            await nurse.set("emergency", True)
            await body.wait(DEADLINE)
            await screen.empty()
            stopped = ward.body.pose
            assert 0 < stopped[0] < 1.2
            # Whoever is interrupted stands still, but what he asked of others goes on.
            log.may.set()
            await ward.until(kind="finished", action="service")
            # The film is no longer shown: that it ended says nothing to anybody.
            await screen.ended(film)
            turned = len(ward.told(tag="pose.heading"))
            await body.command({"turn": 60}, resource="base")
            await ward.until(turned + 1, tag="pose.heading")
            assert ward.body.pose[:2] == pytest.approx(stopped[:2])
            await nurse.set("emergency", False)
            again = await screen.showing("clip")
            assert again["action"] != film["action"]
            await screen.ended(again)
            await screen.showing("bye")
            await ward.until(kind="enter", application="guide", state="2")
            assert ward.body.pose == pytest.approx((1.2, 0.5, 90))

    async def within() -> Lived:
        log = Log()
        async with asyncio.timeout(DEADLINE), log.served() as url:
            (folder / "robot.local.toml").write_text(f'[tags]\n"services.log" = "{url}"\n', "utf-8")
            project = load_ready(folder)
            ward = Ward(project, EspeakNg(str(program)))
            addresses = await ward.live.start()
            try:
                await interrupt(ward, addresses, log)
            finally:
                await ward.live.stop()
        assert log.asked == 1
        return Lived(project, ward.trace, begun.read_text().count("begun"))

    return asyncio.run(within())


@pytest.mark.espeak
def test_what_was_interrupted_begins_again_and_the_rest_goes_on(lived: Lived) -> None:
    of = lived.of
    (datum,) = of("data", tag="emergency", value=True)
    (back,) = of("data", tag="emergency", value=False)
    # Within the step of its datum everything has changed hands, and nobody is without.
    changed = [e for e in of("authority") if e["t"] == datum["t"]]
    assert [(e["resource"], e["from"], e["to"]) for e in changed] == [
        ("base", "guide", "nurse"),
        ("screen", "film", "nurse"),
        ("speech", "guide", "nurse"),
    ]
    assert [e["application"] for e in of("suspend") if e["t"] == datum["t"]] == ["guide", "film"]
    assert [e["application"] for e in of("resume") if e["t"] == back["t"]] == ["guide", "film"]
    cut = [e["action"] for e in of("cancelled") if e["t"] == datum["t"]]
    assert sorted(cut) == ["movie", "robot", "speech"]
    begun = [e["action"] for e in of("action") if e["t"] == back["t"] and e["action"] in cut]
    assert sorted(begun) == ["movie", "robot", "speech"]
    # Each was begun twice and ended once; the service, that nothing cuts off, once.
    for action, times in (("movie", 2), ("robot", 2), ("speech", 2), ("service", 1)):
        assert len(of("action", action=action)) == times
        assert [e["ok"] for e in of("finished", action=action)] == [True]
    (answered,) = of("finished", action="service")
    (judged,) = of("event", name="logged")
    assert datum["seq"] < answered["seq"] < back["seq"] < judged["seq"]
    assert judged["t"] == back["t"]
    assert of("data", tag="interruptions")[-1]["value"] == 1
    assert lived.spoken == 2


@pytest.mark.espeak
def test_it_is_what_the_simulator_says(lived: Lived) -> None:
    lines = [
        Line(number, round(event["t"] * 1e6), given)
        for number, event in enumerate(lived.trace, 1)
        if (given := outside(event)) is not None
    ]
    simulated: list[Event] = []
    simulate(lived.project, lines, tell=lambda events: simulated.extend(map(to_fields, events)))
    assert timeless(simulated) == timeless(lived.trace)


def outside(event: Event) -> inputs.AnyInput | None:
    """The input that an event of the trace came from; None for one that followed."""
    kind, module = event["kind"], str(event.get("module"))
    if event["cause"] is not None or event["t"] == 0:
        return None
    if kind == "finished":
        told = {key: event.get(key) for key in ("action", "name", "application", "result", "error")}
        status = 200 if event["action"] == "service" else UNSET
        return inputs.Finish(ok=event["ok"], status=status, **told)
    if kind == "data":
        return inputs.Set({event["tag"]: event["value"]}, event["writer"])
    if kind == "acquire":
        return inputs.Acquire(module, tuple(event["resources"]))
    if kind == "abandon":
        return inputs.Abandon(module, tuple(event["resources"]))
    if kind == "mapping":
        return inputs.Command(module, event["resource"], event["value"])
    return inputs.Lost(module) if kind == "lost" else None


def timeless(trace: list[Event]) -> list[Event]:
    """The events without those of connections, counted anew."""
    kept = [event for event in trace if event["kind"] != "connected"]
    seq = {event["seq"]: number for number, event in enumerate(kept, 1)}
    return [event | {"seq": seq[event["seq"]], "cause": seq.get(event["cause"])} for event in kept]
