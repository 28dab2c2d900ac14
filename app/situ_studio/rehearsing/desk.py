"""The rehearsal desk: the robot's screen to touch, what it says, and all that the world can do."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QLayout,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from situ.decide import inputs
from situ.document.project import Project
from situ.document.values import read
from situ.rehearse.scenario import WRITER
from situ_studio import kinds
from situ_studio.assistive.heard_as import hear_as
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import Flag
from situ_studio.panels.over_scroll import OverScroll
from situ_studio.rehearsing.answers import USUAL, example, known
from situ_studio.rehearsing.clock_bar import ClockBar
from situ_studio.rehearsing.course import Course, Pending
from situ_studio.rehearsing.dial_rows import DialRow
from situ_studio.rehearsing.dials import dials
from situ_studio.rehearsing.module_rows import ModuleRow
from situ_studio.rehearsing.robot_screen import RobotScreen
from situ_studio.rehearsing.running import Running
from situ_studio.rehearsing.sounding import Sounding
from situ_studio.rehearsing.speech_bubble import SpeechBubble
from situ_studio.rehearsing.taking_notice import TakingNotice
from situ_studio.screens.media_import import home_of
from situ_studio.screens.shown import Content
from situ_studio.screens.tag_chips import Flow
from situ_studio.texts.listening import Listening
from situ_studio.widgets.icon_widgets import Elided, retheme
from situ_studio.widgets.layouts import clear, rule
from situ_studio.wording.language import translated

WIDE = 320


class Desk(OverScroll):
    """Shows one running rehearsal, and does to it what somebody does here."""

    settled = Signal()
    """What can be done with it may be something else now."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme = theme
        self._running: Running | None = None
        self._drawn: Project | None = None
        self._phrases: list[tuple[str, str]] = []
        self._pending: list[Pending] = []
        self._known: dict[str, str] | None = None
        """What services answer, by name; None before it was asked for."""
        self.dials: dict[str, DialRow] = {}
        self.modules: dict[str, ModuleRow] = {}
        self.setAccessibleName(self.tr("Rehearsal"))
        hear_as(self, QAccessible.Role.Grouping)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        body = QWidget()
        body.setProperty("role", "panel")
        column = QVBoxLayout(body)
        column.setContentsMargins(12, 8, 12, 12)
        column.setSpacing(8)
        self.clock = ClockBar(theme)
        column.addWidget(self.clock)
        self.notice = TakingNotice()
        column.addWidget(self.notice)
        self.screen_ = RobotScreen(theme)
        self.screen_.used.connect(lambda id, value: self._give(inputs.Use(id, value)))
        self.screen_.touched.connect(lambda: self._give(inputs.Touch()))
        column.addWidget(self.screen_)
        self.says = SpeechBubble(theme)
        self.sounding = Sounding(Listening(self), self)
        self.says.sound_asked.connect(self._on_sound)
        self.sounding.told.connect(self.says.show_unheard)
        column.addWidget(self.says)
        # What the robot waits for stands above what people may say: that can be a great deal.
        self._actions = self._section(column, self.tr("Goes on"))
        self._people = Flow(4)
        self._section(column, self.tr("People say")).addLayout(self._people)
        self._data = self._section(column, self.tr("Data"))
        self._askers = self._section(column, self.tr("Modules"))
        for rows in (self._actions, self._people):
            _show(rows, False)
        column.addStretch(1)
        self.setWidget(body)

    def _section(self, column: QVBoxLayout, title: str) -> QVBoxLayout:
        whole = QWidget()
        inside = QVBoxLayout(whole)
        inside.setContentsMargins(0, 0, 0, 0)
        inside.setSpacing(6)
        inside.addWidget(rule())
        heading = QLabel(title)
        heading.setProperty("role", "heading")
        inside.addWidget(heading)
        rows = QVBoxLayout()
        rows.setSpacing(4)
        inside.addLayout(rows)
        column.addWidget(whole)
        return rows

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        retheme(self, theme)
        self.screen_.set_theme(theme)
        self.says.set_theme(theme)
        for flag in self.findChildren(Flag):
            flag.set_theme(theme)

    # -- what runs -------------------------------------------------------------------

    def show_running(self, running: Running) -> None:
        """Another rehearsal, from its start."""
        self._running = running
        running.went.connect(self._on_went)
        running.begun.connect(self._on_begun)
        running.turned.connect(self._on_turned)
        running.paced.connect(self._on_paced)
        self.clock.pace_asked.connect(running.set_pace)
        self.clock.step_asked.connect(running.step)
        self.clock.show_pace(running.pace)
        self._on_begun()

    def leave(self) -> None:
        """Nothing is shown any more."""
        running, self._running = self._running, None
        self.sounding.silence()
        if running is not None:
            self.clock.pace_asked.disconnect(running.set_pace)
            self.clock.step_asked.disconnect(running.step)

    def show_drawn(self, project: Project | None) -> None:
        """The project as it is now."""
        self._drawn = project
        self._settle_notice()

    def _settle_notice(self) -> None:
        if self._running is not None:
            self.notice.show_course(self._running.course, self._drawn)
            self.settled.emit()

    def _give(self, given: inputs.AnyInput) -> None:
        if self._running is not None:
            self._running.give(given)

    def _on_begun(self) -> None:
        assert self._running is not None
        self.sounding.begin(self._heard)
        self._drawn = self._running.course.project
        self._on_turned()

    def _on_turned(self) -> None:
        """What can be done to it is that of another version."""
        assert self._running is not None
        project = self._running.course.project
        self._known = None
        clear(self._data)
        clear(self._askers)
        self.dials, self.modules = {}, {}
        for dial in dials(project):
            row = self.dials[dial.tag] = DialRow(self._theme, dial)
            row.written.connect(lambda tag, value: self._give(inputs.Set({tag: value}, WRITER)))
            self._data.addWidget(row)
        self._data.addWidget(self._any_tag())
        for name, resources in project.declared().items():
            asker = self.modules[name] = ModuleRow(self._theme, name, resources)
            asker.done.connect(self._give)
            self._askers.addWidget(asker)
        _show(self._askers, bool(self.modules))
        self._settle()

    def _any_tag(self) -> QWidget:
        self.other = QLineEdit()
        self.other.setPlaceholderText(self.tr("any tag = value"))
        self.other.setAccessibleName(self.tr("Any tag and its value"))
        self.other.returnPressed.connect(self._on_other)
        return self.other

    def _on_other(self) -> None:
        tag, divided, value = self.other.text().partition("=")
        if divided and tag.strip():
            text = value.strip()
            self.other.clear()
            self._give(inputs.Set({tag.strip(): read(text) if text else None}, WRITER))

    # -- what it is like now ---------------------------------------------------------

    def _on_went(self, events: list[dict[str, Any]]) -> None:
        running = self._running
        assert running is not None
        self.clock.show_time(running.seconds)
        self.says.show_speaking(running.course.speaking, running.course.now)
        if running.pace == 1:
            self.sounding.take(events, running.course)
        if events:
            self._settle()

    def _on_paced(self) -> None:
        assert self._running is not None
        self.clock.show_pace(self._running.pace)
        if self._running.pace != 1:
            self.sounding.silence()

    def _on_sound(self, on: bool) -> None:
        self.sounding.turn(on)
        self.sounding.begin(self._heard)
        self.says.sound.show_value(self.sounding.on)

    @property
    def _heard(self) -> Course | None:
        """Whose voice can be heard: at a pace that is no voice's, nobody's."""
        running = self._running
        return running.course if running is not None and running.pace == 1 else None

    def _settle(self) -> None:
        running = self._running
        assert running is not None
        course = running.course
        self.clock.show_time(running.seconds)
        components, behind = course.screen()
        language = course.look("language")
        spoken = language if isinstance(language, str) else "en"
        content = Content(components, behind, spoken)
        self.screen_.show_content(content, home_of(course.project))
        self.says.show_speaking(course.speaking, course.now)
        self._show_phrases(
            [
                (event.name, phrase)
                for one in course.expected.values()
                for event in one.events
                for phrase in event.says
            ]
        )
        self._show_pending(course.pending)
        self._settle_notice()
        for tag, row in self.dials.items():
            row.show_value(course.look(tag))
        asking, there = course.log.now.asking, course.modules
        for name, asker in self.modules.items():
            asker.show_state(bool(asking.get(name)), there.get(name, False))

    def _show_phrases(self, phrases: Sequence[tuple[str, str]]) -> None:
        """(event, phrase): what can be said once for several events is one button."""
        if list(phrases) == self._phrases:
            return
        self._phrases = list(phrases)
        clear(self._people)
        meant: dict[str, dict[str, None]] = {}
        for event, phrase in self._phrases:
            meant.setdefault(phrase, {})[event] = None
        for phrase, events in meant.items():
            button = QPushButton(f"“{phrase}”".replace("&", "&&"))
            button.setProperty("role", "answer")
            button.setToolTip(self.tr("A person says that: {0}").format(", ".join(events)))
            heard = inputs.Set({"heard": {"text": phrase, "confidence": 1}}, WRITER)
            button.clicked.connect(lambda _=False, one=heard: self._give(one))
            self._people.addWidget(button)
        _show(self._people, bool(self._phrases))

    def _show_pending(self, pending: Sequence[Pending]) -> None:
        if list(pending) == self._pending:
            return
        self._pending = list(pending)
        clear(self._actions)
        for one in self._pending:
            row = QWidget()
            line = QHBoxLayout(row)
            line.setContentsMargins(0, 0, 0, 0)
            line.setSpacing(6)
            called = one.name or (f"“{one.text}”" if one.text else "")
            what = f"{translated(kinds.kind(one.action).title)} {called}".strip()
            line.addWidget(Elided(what, "label"), 1)
            answer = self._answer(what, one) if one.action == "service" else None
            for words, ok in ((self.tr("Ends well"), True), (self.tr("Fails"), False)):
                button = QPushButton(words)
                button.setProperty("role", "mend")
                button.setAccessibleName(f"{words}: {what}")
                button.clicked.connect(partial(self._end, one, ok, answer))
                line.addWidget(button)
            self._actions.addWidget(row)
            if answer is not None:
                self._actions.addWidget(answer)
        _show(self._actions, bool(self._pending))

    def _answer(self, what: str, pending: Pending) -> QLineEdit:
        """What a service answers where it ends well: a value as it is written in a scenario. Enter
        ends it so.
        """
        line = QLineEdit()
        assert self._running is not None
        project = self._running.course.project
        if self._known is None:
            self._known = known(project)
        line.setText(self._known.get(pending.name or "", ""))
        line.setCursorPosition(0)
        said = example(project, pending)
        line.setPlaceholderText(self.tr('its answer, such as {"names": []}').replace(USUAL, said))
        line.returnPressed.connect(lambda: self._end(pending, True, line))
        line.setAccessibleName(self.tr("What {0} answers").format(what))
        return line

    def _end(self, pending: Pending, ok: bool, answer: QLineEdit | None, _: bool = False) -> None:
        """Somebody says how it went."""
        text = answer.text() if answer is not None else ""
        self._give(pending.finish(ok, read(text) if text else None))


def _show(rows: QLayout, shown: bool) -> None:
    """A section is there while it has rows."""
    whole = rows.parentWidget()
    if whole is not None:
        whole.setVisible(shown)
