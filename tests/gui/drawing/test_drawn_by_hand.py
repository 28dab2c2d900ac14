"""The examples are drawn by hand, from an empty project: what is saved is what they are.

All of them only with ``SITU_SOAK=1`` (``make soak``); what is drawn lies elsewhere on the canvas.
"""

from __future__ import annotations

import os
import re
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog
from tests.gui.drawing.projects import ProjectDrawer
from tests.gui.test_newcomer import CONTROL

from situ.document import folder
from situ.document.project import Project
from situ.resources import example
from situ_studio.window.dialogs import Dialogs

Start = Callable[..., Any]
Hand = Callable[[str], tuple[ProjectDrawer, Project]]
SOAK = bool(os.environ.get("SITU_SOAK"))


@pytest.fixture
def hand(studio: Start, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Hand:
    """``hand(name)``: at an empty window, who draws that example, and the example."""

    def begin(name: str) -> tuple[ProjectDrawer, Project]:
        wanted, _ = folder.load(example(name))
        assert wanted is not None
        window = studio().window
        window.resize(1700, 1150)
        window.dialogs = Dialogs(window)
        me = ProjectDrawer(window)
        # The desktop's own questions, in most places programs of their own.
        monkeypatch.setattr(QFileDialog, "getExistingDirectory", lambda *_: str(tmp_path))
        monkeypatch.setattr(
            QFileDialog,
            "getOpenFileName",
            lambda *asked: (str(media_of(example(name) / "media", me.wanted_file, asked[-1])), ""),
        )
        return me, wanted

    return begin


def media_of(media: Path, name: str, endings: str) -> Path:
    """The file of that name; where it is named by data, another one of its sort."""
    fits = [file for file in sorted(media.iterdir()) if f"*{file.suffix}" in endings]
    return next((file for file in fits if file.name == name), fits[0])


def plain(text: str) -> str:
    """Without where things lie, and with each comment in one line."""
    text = re.sub(r' ed:(x|y|width|height)="[^"]*"', "", text)
    text = re.sub(r'(<ed:\w+)((?: \w+="[^"]*")*)', _unplaced, text)
    return re.sub(r"<!--.*?-->", lambda m: " ".join(m[0].split()), text, flags=re.DOTALL)


def _unplaced(found: re.Match[str]) -> str:
    return found[1] + re.sub(r' (x|y|width|height)="[^"]*"', "", found[2])


def test_an_application_is_drawn_as_it_is(hand: Hand, tmp_path: Path) -> None:
    me, wanted = hand("vitals")
    me.begin_project("calls")
    me.draw(wanted.applications["calls.rbd.xml"])
    me.key(Qt.Key.Key_S, CONTROL)
    drawn = (tmp_path / "calls" / "calls.rbd.xml").read_text(encoding="utf-8")
    assert plain(drawn) == plain((example("vitals") / "calls.rbd.xml").read_text(encoding="utf-8"))


@pytest.mark.skipif(not SOAK, reason="only in make soak")
@pytest.mark.parametrize("name", ["reception", "vitals"])
def test_a_whole_project_is_drawn_as_it_is(hand: Hand, tmp_path: Path, name: str) -> None:
    """Its documents, its values and its translations; media only where something shows them."""
    me, wanted = hand(name)
    me.draw_project(wanted)
    me.key(Qt.Key.Key_S, CONTROL)
    print(f"{name}: {me.gestures} gestures")
    files = [*wanted.flows, wanted.spds_file, wanted.modules_file]
    for file in filter(None, files):
        drawn = (tmp_path / name / file).read_text(encoding="utf-8")
        assert plain(drawn) == plain((example(name) / file).read_text(encoding="utf-8")), file
    tables = [
        tomllib.loads((root / "situ.toml").read_text(encoding="utf-8"))
        for root in (tmp_path / name, example(name))
    ]
    assert tables[0] == tables[1]
    again, _ = folder.load(tmp_path / name)
    assert again is not None
    assert again.texts == wanted.texts
