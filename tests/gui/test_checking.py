"""Problems of a large project are found beside the window, and only the last answer counts."""

from __future__ import annotations

import sys
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QEventLoop, QTimer, SignalInstance
from PySide6.QtTest import QSignalSpy

from situ.document.check import check
from situ.document.project import Project
from situ.document.rbd import Application, Event, State
from situ_studio.problems.checking import Checker

PATIENCE = 20_000


def project(next: str, states: int = 3) -> Project:
    every = tuple(
        State(no=str(n), name="", events=(Event(name="go", next=next),))
        for n in range(1, states + 1)
    )
    return Project(
        root=".", name="p", applications={"a.rbd.xml": Application("a", "1", states=every)}
    )


def until(signal: SignalInstance) -> None:
    """Runs the loop until the signal comes; a spy's wait would keep other threads waiting."""
    loop = QEventLoop()
    signal.connect(loop.quit)
    late = QTimer()
    late.setSingleShot(True)
    late.timeout.connect(loop.quit)
    late.start(PATIENCE)
    loop.exec()
    assert late.isActive(), "it did not come"
    late.stop()


def test_a_small_project_is_checked_at_once(qt: Any) -> None:
    checker = Checker(large=10)
    spy = QSignalSpy(checker.found)
    small = project("9")
    checker.ask(small)
    assert spy.at(0)[0] is small
    assert "dangling-next" in {p.code for p in spy.at(0)[1]}


def test_of_a_large_project_only_the_last_value_is_told(qt: Any) -> None:
    checker = Checker(large=2)
    told: list[Project] = []
    checker.found.connect(lambda asked, _: told.append(asked))
    values = [project(n) for n in ("9", "8", "1")]
    for value in values:
        checker.ask(value)
    assert told == []
    until(checker.found)
    assert told == [values[-1]]
    assert told[0] is values[-1]


def test_a_small_value_overtakes_a_check_that_still_runs(qt: Any) -> None:
    checker = Checker(large=2)
    told: list[Project] = []
    checker.found.connect(lambda asked, _: told.append(asked))
    small, last = project("1", states=1), project("8")
    checker.ask(project("9"))
    checker.ask(small)
    assert len(told) == 1
    checker.ask(last)
    until(checker.found)
    assert len(told) == 2
    assert told[0] is small
    assert told[1] is last


def test_the_window_goes_on_while_a_large_project_is_checked(qt: Any) -> None:
    checker = Checker(large=2)
    turns: list[int] = []
    tick = QTimer()
    tick.timeout.connect(lambda: turns.append(1))
    tick.start(0)
    checker.ask(project("9", states=400))
    until(checker.found)
    tick.stop()
    assert len(turns) > 8, "one for each piece of it, and those in which it was waited for"


def test_a_check_sees_what_was_edited_and_what_was_not(qt: Any) -> None:
    checker = Checker(large=2)
    spy = QSignalSpy(checker.found)
    first = project("1", states=120)
    application = first.applications["a.rbd.xml"]
    wrong = State(no="121", name="", events=(Event(name="go", next="nowhere"),))
    edited = replace(application, states=(*application.states[:50], wrong))
    again = replace(first, applications={"a.rbd.xml": edited})
    for value in (first, again, first):
        checker.ask(value)
        until(checker.found)
    told = [spy.at(n)[1] for n in range(3)]
    assert told == [check(first), check(again), check(first)]
    assert told[0] != told[1]


@pytest.mark.parametrize("program", ["import sys; sys.exit(3)", "import sys; sys.stdin.read(9)"])
def test_a_process_that_ends_is_logged_and_started_again_for_the_next(
    qt: Any, caplog: pytest.LogCaptureFixture, program: str
) -> None:
    checker = Checker(large=2, command=(sys.executable, "-c", program))
    spy = QSignalSpy(checker.found)
    for _ in range(2):
        checker.ask(project("9"))
        until(checker.ended)
    assert spy.count() == 0
    assert len(caplog.records) == 2


def test_a_program_that_is_not_there_leaves_the_problems_as_they_were(
    qt: Any, caplog: pytest.LogCaptureFixture
) -> None:
    checker = Checker(large=2, command=("/nowhere/python",))
    ended = QSignalSpy(checker.ended)
    checker.ask(project("9"))
    if not ended.count():
        until(checker.ended)
    assert "has ended" in caplog.text
