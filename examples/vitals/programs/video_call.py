"""The video program of the robot, without a window: it calls an address and ends with the call.

Exit status 0: somebody was there and hung up; 1: busy, or nobody took it. Nobody is called: who is
there is drawn by lot. A real one, at this place in ``launch.toml``, shows the call above the
robot's screen and ends in the same two ways.
"""

from __future__ import annotations

import argparse
import random
import sys
import time
from enum import Enum


class Answer(Enum):
    TAKEN = "taken"
    BUSY = "busy"
    NOBODY = "nobody"


def called(chance: random.Random) -> tuple[Answer, float]:
    """How it goes, and after how many seconds it is over."""
    (answer,) = chance.choices(list(Answer), weights=(6, 1, 3))
    least, most = {Answer.TAKEN: (12, 40), Answer.BUSY: (2, 4), Answer.NOBODY: (20, 25)}[answer]
    return answer, chance.uniform(least, most)


def main() -> int:
    parser = argparse.ArgumentParser(description="Calls an address.")
    parser.add_argument("address")
    parser.add_argument("--seed", type=int, help="of who is there; else another each time")
    args = parser.parse_args()
    answer, seconds = called(random.Random(args.seed))
    # The whole program stands in for the time that people talk: nothing else is to be done in it,
    # and a robot that hangs up ends the process.
    time.sleep(seconds)
    return 0 if answer is Answer.TAKEN else 1


if __name__ == "__main__":
    sys.exit(main())
