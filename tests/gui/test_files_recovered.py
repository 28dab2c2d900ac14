"""Files that were renamed or deleted, and not saved, when the studio was killed."""

from __future__ import annotations

import signal
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QSettings, Qt
from tests.gui.test_application_files import Basket, choose, do, errors, key, write
from tests.gui.test_recovery import crash, kept, ran

from situ.document import folder

Start = Callable[..., Any]

TOML = """[project]
name = "ward"
applications = ["day.rbd.xml", "night.rbd.xml"]
spds = "ward.spds.xml"
"""
DAY = """<application name="day" start="1">
  <state no="1"><flow src="turn.rbd.xml"/><expectedevents><event name="done" next="2"/>
  </expectedevents></state>
  <state no="2" final="true"/>
</application>
"""
NIGHT = '<application name="night" start="1"><state no="1" final="true"/></application>\n'
TURN = '<application name="turn" start="1"><state no="1" final="true"/></application>\n'
SPDS = """<spds name="ward">
  <modules><module name="day" resources=""/><module name="night" resources=""/></modules>
  <situation name="all">
    <module name="day" priority="1"/><module name="night" priority="2"/>
  </situation>
</spds>
"""


@pytest.fixture
def home(tmp_path: Path) -> Path:
    """The project's folder."""
    made = tmp_path / "ward"
    made.mkdir()
    for name, text in {
        "situ.toml": TOML,
        "day.rbd.xml": DAY,
        "night.rbd.xml": NIGHT,
        "turn.rbd.xml": TURN,
        "ward.spds.xml": SPDS,
    }.items():
        (made / name).write_text(text)
    return made


def rename(used: Any, file: str, name: str) -> None:
    choose(used, file)
    used.key(Qt.Key.Key_F2)
    write(used, name)
    key(used, Qt.Key.Key_Return)
    used.settle()


def delete(used: Any, file: str) -> None:
    choose(used, file)
    used.key(Qt.Key.Key_Delete)
    key(used, Qt.Key.Key_Return)
    used.settle()


def again(studio: Start, home: Path) -> Any:
    """The next start, at which what was not saved is brought back."""
    used = studio(home)
    used.basket = used.session.throw_away = Basket()
    used.click(used.window.recovered.buttons[0])
    used.settle()
    return used


def test_the_old_file_of_one_that_was_renamed_goes_when_the_next_start_saves(
    studio: Start, home: Path
) -> None:
    first = studio(home)
    rename(first, "night.rbd.xml", "late")
    rename(first, "ward.spds.xml", "first")
    crash(first)
    used = again(studio, home)
    assert used.session.files == ["day.rbd.xml", "late.rbd.xml", "turn.rbd.xml", "first.spds.xml"]
    # All of it is one step.
    assert used.session.undo_text == "Bring back unsaved changes"
    do(used, "undo")
    assert used.session.undo_text is None
    assert used.session.dirty == []
    assert used.session.files == ["day.rbd.xml", "night.rbd.xml", "turn.rbd.xml", "ward.spds.xml"]
    do(used, "redo")
    assert used.basket.held == {}
    do(used, "save")
    assert used.basket.held == {"night.rbd.xml": NIGHT.encode(), "ward.spds.xml": SPDS.encode()}
    assert used.session.dirty == []
    assert errors(home) == []
    found, _ = folder.load(home)
    assert found is not None
    assert found.spds_file == "first.spds.xml"
    assert [*found.applications] == ["day.rbd.xml", "late.rbd.xml"]


def test_that_a_part_was_deleted_is_kept_though_nothing_else_was_changed(
    studio: Start, home: Path, settings: QSettings
) -> None:
    first = studio(home)
    delete(first, "turn.rbd.xml")
    crash(first)
    assert len(kept(settings)) == 1
    used = again(studio, home)
    assert "turn.rbd.xml" not in used.session.files
    do(used, "save")
    assert used.basket.held == {"turn.rbd.xml": TURN.encode()}
    assert kept(settings) == []


def test_a_script_that_was_begun_and_not_saved_is_brought_back(studio: Start, home: Path) -> None:
    (home / "situ.toml").write_text(TOML.replace('spds = "ward.spds.xml"\n', ""))
    (home / "ward.spds.xml").unlink()
    first = studio(home)
    do(first, "begin_script")
    crash(first)
    used = again(studio, home)
    do(used, "save")
    found, _ = folder.load(home)
    assert found is not None
    assert found.spds is not None
    assert errors(home) == []


def test_no_file_goes_where_not_all_can_be_brought_back(studio: Start, home: Path) -> None:
    first = studio(home)
    rename(first, "night.rbd.xml", "late")
    crash(first)
    # Another program breaks what it was renamed in, and what it was called.
    for file in ("ward.spds.xml", "night.rbd.xml"):
        broken = (home / file).read_text().replace('name="', 'x="1" name="', 1)
        (home / file).write_text(broken)
    used = again(studio, home)
    assert "late.rbd.xml" in used.session.files
    do(used, "save")
    assert used.basket.held == {}
    assert "night.rbd.xml" not in used.session.dirty
    assert 'x="1"' in (home / "night.rbd.xml").read_text()
    assert 'x="1"' in (home / "ward.spds.xml").read_text()


def test_a_file_that_another_program_changed_after_the_crash_stays(
    studio: Start, home: Path
) -> None:
    first = studio(home)
    rename(first, "night.rbd.xml", "late")
    delete(first, "turn.rbd.xml")
    crash(first)
    (home / "night.rbd.xml").write_text(NIGHT.replace('no="1"', 'no="1" name="Later"'))
    used = again(studio, home)
    told = "night.rbd.xml could not go into the waste basket: it stays in the folder."
    assert used.window.status.said.text() == told
    do(used, "save")
    assert used.basket.held == {"turn.rbd.xml": TURN.encode()}
    assert "Later" in (home / "night.rbd.xml").read_text()
    assert used.session.files == ["day.rbd.xml", "late.rbd.xml", "ward.spds.xml"]
    assert used.session.dirty == []


_KILLED = """
import os, signal, sys
from pathlib import Path
from PySide6.QtCore import QSettings
from situ_studio import main
window = main.create_window(Path(sys.argv[1]), QSettings(sys.argv[2], QSettings.Format.IniFormat))
window.open_file("night.rbd.xml")
window.commands.rename_file()
window.document_files.dialog.name.setText("late")
window.document_files.dialog.rename.click()
window.recovery.keep()
window.session.throw_away = lambda file: os.kill(os.getpid(), signal.SIGKILL)
window.commands.save()
"""


def test_a_file_goes_though_the_studio_was_killed_when_all_but_that_was_saved(
    studio: Start, home: Path, settings: QSettings, tmp_path: Path
) -> None:
    ended = ran(_KILLED, str(home), settings.fileName(), home=tmp_path)
    assert ended.returncode == -signal.SIGKILL, ended.stderr
    assert '"late.rbd.xml"' in (home / "situ.toml").read_text()
    assert (home / "night.rbd.xml").read_text() == NIGHT
    used = again(studio, home)
    assert "night.rbd.xml" in used.session.dirty
    do(used, "save")
    assert used.basket.held == {"night.rbd.xml": NIGHT.encode()}
    assert used.session.dirty == []
    assert errors(home) == []
