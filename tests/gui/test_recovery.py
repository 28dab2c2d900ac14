"""Nothing is ever lost: what was not saved is offered when the project is opened next."""

from __future__ import annotations

import os
import resource
import signal
import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QEventLoop, QSettings, Qt, QTimer

from situ.document import codec
from situ.document.folder import clear_unfinished
from situ.document.rbd import Application, State
from situ_studio.files import leftovers
from situ_studio.files.recovery import LARGE

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


def ran(script: str, *arguments: str, home: Path) -> subprocess.CompletedProcess[str]:
    """A studio of its own, whose settings and state lie in ``home``."""
    return subprocess.run(
        [sys.executable, "-c", script, *arguments],
        env={
            **os.environ,
            "QT_QPA_PLATFORM": "offscreen",
            "XDG_STATE_HOME": str(home),
            "XDG_CONFIG_HOME": str(home),
        },
        timeout=120,
        check=False,
        capture_output=True,
        text=True,
    )


_ENDED = """
import os, signal, sys
from PySide6.QtCore import QSettings, QTimer
from situ_studio import main
from situ_studio.edits import places
from situ_studio.window import windows
settings = QSettings(sys.argv[2], QSettings.Format.IniFormat)
main.QSettings = lambda: settings
made = windows.Windows.open_window
def open_window(self, path=None):
    window = made(self, path)
    def edit():
        document = window.session.document("reception.rbd.xml")
        window.commit(places.change(document, ("state", "2"), name="killed"), "Rename")
        os.kill(os.getpid(), signal.SIGTERM)
    QTimer.singleShot(0, edit)
    return window
windows.Windows.open_window = open_window
sys.exit(main.main([sys.argv[1]]))
"""


def test_a_polite_kill_loses_nothing(
    studio: Start, project: Copy, settings: QSettings, tmp_path: Path
) -> None:
    folder = project("reception")
    ended = ran(_ENDED, str(folder), settings.fileName(), home=tmp_path)
    assert ended.returncode == 0, ended.stderr
    assert (tmp_path / "situ-studio" / "studio.log").is_file()
    used = studio(folder)
    used.click(used.window.recovered.buttons[0])
    assert used.session.document(FILE).state("2").name == "killed"


_KILLED = """
import os, random, signal, sys
from pathlib import Path
from PySide6.QtCore import QSettings
from situ.document import codec
from situ.document.folder import clear_unfinished
from situ_studio import main
from situ_studio.edits import places
from situ_studio.files.kept import read
FILE = "reception.rbd.xml"
folder, home = Path(sys.argv[1]), Path(sys.argv[2]).parent / "recovery"
window = main.create_window(folder, QSettings(sys.argv[2], QSettings.Format.IniFormat))
random.seed(int(sys.argv[3]))
unfinished = False
for turn in range(12):
    ears, mouth = os.pipe()
    child = os.fork()
    if child == 0:
        # The same studio goes on, changing and saving, until it is killed.
        step = 0
        while True:
            step += 1
            document = window.session.document(FILE)
            name = f"turn {turn} step {step} " + "x" * random.randrange(3000)
            window.commit(places.change(document, ("state", "2"), name=name), "Rename")
            window.recovery.keep()
            os.write(mouth, b".")
            assert window.commands.save()
    os.close(mouth)
    for _ in range(random.randint(1, 3)):
        assert os.read(ears, 1) == b".", "the studio ended by itself"
    for _ in range(random.randrange(60000)):
        pass
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    os.close(ears)
    unfinished |= any(file.name.startswith(".") for file in folder.iterdir())
    clear_unfinished(folder)
    left = [file.name for file in folder.iterdir() if file.name.startswith(".")]
    assert not left, (turn, left)
    data = (folder / FILE).read_bytes()
    document, problems = codec.read(data, FILE)
    assert document is not None and not problems, (turn, problems)
    assert codec.write(document) == data, turn
    if window.session.disk.is_other(FILE):
        window.session.reconciling.take_theirs(FILE)
    for file in home.glob("*.json"):
        kept = read(file)
        assert kept is not None, (turn, file)
        restored, problems = codec.read(kept.files[FILE].encode(), FILE)
        assert restored is not None and not problems, (turn, file)
"""


def test_whenever_it_is_killed_while_it_saves_each_file_is_the_old_one_or_the_new_one_whole(
    project: Copy, settings: QSettings, tmp_path: Path
) -> None:
    ended = ran(_KILLED, str(project("reception")), settings.fileName(), "8", home=tmp_path)
    assert ended.returncode == 0, ended.stderr


def test_a_disk_that_is_full_while_saving_leaves_the_old_file_and_everything_here(
    studio: Start, project: Copy, caplog: pytest.LogCaptureFixture
) -> None:
    folder = project("reception")
    before = (folder / FILE).read_bytes()
    used = studio(folder)
    rename(used, "too much")
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, hard))
    try:
        used.key(Qt.Key.Key_S, CONTROL)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    notice = used.window.notice
    assert "Not saved" in notice.words.text()
    assert FILE in notice.words.text()
    assert (folder / FILE).read_bytes() == before
    assert {f.name for f in folder.iterdir() if f.name.startswith(".")} == set()
    assert used.session.dirty == [FILE]
    assert used.session.document(FILE).state("2").name == "too much"
    used.click(notice.buttons[0])
    assert not notice.isVisible()
    assert used.session.dirty == []
    assert b"too much" in (folder / FILE).read_bytes()


