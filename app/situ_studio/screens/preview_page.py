"""The screen of the preview, which is used as on the robot: pressed, typed into, chosen from."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

from PySide6.QtCore import QPoint, QPointF, QRectF, QSize, QSizeF, Qt, Signal
from PySide6.QtGui import QAccessible, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QLineEdit, QMenu, QWidget

from situ.decide.screens import Shown
from situ.decide.values import in_text
from situ.document import rbd
from situ_studio.assistive.heard_as import hear_as
from situ_studio.looks.theme import LIGHT, Theme
from situ_studio.panels.preview import ScreenPreview
from situ_studio.screens import placing
from situ_studio.screens.accessible import called
from situ_studio.screens.component_painting import Stage
from situ_studio.screens.input_painting import letters, rooms
from situ_studio.screens.list_painting import Row, rows
from situ_studio.screens.marks import Scale
from situ_studio.screens.painting import layer
from situ_studio.screens.shown import content
from situ_studio.screens.walk import Walk

Target = tuple[rbd.Component, int]
"""What can be pressed: a component, and of a list the row, else -1."""


MOST = 4000
"""Px of height, more than any screen has: fields of the studio are low."""
_WAYS = {
    "left": Qt.AlignmentFlag.AlignLeft,
    "center": Qt.AlignmentFlag.AlignHCenter,
    "right": Qt.AlignmentFlag.AlignRight,
}


class PreviewPage(ScreenPreview):
    """Tells ``walked`` after everything that a person did. Tab goes from one target to the next,
    Enter and Space press it.
    """

    walked = Signal()

    def __init__(
        self, theme: Theme, walk: Walk, media: Path | None, parent: QWidget | None = None
    ) -> None:
        super().__init__(theme, parent)
        self.walk = walk
        self._folder = media
        self._at: int | None = None
        self._stage: Stage | None = None
        self._rows: dict[str, list[Row]] = {}
        self.field: QLineEdit | None = None
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        hear_as(self, QAccessible.Role.Canvas)
        self.bring()

    def bring(self) -> None:
        """Shows where the walk is now."""
        self._close_field()
        self._at = None
        self._show()
        texts = [in_text(one.get("text")) for one in self._laid_out().content.components]
        self.setAccessibleDescription(". ".join(filter(None, (self.walk.said, *texts))))

    def _show(self) -> None:
        walk = self.walk
        self._stage = None
        self.show_screen(self._theme, walk.screen, walk.above, self._folder, walk.shown)
        self.walked.emit()

    def show_device(self, device: QSize) -> None:
        self._stage = None
        super().show_device(device)

    # -- what can be pressed -------------------------------------------------------------

    def targets(self) -> list[Target]:
        """In the order in which they lie, back to front."""
        found: list[Target] = []
        for one in self.walk.seen:
            if isinstance(one, rbd.List):
                count = len(self._shown(one.id)["items"] or ())
                found += [(one, at) for at in range(count)]
            elif isinstance(one, rbd.Button | rbd.Input) or _ends(one):
                found.append((one, -1))
        return found

    def area(self, target: Target) -> QRectF:
        """Where it lies in the widget, px; empty for a row that is not seen."""
        component, at = target
        if at < 0:
            return Scale(QSizeF(self.size())).area(placing.box_of(component))
        every = self._rows_of(component.id)
        return self._scaled(every[at].box) if at < len(every) else QRectF()

    def target_at(self, spot: QPointF) -> Target | None:
        """The uppermost one there."""
        for target in reversed(self.targets()):
            if self.area(target).contains(spot):
                return target
        return None

    def _laid_out(self) -> Stage:
        # Asked for at each move of the mouse, for every row of a list.
        if self._stage is None:
            walk = self.walk
            every = content(walk.screen, walk.above, walk.shown)
            self._stage, self._rows = Stage(layer(self.device), every, None), {}
        return self._stage

    def _shown(self, id: str) -> Shown:
        return next(one for one in self._laid_out().content.components if one["id"] == id)

    def _rows_of(self, id: str) -> list[Row]:
        stage, one = self._laid_out(), self._shown(id)
        if id not in self._rows:
            self._rows[id] = rows(stage, one)
        return self._rows[id]

    def _scaled(self, box: QRectF) -> QRectF:
        size = layer(self.device)
        across, down = self.width() / size.width(), self.height() / size.height()
        return QRectF(box.x() * across, box.y() * down, box.width() * across, box.height() * down)

    # -- what is done --------------------------------------------------------------------

    def press(self, target: Target) -> None:
        """As a finger does."""
        component, at = target
        walk = self.walk
        match component:
            case rbd.Button():
                self._do(lambda: walk.press(component))
            case rbd.Movie(failed=None):
                self._do(lambda: walk.end(component))
            case rbd.Movie():
                self._ask_how(component, self.area(target))
            case rbd.List():
                entry: Any = self._shown(component.id)["items"][at]["value"]
                self._do(lambda: walk.choose(component, entry))
            case rbd.Input():
                self._at = self.targets().index(target)
                self._open_field(component)
            case _:
                pass

    def _ask_how(self, movie: rbd.Movie, area: QRectF) -> None:
        """A movie that says what happens where it can not be played: well or badly?"""
        walk = self.walk
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        for words, event, then in (
            (self.tr("The movie ends"), movie.done, walk.end),
            (self.tr("The movie can not be played"), movie.failed, walk.fail),
        ):
            chosen = menu.addAction(f"{words}  ›  {walk.leads(event)}".replace("&", "&&"))
            chosen.triggered.connect(partial(self._do, partial(then, movie)))
        at = self.mapToGlobal(area.center().toPoint())
        menu.popup(at - QPoint(menu.sizeHint().width() // 2, 0))
        menu.setActiveAction(menu.actions()[0])

    def _do(self, what: Callable[[], None]) -> None:
        what()
        self.bring()

    def _open_field(self, component: rbd.Input) -> None:
        self._close_field()
        stage, one = self._laid_out(), self._shown(component.id)
        text = in_text(one.get("value"))
        room, _ = rooms(stage, one, text)
        zoom = self.width() / stage.size.width()
        field = QLineEdit(text, self)
        field.setAccessibleName(component.tag)
        field.setFrame(False)
        if component.max is not None:
            field.setMaxLength(component.max)
        if component.kind == "pin":
            field.setEchoMode(QLineEdit.EchoMode.Password)
        tall = max(8, round(letters(stage, one, room) * zoom))
        field.setAlignment(_WAYS[component.align or "left"])
        # The robot's screen is light in both themes.
        ink = LIGHT.color("text").name()
        field.setStyleSheet(
            f"QLineEdit {{ background: white; color: {ink}; border: none; padding: 0;"
            f" font-size: {tall}px; font-weight: 500; min-height: 0; max-height: {MOST}px; }}"
        )
        field.setGeometry(self._scaled(room).adjusted(0, 4, 0, -4).toRect())
        field.selectAll()
        field.textEdited.connect(lambda typed: self._on_typed(component, typed))
        field.returnPressed.connect(lambda: self._do(lambda: self.walk.enter(component)))
        self.field = field
        field.show()
        field.setFocus()

    def _on_typed(self, component: rbd.Input, text: str) -> None:
        full = self.walk.type(component, text)
        if full and component.event:
            self._do(lambda: self.walk.enter(component))
            return
        self._show()

    def _close_field(self) -> None:
        field, self.field = self.field, None
        if field is not None:
            # Before it goes, or Qt looks for another place for the focus.
            self.setFocus()
            field.hide()
            field.deleteLater()

    # -- mouse and keys ------------------------------------------------------------------

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        hand = Qt.CursorShape.PointingHandCursor
        over = self.target_at(event.position()) is not None
        self.setCursor(hand if over else Qt.CursorShape.ArrowCursor)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton:
            return
        target = self.target_at(event.position())
        if target is not None:
            self.press(target)
        elif self.rect().contains(event.position().toPoint()):
            self._do(self.walk.touch)

    def focusNextPrevChild(self, next: bool) -> bool:
        """Through what can be pressed, then on to what follows."""
        self._close_field()
        order = list(self._order())
        at = -1 if self._at is None else order.index(self._at) if self._at in order else -1
        if at < 0 and not next:
            at = len(order)
        at += 1 if next else -1
        if not 0 <= at < len(order):
            self._at = None
            self.update()
            return super().focusNextPrevChild(next)
        self._at = order[at]
        # A reader tells it again whenever it changes: of the way only where it leads.
        self.setAccessibleDescription(self._words(self.targets()[self._at]))
        self.update()
        return True

    def _words(self, target: Target) -> str:
        """What a target is called, as it is shown now."""
        component, at = target
        if at >= 0:
            return in_text(self._shown(component.id)["items"][at]["label"])
        return in_text(self._shown(component.id).get("text")) or called(component)

    def _order(self) -> Iterator[int]:
        """The targets that are seen, as one reads them."""
        every = self.targets()
        seen = [(self.area(one), at) for at, one in enumerate(every)]
        for area, at in sorted(seen, key=lambda one: (one[0].top(), one[0].left())):
            if not area.isEmpty():
                yield at

    def keyPressEvent(self, event: QKeyEvent) -> None:
        keys = (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space)
        if event.key() in keys and self._at is not None:
            self.press(self.targets()[self._at])
        else:
            super().keyPressEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        every = self.targets()
        if self._at is None or self._at >= len(every) or not self.hasFocus():
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(LIGHT.color("accent"), 3))
        painter.drawRoundedRect(self.area(every[self._at]).adjusted(-3, -3, 3, 3), 8, 8)
        painter.end()


def _ends(component: rbd.Component) -> bool:
    """Whether it is a movie whose end, good or bad, raises something."""
    return isinstance(component, rbd.Movie) and bool(component.done or component.failed)
