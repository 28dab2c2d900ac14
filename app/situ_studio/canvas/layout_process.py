"""The layout of one drawing in a process of its own: its shape comes in, its places go out (JSON).

Started as ``python -m situ_studio.canvas.layout_process`` by ``Arranging``.
"""

from __future__ import annotations

import sys

import msgspec

from situ_studio.canvas.layout import Shape, place


def main() -> None:
    shape = msgspec.json.decode(sys.stdin.buffer.read(), type=Shape)
    sys.stdout.buffer.write(msgspec.json.encode(place(shape)))


if __name__ == "__main__":
    main()
