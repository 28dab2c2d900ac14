"""A script for a project that has none: one step, with the file that names it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import Qt

from situ.document.check import check
from situ.document.folder import load

CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
Start = Callable[..., Any]


@pytest.fixture
def used(studio: Start, tmp_path: Path) -> Any:
    used = studio()
    used.answers.put("name", "ward")
    used.answers.put("new_folder", str(tmp_path))
    used.click(used.window.welcome.new)
    return used


def begin(used: Any) -> None:
    """By its name, among all commands."""
    used.key(Qt.Key.Key_K, CONTROL)
    used.type("script of situations")
    used.key(Qt.Key.Key_Return)


def test_it_is_opened_saved_and_found_again(used: Any, tmp_path: Path) -> None:
    begin(used)
    used.window.actions_.refresh()
    assert not used.window.actions_.actions["begin_script"].isVisible()
    assert used.window.current_file == "ward.spds.xml"
    assert used.window.current_view.mode == "graph"
    used.key(Qt.Key.Key_S, CONTROL)
    assert used.session.dirty == []
    project, problems = load(tmp_path / "ward")
    assert problems == []
    assert project is not None
    assert project.spds == used.window.current_document
    assert [p for p in check(project) if p.severity == "error"] == []


def test_it_is_one_step(used: Any) -> None:
    before = used.session.project
    begin(used)
    used.key(Qt.Key.Key_Z, CONTROL)
    assert used.session.files == ["ward.rbd.xml"]
    assert used.session.project == before
    assert used.window.tabs.files() == ["ward.rbd.xml"]
    used.key(Qt.Key.Key_Z, CONTROL | SHIFT)
    assert used.session.files == ["ward.rbd.xml", "ward.spds.xml"]
    assert 'spds = "ward.spds.xml"' in used.session.value("situ.toml").text
