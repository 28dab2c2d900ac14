"""One edit in the whole window, and the automatic layout."""

from __future__ import annotations

import contextlib
import tempfile
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

from tests.benchmarks import documents
from tests.benchmarks.drawing import qt
from tests.benchmarks.harness import CPU, Bench, Goal, Row, Sample, each, library

SIZES = (100, 5_000)
EDITS = ("move", "connect", "rename", "undo", "drag")
LAYOUTS = (300, 1_000)
FRAME = 16.0

PROJECT = '[project]\nname = "bench"\napplications = ["dialogue.rbd.xml"]\n'


@contextlib.contextmanager
def _edits() -> Iterator[Mapping[str, Sample]]:
    """From the edit's value to the painted frame: canvas, outline, status, form and title."""
    samples: dict[str, Sample] = {}
    with qt() as app, contextlib.ExitStack() as opened:
        for size in SIZES:
            window = opened.enter_context(_window(size, app))
            for name, work in _works(window).items():
                samples[f"{name}, {size:,} states"] = _edit(window, work, app)
        yield samples


@contextlib.contextmanager
def _window(size: int, app: Any) -> Iterator[Any]:
    """A window with a project of one application, all of it shown, at 100 %."""
    from PySide6.QtCore import QSettings

    from situ_studio.project.session import Session
    from situ_studio.window.main_window import MainWindow

    with tempfile.TemporaryDirectory(prefix="situ-bench-") as folder:
        root = Path(folder)
        (root / "situ.toml").write_text(PROJECT)
        (root / "dialogue.rbd.xml").write_bytes(documents.dialogue(size))
        settings = QSettings(f"{folder}/settings.ini", QSettings.Format.IniFormat)
        window: Any = MainWindow(Session(), settings, list)
        window.resize(1_280, 800)
        window.show()
        window.open_project(root)
        canvas = window.current_view.canvas
        while canvas.filling.is_filling or canvas._piping.is_routing():
            app.processEvents()
        # Another process looks for problems: what it is sent would count as this one's time.
        window.session.checker.cancel()
        window.session.checker.ask = lambda project: None
        canvas.set_zoom(1.0)
        app.processEvents()
        yield window
        window.may_leave = lambda: True
        window.close()
        window.deleteLater()


def _works(window: Any) -> dict[str, Callable[[int], None]]:
    """What is done, alternately to and fro so that every time is an edit."""
    from situ_studio.canvas import gestures

    canvas = window.current_view.canvas

    def move(turn: int) -> None:
        to: dict[tuple[str, ...], tuple[float, float]] = {
            ("state", "7"): (240.0 + turn % 2 * 8, 480.0)
        }
        window.commit(*gestures.move(canvas.document, to))

    def connect(turn: int) -> None:
        goal = str(8 + turn % 2)
        window.commit(*gestures.lead(canvas.document, ("state", "7"), "0", goal))

    def rename(turn: int) -> None:
        window.commit(*gestures.rename(canvas.document, "7", f"name {turn % 2}"))

    def undo(turn: int) -> None:
        (window.session.redo if window.session.redo_text else window.session.undo)()

    def drag(turn: int) -> None:
        """One step of a mouse that drags a card: nothing of it is in the document yet."""
        canvas.graph.nodes["7"].view.setPos(240.0 + turn % 2 * 8, 480.0)
        canvas._follow_cards()

    return {"move": move, "connect": connect, "rename": rename, "undo": undo, "drag": drag}


def _edit(window: Any, work: Callable[[int], None], app: Any) -> Sample:
    from PySide6.QtCore import QEvent

    turn = 0

    def several(times: int) -> None:
        nonlocal turn
        for _ in range(times):
            turn += 1
            work(turn)
            window.current_view.canvas.viewer.viewport().repaint()
            # What else of the window has to be painted.
            app.sendPostedEvents(None, QEvent.Type.UpdateRequest)

    one = each(several, CPU, unit=1e-3)

    def sample() -> float:
        took = one()
        # Ways that are still looked for belong to the frames after.
        app.processEvents()
        while window.current_view.canvas._piping.is_routing():
            app.processEvents()
        return took

    return sample


@contextlib.contextmanager
def _layouts() -> Iterator[Mapping[str, Sample]]:
    """fast-sugiyama gets the same graph without circles: these can keep it from ending."""
    from situ.document import codec
    from situ.document.rbd import Application

    with qt():
        from situ_studio.canvas import layout

        from_edges = library("fast_sugiyama").from_edges
        samples: dict[str, Sample] = {}
        for size in LAYOUTS:
            document, _ = codec.read(documents.dialogue(size), "dialogue.rbd.xml")
            assert isinstance(document, Application)
            shape = layout.shape(document)
            place = {uid: index for index, uid in enumerate(shape.heights)}
            edges = [
                (place[uid], place[to])
                for uid, leads in shape.leads.items()
                for to in leads
                if place[uid] < place[to]
            ]

            def ours(times: int, document: Application = document) -> None:
                for _ in range(times):
                    layout.arrange(document)

            def peer(times: int, edges: list[tuple[int, int]] = edges) -> None:
                for _ in range(times):
                    from_edges(edges, ranking_type="up", transpose=False)

            samples[f"arrange {size:,}"] = each(ours, CPU, unit=1.0)
            samples[f"fast-sugiyama, {size:,}"] = each(peer, CPU, unit=1.0)
        yield samples


BENCHES = (
    Bench(
        "edit",
        tuple(
            Row(
                f"editor: {name} at {SIZES[-1]:,} states",
                "edit",
                f"{name}, {SIZES[-1]:,} states",
                f"{name}, {SIZES[0]:,} states",
                "ms",
                Goal(FRAME, of="ours"),
            )
            for name in EDITS
        ),
        _edits,
    ),
    Bench(
        "layout",
        tuple(
            Row(
                f"automatic layout of {size:,} states",
                "layout",
                f"arrange {size:,}",
                f"fast-sugiyama, {size:,}",
                "s",
                Goal(0.5, of="ours") if size == LAYOUTS[0] else Goal(1.0),
            )
            for size in LAYOUTS
        ),
        _layouts,
    ),
)
