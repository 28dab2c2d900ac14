"""What writers that were killed left in a folder, taken away while the window is used."""

from __future__ import annotations

import threading
from pathlib import Path

from situ.document import folder

NAME = "clearing a folder"
"""What the threads that do it are called."""


def clear(where: Path) -> None:
    """Begins it, and returns at once: a folder may have many others, on a disk that is far away."""
    threading.Thread(target=folder.clear_unfinished, args=(where,), name=NAME, daemon=True).start()
