"""Situ Studio's start: the only place where its objects are wired."""

from __future__ import annotations

import argparse
import logging
import os
import re
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QEvent, QEventLoop, QSettings, QTimer, qInstallMessageHandler
from PySide6.QtWidgets import QApplication

import situ
from situ.document import folder
from situ.errors import SituError, UsageError
from situ.resources import examples
from situ_studio.edits.edit import Document
from situ_studio.export import picture
from situ_studio.log_file import LogFile, on_qt_message, usual_folder
from situ_studio.looks.application import application
from situ_studio.panels.project_tree import stem
from situ_studio.unexpected import Hooks, Interrupts, Unexpected
from situ_studio.views.table import VIEWS
from situ_studio.welcome.project_pictures import Example
from situ_studio.window.main_window import MainWindow
from situ_studio.window.windows import Windows
from situ_studio.wording.language import LANGUAGES, Speaking, spoken

_log = logging.getLogger("situ.studio")

WELCOME = "welcome"
PATIENCE = 5000
"""Milliseconds that a screenshot of a robot waits for it to answer."""


def create_window(
    path: str | Path | None = None,
    settings: QSettings | None = None,
    theme: str | None = None,
    language: str | None = None,
) -> MainWindow:
    """A window with the project at ``path`` open, or with the welcome page; not shown yet.

    settings: where geometry, theme and recent projects are kept; the user's own unless given.
    theme: ``light``, ``dark`` or ``system``, language: a code of ``LANGUAGES`` or ``system``, in
    place of those kept.
    Raises UsageError, with one line, where ``path`` is no project that can be read.
    """
    made = _windows(settings or QSettings(), theme, language)
    return made.open_window(None if path is None else Path(path))


def _windows(settings: QSettings, theme: str | None, language: str | None) -> Windows:
    """None yet."""
    qt = application()
    speaking = qt.findChild(Speaking) or Speaking(qt)
    return Windows(settings, speaking, shipped_examples, theme, language)


def shipped_examples() -> list[Example]:
    """Those that can be read, with the first sentence of their README in the user's language."""
    found = []
    for name, where in examples().items():
        try:
            project, _ = folder.load(where)
        except SituError:
            continue
        if project is not None:
            found.append(Example(name, _about(where), project))
    # The one with a single application is the easier one to begin with.
    return sorted(found, key=lambda e: (e.project.spds is not None, e.name))


def _about(where: Path) -> str:
    """The first sentence of a README in the user's language, else in English, or nothing."""
    theirs = where / f"README.{spoken()}.md"
    try:
        text = (theirs if theirs.is_file() else where / "README.md").read_text(encoding="utf-8")
    except OSError:
        return ""
    for paragraph in text.split("\n\n"):
        line = " ".join(paragraph.split())
        if line and not line.startswith(("#", "```", "|", "-", "!")):
            return re.split(r"(?<=[.!?])\s|(?<=。)", line)[0].replace("`", "")
    return ""


# -- the command line ----------------------------------------------------------------


def parser() -> argparse.ArgumentParser:
    """The options of ``situ studio``."""
    made = argparse.ArgumentParser(prog="situ studio", allow_abbrev=False)
    made.add_argument("project", nargs="?", metavar="PROJECT")
    made.add_argument("--new", action="store_true")
    made.add_argument("--screenshot", metavar="OUT.png")
    made.add_argument("--picture", metavar="OUT.svg|pdf|png")
    made.add_argument("--document", metavar="NAME")
    made.add_argument("--size", type=_size, metavar="WxH")
    made.add_argument("--view", metavar="NAME")
    made.add_argument("--connect", metavar="ENDPOINT")
    made.add_argument("--at", type=float, default=0.0, metavar="SECONDS")
    made.add_argument("--theme", choices=("light", "dark"))
    made.add_argument("--language", choices=tuple(LANGUAGES))
    made.add_argument("--log-level", choices=("debug", "info", "warning", "error"))
    return made


