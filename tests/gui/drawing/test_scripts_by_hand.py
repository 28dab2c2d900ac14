"""What a script and the modules around it have is written where it stands."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import Qt
from tests.gui.drawing.projects import ADD, ProjectDrawer
from tests.gui.test_newcomer import CONTROL

from situ.document.modules import Module, Modules, Provides
from situ.document.spds import Entry
from situ_studio.edits.notes import note_of

Start = Callable[..., Any]
Copy = Callable[[str], Path]
TAB = Qt.Key.Key_Tab
INFORMATION = "What modules say of themselves"


def test_a_priority_that_is_added_is_written_at_once(studio: Start, project: Copy) -> None:
    used = studio(project("conversation"))
    me = ProjectDrawer(used.window)
    me.open_in_tree("conversation")
    used.select("situation", "sound")
    me.press_in_form("Add a priority")
    for text in ("converse", "35"):
        me.write(me.focus(), text)
        me.key(TAB)
    script = used.session.project.spds
    assert script.situation("sound").entries[-1] == Entry("converse", 35)
    me.fill_form({"Note": "A glance"})
    assert note_of(used.session.project.spds.situation("sound")) == "A glance"


def test_a_project_without_module_information_gets_some(studio: Start, tmp_path: Path) -> None:
    used = studio()
    used.answers.put("new_folder", str(tmp_path))
    used.answers.put("name", "ward")
    used.click(used.window.welcome.new)
    me = ProjectDrawer(used.window)
    me.choose_in_menu(INFORMATION, lambda: me.click(ADD))
    me.settle()
    drawn = Modules((Module("cuff", (), "Asks", (), (Provides("bp.pulse", "number", "bpm"),)),))
    me.draw_information(drawn)
    used.key(Qt.Key.Key_S, CONTROL)
    assert used.session.project.modules == drawn
    assert 'modules = "modules.xml"' in (tmp_path / "ward" / "situ.toml").read_text()
    assert "bp.pulse" in (tmp_path / "ward" / "modules.xml").read_text()
    while used.session.undo_text is not None:
        used.key(Qt.Key.Key_Z, CONTROL)
    assert used.session.project.modules is None
    assert used.session.files == ["ward.rbd.xml"]
