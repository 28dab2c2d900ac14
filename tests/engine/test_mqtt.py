"""MQTT: a real broker (Debian's mosquitto) on this machine, and what may come from one."""

from __future__ import annotations

import asyncio
import logging
import shutil
import socket
import subprocess
import sys
from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import aiomqtt
import pytest

from situ.decide.inputs import AnyInput, Raise, Set
from situ.document.project import Mqtt
from situ.engine.mqtt import AGAIN, LONGEST, QUEUE, Bridge
from situ.engine.secrets import Secrets
from situ.errors import UsageError

DEADLINE = 20.0


class Broker:
    """mosquitto on a free port; ``more`` are lines of its configuration."""

    def __init__(self, program: str, folder: Path, *more: str) -> None:
        self._program = program
        self._folder = folder
        self._more = more
        with socket.create_server(("127.0.0.1", 0)) as free:
            self.port: int = free.getsockname()[1]
        self._process: subprocess.Popen[str] | None = None
        self.start()

    def start(self) -> None:
        lines = [f"listener {self.port} 127.0.0.1", "user root", *self._more]
        config = self._folder / "mosquitto.conf"
        config.write_text("\n".join(lines or ["allow_anonymous true"]) + "\n", "utf-8")
        self._process = subprocess.Popen(
            [self._program, "-c", str(config)], stderr=subprocess.PIPE, text=True
        )
        assert self._process.stderr is not None
        said = []
        for line in self._process.stderr:
            said.append(line)
            if line.rstrip().endswith("running"):
                return
        raise AssertionError(f"mosquitto did not start: {said}")

    def stop(self) -> None:
        if self._process is not None:
            self._process.kill()
            self._process.wait(DEADLINE)
            assert self._process.stderr is not None
            self._process.stderr.close()
            self._process = None

    def client(self, **more: Any) -> aiomqtt.Client:
        return aiomqtt.Client("127.0.0.1", self.port, timeout=DEADLINE, **more)


@pytest.fixture
def make_broker(mosquitto: str, tmp_path: Path) -> Iterator[Callable[..., Broker]]:
    made: list[Broker] = []

    def make(*more: str) -> Broker:
        made.append(Broker(mosquitto, tmp_path, *(more or ["allow_anonymous true"])))
        return made[-1]

    yield make
    for one in made:
        one.stop()


@pytest.fixture
def broker(make_broker: Callable[..., Broker]) -> Broker:
    return make_broker()


class Robot:
    """What a bridge submits and says, to be waited for."""

    def __init__(self) -> None:
        self.inputs: list[AnyInput] = []
        self.said: list[str] = []
        self._more = asyncio.Event()
        self.log = logging.Logger("robot")
        handler = logging.Handler()
        handler.emit = self._emit  # type: ignore[method-assign]
        self.log.addHandler(handler)
        # The library's own lines are no news.
        self.log.getChild = lambda _: logging.Logger("silent", logging.CRITICAL)  # type: ignore[method-assign,assignment]

    def submit(self, given: AnyInput) -> None:
        self.inputs.append(given)
        self._more.set()

    def _emit(self, record: logging.LogRecord) -> None:
        self.said.append(record.getMessage())
        self._more.set()

    async def until(self, ready: Callable[[], bool]) -> None:
        async with asyncio.timeout(DEADLINE):
            while not ready():
                self._more.clear()
                await self._more.wait()

    async def told(self, words: str) -> None:
        """Waits for a line of the log with these words, and forgets all lines."""
        await self.until(lambda: any(words in line for line in self.said))
        self.said.clear()

    async def first(self, count: int) -> list[AnyInput]:
        await self.until(lambda: len(self.inputs) >= count)
        return self.inputs


@asynccontextmanager
async def bridge(
    url: str, incoming: dict[str, str] | None = None, state: Path | None = None, clock: Any = None
) -> AsyncIterator[tuple[Bridge, Robot]]:
    robot = Robot()
    loop = asyncio.get_running_loop()
    mqtt = Mqtt(url, incoming or {})
    made = Bridge(mqtt, robot.submit, Secrets(state), clock or loop, robot.log)
    made.start()
    try:
        yield made, robot
    finally:
        await made.close()


@asynccontextmanager
async def joined(
    broker: Broker, incoming: dict[str, str] | None = None
) -> AsyncIterator[tuple[Bridge, Robot, aiomqtt.Client]]:
    """A bridge that is subscribed, and another client of the broker."""
    asked = {**(incoming or {}), "ready": "event:ready"}
    async with (
        bridge(f"mqtt://127.0.0.1:{broker.port}", asked) as (made, robot),
        broker.client() as client,
    ):
        # Subscriptions are made in order; whoever hears this one hears them all.
        ready = Raise("ready")
        async with asyncio.timeout(DEADLINE):
            while ready not in robot.inputs:
                await client.publish("ready", qos=1)
                await asyncio.sleep(0)
        await client.publish("ready", b"last", qos=1)
        robot.inputs.clear()
        yield made, robot, client


