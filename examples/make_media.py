"""Draws the examples' pictures, movie and sound: ``python examples/make_media.py``.

Everything that the examples show or play is made here, so that no picture of
unknown origin is in the repository and anybody can change one. It needs PySide6
(``pip install .[studio]``) and no display, no typeface and no network: no picture
holds text, because texts are translated and pictures are not. The same version of
Qt writes the same bytes; another one writes files that look the same.
"""

from __future__ import annotations

import math
import struct
import sys
import wave
from array import array
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QPointF, QRectF, Qt
from PySide6.QtGui import (
    QColor,
    QImage,
    QImageWriter,
    QLinearGradient,
    QPainter,
    QPainterPath,
    QPen,
)

HERE = Path(__file__).resolve().parent

INK = QColor("#1d3a86")
ACCENT = QColor("#1f4fc4")
PALE = QColor("#e3ecfb")
SOFT = QColor("#c5d6f6")
PAPER = QColor("#ffffff")
SKIN = QColor("#f0c9a8")
SKIN_LINE = QColor("#a86f48")
RED = QColor("#d3342b")

Draw = Callable[[QPainter], None]


# -- drawing -----------------------------------------------------------------


def picture(width: int, height: int, draw: Draw, ground: QColor | None = None) -> QImage:
    """What ``draw`` draws, in pixels, origin top left; without ground transparent."""
    kind = QImage.Format.Format_ARGB32 if ground is None else QImage.Format.Format_RGB32
    image = QImage(width, height, kind)
    image.fill(QColor(0, 0, 0, 0) if ground is None else ground)
    painter = QPainter(image)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    draw(painter)
    painter.end()
    return image


def line(color: QColor, width: float) -> QPen:
    return QPen(
        color,
        width,
        Qt.PenStyle.SolidLine,
        Qt.PenCapStyle.RoundCap,
        Qt.PenJoinStyle.RoundJoin,
    )


def box(p: QPainter, x: float, y: float, w: float, h: float, radius: float, fill: QColor) -> None:
    p.setBrush(fill)
    p.drawRoundedRect(QRectF(x, y, w, h), radius, radius)


def dot(p: QPainter, x: float, y: float, radius: float, fill: QColor) -> None:
    p.setBrush(fill)
    p.drawEllipse(QPointF(x, y), radius, radius)


def curve(*points: tuple[float, float]) -> QPainterPath:
    """A path from the first point through cubic curves: then three points each."""
    path = QPainterPath(QPointF(*points[0]))
    for i in range(1, len(points), 3):
        path.cubicTo(*(QPointF(*q) for q in points[i : i + 3]))
    return path


# -- the pictures, each in a square of 600, but for the background -------------


def tile(p: QPainter) -> None:
    p.setPen(Qt.PenStyle.NoPen)
    box(p, 0, 0, 600, 600, 40, PALE)


def robot(p: QPainter, *, smile: float = 1.0, waving: bool = True) -> None:
    """The robot nurse, head to waist. smile: 1 happy, 0 serious, -1 sorry."""
    p.setPen(line(INK, 10))
    # the arm lies behind the body
    p.setBrush(Qt.BrushStyle.NoBrush)
    if waving:
        p.drawPath(curve((410, 480), (480, 490), (490, 400), (494, 350)))
        dot(p, 496, 322, 28, PAPER)
        p.setPen(line(ACCENT, 9))
        p.setBrush(Qt.BrushStyle.NoBrush)
        p.drawArc(QRectF(470, 272, 84, 100), -46 * 16, 92 * 16)
        p.drawArc(QRectF(470, 246, 116, 152), -42 * 16, 84 * 16)
        p.setPen(line(INK, 10))
    else:
        p.drawPath(curve((410, 480), (450, 500), (456, 540), (450, 600)))
    p.drawPath(curve((190, 480), (150, 500), (144, 540), (150, 600)))
    # body
    body = QPainterPath(QPointF(170, 600))
    body.cubicTo(QPointF(166, 470), QPointF(220, 430), QPointF(300, 430))
    body.cubicTo(QPointF(380, 430), QPointF(434, 470), QPointF(430, 600))
    p.setBrush(PAPER)
    p.drawPath(body)
    box(p, 262, 392, 76, 40, 10, SOFT)
    # a heart where a nurse wears her badge
    p.setPen(Qt.PenStyle.NoPen)
    heart(p, 300, 520, 34, RED)
    # head
    p.setPen(line(INK, 10))
    p.drawLine(QPointF(300, 150), QPointF(300, 96))
    dot(p, 300, 82, 20, ACCENT)
    box(p, 150, 220, 34, 90, 12, SOFT)
    box(p, 416, 220, 34, 90, 12, SOFT)
    box(p, 176, 150, 248, 240, 62, PAPER)
    p.setPen(Qt.PenStyle.NoPen)
    box(p, 206, 190, 188, 150, 46, INK)
    for x in (262, 338):
        dot(p, x, 250, 17, PAPER)
        dot(p, x + 5, 245, 6, SOFT)
    p.setPen(line(PAPER, 9))
    p.setBrush(Qt.BrushStyle.NoBrush)
    bend = 26 * smile
    middle = 300 - bend * 0.3
    p.drawPath(curve((262, middle), (280, middle + bend), (320, middle + bend), (338, middle)))
    if smile < 0:  # eyebrows
        p.drawLine(QPointF(244, 214), QPointF(270, 206))
        p.drawLine(QPointF(356, 214), QPointF(330, 206))


