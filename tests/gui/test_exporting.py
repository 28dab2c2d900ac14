"""What a window exports and prints: the drawing or a part of it, and pages that fit together."""

from __future__ import annotations

import itertools
import pickle
import re
import sys
from collections.abc import Callable, Iterator
from datetime import datetime
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PySide6.QtCore import QEvent, QMarginsF, QRectF, QSizeF, Qt, QTimer
from PySide6.QtGui import QImage, QPageLayout, QPageSize
from PySide6.QtPrintSupport import QPrinter, QPrintPreviewDialog, QPrintPreviewWidget
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtTest import QSignalSpy, QTest
from PySide6.QtWidgets import QApplication

from situ.document import folder
from situ.resources import example
from situ_studio.export import exporting, picture, printing
from situ_studio.export.chosen_printer import chosen
from situ_studio.export.export_dialog import ExportDialog, What
from situ_studio.export.large_export import Drawing, LargeExport
from situ_studio.looks import letters
from situ_studio.window.dialogs import Dialogs

Start = Callable[..., Any]
Copy = Callable[[str], Path]
PATIENCE = 20_000
CONTROL = Qt.KeyboardModifier.ControlModifier
AREAS: dict[What, QRectF] = {"whole": QRectF(0, 0, 400, 300), "seen": QRectF(0, 0, 100, 50)}


def export(used: Any, out: Path, what: str, scale: float = 1.0) -> None:
    """As somebody who finds the command by its name."""
    used.answers.put("picture_file", str(out))
    used.answers.put("export", (what, scale))
    used.key(Qt.Key.Key_K, CONTROL)
    used.type("Export picture")
    used.key(Qt.Key.Key_Return)


def test_the_whole_drawing_goes_into_the_file_in_the_format_of_its_name(
    studio: Start, project: Copy, tmp_path: Path
) -> None:
    used = studio(project("reception"))
    for ending in picture.FORMATS:
        export(used, tmp_path / f"a.{ending}", "whole")
    assert used.answers.told == []
    svg = QSvgRenderer(str(tmp_path / "a.svg"))
    assert svg.isValid()
    apart = QImage(str(tmp_path / "a.png")).size() - svg.viewBox().size()
    assert max(abs(apart.width()), abs(apart.height())) <= 1
    assert (tmp_path / "a.pdf").read_bytes().startswith(b"%PDF")
    assert "a.png is written" in used.window.status.said.text()


def test_the_selection_or_what_is_seen_is_exported_alone(
    studio: Start, project: Copy, tmp_path: Path
) -> None:
    used = studio(project("reception"))
    used.window.select_all((("state", "2"), ("state", "3")))
    used.window.current_view.canvas.set_zoom(2.0)
    used.settle()
    sizes = {}
    for what in ("whole", "selection", "seen"):
        export(used, tmp_path / f"{what}.png", what)
        sizes[what] = QImage(str(tmp_path / f"{what}.png")).size()
    assert used.answers.told == []
    for what in ("selection", "seen"):
        assert sizes[what].width() * sizes[what].height() * 2 < (
            sizes["whole"].width() * sizes["whole"].height()
        )
    assert sizes["selection"] != sizes["seen"]


def test_a_picture_is_of_the_size_asked_for(studio: Start, project: Copy, tmp_path: Path) -> None:
    used = studio(project("reception"))
    for scale in (1.0, 2.0):
        export(used, tmp_path / f"{scale}.png", "whole", scale)
    one, two = (QImage(str(tmp_path / f"{s}.png")) for s in (1.0, 2.0))
    assert abs(two.width() - 2 * one.width()) <= 1


def test_from_the_outline_the_drawing_is_exported_too(
    studio: Start, project: Copy, tmp_path: Path
) -> None:
    used = studio(project("reception"))
    used.window.show_mode("outline")
    export(used, tmp_path / "a.svg", "whole")
    assert QSvgRenderer(str(tmp_path / "a.svg")).isValid()


def test_what_can_not_be_written_is_told_in_one_line(
    studio: Start, project: Copy, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    used = studio(project("reception"))
    export(used, tmp_path / "none" / "a.png", "whole")
    export(used, tmp_path / "a.gif", "whole")
    monkeypatch.setattr(exporting, "MOST_CARDS", 3)
    used.answers.put("printer", tmp_path / "none" / "a.pdf")
    used.window.exporting.print_()
    unprinted = QSignalSpy(used.window.exporting._large.refused)
    assert unprinted.count() or unprinted.wait(PATIENCE)
    used.answers.put("picture_file", str(tmp_path / "none" / "b.png"))
    used.window.exporting.export()
    refused = QSignalSpy(used.window.exporting._large.refused)
    assert refused.count() or refused.wait(PATIENCE)
    told = ("cannot be written", ".svg, .pdf or .png", "can not be printed", "can not be drawn")
    assert len(used.answers.told) == len(told)
    for text, said in zip(told, used.answers.told, strict=True):
        assert text in said
        assert "\n" not in said
    assert list(tmp_path.glob("a.*")) == []


@pytest.fixture
def fill_disk() -> Iterator[Callable[[], None]]:
    """From its call on no file gets more than 2 kB."""
    resource = pytest.importorskip("resource")
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    yield lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (2048, before[1]))
    resource.setrlimit(resource.RLIMIT_FSIZE, before)


