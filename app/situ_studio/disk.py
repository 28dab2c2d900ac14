"""A window's files on disk: what another program changed, and what can not be changed here."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from situ.errors import SituError

if TYPE_CHECKING:
    from situ_studio.window import MainWindow


class DiskSide(QObject):
    """Asks whose change counts where a file was changed here and on disk."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        window.session.changed_on_disk.connect(self._on_changed)

    def settle(self) -> None:
        """Says that the shown file can not be changed, where that is so."""
        window = self._window
        file = window.current_file
        if file is None or not window.session.is_incomplete(file):
            window.incomplete.hide()
            return
        text = self.tr(
            "{0} has errors, and what they name is not shown. It can not be changed here until "
            "they are mended in a text editor; then it is read anew."
        )
        window.incomplete.ask(text.format(file))

    def _on_changed(self, file: str) -> None:
        window = self._window
        if file not in window.session.dirty:
            try:
                window.session.take_from_disk(file)
            except SituError as error:
                text = self.tr("Another program changed {0}, and it has errors now: {1}")
                window.notice.ask(
                    text.format(file, error),
                    (self.tr("Keep mine"), lambda: window.session.keep_mine(file)),
                    about=file,
                )
                return
            if window.notice.about == file:
                window.notice.hide()
            self.settle()
            window.say(self.tr("{0} was changed by another program: read anew.").format(file))
            return
        window.notice.ask(
            self.tr("Another program changed {0}; you have changed it too.").format(file),
            (self.tr("Take the one on disk"), lambda: self._on_theirs(file)),
            (self.tr("Keep mine"), lambda: window.session.keep_mine(file)),
            about=file,
        )

    def _on_theirs(self, file: str) -> None:
        try:
            self._window.session.take_from_disk(file)
        except SituError as error:
            self._window.dialogs.tell(str(error))