def robot_on_tile(p: QPainter, *, smile: float, waving: bool) -> None:
    tile(p)
    p.setClipRect(QRectF(0, 0, 600, 600))
    if waving:
        p.translate(-24, 0)
    robot(p, smile=smile, waving=waving)


def heart(p: QPainter, x: float, y: float, size: float, fill: QColor) -> None:
    """A heart whose middle is at x, y; size is half its width."""
    s = size
    path = QPainterPath(QPointF(x, y + 0.9 * s))
    path.cubicTo(
        QPointF(x - 1.5 * s, y - 0.1 * s),
        QPointF(x - 0.9 * s, y - 1.15 * s),
        QPointF(x, y - 0.4 * s),
    )
    path.cubicTo(
        QPointF(x + 0.9 * s, y - 1.15 * s),
        QPointF(x + 1.5 * s, y - 0.1 * s),
        QPointF(x, y + 0.9 * s),
    )
    p.setBrush(fill)
    p.drawPath(path)


def cards(p: QPainter, highlighted: int | None) -> None:
    """Three cards of a card index, each a person."""
    for i in range(3):
        y = 92 + i * 146
        chosen = i == highlighted
        p.setPen(line(ACCENT if chosen else INK, 10))
        box(p, 80, y, 440, 120, 24, SOFT if chosen else PAPER)
        p.setPen(Qt.PenStyle.NoPen)
        dot(p, 148, y + 46, 19, INK)
        shoulders = QPainterPath(QPointF(112, y + 98))
        shoulders.cubicTo(QPointF(116, y + 62), QPointF(180, y + 62), QPointF(184, y + 98))
        p.setBrush(INK)
        p.drawPath(shoulders)
        p.setPen(line(INK, 14))
        p.drawLine(QPointF(226, y + 44), QPointF(430, y + 44))
        p.setPen(line(SOFT if not chosen else PAPER, 14))
        p.drawLine(QPointF(226, y + 80), QPointF(360, y + 80))


def search(p: QPainter) -> None:
    tile(p)
    cards(p, None)
    p.setPen(line(INK, 52))
    p.drawLine(QPointF(456, 456), QPointF(540, 540))
    p.setPen(line(ACCENT, 32))
    p.drawLine(QPointF(456, 456), QPointF(540, 540))
    p.setPen(line(INK, 14))
    glass = QColor(PAPER)
    glass.setAlpha(150)
    dot(p, 380, 380, 106, glass)


