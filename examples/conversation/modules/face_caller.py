"""face-caller: turns the face to whoever calls, and keeps it there while they do."""

from __future__ import annotations

import sys

import situ
from situ.errors import SituError


def face_caller(board: situ.Board) -> None:
    for calling in board.watch("person.calling"):
        if calling.value:
            with board.authority("head") as head:
                if head.wait(1.0):
                    head.command({"yaw": board.get("person.direction") or 0, "pitch": 0})
                    head.wait_lost(10.0)


def main(endpoint: str = "tcp://127.0.0.1:5570") -> None:
    with situ.connect(endpoint, module="face-caller", resources=["head"]) as board:
        face_caller(board)


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except SituError as error:
        sys.exit(f"face-caller: {error}")
    except KeyboardInterrupt:
        pass
