"""A script to draw, where its things lie, and what must hold of its drawing."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest

from situ.document.condition import Condition
from situ.document.condition import Test as Question
from situ.document.spds import Declaration, Entry, Observed, Situation, Spds
from situ_studio.canvas.curves import CurvedPipe
from situ_studio.canvas.nodes import NodeFace
from situ_studio.canvas.script_projection import ScriptProjector


def holds(tag: str) -> Condition:
    return Condition((Question(tag, "is", "true", within=2),))


TALK = Spds(
    name="talk",
    observe=(
        Observed("waving", "boolean"),
        Observed("calling", "boolean"),
        Observed("slap", "number", "deg"),
        Observed("unused", "text"),
    ),
    modules=(
        Declaration("transfer", ("base", "head")),
        Declaration("gaze", ("head",)),
        Declaration("converse", ("speech", "screen")),
    ),
    situations=(
        Situation(
            "invited",
            limit=90,
            condition=Condition((*holds("calling").children, *holds("waving").children)),
            until=holds("slap"),
            entries=(Entry("transfer", 90),),
        ),
        Situation(
            "sound",
            extends="conversation",
            condition=holds("slap"),
            entries=(Entry("gaze", 60),),
        ),
        Situation("conversation", entries=(Entry("converse", 30), Entry("gaze", None))),
    ),
)
"""Three situations, one of them taking over, and what they give to whom."""


def agree(desk: Any) -> None:
    """View = document = NodeGraphQt's model. What was drawn edit by edit is what is drawn afresh
    with every card at its place."""
    canvas = desk.canvas
    graph, viewer = canvas.graph, canvas.viewer
    assert canvas.document is desk.document
    afresh = ScriptProjector()
    afresh.columns.like(canvas._projector.columns)
    wanted = afresh.picture(canvas.document, canvas._problems)
    nodes = {n.uid: n for n in graph.model.nodes.values()}
    assert set(nodes) == set(wanted.cards)
    connected = set()
    for key, node in nodes.items():
        card = wanted.cards[key]
        assert node.model.name == card.name
        assert tuple(node.model.outputs) == card.outputs
        assert tuple(node.model.inputs) == card.inputs
        assert (node.view.x(), node.view.y()) == (card.x, card.y)
        for port in node.output_ports():
            for other, names in port.model.connected_ports.items():
                for name in names:
                    connected.add((key, port.name(), graph.model.nodes[other].uid, name))
    assert connected == set(wanted.links)
    items = [i.uid for i in viewer.scene().items() if isinstance(i, NodeFace)]
    assert sorted(items) == sorted(wanted.cards)
    pipes = [i for i in viewer.scene().items() if isinstance(i, CurvedPipe)]
    ends = [
        (p.output_port.node.uid, p.output_port.name, p.input_port.node.uid, p.input_port.name)
        for p in pipes
    ]
    assert sorted(ends) == sorted(wanted.links)
    assert all(p.link == wanted.links[e] for p, e in zip(pipes, ends, strict=True))
    assert not viewer.touched
    assert not viewer.busy()


def pipe(made: Any, source: str, target: str) -> CurvedPipe:
    found: CurvedPipe = next(
        made.canvas.graph.pipe(i)
        for i in made.canvas.graph.links
        if i[0] == source and i[2] == target
    )
    return found


def out(made: Any, key: str) -> QPointF:
    return QPointF(made.hand.exit(key, "out"))


def middle(made: Any, key: str) -> QPointF:
    return QPointF(made.hand.card(key).sceneBoundingRect().center())


def body(made: Any, key: str) -> QPointF:
    return QPointF(made.hand.card(key).scenePos() + QPointF(60, 22))


def edit(made: Any, text: str) -> None:
    editor = made.canvas.priorities.editor
    editor.selectAll()
    made.hand.type(editor, text)
    QTest.keyClick(editor, Qt.Key.Key_Return)
    made.hand.settle()
