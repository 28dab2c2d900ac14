"""The robot's screen as people use it: painted as on the robot, and what is touched is told."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from msgspec import UNSET, Struct
from PySide6.QtCore import QPoint, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QAccessible,
    QContextMenuEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QResizeEvent,
)
from PySide6.QtWidgets import QLineEdit, QSizePolicy, QWidget

from situ.decide.screens import Shown
from situ.decide.values import in_text
from situ_studio.assistive.heard_as import hear_as
from situ_studio.looks.theme import Theme
from situ_studio.screens.component_painting import Stage
from situ_studio.screens.list_painting import rows
from situ_studio.screens.painting import DEVICE, layer, paint_content
from situ_studio.screens.shown import Content

NEXT = (Qt.Key.Key_Right, Qt.Key.Key_Down)
BEFORE = (Qt.Key.Key_Left, Qt.Key.Key_Up)
PRESS = (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space)


class Target(Struct, frozen=True):
    """What can be touched: a button, an input or a row of a list. box: on the robot's screen, px.

    value: what a row stands for, else unset.
    """

    id: str
    words: str
    box: QRectF
    types: bool = False
    value: Any = UNSET


class RobotScreen(QWidget):
    """As wide as there is room, in the shape of the robot's screen. The arrow keys go from one
    thing that can be touched to the next, Enter touches it.
    """

    used = Signal(str, object)
    """A component's id, and the value typed or chosen; unset for a button."""
    touched = Signal()
    """A touch on nothing that answers."""
    menu_asked = Signal(str, QPoint)
    """A context menu is wanted: of the component with that id, or "", and where on the desktop."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme = theme
        self._content = Content(())
        self._media: Path | None = None
        self._at: str | None = None
        self.targets: list[Target] = []
        """What can be touched, from the top; what lies above others is last."""
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMinimumWidth(160)
        self.field = QLineEdit(self)
        self.field.hide()
        self.field.returnPressed.connect(self._on_typed)
        self._typing: Target | None = None
        self.setAccessibleName(self.tr("The robot's screen"))
        hear_as(self, QAccessible.Role.Canvas)
        self._name()

    def show_content(self, content: Content, media: Path | None) -> None:
        """What the robot shows now. media: the folder of its pictures."""
        if content == self._content and media == self._media:
            return
        self._content, self._media = content, media
        self.targets = self._find()
        if self._typing is not None and self._typing.id not in {t.id for t in self.targets}:
            self._end_typing()
        self._name()
        self.update()

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self.update()

    def place_of(self, target: Target) -> QPointF:
        """The middle of what can be touched, on this widget."""
        return self._box(target).center()

    # -- where what is ---------------------------------------------------------------

    def _find(self) -> list[Target]:
        stage = Stage(layer(DEVICE), self._content, self._media)
        found: list[Target] = []
        for one in self._content.components:
            found += _targets(stage, one)
        return found

    def _box(self, target: Target) -> QRectF:
        scale = self.width() / layer(DEVICE).width()
        box = target.box
        return QRectF(
            box.left() * scale, box.top() * scale, box.width() * scale, box.height() * scale
        )

    def _under(self, at: QPointF) -> Target | None:
        return next((t for t in reversed(self.targets) if self._box(t).contains(at)), None)

    # -- hands and keys --------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton:
            return
        self.setFocus(Qt.FocusReason.MouseFocusReason)
        target = self._under(event.position())
        self._end_typing()
        self._at = None
        if target is None:
            self.touched.emit()
        else:
            self._touch(target)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        by_hand = event.reason() == QContextMenuEvent.Reason.Mouse
        target = self._under(QPointF(event.pos())) if by_hand else self.current
        self.menu_asked.emit(target.id if target is not None else "", event.globalPos())

    @property
    def current(self) -> Target | None:
        """Where the arrow keys are; None while they are nowhere."""
        return next((t for t in self.targets if _key(t) == self._at), None)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key = Qt.Key(event.key())
        here = next((n for n, t in enumerate(self.targets) if _key(t) == self._at), None)
        if key in NEXT + BEFORE and self.targets:
            way = 1 if key in NEXT else -1
            to = (here + way) if here is not None else (0 if way > 0 else -1)
            self._at = _key(self.targets[to % len(self.targets)])
            # A reader tells it again whenever it changes: of the way only where it leads.
            self.setAccessibleDescription(self.targets[to % len(self.targets)].words)
            self.update()
        elif key in PRESS:
            if here is None:
                self.touched.emit()
            else:
                self._touch(self.targets[here])
        else:
            super().keyPressEvent(event)

    def _touch(self, target: Target) -> None:
        if target.types:
            self._begin_typing(target)
        else:
            self.used.emit(target.id, target.value)

    def _begin_typing(self, target: Target) -> None:
        self._typing = target
        shown = next(one for one in self._content.components if one["id"] == target.id)
        kind = shown.get("kind")
        self.field.setEchoMode(
            QLineEdit.EchoMode.Password if kind == "pin" else QLineEdit.EchoMode.Normal
        )
        self.field.setMaxLength(shown.get("max") or 32767)
        self.field.setText(in_text(shown.get("value")))
        self.field.selectAll()
        self.field.setAccessibleName(target.words)
        self._place_field()
        self.field.show()
        self.field.setFocus(Qt.FocusReason.OtherFocusReason)

    def _place_field(self) -> None:
        if self._typing is not None:
            box = self._box(self._typing).toAlignedRect()
            high = max(box.height(), 26)
            self.field.setGeometry(box.left(), box.center().y() - high // 2, box.width(), high)

    def _on_typed(self) -> None:
        typing = self._typing
        if typing is not None:
            text = self.field.text()
            self._end_typing()
            self.setFocus(Qt.FocusReason.OtherFocusReason)
            self.used.emit(typing.id, text)

    def _end_typing(self) -> None:
        self._typing = None
        self.field.hide()

    # -- looks -----------------------------------------------------------------------

    def _name(self) -> None:
        texts = [in_text(c.get("text")) for c in self._content.components if c.get("text")]
        here = next((t.words for t in self.targets if _key(t) == self._at), "")
        self.setAccessibleDescription(". ".join([here, *texts] if here else texts))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.setFixedHeight(self._height(event.size().width()))
        self._place_field()

    def _height(self, width: int) -> int:
        size = layer(DEVICE)
        return int(width * size.height() / size.width())

    def sizeHint(self) -> QSize:
        return QSize(280, self._height(280))

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        rect = QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5)
        paint_content(painter, rect, self._content, self._media, DEVICE)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(self._theme.color("line_strong"))
        painter.drawRoundedRect(rect, 4, 4)
        if self.hasFocus():
            painter.setPen(QPen(self._theme.color("accent"), 2))
            here = [t for t in self.targets if _key(t) == self._at]
            for target in here:
                painter.drawRoundedRect(self._box(target).adjusted(-2, -2, 2, 2), 5, 5)
            if not here:
                painter.drawRoundedRect(rect.adjusted(1, 1, -1, -1), 4, 4)
        painter.end()


def _targets(stage: Stage, one: Shown) -> list[Target]:
    """What can be touched of a component."""
    match one["type"]:
        case "button":
            return [Target(one["id"], in_text(one.get("text")), stage.box(one))]
        case "input":
            return [Target(one["id"], one["id"], stage.box(one), types=True)]
        case "list" if one["items"] is not None:
            box = stage.box(one)
            pairs = zip(rows(stage, one), one["items"], strict=False)
            return [
                Target(one["id"], in_text(item["label"]), row.box & box, value=item["value"])
                for row, item in pairs
                if row.box.intersects(box)
            ]
        case _:
            return []


def _key(target: Target) -> str:
    """The same for the same thing as long as it is shown."""
    return f"{target.id} {target.words} {target.value}"
