"""The screen of the selected state, beside its graph: what people see and hear there."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtGui import QAccessible, QPainter
from PySide6.QtWidgets import QFrame, QLabel, QScrollArea, QVBoxLayout, QWidget

from situ.document import rbd
from situ.document.problem import Problem
from situ_studio.assistive.heard_as import hear_as
from situ_studio.edits import words
from situ_studio.edits.edit import Place
from situ_studio.looks.letters import px
from situ_studio.looks.theme import LIGHT, Theme
from situ_studio.screens import guides, marks
from situ_studio.screens.sheet import Sheet
from situ_studio.screens.snapping import Snap
from situ_studio.screens.state_screen import StateScreen
from situ_studio.widgets.layouts import clear


class ScreenBeside(QScrollArea):
    """Of what is selected in an application: the screen, at the size there is, and the speech.

    While nothing is selected that has a screen, the one before is shown, at first the start's.
    media: the folder of the pictures, at the time of the call.
    """

    selection_changed = Signal(tuple)
    """The places of what was clicked on the screen."""
    edited = Signal(object, str)
    """Another application, and the name of the step."""
    status = Signal(str)
    """What was asked for can not be done: why, in one line."""
    filled_in = Signal(tuple)
    """The place of the component that is to be filled in."""
    media_asked = Signal(tuple, str, object)
    file_asked = Signal(tuple, str, QPoint)
    """As ``StateScreen`` tells them."""
    menu_requested = Signal(tuple, QPoint)
    """A context menu is wanted: of a component, or of the screen, and where on the desktop."""

    def __init__(
        self, theme: Theme, media: Callable[[], Path | None], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setAccessibleName(self.tr("Screen of the selected state"))
        hear_as(self, QAccessible.Role.Grouping)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setMinimumWidth(px(280))
        self.viewport().setProperty("role", "panel")
        page = QWidget()
        page.setProperty("role", "panel")
        column = QVBoxLayout(page)
        column.setContentsMargins(16, 12, 16, 16)
        column.setSpacing(8)
        self.title = QLabel()
        self.title.setProperty("role", "section")
        column.addWidget(self.title)
        self.sheet = _GuidedSheet(theme)
        self._shown = StateScreen(self.sheet, theme, media, self)
        self._shown.selection_changed.connect(self.selection_changed)
        self._shown.edited.connect(self.edited)
        self._shown.status.connect(self.status)
        self._shown.filled_in.connect(self.filled_in)
        self._shown.media_asked.connect(self.media_asked)
        self._shown.file_asked.connect(self.file_asked)
        self._shown.menu_requested.connect(self.menu_requested)
        column.addWidget(self.sheet)
        self._speech = QVBoxLayout()
        self._speech.setSpacing(4)
        column.addLayout(self._speech)
        column.addStretch(1)
        self.setWidget(page)

    def set_theme(self, theme: Theme) -> None:
        self._shown.set_theme(theme)

    def show_document(self, application: rbd.Application, problems: list[Problem]) -> None:
        """Takes a new value, of which ``select`` says what is shown."""
        self._shown.show_document(application, problems)
        self.sheet.guides = guides.of(application)

    def select(self, selected: tuple[Place, ...]) -> None:
        """Shows the screen of the first of these that has one, as it is now."""
        self._shown.select(selected)
        application, part = self._shown.application, self._shown.part
        if application is None:
            return
        if isinstance(part, rbd.State):
            self.title.setText(words.state_words(application, part.no))
        else:
            self.title.setText(self.tr("In every state"))
        clear(self._speech)
        for text in self.texts:
            said = QLabel(self.tr("“{0}”").format(text))
            said.setTextFormat(Qt.TextFormat.PlainText)
            said.setProperty("role", "dim")
            said.setWordWrap(True)
            self._speech.addWidget(said)

    def offer_tags(self, tags: tuple[str, ...]) -> None:
        """What ``{`` completes in a text that is edited in place."""
        self.sheet.offer_tags(tags)

    @property
    def texts(self) -> list[str]:
        """What is said there, a line a speech."""
        part = self._shown.part
        actions = part.actions if isinstance(part, rbd.State) else ()
        return [one.text for one in actions if isinstance(one, rbd.Speech) and one.text]


class _GuidedSheet(Sheet):
    """Shows guides, which are put and moved in the designer."""

    def paint_marks(self) -> None:
        painter = QPainter(self)
        upright = tuple(one.at for one in self.guides if one.axis == "x")
        lying = tuple(one.at for one in self.guides if one.axis == "y")
        # The robot's screen is light in both themes.
        marks.paint_guides(painter, LIGHT, self.scale, Snap(0, 0, upright, lying))
        painter.end()
        super().paint_marks()
