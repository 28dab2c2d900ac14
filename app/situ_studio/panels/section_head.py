"""The heading of a section of a form."""

from __future__ import annotations

from PySide6.QtWidgets import QHBoxLayout, QLabel

from situ_studio.kinds import Section
from situ_studio.looks.letters import px
from situ_studio.widgets.icon_widgets import Elided
from situ_studio.wording.language import translated


class SectionHead(QHBoxLayout):
    """Title and hint in one line, at whose end buttons may stand."""

    def __init__(self, section: Section) -> None:
        super().__init__()
        self.setSpacing(6)
        title = QLabel(translated(section.title))
        title.setProperty("role", "heading")
        title.setFixedHeight(px(32))
        title.setToolTip(translated(section.help))
        self.addWidget(title)
        self.addWidget(Elided(translated(section.hint), "hint"), 1)
