"""transfer: turns to whoever called and waved, goes there, and says how far it has come."""

from __future__ import annotations

import sys
from typing import Any

import situ
from situ.errors import SituError

TURN, SPEED, DISTANCE = 45.0, 0.4, 1.6  # degrees a second, metres a second, metres


def transfer(board: situ.Board) -> None:
    for calling in board.watch("person.calling"):
        if calling.value:
            # Asks at the call already, so that at the wave nobody is waited for.
            with board.authority("base", "head") as body:
                if body.wait(6.0):
                    board.set("transfer.phase", "turning")
                    angle = board.get("person.direction") or 0.0
                    body.command({"yaw": 0, "pitch": 0}, resource="head")
                    turn = TURN if angle > 0 else -TURN
                    facing = drive(board, body, {"turn": turn}, abs(angle) / TURN)
                    board.set("transfer.phase", "moving")
                    there = facing and drive(board, body, {"vx": SPEED}, DISTANCE / SPEED)
                    board.set("transfer.phase", "arrived" if there else "failed")


def drive(
    board: situ.Board, body: situ.Authority, velocity: dict[str, Any], seconds: float
) -> bool:
    """Moves for so long; False where the base was taken away meanwhile."""
    end = board.clock() + seconds
    while (left := end - board.clock()) > 0:
        # Never good for longer than this program is known to live.
        body.command(velocity, valid=min(left, 0.5), resource="base")
        if body.wait_lost(min(left, 0.2)):
            return False
    return True


def main(endpoint: str = "tcp://127.0.0.1:5570") -> None:
    with situ.connect(endpoint, module="transfer", resources=["base", "head"]) as board:
        transfer(board)


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except SituError as error:
        sys.exit(f"transfer: {error}")
    except KeyboardInterrupt:
        pass
