"""What nobody expected: faults in slots and threads, signals from outside, what the log says."""

from __future__ import annotations

import logging
import os
import signal
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QTimer
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QApplication

from situ_studio.log_file import OLD, SIZE, LogFile
from situ_studio.unexpected import Hooks, Interrupts, Unexpected
from situ_studio.widgets.details import Details

Start = Callable[..., Any]
Copy = Callable[[str], Path]


def rename(used: Any, name: str) -> None:
    used.select("state", "2")
    used.fill(used.window.inspector.form.field("name"), name)


def broken() -> None:
    raise LookupError("the button of Mrs. Smith fell off")


def test_a_fault_in_a_slot_is_told_once_and_the_studio_runs_on(
    studio: Start, project: Copy, tmp_path: Path
) -> None:
    used = studio(project("reception"))
    rename(used, "not saved")
    windows = used.window.windows
    with Hooks(Unexpected(windows.keep_unsaved, windows.tell_fault)):
        used.window.tabs.views.button("outline").clicked.connect(broken)
        for name in ("outline", "graph", "outline"):
            used.click(used.window.tabs.views.button(name))
    ((words, details),) = used.answers.details_told
    assert "went wrong" in words
    assert "Mrs. Smith" not in words
    assert "in broken" in details
    assert "Mrs. Smith" in details
    assert len(list((tmp_path / "recovery").glob("*.json"))) == 1
    assert used.window.current_view.mode == "outline"
    rename(used, "still here")
    assert used.session.undo_text == "Rename state 2"


def test_a_fault_in_a_thread_is_told_like_any_other(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    windows = used.window.windows
    with Hooks(Unexpected(windows.keep_unsaved, windows.tell_fault)):
        thread = threading.Thread(target=broken)
        thread.start()
        thread.join()
        used.settle()
    assert len(used.answers.details_told) == 1


def test_that_what_is_not_saved_can_not_be_kept_does_not_hide_the_fault() -> None:
    told: list[tuple[str, str]] = []
    hook = Unexpected(broken, lambda words, details: told.append((words, details)))
    hook(ValueError, ValueError("first"), None)
    assert len(told) == 1
    assert "first" in told[0][1]


def test_details_are_folded_and_copied_by_a_button(studio: Start) -> None:
    used = studio()
    dialog = Details("A fault", "Something went wrong.", "line 1\nline 2", used.window)
    dialog.show()
    used.settle()
    assert not dialog.details.isVisible()
    # Enter closes it.
    assert dialog.close_button.isDefault()
    used.click(dialog.fold)
    assert dialog.details.isVisible()
    QGuiApplication.clipboard().clear()
    used.click(dialog.copy)
    assert QGuiApplication.clipboard().text() == "Something went wrong.\n\nline 1\nline 2"
    used.click(dialog.close_button)
    assert not dialog.isVisible()
    dialog.deleteLater()


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


# -- the log -----------------------------------------------------------------------------------


@pytest.fixture
def log(tmp_path: Path) -> Iterator[LogFile]:
    made = LogFile(tmp_path / "state")
    made.open()
    yield made
    made.close()


def test_the_log_says_where_a_fault_was_and_nothing_that_people_wrote(log: LogFile) -> None:
    shown = logging.StreamHandler()
    logging.getLogger().addHandler(shown)
    try:
        broken()
    except LookupError:
        # Another handler that writes the message first leaves it in the record.
        record = logging.getLogger("situ.studio").makeRecord(
            "situ.studio", logging.ERROR, "", 0, "A fault", (), None
        )
        record.exc_text = "LookupError: the button of Mrs. Smith fell off"
        logging.getLogger("situ.studio").handle(record)
        logging.getLogger("situ.studio").exception("A fault in the studio")
    finally:
        logging.getLogger().removeHandler(shown)
    text = log.end()
    assert "A fault in the studio" in text
    assert "in broken" in text
    assert "LookupError" in text
    assert "Smith" not in text


def test_the_log_never_grows_without_end(log: LogFile) -> None:
    logger = logging.getLogger("situ.studio")
    for number in range(60):
        logger.error("%d %s", number, "x" * (SIZE // 10))
    files = sorted(log.path.parent.glob("studio.log*"))
    assert len(files) == 1 + OLD
    assert sum(file.stat().st_size for file in files) <= (1 + OLD) * SIZE
    assert log.end(1000).splitlines()[-1:] == [] or "59" in log.path.read_text()


def test_a_log_that_can_not_be_written_is_done_without(tmp_path: Path) -> None:
    (tmp_path / "state").write_text("a file where the folder would be")
    log = LogFile(tmp_path / "state")
    log.open()
    logging.getLogger("situ.studio").error("nobody hears this")
    assert log.end() == ""
    log.close()


def test_help_shows_the_end_of_the_log(studio: Start, log: LogFile) -> None:
    used = studio()
    used.window.windows.log = log
    logging.getLogger("situ.studio").error("something noted")
    used.window.actions_.actions["show_log"].trigger()
    ((words, details),) = used.answers.details_told
    assert str(log.path.parent) in words
    assert "something noted" in details
