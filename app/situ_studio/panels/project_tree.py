"""The project tree: the project, its documents, and what else lies in its folder."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRect, QRectF, Qt, Signal
from PySide6.QtGui import (
    QAccessible,
    QAccessibleEvent,
    QFocusEvent,
    QPainter,
    QStandardItem,
    QStandardItemModel,
)
from PySide6.QtWidgets import QStyleOptionViewItem, QTreeView, QVBoxLayout, QWidget

from situ.document.folder import PROJECT_FILE, TEXTS_FOLDER
from situ.document.modules import Modules
from situ.document.project import Project
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ_studio.assistive.announcing import soon, tell_row
from situ_studio.edits.edit import Document
from situ_studio.looks import icons
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.lists import COUNT, ICON, MARKS, PLACE, RowDelegate
from situ_studio.screens.media_import import names_of
from situ_studio.wording.language import tr

MEDIA = "media/"
"""What the tab of the media goes by, as others go by their file."""
SCENARIOS = "scenarios"
"""The panel of the scenarios."""


def look(document: Document, part: bool = False) -> tuple[str, str, int]:
    """A document's icon, its colour, and how many it holds. part: it runs only inside others."""
    if isinstance(document, Application):
        kind = "part" if part else "state"
        return kind, kind, len(document.states)
    if isinstance(document, Spds):
        return "situation", "situation", len(document.situations)
    return "module", "module", len(document.modules)


def kind(document: Document, part: bool = False) -> str:
    """What sort of document it is, in the user's language."""
    if isinstance(document, Application):
        return tr("part") if part else tr("application")
    return tr("script") if isinstance(document, Spds) else tr("module information")


def stem(file: str) -> str:
    """A document's name for people: the file's without ``.rbd.xml``, ``.spds.xml``, ``.xml``."""
    name = file.rsplit("/", 1)[-1]
    for end in (".rbd.xml", ".spds.xml", ".xml"):
        if name.endswith(end):
            return name.removesuffix(end)
    return name


