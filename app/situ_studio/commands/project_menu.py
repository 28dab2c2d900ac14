"""What can be added to a project, from the heading of its tree and from its rows."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QPoint, Qt
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QMenu

from situ.document.beside import Toml
from situ.document.folder import PROJECT_FILE
from situ_studio.edits import new_information
from situ_studio.looks import icons
from situ_studio.panels.lists import PLACE
from situ_studio.widgets.icon_widgets import IconButton

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow


class ProjectMenu(QObject):
    """The plus beside *Project*; the same menu opens where a row is pressed with the right."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self.button = IconButton(window.theme, "plus", self.tr("Add to the project"), "text2", 14)
        self.button.clicked.connect(self._on_button)
        window.headers["project"].add(self.button)
        tree = window.project_tree.tree
        tree.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        tree.customContextMenuRequested.connect(
            lambda at: self.open(tree.viewport().mapToGlobal(at), tree.indexAt(at).data(PLACE))
        )

    def open(self, at: QPoint, file: str | None = None) -> None:
        """Opens the menu at a place of the screen; a project without ``situ.toml`` has none.

        file: that of the row that was pressed, with which more can be done.
        """
        window = self._window
        if not window.pages.has(PROJECT_FILE):
            window.say(self.tr("One file alone is open: nothing can be added beside it."))
            return
        window.actions_.refresh()
        menu = QMenu(window)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        window.pages.applications.fill(menu)
        menu.addSeparator()
        script = window.actions_.actions["begin_script"]
        if script.isVisible():
            menu.addAction(script)
        project = window.session.project
        if project is not None and new_information.can_begin(project):
            modules = menu.addAction(
                self._icon("module"), self.tr("What modules say of themselves")
            )
            modules.triggered.connect(lambda _=False: self._begin_information())
        language = menu.addAction(self._icon("language"), self.tr("Language…"))
        language.triggered.connect(lambda: window.pages.add_language())
        menu.addSeparator()
        form = menu.addAction(self._icon("folder"), self.tr("What the project is"))
        form.triggered.connect(lambda: window.open_file(PROJECT_FILE))
        if file is not None:
            window.document_files.add_to(menu, file)
        menu.popup(at)

    def _begin_information(self) -> None:
        toml = self._window.session.value(PROJECT_FILE)
        if isinstance(toml, Toml):
            changed = new_information.begun(toml)
            if self._window.session.commit_all(changed, self.tr("Begin module information")):
                self._window.open_file(new_information.FILE)

    def _on_button(self) -> None:
        self.open(self.button.mapToGlobal(self.button.rect().bottomLeft()))

    def _icon(self, name: str) -> QIcon:
        return icons.icon(name, self._window.theme.color("text2"), 18)
