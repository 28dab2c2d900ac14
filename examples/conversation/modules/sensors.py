"""The sensors, by hand: type what the robot shall perceive.

face 10       a face, ten degrees to the left
face off      nobody to be seen
say yes       somebody says this
slap 40       a slap from that direction
call -60      somebody calls from that direction
wave          a waving hand
stop          the red button is pressed in
go            it is let go
"""

from __future__ import annotations

import sys
from collections.abc import Iterable
from typing import Any

import situ
from situ.errors import SituError


def perceived(line: str, listen: Iterable[str]) -> dict[str, Any]:
    """What stands on the blackboard after ``line``; empty where it is not understood."""
    sense, _, rest = line.strip().partition(" ")
    if sense == "say" and rest:
        # A recogniser would judge by what makes sense now; here it is what is listened for.
        acceptable = rest.casefold() in {phrase.casefold() for phrase in listen}
        return {"heard": {"text": rest, "confidence": 0.9}, "speech.acceptable": acceptable}
    if sense == "wave" and not rest:
        return {"hand.waving": True}
    if sense in ("stop", "go") and not rest:
        return {"robot.stop": sense == "stop"}
    if sense == "face" and rest == "off":
        return {"face.visible": False, "face.direction": None}
    try:
        degrees = float(rest)
    except ValueError:
        return {}
    found: dict[str, dict[str, Any]] = {
        "face": {"face.visible": True, "face.direction": degrees},
        "slap": {"sound.slap": degrees},
        "call": {"person.calling": True, "person.direction": degrees},
    }
    return found.get(sense, {})


def main(endpoint: str = "tcp://127.0.0.1:5570") -> None:
    with situ.connect(endpoint) as board:
        print(__doc__)
        for line in sys.stdin:
            tags = perceived(line, board.get("listen") or [])
            if tags:
                board.set(tags)
            elif line.strip():
                print(f"not a sense: {line.strip()}; try face, say, slap, call, wave, stop or go")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except SituError as error:
        sys.exit(f"sensors: {error}")
    except KeyboardInterrupt:
        pass
