"""The status bar: what the link is, honestly; problems; selection; how much there is; saved."""

from __future__ import annotations

from datetime import datetime
from itertools import compress
from operator import is_not

from PySide6.QtCore import QEvent, QTimer, Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QSizePolicy, QStatusBar, QWidget

import situ
from situ.document.rbd import Always, Application, State
from situ.document.spds import Spds
from situ_studio.assistive.announcing import Announcements
from situ_studio.edits.edit import Document
from situ_studio.help.help_texts import PANELS, helped
from situ_studio.help.help_topics import HELP
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.processes.working import WorkStrip
from situ_studio.widgets.icon_widgets import Elided, IconLabel, ThemedButton
from situ_studio.wording.language import count, tr

SAID_FOR = 6000
"""Milliseconds that a passing message stays."""
SLACK = 16
"""Px that may be empty behind what the link is."""


class Status(QStatusBar):
    """24 px at the bottom of the window."""

    problems_asked = Signal()

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setSizeGripEnabled(False)
        self.setContentsMargins(0, 0, 0, 0)
        left = QWidget()
        line = QHBoxLayout(left)
        line.setContentsMargins(10, 0, 0, 0)
        line.setSpacing(6)
        self._link_icon = IconLabel(theme, "unlink", "text2", 14)
        line.addWidget(self._link_icon)
        self.link = SteadyLabel()
        self.link.setText(self.tr("no robot"))
        line.addWidget(self.link)
        self._line = line
        line.addSpacing(10)
        self.errors = self._button(theme, "error", "error")
        line.addWidget(self.errors)
        self.warnings = self._button(theme, "warning", "warning")
        line.addWidget(self.warnings)
        self.addWidget(left)
        self.said = Elided()
        self.addWidget(self.said, 1)
        self.selection = QLabel()
        self.counts = _GivingWay()
        right = QWidget()
        end = QHBoxLayout(right)
        end.setContentsMargins(0, 0, 12, 0)
        end.setSpacing(16)
        self._end = end
        end.addWidget(self.selection)
        end.addWidget(self.counts)
        saved = QHBoxLayout()
        saved.setSpacing(6)
        self._saved_icon = IconLabel(theme, "check", "text2", 14)
        saved.addWidget(self._saved_icon)
        self.saved = QLabel()
        saved.addWidget(self.saved)
        end.addLayout(saved)
        self.work = WorkStrip()
        self.addPermanentWidget(self.work)
        self.addPermanentWidget(right)
        self.announcements = Announcements(self)
        self._counted: list[State | Always] = []
        self._leading = 0
        self._silence = QTimer(self)
        self._silence.setSingleShot(True)
        self._silence.setInterval(SAID_FOR)
        self._silence.timeout.connect(self.said.clear)
        for name in ("link", "errors", "warnings", "selection", "counts", "saved"):
            item: QWidget = getattr(self, name)
            item.setProperty(HELP, f"status/{name}")
            item.setToolTip(helped(PANELS[f"status/{name}"].text))
        self.show_problems(0, 0)
        self.show_saved(0, None, False)

    def _button(self, theme: Theme, icon: str, token: str) -> QPushButton:
        button = ThemedButton(theme, icon, "0", "", token, 14)
        button.clicked.connect(self.problems_asked)
        return button

    def add_to_link(self, behind: QWidget, at_the_right: QWidget) -> None:
        """More about the link: behind what it is, and before the selection."""
        self._line.insertWidget(2, behind)
        self._end.insertWidget(0, at_the_right)

    def show_project(self, there: bool) -> None:
        """Problems only where there is a document; else what program this is."""
        self.errors.setVisible(there)
        self.warnings.setVisible(there)
        if not there:
            self.counts.setText(f"Situ Studio {situ.__version__}")
            self._saved_icon.hide()
        self.selection.setVisible(there)
        self.saved.setVisible(there)

    def say(self, text: str) -> None:
        """A message for a few seconds."""
        self.said.setText(text)
        self.announcements.tell(text)
        self._silence.start()

    def show_link(self, icon: str, words: str, live: str) -> None:
        """live: ``true``, ``lost`` or nothing."""
        token = {"true": "live", "lost": "error"}.get(live, "text2")
        self._link_icon.set_icon(icon, token)
        self.link.setText(words)
        before = self.link.property("live")
        if before != live:
            self.link.setProperty("live", live)
            # None at the start, when there is nothing to tell of.
            if (before or "") != live:
                self.announcements.tell(words)
            self.link.style().unpolish(self.link)
            self.link.style().polish(self.link)

    def show_problems(self, errors: int, warnings: int) -> None:
        self.errors.setText(str(errors))
        self.errors.setAccessibleName(count(errors, self.tr("{0} error"), self.tr("{0} errors")))
        self.warnings.setText(str(warnings))
        self.warnings.setAccessibleName(
            count(warnings, self.tr("{0} warning"), self.tr("{0} warnings"))
        )

    def show_selection(self, selected: tuple[tuple[str, ...], ...]) -> None:
        if not selected:
            self.selection.setText("")
            return
        if selected == (("always",),):
            self.selection.setText(self.tr("“In every state” selected"))
            return
        kinds = {_sort(place) for place in selected if len(place) >= 2}
        one, many = self._names(kinds.pop() if len(kinds) == 1 else "")
        text = count(len(selected), one, many)
        self.selection.setText(self.tr("{0} selected").format(text))

    def _names(self, kind: str) -> tuple[str, str]:
        """What one and several of a kind are called."""
        every = {
            "state": (self.tr("{0} state"), self.tr("{0} states")),
            "event": (self.tr("{0} event"), self.tr("{0} events")),
            "action": (self.tr("{0} action"), self.tr("{0} actions")),
            "screen": (self.tr("{0} screen"), self.tr("{0} screens")),
            "component": (self.tr("{0} component"), self.tr("{0} components")),
            "timeout": (self.tr("{0} timeout"), self.tr("{0} timeouts")),
            "situation": (self.tr("{0} situation"), self.tr("{0} situations")),
            "module": (self.tr("{0} module"), self.tr("{0} modules")),
            "entry": (self.tr("{0} priority"), self.tr("{0} priorities")),
            "data": (self.tr("{0} data"), self.tr("{0} data")),
            "resource": (self.tr("{0} resource"), self.tr("{0} resources")),
            "note": (self.tr("{0} note"), self.tr("{0} notes")),
            "frame": (self.tr("{0} frame"), self.tr("{0} frames")),
        }
        return every.get(kind, (self.tr("{0} thing"), self.tr("{0} things")))

    def show_counts(self, document: Document | None) -> None:
        words: list[str] = []
        if isinstance(document, Application):
            parts: list[State | Always] = list(document.states)
            if document.always is not None:
                parts.append(document.always)
            if len(parts) == len(self._counted):
                # Only what is another value is counted anew.
                other = [*map(is_not, parts, self._counted)]
                self._leading += sum(map(_leading, compress(parts, other)))
                self._leading -= sum(map(_leading, compress(self._counted, other)))
            else:
                self._leading = sum(map(_leading, parts))
            self._counted, leading = parts, self._leading
            words = [
                count(len(document.states), self.tr("{0} state"), self.tr("{0} states")),
                count(leading, self.tr("{0} transition"), self.tr("{0} transitions")),
            ]
        elif isinstance(document, Spds):
            resources = {r for m in document.modules for r in m.resources}
            words = [
                count(
                    len(document.situations), self.tr("{0} situation"), self.tr("{0} situations")
                ),
                count(len(document.modules), self.tr("{0} module"), self.tr("{0} modules")),
                count(len(resources), self.tr("{0} resource"), self.tr("{0} resources")),
            ]
        elif document is not None:
            words = [count(len(document.modules), self.tr("{0} module"), self.tr("{0} modules"))]
        self.counts.setText(tr(", ").join(words))

    def show_saved(self, unsaved: int, at: datetime | None, there: bool) -> None:
        """unsaved: how many documents; there: whether a project is open at all."""
        self._saved_icon.setVisible(there and not unsaved)
        if not there:
            self.saved.setText("")
        elif unsaved:
            self.saved.setText(
                count(
                    unsaved,
                    self.tr("{0} document not saved"),
                    self.tr("{0} documents not saved"),
                )
            )
        elif at is not None:
            self.saved.setText(self.tr("Saved {0}").format(f"{at:%H:%M}"))
        else:
            self.saved.setText(self.tr("No changes"))


