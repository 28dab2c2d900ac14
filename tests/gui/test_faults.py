"""What nobody expected: faults in slots, signals from outside."""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication

from situ_studio.main import Interrupts, Unexpected

Start = Callable[..., Any]
Copy = Callable[[str], Path]


def test_a_fault_in_a_slot_is_told_once_and_the_studio_runs_on(
    studio: Start, project: Copy, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    used = studio(project("reception"))
    monkeypatch.setattr(sys, "excepthook", Unexpected(used.answers.tell))

    def broken() -> None:
        raise LookupError("the button fell off")

    used.window.tabs.views.button("outline").clicked.connect(broken)
    for name in ("outline", "graph", "outline"):
        used.click(used.window.tabs.views.button(name))
    assert len(used.answers.told) == 1
    assert "the button fell off" in used.answers.told[0]
    assert "\n" not in used.answers.told[0]
    assert "in broken" in caplog.text
    assert used.window.current_view.mode == "outline"
    used.select("state", "2")
    used.fill(used.window.inspector.form.field("name"), "still here")
    assert used.session.undo_text == "Rename state 2"


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_the_loop(qt: QApplication, number: int) -> None:
    before = signal.getsignal(number)
    with Interrupts(qt):
        QTimer.singleShot(0, lambda: os.kill(os.getpid(), number))
        late = QTimer()
        late.setSingleShot(True)
        late.timeout.connect(lambda: qt.exit(7))
        late.start(5000)
        assert qt.exec() == 0
        late.stop()
    assert signal.getsignal(number) is before
