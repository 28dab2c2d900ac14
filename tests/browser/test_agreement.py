"""What the editor paints of a screen beside what the robot's page shows of it (docs/screen.md)."""

from __future__ import annotations

import random
import shutil
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QImage, QPainter, QTransform
from PySide6.QtWidgets import QApplication

from situ.decide.screens import Shown
from situ.document import rbd
from situ.resources import example
from situ_studio.looks.application import application
from situ_studio.screens import input_painting, list_painting
from situ_studio.screens.component_painting import Stage
from situ_studio.screens.css_colours import css_colour
from situ_studio.screens.painting import layer, paint_content
from situ_studio.screens.shown import Content, content

pytestmark = pytest.mark.chromium

SIZES = ((1280, 800), (1024, 600), (800, 1280))
_SMOOTH = Qt.TransformationMode.SmoothTransformation
NEAR = 2
"""px by which edges may lie apart."""
VALUES = {
    "user.name": "Mrs. Yamada",
    "user": {"age": 81.0},
    "pin": "1234",
    "initial": "K",
    "patients": [{"name": f"Person {number}", "room": number} for number in range(20)],
    "meals": ["Soup", "Potatoes with a good deal of herring", "今日は魚の定食です"],
}


def at(x: float, y: float, width: float, height: float, name: str, **more: Any) -> dict[str, Any]:
    return {"id": name, "x": x, "y": y, "width": width, "height": height} | more


WORDS = rbd.Screen(
    components=(
        rbd.Text(
            **at(5, 3, 60, 16, "title", size=9.0), text="Good morning! How are you, {user.name}?"
        ),
        rbd.Text(
            **at(5, 22, 40, 20, "body", size=6.0),
            text="Please tell me your name, and I look for your appointment.\nThen  sit\tdown.",
        ),
        rbd.Text(
            **at(5, 45, 40, 8, "hint", size=4.0, align="right"), text="At {user.age} well-known"
        ),
        rbd.Text(
            **at(50, 22, 45, 18, "japanese", size=7.0, align="center"),
            text="今日は良い天気ですね。庭でお茶を飲みましょう。",
        ),
        rbd.Text(
            **at(50, 45, 45, 10, "filled", fill="#ffeeaa", align="center"), text="With a fill"
        ),
        rbd.Text(**at(5, 53, 20, 7, "below", size=2.5), text="{nobody}\nBelow"),
        rbd.Text(**at(70, 3, 28, 16, "long"), text="W" * 300),
        rbd.Text(**at(55, 80, 20, 14, "empty"), text=""),
        rbd.Button(**at(5, 60, 28, 15, "yes"), text="YES", event="e"),
        rbd.Button(**at(36, 60, 28, 15, "no"), text="NO, not today, thank you", event="e"),
        rbd.Button(**at(67, 60, 28, 15, "given", fill="#cceecc"), text="それではまたあとで"),
        rbd.Button(**at(5, 80, 20, 14, "word", size=12.0), text="Unterbrechungsfreie Messung"),
        rbd.Button(**at(30, 80, 20, 14, "left", color="#b3261e", align="left"), text="Coloured"),
    )
)  # fmt: skip
ALWAYS = (rbd.Button(**at(78, 82, 18, 12, "home", fill="teal"), text="Home", event="home"),)
THINGS = rbd.Screen(
    background="lobby.png",
    components=(
        rbd.Input(**at(5, 5, 40, 12, "name"), tag="user.name", event="e"),
        rbd.Input(**at(50, 5, 20, 12, "pin"), tag="pin", kind="pin"),
        rbd.Input(**at(75, 5, 10, 20, "one", fill="#ffeeaa"), tag="initial", max=1, event="e"),
        rbd.Input(**at(88, 5, 10, 12, "none"), tag="nothing"),
        rbd.List(
            **at(5, 30, 40, 55, "over"), items="patients", label="{item.name}, room {item.room}"
        ),
        rbd.List(
            **at(50, 30, 20, 55, "few", size=4.0, align="center", fill="#e4edfb"), items="meals"
        ),
        rbd.Image(**at(75, 30, 20, 25, "wide", align="right"), src="robot.png"),
        rbd.Image(**at(75, 60, 20, 25, "gone", fill="#cceecc"), src="none.png"),
    ),
)  # fmt: skip


