"""docs/tutorial.md: whoever does what it says has a robot that measures, and no problem is left.

``make tutorial`` makes its pictures anew.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtWidgets import QApplication, QFileDialog
from tests.gui.test_newcomer import situ
from tests.gui.tutorial.pupil import Pupil
from tests.gui.tutorial.steps import STEPS

from situ_studio.window.dialogs import Dialogs

DOCS = Path(__file__).resolve().parents[3] / "docs"
ANEW = bool(os.environ.get("SITU_PICTURES"))
GESTURES = 180
"""Of five seconds each: a quarter of an hour."""
SEEN = {
    "Speech Hello": "Speech",
    "What Service measure answers": "its answer",
}
"""What is seen of what a screen reader says."""
LARGEST = 60_000
"""Bytes of a picture."""
MEASURED = {"systolic": 121, "diastolic": 79}


@pytest.fixture(autouse=True)
def nothing_blinks(qt: QApplication) -> Iterator[None]:
    before = qt.cursorFlashTime()
    qt.setCursorFlashTime(0)
    yield
    qt.setCursorFlashTime(before)


def sections() -> dict[str, str]:
    """Of the tutorial, by their headings, in their order."""
    text = (DOCS / "tutorial.md").read_text(encoding="utf-8")
    _, *every = re.split(r"^## ", text, flags=re.MULTILINE)
    return {one.partition("\n")[0]: one.partition("\n")[2] for one in every}


def missing(words: list[str], section: str) -> set[str]:
    """What a person would not know from the section; how it is set off does not count."""
    plain = " ".join(re.sub(r"[*`|]", "", section).split())
    return {word for word in words if SEEN.get(word, word) not in plain}


def test_the_steps_of_the_tutorial_make_a_robot_that_measures(
    studio: Callable[..., Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    window = studio().window
    window.dialogs = Dialogs(window)
    monkeypatch.setattr(QFileDialog, "getExistingDirectory", lambda *_: str(tmp_path))
    me = Pupil(window, DOCS / "tutorial" if ANEW else None)
    told = sections()
    # The last section is done in a terminal.
    assert len(told) == len(STEPS) + 1
    for number, (step, heading) in enumerate(zip(STEPS, told, strict=False), start=1):
        assert heading == f"{number}. {step.__doc__}"
        me.written, me.looked = [], []
        step(me)
        assert not missing(me.written, told[heading]), f"section {heading}"
        pictures = re.findall(r"!\[[^]]+\]\(tutorial/([\w-]+)\.png\)", told[heading])
        assert pictures == me.looked, f"section {heading}"
    assert me.gestures <= GESTURES
    me.widget("0 errors")
    me.widget("0 warnings")
    window.close()

    folder = tmp_path / "blood-pressure"
    checked = situ("check", str(folder))
    assert (checked.returncode, checked.stdout, checked.stderr) == (0, "", "")
    tested = situ("test", str(folder), "--json")
    assert tested.returncode == 0, tested.stdout
    script = tmp_path / "lower.jsonl"
    lines: list[dict[str, Any]] = [
        {"at": 6, "use": {"component": "start"}},
        {"at": 9, "finish": {"action": "service", "name": "measure", "result": MEASURED}},
        {"at": 9, "expect": {"kind": "enter", "state": "3"}},
        {"at": 70, "expect": {"kind": "enter", "state": "1"}},
    ]
    script.write_text("".join(json.dumps(line) + "\n" for line in lines), encoding="utf-8")
    played = situ("simulate", str(folder), "--script", str(script))
    assert played.returncode == 0, played.stderr
    assert "Your blood pressure is 121 over 79. That is good." in played.stdout


def test_every_picture_of_the_tutorial_is_shown_in_it_and_small() -> None:
    shown = set(re.findall(r"\(tutorial/([\w-]+\.png)\)", "".join(sections().values())))
    kept = {file.name: file.stat().st_size for file in (DOCS / "tutorial").iterdir()}
    assert shown == set(kept)
    assert [name for name, size in kept.items() if size > LARGEST] == []
