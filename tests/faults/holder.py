"""The module ``nod`` of ``ward``: python holder.py ENDPOINT. It says when it holds the head."""

from __future__ import annotations

import sys

import situ

if __name__ == "__main__":
    with (
        situ.connect(sys.argv[1], "nod", ["head"], timeout=30.0) as board,
        board.authority("head") as head,
    ):
        print(head.wait(30.0), flush=True)
        head.command({"yaw": 10})
        # Until it is killed.
        sys.stdin.read()
