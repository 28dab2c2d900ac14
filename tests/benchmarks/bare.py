"""What a drawing is beside: a scene of plain items, and NodeGraphQt as it comes."""

from __future__ import annotations

from typing import Any


def bare(canvas: Any, zoom: str) -> Any:
    """A view with as many rectangles, texts and lines as the canvas draws at that zoom.

    out: the whole drawing. in: one to one. Each a plain item, where the canvas has its own; an
    icon, a port and an arrow head count as rectangles, a text is as long as it is there.
    """
    from PySide6.QtCore import QLineF, QRectF
    from PySide6.QtGui import QPainter
    from PySide6.QtWidgets import QGraphicsScene, QGraphicsView

    canvas.zoom_to_fit()
    if zoom == "in":
        canvas.set_zoom(1.0)
    level = canvas.look.level
    scene = QGraphicsScene()
    for card in canvas.graph.cards.values():
        _bare_card(scene, card, level)
    for id in canvas.graph.links:
        pipe = canvas.graph.pipe(id)
        route = pipe.route
        if level in ("quarter", "tiny"):
            ends = [canvas.graph.cards[id[0]], canvas.graph.cards[id[2]]]
            scene.addLine(QLineF(ends[0].x, ends[0].y, ends[1].x, ends[1].y))
            continue
        if route.folded or len(route.points) < 2:
            continue
        for (ax, ay), (bx, by) in zip(route.points, route.points[1:], strict=False):
            scene.addLine(QLineF(ax, ay, bx, by))
        x, y = route.points[-1]
        scene.addRect(QRectF(x - 7, y - 4, 7, 8))
        if route.label is not None:
            scene.addRect(QRectF(route.label[0] - 20, route.label[1] - 9, 40, 18))
            _text(scene, route.label[0] - 18, route.label[1] - 8, pipe.link.label)
    view = QGraphicsView(scene)
    scene.setParent(view)
    view.setRenderHint(QPainter.RenderHint.Antialiasing)
    view.setFrameShape(QGraphicsView.Shape.NoFrame)
    view.resize(canvas.size())
    view.show()
    return view


def _bare_card(scene: Any, card: Any, level: str) -> None:
    """The shapes of ``cards.CardItem``, counted there."""
    from PySide6.QtCore import QLineF, QRectF

    from situ_studio.canvas import thumbnails

    x, y = card.x, card.y
    body = QRectF(x, y, card.width, card.height)
    scene.addRect(body)
    if level == "tiny":
        return
    _text(scene, x + 8, y + 4, card.no)
    if level == "quarter":
        return
    scene.addRect(QRectF(x + 8, y + 6, 20, 16))
    _text(scene, x + 36, y + 4, card.name)
    if card.screen is not None:
        scene.addRect(QRectF(x + 8, y + 54, 48, 31))
        for mark in thumbnails.marks(card.screen):
            scene.addRect(QRectF(x + 10 + mark.x * 0.44, y + 56 + mark.y * 0.27, 12, 4))
    for leaving in card.exits:
        across, down = card.port(leaving.id)
        scene.addRect(QRectF(x + across - 4, y + down - 4, 8, 8))
        if level == "full":
            _text(scene, x + across - 70, y + down - 8, leaving.label)
            if leaving.timeout or leaving.guard:
                scene.addRect(QRectF(x + across - 90, y + down - 6, 12, 12))
    if level != "full":
        return
    scene.addRect(body)
    scene.addRect(body.translated(0, 2))
    scene.addLine(QLineF(x, y + 28, x + card.width, y + 28))
    if card.line:
        scene.addRect(QRectF(x + 8, y + 33, 13, 13))
        _text(scene, x + 26, y + 32, card.line)
    for index in range(len(card.icons)):
        scene.addRect(QRectF(x + 8 + 19 * index, y + 92, 14, 14))
    for index, chip in enumerate(card.chips[:3]):
        scene.addRect(QRectF(x + 9 + 40 * index, y + card.height - 6, 36, 13))
        _text(scene, x + 12 + 40 * index, y + card.height - 8, chip)


def _text(scene: Any, x: float, y: float, text: str) -> None:
    if text:
        scene.addSimpleText(text[:24]).setPos(x, y)


def stock_graph(canvas: Any) -> Any:
    """NodeGraphQt's viewer with the canvas's nodes, ports and connections."""
    from NodeGraphQt import BaseNode, NodeGraph

    class StateNode(BaseNode):  # type: ignore[misc]
        __identifier__ = "bench"
        NODE_NAME = "state"

    graph = NodeGraph(canvas)
    graph.set_acyclic(False)
    made: dict[str, Any] = {}
    for uid, card in canvas.graph.cards.items():
        node = made[uid] = StateNode()
        # Not ``add_node``: it looks for a name that no other has among all of them.
        node._graph, node.model._graph_model = graph, graph.model
        for entry in card.inputs:
            node.add_input(entry, multi_input=True)
        for leaving in card.outputs:
            node.add_output(leaving)
        node.model.name = node.view.name = card.name
        node.model.pos = [card.x, card.y]
        graph.model.nodes[node.id] = node
        graph.viewer().add_node(node.view, (card.x, card.y))
        node.view.draw_node()
    for link in canvas.graph.links.values():
        leaving = made[link.source].get_output(link.exit)
        entry = made[link.target].get_input(link.entry)
        leaving.connect_to(entry, push_undo=False, emit_signal=False)
    view = graph.viewer()
    view.stays_with = graph
    view.resize(canvas.size())
    view.show()
    return view
