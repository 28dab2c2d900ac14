"""What commands do with the components of screens, on a sheet or in the outline."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QMimeData, QObject
from PySide6.QtGui import QGuiApplication

from situ.document import rbd
from situ.document.rbd import Application
from situ.document.words import listed
from situ_studio.edits import places, words
from situ_studio.edits.edit import Place
from situ_studio.edits.lacking import lacking
from situ_studio.screens import copies, ordering
from situ_studio.screens.guiding import Guiding
from situ_studio.screens.sheet import Sheet

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow

MIME = "application/x-situ-components+xml"
"""Copied components: an application with one state that has them, as a file has it."""
SHEETS = ("designer", "screen")
"""The pieces of a view (``views``) that have a sheet."""


class ComponentCommands(QObject):
    """The handlers of one window that are about components; ``commands.Commands`` asks them."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self._session = window.session

    # -- what is selected ----------------------------------------------------------------

    @property
    def chosen(self) -> tuple[Place, ...]:
        """The places of the selected components; none where anything else is selected too."""
        view = self._window.current_view
        every = view.selected if view is not None else ()
        return every if all(map(places.is_component, every)) else ()

    @property
    def sheet(self) -> Sheet | None:
        """The sheet that is seen, if one is."""
        view = self._window.current_view
        for name in SHEETS if view is not None else ():
            piece = view.piece(name) if view is not None else None
            if piece is not None and piece.isVisible():
                sheet: Sheet = piece.sheet
                return sheet
        return None

    @property
    def guiding(self) -> Guiding | None:
        """The guides of the designer, where that is seen."""
        view = self._window.current_view
        piece = view.piece("designer") if view is not None else None
        if piece is None or not piece.isVisible():
            return None
        guiding: Guiding = piece.guiding
        return guiding

    def offer_tags(self, tags: tuple[str, ...]) -> None:
        """Tells every screen that is seen, in both groups of tabs, the tags of the project."""
        for group in self._window.sides.groups:
            view = group.current_view
            for piece in map(view.piece, SHEETS) if view is not None else ():
                if piece is not None and piece.isVisible():
                    piece.offer_tags(tags)

    def _of(self, chosen: tuple[Place, ...]) -> tuple[Place, rbd.Screen, tuple[str, ...]] | None:
        """The place and the value of the screen of the first component, and the ids on it."""
        document = self._window.current_document
        if document is None or not chosen:
            return None
        within = chosen[0][:-1]
        screen = places.get(document, within)
        if not isinstance(screen, rbd.Screen):
            return None
        return within, screen, tuple(p[-1] for p in chosen if p[:-1] == within)

    # -- copies --------------------------------------------------------------------------

    def copy(self) -> None:
        """What is selected to the clipboard, as a file has it; says so."""
        found = self._of(self.chosen)
        if found is None:
            return
        _, screen, ids = found
        data = copies.written(copies.chosen(screen, ids))
        mime = QMimeData()
        mime.setData(MIME, data)
        mime.setText(data.decode())
        QGuiApplication.clipboard().setMimeData(mime)
        self._window.say(self.tr("{0} copied").format(self._named(ids)))

    def cut(self) -> None:
        """Takes away what ``copy`` copies: of one screen."""
        found = self._of(self.chosen)
        if found is not None:
            within, _, ids = found
            self.copy()
            self._delete(tuple((*within, id) for id in ids), self.tr("Cut {0}"))

    def delete(self, text: str) -> None:
        """text: the name of the step."""
        self._delete(self.chosen, text)

    def _delete(self, chosen: tuple[Place, ...], text: str) -> None:
        document = self._window.current_document
        if document is None or not chosen:
            return
        for place in chosen:
            document = places.put(document, place, None)
        self._window.commit(document, text.format(self._named([p[-1] for p in chosen])))
        self._window.select(chosen[0][:-2])

    @property
    def can_paste(self) -> bool:
        """Whether components are on the clipboard."""
        there: QMimeData | None = QGuiApplication.clipboard().mimeData()
        return there is not None and there.hasFormat(MIME)

    def paste(self) -> None:
        """Onto the screen of the selected state; says what this project does not have of it."""
        view, document = self._window.current_view, self._window.current_document
        mime = QGuiApplication.clipboard().mimeData()
        components = copies.read(bytes(mime.data(MIME).data()))
        if not components:
            said = self.tr("The components on the clipboard can not be read: copy them again.")
            self._window.say(said)
            return
        root = places.root(view.selected[0]) if view is not None and view.selected else ()
        part = places.get(document, root) if document is not None and root else None
        if not isinstance(part, rbd.State | rbd.Always):
            self._window.say(self.tr("Select a state first, then paste the components."))
            return
        assert isinstance(document, Application)
        if isinstance(part, rbd.State) and part.flow is not None:
            said = self.tr("{0} runs {1}: paste the components there.")
            where = words.place_words(document, root)
            self._window.say(said.format(where[:1].upper() + where[1:], part.flow))
            return
        self._put(document, root, components, self.tr("Paste {0}"))

    def duplicate(self) -> None:
        found, document = self._of(self.chosen), self._window.current_document
        if found is not None and isinstance(document, Application):
            within, screen, ids = found
            self._put(document, within[:-1], copies.chosen(screen, ids), self.tr("Duplicate {0}"))

    def _put(
        self,
        document: Application,
        root: Place,
        components: tuple[rbd.Component, ...],
        text: str,
    ) -> None:
        part = places.get(document, root)
        screen, ids = copies.pasted(part.screen, components)
        after = places.change(document, root, screen=screen)
        self._window.commit(after, text.format(self._named([c.id for c in components])))
        made = tuple((*root, "screen", id) for id in ids)
        self._window.select_all(made)
        project = self._session.project
        missing = lacking(project, self._window.media, after, made) if project is not None else []
        if missing:
            said = self.tr("Pasted. This project does not have {0}: copy the files too.")
            self._window.say(said.format(listed(missing)))

    def _named(self, ids: list[str] | tuple[str, ...]) -> str:
        return ids[0] if len(ids) == 1 else self.tr("{0} components").format(len(ids))

    # -- order and text --------------------------------------------------------------------

    def order(self, way: ordering.Way) -> None:
        """Puts what is selected before or behind others, as ``screens.ordering`` says."""
        found, document = self._of(self.chosen), self._window.current_document
        if found is None or document is None:
            return
        within, screen, ids = found
        after = ordering.reordered(screen, ids, way)
        if after is not screen:
            texts = {
                "front": self.tr("Bring {0} to the front"),
                "forward": self.tr("Bring {0} forward"),
                "backward": self.tr("Send {0} backward"),
                "back": self.tr("Send {0} to the back"),
            }
            named = texts[way].format(self._named(ids))
            self._window.commit(places.put(document, within, after), named)

    def write(self) -> bool:
        """Opens the text of the selected component where it stands; False where it has none."""
        sheet, chosen = self.sheet, self.chosen
        return sheet is not None and len(chosen) == 1 and sheet.writing.begin(chosen[0][-1])
