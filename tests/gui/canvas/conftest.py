"""A canvas in a real window, a hand that drives it with real events, and documents to draw."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, QRectF, Qt
from PySide6.QtGui import QImage, QKeyEvent, QMouseEvent, QPainter, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget

from situ.document.aside import NOTHING
from situ.document.condition import Condition, Test
from situ.document.rbd import (
    Always,
    Application,
    Button,
    Event,
    Robot,
    Say,
    Screen,
    Service,
    Speech,
    State,
    Text,
    Timeout,
)
from situ_studio.canvas import figures
from situ_studio.canvas.application import ApplicationCanvas
from situ_studio.canvas.nodes import NodeFace, Spot
from situ_studio.canvas.pipes import RoutedPipe
from situ_studio.canvas.projection import Projector
from situ_studio.looks import theme

LEFT = Qt.MouseButton.LeftButton
NONE = Qt.KeyboardModifier.NoModifier


class Hand:
    """Mouse and keys on a canvas. Points are scene points unless they say otherwise."""

    def __init__(self, canvas: Any) -> None:
        self.canvas = canvas
        self.viewer = canvas.viewer
        self.port = canvas.viewer.viewport()

    def pixel(self, spot: QPointF) -> QPoint:
        found: QPoint = self.viewer.mapFromScene(spot)
        return found

    def sees(self, spot: QPointF) -> bool:
        return bool(self.port.rect().adjusted(4, 4, -4, -4).contains(self.pixel(spot)))

    def _send(
        self,
        kind: QEvent.Type,
        at: QPoint,
        button: Qt.MouseButton,
        buttons: Qt.MouseButton,
        held: Qt.KeyboardModifier = NONE,
    ) -> None:
        spot = QPointF(at)
        event = QMouseEvent(kind, spot, QPointF(self.port.mapToGlobal(at)), button, buttons, held)
        QApplication.sendEvent(self.port, event)

    def press(self, spot: QPointF, held: Qt.KeyboardModifier = NONE) -> None:
        at = self.pixel(spot)
        self._send(
            QEvent.Type.MouseMove, at, Qt.MouseButton.NoButton, Qt.MouseButton.NoButton, held
        )
        self._send(QEvent.Type.MouseButtonPress, at, LEFT, LEFT, held)

    def move(self, spot: QPointF, held: Qt.KeyboardModifier = NONE) -> None:
        self._send(QEvent.Type.MouseMove, self.pixel(spot), Qt.MouseButton.NoButton, LEFT, held)

    def release(self, spot: QPointF, held: Qt.KeyboardModifier = NONE) -> None:
        self._send(
            QEvent.Type.MouseButtonRelease, self.pixel(spot), LEFT, Qt.MouseButton.NoButton, held
        )
        self.settle()

    def settle(self) -> None:
        QApplication.processEvents()

    def drag(self, start: QPointF, end: QPointF, held: Qt.KeyboardModifier = NONE) -> None:
        self.press(start, held)
        for step in range(1, 6):
            self.move(start + (end - start) * (step / 5), held)
        self.release(end, held)

    def click(self, spot: QPointF, held: Qt.KeyboardModifier = NONE) -> None:
        self.press(spot, held)
        self.release(spot, held)

    def double_click(self, spot: QPointF) -> None:
        self.click(spot)
        self._send(QEvent.Type.MouseButtonDblClick, self.pixel(spot), LEFT, LEFT)
        self.release(spot)

    def key(self, key: Qt.Key, held: Qt.KeyboardModifier = NONE, text: str = "") -> None:
        for kind in (QEvent.Type.KeyPress, QEvent.Type.KeyRelease):
            QApplication.sendEvent(self.viewer, QKeyEvent(kind, key, held, text))
        self.settle()

    def type(self, widget: QWidget, text: str) -> None:
        QTest.keyClicks(widget, text)
        self.settle()

    def wheel(self, spot: QPointF, turned: int) -> None:
        at = self.pixel(spot)
        event = QWheelEvent(
            QPointF(at),
            QPointF(self.port.mapToGlobal(at)),
            QPoint(),
            QPoint(0, turned),
            Qt.MouseButton.NoButton,
            NONE,
            Qt.ScrollPhase.NoScrollPhase,
            False,
        )
        QApplication.sendEvent(self.port, event)
        self.settle()

    # -- where things are ------------------------------------------------------------

    def card(self, uid: str) -> NodeFace:
        view: NodeFace = self.canvas.graph.nodes[uid].view
        return view

    def body(self, uid: str) -> QPointF:
        """A spot of the card with no port near."""
        return QPointF(self.card(uid).scenePos() + QPointF(20, 44))

    def header(self, uid: str) -> QPointF:
        return QPointF(self.card(uid).scenePos() + QPointF(60, 14))

    def exit(self, uid: str, name: str) -> QPointF:
        node = self.canvas.graph.nodes[uid]
        spot: Spot = node.port("out", name).view
        return spot.centre()

    def pipe(self, source: str, exit: str) -> RoutedPipe:
        found: RoutedPipe = next(
            self.canvas.graph.pipe(i)
            for i in self.canvas.graph.links
            if i[0] == source and i[1] == exit
        )
        return found

    def on_pipe(self, pipe: RoutedPipe, part: float = 0.5) -> QPointF:
        if pipe.route.folded:
            return pipe.shape().boundingRect().center()
        return QPointF(pipe.path().pointAtPercent(part))


class Desk:
    """A canvas with its document's history: what the shell is to it. ``refuse`` shows no edit."""

    def __init__(self, canvas: Any, document: Any) -> None:
        self.canvas = canvas
        self.hand = Hand(canvas)
        self.done: list[Any] = [document]
        self.undone: list[Any] = []
        self.edits: list[str] = []
        self.selections: list[Any] = []
        self.refuse = False
        canvas.edited.connect(self._edited)
        canvas.selection_changed.connect(self.selections.append)
        canvas.show_document(document)

    @property
    def document(self) -> Any:
        return self.done[-1]

    def _edited(self, after: Any, text: str) -> None:
        assert text
        self.edits.append(text)
        if self.refuse:
            return
        self.done.append(after)
        self.undone = []
        self.canvas.show_document(after)

    def undo(self) -> None:
        if len(self.done) > 1:
            self.undone.append(self.done.pop())
            self.canvas.show_document(self.document)

    def redo(self) -> None:
        if self.undone:
            self.done.append(self.undone.pop())
            self.canvas.show_document(self.document)

    def change(self, after: Any) -> None:
        """Somebody else changes the document."""
        self.done.append(after)
        self.undone = []
        self.canvas.show_document(after)


