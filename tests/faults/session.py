"""Whether a client was heard of all the time."""

from __future__ import annotations

from situ.blackboard.client import AsyncBoard


class Session:
    """A client's session, from now to ``end``.

    On a machine with much else to do a test's own process may stand still for longer than the
    lease: then it is itself the one that stalled, and has lost what was told meanwhile.
    """

    def __init__(self, board: AsyncBoard) -> None:
        self._board = board
        self._first = self._now()
        self.stayed = False

    def end(self) -> None:
        self.stayed = self._now() == self._first

    def _now(self) -> str:
        welcome = self._board.link.dialog.welcome
        assert welcome is not None
        return welcome.session
