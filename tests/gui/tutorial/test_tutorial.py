"""docs/tutorial.md, and docs/tutorial.ja.md in Japanese: whoever does what it says has a robot that
measures, and no problem is left.

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
from PySide6.QtCore import QSettings
from PySide6.QtWidgets import QApplication, QFileDialog
from tests.gui.test_newcomer import situ
from tests.gui.tutorial.pupil import Pupil
from tests.gui.tutorial.steps import STEPS

from situ_studio.window.dialogs import Dialogs

DOCS = Path(__file__).resolve().parents[3] / "docs"
ANEW = bool(os.environ.get("SITU_PICTURES"))
GESTURES = 180
"""Of five seconds each: a quarter of an hour."""
FILES = {"en": "tutorial.md", "ja": "tutorial.ja.md"}
PICTURES = {"en": "tutorial", "ja": "tutorial/ja"}
SEEN = {
    "Speech Hello": "Speech",
    "発話 こんにちは": "発話",
    "What Service measure answers": "its answer",
    "サービス measure の答え": "答え",
}
"""What is seen of what a screen reader says."""
LARGEST = 64_000
"""Bytes of a picture."""
MEASURED = {"systolic": 121, "diastolic": 79}


@pytest.fixture(autouse=True)
def nothing_blinks(qt: QApplication) -> Iterator[None]:
    before = qt.cursorFlashTime()
    qt.setCursorFlashTime(0)
    yield
    qt.setCursorFlashTime(before)


def sections(language: str) -> dict[str, str]:
    """Of the tutorial, by their headings, in their order."""
    text = (DOCS / FILES[language]).read_text(encoding="utf-8")
    _, *every = re.split(r"^## ", text, flags=re.MULTILINE)
    return {one.partition("\n")[0]: one.partition("\n")[2] for one in every}


def missing(words: list[str], section: str) -> set[str]:
    """What a person would not know from the section; how it is set off does not count."""
    plain = " ".join(re.sub(r"[*`|]", "", section).split())
    return {word for word in words if SEEN.get(word, word) not in plain}


@pytest.mark.parametrize("language", FILES)
def test_the_steps_of_the_tutorial_make_a_robot_that_measures(
    studio: Callable[..., Any],
    settings: QSettings,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    language: str,
) -> None:
    settings.setValue("language", language)
    window = studio().window
    window.dialogs = Dialogs(window)
    monkeypatch.setattr(QFileDialog, "getExistingDirectory", lambda *_: str(tmp_path))
    me = Pupil(window, DOCS / PICTURES[language] if ANEW else None, language)
    told = sections(language)
    # The last section is done in a terminal.
    assert len(told) == len(STEPS) + 1
    for number, (step, heading) in enumerate(zip(STEPS, told, strict=False), start=1):
        assert heading == f"{number}. {me.here(step.__doc__ or '')}"
        me.written, me.looked = [], []
        step(me)
        assert not missing(me.written, told[heading]), f"section {heading}"
        pictures = re.findall(r"!\[[^]]+\]\(tutorial/(?:ja/)?([\w-]+)\.png\)", told[heading])
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
        {"at": 6, "use": {"component": me.here("START").lower()}},
        {"at": 9, "finish": {"action": "service", "name": "measure", "result": MEASURED}},
        {"at": 9, "expect": {"kind": "enter", "state": "3"}},
        {"at": 70, "expect": {"kind": "enter", "state": "1"}},
    ]
    script.write_text("".join(json.dumps(line) + "\n" for line in lines), encoding="utf-8")
    played = situ("simulate", str(folder), "--script", str(script))
    assert played.returncode == 0, played.stderr
    said = me.here("Your blood pressure is {bp.systolic} over {bp.diastolic}. That is good.")
    for tag, value in MEASURED.items():
        said = said.replace(f"{{bp.{tag}}}", str(value))
    assert said in played.stdout


@pytest.mark.parametrize("language", FILES)
def test_every_picture_of_the_tutorial_is_shown_in_it_and_small(language: str) -> None:
    folder = PICTURES[language]
    shown = set(re.findall(rf"\({folder}/([\w-]+\.png)\)", "".join(sections(language).values())))
    kept = {file.name: file.stat().st_size for file in (DOCS / folder).glob("*.png")}
    assert shown == set(kept)
    assert [name for name, size in kept.items() if size > LARGEST] == []
