"""Programs that end with who started them."""

from __future__ import annotations

import ctypes
import os
import signal
import sys
from collections.abc import Callable


def ending_with_us(number: signal.Signals) -> Callable[[], None] | None:
    """A ``preexec_fn``: the program gets this signal from the system when we die, however we do.

    None where the system can not (all but Linux).
    """
    if sys.platform != "linux":
        return None
    # Loaded here: between fork and exec nothing may be imported.
    prctl = ctypes.CDLL(None, use_errno=True).prctl
    starter = os.getpid()

    def ask() -> None:
        prctl(_SET_PARENT_DEATH_SIGNAL, number)
        if os.getppid() != starter:  # it died before we asked
            os._exit(1)

    return ask


_SET_PARENT_DEATH_SIGNAL = 1
