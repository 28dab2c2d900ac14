"""The welcome page: what one can start with."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from datetime import datetime
from functools import partial
from pathlib import Path

import shiboken6
from PySide6.QtCore import QRectF, Qt, QTimer, Signal
from PySide6.QtGui import (
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QResizeEvent,
    QShowEvent,
)
from PySide6.QtWidgets import (
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from situ.document.rbd import Application
from situ.document.spds import Spds
from situ.resources import templates
from situ_studio import icons, recent
from situ_studio.icon_widgets import Elided, IconButton, IconLabel
from situ_studio.language import LANGUAGES
from situ_studio.layouts import clear
from situ_studio.letters import px
from situ_studio.project_pictures import (
    Example,
    LargePicture,
    Picture,
    SmallPicture,
    facts,
    project_picture,
)
from situ_studio.tabs import Segments
from situ_studio.theme import Theme

MOST, EDGE, GAP = 1160, 24, 16
"""Px: how wide the page becomes, what is left beside it, and between its cards."""
START, NARROWEST = 324, 232
"""Px that a choice is wide, and a card of an example at the least."""


class Press(QFrame):
    """A frame that acts as a button."""

    pressed = Signal()

    def __init__(self, role: str, words: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", role)
        self.setAccessibleName(words)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setCursor(Qt.CursorShape.PointingHandCursor)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self.rect().contains(event.position().toPoint()):
            self.pressed.emit()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space):
            self.pressed.emit()
        else:
            super().keyPressEvent(event)


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
    """Tells what a person wants to start with.

    read: gives what the small picture of a project shows; it may take its time.
    """

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

    def __init__(
        self,
        theme: Theme,
        read: Callable[[str], Application | Spds | None] = project_picture,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._theme = theme
        self._read = read
        self._unread: list[tuple[SmallPicture, str]] = []
        self._cards: list[Press] = []
        self._read_soon = QTimer(self)
        self._read_soon.setSingleShot(True)
        self._read_soon.timeout.connect(self._read_next)
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
        column.addSpacing(32)
        column.addLayout(self._templates())
        column.addStretch(1)
        column.addSpacing(24)
        foot = QHBoxLayout()
        foot.setSpacing(24)
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
        self.new = self._choice(
            "first",
            "plus",
            self.tr("New project"),
            self.tr("An empty one to start from"),
            "Ctrl N",
            self.new_asked.emit,
        )
        column.addWidget(self.new)
        self.open = self._choice(
            "card",
            "folder",
            self.tr("Open a project"),
            self.tr("A folder with situ.toml"),
            "Ctrl O",
            self.open_asked.emit,
        )
        column.addWidget(self.open)
        self.connect_robot = self._choice(
            "card",
            "link",
            self.tr("Connect to a robot"),
            self.tr("By its address"),
            "Ctrl R",
            self.connect_asked.emit,
        )
        self.connect_robot.hide()
        column.addWidget(self.connect_robot)
        column.addSpacing(16)
        column.addLayout(self._heading(self.tr("Recent")))
        self._recent = QVBoxLayout()
        self._recent.setSpacing(8)
        column.addLayout(self._recent)
        column.addStretch(1)
        return column

    def _choice(
        self,
        role: str,
        icon: str | Picture,
        title: str,
        below: str,
        keys: str,
        pressed: Callable[[], object],
    ) -> Press:
        press = Press(role, title)
        press.setAccessibleDescription(below)
        press.setFixedSize(px(START), px(64))
        press.pressed.connect(pressed)
        line = QHBoxLayout(press)
        line.setContentsMargins(16, 0, 16, 0)
        line.setSpacing(14)
        token = "on_accent" if role == "first" else "accent"
        if isinstance(icon, Picture):
            line.setContentsMargins(12, 0, 12, 0)
            line.addWidget(icon)
        else:
            line.addWidget(IconLabel(self._theme, icon, token, 20))
        words = QVBoxLayout()
        words.setSpacing(0)
        words.addStretch(1)
        name = Elided(title, "strong")
        words.addWidget(name)
        words.addWidget(Elided(below, "label"))
        words.addStretch(1)
        line.addLayout(words, 1)
        if keys:
            label = QLabel(keys)
            label.setProperty("role", "kbd")
            line.addWidget(label, 0, Qt.AlignmentFlag.AlignVCenter)
        return press

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

    def _templates(self) -> QVBoxLayout:
        column = QVBoxLayout()
        column.setSpacing(8)
        column.addLayout(self._heading(self.tr("New from a template")))
        row = QHBoxLayout()
        row.setSpacing(16)
        # All of resources/templates but the empty one, which is the new project above.
        for name, icon, title, below in (
            (
                "reception",
                "screen",
                self.tr("Question and answers"),
                self.tr("Screens, a way home, a timeout"),
            ),
            (
                "conversation",
                "situation",
                self.tr("Modules that share a robot"),
                self.tr("Situations, priorities, a stop"),
            ),
        ):
            asked = partial(self.template_asked.emit, name)
            picture = self._picture(icon, str(templates()[name]))
            press = self._choice("card", picture, title, below, "", asked)
            press.setObjectName(f"template {name}")
            row.addWidget(press)
        row.addStretch(1)
        column.addLayout(row)
        return column

    # -- contents ------------------------------------------------------------------

    def show_examples(self, examples: list[Example]) -> None:
        """One card each."""
        clear(self._examples)
        self._cards = [self._example(one) for one in examples]
        self._place_examples()

    def _place_examples(self) -> None:
        """As many side by side as have room."""
        room = min(self.viewport().width() - 2 * EDGE, px(MOST)) - px(START) - 2 * GAP
        many = max(1, min(len(self._cards), (room + GAP) // (px(NARROWEST) + GAP)))
        for at, card in enumerate(self._cards):
            self._examples.addWidget(card, at // many, at % many)
        for column in range(len(self._cards)):
            self._examples.setColumnStretch(column, int(column < many))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._place_examples()

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

    def _example(self, one: Example) -> Press:
        title = one.name.replace("-", " ").capitalize()
        press = Press("card", self.tr("Open a copy of the example {0}").format(title))
        press.setObjectName(f"example {one.name}")
        press.pressed.connect(lambda: self.example_asked.emit(one.name))
        column = QVBoxLayout(press)
        column.setContentsMargins(1, 1, 1, 1)
        column.setSpacing(0)
        column.addWidget(LargePicture(self._theme, one.document))
        words = QVBoxLayout()
        words.setContentsMargins(16, 12, 16, 14)
        words.setSpacing(4)
        line = QHBoxLayout()
        line.setSpacing(8)
        script = isinstance(one.document, Spds)
        kind = "situation" if script else "state"
        line.addWidget(IconLabel(self._theme, kind, kind, 18))
        name = QLabel(title)
        name.setProperty("role", "section")
        line.addWidget(name)
        line.addStretch(1)
        count = QLabel(facts(one.document))
        count.setProperty("role", "hint")
        line.addWidget(count)
        words.addLayout(line)
        about = QLabel(one.about)
        about.setProperty("role", "dim")
        about.setWordWrap(True)
        about.setMinimumHeight(px(40))
        about.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        words.addWidget(about)
        words.addStretch(1)
        column.addLayout(words)
        return press

    def show_back(self, name: str | None) -> None:
        """The way back to the project that is open; None: there is none."""
        clear(self._back)
        self.back = None
        if name is not None:
            title = self.tr("Back to {0}").format(name)
            below = self.tr("It is still open")
            self.back = self._choice("card", "left", title, below, "Esc", self.back_asked.emit)
            self._back.addWidget(self.back)
            self._back.addSpacing(16)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.back_asked.emit()
        else:
            super().keyPressEvent(event)

    def _picture(self, icon: str, path: str) -> SmallPicture:
        """A small picture of the project at ``path``, which is read when there is time."""
        made = SmallPicture(self._theme, icon)
        self._unread.append((made, path))
        self._read_soon.start()
        return made

    @property
    def reads(self) -> bool:
        """Whether there are pictures that are still to be read."""
        return bool(self._unread)

    def _read_next(self) -> None:
        """Reads one project at a time, so that the page is there at once and never stands still."""
        if not self._unread or not self.isVisible():
            return
        picture, path = self._unread.pop(0)
        if shiboken6.isValid(picture):
            picture.show_document(self._read(path))
        self._read_soon.start()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._read_soon.start()

    def show_recent(self, paths: list[str], times: Mapping[str, datetime], now: datetime) -> None:
        """The projects that were open lately, the last one first. times: when, of some of them."""
        clear(self._recent)
        for path in paths[:5]:
            asked = partial(self.recent_asked.emit, path)
            if Path(path).exists():
                picture = self._picture("history", path)
                when = recent.ago(times[path], now) if path in times else ""
                card: QFrame = self._choice(
                    "card", picture, Path(path).name, when or path, "", asked
                )
                card.setToolTip(path)
            else:
                card = self._gone(path)
            card.setFixedSize(px(START), px(56))
            off = IconButton(self._theme, "close", self.tr("Remove from the list"), "text3", 14)
            off.setObjectName(f"forget {path}")
            off.clicked.connect(partial(self.forget_asked.emit, path))
            line = card.layout()
            assert line is not None
            line.addWidget(off)
            self._recent.addWidget(card)
        if paths:
            return
        empty = QFrame()
        empty.setProperty("role", "empty")
        empty.setFixedSize(px(START), px(56))
        line = QHBoxLayout(empty)
        line.setContentsMargins(16, 0, 16, 0)
        words = QLabel(self.tr("Projects that you open will be listed here."))
        words.setProperty("role", "dim")
        line.addWidget(words)
        self._recent.addWidget(empty)

    def _gone(self, path: str) -> QFrame:
        """A recent project whose folder is not there: removed, renamed, or its drive is away."""
        card = QFrame()
        card.setProperty("role", "empty")
        card.setToolTip(path)
        line = QHBoxLayout(card)
        line.setContentsMargins(16, 0, 16, 0)
        line.setSpacing(14)
        line.addWidget(IconLabel(self._theme, "warning", "text3", 20))
        words = QVBoxLayout()
        words.setSpacing(0)
        words.addStretch(1)
        words.addWidget(Elided(Path(path).name, "dim"))
        words.addWidget(Elided(self.tr("Not there any more"), "label"))
        words.addStretch(1)
        line.addLayout(words, 1)
        locate = QPushButton(self.tr("Locate…"))
        locate.setObjectName(f"locate {path}")
        locate.setProperty("role", "mend")
        locate.setToolTip(self.tr("Say where this project is now"))
        locate.clicked.connect(partial(self.locate_asked.emit, path))
        line.addWidget(locate)
        return card

    def show_connect(self, shown: bool) -> None:
        """Whether a robot can be connected to from here."""
        self.connect_robot.setVisible(shown)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        for picture in self.findChildren(Picture):
            picture.set_theme(theme)
