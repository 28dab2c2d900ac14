"""cuff: measures blood pressure. The device is simulated; a real one has the same three methods.

An application asks ``board:cuff/measure`` with ``arm``; the answer is systolic and diastolic in
mmHg and the pulse. Meanwhile ``cuff.pressure`` (mmHg) and ``cuff.progress`` (%) tell how far it
is. Where nobody waits for the answer any more, the air is let out at once.
"""

from __future__ import annotations

import argparse
import random
import sys
from typing import Any

import situ
from situ.errors import SituError

INFLATED, FILL, LEAK, LOWEST = 180.0, 30.0, 8.0, 50.0
"""mmHg at the top; up and down in mmHg a second; where the pulse has surely come back."""

STEP = 0.5
"""Seconds between two looks at the device."""


class SimulatedCuff:
    """A cuff on the arm of somebody invented; the same seed gives the same people.

    loose: which measurements find no pulse, counted from 1. Times are seconds since ``start``.
    """

    seconds = INFLATED / FILL + (INFLATED - LOWEST) / LEAK

    def __init__(self, seed: int = 0, loose: tuple[int, ...] = ()) -> None:
        self._chance = random.Random(seed)
        self._loose = loose
        self._count = 0
        self._found: dict[str, int] = {}

    def start(self) -> None:
        self._count += 1
        systolic = self._chance.randint(112, 168)
        self._found = {
            "systolic": systolic,
            "diastolic": round(systolic * 0.6) + self._chance.randint(-6, 6),
            "pulse": self._chance.randint(58, 92),
        }

    def pressure(self, at: float) -> float:
        """In the cuff, in mmHg."""
        top = INFLATED / FILL
        if at < top:
            return FILL * at
        return max(INFLATED - LEAK * (at - top), LOWEST) if at < self.seconds else 0.0

    def result(self) -> dict[str, int]:
        """After ``seconds``. Raises ValueError where no pulse was found."""
        if self._count in self._loose:
            raise ValueError("no pulse was found: the cuff sits loosely")
        return dict(self._found)


def cuff(board: situ.Board, device: SimulatedCuff) -> None:
    board.set({"cuff.pressure": 0, "cuff.progress": 0})
    with board.requests("measure") as requests:
        for request in requests:
            if request.params.get("arm") not in ("left", "right"):
                request.fail(f"there is no arm {request.params.get('arm')!r}: left or right")
            else:
                measure(board, device, request)


def measure(board: situ.Board, device: SimulatedCuff, request: Any) -> None:
    begun = board.clock()
    device.start()
    while (at := board.clock() - begun) < device.seconds and not request.cancelled:
        progress = round(100 * at / device.seconds)
        board.set({"cuff.pressure": round(device.pressure(at)), "cuff.progress": progress})
        board.sleep(STEP)
    board.set({"cuff.pressure": 0, "cuff.progress": 0})
    if request.cancelled:
        return
    try:
        request.answer(device.result())
    except ValueError as error:
        request.fail(str(error))


def main() -> None:
    parser = argparse.ArgumentParser(description="The blood pressure cuff.")
    parser.add_argument("endpoint", nargs="?", default="tcp://127.0.0.1:5570")
    parser.add_argument("--seed", type=int, default=0, help="of who is measured")
    parser.add_argument(
        "--loose", type=int, nargs="*", default=[], help="which measurements find no pulse: 1, 2, …"
    )
    args = parser.parse_args()
    with situ.connect(args.endpoint, module="cuff") as board:
        cuff(board, SimulatedCuff(args.seed, tuple(args.loose)))


if __name__ == "__main__":
    try:
        main()
    except SituError as error:
        sys.exit(f"cuff: {error}")
    except KeyboardInterrupt:
        pass