def test_recovery_goes_on_once_there_is_room_again(
    studio: Start, project: Copy, settings: QSettings, caplog: pytest.LogCaptureFixture
) -> None:
    used = studio(project("reception"))
    rename(used, "kept later")
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, hard))
    try:
        used.window.recovery.keep()
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert kept(settings) == []
    assert "can not be kept" in caplog.text
    assert "save soon" in used.window.status.said.text()
    used.window.recovery.keep()
    assert b"kept later" in kept(settings)[0].read_bytes()


_BEGUN = """
import os, signal, sys
from situ.document import folder
os.replace = lambda *_: os.kill(os.getpid(), signal.SIGKILL)
folder.write(sys.argv[1], b"half")
"""


def test_what_a_killed_writer_left_is_gone_at_the_next_start(
    studio: Start, project: Copy, settings: QSettings, monkeypatch: pytest.MonkeyPatch
) -> None:
    threads: list[threading.Thread] = []

    def clear(where: Path) -> None:
        threads.append(threading.current_thread())
        clear_unfinished(where)

    monkeypatch.setattr("situ.document.folder.clear_unfinished", clear)
    folder, home = project("reception"), Path(settings.fileName()).parent / "recovery"
    home.mkdir()
    (folder / ".mine").write_text("stays")
    for file in (folder / FILE, folder / "scenarios" / "a.toml", home / "a.json"):
        file.parent.mkdir(exist_ok=True)
        done = subprocess.run([sys.executable, "-c", _BEGUN, str(file)], check=False)
        assert done.returncode == -signal.SIGKILL
    held = folder / f".{FILE}.{os.getpid()}.unfinished-x"
    held.write_text("somebody writes this now")
    hidden = [p for root in (folder, home) for p in root.rglob(".*")]
    assert len(hidden) == 5
    studio(folder)
    for thread in [t for t in threading.enumerate() if t.name == leftovers.NAME]:
        thread.join()
    # Never while the window waits.
    assert threads
    assert threading.main_thread() not in threads
    assert {p.name for root in (folder, home) for p in root.rglob(".*")} == {".mine", held.name}


def large(folder: Path) -> None:
    """Makes the application of ``folder`` one that another process keeps."""
    document, _ = codec.read((folder / FILE).read_bytes(), FILE)
    assert isinstance(document, Application)
    more = tuple(State(no=str(1000 + n), name=f"more {n}") for n in range(LARGE))
    whole = replace(document, states=(*document.states, *more))
    (folder / FILE).write_bytes(codec.write(whole))


def come(ends: Callable[[], bool]) -> None:
    """Waits until it is so."""
    loop, look = QEventLoop(), QTimer()
    look.timeout.connect(lambda: loop.quit() if ends() else None)
    look.start(5)
    loop.exec()


def test_a_large_document_is_kept_by_another_process_and_then_what_changed_meanwhile(
    studio: Start, project: Copy, settings: QSettings
) -> None:
    folder = project("reception")
    large(folder)
    used = studio(folder)
    keeping = used.window.recovery
    rename(used, "first")
    keeping._soon.timeout.emit()
    assert keeping._worker.is_busy
    assert kept(settings) == []
    rename(used, "second")
    keeping._soon.timeout.emit()
    come(lambda: not keeping._worker.is_busy)
    (file,) = kept(settings)
    assert b"second" in file.read_bytes()
    # What is kept already is not written again.
    keeping._soon.timeout.emit()
    assert not keeping._worker.is_busy
    rename(used, "third")
    keeping._soon.timeout.emit()
    used.key(Qt.Key.Key_S, CONTROL)
    assert kept(settings) == []
    assert not keeping._worker.is_busy


def test_what_another_process_can_not_keep_is_kept_here(
    studio: Start, project: Copy, settings: QSettings, caplog: pytest.LogCaptureFixture
) -> None:
    folder = project("reception")
    large(folder)
    used = studio(folder)
    keeping = used.window.recovery
    keeping._worker._command = (sys.executable, "-c", "import sys; sys.exit(3)")
    rename(used, "not lost")
    keeping._soon.timeout.emit()
    come(lambda: not keeping._worker.is_busy)
    assert b"not lost" in kept(settings)[0].read_bytes()
    assert "has ended" in caplog.text


_KEEPING = """
import os, signal, sys
from pathlib import Path
from PySide6.QtCore import QSettings
from situ_studio import main
from situ_studio.edits import places
from situ_studio.looks.application import application
FILE = "reception.rbd.xml"
window = main.create_window(Path(sys.argv[1]), QSettings(sys.argv[2], QSettings.Format.IniFormat))
keeping = window.recovery
document = window.session.document(FILE)
window.commit(places.change(document, ("state", "2"), name="killed"), "Rename")
keeping._keep_soon()
worker = keeping._worker
while worker._turn.isActive():
    application().processEvents()
process = worker._processes[0]
process.waitForBytesWritten(10000)
os.kill(os.getpid(), signal.SIGKILL)
"""


def test_what_was_sent_is_kept_though_the_studio_is_killed_before_it_is_written(
    studio: Start, project: Copy, settings: QSettings, tmp_path: Path
) -> None:
    folder = project("reception")
    large(folder)
    ended = ran(_KEEPING, str(folder), settings.fileName(), home=tmp_path)
    assert ended.returncode == -signal.SIGKILL, ended.stderr
    come(lambda: kept(settings) != [])
    used = studio(folder)
    used.click(used.window.recovered.buttons[0])
    assert used.session.document(FILE).state("2").name == "killed"
