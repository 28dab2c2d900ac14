"""The keys that the robot's screen brings along, where it has none."""

from __future__ import annotations

import re
from typing import Any

import pytest
from playwright.async_api import expect
from tests.browser.components import button, field

from situ.decide.inputs import Set, Use

pytestmark = pytest.mark.chromium


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
