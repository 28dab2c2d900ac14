"""The automatic layout of many cards: in a process, with a limit, cancelled, never on its own."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtTest import QSignalSpy
from PySide6.QtWidgets import QApplication

from situ.document.aside import NOTHING
from situ.document.rbd import Application, Event, State
from situ_studio.canvas import arranging, layout

PATIENCE = 20_000
SLEEPS = (sys.executable, "-c", "import signal; signal.pause()")


@pytest.fixture
def many(monkeypatch: pytest.MonkeyPatch) -> Application:
    """A way of states, all in one heap, and more than are arranged at once."""
    monkeypatch.setattr("situ_studio.canvas.positions.AT_ONCE", 5)
    return Application(
        name="many",
        states=tuple(
            State(
                no=str(i), events=(Event(name="on", next=str(i + 1)),), aside=NOTHING.at(8 * i, 0)
            )
            for i in range(1, 13)
        ),
    )


@pytest.fixture
def made(desk: Callable[..., Any], many: Application, monkeypatch: pytest.MonkeyPatch) -> Any:
    """A desk whose layouts never end."""
    made = desk(many)
    made.canvas.positions.arranging._command = SLEEPS
    made.said = []
    made.canvas.status.connect(made.said.append)
    return made


@pytest.fixture
def job(qt: QApplication) -> Iterator[Callable[..., arranging.Arranging]]:
    every: list[arranging.Arranging] = []

    def make(command: tuple[str, ...], limit: float = 60.0) -> arranging.Arranging:
        every.append(arranging.Arranging(qt, command, limit))
        return every[-1]

    yield make
    for one in every:
        one.cancel()
        one.deleteLater()


def test_many_cards_are_arranged_as_few_are(
    desk: Callable[..., Any], many: Application, check: Callable[[Any], None]
) -> None:
    made = desk(many)
    done = QSignalSpy(made.canvas.positions.arranging.done)
    begun = QSignalSpy(made.canvas.work_begun)
    made.canvas.auto_layout()
    assert made.edits == []
    assert begun.at(0) == ["Arranging 12 cards", made.canvas.positions.arranging]
    assert done.count() or done.wait(PATIENCE)
    assert made.edits == ["Arrange all cards"]
    places = layout.arrange(many)
    assert {s.no: s.aside.position for s in made.document.states} == places
    check(made)


def test_the_window_answers_meanwhile_and_esc_cancels(
    made: Any, check: Callable[[Any], None]
) -> None:
    made.canvas.auto_layout()
    (process,) = made.canvas.positions.arranging._running
    assert process.waitForStarted(PATIENCE)
    made.hand.click(made.hand.body("12"))
    assert made.canvas.selection() == (("state", "12"),)
    made.hand.key(Qt.Key.Key_Escape)
    assert process.state() == process.ProcessState.NotRunning
    assert (made.edits, made.said) == ([], [])
    assert made.canvas.selection() == (("state", "12"),)
    check(made)


def test_closing_the_canvas_ends_the_process(made: Any, qt: QApplication) -> None:
    made.canvas.auto_layout()
    (process,) = made.canvas.positions.arranging._running
    assert process.waitForStarted(PATIENCE)
    gone = QSignalSpy(process.finished)
    made.canvas.positions.arranging.deleteLater()
    assert gone.count() or gone.wait(PATIENCE)


def test_what_was_added_meanwhile_is_not_lost(made: Any, many: Application) -> None:
    made.canvas.auto_layout()
    more = replace(many, states=(*many.states, State(no="99")))
    made.change(more)
    made.canvas.positions.arranging.done.emit(layout.arrange(many))
    assert made.document is more
    assert made.said == ["There are other cards now than those arranged: arrange them again"]


def test_what_takes_too_long_is_given_up(job: Callable[..., Any], many: Application) -> None:
    one = job(SLEEPS, limit=0.0)
    refused = QSignalSpy(one.refused)
    one.start(layout.shape(many))
    assert refused.count() or refused.wait(PATIENCE)
    assert "longer than 0 s" in refused.at(0)[0]
    assert not one.is_running


@pytest.mark.parametrize(
    ("command", "why"),
    [
        ((sys.executable, "-c", "raise MemoryError('no room')"), "MemoryError: no room"),
        ((sys.executable, "-c", "import os; os.abort()"), "its process ended early"),
        ((sys.executable, "-c", "print('what')"), "malformed"),
        (("/nowhere/at/all",), "it could not be started"),
    ],
)
def test_a_layout_that_fails_says_so_in_one_line(
    job: Callable[..., Any], many: Application, command: tuple[str, ...], why: str
) -> None:
    one = job(command)
    refused, ended = QSignalSpy(one.refused), QSignalSpy(one.ended)
    one.start(layout.shape(many))
    assert refused.count() or refused.wait(PATIENCE)
    said = refused.at(0)[0]
    assert why in said
    assert "\n" not in said
    assert ended.count() == 1
    assert not one.is_running


def test_a_second_start_cancels_the_first(job: Callable[..., Any], many: Application) -> None:
    one = job(SLEEPS)
    one.start(layout.shape(many))
    (first,) = one._running
    one.start(layout.shape(many))
    (second,) = one._running
    assert first is not second
    assert first.state() == first.ProcessState.NotRunning
