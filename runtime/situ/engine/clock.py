"""Time as the engine sees it: seconds from anywhere, and calls at a moment.

Every asyncio event loop is a ``Clock``. Tests bring one that they move by hand.
"""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime
from typing import Protocol

from situ.decide.clock import tags_at


class Handle(Protocol):
    """A call that has been asked for and may be taken back."""

    def cancel(self) -> None: ...


class Clock(Protocol):
    """``time()`` in seconds, never going back; ``call_at`` calls once, at or after ``when``."""

    def time(self) -> float: ...

    def call_at(self, when: float, callback: Callable[[], None], /) -> Handle: ...


async def pause(clock: Clock, seconds: float) -> None:
    """Returns when ``seconds`` have passed on ``clock``; takes its call back when cancelled."""
    if seconds <= 0:
        return
    # Here, so that who only asks for the time of day does without.
    import asyncio

    over = asyncio.get_running_loop().create_future()

    def ring() -> None:
        if not over.done():
            over.set_result(None)

    handle = clock.call_at(clock.time() + seconds, ring)
    try:
        await over
    finally:
        handle.cancel()


def time_of_day(moment: float) -> dict[str, str]:
    """The tags ``clock.*`` at a UNIX time, in the robot's time zone."""
    return tags_at(datetime.fromtimestamp(moment))
