"""The ward of examples/vitals in memory: its clock, and its records over HTTP."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from datetime import UTC, datetime, timedelta

import aiohttp
from aiohttp.test_utils import TestServer

from ward_records.access import Tokens
from ward_records.day import Day
from ward_records.store import Store
from ward_records.watching import Watching
from ward_records.web import application

NOW = datetime(2026, 5, 4, 8, 0, tzinfo=UTC)
TOKENS = Tokens("the-robot", "a-nurse", "a-visitor")
ROBOT = {"Authorization": "Bearer the-robot"}

Asking = Callable[[aiohttp.ClientSession], Awaitable[None]]


class Clock:
    """Stands at ``NOW`` until it is moved."""

    def __init__(self) -> None:
        self.now = NOW

    def __call__(self) -> datetime:
        return self.now

    def at(self, time: str) -> None:
        self.now = self.now.replace(hour=int(time[:2]), minute=int(time[3:]))

    def on(self, **passed: float) -> None:
        self.now += timedelta(**passed)


def over_http(
    store: Store,
    asking: Asking,
    token: str | None = None,
    *,
    speaks: str = "en",
    clock: Clock | None = None,
) -> None:
    """Has a browser ask the records; it has opened the page with the token, where there is one."""
    now = clock or Clock()
    ward = application(store, Day(store.db, now, UTC), Watching(now), TOKENS)

    async def run() -> None:
        async with (
            TestServer(ward) as server,
            aiohttp.ClientSession(
                server.make_url("/"),
                cookie_jar=aiohttp.CookieJar(unsafe=True),
                headers={"Accept-Language": speaks},
            ) as session,
        ):
            if token is not None:
                await session.get("/", params={"token": token})
            await asking(session)

    asyncio.run(run())
