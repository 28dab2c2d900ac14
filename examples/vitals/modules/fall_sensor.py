"""The fall sensor that somebody wears, over MQTT. The device is simulated, what finds falls is not.

It publishes ``ward/ROOM/fall`` = ``{"room": ROOM}``, retained: whoever was away hears it too. When
``ward/ROOM/fall/seen`` comes, the robot knows, and it is taken back. It is no module of the
blackboard: ``[mqtt]`` in ``situ.toml`` says what its messages mean.
"""

from __future__ import annotations

import argparse
import asyncio
import json
import random
import sys
from collections.abc import AsyncIterator, Iterable

import aiomqtt

RATE = 25
"""Samples a second."""

WEIGHTLESS, FALLING = 0.5, 0.2
"""In g, and seconds: so light for so long is a fall and no step."""

HIT, SOON = 2.5, 1.0
"""In g, and seconds: so hard, so soon after it, is the floor."""

STILL, RESTING = 0.25, 2.0
"""In g about 1 g, and seconds: so still for so long is somebody who does not get up."""


class SimulatedWearer:
    """Somebody who walks about and falls at ``falls`` (seconds); the same seed gives the same
    steps. stumbles: there she only sits down hard.
    """

    def __init__(
        self, seed: int = 0, falls: Iterable[float] = (), stumbles: Iterable[float] = ()
    ) -> None:
        self._chance = random.Random(seed)
        self._falls = sorted(falls)
        self._stumbles = sorted(stumbles)

    def acceleration(self, at: float) -> float:
        """In g, at a time in seconds; to be asked in the order of time."""
        noise = self._chance.gauss(0, 0.03)
        for fell in self._falls:
            if fell <= at < fell + 0.4:
                return 0.2 + noise
            if fell + 0.4 <= at < fell + 0.5:
                return 3.4 + noise
            if fell + 0.5 <= at < fell + 20:
                return 1.0 + noise
        for sat in self._stumbles:
            if sat <= at < sat + 0.1:
                return 2.8 + noise
        return 1.0 + 0.35 * (1 if int(at * 4) % 2 else -1) + noise


class FallDetector:
    """Weightless, then hit, then still: that is a fall. Times are seconds and never decrease."""

    def __init__(self) -> None:
        self._light_since: float | None = None
        self._fell: float | None = None
        self._still_since: float | None = None

    def feed(self, at: float, acceleration: float) -> bool:
        """Whether with this sample a fall is certain; each is told once."""
        if acceleration < WEIGHTLESS:
            self._light_since = at if self._light_since is None else self._light_since
            if at - self._light_since >= FALLING:
                self._fell, self._still_since = at, None
            return False
        self._light_since = None
        if self._fell is None:
            return False
        if acceleration > HIT and at - self._fell <= SOON:
            self._still_since = at
        elif self._still_since is None:
            if at - self._fell > SOON:
                self._fell = None
        elif abs(acceleration - 1.0) > STILL:
            self._fell = self._still_since = None
        elif at - self._still_since >= RESTING:
            self._fell = self._still_since = None
            return True
        return False


async def fall_sensor(
    client: aiomqtt.Client, room: int, samples: AsyncIterator[tuple[float, float]]
) -> None:
    """Tells of falls until the samples end; then still waits until each has been seen."""
    topic = f"ward/{room}/fall"
    await client.subscribe(f"{topic}/seen", qos=1)
    open_ = asyncio.Event()

    async def hear() -> None:
        async for _ in client.messages:
            await client.publish(topic, b"", qos=1, retain=True)
            open_.clear()
            if ended:
                return

    ended = False
    hearing = asyncio.ensure_future(hear())
    try:
        detector = FallDetector()
        async for at, acceleration in samples:
            if detector.feed(at, acceleration):
                open_.set()
                await client.publish(topic, json.dumps({"room": room}), qos=1, retain=True)
        ended = True
        if open_.is_set():
            await hearing
    finally:
        hearing.cancel()
        await asyncio.gather(hearing, return_exceptions=True)


async def live(wearer: SimulatedWearer) -> AsyncIterator[tuple[float, float]]:
    """Its samples as time passes."""
    clock = asyncio.get_running_loop().time
    begun = clock()
    count = 0
    while True:
        at = count / RATE
        await asyncio.sleep(max(0.0, begun + at - clock()))
        yield at, wearer.acceleration(at)
        count += 1


async def wear(args: argparse.Namespace) -> None:
    wearer = SimulatedWearer(args.seed, args.fall)
    async with aiomqtt.Client(args.host, args.port) as client:
        await fall_sensor(client, args.room, live(wearer))


def main() -> None:
    parser = argparse.ArgumentParser(description="A fall sensor that somebody wears.")
    parser.add_argument("--host", default="127.0.0.1", help="the broker's")
    parser.add_argument("--port", type=int, default=1883)
    parser.add_argument("--room", type=int, default=12)
    parser.add_argument("--seed", type=int, default=0, help="of her steps")
    parser.add_argument(
        "--fall", type=float, nargs="*", default=[], help="when she falls, in seconds"
    )
    asyncio.run(wear(parser.parse_args()))


if __name__ == "__main__":
    try:
        main()
    except aiomqtt.MqttError as error:
        sys.exit(f"fall-sensor: {error}")
    except KeyboardInterrupt:
        pass
