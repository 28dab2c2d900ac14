"""``situ robots``: who announces itself in the network."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from situ.cli_simulate import above_zero

if TYPE_CHECKING:
    from situ.blackboard.announced import Announced

WAIT = 3.0
"""Seconds in which those who are there have answered."""
WORDS = {
    "ready": "there is a key for it here",
    "open": "without keys: open to everybody",
    "no-key": "there is no key for it here",
    "other-key": "not the robot that is known here by this address or name: its key is another",
    "other-version": "speaks another version of the protocol",
}


def add(commands: Any) -> None:
    parser = commands.add_parser(
        "robots",
        help="list the robots that announce themselves in the network",
        description="Lists the robots that announce themselves in the network, with what comes of "
        "connecting to them. Whoever is in the network can announce anything: which robot it is "
        "shows with its key.",
    )
    parser.add_argument(
        "--wait",
        type=above_zero,
        default=WAIT,
        metavar="S",
        help=f"how long they have to answer; {WAIT:g} unless given",
    )
    parser.add_argument(
        "--interface",
        action="append",
        default=[],
        metavar="ADDRESS",
        help="one of this machine's addresses: look in its network only; may be given again",
    )
    parser.add_argument(
        "--keys", type=Path, metavar="DIR", help="your keys; ~/.config/situ/keys unless given"
    )
    parser.add_argument("--json", action="store_true", help="for a program to read")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    import asyncio

    import msgspec

    from situ.blackboard.keys import client_folder, client_robots
    from situ.blackboard.nearby import standing
    from situ.errors import UsageError

    known = client_robots(args.keys or client_folder())
    try:
        found = asyncio.run(_look(args.wait, args.interface))
    except OSError as error:
        why = error.strerror or error
        raise UsageError(f"the network can not be listened to: {why}") from None
    for name, robot in sorted(found.items()):
        stands = standing(robot, known)
        if args.json:
            told = {"name": name, "endpoint": robot.endpoint, "standing": stands}
            print(msgspec.json.encode({**told, **msgspec.to_builtins(robot)}).decode())
        else:
            print(f"{name}  {robot.endpoint}  {WORDS[stands]}")
    if not found and not args.json:
        print("no robot announces itself here; one that is not bound to a network never does")
    return 0


async def _look(wait: float, interfaces: list[str]) -> dict[str, Announced]:
    import asyncio

    from situ.blackboard.nearby import Nearby

    found: dict[str, Announced] = {}

    def told(name: str, robot: Announced | None) -> None:
        if robot is None:
            found.pop(name, None)
        else:
            found[name] = robot

    async with Nearby(told, interfaces):
        await asyncio.sleep(wait)
    return found
