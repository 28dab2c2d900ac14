"""The welcome page: what one can start with."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from PySide6.QtCore import QRectF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QPainter, QPaintEvent, QResizeEvent, QShowEvent
from PySide6.QtWidgets import (
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QScrollArea,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from situ.resources import templates
from situ_studio.looks import icons
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.tabs import Segments
from situ_studio.welcome.project_pictures import Example, Picture, SmallPictures, project_picture
from situ_studio.welcome.recent_list import RecentList
from situ_studio.welcome.welcome_cards import START, Choice, ExampleCard, Press
from situ_studio.widgets.icon_widgets import ThemedButton
from situ_studio.widgets.layouts import clear
from situ_studio.wording.language import LANGUAGES

MOST, EDGE, GAP = 1160, 24, 16
"""Px: how wide the page becomes, what is left beside it, and between its cards."""
NARROWEST = 232
"""Px that the card of an example is wide at the least."""


class Mark(QWidget):
    """The studio's own sign."""

    def __init__(self) -> None:
        super().__init__()
        self.setFixedSize(px(56), px(56))

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        icons.paint(painter, "situ", QRectF(self.rect()), "#FFFFFF")
        painter.end()


class Welcome(QScrollArea):
    """Tells what a person wants to start with."""

    back_asked = Signal()
    new_asked = Signal()
    open_asked = Signal()
    connect_asked = Signal()
    recent_asked = Signal(str)
    forget_asked = Signal(str)
    """That project is to be taken off the list of recent ones."""
    locate_asked = Signal(str)
    """That project is not where it was: a person says where it is now."""
    example_asked = Signal(str)
    template_asked = Signal(str)
    theme_asked = Signal(str)
    language_asked = Signal(str)
    tutorial_asked = Signal()
    help_asked = Signal()

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self.pictures = SmallPictures(self, project_picture)
        self._cards: list[ExampleCard] = []
        self._choices: list[Choice] = []
        """The templates."""
        self.setAccessibleName(self.tr("Welcome"))
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setProperty("role", "page")
        page = QWidget()
        page.setProperty("role", "page")
        outer = QHBoxLayout(page)
        outer.setContentsMargins(EDGE, 0, EDGE, 0)
        outer.addStretch(1)
        middle = QWidget()
        middle.setMaximumWidth(px(MOST))
        middle.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        outer.addWidget(middle, 100)
        outer.addStretch(1)
        self.setWidget(page)
        column = QVBoxLayout(middle)
        column.setContentsMargins(0, 40, 0, 24)
        column.setSpacing(0)
        column.addLayout(self._head())
        column.addSpacing(32)
        body = QHBoxLayout()
        body.setSpacing(2 * GAP)
        body.addLayout(self._start())
        body.addLayout(self._examples_side(), 1)
        column.addLayout(body)
        column.addSpacing(24)
        column.addLayout(self._templates_below())
        column.addStretch(1)
        column.addSpacing(24)
        foot = QHBoxLayout()
        foot.setSpacing(24)
        # The words of the first one stand below the column, not its edge.
        foot.setContentsMargins(-8, 0, 0, 0)
        self.tutorial = ThemedButton(
            theme, "play", self.tr("Tutorial, a quarter of an hour"), "link", "accent"
        )
        self.tutorial.setToolTip(self.tr("A first robot from nothing, one step at a time"))
        self.tutorial.clicked.connect(self.tutorial_asked)
        foot.addWidget(self.tutorial)
        self.help = ThemedButton(theme, "help", self.tr("First steps"), "link")
        self.help.setToolTip(self.tr("What a project is, and how one begins; F1 explains the rest"))
        self.help.clicked.connect(self.help_asked)
        foot.addWidget(self.help)
        foot.addStretch(1)
        self.languages = Segments(
            theme,
            tuple((code, "", name) for code, name in LANGUAGES.items()),
            self.tr("Language"),
        )
        self.languages.chosen.connect(self.language_asked)
        foot.addWidget(self.languages)
        self.themes = Segments(
            theme,
            (
                ("system", "", self.tr("Like the system")),
                ("light", "", self.tr("Light")),
                ("dark", "", self.tr("Dark")),
            ),
            self.tr("Colours"),
        )
        self.themes.chosen.connect(self.theme_asked)
        foot.addWidget(self.themes)
        column.addLayout(foot)

    def _head(self) -> QHBoxLayout:
        line = QHBoxLayout()
        line.setSpacing(20)
        line.addWidget(Mark())
        words = QVBoxLayout()
        words.setSpacing(0)
        title = QLabel(self.tr("Welcome to Situ Studio"))
        title.setProperty("role", "welcome")
        words.addWidget(title)
        lead = QLabel(self.tr("Draw what a robot says, shows and does, and watch it live."))
        lead.setProperty("role", "lead")
        words.addWidget(lead)
        line.addLayout(words, 1)
        return line

    def _heading(self, words: str, hint: str = "") -> QHBoxLayout:
        line = QHBoxLayout()
        line.setContentsMargins(0, 0, 0, 8)
        line.setSpacing(8)
        title = QLabel(words)
        title.setProperty("role", "strong")
        line.addWidget(title)
        below = QLabel(hint)
        below.setProperty("role", "hint")
        line.addWidget(below)
        line.addStretch(1)
        return line

    def _start(self) -> QVBoxLayout:
        column = QVBoxLayout()
        column.setSpacing(8)
        self.back: Press | None = None
        self._back = QVBoxLayout()
        self._back.setSpacing(8)
        column.addLayout(self._back)
        column.addLayout(self._heading(self.tr("Start")))
        self.new = Choice(
            self._theme,
            "plus",
            self.tr("New project"),
            self.tr("An empty one to start from"),
            "Ctrl N",
            role="first",
        )
        self.new.pressed.connect(self.new_asked)
        column.addWidget(self.new)
        self.open = Choice(
            self._theme,
            "folder",
            self.tr("Open a project"),
            self.tr("A folder with situ.toml"),
            "Ctrl O",
        )
        self.open.pressed.connect(self.open_asked)
        column.addWidget(self.open)
        self.connect_robot = Choice(
            self._theme,
            "link",
            self.tr("Connect to a robot"),
            self.tr("Found nearby, or by its address"),
            "Ctrl R",
        )
        self.connect_robot.pressed.connect(self.connect_asked)
        self.connect_robot.hide()
        column.addWidget(self.connect_robot)
        column.addSpacing(16)
        column.addLayout(self._heading(self.tr("Recent")))
        self.recent = RecentList(self._theme, self.pictures)
        self.recent.asked.connect(self.recent_asked)
        self.recent.forget_asked.connect(self.forget_asked)
        self.recent.locate_asked.connect(self.locate_asked)
        column.addWidget(self.recent)
        column.addStretch(1)
        return column

    def _examples_side(self) -> QVBoxLayout:
        column = QVBoxLayout()
        column.setSpacing(8)
        column.addLayout(
            self._heading(self.tr("Open an example"), self.tr("a copy is made, so try anything"))
        )
        self._examples = QGridLayout()
        self._examples.setSpacing(GAP)
        column.addLayout(self._examples)
        column.addStretch(1)
        return column

    def _templates_below(self) -> QVBoxLayout:
        column = QVBoxLayout()
        column.setSpacing(8)
        column.addLayout(self._heading(self.tr("New from a template")))
        self._templates = QGridLayout()
        self._templates.setSpacing(GAP)
        # All of resources/templates but the empty one, which is the new project above.
        for name, icon, title, below in (
            (
                "reception",
                "screen",
                self.tr("Question and answers"),
                self.tr("Ask, wait, thank"),
            ),
            ("menu", "list", self.tr("Main menu"), self.tr("Services to choose from")),
            (
                "reminder",
                "timeout",
                self.tr("Medication reminder"),
                self.tr("Once a day, else a nurse"),
            ),
            (
                "conversation",
                "situation",
                self.tr("Modules that share a robot"),
                self.tr("Situations, priorities, a stop"),
            ),
        ):
            picture = self.pictures.picture(self._theme, icon, str(templates()[name]))
            card = Choice(self._theme, picture, title, below)
            card.setObjectName(f"template {name}")
            card.pressed.connect(partial(self.template_asked.emit, name))
            card.take_all_room()
            self._choices.append(card)
            self._templates.addWidget(card)
        column.addLayout(self._templates)
        return column

    # -- contents ------------------------------------------------------------------

    def show_examples(self, examples: list[Example]) -> None:
        """One card each."""
        clear(self._examples)
        self._cards = [ExampleCard(self._theme, one) for one in examples]
        for one, card in zip(examples, self._cards, strict=True):
            card.pressed.connect(partial(self.example_asked.emit, one.name))
        self._place_cards()

    def _place_cards(self) -> None:
        """As many side by side as have room."""
        room = min(self.viewport().width() - 2 * EDGE, px(MOST))
        _place(self._examples, self._cards, room - px(START) - 2 * GAP)
        _place(self._templates, self._choices, room)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._place_cards()

    def example(self, name: str) -> Press:
        """The card of an example; LookupError where there is none."""
        return self._named(f"example {name}")

    def template(self, name: str) -> Press:
        """The card of a template; LookupError where there is none."""
        return self._named(f"template {name}")

    def _named(self, name: str) -> Press:
        for press in self.findChildren(Press):
            if press.objectName() == name:
                return press
        raise LookupError(name)

    def show_back(self, name: str | None) -> None:
        """The way back to the project that is open; None: there is none."""
        clear(self._back)
        self.back = None
        if name is not None:
            title = self.tr("Back to {0}").format(name)
            below = self.tr("It is still open")
            self.back = Choice(self._theme, "left", title, below, "Esc")
            self.back.pressed.connect(self.back_asked)
            self._back.addWidget(self.back)
            self._back.addSpacing(16)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.back_asked.emit()
        else:
            super().keyPressEvent(event)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.pictures.go_on()

    def show_connect(self, shown: bool) -> None:
        """Whether a robot can be connected to from here."""
        self.connect_robot.setVisible(shown)

    def set_theme(self, theme: Theme) -> None:
        self._theme = self.recent.theme = theme
        for picture in self.findChildren(Picture):
            picture.set_theme(theme)


def _place(grid: QGridLayout, cards: Sequence[QWidget], room: int) -> None:
    """Puts cards into a grid of so many px: as many side by side as have room."""
    many = max(1, min(len(cards), (room + GAP) // (px(NARROWEST) + GAP)))
    for at, card in enumerate(cards):
        grid.addWidget(card, at // many, at % many)
    for column in range(len(cards)):
        grid.setColumnStretch(column, int(column < many))
