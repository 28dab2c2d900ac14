"""The robot's screen as a person meets it: components seen, touched, typed into, chosen from."""

from __future__ import annotations

import shutil
import time
from pathlib import Path
from typing import Any

import pytest
from playwright.async_api import expect
from tests.browser.components import button, component, field, names, text

from situ.decide.effects import Map
from situ.decide.inputs import Finish, Set, Touch, Use
from situ.resources import example

pytestmark = pytest.mark.chromium


def test_every_component_is_shown_where_the_designer_put_it(play: Any, media: Path) -> None:
    shutil.copy(example("reception") / "media" / "robot.png", media)

    async def scenario(stage: Any) -> None:
        stage.show(
            text("Hello!"),
            button(),
            field(value="Ann"),
            component("image", "robot", 62, 8, 30, 40, src="robot.png"),
            names("Ann", "Bob"),
            background="robot.png",
        )
        for name, (x, y, width, height) in {
            "hello": (8, 10, 60, 20),
            "yes": (8, 68, 38, 22),
            "name": (10, 40, 50, 16),
            "robot": (62, 8, 30, 40),
            "names": (10, 30, 80, 40),
        }.items():
            await expect(stage.component(name)).to_be_visible()
            box = await stage.component(name).bounding_box()
            assert box["x"] == pytest.approx(x * 12.8, abs=1)
            assert box["y"] == pytest.approx(y * 8.0, abs=1)
            assert box["width"] == pytest.approx(width * 12.8, abs=1)
            assert box["height"] == pytest.approx(height * 8.0, abs=1)
        # Text as high as the designer said: 9 percent of 800.
        size = await stage.component("hello").evaluate("one => getComputedStyle(one).fontSize")
        assert float(size.removesuffix("px")) == pytest.approx(72)
        for picture in ("[data-id=robot] img", "#background"):
            await stage.page.wait_for_function(
                "name => document.querySelector(name).naturalWidth > 0", arg=picture
            )

    play(scenario)


def test_every_component_has_its_colours_and_its_side(play: Any, media: Path) -> None:
    for name in ("robot.png", "clip.webm"):
        shutil.copy(example("reception") / "media" / name, media)
    looks: dict[str, Any] = {"fill": "#ffeeaa", "color": "#b3261e", "align": "right"}
    inside = """name => {
        const one = document.querySelector(`[data-id=${name}]`);
        const inner = one.querySelector("img, video, input, .item, span");
        const side = getComputedStyle(inner);
        return inner.matches("img, video") ? side.objectPosition : side.textAlign;
    }"""

    async def scenario(stage: Any) -> None:
        stage.show(
            text("Hello", **looks),
            button(**looks),
            field(**looks),
            names("Ann", **looks),
            component("image", "robot", 70, 0, 30, 20, src="robot.png", **looks),
            component("movie", "clip", 70, 30, 30, 20, src="clip.webm", **looks),
        )
        for name in ("hello", "yes", "name", "names", "robot", "clip"):
            await expect(stage.component(name)).to_have_css(
                "background-color", "rgb(255, 238, 170)"
            )
            side = await stage.page.evaluate(inside, name)
            assert side == ("100% 50%" if name in ("robot", "clip") else "right"), name
        for name in ("hello", "yes", "name", "names"):
            await expect(stage.component(name)).to_have_css("color", "rgb(179, 38, 30)")

    play(scenario)


def test_a_background_that_can_not_be_had_is_left_out(play: Any, media: Path) -> None:
    shutil.copy(example("reception") / "media" / "lobby.png", media)

    async def scenario(stage: Any) -> None:
        background = stage.page.locator("#background")
        # Asked of the page: the browser's driver loses a response on a busy machine.
        stage.show(text("Hello"), background="none.png")
        await expect(background).to_have_attribute("src", "/media/none.png")
        await expect(background).to_have_attribute("hidden", "")
        stage.show(text("Hello again"), background="none.png")
        await expect(stage.component("hello")).to_have_text("Hello again")
        await expect(background).to_be_hidden()
        stage.show(text("Hello"), background="lobby.png")
        await expect(background).to_be_visible()

    play(scenario)


def test_text_is_never_markup(play: Any) -> None:
    evil = '<img src=x onerror="window.hacked=1"><script>window.hacked=1</script>'

    async def scenario(stage: Any) -> None:
        stage.performer.perform(Map("speech", "reception", {"text": evil, "lang": "en"}))
        stage.show(
            text(evil), button(text=evil), names(evil), field(value=evil),
            text("x", "styled", color="red;background:url(x)", fill="url(javascript:1)"),
        )  # fmt: skip
        await expect(stage.component("hello")).to_have_text(evil)
        await expect(stage.component("yes")).to_have_text(evil)
        await expect(stage.component("names")).to_have_text(evil)
        await expect(stage.component("name").locator("input")).to_have_value(evil)
        await expect(stage.page.locator("#caption")).to_have_text(evil)
        assert await stage.page.locator("#components img, #components script").count() == 0
        assert await stage.page.evaluate("window.hacked") is None

    play(scenario, services=("screen", "engine"), captions=True)