def at_scale(canvas: Any, left: float = -60, top: float = -60) -> None:
    """One to one, the scene's ``left``, ``top`` in the corner."""
    size = canvas.viewer.viewport().size()
    canvas.viewer._scene_range = QRectF(left, top, size.width(), size.height())
    canvas.viewer._update_scene()


@pytest.fixture
def desk(qt: QApplication) -> Iterator[Callable[..., Desk]]:
    """``desk(document)``: a shown ApplicationCanvas of 1100 × 760 with that document."""
    made: list[QWidget] = []

    def make(document: Any, kind: Any = ApplicationCanvas, size: Any = (1100, 760)) -> Desk:
        canvas = kind(theme.LIGHT)
        canvas.resize(*size)
        made.append(canvas)
        canvas.show()
        QTest.qWaitForWindowExposed(canvas)
        desk = Desk(canvas, document)
        QApplication.processEvents()
        at_scale(canvas)
        return desk

    yield make
    for canvas in made:
        canvas.close()
        canvas.deleteLater()
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    QApplication.processEvents()


def place(column: int, row: int) -> Any:
    return NOTHING.at(column * 230, row * 228)


@pytest.fixture
def small() -> Application:
    """Five states in two rows: a way, back edges, a loop, a guard, a join, a dangling ``next``."""
    guard = Condition((Test("patients.0", "exists", "true"),))
    return Application(
        name="small",
        start="1",
        always=Always(
            screen=Screen(
                components=(
                    Button(id="home", x=2, y=2, width=16, height=12, event="home", text="Home"),
                )
            ),
            events=(Event(name="home", next="1"),),
            aside=NOTHING.at(690, 228),
        ),
        states=(
            State(
                no="1",
                name="start",
                timeout=Timeout(seconds=30, next="1"),
                screen=Screen(
                    touched="touched",
                    components=(
                        Text(id="t", x=10, y=10, width=80, height=20, text="Touch me to begin"),
                        Button(id="b", x=30, y=60, width=40, height=25, event="go", text="GO"),
                    ),
                ),
                actions=(Speech(text="Touch me to begin"),),
                events=(
                    Event(name="touched", next="2"),
                    Event(name="human", next="2", says=(Say("hello"),)),
                ),
                aside=place(0, 0),
            ),
            State(
                no="2",
                name="look",
                timeout=Timeout(seconds=60, next="1"),
                actions=(
                    Speech(text="One moment, I am looking for your name"),
                    Service(name="find", url="http://x/find", done="returned", failed="offline"),
                    Robot(resource="head", command="nod", optional=True),
                ),
                events=(
                    Event(name="returned", next="3", when=guard),
                    Event(name="returned", next="4"),
                    Event(name="offline", next="4"),
                ),
                aside=place(1, 0),
            ),
            State(
                no="3",
                name="names",
                actions=(Speech(text="Please touch your name."),),
                events=(
                    Event(name="clickNo", next="4"),
                    Event(name="clickBack", next="1"),
                    Event(name="again", next="#again"),
                    Event(name="lost", next="17"),
                ),
                aside=place(3, 0),
            ),
            State(
                no="4",
                name="no user",
                events=(Event(name="tryAgain", next="2"), Event(next="5", when=guard)),
                aside=place(0, 1),
            ),
            State(no="5", name="end", final=True, aside=place(1, 1)),
        ),
    )


