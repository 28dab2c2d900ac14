"""Several windows: a project in one of them, closed together, open again at the next start."""

from __future__ import annotations

import gc
import threading
import weakref
from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import QSettings, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from tests.gui.conftest import Studio

from situ.document import folder
from situ.document.problem import Problem
from situ.document.project import Project
from situ_studio.files import leftovers
from situ_studio.files.claim import Claim
from situ_studio.files.opening import NAME
from situ_studio.views.showing import showing
from situ_studio.window.windows import Windows
from situ_studio.wording.language import Speaking

CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier

Start = Callable[..., Studio]
Copy = Callable[[str], Path]


def windows_of(used: Studio) -> Windows:
    windows = used.window.windows
    assert windows is not None
    return windows


def press(used: Studio, key: Qt.Key, held: Qt.KeyboardModifier) -> None:
    """A key that may end the window."""
    QTest.keyClick(used.window, key, held)


def opened_beside(used: Studio, path: Path) -> Studio:
    """The window that opens where a second project is wanted in one of its own."""
    used.answers.put("project", str(path))
    used.answers.put("where", "new")
    used.key(Qt.Key.Key_O, CONTROL)
    window = windows_of(used).windows[-1]
    assert window is not used.window
    assert QTest.qWaitForWindowExposed(window)
    return Studio(window)


def test_a_second_project_opens_where_the_person_says(studio: Start, project: Copy) -> None:
    first = studio(project("reception"))
    second = opened_beside(first, project("conversation"))
    assert first.session.project.name == "reception"
    assert second.session.project.name == "conversation"
    first.answers.put("project", str(second.session.root.parent / "nowhere"))
    first.answers.put("where", "cancel")
    first.key(Qt.Key.Key_O, CONTROL)
    assert first.session.project.name == "reception"
    assert len(windows_of(first).windows) == 2


def test_a_project_that_is_open_is_shown_in_its_window(studio: Start, project: Copy) -> None:
    first = studio(project("reception"))
    second = opened_beside(first, project("conversation"))
    for path in (first.session.root, first.session.root / "situ.toml"):
        second.answers.put("project", str(path))
        second.settle()
        assert second.window.isActiveWindow()
        second.window.commands.open_project()
        QApplication.processEvents()
        assert len(windows_of(first).windows) == 2
        assert first.window.isActiveWindow()
        assert "open here already" in first.window.status.said.text()


def test_a_project_that_another_studio_has_open_is_told(
    studio: Start, project: Copy, tmp_path: Path
) -> None:
    folder = project("reception")
    other = Claim(tmp_path / "recovery")
    assert other.take(folder)
    used = studio(folder)
    assert "another Situ Studio" in used.window.notice.words.text()
    used.click(used.window.notice.buttons[0])
    other.release()
    used.window.open_project(folder)
    assert not used.window.notice.isVisible()
    assert not Claim(tmp_path / "recovery").take(folder)
    used.window.close()
    assert Claim(tmp_path / "recovery").take(folder)


def test_quit_asks_in_each_window_and_closes_none_where_one_wants_to_stay(
    studio: Start, project: Copy
) -> None:
    first = studio(project("reception"))
    second = opened_beside(first, project("conversation"))
    second.select("state", "1")
    form = second.window.inspector.form
    assert form is not None
    second.fill(form.field("name"), "changed")
    second.answers.put("unsaved", "cancel")
    press(first, Qt.Key.Key_Q, CONTROL)
    assert first.window.isVisible()
    assert second.window.isVisible()
    second.answers.put("unsaved", "discard")
    windows = windows_of(second)
    press(first, Qt.Key.Key_Q, CONTROL)
    assert windows.windows == []


def test_what_was_open_is_open_again(
    studio: Start, project: Copy, settings: QSettings, qt: QApplication
) -> None:
    first = studio(project("reception"))
    first.window.open_file("register.rbd.xml")
    first.select("state", "2")
    second = opened_beside(first, project("conversation"))
    second.window.show_mode("outline")
    press(second, Qt.Key.Key_Q, CONTROL)
    speaking = qt.findChild(Speaking)
    assert speaking is not None
    again = Windows(settings, speaking, list)
    shown = again.restore()
    assert shown is not None
    one, two = again.windows
    assert one.session.root == first.session.root
    assert one.current_file == "register.rbd.xml"
    view = one.current_view
    assert view is not None
    assert view.selected == (("state", "2"),)
    assert two.current_view is not None
    assert two.current_view.mode == "outline"
    Studio(one).settle()


