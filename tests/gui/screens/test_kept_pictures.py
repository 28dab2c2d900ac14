"""Pictures that are kept: so many bytes, not so many pictures."""

from __future__ import annotations

from typing import Any

from PySide6.QtGui import QPixmap

from situ_studio.screens.kept_pictures import KeptPictures


def test_what_was_not_asked_for_longest_goes_when_they_are_too_large(qt: Any) -> None:
    made: list[str] = []

    def picture(name: str, side: int) -> Any:
        def make() -> QPixmap:
            made.append(name)
            return QPixmap(side, side)

        return lambda: kept.get(name, make)

    kept = KeptPictures(100_000)
    small, other, large, huge = (
        picture(name, side) for name, side in (("a", 100), ("b", 100), ("c", 120), ("d", 1000))
    )
    small(), other(), small()
    assert made == ["a", "b"]
    # 40 kB each, and 58 kB: the one that was asked for last stays.
    large()
    small()
    assert made == ["a", "b", "c"]
    assert kept.bytes <= 100_000
    other()
    assert made == ["a", "b", "c", "b"]
    # One that is too large by itself is kept alone: it is what is being looked at.
    huge(), huge()
    assert made == ["a", "b", "c", "b", "d"]
    small()
    assert kept.bytes <= 100_000
    # Thousands that are no picture at all are let go of too.
    for at in range(2_000):
        kept.get(at, QPixmap)
    assert kept.bytes <= 100_000
