"""glucose-meter: reads a strip. The device is simulated; a real one has the same method.

An application asks ``board:glucose-meter/measure``; the answer is the glucose in mmol/L.
``glucose.phase`` tells meanwhile what is waited for: strip, blood, reading.
"""

from __future__ import annotations

import argparse
import random
import sys
from typing import Any

import situ
from situ.errors import SituError

STEP, PATIENCE = 0.5, 28.0
"""Seconds between two looks at the device, and until it is given up."""


class SimulatedMeter:
    """A meter into which a strip is put, then blood on it; the same seed gives the same people.

    used: which strips are used ones, counted from 1.
    """

    def __init__(self, seed: int = 0, used: tuple[int, ...] = ()) -> None:
        self._chance = random.Random(seed)
        self._used = used
        self._count = 0
        self.start()
        self._count = 0

    def start(self) -> None:
        self._count += 1
        self._strip = self._chance.uniform(3.0, 6.0)
        self._blood = self._strip + self._chance.uniform(4.0, 8.0)
        self._glucose = round(self._chance.uniform(4.2, 11.0), 1)

    def phase(self, at: float) -> str:
        """So many seconds after ``start``: strip, blood, reading, done, or used."""
        if at < self._strip:
            return "strip"
        if self._count in self._used:
            return "used"
        if at < self._blood:
            return "blood"
        return "reading" if at < self._blood + 5.0 else "done"

    def result(self) -> dict[str, float]:
        return {"glucose": self._glucose}


def glucose_meter(board: situ.Board, device: SimulatedMeter) -> None:
    with board.requests("measure") as requests:
        for request in requests:
            measure(board, device, request)
            board.set("glucose.phase", None)


def measure(board: situ.Board, device: SimulatedMeter, request: Any) -> None:
    begun = board.clock()
    device.start()
    while (at := board.clock() - begun) < PATIENCE and not request.cancelled:
        phase = device.phase(at)
        if phase == "done":
            request.answer(device.result())
            return
        if phase == "used":
            request.fail("this strip was used before: a new one is needed")
            return
        if board.get("glucose.phase") != phase:
            board.set("glucose.phase", phase)
        board.sleep(STEP)
    if not request.cancelled:
        request.fail("nobody put a strip and blood into the meter")


def main() -> None:
    parser = argparse.ArgumentParser(description="The glucose meter.")
    parser.add_argument("endpoint", nargs="?", default="tcp://127.0.0.1:5570")
    parser.add_argument("--seed", type=int, default=0, help="of who is measured")
    parser.add_argument(
        "--used", type=int, nargs="*", default=[], help="which strips are used ones: 1, 2, …"
    )
    args = parser.parse_args()
    with situ.connect(args.endpoint, module="glucose-meter") as board:
        glucose_meter(board, SimulatedMeter(args.seed, tuple(args.used)))


if __name__ == "__main__":
    try:
        main()
    except SituError as error:
        sys.exit(f"glucose-meter: {error}")
    except KeyboardInterrupt:
        pass
