"""The editor's canvas beside a bare scene of as many rectangles, texts and lines.

Without a display (offscreen), painted by Qt's raster engine as on a screen.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from tests.benchmarks import documents
from tests.benchmarks.harness import CPU, Bench, Goal, Missing, Row, Sample, each

SIZES = (1_000, 5_000)
OPENED = SIZES[0]
WINDOW = (1_100, 760)

BARE = "a bare scene"


def _name(size: int, zoom: str) -> str:
    return f"{size:,} states, zoomed {zoom}"


@contextlib.contextmanager
def _qt() -> Iterator[Any]:
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    try:
        from situ_studio import main
    except ImportError:
        raise Missing("the editor is not installed: pip install 'situ[studio]'") from None
    from PySide6.QtCore import QEvent

    app = main.application()
    yield app
    app.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    app.processEvents()


@contextlib.contextmanager
def _frames() -> Iterator[Mapping[str, Sample]]:
    samples: dict[str, Sample] = {}
    with _qt() as app:
        shown = []
        for size in SIZES:
            canvas = _canvas(documents.dialogue(size))
            view = _bare(canvas)
            shown += [canvas, view]
            app.processEvents()
            for zoom in ("out", "in"):
                samples[_name(size, zoom)] = _frame(canvas, canvas.viewer, zoom)
                samples[f"{BARE}, {_name(size, zoom)}"] = _frame(canvas, view, zoom)
        yield samples
        for widget in shown:
            widget.close()
            widget.deleteLater()


@contextlib.contextmanager
def _opening() -> Iterator[Mapping[str, Sample]]:
    data = documents.dialogue(OPENED)
    with _qt() as app:

        def opened() -> None:
            canvas = _canvas(data)
            canvas.viewer.viewport().repaint()
            _closed(canvas)

        model = _canvas(data)

        def bare() -> None:
            from lxml import etree

            etree.fromstring(data)
            view = _bare(model)
            view.viewport().repaint()
            _closed(view)

        def _closed(widget: Any) -> None:
            widget.close()
            widget.deleteLater()

        yield {"read and shown": _once(opened, app), f"parse, {BARE}": _once(bare, app)}
        _closed(model)


def _once(work: Callable[[], None], app: Any) -> Sample:
    """What was closed is deleted after it was measured."""
    from PySide6.QtCore import QEvent

    def several(times: int) -> None:
        for _ in range(times):
            work()

    one = each(several, CPU, unit=1.0)

    def sample() -> float:
        took = one()
        app.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        app.processEvents()
        return took

    return sample


def _canvas(data: bytes) -> Any:
    """A canvas that shows the application."""
    from situ.document import codec
    from situ.document.rbd import Application
    from situ_studio import theme
    from situ_studio.canvas.application import ApplicationCanvas

    document, problems = codec.read(data, "dialogue.rbd.xml")
    assert isinstance(document, Application)
    assert not problems
    canvas = ApplicationCanvas(theme.LIGHT)
    canvas.resize(*WINDOW)
    canvas.show()
    canvas.show_document(document)
    return canvas


def _bare(canvas: Any) -> Any:
    """A view with a rectangle and a text a card and a line a transition, where the canvas has
    them."""
    from PySide6.QtCore import QLineF
    from PySide6.QtGui import QPainter
    from PySide6.QtWidgets import QGraphicsScene, QGraphicsView

    scene = QGraphicsScene()
    for uid, node in canvas.graph.nodes.items():
        box = node.view.sceneBoundingRect()
        scene.addRect(box)
        scene.addSimpleText(f"question {uid}").setPos(box.topLeft())
    for id in canvas.graph.links:
        pipe = canvas.graph.pipe(id)
        way = pipe.sceneTransform().map(pipe.path())
        scene.addLine(QLineF(way.pointAtPercent(0), way.pointAtPercent(1)))
    view = QGraphicsView(scene)
    scene.setParent(view)
    view.setRenderHint(QPainter.RenderHint.Antialiasing)
    view.resize(*WINDOW)
    view.show()
    return view


def _frame(canvas: Any, view: Any, zoom: str) -> Sample:
    def frames(times: int) -> None:
        for _ in range(times):
            view.viewport().repaint()

    one = each(frames, CPU, unit=1e-3)

    def sample() -> float:
        canvas.zoom_to_fit()
        if zoom == "in":
            canvas.set_zoom(1.0)
        if view is not canvas.viewer:
            view.setTransform(canvas.viewer.transform())
            middle = canvas.viewer.viewport().rect().center()
            view.centerOn(canvas.viewer.mapToScene(middle))
        return one()

    return sample


BENCHES = (
    Bench(
        "frame",
        tuple(
            Row(
                f"editor: frame at {_name(size, zoom)}",
                "frame",
                _name(size, zoom),
                f"{BARE}, {_name(size, zoom)}",
                "ms",
                Goal(1.5),
            )
            for size in SIZES
            for zoom in ("out", "in")
        ),
        _frames,
    ),
    Bench(
        "open",
        (
            Row(
                f"editor: read and show {OPENED:,} states on the canvas",
                "open",
                "read and shown",
                f"parse, {BARE}",
                "s",
                Goal(1.0, of="ours"),
            ),
        ),
        _opening,
    ),
)
