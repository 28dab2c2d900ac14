"""Unsaved changes, kept in a file of their own until they are saved or given up.

Whatever ends the studio (a crash, a kill, the power), what was changed up to two seconds
before is offered when the project is opened next.
"""

from __future__ import annotations

import logging
from collections.abc import Callable
from datetime import datetime
from pathlib import Path

import msgspec
from PySide6.QtCore import QLockFile, QObject, QTimer

from situ.document import folder
from situ.document.catalogue import Catalogue
from situ.document.rbd import Application
from situ.errors import SituError
from situ_studio import edit
from situ_studio.claim import key, lock
from situ_studio.edit import Written
from situ_studio.panels.notice import Notice
from situ_studio.session import Session

_log = logging.getLogger("situ.studio")

SOON = 2000
"""Milliseconds after an edit at which it is kept."""


class Kept(msgspec.Struct, frozen=True):
    """What a recovery file holds: the unsaved documents of one project, as their files' text."""

    root: str
    at: datetime
    files: dict[str, str]


class Recovery(QObject):
    """Keeps what ``session`` has not saved in ``home``, and offers in ``notice`` what was kept.

    Every window has a file and a lock of its own there: what another window keeps that still
    runs is not offered. now: the wall clock.
    """

    def __init__(
        self,
        session: Session,
        home: Path,
        notice: Notice,
        now: Callable[[], datetime] = datetime.now,
    ) -> None:
        super().__init__(notice)
        self._session, self._home, self._notice, self._now = session, home, notice, now
        self._file: Path | None = None
        self._lock: QLockFile | None = None
        self._kept: dict[str, Written] = {}
        self._soon = QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.setInterval(SOON)
        self._soon.timeout.connect(self.keep)
        session.opened.connect(self._on_opened)
        session.stack_changed.connect(self._on_stack)

    # -- keeping -----------------------------------------------------------------

    def keep(self) -> None:
        """Keeps what is not saved now; forgets what was kept where all is saved."""
        self._soon.stop()
        dirty = {f: self._session.value(f) for f in self._session.dirty}
        wanted = {
            file: document
            for file, document in dirty.items()
            if document is not None and not self._session.is_incomplete(file)
        }
        if not wanted:
            self.forget()
            return
        if wanted == self._kept and all(wanted[f] is self._kept[f] for f in wanted):
            return
        root = str(self._session.root.resolve())
        files = {file: edit.write(document).decode() for file, document in wanted.items()}
        try:
            if self._file is None:
                self._home.mkdir(parents=True, exist_ok=True)
                self._file, self._lock = self._free(self._session.root)
            folder.write(self._file, msgspec.json.encode(Kept(root, self._now(), files)))
        except (SituError, OSError) as error:
            _log.warning("unsaved changes can not be kept: %s", error)
            return
        self._kept = wanted

    def forget(self) -> None:
        """Takes away what this window kept: it is saved, or was given up by a person."""
        self._soon.stop()
        self._kept = {}
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
        root = str(self._session.root.resolve())
        for file in sorted(self._home.glob(f"{key(self._session.root)}-*.json")):
            held = lock(file)
            if not held.tryLock(0):
                continue
            kept = read(file)
            held.unlock()
            if kept is not None and kept.root == root:
                self._offer(file, kept)
                return

    def _offer(self, file: Path, kept: Kept) -> None:
        names = ", ".join(kept.files)
        text = self.tr("There are changes to {0} of {1} that were not saved.")
        self._notice.ask(
            text.format(names, f"{kept.at:%Y-%m-%d %H:%M}"),
            (self.tr("Bring them back"), lambda: self._restore(file, kept)),
            (self.tr("Forget them"), lambda: file.unlink(missing_ok=True)),
        )

    def _restore(self, file: Path, kept: Kept) -> None:
        """As one step a document, that can be undone."""
        for name, text in kept.files.items():
            document, _ = edit.read(text.encode(), name)
            now = self._session.value(name)
            # A part that was made, and not saved, is known to no file of the project yet.
            new = now is None and isinstance(document, Application | Catalogue)
            if document is not None and (new or type(document) is type(now)):
                self._session.commit(name, document, self.tr("Bring back unsaved changes"))
        # Only once they are kept anew.
        self.keep()
        file.unlink(missing_ok=True)


def read(file: Path) -> Kept | None:
    """What was kept in ``file``; None where that can not be read."""
    try:
        return msgspec.json.decode(file.read_bytes(), type=Kept)
    except (OSError, msgspec.MsgspecError):
        return None
