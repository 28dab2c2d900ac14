"""The screen of the selected state, beside its graph: what people see and hear there."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtWidgets import QFrame, QLabel, QScrollArea, QVBoxLayout, QWidget

from situ.document import rbd
from situ.document.problem import Problem
from situ_studio import kinds, places, words
from situ_studio.edit import Place
from situ_studio.insert import NotHere, insert
from situ_studio.layouts import clear
from situ_studio.screens import placing
from situ_studio.screens.sheet import Sheet
from situ_studio.theme import Theme


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
    menu_requested = Signal(tuple, QPoint)
    """A context menu is wanted: of a component, or of the screen, and where on the desktop."""

    def __init__(
        self, theme: Theme, media: Callable[[], Path | None], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._theme = theme
        self._application: rbd.Application | None = None
        self._place: Place = ()
        self._media = media
        self.setAccessibleName(self.tr("Screen of the selected state"))
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setMinimumWidth(280)
        self.viewport().setProperty("role", "panel")
        page = QWidget()
        page.setProperty("role", "panel")
        column = QVBoxLayout(page)
        column.setContentsMargins(16, 12, 16, 16)
        column.setSpacing(8)
        self.title = QLabel()
        self.title.setProperty("role", "section")
        column.addWidget(self.title)
        self.sheet = Sheet(theme)
        self.sheet.chosen.connect(self._on_chosen)
        self.sheet.edited.connect(self._on_edited)
        self.sheet.dropped.connect(self._on_dropped)
        self.sheet.opened.connect(lambda id: self.filled_in.emit((*self._place, "screen", id)))
        self.sheet.menu_asked.connect(self._on_menu)
        column.addWidget(self.sheet)
        self._speech = QVBoxLayout()
        self._speech.setSpacing(4)
        column.addLayout(self._speech)
        column.addStretch(1)
        self.setWidget(page)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self._show()

    def show_document(self, application: rbd.Application, problems: list[Problem]) -> None:
        """Takes a new value, of which ``select`` says what is shown."""
        self._application = application

    def select(self, selected: tuple[Place, ...]) -> None:
        """Shows the screen of the first of these that has one, as it is now."""
        application = self._application
        if application is None:
            return
        for place in (*selected, self._place, ("state", application.start_no or "")):
            root = places.root(place)
            if root and isinstance(places.get(application, root), rbd.State | rbd.Always):
                self._place = root
                break
        else:
            self._place = ()
        within = (*self._place, "screen")
        self.sheet.select(tuple(p[-1] for p in selected if p[:-1] == within))
        self._show()

    @property
    def selected_count(self) -> int:
        """How many components are selected on the screen, while it is shown."""
        return len(self.sheet.selected) if not self.isHidden() else 0

    def align(self, edge: str) -> None:
        """edge: as ``placing.aligned`` has it; a single component is aligned with the screen."""
        self.sheet.align(edge)

    @property
    def texts(self) -> list[str]:
        """What is said there, a line a speech."""
        part = self._part()
        actions = part.actions if isinstance(part, rbd.State) else ()
        return [one.text for one in actions if isinstance(one, rbd.Speech) and one.text]

    def _part(self) -> rbd.State | rbd.Always | None:
        if self._application is None or not self._place:
            return None
        found = places.get(self._application, self._place)
        return found if isinstance(found, rbd.State | rbd.Always) else None

    def _show(self) -> None:
        application, part = self._application, self._part()
        if application is None:
            return
        above: tuple[rbd.Component, ...] = ()
        if isinstance(part, rbd.State):
            self.title.setText(words.state_words(application, part.no))
            always = application.always_in(part)
            if always is not None and always.screen is not None:
                above = always.screen.components
        else:
            self.title.setText(self.tr("In every state"))
        self.sheet.setVisible(part is not None)
        screen = part.screen if part is not None else None
        self.sheet.show_screen(self._theme, screen, above, self._media())
        clear(self._speech)
        for text in self.texts:
            said = QLabel(self.tr("“{0}”").format(text))
            said.setTextFormat(Qt.TextFormat.PlainText)
            said.setProperty("role", "dim")
            said.setWordWrap(True)
            self._speech.addWidget(said)

    def _on_chosen(self, ids: tuple[str, ...]) -> None:
        places_ = tuple((*self._place, "screen", id) for id in ids)
        self.selection_changed.emit(places_ or (self._place,))

    def _on_menu(self, at: QPoint) -> None:
        self.menu_requested.emit((*self._place, "screen", *self.sheet.selected[:1]), at)

    def _on_edited(self, screen: rbd.Screen, text: str) -> None:
        if self._application is not None:
            after = places.change(self._application, self._place, screen=screen)
            self.edited.emit(after, text)

    def _on_dropped(self, name: str, x: float, y: float) -> None:
        if self._application is None:
            return
        try:
            after, place, text = insert(self._application, kinds.kind(name), self._place)
        except NotHere as refused:
            self.status.emit(str(refused))
            return
        box = placing.box_of(places.get(after, place))
        box = box._replace(x=round(x - box.width / 2), y=round(y - box.height / 2))
        after = places.change(after, place, **placing.inside(box)._asdict())
        self.edited.emit(after, text)
        self.selection_changed.emit((place,))
