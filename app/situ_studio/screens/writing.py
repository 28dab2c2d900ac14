"""The text of a component, written where it stands on the screen."""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

from msgspec.structs import replace
from PySide6.QtCore import QCoreApplication, QEvent, QRect, QSize, Qt, Signal
from PySide6.QtGui import QFocusEvent, QFont, QInputMethodEvent, QKeyEvent, QTextOption
from PySide6.QtWidgets import QPlainTextEdit, QWidget

from situ.document import rbd
from situ_studio import kinds
from situ_studio.looks.theme import FAMILIES, Theme
from situ_studio.panels.fields import Paragraph
from situ_studio.screens.component_painting import Stage, style_of
from situ_studio.screens.measures import measures
from situ_studio.screens.painting import layer
from situ_studio.screens.placing import box_of
from situ_studio.screens.shown import content
from situ_studio.wording.language import translated

if TYPE_CHECKING:
    from situ_studio.screens.sheet import Sheet

ATTRIBUTES: dict[type[rbd.Component], str] = {
    rbd.Text: "text",
    rbd.Button: "text",
    rbd.List: "label",
}
"""What of a component is written on it, by its kind."""
ITEM = "item"
"""In a list's label: the entry."""
READABLE = 11
"""Px that letters have at least while they are written."""
EDGE = 2
"""Width of the line round what is written, px."""
_SIDES = {
    "left": Qt.AlignmentFlag.AlignLeft,
    "center": Qt.AlignmentFlag.AlignHCenter,
    "right": Qt.AlignmentFlag.AlignRight,
}
_BETWEEN = (Qt.FocusReason.PopupFocusReason, Qt.FocusReason.ActiveWindowFocusReason)


class Writing:
    """At most one text of a sheet is written at a time; that it is another one is one step."""

    def __init__(self, sheet: Sheet) -> None:
        self._sheet = sheet
        self._tags: tuple[str, ...] = ()
        self._id = ""
        self.field: Words | None = None

    @property
    def is_open(self) -> bool:
        return self.field is not None

    def offer(self, tags: tuple[str, ...]) -> None:
        """The tags that ``{`` completes."""
        self._tags = tags

    def begin(self, id: str, instead: str | None = None) -> bool:
        """Opens the text of a component; False where it has none.

        instead: what is in the field at first, the cursor behind it; else all of the text is
        selected.
        """
        component = self._sheet.component(id)
        if component is None or type(component) not in ATTRIBUTES:
            return False
        self.take()
        self._id = id
        text = str(getattr(component, ATTRIBUTES[type(component)]))
        self.field = Words(component, self._sheet)
        self.field.complete_tags(
            (ITEM, *self._tags) if isinstance(component, rbd.List) else self._tags
        )
        self.field.show_value(text)
        self.field.selectAll()
        if instead is not None:
            self.field.insertPlainText(instead)
        self.field.committed.connect(self._on_committed)
        self.field.left.connect(self.end)
        self.settle()
        self.field.show()
        self.field.setFocus()
        self._sheet.update()
        return True

    def compose(self, event: QInputMethodEvent) -> bool:
        """An input method begins to write on the only selected component; whether it can."""
        selected = self._sheet.selected
        # It says too that there is nothing, as when the focus comes.
        says = bool(event.preeditString() or event.commitString())
        if not says or len(selected) != 1 or not self.begin(selected[0], ""):
            return False
        assert self.field is not None
        QCoreApplication.sendEvent(self.field, event)
        return True

    def settle(self) -> None:
        """The field lies over its component, its letters as large as they are on it."""
        component = self._sheet.component(self._id)
        if self.field is not None and component is not None:
            self.field.dress(self._sheet.colours, *_letters(self._sheet, component))
            self.field.lie(self._sheet.area(box_of(component)).toRect())

    def follow(self) -> None:
        """The screen is another one: the field is over the component's place there, if any."""
        if self.field is not None and self._sheet.component(self._id) is None:
            self.end()
        self.settle()

    def take(self) -> None:
        """Takes what was written until now, and ends."""
        if self.field is not None:
            self.field.finish_writing()

    def end(self) -> None:
        """Takes the field away; what is in it is forgotten unless it was told."""
        field, self.field = self.field, None
        if field is not None:
            had_focus = field.hasFocus()
            # It tells nothing more, though it loses the focus.
            field.blockSignals(True)
            field.hide()
            field.deleteLater()
            if had_focus:
                self._sheet.setFocus()
            self._sheet.update()

    def _on_committed(self, text: str) -> None:
        sheet, screen = self._sheet, self._sheet.screen_shown
        component = sheet.component(self._id)
        if screen is None or component is None:
            return
        attribute = ATTRIBUTES[type(component)]
        # As a file has it.
        text = text.strip()
        if isinstance(component, rbd.List):
            text = text or f"{{{ITEM}}}"
        after = tuple(
            replace(c, **{attribute: text}) if c is component else c for c in screen.components
        )
        if getattr(component, attribute) != text:
            step = sheet.tr("Change text of {0}").format(component.id)
            sheet.edited.emit(replace(screen, components=after), step)


