"""The command line as a whole: help, wrong usage, and every kind of failure in one line."""

from __future__ import annotations

import argparse
import signal
import subprocess
import sys
from collections.abc import Callable

import pytest

from situ import cli
from situ.errors import SituError

# parser() is a fresh one each time; the commands are listed once, for the parameters below.
COMMANDS = sorted(
    {
        name
        for action in cli.parser()._actions
        if isinstance(action, argparse._SubParsersAction)
        for name in action.choices
    }
)


def one_line(text: str) -> bool:
    return len(text.splitlines()) == 1 and "Traceback" not in text


@pytest.mark.parametrize("command", COMMANDS)
def test_each_command_has_help(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main([command, "--help"]) == 0
    shown = capsys.readouterr()
    assert shown.out.startswith(f"usage: situ {command}")
    assert shown.err == ""


@pytest.mark.parametrize(
    "line", [[], ["no-such-command"], *([command, "--no-such-option"] for command in COMMANDS)]
)
def test_wrong_usage_is_one_line_and_exit_2(
    line: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(line) == 2
    shown = capsys.readouterr()
    assert shown.out == ""
    assert one_line(shown.err)
    assert "--help" in shown.err


def test_a_mistyped_command_is_told_the_nearest_one(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["studo"]) == 2
    assert "did you mean studio?" in capsys.readouterr().err


def test_the_log_level_may_stand_before_or_after_the_command() -> None:
    for line in (["--log-level", "debug", "studio"], ["studio", "--log-level", "debug"]):
        assert cli.parser().parse_args(line).log_level == "debug"


def failing(error: BaseException) -> Callable[[], int]:
    def run() -> int:
        raise error

    return run


@pytest.mark.parametrize("given", ["0", "-1", "soon", "nan", "inf"])
@pytest.mark.parametrize("option", ["--speed", "--patience", "--auto-finish"])
def test_a_time_and_a_speed_are_numbers_above_0(
    option: str, given: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["run", "x", f"{option}={given}"]) == 2
    assert f"{option}: a number above 0 is needed" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("error", "told"),
    [
        (SituError("reception: no such folder"), "situ: reception: no such folder\n"),
        (SituError("two\nlines"), "situ: two lines\n"),
        (FileNotFoundError(2, "No such file", "a.xml"), "situ: a.xml: No such file\n"),
    ],
)
def test_an_error_is_one_line_and_exit_2(
    error: BaseException, told: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.guarded(failing(error)) == 2
    assert capsys.readouterr().err == told


def test_a_fault_of_ours_is_one_line_too(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.guarded(failing(KeyError("state"))) == 2
    told = capsys.readouterr().err
    assert one_line(told)
    assert "report" in told


def test_control_c_is_quiet(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.guarded(failing(KeyboardInterrupt())) == 130
    assert capsys.readouterr().err == ""


def test_a_reader_that_goes_away_is_no_error() -> None:
    much = "import sys; from situ import cli; sys.exit(cli.guarded(lambda: print('x' * 999999)))"
    with subprocess.Popen(
        [sys.executable, "-c", much], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        process.stdout.read(1)
        process.stdout.close()
        assert process.stderr.read() == b""
        assert process.wait() == 141


def test_the_module_runs_as_the_command_does() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "situ", "no-such-command"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2
    assert one_line(done.stderr)


STRUCK = """
import signal, sys
class Struck:
    def find_spec(self, name, path=None, target=None):
        if name == {name!r}:
            signal.raise_signal(signal.SIGINT)
sys.meta_path.insert(0, Struck())
from situ.__main__ import main
sys.argv = ["situ", "check", "--help"]
sys.exit(main())
"""


@pytest.mark.parametrize("name", ["situ.cli", "msgspec", "situ.cli_check"])
def test_ctrl_c_while_the_command_is_still_being_read_is_quiet(name: str) -> None:
    done = subprocess.run(
        [sys.executable, "-c", STRUCK.format(name=name)],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.stderr == ""
    assert done.stdout == ""
    # Ended by the signal itself, or as a shell tells it.
    assert done.returncode in (-signal.SIGINT, 128 + signal.SIGINT)


def test_ctrl_c_while_a_command_runs_is_left_to_it() -> None:
    stop = (
        "import signal, sys\n"
        "from situ import cli\n"
        "cli.main = lambda: cli.guarded(lambda: signal.raise_signal(signal.SIGINT))\n"
        "from situ.__main__ import main\n"
        "sys.exit(main())"
    )
    done = subprocess.run([sys.executable, "-c", stop], capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (130, b"")
