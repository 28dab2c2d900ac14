"""The core alone: a robot's decisions in a plain loop, for services that are elsewhere.

Without asyncio, HTTP and all that carries out effects: small, and quick to start again.
"""

from __future__ import annotations

import math
import select
import time
from collections.abc import Callable

from situ.blackboard.journal import DurableTags
from situ.blackboard.replies import Addresses
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
    awake = waking.fileno()
    poll = select.poll()
    for descriptor in (awake, *deciding.descriptors()):
        poll.register(descriptor, select.POLLIN)
    beat = None if notifier.beat is None else time.monotonic()
    while not waking.came:
        due = deciding.turn()
        if beat is not None and notifier.beat is not None:
            if time.monotonic() >= beat:
                notifier.tell(**{WATCHDOG: "1"})
                beat = time.monotonic() + notifier.beat
            due = beat if due is None else min(due, beat)
        # Rounded up: what is asked before it is due is asked again and again.
        left = None if due is None else max(0, math.ceil((due - time.monotonic()) * 1000))
        for descriptor, _ in poll.poll(left):
            if descriptor == awake:
                waking.take()