def test_on_a_full_disk_it_is_told_so_and_the_picture_that_was_there_stays(
    studio: Start,
    project: Copy,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    fill_disk: Callable[[], None],
) -> None:
    used = studio(project("reception"))
    kinds = ("svg", "pdf", "png")
    for kind in kinds:
        (tmp_path / f"a.{kind}").write_text("before")
    paper = tmp_path / "paper.pdf"
    paper.write_text("before")
    fill_disk()
    for kind in kinds:
        export(used, tmp_path / f"a.{kind}", "whole")
    assert len(used.answers.told) == 3
    used.answers.put("preview", tmp_path / "here.pdf")
    used.key(Qt.Key.Key_P, CONTROL)
    assert "here.pdf can not be printed" in used.answers.told[-1]
    monkeypatch.setattr(exporting, "MOST_CARDS", 3)
    refused = QSignalSpy(used.window.exporting._large.refused)
    used.answers.put("printer", paper)
    used.key(Qt.Key.Key_P, CONTROL)
    assert refused.count() or refused.wait(PATIENCE)
    assert "paper.pdf can not be printed" in used.answers.told[-1]
    assert len(used.answers.told) == 5
    kept = [*(f"a.{kind}" for kind in kinds), "paper.pdf"]
    assert {(tmp_path / name).read_text() for name in kept} == {"before"}
    left = {file.name for file in tmp_path.iterdir() if file.is_file()}
    assert left - {*kept, "here.pdf", "settings.ini", "settings.ini.lock"} == set()


