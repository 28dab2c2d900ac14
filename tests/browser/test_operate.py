"""The operator's page: what the flow expects as buttons, and what else he plays."""

from __future__ import annotations

import asyncio
import contextlib
import json
import sys
from collections.abc import AsyncIterator, Awaitable, Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from playwright.async_api import Locator, Page, expect

from situ.blackboard.asynchronous import AsyncBoard
from situ.blackboard.keys import RobotKeys

if TYPE_CHECKING:
    from tests.browser.conftest import Theatre

DEADLINE = 20.0
pytestmark = pytest.mark.chromium

FLOW = """\
<application name="desk" start="1">
  <state no="1" name="asks">
    <screen touched="touched"><components><text id="t" x="0" y="0" width="9" height="9">Hi</text></components></screen>
    <backgroundactions>{speech}</backgroundactions>
    <expectedevents>
      <event name="yes" next="2"><say>Yes, please</say></event>
      <event name="no" next="1"><when><data tag="ready" is="true"/></when></event>
      <event name="touched" next="2"/>
      <event name="greets"><say>{{name}}</say></event>
    </expectedevents>
  </state>
  <state no="2" name="serves"><expectedevents><event name="over" next="1"/></expectedevents></state>
</application>
"""  # noqa: E501
FILES = {
    "situ.toml": '[project]\nname = "ward"\napplications = ["desk.rbd.xml"]\n',
    "desk.rbd.xml": FLOW.format(speech=""),
}
PRIVATE = '[privacy]\nprivate = ["name"]\n'
WARD = {
    "situ.toml": FILES["situ.toml"]
    + """\
spds = "ward.spds.xml"
modules = "modules.xml"
[[setting]]
tag = "voice"
type = "choice"
choices = ["low", "high"]
""",
    "desk.rbd.xml": FLOW.format(speech="<speech>What is your name?</speech>"),
    "modules.xml": """\
<modules>
  <module name="face" resources="">
    <provides data="face.visible" type="boolean"/>
    <provides data="face.name" type="text"/>
  </module>
</modules>
""",
    "ward.spds.xml": """\
<spds name="ward">
  <observe>
    <data tag="human.distance" type="number" unit="m"/>
    <data tag="fall.detected"/>
    <data tag="urgent"/>
  </observe>
  <modules>
    <module name="desk" resources="speech screen"/>
    <module name="operator" resources="speech"/>
  </modules>
  <situation name="alarm">
    <condition><data tag="fall.detected" is="true"/></condition>
    <module name="desk" priority="90"/>
  </situation>
  <situation name="urgent" extends="reception">
    <condition><data tag="urgent" is="true"/></condition>
    <module name="desk" priority="90"/>
  </situation>
  <situation name="reception">
    <module name="desk" priority="30"/>
    <module name="operator" priority="60"/>
  </situation>
</spds>
""",
}
COUNT = """() => {
  const parse = JSON.parse;
  window.answers = window.snapshots = 0;
  JSON.parse = (text) => {
    const read = parse(text);
    if (read?.applications?.desk?.state === "2") window.answers += 1;
    if (read?.re === "snapshot") window.snapshots += 1;
    return read;
  };
}"""
NAME = "one => one.ariaLabel || one.labels?.length || one.getAttribute('aria-labelledby')"
Scene = Callable[[Page, AsyncBoard], Awaitable[None]]
Operate = Callable[..., None]


@pytest.fixture
def operate(before: Any) -> Operate:
    """Opens the page: ``operate(scene)``; more as in ``before``."""

    def run(scene: Scene, files: dict[str, str] = FILES, **more: Any) -> None:
        before("operate", files, scene, **more)

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
            await page.get_by_label("Another tag").fill("user.name")
            await page.get_by_label("Value").fill(typed)
            await page.locator("#other-data button").click()
            now = "Not set" if value is None else "Now "
            await expect(page.locator("#data-now")).to_contain_text(now)
            await expect(page.get_by_label("Value")).to_have_value("")
            assert await board.get("user.name") == value
        # What the blackboard refuses is told in its words.
        await page.get_by_label("Another tag").fill("robot/head")
        await page.locator("#other-data button").click()
        await expect(page.locator("#told[data-is=wrong]")).to_contain_text("robot/head")

    operate(scene)


