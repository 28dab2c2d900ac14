"""The process that announces a robot: ``python -m situ.engine.announcer``.

Its input is one line, an ``Announcement`` as JSON; the robot is announced until that input ends or
a SIGTERM comes.
"""

from __future__ import annotations

import asyncio
import contextlib
import secrets
import signal
import socket
import sys
from collections.abc import Callable

import ifaddr
import msgspec
from zeroconf import InterfaceChoice, IPVersion, ServiceInfo
from zeroconf.asyncio import AsyncZeroconf

from situ.blackboard.announced import SERVICE, label, properties
from situ.engine.announcing import Announcement, not_announced

TTL = 60
"""Seconds for which others believe it: as long is a robot seen that lost its power."""
EVERY = "0.0.0.0"
HERE = "127.0.0.1"


async def announce(
    announcement: Announcement,
    addresses: Callable[[], tuple[str, ...]],
    changed: asyncio.Event,
) -> None:
    """Announces it until it is cancelled; then says goodbye. addresses: where the robot can be
    reached now; asked again when ``changed`` is set. Raises OSError where it can not be done."""
    everywhere = announcement.bound == EVERY
    zeroconf = AsyncZeroconf(
        interfaces=InterfaceChoice.All if everywhere else [announcement.bound],
        ip_version=IPVersion.V4Only,
    )
    try:
        told = addresses()
        service = _service(announcement, told)
        # Another robot may have that name: this one takes the next.
        await (await zeroconf.async_register_service(service, allow_name_change=True))
        while True:
            await changed.wait()
            changed.clear()
            now = addresses()
            if now == told:
                continue
            told = now
            if everywhere:
                await zeroconf.async_update_interfaces()
            service = _service(announcement, told, service.name)
            await (await zeroconf.async_update_service(service))
    finally:
        await zeroconf.async_unregister_all_services()
        await zeroconf.async_close()


def _service(announcement: Announcement, addresses: tuple[str, ...], name: str = "") -> ServiceInfo:
    robot = announcement.robot
    return ServiceInfo(
        SERVICE,
        name or f"{label(robot)}.{SERVICE}",
        port=robot.port,
        properties=dict(properties(robot)),
        # The machine's own name may be another's too, and what was heard of it be out of date.
        server=f"situ-{secrets.token_hex(8)}.local.",
        parsed_addresses=list(addresses),
        host_ttl=TTL,
        other_ttl=TTL,
    )


def addresses_of(bound: str) -> tuple[str, ...]:
    """Where who is bound there can be reached: of all addresses those that others can use; where
    there are none, this machine's own."""
    if bound != EVERY:
        return (bound,)
    every = [ip.ip for adapter in ifaddr.get_adapters() for ip in adapter.ips if ip.is_IPv4]
    return tuple(str(ip) for ip in every if not str(ip).startswith("127.")) or (HERE,)


def changes_of_network() -> socket.socket | None:
    """Is readable when an address of this machine comes or goes; None where the system can not
    tell (all but Linux)."""
    if sys.platform != "linux":
        return None
    kind = socket.SOCK_RAW | socket.SOCK_NONBLOCK
    told = socket.socket(socket.AF_NETLINK, kind, socket.NETLINK_ROUTE)
    told.bind((0, _IPV4_ADDRESSES))
    return told


_IPV4_ADDRESSES = 0x10
"""``RTMGRP_IPV4_IFADDR`` of netlink(7)."""


async def _run(announcement: Announcement) -> None:
    loop, changed = asyncio.get_running_loop(), asyncio.Event()
    task = asyncio.current_task()
    assert task is not None

    def end() -> None:
        # Once: the goodbye must not be broken off.
        loop.remove_signal_handler(signal.SIGTERM)
        loop.remove_reader(sys.stdin.fileno())
        task.cancel()

    loop.add_signal_handler(signal.SIGTERM, end)
    # Nothing more comes by it but its end.
    loop.add_reader(sys.stdin.fileno(), end)
    network = changes_of_network()

    def look() -> None:
        assert network is not None
        # Of very many at once some are lost; that something changed is enough.
        with contextlib.suppress(OSError):
            network.recv(65536)
        changed.set()

    if network is not None:
        loop.add_reader(network, look)
    try:
        await announce(announcement, lambda: addresses_of(announcement.bound), changed)
    finally:
        if network is not None:
            loop.remove_reader(network)
            network.close()


def main() -> int:
    announcement = msgspec.json.decode(sys.stdin.buffer.readline(), type=Announcement)
    try:
        asyncio.run(_run(announcement))
    except asyncio.CancelledError:
        return 0
    except OSError as error:
        print(not_announced(error), file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
