"""What commands do with a robot, a rehearsal and recordings, and with what they show."""

from __future__ import annotations

from situ_studio.commands.file_commands import FileCommands


class RobotCommands(FileCommands):
    """The handlers of one window that are about what runs, or ran."""

    # -- when ------------------------------------------------------------------------

    def can_connect(self) -> bool:
        return not self.is_connected()

    def is_connected(self) -> bool:
        return self._window.robot.connected

    def can_compare(self) -> bool:
        return self._window.robot.comparing.can_compare()

    def compares(self) -> bool:
        return self._window.robot.comparing.comparing.goes

    def can_save_recording(self) -> bool:
        return self._window.robot.saving.can_save

    def has_recording(self) -> bool:
        return self._window.robot.recording is not None

    def follows_robot(self, _: object) -> bool:
        return self._window.robot.following.on

    def can_ask_why(self) -> bool:
        return self._window.why.can_ask()

    def can_take_in(self) -> bool:
        return self._window.rehearsing.can_take_in

    def can_go_back(self) -> bool:
        return self._window.rehearsing.can_go_back

    def is_rehearsing(self) -> bool:
        return self._window.rehearsing.running is not None

    def can_deploy(self) -> bool:
        return self._window.deploying.can_deploy

    def differs_from_robot(self) -> bool:
        return self._window.deploying.differs

    def may_operate(self) -> bool:
        return not self._window.robot.link.looks_only

    def can_operate(self) -> bool:
        return self._window.operating.can_operate

    def is_paused(self) -> bool:
        return self._window.operating.is_paused

    def can_pause(self) -> bool:
        return self._window.operating.can_pause

    def can_break(self) -> bool:
        return self._window.operating.can_break

    def can_go_to(self) -> bool:
        return self._window.operating.can_go_to

    def has_breakpoints(self) -> bool:
        return self._window.operating.has_breakpoints

    # -- what is done ----------------------------------------------------------------

    def connect_robot(self) -> None:
        self._window.robot.ask()

    def disconnect_robot(self) -> None:
        self._window.robot.disconnect_robot()

    def open_recording(self) -> None:
        path = self._window.dialogs.recording()
        if path is not None:
            self._window.robot.open_recording(path)

    def save_recording(self) -> None:
        self._window.robot.saving.ask()

    def close_recording(self) -> None:
        self._window.robot.close_recording()

    def compare_recording(self) -> None:
        self._window.robot.comparing.compare()

    def next_difference(self, by: int) -> None:
        self._window.robot.comparing.next(by)

    def count_recordings(self) -> None:
        self._window.field.choose_files()

    def follow_robot(self) -> None:
        self._window.robot.following.toggle()

    def ask_why(self) -> None:
        self._window.why.ask()

    def ask_why_not(self) -> None:
        self._window.why.ask_not()

    def rehearse(self) -> None:
        self._window.rehearsing.rehearse()

    def pause_rehearsal(self) -> None:
        self._window.rehearsing.pause()

    def step_rehearsal(self) -> None:
        self._window.rehearsing.step()

    def end_rehearsal(self) -> None:
        self._window.rehearsing.end()

    def save_rehearsal(self) -> None:
        self._window.rehearsing.save()

    def run_scenarios(self) -> None:
        self._window.scenarios.run()

    def take_into_rehearsal(self) -> None:
        self._window.rehearsing.take_in()

    def take_back_in_rehearsal(self) -> None:
        self._window.rehearsing.go_back()

    def deploy(self) -> None:
        self._window.deploying.ask()

    def operate(self, method: str) -> None:
        getattr(self._window.operating, method)()