def test_a_large_drawing_is_drawn_by_another_process_and_can_be_cancelled(
    studio: Start, project: Copy, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(exporting, "MOST_CARDS", 3)
    used = studio(project("reception"))
    out = tmp_path / "a.svg"

    def begin() -> Any:
        used.answers.put("picture_file", str(out))
        used.key(Qt.Key.Key_K, CONTROL)
        used.type("Export picture")
        used.key(Qt.Key.Key_Return)
        (work,) = used.window.status.work.going
        return work

    begin().cancel()
    assert used.window.status.work.going == []
    assert not out.exists()
    # What is not saved yet is drawn too.
    used.select("state", "7")
    used.key(Qt.Key.Key_Delete)
    work = begin()
    ended = QSignalSpy(work.ended)
    assert ended.count() or ended.wait(PATIENCE)
    assert used.answers.told == []
    assert "a.svg is written" in used.window.status.said.text()
    alone = tmp_path / "alone.svg"
    monkeypatch.setattr(exporting, "MOST_CARDS", 1000)
    export(used, alone, "whole")
    sizes = [QSvgRenderer(str(file)).viewBox().size() for file in (out, alone)]
    assert sizes[0] == sizes[1]


@pytest.mark.parametrize(
    ("program", "why"),
    [
        ("import sys; sys.exit(3)", "its process ended early"),
        ("import sys; sys.exit('one line\\nthe last line')", "the last line"),
    ],
)
def test_of_a_process_that_ends_it_is_told_why_each_time(
    qt: QApplication, tmp_path: Path, program: str, why: str
) -> None:
    project, _ = folder.load(example("reception"))
    assert project is not None
    document = next(iter(project.applications.values()))
    large = LargeExport(qt, command=(sys.executable, "-c", program))
    refused = QSignalSpy(large.refused)
    for count in (1, 2):
        large.start(Drawing(document, str(tmp_path / "a.svg"), "a"))
        assert refused.count() == count or refused.wait(PATIENCE)
        assert refused.at(count - 1) == [f"{tmp_path / 'a.svg'} can not be drawn: {why}"]
    large.deleteLater()


def test_a_document_without_a_graph_is_neither_exported_nor_printed(
    studio: Start, project: Copy
) -> None:
    used = studio(project("conversation"))
    actions = used.window.actions_.actions
    assert actions["export"].isEnabled()
    used.window.open_file(used.session.project.modules_file)
    used.settle()
    assert not actions["export"].isEnabled()
    assert not actions["print"].isEnabled()


def test_the_question_says_how_large_a_png_becomes_and_refuses_too_large_ones(
    studio: Start,
) -> None:
    used = studio()
    dialog = ExportDialog("a.png", AREAS, used.window)
    dialog.show()
    dialog.activateWindow()
    QApplication.processEvents()
    assert dialog.size_.text() == "800 × 600 px"
    words = dialog.what.fontMetrics().horizontalAdvance(dialog.what.currentText())
    assert words + 9 + 22 <= dialog.what.width()
    assert dialog.scale.height() == dialog.what.height()
    QTest.keyClick(dialog.what, Qt.Key.Key_Down)
    for _ in range(4):
        QTest.keyClick(dialog.scale, Qt.Key.Key_Up)
    assert dialog.size_.text() == "300 × 150 px"
    QTest.keyClick(dialog.what, Qt.Key.Key_Return)
    assert dialog.result() == ExportDialog.DialogCode.Accepted
    assert (dialog.chosen.what, dialog.chosen.scale) == ("seen", 3.0)
    dialog.deleteLater()
    large = ExportDialog("a.png", {"whole": QRectF(0, 0, 30000, 30000)}, used.window)
    assert not large.export.isEnabled()
    assert "too large" in large.size_.text()
    large.deleteLater()
    lines = ExportDialog("a.svg", AREAS, used.window)
    assert not lines.isAncestorOf(lines.scale)
    lines.deleteLater()


# -- on paper --------------------------------------------------------------------------------


def pages_of(pdf: Path) -> int:
    return pdf.read_bytes().count(b"/Type /Page\n")


def boxes_of(pdf: Path) -> list[bytes]:
    """How large its pages are."""
    return re.findall(rb"/MediaBox \[[^]]*\]", pdf.read_bytes())


def test_ctrl_p_prints_the_drawing_in_lines(studio: Start, project: Copy, tmp_path: Path) -> None:
    used, out = studio(project("reception")), tmp_path / "paper.pdf"
    used.answers.put("preview", out)
    used.key(Qt.Key.Key_P, CONTROL)
    found = out.read_bytes()
    assert pages_of(out) >= 1
    assert b"Inter-Medium" in found
    assert b"/Subtype /Image" not in found
    assert used.answers.told == []


def test_a_large_drawing_is_printed_by_another_process_as_the_window_would(
    studio: Start, project: Copy, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    used, out, alone = studio(project("reception")), tmp_path / "a.pdf", tmp_path / "alone.pdf"
    used.answers.put("preview", alone)
    used.key(Qt.Key.Key_P, CONTROL)
    monkeypatch.setattr(exporting, "MOST_CARDS", 3)

    def begin() -> list[Any]:
        used.key(Qt.Key.Key_P, CONTROL)
        return list(used.window.status.work.going)

    used.answers.put("printer", None)
    assert begin() == []
    out.write_text("what was there before")
    used.answers.put("printer", out)
    (work,) = begin()
    work.cancel()
    assert used.window.status.work.going == []
    assert [file.name for file in tmp_path.glob("a.pdf*")] == ["a.pdf"]
    assert out.read_text() == "what was there before"
    used.answers.put("printer", out)
    (work,) = begin()
    assert "reception" in work.words
    ended = QSignalSpy(work.ended)
    assert ended.count() or ended.wait(PATIENCE)
    assert used.answers.told == []
    assert "is printed" in used.window.status.said.text()
    assert not Path(f"{out}.part").exists()
    assert pages_of(out) == pages_of(alone) >= 1
    assert boxes_of(out) == boxes_of(alone)
    assert b"Inter-Medium" in out.read_bytes()


def test_printing_goes_on_where_its_window_is_made_anew_for_other_letters(
    studio: Start, project: Copy, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    used, out = studio(project("reception")), tmp_path / "a.pdf"
    windows, old = used.window.windows, used.window
    monkeypatch.setattr(exporting, "MOST_CARDS", 3)
    used.answers.put("printer", out)
    used.key(Qt.Key.Key_P, CONTROL)
    windows.choose_letters("125")
    try:
        while old in windows.windows:
            QApplication.processEvents()
        (window,) = windows.windows
        assert old.status.work.going == []
        # On a busy machine it may be done by now.
        for work in window.status.work.going:
            assert work.words == "Printing reception"
            assert QSignalSpy(work.ended).wait(PATIENCE)
        assert "is printed" in window.status.said.text()
        assert pages_of(out) >= 1
    finally:
        letters.use(100)


def test_of_what_is_printed_while_the_window_is_closed_nothing_is_left(
    studio: Start, project: Copy, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    used, out = studio(project("reception")), tmp_path / "a.pdf"
    monkeypatch.setattr(exporting, "MOST_CARDS", 3)
    used.answers.put("printer", out)
    used.key(Qt.Key.Key_P, CONTROL)
    assert len(used.window.status.work.going) == 1
    begun = Path(f"{out}.part")
    begun.write_text("half")
    used.window.close()
    assert not begun.exists()
    assert not out.exists()


def test_a_printer_is_set_up_elsewhere_as_it_was_chosen(qt: QApplication) -> None:
    printer = QPrinter(QPrinter.PrinterMode.HighResolution)
    printer.setOutputFormat(QPrinter.OutputFormat.PdfFormat)
    printer.setOutputFileName("a.pdf")
    printer.setPageSize(QPageSize(QPageSize.PageSizeId.A3))
    printer.setPageOrientation(QPageLayout.Orientation.Landscape)
    printer.setPageMargins(QMarginsF(20, 30, 40, 50), QPageLayout.Unit.Point)
    printer.setCopyCount(3)
    printer.setColorMode(QPrinter.ColorMode.GrayScale)
    found = pickle.loads(pickle.dumps(chosen(printer)))
    assert found.printer("b.pdf").outputFileName() == "b.pdf"
    assert chosen(found.printer("a.pdf")) == found
    assert found.printer("").pageLayout().pageSize().id() == QPageSize.PageSizeId.A3


@settings(deadline=None)
@given(
    st.floats(-5000, 5000),
    st.floats(50, 20000),
    st.floats(50, 20000),
    st.floats(300, 2000),
    st.floats(300, 2000),
    st.floats(0, 100),
)
def test_pages_cover_a_drawing_and_share_a_strip(
    at: float, wide: float, high: float, width: float, height: float, overlap: float
) -> None:
    area, page = QRectF(at, -at, wide, high), QSizeF(width, height)
    rows = printing.parts(area, page, overlap)
    whole = QRectF(rows[0][0].topLeft(), rows[-1][-1].bottomRight())
    assert whole.adjusted(-0.01, -0.01, 0.01, 0.01).contains(area)
    assert {p.size().width() for row in rows for p in row} == {width}
    for row in rows:
        for one, next_ in itertools.pairwise(row):
            assert one.right() - next_.left() == pytest.approx(overlap, abs=0.01)
    for upper, lower in itertools.pairwise(rows):
        assert upper[0].bottom() - lower[0].top() == pytest.approx(overlap, abs=0.01)
    # None too many: with one less it would not fit.
    for count, length, room in ((len(rows[0]), wide, width), (len(rows), high, height)):
        assert count == 1 or (count - 1) * (room - overlap) + overlap < length + 0.01


def test_a_drawing_is_on_one_page_where_it_stays_legible() -> None:
    page = QSizeF(700, 1000)
    assert printing.scale_for(QRectF(0, 0, 300, 300), page) == 1.0
    assert printing.scale_for(QRectF(0, 0, 1000, 300), page) == pytest.approx(0.7)
    assert printing.scale_for(QRectF(0, 0, 9000, 300), page) == printing.SMALLEST


def test_pages_are_wide_for_a_wide_drawing_and_each_has_its_foot(
    qt: QApplication, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    project, _ = folder.load(example("reception"))
    assert project is not None
    drawn = picture.paper(next(iter(project.applications.values())))
    feet: list[tuple[str, str, str]] = []
    paint_foot = printing._paint_foot

    def watched(painter: Any, foot: QRectF, title: str, where: str, date: str) -> None:
        feet.append((title, where, date))
        paint_foot(painter, foot, title, where, date)

    monkeypatch.setattr(printing, "_paint_foot", watched)
    printer, out = QPrinter(QPrinter.PrinterMode.HighResolution), tmp_path / "a.pdf"
    printer.setOutputFormat(QPrinter.OutputFormat.PdfFormat)
    printer.setOutputFileName(str(out))
    printing.lay(printer, QRectF(0, 0, 200, 100))
    assert printer.pageLayout().orientation() == QPageLayout.Orientation.Landscape
    printing.lay(printer, QRectF(0, 0, 100, 200))
    assert printer.pageLayout().orientation() == QPageLayout.Orientation.Portrait
    drawn.area = drawn.area.adjusted(0, 0, 2000, 0)
    count = printing.print_paper(printer, drawn, "the title", datetime(2026, 3, 4))
    assert count == pages_of(out) == len(feet) > 1
    assert feet[0][:2] == ("the title", "row 1, column 1")
    assert len({where for _, where, _ in feet}) == count
    assert all("4" in date for _, _, date in feet)
    drawn.close()
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


def test_the_preview_shows_what_will_be_printed(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.window.dialogs = Dialogs(used.window)
    seen: list[int] = []

    def look() -> None:
        dialog = QApplication.activeModalWidget()
        assert isinstance(dialog, QPrintPreviewDialog)
        (shown,) = dialog.findChildren(QPrintPreviewWidget)
        seen.append(shown.pageCount())
        dialog.reject()

    QTimer.singleShot(0, look)
    used.key(Qt.Key.Key_P, CONTROL)
    assert len(seen) == 1
    assert seen[0] >= 1
