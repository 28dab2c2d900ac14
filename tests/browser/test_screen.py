"""The robot's screen as a person meets it: seen, touched, typed into, chosen from."""

from __future__ import annotations

import re
import shutil
import time
from pathlib import Path
from typing import Any

import pytest
from playwright.async_api import expect

from situ.decide.effects import Map
from situ.decide.inputs import Finish, Set, Touch, Use
from situ.resources import example

pytestmark = pytest.mark.chromium

KIOSK = {"width": 1280, "height": 800}
PHONE = {"width": 390, "height": 844}


def component(
    kind: str, name: str, x: float, y: float, width: float, height: float, **more: Any
) -> dict[str, Any]:
    return {"type": kind, "id": name, "x": x, "y": y, "width": width, "height": height} | more


def button(name: str = "yes", text: str = "YES", x: float = 8, **more: Any) -> dict[str, Any]:
    return component("button", name, x, 68, 38, 22, text=text, event=f"click-{name}") | more


def text(words: str, name: str = "hello", **more: Any) -> dict[str, Any]:
    return component("text", name, 8, 10, 60, 20, text=words, size=9) | more


def field(name: str = "name", **more: Any) -> dict[str, Any]:
    given = {"tag": f"user.{name}", "kind": "text", "value": None}
    return component("input", name, 10, 40, 50, 16) | given | more


def names(*labels: str, **more: Any) -> dict[str, Any]:
    items = [{"label": label, "value": {"name": label}} for label in labels]
    return component("list", "names", 10, 30, 80, 40, items=items, event="chosen") | more


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


