"""nod: two nods when what was said can be accepted."""

from __future__ import annotations

import sys

import situ
from situ.errors import SituError


def nod(board: situ.Board) -> None:
    for said in board.watch("speech.acceptable"):
        if said.value:
            with board.authority("head") as head:
                if head.wait(1.0):
                    for pitch in (-12, 0, -12, 0):
                        head.command({"pitch": pitch}, valid=0.4)
                        head.wait_lost(0.25)


def main(endpoint: str = "tcp://127.0.0.1:5570") -> None:
    with situ.connect(endpoint, module="nod", resources=["head"]) as board:
        nod(board)


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except SituError as error:
        sys.exit(f"nod: {error}")
    except KeyboardInterrupt:
        pass
