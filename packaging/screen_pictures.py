"""Takes a picture of every screen that a project's scenarios come to, in each of its languages.

    python packaging/screen_pictures.py examples/vitals FOLDER

One PNG a screen in chromium, 1280 × 800, as FOLDER/LANGUAGE-APPLICATION-STATE.png: to be looked at.
Exit status 1 where a text does not fit on its component. What a service would answer is what the
scenarios say; a button that chooses a language chooses the one whose pictures are taken.
"""

from __future__ import annotations

import asyncio
import re
import shutil
import sys
import tempfile
from pathlib import Path
from typing import Any

import msgspec
from playwright.async_api import Page, async_playwright

from situ.decide.effects import Map
from situ.document.project import Project
from situ.document.ready import load_ready
from situ.engine.perform import Performer
from situ.rehearse.recording import record
from situ.rehearse.scenario import load
from situ.rehearse.suite import scenarios
from situ.system_libraries import PATH

ARGUMENTS = ["--no-sandbox", "--disable-gpu", "--force-prefers-reduced-motion"]
CUT = "[...document.querySelectorAll('[data-cut]')].map(one => one.dataset.id)"
SHOWN = "count => document.querySelectorAll('[data-id]').length === count"
SETTLED = (
    "document.fonts.ready.then(() => document.getAnimations().every(one => one.finish() || 1))"
)
CHOICE = re.compile(r'(tag="language" value=")[^"]*"')

Screens = dict[tuple[str, str], list[dict[str, Any]]]
"""The components by application and state."""


def speaking(folder: Path, language: str) -> Project:
    """A copy's project that starts in a language, and whose buttons choose no other."""
    for file in folder.glob("*.rbd.xml"):
        text = file.read_text("utf-8")
        file.write_text(CHOICE.sub(rf'\g<1>{language}"', text), "utf-8")
    project = load_ready(folder)
    return msgspec.structs.replace(project, tags={**project.tags, "language": language})


def screens(project: Project) -> Screens:
    """Those that a scenario comes to, as it is first seen there; empty ones are none."""
    found: Screens = {}
    for file in scenarios(project):
        recording, _ = record(project, load(file))
        for event in recording.events:
            if event["kind"] == "screen" and event["components"]:
                where = (str(event["application"]), str(event["state"]))
                found.setdefault(where, event["components"])
    return dict(sorted(found.items()))


async def take(page: Page, robot: Performer, language: str, shown: Screens, out: Path) -> int:
    """Returns how many have a text that does not fit."""
    cut = 0
    for (application, state), components in shown.items():
        # Empty in between: another screen with as many components would be taken for this one.
        for those in ([], components):
            value = {"components": those, "background": None}
            robot.perform(Map("screen", application, value, ()))
            await page.wait_for_function(SHOWN, arg=len(those))
        await page.evaluate(SETTLED)
        if too_long := await page.evaluate(CUT):
            cut += 1
            print(f"{language} {application} {state}: does not fit: {', '.join(too_long)}")
        name = f"{language}-{application}-{state.replace('/', '_')}.png"
        await page.screenshot(path=out / name)
    return cut


async def main(project: Path, out: Path) -> int:
    out.mkdir(parents=True, exist_ok=True)
    chromium = shutil.which("chromium", path=PATH)
    if chromium is None:
        sys.exit("chromium is not installed: sudo apt-get install chromium")
    cut = 0
    async with async_playwright() as playwright:
        browser = await playwright.chromium.launch(executable_path=chromium, args=ARGUMENTS)
        for language in load_ready(project).languages:
            with tempfile.TemporaryDirectory() as copied:
                shutil.copytree(project, copied, dirs_exist_ok=True)
                speaks = speaking(Path(copied), language)
                robot = Performer(
                    speaks, lambda _: None, sound=False, captions=False, services=("screen",)
                )
                await robot.start()
                page = await browser.new_page(viewport={"width": 1280, "height": 800})
                await page.goto(robot.screen_url or "")
                shown = screens(speaks)
                cut += await take(page, robot, language, shown, out)
                print(f"{language}: {len(shown)} screens in {out}")
                await page.close()
                await robot.close()
        await browser.close()
    return 1 if cut else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(asyncio.run(main(Path(sys.argv[1]), Path(sys.argv[2]))))
