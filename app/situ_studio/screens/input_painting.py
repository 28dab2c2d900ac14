"""What people type into, as the robot's page shows it."""

from __future__ import annotations

import re
from functools import lru_cache

from PySide6.QtCore import QLocale, QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPen

from situ.decide.screens import Shown
from situ.decide.values import in_text
from situ_studio.screens.component_painting import Stage, draw_line, edge, rounded
from situ_studio.screens.css_colours import css_colour
from situ_studio.screens.lettering import Fitted, Style, extent, set_lines
from situ_studio.screens.measures import measures

_WIDE = 1e6
_SIGNS = {
    "en": {"D": "DD", "M": "MM", "Y": "YYYY"},
    "de": {"D": "TT", "M": "MM", "Y": "JJJJ"},
    "fr": {"D": "JJ", "M": "MM", "Y": "AAAA"},
    "es": {"D": "DD", "M": "MM", "Y": "AAAA"},
}
"""The letters that stand for a day, a month and a year that are to be typed (dates.js)."""
_DATE = re.compile(r"(?P<Y>\d{4})-(?P<M>\d\d)-(?P<D>\d\d)")


def paint_input(painter: QPainter, stage: Stage, one: Shown) -> None:
    """Paints an input, with its button where the page has one."""
    known = measures()
    box = stage.box(one)
    alone = stage.alone(one)
    if alone:
        ring = known["focus-ring"]
        edge(
            painter,
            box.adjusted(-ring, -ring, ring, ring),
            stage.corner + ring,
            ring,
            known.colour("focus"),
        )
    fill = css_colour(one.get("fill"))
    rounded(painter, box, stage.corner, fill if fill is not None else known.colour("paper"))
    if alone:
        # Where there is one thing to type, the page begins there.
        edge(painter, box, stage.corner, known["focus-edge"], known.colour("accent"))
    else:
        edge(painter, box, stage.corner, known["input-edge"], known.colour("line"))
    text = in_text(one.get("value"))
    room, button = rooms(stage, one, text)
    if button is not None:
        _enter(painter, button)
    ink = css_colour(one.get("color")) or known.colour("ink")
    if one["kind"] == "pin":
        text = "\u2022" * len(text)
    elif one["kind"] == "date":
        ink = ink if text else known.colour("hint")
        text = date(text, stage.content.language)
    if not text:
        return
    size = letters(stage, one, room)
    spacing = known["pin-spacing"] if one["kind"] == "pin" else 0.0
    style = Style(int(known["input-weight"]), 1.0, spacing, tabular=True)
    painter.save()
    painter.setClipRect(room, Qt.ClipOperation.IntersectClip)
    above, under = extent(style)
    below = room.center().y() + (above - under) / 2 * size
    for line in set_lines(text, style, Fitted(size), _WIDE, False):
        draw_line(painter, line, size, room, below, ink, one.get("align", "left"))
    painter.restore()


def date(text: str, language: str) -> str:
    """A date, YYYY-MM-DD, as it is typed in a language; without one, what is to be typed."""
    found = _DATE.fullmatch(text)
    if text and found is None:
        return text
    order, between = _order(language)
    signs = found.groupdict() if found else _SIGNS.get(language[:2], _SIGNS["en"])
    return between.join(signs[one] for one in order)


@lru_cache(maxsize=64)
def _order(language: str) -> tuple[tuple[str, ...], str]:
    """The parts of a date as a language orders them, and what stands between them."""
    locale = QLocale(language.replace("-", "_"))
    if locale.language() == QLocale.Language.C:
        locale = QLocale("en")
    written = locale.dateFormat(QLocale.FormatType.ShortFormat)
    between = re.search("[^dMy]+", written)
    order = dict.fromkeys(one for one in written.upper() if one in "DMY")
    return tuple(order), between[0].strip() if between else "-"


def rooms(stage: Stage, one: Shown, text: str) -> tuple[QRectF, QRectF | None]:
    """Where it is typed, and where the button lies; None where there is none."""
    known, box, unit = measures(), stage.box(one), stage.unit
    if box.width() < known["input-slim"]:
        wide = known["input-slim-wide"]
        return box.adjusted(wide, 0, -wide, 0), None
    wide = known.least("input-wide", unit)
    if not text or not one.get("event") or one.get("max") == 1:
        return box.adjusted(wide, 0, -wide, 0), None
    across = min(known["enter-most"], known["enter-share"] * stage.size.width())
    side = known.least("enter-side", unit)
    high = min(across, known["enter-high"] * box.height())
    button = QRectF(box.right() - side - across, box.center().y() - high / 2, across, high)
    gap = known.least("enter-gap", unit)
    return box.adjusted(wide, 0, -(side + across + gap), 0), button


def letters(stage: Stage, one: Shown, room: QRectF) -> float:
    """The px of what is typed."""
    known, box = measures(), stage.box(one)
    seen = int(known["input-letters"])
    count = seen if one["kind"] == "date" else min(one.get("max") or 1, seen)
    most = min(box.height() * known["input-share"], room.width() / (count * known["input-letter"]))
    share: float = one.get("size", known["input-size"])
    return max(known["least"], min(most, share * stage.unit))


def _enter(painter: QPainter, at: QRectF) -> None:
    known = measures()
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(known.colour("accent"))
    painter.drawEllipse(at)
    painter.setPen(QPen(known.colour("paper"), 3, Qt.PenStyle.SolidLine, Qt.PenCapStyle.SquareCap))
    middle, side = at.center(), at.width()
    painter.drawPolyline(
        [
            middle + QPointF(-0.17 * side, 0.02 * side),
            middle + QPointF(-0.04 * side, 0.15 * side),
            middle + QPointF(0.19 * side, -0.14 * side),
        ]
    )