def test_a_button_is_used_by_a_click_and_by_the_keyboard(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        stage.show(button(), button("no", "NO", 54))
        await stage.component("yes").click()
        assert await stage.next() == Use("yes")
        await stage.page.keyboard.press("Tab")
        await stage.page.keyboard.press("Enter")
        assert await stage.next() == Use("no")

    play(scenario)


def test_an_input_is_entered_by_enter_and_by_its_own_button(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        stage.show(field(event="entered"), button())
        # The only input has the focus already.
        await expect(stage.component("name").locator("input")).to_be_focused()
        await stage.page.keyboard.type("Ann Marsh")
        await stage.page.keyboard.press("Enter")
        assert await stage.next() == Use("name", "Ann Marsh")
        await stage.page.keyboard.type("all")
        await stage.component("name").get_by_role("button").click()
        assert await stage.next() == Use("name", "Ann Marshall")
        assert stage.nothing_more()

    play(scenario)


def test_an_input_is_entered_when_it_is_full_and_a_single_letter_is_replaced(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        stage.show(field(max=1))
        await expect(stage.component("name").locator("input")).to_be_focused()
        await stage.page.keyboard.type("K")
        assert await stage.next() == Use("name", "K")
        await stage.page.keyboard.type("J")
        assert await stage.next() == Use("name", "J")
        stage.show(field("pin", kind="pin", max=4))
        await expect(stage.component("pin").locator("input")).to_be_focused()
        await stage.page.keyboard.type("12x3")
        assert stage.nothing_more()
        await stage.page.keyboard.type("45")
        assert await stage.next() == Use("pin", "1234")

    play(scenario)


def test_a_number_is_sent_as_a_number_and_what_is_none_is_not_sent(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        stage.show(field("age", kind="number", event="entered"))
        await expect(stage.component("age").locator("input")).to_be_focused()
        await stage.page.keyboard.type("8-1")
        await stage.page.keyboard.press("Enter")
        await expect(stage.component("age")).to_have_class("input component can-enter wrong")
        await stage.component("age").locator("input").fill("81,5")
        await stage.page.keyboard.press("Enter")
        assert await stage.next() == Use("age", 81.5)

    play(scenario)


def test_a_date_is_written_when_chosen_and_entered_by_enter(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        stage.show(field("born", kind="date", event="entered"))
        await stage.component("born").locator("input").fill("1941-05-07")
        assert await stage.next() == Set({"user.born": "1941-05-07"}, "screen")
        await stage.page.keyboard.press("Enter")
        assert await stage.next() == Use("born", "1941-05-07")

    play(scenario)


def test_what_was_typed_is_written_before_the_button_that_confirms_it(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        stage.show(field(event="entered"), button("confirm", "CONFIRM"))
        await stage.component("name").locator("input").fill("Ann")
        await stage.component("confirm").click()
        assert await stage.next() == Set({"user.name": "Ann"}, "screen")
        assert await stage.next() == Use("confirm")
        assert stage.nothing_more()

    play(scenario)


def test_an_item_of_a_list_is_chosen_whole(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        people = [f"Person {number}" for number in range(40)]
        stage.show(names(*people))
        await stage.page.get_by_text("Person 3", exact=True).click()
        assert await stage.next() == Use("names", {"name": "Person 3"})
        # Far below; scrolling there touches nothing.
        await stage.page.get_by_text("Person 37", exact=True).click()
        assert await stage.next() == Use("names", {"name": "Person 37"})

    play(scenario)


def test_a_touch_of_no_component_or_of_a_text_is_a_touch_of_the_screen(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        stage.show(text("Touch the screen"), button(), field())
        await expect(stage.component("hello")).to_be_visible()
        await stage.page.mouse.click(1200, 100)
        assert await stage.next() == Touch()
        await stage.component("hello").click()
        assert await stage.next() == Touch()
        await stage.component("name").click()
        await stage.component("yes").click()
        assert await stage.next() == Use("yes")
        assert stage.nothing_more()

    play(scenario)


def test_the_second_half_of_a_double_tap_does_not_answer_the_next_screen(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        stage.show(text("Are these your initials?"), button())
        await expect(stage.component("yes")).to_be_visible()
        box = await stage.component("yes").bounding_box()
        hand = await stage.page.context.new_cdp_session(stage.page)
        began = time.time()

        async def tap(count: int) -> None:
            # Told when it was made, so that it is a double tap on a slow machine too.
            place = {"x": box["x"] + 50, "y": box["y"] + 50, "button": "left", "clickCount": count}
            for moment, kind in ((0.0, "mousePressed"), (0.05, "mouseReleased")):
                at = {"type": kind, "timestamp": began + moment + 0.2 * (count - 1)}
                await hand.send("Input.dispatchMouseEvent", place | at)

        await tap(1)
        assert await stage.next() == Use("yes")
        stage.show(text("Shall I show names?", "question"), button(), button("no", "NO", 54))
        await expect(stage.component("no")).to_be_visible()
        await tap(2)
        await stage.component("no").click()
        assert await stage.next() == Use("no")

    play(scenario)


def test_a_movie_plays_to_its_end_and_says_so(play: Any, media: Path) -> None:
    shutil.copy(example("reception") / "media" / "clip.webm", media)
    clip = component("movie", "clip", 10, 10, 50, 50, src="clip.webm")

    async def scenario(stage: Any) -> None:
        stage.show(text("One"), clip, actions=(7,))
        video = stage.page.locator("video")
        await video.wait_for()
        await stage.page.wait_for_function("() => document.querySelector('video')?.currentTime > 0")
        # A text that changes does not begin it anew; meanwhile it runs faster than in life.
        await video.evaluate("one => { one.playbackRate = 16; one.mark = 1; }")
        stage.show(text("Two"), clip, actions=(7,))
        assert await stage.next() == Finish(id=7)
        assert await video.evaluate("one => one.mark") == 1
        # The state entered anew is a new action: it plays once more.
        stage.show(text("Two"), clip, actions=(8,))
        assert await stage.next() == Finish(id=8)
        assert stage.nothing_more()

    play(scenario)


def test_a_movie_that_is_missing_fails(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        stage.show(component("movie", "clip", 10, 10, 50, 50, src="gone.webm"), actions=(7,))
        finish = await stage.next()
        assert isinstance(finish, Finish)
        assert (finish.id, finish.ok) == (7, False)

    play(scenario)