def test_a_paused_application_takes_nothing_until_it_goes_on(operate: Operate) -> None:
    async def scene(page: Page, board: AsyncBoard) -> None:
        await page.get_by_role("button", name="Pause").click()
        await expect(page.locator("[data-application=desk] .note")).to_have_text("Paused")
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


def test_a_viewer_is_shown_nothing_private(operate: Operate, keys: RobotKeys) -> None:
    files = {**FILES, "situ.toml": FILES["situ.toml"] + PRIVATE}

    async def scene(page: Page, board: AsyncBoard) -> None:
        await expect(page.get_by_text("You can look only")).to_be_visible()
        await board.set("name", "Ann")
        yes = page.locator("[data-event=greets]")
        await expect(yes).to_contain_text("“•••”")
        # It follows changes by other topics, and need not ask for what it missed.
        await page.evaluate(COUNT)
        await board.set("language", "de")
        await expect(page.locator("h1")).to_have_text("Bedienen")
        assert await page.evaluate("window.snapshots") == 0

    operate(scene, token="tablet's token", keys=keys, files=files)


# -- data by their types ---------------------------------------------------------------


def test_data_of_settings_are_named_in_the_language_of_the_robots_screen(operate: Operate) -> None:
    files = WARD | {
        "situ.toml": WARD["situ.toml"]
        .replace('tag = "voice"', 'tag = "voice"\nlabel = "Voice"')
        .replace("[project]", '[project]\nlanguages = ["en", "ja"]'),
        "texts/ja.po": 'msgid "Voice"\nmsgstr "声"\n\nmsgid "high"\nmsgstr "高い"\n',
    }

    async def scene(page: Page, board: AsyncBoard) -> None:
        await board.set({"language": "ja", "voice": "high"})
        voice = page.get_by_role("radiogroup", name="声", exact=True)
        await expect(voice.get_by_role("radio", name="高い")).to_be_checked()
        await expect(note(page, "voice")).to_have_text("現在：高い")

    operate(scene, files)


def test_data_are_filled_in_by_their_types(operate: Operate) -> None:
    async def scene(page: Page, board: AsyncBoard) -> None:
        await page.get_by_label("face.visible").click()
        await expect(note(page, "face.visible")).to_have_text("Now true")
        assert await board.get("face.visible") is True
        await page.get_by_label("human.distance (m)", exact=True).fill("1,5")
        await page.keyboard.press("Enter")
        await expect(note(page, "human.distance")).to_have_text("Now 1.5")
        # One more, in the last place that is written.
        await page.get_by_role("button", name="More: human.distance (m)").click()
        await expect(note(page, "human.distance")).to_have_text("Now 1.6")
        await page.get_by_role("button", name="Less: human.distance (m)").click()
        await expect(note(page, "human.distance")).to_have_text("Now 1.5")
        assert await board.get("human.distance") == 1.5
        await page.get_by_role("radio", name="high").check(force=True)
        await expect(note(page, "voice")).to_have_text("Now high")
        await page.get_by_label("face.name").fill("12")
        await page.keyboard.press("Enter")
        await expect(note(page, "face.name")).to_have_text("Now 12")
        assert await board.get("face.name") == "12"
        # Another's change is seen, but not over what is being typed.
        await page.get_by_label("face.name").fill("An")
        await board.set({"face.name": "Bea", "face.visible": False})
        await expect(note(page, "face.name")).to_have_text("Now Bea")
        await expect(page.get_by_label("face.name")).to_have_value("An")
        await expect(page.get_by_label("face.visible")).not_to_be_checked()
        await page.get_by_label("human.distance (m)", exact=True).fill("far")
        await page.keyboard.press("Enter")
        await expect(page.locator("#told[data-is=wrong]")).to_contain_text("Type a number")
        assert await board.get("human.distance") == 1.5

    operate(scene, files=WARD)


def note(page: Page, tag: str) -> Locator:
    return page.locator(f'[data-tag="{tag}"] .note')


# -- what the robot is to say ----------------------------------------------------------


