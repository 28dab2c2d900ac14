"""A window's drawing outside of it: as a picture in a file, and on paper."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QRectF, Qt
from PySide6.QtPrintSupport import QPrinter
from PySide6.QtWidgets import QApplication

from situ.document.rbd import Application
from situ.document.spds import Spds
from situ_studio.export import picture, printing
from situ_studio.export.chosen_printer import chosen
from situ_studio.export.export_dialog import What
from situ_studio.export.large_export import Drawing, LargeExport, Printing
from situ_studio.panels.project_tree import stem
from situ_studio.processes.working import Work

if TYPE_CHECKING:
    from situ_studio.canvas.paper import Paper
    from situ_studio.window.main_window import MainWindow

MOST_CARDS = 1000
"""Of a drawing that is put on paper while the window waits; another process draws larger ones."""


class ExportingSide(QObject):
    """Exports and prints the document that the window shows.

    now: gives the date that is printed.
    """

    def __init__(self, window: MainWindow, now: Callable[[], datetime] = datetime.now) -> None:
        super().__init__(window)
        self._window = window
        self._now = now
        self._folder: Path | None = None
        self._work: Work | None = None
        self._hear(LargeExport(self))
        window.closed.connect(self._give_up)

    def _hear(self, large: LargeExport) -> None:
        self._large = large
        large.written.connect(self._on_written)
        large.refused.connect(self._on_refused)

    def export(self) -> None:
        """Asks for a file and what shall be in it, and writes it. UsageError where it can not."""
        window, file = self._window, self._window.current_file
        if file is None:
            return
        home = self._folder or window.session.root.parent
        name = window.dialogs.picture_file(str(home / f"{stem(file)}.svg"))
        if name is None:
            return
        picture.format_of(name)
        document = window.current_document
        if document is not None and _cards(document) > MOST_CARDS:
            self._begin(Drawing(document, name, stem(file)))
            return
        with self._drawn() as whole:
            areas = self._areas(whole)
            chosen = window.dialogs.export(Path(name).name, areas)
            if chosen is None:
                return
            if chosen.what == "selection":
                with self._drawn(selected=True) as drawn:
                    self._write(drawn, name, drawn.area, chosen.scale)
            else:
                self._write(whole, name, areas[chosen.what], chosen.scale)
        self._folder = Path(name).parent
        window.say(self.tr("{0} is written.").format(name))

    def _begin(self, wanted: Drawing | Printing) -> None:
        """The whole drawing, by another process; the window stays in use."""
        self._show_work(wanted)
        self._large.start(wanted)

    def _show_work(self, wanted: Drawing | Printing) -> None:
        self._end_work()
        if isinstance(wanted, Printing):
            words = self.tr("Printing {0}").format(wanted.printer.title)
        else:
            words = self.tr("Drawing {0}").format(Path(wanted.out).name)
        self._work = self._window.status.work.begin(words, self._give_up)

    def move_to(self, other: ExportingSide) -> None:
        """What is drawn or printed goes on for a window that stands in place of this one."""
        wanted, large = self._large.wanted, self._large
        if wanted is not None:
            self._end_work()
            large.written.disconnect(self._on_written)
            large.refused.disconnect(self._on_refused)
            large.setParent(other)
            other._hear(large)
            other._show_work(wanted)

    def _give_up(self) -> None:
        # The work ends itself.
        self._work = None
        self._large.cancel()

    def _on_written(self, done: Drawing | Printing) -> None:
        self._end_work()
        if isinstance(done, Printing):
            self._window.say(self.tr("{0} is printed.").format(done.title))
            return
        self._folder = Path(done.out).parent
        self._window.say(self.tr("{0} is written.").format(done.out))

    def _on_refused(self, why: str) -> None:
        self._end_work()
        self._window.dialogs.tell(why)

    def _end_work(self) -> None:
        work, self._work = self._work, None
        if work is not None:
            work.end()

    def print_(self) -> None:
        """Shows the drawing as it comes on paper, to be printed from there; one that is too large
        for that is printed beside the window once a printer is chosen."""
        file, project = self._window.current_file, self._window.session.project
        document, view = self._window.current_document, self._window.current_view
        if file is None or project is None or document is None or view is None:
            return
        title = self.tr("{0} — {1}").format(stem(file), project.name)
        printer = QPrinter(QPrinter.PrinterMode.HighResolution)
        printer.setDocName(stem(file))
        if _cards(document) > MOST_CARDS:
            printing.lay(printer, view.canvas.extent())
            if self._window.dialogs.printer(printer):
                self._begin(Printing(document, title, self._now(), chosen(printer)))
            return
        with self._drawn() as drawn:
            printing.lay(printer, drawn.area)
            at, pages = self._now(), 0

            def paint(onto: QPrinter) -> None:
                nonlocal pages
                pages = printing.print_paper(onto, drawn, title, at)

            printed = self._window.dialogs.preview(printer, paint)
            why = printing.refused(printer, pages) if printed else ""
            if why:
                out = printer.outputFileName() or printer.printerName()
                self._window.dialogs.tell(self.tr("{0} can not be printed: {1}").format(out, why))

    @contextmanager
    def _drawn(self, selected: bool = False) -> Iterator[Paper]:
        """The current document on paper, or what is selected of it."""
        view, document = self._window.current_view, self._window.current_document
        assert view is not None
        assert document is not None
        with _waiting():
            only = view.selected if selected else None
            drawn = picture.paper(document, view.canvas, only)
        try:
            yield drawn
        finally:
            drawn.close()

    def _areas(self, whole: Paper) -> dict[What, QRectF]:
        """What of the drawing can be exported, and where in the scene that is."""
        view = self._window.current_view
        assert view is not None
        areas: dict[What, QRectF] = {"whole": whole.area}
        chosen = whole.area_of(view.selected)
        if not chosen.isEmpty():
            areas["selection"] = chosen
        seen = view.canvas.viewer.seen() if view.mode == "graph" else QRectF()
        if not (seen & whole.area).isEmpty():
            areas["seen"] = seen & whole.area
        return areas

    def _write(self, drawn: Paper, name: str, part: QRectF, scale: float) -> None:
        with _waiting():
            picture.write(drawn, name, Path(name).stem, part, scale)


def _cards(document: object) -> int:
    """How many cards the graph of a document has, nearly."""
    if isinstance(document, Application):
        return len(document.states)
    return len(document.situations) if isinstance(document, Spds) else 0


@contextmanager
def _waiting() -> Iterator[None]:
    """The pointer says that the window is at work."""
    QApplication.setOverrideCursor(Qt.CursorShape.WaitCursor)
    try:
        yield
    finally:
        QApplication.restoreOverrideCursor()
