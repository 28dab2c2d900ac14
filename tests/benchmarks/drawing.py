"""The editor's canvas beside a bare scene of as many rectangles, texts and lines.

Without a display (offscreen), painted by Qt's raster engine as on a screen.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from tests.benchmarks import documents
from tests.benchmarks.bare import bare, stock_graph
from tests.benchmarks.harness import CPU, Bench, Goal, Missing, Row, Sample, each

SIZES = (100, 1_000, 5_000)
STOCK = 1_000
OPENED = 1_000
WINDOW = (1_100, 760)

BARE = "a bare scene"
STEP = 24.0
"""Px that a drawing is moved by from frame to frame."""


def _name(size: int, zoom: str) -> str:
    return f"{size:,} states, zoomed {zoom}"


@contextlib.contextmanager
def qt() -> Iterator[Any]:
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    try:
        # All of it, as the studio does: what is imported later is not frozen.
        import situ_studio.main  # noqa: F401
        from situ_studio.looks.application import application
    except ImportError:
        raise Missing("the editor is not installed: pip install 'situ[studio]'") from None
    from PySide6.QtCore import QEvent

    app = application()
    yield app
    app.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    app.processEvents()


@contextlib.contextmanager
def _frames() -> Iterator[Mapping[str, Sample]]:
    samples: dict[str, Sample] = {}
    with qt() as app:
        shown = []
        for size in SIZES:
            canvas = _whole(documents.dialogue(size), app)
            beside = {"out": bare(canvas, "out"), "in": bare(canvas, "in")}
            stock = stock_graph(canvas) if size == STOCK else None
            shown += [canvas, *beside.values(), *([stock] if stock is not None else [])]
            app.processEvents()
            for zoom, view in beside.items():
                name = _name(size, zoom)
                samples[name] = _frame(canvas, canvas.viewer, zoom)
                samples[f"{BARE}, {name}"] = _frame(canvas, view, zoom)
                if stock is not None:
                    samples[f"NodeGraphQt as it comes, {name}"] = _frame(canvas, stock, zoom)
            samples[f"{size:,} states, moved along"] = _frame(canvas, canvas.viewer, "in", STEP)
            samples[f"{BARE}, {size:,} states, moved along"] = _frame(
                canvas, beside["in"], "in", STEP
            )
        yield samples
        for widget in shown:
            widget.close()
            widget.deleteLater()


@contextlib.contextmanager
def _opening() -> Iterator[Mapping[str, Sample]]:
    data, large = documents.dialogue(OPENED), documents.dialogue(SIZES[-1])
    with qt() as app:

        def opened() -> None:
            canvas = _filled(data, app)
            canvas.viewer.viewport().repaint()
            _closed(canvas)

        def begun() -> None:
            canvas = _canvas(large)
            canvas.viewer.viewport().repaint()
            _closed(canvas)

        model = _filled(data, app)

        def parsed() -> None:
            from lxml import etree

            etree.fromstring(data)
            view = bare(model, "in")
            view.viewport().repaint()
            _closed(view)

        def _closed(widget: Any) -> None:
            widget.close()
            widget.deleteLater()

        yield {
            "read and shown": _once(opened, app),
            "read, the first cards shown": _once(begun, app),
            f"parse, {BARE}": _once(parsed, app),
        }
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
    from situ_studio.canvas.application import ApplicationCanvas
    from situ_studio.looks import theme

    document, problems = codec.read(data, "dialogue.rbd.xml")
    assert isinstance(document, Application)
    assert not problems
    canvas = ApplicationCanvas(theme.LIGHT)
    canvas.resize(*WINDOW)
    canvas.show()
    canvas.show_document(document)
    return canvas


def _filled(data: bytes, app: Any) -> Any:
    """A canvas with all cards."""
    canvas = _canvas(data)
    while canvas.filling.is_filling:
        app.processEvents()
    return canvas


def _whole(data: bytes, app: Any) -> Any:
    """A canvas with all cards and the ways of all pipes."""
    canvas = _filled(data, app)
    while canvas._piping.is_routing():
        app.processEvents()
    return canvas


def _frame(canvas: Any, view: Any, zoom: str, step: float = 0.0) -> Sample:
    """step: px that the drawing moves by before each frame, to and fro."""

    def frames(times: int) -> None:
        here = 0
        for turn in range(times):
            if step:
                way = 1 if turn // 40 % 2 == 0 else -1
                here += way
                canvas.viewer._set_viewer_pan(way * step, 0.0)
                _aim(canvas, view)
            view.viewport().repaint()
        canvas.viewer._set_viewer_pan(-here * step, 0.0)

    one = each(frames, CPU, unit=1e-3)

    def sample() -> float:
        canvas.zoom_to_fit()
        if zoom == "in":
            canvas.set_zoom(1.0)
        _aim(canvas, view)
        return one()

    return sample


def _aim(canvas: Any, view: Any) -> None:
    """Has the view show what the canvas shows."""
    if view is canvas.viewer:
        return
    if hasattr(view, "_scene_range"):
        view._scene_range = canvas.viewer.seen()
        view._update_scene()
        return
    view.setTransform(canvas.viewer.transform())
    view.setSceneRect(canvas.viewer.seen())


BENCHES = (
    Bench(
        "frame",
        (
            *(
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
            *(
                Row(
                    f"editor: frame at {size:,} states, moved along",
                    "frame",
                    f"{size:,} states, moved along",
                    f"{BARE}, {size:,} states, moved along",
                    "ms",
                    Goal(1.5),
                )
                for size in SIZES
            ),
            *(
                Row(
                    f"editor: frame at {_name(STOCK, zoom)}, beside NodeGraphQt",
                    "frame",
                    _name(STOCK, zoom),
                    f"NodeGraphQt as it comes, {_name(STOCK, zoom)}",
                    "ms",
                )
                for zoom in ("out", "in")
            ),
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
            Row(
                f"editor: read {SIZES[-1]:,} states and show the first on the canvas",
                "open",
                "read, the first cards shown",
                f"parse, {BARE}",
                "s",
            ),
        ),
        _opening,
    ),
)
