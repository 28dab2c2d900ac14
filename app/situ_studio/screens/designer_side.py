"""The panel at the left of the designer: what can be put on a screen, and what lies on it."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QVBoxLayout, QWidget

from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.header import PanelHeader
from situ_studio.panels.over_scroll import OverScroll
from situ_studio.screens.component_tiles import ComponentTiles
from situ_studio.screens.layers import Layers
from situ_studio.screens.tag_chips import TagChips
from situ_studio.screens.template_tiles import TemplateTiles
from situ_studio.widgets.icon_widgets import IconButton
from situ_studio.widgets.layouts import rule


class DesignerSide(OverScroll):
    """Components, templates, *On this screen* and tags, each under its heading."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName(self.tr("What is on the screen"))
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.viewport().setProperty("role", "panel")
        self.setMinimumWidth(px(200))
        page = QWidget()
        page.setProperty("role", "panel")
        self._column = QVBoxLayout(page)
        self._column.setContentsMargins(0, 0, 4, 0)
        self._column.setSpacing(0)
        self.components = ComponentTiles(theme)
        self._section(self.tr("Components"), self.tr("drag or press"), self.components)
        self.templates = TemplateTiles(theme)
        head = self._section(self.tr("Templates"), "", self.templates)
        self.keep = IconButton(
            theme, "plus", self.tr("Save this screen as a template"), "text3", 14
        )
        head.add(self.keep)
        self._more = IconButton(theme, "down", self.tr("Show all templates"), "text3", 14)
        self._more.clicked.connect(lambda: self._show_all(not self.templates.shows_all))
        head.add(self._more)
        self.layers = Layers(theme)
        self._section(self.tr("On this screen"), self.tr("front to back"), self.layers)
        self.tags = TagChips(theme)
        self._section(self.tr("Tags"), self.tr("drag into a text"), self.tags, last=True)
        self._column.addStretch(1)
        self.setWidget(page)

    def set_theme(self, theme: Theme) -> None:
        for one in (self.components, self.templates, self.layers, self.tags):
            one.set_theme(theme)

    def _section(self, title: str, hint: str, body: QWidget, last: bool = False) -> PanelHeader:
        head = PanelHeader(title, hint)
        self._column.addWidget(head)
        self._column.addWidget(body)
        if not last:
            self._column.addWidget(rule())
        return head

    def _show_all(self, every: bool) -> None:
        self.templates.show_all(every)
        words = self.tr("Show fewer templates") if every else self.tr("Show all templates")
        self._more.show_icon("up" if every else "down", words)
