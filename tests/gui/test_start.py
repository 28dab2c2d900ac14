"""The start: quick, and sharp on every screen."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QApplication

from situ_studio.looks import icons

Start = Callable[..., Any]
Copy = Callable[[str], Path]

NOT_AT_THE_START = {"asyncio", "http.client", "setuptools", "ssl", "zmq", "PySide6.QtNetwork"}
"""What takes long to import, and what nobody needs who opens a project and draws."""

OPEN = """
import sys
from PySide6.QtCore import QSettings
from situ_studio import main
from situ_studio.looks.application import application

qt = application()
window = main.create_window(sys.argv[1], QSettings(sys.argv[2], QSettings.Format.IniFormat))
window.show()
main.settle(window)
assert window.current_view.canvas is not None
print(*sorted(set(sys.modules) & set(sys.argv[3:])))
"""


def test_opening_an_example_imports_nothing_that_only_a_robot_needs(
    project: Copy, tmp_path: Path
) -> None:
    opened = subprocess.run(
        [sys.executable, "-c", OPEN, project("reception"), tmp_path / "s.ini", *NOT_AT_THE_START],
        env={**os.environ, "QT_QPA_PLATFORM": "offscreen"},
        check=True,
        capture_output=True,
        text=True,
    )
    assert opened.stdout.split() == []


BESIDE = """
import sys
from importlib import import_module
from pathlib import Path
import situ_studio
root = Path(situ_studio.__file__).parent
beside = [*root.rglob("*_process.py")]
for file in beside:
    import_module(".".join(("situ_studio", *file.relative_to(root).with_suffix("").parts)))
WINDOWS = ("situ_studio.main", "situ_studio.window", "situ_studio.commands")
print(len(beside), *(name for name in sys.modules if name.startswith(WINDOWS)))
"""


def test_no_process_beside_the_studio_imports_its_windows() -> None:
    began = subprocess.run(
        [sys.executable, "-c", BESIDE],
        env={**os.environ, "QT_QPA_PLATFORM": "offscreen"},
        check=True,
        capture_output=True,
        text=True,
    )
    many, *windows = began.stdout.split()
    assert int(many) > 5
    assert windows == []


def test_on_a_screen_with_another_ratio_icons_are_made_anew(
    studio: Start, monkeypatch: pytest.MonkeyPatch
) -> None:
    used = studio()
    action = used.window.actions_.actions["save"]
    assert action.icon().pixmap(QSize(18, 18), 1.5).devicePixelRatio() == 1.0
    monkeypatch.setattr(icons, "scales", lambda: [1.0, 1.5])
    QApplication.sendEvent(used.window, QEvent(QEvent.Type.DevicePixelRatioChange))
    sharp = action.icon().pixmap(QSize(18, 18), 1.5)
    assert (sharp.devicePixelRatio(), sharp.size()) == (1.5, QSize(27, 27))


def test_the_colours_follow_the_system_while_the_studio_runs(studio: Start) -> None:
    used = studio(theme="system")
    # The offscreen platform has no colours of its own: it is told of them as Qt tells it.
    changed = QGuiApplication.styleHints().colorSchemeChanged
    seen = []
    for scheme in (Qt.ColorScheme.Dark, Qt.ColorScheme.Light):
        changed.emit(scheme)
        used.settle()
        seen.append((used.window.theme.name, used.window.palette().window().color().name()))
    assert seen == [("dark", "#1b1f27"), ("light", "#ffffff")]
    used.window.choose_theme("light")
    changed.emit(Qt.ColorScheme.Dark)
    assert used.window.theme.name == "light"
