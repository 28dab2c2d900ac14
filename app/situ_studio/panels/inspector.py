"""The inspector: the form of what is selected, one form a kind."""

from __future__ import annotations

from msgspec.structs import replace
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QVBoxLayout,
    QWidget,
)

from situ.document.problem import Problem
from situ.document.project import Project
from situ_studio import kinds
from situ_studio.edits import places, words
from situ_studio.edits.edit import Document, Place
from situ_studio.edits.vocabulary import Vocabulary
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.component_sections import AlignSeveral
from situ_studio.panels.form import Form
from situ_studio.panels.header import TitleBar
from situ_studio.panels.over_scroll import OverScroll
from situ_studio.panels.subject import Subject
from situ_studio.panels.told import Told
from situ_studio.screens.devices import USUAL, Device
from situ_studio.widgets.icon_widgets import Elided, IconButton, IconLabel
from situ_studio.widgets.layouts import rule
from situ_studio.wording.language import translated


class Inspector(QWidget):
    """Shows one selected place; several or none are told in words."""

    edited = Signal(object, str, tuple)
    """The new document, the step's name, the place that is selected then."""
    place_asked = Signal(tuple)
    screen_asked = Signal(tuple)
    """As ``SectionEditor`` tells it."""
    kind_asked = Signal(tuple, str)
    """As ``Form.kind_asked``."""
    refused = Signal(str)
    align_asked = Signal(str)
    """How the selected components shall lie, as ``screens.placing.aligned`` has it."""
    file_asked = Signal(tuple, str)
    """As ``Form.file_asked``."""
    usages_asked = Signal()

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "panel")
        self.setAccessibleName(self.tr("Inspector"))
        self._theme = theme
        self._place: Place = ()
        self._moved: Place = ()
        self._form: Form | None = None
        self._subject: Subject | None = None
        self._device = USUAL
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        self.header = TitleBar(40)
        whole = QVBoxLayout(self.header)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.setSpacing(0)
        line = QHBoxLayout()
        line.setContentsMargins(12, 0, 8, 0)
        line.setSpacing(8)
        whole.addLayout(line, 1)
        whole.addWidget(rule())
        self._back = IconButton(theme, "left", self.tr("Back"), "text2", 14)
        self._back.setFixedSize(px(20), px(20))
        self._back.clicked.connect(self._on_back)
        line.addWidget(self._back, 0, Qt.AlignmentFlag.AlignVCenter)
        self._icon = IconLabel(theme, "state", "state", 18)
        line.addWidget(self._icon, 0, Qt.AlignmentFlag.AlignVCenter)
        self._title = Elided("", "subject")
        line.addWidget(self._title, 1)
        self._pill = QLabel()
        self._what = ("", "")
        """What is selected, in whole and short."""
        self._pill.setProperty("role", "pill")
        line.addWidget(self._pill, 0, Qt.AlignmentFlag.AlignVCenter)
        self.usages = IconButton(theme, "search", self.tr("Find usages"), "text3", 14)
        self.usages.setFixedSize(px(22), px(22))
        self.usages.clicked.connect(self.usages_asked)
        line.addWidget(self.usages, 0, Qt.AlignmentFlag.AlignVCenter)
        self.told = Told(theme)
        column.addWidget(self.told)
        self._words = QLabel()
        self._words.setProperty("role", "words")
        self._words.setWordWrap(True)
        self._words.setContentsMargins(12, 12, 12, 12)
        column.addWidget(self._words)
        self.several = AlignSeveral(theme)
        self.several.asked.connect(self.align_asked)
        self.several.hide()
        column.addWidget(self.several)
        self._scroll = OverScroll()
        self._scroll.setWidgetResizable(True)
        self._scroll.setFrameShape(QFrame.Shape.NoFrame)
        self._scroll.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._scroll.viewport().setProperty("role", "panel")
        column.addWidget(self._scroll, 1)
        self.show_nothing(self.tr("Nothing is selected."))

    @property
    def form(self) -> Form | None:
        """The form that is shown; None where words are."""
        return self._form

    @property
    def place(self) -> Place:
        """The place that the form shows."""
        return self._place

    def show_nothing(self, why: str, title: str = "") -> None:
        """Words instead of a form."""
        self._drop_form()
        self._back.hide()
        self._pill.hide()
        self.told.hide()
        self.several.hide()
        self._icon.set_icon("info", "text3")
        self._title.setText(title or self.tr("Inspector"))
        self._words.setText(why)
        self._words.show()

    def show_selection(
        self,
        document: Document,
        selected: tuple[Place, ...],
        vocabulary: Vocabulary,
        problems: tuple[Problem, ...] = (),
        project: Project | None = None,
    ) -> None:
        """Shows what is selected in ``document``; nothing selected is the document itself."""
        if len(selected) > 1:
            self.show_nothing(
                self.tr("Select one of them to change it."),
                self.tr("{0} selected").format(len(selected)),
            )
            if all(map(places.is_component, selected)):
                self.several.show_count(len(selected))
            return
        place = places.nearest(document, selected[0]) if selected else ()
        if self._moved and places.get(document, self._moved) is not None:
            # What the form shows has got another name: the field with the focus stays.
            place = self._moved
        value = places.get(document, place)
        kind = kinds.kind_of(value)
        while kind is None and place:
            place = place[:-1]
            value = places.get(document, place)
            kind = kinds.kind_of(value)
        if kind is None or not (kind.fields or kind.sections):
            about = translated(kind.help) if kind is not None else ""
            self.show_nothing(about or self.tr("Nothing is selected."))
            return
        if self._form is None or self._form.kind is not kind:
            self._drop_form()
            form = Form(kind, self._theme)
            form.edited.connect(self._on_edited)
            form.place_asked.connect(self.place_asked)
            form.screen_asked.connect(self.screen_asked)
            form.kind_asked.connect(self.kind_asked)
            form.refused.connect(self.refused)
            form.file_asked.connect(self.file_asked)
            self._scroll.setWidget(form)
            # setWidget makes it paint the application's grey.
            form.setAutoFillBackground(False)
            form.setProperty("role", "panel")
            form.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
            self._form = form
        self._place = place
        self._words.hide()
        self.several.hide()
        icon, tint, name, what = words.title(document, place)
        self._icon.set_icon(icon, tint)
        self._title.setText(name)
        self._what = (what, translated(kind.title))
        pill = str(kind.tint) if kind.tint != "state" else tint
        if self._pill.property("pill") != pill:
            self._pill.setProperty("pill", pill)
            self._pill.style().unpolish(self._pill)
            self._pill.style().polish(self._pill)
        self._pill.show()
        self._back.setVisible(len(place) > 2 or (place[:1] == ("always",) and len(place) > 1))
        self._fit_pill()
        self.told.show_problems(tuple(p for p in problems if p.place == place))
        self._subject = Subject(
            document=document,
            place=place,
            value=value,
            theme=self._theme,
            vocabulary=vocabulary,
            problems=problems,
            project=project,
            device=self._device,
        )
        self._form.show_subject(self._subject)

    def _fit_pill(self) -> None:
        """What it is, shorter where its name would be cut."""
        whole, short = self._what
        self._pill.setText(whole)
        self._pill.ensurePolished()
        wanted = self._title.fontMetrics().horizontalAdvance(self._title.text())
        others = [self._icon, self._pill, self.usages]
        if self._back.isVisibleTo(self):
            others.append(self._back)
        taken = sum(max(one.minimumWidth(), one.sizeHint().width()) + 8 for one in others)
        if wanted > self.width() - taken - 20:
            self._pill.setText(short)
        self._pill.setToolTip(whole if self._pill.text() != whole else "")

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit_pill()

    def look_at(self, device: Device) -> None:
        """What is told of sizes is that of this screen."""
        if device == self._device:
            return
        self._device = device
        if self._form is not None and self._subject is not None:
            self._subject = replace(self._subject, device=device)
            self._form.show_subject(self._subject)

    def set_theme(self, theme: Theme) -> None:
        """Takes the theme; the form is made anew at the next ``show_selection``."""
        self._theme = theme
        self.told.set_theme(theme)
        self._drop_form()

    def _drop_form(self) -> None:
        self._subject = None
        form = self._scroll.takeWidget()
        if form is not None:
            form.hide()
            form.deleteLater()
        self._form = None
        self._place = ()

    def _on_edited(self, document: Document, text: str, place: Place) -> None:
        self._moved = place if place != self._place else ()
        self.edited.emit(document, text, place)
        self._moved = ()

    def _on_back(self) -> None:
        place = self._place
        if place[-2:-1] == ("screen",) or place[-1:] in (("screen",), ("timeout",)):
            self.place_asked.emit(place[:-1])
        else:
            self.place_asked.emit(place[:-2])
