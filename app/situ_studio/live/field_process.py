"""Recordings from the field counted in a process of its own, a piece with each question.

Started as ``python -m situ_studio.live.field_process`` by ``FieldReading``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from situ_studio.live.field import Asked, Field, counted
from situ_studio.processes.answering import answer


class Counting:
    """Answers ``Asked`` and then None, again and again, with what ``counted`` gives."""

    def __init__(self) -> None:
        self._going: Iterator[float | Field] = iter(())

    def __call__(self, asked: Asked | None, _: Callable[[], bool]) -> float | Field | None:
        if asked is not None:
            self._going = counted(asked)
        return next(self._going, None)


def main() -> None:
    answer(Counting())


if __name__ == "__main__":
    main()
