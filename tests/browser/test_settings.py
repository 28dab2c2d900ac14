"""The settings page as an end user meets it: each kind of field, saved, refused, seen live."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import Any

import pytest
from playwright.async_api import Locator, Page, expect

from situ.blackboard.asynchronous import AsyncBoard
from situ.blackboard.keys import RobotKeys

pytestmark = pytest.mark.chromium

PHONE = {"viewport": {"width": 390, "height": 844}}
FORMS = {
    "ward.round": ("Morning round", 'type = "time"'),
    "ward.visit": ("Next visit", 'type = "date"'),
    "ward.greeting": ("What the robot says", ""),
    "ward.volume": ("Loudness in percent", 'type = "number"'),
    "ward.quiet": ("Quiet at night", 'type = "boolean"'),
    "ward.voice": ("Voice", 'type = "choice"\nchoices = ["soft", "normal", "loud"]'),
}
PROJECT = """\
[project]
name = "ward"
applications = ["rest.rbd.xml"]
[tags]
"ward.round" = "08:30"
"ward.volume" = 60
"ward.voice" = "normal"
[durable]
tags = ["ward.*"]
""" + "".join(
    f'[[setting]]\ntag = "{tag}"\nlabel = "{label}"\n{more}\n'
    for tag, (label, more) in FORMS.items()
)
JAPANESE = "".join(
    f'msgid "{written}"\nmsgstr "{said}"\n\n'
    for written, said in (
        ("Morning round", "朝の巡回"),
        ("Voice", "声"),
        ("soft", "小さい声"),
        ("normal", "普通の声"),
    )
)
REST = '<application name="rest"><state no="1" final="true"/></application>'


class Ward:
    """A robot with settings, a page that shows them, and somebody else at the blackboard."""

    def __init__(self, page: Page, board: AsyncBoard) -> None:
        self.page = page
        self.board = board

    def form(self, tag: str) -> Locator:
        return self.page.locator(f'form[data-tag="{tag}"]')

    def field(self, tag: str) -> Locator:
        return self.page.get_by_label(FORMS[tag][0], exact=True)

    async def note(self, tag: str, words: str) -> None:
        await expect(self.form(tag).locator(".note")).to_contain_text(words)

    async def save(self, tag: str, text: str) -> None:
        await self.field(tag).fill(text)
        await self.form(tag).get_by_role("button", name="Save").click()


Scenario = Callable[[Ward], Awaitable[None]]
Visit = Callable[..., None]


@pytest.fixture
def visit(before: Any) -> Visit:
    """Opens the page: ``visit(scenario)``; own: files of the project beside the ward's, or in
    their place; more as in ``before``."""
    files = {"situ.toml": PROJECT, "rest.rbd.xml": REST}

    def run(scenario: Scenario, own: dict[str, str] | None = None, **more: Any) -> None:
        every = files | (own or {})
        before("settings", every, lambda page, board: scenario(Ward(page, board)), **more)

    return run


def test_each_kind_of_field_is_typed_and_saved(visit: Visit) -> None:
    async def scenario(ward: Ward) -> None:
        await expect(ward.field("ward.round")).to_have_value("08:30")
        await expect(ward.field("ward.volume")).to_have_value("60")
        await expect(ward.page.get_by_role("radio", name="normal")).to_be_checked()
        for tag, typed, value in (
            ("ward.round", "09:15", "09:15"),
            ("ward.visit", "2027-02-28", "2027-02-28"),
            ("ward.greeting", "<b>Good morning</b>", "<b>Good morning</b>"),
            ("ward.volume", "62,5", 62.5),
        ):
            await ward.save(tag, typed)
            await ward.note(tag, "Saved at")
            assert await ward.board.get(tag) == value
        await ward.field("ward.quiet").click()
        await ward.note("ward.quiet", "Saved at")
        assert await ward.board.get("ward.quiet") is True
        await ward.page.get_by_role("radio", name="loud").check()
        await ward.note("ward.voice", "Saved at")
        assert await ward.board.get("ward.voice") == "loud"
        # An emptied field says that there is nothing.
        await ward.save("ward.round", "")
        await ward.note("ward.round", "Saved at")
        assert await ward.board.get("ward.round") is None

    visit(scenario)


def test_what_does_not_fit_its_kind_is_refused_before_it_is_sent(visit: Visit) -> None:
    async def scenario(ward: Ward) -> None:
        await ward.save("ward.volume", "loud")
        await ward.note("ward.volume", "Type a number")
        await expect(ward.field("ward.volume")).to_have_attribute("aria-invalid", "true")
        await expect(ward.field("ward.volume")).to_be_focused()
        await ward.field("ward.round").press("Backspace")
        await ward.form("ward.round").get_by_role("button", name="Save").click()
        await ward.note("ward.round", "Type a time")
        assert await ward.board.get("ward.volume") == 60
        assert await ward.board.get("ward.round") == "08:30"
        # Taken back, all is as it was.
        await ward.form("ward.volume").get_by_role("button", name="Cancel").click()
        await expect(ward.field("ward.volume")).to_have_value("60")

    visit(scenario)


def test_what_others_change_is_seen_at_once(visit: Visit) -> None:
    async def scenario(ward: Ward) -> None:
        await expect(ward.field("ward.volume")).to_be_enabled()
        await ward.board.set("ward.volume", 10)
        await expect(ward.field("ward.volume")).to_have_value("10")
        await ward.note("ward.volume", "Changed by bob")
        await ward.board.set("ward.volume", "very")
        await ward.note("ward.volume", "Now very, which does not fit here")
        # A year alone is no day.
        await ward.board.set("ward.visit", "2027")
        await ward.note("ward.visit", "Now 2027, which does not fit here")

    visit(scenario)


def test_a_change_that_was_not_seen_is_not_overwritten(visit: Visit) -> None:
    async def scenario(ward: Ward) -> None:
        await ward.field("ward.volume").fill("30")
        await ward.board.set("ward.volume", 20)
        await ward.note("ward.volume", "Meanwhile changed to 20 by bob")
        await expect(ward.field("ward.volume")).to_have_value("30")
        await ward.field("ward.volume").press("Enter")
        await ward.note("ward.volume", "Saved at")
        assert await ward.board.get("ward.volume") == 30

    visit(scenario)


def test_the_page_speaks_the_language_of_the_robot(visit: Visit) -> None:
    async def scenario(ward: Ward) -> None:
        title = ward.page.get_by_role("heading", level=1)
        await expect(title).to_have_text("Settings")
        for language, words in (("de", "Einstellungen"), ("ja", "設定"), ("xx", "Settings")):
            await ward.board.set("language", language)
            await expect(title).to_have_text(words)

    visit(scenario)


def test_a_setting_and_its_choices_are_named_as_the_robots_screen_would_show_them(
    visit: Visit,
) -> None:
    own = {
        "situ.toml": PROJECT.replace("[tags]", 'languages = ["en", "ja"]\n[tags]'),
        "texts/ja.po": JAPANESE,
    }

    async def scenario(ward: Ward) -> None:
        page, note = ward.page, ward.form("ward.voice").locator(".note")
        await expect(ward.field("ward.round")).to_have_value("08:30")
        # What is being typed stays when the language changes.
        await ward.field("ward.volume").fill("61")
        await ward.board.set("language", "ja")
        await expect(page.get_by_label("朝の巡回", exact=True)).to_have_value("08:30")
        voice = page.get_by_role("radiogroup", name="声", exact=True)
        await expect(voice.get_by_role("radio", name="普通の声")).to_be_checked()
        # What nobody translated is shown as it is written.
        await expect(voice.get_by_role("radio", name="loud")).to_be_visible()
        await expect(ward.field("ward.volume")).to_have_value("61")
        await voice.get_by_role("radio", name="小さい声").check()
        await expect(note).to_contain_text("保存しました")
        assert await ward.board.get("ward.voice") == "soft"
        await ward.board.set("language", None)
        await expect(page.get_by_role("radio", name="soft")).to_be_checked()
        await expect(ward.field("ward.round")).to_be_visible()

    visit(scenario, own)


def test_without_the_token_nothing_is_shown_until_it_is_typed(visit: Visit) -> None:
    async def scenario(ward: Ward) -> None:
        await expect(ward.page.get_by_label("Token")).to_be_focused()
        await expect(ward.page.locator(".setting")).to_have_count(0)
        await ward.page.get_by_label("Token").fill("wrong")
        await ward.page.get_by_role("button", name="Open").click()
        await expect(ward.page.get_by_text("does not know this token")).to_be_visible()

    visit(scenario, token="")


def test_with_keys_it_is_written_who_saved(visit: Visit, keys: RobotKeys) -> None:
    async def scenario(ward: Ward) -> None:
        assert "token" not in ward.page.url
        await ward.save("ward.volume", "70")
        await ward.note("ward.volume", "Saved at")
        (entry,) = (await ward.board.entries("ward.volume")).values()
        assert (entry.value, entry.writer) == (70, "operator:ann")

    visit(scenario, token="ann's token", keys=keys)


def test_a_viewer_sees_what_stands_there_and_changes_nothing(visit: Visit, keys: RobotKeys) -> None:
    async def scenario(ward: Ward) -> None:
        await expect(ward.page.get_by_text("You can look only")).to_be_visible()
        await expect(ward.field("ward.volume")).to_have_value("60")
        for field in await ward.page.locator(".setting input").all():
            await expect(field).to_be_disabled()

    visit(scenario, token="tablet's token", keys=keys)


def test_on_a_phone_every_target_has_a_fingers_size(visit: Visit) -> None:
    async def scenario(ward: Ward) -> None:
        await expect(ward.field("ward.volume")).to_be_enabled()
        await ward.field("ward.volume").fill("1")
        targets = "button:visible, input:visible, .choices label:visible"
        for target in await ward.page.locator(targets).all():
            box = await target.bounding_box()
            assert box is not None
            assert box["height"] >= 44
            assert box["width"] >= 44
        # What is said under a field is told with it to who does not see it.
        for field in await ward.page.locator(".setting [aria-describedby]").all():
            note = await field.get_attribute("aria-describedby")
            assert await ward.page.locator(f"#{note}[role=status]").count() == 1
        wide = await ward.page.evaluate("document.documentElement.scrollWidth")
        assert wide <= 390

    visit(scenario, **PHONE)
