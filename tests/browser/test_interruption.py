"""A film on the robot's screen gives way to a higher situation, and begins again after it."""

from __future__ import annotations

import asyncio
import shutil
from pathlib import Path
from typing import Any

import pytest
from playwright.async_api import expect

from situ.blackboard.client import connect_async
from situ.document.ready import load_ready
from situ.engine.deciding import Setup
from situ.engine.live import Live
from situ.engine.perform import Performer
from situ.resources import example

pytestmark = pytest.mark.chromium

WARD = Path(__file__).parents[1] / "engine" / "ward"
DEADLINE = 20.0
PLAYS = "() => document.querySelector('video')?.currentTime > 0"


def test_a_film_that_was_interrupted_begins_again_and_says_when_it_has_ended(
    theatre: Any, tmp_path: Path
) -> None:
    folder = tmp_path / "ward"
    shutil.copytree(WARD, folder)
    (folder / "media").mkdir()
    shutil.copy(example("reception") / "media" / "clip.webm", folder / "media")
    project = load_ready(folder)

    def performer(submit: Any, tag: Any) -> Performer:
        return Performer(project, submit, tag=tag, services=("screen",), sound=False)

    async def within(robot: Live) -> None:
        addresses = await robot.start()
        async with (
            theatre.window(addresses.http) as page,
            connect_async(addresses.requests, "nurse", ["base", "screen", "speech"]) as nurse,
            nurse.authority("base", "screen", "speech") as body,
            nurse.watch("application/film") as film,
        ):
            video = page.locator("video")
            await page.wait_for_function(PLAYS)
            await video.evaluate("one => { one.mark = 1; }")
            await nurse.set("emergency", True)
            await body.wait(DEADLINE)
            alarm = {"type": "text", "id": "alarm", "x": 10, "y": 40, "width": 80, "height": 20}
            await body.command({"components": [alarm | {"text": "Help comes"}]}, resource="screen")
            await expect(page.get_by_text("Help comes")).to_be_visible()
            assert await video.count() == 0
            await nurse.set("emergency", False)
            await page.wait_for_function(PLAYS)
            # It is another one, that began at its beginning; it runs faster than in life.
            assert await video.evaluate("one => one.mark ?? null") is None
            await video.evaluate("one => { one.playbackRate = 16; }")
            await expect(page.get_by_text("Good bye")).to_be_visible()
            while (change := await film.next(DEADLINE)) is not None:
                if change.value["state"] == "2":
                    break
            assert change is not None

    async def whole() -> None:
        robot = Live(project, Setup(), performer)
        try:
            async with asyncio.timeout(3 * DEADLINE):
                await within(robot)
        finally:
            await robot.stop()

    theatre.loop.run_until_complete(whole())
