"""The screen designer with a screen of 100 components: a frame while one is dragged, and an edit.

Beside the frame is a bare widget that paints as many boxes with a text in each.
"""

from __future__ import annotations

import contextlib
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from tests.benchmarks.drawing import qt
from tests.benchmarks.harness import CPU, Bench, Goal, Row, Sample, each

MANY, FEW = 100, 10
SIZE = (1_000, 625)
FRAME = 16.0
STATES = 20
BARE = "a bare widget that paints as many boxes"

PROJECT = '[project]\nname = "bench"\napplications = ["screens.rbd.xml"]\n'


def application(components: int) -> bytes:
    """States with that many components each: texts, buttons, inputs and lists."""
    from situ.document import codec, rbd

    def component(at: int) -> rbd.Component:
        box: dict[str, Any] = {
            "x": at % 10 * 10 + 0.5,
            "y": at // 10 * 10 + 0.5,
            "width": 9.0,
            "height": 9.0,
        }
        if at % 10 < 5:
            return rbd.Text(id=f"text{at}", text=f"Text {at} of {{user.name}}", size=4, **box)
        if at % 10 < 8:
            return rbd.Button(id=f"button{at}", text=f"Yes {at}", event="clickYes", **box)
        if at % 10 == 8:
            return rbd.Input(id=f"input{at}", tag="user.name", **box)
        return rbd.List(id=f"list{at}", items="patients", **box)

    screen = rbd.Screen(components=tuple(component(at) for at in range(components)))
    states = tuple(
        rbd.State(no=str(no), screen=screen, events=(rbd.Event(name="clickYes", next="1"),))
        for no in range(1, STATES + 1)
    )
    return codec.write(rbd.Application(name="screens", states=states))


@contextlib.contextmanager
def _frames() -> Iterator[Mapping[str, Sample]]:
    with qt() as app:
        sheet, bare = _sheet(), _bare()
        for widget in (sheet, bare):
            widget.show()
        app.processEvents()
        yield {
            "drag": _dragged(sheet),
            BARE: each(lambda times: _painted(bare, times), CPU, 1e-3),
        }
        for widget in (sheet, bare):
            widget.close()
            widget.deleteLater()


def _sheet() -> Any:
    from situ.document import codec
    from situ.document.rbd import Application
    from situ_studio.looks.theme import LIGHT
    from situ_studio.screens.sheet import Sheet

    document, _ = codec.read(application(MANY), "screens.rbd.xml")
    assert isinstance(document, Application)
    sheet = Sheet(LIGHT)
    sheet.resize(*SIZE)
    sheet.show_screen(LIGHT, document.states[0].screen, (), None)
    return sheet


def _dragged(sheet: Any) -> Sample:
    """From a move of the mouse that holds a button to the painted frame."""
    from PySide6.QtCore import QEvent, QPointF, Qt
    from PySide6.QtGui import QMouseEvent

    left, none = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    start = QPointF(sheet.width() * 0.55, sheet.height() * 0.55)

    def event(kind: QEvent.Type, at: QPointF) -> QMouseEvent:
        return QMouseEvent(kind, at, sheet.mapToGlobal(at), left, left, none)

    def several(times: int) -> None:
        for turn in range(times):
            way = QPointF(20 + turn % 40, 10 + turn % 30)
            sheet.mouseMoveEvent(event(QEvent.Type.MouseMove, start + way))
            sheet.repaint()

    sheet.mousePressEvent(event(QEvent.Type.MouseButtonPress, start))
    several(1)
    return each(several, CPU, unit=1e-3)


def _bare() -> Any:
    from PySide6.QtCore import QRectF, Qt
    from PySide6.QtGui import QPainter, QPaintEvent
    from PySide6.QtWidgets import QWidget

    from situ_studio.looks.theme import LIGHT, font

    class Bare(QWidget):
        def paintEvent(self, event: QPaintEvent) -> None:
            painter = QPainter(self)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.fillRect(self.rect(), LIGHT.color("card"))
            painter.setFont(font())
            across, down = self.width() / 10, self.height() / 10
            for at in range(MANY):
                box = QRectF(at % 10 * across, at // 10 * down, across * 0.9, down * 0.9)
                painter.setPen(LIGHT.color("line"))
                painter.setBrush(LIGHT.color("field"))
                painter.drawRoundedRect(box, 6, 6)
                painter.setPen(LIGHT.color("text"))
                painter.drawText(box, int(Qt.AlignmentFlag.AlignCenter), f"Text {at}")
            painter.end()

    made = Bare()
    made.resize(*SIZE)
    return made


def _painted(widget: Any, times: int) -> None:
    for _ in range(times):
        widget.repaint()


@contextlib.contextmanager
def _edits() -> Iterator[Mapping[str, Sample]]:
    """From the mouse that is let go to the painted frame, in the whole window."""
    with qt() as app, contextlib.ExitStack() as opened:
        yield {
            f"edit, {count} components": _edit(opened.enter_context(_window(count, app)), app)
            for count in (FEW, MANY)
        }


@contextlib.contextmanager
def _window(components: int, app: Any) -> Iterator[Any]:
    from PySide6.QtCore import QSettings

    from situ_studio.project.session import Session
    from situ_studio.window.main_window import MainWindow

    with tempfile.TemporaryDirectory(prefix="situ-bench-") as folder:
        root = Path(folder)
        (root / "situ.toml").write_text(PROJECT)
        (root / "screens.rbd.xml").write_bytes(application(components))
        settings = QSettings(f"{folder}/settings.ini", QSettings.Format.IniFormat)
        window: Any = MainWindow(Session(), settings, list)
        window.resize(1_280, 800)
        window.show()
        window.open_project(root)
        window.show_mode("screen")
        window.select(("state", "1"))
        # Problems are looked for beside it, which would count as this one's time.
        window.session.checker.cancel()
        window.session.checker.ask = lambda project: None
        app.processEvents()
        yield window
        window.may_leave = lambda: True
        window.close()
        window.deleteLater()


def _edit(window: Any, app: Any) -> Sample:
    from PySide6.QtCore import QEvent

    from situ_studio.screens import placing

    sheet = window.commands.components.sheet
    sheet.choose(("text3",))
    turn = 0

    def several(times: int) -> None:
        nonlocal turn
        for _ in range(times):
            turn += 1
            by = 1 if turn % 2 else -1
            sheet.place(placing.moved(sheet.selected_boxes(), 0, by), "Move {0}")
            sheet.repaint()
            # What else of the window has to be painted.
            app.sendPostedEvents(None, QEvent.Type.UpdateRequest)

    return each(several, CPU, unit=1e-3)


BENCHES = (
    Bench(
        "screen frame",
        (
            Row(
                f"editor: frame while one of {MANY} components is dragged",
                "frame",
                "drag",
                BARE,
                "ms",
                Goal(1.5),
            ),
        ),
        _frames,
    ),
    Bench(
        "screen edit",
        (
            Row(
                f"editor: one edit on a screen of {MANY} components",
                "edit",
                f"edit, {MANY} components",
                f"edit, {FEW} components",
                "ms",
                Goal(FRAME, of="ours"),
            ),
        ),
        _edits,
    ),
)
