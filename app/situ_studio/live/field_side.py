"""A window's field recordings: chosen, counted beside the window, painted, and exported."""

from __future__ import annotations

import io
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from situ.document import folder
from situ.errors import UsageError
from situ.rehearse.usage import PLACE, write_csv
from situ.rehearse.ways import frames
from situ_studio.live.field import Asked, Field, painted, whole
from situ_studio.live.field_panel import FieldPanel
from situ_studio.live.field_reading import FieldReading
from situ_studio.looks.theme import Theme
from situ_studio.processes.working import OneWork
from situ_studio.wording.language import said, tr
from situ_studio.wording.lasting import lasting

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow

PANEL = "field"
USUAL = "usage.csv"
KEPT = "field_place"
"""Where the settings keep by which tag places are told."""


class FieldSide(QObject):
    """``field`` is what was counted last; None before."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self.field: Field | None = None
        self._paths: list[Path] = []
        self.panel = FieldPanel(window.theme)
        self._place = str(window.settings.value(KEPT, PLACE))
        self.panel.place.show_value(self._place)
        window.bottom.add(PANEL, self.tr("Field"), self.panel)
        self.reading = FieldReading(self)
        self._work = OneWork(self.reading.cancel)
        self.reading.counted.connect(self._on_counted)
        self.reading.went_on.connect(self._work.tell)
        self.reading.gone.connect(self._on_gone)
        panel = self.panel
        panel.files_asked.connect(self.choose_files)
        panel.folder_asked.connect(self.choose_folder)
        panel.paint_asked.connect(self.paint)
        panel.export_asked.connect(self.export)
        panel.place_asked.connect(self.place)
        panel.refused.connect(window.say)
        panel.gone.connect(self.go)
        window.session.opened.connect(self._offer_tags)
        self._offer_tags()
        window.scenarios.panel.paint.toggled.connect(self._on_scenarios)
        window.session.opened.connect(self._forget)
        window.robot.follower.viewing.exchanged.connect(lambda: panel.paint.setChecked(False))

    def set_theme(self, theme: Theme) -> None:
        self.panel.set_theme(theme)

    def choose_files(self) -> None:
        """Asks for recordings and counts them."""
        paths = self._window.dialogs.field_recordings()
        if paths:
            self.count(paths)

    def choose_folder(self) -> None:
        """Asks for a folder and counts what was recorded there."""
        chosen = self._window.dialogs.field_folder()
        if chosen is not None:
            self.count([chosen])

    def count(self, paths: list[Path]) -> None:
        """Counts what people did in these, and in folders of them, beside the window."""
        self.reading.cancel()
        window = self._window
        window.bottom.choose(PANEL)
        self._work.begin(window.status.work, self.tr("Counting recordings"))
        self._paths = paths
        self.reading.start(Asked(tuple(paths), self._place))

    def place(self, tag: str) -> None:
        """That tag says where the robot was: what was counted is counted anew by it."""
        self._place = tag
        self._window.settings.setValue(KEPT, tag)
        self.panel.place.show_value(tag)
        if self._paths:
            self.count(self._paths)

    def _offer_tags(self) -> None:
        project = self._window.session.project
        known = self._window.vocabulary(project.spds if project is not None else None)
        self.panel.place.complete_from(known.tags)

    def paint(self, on: bool) -> None:
        """How often, how long, and where the time ran out, on the drawings."""
        project, follower = self._window.session.project, self._window.robot.follower
        if not on or self.field is None or project is None:
            follower.paint(None)
            return
        self._window.scenarios.panel.paint.setChecked(False)
        follower.paint(painted(project, self.field))

    def _on_scenarios(self, on: bool) -> None:
        """The drawings show the scenarios instead."""
        if on:
            self.panel.paint.blockSignals(True)
            self.panel.paint.setChecked(False)
            self.panel.paint.blockSignals(False)

    def export(self) -> None:
        """The table as ``situ report`` writes it, into a file that a person chooses."""
        path = self._window.dialogs.usage_file(USUAL)
        if path is None:
            return
        text = io.StringIO()
        write_csv(self.panel.table.used, text)
        try:
            folder.write(path, text.getvalue().encode())
        except UsageError as error:
            self._window.dialogs.tell(said(str(error)))
        else:
            self._window.say(self.tr("Exported to {0}").format(path.name))

    def go(self, application: str, state: str) -> None:
        """Shows that state; one that the project has no more, says so."""
        project = self._window.session.project
        found = frames(project, application, state) if project is not None else []
        if found:
            self._window.go_to(found[-1].file, ("state", found[-1].state.no))
        else:
            self._window.say(self.tr("The project has no such state any more."))

    def move_to(self, other: FieldSide) -> None:
        """What was counted, or is being, is shown by a window in place of this one."""
        other._paths = list(self._paths)
        painted = self.panel.paint.isChecked()
        if self.reading.is_counting:
            other.count(self._paths)
        elif self.field is not None:
            other._show(self.field)
            other.panel.paint.setChecked(painted)

    def cancel(self) -> None:
        """What is being counted is left."""
        self.reading.cancel()
        self._work.end()

    def _forget(self) -> None:
        """Another project is open."""
        self.cancel()
        self.field = None
        self._paths = []
        self.panel.clear()

    def _on_counted(self, field: Field) -> None:
        self._work.end()
        if field.refused:
            self._window.dialogs.tell("\n".join(map(said, field.refused)))
        elif not field.recordings:
            none = self.tr("{0}: there is no recording in it (*.mcap)")
            self._window.dialogs.tell(none.format(*self._paths))
        if field.recordings:
            self._show(field)

    def _show(self, field: Field) -> None:
        project = self._window.session.project
        if project is None:
            return
        self.field = field
        self.panel.show_used(whole(project, field), field.recordings, _situations(field))
        if self.panel.paint.isChecked():
            self.paint(True)
        else:
            self.panel.paint.setChecked(True)

    def _on_gone(self) -> None:
        self._work.end()
        self._window.dialogs.tell(
            self.tr("The recordings could not be counted; what happened is in studio.log.")
        )


def _situations(field: Field) -> str:
    """``called 3×, 12 s``, the ones that were current longest first."""
    every = sorted(field.situations.items(), key=lambda one: -one[1].seconds)
    return tr(", ").join(
        tr("{0} {1}×, {2}").format(name, one.times, lasting(one.seconds)) for name, one in every
    )