def chance(seed: int) -> rbd.Screen:
    """Any screen: texts of any length and size in boxes of any size, lists, inputs."""
    draw = random.Random(seed)
    some = [
        "tea", "at", "Unterbrechung", "blood-pressure", "I", "medication,", "8:30", "AVATAR",
        "お茶を飲みましょう", "診察予約", "ジョンさん、", "と", "{user.name}",
    ]  # fmt: skip

    def words() -> str:
        return draw.choice([" ", "", "\n", " "]).join(draw.choices(some, k=draw.randint(1, 12)))

    def place(number: int) -> dict[str, Any]:
        width, height = draw.uniform(6, 70), draw.uniform(5, 40)
        size = draw.choice([None, round(draw.uniform(2, 14), 1)])
        return at(
            draw.uniform(0, 100 - width), draw.uniform(0, 100 - height), width, height,
            f"c{seed}-{number}", size=size, align=draw.choice([None, "left", "center", "right"]),
            fill=draw.choice([None, None, "#123"]),
        )  # fmt: skip

    made: list[rbd.Component] = []
    for number in range(10):
        match draw.randrange(8):
            case 0 | 1 | 2:
                made.append(rbd.Text(**place(number), text=words()))
            case 3 | 4 | 5:
                made.append(rbd.Button(**place(number), text=words(), event="e"))
            case 6:
                made.append(rbd.List(**place(number), items="meals"))
            case _:
                event = draw.choice([None, "e"])
                made.append(rbd.Input(**place(number), tag="user.name", event=event))
    return rbd.Screen(components=tuple(made))


SCREENS = (content(WORDS, ALWAYS, VALUES), content(THINGS, (), VALUES))
"""At every size, px by px too."""
CHANCE = tuple(content(chance(seed), (), VALUES) for seed in range(12))
"""Each at one size."""

DECODED = "Promise.all([...document.images].map((one) => one.decode().catch(() => null)))"
MEASURED = """() => Object.fromEntries([...document.querySelectorAll(".component")].map((one) => {
    const box = (node) => {
        const { x, y, width, height } = node.getBoundingClientRect();
        return [x, y, width, height];
    };
    const lines = new Map();
    if (one.matches(".text, .button")) {
        for (const whole of one.querySelectorAll(".whole")) {
            for (const { top } of whole.getClientRects()) {
                const line = Math.round(top);
                lines.set(line, (lines.get(line) ?? "") + whole.textContent);
            }
        }
    }
    return [one.dataset.id, {
        box: box(one),
        size: parseFloat(getComputedStyle(one.querySelector("input") ?? one).fontSize),
        lines: [...lines.keys()].sort((a, b) => a - b).map((top) => lines.get(top)),
        rows: [...one.querySelectorAll(".item")].map(box),
        enter: [...one.querySelectorAll(".enter")].map(box).filter(([, , width]) => width > 0),
    }];
}))"""


@pytest.fixture(scope="module")
def qt() -> QApplication:
    """The studio's application, with its fonts."""
    return application()


def painted(shown: Content, size: QSize, media: Path) -> QImage:
    image = QImage(size, QImage.Format.Format_RGB32)
    image.fill(Qt.GlobalColor.white)
    painter = QPainter(image)
    paint_content(painter, QRectF(0, 0, size.width(), size.height()), shown, media, size)
    painter.end()
    return image


def apart(one: QRectF, box: list[float]) -> float:
    ours = (one.left(), one.top(), one.width(), one.height())
    return max(abs(a - b) for a, b in zip(ours, box, strict=True))


def check(stage: Stage, one: Shown, found: dict[str, Any]) -> None:
    """The component stands on the page where it is painted, and its letters do."""
    assert apart(stage.box(one), found["box"]) <= NEAR
    if one["type"] in ("text", "button"):
        fitted = stage.fitted(one)
        if fitted.parted == "anywhere" and one["id"] != "long":
            return  # a browser has ways of its own of parting a word
        assert found["size"] == pytest.approx(fitted.size, abs=1)
        lines = [line.text.replace(" ", "") for line in stage.lines(one)]
        assert len(found["lines"]) == len([line for line in lines if line])
        if fitted.parted != "anywhere":
            assert found["lines"] == [line for line in lines if line]
    elif one["type"] == "list":
        assert found["size"] == pytest.approx(list_painting.size(stage, one), abs=1)
        rows = list_painting.rows(stage, one)
        assert rows
        for row, box in zip(rows, found["rows"], strict=False):
            assert apart(row.box, box) <= NEAR
    elif one["type"] == "input":
        room, enter = input_painting.rooms(stage, one, str(one["value"] or ""))
        assert found["size"] == pytest.approx(input_painting.letters(stage, one, room), abs=1)
        assert len(found["enter"]) == (enter is not None)
        if enter is not None:
            assert apart(enter, found["enter"][0]) <= NEAR


def ink(image: QImage, box: QRectF) -> list[int]:
    """The first and the last row and column inside a component in which there is more than its
    ground."""
    inside = image.copy(box.toAlignedRect().adjusted(5, 5, -5, -5))
    grey = inside.convertToFormat(QImage.Format.Format_Grayscale8)
    found: list[int] = []
    for way in (grey, grey.transformed(QTransform().rotate(-90))):
        shades, line, wide = bytes(way.constBits()), way.bytesPerLine(), way.width()
        rows = [shades[y * line : y * line + wide] for y in range(way.height())]
        inked = [y for y, row in enumerate(rows) if max(row) - min(row) > 60]
        found += [inked[0], inked[-1]] if inked else [-1, -1]
    return found


