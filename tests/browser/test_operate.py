"""The operator's page: what the flow expects as buttons, and what else he plays."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import Any

import pytest
from playwright.async_api import Page, expect

from situ.blackboard.asynchronous import AsyncBoard
from situ.blackboard.keys import RobotKeys

pytestmark = pytest.mark.chromium

PHONE = {"viewport": {"width": 390, "height": 844}}
FLOW = """\
<application name="desk" start="1">
  <state no="1" name="asks">
    <screen touched="touched"><components><text id="t" x="0" y="0" width="9" height="9">Hi</text></components></screen>
    <expectedevents>
      <event name="yes" next="2"><say>Yes, please</say></event>
      <event name="no" next="1"><when><data tag="ready" is="true"/></when></event>
      <event name="touched" next="2"/>
    </expectedevents>
  </state>
  <state no="2" name="serves"><expectedevents><event name="over" next="1"/></expectedevents></state>
</application>
"""  # noqa: E501
FILES = {
    "situ.toml": '[project]\nname = "ward"\napplications = ["desk.rbd.xml"]\n',
    "desk.rbd.xml": FLOW,
}
Scene = Callable[[Page, AsyncBoard], Awaitable[None]]
Operate = Callable[..., None]


@pytest.fixture
def operate(before: Any) -> Operate:
    """Opens the page: ``operate(scene)``; more as in ``before``."""

    def run(scene: Scene, **more: Any) -> None:
        before("operate", FILES, scene, **more)

    return run


async def state(page: Page, name: str) -> None:
    await expect(page.locator("[data-application=desk] .state")).to_contain_text(name)


def test_a_button_raises_its_event_and_the_next_state_is_shown(operate: Operate) -> None:
    async def scene(page: Page, board: AsyncBoard) -> None:
        await state(page, "asks (1)")
        yes = page.get_by_role("button", name="yes")
        await expect(yes).to_contain_text("“Yes, please”")
        await yes.click()
        await state(page, "serves (2)")
        await expect(page.get_by_text("yes raised")).to_be_visible()
        await page.get_by_role("button", name="over").click()
        await state(page, "asks (1)")

    operate(scene)


def test_an_event_whose_guard_does_not_hold_says_why_until_it_does(operate: Operate) -> None:
    async def scene(page: Page, board: AsyncBoard) -> None:
        no = page.locator("[data-event=no]")
        await expect(no).to_be_disabled()
        await expect(no).to_contain_text("Only where ready is true")
        await board.set("ready", True)
        await expect(no).to_be_enabled()

    operate(scene)


def test_what_a_person_said_is_heard_as_from_a_recogniser(operate: Operate) -> None:
    async def scene(page: Page, board: AsyncBoard) -> None:
        await state(page, "asks")
        await page.get_by_label("What a person said").fill("yes please!")
        await page.keyboard.press("Enter")
        await state(page, "serves")
        assert await board.get("heard") == {"text": "yes please!", "confidence": 1}

    operate(scene)


def test_the_screen_is_touched_and_data_are_set_as_json_or_text(operate: Operate) -> None:
    async def scene(page: Page, board: AsyncBoard) -> None:
        await state(page, "asks")
        await page.get_by_role("button", name="Touch the screen").click()
        await state(page, "serves")
        for typed, value in (("12", 12), ('{"a": [1]}', {"a": [1]}), ("Ann", "Ann"), ("", None)):
            await page.get_by_label("Tag").fill("user.name")
            await page.get_by_label("Value").fill(typed)
            await page.get_by_role("button", name="Set").click()
            now = "Now not set" if value is None else "Now "
            await expect(page.locator("#data-now")).to_contain_text(now)
            await expect(page.get_by_label("Value")).to_have_value("")
            assert await board.get("user.name") == value
        # What the blackboard refuses is told in its words.
        await page.get_by_label("Tag").fill("robot/head")
        await page.get_by_role("button", name="Set").click()
        await expect(page.locator("#told[data-is=wrong]")).to_contain_text("robot/head")

    operate(scene)


def test_a_paused_application_takes_nothing_until_it_goes_on(operate: Operate) -> None:
    async def scene(page: Page, board: AsyncBoard) -> None:
        await page.get_by_role("button", name="Pause").click()
        await expect(page.get_by_text("Paused", exact=True)).to_be_visible()
        await expect(page.locator("[data-event=yes]")).to_be_disabled()
        # Who uses keys need not look for the button again.
        await expect(page.get_by_role("button", name="Go on")).to_be_focused()
        await page.get_by_role("button", name="Go on").click()
        await page.locator("[data-event=yes]").click()
        await state(page, "serves")

    operate(scene)


def test_a_viewer_sees_the_state_and_can_do_nothing(operate: Operate, keys: RobotKeys) -> None:
    async def scene(page: Page, board: AsyncBoard) -> None:
        await expect(page.get_by_text("You can look only")).to_be_visible()
        await state(page, "asks")
        await expect(page.get_by_role("button", name="yes")).to_be_disabled()
        await expect(page.locator("#acts")).to_be_hidden()

    operate(scene, token="tablet's token", keys=keys)


def test_on_a_phone_every_target_has_a_fingers_size(operate: Operate) -> None:
    async def scene(page: Page, board: AsyncBoard) -> None:
        await state(page, "asks")
        for target in await page.locator("button:visible, input:visible").all():
            box = await target.bounding_box()
            assert box is not None
            assert min(box["width"], box["height"]) >= 44
        assert await page.evaluate("document.documentElement.scrollWidth") <= 390

    operate(scene, **PHONE)
