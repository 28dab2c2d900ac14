"""The language of the studio, chosen while it runs: nothing that is open is lost."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QInputMethodEvent, QTextDocument
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from tests.gui.conftest import Studio

from situ_studio.canvas import gestures
from situ_studio.canvas.picture import NEW
from situ_studio.wording.language import Speaking, language_of


@pytest.fixture(autouse=True)
def english(qt: QApplication) -> object:
    """Whatever a test chose, the next one begins in English."""
    yield
    speaking = qt.findChild(Speaking)
    if speaking is not None:
        speaking.use("en")


def choose(studio: Studio, language: str) -> Studio:
    """The window that is there after the language was typed into the palette and chosen."""
    before, windows = studio.window, studio.window.windows
    assert windows is not None
    studio.key(Qt.Key.Key_K, Qt.KeyboardModifier.ControlModifier)
    # As an input method does, which Japanese letters come by.
    typed = QInputMethodEvent()
    typed.setCommitString(language)
    field = QApplication.focusWidget()
    assert field is not None
    QApplication.sendEvent(field, typed)
    studio.settle()
    QTest.keyClick(field, Qt.Key.Key_Return)
    while before in windows.windows:
        QApplication.processEvents()
    (window,) = windows.windows
    made = Studio(window)
    made.settle()
    return made


def test_the_window_speaks_the_language_that_was_chosen(
    studio: Callable[..., Studio], project: Callable[[str], Path]
) -> None:
    english = studio(project("reception"))
    assert english.window.headers["outline"].title.text() == "Outline"
    japanese = choose(english, "日本語")
    assert japanese.window.headers["outline"].title.text() == "アウトライン"
    assert japanese.window.menuBar().actions()[0].text().startswith("ファイル")
    assert re.fullmatch("状態 16 個、遷移 [0-9]+ 個", japanese.window.status.counts.text())
    assert choose(japanese, "English").window.headers["outline"].title.text() == "Outline"


def test_a_project_is_begun_in_the_language_that_is_spoken(
    studio: Callable[..., Studio], tmp_path: Path
) -> None:
    japanese = choose(studio(), "日本語")
    japanese.answers.put("name", "my-robot")
    japanese.answers.put("new_folder", str(tmp_path))
    japanese.key(Qt.Key.Key_N, Qt.KeyboardModifier.ControlModifier)
    project = japanese.session.project
    assert project.languages == ("ja",)
    (state,) = project.applications["my-robot.rbd.xml"].states
    assert state.name == "はじめ"


def test_the_tutorial_is_in_the_language_that_is_spoken(studio: Callable[..., Studio]) -> None:
    japanese = choose(studio(), "日本語")
    japanese.click(japanese.window.welcome.tutorial)
    window = japanese.window.helping.tutorial
    assert window is not None
    assert window.title.text() == "血圧を測るロボット"
    told = "".join(step.text for step in window.steps)
    pictures = re.findall(r"\((tutorial/\S+)\)", told)
    image = QTextDocument.ResourceType.ImageResource.value
    assert pictures
    for one in pictures:
        assert not window.pages.loadResource(image, one).isNull(), one


def test_what_follows_is_asked_found_and_named_in_the_language_that_is_spoken(
    studio: Callable[..., Studio], project: Callable[[str], Path]
) -> None:
    japanese = choose(studio(project("reception")), "日本語")
    application = japanese.session.project.applications["reception.rbd.xml"]
    offered = gestures.choices(application, ("state", "1"), NEW)[: len(gestures.FOLLOWS)]
    assert [f.key for f in offered] == [f.key for f in gestures.FOLLOWS]
    for follow in offered:
        assert re.search("[ぁ-んァ-ヶ一-龯]", follow.label), follow
        assert re.search("[ぁ-んァ-ヶ一-龯]", follow.words), follow
    after, _, no = gestures.follow(application, ("state", "1"), NEW, "question", 0, 0)
    assert no is not None
    made = after.state(no)
    assert made is not None
    assert made.name == f"状態 {no}"
    assert made.screen is not None
    assert [one.text for one in made.screen.components] == ["よろしいですか", "はい", "いいえ"]  # type: ignore[attr-defined]


def test_nothing_that_is_open_is_lost_with_the_language(
    studio: Callable[..., Studio], project: Callable[[str], Path]
) -> None:
    one = studio(project("reception"))
    one.window.open_file("register.rbd.xml")
    one.select("state", "2")
    form = one.window.inspector.form
    assert form is not None
    one.fill(form.field("name"), "another name")
    session, changed = one.session, one.session.document("register.rbd.xml")
    one.window.show_mode("outline")
    other = choose(one, "日本語").window
    assert other.session is session
    assert session.document("register.rbd.xml") is changed
    view = other.current_view
    assert view is not None
    assert (other.current_file, view.mode) == ("register.rbd.xml", "outline")
    assert view.selected == (("state", "2"),)
    assert other.tabs.files() == ["reception.rbd.xml", "register.rbd.xml"]
    made = Studio(other)
    made.key(Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert session.document("register.rbd.xml") is not changed
    assert not session.dirty


def test_panels_that_stood_aside_when_the_language_was_chosen_come_back(
    studio: Callable[..., Studio], project: Callable[[str], Path]
) -> None:
    one = studio(project("reception"))
    one.window.open_file("reception.rbd.xml")
    one.settle()

    def seen(used: Studio) -> tuple[set[str], bool]:
        docks = used.window.docks
        return {name for name in docks if docks[name].isVisible()}, used.window.bottom.is_folded

    before = seen(one)
    assert {"project", "outline", "palette"} <= before[0]
    # The designer's panel stood there.
    one.window.show_mode("screen")
    one.settle()
    assert "project" not in seen(one)[0]
    other = choose(one, "日本語")
    assert "designer" in seen(other)[0]
    other.window.show_mode("graph")
    other.settle()
    assert seen(other) == before
    # What is known of a rehearsal stood there.
    other.window.rehearsing.rehearse()
    other.settle()
    assert "project" not in seen(other)[0]
    again = choose(other, "English")
    again.window.rehearsing.end()
    again.settle()
    assert seen(again) == before


def test_the_canvas_looks_where_it_looked(
    studio: Callable[..., Studio], project: Callable[[str], Path]
) -> None:
    one = studio(project("reception"))
    one.key(Qt.Key.Key_Plus, Qt.KeyboardModifier.ControlModifier)
    view = one.window.current_view
    assert view is not None
    looking = view.call("looking")
    view = choose(one, "日本語").window.current_view
    assert view is not None
    assert view.call("looking") == pytest.approx(looking, abs=2)


def test_the_language_is_kept_for_the_next_start(
    studio: Callable[..., Studio],
) -> None:
    choose(studio(), "日本語").window.close()
    assert studio().window.menuBar().actions()[0].text().startswith("ファイル")


@pytest.mark.parametrize(
    ("choice", "wanted", "spoken"),
    [
        ("ja", ["en-GB"], "ja"),
        ("system", ["fr-FR", "ja-JP", "en-US"], "ja"),
        ("system", ["fr-FR"], "en"),
        ("unknown", ["ja"], "ja"),
    ],
)
def test_the_system_s_language_is_spoken_where_none_was_chosen(
    choice: str, wanted: list[str], spoken: str
) -> None:
    assert language_of(choice, wanted) == spoken


def test_each_window_has_a_project_of_its_own(
    studio: Callable[..., Studio], project: Callable[[str], Path]
) -> None:
    first = studio(project("reception"))
    first.key(Qt.Key.Key_N, Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier)
    windows = first.window.windows
    assert windows is not None
    _, second = windows.windows
    second.open_project(project("conversation"))
    assert first.session.project.name == "reception"
    assert second.session.project is not None
    assert second.session.project.name == "conversation"
    second.close()
    first.settle()
    assert windows.windows == [first.window]
