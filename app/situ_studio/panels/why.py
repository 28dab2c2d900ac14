"""Why?: what led to something the robot did, or what kept it from it, a row for each link."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QVBoxLayout, QWidget

from situ_studio.assistive.announcing import announce
from situ_studio.edits.edit import Place
from situ_studio.looks.theme import Theme
from situ_studio.panels.table import Row, RowsTable
from situ_studio.wording.language import tr


class Link(Struct, frozen=True):
    """An event of a chain of causes, or a reason. t: seconds of the trace, ``at`` how that is
    written. values: what it hung on, then.

    where: the file and place that it is about; None where it is about none.
    """

    t: float
    at: str
    words: str
    values: str = ""
    where: tuple[str, Place] | None = None


class Why(QWidget):
    """Shows one answer, and tells which link of it a person chose."""

    chosen = Signal(object)
    """A ``Link``."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "panel")
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        line = QHBoxLayout()
        line.setContentsMargins(12, 6, 12, 6)
        line.setSpacing(12)
        self.title, self.more = QLabel(), QLabel()
        self.title.setProperty("role", "subject")
        self.more.setProperty("role", "dim")
        self.more.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        for label in (self.title, self.more):
            label.setTextFormat(Qt.TextFormat.PlainText)
            label.setWordWrap(True)
            line.addWidget(label, 1)
        column.addLayout(line)
        titles = (tr("Time"), tr("What happened"), tr("Values then"))
        self.table = RowsTable(tr("Why?"), titles, (90, 400), theme)
        self.table.rows.tips = (
            tr("When it happened: by the clock, or in seconds since the robot started."),
            tr("What it was, the input that began it first."),
            tr("The values that decided it, as they were then."),
        )
        self.table.when_chosen(self._on_chosen)
        column.addWidget(self.table, 1)
        self.links: tuple[Link, ...] = ()
        self.reset()

    def set_theme(self, theme: Theme) -> None:
        self.table.set_theme(theme)

    def reset(self) -> None:
        """Nothing was asked."""
        title = tr("Ask Why? of a card, an arrow or a row.")
        more = tr("It is in their menus; F7 and Shift+F7 ask for what is selected.")
        self._show(title, more, ())

    def tell(self, title: str, more: str = "") -> None:
        """Words, and no chain."""
        self._show(title, more, ())
        announce(self, ". ".join(filter(None, (title, more))))

    def answer(self, title: str, more: str, links: Sequence[Link], asked: int) -> None:
        """A chain. asked: its link that answers first of all; it is current."""
        self._show(title, more, tuple(links), asked)
        index = self.table.rows.index(asked, 0)
        self.table.setCurrentIndex(index)
        self.table.scrollTo(index)
        # The whole chain is in the table; what was asked for is heard at once.
        heard = (title, more, links[asked].words, links[asked].values) if links else (title, more)
        announce(self, ". ".join(one.strip() for one in heard if one.strip()))

    def _show(self, title: str, more: str, links: tuple[Link, ...], asked: int = 0) -> None:
        self.title.setText(title)
        self.title.setToolTip(title)
        self.more.setText(more)
        self.links = links
        self.table.rows.show(
            [
                Row(str(n), (link.at, link.words, link.values), n == asked)
                for n, link in enumerate(links)
            ]
        )
        for link in links:
            self.table.make_room(0, link.at)

    def _on_chosen(self, key: str) -> None:
        self.chosen.emit(self.links[int(key)])
