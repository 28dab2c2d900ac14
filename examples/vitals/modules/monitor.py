"""monitor: the camera, for the nurse's page. It is simulated; a real one has the same method.

An application asks ``board:monitor/watch`` with the ``room``. Then the records are shown a picture
every second, and say whether a nurse looks: that stands at ``watched``. The answer is whether she
has ended it; it comes after 26 s at the latest, to be asked again, for no service waits for ever.
Pictures go to nobody else and are kept by nobody.
"""

from __future__ import annotations

import argparse
import json
import random
import sys
import urllib.request
from collections.abc import Callable
from http.client import HTTPException
from pathlib import Path
from typing import Any
from urllib.parse import quote

import situ
from situ.errors import SituError

STEP, PATIENCE, ANSWER = 1.0, 20.0, 5.0
"""Seconds between two pictures, until it asks to be asked again, and for the records to answer."""

LOST = 3
"""So many pictures in a row that nobody takes, and the connection is lost."""

Show = Callable[[str, bytes], dict[str, Any]]
"""Takes a room and a picture; gives ``watched`` and ``ended``. Raises OSError."""


class SimulatedCamera:
    """Sees somebody on the floor, who breathes; the same seed gives the same room."""

    def __init__(self, seed: int = 0) -> None:
        chance = random.Random(seed)
        self._lies = chance.randint(150, 300)
        self._blanket = chance.choice(("#8a5a44", "#44688a", "#5a7a4a"))

    def picture(self, at: float) -> bytes:
        """An image/svg+xml, so many seconds after it was switched on."""
        breath = (0, 3, 5, 3)[int(at) % 4]
        x = self._lies
        return (
            '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 640 480">'
            '<path fill="#d9d2c5" d="M0 0h640v300H0z"/><path fill="#a98f6f" d="M0 300h640v180H0z"/>'
            '<path fill="#c7e0f0" stroke="#fff" stroke-width="8" d="M420 50h150v130H420z"/>'
            '<path fill="#7b5a3c" d="M60 180h26v150H60zM60 240h130v24H60zM176 250h18v80h-18z"/>'
            f'<ellipse cx="{x + 170}" cy="{395 - breath}" rx="150" ry="{34 + breath}" '
            f'fill="{self._blanket}"/><circle cx="{x}" cy="385" r="32" fill="#e3b795"/>'
            f'<path fill="#d6d6d6" d="M{x - 32} 385a32 32 0 0 1 64 -6q-34 -18 -64 6z"/>'
            f'<text x="20" y="460" font-family="sans-serif" font-size="24" fill="#fff">{at:.0f} s'
            "</text></svg>"
        ).encode()


def monitor(board: situ.Board, device: SimulatedCamera, show: Show) -> None:
    with board.requests("watch") as requests:
        for request in requests:
            watch(board, device, show, request)


def watch(board: situ.Board, device: SimulatedCamera, show: Show, request: Any) -> None:
    begun, missed = board.clock(), 0
    room = str(request.params.get("room"))
    while (at := board.clock() - begun) < PATIENCE and not request.cancelled:
        try:
            said = show(room, device.picture(at))
        except OSError as error:
            missed += 1
            if missed == LOST:
                board.set("watched", False)
                request.fail(f"the records take no picture: {error}")
                return
        else:
            missed = 0
            if said.get("ended"):
                board.set("watched", False)
                request.answer({"ended": True})
                return
            board.set("watched", bool(said.get("watched")))
        board.sleep(STEP)
    if request.cancelled:
        board.set("watched", False)
    else:
        request.answer({"ended": False})


def records(url: str, token: str) -> Show:
    """Shows the pictures to the records at this address."""

    def show(room: str, picture: bytes) -> dict[str, Any]:
        asked = urllib.request.Request(
            f"{url}/watch/{quote(room, safe='')}",
            data=picture,
            method="PUT",
            headers={"Authorization": f"Bearer {token}", "Content-Type": "image/svg+xml"},
        )
        try:
            with urllib.request.urlopen(asked, timeout=ANSWER) as answer:
                said = json.loads(answer.read())
        except (ValueError, HTTPException) as error:
            raise OSError(f"{url} is not the records: {error}") from None
        if not isinstance(said, dict):
            raise OSError(f"{url} is not the records: its answer is no object")
        return said

    return show


def main() -> None:
    parser = argparse.ArgumentParser(description="The camera, for the nurse's page.")
    parser.add_argument("endpoint", nargs="?", default="tcp://127.0.0.1:5570")
    parser.add_argument("--records", default="http://127.0.0.1:8081", metavar="URL")
    parser.add_argument("--tokens", type=Path, required=True, help="their tokens.json")
    parser.add_argument("--seed", type=int, default=0, help="of the room")
    args = parser.parse_args()
    token = json.loads(args.tokens.read_text("utf-8"))["service"]
    with situ.connect(args.endpoint, module="monitor") as board:
        monitor(board, SimulatedCamera(args.seed), records(args.records, token))


if __name__ == "__main__":
    try:
        main()
    except (SituError, OSError) as error:
        sys.exit(f"monitor: {error}")
    except KeyboardInterrupt:
        pass
