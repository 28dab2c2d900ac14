"""``situ`` on a clock that a test puts forward: at each SIGUSR1 a minute has passed at once.

Everything else is the real runtime's: it finds itself as one that had stood still that long.
"""

from __future__ import annotations

import asyncio
import signal
import sys

from situ.cli import main

MINUTE = 61.0


class PutForward(asyncio.SelectorEventLoop):
    """A loop whose clock leaps."""

    def __init__(self) -> None:
        self._ahead = 0.0
        super().__init__()
        self.add_signal_handler(signal.SIGUSR1, self._leap)

    def time(self) -> float:
        return super().time() + self._ahead

    def _leap(self) -> None:
        self._ahead += MINUTE


class Policy(asyncio.DefaultEventLoopPolicy):
    """Every loop is one."""

    def new_event_loop(self) -> PutForward:
        return PutForward()


if __name__ == "__main__":
    asyncio.set_event_loop_policy(Policy())
    sys.exit(main())
