"""A window's part of the documents' files: renamed, deleted, and another application like one made.

Each is one step of documents. On disk nothing happens before the project is saved: then the new
file is written, and the old one goes into the system's waste basket (``Session.save``).
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, QPoint, Qt
from PySide6.QtGui import QContextMenuEvent, QKeyEvent
from PySide6.QtWidgets import QDialog, QMenu

from situ.document.beside import Toml
from situ.document.folder import PROJECT_FILE
from situ.document.project import Project
from situ.document.rbd import Application
from situ.errors import UsageError
from situ.rehearse.suite import ENDING
from situ_studio.edits import document_uses as uses
from situ_studio.edits.edit import Document, Written
from situ_studio.files.document_dialogs import DeleteDocument, RenameDocument
from situ_studio.files.left_open import Left, left, open_again
from situ_studio.files.proposed_names import ProposedNames, values
from situ_studio.panels.lists import PLACE
from situ_studio.panels.project_tree import kind, stem
from situ_studio.project.undo import Looking, Selection
from situ_studio.views import showing
from situ_studio.wording.language import said

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow
    from situ_studio.window.sides import Group

COMMANDS = ("rename_file", "duplicate_application", "delete_file")
"""What is offered of a document's file."""


class DocumentFiles(QObject):
    """About the row of the project's tree that has the focus, else about the shown document."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window, self._session = window, window.session
        self._pairs: dict[str, str] = {}
        self._left: dict[str, tuple[Left, ...]] = {}
        self._pressed: str | None = None
        self.dialog: QDialog | None = None
        """While it is asked."""
        self._session.opened.connect(self._forget)
        self._session.listed.connect(self._follow)
        self._session.selected.connect(self._open_again)
        self._session.left_over.connect(self._tell_left)
        self._tree = window.project_tree.tree
        self._tree.installEventFilter(self)

    def move_to(self, other: DocumentFiles) -> None:
        """Tabs go along in a window that is made in place of this one."""
        other._pairs.update(self._pairs)
        other._left.update(self._left)

    def _forget(self) -> None:
        self._pairs.clear()
        self._left.clear()

    # -- which one -----------------------------------------------------------------------

    @property
    def file(self) -> str | None:
        """The document's file that is meant; None where none is."""
        file = self._window.current_file
        if self._pressed is not None:
            file = self._pressed
        elif self._tree.hasFocus():
            file = self._tree.currentIndex().data(PLACE)
        project = self._session.project
        if project is None or project.toml is None or file is None:
            return None
        return file if self._session.document(file) is not None else None

    @property
    def is_application(self) -> bool:
        """Whether it is an application's, of which there may be another one like it."""
        return isinstance(self._session.document(self.file or ""), Application)

    def add_to(self, menu: QMenu, file: str | None) -> None:
        """Puts what can be done with a row of the tree before what a menu has."""
        self._pressed = file
        menu.aboutToHide.connect(self._release, Qt.ConnectionType.QueuedConnection)
        if self.file is None:
            self._pressed = None
            return
        every = self._window.actions_
        every.refresh()
        first = menu.actions()[0]
        for name in COMMANDS:
            if every.actions[name].isEnabled():
                menu.insertAction(first, every.actions[name])
        menu.insertSeparator(first)

    def _release(self) -> None:
        # What was chosen is done by now.
        self._pressed = None
        self._window.actions_.refresh()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QContextMenuEvent) and self._by_key(event):
            return True
        if not isinstance(event, QKeyEvent) or self.file is None:
            return False
        keys = {Qt.Key.Key_F2: self.rename, Qt.Key.Key_Delete: self.delete}
        wanted = keys.get(Qt.Key(event.key()))
        if wanted is None or event.modifiers() != Qt.KeyboardModifier.NoModifier:
            return False
        if event.type() == QEvent.Type.ShortcutOverride:
            event.accept()
            return True
        if event.type() == QEvent.Type.KeyPress:
            wanted()
            return True
        return False

    def _by_key(self, event: QContextMenuEvent) -> bool:
        """The menu of the current row, where the keyboard asks for it."""
        if event.reason() != QContextMenuEvent.Reason.Keyboard:
            return False
        index = self._tree.currentIndex()
        below = self._tree.visualRect(index).bottomLeft() + QPoint(24, 0)
        at = self._tree.viewport().mapToGlobal(below)
        self._window.project_menu.open(at, index.data(PLACE))
        return True

    # -- another name --------------------------------------------------------------------

    def rename(self) -> None:
        """Asks for another name; what follows is shown before it is done."""
        file = self._ready()
        if file is None:
            return
        window, document = self._window, self._session.document(file)
        assert document is not None
        names = ProposedNames(self._session, file, lambda new: self._pairs.get(new) == file)
        dialog = RenameDocument(stem(file), document, names, window.theme, window)
        dialog.agreed.connect(partial(self._rename, file, document))
        self._open(dialog)

    def _rename(self, file: str, document: Document, wanted: uses.Renaming) -> None:
        new = next(iter(wanted.changed))
        if new != file:
            self._pairs[file] = new
        words = self.tr("Rename {0} {1}").format(kind(document), stem(file))
        self._commit(wanted.changed, words)

    # -- deleted -------------------------------------------------------------------------

    def delete(self) -> None:
        """Asks whether a document shall be deleted, and says what still refers to it."""
        file, project = self._ready(), self._session.project
        if file is None or project is None:
            return
        needed = self._needed(project, file)
        if needed:
            self._window.say(needed)
            return
        document = self._session.document(file)
        assert document is not None
        try:
            found = uses.uses(project, values(self._session, project), file)
        except UsageError as error:
            self._window.say(said(str(error)))
            return
        dialog = DeleteDocument(file, document, found, self._window)
        dialog.agreed.connect(partial(self._delete, file, document))
        self._open(dialog)

    def _needed(self, project: Project, file: str) -> str:
        """Why a project can not be without a file, in one line; "" where it can."""
        if [*project.applications] == [file]:
            return self.tr("It is the only application: a project has at least one.")
        if file == project.spds_file and len(project.applications) > 1:
            return self.tr(
                "A project with several applications needs its script: it says which one goes "
                "first."
            )
        return ""

    def _delete(self, file: str, document: Document) -> None:
        project, toml = self._session.project, self._session.value(PROJECT_FILE)
        changed: dict[str, Written | None] = {}
        if project is not None and isinstance(toml, Toml):
            changed[PROJECT_FILE] = uses.listed(toml, project, file)
        every = self._window.sides.views_of(file)
        view = self._window.views.get(file) or next(iter(every), None)
        seen = (view.selected, view.call("looking")) if view is not None else ((), None)
        words = self.tr("Delete {0} {1}").format(kind(document), stem(file))
        self._commit({**changed, file: None}, words, *seen)

    # -- another one like it -------------------------------------------------------------

    def duplicate(self) -> None:
        file = self._ready()
        if file is not None:
            self._window.pages.applications.copy(file)

    # -- inside --------------------------------------------------------------------------

    def _ready(self) -> str | None:
        """The file that is meant, once nothing of it could be lost; else it is said why not."""
        window, file = self._window, self.file
        window.finish_fields()
        if file is None:
            return None
        # What another program did meanwhile is taken in, or asked about, first.
        self._session.disk.look()
        if self._session.document(file) is None:
            return None
        if self._session.is_incomplete(file):
            told = self.tr("{0} has errors: mend them first, or what they name would be lost.")
        elif self._session.disk.is_other(file):
            told = self.tr("Another program changed {0}: decide first which one stays.")
        else:
            return file
        window.say(told.format(file))
        return None

    def _commit(
        self,
        changed: dict[str, Written | None],
        words: str,
        selected: Selection = (),
        looking: Looking | None = None,
    ) -> None:
        self._session.contents.attend(file for file in changed if file.endswith(ENDING))
        if not self._session.commit_all(changed, words, selected, looking):
            told = self.tr("A document with errors refers to it: mend it first.")
            self._window.say(told)

    def _open(self, dialog: QDialog) -> None:
        self.dialog = dialog
        dialog.finished.connect(self._on_finished)
        dialog.open()

    def _on_finished(self) -> None:
        self.dialog = None

    def _tell_left(self, file: str) -> None:
        told = self.tr("{0} could not go into the waste basket: it stays in the folder.")
        self._window.say(told.format(file))

    # -- tabs go along -------------------------------------------------------------------

    def _follow(self) -> None:
        """A tab of a file that has another name now, or its old one again, shows that."""
        for one, other in self._pairs.items():
            for old, new in ((one, other), (other, one)):
                gone = self._session.document(old) is None
                if gone and self._session.document(new) is not None:
                    for group in self._window.sides.groups:
                        self._swap(group, old, new)
        # They close now, but come back as they are with what is taken away.
        for group in self._window.sides.groups:
            for tab in group.tabs.files():
                for file in group.ways.get(tab, (tab,)):
                    if self._session.document(file) is None and not self._window.pages.has(file):
                        self._left[file] = left(self._window, file)

    def _open_again(self, file: str) -> None:
        if self._session.document(file) is not None:
            open_again(self._window, file, self._left.pop(file, ()))

    def _swap(self, group: Group, old: str, new: str) -> None:
        ways = {tab: way for tab, way in group.ways.items() if old in way}
        if old not in group.tabs.files() and not ways:
            return
        window, here = self._window, self._window.sides.current
        window.sides.enter(group)
        chosen, shown = group.tabs.chosen_file, group.current_file
        view = group.views.get(old)
        if view is not None:
            group.waiting[new] = showing.shown(view)
        for tab, way in ways.items():
            moved = tuple(new if file == old else file for file in way)
            group.ways.pop(tab)
            group.ways[moved[0]] = moved
        if old in group.tabs.files():
            place = group.tabs.files().index(old)
            window.open_files.add_tab(new)
            group.tabs.put(new, place)
        if chosen == old:
            window.tabs.choose(new)
        elif shown == old and chosen is not None:
            window.tabs.choose(chosen)
        window.sides.enter(here)
