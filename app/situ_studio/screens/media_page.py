"""The page of a project's media: what they show, where each is used, and more from elsewhere."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QMimeData, Qt, QUrl, Signal
from PySide6.QtGui import QDragEnterEvent, QDragMoveEvent, QDropEvent, QKeyEvent
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QVBoxLayout,
    QWidget,
)

from situ.document import rbd
from situ.document.project import Project
from situ_studio.edits import mentions, places, words
from situ_studio.edits.edit import Place
from situ_studio.looks.theme import Theme
from situ_studio.panels.project_tree import stem
from situ_studio.screens import media_import
from situ_studio.screens.designer_sheet import files_in
from situ_studio.screens.media_rows import DETAIL, ICON, KEY, MediaRows
from situ_studio.widgets.icon_widgets import ThemedButton, retheme
from situ_studio.widgets.layouts import rule

Use = tuple[str, Place]
"""A document's file, and the place that shows or plays a medium."""


def uses(project: Project) -> dict[str, list[Use]]:
    """By the file as the project names it, where its documents show or play it."""
    found: dict[str, list[Use]] = {}
    for file, application in project.flows.items():
        for mention in mentions.mentions(application):
            for role, name in mention.names:
                if role == "media":
                    found.setdefault(name, []).append((file, mention.place))
        parts: list[tuple[Place, rbd.Screen | None]] = [
            (("state", one.no), one.screen) for one in application.states
        ]
        if application.always is not None:
            parts.append((("always",), application.always.screen))
        for place, screen in parts:
            if screen is not None and screen.background:
                found.setdefault(screen.background, []).append((file, (*place, "screen")))
    return found


class MediaPage(QWidget):
    """A row a file. Enter or a double click goes to where it is used, the next time to the next;
    rows are dragged onto a screen, and files dropped here are brought into the project.
    """

    go_asked = Signal(str, tuple)
    import_asked = Signal()
    dropped = Signal(tuple)
    """Paths of files."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "panel")
        self.setAcceptDrops(True)
        self._theme = theme
        self._uses: dict[str, list[Use]] = {}
        self._gone: tuple[str, int] = ("", -1)
        """The file that was gone to last, and to which of its uses."""
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        line = QHBoxLayout()
        line.setContentsMargins(12, 6, 12, 6)
        line.setSpacing(8)
        self.add = ThemedButton(theme, "plus", self.tr("Import…"), "mend", "accent", 14)
        self.add.setToolTip(self.tr("A picture, movie or sound from elsewhere"))
        self.add.clicked.connect(self.import_asked)
        line.addWidget(self.add)
        self.hint = QLabel(self.tr("Drag a row onto a screen; Enter shows where it is used."))
        self.hint.setProperty("role", "hint")
        self.hint.setWordWrap(True)
        line.addWidget(self.hint, 1)
        line.addStretch()
        column.addLayout(line)
        column.addWidget(rule())
        self.list = _List()
        self.list.setAccessibleName(self.tr("Media"))
        self.list.asked.connect(self._on_asked)
        column.addWidget(self.list, 1)
        self.nothing = QLabel(self.tr("No picture, movie or sound yet: import one."))
        self.nothing.setProperty("role", "dim")
        self.nothing.setAlignment(Qt.AlignmentFlag.AlignCenter)
        column.addWidget(self.nothing, 1)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        retheme(self, theme)
        self._paint_rows()

    def begin(self) -> None:
        """The keyboard goes to the rows."""
        self.list.setFocus()

    def show_project(self, project: Project) -> None:
        """All media that are there now, and where they are used."""
        self._uses = uses(project)
        names = media_import.names_of(project)
        now = self.list.currentItem().data(KEY) if self.list.currentRow() >= 0 else ""
        self.list.home = media_import.home_of(project)
        self._paint_rows()
        self.list.clear()
        for name in names:
            item = QListWidgetItem(name)
            item.setData(KEY, name)
            kinds = media_import.ENDINGS.items()
            kind = next((k for k, ends in kinds if name.lower().endswith(ends)), "doc")
            item.setData(ICON, kind)
            told = self._told(project, name)
            item.setData(DETAIL, told)
            item.setToolTip(f"{name}\n{told}")
            item.setData(Qt.ItemDataRole.AccessibleTextRole, f"{name}. {told}")
            self.list.addItem(item)
        self.list.setCurrentRow(names.index(now) if now in names else 0)
        self.list.setVisible(bool(names))
        self.nothing.setVisible(not names)
        self.hint.setVisible(bool(names))

    def _paint_rows(self) -> None:
        # Qt keeps what painted them before.
        self.list.itemDelegate().deleteLater()
        self.list.setItemDelegate(MediaRows(self._theme, self.list.home, self.list))

    def choose(self, name: str) -> None:
        """Selects the row of a file."""
        for row in range(self.list.count()):
            if self.list.item(row).data(KEY) == name:
                self.list.setCurrentRow(row)

    def _told(self, project: Project, name: str) -> str:
        found: dict[str, dict[str, None]] = {}
        for file, place in self._uses.get(name, ()):
            application, root = project.flows[file], places.root(place)
            where = words.state_words(application, root[1]) if len(root) > 1 else ""
            found.setdefault(file, {})[where or self.tr("In every state")] = None
        if not found:
            return self.tr("Not used")
        several = len(project.flows) > 1
        each = (
            f"{stem(file)}: {', '.join(wheres)}" if several else ", ".join(wheres)
            for file, wheres in found.items()
        )
        return self.tr("Used in {0}").format("; ".join(each))

    def _on_asked(self, name: str) -> None:
        every = self._uses.get(name, [])
        if every:
            last, at = self._gone
            at = (at + 1) % len(every) if last == name else 0
            self._gone = (name, at)
            self.go_asked.emit(*every[at])

    # -- files from elsewhere --------------------------------------------------------

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        event.setAccepted(self._may_bring(event))

    def dragMoveEvent(self, event: QDragMoveEvent) -> None:
        event.setAccepted(self._may_bring(event))

    def _may_bring(self, event: QDropEvent) -> bool:
        return event.source() is not self.list and bool(files_in(event.mimeData()))

    def dropEvent(self, event: QDropEvent) -> None:
        event.setDropAction(Qt.DropAction.CopyAction)
        event.accept()
        self.dropped.emit(files_in(event.mimeData()))


class _List(QListWidget):
    """A drag carries the path of the file, as one from elsewhere."""

    asked = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.home: Path | None = None
        self.setMouseTracking(True)
        self.setUniformItemSizes(True)
        self.setDragEnabled(True)
        self.setProperty("role", "panel")
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.itemDoubleClicked.connect(lambda item: self.asked.emit(item.data(KEY)))

    def mimeData(self, items: Sequence[QListWidgetItem]) -> QMimeData:
        data = QMimeData()
        if self.home is not None:
            data.setUrls([QUrl.fromLocalFile(str(self.home / one.data(KEY))) for one in items])
        return data

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and self.currentRow() >= 0:
            self.asked.emit(self.currentItem().data(KEY))
        else:
            super().keyPressEvent(event)
