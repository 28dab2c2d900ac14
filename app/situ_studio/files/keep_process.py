"""Keeping unsaved changes in a process of its own: documents come in, and are written into a file.

Started as ``python -m situ_studio.files.keep_process`` by ``Recovery``. What was sent whole is
written, also where the studio is gone before.
"""

from __future__ import annotations

from collections.abc import Callable

from situ.errors import SituError
from situ_studio.files import kept
from situ_studio.files.kept import Wanted
from situ_studio.processes.answering import answer


def main() -> None:
    answer(_keep)


def _keep(wanted: Wanted, _: Callable[[], bool]) -> str:
    """Why it could not be kept, in one line; "" where it is."""
    try:
        kept.write(wanted)
    except SituError as error:
        return str(error)
    return ""


if __name__ == "__main__":
    main()
