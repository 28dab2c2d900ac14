"""gaze-sound: a glance to where a slap came from, as long as the situation gives it."""

from __future__ import annotations

import sys

import situ
from situ.errors import SituError


def gaze_sound(board: situ.Board) -> None:
    for slap in board.watch("sound.slap"):
        if slap.value is not None:
            with board.authority("head") as head:
                if head.wait(1.0):
                    head.command({"yaw": slap.value, "pitch": 0})
                    head.wait_lost(3.0)


def main(endpoint: str = "tcp://127.0.0.1:5570") -> None:
    with situ.connect(endpoint, module="gaze-sound", resources=["head"]) as board:
        gaze_sound(board)


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except SituError as error:
        sys.exit(f"gaze-sound: {error}")
    except KeyboardInterrupt:
        pass