def _size(text: str) -> tuple[int, int]:
    found = re.fullmatch(r"([1-9]\d{1,4})x([1-9]\d{1,4})", text)
    if found is None:
        raise argparse.ArgumentTypeError(f"{text!r} is no size; write it as 1440x900")
    return int(found[1]), int(found[2])


def main(argv: Sequence[str] | None = None) -> int:
    """Runs the studio; the exit status: 0 well, 2 wrong usage or unreadable input."""
    try:
        options = parser().parse_args(argv)
    except SystemExit as stopped:
        return stopped.code if isinstance(stopped.code, int) else 2
    level = (options.log_level or "warning").upper()
    said = logging.StreamHandler()
    said.setLevel(level)
    logging.basicConfig(
        level=min(logging.INFO, said.level),
        format="%(levelname)s %(name)s: %(message)s",
        handlers=[said],
    )
    try:
        return run(options)
    except SituError as error:
        print(f"situ studio: {error}", file=sys.stderr)
    except Exception as error:
        # The last frame of the program: a defect is told in one line, not by a traceback.
        _log.debug("unexpected", exc_info=True)
        print(
            f"situ studio: a fault in the studio itself ({type(error).__name__}: {error}); "
            "please report it with what --log-level debug prints",
            file=sys.stderr,
        )
    return 2


def run(options: argparse.Namespace) -> int:
    """Opens the window and runs Qt's loop, or takes the screenshot."""
    choose_platform(options.screenshot is not None or options.picture is not None)
    qt = application()
    if options.picture is not None:
        return draw_picture(options.project, options.picture, options.document)
    if options.screenshot is not None:
        with tempfile.TemporaryDirectory() as fresh:
            # A picture shows the window as it is at the first start, and leaves no trace.
            settings = QSettings(f"{fresh}/settings.ini", QSettings.Format.IniFormat)
            window = _window(options, _windows(settings, options.theme, options.language))
            return screenshot(window, options.screenshot, options.connect, options.at)
    log = LogFile(usual_folder())
    log.open()
    before = qInstallMessageHandler(on_qt_message)
    _log.info("Situ Studio %s", situ.__version__)
    try:
        return _use(qt, options, log)
    finally:
        qInstallMessageHandler(before)
        log.close()


def _use(qt: QApplication, options: argparse.Namespace, log: LogFile) -> int:
    """Shows the windows and runs Qt's loop until the last is closed."""
    windows = _windows(QSettings(), options.theme, options.language)
    windows.log = log
    unexpected = Unexpected(windows.keep_unsaved, windows.tell_fault)
    with Hooks(unexpected), Interrupts(qt):
        asked = options.project is not None or options.new or options.view is not None
        window = None if asked else windows.restore()
        if window is None:
            window = _window(options, windows)
            window.show()
            if options.view is None:
                windows.recall(window)
        if options.connect is not None:
            window.robot.connect_robot(options.connect)
        status = int(qt.exec())
    # Ended from outside: nobody was asked what to do with what is not saved.
    windows.keep_unsaved()
    if windows.windows:
        windows.remember()
    return status


def choose_platform(picture: bool) -> None:
    """A picture needs no display; a window does, and Qt would end the process without one.

    Raises UsageError for a window where there is none. ``QT_QPA_PLATFORM`` has the last word.
    """
    if sys.platform != "linux" or os.environ.get("QT_QPA_PLATFORM"):
        return
    if picture:
        os.environ["QT_QPA_PLATFORM"] = "offscreen"
    elif not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        raise UsageError(
            "there is no display (neither DISPLAY nor WAYLAND_DISPLAY is set); "
            "for a picture of the window use --screenshot OUT.png"
        )


def _window(options: argparse.Namespace, windows: Windows) -> MainWindow:
    """The window that the command line asks for."""
    project = None if options.view == WELCOME else options.project
    window = windows.open_window(None if project is None else Path(project))
    if options.size is not None:
        window.resize(*options.size)
    if options.view is not None:
        try:
            show_view(window, options.view)
        except SituError:
            window.deleteLater()
            raise
    return window