class _GivingWay(Elided):
    """Has the room that it needs where there is some; its tip is what helps with it."""

    def __init__(self) -> None:
        super().__init__()
        self.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Preferred)

    def _tell(self) -> None:
        """Nothing of what has no room: it is known elsewhere."""


class SteadyLabel(QLabel):
    """Words that are others in each frame of a scrub: what stands around them is laid out anew, and
    goes elsewhere, only where they need much more or less room than they have.
    """

    def setText(self, words: str) -> None:
        if words != self.text():
            super().setText(words)
            self._settle()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange):
            self._settle()

    def _settle(self) -> None:
        """Of a fixed size, its words are no matter of its layout's."""
        wanted, has = self.sizeHint(), self.minimumSize()
        slack = has.width() - wanted.width()
        if not 0 <= slack <= px(SLACK) or has.height() != wanted.height():
            self.setFixedSize(wanted)


def _leading(part: State | Always) -> int:
    """How many transitions leave it."""
    events = sum(event.next is not None for event in part.events)
    return events + bool(part.timeout is not None and part.timeout.next)


def _sort(place: tuple[str, ...]) -> str:
    """What stands at a place: ``state``, ``event``, ``component``."""
    if len(place) == 2 and place[1] not in ("screen", "timeout"):
        return place[0]
    if place[-1] in ("screen", "timeout"):
        return place[-1]
    return "component" if place[-2] == "screen" else place[-2]