async def given(robot: Robot, client: aiomqtt.Client, count: int) -> list[AnyInput]:
    """What came in besides that the bridge is ready."""
    await robot.until(lambda: sum(one != Raise("ready") for one in robot.inputs) >= count)
    return [one for one in robot.inputs if one != Raise("ready")]


def test_what_comes_in_is_an_event_or_a_tag(broker: Broker) -> None:
    asked = {
        "zigbee/+/fall": "event:fallDetected",
        "room/temp": "tag:room.temperature",
        "ward/#": "tag:ward.last",
    }

    async def scenario() -> None:
        async with joined(broker, asked) as (_, robot, client):
            await client.publish("zigbee/hall/fall", b"", qos=1)
            await client.publish("zigbee/hall/door/fall", b"", qos=1)
            for payload in (b"21.5", b'{"value": [1, null]}', b"warm, but windy", b"NaN", b""):
                await client.publish("room/temp", payload, qos=1)
            await client.publish("ward/7/bed/2", b"true", qos=1)
            assert await given(robot, client, 7) == [
                Raise("fallDetected"),
                Set({"room.temperature": 21.5}, "mqtt"),
                Set({"room.temperature": {"value": [1, None]}}, "mqtt"),
                Set({"room.temperature": "warm, but windy"}, "mqtt"),
                Set({"room.temperature": "NaN"}, "mqtt"),
                Set({"room.temperature": None}, "mqtt"),
                Set({"ward.last": True}, "mqtt"),
            ]

    asyncio.run(scenario())


def test_a_message_that_two_filters_fit_does_what_each_says_once(broker: Broker) -> None:
    asked = {"ward/+": "event:some", "ward/#": "event:all", "ward/7": "tag:seven"}

    async def scenario() -> None:
        async with joined(broker, asked) as (_, robot, client):
            await client.publish("ward/7", b"1", qos=1)
            await client.publish("ward/8/x", b"2", qos=1)
            assert await given(robot, client, 4) == [
                Raise("some"),
                Raise("all"),
                Set({"seven": 1}, "mqtt"),
                Raise("all"),
            ]

    asyncio.run(scenario())


def test_what_the_broker_keeps_is_a_tags_value_but_no_event(broker: Broker) -> None:
    async def scenario() -> None:
        async with broker.client() as client:
            await client.publish("room/temp", b"19", qos=1, retain=True)
            await client.publish("fall", b"", qos=1, retain=True)
            await client.publish("zigbee/fall", b"x", qos=1, retain=True)
        asked = {
            "zigbee/fall": "event:fallDetected",
            "room/temp": "tag:room.temperature",
        }
        async with bridge(f"mqtt://127.0.0.1:{broker.port}", asked) as (_, robot):
            assert await robot.first(1) == [Set({"room.temperature": 19}, "mqtt")]

    asyncio.run(scenario())


@pytest.mark.parametrize("payload", [b"\xff\xfe", b"[" * 150 + b"]" * 150])
def test_what_is_no_value_is_told_and_left_out(broker: Broker, payload: bytes) -> None:
    async def scenario() -> None:
        async with joined(broker, {"x": "tag:x"}) as (_, robot, client):
            await client.publish("x", payload, qos=1)
            await client.publish("x", b"1", qos=1)
            assert await given(robot, client, 1) == [Set({"x": 1}, "mqtt")]
            assert any(" at x is " in line for line in robot.said)

    asyncio.run(scenario())


def test_an_applications_message_goes_out_unkept(broker: Broker) -> None:
    values: list[Any] = [{"room": 12}, "ON", 3.5, None]

    async def scenario() -> None:
        async with joined(broker) as (made, _, client):
            await client.subscribe("nurse/#", qos=1)
            for value in values:
                made.send("nurse/call", value)
            heard = []
            async with asyncio.timeout(DEADLINE):
                async for message in client.messages:
                    heard.append((str(message.topic), message.payload, message.qos))
                    assert not message.retain
                    if len(heard) == len(values):
                        break
            assert heard == [
                ("nurse/call", payload, 1) for payload in (b'{"room":12}', b"ON", b"3.5", b"")
            ]
        async with broker.client() as late:
            await late.subscribe("nurse/#", qos=1)
            await late.subscribe("end", qos=1)
            await late.publish("end", b"", qos=1)
            async for message in late.messages:
                assert str(message.topic) == "end"
                break

    asyncio.run(scenario())


