"""Lists as the robot's page shows them: rows from the top, and whether there are more."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import msgspec
from PySide6.QtCore import QRectF, QSizeF, Qt
from PySide6.QtGui import QColor, QLinearGradient, QPainter, QPixmap

from situ.decide.screens import Shown
from situ.decide.values import in_text
from situ_studio.screens.component_painting import Stage, draw_line, edge, rounded
from situ_studio.screens.css_colours import css_colour
from situ_studio.screens.lettering import Fitted, Line, Style, base, set_lines
from situ_studio.screens.measures import measures
from situ_studio.screens.shown import Content


class Row(NamedTuple):
    """A row of a list, and its lines; without any where it is not known what stands there."""

    box: QRectF
    lines: tuple[Line, ...]


def paint_list(painter: QPainter, stage: Stage, one: Shown) -> None:
    """Paints a list, paler at its lower end where it goes on."""
    known, box = measures(), stage.box(one)
    if (fill := css_colour(one.get("fill"))) is not None:
        rounded(painter, box, stage.corner * known["list-corner"], fill)
    every = rows(stage, one)
    if not every:
        return
    painter.save()
    painter.setClipRect(box, Qt.ClipOperation.IntersectClip)
    if every[-1].box.bottom() + pad(stage, one) <= box.bottom() + 4:
        for row in every:
            _row(painter, stage, one, row)
    else:
        here = msgspec.json.encode(one | {"x": 0, "y": 0})
        zoom = painter.deviceTransform().m11()
        seen = _fading(here, stage.size.width(), stage.size.height(), zoom)
        painter.drawPixmap(box, seen, QRectF(seen.rect()))
    painter.restore()


def size(stage: Stage, one: Shown) -> float:
    """The px of a list's letters."""
    known = measures()
    share: float = one.get("size", known["list-size"])
    return max(known["least"], share * stage.unit)


def pad(stage: Stage, one: Shown) -> float:
    """px between a list's edge and its rows."""
    known = measures()
    return known.least("list-pad-filled", stage.unit) if one.get("fill") else known["list-pad"]


def style() -> Style:
    """The letters of a row."""
    known = measures()
    return Style(int(known["list-weight"]), known["list-line"])


def rows(stage: Stage, one: Shown) -> list[Row]:
    """Its rows, as far as one of them can be seen; the last of all is known by its lower edge."""
    known, box, em = measures(), stage.box(one), size(stage, one)
    free, gap = pad(stage, one), known.least("row-gap", stage.unit)
    least = max(known["row-least"], known["row-tall"] * em)
    at = box.top() + free
    across = max(box.width() - 2 * free, 2 * known["row-wide"] * em)
    found: list[Row] = []
    if one["items"] is None:
        # Nobody knows yet what stands there: as many as there is room for.
        while not found or at + least + free <= box.bottom():
            found.append(Row(QRectF(box.left() + free, at, across, least), ()))
            at += least + gap
        return found
    room = across - 2 * known["row-wide"] * em
    for item in one["items"]:
        lines = set_lines(in_text(item["label"]), style(), Fitted(em, "row"), room, False)
        tall = max(least, len(lines) * known["list-line"] * em + 2 * known["row-high"] * em)
        found.append(Row(QRectF(box.left() + free, at, across, tall), lines))
        at += tall + gap
        if at > box.bottom() + free:
            break
    return found


def _row(painter: QPainter, stage: Stage, one: Shown, row: Row) -> None:
    known, em = measures(), size(stage, one)
    rounded(painter, row.box, stage.corner, known.colour("paper"))
    edge(painter, row.box, stage.corner, known["row-edge"], known.colour("row-line"))
    wide = known["row-wide"] * em
    room = row.box.adjusted(wide, 0, -wide, 0)
    if one["items"] is None:
        bar = QRectF(room.left(), room.center().y() - em / 4, room.width() * 0.4, em / 2)
        rounded(painter, bar, em / 4, known.colour("line"))
        return
    ink = css_colour(one.get("color")) or known.colour("ink")
    tall = known["list-line"] * em
    top = room.center().y() - tall * len(row.lines) / 2
    for number, line in enumerate(row.lines):
        below = top + number * tall + base(style(), em)
        draw_line(painter, line, em, room, below, ink, one.get("align", "left"))


@lru_cache(maxsize=64)
def _fading(written: bytes, wide: float, high: float, zoom: float) -> QPixmap:
    """A list's rows as seen through a mask that lets less through at the lower end.

    written: the list, at the left upper corner. wide, high: px of the screen. zoom: of the picture.
    """
    one: Shown = msgspec.json.decode(written)
    stage = Stage(QSizeF(wide, high), Content((one,)), None)
    box = stage.box(one)
    seen = QPixmap(max(1, round(box.width() * zoom)), max(1, round(box.height() * zoom)))
    seen.fill(Qt.GlobalColor.transparent)
    painter = QPainter(seen)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.scale(seen.width() / box.width(), seen.height() / box.height())
    for row in rows(stage, one):
        _row(painter, stage, one, row)
    mask = QLinearGradient(0, box.bottom() - measures()["fade"], 0, box.bottom())
    mask.setColorAt(0, QColor(0, 0, 0, 255))
    mask.setColorAt(1, QColor(0, 0, 0, 0))
    painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_DestinationIn)
    painter.fillRect(box, mask)
    painter.end()
    return seen
