"""``situ get``, ``set``, ``watch``, ``event``, ``modules``, ``trace`` and ``run``."""

from __future__ import annotations

import json
import select
import signal
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import count
from pathlib import Path
from typing import Any

import pytest

import situ
from situ import cli
from situ.blackboard.server import Server, check_reach
from situ.errors import UsageError
from situ.rehearse.recorded import Heading, Line, read

DEADLINE = 20.0
LAB = Path(__file__).parent / "lab"


@pytest.fixture
def say(running: Any, capsys: pytest.CaptureFixture[str]) -> Callable[..., str]:
    """Runs a command at the running robot; its output."""

    def run(*arguments: str) -> str:
        capsys.readouterr()
        assert cli.main([*arguments, "--at", running.endpoint]) == 0
        return capsys.readouterr().out

    return run


def test_what_is_set_is_got(say: Callable[..., str]) -> None:
    say("set", "face.visible", "true")
    say("set", "face.name", "Ann")
    assert say("get", "face.visible") == "true\n"
    assert say("get", "face.*") == 'face.name "Ann"\nface.visible true\n'
    entry = json.loads(say("get", "face.name", "--json"))["face.name"]
    assert (entry["value"], entry["version"]) == ("Ann", 1)
    assert entry["writer"].startswith("operator:")
    say("set", "face.name", "null")
    assert say("get", "face.name") == "null\n"


