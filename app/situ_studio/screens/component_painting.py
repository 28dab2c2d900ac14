"""Texts, buttons, pictures and movies of a screen, as the robot's page shows them."""

from __future__ import annotations

from collections import defaultdict
from functools import lru_cache
from pathlib import Path
from typing import Any

from PySide6.QtCore import QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QBrush, QColor, QPainter, QPainterPath, QPen, QTransform

from situ.decide.screens import Shown
from situ_studio.looks import icons
from situ_studio.screens.css_colours import css_colour
from situ_studio.screens.lettering import REFERENCE, Fitted, Line, Style, base, fit, set_lines
from situ_studio.screens.measures import is_light, measures
from situ_studio.screens.media_pictures import Picture, picture
from situ_studio.screens.shown import Content

_HERE = QPointF(0, 0)


class Stage:
    """What a component is painted by: the px that all share, and what the others are."""

    def __init__(self, size: QSizeF, content: Content, media: Path | None) -> None:
        known = measures()
        self.size = size
        self.media = media
        self.content = content
        self.unit = min(size.height(), size.width() * known["narrow"]) / 100
        self.corner = known.least("corner", self.unit)
        plain = [
            one
            for one in content.components
            if one["type"] == "button" and not one.get("fill") and not one.get("color")
        ]
        # Of two or three answers the first is the one most people want; three of one size, as in
        # a quiz, and more are equals.
        equals = len(plain) > 2 and len({(one["width"], one["height"]) for one in plain}) == 1
        self.first = plain[0] if 0 < len(plain) <= 3 and not equals else None
        inputs = [one for one in content.components if one["type"] == "input"]
        self._only_input = inputs[0] if len(inputs) == 1 else None
        self._alike: dict[tuple[Any, ...], Fitted] | None = None
        self._fits: dict[str, Fitted] = {}
        self._boxes: dict[str, QRectF] = {}

    def box(self, one: Shown) -> QRectF:
        """Where a component lies, px."""
        found = self._boxes.get(one["id"])
        if found is None:
            across, down = self.size.width() / 100, self.size.height() / 100
            found = QRectF(
                one["x"] * across, one["y"] * down, one["width"] * across, one["height"] * down
            )
            self._boxes[one["id"]] = found
        return found

    def alone(self, one: Shown) -> bool:
        """Whether it is the only input: that has the focus."""
        return one is self._only_input

    def fitted(self, one: Shown) -> Fitted:
        """The letters of a text or button; of buttons that are alike, as those of the smallest."""
        if one["type"] == "text":
            return self._own(one)
        if self._alike is None:
            alike: dict[tuple[Any, ...], list[Fitted]] = defaultdict(list)
            for button in self.content.components:
                if button["type"] == "button" and not (own := self._own(button)).cut:
                    alike[_kind(button)].append(own)
            self._alike = {kind: min(every) for kind, every in alike.items()}
        own = self._own(one)
        return own if own.cut else own._replace(size=self._alike[_kind(one)].size)

    def _own(self, one: Shown) -> Fitted:
        if (known := self._fits.get(one["id"])) is not None:
            return known
        box, style = self.box(one), style_of(one)
        wide, high = padding(one)
        wanted = one.get("size", measures()[f"{one['type']}-size"]) * self.unit
        found = fit(one["text"], style, box.width(), box.height(), wanted, wide, high)
        self._fits[one["id"]] = found
        return found

    def lines(self, one: Shown) -> tuple[Line, ...]:
        """What stands in each line of a text or button."""
        fitted = self.fitted(one)
        room = self.box(one).width() - 2 * padding(one)[0] * fitted.size
        return set_lines(one["text"], style_of(one), fitted, room)


def _kind(button: Shown) -> tuple[Any, ...]:
    return button["width"], button["height"], button.get("size")


def padding(one: Shown) -> tuple[float, float]:
    """What is left free beside a component's text, and above and below it, in em."""
    return (0.0, 0.0) if one["type"] == "text" and not one.get("fill") else _padding(one["type"])


