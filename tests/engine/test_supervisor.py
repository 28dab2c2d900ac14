"""What ``situ run`` starts again, when, how, and when it gives up."""

from __future__ import annotations

import argparse
import json
import logging
import os
import signal
import socket
import subprocess
import sys
from collections.abc import Mapping
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

import situ
from situ import cli, cli_run
from situ.engine import again
from situ.engine.again import HANDED_ON
from situ.engine.notify import Listener, Notifier
from situ.engine.supervisor import CLOSING, DEATHS, GIVEN_UP, HANGS, STARTING, Supervisor

DEADLINE = 30.0
LAB = Path(__file__).parent.parent / "blackboard" / "lab"
UP = {"READY": "1", "X_SITU_ADDRESSES": "{}"}


class Child:
    """A process: ``status`` is None while it runs. It ends when it is told, unless it is deaf."""

    def __init__(self, part: str, fresh: bool, told: Mapping[str, str]) -> None:
        self.part, self.fresh, self.told = part, fresh, dict(told)
        self.status: int | None = None
        self.deaf = False
        self.asked: list[str] = []

    def poll(self) -> int | None:
        return self.status

    def terminate(self) -> None:
        self.asked.append("end")
        if not self.deaf:
            self.status = 0

    def kill(self) -> None:
        self.asked.append("kill")
        self.status = -9


class Robot:
    """A supervisor with children and a clock that are moved by hand."""

    def __init__(self, *parts: str) -> None:
        self.started: list[Child] = []
        self.ready: list[dict[str, str]] = []
        self.now = 0.0
        self.supervisor = Supervisor(
            parts or ("core",), self._start, lambda told: self.ready.append(dict(told))
        )
        self.supervisor.begin(self.now)
        self.turn()

    def _start(self, part: str, fresh: bool, addresses: Mapping[str, str]) -> Child:
        self.started.append(Child(part, fresh, addresses))
        return self.started[-1]

    def turn(self, after: float = 0.0) -> float | None:
        self.now += after
        return self.supervisor.turn(self.now)

    def up(self, part: str = "core", **more: str) -> None:
        self.supervisor.heard(part, UP | more, self.now)
        self.turn()

    def die(self, status: int = -9) -> None:
        """The last one that was started; what follows is done when it is due."""
        self.started[-1].status = status
        left = self.turn()
        if self.supervisor.status is None and left is not None:
            self.turn(left)


def test_one_that_dies_is_started_again_at_once_and_knows_where_it_was() -> None:
    robot = Robot()
    robot.up()
    robot.turn(5)
    robot.started[0].status = -11
    robot.turn()
    assert [child.part for child in robot.started] == ["core", "core"]
    assert robot.started[1].told == {"core": "{}"}
    assert not robot.started[1].fresh
    robot.up()
    # Who started it all has heard that it is ready already.
    assert robot.ready == [{"core": "{}"}]


@pytest.mark.parametrize("status", [0, 1, 2, 128 + signal.SIGPIPE])
def test_one_that_ends_by_itself_ends_all(status: int) -> None:
    robot = Robot("core", "engine")
    robot.up()
    robot.started[0].status = status
    robot.turn()
    assert robot.started[1].asked == ["end"]
    robot.turn()
    assert robot.supervisor.status == status
    assert len(robot.started) == 2


def test_one_that_dies_again_and_again_waits_longer_and_is_given_up(
    caplog: pytest.LogCaptureFixture,
) -> None:
    robot = Robot()
    waits = []
    for count in range(1, DEATHS):
        robot.up()
        robot.turn(1.5)
        robot.started[-1].status = -6
        left = robot.turn()
        waits.append(left if len(robot.started) == count and left is not None else 0.0)
        robot.turn(waits[-1])
    assert waits[0] == 0.0
    assert all(before < after for before, after in pairwise(waits))
    robot.started[-1].status = -6
    robot.turn()
    assert robot.supervisor.status == GIVEN_UP
    assert len(robot.started) == DEATHS
    assert "core was killed by signal 6, 5 times in 10 s: it is given up" in caplog.text