def test_an_event_is_raised(say: Callable[..., str]) -> None:
    say("event", "go", "--application", "desk")
    assert json.loads(say("get", "application/desk"))["state"] == "2"
    say("event", "asked")
    assert json.loads(say("get", "application/desk"))["state"] == "1"


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["go"], ""),
        (["gone"], "situ: gone is not expected now; the robot expects only go\n"),
        (
            ["asked", "--application", "desk"],
            "situ: asked is not expected now; desk expects only go\n",
        ),
    ],
    ids=["expected", "by-nobody", "not-by-this-one"],
)
def test_an_event_that_nobody_expects_is_raised_and_told(
    running: Any, arguments: list[str], told: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with situ.connect(running.endpoint, role="operator") as board, board.trace() as events:
        board.debug("goto", state="1")
        assert cli.main(["event", *arguments, "--at", running.endpoint]) == 0
        assert capsys.readouterr() == ("", told)
        raised = next(event for event in events if event["kind"] == "event")
    assert raised["name"] == arguments[0]


def test_modules_are_listed(say: Callable[..., str]) -> None:
    rows = [line.split() for line in say("modules").splitlines()]
    assert rows[0] == ["MODULE", "KIND", "PRESENT", "RESOURCES", "HOLDS", "PROVIDES", "NEEDS"]
    needs = ["face.direction,", "module", "eyes"]
    assert ["chase", "module", "no", "head", "-", "-", *needs] in rows
    assert ["desk", "application", "yes", "screen", "screen", "-", "-"] in rows
    assert ["eyes", "module", "no", "-", "-", "face.direction", "camera.left"] in rows
    assert "data face.direction  wanted by chase" in say("modules", "--wanted").splitlines()
    assert json.loads(say("modules", "--json"))[0]["name"] == "carry"
    assert json.loads(say("modules", "--wanted", "--json"))[0]["data"] == "camera.left"


@pytest.mark.parametrize(
    ("arguments", "line"),
    [
        (["watch", "watched.*"], b"watched.x 1\n"),
        (["trace", "--since", "1"], b'{"kind":"data","seq":1,'),
    ],
)
def test_watch_and_trace_print_as_it_comes(running: Any, arguments: list[str], line: bytes) -> None:
    with situ.connect(running.endpoint) as board:
        board.set("watched.x", 1)
    command = [sys.executable, "-m", "situ", *arguments, "--at", running.endpoint]
    with subprocess.Popen(command, stdout=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert process.stdout.readline().startswith(line)
        process.terminate()


def test_trace_ends_with_the_robot(
    run_lab: Callable[..., Any], capsys: pytest.CaptureFixture[str]
) -> None:
    robot = run_lab()
    with ThreadPoolExecutor() as pool, situ.connect(robot.endpoint) as board:
        following = pool.submit(cli.main, ["trace", "--at", robot.endpoint])
        for number in count():
            board.set("x", number)
            if capsys.readouterr().out:
                break
        assert robot.stop() == 0
        assert following.result(DEADLINE) == 0
    assert capsys.readouterr().err == f"situ: {robot.endpoint}: the robot has ended\n"


def test_a_trace_is_recorded_instead_of_printed(
    run_lab: Callable[..., Any], tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    robot, file, trace = run_lab(), tmp_path / "run.mcap", ["trace", "--since", "1"]
    command = [sys.executable, "-m", "situ", *trace, "--at", robot.endpoint]
    with ThreadPoolExecutor() as pool, subprocess.Popen(command, stdout=subprocess.PIPE) as process:
        where = ["--at", robot.endpoint, "--record", str(file)]
        following = pool.submit(cli.main, [*trace, *where])
        # So that there is something; it has heard of it when it ends.
        with situ.connect(robot.endpoint) as board:
            board.set("x", 1)
            assert process.stdout is not None
            printed = process.stdout.readline()
            while b'"x"' not in printed.splitlines()[-1]:
                printed += process.stdout.readline()
            for number in count(2):
                board.set("x", number)
                if file.exists() and file.stat().st_size:
                    break
        assert robot.stop() == 0
        assert following.result(DEADLINE) == 0
        printed += process.stdout.read()
    capfd.readouterr()
    assert cli.main(["replay", str(file)]) == 0
    assert capfd.readouterr().out.encode() == printed
    assert cli.main(["replay", str(file), "--decide"]) == 2
    assert "masked" in capfd.readouterr().err


@pytest.mark.parametrize("role", ["viewer", "operator"])
def test_a_trace_shows_viewers_nothing_private(
    run_lab: Callable[..., Any], ward_folder: Path, role: str, tmp_path: Path
) -> None:
    running = run_lab(project=ward_folder)
    name, file = f"Ann {role}", tmp_path / "run.mcap"
    trace = ["trace", "--role", role, "--at", running.endpoint, "--since", "1"]
    with situ.connect(running.endpoint) as board:
        board.set({"private.name": name, "greeting": f"Good morning, {name}!"})
        board.set("last", role)
        for more in ([], ["--record", str(file)]):
            command = [sys.executable, "-m", "situ", *trace, *more]
            with subprocess.Popen(command, stdout=subprocess.PIPE) as process:
                assert process.stdout is not None
                if more:
                    for number in count():
                        board.set("number", number)
                        if file.exists() and file.stat().st_size:
                            break
                else:
                    lines = [process.stdout.readline()]
                    while f'"tag":"last","value":"{role}"'.encode() not in lines[-1]:
                        lines.append(process.stdout.readline())
                process.send_signal(signal.SIGINT)
    told = [json.loads(line) for line in lines]
    shown = {e["tag"]: e["value"] for e in told if e["kind"] == "data"}
    recorded = list(read(file))
    heading = recorded[0]
    assert isinstance(heading, Heading)
    kept = b"".join(piece.text for piece in recorded if isinstance(piece, Line))
    if role == "viewer":
        assert shown["private.name"] == shown["greeting"] == "•••"
        assert b"Ann viewer" not in kept
        assert heading.masked
    else:
        assert (shown["private.name"], shown["greeting"]) == (name, f"Good morning, {name}!")
        assert name.encode() in kept
        assert not heading.masked


def test_get_and_watch_show_viewers_nothing_private(
    run_lab: Callable[..., Any], ward_folder: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    at = ["--at", run_lab(project=ward_folder).endpoint]
    assert cli.main(["set", "user.name", "Ann", *at]) == 0
    for role, shown in (([], "•••"), (["--role", "operator"], "Ann")):
        assert cli.main(["get", "user.name", *role, *at]) == 0
        assert capfd.readouterr().out == f'"{shown}"\n'
        watch = [sys.executable, "-m", "situ", "watch", "user.*", *role, *at]
        with subprocess.Popen(watch, stdout=subprocess.PIPE) as process:
            assert process.stdout is not None
            assert process.stdout.readline().decode() == f'user.name "{shown}"\n'
            assert cli.main(["set", "user.name", "Ann", *at]) == 0
            assert process.stdout.readline().decode() == f'user.name "{shown}"\n'
            process.terminate()


def test_with_wait_the_next_start_is_waited_for(run_lab: Callable[..., Any]) -> None:
    robot = run_lab()
    command = [sys.executable, "-m", "situ", "watch", "x", "--wait", "--at", robot.endpoint]
    with subprocess.Popen(command, stdout=subprocess.PIPE) as process:
        assert process.stdout is not None
        with situ.connect(robot.endpoint) as board:
            board.set("x", 1)
            assert process.stdout.readline() == b"x 1\n"
        robot.stop()
        run_lab("--endpoint", robot.endpoint, "--notify", robot.notifications)
        assert process.stdout.readline() == b"x null\n"
        with situ.connect(robot.endpoint) as board:
            board.set("x", 2)
            assert process.stdout.readline() == b"x 2\n"
        process.terminate()


def test_watch_prints_messages_too(running: Any) -> None:
    command = [sys.executable, "-m", "situ", "watch", "--messages", "--json", "desk/*"]
    with (
        subprocess.Popen([*command, "--at", running.endpoint], stdout=subprocess.PIPE) as process,
        situ.connect(running.endpoint) as board,
    ):
        assert process.stdout is not None
        # Nothing tells when it listens: the application sends until it is heard.
        for _ in range(round(DEADLINE / 0.1)):
            board.publish("go")
            board.publish("asked", "desk")
            if select.select([process.stdout], [], [], 0.1)[0]:
                break
        line = json.loads(process.stdout.readline())
        assert (line["topic"], line["application"]) == ("desk/busy", "desk")
        process.terminate()


@pytest.mark.parametrize(
    "arguments",
    [["get", "x"], ["set", "x", "1"], ["watch", "x"], ["event", "x"], ["modules"], ["trace"]],
    ids=lambda arguments: arguments[0],
)
def test_nobody_there_is_one_line_and_status_2(
    arguments: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    # A port of ours that takes connections and never answers.
    assert cli.main([*arguments, "--at", "ipc://@nobody-is-here"]) == 2
    error = capsys.readouterr().err
    why = "nobody answers; is situ run going there, and if it has keys, does it know yours?"
    assert error == f"situ: ipc://@nobody-is-here: {why}\n"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["set", "robot/head", "1"], "only the priority management writes there"),
        (["get", "No Tag"], "is no tag and no pattern"),
        (["event", "go", "--application", "none"], "there is no application none"),
    ],
    ids=["robot", "no-tag", "no-application"],
)
def test_what_is_refused_is_one_line_and_status_2(
    running: Any, arguments: list[str], said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main([*arguments, "--at", running.endpoint]) == 2
    error = capsys.readouterr().err
    assert said in error
    assert error.count("\n") == 1


# -- situ run ----------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--endpoint", "tcp://0.0.0.0:0"], "can be reached from other machines"),
        (["--endpoint", "tcp://*:0"], "can be reached from other machines"),
        (["--endpoint", "tcp://127.0.0.1:0", "--notify", "tcp://[::]:0"], "bind it to 127.0.0.1"),
        (["--endpoint", "tcp://127.0.0.1:0", "--http", "0.0.0.0:0"], "bind it to 127.0.0.1"),
        (["--endpoint", "tcp://127.0.0.1:99999"], "there is no port"),
        (["--endpoint", "tcp://127.0.0.1:-1"], "there is no port -1"),
        (["--endpoint", "tcp://127.0.0.1:65534"], "there is no port 65536"),
        (["--endpoint", ""], "write it as tcp://127.0.0.1:5570"),
        (["--endpoint", "nonsense"], "write it as tcp://127.0.0.1:5570"),
        (["--endpoint", "tcp://127.0.0.1:0", "--auto-finish", "1"], "goes with --script"),
        (["--endpoint", "tcp://127.0.0.1:0", "--script", "none.jsonl"], "none.jsonl"),
    ],
)
def test_a_run_that_may_not_be_is_one_line_and_status_2(
    arguments: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["run", str(LAB), "--no-restart", "--state", str(tmp_path), *arguments]) == 2
    error = capsys.readouterr().err
    assert said in error
    assert error.count("\n") == 1


def test_a_project_with_errors_is_not_run(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "a.rbd.xml").write_text('<application name="a"><state no="1" name=""/><x/>')
    assert cli.main(["run", "--no-restart", str(tmp_path / "a.rbd.xml")]) == 2
    assert "a.rbd.xml" in capsys.readouterr().err


def test_a_port_that_is_taken_is_told(
    running: Any, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    command = ["run", str(LAB), "--no-restart", "--state", str(tmp_path)]
    command += ["--endpoint", running.endpoint]
    assert cli.main(command) == 2
    error = capsys.readouterr().err
    assert "give another address or port 0" in error
    assert error.count("\n") == 1


@pytest.mark.parametrize(
    "address", ["tcp://127.0.0.1:5570", "tcp://127.1.2.3:0", "tcp://[::1]:0", "tcp://localhost:1"]
)
def test_loopback_is_open(address: str) -> None:
    check_reach(address, keyed=False, insecure=False)


@pytest.mark.parametrize(
    "address", ["tcp://192.168.1.2:0", "tcp://robot.example:0", "tcp://[2001:db8::1]:0"]
)
def test_all_else_is_refused_without_keys(address: str) -> None:
    with pytest.raises(UsageError, match="situ keys new"):
        check_reach(address, keyed=False, insecure=False)
    check_reach(address, keyed=True, insecure=False)
    check_reach(address, keyed=False, insecure=True)


@pytest.mark.parametrize("address", ["tcp://", "robot", "tcp://0.0.0.0:70000"])
def test_what_is_no_address_is_refused_with_keys_too(address: str) -> None:
    with pytest.raises(UsageError):
        check_reach(address, keyed=True, insecure=False)


def test_a_server_that_can_not_bind_leaves_nothing_open() -> None:
    import zmq

    context: zmq.Context[zmq.Socket[bytes]] = zmq.Context()
    first = Server("tcp://127.0.0.1:0", "tcp://127.0.0.1:0", context=context)
    with pytest.raises(UsageError):
        Server("tcp://127.0.0.1:0", first.notifications, context=context)
    first.close()
    context.term()
