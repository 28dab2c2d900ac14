"""What must be seen afterwards: who came in, who was refused, what people changed.

One line each on the logger ``situ.audit``: a word for what happened, then ``key=value``. No
values of tags. With keys only; without them nobody is known.
"""

from __future__ import annotations

import json
import logging
import time
from collections.abc import Callable

AGAIN = 60.0
"""Seconds in which the same refusal is told once; then ``times`` says how often it was."""
MOST = 1_000
"""Refusals that are told apart at once; a flood of others must not fill memory."""
LONGEST = 200

_log = logging.getLogger("situ.audit")


class Audit:
    """Writes the lines. clock: seconds, never going back."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._told: dict[tuple[str, ...], tuple[float, int]] = {}

    def tell(self, what: str, /, **fields: str) -> None:
        _log.info("%s", _line(what, fields))

    def refuse(self, what: str, /, **fields: str) -> None:
        """As ``tell``, a warning; whoever tries again and again does not fill the log."""
        now = self._clock()
        same = (what, *fields.values())
        since, times = self._told.get(same, (None, 0))
        if since is not None and now < since + AGAIN:
            self._told[same] = since, times + 1
            return
        if len(self._told) >= MOST:
            self._told = {k: v for k, v in self._told.items() if now < v[0] + AGAIN}
            if len(self._told) >= MOST:
                return
        self._told[same] = now, 0
        more = {"times": str(times)} if times else {}
        _log.warning("%s", _line(what, {**fields, **more}))


def _line(what: str, fields: dict[str, str]) -> str:
    return " ".join([what, *(f"{name}={_value(value)}" for name, value in fields.items())])


def _value(value: str) -> str:
    """One word, or a JSON text: nobody can end the line or forge a field."""
    if len(value) > LONGEST:
        value = value[:LONGEST] + "…"
    plain = value.isprintable() and not any(c in value for c in ' "=\\')
    return value if plain and value else json.dumps(value)
