"""A document in very small: for the welcome page."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPainterPath, QPen

from situ.document.rbd import Application, State
from situ.document.spds import Spds
from situ_studio.canvas import routes
from situ_studio.looks import icons
from situ_studio.looks.theme import Theme

Point = tuple[float, float]
CARD = (176.0, 116.0)


def paint_application(
    painter: QPainter, rect: QRectF, application: Application, theme: Theme, routed: bool = True
) -> None:
    """Cards at their places with what leads to what; states without a place stand in rows.

    routed: lines go round the cards, as on the canvas; else straight, in a tenth of the time.
    """
    boxes: dict[str, QRectF] = {}
    for index, state in enumerate(application.states):
        x, y = state.aside.position or (24 + 230 * (index % 5), 52 + 228 * (index // 5))
        boxes[state.no] = QRectF(x, y, *CARD)
    if not boxes:
        return
    extent = QRectF()
    for box in boxes.values():
        extent = extent.united(box)
    scale = min(rect.width() / extent.width(), rect.height() / extent.height(), 0.5)
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.translate(rect.center())
    painter.scale(scale, scale)
    painter.translate(-extent.center())
    line = 1 / scale
    painter.setPen(QPen(theme.color("pipe"), line))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for points in (_routes if routed else _straight)(application, boxes):
        painter.drawPolyline([QPointF(x, y) for x, y in points])
    for state in application.states:
        _card(painter, boxes[state.no], state, theme, line, state.no == application.start_no)
    painter.restore()


def _routes(application: Application, boxes: dict[str, QRectF]) -> list[tuple[Point, ...]]:
    """The ways of the transitions, as the canvas would draw them."""
    around = {no: routes.Box(b.left(), b.top(), b.right(), b.bottom()) for no, b in boxes.items()}
    pipes = []
    for state in application.states:
        box = boxes[state.no]
        targets = sorted({e.next for e in state.events if e.next in boxes and e.next != state.no})
        for index, target in enumerate(targets):
            assert target is not None
            pipes.append(
                routes.Pipe(
                    id=(state.no, str(index), target),
                    source=state.no,
                    target=target,
                    start=(box.right(), box.top() + 63 + 18 * min(index, 2)),
                    end=(boxes[target].left(), boxes[target].top() + 63),
                    width=0,
                    height=0,
                    chip=0,
                )
            )
    return [route.points for route in routes.Router().route(around, pipes).values()]


def _straight(application: Application, boxes: dict[str, QRectF]) -> list[tuple[Point, ...]]:
    """From the middle of each card to those of where it leads."""
    found: list[tuple[Point, ...]] = []
    for state in application.states:
        start = boxes[state.no].center()
        for event in state.events:
            if event.next in boxes and event.next != state.no:
                end = boxes[event.next].center()
                found.append(((start.x(), start.y()), (end.x(), end.y())))
    return found


def _card(
    painter: QPainter, box: QRectF, state: State, theme: Theme, line: float, start: bool
) -> None:
    border = theme.color("start" if start else "line_strong")
    painter.setPen(QPen(border, line))
    painter.setBrush(theme.color("card"))
    painter.drawRoundedRect(box, 12, 12)
    head = QRectF(box.x(), box.y(), box.width(), 30)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(theme.color("start_soft" if start else "state_soft"))
    painter.drawRoundedRect(head.adjusted(2, 2, -2, 0), 10, 10)
    picture = QRectF(box.x() + 12, box.y() + 44, 72, 48)
    painter.setBrush(theme.color("line"))
    painter.drawRoundedRect(picture, 4, 4)
    if state.screen is None:
        return
    for component in state.screen.components[:8]:
        at = QRectF(
            picture.x() + component.x / 100 * picture.width(),
            picture.y() + component.y / 100 * picture.height(),
            max(component.width / 100 * picture.width(), 3),
            max(component.height / 100 * picture.height() * 0.7, 3),
        )
        button = component.element == "button"
        painter.setBrush(theme.color("accent" if button else "text3"))
        painter.drawRoundedRect(at, 2, 2)


def paint_script(painter: QPainter, rect: QRectF, script: Spds, theme: Theme) -> None:
    """Columns of data, situations, modules and resources, and what leads to what."""
    resources = list(dict.fromkeys(r for m in script.modules for r in m.resources))
    columns: list[tuple[str, str, list[str]]] = [
        ("data", "data", [o.tag for o in script.observe]),
        ("situation", "situation", [s.name for s in script.situations]),
        ("module", "module", [m.name for m in script.modules]),
        ("resource", "resource", resources),
    ]
    rows = max((len(c[2]) for c in columns), default=0)
    if not rows:
        return
    pitch = min(28.0, rect.height() / rows)
    width = rect.width() / len(columns)
    boxes: dict[tuple[str, str], QRectF] = {}
    for index, (kind, _, names) in enumerate(columns):
        top = rect.center().y() - len(names) * pitch / 2
        wide = width * 0.36 if kind == "resource" else width * 0.62
        for row, name in enumerate(names):
            x = rect.x() + width * (index + 0.19)
            boxes[kind, name] = QRectF(x, top + row * pitch, wide, pitch * 0.64)
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(QPen(theme.color("pipe"), 1))
    for situation in script.situations:
        tests = _tags(situation.condition)
        for tag in tests:
            _curve(painter, boxes.get(("data", tag)), boxes["situation", situation.name])
        for entry in situation.entries:
            _curve(painter, boxes["situation", situation.name], boxes.get(("module", entry.module)))
    for module in script.modules:
        for resource in module.resources:
            _curve(painter, boxes["module", module.name], boxes.get(("resource", resource)))
    for kind, icon, names in columns:
        for name in names:
            _node(painter, boxes[kind, name], kind, icon, theme)
    painter.restore()


def _tags(condition: object) -> list[str]:
    found: list[str] = []
    for child in getattr(condition, "children", ()):
        tag = getattr(child, "tag", None)
        found += [tag] if tag is not None else _tags(child)
    return list(dict.fromkeys(found))


def _curve(painter: QPainter, source: QRectF | None, target: QRectF | None) -> None:
    if source is None or target is None:
        return
    start = QPointF(source.right(), source.center().y())
    end = QPointF(target.left(), target.center().y())
    half = (end.x() - start.x()) / 2
    path = QPainterPath(start)
    path.cubicTo(start + QPointF(half, 0), end - QPointF(half, 0), end)
    painter.drawPath(path)


def _node(painter: QPainter, box: QRectF, kind: str, icon: str, theme: Theme) -> None:
    painter.setPen(QPen(theme.color("line_strong"), 1))
    painter.setBrush(theme.color("card"))
    painter.drawRoundedRect(box, 4, 4)
    strip = QRectF(box.x() + 1, box.y() + 1, min(16.0, box.width()), box.height() - 2)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(theme.color(f"{kind}_soft"))
    painter.drawRoundedRect(strip, 3, 3)
    side = min(10.0, box.height() - 4)
    at = QRectF(0, 0, side, side)
    at.moveCenter(strip.center())
    icons.paint(painter, icon, at, theme.color(kind))
    if kind != "resource":
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme.color("text3"))
        bar = QRectF(
            strip.right() + 6, box.center().y() - 1.5, (box.right() - strip.right()) * 0.55, 3
        )
        painter.drawRoundedRect(bar, 1.5, 1.5)
