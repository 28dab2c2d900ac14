"""The robots that announce themselves in the network, and what is known of them here."""

from __future__ import annotations

import asyncio
import ipaddress
from collections.abc import Callable, Mapping, Sequence
from typing import Literal

import ifaddr
from zeroconf import (
    BadTypeInNameException,
    InterfaceChoice,
    IPVersion,
    ServiceStateChange,
    Zeroconf,
)
from zeroconf.asyncio import AsyncServiceBrowser, AsyncServiceInfo, AsyncZeroconf

from situ.blackboard.announced import SERVICE, Announced, fingerprint, heard
from situ.blackboard.keys import RobotKey
from situ.blackboard.protocol import VERSION

MOST = 500
"""Robots that are followed: anybody can announce any number."""
ANSWER = 3.0
"""Seconds that a robot has to say where it is."""

Standing = Literal["ready", "open", "no-key", "other-key", "other-version"]
"""What comes of connecting from here: it works, with keys or without any; there is no key here for
it; it is not the robot that is known here by that address or name; it speaks another protocol."""

Told = Callable[[str, Announced | None], None]
"""Is given a robot's name among the others, and the robot as it is now; None: it has gone."""


class Nearby:
    """Follows the robots that announce themselves, from ``open`` to ``close``, in one asyncio loop.

    told: is called with each that comes, changes or goes. interfaces: the addresses of those to
    look at; all unless given.
    """

    def __init__(self, told: Told, interfaces: Sequence[str] = ()) -> None:
        self._told = told
        self._interfaces = list(interfaces)
        self._there: set[str] = set()
        self._asking: dict[str, asyncio.Task[None]] = {}

    async def open(self) -> None:
        """Raises OSError where the network can not be listened to."""
        self._zeroconf = AsyncZeroconf(
            interfaces=self._interfaces or InterfaceChoice.All, ip_version=IPVersion.V4Only
        )
        self._browser = AsyncServiceBrowser(
            self._zeroconf.zeroconf, SERVICE, handlers=[self._on_change]
        )

    async def close(self) -> None:
        for task in self._asking.values():
            task.cancel()
        await self._browser.async_cancel()
        await self._zeroconf.async_close()

    async def __aenter__(self) -> Nearby:
        await self.open()
        return self

    async def __aexit__(self, *_: object) -> None:
        await self.close()

    def _on_change(
        self,
        zeroconf: Zeroconf,
        service_type: str,
        name: str,
        state_change: ServiceStateChange,
    ) -> None:
        if not name.isprintable():
            # It would steer a terminal; no robot calls itself so.
            return
        try:
            info = AsyncServiceInfo(SERVICE, name)
        except BadTypeInNameException:
            return
        before = self._asking.pop(name, None)
        if before is not None:
            before.cancel()
        if state_change is ServiceStateChange.Removed:
            self._tell(name, None)
        elif name in self._there or len(self._there | self._asking.keys()) < MOST:
            self._asking[name] = asyncio.create_task(self._ask(zeroconf, info))

    async def _ask(self, zeroconf: Zeroconf, info: AsyncServiceInfo) -> None:
        name = info.name
        try:
            if await info.async_request(zeroconf, ANSWER * 1000):
                found = tuple(info.parsed_addresses(IPVersion.V4Only))
                robot = heard(best_first(found, own_networks()), info.port, info.properties)
                self._tell(name, robot)
        finally:
            # Whoever has cancelled it asks anew by now, or tells that it has gone.
            if self._asking.get(name) is asyncio.current_task():
                del self._asking[name]

    def _tell(self, name: str, robot: Announced | None) -> None:
        """Each that was told goes once."""
        short = name.removesuffix(f".{SERVICE}")
        if robot is not None:
            self._there.add(name)
            self._told(short, robot)
        elif name in self._there:
            self._there.remove(name)
            self._told(short, None)


def own_networks() -> tuple[ipaddress.IPv4Network, ...]:
    """Those that this machine is in."""
    every = (ip for adapter in ifaddr.get_adapters() for ip in adapter.ips if ip.is_IPv4)
    return tuple(
        ipaddress.IPv4Network(f"{ip.ip}/{ip.network_prefix}", strict=False) for ip in every
    )


def best_first(
    addresses: Sequence[str], networks: Sequence[ipaddress.IPv4Network]
) -> tuple[str, ...]:
    """A robot's addresses: those in networks of ours before others, else as it has them."""

    def far(address: str) -> bool:
        return not any(ipaddress.IPv4Address(address) in network for network in networks)

    return tuple(sorted(addresses, key=far))


def standing(robot: Announced, known: Mapping[str, RobotKey]) -> Standing:
    """What comes of connecting to it. known: the robots whose keys lie here, by name."""
    if robot.protocol != VERSION:
        return "other-version"
    if any(fingerprint(one.public) == robot.key for one in known.values()):
        return "ready"
    here = {f"tcp://{address}:{robot.port}" for address in robot.addresses}
    if any(here.intersection(one.addresses) for one in known.values()):
        return "other-key"
    if robot.key:
        return "no-key"
    return "other-key" if robot.project in known else "open"
