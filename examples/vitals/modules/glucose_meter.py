"""glucose-meter: reads a strip. The device is simulated; a real one has the same two methods.

An application asks one after the other, so that each of its states waits for one thing:
``board:glucose-meter/strip`` answers when a strip is in, ``…/blood`` when there is blood on it,
``…/read`` with the glucose in mmol/L.
"""

from __future__ import annotations

import argparse
import random
import sys

import situ
from situ.errors import SituError

STEP, PATIENCE = 0.5, 28.0
"""Seconds between two looks at the device, and until it is given up."""


class SimulatedMeter:
    """A meter and people who use it; the same seed gives the same people.

    used: which strips are used ones, counted from 1. nobody: no strip comes.
    """

    def __init__(self, seed: int = 0, used: tuple[int, ...] = (), nobody: bool = False) -> None:
        self._chance = random.Random(seed)
        self._used = used
        self._nobody = nobody
        self._strips = 0

    def takes(self, what: str) -> float:
        """Seconds until there is a strip, blood, or a value."""
        if self._nobody:
            return float("inf")
        return {"strip": self._chance.uniform(3, 6), "blood": self._chance.uniform(4, 8)}.get(
            what, 5
        )

    def found(self, what: str) -> dict[str, float]:
        """After ``takes``. Raises ValueError where the strip is a used one."""
        if what == "strip":
            self._strips += 1
            if self._strips in self._used:
                raise ValueError("this strip was used before: a new one is needed")
        return {"glucose": round(self._chance.uniform(4.2, 11.0), 1)} if what == "read" else {}


def glucose_meter(board: situ.Board, device: SimulatedMeter) -> None:
    with board.requests("strip", "blood", "read") as requests:
        for request in requests:
            asked, takes = board.clock(), device.takes(request.request)
            while board.clock() - asked < min(takes, PATIENCE) and not request.cancelled:
                board.sleep(STEP)
            if request.cancelled:
                continue
            if takes > PATIENCE:
                request.fail(f"nobody gave it what it waits for: {request.request}")
                continue
            try:
                request.answer(device.found(request.request))
            except ValueError as error:
                request.fail(str(error))


def main() -> None:
    parser = argparse.ArgumentParser(description="The glucose meter.")
    parser.add_argument("endpoint", nargs="?", default="tcp://127.0.0.1:5570")
    parser.add_argument("--seed", type=int, default=0, help="of who is measured")
    parser.add_argument(
        "--used", type=int, nargs="*", default=[], help="which strips are used ones: 1, 2, …"
    )
    parser.add_argument("--nobody", action="store_true", help="no strip comes")
    args = parser.parse_args()
    with situ.connect(args.endpoint, module="glucose-meter") as board:
        glucose_meter(board, SimulatedMeter(args.seed, tuple(args.used), args.nobody))


if __name__ == "__main__":
    try:
        main()
    except SituError as error:
        sys.exit(f"glucose-meter: {error}")
    except KeyboardInterrupt:
        pass
