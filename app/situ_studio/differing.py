"""What was changed here and what another program changed in one file, since both were the same."""

from __future__ import annotations

from msgspec import Struct

from situ.document.change import Change
from situ.document.diff import compare
from situ_studio.edit import Document


class Differing(Struct, frozen=True):
    """One file that is other on disk than it was read here.

    base: what both began with; None where that was given up. theirs: what lies on disk; None
    where it is gone, or has errors: unread says the first. both: the changes of both, where they
    do not collide.
    """

    file: str
    mine: Document
    base: Document | None
    theirs: Document | None
    both: Document | None = None
    gone: bool = False
    unread: str = ""

    @property
    def my_changes(self) -> list[Change]:
        """What was changed here; against what lies on disk where the beginning was given up."""
        before = self.base if self.base is not None else self.theirs
        return compare(before, self.mine, self.file) if before is not None else []

    @property
    def their_changes(self) -> list[Change]:
        """What the other program changed; nothing where the beginning was given up."""
        if self.base is None or self.theirs is None:
            return []
        return compare(self.base, self.theirs, self.file)
