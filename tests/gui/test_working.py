"""Long work is shown with its progress, and cancelled at once."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QObject, QTimer
from PySide6.QtTest import QSignalSpy
from PySide6.QtWidgets import QApplication

from situ.document import folder
from situ_studio.files import opening
from situ_studio.files.opening import Opening
from situ_studio.problems.checking import Checker, CheckWork
from situ_studio.processes.working import WorkStrip

Start = Callable[..., Any]
Copy = Callable[[str], Path]


def comes_in(spy: QSignalSpy) -> None:
    """Waits for what a thread of Python says, which ``QSignalSpy.wait`` would not let run."""
    while not spy.count():
        QApplication.processEvents()


def shown(strip: WorkStrip) -> None:
    """Its patience is over."""
    strip._soon.timeout.emit()


def test_a_work_is_shown_once_it_takes_long_with_how_far_it_is(studio: Start) -> None:
    used = studio()
    strip = used.window.status.work
    work = strip.begin("Reading much", lambda: None)
    assert not strip.isVisible()
    shown(strip)
    assert strip.isVisible()
    assert strip.words.text() == "Reading much"
    assert strip.bar.maximum() == 0
    work.tell(0.5)
    assert strip.bar.value() == 50
    work.end()
    assert not strip.isVisible()
    assert strip.going == []


def test_the_button_cancels_what_is_shown_and_the_one_before_is_shown_again(studio: Start) -> None:
    used = studio()
    strip = used.window.status.work
    cancelled: list[str] = []
    first = strip.begin("first", lambda: cancelled.append("first"))
    shown(strip)
    strip.begin("second", lambda: cancelled.append("second"))
    assert strip.words.text() == "second"
    used.click(strip.stop)
    assert cancelled == ["second"]
    assert strip.words.text() == "first"
    first.end()
    assert not strip.isVisible()


def test_a_large_project_is_read_beside_the_window(
    studio: Start, project: Copy, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(opening, "LARGE", 0)
    used = studio()
    spy = QSignalSpy(used.session.opened)
    used.window.commands.open_path(str(project("reception")))
    assert used.session.project is None
    (work,) = used.window.status.work.going
    assert "reception" in work.words
    assert spy.count() or spy.wait(20_000)
    assert used.window.current_file == "reception.rbd.xml"
    assert used.window.status.work.going == []


def test_cancelled_the_window_stays_as_it_is(project: Copy, qt: QObject) -> None:
    reading = Opening(qt)
    came: list[opening.Found] = []
    reading.read.connect(came.append)
    reading.start(project("reception"))
    reading.cancel()
    for thread in threading.enumerate():
        if thread.name == opening.NAME:
            thread.join()
    QApplication.processEvents()
    assert came == []
    assert not any(timer.isActive() for timer in reading.findChildren(QTimer))
    spy = QSignalSpy(reading.read)
    reading.start(project("conversation"))
    comes_in(spy)
    assert [found.name for found, _ in came if found is not None] == ["conversation"]
    reading.deleteLater()


def test_a_large_project_that_is_none_is_told(
    studio: Start, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(opening, "LARGE", -1)
    used = studio()
    (tmp_path / "empty").mkdir()
    used.window.commands.open_path(str(tmp_path / "empty"))
    (work,) = used.window.status.work.going
    spy = QSignalSpy(work.ended)
    assert spy.count() or spy.wait(20_000)
    assert len(used.answers.told) == 1
    assert "situ.toml" in used.answers.told[0]


def test_a_check_beside_the_window_is_shown_and_cancelled(project: Copy, qt: QObject) -> None:
    found, _ = folder.load(project("reception"))
    assert found is not None
    checker, strip = Checker(large=0), WorkStrip()
    CheckWork(checker, strip)
    told: list[object] = []
    checker.found.connect(lambda *_: told.append(1))
    ended = QSignalSpy(checker.ended)
    checker.ask(found)
    assert len(strip.going) == 1
    strip.cancel()
    assert strip.going == []
    comes_in(ended)
    assert told == []
    checker.ask(found)
    assert len(strip.going) == 1
    ended = QSignalSpy(checker.ended)
    comes_in(ended)
    assert told == [1]
    assert strip.going == []
    strip.deleteLater()


def test_a_layout_is_shown_in_the_strip_whose_button_cancels_it(
    studio: Start, project: Copy, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("situ_studio.canvas.positions.AT_ONCE", 5)
    used = studio(project("reception"))
    strip, arranging = used.window.status.work, used.window.current_view.canvas.positions.arranging
    arranging._command = (sys.executable, "-c", "import signal; signal.pause()")
    layout = used.window.actions_.actions["layout"]
    layout.trigger()
    shown(strip)
    assert "Arranging" in strip.words.text()
    (process,) = arranging._running
    used.click(strip.stop)
    assert process.state() == process.ProcessState.NotRunning
    assert not strip.isVisible()
    assert used.session.dirty == []
    layout.trigger()
    assert len(strip.going) == 1
    # The drawing is gone, and its layout with it.
    used.window.open_project(project("conversation"))
    used.settle()
    assert strip.going == []
