"""Nothing is ever lost: what was not saved is offered when the project is opened next."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import QSettings, Qt

CONTROL = Qt.KeyboardModifier.ControlModifier
FILE = "reception.rbd.xml"

Start = Callable[..., Any]
Copy = Callable[[str], Path]


def rename(used: Any, name: str) -> None:
    used.select("state", "2")
    used.fill(used.window.inspector.form.field("name"), name)


def kept(settings: QSettings) -> list[Path]:
    return list((Path(settings.fileName()).parent / "recovery").glob("*.json"))


def crash(used: Any) -> None:
    """As a process that is killed: its lock goes with it, its file stays."""
    used.window.recovery.keep()
    used.window.recovery._lock.unlock()
    used.window.recovery._file = used.window.recovery._lock = None


def test_what_was_not_saved_is_offered_at_the_next_start(studio: Start, project: Copy) -> None:
    folder = project("reception")
    first = studio(folder)
    rename(first, "lost?")
    crash(first)
    used = studio(folder)
    strip = used.window.recovered
    assert strip.isVisible()
    assert FILE in strip.words.text()
    assert used.session.document(FILE).state("2").name == "intro"
    used.click(strip.buttons[0])
    assert not strip.isVisible()
    assert used.session.document(FILE).state("2").name == "lost?"
    assert used.session.dirty == [FILE]
    used.window.actions_.actions["undo"].trigger()
    assert used.session.document(FILE).state("2").name == "intro"


def test_what_was_brought_back_is_kept_again(
    studio: Start, project: Copy, settings: QSettings
) -> None:
    folder = project("reception")
    first = studio(folder)
    rename(first, "twice")
    crash(first)
    second = studio(folder)
    second.click(second.window.recovered.buttons[0])
    crash(second)
    assert len(kept(settings)) == 1
    third = studio(folder)
    third.click(third.window.recovered.buttons[0])
    assert third.session.document(FILE).state("2").name == "twice"


def test_forgotten_changes_are_not_offered_again(
    studio: Start, project: Copy, settings: QSettings
) -> None:
    folder = project("reception")
    first = studio(folder)
    rename(first, "no more")
    crash(first)
    used = studio(folder)
    used.click(used.window.recovered.buttons[1])
    assert kept(settings) == []
    assert used.session.dirty == []


def test_saving_leaves_nothing_to_recover(
    studio: Start, project: Copy, settings: QSettings
) -> None:
    used = studio(project("reception"))
    rename(used, "saved")
    used.window.recovery.keep()
    assert len(kept(settings)) == 1
    used.key(Qt.Key.Key_S, CONTROL)
    assert kept(settings) == []


def test_changes_given_up_at_closing_are_not_offered(
    studio: Start, project: Copy, settings: QSettings
) -> None:
    used = studio(project("reception"))
    rename(used, "given up")
    used.window.recovery.keep()
    used.answers.put("unsaved", "discard")
    used.window.close()
    assert kept(settings) == []


def test_an_edit_is_kept_soon_without_being_asked(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    soon = used.window.recovery._soon
    assert not soon.isActive()
    rename(used, "soon")
    assert soon.isActive()
    used.window.actions_.actions["undo"].trigger()
    assert not soon.isActive()


def test_what_another_window_keeps_is_its_own(studio: Start, project: Copy) -> None:
    folder = project("reception")
    first = studio(folder)
    rename(first, "mine")
    first.window.recovery.keep()
    assert not studio(folder).window.recovered.isVisible()


def test_a_recovery_file_that_can_not_be_read_is_passed_over(
    studio: Start, project: Copy, settings: QSettings
) -> None:
    folder = project("reception")
    first = studio(folder)
    rename(first, "broken")
    crash(first)
    kept(settings)[0].write_bytes(b"{")
    assert not studio(folder).window.recovered.isVisible()


_KILLED = """
import os, signal, sys
from PySide6.QtCore import QSettings, QTimer
from situ_studio import main, places
settings = QSettings(sys.argv[2], QSettings.Format.IniFormat)
made = main.create_window
def create(path, _, theme, language):
    window = made(path, settings, theme, language)
    def edit():
        document = window.session.document("reception.rbd.xml")
        window.commit(places.change(document, ("state", "2"), name="killed"), "Rename")
        os.kill(os.getpid(), signal.SIGTERM)
    QTimer.singleShot(0, edit)
    return window
main.create_window = create
sys.exit(main.main([sys.argv[1]]))
"""


def test_a_polite_kill_loses_nothing(studio: Start, project: Copy, settings: QSettings) -> None:
    folder = project("reception")
    ended = subprocess.run(
        [sys.executable, "-c", _KILLED, str(folder), settings.fileName()],
        env={**os.environ, "QT_QPA_PLATFORM": "offscreen"},
        timeout=60,
        check=False,
    )
    assert ended.returncode == 0
    assert signal.getsignal(signal.SIGTERM) is signal.SIG_DFL
    used = studio(folder)
    used.click(used.window.recovered.buttons[0])
    assert used.session.document(FILE).state("2").name == "killed"
