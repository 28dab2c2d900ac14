"""Whatever the size of the robot's screen, its texts and buttons fit and look as they are meant."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import pytest
from playwright.async_api import expect
from tests.browser.components import button, component, field, text

from situ.decide.inputs import Finish, Set, Use
from situ.resources import example

pytestmark = pytest.mark.chromium

KIOSK = {"width": 1280, "height": 800}
PHONE = {"width": 390, "height": 844}


@pytest.mark.parametrize("viewport", [KIOSK, PHONE], ids=["kiosk", "phone"])
def test_every_text_fits_its_box(play: Any, viewport: Any) -> None:
    async def scenario(stage: Any) -> None:
        stage.show(
            text("What is the first letter of your first name?", size=14),
            button(text="Unterbrechungsfreie Messung", size=12),
            button("no", "それではまたあとでお願いします", 54, size=12),
        )
        await expect(stage.component("no")).to_be_visible()
        await stage.page.evaluate(
            "document.fonts.ready.then(() => new Promise(requestAnimationFrame))"
        )
        for name in ("hello", "yes", "no"):
            over = await stage.component(name).evaluate(
                """one => {
                    const box = one.getBoundingClientRect();
                    const inner = one.firstElementChild;
                    return [inner.scrollWidth - box.width, inner.scrollHeight - box.height];
                }"""
            )
            assert max(over) <= 1

    play(scenario, viewport=viewport)


def test_a_text_that_fits_at_no_size_is_cut_at_its_box(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        stage.show(text("W" * 20_000, "huge"), text("short", "other", y=60))
        await expect(stage.component("huge")).to_have_attribute("data-cut", "true")
        cut = "one => getComputedStyle(one).overflow + getComputedStyle(one).alignItems"
        assert await stage.component("huge").evaluate(cut) == "hiddenflex-start"
        # Once it is short enough nothing of that stays.
        stage.show(text("short", "huge"), text("short", "other", y=60))
        await expect(stage.component("huge")).not_to_have_attribute("data-cut", "true")

    play(scenario)


def test_buttons_that_are_alike_are_written_alike(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        words = ("Medication and everything else", "Games", "TV")
        stage.show(
            *(button(f"b{n}", word, 2 + n * 20, width=18) for n, word in enumerate(words)),
            button("large", "Help", 64, width=34),
        )
        await expect(stage.component("large")).to_be_visible()
        sizes = await stage.page.evaluate(
            "[...document.querySelectorAll('.button')].map(one => parseFloat(one.style.fontSize))"
        )
        assert len(set(sizes[:3])) == 1
        assert sizes[3] > sizes[0]

    play(scenario)


def test_default_looks_tell_the_answer_from_the_others(play: Any) -> None:
    async def looks(stage: Any) -> list[str]:
        found: list[str] = await stage.page.evaluate(
            "[...document.querySelectorAll('.button')].map(one => one.dataset.look)"
        )
        return found

    async def scenario(stage: Any) -> None:
        stage.show(button(), button("no", "NO", 54), button("home", fill="#ffeeaa"))
        await expect(stage.component("home")).to_be_visible()
        assert await looks(stage) == ["filled", "outlined", "given"]
        # Dark letters on a light colour, where only the colour is given.
        await expect(stage.component("home")).to_have_css("color", "rgb(21, 34, 59)")
        stage.show(*(button(name, name, y=20 * place) for place, name in enumerate("abcd")))
        await expect(stage.component("d")).to_be_visible()
        assert await looks(stage) == ["outlined"] * 4
        # As in a quiz; larger than the others, it is the one most people want.
        stage.show(*(button(name, name, y=20 * place) for place, name in enumerate("abc")))
        await expect(stage.component("d")).to_have_count(0)
        assert await looks(stage) == ["outlined"] * 3
        larger = button("a", "a", width=60)
        stage.show(larger, *(button(name, name, y=20 * place) for place, name in enumerate("bc")))
        await expect(stage.component("a")).to_have_attribute("data-look", "filled")
        assert await looks(stage) == ["filled", "outlined", "outlined"]

    play(scenario)


def test_turned_to_portrait_and_back_everything_stays_and_can_be_used(
    play: Any, media: Path
) -> None:
    for name in ("robot.png", "clip.webm"):
        shutil.copy(example("reception") / "media" / name, media)
    inside = """() => {
        const { right, bottom } = document.getElementById("stage").getBoundingClientRect();
        return [...document.querySelectorAll(".component")].filter((one) => {
            const box = one.getBoundingClientRect();
            const inner = one.matches(".text, .button") ? one.firstElementChild : one;
            return box.x < 0 || box.y < 0 || box.right > right + 1 || box.bottom > bottom + 1
                || inner.scrollWidth > one.clientWidth + 1
                || (inner !== one && inner.scrollHeight > one.clientHeight + 1);
        }).map((one) => one.dataset.id);
    }"""

    async def scenario(stage: Any) -> None:
        page = stage.page
        stage.show(
            component("text", "hello", 4, 2, 60, 16, text="Good morning! How are you?", size=9),
            component("image", "robot", 66, 2, 30, 30, src="robot.png"),
            component("movie", "clip", 4, 20, 28, 26, src="clip.webm"),
            field(event="e", tag="n", x=34, y=34, width=62, height=14),
            component(
                "list", "names", 34, 50, 62, 20, event="c",
                items=[{"label": one, "value": one} for one in ("Ann", "Bob")],
            ),
            component("button", "yes", 4, 74, 44, 22, text="YES", event="y"),
            component("button", "no", 52, 74, 44, 22, text="NO", event="n"),
            actions=(7,),
        )  # fmt: skip
        await page.wait_for_function("() => document.querySelector('video')?.currentTime > 0")
        # It must not end before it is told to.
        await page.locator("video").evaluate("one => { one.playbackRate = 0.0625; }")
        await page.evaluate("document.querySelectorAll('.component').forEach(n => n.mark = 1)")
        await page.keyboard.type("Ann")
        for viewport in (PHONE, {"width": 800, "height": 1280}, KIOSK):
            await page.set_viewport_size(viewport)
            await page.evaluate(
                "new Promise(done => requestAnimationFrame(() => setTimeout(done)))"
            )
            assert await page.evaluate(inside) == []
            await expect(stage.component("name").locator("input")).to_have_value("Ann")
            await stage.component("yes").click()
            said = [await stage.next()]
            if said == [Set({"n": "Ann"}, "screen")]:  # typed, and then left
                said = [await stage.next()]
            assert said == [Use("yes")]
            await page.get_by_text("Bob").click()
            assert await stage.next() == Use("names", "Bob")
            await stage.component("name").locator("input").focus()
            await page.keyboard.press("Enter")
            assert await stage.next() == Use("name", "Ann")
        assert await page.evaluate(
            "[...document.querySelectorAll('.component')].every(n => n.mark)"
        )
        # The movie has not begun anew, and ends once.
        await page.locator("video").evaluate("one => { one.playbackRate = 16; }")
        assert await stage.next() == Finish(id=7)
        assert stage.nothing_more()

    play(scenario)
