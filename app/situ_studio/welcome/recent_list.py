"""The projects that were open lately, on the welcome page."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import datetime
from functools import partial
from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.welcome import recent
from situ_studio.welcome.project_pictures import SmallPictures
from situ_studio.welcome.welcome_cards import START, Choice, two_lines
from situ_studio.widgets.icon_widgets import Elided, IconButton, IconLabel
from situ_studio.widgets.layouts import clear

MOST, HIGH = 5, 56
"""How many are listed, and px that each is high."""


class RecentList(QWidget):
    """A card each, the last one first; of one whose folder is gone, what can be done about it.

    theme: of what is shown next.
    """

    asked = Signal(str)
    """The project at that path is to be opened."""
    forget_asked = Signal(str)
    """It is to be taken off the list."""
    locate_asked = Signal(str)
    """It is not where it was: a person says where it is now."""

    def __init__(self, theme: Theme, pictures: SmallPictures) -> None:
        super().__init__()
        self.theme = theme
        self._pictures = pictures
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(0, 0, 0, 0)
        self._column.setSpacing(8)

    def show_projects(self, paths: list[str], times: Mapping[str, datetime], now: datetime) -> None:
        """times: when they were open, as far as that is known."""
        clear(self._column)
        for path in paths[:MOST]:
            at = recent.ago(times[path], now) if path in times else ""
            card, line = self._there(path, at) if Path(path).exists() else self._gone(path)
            card.setToolTip(path)
            card.setFixedSize(px(START), px(HIGH))
            off = IconButton(self.theme, "close", self.tr("Remove from the list"), "text3", 14)
            off.setObjectName(f"forget {path}")
            off.clicked.connect(partial(self.forget_asked.emit, path))
            line.addWidget(off)
            self._column.addWidget(card)
        if not paths:
            self._column.addWidget(self._none())

    def _there(self, path: str, at: str) -> tuple[QFrame, QHBoxLayout]:
        picture = self._pictures.picture(self.theme, "history", path)
        card = Choice(self.theme, picture, Path(path).name, at or path)
        card.pressed.connect(partial(self.asked.emit, path))
        return card, card.line

    def _gone(self, path: str) -> tuple[QFrame, QHBoxLayout]:
        """A project whose folder is not there: removed, renamed, or its drive is away."""
        card, line = _empty()
        line.setSpacing(14)
        line.addWidget(IconLabel(self.theme, "warning", "text3", 20))
        name = Elided(Path(path).name, "dim")
        line.addLayout(two_lines(name, Elided(self.tr("Not there any more"), "label")), 1)
        locate = QPushButton(self.tr("Locate…"))
        locate.setObjectName(f"locate {path}")
        locate.setProperty("role", "mend")
        locate.setToolTip(self.tr("Say where this project is now"))
        locate.clicked.connect(partial(self.locate_asked.emit, path))
        line.addWidget(locate)
        return card, line

    def _none(self) -> QFrame:
        card, line = _empty()
        card.setFixedSize(px(START), px(HIGH))
        words = QLabel(self.tr("Projects that you open will be listed here."))
        words.setProperty("role", "dim")
        line.addWidget(words)
        return card


def _empty() -> tuple[QFrame, QHBoxLayout]:
    card = QFrame()
    card.setProperty("role", "empty")
    line = QHBoxLayout(card)
    line.setContentsMargins(16, 0, 16, 0)
    return card, line
