"""Starts the five modules of the example, each a process of its own, until Ctrl-C.

One that ends, because there is no robot or its name is taken, ends the others too.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
MODULES = ("chase_face", "nod", "gaze_sound", "face_caller", "transfer")


def main(*arguments: str) -> int:
    # Told to end while it still starts them, it starts them all first, and loses none.
    told: list[int] = []
    for number in (signal.SIGTERM, signal.SIGINT):
        signal.signal(number, lambda number, _: told.append(number))
    modules = [
        subprocess.Popen([sys.executable, str(HERE / f"{name}.py"), *arguments]) for name in MODULES
    ]
    try:
        for number in (signal.SIGTERM, signal.SIGINT):
            signal.signal(number, signal.default_int_handler)
        if told:
            return 0
        _, status = os.wait()
        return os.waitstatus_to_exitcode(status)
    except KeyboardInterrupt:
        return 0
    finally:
        for module in modules:
            module.terminate()
        for module in modules:
            module.wait()


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
