"""Pictures of graphs: SVG and PDF in lines with no px in them, PNG in the size asked for."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QImage, QPainter
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import QApplication

from situ.document import folder
from situ.resources import example
from situ_studio import main
from situ_studio.export import picture

IGNORE = Qt.AspectRatioMode.IgnoreAspectRatio
SMOOTH = Qt.TransformationMode.SmoothTransformation


def here(*arguments: str | Path) -> int:
    status = main.main([str(a) for a in arguments])
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    return status


@pytest.mark.parametrize("name", ["converse", "conversation"])
def test_an_svg_shows_what_the_png_shows_with_texts_as_outlines(
    qt: QApplication, tmp_path: Path, name: str, farthest: Callable[[QImage, QImage], int]
) -> None:
    lines, pixels = tmp_path / "a.svg", tmp_path / "a.png"
    for out in (lines, pixels):
        project = example("conversation")
        assert here(project, "--picture", out, "--document", name) == 0
    text = lines.read_text("utf-8")
    assert "<text" not in text
    assert "<image" not in text
    shown = QImage(str(pixels))
    drawn = QImage(shown.size(), QImage.Format.Format_RGB32)
    drawn.fill(Qt.GlobalColor.white)
    painter = QPainter(drawn)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    QSvgRenderer(str(lines)).render(painter)
    painter.end()
    # Letters have other edges as outlines; made small, all is the same.
    small = [
        i.scaled(128, 96, Qt.AspectRatioMode.IgnoreAspectRatio, SMOOTH) for i in (shown, drawn)
    ]
    assert farthest(*small) < 40


def test_a_pdf_has_its_typefaces_and_no_pictures(qt: QApplication, tmp_path: Path) -> None:
    out = tmp_path / "a.pdf"
    assert here(example("reception"), "--picture", out) == 0
    found = out.read_bytes()
    assert b"Inter-Medium" in found
    assert b"/FontFile2" in found
    assert b"/Subtype /Image" not in found


def test_of_a_selection_there_is_only_what_is_selected(qt: QApplication) -> None:
    project, _ = folder.load(example("reception"))
    assert project is not None
    document = next(iter(project.applications.values()))
    whole = picture.paper(document)
    part = picture.paper(document, only=[("state", "2"), ("state", "3")])
    assert whole.area.contains(part.area)
    assert part.area.height() < whole.area.height() / 2
    whole.close()
    part.close()


def test_a_picture_that_can_not_be_written_is_told_in_one_line(
    qt: QApplication, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for arguments, said in (
        (("--picture", tmp_path / "a.gif"), ".svg, .pdf or .png"),
        (("--picture", tmp_path / "a.png", "--document", "nobody"), "there are: reception"),
        (("--picture", tmp_path / "none" / "a.png"), "cannot be written"),
    ):
        assert here(example("reception"), *arguments) == 2
        told = capsys.readouterr().err
        assert said in told
        assert told.count("\n") == 1
