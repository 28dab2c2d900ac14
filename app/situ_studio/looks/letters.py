"""How large the letters of the windows are: as the system's, or as a person chose.

All that has words in it grows with them: rows, fields, buttons, icons. Drawings do not, for they
have a zoom, and their places are kept in the project; nor does the robot's screen, which is as the
robot shows it.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager

from PySide6.QtCore import QCoreApplication, QRectF
from PySide6.QtGui import QFontDatabase, QPainter

SYSTEM = "system"
SIZES = (80, 90, 100, 110, 125, 150)
"""Percent that a person can choose."""
_KEPT = "letters"
"""The property of the application that holds the factor: its widgets have no other in common."""
_USUAL = {"win32": (9.0, 9.0), "darwin": (13.0, 13.0)}
"""Points that the desktops' own letters have, from and to, by ``sys.platform``."""
_USUAL_ELSEWHERE = (9.0, 11.0)


def of_system(points: float | None = None, platform: str = sys.platform) -> int:
    """Percent that the system's letters are of what its desktop has usually, from 80 to 150.

    points: of the system's letters; asked of Qt unless given.
    """
    if points is None:
        points = QFontDatabase.systemFont(QFontDatabase.SystemFont.GeneralFont).pointSizeF()
    least, most = _USUAL.get(platform, _USUAL_ELSEWHERE)
    if points <= 0 or least <= points <= most:
        return 100
    return max(SIZES[0], min(SIZES[-1], round(100 * points / ((least + most) / 2))))


def percent_of(choice: str) -> int:
    """Of a size of ``SIZES``, as text; the system's for all else."""
    return int(choice) if choice in map(str, SIZES) else of_system()


def use(percent: int) -> None:
    """What is made from now on has letters of this size."""
    application = QCoreApplication.instance()
    assert application is not None
    application.setProperty(_KEPT, percent / 100)


def factor() -> float:
    """By how much letters, and what is round them, are larger than the design's."""
    application = QCoreApplication.instance()
    kept = application.property(_KEPT) if application is not None else None
    return float(kept) if kept else 1.0


def px(length: float) -> int:
    """A length of the design, for letters as they are now."""
    return int(length * factor() + 0.5)


@contextmanager
def enlarged(painter: QPainter, area: QRectF) -> Iterator[QRectF]:
    """What is painted here is as large as the letters; gives ``area`` in the design's px.

    Fonts are of ``theme.face``.
    """
    by = factor()
    painter.save()
    painter.scale(by, by)
    yield QRectF(area.x() / by, area.y() / by, area.width() / by, area.height() / by)
    painter.restore()