def test_the_robot_says_an_operators_words_as_the_module_operator(operate: Operate) -> None:
    async def scene(page: Page, board: AsyncBoard) -> None:
        await page.get_by_role("button", name="“What is your name?”").click()
        await expect(page.locator("#told")).to_have_text("“What is your name?”")
        assert await board.get("robot/speech") == {"text": "What is your name?"}
        assert (await board.entries("robot/speech"))["robot/speech"].writer == "operator"
        # Meanwhile the flow, which lost the voice, waits.
        await expect(page.get_by_text("Suspended")).to_be_visible()
        await page.get_by_label("Let the robot say").fill("Just a moment")
        await page.keyboard.press("Enter")
        await expect(page.get_by_label("Let the robot say")).to_have_value("")
        assert await board.get("robot/speech") == {"text": "Just a moment"}
        await page.get_by_role("button", name="Be quiet").click()
        await expect(page.get_by_text("Suspended")).to_be_hidden()
        assert (await board.get("robot/speech"))["text"] == "What is your name?"
        assert (await board.entries("robot/speech"))["robot/speech"].writer == "desk"

    operate(scene, files=WARD)


def test_after_its_words_the_voice_goes_back_by_itself(operate: Operate) -> None:
    async def scene(page: Page, board: AsyncBoard) -> None:
        await board.set("speech.rate", 250)
        await page.get_by_label("Let the robot say").fill("Hm")
        await page.keyboard.press("Enter")
        await expect(page.get_by_text("Suspended")).to_be_visible()
        await expect(page.get_by_text("Suspended")).to_be_hidden()
        await expect(page.get_by_role("button", name="Be quiet")).to_be_hidden()

    operate(scene, files=WARD)


def test_without_a_priority_the_words_are_pale_and_it_is_said_why(operate: Operate) -> None:
    async def scene(page: Page, board: AsyncBoard) -> None:
        why = page.get_by_text("The script gives the module “operator” no priority")
        speech = page.get_by_role("button", name="“What is your name?”")
        await expect(speech).to_be_enabled()
        await expect(why).to_be_hidden()
        await board.set("fall.detected", True)
        await expect(why).to_be_visible()
        await expect(speech).to_be_disabled()
        await expect(page.get_by_label("Let the robot say")).to_be_disabled()
        await expect(page.locator("#robot-now")).to_contain_text("alarm")

    operate(scene, files=WARD)


def test_where_another_has_the_voice_it_is_said_who(operate: Operate) -> None:
    async def scene(page: Page, board: AsyncBoard) -> None:
        await board.set("urgent", True)
        await expect(page.locator("#robot-now")).to_contain_text("urgent")
        await page.get_by_label("Let the robot say").fill("Just a moment")
        await page.keyboard.press("Enter")
        await expect(page.locator("#told[data-is=wrong]")).to_have_text("desk has the voice.")
        await expect(page.get_by_label("Let the robot say")).to_have_value("Just a moment")

    operate(scene, files=WARD)


# -- the debugger ----------------------------------------------------------------------


def test_it_is_sent_to_a_state_and_stopped_there(operate: Operate) -> None:
    async def scene(page: Page, board: AsyncBoard) -> None:
        await page.get_by_text("States and breakpoints").click()
        await page.get_by_label("State", exact=True).select_option("serves (2)")
        await page.get_by_role("button", name="Stop there").click()
        await expect(page.locator("#breakpoints")).to_have_text("Stops at desk 2Remove")
        await page.get_by_role("button", name="Go there").click()
        await state(page, "serves (2)")
        await expect(page.locator("[data-application=desk] .note")).to_have_text("Paused")
        # What was chosen stays while the rest is drawn anew.
        await expect(page.get_by_label("State", exact=True)).to_have_value("2")
        await board.publish("over")
        await page.get_by_role("button", name="Next step").click()
        await state(page, "asks (1)")
        await page.get_by_role("button", name="Remove").click()
        await expect(page.locator("#breakpoints")).to_be_hidden()
        assert await board.get("debugger.breakpoints") == []

    operate(scene)


# -- hands and eyes --------------------------------------------------------------------


