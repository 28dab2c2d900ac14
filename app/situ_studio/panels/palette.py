"""The palette: kinds to drag onto the canvas, or to press with the keyboard."""

from __future__ import annotations

from functools import lru_cache
from itertools import groupby

from PySide6.QtCore import QMimeData, Qt, Signal
from PySide6.QtGui import QPixmap
from PySide6.QtWidgets import QFrame, QGridLayout, QLabel, QScrollArea, QVBoxLayout, QWidget

from situ.document.modules import Modules
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ_studio.edits.edit import Document
from situ_studio.help.help_topics import HELP
from situ_studio.kinds import KINDS, MIME, Kind
from situ_studio.looks import icons
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.widgets.dragging import Dragging
from situ_studio.widgets.icon_widgets import ThemedButton
from situ_studio.widgets.layouts import clear
from situ_studio.wording.language import translated


def offered(document: Document | None) -> tuple[Kind, ...]:
    """The kinds that a document can take."""
    parts: tuple[str, ...] = ()
    if isinstance(document, Application):
        parts = ("application", "action", "screen", "drawing")
    elif isinstance(document, Spds):
        parts = ("script",)
    elif isinstance(document, Modules):
        parts = ("modules",)
    return _of(parts)


@lru_cache
def _of(parts: tuple[str, ...]) -> tuple[Kind, ...]:
    return tuple(k for part in parts for k in KINDS if k.palette == part)


LOWEST = 80
"""Px of the palette that are seen in the lowest window."""
BETWEEN, HEAD = 6, 28
"""Px between two groups, and of a group's name in a high window."""
NARROW = 94
"""Px of a column where the panel is as narrow as it begins; a longer word gets both."""


class PaletteItem(ThemedButton):
    """One kind. A drag carries its name as ``MIME``; a click asks to insert it."""

    def __init__(self, theme: Theme, kind: Kind, parent: QWidget | None = None) -> None:
        super().__init__(
            theme, kind.icon, translated(kind.title), "palette", str(kind.tint), 16, parent=parent
        )
        self.kind = kind
        self.setToolTip(translated(kind.help))
        self.setProperty(HELP, f"kind/{kind.name}")
        self._theme = theme
        Dragging(self, self._carried, self._picture)

    def _carried(self) -> QMimeData:
        data = QMimeData()
        data.setData(MIME, self.kind.name.encode())
        return data

    def _picture(self) -> QPixmap:
        return icons.pixmap(self.kind.icon, self._theme.color(self.kind.tint), 24)


class PaletteRoom(QScrollArea):
    """Holds the palette: as high as that, but in a low window, where it scrolls."""

    def __init__(self, palette: Palette, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._palette = palette
        self._low = False
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.viewport().setProperty("role", "panel")
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setWidget(palette)
        palette.filled.connect(self._settle)
        self._settle()

    def set_low(self, low: bool) -> None:
        """Whether the window has no room for all of it."""
        self._low = low
        self._settle()

    def _settle(self) -> None:
        height = self._palette.maximumHeight()
        self.setMaximumHeight(height)
        self.setMinimumHeight(min(height, px(LOWEST)) if self._low else height)
        bar = self.verticalScrollBar().sizeHint().width() if self._low else 0
        self.setMinimumWidth(self._palette.minimumSizeHint().width() + bar)


class Palette(QWidget):
    """Two columns; what belongs together stands together."""

    kind_asked = Signal(str)
    filled = Signal()
    """It is of another height now."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "panel")
        self._theme = theme
        self._kinds: tuple[Kind, ...] = ()
        self._dense = False
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(8, 0, 8, 8)
        self._column.setSpacing(0)
        self._fill()

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self._fill()

    def set_dense(self, dense: bool) -> None:
        """Lower rows, where the window is low: the palette never scrolls."""
        if dense != self._dense:
            self._dense = dense
            self._fill()

    def show_document(self, document: Document | None) -> None:
        """Offers what the document can take."""
        kinds = offered(document)
        if kinds != self._kinds:
            self._kinds = kinds
            self._fill()

    def item(self, name: str) -> PaletteItem:
        """The button of a kind; LookupError where it is not offered."""
        for item in self.findChildren(PaletteItem):
            if item.kind.name == name and not item.isHidden():
                return item
        raise LookupError(name)

    def _fill(self) -> None:
        clear(self._column)
        gap, high = (2, px(24)) if self._dense else (4, px(28))
        groups = [tuple(those) for _, those in groupby(self._kinds, lambda k: k.palette)]
        height = 0
        if not groups:
            height = self._nothing()
        for group in groups:
            if height:
                height += self._head(group[0].palette)
            grid, rows = self._rows(group)
            grid.setVerticalSpacing(gap)
            self._column.addLayout(grid)
            height += rows * (high + gap) - gap
        self._column.addStretch(1)
        self.setFixedHeight(height + 8)
        self.filled.emit()

    def _nothing(self) -> int:
        """Where nothing is drawn, how one comes to where there is something to add."""
        return self._say(self.tr("Open a drawing to add to it."))

    def _head(self, part: str) -> int:
        """What divides a group from the one above: its name, where there is room; its height."""
        name = {"action": self.tr("Actions"), "screen": self.tr("On its screen")}.get(part, "")
        if self._dense or not name:
            self._column.addSpacing(BETWEEN)
            return BETWEEN
        return self._say(name)

    def _say(self, words: str) -> int:
        """A line of words; its height."""
        label = QLabel(words)
        label.setProperty("role", "hint")
        label.setFixedHeight(px(HEAD))
        label.setContentsMargins(4, 0, 0, 0)
        self._column.addWidget(label)
        return px(HEAD)

    def _rows(self, group: tuple[Kind, ...]) -> tuple[QGridLayout, int]:
        """A group in two columns, and how many rows it has."""
        grid = QGridLayout()
        grid.setSpacing(4)
        row = column = 0
        long: list[PaletteItem] = []
        for kind in group:
            item = self._item(kind)
            if item.sizeHint().width() > px(NARROW):
                long.append(item)
            else:
                grid.addWidget(item, row, column)
                row, column = (row + 1, 0) if column else (row, 1)
            # Not before the row is full: no hole is left beside it.
            while long and not column:
                grid.addWidget(long.pop(0), row, 0, 1, 2)
                row += 1
        row += column
        for item in long:
            grid.addWidget(item, row, 0, 1, 2)
            row += 1
        grid.setColumnStretch(0, 1)
        grid.setColumnStretch(1, 1)
        return grid, row

    def _item(self, kind: Kind) -> PaletteItem:
        item = PaletteItem(self._theme, kind, self)
        item.setProperty("dense", self._dense)
        item.clicked.connect(lambda _=False, k=kind: self.kind_asked.emit(k.name))
        item.ensurePolished()
        return item
