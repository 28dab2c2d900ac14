"""The windows of the studio, and what they have in common: settings, language, letters."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import msgspec
from msgspec import Struct
from PySide6.QtCore import QByteArray, QEvent, QObject, QPoint, QSettings, QTimer
from PySide6.QtWidgets import QApplication

from situ.errors import SituError
from situ_studio.files.opening import Reading, is_large
from situ_studio.live.moving import move
from situ_studio.log_file import LogFile
from situ_studio.looks import letters
from situ_studio.project.session import Session
from situ_studio.views.showing import keep, recall, show_again, showing
from situ_studio.welcome.project_pictures import Example
from situ_studio.window.main_window import MainWindow
from situ_studio.wording.language import SYSTEM, Speaking, language_of

ASIDE = QPoint(32, 32)
"""How far a new window lies from where the last one was."""


class Kept(Struct, frozen=True):
    """One window with a project, as the settings keep it for the next start."""

    root: str
    geometry: str
    welcome: bool = False


class Windows(QObject):
    """Makes windows, and makes them anew where the language changes, or the size of letters.

    examples: what the welcome page offers. theme: in place of the one in the settings.
    language: in place of the one in the settings.
    """

    def __init__(
        self,
        settings: QSettings,
        speaking: Speaking,
        examples: Callable[[], list[Example]],
        theme: str | None = None,
        language: str | None = None,
    ) -> None:
        super().__init__()
        self._settings = settings
        self._speaking = speaking
        self._examples = examples
        self._theme = theme
        self._quitting = False
        self._reading: dict[MainWindow, Kept] = {}
        self.log: LogFile | None = None
        self.windows: list[MainWindow] = []
        self.language = language or str(settings.value("language", SYSTEM))
        self._speak()
        self.letters = str(settings.value("letters", letters.SYSTEM))
        letters.use(letters.percent_of(self.letters))

    def _speak(self) -> None:
        code = language_of(self.language)
        if code != self._speaking.code:
            self._speaking.use(code)

    def open_window(self, path: Path | None = None) -> MainWindow:
        """A window with the project at ``path``, or with the welcome page; not shown yet.

        Raises UsageError, with one line, where ``path`` is no project that can be read.
        """
        window = self._made(Session(), path is not None)
        if path is not None:
            try:
                window.open_project(path)
            except SituError:
                self._forget(window)
                window.deleteLater()
                raise
        return window

    def _made(
        self, session: Session, opening: bool, before: MainWindow | None = None
    ) -> MainWindow:
        link = before.robot.link if before is not None else None
        window = MainWindow(session, self._settings, self._examples, self._theme, opening, link)
        window.windows = self
        window.welcome.languages.show_choice(self._speaking.code)
        window.closed.connect(self._on_closed)
        window.looks_changed.connect(self.settle_letters)
        self.windows.append(window)
        return window

    def _on_closed(self, window: MainWindow) -> None:
        if len(self.windows) > 1:
            self._forget(window)
            window.deleteLater()
            self.remember()
        else:
            # What was open in the last one is open again at the next start.
            self.remember()
            self._forget(window)

    def _forget(self, window: MainWindow) -> None:
        self._reading.pop(window, None)
        if window in self.windows:
            self.windows.remove(window)

    def window_of(self, path: Path) -> MainWindow | None:
        """The window in which the project at ``path`` is open."""
        there = path.resolve()
        for window in self.windows:
            project = window.session.project
            if project is None:
                continue
            root = window.session.root.resolve()
            names = [root] if project.toml is not None else [root / f for f in window.session.files]
            if there in names or (project.toml is not None and there == root / project.toml):
                return window
        return None

    def show_project(self, path: Path) -> None:
        """Opens a project in a window of its own, a large one once it is read. Raises UsageError
        as ``open_window``."""
        if not is_large(path):
            window = self.open_window(path)
            self._show(window)
            recall(self._settings, window)
            return
        window = self.open_window()
        self._show(window)
        Reading(window, path, self._on_refused)

    def _on_refused(self, window: MainWindow, why: str) -> None:
        """A project can not be read into its window: it is not in the way of the others."""
        self._reading.pop(window, None)
        if len(self.windows) > 1:
            self._forget(window)
            window.asked = True
            window.close()
            window.deleteLater()
        if why and self.windows:
            self.windows[0].say(why)

    def _show(self, window: MainWindow) -> None:
        window.move(window.pos() + ASIDE)
        window.show()
        window.activateWindow()

    def quit(self) -> None:
        """Closes all windows, or none where a person wants to stay in one."""
        if not all(window.may_leave() for window in self.windows):
            return
        self.remember()
        self._quitting = True
        for window in list(self.windows):
            window.asked = True
            window.close()
        self._quitting = False

    def keep_unsaved(self) -> None:
        """Keeps for the next start what is not saved in any window."""
        for window in self.windows:
            window.finish_fields()
            window.recovery.keep()

    def tell_fault(self, words: str, details: str) -> None:
        """Tells of a fault of the studio over the window that is used."""
        active = QApplication.activeWindow()
        shown = [w for w in self.windows if w is active] or self.windows
        if shown:
            shown[0].dialogs.details(self.tr("A fault in Situ Studio"), words, details)

    def show_log(self, window: MainWindow) -> None:
        """Shows the end of the log over ``window``."""
        if self.log is None:
            window.say(self.tr("This Situ Studio writes no log."))
            return
        words = self.tr(
            "What Situ Studio noted lately, for a report. It names files, and no texts of yours. "
            "All of it lies in {0}."
        )
        title, text = self.tr("Log"), self.log.end()
        window.dialogs.details(title, words.format(self.log.path.parent), text, unfolded=True)

    def remember(self) -> None:
        """Keeps what is open for the next start."""
        if self._quitting:
            return
        every = []
        for window in self.windows:
            project = window.session.project
            if project is not None and project.toml is not None:
                keep(self._settings, window)
                geometry = bytes(window.saveGeometry().toBase64().data()).decode()
                welcome = window.stack.currentIndex() == 0
                every.append(Kept(str(window.session.root.resolve()), geometry, welcome))
            elif window in self._reading:
                every.append(self._reading[window])
        self._settings.setValue("open", msgspec.json.encode(every).decode())

    def restore(self) -> MainWindow | None:
        """Opens and shows what was open at the end, the first window of it; None where nothing
        was, or nothing of it is there any more. Large projects are read while their windows are
        seen, each by itself."""
        try:
            every = msgspec.json.decode(str(self._settings.value("open", "[]")), type=list[Kept])
        except msgspec.MsgspecError:
            return None
        missing = []
        for one in every:
            path = Path(one.root)
            if is_large(path):
                self._read_again(one)
                continue
            try:
                window = self.open_window(path)
            except SituError:
                missing.append(one.root)
                continue
            self._show_again(window, one)
            recall(self._settings, window)
            if one.welcome:
                window.welcoming.show()
        if missing:
            shown = self.windows[0] if self.windows else self.open_window()
            shown.show()
            shown.say(self.tr("Not there any more: {0}").format(", ".join(missing)))
        return self.windows[0] if self.windows else None

    def recall(self, window: MainWindow) -> None:
        """The window's project is shown as it was the last time."""
        recall(self._settings, window)

    def _show_again(self, window: MainWindow, one: Kept) -> None:
        window.restoreGeometry(QByteArray.fromBase64(one.geometry.encode()))
        window.show()

    def _read_again(self, one: Kept) -> None:
        window = self.open_window()
        # Whoever quits before it is read has it open at the next start all the same.
        self._reading[window] = one
        self._show_again(window, one)
        Reading(window, Path(one.root), self._on_refused)

    def new_window(self) -> None:
        """A window with the welcome page, beside the others."""
        self._show(self.open_window())

    def settle_keys(self) -> None:
        """Every window's commands have the keys that the settings say now."""
        for window in self.windows:
            window.settle_keys()

    def choose_language(self, choice: str) -> None:
        """Speaks another language: every window is made anew, and shows what it showed."""
        self.language = choice
        self._settings.setValue("language", choice)
        if language_of(choice) == self._speaking.code:
            for window in self.windows:
                window.actions_.refresh()
            return
        self._speak()
        # The window whose menu was used is still in the middle of it.
        QTimer.singleShot(0, self, self._renew_all)

    def choose_letters(self, choice: str) -> None:
        """Letters of another size, in percent, or as large as the system's: in all windows, at once
        and at the next start."""
        self.letters = choice
        self._settings.setValue("letters", choice)
        self.settle_letters()

    def settle_letters(self) -> None:
        """Where letters shall have another size than they have, every window is made anew."""
        percent = letters.percent_of(self.letters)
        if percent == round(100 * letters.factor()):
            for window in self.windows:
                window.actions_.refresh()
            return
        letters.use(percent)
        QTimer.singleShot(0, self, self._renew_all)

    def _renew_all(self) -> None:
        for window in list(self.windows):
            self._renew(window)

    def _renew(self, old: MainWindow) -> None:
        old.finish_fields()
        # As where a window closes: what made room for a while is kept in its place.
        old.designing.leave()
        old.moment.leave()
        old.keep()
        shown, visible = showing(old), old.isVisible()
        old.recovery.forget()
        reading = self._reading.get(old)
        self._forget(old)
        new = self._made(old.session, old.session.project is not None, old)
        if reading is not None:
            self._reading[new] = reading
        for one in old.findChildren(Reading):
            one.move_to(new)
        old.exporting.move_to(new.exporting)
        old.document_files.move_to(new.document_files)
        new.claim, old.claim = old.claim, new.claim
        new.take_over()
        move(old, new)
        new.setGeometry(old.geometry())
        new.setVisible(visible)
        if old.session.project is not None:
            # Where a canvas looks hangs on its size, which it has once it is laid out.
            QApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest)
            show_again(new, shown)
        old.hide()
        old.deleteLater()
