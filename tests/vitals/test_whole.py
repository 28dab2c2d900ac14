"""examples/vitals as its README starts it, gone through in a real browser: every service, what
begins by itself, what comes between, and what the nurse sees of it.

The devices and the ways are quick here; each service's other ends stand in the scenarios.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import re
import shutil
import socket
import subprocess
import sys
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import NamedTuple

import pytest
from playwright.async_api import Browser, Locator, Page, async_playwright, expect

import situ

VITALS = Path(__file__).resolve().parents[2] / "examples" / "vitals"
DEADLINE = 30.0
ARGUMENTS = ["--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking"]
QUICK = {
    "situ.toml": {
        '"08:00"': '"11:00"',  # no round has begun yet
        "[3.0, 2.0,": "[0.3, 0.2,",
        "[7.0, 2.0,": "[0.7, 0.2,",
        "[7.0, -2.0,": "[0.7, -0.2,",
    },
    "modules/cuff.py": {"180.0, 30.0, 8.0, 50.0": "180.0, 300.0, 120.0, 50.0"},
    "modules/glucose_meter.py": {
        "uniform(3, 6)": "uniform(0.3, 0.6)",
        "uniform(4, 8)": "uniform(0.4, 0.8)",
        "what, 5": "what, 0.5",
    },
}
"""What is put in place of what, by file of the project."""


class Started(NamedTuple):
    """Where it is: the robot's screen, the nurse's page, the blackboard, the broker's port."""

    screen: str
    nurse: str
    board: str
    broker: int
    state: Path


def free_ports(count: int) -> int:
    """The first of so many in a row that nobody listens at."""
    while True:
        with contextlib.ExitStack() as held, contextlib.suppress(OSError):
            one = held.enter_context(socket.create_server(("127.0.0.1", 0)))
            port: int = one.getsockname()[1]
            for more in range(1, count):
                held.enter_context(socket.create_server(("127.0.0.1", port + more)))
            return port


def where_it_is(hour: int, minute: int) -> str:
    """A time zone in which it is that late now."""
    now = datetime.now(UTC)
    west = (now.hour * 60 + now.minute - hour * 60 - minute) % (24 * 60)
    return f"WARD{west // 60:02}:{west % 60:02}"


@pytest.fixture
def started(tmp_path: Path, mosquitto: str) -> Iterator[Started]:
    """All of it, started by one command, at 10:25: bingo is in five minutes."""
    assert mosquitto
    project, state = tmp_path / "vitals", tmp_path / "state"
    shutil.copytree(VITALS, project, ignore=shutil.ignore_patterns("__pycache__"))
    # The blackboard's own, that where it notifies, and the screen's.
    board, records, broker = free_ports(3), free_ports(1), free_ports(1)
    ports = {"5570": str(board), "8081": str(records), "1883": str(broker)}
    for name, changed in {**QUICK, "situ.toml": {**QUICK["situ.toml"], **ports}}.items():
        text = (project / name).read_text("utf-8")
        for there, instead in changed.items():
            assert there in text, (name, there)
            text = text.replace(there, instead)
        (project / name).write_text(text, "utf-8")
    state.mkdir(mode=0o700)
    # The video program: whoever is called takes it, and hangs up at once.
    program = json.dumps([sys.executable, "-c", ""])
    (state / "launch.toml").write_text(f"video-call = {program}\n", "utf-8")
    one = subprocess.Popen(
        [sys.executable, str(project / "start.py"), "--state", str(state)],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        env={**os.environ, "TZ": where_it_is(10, 25)},
    )
    try:
        assert one.stdout is not None
        lines = [one.stdout.readline() for _ in range(3)]
        screen, nurse = (re.search(r"http\S+", line) for line in lines[:2])
        assert screen is not None, lines
        assert nurse is not None, lines
        assert f"tcp://127.0.0.1:{board}" in lines[2]
        yield Started(screen[0], nurse[0], f"tcp://127.0.0.1:{board}", broker, state)
    finally:
        one.terminate()
        one.communicate(timeout=DEADLINE)


