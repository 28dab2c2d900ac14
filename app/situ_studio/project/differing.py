"""What was changed here and what another program changed in one file, since both were the same."""

from __future__ import annotations

from msgspec import Struct

from situ.document import beside
from situ.document.beside import Toml
from situ.document.catalogue import Catalogue
from situ.document.change import Change
from situ.document.diff import compare
from situ.document.join import join, join_texts
from situ.document.project import Project
from situ_studio.edits.edit import Lines, Written
from situ_studio.wording.language import tr


class Differing(Struct, frozen=True):
    """One file that is other on disk than it was read here.

    base: what both began with; None where that was given up. theirs: what lies on disk; None
    where it is gone, or has errors: unread says the first. both: the changes of both, where they
    do not collide. project: as it is here.
    """

    file: str
    mine: Written
    base: Written | None
    theirs: Written | None
    project: Project
    both: Written | None = None
    gone: bool = False
    unread: str = ""

    @property
    def my_changes(self) -> list[Change]:
        """What was changed here; against what lies on disk where the beginning was given up."""
        before = self.base if self.base is not None else self.theirs
        return self._compared(before, self.mine) if before is not None else []

    @property
    def their_changes(self) -> list[Change]:
        """What the other program changed; nothing where the beginning was given up."""
        if self.base is None or self.theirs is None:
            return []
        return self._compared(self.base, self.theirs)

    def _compared(self, before: Written, after: Written) -> list[Change]:
        if isinstance(before, Toml | Catalogue) or isinstance(after, Toml | Catalogue):
            if isinstance(before, Toml | Catalogue) and isinstance(after, Toml | Catalogue):
                return beside.compare(self.project, self.file, before, after)
            return []
        if isinstance(before, Lines) or isinstance(after, Lines):
            told = tr("lines of the scenario")
            return [Change(file=self.file, place=(), text=told, behaviour=False)]
        return compare(before, after, self.file)


def joined(base: Written | None, mine: Written, theirs: Written) -> Written | None:
    """What both made of one file; None where they collide, or nothing is known of the beginning."""
    if isinstance(base, Catalogue) and isinstance(mine, Catalogue):
        return join_texts(base, mine, theirs) if isinstance(theirs, Catalogue) else None
    if base is None or isinstance(base, Toml | Catalogue | Lines):
        return None
    if isinstance(mine, Toml | Catalogue | Lines) or isinstance(theirs, Toml | Catalogue | Lines):
        return None
    return join(base, mine, theirs)