def test_no_topic_that_none_can_have_is_sent(broker: Broker) -> None:
    async def scenario() -> None:
        async with joined(broker) as (made, robot, client):
            await client.subscribe("a/#", qos=1)
            for topic in ("a/+", "a/#", "", "a/\0", "a/" + "x" * 70_000):
                made.send(topic, 1)
            made.send("a/b", 2)
            async for message in client.messages:
                assert str(message.topic) == "a/b"
                break
            assert len([line for line in robot.said if "is no topic" in line]) == 5

    asyncio.run(scenario())


def test_a_broker_that_is_away_is_tried_again_and_told_what_waited(
    broker: Broker, hand_clock: Any
) -> None:
    broker.stop()

    async def scenario() -> None:
        url = f"mqtt://127.0.0.1:{broker.port}"
        async with bridge(url, clock=hand_clock) as (made, robot):
            await robot.told("can not be used")
            made.send("nurse/call", 1)
            for wait in (AGAIN, 2 * AGAIN):
                assert await hand_clock.asked_for_time() == pytest.approx(wait)
                await hand_clock.advance(wait)
            assert await hand_clock.asked_for_time() == pytest.approx(4 * AGAIN)
            # It was said once, not each time.
            assert robot.said == []
            await asyncio.to_thread(broker.start)
            async with broker.client() as client:
                await client.subscribe("nurse/#", qos=1)
                await hand_clock.advance(4 * AGAIN)
                async with asyncio.timeout(DEADLINE):
                    async for message in client.messages:
                        assert message.payload == b"1"
                        break
            await asyncio.to_thread(broker.stop)
            await robot.told("can not be used")
            # From the beginning, for it had been there.
            assert await hand_clock.asked_for_time() == pytest.approx(AGAIN)

    asyncio.run(scenario())


def test_the_waits_do_not_grow_for_ever(broker: Broker, hand_clock: Any) -> None:
    broker.stop()

    async def scenario() -> None:
        url = f"mqtt://127.0.0.1:{broker.port}"
        async with bridge(url, clock=hand_clock):
            waits = []
            for _ in range(7):
                waits.append(await hand_clock.asked_for_time())
                await hand_clock.advance(waits[-1])
            assert waits == pytest.approx([1, 2, 4, 8, 16, 30, LONGEST])

    asyncio.run(scenario())


def test_of_too_many_messages_the_oldest_are_dropped_and_told(broker: Broker) -> None:
    broker.stop()

    async def scenario() -> None:
        async with bridge(f"mqtt://127.0.0.1:{broker.port}") as (made, robot):
            await robot.told("can not be used")
            for number in range(QUEUE + 1):
                made.send("x", number)
            assert [line for line in robot.said if "oldest" in line]

    asyncio.run(scenario())


def password(folder: Path, text: str) -> None:
    file = folder / "secrets.toml"
    file.write_text(text, "utf-8")
    file.chmod(0o600)


def test_user_and_password_are_the_robots_secret(
    make_broker: Callable[..., Broker], tmp_path: Path
) -> None:
    users = tmp_path / "users"
    tool = shutil.which("mosquitto_passwd")
    assert tool is not None
    subprocess.run([tool, "-c", "-b", str(users), "robot", "not-told"], check=True)
    broker = make_broker("allow_anonymous false", f"password_file {users}")
    url = f"mqtt://127.0.0.1:{broker.port}"

    async def scenario() -> None:
        async with bridge(url, state=tmp_path) as (_, robot):
            await robot.until(lambda: any("can not be used" in line for line in robot.said))
            assert "uthori" in robot.said[0]
        password(tmp_path, '[mqtt]\nuser = "robot"\npassword = "not-told"\n')
        async with bridge(url, state=tmp_path) as (made, robot):
            made.send("x", 1)
            async with broker.client(username="robot", password="not-told") as client:
                await client.subscribe("y", qos=1)
                made.send("y", 2)
                async with asyncio.timeout(DEADLINE):
                    async for message in client.messages:
                        assert message.payload == b"2"
                        break
            assert all("connected to" in line for line in robot.said)

    asyncio.run(scenario())