def write(p: QPainter) -> None:
    tile(p)
    p.setPen(line(INK, 10))
    box(p, 100, 70, 340, 460, 28, PAPER)
    box(p, 196, 44, 148, 58, 18, SOFT)
    for y, to in ((180, 370), (250, 370), (320, 300)):
        p.setPen(line(SOFT, 16))
        p.drawLine(QPointF(160, y), QPointF(to, y))
    p.setPen(line(ACCENT, 10))
    p.setBrush(Qt.BrushStyle.NoBrush)
    p.drawPath(
        curve((160, 430), (190, 370), (214, 370), (214, 420), (214, 460), (250, 400), (276, 400))
    )
    p.save()
    p.translate(276, 404)
    p.rotate(42)
    p.setPen(line(INK, 10))
    tip = QPainterPath(QPointF(0, 0))
    tip.lineTo(-26, -64)
    tip.lineTo(26, -64)
    tip.closeSubpath()
    p.setBrush(SKIN)
    p.drawPath(tip)
    box(p, -26, -300, 52, 236, 8, ACCENT)
    box(p, -26, -330, 52, 46, 16, QColor("#f3b7b1"))
    p.restore()


def measure(p: QPainter) -> None:
    tile(p)
    p.setPen(Qt.PenStyle.NoPen)
    heart(p, 300, 300, 186, RED)
    p.setPen(line(PAPER, 20))
    p.setBrush(Qt.BrushStyle.NoBrush)
    pulse = QPainterPath(QPointF(136, 296))
    for x, y in ((226, 296), (262, 210), (318, 390), (356, 262), (380, 296), (464, 296)):
        pulse.lineTo(x, y)
    p.drawPath(pulse)


def ask(p: QPainter) -> None:
    """The robot asks whether it may show names: cards with a lock."""
    tile(p)
    cards(p, None)
    p.setPen(line(INK, 26))
    p.setBrush(Qt.BrushStyle.NoBrush)
    p.drawArc(QRectF(352, 240, 116, 160), 0, 180 * 16)
    p.setPen(line(INK, 10))
    box(p, 310, 322, 200, 176, 30, ACCENT)
    p.setPen(Qt.PenStyle.NoPen)
    dot(p, 410, 394, 24, PAPER)
    box(p, 400, 400, 20, 56, 10, PAPER)


def clip(p: QPainter, moved: float, closed: float, glow: float) -> None:
    """A finger and a pulse oximeter from the side, in 600 by 600.

    moved: 0 the finger is outside, 1 inside; closed: 0 the clip is open, 1 shut;
    glow: 0 to 1, the red light through the finger.
    """
    tile(p)
    tip = 250 + 130 * moved
    opening = 22 * (1 - closed)
    # lower jaw
    p.save()
    p.translate(520, 330)
    p.rotate(-opening)
    p.setPen(line(INK, 10))
    box(p, -250, 26, 262, 92, 34, PAPER)
    p.restore()
    # hand: the bent fingers, then the one that is measured
    p.setPen(line(SKIN_LINE, 8))
    box(p, -60, 226, tip - 130, 206, 66, SKIN)
    for i in range(3):
        box(p, tip - 220, 360 + i * 40, 96, 46, 23, SKIN)
    box(p, tip - 330, 292, 330, 76, 38, SKIN)
    p.setPen(line(SKIN_LINE, 5))
    box(p, tip - 60, 300, 50, 30, 15, QColor("#f9e3d3"))
    if glow > 0:
        p.setPen(Qt.PenStyle.NoPen)
        for radius, part in ((84, 0.18), (58, 0.28), (34, 0.55)):
            light = QColor(RED)
            light.setAlphaF(part * glow)
            dot(p, 352, 330, radius, light)
    # upper jaw with its small display
    p.save()
    p.translate(520, 330)
    p.rotate(opening)
    p.setPen(line(INK, 10))
    box(p, -250, -132, 262, 106, 34, PAPER)
    p.setPen(Qt.PenStyle.NoPen)
    box(p, -196, -112, 150, 62, 14, INK)
    p.setPen(line(QColor("#4ade9c") if glow > 0 else SOFT, 7))
    p.setBrush(Qt.BrushStyle.NoBrush)
    pulse = QPainterPath(QPointF(-180, -80))
    height = 24 * glow
    for x, y in ((-150, 0.0), (-136, -1.0), (-118, 0.9), (-104, 0.0), (-64, 0.0)):
        pulse.lineTo(x, -80 + y * height)
    p.drawPath(pulse)
    p.setPen(line(INK, 10))
    dot(p, -8, 0, 26, SOFT)
    p.restore()


