"""Finding problems in a process of its own: projects come in, the problems of the last go out.

Started as ``python -m situ_studio.check_process`` by ``Checker``; the messages are those of
``situ_studio.sending``. It ends when nobody writes to it any more.
"""

from __future__ import annotations

import pickle
import sys
import threading
import traceback
from queue import SimpleQueue

from situ.document.analysis import Cancelled
from situ.document.check import check
from situ.document.problem import Problem
from situ.document.project import Project
from situ_studio.sending import Receiving, frame, framed


def main() -> None:
    came: SimpleQueue[bytes | None] = SimpleQueue()
    threading.Thread(target=_read, args=(came,), daemon=True).start()
    receiving = Receiving()
    while (message := came.get()) is not None:
        asked = receiving.unpack(message)
        if asked is None:
            continue
        number, project = asked
        try:
            found = _problems(project, came)
        except Cancelled:
            continue
        sys.stdout.buffer.write(framed(pickle.dumps((number, found), pickle.HIGHEST_PROTOCOL)))
        sys.stdout.buffer.flush()


def _read(came: SimpleQueue[bytes | None]) -> None:
    message: bytes | None = b""
    while message is not None:
        message = frame(sys.stdin.buffer)
        came.put(message)


def _problems(project: Project, came: SimpleQueue[bytes | None]) -> list[Problem]:
    """Raises Cancelled where another project is on its way."""
    try:
        return check(project, cancel=lambda: not came.empty())
    except Cancelled:
        raise
    except Exception:
        # A defect of one check ends no other: the editor hears of it through its log.
        traceback.print_exc()
        return []


if __name__ == "__main__":
    main()
