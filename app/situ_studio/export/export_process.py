"""Drawing and printing in a process of its own: a document comes in, its file is written.

Started as ``python -m situ_studio.export.export_process`` by ``LargeExport``.
"""

from __future__ import annotations

import os
from collections.abc import Callable

from situ.errors import SituError, UsageError
from situ_studio.export import picture, printing
from situ_studio.export.large_export import Drawing, Printing
from situ_studio.looks.application import application
from situ_studio.processes.answering import answer


def main() -> None:
    # Nothing of it is seen, whatever desktop the studio is on.
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    application()
    answer(_draw)


def _draw(wanted: Drawing | Printing, _: Callable[[], bool]) -> str:
    """Why it could not be written, in one line; "" where it is."""
    try:
        if isinstance(wanted, Printing):
            _print(wanted)
        else:
            picture.draw(wanted.document, wanted.out, wanted.title)
    except (SituError, OSError) as error:
        return str(error)
    return ""


def _print(wanted: Printing) -> None:
    drawn = picture.paper(wanted.document)
    try:
        printer = wanted.printer.printer(wanted.begun)
        why = printing.refused(
            printer, printing.print_paper(printer, drawn, wanted.title, wanted.at)
        )
        if why:
            raise UsageError(why)
    finally:
        drawn.close()
    if wanted.begun:
        os.replace(wanted.begun, wanted.printer.file)


if __name__ == "__main__":
    main()