def lobby(p: QPainter) -> None:
    """The background of the start screen, 1280 by 800: pale, texts stand on its left."""
    sky = QLinearGradient(0, 0, 0, 800)
    sky.setColorAt(0, QColor("#f6f9fe"))
    sky.setColorAt(1, QColor("#e6eefb"))
    p.setPen(Qt.PenStyle.NoPen)
    p.fillRect(QRectF(0, 0, 1280, 800), sky)
    p.fillRect(QRectF(0, 664, 1280, 136), QColor("#d5e2f8"))
    # a window with a hill and the sun
    p.setPen(line(SOFT, 12))
    box(p, 860, 64, 330, 276, 20, PAPER)
    p.setPen(Qt.PenStyle.NoPen)
    dot(p, 1110, 140, 34, QColor("#fbe3a4"))
    hill = QPainterPath(QPointF(866, 334))
    hill.cubicTo(QPointF(930, 220), QPointF(1010, 250), QPointF(1050, 290))
    hill.cubicTo(QPointF(1090, 250), QPointF(1150, 260), QPointF(1184, 334))
    hill.closeSubpath()
    p.setBrush(QColor("#cfe8d9"))
    p.drawPath(hill)
    p.setPen(line(SOFT, 10))
    p.drawLine(QPointF(1025, 76), QPointF(1025, 334))
    # a plant
    p.setPen(Qt.PenStyle.NoPen)
    x, soil = 826, 566
    for lean in (-54, -20, 18, 52):
        leaf = QPainterPath(QPointF(x, soil))
        leaf.cubicTo(
            QPointF(x + lean * 1.9, soil - 40),
            QPointF(x + lean * 1.6, soil - 120),
            QPointF(x + lean, soil - 160),
        )
        leaf.cubicTo(
            QPointF(x + lean * 0.5, soil - 110), QPointF(x + 2, soil - 40), QPointF(x, soil)
        )
        p.setBrush(QColor("#a9d5bd"))
        p.drawPath(leaf)
    p.setPen(line(SOFT, 8))
    box(p, x - 48, soil - 4, 96, 124, 14, PAPER)
    # the robot, without its tile
    p.save()
    p.translate(830, 356)
    p.scale(0.74, 0.74)
    robot(p)
    p.restore()


# -- movie: key frames of VP8, as WebP has them, in a WebM ---------------------


def vp8(image: QImage, quality: int) -> bytes:
    """One key frame: the payload of the ``VP8`` chunk of a lossy WebP file."""
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    writer = QImageWriter(buffer, QByteArray(b"webp"))
    writer.setQuality(quality)
    if not writer.write(image):
        raise SystemExit("this Qt can not write WebP: install PySide6 with its image formats")
    data = bytes(buffer.data().data())
    at = 12
    while at < len(data):
        name, size = data[at : at + 4], struct.unpack("<I", data[at + 4 : at + 8])[0]
        if name == b"VP8 ":
            return data[at + 8 : at + 8 + size]
        at += 8 + size + (size & 1)
    raise SystemExit("this Qt wrote WebP without a VP8 frame")


def element(name: str, body: bytes | Iterable[bytes]) -> bytes:
    """An EBML element; name is its identifier in hexadecimal, the size takes 8 bytes."""
    content = body if isinstance(body, bytes) else b"".join(body)
    return bytes.fromhex(name) + struct.pack(">Q", len(content) | 1 << 56) + content


