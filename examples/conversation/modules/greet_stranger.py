"""greet-stranger: written later; says hello when a face comes after a while without any.

Nobody else's file changes for it. The README of this example shows the three places of
the script in which the task designer gives it a situation and a priority.
"""

from __future__ import annotations

import sys

import situ
from situ.errors import SituError

ALONE = 10.0  # seconds without a face, after which the next one counts as a stranger's


def greet_stranger(board: situ.Board) -> None:
    seen = board.clock() - ALONE
    for face in board.watch("face.visible"):
        if face.value and board.clock() - seen >= ALONE:
            board.set("stranger.near", True)
            with board.authority("head", "speech") as robot:
                if robot.wait(1.0):
                    robot.command({"pitch": 10}, resource="head")
                    robot.command({"text": "Hello! Have we met?"}, resource="speech")
                    robot.wait_lost(5.0)
        seen = board.clock()


def main(endpoint: str = "tcp://127.0.0.1:5570") -> None:
    with situ.connect(endpoint, module="greet-stranger", resources=["head", "speech"]) as board:
        greet_stranger(board)


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except SituError as error:
        sys.exit(f"greet-stranger: {error}")
    except KeyboardInterrupt:
        pass
