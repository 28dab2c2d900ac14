"""The problems of what lies on a screen, where it lies: a sign on each component that has one."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPen

from situ.document.problem import Problem
from situ_studio.edits import places
from situ_studio.edits.edit import Place
from situ_studio.looks import icons
from situ_studio.looks.theme import LIGHT
from situ_studio.screens.marks import GRIP
from situ_studio.wording.language import said, tr

if TYPE_CHECKING:
    from situ_studio.screens.sheet import Sheet

SIDE = 18.0
"""Of a sign with the ground around it, px."""

Told = Mapping[str, Sequence[Problem]]
"""Problems by the id of the component that they are about, errors first."""


def by_screen(problems: Iterable[Problem]) -> dict[Place, dict[str, list[Problem]]]:
    """The problems of what lies on screens, by the place of the screen."""
    found: dict[Place, dict[str, list[Problem]]] = {}
    for problem in sorted(problems, key=lambda one: one.severity):
        size = len(places.root(problem.place))
        screen, rest = problem.place[: size + 1], problem.place[size + 1 :]
        if screen[size:] == ("screen",) and rest:
            found.setdefault(screen, {}).setdefault(rest[0], []).append(problem)
    return found


def worst(problems: Sequence[Problem]) -> str:
    """``error`` or ``warning``; "" where there is none."""
    return problems[0].severity if problems else ""


def told_words(problems: Sequence[Problem]) -> str:
    """A line each."""
    return "\n".join(said(one.message) for one in problems)


def spoken(problems: Sequence[Problem]) -> str:
    """For those who hear it."""
    kinds = {"error": tr("Error"), "warning": tr("Warning")}
    return "; ".join(f"{kinds[one.severity]}: {said(one.message)}" for one in problems)


class ProblemMarks:
    """The signs on a sheet: in the upper right corner of their component, left of its handle."""

    def __init__(self, sheet: Sheet) -> None:
        self._sheet = sheet
        self.told: Told = {}

    def areas(self) -> dict[str, QRectF]:
        """Where the signs are, by the ids of their components, those in front last."""
        sheet, found = self._sheet, {}
        room = QRectF(sheet.rect())
        for id, box in sheet.own().items():
            if id in self.told:
                corner = sheet.area(box).topRight()
                area = QRectF(0, 0, SIDE, SIDE)
                area.moveCenter(QPointF(corner.x() - GRIP - SIDE / 2, corner.y() + 2))
                # A component may lie outside the screen: its sign does not.
                area.moveLeft(min(max(area.left(), 1.0), room.width() - SIDE - 1))
                area.moveTop(min(max(area.top(), 1.0), room.height() - SIDE - 1))
                found[id] = area
        return found

    def words_at(self, at: QPointF) -> str:
        """What is told by the sign there; "" where there is none."""
        under = [id for id, area in self.areas().items() if area.contains(at)]
        return told_words(self.told[under[-1]]) if under else ""

    def paint(self, painter: QPainter) -> None:
        # The robot's screen is light in both themes.
        for id, area in self.areas().items():
            token = worst(self.told[id])
            painter.setPen(QPen(LIGHT.color(token), 1))
            painter.setBrush(LIGHT.color("card"))
            painter.drawEllipse(area)
            painter.setBrush(Qt.BrushStyle.NoBrush)
            icons.paint(painter, token, area.adjusted(3, 2.5, -3, -3.5), LIGHT.color(token))
