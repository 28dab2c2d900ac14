"""The screen on which components are placed: what is selected, proposed and told of it.

``hand`` is the mouse on it, ``keyboard`` the keys, ``writing`` the text that is edited in place,
``marks`` what is painted over it, ``problem_marks`` what is wrong there, ``accessible`` what a
screen reader finds.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from pathlib import Path

from PySide6.QtCore import QEvent, QPoint, QPointF, QRectF, QSize, QSizeF, Qt, Signal
from PySide6.QtGui import (
    QContextMenuEvent,
    QDragEnterEvent,
    QDragMoveEvent,
    QDropEvent,
    QFocusEvent,
    QHelpEvent,
    QInputMethodEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QResizeEvent,
)
from PySide6.QtWidgets import QToolTip, QWidget

from situ.document import rbd
from situ_studio.assistive.announcing import announce
from situ_studio.kinds import COMPONENTS, MIME
from situ_studio.looks.theme import LIGHT, Theme
from situ_studio.panels.preview import ScreenPreview
from situ_studio.screens import accessible, keyboard, marks, placing
from situ_studio.screens.devices import USUAL, Device
from situ_studio.screens.drags import Proposal
from situ_studio.screens.guides import Guides
from situ_studio.screens.hand import Hand
from situ_studio.screens.placing import Box
from situ_studio.screens.problem_marks import ProblemMarks, Told
from situ_studio.screens.resting import Resting
from situ_studio.screens.shown import Values
from situ_studio.screens.telling import told_placed
from situ_studio.screens.writing import Writing


class Sheet(ScreenPreview):
    """A screen whose components a person places.

    What is painted while something is dragged is a proposal: the document is another one when the
    mouse is let go, in one step. Components that Always adds are shown, not touched.
    """

    chosen = Signal(tuple)
    """The ids of the components that a person selected; () is the screen itself."""
    edited = Signal(object, str)
    """Another screen, and the name of the step."""
    dropped = Signal(str, float, float)
    """A kind of component was dropped: its name, and where its middle shall be."""
    opened = Signal(str)
    """The component is to be filled in: Enter, or a double click where there is no text."""
    menu_asked = Signal(QPoint)
    """A context menu is wanted, of what is selected, there on the desktop."""

    spoken_as: accessible.AccessibleSheet | None = None
    """What screen readers find, since one asked."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        accessible.install()
        super().__init__(theme, parent)
        self.setAccessibleName(self.tr("Screen"))
        self.setAccessibleDescription(
            self.tr("Tab goes from component to component, arrows move one, F2 writes its text.")
        )
        self._chosen: tuple[str, ...] = ()
        self._proposal: Proposal | None = None
        self._proposed: rbd.Screen | None = None
        self._boxes: tuple[rbd.Screen | None, dict[str, Box]] = None, {}
        self._resting: Resting | None = None
        self._kept: rbd.Screen | None = None
        """The screen of the document, while what is proposed is painted in its place."""
        self._all_above: tuple[rbd.Component, ...] = ()
        self._shows_above = True
        self.invitation = ""
        """What there is to do, where nothing is on the screen yet."""
        self.looked_at = USUAL
        """Whose millimetres are told."""
        self.guides: Guides = ()
        """Those that a person has put there, where they are seen."""
        self._hand = Hand(self)
        self.writing = Writing(self)
        self.problems = ProblemMarks(self)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_InputMethodEnabled)
        self.setMouseTracking(True)
        self.setAcceptDrops(True)
        self.setCursor(Qt.CursorShape.ArrowCursor)

    # -- what is shown -------------------------------------------------------------------

    def show_screen(
        self,
        theme: Theme,
        screen: rbd.Screen | None,
        above: tuple[rbd.Component, ...],
        media: Path | None,
        values: Values | None = None,
    ) -> None:
        """A drag ends where its screen is another one."""
        if screen is not self._screen:
            self._hand.cancel()
        self._all_above = above
        above = above if self._shows_above else ()
        super().show_screen(theme, screen, above, media, values)
        self.writing.follow()
        if self.spoken_as is not None:
            self.spoken_as.on_shown()

    def look_at(self, device: Device) -> None:
        """Shows the screen as it is on that device."""
        self.looked_at = device
        self.show_device(QSize(device.wide, device.high))

    def show_always(self, shown: bool) -> None:
        """Whether the components that Always adds are seen, and snapped to."""
        self._shows_above = shown
        self._above = self._all_above if shown else ()
        self.update()

    def show_problems(self, told: Told) -> None:
        """Marks the components that these are about."""
        if told != self.problems.told:
            self.problems.told = told
            self.update()

    def offer_tags(self, tags: tuple[str, ...]) -> None:
        """What ``{`` completes in a text that is edited in place."""
        self.writing.offer(tags)

    def select(self, ids: tuple[str, ...]) -> None:
        """Shows which components are selected."""
        if ids != self._chosen:
            self.writing.take()
            self._chosen = ids
            self.update()
            if self.spoken_as is not None:
                self.spoken_as.on_selected()

    @property
    def screen_shown(self) -> rbd.Screen | None:
        """The screen of the document, without what is proposed."""
        return self._screen

    @property
    def selected(self) -> tuple[str, ...]:
        """The ids of the selected components that are there."""
        return tuple(self.selected_boxes())

    @property
    def proposal(self) -> Proposal | None:
        """What is painted in place of the document, while something is dragged."""
        return self._proposal

    @property
    def colours(self) -> Theme:
        return self._theme

    # -- what is done --------------------------------------------------------------------

    def choose(self, ids: tuple[str, ...]) -> None:
        """Selects components as a person does."""
        self.select(ids)
        self.chosen.emit(ids)

    def select_all(self) -> None:
        self.choose(tuple(self.own()))

    def align(self, edge: str) -> None:
        """Places what is selected, as ``placing.aligned`` says."""
        self.place(placing.aligned(self.selected_boxes(), edge), self.tr("Align {0}"))

    def place(self, boxes: Mapping[str, Box], text: str) -> None:
        """Components lie there now. text: the name of the step, {0} are those selected."""
        if self._screen is not None:
            after = placing.placed(self._screen, boxes)
            self.tell(after, text)
            announce(self, told_placed(after, boxes, self.looked_at))

    def tell(self, after: rbd.Screen, text: str) -> None:
        """The screen is another one; nothing where it is the very same."""
        if after is not self._screen:
            self.edited.emit(after, text.format(", ".join(self.selected)))

    def open(self, id: str) -> None:
        """Opens a component's text, or its form where it has none."""
        if not self.writing.begin(id):
            self.opened.emit(id)

    def propose(self, proposal: Proposal | None) -> None:
        """Paints components where they would lie; None: where they do."""
        self._proposal = self._proposed = None
        if proposal is None:
            self._resting = None
        if proposal is not None and self._screen is not None:
            self._proposal = proposal
            self._proposed = placing.placed(self._screen, proposal.boxes)
        self.update()

    # -- measures ------------------------------------------------------------------------

    @property
    def scale(self) -> marks.Scale:
        return marks.Scale(QSizeF(self.size()))

    def own(self) -> dict[str, Box]:
        """The boxes of the screen's own components, back to front."""
        screen = self._screen
        if screen is None:
            return {}
        # Asked for many times between two edits.
        if self._boxes[0] is not screen:
            self._boxes = screen, {c.id: placing.box_of(c) for c in screen.components}
        return self._boxes[1]

    def selected_boxes(self) -> dict[str, Box]:
        own = self.own()
        return {id: own[id] for id in self._chosen if id in own}

    def others(self, ids: Collection[str]) -> list[Box]:
        """The boxes of everything on the screen but these."""
        found = [box for id, box in self.own().items() if id not in ids]
        return found + [placing.box_of(c) for c in self._above]

    def component(self, id: str) -> rbd.Component | None:
        """One of the screen's own components."""
        every = self._screen.components if self._screen is not None else ()
        return next((c for c in every if c.id == id), None)

    def area(self, box: Box) -> QRectF:
        """Where a box lies in the widget, px."""
        return self.scale.area(box)

    def handle_at(self, name: str) -> QPointF:
        """The middle of a handle of what is selected."""
        return self.scale.handle(name, placing.around(self.selected_boxes().values()))

    def handle_under(self, at: QPointF) -> str:
        """The handle there; "" where there is none."""
        if self.selected_boxes():
            for name in placing.HANDLES:
                if (self.handle_at(name) - at).manhattanLength() <= marks.GRIP:
                    return name
        return ""

    def under(self, at: QPointF) -> list[str]:
        """The components there, the uppermost one first."""
        return [id for id, box in reversed(self.own().items()) if self.area(box).contains(at)]

    # -- events --------------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self._hand.press(event.position(), event.modifiers())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        self._hand.move(event.position(), event.modifiers())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self._hand.release()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self._hand.double(event.position())

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        if event.reason() == QContextMenuEvent.Reason.Mouse:
            under = self.under(QPointF(event.pos()))
            if not under:
                self.choose(())
            elif not set(under) & set(self.selected):
                self.choose((under[0],))
            self.menu_asked.emit(event.globalPos())

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        event.setAccepted(_component_in(event) != "")

    def dragMoveEvent(self, event: QDragMoveEvent) -> None:
        event.setAccepted(_component_in(event) != "")

    def dropEvent(self, event: QDropEvent) -> None:
        name = _component_in(event)
        if name:
            event.setDropAction(Qt.DropAction.CopyAction)
            event.accept()
            self.setFocus()
            self.dropped.emit(name, *self.scale.percent(event.position()))

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            words = self.problems.words_at(QPointF(event.pos()))
            if words:
                QToolTip.showText(event.globalPos(), words, self)
                return True
        if isinstance(event, QKeyEvent):
            # What is done with a component here is not done with its state on the graph.
            if event.type() == QEvent.Type.ShortcutOverride and keyboard.takes(self, event):
                event.accept()
                return True
            # Before Qt moves the focus by Tab.
            if event.type() == QEvent.Type.KeyPress and keyboard.step(self, event):
                return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape and self._hand.cancel():
            return
        if not keyboard.press(self, event):
            super().keyPressEvent(event)

    def inputMethodEvent(self, event: QInputMethodEvent) -> None:
        # Somebody begins to write with an input method, as one does in Japanese.
        if not self.writing.compose(event):
            super().inputMethodEvent(event)

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        self.update()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.writing.settle()

    def menu_corner(self) -> QPoint:
        """Where a context menu of what is selected stands, on the desktop."""
        boxes = self.selected_boxes()
        at = self.area(placing.around(boxes.values())).center() if boxes else self.rect().center()
        return self.mapToGlobal(QPointF(at).toPoint())

    # -- painting ------------------------------------------------------------------------

    def paintEvent(self, event: QPaintEvent) -> None:
        kept = self._kept = self._screen
        self._screen = self._proposed if self._proposed is not None else kept
        try:
            super().paintEvent(event)
            self.paint_marks()
        finally:
            self._screen, self._kept = kept, None

    def nothing(self) -> str:
        return self.invitation

    def paint_screen(self, painter: QPainter, rect: QRectF, screen: rbd.Screen) -> None:
        """What is not dragged is painted once in a drag, while no sizes change."""
        before, proposal = self._kept, self._proposal
        if before is None or proposal is None or not self._hand.moves:
            super().paint_screen(painter, rect, screen)
            return
        if self._resting is None:
            shown, count = self.content_of(before), len(before.components)
            self._resting = Resting(shown, count, proposal.boxes, self._media, self._device)
        self._resting.paint(painter, rect, self.content_of(screen))

    def paint_marks(self) -> None:
        """Paints what stands on the screen that is seen, with what is proposed."""
        # The robot's screen is light in both themes, and so is what stands on it.
        painter, theme, scale = QPainter(self), LIGHT, self.scale
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        boxes = self.selected_boxes()
        if self._proposal is not None:
            marks.paint_guides(painter, theme, scale, self._proposal.snap)
        if not self.writing.is_open:
            dragged = self._proposal is not None
            marks.paint_selection(painter, theme, scale, list(boxes.values()), not dragged)
        if self._proposal is not None:
            marks.paint_gaps(painter, theme, scale, self._proposal.gaps)
        if boxes and not self.writing.is_open:
            components = [c for id in boxes if (c := self.component(id)) is not None]
            whole = placing.around(boxes.values())
            text = marks.measured(whole, components, self.looked_at)
            marks.paint_badge(painter, theme, scale, whole, text, self._proposal is not None)
        if self._proposal is None and not self.writing.is_open:
            self.problems.paint(painter)
        if self._kept == rbd.Screen():
            painter.setPen(theme.color("text3"))
            wrapped = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
            painter.drawText(self.rect(), int(wrapped), self.invitation)
        if self._hand.band is not None:
            marks.paint_band(painter, theme, scale, self._hand.band)
        if self.hasFocus() and not boxes:
            marks.paint_focus(painter, theme, scale)
        painter.end()


def _component_in(event: QDropEvent) -> str:
    """The kind of component that is dragged; "" for anything else."""
    name = bytes(event.mimeData().data(MIME).data()).decode()
    return name if any(kind.name == name for kind in COMPONENTS) else ""