def test_nothing_moves_while_somebody_presses(operate: Operate) -> None:
    async def scene(page: Page, board: AsyncBoard) -> None:
        await state(page, "asks")
        await page.locator("[data-event=yes]").hover()
        await page.mouse.down()
        await page.evaluate(COUNT)
        await board.publish("touched")
        # Of two answers the first has been dealt with: it is held back.
        while await page.evaluate("window.answers") < 2:
            await board.get("clock.time")
        await expect(page.locator("[data-event=yes]")).to_be_visible()
        await page.mouse.up()
        await state(page, "serves")

    operate(scene)


@pytest.mark.parametrize(("width", "height", "scheme"), [(360, 740, "light"), (1024, 768, "dark")])
def test_every_target_has_a_fingers_size_a_name_and_its_place(
    operate: Operate, width: int, height: int, scheme: str
) -> None:
    async def scene(page: Page, board: AsyncBoard) -> None:
        await state(page, "asks")
        await page.get_by_text("States and breakpoints").click()
        targets = page.locator("button:visible, input:visible, select:visible, summary:visible")
        for target in await targets.all():
            box = await target.bounding_box()
            assert box is not None
            assert min(box["width"], box["height"]) >= 44
            assert box["x"] >= 0
            assert box["x"] + box["width"] <= width
        for role in ("button", "textbox", "switch", "radiogroup", "combobox"):
            for one in await page.get_by_role(role).all():
                assert await one.evaluate(NAME) or await one.text_content()
        assert await page.evaluate("document.documentElement.scrollWidth") <= width
        dark = await page.evaluate("getComputedStyle(document.body).backgroundColor")
        assert (dark == "rgb(16, 21, 31)") == (scheme == "dark")

    window = {"viewport": {"width": width, "height": height}, "color_scheme": scheme}
    operate(scene, files=WARD, **window)


# -- a robot in a process of its own ---------------------------------------------------


def test_it_needs_an_operators_token_and_comes_back_with_a_robot_that_was_killed(
    theatre: Theatre, keys: RobotKeys, tmp_path: Path
) -> None:
    project = tmp_path / "desk"
    project.mkdir()
    for name, text in FILES.items():
        (project / name).write_text(text)
    state_dir = tmp_path / "state"

    @contextlib.asynccontextmanager
    async def running(*addresses: str) -> AsyncIterator[dict[str, str]]:
        process = await asyncio.create_subprocess_exec(
            *(sys.executable, "-m", "situ", "run", str(project), "--json", "--no-restart"),
            *("--state", str(state_dir), *addresses),
            stdout=asyncio.subprocess.PIPE,
        )
        assert process.stdout is not None
        try:
            yield json.loads(await process.stdout.readline())
        finally:
            process.kill()
            await process.wait()
            # Until its pipe has ended too the loop knows of it.
            assert await process.stdout.read() == b""

    async def scene() -> None:
        async with theatre.window("about:blank") as page:
            async with running("--endpoint", "tcp://127.0.0.1:0") as told:
                http = told["http"].partition("/?")[0]
                same = ("--endpoint", told["requests"], "--notify", told["notifications"])
                await page.goto(f"{http}/operate")
                for token, seen in (("wrong", "does not know this token"), ("tablet's token", "")):
                    await page.get_by_label("Token").fill(token)
                    await page.get_by_role("button", name="Open").click()
                    await expect(page.get_by_text(seen or "You can look only")).to_be_visible()
                await expect(page.get_by_role("button", name="yes")).to_be_disabled()
                await page.get_by_role("button", name="Forget the token").click()
                await page.get_by_label("Token").fill("ann's token")
                await page.get_by_role("button", name="Open").click()
                await page.get_by_role("button", name="yes").click()
                await state(page, "serves (2)")
            await expect(page.locator("#link")).to_have_text("Robot is away")
            await expect(page.get_by_role("button", name="over")).to_be_disabled()
            async with running(*same, "--http", http.removeprefix("http://")):
                await page.get_by_role("button", name="over").click()
                await state(page, "asks (1)")

    async def whole() -> None:
        async with asyncio.timeout(3 * DEADLINE):
            await scene()

    theatre.loop.run_until_complete(whole())
