"""The window's part of choosing pictures, movies and sounds: for what is new, or is there."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec.structs import replace
from PySide6.QtCore import QObject, QPoint

from situ.document import rbd
from situ.document.names import is_name, is_reserved
from situ.errors import UsageError
from situ_studio import kinds
from situ_studio.commands.insert import NotHere, insert
from situ_studio.edits import places, words
from situ_studio.edits.edit import Document, Place
from situ_studio.screens import media_import
from situ_studio.screens.media_picker import MediaPicker, names_data
from situ_studio.screens.media_rows import IMPORT
from situ_studio.screens.state_screen import lying
from situ_studio.wording.language import said

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow

EVERY = (*media_import.PICTURES, *media_import.MOVIES, *media_import.SOUNDS)


class ChoosingMedia(QObject):
    """What needs a file is made once the file is chosen: without one there is nothing, no step
    and no error. Where the project has no file that fits, one from elsewhere is asked for at once,
    but where data names the file now: then data is offered.
    """

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self.picker: MediaPicker | None = None
        """While it is seen."""
        window.inspector.file_asked.connect(self.change)

    def add(self, at: Place, name: str, middle: tuple[float, float] | None = None) -> None:
        """Asks for the file of a new component or action of a kind, and puts it in.

        middle: where a component's shall be, percent of the screen; None: in free room.
        """
        document = self._window.current_document
        kind = kinds.kind(name)
        if document is None:
            return
        try:
            insert(document, kind, at)
        except NotHere as refused:
            self._window.say(str(refused))
            return
        spot = self._spot(middle)
        self._ask(name, spot, partial(self._put, kind, at, middle))

    def change(self, place: Place, attribute: str, spot: QPoint | None = None) -> None:
        """Asks for another file for what stands at a place."""
        document = self._window.current_document
        if document is None:
            return
        value = places.get(document, place)
        kind = getattr(value, "element", "")
        kind = kind if kind in ("movie", "sound") else "image"
        form = self._window.inspector.form
        if spot is None and form is not None:
            field = form.field(attribute)
            spot = field.mapToGlobal(QPoint(0, field.height() + 2))
        now = getattr(value, attribute, None) or ""
        self._ask(kind, spot, partial(self._set, place, attribute), now)

    def bring(self) -> None:
        """Asks for a file from elsewhere and brings it into the project, for nothing yet."""
        found = self._window.dialogs.media_file(EVERY)
        if found is not None:
            self.bring_files((Path(found),))

    def bring_files(self, files: tuple[Path, ...]) -> None:
        """Copies files into the project's media, as ``media_import.bring``; says why not."""
        for file in files:
            self._bring(file, EVERY)

    # -- asking ----------------------------------------------------------------------

    def _ask(
        self, kind: str, spot: QPoint | None, then: Callable[[Document, str], None], now: str = ""
    ) -> None:
        """then: is told the document and the file."""
        window = self._window
        project, document = window.session.project, window.current_document
        if project is None or document is None:
            return

        def done(src: str) -> None:
            if window.current_document is document:
                then(document, src)
            else:
                window.say(self.tr("The document has changed meanwhile: choose the file again."))

        endings = media_import.ENDINGS[kind]
        names = [one for one in media_import.names_of(project) if one.lower().endswith(endings)]
        if not names and not names_data(now):
            self._import(kind, done)
            return
        home = media_import.home_of(project)
        known = window.vocabulary(document).tags
        tags = [tag for tag in known if is_name(tag) and not is_reserved(tag)]
        picker = self.picker = MediaPicker(kind, names, home, window.theme, window, now, tags)
        picker.chosen.connect(lambda key: self._take(key, kind, done))
        picker.closed.connect(self._on_closed)
        middle = window.mapToGlobal(window.rect().center() - picker.rect().center())
        picker.popup(spot or middle)

    def _on_closed(self) -> None:
        self.picker = None

    def _take(self, key: str, kind: str, then: Callable[[str], None]) -> None:
        if key == IMPORT:
            self._import(kind, then)
        else:
            then(key)

    def _import(self, kind: str, then: Callable[[str], None]) -> None:
        """Asks for a file from elsewhere, and brings it into the project."""
        window = self._window
        endings = media_import.ENDINGS[kind]
        found = window.dialogs.media_file(endings)
        src = self._bring(Path(found), endings) if found is not None else None
        if src is not None:
            then(src)

    def _bring(self, file: Path, endings: tuple[str, ...]) -> str | None:
        """What the project calls the file then; None, and said why, where it can not have it."""
        project = self._window.session.project
        if project is None:
            return None
        try:
            src = media_import.bring(project, file, endings)
        except UsageError as error:
            self._window.say(said(str(error)))
            return None
        self._window.pages.settle_media(src)
        return src

    def _spot(self, middle: tuple[float, float] | None) -> QPoint | None:
        """Where it is asked: at what shall be there, else in the middle of the screen, if seen."""
        sheet = self._window.commands.components.sheet
        if sheet is None:
            return None
        return sheet.mapToGlobal(sheet.scale.point(*(middle or (50.0, 50.0))).toPoint())

    # -- what is done ----------------------------------------------------------------

    def _put(
        self,
        kind: kinds.Kind,
        at: Place,
        middle: tuple[float, float] | None,
        document: Document,
        src: str,
    ) -> None:
        after, place, text = insert(document, kind, at)
        made = replace(places.get(after, place), **{kind.file: src})
        project = self._window.session.project
        if isinstance(made, rbd.Component) and project is not None:
            sheet = self._window.commands.components.sheet
            made = lying(made, media_import.home_of(project), middle, sheet)
        after = places.put(after, place, made)
        self._window.commit(after, text)
        if middle is None:
            self._window.fill_in(place)
        else:
            # As after any drop: arrows move it.
            self._window.select(place)

    def _set(self, place: Place, attribute: str, document: Document, src: str) -> None:
        after = places.change(document, place, **{attribute: src})
        text = words.change_words(document, place, attribute, self.tr("File"))
        self._window.commit(after, text)