def test_a_project_comes_back_as_it_was_left_whenever_it_is_opened(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    window = used.window
    folder = window.session.root
    window.open_file("register.rbd.xml")
    used.key(Qt.Key.Key_Backslash, CONTROL)
    window.open_file("reception.rbd.xml")
    used.key(Qt.Key.Key_3, CONTROL)
    used.select("state", "11")
    for _ in range(3):
        used.key(Qt.Key.Key_Plus, CONTROL)
    window.sides.set_sizes((300, 500))
    used.settle()
    left = showing(window)
    assert left.groups[1].documents["reception.rbd.xml"].mode == "split"
    window.open_project(project("conversation"))
    used.settle()
    assert len(window.sides.groups) == 1
    window.open_project(folder)
    used.settle()
    assert showing(window) == left
    assert window.inspector.place == ("state", "11")


LARGE = "x" * 600_000


def test_large_projects_are_read_again_each_by_itself_while_their_windows_are_seen(
    studio: Start, project: Copy, settings: QSettings, qt: QApplication
) -> None:
    first = studio(project("reception"))
    second = opened_beside(first, project("conversation"))
    roots = [first.session.root, second.session.root]
    second.window.show_mode("outline")
    press(second, Qt.Key.Key_Q, CONTROL)
    for root in roots:
        (root / "unused.xml").write_text(LARGE)
    (roots[0] / "situ.toml").unlink()
    speaking = qt.findChild(Speaking)
    assert speaking is not None
    again = Windows(settings, speaking, list)
    shown = again.restore()
    assert shown is not None
    failing, whole = again.windows
    assert [w.session.project for w in again.windows] == [None, None]
    assert [len(w.status.work.going) for w in again.windows] == [1, 1]
    # Who leaves before they are read has them the next time.
    again.remember()
    assert all(str(root) in settings.value("open") for root in roots)
    while whole.session.project is None or failing in again.windows:
        QApplication.processEvents()
    assert whole.current_view is not None
    assert whole.current_view.mode == "outline"
    assert whole.status.work.going == []
    assert again.windows == [whole]
    assert failing not in again.windows
    assert "situ.toml" in whole.status.said.text()


def test_a_large_project_is_read_on_where_its_window_is_made_anew_for_another_language(
    studio: Start,
    project: Copy,
    settings: QSettings,
    qt: QApplication,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    used = studio(project("reception"))
    root = used.session.root
    press(used, Qt.Key.Key_Q, CONTROL)
    (root / "unused.xml").write_text(LARGE)
    renewed, load = threading.Event(), folder.load

    def slow(path: Path) -> tuple[Project | None, list[Problem]]:
        # The pictures of the welcome page are read meanwhile.
        if threading.current_thread().name == NAME:
            assert renewed.wait(60)
        return load(path)

    monkeypatch.setattr(folder, "load", slow)
    speaking = qt.findChild(Speaking)
    assert speaking is not None
    again = Windows(settings, speaking, list)
    first = again.restore()
    assert first is not None
    try:
        again.choose_language("ja")
        while first in again.windows:
            QApplication.processEvents()
        (window,) = again.windows
        assert [len(w.status.work.going) for w in (first, window)] == [0, 1]
        again.remember()
        assert str(root) in settings.value("open")
        renewed.set()
        while window.session.project is None:
            QApplication.processEvents()
        assert window.status.work.going == []
        assert window.current_file == "reception.rbd.xml"
    finally:
        renewed.set()
        speaking.use("en")


def test_a_large_project_whose_reading_is_cancelled_leaves_the_welcome_page(
    studio: Start, project: Copy, settings: QSettings, qt: QApplication
) -> None:
    used = studio(project("reception"))
    root = used.session.root
    press(used, Qt.Key.Key_Q, CONTROL)
    (root / "unused.xml").write_text(LARGE)
    speaking = qt.findChild(Speaking)
    assert speaking is not None
    again = Windows(settings, speaking, list)
    window = again.restore()
    assert window is not None
    window.status.work.cancel()
    assert window.status.work.going == []
    assert window.stack.currentIndex() == 0
    Studio(window).settle()
    assert window.session.project is None


def test_windows_closed_one_by_one_leave_the_last_to_be_open_again(
    studio: Start, project: Copy, settings: QSettings, qt: QApplication
) -> None:
    first = studio(project("reception"))
    second = opened_beside(first, project("conversation"))
    press(first, Qt.Key.Key_W, CONTROL | SHIFT)
    second.settle()
    press(second, Qt.Key.Key_W, CONTROL | SHIFT)
    speaking = qt.findChild(Speaking)
    assert speaking is not None
    again = Windows(settings, speaking, list)
    again.restore()
    assert [w.session.root.name for w in again.windows] == ["conversation"]


def test_a_project_that_is_gone_at_the_next_start_is_told(
    studio: Start, project: Copy, settings: QSettings, qt: QApplication
) -> None:
    used = studio(project("reception"))
    folder = used.session.root
    press(used, Qt.Key.Key_Q, CONTROL)
    folder.rename(folder.parent / "moved")
    speaking = qt.findChild(Speaking)
    assert speaking is not None
    again = Windows(settings, speaking, list)
    shown = again.restore()
    assert shown is not None
    assert shown.session.project is None
    assert str(folder) in shown.status.said.text()
    settings.setValue("open", "no list")
    assert Windows(settings, speaking, list).restore() is None


def lasting_threads() -> set[threading.Thread]:
    return {one for one in threading.enumerate() if one.name != leftovers.NAME}


def test_a_closed_window_is_freed_with_all_that_it_had(studio: Start, project: Copy) -> None:
    first = studio(project("reception"))
    threads = lasting_threads()
    second = opened_beside(first, project("conversation"))
    second.window.show_mode("outline")
    second.settle()
    kept = [
        weakref.ref(one)
        for one in (
            second.window,
            second.session,
            second.session.disk,
            second.window.recovery,
            second.window.robot.link,
            second.window.current_view,
        )
    ]
    second.window.close()
    del second
    first.settle()
    gc.collect()
    assert [one() for one in kept] == [None] * len(kept)
    assert lasting_threads() == threads