class Tree(QTreeView):
    """A tree whose arrows are ours."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme = theme
        self._focused = soon(self, lambda: tell_row(self, self.notify))
        self.notify: Callable[[QAccessibleEvent], None] = QAccessible.updateAccessibility
        self.setHeaderHidden(True)
        self.setIndentation(px(14))
        self.setMouseTracking(True)
        self.setUniformRowHeights(True)
        self.setEditTriggers(QTreeView.EditTrigger.NoEditTriggers)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self.viewport().update()

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        # A reader looks for the selected row, and Qt counts no rows in others there.
        if QAccessible.isActive():
            self._focused.start()

    def drawRow(
        self,
        painter: QPainter,
        options: QStyleOptionViewItem,
        index: QModelIndex | QPersistentModelIndex,
    ) -> None:
        super().drawRow(painter, options, index)
        if self.model().hasChildren(index):
            rect = self.visualRect(index)
            box = QRectF(rect.x() - 12, rect.center().y() - 5.5, 12, 12)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            name = "down" if self.isExpanded(index) else "right"
            icons.paint(painter, name, box, self._theme.color("text3"))

    def drawBranches(
        self, painter: QPainter, rect: QRect, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        """Nothing: the row draws its arrow, above its own background."""


class ProjectTree(QWidget):
    """Tells which document is asked for; marks the one that is shown."""

    file_asked = Signal(str)
    panel_asked = Signal(str)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "panel")
        self._files: dict[str, QStandardItem] = {}
        self._folder: dict[Path, int] = {}
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 4)
        self.tree = Tree(theme)
        self.tree.setAccessibleName(self.tr("Project"))
        self._delegate = RowDelegate(theme, 24, self.tree)
        self.tree.setItemDelegate(self._delegate)
        self._model = QStandardItemModel(self)
        self.tree.setModel(self._model)
        self.tree.clicked.connect(self._on_asked)
        self.tree.activated.connect(self._on_asked)
        column.addWidget(self.tree)

    def set_theme(self, theme: Theme) -> None:
        self._delegate.set_theme(theme)
        self.tree.set_theme(theme)

    def show_project(self, project: Project, files: list[str]) -> None:
        """Shows the project's documents and folders."""
        self._model.clear()
        self._files = {}
        top = QStandardItem(project.name)
        top.setData(("folder", "text2"), ICON)
        top.setData(500, Qt.ItemDataRole.FontRole)
        top.setToolTip(project.root)
        self._model.appendRow(top)
        if project.toml is not None:
            top.setData(PROJECT_FILE, PLACE)
            self._files[PROJECT_FILE] = top
        for file in files:
            item = QStandardItem(stem(file))
            item.setData(file, PLACE)
            item.setToolTip(file)
            top.appendRow(item)
            self._files[file] = item
        if project.toml is not None:
            texts = QStandardItem(self.tr("texts"))
            texts.setData(("language", "text2"), ICON)
            texts.setData(TEXTS_FOLDER, PLACE)
            texts.setData(str(len(project.languages)) if project.languages else "", COUNT)
            texts.setToolTip(self.tr("All texts, spoken, shown and heard, in every language"))
            top.appendRow(texts)
            self._files[TEXTS_FOLDER] = texts
        if project.toml is not None:
            self._add_folder(top, self.tr("media"), MEDIA, "image")
            self._files[MEDIA].setToolTip(
                self.tr("Pictures, movies and sounds, and where each is used")
            )
            self.show_media(project)
        self.show_scenarios(project)
        # Not all: a row without others would be read as an open one.
        self.tree.expand(top.index())
        self._settle_height()

    def _settle_height(self) -> None:
        self.setMinimumHeight(self.height_least())
        self.setMaximumHeight(self.height_wanted())

    def _add_folder(self, top: QStandardItem, words: str, key: str, icon: str) -> None:
        item = self._files[key] = QStandardItem(words)
        item.setData((icon, "text2"), ICON)
        item.setData(key, PLACE)
        top.appendRow(item)

    def show_media(self, project: Project) -> None:
        """Brings up to date how many pictures, movies and sounds there are."""
        item = self._files.get(MEDIA)
        if item is not None:
            count = len(names_of(project))
            item.setData(str(count) if count else "", COUNT)

    def show_scenarios(self, project: Project) -> None:
        """Brings up to date how many there are; the first one brings their row."""
        top = self._model.item(0)
        if project.scenarios is None or not (Path(project.root) / project.scenarios).is_dir():
            return
        if SCENARIOS not in self._files:
            self._add_folder(top, self.tr("scenarios"), SCENARIOS, "scenarios")
            self._files[SCENARIOS].setToolTip(project.scenarios)
            self._settle_height()
        found = (Path(project.root) / project.scenarios).rglob("*")
        self._files[SCENARIOS].setData(str(sum(1 for one in found if one.is_file())), COUNT)

    def show_document(
        self, file: str, document: Document, part: bool, dirty: bool, marks: tuple[str, ...]
    ) -> None:
        """Brings one document's row up to date; ``marks`` are ``error`` and ``warning``."""
        item = self._files.get(file)
        if item is None:
            return
        icon, token, count = look(document, part)
        item.setData((icon, token), ICON)
        item.setData(str(count), COUNT)
        item.setData(tuple((m, m) for m in marks), MARKS)
        item.setText(stem(file) + (" •" if dirty else ""))
        heard = [stem(file), kind(document, part), self.tr("not saved") if dirty else ""]
        heard += [tr("has an error")] * ("error" in marks) or [tr("has a warning")] * bool(marks)
        item.setAccessibleText(", ".join(one for one in heard if one))

    def show_current(self, file: str | None) -> None:
        """Marks the document that the window shows."""
        item = self._files.get(file or "")
        if item is None:
            self.tree.clearSelection()
        else:
            self.tree.setCurrentIndex(item.index())

    def height_wanted(self) -> int:
        """The height at which nothing needs to scroll."""
        root = self._model.invisibleRootItem()
        return px(24) * sum(1 + root.child(i).rowCount() for i in range(root.rowCount())) + 8

    def height_least(self) -> int:
        """The height below which it does not go: that of nine rows, or of all of fewer."""
        return min(self.height_wanted(), px(9 * 24 + 8))

    def _on_asked(self, index: QModelIndex) -> None:
        file = index.data(PLACE)
        if file == SCENARIOS:
            self.panel_asked.emit(file)
        elif file:
            self.file_asked.emit(file)


def is_information(document: Document) -> bool:
    """Whether a document is module information, which has no graph of its own."""
    return isinstance(document, Modules)
