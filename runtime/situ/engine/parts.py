"""The processes of ``situ run``, started, waited for and ended: a ``Supervisor`` with real ones."""

from __future__ import annotations

import os
import select
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from situ.engine.ending import ending_with_us
from situ.engine.notify import READY, WATCHDOG, Listener, Notifier
from situ.engine.supervisor import HANGS, Child, Supervisor
from situ.engine.waking import Waking

Command = Callable[[str, bool, Mapping[str, str]], Sequence[str]]
"""The arguments of ``situ`` for a part, as ``Start`` is asked for it."""


def supervise(
    parts: Sequence[str], command: Command, ready: Callable[[Mapping[str, str]], None]
) -> int:
    """Runs the parts until one ends by itself, one is given up, or a signal comes; the exit
    status. In the main thread only; SIGINT, SIGTERM and SIGCHLD are its own meanwhile."""
    notifier = Notifier(os.environ)
    with tempfile.TemporaryDirectory(prefix="situ-") as folder:
        listeners = {name: Listener(Path(folder) / name) for name in parts}

        def start(part: str, fresh: bool, addresses: Mapping[str, str]) -> Child:
            environment = {
                **os.environ,
                "NOTIFY_SOCKET": str(listeners[part].path),
                "WATCHDOG_USEC": str(int(HANGS * 1_000_000)),
            }
            argv = [sys.executable, "-m", "situ", *command(part, fresh, addresses)]
            # A group of its own: what the terminal says goes to us, and from us to them.
            return subprocess.Popen(
                argv,
                env=environment,
                start_new_session=True,
                preexec_fn=ending_with_us(signal.SIGTERM),
            )

        def told(addresses: Mapping[str, str]) -> None:
            ready(addresses)
            notifier.tell(**{READY: "1"})

        supervisor = Supervisor(parts, start, told)
        try:
            _loop(supervisor, listeners, notifier)
        finally:
            for listener in listeners.values():
                listener.close()
    assert supervisor.status is not None
    return supervisor.status


def _loop(supervisor: Supervisor, listeners: Mapping[str, Listener], notifier: Notifier) -> None:
    with Waking(signal.SIGINT, signal.SIGTERM, signal.SIGCHLD) as waking:
        awaited = [waking.fileno(), *(listener.fileno() for listener in listeners.values())]
        supervisor.begin(time.monotonic())
        while True:
            left = supervisor.turn(time.monotonic())
            if supervisor.status is not None:
                return
            if notifier.beat is not None:
                notifier.tell(**{WATCHDOG: "1"})
                left = notifier.beat if left is None else min(left, notifier.beat)
            select.select(awaited, [], [], left)
            waking.take()
            for name, listener in listeners.items():
                while (message := listener.take()) is not None:
                    supervisor.heard(name, message, time.monotonic())
            if any(number != signal.SIGCHLD for number in waking.came):
                notifier.tell(STOPPING="1")
                supervisor.stop(time.monotonic())
            waking.came.clear()
