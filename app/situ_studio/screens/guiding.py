"""Guides in the designer: drawn out of the rulers, moved and removed, by mouse and keys."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QPointF, QRect, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QWidget

from situ.document.rbd import Application
from situ_studio.assistive.tab_order import BEHIND
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.screens import guides as of_screens
from situ_studio.screens import snapping
from situ_studio.screens.device_ground import DeviceGround
from situ_studio.screens.guide_lines import ROOM, GuideLine
from situ_studio.screens.guides import Axis, Guide, Guides
from situ_studio.screens.sheet import Sheet

NEAR = 4.0
"""Px from a guide at which the mouse takes it."""
PRESSES = (QEvent.Type.MouseButtonPress, QEvent.Type.MouseButtonDblClick)


class Guiding(QObject):
    """Of one designer. What a drag paints is a proposal; letting go is the one edit."""

    edited = Signal(object, str)
    """Another application, and the name of the step."""

    def __init__(self, sheet: Sheet, ground: DeviceGround, theme: Theme) -> None:
        super().__init__(ground)
        self._sheet, self._ground, self._theme = sheet, ground, theme
        self._application: Application | None = None
        self._lines: list[GuideLine] = []
        self._wanted: Guide | None = None
        self._held: Guide | None = None
        """The one that goes with the mouse, as it was before; a new one is not there yet."""
        self._proposed: Guide | None = None
        self._dragging = False
        self._new = False
        for one in (sheet, ground, *ground.rulers):
            one.installEventFilter(self)
        # So the mouse shows beside the screen, too, what it would take.
        ground.setMouseTracking(True)
        ground.laid_out.connect(self._lay_out)

    # -- what is shown -------------------------------------------------------------------

    @property
    def guides(self) -> Guides:
        return of_screens.of(self._application) if self._application is not None else ()

    @property
    def lines(self) -> tuple[GuideLine, ...]:
        """What is seen, in the order of the guides; a new one that is dragged is the last."""
        return tuple(self._lines)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        for line in self._lines:
            line.set_theme(theme)

    def show_document(self, application: Application) -> None:
        """Shows the guides of an application; a drag ends where it is another one."""
        if application is not self._application:
            self._end()
        self._application = application
        self._show()

    def _show(self) -> None:
        shown = list(self.guides)
        if self._dragging:
            if self._held is not None and not self._new:
                shown.remove(self._held)
            if self._proposed is not None:
                shown.append(self._proposed)
        focus = next((line.guide for line in self._lines if line.hasFocus()), None)
        wanted, self._wanted = self._wanted or focus, None
        if focus and wanted not in shown and len(shown) < len(self._lines) and not self._dragging:
            # Undone: the keys are no other guide's then.
            self._sheet.setFocus()
        while len(self._lines) > len(shown):
            gone = self._lines.pop()
            if gone.hasFocus():
                self._sheet.setFocus()
            gone.hide()
            gone.deleteLater()
        while len(self._lines) < len(shown):
            self._lines.append(self._line())
        for line, guide in zip(self._lines, shown, strict=True):
            line.show_guide(guide, self._dragging and guide is self._proposed)
            if guide == wanted and not line.hasFocus():
                line.setFocus()
        self._sheet.guides = tuple(shown)
        for ruler in self._ground.rulers:
            ruler.show_guides(tuple(shown))
        self._lay_out()

    def _line(self) -> GuideLine:
        line = GuideLine(self._theme, self._ground)
        line.moved.connect(self._on_moved)
        line.removed.connect(self._on_removed)
        line.left.connect(self._on_left)
        line.setProperty(BEHIND, self._sheet)
        return line

    def _lay_out(self) -> None:
        room, sheet, wide = self._ground.room, self._sheet.geometry(), px(ROOM)
        for line in self._lines:
            guide = line.guide
            if guide.axis == "x":
                middle = sheet.left() + sheet.width() * guide.at / 100
                place = QRect(round(middle) - wide // 2, room.top(), wide, room.height())
            else:
                middle = sheet.top() + sheet.height() * guide.at / 100
                place = QRect(room.left(), round(middle) - wide // 2, room.width(), wide)
            line.lie(place, self._ground.lit)
            line.setVisible(not self._sheet.isHidden())
            line.raise_()

    # -- what is done --------------------------------------------------------------------

    def add(self, axis: Axis) -> None:
        """A new guide in the middle, or beside the one there: it has the focus then."""
        guide = of_screens.free(self.guides, axis)
        self._tell((*self.guides, guide), self.tr("Add a guide"), guide)

    def clear(self) -> None:
        self._tell((), self.tr("Remove all guides"))

    def _on_moved(self, guide: Guide, by: float) -> None:
        self._move(guide, of_screens.at(guide.axis, guide.at + by))

    def _move(self, guide: Guide, to: Guide) -> None:
        left = tuple(one for one in self.guides if one != guide)
        self._tell((*left, to), self.tr("Move a guide"), to)

    def _on_left(self) -> None:
        """Escape gives up a drag, and else leaves the guide."""
        if self._dragging:
            self._end()
            self._show()
        else:
            self._sheet.setFocus()

    def _on_removed(self, guide: Guide) -> None:
        left = tuple(one for one in self.guides if one != guide)
        self._sheet.setFocus()
        self._tell(left, self.tr("Remove a guide"))

    def _tell(self, guides: Guides, text: str, wanted: Guide | None = None) -> None:
        """wanted: which one has the focus then."""
        if self._application is None:
            return
        after = of_screens.put(self._application, guides)
        self._wanted = wanted
        if after is not self._application:
            self.edited.emit(after, text)
        self._show()

    # -- the mouse -----------------------------------------------------------------------

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QKeyEvent):
            escape = event.key() == Qt.Key.Key_Escape and self._dragging
            if escape:
                # Asked whether it is a shortcut's, and pressed: both are the drag's.
                event.accept()
                if event.type() == QEvent.Type.KeyPress:
                    self._end()
                    self._show()
            return escape
        if not isinstance(event, QMouseEvent) or not isinstance(watched, QWidget):
            return False
        at = QPointF(watched.mapTo(self._ground, event.position().toPoint()))
        kind, free = event.type(), bool(event.modifiers() & Qt.KeyboardModifier.AltModifier)
        if kind in PRESSES and event.button() == Qt.MouseButton.LeftButton:
            return self._press(watched, at)
        if kind == QEvent.Type.MouseMove and self._dragging:
            return self._drag(at, free)
        if kind == QEvent.Type.MouseMove:
            # With a button held it is something else that goes with the mouse.
            return not event.buttons() and self._hover(watched, at)
        if kind == QEvent.Type.MouseButtonRelease and self._dragging:
            self._release()
            return True
        return False

    def under(self, watched: QWidget, at: QPointF) -> Guide | None:
        """The guide that is taken at a place of the ground: a component or handle goes before."""
        sheet = self._sheet
        if watched is not sheet and watched is not self._ground:
            return None
        near = {one: abs(self._away(one, at)) for one in self.guides}
        nearest = min(near, key=lambda one: near[one], default=None)
        if nearest is None or near[nearest] > NEAR:
            return None
        here = at - QPointF(sheet.pos())
        if watched is sheet and (sheet.handle_under(here) or sheet.under(here)):
            return None
        return nearest

    def _away(self, guide: Guide, at: QPointF) -> float:
        sheet = self._sheet.geometry()
        if guide.axis == "x":
            return at.x() - sheet.left() - sheet.width() * guide.at / 100
        return at.y() - sheet.top() - sheet.height() * guide.at / 100

    def _hover(self, watched: QWidget, at: QPointF) -> bool:
        """The mouse shows what it would take."""
        guide = self.under(watched, at)
        if guide is not None:
            watched.setCursor(_cursor(guide.axis))
            return True
        if watched is self._ground:
            watched.unsetCursor()
        return False

    def _press(self, watched: QWidget, at: QPointF) -> bool:
        if self._application is None or self._sheet.isHidden():
            return False
        ruler = next((one for one in self._ground.rulers if one is watched), None)
        guide = self.under(watched, at)
        if ruler is None and guide is None:
            return False
        self._dragging, self._new = True, ruler is not None
        if ruler is not None:
            self._sheet.setFocus()
            # What is drawn down from the ruler above lies.
            self._held, self._proposed = Guide("y" if ruler.axis == "x" else "x", 0.0), None
        else:
            self._held = self._proposed = guide
            next(line for line in self._lines if line.guide == guide).setFocus()
        self._show()
        return True

    def _drag(self, at: QPointF, free: bool) -> bool:
        assert self._held is not None
        axis, sheet = self._held.axis, self._sheet
        if self._over_ruler(axis, at):
            self._proposed = None
        else:
            x, y = sheet.scale.percent(at - QPointF(sheet.pos()))
            value = x if axis == "x" else y
            boxes = sheet.others(())
            self._proposed = of_screens.at(
                axis, value if free else snapping.guided(axis, value, boxes)
            )
        self._show()
        return True

    def _over_ruler(self, axis: Axis, at: QPointF) -> bool:
        room = self._ground.room
        if axis == "x":
            return at.x() < room.left() or at.x() > room.right()
        return at.y() < room.top() or at.y() > room.bottom()

    def _release(self) -> None:
        held, proposed, new = self._held, self._proposed, self._new
        self._end()
        assert held is not None
        if proposed is None and not new:
            self._on_removed(held)
        elif proposed is not None and new:
            self._tell((*self.guides, proposed), self.tr("Add a guide"), proposed)
        elif proposed is not None and proposed != held:
            self._move(held, proposed)
        else:
            self._show()

    def _end(self) -> None:
        self._held = self._proposed = None
        self._dragging = self._new = False


def _cursor(axis: Axis) -> Qt.CursorShape:
    return Qt.CursorShape.SplitHCursor if axis == "x" else Qt.CursorShape.SplitVCursor
