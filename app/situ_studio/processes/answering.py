"""The other end of a ``Worker``: questions come in by stdin, answers go out by stdout."""

from __future__ import annotations

import pickle
import sys
import threading
from collections.abc import Callable
from queue import SimpleQueue
from typing import Any

from situ.document.analysis import Cancelled
from situ_studio.processes.sending import Receiving, frame, framed


def answer(work: Callable[[Any, Callable[[], bool]], Any]) -> None:
    """Answers each question with what ``work`` makes of it, until nobody writes any more.

    work: gets the question, and what says whether another one is on its way; it may raise
    Cancelled then, and that question stays without an answer.
    """
    came: SimpleQueue[bytes | None] = SimpleQueue()
    threading.Thread(target=_read, args=(came,), daemon=True).start()
    receiving = Receiving()
    while (message := came.get()) is not None:
        asked = receiving.unpack(message)
        if asked is None:
            continue
        number, value = asked
        try:
            found = work(value, lambda: not came.empty())
        except Cancelled:
            continue
        sys.stdout.buffer.write(framed(pickle.dumps((number, found), pickle.HIGHEST_PROTOCOL)))
        sys.stdout.buffer.flush()


def _read(came: SimpleQueue[bytes | None]) -> None:
    message: bytes | None = b""
    while message is not None:
        message = frame(sys.stdin.buffer)
        came.put(message)