@lru_cache(maxsize=2)
def _padding(kind: str) -> tuple[float, float]:
    known = measures()
    return known[f"{kind}-wide"], known[f"{kind}-high"]


def style_of(one: Shown) -> Style:
    """The letters of a text or a button."""
    return _style("button" if one["type"] == "button" else rank_of(one))


@lru_cache(maxsize=4)
def _style(kind: str) -> Style:
    known = measures()
    if kind == "button":
        return Style(int(known["button-weight"]), known["button-line"])
    return Style(int(known[f"{kind}-weight"]), known["text-line"], known[f"{kind}-spacing"])


def rank_of(one: Shown) -> str:
    """Whether a text is a title, a body or a hint."""
    known = measures()
    size = one.get("size", known["text-size"])
    if size >= known["title-from"]:
        return "title"
    return "body" if size >= known["body-from"] else "hint"


def paint_component(painter: QPainter, stage: Stage, one: Shown) -> None:
    """Paints a text, a button, a picture or a movie."""
    box = stage.box(one)
    if one["type"] == "button":
        _button(painter, stage, one, box)
        return
    if (fill := css_colour(one.get("fill"))) is not None:
        rounded(painter, box, stage.corner, fill)
    if one["type"] == "text":
        known = measures()
        ink = css_colour(one.get("color"))
        if ink is None:
            ink = known.colour("ink-soft" if rank_of(one) == "hint" else "ink")
        _text(painter, stage, one, box, ink, one.get("align", "left"))
    else:
        _picture(painter, stage, one, box)


def _button(painter: QPainter, stage: Stage, one: Shown, box: QRectF) -> None:
    known = measures()
    fill, ink = css_colour(one.get("fill")), css_colour(one.get("color"))
    if one.get("fill"):
        _shade(painter, box, stage.corner, known.colour("shade-given"))
        if fill is not None:
            rounded(painter, box, stage.corner, fill)
        if ink is None:
            ink = known.colour("ink") if is_light(fill) else known.colour("paper")
    elif one is stage.first:
        _shade(painter, box, stage.corner, known.colour("shade"))
        rounded(painter, box, stage.corner, known.colour("accent"))
        ink = known.colour("paper")
    else:
        ink = ink or known.colour("accent")
        rounded(painter, box, stage.corner, known.colour("paper"))
        edge(painter, box, stage.corner, known.least("button-edge", stage.unit), ink)
    _text(painter, stage, one, box, ink, one.get("align", "center"))


def _shade(painter: QPainter, box: QRectF, corner: float, shade: QColor) -> None:
    """What a filled button throws below itself, and not under itself."""
    deep = measures()["shade-deep"]
    below, own = QPainterPath(), QPainterPath()
    corner = min(corner, box.width() / 2, box.height() / 2)
    below.addRoundedRect(box.translated(0, deep), corner, corner)
    own.addRoundedRect(box, corner, corner)
    painter.fillPath(below.subtracted(own), shade)


def _text(
    painter: QPainter, stage: Stage, one: Shown, box: QRectF, ink: QColor, align: str
) -> None:
    fitted, style = stage.fitted(one), style_of(one)
    wide, high = (side * fitted.size for side in padding(one))
    room = box.adjusted(wide, high, -wide, -high)
    if fitted.cut:
        painter.save()
        painter.setClipRect(box, Qt.ClipOperation.IntersectClip)
    lines = stage.lines(one)
    tall = style.line * fitted.size
    top = room.top() if fitted.cut else room.center().y() - tall * len(lines) / 2
    for number, line in enumerate(lines):
        if fitted.cut and top + number * tall > box.bottom():
            break
        below = top + number * tall + base(style, fitted.size)
        draw_line(painter, line, fitted.size, room, below, ink, align)
    if fitted.cut:
        painter.restore()


