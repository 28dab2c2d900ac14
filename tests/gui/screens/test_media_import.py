"""Files come into a project's media under safe names, once, and only what the page can show."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication

from situ.document.project import Project
from situ.document.rbd import Application
from situ.engine.screen.server import _MEDIA_TYPES
from situ.errors import UsageError
from situ_studio.edits.vocabulary import Lexicon
from situ_studio.looks.theme import LIGHT
from situ_studio.panels.subject import Subject
from situ_studio.screens import media_import, media_pictures
from situ_studio.screens.media_import import bring, free_name
from situ_studio.views.table import Setting


@pytest.fixture
def project(tmp_path: Path) -> Project:
    (tmp_path / "project" / "media").mkdir(parents=True)
    return Project(root=str(tmp_path / "project"), name="p", media="media")


def file(tmp_path: Path, name: str, data: bytes) -> Path:
    made = tmp_path / "elsewhere" / name
    made.parent.mkdir(exist_ok=True)
    made.write_bytes(data)
    return made


def names(project: Project) -> list[str]:
    return sorted(one.name for one in (Path(project.root) / "media").iterdir())


def test_a_file_is_copied_under_a_safe_name_that_is_free(project: Project, tmp_path: Path) -> None:
    first = bring(project, file(tmp_path, "Mein Hund (1).PNG", b"one"))
    second = bring(project, file(tmp_path, "mein-hund-1.png", b"two"))
    assert (first, second) == ("mein-hund-1.png", "mein-hund-1-2.png")
    assert (Path(project.root) / "media" / second).read_bytes() == b"two"


def test_the_same_bytes_are_not_copied_twice(project: Project, tmp_path: Path) -> None:
    first = bring(project, file(tmp_path, "a.png", b"same"))
    assert bring(project, file(tmp_path, "b.png", b"same")) == first
    assert media_import.bring_bytes(project, b"same", "pasted.png") == first
    assert names(project) == ["a.png"]


def test_a_project_without_a_media_folder_gets_one(tmp_path: Path) -> None:
    bare = Project(root=str(tmp_path / "bare"), name="p")
    src = bring(bare, file(tmp_path, "a.webm", b"movie"))
    assert src == "media/a.webm"
    assert (Path(bare.root) / src).is_file()


@pytest.mark.parametrize(
    ("name", "data", "said"),
    [
        ("notes.txt", b"x", "takes .png"),
        ("gone.png", None, "is no file"),
        ("large.png", b"x" * 101, "make it smaller"),
    ],
)
def test_what_can_not_come_in_is_refused_in_one_line(
    name: str,
    data: bytes | None,
    said: str,
    project: Project,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(media_import, "LARGEST", 100)
    source = file(tmp_path, name, data) if data is not None else tmp_path / name
    with pytest.raises(UsageError, match=said) as told:
        bring(project, source)
    assert "\n" not in str(told.value)
    assert names(project) == []


def test_the_page_serves_all_that_can_be_brought_in() -> None:
    assert {*media_import.PICTURES, *media_import.MOVIES, *media_import.SOUNDS} <= set(_MEDIA_TYPES)


@given(st.text(max_size=80), st.sampled_from(media_import.PICTURES))
@settings(max_examples=60, deadline=None)
def test_a_name_is_one_that_every_system_takes(stem: str, ending: str) -> None:
    made = free_name(Path("no such folder"), stem.replace("/", "").replace("\0", "") + ending)
    assert re.fullmatch(r"[a-z0-9-]{1,60}\.[a-z0-9]+", made), made


def test_what_came_into_a_project_without_a_media_folder_is_shown_and_offered(
    qt: QApplication, tmp_path: Path
) -> None:
    project = Project(root=str(tmp_path), name="p")
    (tmp_path / "a.rbd.xml").write_text("<application/>")
    picture = QImage(4, 4, QImage.Format.Format_RGB32)
    assert picture.save(str(tmp_path / "beside.png"))
    src = bring(project, tmp_path / "beside.png")
    application = Application(name="a")
    setting = Setting(application, LIGHT, None, lambda: project)
    subject = Subject(
        document=application, place=(), value=application, theme=LIGHT, project=project
    )
    for home in (setting.media(), subject.media):
        assert media_pictures.picture(home, src) is not None
        assert media_pictures.picture(home, "beside.png") is not None
    offered = Lexicon(media_import.names_of).vocabulary(project, application).media
    assert offered == ("beside.png", "media/beside.png")


def test_media_are_the_files_of_their_folder_and_of_all_below_it(project: Project) -> None:
    home = Path(project.root) / "media"
    (home / "dogs" / "small").mkdir(parents=True)
    (home / "empty").mkdir()
    for name in ("b.png", "a.txt", "dogs/c.png", "dogs/small/a.png"):
        (home / name).touch()
    (home / "again.png").symlink_to(home / "b.png")
    (home / "nowhere.png").symlink_to(home / "gone.png")
    (home / "round").symlink_to(home, target_is_directory=True)
    expected = ("a.txt", "again.png", "b.png", "dogs/c.png", "dogs/small/a.png")
    assert media_import.names_of(project) == expected


def test_without_a_media_folder_media_are_what_the_page_shows_of_two_folders(
    tmp_path: Path,
) -> None:
    project = Project(root=str(tmp_path), name="p")
    assert media_import.names_of(project) == ()
    (tmp_path / "media" / "dogs").mkdir(parents=True)
    (tmp_path / "other").mkdir()
    for name in ("a.rbd.xml", "B.PNG", "other/c.png", "media/d.ogg", "media/dogs/e.webm"):
        (tmp_path / name).touch()
    assert media_import.names_of(project) == ("B.PNG", "media/d.ogg", "media/dogs/e.webm")


def test_names_of_media_are_read_without_asking_each_file(
    project: Project, monkeypatch: pytest.MonkeyPatch
) -> None:
    many = [f"{number:02}.png" for number in range(40)]
    for name in many:
        (Path(project.root) / "media" / name).touch()
    asked: list[Path] = []
    for what in ("stat", "is_file"):
        there = getattr(Path, what)

        def ask(path: Path, there: Any = there, **kinds: Any) -> Any:
            asked.append(path)
            return there(path, **kinds)

        monkeypatch.setattr(Path, what, ask)
    assert media_import.names_of(project) == tuple(many)
    assert len(asked) < 10
