"""``situ deploy``, ``rollback`` and ``history``: what they say, and their exit status.

Against a robot in a process of its own: ``tests/faults/test_deploy.py``.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace

from situ import cli, cli_deploy
from situ.blackboard.replies import Deployment, Files, Turn, Turns
from situ.decide.deployment import Waits
from situ.document.folder import sources
from situ.document.ready import load_ready

DESK = Path(__file__).parent.parent / "faults" / "desk"

SPEECH = Waits("reception", "3", "speech", None)
CHECKING = Deployment(id=1, version=2, asked=3, stands="checking")
WAITING = replace(CHECKING, stands="waiting", waits=(SPEECH,))
RUNS = Deployment(id=1, version=3, asked=3, stands="running", minute=60.0, former=2)
COUNTS = replace(RUNS, minute=None, former=None)
TURNS = (
    Turn(1e9, 2, "operator:ann", "deployed"),
    Turn(1e9, 3, "operator:ann", "deployed", "", ("reception.rbd.xml: timeout 20 → 25 s",)),
    Turn(1e9, 2, "situ", "returned", "version 3 failed: the robot's process died"),
)


class Board:
    """A robot of which it is known what it will tell, state by state."""

    def __init__(self, states: list[Deployment], turns: Turns | None = None) -> None:
        self._states = states
        self._turns = turns
        self.situ: str | None = "0.9.1"
        self.asked: list[Any] = []

    def __enter__(self) -> Board:
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def rollback(self, version: int | None, *, force_after: float | None) -> Deployment:
        self.asked.append((version, force_after))
        return self.progress()

    def documents(self) -> Files:
        return Files(id=1, project="desk", files=sources(load_ready(DESK)))

    def progress(self) -> Deployment:
        return self._states.pop(0)

    def history(self) -> Turns:
        assert self._turns is not None
        return self._turns

    def sleep(self, seconds: float) -> None:
        """Time passes by what is told."""


@pytest.fixture
def robot(monkeypatch: pytest.MonkeyPatch) -> Callable[..., Board]:
    made: list[Board] = []

    def make(*states: Deployment, turns: Turns | None = None) -> Board:
        made.append(Board(list(states), turns))
        return made[-1]

    monkeypatch.setattr(cli_deploy, "_connect", lambda *_: made[-1])
    return make


def test_one_document_in_place_of_a_whole_project_is_not_sent(
    robot: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    robot()
    assert cli.main(["deploy", str(DESK / "desk.rbd.xml"), "--to", "tcp://robot:5570"]) == 2
    assert "is one document, and this robot runs a whole project" in capsys.readouterr().err


def test_it_says_what_it_waits_for_and_that_it_goes_back_by_itself(
    robot: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    board = robot(CHECKING, WAITING, WAITING, RUNS)
    assert cli.main(["rollback", "3", "--to", "tcp://robot:5570", "--force-after", "9"]) == 0
    assert board.asked == [(3, 9.0)]
    assert capsys.readouterr().out.splitlines() == [
        "the robot checks version 3",
        "checked; waiting for speech of state 3 of reception",
        "version 3 runs; back to version 2 by itself if it fails in its first minute",
    ]


def test_what_it_goes_back_to_is_what_the_robot_says(
    robot: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    robot(CHECKING, replace(RUNS, former=1))
    assert cli.main(["rollback", "--to", "tcp://robot:5570"]) == 0
    assert "; back to version 1 by itself" in capsys.readouterr().out


def test_where_another_took_its_place_that_is_said(
    robot: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    turns = Turns(id=1, turns=TURNS[:1], version=2, kept=(0, 2))
    robot(WAITING, replace(WAITING, asked=4), turns=turns)
    assert cli.main(["rollback", "--to", "tcp://robot:5570"]) == 1
    assert capsys.readouterr().err == (
        "situ: version 2 runs, not version 3: version 4 was asked for after it; see situ history\n"
    )


def test_where_another_was_refused_it_waits_on(robot: Any) -> None:
    refused = replace(WAITING, asked=4, stands="refused")
    robot(WAITING, refused, refused, RUNS)
    assert cli.main(["rollback", "--to", "tcp://robot:5570"]) == 0


@pytest.mark.parametrize(
    ("state", "told"),
    [
        (WAITING, "situ: version 3 goes on without this: situ rollback 2 takes it back\n"),
        (RUNS, ""),
    ],
)
def test_ctrl_c_says_that_the_robot_goes_on(
    robot: Any,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    state: Deployment,
    told: str,
) -> None:
    board = robot(state)

    def interrupted(_: float) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(board, "sleep", interrupted)
    status = cli.main(["rollback", "--to", "tcp://robot:5570", "--wait"])
    assert (status, capsys.readouterr().err) == (130, told)


@pytest.mark.parametrize("seconds", ["-1", "nan", "inf", "soon"])
def test_a_time_that_is_none_is_said_at_once(
    robot: Any, capsys: pytest.CaptureFixture[str], seconds: str
) -> None:
    board = robot()
    line = ["rollback", "--to", "tcp://robot:5570", "--force-after", seconds]
    assert (cli.main(line), board.asked) == (2, [])
    assert "a number of seconds, 0 or more, is needed" in capsys.readouterr().err


def test_with_wait_it_ends_when_the_first_minute_is_over(
    robot: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    robot(WAITING, RUNS, RUNS, replace(COUNTS, restart=("[mqtt]",)))
    assert cli.main(["rollback", "--to", "tcp://robot:5570", "--wait"]) == 0
    assert capsys.readouterr().out.splitlines()[-2:] == [
        "version 3 counts: its first minute is over",
        "when the robot is started again, these count too: [mqtt]",
    ]


@pytest.mark.parametrize(
    ("last", "told"),
    [
        (
            replace(CHECKING, stands="refused", problems=("reception.rbd.xml:3:2: error …",)),
            ["version 3 is refused; version 2 runs on", "reception.rbd.xml:3:2: error …"],
        ),
        (
            replace(CHECKING, stands="returned", problems=("version 3 failed: a livelock",)),
            ["version 2 runs again: version 3 failed: a livelock"],
        ),
    ],
)
def test_what_the_robot_does_not_take_has_the_exit_status_1(
    robot: Any, capsys: pytest.CaptureFixture[str], last: Deployment, told: list[str]
) -> None:
    robot(CHECKING, last)
    assert cli.main(["rollback", "--to", "tcp://robot:5570"]) == 1
    assert capsys.readouterr().err.splitlines() == [f"situ: {line}" for line in told]


@pytest.mark.parametrize(
    ("turns", "status", "told"),
    [
        (Turns(id=1, turns=TURNS, version=2, kept=(0, 2, 3)), 1, "version 2 runs again: version 3"),
        (Turns(id=1, turns=TURNS[:2], version=3, kept=(0, 2, 3)), 0, "version 3 runs"),
        (
            Turns(id=1, turns=TURNS[:1], version=2, kept=(0, 2)),
            1,
            "not version 3: the robot was started again",
        ),
    ],
)
def test_a_robot_that_was_started_again_meanwhile_is_asked_what_became_of_it(
    robot: Any, capsys: pytest.CaptureFixture[str], turns: Turns, status: int, told: str
) -> None:
    robot(WAITING, Deployment(id=1, version=turns.version), turns=turns)
    assert cli.main(["rollback", "--to", "tcp://robot:5570"]) == status
    assert told in "".join(capsys.readouterr())


def test_the_history_is_told_in_words(robot: Any, capsys: pytest.CaptureFixture[str]) -> None:
    refused = Turn(1e9, 4, "operator:bob", "refused", "reception.rbd.xml:3:2: error …")
    given = Turn(1e9, 0, "situ", "given", "it was changed since")
    robot(turns=Turns(id=1, turns=(*TURNS, refused, given), version=0, kept=(0, 2, 3)))
    assert cli.main(["history", "--to", "tcp://robot:5570"]) == 0
    lines = [line.partition("  ")[2].strip() for line in capsys.readouterr().out.splitlines()]
    assert lines == [
        "version 2 deployed by operator:ann",
        "version 3 deployed by operator:ann",
        "reception.rbd.xml: timeout 20 → 25 s",
        "back to version 2 by itself: version 3 failed: the robot's process died",
        "version 4 of operator:bob refused: reception.rbd.xml:3:2: error …",
        "version 0 runs, what lies in the project's own folder: it was changed since",
        *("", ""),
    ]


def test_the_history_ends_with_what_runs_and_on_which_situ(
    robot: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    board = robot(turns=Turns(id=1, turns=(), version=0, kept=(0, 2)))
    line = ["history", "--to", "tcp://robot:5570"]
    assert cli.main(line) == 0
    runs = "version 0 runs; 2 can be gone back to"
    assert capsys.readouterr().out.splitlines() == [runs, "the robot itself runs Situ 0.9.1"]
    assert cli.main([*line, "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["situ"] == "0.9.1"
    # A robot from before it was told.
    board.situ = None
    assert cli.main(line) == 0
    assert capsys.readouterr().out.splitlines() == [runs]
    assert cli.main([*line, "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["situ"] is None