def draw_line(
    painter: QPainter,
    line: Line,
    size: float,
    room: QRectF,
    below: float,
    ink: QColor,
    align: str,
) -> None:
    """Draws a line of letters of ``size`` px, which stand on ``below``, into ``room``."""
    free = room.width() - line.width * size
    side = {"left": 0.0, "center": max(free, 0.0) / 2, "right": max(free, 0.0)}[align]
    scale = size / REFERENCE
    world = painter.worldTransform()
    painter.translate(room.left() + side, round(below) - line.base * size)
    painter.scale(scale, scale)
    painter.setPen(ink)
    for glyphs in line.glyphs:
        painter.drawGlyphRun(_HERE, glyphs)
    painter.setWorldTransform(world)


def _picture(painter: QPainter, stage: Stage, one: Shown, box: QRectF) -> None:
    found = picture(stage.media, one["src"]) if one["type"] == "image" else None
    if found is None:
        known = measures()
        if css_colour(one.get("fill")) is None:
            rounded(painter, box, stage.corner, known.colour("accent-soft"))
        side = min(box.width(), box.height()) * 0.35
        at = QRectF(0, 0, side, side)
        at.moveCenter(box.center())
        icons.paint(painter, one["type"], at, known.colour("accent"))
        return
    size = QSizeF(found.whole().size()).scaled(box.size(), Qt.AspectRatioMode.KeepAspectRatio)
    at = QRectF(QPointF(0, 0), size)
    at.moveCenter(box.center())
    if one.get("align") == "left":
        at.moveLeft(box.left())
    elif one.get("align") == "right":
        at.moveRight(box.right())
    corners = QPainterPath()
    corners.addRoundedRect(box, stage.corner, stage.corner)
    _fill_with_picture(painter, corners, at, found)


# -- shapes ----------------------------------------------------------------------------


def _fill_with_picture(painter: QPainter, shape: QPainterPath, at: QRectF, found: Picture) -> None:
    """What of a picture that is drawn into ``at`` lies in ``shape``.

    By no clip: half of a px at its edge would be all of one where little is painted anew.
    """
    to_device = painter.deviceTransform()
    seen = to_device.mapRect(at).toRect()
    pixels = found.at(seen.size())
    area = to_device.inverted()[0].mapRect(QRectF(seen)) if pixels.size() == seen.size() else at
    place = QTransform.fromTranslate(area.x(), area.y())
    place.scale(area.width() / pixels.width(), area.height() / pixels.height())
    brush = QBrush(pixels)
    brush.setTransform(place)
    beside = QPainterPath()
    beside.addRect(area)
    painter.fillPath(shape.intersected(beside), brush)


def draw_picture(painter: QPainter, at: QRectF, found: Picture) -> None:
    """Draws a picture into ``at``, from one of as many px as that has on the device."""
    to_device, world = painter.deviceTransform(), painter.worldTransform()
    seen = to_device.mapRect(at).toRect()
    pixels = found.at(seen.size())
    if pixels.size() != seen.size():
        painter.drawPixmap(at, pixels, QRectF(pixels.rect()))
        return
    # On whole px, as the page has it, a picture is as sharp as it is, and quickly drawn.
    beyond = world.inverted()[0] * to_device
    painter.setWorldTransform(
        QTransform.fromTranslate(seen.x(), seen.y()) * beyond.inverted()[0], False
    )
    painter.drawPixmap(0, 0, pixels)
    painter.setWorldTransform(world, False)


def rounded(painter: QPainter, box: QRectF, corner: float, colour: QColor) -> None:
    """Fills a box with round corners."""
    corner = min(corner, box.width() / 2, box.height() / 2)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(colour)
    painter.drawRoundedRect(box, corner, corner)


def edge(painter: QPainter, box: QRectF, corner: float, wide: float, colour: QColor) -> None:
    """Draws the edge of such a box, inside it."""
    corner = min(corner, box.width() / 2, box.height() / 2)
    within = max(corner - wide / 2, 0.0)
    painter.setPen(QPen(colour, wide))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawRoundedRect(box.adjusted(wide / 2, wide / 2, -wide / 2, -wide / 2), within, within)
