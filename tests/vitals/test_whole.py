"""examples/vitals as its README starts it, used in a real browser."""

from __future__ import annotations

import asyncio
import os
import re
import shutil
import socket
import subprocess
import sys
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path

import pytest
from playwright.async_api import Page, async_playwright, expect

VITALS = Path(__file__).resolve().parents[2] / "examples" / "vitals"
DEADLINE = 30.0
ARGUMENTS = ["--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking"]


def free_port() -> int:
    with socket.create_server(("127.0.0.1", 0)) as free:
        port: int = free.getsockname()[1]
    return port


def where_it_is_early() -> str:
    """A time zone in which it is ten past seven: quiet hours are over, no round has begun."""
    now = datetime.now(UTC)
    hours, minutes = divmod((now.hour * 60 + now.minute - 7 * 60 - 10) % (24 * 60), 60)
    return f"WARD{hours:02}:{minutes:02}"


@pytest.fixture
def addresses(tmp_path: Path, mosquitto: str) -> Iterator[tuple[str, str]]:
    """Of the robot's screen and of the nurse's page; all is started, by one command."""
    assert mosquitto
    project = tmp_path / "vitals"
    shutil.copytree(VITALS, project, ignore=shutil.ignore_patterns("__pycache__"))
    toml = (project / "situ.toml").read_text("utf-8")
    toml = toml.replace("127.0.0.1:5570", "127.0.0.1:0")
    toml = toml.replace(":8081", f":{free_port()}").replace(":1883", f":{free_port()}")
    (project / "situ.toml").write_text(toml, "utf-8")
    command = [sys.executable, str(project / "start.py"), "--state", str(tmp_path / "state")]
    started = subprocess.Popen(
        command,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        env={**os.environ, "TZ": where_it_is_early()},
    )
    try:
        assert started.stdout is not None
        lines = [started.stdout.readline() for _ in range(2)]
        screen, nurse = (re.search(r"http\S+", line) for line in lines)
        assert screen is not None, lines
        assert nurse is not None, lines
        yield screen[0], nurse[0]
    finally:
        started.terminate()
        started.communicate(timeout=DEADLINE)


@pytest.mark.chromium
def test_one_command_starts_all_and_a_call_reaches_the_nurse(
    addresses: tuple[str, str], chromium: str, tmp_path: Path
) -> None:
    async def run() -> None:
        async with async_playwright() as playwright:
            browser = await playwright.chromium.launch(executable_path=chromium, args=ARGUMENTS)
            try:
                context = await browser.new_context(viewport={"width": 1280, "height": 800})
                context.set_default_timeout(DEADLINE * 1000)
                complaints: list[str] = []
                robot, nurse = await context.new_page(), await context.new_page()
                for page in (robot, nurse):
                    page.on("pageerror", lambda error: complaints.append(str(error)))
                    page.on(
                        "console",
                        lambda line: complaints.append(line.text) if line.type == "error" else None,
                    )
                await log_in(robot, addresses[0])
                await robot.locator('[data-id="help"]').click()
                await robot.locator('[data-id="called"]').wait_for()
                await look(nurse, addresses[1])
                # The browser tells that limits were refused; nothing else went wrong.
                assert [one for one in complaints if "400 (Bad Request)" not in one] == []
            finally:
                await browser.close()

    asyncio.run(run())
    kept = tmp_path / "state" / "records"
    assert {one.stat().st_mode & 0o077 for one in kept.iterdir()} == {0}
    assert (tmp_path / "state" / "secrets.toml").stat().st_mode & 0o077 == 0


async def log_in(page: Page, address: str) -> None:
    await page.goto(address)
    await page.locator('[data-id="english"]').click()
    await page.locator('[data-id="room"]').wait_for()
    await page.keyboard.type("12")
    await page.locator('[data-id="confirm"]').click()
    await page.locator('[data-id="pin"]').wait_for()
    await page.keyboard.type("1234")
    await expect(page.locator('[data-id="hello"]')).to_have_text("Hello Jack Nilsen")
    await page.locator('[data-id="continue"]').click()
    await page.locator('[data-id="pressure"]').wait_for()


async def look(page: Page, address: str) -> None:
    """The nurse sees the call and goes, and gives somebody limits of his own."""
    await page.goto(address)
    assert "token" not in page.url
    call = page.locator("#calls li")
    while await call.count() == 0:
        await page.reload()
    await expect(call).to_contain_text("room 12: help")
    await page.get_by_role("button", name="I am going").click()
    await expect(call).to_contain_text("seen")
    await page.get_by_role("link", name="Jack Nilsen").click()
    field = page.get_by_label("Systolic, upper limit")
    await field.fill("90")
    await page.get_by_role("button", name="Save", exact=True).click()
    await expect(page.get_by_role("alert")).to_contain_text("Not saved: systolic")
    await field.fill("165")
    await page.get_by_role("button", name="Save", exact=True).click()
    await expect(page.get_by_role("alert")).to_have_count(0)
    await expect(field).to_have_value("165")
    # A browser's own form is taken for what it is.
    await page.get_by_role("link", name="Ward").click()
    await page.get_by_role("link", name="Add a resident").click()
    for label, typed in (("Name", "Bea Lee"), ("Room", "12"), ("PIN", "4321")):
        await page.get_by_label(label).fill(typed)
    await page.get_by_role("button", name="Add").click()
    await expect(page.get_by_role("heading", name="Bea Lee")).to_have_count(1)