def without(image: QImage, boxes: list[QRectF]) -> QImage:
    """The picture with these left out."""
    painter = QPainter(image)
    for box in boxes:
        painter.fillRect(box.adjusted(-1, -1, 1, 1), Qt.GlobalColor.white)
    painter.end()
    return image


def furthest(one: QImage, other: QImage) -> int:
    """How far the colours of two pictures are apart, seen from far."""
    shades: list[bytes] = []
    for image in (one, other):
        far = image.convertToFormat(QImage.Format.Format_RGB32).scaled(
            image.width() // 16, image.height() // 16, mode=_SMOOTH
        )
        shades.append(bytes(far.constBits()))
    one_shades, other_shades = shades
    return max(abs(a - b) for a, b in zip(one_shades, other_shades, strict=True))


def test_the_editor_paints_what_the_page_shows(play: Any, media: Path, qt: QApplication) -> None:
    for name in ("robot.png", "lobby.png"):
        shutil.copy(example("reception") / "media" / name, media)

    async def scenario(stage: Any) -> None:
        page = stage.page
        await page.evaluate("Promise.all([...document.fonts].map((face) => face.load()))")
        for turn, (wide, high) in enumerate(SIZES):
            await page.set_viewport_size({"width": wide, "height": high})
            size = QSize(wide, high)
            for shown in (*SCREENS, *CHANCE[turn::3]):
                stage.show(*shown.components, background=shown.background)
                last = shown.components[-1]["id"]
                await stage.component(last).wait_for(state="attached")
                found = await page.evaluate(MEASURED)
                ours = Stage(layer(size), shown, media)
                for one in shown.components:
                    try:
                        check(ours, one, found[one["id"]])
                    except AssertionError as wrong:
                        raise AssertionError(f"{one}\nat {wide} x {high}: {wrong}") from wrong
                if shown in SCREENS:
                    await page.evaluate(DECODED)
                    seen = QImage.fromData(await page.screenshot(animations="disabled"))
                    picture = painted(shown, size, media)
                    for one in shown.components:
                        if one["type"] not in ("list", "image"):
                            box = ours.box(one)
                            theirs = ink(seen, box)
                            assert ink(picture, box) == pytest.approx(theirs, abs=NEAR), one
                    # The editor marks a picture that is missing.
                    gone = [ours.box(one) for one in shown.components if one["id"] == "gone"]
                    assert furthest(without(seen, gone), without(picture, gone)) < 30

    play(scenario)


def test_dates_are_asked_for_as_the_page_asks_for_them(play: Any) -> None:
    languages = (
        "en", "en-GB", "en_GB", "de", "de-AT", "fr", "fr-CA", "es", "it", "nl", "pt", "sv", "da",
        "nb", "fi", "pl", "cs", "tr", "ru", "el", "hu", "ja", "zh", "ko", "th", "xx", "",
    )  # fmt: skip
    asked = """async (languages) => {
        const { datePattern } = await import("/page/dates.js");
        return languages.map((one) => {
            document.documentElement.lang = one;
            return datePattern();
        });
    }"""

    async def scenario(stage: Any) -> None:
        theirs = await stage.page.evaluate(asked, languages)
        assert {one: input_painting.date("", one) for one in languages} == dict(
            zip(languages, theirs, strict=True)
        )

    play(scenario)


def test_colours_are_read_as_the_page_reads_them(play: Any, qt: QApplication) -> None:
    written = [
        "#abc", "#a1b2c3", "#abcd", "#a1b2c380", "Teal", "transparent", "rgb(1, 2, 3)",
        "rgb(10% 20% 30% / 50%)", "rgba(9,8,7,.5)", "hsl(120, 50%, 25%)",
        "hsla(200deg 10% 90% / 1)", "nonsense", "#12345", "rgb(1,2)", "", "url(x)",
    ]  # fmt: skip
    read = """(written) => written.map((text) => {
        if (!CSS.supports("color", text)) return null;
        const dot = document.createElement("canvas").getContext("2d");
        dot.fillStyle = text;
        dot.fillRect(0, 0, 1, 1);
        return [...dot.getImageData(0, 0, 1, 1).data];
    })"""

    async def scenario(stage: Any) -> None:
        for text, theirs in zip(written, await stage.page.evaluate(read, written), strict=True):
            ours = css_colour(text)
            if theirs is None or ours is None:
                assert ours is None, text
                assert theirs is None, text
            elif theirs[3]:
                assert ours.getRgb() == pytest.approx(tuple(theirs), abs=2), text
            else:
                assert ours.alpha() == 0, text

    play(scenario)
