"""A screen that is painted in parts: after any edits what would be painted anew."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace
from PySide6.QtCore import QRectF, QSize
from PySide6.QtGui import QImage, QPainter

from situ.document import rbd
from situ.resources import example
from situ_studio.screens import painting
from situ_studio.screens.painted import Painted
from situ_studio.screens.painting import paint_content
from situ_studio.screens.shown import Values, content

MEDIA = example("reception") / "media"
DEVICE = QSize(1280, 800)
RECT = QRectF(0.5, 0.5, 399, 249)

places = st.tuples(*(st.integers(0, 9) for _ in range(2)))
texts = st.sampled_from(["Yes", "No, thank you very much", "{user.name}", "お名前は", ""])
colours = st.sampled_from([None, "#2266cc", "#ffee00"])


@st.composite
def components(draw: st.DrawFn) -> rbd.Component:
    x, y = draw(places)
    box: dict[str, Any] = {
        "id": "c",
        "x": 9.5 * x,
        "y": 9.5 * y,
        "width": float(draw(st.sampled_from([8, 21, 60]))),
        "height": float(draw(st.sampled_from([6, 13, 40]))),
    }
    kind = draw(st.sampled_from(["text", "button", "image", "movie", "input", "list"]))
    if kind == "text":
        return rbd.Text(text=draw(texts), size=draw(st.sampled_from([3, 9])), **box)
    if kind == "button":
        return rbd.Button(text=draw(texts), event="go", fill=draw(colours), **box)
    if kind == "image":
        return rbd.Image(src=draw(st.sampled_from(["robot.png", "gone.png"])), **box)
    if kind == "movie":
        return rbd.Movie(src="clip.webm", **box)
    if kind == "input":
        return rbd.Input(tag="user.name", **box)
    return rbd.List(items="patients", **box)


def seen(
    painted: Painted, screen: rbd.Screen, values: Values, ratio: float, media: Path = MEDIA
) -> QImage:
    image = QImage(round(400 * ratio), round(250 * ratio), QImage.Format.Format_ARGB32)
    image.setDevicePixelRatio(ratio)
    image.fill(0xFF808080)
    painter = QPainter(image)
    painted.paint(painter, RECT, content(screen, (), values), media, DEVICE)
    painter.end()
    return image


def farthest(one: QImage, other: QImage) -> int:
    """By how much a colour of a px differs most, inside the edge that widgets draw."""
    inside = one.rect().adjusted(2, 2, -2, -2)
    a, b = (bytes(image.copy(inside).constBits()) for image in (one, other))
    off = 0
    # Most of it is the same.
    for at in range(0, len(a), 64):
        if a[at : at + 64] != b[at : at + 64]:
            both = zip(a[at : at + 64], b[at : at + 64], strict=True)
            off = max(off, *(abs(x - y) for x, y in both))
    return off


@settings(max_examples=15, deadline=None)
@given(st.lists(components(), min_size=1, max_size=8), st.data())
def test_after_any_edits_it_is_what_is_painted_anew(
    qt: Any, first: list[rbd.Component], data: st.DataObject
) -> None:
    every = [replace(one, id=f"c{at}") for at, one in enumerate(first)]
    ratio = data.draw(st.sampled_from([1.0, 1.25, 2.0]))
    painted = Painted()
    for _ in range(4):
        at = data.draw(st.integers(0, len(every) - 1))
        way = data.draw(st.sampled_from(["move", "exchange", "order", "value", "remove"]))
        values = Values({"user.name": "Ana" if way == "value" else "Jack"})
        if way == "move":
            x, y = data.draw(places)
            every[at] = replace(every[at], x=9.5 * x, y=9.5 * y)
        elif way == "exchange":
            every[at] = replace(data.draw(components()), id=every[at].id)
        elif way == "order":
            every.append(every.pop(at))
        elif way == "remove" and len(every) > 1:
            every.pop(at)
        screen = rbd.Screen(components=tuple(every))
        assert seen(painted, screen, values, ratio) == seen(Painted(), screen, values, ratio)


@pytest.fixture
def screen() -> rbd.Screen:
    box: dict[str, Any] = {"width": 30.0, "height": 20.0}
    return rbd.Screen(
        background="lobby.png",
        components=(
            rbd.Text(id="t", text="Hello", x=5, y=5, **box),
            rbd.Button(id="b", text="Yes", event="go", x=40, y=40, **box),
            rbd.Image(id="i", src="robot.png", x=5, y=60, **box),
        ),
    )


def test_it_is_what_a_screen_is_without_it(qt: Any, screen: rbd.Screen) -> None:
    image = QImage(400, 250, QImage.Format.Format_ARGB32)
    image.fill(0xFF808080)
    painter = QPainter(image)
    paint_content(painter, RECT, content(screen), MEDIA, DEVICE)
    painter.end()
    kept = seen(Painted(), screen, Values({}), 1.0)
    assert farthest(image, kept) <= 2


def test_only_what_is_another_is_painted_and_a_file_that_is_written_anew(
    qt: Any, screen: rbd.Screen, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: list[str] = []
    paint = painting._component

    def component(painter: Any, stage: Any, one: Any) -> None:
        told.append(one["id"])
        paint(painter, stage, one)

    monkeypatch.setattr(painting, "_component", component)
    for name in ("robot.png", "lobby.png"):
        shutil.copy(MEDIA / name, tmp_path / name)
    painted = Painted()

    def paint_again(screen: rbd.Screen) -> list[str]:
        told.clear()
        seen(painted, screen, Values({}), 1.0, tmp_path)
        return told

    assert paint_again(screen) == ["t", "b", "i"]
    assert paint_again(screen) == []
    moved = replace(screen.components[0], x=6)
    screen = replace(screen, components=(moved, *screen.components[1:]))
    assert paint_again(screen) == ["t"]
    shutil.copy(MEDIA / "ask.png", tmp_path / "robot.png")
    assert paint_again(screen) == ["i"]
    shutil.copy(MEDIA / "robot.png", tmp_path / "lobby.png")
    assert paint_again(screen) == ["t", "b", "i"]


def test_the_edge_of_a_picture_is_the_same_where_only_what_is_beside_it_is_another(qt: Any) -> None:
    box: dict[str, Any] = {"y": 0.0, "height": 6.0}
    wide = rbd.Image(id="wide", src="robot.png", x=0.0, width=60.0, **box)
    painted = Painted()
    for x in (38.0, 9.5):
        small = rbd.Movie(id="small", src="clip.webm", x=x, width=8.0, **box)
        screen = rbd.Screen(components=(small, wide))
        whole = seen(Painted(), screen, Values({}), 2.0)
        assert seen(painted, screen, Values({}), 2.0) == whole