class Resident:
    """Somebody before the robot's screen, who sees what is on it and touches it."""

    def __init__(self, page: Page) -> None:
        self.page = page

    def sees(self, component: str) -> Locator:
        return self.page.locator(f'[data-id="{component}"]')

    async def touches(self, *components: str) -> None:
        """One after the other, each as soon as it is there."""
        for component in components:
            await self.sees(component).click()

    async def types(self, component: str, keys: str) -> None:
        await self.sees(component).wait_for()
        await self.page.keyboard.type(keys)

    async def logs_in(self, language: str, room: str, pin: str, greeting: str) -> None:
        await self.touches(language)
        await self.types("room", room)
        await self.touches("confirm")
        await self.types("pin", pin)
        await expect(self.sees("hello")).to_have_text(greeting)
        await self.touches("continue")


async def page_of(browser: Browser) -> Page:
    context = await browser.new_context(viewport={"width": 1280, "height": 800}, locale="en-GB")
    context.set_default_timeout(DEADLINE * 1000)
    return await context.new_page()


@pytest.mark.chromium
@pytest.mark.timeout(180)
def test_every_service_is_used_by_clicks_and_the_nurse_sees_what_came_of_it(
    started: Started, chromium: str
) -> None:
    async def run() -> None:
        async with async_playwright() as playwright:
            browser = await playwright.chromium.launch(executable_path=chromium, args=ARGUMENTS)
            try:
                expect.set_options(timeout=DEADLINE * 1000)
                complaints: list[str] = []
                # Each has a browser of his own: a page behind another one is slow on purpose.
                jack = Resident(await page_of(browser))
                nurse = await page_of(browser)
                for page in (jack.page, nurse):
                    page.on("pageerror", lambda error: complaints.append(str(error)))
                    page.on(
                        "console",
                        lambda line: complaints.append(line.text) if line.type == "error" else None,
                    )
                await jack.page.goto(started.screen)
                await what_begins_by_itself(jack, started)
                await nurse.goto(started.nurse)
                assert "token" not in nurse.url
                await give_limits(nurse)
                await jack.logs_in("english", "12", "1234", "Hello Jack Nilsen")
                await measure(jack)
                await call(jack)
                score = await play(jack, started)
                await be_entertained(jack)
                await jack.touches("help", "back", "goodbye")
                await be_told_and_move_out(jack, nurse)
                haru = jack
                await haru.logs_in("japanese", "21", "2121", "木村はる様、こんにちは")
                await expect(haru.sees("pressure")).to_have_text("血圧")
                await haru.touches("goodbye")
                await night(haru, started)
                await look(nurse, score)
                await look_on(await page_of(browser), started)
                # The browser tells that limits were refused; nothing else went wrong.
                assert [one for one in complaints if "400 (Bad Request)" not in one] == []
            finally:
                await browser.close()

    asyncio.run(run())
    assert {one.stat().st_mode & 0o077 for one in (started.state / "records").iterdir()} == {0}
    assert (started.state / "secrets.toml").stat().st_mode & 0o077 == 0


async def what_begins_by_itself(joan: Resident, started: Started) -> None:
    """The robot tells of the bingo; then it is time for the noon round, which goes to her door."""
    await expect(joan.sees("at")).to_have_text("At 10:30")
    await expect(joan.sees("what")).to_have_text("bingo in the hall")
    await joan.touches("good")
    with situ.connect(started.board, module="settings") as settings:
        settings.set("medication.noon", "10:00")
    await expect(joan.sees("round")).to_have_text("I am on my way to somebody.")
    await joan.touches("english")
    await joan.types("pin", "2718")
    await expect(joan.sees("what")).to_have_text("one drop in each eye")
    await joan.touches("taken", "bye")


