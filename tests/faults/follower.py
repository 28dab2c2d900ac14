"""A client that follows all tags: python follower.py ENDPOINT

It ends when the tag ``all`` says at which version each tag stands, and all are there; then it
prints what it was told: tag to [how many changes, the last one's version].
"""

from __future__ import annotations

import json
import sys

import situ

PATIENCE = 30.0


def follow(endpoint: str) -> dict[str, tuple[int, int]]:
    told: dict[str, tuple[int, int]] = {}
    wanted: dict[str, int] | None = None
    with (
        situ.connect(endpoint, role="viewer", timeout=PATIENCE) as board,
        board.watch("**") as changes,
    ):
        print("following", flush=True)
        for change in changes:
            count, version = told.get(change.tag, (0, 0))
            # Of a tag that it had never heard of it can have missed nothing.
            assert change.missed == (change.version - version - 1 if count else 0)
            told[change.tag] = count + 1, change.version
            if change.tag == "all":
                wanted = change.value
            if wanted is not None and all(told.get(t, (0, 0))[1] == v for t, v in wanted.items()):
                break
    return told


if __name__ == "__main__":
    print(json.dumps(follow(sys.argv[1])))
