"""A window's files on disk: what another program changed, and what can not be changed here."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from situ.document.diff import compare
from situ.errors import SituError
from situ_studio.wording.language import said

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow

UNSAVED = "what can not be saved"
"""What the notice is about that is about no file."""


class DiskSide(QObject):
    """Asks whose change counts where a file was changed here and on disk."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        window.session.changed_on_disk.connect(self._on_changed)
        window.session.folder_gone.connect(self._on_gone)
        window.session.disk.back.connect(self._on_back)
        window.session.moved.connect(self._on_moved)

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

    def resolve(self, file: str) -> bool:
        """Asks which of both shall stay; False where that was not decided, or can not be."""
        window, session = self._window, self._window.session
        answer = window.dialogs.conflict(session.reconciling.differing(file))
        if answer == "cancel":
            return False
        try:
            if answer == "both":
                session.reconciling.take_both(file)
            elif answer == "theirs":
                session.reconciling.take_theirs(file)
            else:
                session.reconciling.keep_mine(file)
        except SituError as error:
            window.dialogs.tell(said(str(error)))
            return False
        if window.notice.about == file:
            window.notice.hide()
        return True

    def tell_unsaved(self, error: SituError) -> None:
        """Saving failed: nothing is lost, and there are other places."""
        window = self._window
        window.recovery.keep()
        text = self.tr(
            "Not saved. {0}. Your changes stay here, and are kept for the next start too."
        )
        window.notice.ask(
            text.format(said(str(error)).rstrip(".")),
            (self.tr("Try again"), window.commands.save),
            (self.tr("Save a copy…"), window.commands.save_copy),
            about=UNSAVED,
        )

    def tell_saved(self) -> None:
        """What could not be saved is saved now."""
        if self._window.notice.about == UNSAVED:
            self._window.notice.hide()

    # -- what another program did ------------------------------------------------

    def _on_changed(self, file: str) -> None:
        window, session = self._window, self._window.session
        if session.disk.is_missing(file):
            self._ask(self.tr("{0} is gone: another program removed or renamed it."), file)
        elif file in session.dirty:
            self._ask(self.tr("Another program changed {0}; you have changed it too."), file)
        else:
            before = session.document(file)
            try:
                session.reconciling.take_theirs(file)
            except SituError as error:
                text = self.tr("Another program changed {0}, and it has errors now: {1}")
                window.notice.ask(
                    text.format(file, said(str(error))),
                    (self.tr("Keep mine"), lambda: session.reconciling.keep_mine(file)),
                    about=file,
                )
                return
            if window.notice.about == file:
                window.notice.hide()
            self.settle()
            after = session.document(file)
            changes = []
            if before is not None and after is not None:
                changes = [said(change.text) for change in compare(before, after, file)]
            text = self.tr("{0} was changed by another program: read anew.").format(file)
            window.say(" ".join((text, *changes[:1], *("…" for _ in changes[1:2]))))

    def _ask(self, text: str, file: str) -> None:
        self._window.notice.ask(
            text.format(file),
            (self.tr("Look at the changes…"), lambda: self._answered(text, file)),
            about=file,
        )

    def _answered(self, text: str, file: str) -> None:
        if not self.resolve(file):
            self._ask(text, file)

    def _on_gone(self) -> None:
        window = self._window
        if window.notice.isVisible() and window.notice.about == str(window.session.root):
            return
        text = self.tr(
            "The folder {0} is gone: it was renamed or removed, or its drive is away. "
            "Your documents are still here."
        )
        window.notice.ask(
            text.format(window.session.root),
            (self.tr("It is back"), self.look),
            (self.tr("Show where it is now…"), self._find),
            (self.tr("Save a copy…"), window.commands.save_copy),
            about=str(window.session.root),
        )

    def look(self) -> None:
        """Looks whether something was changed: not every drive tells that by itself."""
        if self._window.session.project is not None:
            self._window.session.disk.look()

    def _on_back(self) -> None:
        window = self._window
        if window.notice.about == str(window.session.root):
            window.notice.hide()

    def _find(self) -> None:
        window = self._window
        path = window.dialogs.project(str(window.session.root.parent))
        if path is None:
            self._on_gone()
            return
        try:
            window.session.move(Path(path))
        except SituError as error:
            window.dialogs.tell(said(str(error)))
            self._on_gone()

    def _on_moved(self) -> None:
        window = self._window
        window.notice.hide()
        window.welcoming.remember(window.session.root)
        window.say(self.tr("The project is saved in {0} now.").format(window.session.root))