def number(name: str, value: int) -> bytes:
    return element(name, value.to_bytes(max(1, (value.bit_length() + 7) // 8), "big"))


def webm(frames: list[tuple[int, bytes]], width: int, height: int, length: int) -> bytes:
    """A WebM (RFC 8794, RFC 9559) of key frames; times and length in ms, below 32 s."""
    head = element(
        "1A45DFA3",
        [
            number("4286", 1),
            number("42F7", 1),
            number("42F2", 4),
            number("42F3", 8),
            element("4282", b"webm"),
            number("4287", 2),
            number("4285", 2),
        ],
    )
    info = element(
        "1549A966",
        [
            number("2AD7B1", 1_000_000),
            element("4489", struct.pack(">d", float(length))),
            element("4D80", b"situ"),
            element("5741", b"situ"),
        ],
    )
    video = element("E0", [number("B0", width), number("BA", height)])
    track = element(
        "AE",
        [
            number("D7", 1),
            number("73C5", 1),
            number("83", 1),
            number("9C", 0),
            element("86", b"V_VP8"),
            video,
        ],
    )
    blocks = [element("A3", b"\x81" + struct.pack(">hB", at, 0x80) + frame) for at, frame in frames]
    cluster = element("1F43B675", [number("E7", 0), *blocks])
    return head + element("18538067", [info, element("1654AE6B", track), cluster])


def finger_clip() -> bytes:
    """Six seconds: the finger goes into the clip, the clip shuts, the light pulses."""
    size, step, length = 480, 100, 6000

    def smooth(x: float) -> float:
        x = min(1.0, max(0.0, x))
        return x * x * (3 - 2 * x)

    frames: list[tuple[int, bytes]] = []
    for at in range(0, length, step):
        t = at / 1000
        moved, closed = smooth((t - 0.6) / 1.4), smooth((t - 2.1) / 0.5)
        beat = 0.6 + 0.4 * math.cos((t - 2.8) * 2 * math.pi * 1.1)
        glow = beat if t > 2.8 else 0.0

        def draw(p: QPainter, m: float = moved, c: float = closed, g: float = glow) -> None:
            p.scale(size / 600, size / 600)
            clip(p, m, c, g)

        frame = vp8(picture(size, size, draw, PALE), 62)
        if not frames or frames[-1][1] != frame:
            frames.append((at, frame))
    return webm(frames, size, size, length)


# -- sound -------------------------------------------------------------------


def chime(path: Path) -> None:
    """Two soft bell tones, 1.1 s: 16 bit, mono, 22,050 Hz."""
    rate, seconds = 22_050, 1.1
    samples = []
    for i in range(int(rate * seconds)):
        t, value = i / rate, 0.0
        for start, pitch in ((0.0, 659.26), (0.22, 880.0)):
            if t >= start:
                u = t - start
                rise = min(1.0, u / 0.008)
                for part, loud, fade in ((1, 1.0, 4.0), (2, 0.28, 7.0), (3, 0.1, 11.0)):
                    value += (
                        rise * loud * math.exp(-fade * u) * math.sin(2 * math.pi * pitch * part * u)
                    )
        end = min(1.0, (seconds - t) / 0.05)
        samples.append(round(9000 * value * end))
    write_sound(path, rate, samples)


def write_sound(path: Path, rate: int, samples: Iterable[int]) -> None:
    """As WAV, mono, 16 bit. rate: samples a second."""
    kept = array("h", samples)
    if sys.byteorder == "big":
        kept.byteswap()
    with wave.open(str(path), "wb") as out:
        out.setnchannels(1)
        out.setsampwidth(2)
        out.setframerate(rate)
        out.writeframes(kept.tobytes())


# -- all of it ---------------------------------------------------------------


ROBOTS: dict[str, Draw] = {
    "robot.png": lambda p: robot_on_tile(p, smile=1, waving=True),
    "sorry.png": lambda p: robot_on_tile(p, smile=-0.6, waving=False),
}
"""As each example shows it."""

PICTURES: dict[str, Draw] = {
    **ROBOTS,
    "ask.png": ask,
    "search.png": search,
    "write.png": write,
    "measure.png": measure,
}


def make(folder: Path) -> list[Path]:
    """Writes every picture, the movie and the sound into ``folder``; the files written."""
    folder.mkdir(parents=True, exist_ok=True)
    write_picture(folder / "lobby.png", picture(1280, 800, lobby))
    write_squares(folder, PICTURES)
    (folder / "clip.webm").write_bytes(finger_clip())
    chime(folder / "chime.wav")
    return [folder / name for name in ("lobby.png", *PICTURES, "clip.webm", "chime.wav")]


def write_squares(folder: Path, pictures: Mapping[str, Draw]) -> None:
    """Each in a square of 600, by file name."""
    for name, draw in pictures.items():
        write_picture(folder / name, picture(600, 600, draw))


def write_picture(path: Path, image: QImage) -> None:
    """Raises SystemExit."""
    if not image.save(str(path)):
        raise SystemExit(f"can not write {path}")


def tell(written: Iterable[Path]) -> None:
    for path in written:
        print(f"{path.relative_to(HERE.parent)}  {path.stat().st_size:,} bytes")


if __name__ == "__main__":
    tell(make(HERE / "reception" / "media"))
