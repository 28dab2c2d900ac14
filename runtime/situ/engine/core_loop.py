"""The core alone: a robot's decisions in a plain loop, for services that are elsewhere.

Without asyncio, HTTP and all that carries out effects: small, and quick to start again.
"""

from __future__ import annotations

import time
from collections.abc import Callable

import zmq

from situ.blackboard.journal import DurableTags
from situ.blackboard.protocol import Addresses
from situ.engine.deciding import Deciding
from situ.engine.notify import WATCHDOG, Notifier
from situ.engine.waking import Waking


def run(
    deciding: Deciding,
    waking: Waking,
    notifier: Notifier,
    durable: DurableTags | None,
    up: Callable[[Addresses], None],
    forget: Callable[[], bool],
) -> None:
    """Runs until ``waking`` was told a signal. ``deciding`` must call soon by ``waking``.

    up: is told the addresses when clients are served. forget: asked at the end, as ``end`` of
    ``Deciding`` wants it. Raises UsageError where an address can not be bound.
    """
    addresses = deciding.bind()
    try:
        deciding.start(addresses)
        up(addresses)
        _serve(deciding, waking, notifier)
        deciding.end(forget=forget())
        if durable is not None:
            durable.close()
        waking.take()
    finally:
        deciding.close()


def _serve(deciding: Deciding, waking: Waking, notifier: Notifier) -> None:
    poller = zmq.Poller()
    for descriptor in (waking.fileno(), *deciding.descriptors()):
        poller.register(descriptor, zmq.POLLIN)
    beat = time.monotonic() if notifier.beat is not None else None
    while not waking.came:
        due = deciding.turn()
        now = time.monotonic()
        if beat is not None and notifier.beat is not None:
            if now >= beat:
                notifier.tell(**{WATCHDOG: "1"})
                beat = now + notifier.beat
            due = beat if due is None else min(due, beat)
        # Never before it is due: what is asked too early is asked again and again.
        left = None if due is None else max(0, int((due - now) * 1000) + 1)
        if due is not None and due <= now:
            left = 0
        if poller.poll(left):
            waking.take()