async def give_limits(nurse: Page) -> None:
    """So low that whatever is measured lies outside; what makes no sense is not taken."""
    await nurse.get_by_role("link", name="Jack Nilsen").click()
    field = nurse.get_by_label("Systolic, upper limit")
    await field.fill("90")
    await nurse.get_by_role("button", name="Save", exact=True).click()
    await expect(nurse.get_by_role("alert")).to_contain_text("Not saved: systolic")
    await field.fill("105")
    await nurse.get_by_role("button", name="Save", exact=True).click()
    await expect(nurse.get_by_role("alert")).to_have_count(0)
    # At the form that she has just sent.
    await expect(nurse.get_by_role("status")).to_be_in_viewport()
    await expect(nurse.get_by_role("status")).to_have_text("Saved.")
    await expect(field).to_have_value("105")
    # A browser's own form is taken for what it is.
    await nurse.get_by_role("link", name="Ward").click()
    await nurse.get_by_role("link", name="Add a resident").click()
    for label, typed in (("Name", "Bea Lee"), ("Room", "12"), ("PIN", "4321")):
        await nurse.get_by_label(label).fill(typed)
    await nurse.get_by_role("button", name="Add").click()
    await expect(nurse.get_by_role("heading", name="Bea Lee")).to_have_count(1)


async def measure(jack: Resident) -> None:
    """The pressure, again where it is outside of the limits; then oxygen and sugar."""
    await jack.touches("pressure", "start", "now")
    await expect(jack.sees("pressure")).to_have_text(re.compile(r"^\d+ / \d+$"))
    await expect(jack.sees("nurse")).to_contain_text("Your nurse sees this")
    await jack.touches("done", "oxygen", "start")
    await expect(jack.sees("value")).to_have_text(re.compile(r"^\d+ %$"))
    await jack.touches("done", "sugar")
    await expect(jack.sees("value")).to_have_text(re.compile(r"^[\d.]+ mmol/L$"))
    await jack.touches("done")


async def call(jack: Resident) -> None:
    """His daughter, by the video program; then somebody of the staff."""
    await jack.touches("calling", "family")
    await jack.page.get_by_role("option", name="Anna Nilsen").click()
    await expect(jack.sees("question")).to_have_text("Shall I call Anna Nilsen?")
    await jack.touches("yes")
    await expect(jack.sees("ended")).to_have_text("The call has ended.")
    await jack.touches("another", "staff", "yes", "done")


async def play(jack: Resident, started: Started) -> int:
    """To the score, though somebody falls at the first question, and the red button is pressed
    at the second: both times the very question is there again."""
    await jack.touches("game", "start")
    score = 0
    for asked in range(1, 6):
        await expect(jack.sees("count")).to_have_text(f"Question {asked} of 5")
        question = await jack.sees("question").inner_text()
        if asked == 1:
            await fall(jack, started)
        if asked == 2:
            await stop(jack, started)
        await expect(jack.sees("question")).to_have_text(question)
        await jack.touches("second")
        answer = jack.sees("right").or_(jack.sees("wrong"))
        await answer.wait_for()
        score += await jack.sees("right").count()
        await jack.touches("on")
    await expect(jack.sees("score")).to_have_text(f"{score} of 5")
    await jack.touches("done")
    return score


async def fall(jack: Resident, started: Started) -> None:
    """In room 7, told over MQTT by the sensor that she wears: the robot goes, stays until it is
    let go, and comes back."""
    sensor = await asyncio.create_subprocess_exec(
        *(sys.executable, str(VITALS / "modules" / "fall_sensor.py")),
        *("--port", str(started.broker), "--room", "7", "--fall", "0"),
    )
    try:
        await expect(jack.sees("stay")).to_have_text("I stay with you until help is here.")
        await jack.touches("here")
        await expect(jack.sees("thanks")).to_have_text("Thank you for waiting.")
    finally:
        sensor.terminate()
        await sensor.wait()


async def stop(jack: Resident, started: Started) -> None:
    """The red button: nothing is shown while it is pressed in."""
    with situ.connect(started.board, module="stop-button") as button:
        button.set("robot.stop", True)
        await expect(jack.sees("question")).to_have_count(0)
        button.set("robot.stop", False)
        await jack.sees("question").wait_for()


async def be_entertained(jack: Resident) -> None:
    await jack.touches("entertainment", "playMusic", "next")
    await expect(jack.sees("title")).not_to_have_text("")
    await jack.touches("stop", "playFilm")
    playing = jack.sees("movie").locator("video")
    await expect(playing).to_have_js_property("paused", False)
    await jack.touches("stop", "tellStory")
    page = await jack.sees("page").inner_text()
    await jack.touches("on")
    await expect(jack.sees("page")).not_to_have_text(page)
    await jack.touches("stop", "back")


