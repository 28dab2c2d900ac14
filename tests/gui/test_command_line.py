"""``python -m situ_studio``: screenshots and wrong usage."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import QEvent
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication

from situ_studio import main
from situ_studio.looks import theme

Copy = Callable[[str], Path]


def run(*arguments: str | Path, bare: bool = False) -> subprocess.CompletedProcess[str]:
    """bare: without a display, and without the platform that the tests choose."""
    env = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
    if bare:
        for name in ("QT_QPA_PLATFORM", "DISPLAY", "WAYLAND_DISPLAY"):
            env.pop(name, None)
    return subprocess.run(
        [sys.executable, "-m", "situ_studio", *map(str, arguments)],
        capture_output=True,
        text=True,
        timeout=50,
        env=env,
        check=False,
    )


def here(*arguments: str | Path) -> int:
    """The same in this process: a start of Python costs more than all that is tested."""
    status = main.main([str(a) for a in arguments])
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    return status


def test_a_screenshot_has_the_size_and_colours_asked_for(
    qt: QApplication, project: Copy, tmp_path: Path
) -> None:
    out = tmp_path / "dark.png"
    size = ("--size", "1280x800", "--theme", "dark")
    assert here(project("reception"), "--screenshot", out, *size) == 0
    picture = QImage(str(out))
    assert (picture.width(), picture.height()) == (1280, 800)
    # The status bar, at its very left, is panel.
    assert picture.pixelColor(2, 795).name().upper() == theme.DARK.panel


def test_a_screenshot_shows_the_view_that_is_named(
    qt: QApplication, project: Copy, tmp_path: Path
) -> None:
    graph, outline, both = (tmp_path / f"{n}.png" for n in ("graph", "outline", "both"))
    folder = project("conversation")
    views = {"conversation": graph, "outline:conversation": outline, "both:conversation": both}
    for view, out in views.items():
        assert here(folder, "--screenshot", out, "--size", "900x600", "--view", view) == 0
    pictures = [QImage(str(out)) for out in (graph, outline, both)]
    assert pictures[0] != pictures[1] != pictures[2] != pictures[0]


def test_a_screenshot_needs_no_display(project: Copy, tmp_path: Path) -> None:
    out = tmp_path / "there.png"
    done = run(project("conversation"), "--screenshot", out, bare=True)
    assert (done.returncode, done.stderr) == (0, "")
    assert not QImage(str(out)).isNull()


def test_a_window_without_a_display_is_refused_in_one_line(project: Copy) -> None:
    done = run(project("conversation"), bare=True)
    assert done.returncode == 2
    assert done.stderr.count("\n") == 1
    assert "DISPLAY" in done.stderr


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["nowhere"], "nowhere"),
        (["--size", "big"], "is no size"),
        (["--view", "reception"], "no view"),
        (["--colour", "red"], "unrecognized"),
    ],
)
def test_wrong_usage_is_one_line_and_status_2(
    qt: QApplication,
    capsys: pytest.CaptureFixture[str],
    arguments: list[str],
    words: str,
    tmp_path: Path,
) -> None:
    assert here(*arguments, "--screenshot", tmp_path / "no.png") == 2
    said = capsys.readouterr().err
    assert words in said.strip().splitlines()[-1]
    assert "Traceback" not in said
    assert not (tmp_path / "no.png").exists()