def agree(desk: Desk) -> None:
    """View = document = NodeGraphQt's model; no gesture is left half done."""
    canvas = desk.canvas
    graph, viewer = canvas.graph, canvas.viewer
    assert canvas.document is desk.document
    picture = Projector().picture(canvas.document, canvas._problems, canvas.positions.laid)
    cards: dict[str, Any] = {**picture.cards, **figures.shown(canvas.document, {})}
    links = picture.links
    # The model.
    nodes = {n.uid: n for n in graph.model.nodes.values()}
    assert len(nodes) == len(graph.model.nodes)
    assert set(nodes) == set(cards)
    connected = set()
    for uid, node in nodes.items():
        card = cards[uid]
        assert node.model.name == card.name
        assert tuple(node.model.pos) == (card.x, card.y)
        assert tuple(node.model.outputs) == card.outputs
        assert tuple(node.model.inputs) == card.inputs
        assert tuple(p.name() for p in node.output_ports()) == card.outputs
        for port in node.output_ports():
            for other, names in port.model.connected_ports.items():
                target = graph.model.nodes[other].uid
                assert names == ["in"]
                connected.add((uid, port.name(), target))
        for port in node.input_ports():
            for other, names in port.model.connected_ports.items():
                for name in names:
                    assert (graph.model.nodes[other].uid, name, uid) in links
    assert connected == set(links)
    # The view.
    items = [i for i in viewer.scene().items() if isinstance(i, NodeFace)]
    assert sorted(i.uid for i in items) == sorted(cards)
    for item in items:
        card = cards[item.uid]
        assert (item.x(), item.y()) == (card.x, card.y)
        assert getattr(item, "wanted", None) is None
        assert item.face == card
        assert {s.name for s in item.outputs} == set(card.outputs)
        assert {s.name for s in item.inputs} == set(card.inputs)
    pipes = [i for i in viewer.scene().items() if isinstance(i, RoutedPipe)]
    ends = [(p.output_port.node.uid, p.output_port.name, p.input_port.node.uid) for p in pipes]
    assert sorted(ends) == sorted(links)
    for pipe, end in zip(pipes, ends, strict=True):
        assert pipe.link == links[end]
        assert pipe in pipe.output_port.connected_pipes
        assert pipe in pipe.input_port.connected_pipes
    spots = [i for i in viewer.scene().items() if isinstance(i, Spot)]
    assert all(s.node is not None and s.node.uid in cards for s in spots)
    assert sum(len(s.connected_pipes) for s in spots) == 2 * len(pipes)
    # Nothing under way.
    assert not viewer.touched
    assert not viewer._LIVE_PIPE.isVisible()
    assert not viewer._rubber_band.isActive
    assert viewer._detached_port is None
    assert not graph.connections


def _farthest(one: QImage, other: QImage) -> int:
    """The largest difference of any px in any colour, of 255."""
    assert one.size() == other.size()
    apart = one.convertToFormat(QImage.Format.Format_RGB32)
    painter = QPainter(apart)
    painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_Difference)
    painter.drawImage(0, 0, other.convertToFormat(QImage.Format.Format_RGB32))
    painter.end()
    colours = apart.convertToFormat(QImage.Format.Format_RGB888)
    return max(bytes(colours.constBits()))


@pytest.fixture
def farthest() -> Callable[[QImage, QImage], int]:
    return _farthest


@pytest.fixture
def check() -> Callable[[Desk], None]:
    return agree
