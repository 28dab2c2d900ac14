"""Field: what recordings tell of each state, as a table and on the drawings."""

from __future__ import annotations

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QGuiApplication, QKeyEvent, QKeySequence
from PySide6.QtWidgets import QAbstractButton, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from situ.document import names, words
from situ.rehearse.usage import PLACE
from situ.rehearse.usage import Row as Used
from situ_studio.live.field_rows import NUMBERS, by_column, cells, rows, tips, titles
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import Flag, Line
from situ_studio.panels.table import RowsTable
from situ_studio.widgets.icon_widgets import Elided, ThemedButton, retheme
from situ_studio.wording.language import tr

WIDTHS = (180, 64, 52, 52, 88, 68, 78, 96)


class FieldTable(RowsTable):
    """A click on a head sorts by that column, a second one the other way round; Ctrl+C copies all
    of it as a spreadsheet takes it."""

    def __init__(self, theme: Theme) -> None:
        super().__init__(tr("Field"), titles(), WIDTHS, theme)
        self.rows.tips = tips()
        self.used: list[Used] = []
        header = self.horizontalHeader()
        header.setSectionsClickable(True)
        header.setSortIndicatorShown(True)
        header.setSortIndicator(0, Qt.SortOrder.AscendingOrder)
        header.sectionClicked.connect(self._on_head)
        self._column = 0

    def show_used(self, used: list[Used]) -> None:
        """Those rows, sorted as a person has chosen."""
        self.used = used
        self._sort()

    def copy(self) -> None:
        """All rows below their heads, into the clipboard; times in seconds, to be counted with."""
        lines = [titles(), *(cells(one, _seconds) for one in self.used)]
        QGuiApplication.clipboard().setText("\n".join(map("\t".join, lines)))

    def event(self, event: QEvent) -> bool:
        override = event.type() == QEvent.Type.ShortcutOverride
        if override and isinstance(event, QKeyEvent) and event.matches(COPY):
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.matches(COPY):
            self.copy()
        else:
            super().keyPressEvent(event)

    def _on_head(self, column: int) -> None:
        header = self.horizontalHeader()
        if column != self._column:
            # What there is most of is what is looked for.
            first = Qt.SortOrder.DescendingOrder if column in NUMBERS else ASCENDING
            header.setSortIndicator(column, first)
        self._column = column
        self._sort()

    def _sort(self) -> None:
        down = self.horizontalHeader().sortIndicatorOrder() != ASCENDING
        self.used = by_column(self.used, self._column, down)
        self.rows.exchange(rows(self.used))


def _seconds(time: float) -> str:
    return words.seconds(round(time, 1))


ASCENDING = Qt.SortOrder.AscendingOrder
COPY = QKeySequence.StandardKey.Copy


class PlaceTag(Line):
    """The tag that says where the robot is; emptied it is the usual one."""

    def __init__(self) -> None:
        super().__init__()
        self.setFixedWidth(px(132))
        self.setAccessibleName(tr("The tag that says where the robot is"))
        self.setToolTip(tr("What the robot did is counted for each place: each value of this tag"))
        self.show_value(PLACE)

    def read(self, text: str) -> str:
        tag = text.strip() or PLACE
        if not names.is_tag(tag):
            raise ValueError(tr("{0} is no tag; write it as pose.place").format(tag))
        return tag


class FieldPanel(QWidget):
    """``gone``: somebody wants to see that state, as (application, number)."""

    files_asked = Signal()
    folder_asked = Signal()
    paint_asked = Signal(bool)
    export_asked = Signal()
    place_asked = Signal(object)
    """A tag: it shall say where the robot was."""
    refused = Signal(str)
    """Why what was typed is no such tag."""
    gone = Signal(str, str)

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self.files = ThemedButton(theme, "record", tr("Recordings…"), "mend", "accent", 14)
        self.files.setToolTip(tr("Counts what people did in recorded runs"))
        self.folder = ThemedButton(theme, "folder", tr("Folder…"), "mend", "accent", 14)
        self.folder.setToolTip(tr("Counts all recordings in a folder and those below it"))
        self.paint = Flag(theme, tr("On the drawings"))
        self.paint.setToolTip(
            tr("How often, how long and where the time ran out; 0× is where nobody came")
        )
        self.copy = ThemedButton(theme, "copy", tr("Copy"), "mend", "accent", 14)
        self.copy.setToolTip(tr("The whole table, as a spreadsheet takes it (Ctrl+C)"))
        self.export = ThemedButton(theme, "export", tr("Export…"), "mend", "accent", 14)
        self.export.setToolTip(tr("The whole table into a file (CSV)"))
        self.summary = Elided()
        line = QHBoxLayout()
        line.setContentsMargins(12, 4, 12, 4)
        line.setSpacing(8)
        for button in (self.files, self.folder):
            line.addWidget(button)
        line.addStretch(1)
        on_the_right: tuple[QAbstractButton, ...] = (self.paint, self.copy, self.export)
        for widget in on_the_right:
            line.addWidget(widget)
        label = QLabel(tr("Place by"))
        label.setProperty("role", "label")
        self.place = PlaceTag()
        label.setBuddy(self.place)
        label.setToolTip(self.place.toolTip())
        below = QHBoxLayout()
        below.setContentsMargins(12, 0, 12, 4)
        below.setSpacing(8)
        below.addWidget(label)
        below.addWidget(self.place)
        below.addWidget(self.summary, 1)
        self.table = FieldTable(theme)
        self.table.when_chosen(self._on_chosen)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addLayout(line)
        column.addLayout(below)
        column.addWidget(self.table, 1)
        self.files.clicked.connect(self.files_asked)
        self.folder.clicked.connect(self.folder_asked)
        self.paint.toggled.connect(self.paint_asked)
        self.copy.clicked.connect(self.table.copy)
        self.export.clicked.connect(self.export_asked)
        self.place.committed.connect(self.place_asked)
        self.place.refused.connect(self.refused)
        self.clear()

    def set_theme(self, theme: Theme) -> None:
        self.table.set_theme(theme)
        retheme(self, theme)
        self.paint.set_theme(theme)

    def clear(self) -> None:
        """Nothing has been counted."""
        self.table.show_used([])
        self.summary.setText(tr("Nothing counted yet"))
        self.paint.setChecked(False)
        self._offer(False)

    def show_used(self, used: list[Used], recordings: int, situations: str) -> None:
        """What was counted in so many recordings. situations: how often each was current."""
        self.table.show_used(used)
        came = len({(one.application, one.state) for one in used if one.times})
        every = len({(one.application, one.state) for one in used})
        gave_up = sum(one.gave_up for one in used)
        told = [
            tr("{0} recordings").format(recordings),
            tr("came to {0} of {1} states").format(came, every),
            tr("people gave up {0}×").format(gave_up),
            *([situations] if situations else []),
        ]
        self.summary.setText(" · ".join(told))
        self._offer(True)

    def _offer(self, on: bool) -> None:
        buttons: tuple[QAbstractButton, ...] = (self.paint, self.copy, self.export)
        for button in buttons:
            button.setEnabled(on)

    def _on_chosen(self, key: str) -> None:
        used = self.table.used[int(key)]
        self.gone.emit(used.application, used.state)
