"""The welcome page: examples, new projects, recent ones."""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime, timedelta
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QDate, QEvent, QLocale, Qt
from PySide6.QtGui import QFontInfo
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel, QPushButton, QToolButton, QWidget

from situ.document import folder
from situ.document.check import check
from situ.resources import examples, templates
from situ_studio.looks.theme import LIGHT
from situ_studio.welcome import recent
from situ_studio.welcome.project_pictures import SmallPicture, SmallPictures

CONTROL = Qt.KeyboardModifier.ControlModifier

Start = Callable[..., Any]
Copy = Callable[[str], Path]


def test_without_a_project_the_welcome_page_is_shown(studio: Start) -> None:
    used = studio()
    assert used.window.welcome.isVisible()
    assert not used.window.toolbar.isVisible()
    assert used.window.windowTitle() == "Situ Studio"
    assert not used.window.actions_.actions["save"].isEnabled()


def test_an_example_opens_as_a_copy_in_a_folder_that_is_asked_for(
    studio: Start, tmp_path: Path
) -> None:
    used = studio()
    used.answers.put("new_folder", str(tmp_path))
    used.click(used.window.welcome.example("reception"))
    assert used.session.root == tmp_path / "reception"
    assert (tmp_path / "reception" / "situ.toml").is_file()
    assert used.window.current_file == "reception.rbd.xml"
    assert used.window.toolbar.isVisible()
    assert used.session.problems == []


def test_a_second_copy_gets_a_name_that_is_free(studio: Start, tmp_path: Path) -> None:
    used = studio()
    used.answers.put("where", "here")
    for _ in range(2):
        used.answers.put("new_folder", str(tmp_path))
        used.window.commands.open_example("conversation")
    assert used.session.root == tmp_path / "conversation-2"


def test_cards_answer_to_the_keyboard(studio: Start, tmp_path: Path) -> None:
    used = studio()
    used.answers.put("new_folder", str(tmp_path))
    used.window.welcome.example("conversation").setFocus()
    used.key(Qt.Key.Key_Return)
    assert used.session.root == tmp_path / "conversation"


def test_a_new_project_is_whole_and_without_problems(studio: Start, tmp_path: Path) -> None:
    used = studio()
    used.answers.put("name", "my-robot")
    used.answers.put("new_folder", str(tmp_path))
    used.key(Qt.Key.Key_N, CONTROL)
    assert used.window.current_file == "my-robot.rbd.xml"
    project, problems = folder.load(tmp_path / "my-robot")
    assert project is not None
    # That nothing leads on from its one state yet may be warned of.
    assert [p for p in (*problems, *check(project)) if p.severity == "error"] == []


@pytest.mark.parametrize("name", sorted(set(templates()) - {"empty"}))
def test_every_template_has_a_card_that_makes_a_project_of_it(
    studio: Start, tmp_path: Path, name: str
) -> None:
    used = studio()
    used.answers.put("name", "My robot")
    used.answers.put("new_folder", str(tmp_path))
    used.click(used.window.welcome.template(name))
    assert used.session.root == tmp_path / "my-robot"
    assert used.window.current_file == "my-robot.rbd.xml"
    assert used.session.problems == []
    wanted, _ = folder.load(templates()[name])
    assert wanted is not None
    drawn = used.session.project.applications["my-robot.rbd.xml"]
    assert drawn.states == wanted.applications["newproject.rbd.xml"].states


def test_a_name_that_is_none_is_told_in_one_line(studio: Start, tmp_path: Path) -> None:
    used = studio()
    used.answers.put("name", "??")
    used.answers.put("new_folder", str(tmp_path))
    used.click(used.window.welcome.new)
    assert len(used.answers.told) == 1
    assert "is no name for a project" in used.answers.told[0]
    assert used.window.welcome.isVisible()


def test_a_folder_without_a_project_is_told_in_one_line(studio: Start, tmp_path: Path) -> None:
    used = studio()
    used.answers.put("project", str(tmp_path))
    used.key(Qt.Key.Key_O, CONTROL)
    assert "situ.toml" in used.answers.told[0]
    assert used.window.welcome.isVisible()


def test_projects_that_were_open_are_listed_and_open_again(
    studio: Start, project: Copy, tmp_path: Path
) -> None:
    studio(project("reception")).window.close()
    used = studio()
    assert used.window.welcoming.recent == [str(tmp_path / "reception")]
    used.window.welcome.recent_asked.emit(used.window.welcoming.recent[0])
    assert used.window.current_file == "reception.rbd.xml"