def test_what_stays_is_not_made_anew_and_a_caret_keeps_its_place(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        stage.show(text("One"), button(), field(value="Ann"))
        typed = stage.component("name").locator("input")
        await typed.focus()
        await typed.evaluate("one => { one.value = 'Anna'; one.setSelectionRange(2, 2); }")
        await stage.page.evaluate(
            "document.querySelectorAll('.component').forEach(n => n.mark = 1)"
        )
        stage.show(text("Two"), text("New", "new", y=80), button(text="JA"), field(value="Ann"))
        await expect(stage.component("hello")).to_have_text("Two")
        marks = await stage.page.evaluate(
            "[...document.querySelectorAll('.component')].map(n => [n.dataset.id, n.mark ?? 0])"
        )
        assert marks == [["hello", 1], ["new", 0], ["yes", 1], ["name", 1]]
        await expect(typed).to_be_focused()
        assert await typed.evaluate("one => [one.value, one.selectionStart]") == ["Anna", 2]
        # Another tag under the same id is another input: the next letter begins empty.
        stage.show(field(tag="user.other"))
        await expect(typed).to_have_value("")

    play(scenario)


def test_without_a_holder_the_robot_shows_a_calm_face(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        await expect(stage.page.locator("#idle")).to_be_visible()
        stage.show(text("Hello"))
        await expect(stage.page.locator("#idle")).to_be_hidden()
        stage.clear()
        await expect(stage.page.locator("#idle")).to_be_visible()
        await expect(stage.page.locator(".component")).to_have_count(0)

    play(scenario)


def test_the_page_waits_for_a_robot_that_restarts_and_shows_what_is_shown_then(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        stage.show(text("Before"), field())
        await stage.component("name").locator("input").fill("half a na")
        port = await stage.stop()
        veil = stage.page.locator("#veil")
        await expect(veil).to_be_visible()
        await expect(veil).to_contain_text("One moment, please")
        await stage.restart(port)
        stage.show(text("After"), field())
        await expect(veil).to_be_hidden()
        await expect(stage.component("hello")).to_have_text("After")
        await expect(stage.component("name").locator("input")).to_have_value("half a na")
        await stage.page.keyboard.press("Enter")
        assert await stage.next() == Use("name", "half a na")

    play(scenario)


def test_a_key_that_is_out_of_date_is_said(play: Any, tmp_path: Path) -> None:
    async def scenario(stage: Any) -> None:
        port = await stage.stop()
        (tmp_path / "state" / "keys" / "screen").write_text("another key\n", "utf-8")
        await stage.restart(port)
        await expect(stage.page.locator("#veil")).to_contain_text("out of date")

    play(scenario)


def test_the_key_does_not_stay_in_the_address(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        await expect(stage.page.locator("#idle")).to_be_visible()
        assert "token" not in stage.page.url
        await stage.page.reload()
        await expect(stage.page.locator("#idle")).to_be_visible()

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


def test_what_is_said_stands_at_the_bottom_where_there_is_no_sound(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        caption = stage.page.locator("#caption")
        await expect(caption).to_be_visible()
        stage.performer.perform(
            Map("speech", "m", {"text": "Please sit down. " * 40, "lang": "en"})
        )
        await expect(caption).to_have_class("speaking")
        await expect(caption).to_contain_text("Please sit down.")
        stage.performer.perform(Map("speech", None, None))
        await expect(caption).not_to_have_class("speaking")
        stage.performer.captions = False
        await expect(caption).to_be_hidden()

    play(scenario, services=("screen", "engine"), captions=True)


def test_what_is_said_keeps_its_lines_while_the_screen_changes(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        line = stage.page.locator("#caption > span")
        await stage.page.evaluate("Promise.all([...document.fonts].map((face) => face.load()))")
        # One phrase, which has to be parted.
        stage.performer.perform(Map("speech", "m", {"text": "ア" * 200, "lang": "ja"}))
        await expect(line).to_have_text("ア" * 200)
        high = (await line.bounding_box())["height"]
        assert await line.evaluate("one => one.scrollWidth <= one.clientWidth + 1")
        stage.show(text("Meanwhile"))
        await expect(stage.component("hello")).to_have_text("Meanwhile")
        assert (await line.bounding_box())["height"] == high
        assert await line.evaluate("one => one.scrollWidth <= one.clientWidth + 1")

    play(scenario, services=("screen", "engine"), captions=True)


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


def test_a_robot_without_keys_has_them_on_its_screen(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        stage.show(field(event="entered"), button("confirm", "CONFIRM"))
        keys = stage.page.locator("#keys")
        await stage.component("name").locator("input").tap()
        await expect(keys).to_be_visible()
        # Nothing is covered: the screen above the keys is smaller.
        for name in ("name", "confirm"):
            box = await stage.component(name).bounding_box()
            assert box["y"] + box["height"] <= (await keys.bounding_box())["y"]
        for key in ("a", "n", "n", "x", "Backspace"):
            await keys.get_by_role("button", name=key, exact=True).tap()
        await expect(stage.component("name").locator("input")).to_have_value("Ann")
        await keys.get_by_role("button", name="OK").tap()
        assert await stage.next() == Use("name", "Ann")
        await expect(keys).to_be_hidden()
        # Leaving them for a button finds the button where it was aimed at.
        await stage.component("name").locator("input").tap()
        await keys.get_by_role("button", name="Space", exact=True).tap()
        await stage.component("confirm").tap()
        assert await stage.next() == Set({"user.name": "Ann "}, "screen")
        assert await stage.next() == Use("confirm")

    play(scenario, has_touch=True, address="&keyboard=on")


async def tap_keys(stage: Any, *names: str) -> None:
    for name in names:
        keys = stage.page.locator("#keys")
        await keys.get_by_role("button", name=name, exact=True).tap()


def test_the_keys_have_digits_and_the_letters_of_the_language_and_of_others(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        stage.show(field(event="entered"))
        typed = stage.component("name").locator("input")
        await typed.tap()
        # In German Z stands where others have Y, and Ü beside P.
        await tap_keys(stage, "z", "ü", "1", "2")
        await expect(typed).to_have_value("Zü12")
        # A letter of another language is one page away, and the first page comes back by itself.
        await tap_keys(stage, "Space", "Shift", "accents", "é", "ß")
        await expect(typed).to_have_value("Zü12 Éß")
        await tap_keys(stage, "OK")
        assert await stage.next() == Use("name", "Zü12 Éß")

    play(scenario, has_touch=True, address="&keyboard=on", tag={"language": "de"}.get)


def test_japanese_is_typed_in_kana(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        stage.show(field(event="entered"))
        typed = stage.component("name").locator("input")
        await typed.tap()
        # ゛, ゜ and 小 change the letter before; where there is no such letter it stays.
        await tap_keys(stage, "し", "゛", "よ", "小", "ん", "゛")
        await expect(typed).to_have_value("じょん")
        await tap_keys(stage, "ほ", "゛", "゜", "Backspace", "か", "゛", "゛")
        await expect(typed).to_have_value("じょんか")
        await tap_keys(stage, "latin", "7", "kana", "え", "OK")
        assert await stage.next() == Use("name", "じょんか7え")

    play(scenario, has_touch=True, address="&keyboard=on", tag={"language": "ja"}.get)


def test_a_number_has_the_decimal_mark_of_the_language(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        stage.show(field("weight", kind="number", event="entered"))
        await stage.component("weight").locator("input").tap()
        await tap_keys(stage, "7", "2", ",", "5", "OK")
        assert await stage.next() == Use("weight", 72.5)

    play(scenario, has_touch=True, address="&keyboard=on", tag={"language": "de"}.get)


def test_a_date_is_typed_by_digits_in_the_order_of_the_language(play: Any) -> None:
    tags: dict[str, Any] = {}
    written = {
        "en_GB": ("DD/MM/YYYY", "07051941", "07/05/1941"),
        "en": ("MM/DD/YYYY", "05071941", "05/07/1941"),
        "ja": ("YYYY/MM/DD", "19410507", "1941/05/07"),
        "de": ("TT.MM.JJJJ", "07051941", "07.05.1941"),
    }

    async def scenario(stage: Any) -> None:
        for lang, (pattern, digits, shown) in written.items():
            tags["language"] = lang
            name = f"born-{lang}"
            stage.show(field(name, kind="date", event="entered"))
            typed = stage.component(name).locator("input")
            await expect(typed).to_have_attribute("placeholder", pattern)
            await typed.tap()
            await tap_keys(stage, *digits, "9")
            await expect(typed).to_have_value(shown)
            assert await stage.next() == Set({f"user.{name}": "1941-05-07"}, "screen")
            await tap_keys(stage, "OK")
            assert await stage.next() == Use(name, "1941-05-07")
            assert stage.nothing_more()
            # What the robot sets is shown in the same order.
            stage.show(field(name, kind="date", event="entered", value="1950-05-07"))
            await expect(typed).to_have_value(shown.replace("1941", "1950"))

    play(scenario, has_touch=True, address="&keyboard=on", tag=tags.get)


def test_a_day_that_there_is_not_is_not_sent(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        stage.show(field("born", kind="date", event="entered"), button())
        typed = stage.component("born").locator("input")
        await typed.tap()
        await tap_keys(stage, *"31021941")
        await expect(typed).to_have_value("31/02/1941")
        await tap_keys(stage, "OK")
        await expect(stage.component("born")).to_have_class(re.compile("wrong"))
        # Nor is one that is not whole; taken back to its beginning it is none again.
        await typed.tap()
        await tap_keys(stage, *["Backspace"] * 7)
        await expect(typed).to_have_value("3")
        await stage.component("yes").tap()
        assert await stage.next() == Use("yes")
        assert stage.nothing_more()

    play(scenario, has_touch=True, address="&keyboard=on", tag={"language": "en-GB"}.get)


def test_keys_are_large_enough_for_a_finger(play: Any) -> None:
    tags: dict[str, Any] = {}
    kinds = [("text", lang) for lang in ("en", "de", "fr", "ja")]
    kinds += [(kind, "ja") for kind in ("number", "date", "pin")]

    async def scenario(stage: Any) -> None:
        for kind, lang in kinds:
            tags["language"] = lang
            name = f"{kind}-{lang}"
            stage.show(field(name, kind=kind))
            await stage.component(name).locator("input").tap()
            keys = stage.page.locator(f'#keys[data-kind="{kind}"][data-language="{lang}"]')
            await expect(keys).to_be_visible()
            sizes = await stage.page.evaluate(
                "[...document.querySelectorAll('#keys button')].map(one => "
                "[one.offsetWidth, one.offsetHeight])"
            )
            # A centimetre on a screen of 10 inches.
            assert all(width >= 56 and height >= 56 for width, height in sizes), (name, sizes)

    play(scenario, has_touch=True, address="&keyboard=on", tag=tags.get)


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
