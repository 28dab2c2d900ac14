"""oximeter: the finger clip. The device is simulated; a real one has the same method.

An application asks ``board:oximeter/measure``; the answer, oxygen in % and the pulse, comes as
soon as the last readings agree. ``oximeter.finger`` tells whether a finger is in the clip.
"""

from __future__ import annotations

import argparse
import random
import sys
from collections import deque
from typing import Any

import situ
from situ.errors import SituError

STEP, PATIENCE = 0.5, 20.0
"""Seconds between two readings, and until it is given up."""

STEADY = 6
"""So many readings in a row within one percent are believed."""


class SimulatedOximeter:
    """A clip into which a finger is put some seconds after it is asked for; the same seed gives
    the same fingers. nobody: no finger comes.
    """

    def __init__(self, seed: int = 0, nobody: bool = False) -> None:
        self._chance = random.Random(seed)
        self._nobody = nobody
        self.start()

    def start(self) -> None:
        self._put_in = self._chance.uniform(2.0, 4.0)
        self._oxygen = self._chance.randint(90, 99)
        self._pulse = self._chance.randint(58, 92)

    def reading(self, at: float) -> tuple[int, int] | None:
        """Oxygen and pulse so many seconds after ``start``; None: there is no finger."""
        if self._nobody or at < self._put_in:
            return None
        # At first the light is not adjusted, and too little is seen.
        early = max(0.0, 3.0 - (at - self._put_in))
        return round(self._oxygen - 4 * early), self._pulse + self._chance.randint(-1, 1)


def oximeter(board: situ.Board, device: SimulatedOximeter) -> None:
    with board.requests("measure") as requests:
        for request in requests:
            board.set("oximeter.finger", False)
            measure(board, device, request)


def measure(board: situ.Board, device: SimulatedOximeter, request: Any) -> None:
    begun = board.clock()
    device.start()
    last: deque[tuple[int, int]] = deque(maxlen=STEADY)
    while (at := board.clock() - begun) < PATIENCE and not request.cancelled:
        reading = device.reading(at)
        board.set("oximeter.finger", reading is not None)
        if reading is None:
            last.clear()
        else:
            last.append(reading)
        oxygen = [one for one, _ in last]
        if len(last) == STEADY and max(oxygen) - min(oxygen) <= 1:
            pulse = round(sum(one for _, one in last) / STEADY)
            request.answer({"oxygen": oxygen[-1], "pulse": pulse})
            return
        board.sleep(STEP)
    if not request.cancelled:
        request.fail("no finger was found in the clip" if not last else "the finger did not rest")


def main() -> None:
    parser = argparse.ArgumentParser(description="The finger clip.")
    parser.add_argument("endpoint", nargs="?", default="tcp://127.0.0.1:5570")
    parser.add_argument("--seed", type=int, default=0, help="of whose finger it is")
    parser.add_argument("--nobody", action="store_true", help="no finger comes")
    args = parser.parse_args()
    with situ.connect(args.endpoint, module="oximeter") as board:
        oximeter(board, SimulatedOximeter(args.seed, args.nobody))


if __name__ == "__main__":
    try:
        main()
    except SituError as error:
        sys.exit(f"oximeter: {error}")
    except KeyboardInterrupt:
        pass
