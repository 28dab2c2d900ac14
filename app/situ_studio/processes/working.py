"""Long work: what is being done, how far it is, and *Cancel*; a strip in the status bar."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from PySide6.QtCore import QObject, QTimer, Signal, SignalInstance
from PySide6.QtWidgets import QHBoxLayout, QLabel, QProgressBar, QPushButton, QWidget

from situ_studio.looks.letters import px

PATIENCE = 400
"""Milliseconds that a work may take without being shown: what flickers is no help."""


class Work(QObject):
    """One long work. words: what is done; cancel: ends it at once, however far it is."""

    changed = Signal()
    ended = Signal()

    def __init__(self, words: str, cancel: Callable[[], object], parent: QObject) -> None:
        super().__init__(parent)
        self.words = words
        self.done: float | None = None
        """How much of it, from 0 to 1; None: nobody knows."""
        self._cancel = cancel

    def tell(self, done: float) -> None:
        self.done = done
        self.changed.emit()

    def end(self) -> None:
        """It is over, whichever way."""
        self.ended.emit()

    def cancel(self) -> None:
        self._cancel()
        self.end()


class OneWork:
    """One long work of a kind at a time, which is begun again and again. cancel: leaves it."""

    def __init__(self, cancel: Callable[[], object]) -> None:
        self._cancel = cancel
        self._work: Work | None = None

    def begin(self, strip: WorkStrip, words: str) -> None:
        """Shows it in ``strip`` until ``end``, in place of what was begun before."""
        self.end()
        self._work = strip.begin(words, self._give_up)

    def tell(self, done: float) -> None:
        """How much of it is done, from 0 to 1."""
        if self._work is not None:
            self._work.tell(done)

    def end(self) -> None:
        """Nothing is being done any more."""
        work, self._work = self._work, None
        if work is not None:
            work.end()

    def _give_up(self) -> None:
        # The work ends itself.
        self._work = None
        self._cancel()


class Job(Protocol):
    """What goes on beside the window: a QObject that tells when it has ended, and can be ended."""

    ended: SignalInstance
    destroyed: SignalInstance

    def cancel(self) -> None: ...


class WorkStrip(QWidget):
    """Shows the work that was begun last, of those that go on."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        line = QHBoxLayout(self)
        line.setContentsMargins(0, 0, 8, 0)
        line.setSpacing(8)
        self.words = QLabel()
        line.addWidget(self.words)
        self.bar = QProgressBar()
        self.bar.setFixedSize(px(96), px(6))
        self.bar.setTextVisible(False)
        line.addWidget(self.bar)
        self.stop = QPushButton(self.tr("Cancel"))
        self.stop.setProperty("role", "link")
        self.stop.clicked.connect(self.cancel)
        line.addWidget(self.stop)
        self._going: list[Work] = []
        self._soon = QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.setInterval(PATIENCE)
        self._soon.timeout.connect(self._show)
        self.hide()

    @property
    def going(self) -> list[Work]:
        """What goes on now, in the order in which it was begun."""
        return list(self._going)

    def begin(self, words: str, cancel: Callable[[], object]) -> Work:
        """Shows a work, unless it ends soon. Whoever begins it ends it."""
        work = Work(words, cancel, self)
        work.changed.connect(self._settle)
        work.ended.connect(lambda: self._on_ended(work))
        self._going.append(work)
        if self.isHidden():
            self._soon.start()
        else:
            self._settle()
        return work

    def cancel(self) -> None:
        """Cancels the work that is shown."""
        if self._going:
            self._going[-1].cancel()

    def _show(self) -> None:
        self.show()
        self._settle()

    def _settle(self) -> None:
        work = self._going[-1]
        self.words.setText(work.words)
        self.bar.setAccessibleName(work.words)
        self.bar.setRange(0, 0 if work.done is None else 100)
        if work.done is not None:
            self.bar.setValue(round(100 * work.done))

    def _on_ended(self, work: Work) -> None:
        if work not in self._going:
            return
        self._going.remove(work)
        work.deleteLater()
        if self._going:
            self._settle()
        else:
            self._soon.stop()
            self.hide()


def follow(strip: WorkStrip, words: str, job: Job) -> None:
    """Shows a job in the strip until it has ended, or is gone."""
    work = strip.begin(words, job.cancel)
    job.ended.connect(work.end)
    job.destroyed.connect(work.end)
