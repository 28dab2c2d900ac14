"""``[mqtt]`` of a project: events and tags from a broker, an application's messages to it.

One task that lives as long as the robot. A broker that is away is tried again, for ever; the
robot does not wait for it.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import secrets as chance
import ssl
from collections import deque
from collections.abc import Callable
from typing import Any
from urllib.parse import urlsplit

import aiomqtt
import msgspec

from situ.blackboard.wire import too_deep
from situ.decide.inputs import AnyInput, Raise, Set
from situ.document.project import Mqtt
from situ.engine.actions import ActionFailed
from situ.engine.clock import Clock, pause
from situ.engine.secrets import Secrets
from situ.errors import UsageError

WRITER = "mqtt"
"""Who writes the tags that come in."""

AGAIN, LONGEST = 1.0, 30.0
"""Seconds before the first try after a loss, twice as long before each further one, and at most."""

CLOSING = 1.0
"""Seconds that the last messages have to leave."""

QUEUE = 1_000
"""Messages that wait for the broker; of more the oldest are dropped."""

LIMIT = 4 * 1024 * 1024
"""Bytes of a message that comes in."""

QOS = 1
_PORTS = {"mqtt": 1883, "mqtts": 8883}


class Bridge:
    """The robot at its broker, from ``start`` to ``close``.

    submit: gets ``Set`` and ``Raise`` for what comes in. secrets: user, password, and who signed
    the broker's certificate. Raises UsageError for a url that is none.
    """

    def __init__(
        self,
        project: Mqtt,
        submit: Callable[[AnyInput], None],
        secrets: Secrets,
        clock: Clock,
        log: logging.Logger,
    ) -> None:
        self._tls, self._host, self._port = _address(project.url)
        self._shown = f"the MQTT broker at {self._host}:{self._port}"
        self._incoming = dict(project.incoming)
        self._submit = submit
        self._secrets = secrets
        self._clock = clock
        self._log = log
        # Another one than the robot's beside it: two of one name throw each other out.
        self._name = f"situ-{chance.token_hex(6)}"
        self._outgoing: deque[tuple[str, bytes]] = deque(maxlen=QUEUE)
        self._more = asyncio.Event()
        self._none = asyncio.Event()
        self._none.set()
        self._told = False
        self._task: asyncio.Task[None] | None = None

    def start(self) -> None:
        """Begins to look for the broker; waits for nothing."""
        self._task = asyncio.get_running_loop().create_task(self._keep())

    async def close(self) -> None:
        """Ends it; what was sent last leaves before, where the broker is there."""
        if self._task is not None:
            if not self._told:
                with contextlib.suppress(TimeoutError):
                    async with asyncio.timeout(CLOSING):
                        await self._none.wait()
            self._task.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await self._task
            self._task = None

    def send(self, topic: str, value: Any) -> None:
        """An application's message; kept for a broker that is away. Strings go as they are,
        null as nothing, all else as JSON."""
        if not topic or len(topic.encode()) > 65_535 or any(char in topic for char in "+#\0"):
            self._log.warning("%.80r is no topic that a message can have in MQTT", topic)
            return
        if len(self._outgoing) == QUEUE:
            self._log.warning("%s is away: its oldest message is dropped", self._shown)
        self._outgoing.append((topic, _payload(value)))
        self._none.clear()
        self._more.set()

    # -- the connection ------------------------------------------------------

    async def _keep(self) -> None:
        wait = AGAIN
        while True:
            try:
                async with self._client() as client:
                    wait, self._told = AGAIN, False
                    self._log.info("connected to %s", self._shown)
                    await self._talk(client)
            except (aiomqtt.MqttError, ActionFailed, OSError, ValueError) as error:
                if not self._told:
                    # Once, not each time that it is tried in vain.
                    self._told = True
                    said = " ".join(str(error).split()) or type(error).__name__
                    self._log.warning("%s can not be used, it is tried on: %s", self._shown, said)
            except Exception:
                self._log.exception("%s is tried again after a fault", self._shown)
            await pause(self._clock, wait)
            wait = min(wait * 2, LONGEST)

    def _client(self) -> aiomqtt.Client:
        told = self._secrets.mqtt()
        return aiomqtt.Client(
            self._host,
            self._port,
            username=told.user,
            password=told.password,
            identifier=self._name,
            tls_context=ssl.create_default_context(cafile=told.ca) if self._tls else None,
            keepalive=30,
            timeout=10.0,
            logger=self._log.getChild("mqtt"),
        )

    async def _talk(self, client: aiomqtt.Client) -> None:
        """Until the connection is lost, which raises."""
        for topic in self._incoming:
            await client.subscribe(topic, qos=QOS)
        both = [asyncio.ensure_future(one) for one in (self._listen(client), self._tell(client))]
        try:
            done, _ = await asyncio.wait(both, return_when=asyncio.FIRST_COMPLETED)
            for one in done:
                one.result()
        finally:
            for one in both:
                one.cancel()
            await asyncio.gather(*both, return_exceptions=True)

    async def _listen(self, client: aiomqtt.Client) -> None:
        async for message in client.messages:
            self._hear(message)

    async def _tell(self, client: aiomqtt.Client) -> None:
        while True:
            while self._outgoing:
                topic, payload = self._outgoing[0]
                await client.publish(topic, payload, qos=QOS)
                # Only now: one that was lost on the way goes again.
                if self._outgoing and self._outgoing[0] == (topic, payload):
                    self._outgoing.popleft()
            self._none.set()
            self._more.clear()
            await self._more.wait()

    # -- what comes in -------------------------------------------------------

    def _hear(self, message: aiomqtt.Message) -> None:
        topic = message.topic
        for wanted, target in self._incoming.items():
            if not topic.matches(wanted):
                continue
            kind, _, name = target.partition(":")
            if kind == "event":
                # What a broker keeps happened long ago.
                if not message.retain:
                    self._submit(Raise(name))
                continue
            try:
                value = _value(message.payload)
            except ValueError as error:
                self._log.warning("what came from %s at %s is %s", self._shown, topic, error)
                continue
            self._submit(Set({name: value}, WRITER))


def _address(url: str) -> tuple[bool, str, int]:
    try:
        parts = urlsplit(url)
        host, port = parts.hostname, parts.port
    except ValueError:
        host, port = None, None
    if not host or parts.scheme not in _PORTS or parts.path.strip("/") or parts.query:
        raise UsageError(f"situ.toml: [mqtt] url {url!r} is none: give mqtt://HOST or mqtts://HOST")
    if parts.username is not None:
        raise UsageError(
            "situ.toml: [mqtt] url has a user or a password: put them into secrets.toml in the "
            "robot's state folder, as [mqtt] user and password"
        )
    return parts.scheme == "mqtts", host, port or _PORTS[parts.scheme]


def _payload(value: Any) -> bytes:
    if value is None:
        return b""
    return value.encode() if isinstance(value, str) else msgspec.json.encode(value)


def _value(payload: Any) -> Any:
    """JSON, else the text, nothing as null. Raises ValueError: what it is instead."""
    data = payload if isinstance(payload, bytes) else str(payload or "").encode()
    if not data:
        return None
    if len(data) > LIMIT:
        raise ValueError(f"larger than {LIMIT >> 20} MB")
    try:
        value = msgspec.json.decode(data)
        if too_deep([value]):
            raise RecursionError
    except RecursionError:
        raise ValueError("nested too deep") from None
    except (msgspec.DecodeError, UnicodeDecodeError):
        pass
    else:
        return value
    try:
        return data.decode()
    except UnicodeDecodeError:
        raise ValueError("neither JSON nor text") from None
