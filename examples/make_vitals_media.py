"""Draws what examples/vitals shows and plays: ``python examples/make_vitals_media.py``.

As make_media.py, whose lines and colours it takes: no picture of unknown origin, and no typeface.
The tunes are old enough to belong to everybody; they are played note by note in music_box.py.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from pathlib import Path

from make_media import (
    ACCENT,
    INK,
    PALE,
    PAPER,
    RED,
    ROBOTS,
    SKIN,
    SKIN_LINE,
    SOFT,
    Draw,
    box,
    clip,
    curve,
    dot,
    heart,
    line,
    picture,
    tell,
    tile,
    vp8,
    webm,
    write_sound,
    write_squares,
)
from music_box import JOY, LULLABY, RATE, SAKURA, tune
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QLinearGradient, QPainter, QPainterPath

HERE = Path(__file__).resolve().parent

GREEN = QColor("#a9d5bd")
SUN = QColor("#fbe3a4")

Scene = Callable[[QPainter, float], None]
"""Draws what is seen after that part of the film, 0 to 1."""


# -- pictures, each in a square of 600 -----------------------------------------


def cuff(p: QPainter) -> None:
    """An upper arm in a cuff, the lower one on a table; the tube goes towards the hand."""
    tile(p)
    p.setPen(Qt.PenStyle.NoPen)
    box(p, 30, 500, 540, 40, 12, SOFT)
    for colour, width in ((SKIN_LINE, 116), (SKIN, 100)):
        p.setPen(line(colour, width))
        p.drawPolyline([QPointF(*at) for at in ((116, -20), (190, 440), (420, 442))])
        p.setPen(line(colour, width - 28))
        p.drawPolyline([QPointF(*at) for at in ((420, 446), (500, 452))])
        p.setPen(line(colour, width - 70))
        p.drawLine(QPointF(470, 420), QPointF(520, 402))
    p.save()
    p.translate(156, 230)
    p.rotate(-9)
    p.setPen(line(INK, 10))
    box(p, -84, -104, 168, 208, 26, ACCENT)
    p.setPen(line(PAPER, 9))
    p.drawLine(QPointF(-60, 62), QPointF(60, 62))
    p.setPen(Qt.PenStyle.NoPen)
    heart(p, 0, -16, 38, PAPER)
    p.restore()
    p.setPen(line(INK, 13))
    p.setBrush(Qt.BrushStyle.NoBrush)
    p.drawPath(curve((226, 310), (300, 400), (340, 300), (430, 320)))
    p.setPen(line(INK, 10))
    box(p, 430, 250, 120, 100, 22, PAPER)
    box(p, 452, 270, 76, 40, 8, SOFT)


def strip(p: QPainter, blood: bool) -> None:
    """A glucose meter with a strip; blood: a finger touches its end."""
    tile(p)
    p.setPen(line(INK, 10))
    box(p, 150, 40, 300, 330, 70, PAPER)
    box(p, 200, 96, 200, 130, 18, SOFT)
    dot(p, 300, 296, 34, ACCENT)
    box(p, 256, 370, 88, 130, 8, PAPER)
    p.setPen(Qt.PenStyle.NoPen)
    arrow = QPainterPath(QPointF(300, 384))
    for x, y in ((334, 424), (312, 424), (312, 462), (288, 462), (288, 424), (266, 424)):
        arrow.lineTo(x, y)
    arrow.closeSubpath()
    p.setBrush(ACCENT)
    if not blood:
        p.drawPath(arrow)
        return
    p.setPen(line(SKIN_LINE, 8))
    p.save()
    p.translate(306, 520)
    p.rotate(18)
    box(p, 0, -48, 330, 96, 48, SKIN)
    p.setPen(line(SKIN_LINE, 5))
    box(p, 14, -34, 62, 40, 18, QColor("#f9e3d3"))
    p.restore()
    p.setPen(Qt.PenStyle.NoPen)
    drop = curve((300, 450), (330, 490), (334, 528), (300, 528), (266, 528), (270, 490), (300, 450))
    p.setBrush(RED)
    p.drawPath(drop)


def nurse(p: QPainter) -> None:
    tile(p)
    p.setPen(line(INK, 10))
    p.setBrush(PAPER)
    coat = QPainterPath(QPointF(110, 600))
    coat.cubicTo(QPointF(110, 440), QPointF(200, 410), QPointF(300, 410))
    coat.cubicTo(QPointF(400, 410), QPointF(490, 440), QPointF(490, 600))
    p.drawPath(coat)
    p.setPen(line(SKIN_LINE, 8))
    box(p, 258, 350, 84, 96, 36, SKIN)
    p.setPen(Qt.PenStyle.NoPen)
    dot(p, 300, 236, 150, QColor("#6b4a33"))
    p.setPen(line(SKIN_LINE, 8))
    p.setBrush(SKIN)
    p.drawEllipse(QRectF(184, 160, 232, 236))
    p.setPen(line(INK, 10))
    p.setBrush(PAPER)
    p.drawPath(
        curve((176, 178), (180, 60), (420, 60), (424, 178), (350, 146), (250, 146), (176, 178))
    )
    p.setPen(Qt.PenStyle.NoPen)
    box(p, 288, 84, 24, 56, 6, RED)
    box(p, 272, 100, 56, 24, 6, RED)
    for x in (254, 346):
        dot(p, x, 268, 14, INK)
    p.setPen(line(INK, 10))
    p.setBrush(Qt.BrushStyle.NoBrush)
    p.drawArc(QRectF(250, 276, 100, 76), 205 * 16, 130 * 16)
    p.setPen(Qt.PenStyle.NoPen)
    heart(p, 392, 520, 34, RED)


def telephone(p: QPainter) -> None:
    """A friend in a picture frame, who listens and talks."""
    tile(p)
    p.setPen(line(INK, 10))
    box(p, 60, 90, 480, 350, 34, PAPER)
    box(p, 210, 470, 180, 40, 18, SOFT)
    p.setPen(line(INK, 14))
    p.drawLine(QPointF(300, 442), QPointF(300, 470))
    p.setPen(Qt.PenStyle.NoPen)
    shoulders = QPainterPath(QPointF(166, 434))
    shoulders.cubicTo(QPointF(172, 260), QPointF(428, 260), QPointF(434, 434))
    p.setBrush(ACCENT)
    p.drawPath(shoulders)
    dot(p, 300, 216, 92, QColor("#d9dde6"))
    dot(p, 300, 240, 80, SKIN)
    for x in (270, 330):
        dot(p, x, 236, 10, INK)
    p.setPen(line(INK, 8))
    p.setBrush(Qt.BrushStyle.NoBrush)
    p.drawArc(QRectF(262, 236, 76, 56), 205 * 16, 130 * 16)
    p.setPen(line(ACCENT, 12))
    for size in (50, 100):
        p.drawArc(QRectF(420 - size / 2, 200 - size / 2, size, size), -45 * 16, 90 * 16)


def quiz(p: QPainter) -> None:
    """A lamp that lights up."""
    tile(p)
    p.setPen(line(SUN.darker(115), 18))
    for i in (0, 1, 2, 4, 5, 6):
        turn = math.radians(-90 + (i - 3) * 32)
        x, y = math.cos(turn), math.sin(turn)
        p.drawLine(QPointF(300 + 210 * x, 262 + 210 * y), QPointF(300 + 256 * x, 262 + 256 * y))
    p.setPen(line(INK, 10))
    p.setBrush(SUN)
    bulb = QPainterPath(QPointF(240, 430))
    bulb.cubicTo(QPointF(240, 370), QPointF(150, 350), QPointF(150, 256))
    bulb.cubicTo(QPointF(150, 60), QPointF(450, 60), QPointF(450, 256))
    bulb.cubicTo(QPointF(450, 350), QPointF(360, 370), QPointF(360, 430))
    bulb.closeSubpath()
    p.drawPath(bulb)
    box(p, 236, 430, 128, 46, 14, SOFT)
    box(p, 250, 476, 100, 44, 18, SOFT)
    p.setBrush(Qt.BrushStyle.NoBrush)
    p.drawPath(
        curve((270, 426), (262, 360), (250, 330), (250, 300), (270, 270), (300, 330), (300, 300))
    )
    p.drawPath(
        curve((300, 300), (300, 330), (330, 270), (350, 300), (350, 330), (338, 360), (330, 426))
    )


def notes(p: QPainter) -> None:
    tile(p)
    p.setPen(line(INK, 26))
    p.drawLine(QPointF(234, 130), QPointF(234, 420))
    p.drawLine(QPointF(446, 90), QPointF(446, 380))
    p.setPen(line(INK, 48))
    p.drawLine(QPointF(236, 140), QPointF(444, 100))
    p.setPen(Qt.PenStyle.NoPen)
    for x, y in ((178, 430), (390, 390)):
        p.save()
        p.translate(x, y)
        p.rotate(-18)
        p.setBrush(ACCENT)
        p.drawEllipse(QRectF(-80, -56, 160, 112))
        p.restore()


def screen(p: QPainter) -> None:
    """A film in the evening: a screen with hills and the sun."""
    tile(p)
    p.setPen(line(INK, 12))
    box(p, 60, 110, 480, 340, 26, QColor("#cfe3fb"))
    p.setPen(Qt.PenStyle.NoPen)
    dot(p, 420, 210, 48, SUN)
    p.setBrush(GREEN)
    p.drawPath(
        curve((68, 440), (130, 260), (250, 270), (320, 360), (390, 300), (480, 320), (532, 440))
    )
    p.setBrush(ACCENT)
    play = QPainterPath(QPointF(252, 200))
    play.lineTo(252, 360)
    play.lineTo(388, 280)
    play.closeSubpath()
    p.drawPath(play)
    p.setPen(line(INK, 20))
    p.drawLine(QPointF(220, 500), QPointF(380, 500))


def book(p: QPainter) -> None:
    tile(p)
    for side in (-1, 1):
        p.save()
        p.translate(300, 0)
        p.scale(side, 1)
        p.setPen(line(INK, 10))
        p.setBrush(PAPER)
        page = curve((0, 180), (60, 120), (180, 120), (240, 150))
        page.lineTo(240, 440)
        page.cubicTo(QPointF(180, 410), QPointF(60, 410), QPointF(0, 470))
        page.closeSubpath()
        p.drawPath(page)
        p.setPen(line(SOFT, 14))
        p.setBrush(Qt.BrushStyle.NoBrush)
        for y in (230, 290, 350):
            p.drawPath(curve((46, y), (90, y - 32), (150, y - 32), (196, y - 22)))
        p.restore()


# -- films, 640 by 400 -----------------------------------------------------------


def sunset(p: QPainter, part: float) -> None:
    """The sun goes down over the sea, a boat sails home, the stars come out. part: 0 to 1."""
    dark = min(1.0, max(0.0, (part - 0.45) / 0.55))

    def between(one: str, other: str) -> QColor:
        a, b = QColor(one), QColor(other)
        pairs = ((a.red(), b.red()), (a.green(), b.green()), (a.blue(), b.blue()))
        return QColor(*(round(x + (y - x) * dark) for x, y in pairs))

    sky = QLinearGradient(0, 0, 0, 270)
    sky.setColorAt(0, between("#8ec5f4", "#101a3c"))
    sky.setColorAt(1, between("#fbe0b4", "#3b3f78"))
    p.setPen(Qt.PenStyle.NoPen)
    p.fillRect(QRectF(0, 0, 640, 270), sky)
    for i in range(24):
        star = QColor("#ffffff")
        star.setAlphaF(min(1.0, max(0.0, dark * 1.8 - 0.4 - (i % 5) * 0.12)))
        dot(p, (i * 137) % 640, (i * 71) % 220 + 10, 1.6 + i % 3 * 0.6, star)
    dot(p, 440, 70 + 260 * part, 42, between("#fff3b8", "#f08a4b"))
    p.fillRect(QRectF(0, 260, 640, 140), between("#4b8fd0", "#131f4a"))
    p.setPen(line(between("#8fc0ea", "#2b3b78"), 4))
    for i in range(9):
        x = (i * 83 + math.sin(part * 40 + i) * 10) % 640
        p.drawLine(QPointF(x, 280 + i * 13), QPointF(x + 44, 280 + i * 13))
    p.save()
    p.translate(20 + 420 * part, 292 + math.sin(part * 44) * 3)
    p.setPen(Qt.PenStyle.NoPen)
    p.setBrush(QColor("#7b4a2e"))
    p.drawPath(curve((-56, 0), (-40, 34), (40, 34), (56, 0)))
    for x, colour in ((-42, "#f6efe2"), (42, "#e0d5c2")):
        sail = QPainterPath(QPointF(0, -96))
        sail.lineTo(x, -8)
        sail.lineTo(0, -8)
        sail.closeSubpath()
        p.setBrush(QColor(colour))
        p.drawPath(sail)
    p.restore()


def pond(p: QPainter, part: float) -> None:
    """Carp swim below the leaves of a pond. part: 0 to 1, and then from the beginning."""
    p.fillRect(QRectF(0, 0, 640, 400), QColor("#5fa8b4"))
    p.setPen(line(QColor("#7fbcc5"), 5))
    p.setBrush(Qt.BrushStyle.NoBrush)
    for i in range(3):
        ring = (part * 6 + i / 3) % 1.0
        p.drawEllipse(QPointF(500, 110), 12 + 90 * ring, 6 + 50 * ring)
    p.setPen(Qt.PenStyle.NoPen)
    for i, (colour, deep) in enumerate(
        (("#e8703a", 80), ("#f4f0e6", 170), ("#e8a13a", 250), ("#d64f3c", 330))
    ):
        away = (part * (1 + i % 2) + i * 0.27) % 1.0
        side = 1 if i % 2 else -1
        x = -90 + 820 * away if side > 0 else 730 - 820 * away
        wag = math.sin(part * 80 + i)
        p.save()
        p.translate(x, deep + 14 * math.sin(away * 9 + i))
        p.scale(side, 1)
        p.setBrush(QColor(colour))
        p.drawPath(
            curve(
                (-44, 0),
                (-66, -6),
                (-80, -20 + 10 * wag),
                (-92, -24 + 12 * wag),
                (-84, 0),
                (-84, 4),
                (-92, 24 + 12 * wag),
                (-76, 16),
                (-62, 8),
                (-44, 0),
            )
        )
        p.drawEllipse(QRectF(-52, -20, 108, 40))
        dot(p, 40, -6, 4, QColor("#1b1b1b"))
        p.restore()
    for x, y, size in ((90, 60, 54), (210, 120, 38), (560, 320, 62), (440, 370, 40), (60, 350, 46)):
        p.setBrush(QColor("#3f8f5a"))
        p.drawPie(QRectF(x - size, y - size * 0.6, 2 * size, 1.2 * size), 30 * 16, 320 * 16)
    dot(p, 104, 50, 15, QColor("#f3b7c8"))
    dot(p, 104, 50, 7, QColor("#fbe3a4"))


def film(scene: Scene, seconds: int) -> bytes:
    """A scene in that many seconds, below 32, six pictures a second."""
    frames = []
    for number in range(seconds * 6):
        part = number / (seconds * 6)
        shown = picture(480, 300, partial(_small, scene, part), PALE)
        frames.append((round(number * 1000 / 6), vp8(shown, 45)))
    return webm(frames, 480, 300, seconds * 1000)


def _small(scene: Scene, part: float, p: QPainter) -> None:
    p.scale(0.75, 0.75)
    scene(p, part)


# -- all of it ---------------------------------------------------------------------


PICTURES: dict[str, Draw] = {
    **ROBOTS,
    "cuff.png": cuff,
    "clip.png": lambda p: clip(p, 1.0, 1.0, 0.8),
    "strip.png": lambda p: strip(p, blood=False),
    "blood.png": lambda p: strip(p, blood=True),
    "nurse.png": nurse,
    "telephone.png": telephone,
    "quiz.png": quiz,
    "music.png": notes,
    "film.png": screen,
    "story.png": book,
}
FILMS: dict[str, tuple[Scene, int]] = {"sunset.webm": (sunset, 16), "pond.webm": (pond, 16)}
TUNES = {"joy.wav": (JOY, 0.5), "lullaby.wav": (LULLABY, 0.42), "sakura.wav": (SAKURA, 0.4)}


def make(folder: Path) -> list[Path]:
    """Writes every picture, film and tune into ``folder``; the files written."""
    folder.mkdir(parents=True, exist_ok=True)
    write_squares(folder, PICTURES)
    for name, (scene, seconds) in FILMS.items():
        (folder / name).write_bytes(film(scene, seconds))
    for name, (score, beat) in TUNES.items():
        write_sound(folder / name, RATE, tune(score, beat))
    return [folder / name for name in (*PICTURES, *FILMS, *TUNES)]


if __name__ == "__main__":
    tell(make(HERE / "vitals" / "media"))