def _letters(sheet: Sheet, component: rbd.Component) -> tuple[float, int]:
    """How high the letters of a component are as it is painted, px, and their weight."""
    assert sheet.screen_shown is not None
    stage = Stage(layer(sheet.device), content(sheet.screen_shown), None)
    scale = sheet.width() / stage.size.width()
    if isinstance(component, rbd.List):
        size = component.size or measures()["list-size"]
        return size * stage.unit * scale, int(measures()["list-weight"])
    one = next(c for c in stage.content.components if c["id"] == component.id)
    return stage.fitted(one).size * scale, style_of(one).weight


class Words(Paragraph):
    """A text as large as on the screen. Enter and leaving it take it, Shift+Enter begins a line
    where there can be several, Esc leaves what was.
    """

    left = Signal()
    """Nobody writes any more."""

    def __init__(self, component: rbd.Component, parent: QWidget) -> None:
        self._room = QSize()
        super().__init__(parent)
        self._several = isinstance(component, rbd.Text)
        kind = kinds.kind_of(component)
        title = translated(kind.title) if kind is not None else component.element
        self.setAccessibleName(self.tr("Text of {0} {1}").format(title.lower(), component.id))
        self.setTabChangesFocus(False)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        usual = "center" if isinstance(component, rbd.Button) else "left"
        option = QTextOption(_SIDES[component.align or usual])
        option.setWrapMode(QTextOption.WrapMode.WordWrap)
        self.document().setDefaultTextOption(option)
        self.document().setDocumentMargin(0)

    def dress(self, theme: Theme, letters: float, weight: int) -> None:
        """letters: their height, px. The ground is the screen's own in both themes."""
        ink, paper, accent = (measures().colour(n).name() for n in ("ink", "paper", "accent"))
        made = QFont()
        made.setFamilies(FAMILIES)
        made.setPixelSize(max(READABLE, round(letters)))
        made.setWeight(QFont.Weight(weight))
        self.setFont(made)
        self.setStyleSheet(
            f"QPlainTextEdit {{ background: {paper}; color: {ink}; padding: 0; border-radius: 4px;"
            f" border: {EDGE}px solid {theme.accent};"
            f" font-size: {made.pixelSize()}px; font-weight: {weight};"
            f" selection-background-color: {accent}; selection-color: {paper}; }}"
        )

    def lie(self, area: QRect) -> None:
        """Covers ``area`` of the sheet; the text stands in its middle."""
        self._room = area.size()
        self.setGeometry(area)
        self.on_size_changed()

    def on_size_changed(self) -> None:
        if self._room.isEmpty():
            return
        high = self.document().size().height() * self.fontMetrics().lineSpacing()
        free = self._room.height() - 2 * EDGE - high
        self.setViewportMargins(EDGE, max(0, int(free / 2)), EDGE, 0)

    def finish_writing(self) -> None:
        self.finish()
        self.left.emit()

    def event(self, event: QEvent) -> bool:
        # Before Qt moves the focus by Tab.
        if self.tags is not None and self.tags.takes(event):
            return True
        tabs = (Qt.Key.Key_Tab, Qt.Key.Key_Backtab)
        if event.type() == QEvent.Type.KeyPress and cast(QKeyEvent, event).key() in tabs:
            self.finish_writing()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        enter = event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter)
        another = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        if event.key() == Qt.Key.Key_Escape:
            self.left.emit()
        elif enter and not (another and self._several):
            self.finish_writing()
        else:
            super().keyPressEvent(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        # A menu, the words that are offered, another window: one comes back from these.
        if event.reason() in _BETWEEN:
            QPlainTextEdit.focusOutEvent(self, event)
            return
        super().focusOutEvent(event)
        self.left.emit()
