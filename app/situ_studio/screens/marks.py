"""What is painted over a screen while its components are placed: what is selected, guides, gaps."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from PySide6.QtCore import QLineF, QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QFontMetricsF, QPainter, QPen

from situ.document import rbd
from situ_studio.looks.theme import CAPTION, Theme, font
from situ_studio.screens import placing
from situ_studio.screens.devices import USUAL, Device
from situ_studio.screens.placing import Box
from situ_studio.screens.snapping import Gap, Snap
from situ_studio.wording.language import tr

GRIP = 7.0
"""Side of a handle, px."""
PILL = 16.0
"""Height of a pill, px."""
TICK = 3.0
"""Half of the line at each end of a distance, px."""
UNDER = 8.0
"""How far under a component its badge stands, px."""


class Scale:
    """Turns percent of the screen into px of the widget that shows it, and back."""

    def __init__(self, size: QSizeF) -> None:
        self.size = size

    def area(self, box: Box) -> QRectF:
        across, down = self.size.width() / 100, self.size.height() / 100
        return QRectF(box.x * across, box.y * down, box.width * across, box.height * down)

    def point(self, x: float, y: float) -> QPointF:
        return QPointF(x * self.size.width() / 100, y * self.size.height() / 100)

    def percent(self, at: QPointF) -> tuple[float, float]:
        return at.x() / self.size.width() * 100, at.y() / self.size.height() * 100

    def handle(self, name: str, box: Box) -> QPointF:
        """The middle of a handle, so far inside of the widget that all of it is seen."""
        area = self.area(box)
        x = area.left() if "w" in name else area.right() if "e" in name else area.center().x()
        y = area.top() if "n" in name else area.bottom() if "s" in name else area.center().y()
        edge = GRIP / 2 + 0.5
        return QPointF(
            min(max(x, edge), self.size.width() - edge),
            min(max(y, edge), self.size.height() - edge),
        )


def measured(box: Box, components: Sequence[rbd.Component], device: Device = USUAL) -> str:
    """How large a box is on a device, which is told unless it has 10 inches, and what a touch of
    its only component sends.
    """
    wide, high = (round(side) for side in device.millimetres(box.width, box.height))
    told = [tr("{0} × {1} mm").format(wide, high)]
    if device != USUAL:
        told.append(tr("{0} inch").format(f"{device.inches:g}"))
    event = getattr(components[0], "event", None) if len(components) == 1 else None
    return ", ".join([*told, event] if event else told)


def paint_guides(painter: QPainter, theme: Theme, scale: Scale, snap: Snap) -> None:
    painter.setPen(QPen(theme.color("guides"), 1))
    for x in snap.upright:
        painter.drawLine(QLineF(scale.point(x, 0), scale.point(x, 100)))
    for y in snap.lying:
        painter.drawLine(QLineF(scale.point(0, y), scale.point(100, y)))


def paint_gaps(painter: QPainter, theme: Theme, scale: Scale, gaps: Iterable[Gap]) -> None:
    """A line along each, with its length on it; even ones are filled, others outlined."""
    for gap in gaps:
        if gap.across:
            ends = scale.point(gap.start, gap.at), scale.point(gap.end, gap.at)
            tick = QPointF(0, TICK)
        else:
            ends = scale.point(gap.at, gap.start), scale.point(gap.at, gap.end)
            tick = QPointF(TICK, 0)
        painter.setPen(QPen(theme.color("guides"), 1))
        painter.drawLine(QLineF(*ends))
        for end in ends:
            painter.drawLine(QLineF(end - tick, end + tick))
        text = f"{round(gap.length, 1):g} %"
        ground = "guides" if gap.even else "card"
        ink = "on_accent" if gap.even else "guides"
        _pill(painter, theme, (ends[0] + ends[1]) / 2, text, ground, ink, scale)


def paint_selection(
    painter: QPainter, theme: Theme, scale: Scale, boxes: Sequence[Box], handles: bool
) -> None:
    """An outline of each with a pale ring, and the handles of what covers them all."""
    if not boxes:
        return
    ring = theme.color("accent")
    ring.setAlphaF(0.22)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for box in boxes:
        painter.setPen(QPen(ring, 6))
        painter.drawRoundedRect(scale.area(box), 4, 4)
        painter.setPen(QPen(theme.color("accent"), 2))
        painter.drawRoundedRect(scale.area(box), 4, 4)
    if not handles:
        return
    whole = placing.around(boxes)
    if len(boxes) > 1:
        painter.setPen(QPen(theme.color("accent"), 1, Qt.PenStyle.DashLine))
        painter.drawRect(scale.area(whole))
    painter.setPen(QPen(theme.color("accent"), 1.5))
    painter.setBrush(theme.color("card"))
    for name in placing.HANDLES:
        grip = QRectF(0, 0, GRIP, GRIP)
        grip.moveCenter(scale.handle(name, whole))
        painter.drawRoundedRect(grip, 1.5, 1.5)


def paint_badge(
    painter: QPainter, theme: Theme, scale: Scale, box: Box, text: str, within: bool
) -> None:
    """Under a box; where there is no room, above it, and else in it. within: in it, if it is high
    enough, since distances stand around it.
    """
    area = scale.area(box)
    under = area.bottom() + UNDER + PILL / 2
    above = area.top() - UNDER - PILL / 2
    if within and area.height() > 3 * PILL:
        y = area.bottom() - UNDER - PILL / 2
    elif under + PILL / 2 <= scale.size.height():
        y = under
    elif above - PILL / 2 >= 0:
        y = above
    else:
        y = area.bottom() - UNDER - PILL / 2
    _pill(painter, theme, QPointF(area.center().x(), y), text, "accent", "on_accent", scale)


def paint_band(painter: QPainter, theme: Theme, scale: Scale, band: Box) -> None:
    soft = theme.color("accent")
    soft.setAlphaF(0.12)
    painter.setPen(QPen(theme.color("accent"), 1))
    painter.setBrush(soft)
    painter.drawRect(scale.area(band))


def paint_focus(painter: QPainter, theme: Theme, scale: Scale) -> None:
    """A line round all of it: the keys go there, while nothing on it is selected."""
    painter.setPen(QPen(theme.color("accent"), 2))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawRoundedRect(QRectF(QPointF(0, 0), scale.size).adjusted(1, 1, -1, -1), 4, 4)


def _pill(
    painter: QPainter,
    theme: Theme,
    middle: QPointF,
    text: str,
    ground: str,
    ink: str,
    scale: Scale,
) -> None:
    """A text in a rounded box about a point, all of it in the widget."""
    letters = font(CAPTION, 600)
    wide = QFontMetricsF(letters).horizontalAdvance(text) + 12
    area = QRectF(0, 0, wide, PILL)
    area.moveCenter(middle)
    area.moveLeft(min(max(area.left(), 1.0), scale.size.width() - wide - 1))
    area.moveTop(min(max(area.top(), 1.0), scale.size.height() - PILL - 1))
    edge = ink if ground == "card" else ground
    painter.setPen(QPen(theme.color(edge), 1))
    painter.setBrush(theme.color(ground))
    painter.drawRoundedRect(area, 4, 4)
    painter.setFont(letters)
    painter.setPen(theme.color(ink))
    painter.drawText(area, int(Qt.AlignmentFlag.AlignCenter), text)
