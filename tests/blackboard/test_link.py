"""A link to a core, over real sockets, by a clock that the test has in its hand."""

from __future__ import annotations

import select
import time
from collections.abc import Callable
from typing import Any

from situ.blackboard.client import Link, Person
from situ.blackboard.protocol import LEASE

DEADLINE = 20.0


def test_what_is_asked_after_standing_still_is_done_once_the_session_is_taken_up_again(
    running: Any,
) -> None:
    stood = [0.0]

    def clock() -> float:
        return time.monotonic() + stood[0]

    link = Link(running.endpoint, Person(role="operator", user="qt"), clock=clock)
    poll = select.poll()
    for descriptor in link.descriptors():
        poll.register(descriptor, select.POLLIN)

    def drive(ready: Callable[[], bool]) -> None:
        end = time.monotonic() + DEADLINE
        while not ready():
            assert time.monotonic() < end
            link.turn()
            poll.poll(max(0, link.due() - link.clock()) * 1000)

    drive(lambda: link.dialog.connected)
    stood[0] = 2 * LEASE
    # What may not be done twice is given up where it was sent, and the session lost after that.
    call = link.dialog.publish("knock")
    drive(lambda: call.finished)
    call.result()
    link.dialog.bye()
    link.turn()
    link.close()