def test_one_that_dies_seldom_is_never_given_up() -> None:
    robot = Robot()
    for _ in range(3 * DEATHS):
        robot.up()
        robot.turn(4)
        robot.die()
    assert robot.supervisor.status is None


def test_one_that_dies_twice_before_it_is_up_begins_anew(caplog: pytest.LogCaptureFixture) -> None:
    robot = Robot()
    robot.die()
    robot.die(3)
    assert [child.fresh for child in robot.started] == [False, False, True]
    assert "ended with status 3; it is started anew, for it died twice before it was up" in (
        caplog.text
    )


def test_the_others_start_when_the_first_is_ready_and_hear_where_it_is() -> None:
    robot = Robot("core", "engine", "screen")
    assert [child.part for child in robot.started] == ["core"]
    robot.up()
    assert [child.part for child in robot.started] == ["core", "engine", "screen"]
    assert robot.started[1].told == {"core": "{}"}
    robot.up("engine")
    assert robot.ready == []
    robot.up("screen", X_SITU_ADDRESSES="there")
    assert robot.ready == [{"core": "{}", "engine": "{}", "screen": "there"}]
    # A core that is started again leaves them alone.
    robot.started[0].status = -9
    robot.turn()
    robot.up()
    assert [child.part for child in robot.started] == ["core", "engine", "screen", "core"]


def test_one_that_says_nothing_any_more_is_killed(caplog: pytest.LogCaptureFixture) -> None:
    robot = Robot()
    assert robot.turn() == STARTING
    robot.up()
    robot.turn(HANGS - 1)
    robot.supervisor.heard("core", {"WATCHDOG": "1"}, robot.now)
    assert robot.turn(1) == HANGS - 1
    robot.turn(HANGS - 1)
    assert robot.started[0].asked == ["kill"]
    robot.turn()
    assert len(robot.started) == 2
    assert "core hangs; it is killed" in caplog.text


def test_all_are_told_to_end_and_killed_when_they_do_not() -> None:
    robot = Robot("core", "engine")
    robot.up()
    robot.started[1].deaf = True
    robot.supervisor.stop(robot.now)
    robot.supervisor.stop(robot.now)
    assert robot.turn() == CLOSING
    assert robot.supervisor.status is None
    robot.turn(CLOSING)
    assert [child.asked for child in robot.started] == [["end"], ["end", "kill"]]
    robot.turn()
    assert robot.supervisor.status == 0


# -- notify ------------------------------------------------------------------


def test_what_is_told_arrives_at_the_socket_that_is_named(tmp_path: Path) -> None:
    listener = Listener(tmp_path / "notify")
    environment = {"NOTIFY_SOCKET": str(listener.path), "WATCHDOG_USEC": "3000000", "x": "y"}
    notifier = Notifier(environment)
    assert environment == {"x": "y"}
    assert notifier.beat == 1.5
    notifier.tell(READY="1", STATUS="all is well")
    assert listener.take() == {"READY": "1", "STATUS": "all is well"}
    assert listener.take() is None
    listener.close()
    # Nobody is there any more; that is not our business.
    notifier.tell(WATCHDOG="1")


def test_without_a_socket_nothing_is_told_and_no_sign_of_life_is_wanted() -> None:
    notifier = Notifier({"WATCHDOG_USEC": "3000000"})
    assert notifier.beat is None
    notifier.tell(READY="1")


@pytest.mark.skipif(sys.platform != "linux", reason="names without a file are Linux's")
def test_a_name_that_begins_with_at_has_no_file() -> None:
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as there:
        name = f"situ-{os.getpid()}"
        there.bind("\0" + name)
        Notifier({"NOTIFY_SOCKET": f"@{name}"}).tell(STOPPING="1")
        assert there.recv(100) == b"STOPPING=1"


# -- situ run ----------------------------------------------------------------


