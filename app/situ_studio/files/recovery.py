"""Unsaved changes, kept in a file of their own until they are saved or given up.

Whatever ends the studio (a crash, a kill, the power), what was changed up to two seconds
before is offered when the project is opened next.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Sequence
from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QLockFile, QObject, QTimer, Signal

from situ.document.catalogue import Catalogue
from situ.document.rbd import Application
from situ.errors import SituError
from situ_studio.edits import edit
from situ_studio.edits.edit import Document, Lines, Written
from situ_studio.files import kept, leftovers
from situ_studio.files.claim import key, lock
from situ_studio.files.kept import Kept, Wanted
from situ_studio.panels.notice import Notice
from situ_studio.processes.worker import Worker, module
from situ_studio.project.session import Session
from situ_studio.wording.language import said

_log = logging.getLogger("situ.studio")

SOON = 2000
"""Milliseconds after an edit at which it is kept."""


LARGE = 60
"""States and situations above which they are kept by another process: about 15 ms of work."""

COMMAND = module("situ_studio.files.keep_process")


class Recovery(QObject):
    """Keeps what ``session`` has not saved in ``home``, and offers in ``notice`` what was kept.

    Every window has a file and a lock of its own there: what another window keeps that still
    runs is not offered. now: the wall clock.
    """

    refused = Signal(str)
    """Unsaved changes can not be kept: why, in one line; told once until they can be again."""

    def __init__(
        self,
        session: Session,
        home: Path,
        notice: Notice,
        now: Callable[[], datetime] = datetime.now,
        command: Sequence[str] = COMMAND,
    ) -> None:
        super().__init__(notice)
        self._session, self._home, self._notice, self._now = session, home, notice, now
        self._file: Path | None = None
        self._lock: QLockFile | None = None
        self._kept: Wanted | None = None
        self._asked: Wanted | None = None
        self._told = False
        self._worker = Worker(command, self)
        self._worker.answered.connect(self._on_written)
        self._worker.said.connect(lambda said: _log.error("keeping changes failed: %s", said))
        self._worker.gone.connect(self._on_worker_gone)
        self._soon = QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.setInterval(SOON)
        self._soon.timeout.connect(self._keep_soon)
        session.opened.connect(self._on_opened)
        session.stack_changed.connect(self._on_stack)

    # -- keeping -----------------------------------------------------------------

    def keep(self) -> None:
        """Keeps what is not saved, now; forgets what was kept where all is saved."""
        wanted = self._begin()
        if wanted is not None:
            self._worker.end()
            self._write(wanted)

    def _keep_soon(self) -> None:
        """The same without holding up the window: another process writes what is large."""
        wanted = self._begin()
        if wanted is None:
            return
        if sum(map(_size, wanted.values.values())) <= LARGE:
            self._worker.end()
            self._write(wanted)
        else:
            self._asked = wanted
            self._worker.ask(wanted)

    def _begin(self) -> Wanted | None:
        """What is to be kept, and where; None where nothing is that is not kept already."""
        self._soon.stop()
        session, values, gone = self._session, dict[str, Written](), dict[str, bytes]()
        for file in session.dirty:
            value = session.value(file)
            if value is None:
                gone[file] = session.disk.was(file)
            elif not session.is_incomplete(file):
                values[file] = value
        if not values and not gone:
            self.forget()
            return None
        try:
            if self._file is None:
                self._home.mkdir(parents=True, exist_ok=True)
                self._file, self._lock = self._free(session.root)
        except OSError as error:
            self._tell(said(str(error)))
            return None
        wanted = Wanted(self._file, str(session.root.resolve()), self._now(), values, gone)
        last = self._asked if self._worker.is_busy else self._kept
        return None if last is not None and wanted.is_like(last) else wanted

    def _write(self, wanted: Wanted) -> None:
        try:
            kept.write(wanted)
        except SituError as error:
            self._tell(said(str(error)))
        else:
            self._kept, self._told = wanted, False

    def _on_written(self, refused: str) -> None:
        if refused:
            self._tell(refused)
        else:
            self._kept, self._told = self._asked, False

    def _tell(self, why: str) -> None:
        _log.warning("unsaved changes can not be kept: %s", why)
        if not self._told:
            self._told = True
            self.refused.emit(
                self.tr(
                    "Unsaved changes can not be kept for the next start ({0}): save soon"
                ).format(why)
            )

    def _on_worker_gone(self) -> None:
        """Rather the window waits than that something is lost."""
        _log.error("the process that keeps changes has ended: they are kept here")
        self.keep()

    def forget(self) -> None:
        """Takes away what this window kept: it is saved, or was given up by a person."""
        self._soon.stop()
        self._kept = None
        if self._worker.is_busy:
            self._worker.end()
            leftovers.clear(self._home)
        if self._file is not None:
            self._file.unlink(missing_ok=True)
        if self._lock is not None:
            self._lock.unlock()
        self._file = self._lock = None

    def _free(self, root: Path) -> tuple[Path, QLockFile]:
        number = 1
        while True:
            file = self._home / f"{key(root)}-{number}.json"
            held = lock(file)
            if not file.exists() and held.tryLock(0):
                return file, held
            number += 1

    def _on_stack(self) -> None:
        # The timer is not put off by the next edit: somebody who never pauses is kept too.
        if not self._session.dirty:
            self.forget()
        elif not self._soon.isActive():
            self._soon.start()

    # -- offering ----------------------------------------------------------------

    def _on_opened(self) -> None:
        # Another project is open: what the last one had was saved, or given up.
        self.forget()
        self._notice.hide()
        leftovers.clear(self._home)
        root = str(self._session.root.resolve())
        for file in sorted(self._home.glob(f"{key(self._session.root)}-*.json")):
            held = lock(file)
            if not held.tryLock(0):
                continue
            found = kept.read(file)
            held.unlock()
            if found is not None and found.root == root:
                self._offer(file, found)
                return

    def _offer(self, file: Path, found: Kept) -> None:
        names = ", ".join((*found.files, *found.gone))
        text = self.tr("There are changes to {0} of {1} that were not saved.")
        self._notice.ask(
            text.format(names, f"{found.at:%Y-%m-%d %H:%M}"),
            (self.tr("Bring them back"), lambda: self._restore(file, found)),
            (self.tr("Forget them"), lambda: file.unlink(missing_ok=True)),
        )

    def _restore(self, file: Path, found: Kept) -> None:
        """As one step, that can be undone. Where a file can not be brought back, none goes; nor
        does one that is not what it was.
        """
        session = self._session
        values: dict[str, Written | None] = {}
        for name, text in found.files.items():
            value, _ = edit.read(text.encode(), name)
            if isinstance(value, Lines):
                session.contents.attend((name,))
            now = session.value(name)
            # What was made, and not saved, is known to no file of the project yet.
            new = now is None and isinstance(value, Document | Catalogue)
            fits = value is not None and (new or type(value) is type(now))
            if fits and not session.is_incomplete(name):
                values[name] = value
        gone = [f for f in found.gone if not session.disk.is_missing(f)]
        whole = len(values) == len(found.files)
        going = [f for f in gone if whole and session.disk.digest(f) == found.gone[f]]
        session.contents.take_away(going)
        session.commit_all(values | dict.fromkeys(going), self.tr("Bring back unsaved changes"))
        for name in gone:
            if name not in going:
                session.left_over.emit(name)
        session.stack_changed.emit()
        # Only once they are kept anew.
        self.keep()
        file.unlink(missing_ok=True)


def _size(value: Written) -> int:
    return len(value.states) if isinstance(value, Application) else 0