def test_a_recent_project_that_is_gone_is_shown_as_such_and_taken_off_the_list(
    studio: Start, project: Copy, tmp_path: Path
) -> None:
    studio(project("reception")).window.close()
    (tmp_path / "reception").rename(tmp_path / "moved")
    used = studio()
    welcome = used.window.welcome
    assert "Not there any more" in [label.text() for label in welcome.findChildren(QLabel)]
    used.click(welcome.findChild(QToolButton, f"forget {tmp_path / 'reception'}"))
    assert used.window.welcoming.recent == []
    assert "Projects that you open will be listed here." in [
        label.text() for label in welcome.findChildren(QLabel)
    ]


def test_a_recent_project_that_is_gone_is_located_and_opens(
    studio: Start, project: Copy, tmp_path: Path
) -> None:
    studio(project("reception")).window.close()
    (tmp_path / "reception").rename(tmp_path / "moved")
    used = studio()
    used.answers.put("project", None)
    locate = used.window.welcome.findChild(QPushButton, f"locate {tmp_path / 'reception'}")
    used.click(locate)
    assert used.window.welcoming.recent == [str(tmp_path / "reception")]
    used.answers.put("project", str(tmp_path / "moved"))
    used.click(locate)
    assert used.session.root == tmp_path / "moved"
    assert used.window.welcoming.recent == [str(tmp_path / "moved")]


def test_recent_projects_and_templates_show_what_they_look_like(
    studio: Start, project: Copy, tmp_path: Path
) -> None:
    first = studio(project("reception"))
    first.session.now = lambda: NOW - timedelta(hours=2)
    first.window.welcoming.remember(tmp_path / "reception")
    first.window.close()
    used = studio()
    used.session.now = lambda: NOW
    used.window.welcoming.show()
    while used.window.welcome.pictures.waits:
        QApplication.processEvents()
    pictures = used.window.welcome.findChildren(SmallPicture)
    # The recent one, and all templates but the empty one, which is New project.
    assert len(pictures) == len(templates())
    assert all(picture.document is not None for picture in pictures)
    assert "2 hours ago" in [label.text() for label in used.window.welcome.findChildren(QLabel)]


def test_projects_are_read_while_the_page_is_seen_and_for_no_card_that_is_gone(
    qt: QApplication,
) -> None:
    read: list[str] = []
    page = QWidget()
    pictures = SmallPictures(page, read.append)
    gone, there = (pictures.picture(LIGHT, "history", path) for path in ("gone", "there"))
    QApplication.processEvents()
    assert read == []
    gone.deleteLater()
    QApplication.sendPostedEvents(gone, QEvent.Type.DeferredDelete)
    page.show()
    pictures.go_on()
    while pictures.waits:
        QApplication.processEvents()
    assert read == ["there"]
    page.close()
    there.deleteLater()
    page.deleteLater()


NOW = datetime(2026, 3, 5, 14, 0)


@pytest.mark.parametrize(
    ("before", "words"),
    [
        (timedelta(seconds=20), "just now"),
        (timedelta(minutes=1), "a minute ago"),
        (timedelta(minutes=59), "59 minutes ago"),
        (timedelta(hours=1, minutes=30), "an hour ago"),
        (timedelta(hours=13), "13 hours ago"),
        (timedelta(hours=15), "yesterday"),
        (timedelta(days=6), "6 days ago"),
        (-timedelta(hours=2), "just now"),
    ],
)
def test_how_long_ago_something_was_is_said_in_words(
    qt: QApplication, before: timedelta, words: str
) -> None:
    assert recent.ago(NOW - before, NOW) == words


def test_of_what_is_long_ago_the_date_is_said(qt: QApplication) -> None:
    written = QLocale().toString(QDate(2026, 2, 25), QLocale.FormatType.ShortFormat)
    assert recent.ago(NOW - timedelta(days=8), NOW) == written


def test_the_bundled_typeface_is_used(studio: Start) -> None:
    assert QFontInfo(studio().window.welcome.font()).family() == "Inter"


def test_the_foot_of_the_page_changes_the_language(studio: Start) -> None:
    window = studio().window
    windows = window.windows
    for code in ("ja", "en"):
        languages = window.welcome.languages
        assert not languages.button(code).isChecked()
        # The click ends with another window than it began in.
        QTest.mouseClick(languages.button(code), Qt.MouseButton.LeftButton)
        while window in windows.windows:
            QApplication.processEvents()
        (window,) = windows.windows
        assert window.welcome.languages.button(code).isChecked()
        for name in examples():
            (about,) = (
                label.text()
                for label in window.welcome.example(name).findChildren(QLabel)
                if label.wordWrap()
            )
            assert about.endswith("。" if code == "ja" else "."), about
