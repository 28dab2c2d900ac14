"""The one undo stack of a project: what was done, and how far of it was taken back."""

from __future__ import annotations

from collections.abc import Set as AbstractSet

from msgspec import Struct

from situ.document.beside import is_beside
from situ_studio.edits.edit import Edit, Place

Selection = tuple[Place, ...]

Looking = tuple[float, float, float]
"""Where a canvas looks: its zoom, and the scene's point in its upper left corner."""


class Step(Struct):
    """What one gesture changed, with what was selected before and after it and where the canvas
    looked, so that undo and redo bring that back too.

    edits: one a file; the first is that of the document in which it was done.
    """

    edits: tuple[Edit, ...]
    before: Selection = ()
    after: Selection = ()
    looking: Looking | None = None

    @property
    def file(self) -> str:
        """In which it was done: a document that went, not the list on which it stood."""
        gone = [one.file for one in self.edits if one.after is None]
        first = self.edits[0].file
        return gone[0] if gone and is_beside(first) and not is_beside(gone[0]) else first


class UndoStack:
    """Steps that were done, and behind them those that were taken back."""

    def __init__(self) -> None:
        self._steps: list[Step] = []
        self._at = 0

    def add(self, step: Step) -> None:
        """A step was done; what was taken back before can not be done again."""
        del self._steps[self._at :]
        self._steps.append(step)
        self._at += 1

    @property
    def undo_text(self) -> str | None:
        """The name of the step that undo takes back; None where there is none."""
        return self._steps[self._at - 1].edits[0].text if self._at else None

    @property
    def redo_text(self) -> str | None:
        return self._steps[self._at].edits[0].text if self._at < len(self._steps) else None

    def back(self) -> Step | None:
        """The step to be taken back now; None where there is none."""
        if not self._at:
            return None
        self._at -= 1
        return self._steps[self._at]

    def forward(self) -> Step | None:
        """The step to be done again now; None where there is none."""
        if self._at == len(self._steps):
            return None
        self._at += 1
        return self._steps[self._at - 1]

    def leads_to(self, file: str) -> bool:
        """Whether any step changed that file."""
        return any(one.file == file for step in self._steps for one in step.edits)

    def forget(self, gone: AbstractSet[str]) -> None:
        """Steps that changed a file that is gone can not be taken back any more."""
        done = [s for s in self._steps[: self._at] if not gone & {e.file for e in s.edits}]
        undone = [s for s in self._steps[self._at :] if not gone & {e.file for e in s.edits}]
        self._steps, self._at = [*done, *undone], len(done)
