"""The window's part of the scenarios: they are run, looked at, and painted on the drawings."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from situ.document import codec
from situ.errors import UsageError
from situ.rehearse.suite import scenarios
from situ_studio.edits.edit import write
from situ_studio.live.log import TraceLog
from situ_studio.live.recordings import Recording
from situ_studio.processes.working import Work
from situ_studio.rehearsing.painting import painted
from situ_studio.rehearsing.scenario_run import Ran, ScenarioRun
from situ_studio.rehearsing.scenarios_panel import ScenariosPanel, failed_words
from situ_studio.wording.language import said

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow

PANEL = "scenarios"


class ScenariosSide(QObject):
    """``run_`` is what is played now, or was last; None before."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self.run_: ScenarioRun | None = None
        self._work: Work | None = None
        self.panel = ScenariosPanel(window.theme)
        window.bottom.add(PANEL, self.tr("Scenarios"), self.panel)
        self.panel.run_asked.connect(self.run)
        self.panel.paint_asked.connect(self.paint)
        self.panel.looked.connect(self.look)
        self.panel.gone.connect(window.go_to)
        window.session.opened.connect(self._forget)
        window.robot.follower.viewing.exchanged.connect(lambda: self.panel.paint.setChecked(False))

    def run(self) -> None:
        """All of the project as it is now; what was going on is ended."""
        window, project = self._window, self._window.session.project
        if project is None or not window.rehearsing.may_run():
            return
        self.cancel()
        try:
            files = scenarios(project)
        except UsageError as error:
            window.dialogs.tell(said(str(error)))
            return
        self._drop()
        root, changed = Path(project.root).resolve(), window.session.contents.scenarios
        unsaved = {root / file: write(lines) for file, lines in changed.items()}
        run = self.run_ = ScenarioRun(project, files, unsaved, self)
        self._work = window.status.work.begin(self.tr("Running the scenarios"), run.cancel)
        run.went.connect(self._work.tell)
        run.went.connect(lambda _: self.panel.show_run(run))
        run.ended.connect(self._on_ended)
        window.bottom.choose(PANEL)

    def cancel(self) -> None:
        """What is played now is ended."""
        if self.run_ is not None:
            self.run_.cancel()

    def _drop(self) -> None:
        self.cancel()
        if self.run_ is not None:
            self.run_.deleteLater()
            self.run_ = None

    def _forget(self) -> None:
        """Another project is open: what was run is none of it."""
        self._drop()
        if self.panel.paint.isChecked():
            self.paint(False)
        self.panel.clear()
        self._window.bottom.set_count(PANEL, 0)

    def look(self, ran: Ran) -> None:
        """All views show that scenario's run: where it failed first, else its end."""
        run, window = self.run_, self._window
        if run is None or ran.recording is None:
            return
        log = TraceLog()
        log.add(ran.recording.events)
        for step in ran.recording.steps:
            log.keep_clock(step.before)
        documents = run.project.flows.items()
        files = {file: codec.write(document).decode() for file, document in documents}
        for file, other in (
            (run.project.spds_file, run.project.spds),
            (run.project.modules_file, run.project.modules),
        ):
            if file is not None and other is not None:
                files[file] = codec.write(other).decode()
        window.robot.show_recording(
            Recording(
                ran.path, run.project.name, masked=False, files=files, log=log, ran=run.project
            )
        )
        failed = ran.played.failed
        window.robot.follower.viewing.seek(failed[0].at if failed else log.lanes.end)
        if failed:
            window.say(failed_words(failed[0]))

    def paint(self, on: bool) -> None:
        """How often the scenarios came through each thing, on the drawings."""
        run = self.run_
        shown = painted(run.project, run.coverage) if on and run is not None else None
        self._window.robot.follower.paint(shown)

    def _on_ended(self) -> None:
        work, self._work = self._work, None
        if work is not None:
            work.end()
        if self.run_ is not None:
            self._window.bottom.set_count(PANEL, len(self.run_.ran))
            self.paint(self.panel.paint.isChecked())
