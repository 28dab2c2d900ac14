"""Drawing pictures in a process of its own: a document comes in, its file is written.

Started as ``python -m situ_studio.export_process`` by ``LargeExport``.
"""

from __future__ import annotations

import os
from collections.abc import Callable

from situ.errors import SituError
from situ_studio import picture
from situ_studio.answering import answer
from situ_studio.large_export import Drawing
from situ_studio.main import application


def main() -> None:
    # Nothing of it is seen, whatever desktop the studio is on.
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    application()
    answer(_draw)


def _draw(wanted: Drawing, _: Callable[[], bool]) -> str:
    """Why it could not be written, in one line; "" where it is."""
    try:
        picture.draw(wanted.document, wanted.out, wanted.title)
    except SituError as error:
        return str(error)
    return ""


if __name__ == "__main__":
    main()