async def be_told_and_move_out(bea: Resident, nurse: Page) -> None:
    """What was for her when nobody could tell it is told as she logs in; then the nurse removes
    her, and the robot lets her do nothing more."""
    await nurse.get_by_role("link", name="Ward").click()
    await nurse.get_by_role("link", name="Medicine").click()
    await nurse.get_by_label("At").fill("09:30")
    await nurse.get_by_label("Message").fill("your sister has called")
    await nurse.get_by_label("For").select_option(label="Room 12, Bea Lee")
    await nurse.get_by_role("button", name="Add").click()
    await bea.logs_in("english", "12", "4321", "Hello Bea Lee")
    await expect(bea.sees("at")).to_have_text("For you, today at 09:30")
    await expect(bea.sees("what")).to_have_text("your sister has called")
    await bea.touches("good")
    await expect(bea.sees("pressure")).to_be_visible()
    await nurse.get_by_role("link", name="Ward").click()
    await nurse.get_by_role("link", name="Bea Lee").click()
    await nurse.get_by_role("link", name="Remove this resident").click()
    await nurse.get_by_role("button", name="Remove Bea Lee").click()
    await expect(nurse.get_by_role("link", name="Bea Lee")).to_have_count(0)
    await expect(bea.sees("sorry")).to_have_text("I am sorry, I can not go on.")
    await bea.touches("continue")
    await nurse.get_by_role("link", name="Jack Nilsen").click()


async def night(haru: Resident, started: Started) -> None:
    """Quiet hours begin as soon as the settings say so; who touches the dark screen is asked."""
    await haru.sees("touch").wait_for()
    with situ.connect(started.board, module="settings") as settings:
        settings.set({"quiet.from": "00:00", "quiet.until": "23:59"})
        await haru.touches("dark")
        await expect(haru.sees("question")).to_have_text("看護師を呼びましょうか。")
        await haru.touches("no")
        settings.set({"quiet.from": "23:58"})
        await haru.sees("touch").wait_for()


async def look(nurse: Page, score: int) -> None:
    """The nurse sees who called and why, and what was measured, played, taken and told."""
    await nurse.get_by_role("link", name="Ward").click()
    calls = nurse.locator("#calls li")
    for why in ("room 7: fall", "room 12: help", "room 12: blood pressure", "wants to talk"):
        await expect(calls.filter(has_text=why)).to_have_count(1)
    helped = calls.filter(has_text="room 12: help")
    await helped.get_by_role("button", name="I am going").click()
    await expect(helped).to_contain_text("seen")
    await nurse.goto(nurse.url.rstrip("/") + "/today")
    await expect(nurse.locator("#medicines")).to_contain_text("taken")
    await expect(nurse.locator("#reminders tr", has_text="bingo")).to_contain_text("told")
    await nurse.get_by_role("link", name="Ward").click()
    await nurse.get_by_role("link", name="Jack Nilsen").click()
    measured = nurse.locator("#readings tbody tr")
    for what, count in ((r"/ \d+.*outside", 2), (r"\d %", 1), ("mmol/L", 1), (f"{score} of 5", 1)):
        await expect(measured.filter(has_text=re.compile(what))).to_have_count(count)


async def look_on(page: Page, started: Started) -> None:
    """A viewer sees that there are calls, but of nobody by name."""
    token = json.loads((started.state / "records" / "tokens.json").read_text("utf-8"))["viewer"]
    await page.goto(f"{started.nurse.partition('?')[0]}?token={token}")
    hidden = page.locator("#residents tbody tr")
    await expect(hidden).to_have_count(4)
    for path in ("", "today", "residents/3"):
        await page.goto(started.nurse.partition("?")[0] + path)
        await expect(page.locator("body")).to_contain_text("•••")
        for private in ("Jack", "Nilsen", "Joan", "oom 12", "oom 7", "mmol/L", "eye"):
            await expect(page.locator("body")).not_to_contain_text(private)
