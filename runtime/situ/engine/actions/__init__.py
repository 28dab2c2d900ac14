"""What carries out actions, one kind a file.

Each is a coroutine that returns when the action has ended well, raises
``ActionFailed`` when it ended badly, and stops at once when it is cancelled.
"""

from __future__ import annotations


class ActionFailed(Exception):
    """An action ended badly; ``str`` is one line in plain words.

    Never leaves the engine: it becomes ``Finish(ok=False, error=…, status=…)``.
    """

    def __init__(self, message: str, status: int | None = None) -> None:
        super().__init__(message)
        self.status = status
