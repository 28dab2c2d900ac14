"""The robots in the network, told as they come and go: one JSON object a line.

Started as ``python -m situ_studio.live.nearby_process [ADDRESS …]`` by ``NearbyRobots``; the
addresses are this machine's, of the networks to look in; all unless given. Ends with its input.
What strangers send is read here, apart from the window and what it knows.
"""

from __future__ import annotations

import asyncio
import sys
from typing import Any

import msgspec

from situ.blackboard.announced import Announced
from situ.blackboard.keys import client_folder, client_robots
from situ.blackboard.nearby import Nearby, standing
from situ.errors import UsageError


async def follow(interfaces: list[str]) -> None:
    """Raises OSError where the network can not be listened to."""
    ended = asyncio.Event()
    asyncio.get_running_loop().add_reader(sys.stdin.fileno(), ended.set)
    async with Nearby(_tell, interfaces):
        await ended.wait()


def _tell(name: str, robot: Announced | None) -> None:
    if robot is None:
        _say(name=name)
        return
    try:
        # Somebody may have put a key there meanwhile.
        stands: str = standing(robot, client_robots(client_folder()))
    except UsageError as error:
        _say(failed=str(error))
        return
    _say(name=name, standing=stands, endpoint=robot.endpoint, key=robot.key)


def _say(**told: Any) -> None:
    sys.stdout.buffer.write(msgspec.json.encode(told) + b"\n")
    sys.stdout.buffer.flush()


def main() -> None:
    try:
        asyncio.run(follow(sys.argv[1:]))
    except OSError as error:
        _say(failed=error.strerror or str(error))


if __name__ == "__main__":
    main()
