"""The screen of one state on a sheet: which state it is, and what is done to its document."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

from msgspec.structs import replace
from PySide6.QtCore import QObject, QPoint, Signal

from situ.document import rbd
from situ.document.problem import Problem
from situ_studio import kinds
from situ_studio.commands.insert import NotHere, insert
from situ_studio.edits import button_names, places
from situ_studio.edits.edit import Place
from situ_studio.looks.theme import Theme
from situ_studio.screens import placing
from situ_studio.screens.devices import USUAL
from situ_studio.screens.drags import Held, Moving
from situ_studio.screens.media_pictures import picture
from situ_studio.screens.problem_marks import Told, by_screen
from situ_studio.screens.sheet import Sheet
from situ_studio.screens.shown import Values


def lying(
    made: rbd.Component, media: Path | None, at: tuple[float, float] | None, sheet: Sheet | None
) -> rbd.Component:
    """A new component with its middle there, or where it is; a picture in its own shape.

    sheet: of the screen, on which it is drawn to guides and edges as one that is moved.
    """
    box = placing.box_of(made)
    if at is not None:
        box = placing.centred(box, *at)
    shown = picture(media, made.src) if isinstance(made, rbd.Image) else None
    if shown is not None:
        size = shown.whole().size()
        of_screen = USUAL.high / USUAL.wide
        box = placing.shaped(box, size.width() / size.height() * of_screen)
    if at is not None and sheet is not None:
        box = box._replace(x=at[0] - box.width / 2, y=at[1] - box.height / 2)
        box = Moving({"": box}, sheet.others(()), sheet.guides).at(0.0, 0.0, Held()).boxes[""]
    return replace(made, **box._asdict())


class StateScreen(QObject):
    """Of what is selected in an application: the screen, on a sheet.

    While nothing is selected that has a screen, the one before is shown, at first the start's.
    media: the folder of the pictures, at the time of the call. It is a piece of a view
    (``situ_studio.views.table``) but for the widget.
    """

    selection_changed = Signal(tuple)
    """The places of what was clicked on the screen."""
    edited = Signal(object, str)
    """Another application, and the name of the step."""
    status = Signal(str)
    """What was asked for can not be done: why, in one line."""
    media_asked = Signal(tuple, str, object)
    """A picture or movie is wanted for a new component: in which state, of which kind, and where
    its middle shall be, None in free room."""
    file_asked = Signal(tuple, str, QPoint)
    """Another file is wanted: for which component and attribute, and where it is asked."""
    filled_in = Signal(tuple)
    """The place of the component that is to be filled in."""
    menu_requested = Signal(tuple, QPoint)
    """A context menu is wanted: of a component, or of the screen, and where on the desktop."""

    def __init__(
        self, sheet: Sheet, theme: Theme, media: Callable[[], Path | None], parent: QObject
    ) -> None:
        super().__init__(parent)
        self.sheet = sheet
        self.place: Place = ()
        """Of the state, or of Always; () where there is none."""
        self.application: rbd.Application | None = None
        self.values: Values | None = None
        """What references are filled in with at the next ``show``; None: as they are written."""
        self._theme = theme
        self._media = media
        self._problems: dict[Place, dict[str, list[Problem]]] = {}
        sheet.chosen.connect(self._on_chosen)
        sheet.edited.connect(self._on_edited)
        sheet.dropped.connect(self._on_dropped)
        sheet.opened.connect(self._on_opened)
        sheet.menu_asked.connect(self._on_menu)

    @property
    def part(self) -> rbd.State | rbd.Always | None:
        """Whose screen is shown."""
        if self.application is None or not self.place:
            return None
        found = places.get(self.application, self.place)
        return found if isinstance(found, rbd.State | rbd.Always) else None

    @property
    def screen(self) -> rbd.Screen | None:
        return self.part.screen if self.part is not None else None

    @property
    def above(self) -> tuple[rbd.Component, ...]:
        """The components that Always adds to the state."""
        if self.application is None or not isinstance(self.part, rbd.State):
            return ()
        always = self.application.always_in(self.part)
        if always is None or always.screen is None:
            return ()
        return always.screen.components

    @property
    def media(self) -> Path | None:
        """The folder of the pictures, as it is now."""
        return self._media()

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self.show()

    @property
    def problems(self) -> Told:
        """Those of the screen's components, by their ids."""
        return self._problems.get((*self.place, "screen"), {})

    def show_document(self, application: rbd.Application, problems: Iterable[Problem] = ()) -> None:
        """Takes a new value, of which ``select`` says what is shown."""
        self.application = application
        self._problems = by_screen(problems)

    def select(self, selected: tuple[Place, ...]) -> None:
        """Shows the screen of the first of these that has one, as it is now."""
        self.go(selected)
        self.show()

    def go(self, selected: tuple[Place, ...]) -> None:
        """The next ``show`` shows the screen of the first of these that has one."""
        application = self.application
        if application is None:
            return
        for place in (*selected, self.place, ("state", application.start_no or "")):
            root = places.root(place)
            if root and isinstance(places.get(application, root), rbd.State | rbd.Always):
                self.place = root
                break
        else:
            self.place = ()
        within = (*self.place, "screen")
        self.sheet.select(tuple(p[-1] for p in selected if p[:-1] == within))
        self.sheet.show_problems(self.problems)

    def show(self) -> None:
        """Shows it anew: with another theme, or other values."""
        if self.application is not None:
            self.sheet.setVisible(self.part is not None)
            self.sheet.invitation = self._invitation()
            self.sheet.show_screen(self._theme, self.screen, self.above, self.media, self.values)

    def _invitation(self) -> str:
        part = self.part
        if isinstance(part, rbd.State) and part.flow is not None:
            return self.tr("{0} shows its own screens.").format(part.flow)
        begin = self.tr("Drag a component here, or press one of them.")
        if isinstance(part, rbd.State) and part.screen is None:
            return self.tr("This state keeps what was shown before.") + "\n" + begin
        return begin

    def may_add(self) -> bool:
        """Whether components can be put there; says why not."""
        if self.application is None:
            return False
        try:
            insert(self.application, kinds.TEXT, self.place)
        except NotHere as refused:
            self.status.emit(str(refused))
            return False
        return True

    def add(
        self, name: str, at: tuple[float, float] | None = None, **fields: object
    ) -> Place | None:
        """Puts a new component of a kind there with its middle, as one step, and selects it.

        at: None: into free room, as ``insert`` does. Its place; None where it can not be there, or
        its file is asked for first.
        """
        if self.application is None:
            return None
        file = kinds.kind(name).file
        if file and file not in fields:
            self.media_asked.emit(self.place, name, at)
            return None
        try:
            after, place, text = insert(self.application, kinds.kind(name), self.place)
        except NotHere as refused:
            self.status.emit(str(refused))
            return None
        made = replace(places.get(after, place), **fields)
        after = places.put(after, place, lying(made, self.media, at, self.sheet))
        self.edited.emit(after, text)
        self.sheet.choose(place[-1:])
        return place

    def _on_chosen(self, ids: tuple[str, ...]) -> None:
        places_ = tuple((*self.place, "screen", id) for id in ids)
        self.selection_changed.emit(places_ or (self.place,))

    def _on_opened(self, id: str) -> None:
        """A component without words: what it shows is chosen, else its form is filled in."""
        place = (*self.place, "screen", id)
        kind = kinds.kind_of(self.sheet.component(id))
        if kind is not None and kind.file:
            self.file_asked.emit(place, kind.file, self.sheet.menu_corner())
        else:
            self.filled_in.emit(place)

    def _on_menu(self, at: QPoint) -> None:
        self.menu_requested.emit((*self.place, "screen", *self.sheet.selected[:1]), at)

    def _on_edited(self, screen: rbd.Screen, text: str) -> None:
        if self.application is not None:
            after, called = button_names.written(self.application, self.place, screen)
            self.edited.emit(after, text)
            if called:
                self.sheet.choose(tuple(called.values()))

    def _on_dropped(self, name: str, x: float, y: float) -> None:
        self.add(name, (x, y))
