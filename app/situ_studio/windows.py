"""The windows of the studio, and what they have in common: settings and language."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QEvent, QObject, QPoint, QSettings, QTimer
from PySide6.QtWidgets import QApplication

from situ.errors import SituError
from situ_studio.language import SYSTEM, Speaking, language_of
from situ_studio.session import Session
from situ_studio.showing import show_again, showing
from situ_studio.welcome import Example
from situ_studio.window import MainWindow

ASIDE = QPoint(32, 32)
"""How far a new window lies from where the last one was."""


class Windows(QObject):
    """Makes windows, and makes them anew where the language changes.

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
        self.windows: list[MainWindow] = []
        self.language = language or str(settings.value("language", SYSTEM))
        self._speak()

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
        window.closed.connect(self._on_closed)
        self.windows.append(window)
        return window

    def _on_closed(self, window: MainWindow) -> None:
        self._forget(window)
        if self.windows:
            window.deleteLater()

    def _forget(self, window: MainWindow) -> None:
        if window in self.windows:
            self.windows.remove(window)

    def new_window(self) -> None:
        """A window with the welcome page, beside the others."""
        window = self.open_window()
        window.move(window.pos() + ASIDE)
        window.show()

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

    def _renew_all(self) -> None:
        for window in list(self.windows):
            self._renew(window)

    def _renew(self, old: MainWindow) -> None:
        old.finish_fields()
        old.keep()
        shown, visible = showing(old), old.isVisible()
        old.recovery.forget()
        self._forget(old)
        new = self._made(old.session, old.session.project is not None, old)
        new.take_over()
        new.setGeometry(old.geometry())
        new.setVisible(visible)
        if old.session.project is not None:
            # Where a canvas looks hangs on its size, which it has once it is laid out.
            QApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest)
            show_again(new, shown)
        old.hide()
        old.deleteLater()
