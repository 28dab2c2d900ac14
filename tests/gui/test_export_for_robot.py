"""What a robot needs is written from the File menu, too: nobody has to open a terminal for it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

Start = Callable[..., Any]
Copy = Callable[[str], Path]


def test_what_a_robot_needs_is_put_into_a_folder_of_its_own(
    studio: Start, project: Copy, tmp_path: Path
) -> None:
    used = studio(project("reception"))
    export = used.window.actions_.actions["export_robot"]
    used.answers.put("new_folder", str(tmp_path / "stick"))
    export.trigger()
    folder = tmp_path / "stick" / "reception-robot"
    written = {file.name for file in folder.iterdir()}
    assert {"situ.toml", "reception.rbd.xml", "media", "texts"} <= written
    assert "scenarios" not in written
    assert "urn:situ:editor" not in (folder / "reception.rbd.xml").read_text(encoding="utf-8")
    assert str(folder) in used.window.status.said.text()

    # What is there stays.
    used.answers.put("new_folder", str(tmp_path / "stick"))
    export.trigger()
    assert "is not empty" in used.answers.told[-1]

    used.answers.put("new_folder", None)
    export.trigger()
    assert len(used.answers.told) == 1


def test_what_is_not_saved_is_saved_first(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    window = used.window
    window.open_file("reception.rbd.xml")
    used.select("state", "13")
    used.fill(window.inspector.form.field("name"), "oxygen")
    window.actions_.actions["export_robot"].trigger()
    assert "Save first" in window.status.said.text()


def test_a_project_with_errors_is_not_exported(
    studio: Start, project: Copy, tmp_path: Path
) -> None:
    folder = project("reception")
    file = folder / "reception.rbd.xml"
    text = file.read_text(encoding="utf-8")
    file.write_text(text.replace('next="2"', 'next="222"'), encoding="utf-8")
    used = studio(folder)
    used.answers.put("new_folder", str(tmp_path / "stick"))
    used.window.actions_.actions["export_robot"].trigger()
    assert used.answers.told
    assert not (tmp_path / "stick").exists()