def draw_picture(project: str | None, out: str, name: str | None) -> int:
    """Writes a document's graph as ``out``: the one of that file stem, else the first that has one.

    Raises UsageError, with one line, where there is none or it can not be written.
    """
    if project is None:
        raise UsageError("--picture needs a PROJECT")
    picture.format_of(out)
    # Only read, not watched and not checked: a session does both.
    found, problems = folder.load(project)
    if found is None:
        raise UsageError(str(problems[0]) if problems else f"{project}: no project could be read")
    drawn: dict[str, Document] = {
        stem(file): application
        for file, application in (*found.applications.items(), *found.parts.items())
    }
    if found.spds is not None and found.spds_file is not None:
        drawn[stem(found.spds_file)] = found.spds
    name = name if name is not None else next(iter(drawn), "")
    if name not in drawn:
        known = ", ".join(drawn) or "none"
        raise UsageError(f"no graph {name!r}; there are: {known}")
    picture.draw(drawn[name], out, name)
    return 0


def show_view(window: MainWindow, name: str) -> None:
    """Shows what ``--view`` names: a document's file stem, before it a view of it as in
    ``outline:reception`` or ``both:script``, or ``welcome``.

    ``NAME/PLACE`` selects too: ``reception/state/6``. Raises UsageError naming what there is.
    """
    if name == WELCOME:
        window.welcoming.show()
        return
    wanted, mode = name, "graph"
    before, colon, after = name.partition(":")
    if colon and before in {view.name for view in VIEWS}:
        wanted, mode = after, before
    wanted, *place = wanted.split("/")
    files = {stem(file): file for file in window.session.files}
    project = window.session.project
    if wanted == "spds" and project is not None and project.spds_file is not None:
        files["spds"] = project.spds_file
    if wanted not in files:
        known = ", ".join(files) or "none: name a project too"
        raise UsageError(f"no view {wanted!r}; there are: {known}")
    window.open_file(files[wanted])
    window.show_mode(mode)
    if place:
        window.go_to(files[wanted], tuple(place))


def screenshot(window: MainWindow, out: str, connect: str | None, at: float = 0.0) -> int:
    """Shows the window and draws it into a PNG once it is laid out, and the robot was heard.

    at: the robot's time, in seconds, that the picture shows at the earliest.
    """
    window.show()
    window.session.check_now()
    settle(window)
    if connect is not None:
        catch_up(window, connect, at)
    view = window.current_view
    if view is not None and view.mode == "graph":
        view.call("zoom_to_fit")
        settle(window)
    picture = window.grab()
    if not picture.save(out, "PNG"):
        raise UsageError(f"{out}: can not be written")
    window.session.blockSignals(True)
    window.close()
    window.deleteLater()
    return 0


def catch_up(window: MainWindow, endpoint: str, at: float = 0.0) -> None:
    """Connects and waits until the robot's time, as its events tell it, has come to ``at``.

    Raises UsageError where it says nothing for ``PATIENCE``, or ends before.
    """
    link = window.robot.link
    loop = QEventLoop()
    patience = QTimer()
    patience.setSingleShot(True)
    patience.timeout.connect(loop.quit)

    def heard() -> None:
        if link.log.now.t >= at:
            loop.quit()
        else:
            patience.start(PATIENCE)

    link.moment_changed.connect(heard)
    link.state_changed.connect(
        lambda: loop.quit() if link.state.kind in ("refused", "lost") else None
    )
    window.robot.connect_robot(endpoint)
    patience.start(PATIENCE)
    loop.exec()
    if not link.connected:
        raise UsageError(link.state.why or f"{endpoint}: nobody answers; is situ run going there?")
    if link.log.now.t < at:
        raise UsageError(f"{endpoint}: nothing happens there; --at {at:g} s does not come")
    window.robot.follower.refresh()


def settle(window: MainWindow) -> None:
    """Lets Qt lay out and paint everything that is due: a turn of the loop after the last event."""
    loop = QEventLoop()
    for _ in range(4):
        QTimer.singleShot(0, loop.quit)
        loop.exec()
        QApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest)
        QApplication.processEvents()
    assert window.isVisible()
