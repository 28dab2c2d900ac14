"""The list of every key: of the table of commands, and of the canvas itself."""

from __future__ import annotations

from collections.abc import Iterator

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QDialog, QLineEdit, QTreeWidget, QTreeWidgetItem, QVBoxLayout, QWidget

from situ_studio.actions import COMMANDS
from situ_studio.menus import told, translated
from situ_studio.theme import font

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


def rows() -> Iterator[tuple[str, str, str]]:
    """Heading, keys and words of every key, in the table's order."""
    for command in COMMANDS:
        if command.shortcut:
            keys = ", ".join(
                QKeySequence(k).toString(QKeySequence.SequenceFormat.NativeText)
                for k in (command.shortcut, command.also)
                if k
            )
            head, _, _ = command.menu.partition("/")
            yield translated(head), keys, told(command)
    for keys, text in CANVAS:
        canvas = QCoreApplication.translate("actions", "On the canvas")
        yield canvas, translated(keys), translated(text)


class Shortcuts(QDialog):
    """Every key under its menu's name, typed to filter. Esc closes it."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(self.tr("Keyboard shortcuts"))
        self.resize(560, 640)
        column = QVBoxLayout(self)
        self.field = QLineEdit()
        self.field.setPlaceholderText(self.tr("Type what you want to do"))
        self.field.setAccessibleName(self.tr("What to look for"))
        self.field.textChanged.connect(self._filter)
        column.addWidget(self.field)
        self.tree = QTreeWidget()
        self.tree.setAccessibleName(self.tr("Keys"))
        self.tree.setColumnCount(2)
        self.tree.setHeaderLabels([self.tr("What"), self.tr("Keys")])
        self.tree.setColumnWidth(0, 360)
        self.tree.setRootIsDecorated(False)
        column.addWidget(self.tree)
        heads: dict[str, QTreeWidgetItem] = {}
        for head, keys, text in rows():
            if head not in heads:
                heads[head] = QTreeWidgetItem(self.tree, [head])
                heads[head].setFont(0, font(13, 600))
            QTreeWidgetItem(heads[head], [text, keys])
        self.tree.expandAll()

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
