"""A loop in which a robot's leases do not end: for clients by hand, who send no heartbeats."""

from __future__ import annotations

import asyncio


class Unhurried(asyncio.SelectorEventLoop):
    """A second of its takes a minute. Only deadlines wait by it; what is there is done at once."""

    def time(self) -> float:
        return super().time() / 60