def test_every_option_of_situ_run_is_handed_on_or_the_supervisors_own() -> None:
    commands = argparse.ArgumentParser().add_subparsers()
    cli_run.add(commands)
    names = set(vars(commands.choices["run"].parse_args(["x"]))) - {"run", "project"}
    own = {"apart", "no_restart", "supervised", "json"}
    played = {"script", "speed", "clients", "auto_finish"}
    assert names == {*HANDED_ON, *own, *played} - {"log_level"}


def test_a_robot_that_is_killed_goes_on_where_it_was_and_ends_when_it_is_told(
    tmp_path: Path,
) -> None:
    command = ("-m", "situ", "run", str(LAB), "--endpoint", "tcp://127.0.0.1:0", "--json")
    with (
        Listening(tmp_path / "systemd") as systemd,
        subprocess.Popen(
            [sys.executable, *command, "--state", str(tmp_path / "state")],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env={**os.environ, "NOTIFY_SOCKET": str(systemd.path), "WATCHDOG_USEC": "1000000"},
        ) as process,
    ):
        try:
            assert process.stdout is not None
            endpoint = json.loads(process.stdout.readline())["requests"]
            assert "READY" in systemd.until("READY")
            with situ.connect(endpoint, timeout=DEADLINE) as board:
                board.set("x", 7)
                for pid in _children(process.pid):
                    os.kill(pid, signal.SIGKILL)
                assert board.set("y", 8) == {"y": 1}
                assert board.get("x") == 7
            assert systemd.until("WATCHDOG") == {"WATCHDOG": "1"}
            process.send_signal(signal.SIGTERM)
            assert systemd.until("STOPPING") == {"STOPPING": "1"}
            _, error = process.communicate(timeout=DEADLINE)
        finally:
            process.kill()
    assert process.returncode == 0
    assert "core was killed by signal 9; it is started again" in error
    assert "the robot goes on from" in error


def test_what_a_killed_supervisor_leaves_the_next_one_takes_up(tmp_path: Path) -> None:
    command = ("-m", "situ", "run", str(LAB), "--json", "--state", str(tmp_path))
    endpoint = "tcp://127.0.0.1:0"
    for value in (None, 7):
        with subprocess.Popen(
            [sys.executable, *command, "--endpoint", endpoint],
            stdout=subprocess.PIPE,
            text=True,
        ) as process:
            try:
                assert process.stdout is not None
                endpoint = json.loads(process.stdout.readline())["requests"]
                with situ.connect(endpoint, timeout=DEADLINE) as board:
                    assert board.get("x") == value
                    board.set("x", 7)
            finally:
                process.kill()
            # Its robot ends, too; then nobody has the pipe any longer.
            assert process.stdout.read() == ""


def test_each_fresh_start_is_random_anew_and_its_processes_keep_the_seed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    seeds: list[list[str]] = []

    def started_twice(_parts: Any, command: Any, _ready: Any) -> int:
        lines = [command("core", fresh, {}) for fresh in (True, False)]
        seeds.append([line[line.index("--seed") + 1] for line in lines])
        return 0

    monkeypatch.setattr(again, "supervise", started_twice)
    for given in ((), (), ("--seed", "7")):
        assert cli.main(["run", str(LAB), *given]) == 0
    (first, kept), (second, _), named = seeds
    assert first == kept != second
    assert named == ["7", "7"]


def test_a_scenario_is_played_with_the_seed_of_a_simulation() -> None:
    assert cli_run.seed_for("fall.jsonl", None) == 0
    assert cli_run.seed_for("fall.jsonl", 3) == 3


class Listening(Listener):
    """A service manager that waits."""

    def __enter__(self) -> Listening:
        self._socket.settimeout(DEADLINE)
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def until(self, name: str) -> dict[str, str]:
        while True:
            message = self.take()
            assert message is not None
            if name in message:
                return message


def _children(pid: int) -> list[int]:
    return [int(one) for one in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]


@pytest.fixture(autouse=True)
def _told(caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.WARNING, "situ.run")
