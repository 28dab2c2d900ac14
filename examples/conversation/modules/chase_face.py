"""chase-face: follows the face of the speaker, wherever nobody with more right has the head."""

from __future__ import annotations

import sys

import situ
from situ.errors import SituError


def chase_face(board: situ.Board) -> None:
    with board.watch("face.*") as face, board.authority("head") as head:
        while True:
            # Said again and again, each good for half a second: taken over without delay,
            # and if this program hangs the head stops.
            face.next(0.2)
            direction = board.get("face.direction")
            if board.get("face.visible") and direction is not None:
                head.command({"yaw": direction, "pitch": 0}, valid=0.5)


def main(endpoint: str = "tcp://127.0.0.1:5570") -> None:
    with situ.connect(endpoint, module="chase-face", resources=["head"]) as board:
        chase_face(board)


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except SituError as error:
        sys.exit(f"chase-face: {error}")
    except KeyboardInterrupt:
        pass
