"""The robot's page: what stays between screens, what is said, a robot started anew, its key."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from playwright.async_api import expect
from tests.browser.components import button, field, text

from situ.decide.effects import Map
from situ.decide.inputs import Use

pytestmark = pytest.mark.chromium


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
