"""Sections of a component's form that are no fields: how it is aligned, whether it is fit for
fingers and eyes, and what a touch of it leads to.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QSizePolicy, QVBoxLayout, QWidget

from situ.document import rbd
from situ_studio.edits import places, words
from situ_studio.kinds import Section
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.section_head import SectionHead
from situ_studio.panels.subject import MARGIN, Subject
from situ_studio.screens import placing
from situ_studio.screens.devices import USUAL
from situ_studio.screens.fitness import fits
from situ_studio.widgets.icon_widgets import Elided, IconButton, IconLabel, ThemedButton
from situ_studio.widgets.layouts import clear


class ComponentSection(QWidget):
    """A heading, and what is below it in ``body``."""

    edited = Signal(object, str, tuple)
    """The new document, the step's name, the place that is selected then."""
    place_asked = Signal(tuple)

    def __init__(self, section: Section, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.section = section
        self.theme = theme
        self.subject: Subject | None = None
        column = QVBoxLayout(self)
        column.setContentsMargins(MARGIN, 0, MARGIN, 8)
        column.setSpacing(0)
        column.addLayout(SectionHead(section))
        self.body = QVBoxLayout()
        self.body.setSpacing(4)
        column.addLayout(self.body)

    def show_subject(self, subject: Subject) -> None:
        self.subject = subject


class EdgeButtons(QWidget):
    """A row of buttons. pressed: an edge, as ``screens.placing.aligned`` has it."""

    pressed = Signal(str)

    def __init__(self, theme: Theme, edges: dict[str, tuple[str, str]]) -> None:
        """edges: each with its icon and its words."""
        super().__init__()
        line = QHBoxLayout(self)
        line.setContentsMargins(0, 0, 0, 0)
        line.setSpacing(4)
        self.buttons: dict[str, IconButton] = {}
        for edge, (icon, said) in edges.items():
            button = IconButton(theme, icon, said, "text2", 16)
            button.setProperty("role", "cell")
            button.setMinimumSize(px(24), px(28))
            button.setMaximumSize(px(400), px(28))
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            button.clicked.connect(lambda _=False, e=edge: self.pressed.emit(e))
            line.addWidget(button, 1)
            self.buttons[edge] = button


class AlignRow(ComponentSection):
    """One button an edge: the component goes there, of the screen."""

    def __init__(self, section: Section, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(section, theme, parent)
        row = EdgeButtons(
            theme,
            {
                "left": ("align_left", self.tr("To the left edge of the screen")),
                "center": ("align_center", self.tr("To the middle, across")),
                "right": ("align_right", self.tr("To the right edge of the screen")),
                "top": ("align_top", self.tr("To the upper edge of the screen")),
                "middle": ("align_middle", self.tr("To the middle, up and down")),
                "bottom": ("align_bottom", self.tr("To the lower edge of the screen")),
            },
        )
        row.pressed.connect(self._align)
        self.buttons = row.buttons
        self.body.addWidget(row)

    def _align(self, edge: str) -> None:
        subject = self.subject
        if subject is None:
            return
        value = subject.value
        box = placing.aligned({value.id: placing.box_of(value)}, edge)[value.id]
        if box == placing.box_of(value):
            return
        after = places.change(subject.document, subject.place, **box._asdict())
        self.edited.emit(after, self.tr("Align {0}").format(value.id), subject.place)


class AlignSeveral(QWidget):
    """Of several components that are selected: aligned among themselves, or spread evenly.

    asked: an edge, as ``screens.placing.aligned`` has it.
    """

    asked = Signal(str)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        column = QVBoxLayout(self)
        column.setContentsMargins(MARGIN, 4, MARGIN, 12)
        column.setSpacing(4)
        title = QLabel(self.tr("Align"))
        title.setProperty("role", "heading")
        column.addWidget(title)
        self.edges = EdgeButtons(
            theme,
            {
                "left": ("align_left", self.tr("Left edges")),
                "center": ("align_center", self.tr("Middles, one above the other")),
                "right": ("align_right", self.tr("Right edges")),
                "top": ("align_top", self.tr("Upper edges")),
                "middle": ("align_middle", self.tr("Middles, side by side")),
                "bottom": ("align_bottom", self.tr("Lower edges")),
            },
        )
        self.gaps = EdgeButtons(
            theme,
            {
                "across": ("distribute", self.tr("Evenly side by side")),
                "down": ("distribute_down", self.tr("Evenly one above the other")),
            },
        )
        for row in (self.edges, self.gaps):
            row.pressed.connect(self.asked)
            column.addWidget(row)

    def show_count(self, count: int) -> None:
        """How many are selected; three at least can be spread."""
        self.setVisible(count > 1)
        for button in self.gaps.buttons.values():
            button.setEnabled(count > 2)


class FitList(ComponentSection):
    """A line for each thing that was looked at, with a tick or a warning before it."""

    def show_subject(self, subject: Subject) -> None:
        super().show_subject(subject)
        clear(self.body)
        document, project = subject.document, subject.project
        screen = places.get(document, subject.place[:-1])
        if not isinstance(document, rbd.Application) or project is None:
            self.hide()
            return
        file = next((f for f, one in project.flows.items() if one is document), "")
        found = fits(project, file, document, screen, subject.value, subject.device)
        if found and subject.device != USUAL:
            said = Elided(self.tr("On this screen: {0}").format(subject.device.words), "hint")
            self.body.addWidget(said)
        for one in found:
            sign = self.tr("All right") if one.is_fit else self.tr("Warning")
            self.body.addLayout(_told(self.theme, one.is_fit, one.words, sign))
        self.setVisible(bool(found))


def _told(theme: Theme, well: bool, said: str, sign: str) -> QHBoxLayout:
    line = QHBoxLayout()
    line.setSpacing(8)
    icon, token = ("check", "live") if well else ("warning", "warning")
    line.addWidget(IconLabel(theme, icon, token, 14), 0, Qt.AlignmentFlag.AlignTop)
    words_ = QLabel(said)
    words_.setProperty("role", "words")
    words_.setWordWrap(True)
    words_.setAccessibleName(f"{sign}: {said}")
    line.addWidget(words_, 1)
    return line


class WhenTouched(ComponentSection):
    """The event that a component raises, where it leads, and whether the state expects it."""

    def show_subject(self, subject: Subject) -> None:
        super().show_subject(subject)
        clear(self.body)
        value, document = subject.value, subject.document
        name = getattr(value, "event", None) or getattr(value, "done", None)
        part = places.get(document, places.root(subject.place))
        self.setVisible(bool(name) and isinstance(document, rbd.Application))
        if not name or not isinstance(document, rbd.Application):
            return
        answers = _answers(document, part, name)
        for place, target, said in answers:
            self._row(name, said, place, target)
        if answers:
            said = self.tr("The state expects it")
            self.body.addLayout(_told(self.theme, True, said, self.tr("All right")))
            return
        said = self.tr("The state does not expect {0}: nothing happens.").format(name)
        self.body.addLayout(_told(self.theme, False, said, self.tr("Warning")))
        mend = QPushButton(self.tr("Expect {0}").format(name))
        mend.setProperty("role", "mend")
        mend.setToolTip(self.tr("The state gets this event; say then where it leads"))
        mend.clicked.connect(lambda _=False: self._expect(name))
        self.body.addWidget(mend, 0, Qt.AlignmentFlag.AlignLeft)

    def _row(self, name: str, target: str, place: tuple[str, ...], to: str | None) -> None:
        button = ThemedButton(self.theme, "event", f"{name}  ›  {target}", "answer", "text2", 14)
        button.setAccessibleName(self.tr("{0} leads to {1}").format(name, target))
        wanted = ("state", to) if to is not None else place
        tip = self.tr("Go there") if to is not None else self.tr("Show the event")
        button.setToolTip(tip)
        button.clicked.connect(lambda _=False: self.place_asked.emit(wanted))
        self.body.addWidget(button)

    def _expect(self, name: str) -> None:
        subject = self.subject
        if subject is None:
            return
        root = places.root(subject.place)
        part = places.get(subject.document, root)
        events = (*part.events, rbd.Event(name=name))
        after = places.change(subject.document, root, events=events)
        where = words.place_words(subject.document, root)
        self.edited.emit(after, self.tr("Expect {0} in {1}").format(name, where), subject.place)


def _answers(
    application: rbd.Application, part: Any, name: str
) -> list[tuple[tuple[str, ...], str | None, str]]:
    """What a state does with an event: the places of what expects it, the state to which it leads
    (None: to none that is known), and that in words.
    """
    found = []
    always = application.always
    for owner, holder in (
        (("state", part.no) if isinstance(part, rbd.State) else ("always",), part),
        (("always",), always if isinstance(part, rbd.State) and part.always else None),
    ):
        for at, event in enumerate(holder.events if holder is not None else ()):
            if event.name == name:
                known = event.next is not None and application.state(event.next) is not None
                place = (*owner, "event", str(at))
                said = words.leads_to(application, event.next)
                found.append((place, event.next if known else None, said))
    return found


SECTIONS: dict[str, Callable[[Section, Theme, QWidget | None], ComponentSection]] = {
    "align": AlignRow,
    "fit": FitList,
    "touched": WhenTouched,
}
"""By the editor of the kinds' table."""