# The library leaves the socket of a handshake that fails to the garbage collector.
@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
def test_mqtts_is_encrypted_and_the_broker_must_be_the_right_one(
    make_broker: Callable[..., Broker], tmp_path: Path
) -> None:
    key, certificate = tmp_path / "key.pem", tmp_path / "ca.pem"
    request = "req -x509 -newkey ec -pkeyopt ec_paramgen_curve:P-256 -nodes -days 2"
    names = "-subj /CN=localhost -addext subjectAltName=DNS:localhost,IP:127.0.0.1"
    files = ["-keyout", str(key), "-out", str(certificate)]
    command = ["openssl", *request.split(), *names.split(), *files]
    subprocess.run(command, check=True, capture_output=True)
    broker = make_broker("allow_anonymous true", f"certfile {certificate}", f"keyfile {key}")
    url = f"mqtts://127.0.0.1:{broker.port}"

    async def scenario() -> None:
        async with bridge(url, state=tmp_path) as (_, robot):
            await robot.told("CERTIFICATE_VERIFY_FAILED")
        password(tmp_path, '[mqtt]\nca = "ca.pem"\n')
        tls = aiomqtt.TLSParameters(ca_certs=str(certificate))
        async with bridge(url, state=tmp_path) as (made, _), broker.client(tls_params=tls) as one:
            await one.subscribe("x", qos=1)
            made.send("x", 1)
            async with asyncio.timeout(DEADLINE):
                async for message in one.messages:
                    assert message.payload == b"1"
                    break

    asyncio.run(scenario())


@pytest.mark.parametrize(
    ("url", "words"),
    [
        ("http://127.0.0.1", "is none"),
        ("mqtt://", "is none"),
        ("127.0.0.1:1883", "is none"),
        ("mqtt://127.0.0.1:99999", "is none"),
        ("mqtt://127.0.0.1/topic", "is none"),
        ("mqtt://ann:key@127.0.0.1", "secrets.toml"),
    ],
)
def test_a_url_that_is_none_ends_the_start(url: str, words: str) -> None:
    async def scenario() -> None:
        async with bridge(url):
            pass

    with pytest.raises(UsageError, match=words) as caught:
        asyncio.run(scenario())
    assert "ann" not in str(caught.value)
    assert "\n" not in str(caught.value)


# -- a whole robot ---------------------------------------------------------------

APPLICATION = """<application name="ward" start="1">
  <state no="1"><expectedevents>
    <event name="go" next="2"/>
    <event next="2"><when><data tag="fall" is="true"/></when></event>
  </expectedevents></state>
  <state no="2"><backgroundactions>
    <message topic="nurse/call"><param name="room">12</param></message>
  </backgroundactions></state>
</application>"""


async def run(broker: Broker, folder: Path, *options: str) -> str:
    """``situ run`` until it has called the nurse; its trace. Somebody has fallen already."""
    (folder / "ward.rbd.xml").write_text(APPLICATION, "utf-8")
    (folder / "situ.toml").write_text(
        '[project]\nname = "ward"\napplications = ["ward.rbd.xml"]\n'
        f'[mqtt]\nurl = "mqtt://127.0.0.1:{broker.port}"\nin = {{ "+/fall" = "tag:fall" }}\n',
        "utf-8",
    )
    trace = folder / "trace.jsonl"
    command = ["-m", "situ", "run", str(folder), "--endpoint", "tcp://127.0.0.1:0", "--trace"]
    async with broker.client() as client:
        await client.subscribe("nurse/#", qos=1)
        await client.publish("zigbee/fall", b"true", qos=1, retain=True)
        robot = await asyncio.create_subprocess_exec(
            *(sys.executable, *command, str(trace), "--state", str(folder / "state")),
            *("--services", "core", "--no-restart", *options),
            stdout=subprocess.DEVNULL,
        )
        try:
            async with asyncio.timeout(DEADLINE):
                async for message in client.messages:
                    assert (str(message.topic), message.payload) == ("nurse/call", b'{"room":12}')
                    break
                if "--script" not in options:
                    robot.terminate()
                assert await robot.wait() == 0
        finally:
            if robot.returncode is None:
                robot.kill()
                await robot.wait()
    return trace.read_text("utf-8")


def test_a_robot_hears_its_broker_and_tells_it(broker: Broker, tmp_path: Path) -> None:
    trace = asyncio.run(run(broker, tmp_path))
    assert '"writer":"mqtt"' in trace


def test_in_a_played_scenario_messages_go_out_and_nothing_comes_in(
    broker: Broker, tmp_path: Path
) -> None:
    script = tmp_path / "s.jsonl"
    script.write_text('{"at":0,"event":"go"}\n{"at":0.1,"end":true}\n', "utf-8")
    trace = asyncio.run(run(broker, tmp_path, "--script", str(script)))
    assert '"writer":"mqtt"' not in trace
