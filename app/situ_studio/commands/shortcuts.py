"""The list of every key: of the table of commands, and of the canvas itself."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QDialog, QLineEdit, QTreeWidget, QTreeWidgetItem, QVBoxLayout, QWidget

from situ_studio.actions import COMMANDS
from situ_studio.assistive.heard_cells import HeardRow
from situ_studio.commands.keys import headed, written
from situ_studio.commands.menus import told, translated
from situ_studio.looks.letters import px
from situ_studio.looks.theme import font
from situ_studio.screens.keyboard import KEYS

CANVAS: tuple[tuple[str, str], ...] = (
    ("Arrows", "The next card in that direction"),
    ("Tab, Shift+Tab", "The next card, the card before, in the order of the document"),
    ("A letter or number", "The next card whose name or number begins so"),
    ("Enter", "Rename the selected card; Tab goes on to the next one"),
    ("Ctrl+arrows", "Move the selected cards"),
    ("Esc", "Select nothing; give up a drag"),
    ("Space and drag", "Move the drawing"),
    ("Ctrl and wheel", "Zoom"),
)
"""What a canvas does with keys by itself (``canvas.base``), with what a person reads."""

TREE: tuple[tuple[str, str], ...] = (
    ("F2", "Rename the file of the row"),
    ("Del", "Delete the file of the row"),
)
"""What the project's tree does with keys (``files.document_files``), with what a person reads."""


def rows(keys_of: Mapping[str, list[QKeySequence]]) -> Iterator[tuple[str, str, str]]:
    """Heading, keys and words of every key, in the table's order."""
    for command in COMMANDS:
        if keys_of[command.id]:
            yield headed(command), written(keys_of[command.id]), told(command)
    for keys, text in CANVAS:
        canvas = QCoreApplication.translate("actions", "On the canvas")
        yield canvas, translated(keys), translated(text)
    for keys, text in TREE:
        tree = QCoreApplication.translate("actions", "In the project's tree")
        yield tree, translated(keys), translated(text)
    for keys, text in KEYS:
        screen = QCoreApplication.translate("actions", "On the screen of a state")
        yield screen, translated(keys), translated(text)


class Shortcuts(QDialog):
    """Every key under its menu's name, typed to filter. Esc closes it.

    keys: of the commands, by their ids.
    """

    def __init__(self, keys: Mapping[str, list[QKeySequence]], parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(self.tr("Keyboard shortcuts"))
        self.resize(px(560), 640)
        column = QVBoxLayout(self)
        self.list = KeyList()
        column.addWidget(self.list)
        for head, shown, text in rows(keys):
            self.list.add(head, text, shown)


class KeyList(QWidget):
    """Rows of words and keys under headings, and a field that filters them."""

    def __init__(self) -> None:
        super().__init__()
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.field = QLineEdit()
        self.field.setPlaceholderText(self.tr("Type what you want to do"))
        self.field.setAccessibleName(self.tr("What to look for"))
        self.field.textChanged.connect(self._filter)
        column.addWidget(self.field)
        self.tree = QTreeWidget()
        self.tree.setAccessibleName(self.tr("Keys"))
        self.tree.setColumnCount(2)
        self.tree.setHeaderLabels([self.tr("What"), self.tr("Keys")])
        self.tree.setColumnWidth(0, px(360))
        self.tree.setRootIsDecorated(False)
        column.addWidget(self.tree)
        self._heads: dict[str, QTreeWidgetItem] = {}

    def add(self, head: str, text: str, keys: str) -> QTreeWidgetItem:
        """A row at the end of its heading."""
        if head not in self._heads:
            self._heads[head] = QTreeWidgetItem(self.tree, [head])
            self._heads[head].setFont(0, font(13, 600))
            self._heads[head].setExpanded(True)
        return HeardRow(self._heads[head], [text, keys])

    def _filter(self, query: str) -> None:
        wanted = query.casefold().split()
        for at in range(self.tree.topLevelItemCount()):
            head = self.tree.topLevelItem(at)
            assert head is not None
            shown = 0
            for row in range(head.childCount()):
                item = head.child(row)
                assert item is not None
                text = f"{item.text(0)} {item.text(1)}".casefold()
                item.setHidden(not all(word in text for word in wanted))
                shown += not item.isHidden()
            head.setHidden(not shown)
