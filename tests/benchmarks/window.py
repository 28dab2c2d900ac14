"""The studio's start: from nothing to a window that shows an example, beside an empty window.

Each is a process of its own, without a display (offscreen), its modules compiled before, as
those of an installed program are.
"""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping

from tests.benchmarks.harness import Bench, Goal, Missing, Row, Sample

EXAMPLE = "reception"

OURS = f"""
import sys
from PySide6.QtCore import QSettings
from situ.resources import example
from situ_studio import main
from situ_studio.looks.application import application

qt = application()
settings = QSettings(sys.argv[1], QSettings.Format.IniFormat)
window = main.create_window(example({EXAMPLE!r}), settings)
window.show()
main.settle(window)
"""
BESIDE = """
from PySide6.QtWidgets import QApplication, QMainWindow

qt = QApplication([])
window = QMainWindow()
window.resize(1440, 900)
window.show()
qt.processEvents()
"""
# What is measured ends where a person sees the window, not where all of it is taken down.
SHOWN = "\nimport os; print(window.isVisible(), flush=True); os._exit(0)"


@contextlib.contextmanager
def _starts() -> Iterator[Mapping[str, Sample]]:
    try:
        import situ_studio.main  # noqa: F401
    except ImportError:
        raise Missing("the editor is not installed: pip install 'situ[studio]'") from None
    with tempfile.TemporaryDirectory() as kept:
        env = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
        env |= {"QT_QPA_PLATFORM": "offscreen", "PYTHONPYCACHEPREFIX": f"{kept}/compiled"}

        def started(program: str) -> float:
            command = [sys.executable, "-c", program + SHOWN, f"{kept}/settings.ini"]
            began = time.perf_counter()
            subprocess.run(command, env=env, check=True, stdout=subprocess.DEVNULL)
            return time.perf_counter() - began

        yield {
            "studio with an example": lambda: started(OURS),
            "empty PySide6 window": lambda: started(BESIDE),
        }


BENCHES = (
    Bench(
        "start",
        (
            Row(
                "editor: start, with an example open",
                "start",
                "studio with an example",
                "empty PySide6 window",
                "s",
                Goal(1.5, of="ours"),
            ),
        ),
        _starts,
    ),
)
