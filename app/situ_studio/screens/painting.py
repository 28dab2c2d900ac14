"""What the robot's page shows, painted: the same boxes, letters, lines and colours.

The rules are the page's (docs/screen.md), its numbers and colours resources/screen/measures.css.
"""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QPointF, QRectF, QSize, QSizeF, Qt
from PySide6.QtGui import QLinearGradient, QPainter, QPainterPath

from situ.decide.screens import Shown
from situ.document import rbd
from situ_studio.screens.component_painting import Stage, draw_picture, paint_component
from situ_studio.screens.input_painting import paint_input
from situ_studio.screens.list_painting import paint_list
from situ_studio.screens.measures import measures
from situ_studio.screens.media_pictures import Picture, picture
from situ_studio.screens.shown import Content, Values, content

DEVICE = QSize(1280, 800)
"""The robot's screen in px, unless another is given."""
ROUND = 4
"""px of the corners of what is painted."""
ALL = slice(None)
FAR = 12.0
"""px of the robot's screen by which shades and rings stand out from their components, and more."""


def paint_screen(
    painter: QPainter,
    rect: QRectF,
    screen: rbd.Screen,
    above: tuple[rbd.Component, ...] = (),
    media: Path | None = None,
    *,
    device: QSize = DEVICE,
    values: Values | None = None,
) -> None:
    """Paints a screen into ``rect``; ``above`` are the components that Always adds.

    media: the folder in which its pictures lie; pictures that are not there are a pale box.
    device: the robot's screen in px: it is painted at that size and scaled, so that texts break
    where they do on it. values: tag to value, with which references are filled in; without them
    texts stand as they are written.
    """
    paint_content(painter, rect, content(screen, above, values), media, device)


def paint_content(
    painter: QPainter,
    rect: QRectF,
    content: Content,
    media: Path | None = None,
    device: QSize = DEVICE,
    part: slice = ALL,
) -> None:
    """Paints what is on a robot's screen into ``rect``, as ``paint_screen``.

    part: which of the components; the ground is painted with the first. All of them count for
    the size of letters.
    """
    painter.save()
    clip_corners(painter, rect)
    paint_stage(painter, rect, Stage(layer(device), content, media), device, part)
    painter.restore()


def clip_corners(painter: QPainter, rect: QRectF) -> None:
    """Lets nothing be painted beyond the corners of a screen that fills ``rect``."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    clip = QPainterPath()
    clip.addRoundedRect(rect, ROUND, ROUND)
    painter.setClipPath(clip, Qt.ClipOperation.IntersectClip)


def paint_stage(
    painter: QPainter,
    rect: QRectF,
    stage: Stage,
    device: QSize,
    part: slice = ALL,
    within: QRectF | None = None,
) -> None:
    """As ``paint_content``, with the corners. within: px of the stage; what lies wholly beside it
    is left out.
    """
    size, content = stage.size, stage.content
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
    painter.translate(rect.topLeft())
    painter.scale(rect.width() / size.width(), rect.height() / size.height())
    whole = QRectF(0, (size.height() - device.height()) / 2, device.width(), device.height())
    if not part.start:
        _ground(painter, whole, picture(stage.media, content.background or ""))
    for one in content.components[part]:
        if within is None or within.intersects(stage.box(one).adjusted(-FAR, -FAR, FAR, FAR)):
            _component(painter, stage, one)
    painter.restore()


def layer(device: QSize) -> QSizeF:
    """The px that components share: the screen, less of one that is taller than ``tallest``."""
    most = measures()["tallest"] * device.width()
    return QSizeF(device.width(), min(device.height(), most))


def _component(painter: QPainter, stage: Stage, one: Shown) -> None:
    if one["type"] == "input":
        paint_input(painter, stage, one)
    elif one["type"] == "list":
        paint_list(painter, stage, one)
    else:
        paint_component(painter, stage, one)


def _ground(painter: QPainter, whole: QRectF, behind: Picture | None) -> None:
    known = measures()
    shades = QLinearGradient(whole.topLeft(), whole.bottomLeft())
    shades.setColorAt(0, known.colour("ground-top"))
    shades.setColorAt(known["ground-middle"] / 100, known.colour("ground"))
    shades.setColorAt(1, known.colour("ground-bottom"))
    painter.fillRect(whole, shades)
    if behind is not None:
        # It covers all, and what is too much of it is left out on both sides.
        size = QSizeF(behind.whole().size()).scaled(whole.size(), _COVER)
        at = QRectF(QPointF(0, 0), size)
        at.moveCenter(whole.center())
        painter.save()
        painter.setClipRect(whole, Qt.ClipOperation.IntersectClip)
        draw_picture(painter, at, behind)
        painter.restore()


_COVER = Qt.AspectRatioMode.KeepAspectRatioByExpanding
