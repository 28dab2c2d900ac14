"""What a robot that runs has done, looked for in its trace as it comes."""

from __future__ import annotations

import time
from typing import Any

DEADLINE = 20.0


def find(events: Any, **fields: Any) -> dict[str, Any]:
    """The next event with these fields."""
    end = time.monotonic() + DEADLINE
    while (left := end - time.monotonic()) > 0:
        event = events.next(left)
        if event is not None and fields.items() <= event.items():
            return dict(event)
    raise AssertionError(f"no event {fields}")
