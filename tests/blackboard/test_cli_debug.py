"""``situ debug`` at a running robot."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from situ import cli


@pytest.fixture
def say(running: Any, capsys: pytest.CaptureFixture[str]) -> Callable[..., str]:
    """Runs a command at the running robot; its output."""

    def run(*arguments: str) -> str:
        capsys.readouterr()
        assert cli.main([*arguments, "--at", running.endpoint]) == 0
        return capsys.readouterr().out

    return run


def test_an_application_pauses_at_a_breakpoint_and_goes_on_by_steps(
    say: Callable[..., str],
) -> None:
    when = '<data tag="face.visible" exists="false"/>'
    one = ("--application", "desk")
    assert say("debug", "break", *one, "--from", "1", "--to", "2", "--when", when) == "1\n"
    say("event", "go", *one)
    breakpoint, paused = say("debug", "list").splitlines()
    assert breakpoint.startswith("breakpoint 1  writer operator:")
    assert breakpoint.endswith(f"application desk from 1 to 2 when {when}")
    assert paused == "paused desk  breakpoint 1"
    say("debug", "step", *one)
    assert '"state":"2"' in say("get", "application/desk")
    say("debug", "goto", "1", *one)
    assert '"state":"1"' in say("get", "application/desk")
    assert say("debug", "list").splitlines()[1] == "paused desk"
    say("debug", "unbreak", "1")
    say("debug", "resume")
    assert say("debug", "list") == ""
    say("debug", "pause", *one)
    assert say("debug", "list") == "paused desk\n"
    say("debug", "resume", *one)


def test_what_is_refused_is_one_line_and_exit_2(
    running: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["debug", "goto", "99", "--at", running.endpoint]) == 2
    error = capsys.readouterr().err
    assert error.startswith("situ: ")
    assert "has no state 99; there is 1, 2" in error
    assert error.count("\n") == 1
