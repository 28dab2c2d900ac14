"""Versions deployed to a robot in a process of its own (quality, *Faults*; docs/deploying.md)."""

from __future__ import annotations

import json
import random
import shutil
import threading
import time
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

import situ
from situ import cli
from situ.blackboard import sending
from situ.blackboard.calls import Person
from situ.blackboard.client import Board
from situ.blackboard.driving import Driver
from situ.blackboard.link import Link
from situ.blackboard.protocol import Piece, Sent, Stage
from situ.blackboard.replies import Deployment
from situ.document.export import deployable
from situ.document.ready import load_ready
from situ.errors import Refused

if TYPE_CHECKING:
    from tests.faults.conftest import Runtime

DEADLINE = 30.0
DESK = Path(__file__).parent / "desk"
FLOW = "desk.rbd.xml"
CORE = ("--services", "core")


@pytest.fixture
def desk(tmp_path: Path, make_runtime: Callable[[Path], Runtime]) -> Iterator[Runtime]:
    """A robot with the project ``desk``; not yet started."""
    made = make_runtime(shutil.copytree(DESK, tmp_path / "desk"))
    yield made
    if made.running:
        made.kill()


def files(**changed: tuple[str, str]) -> dict[str, bytes]:
    """The files of ``desk`` with one text put for another: in the flow, or in the script."""
    found = deployable(load_ready(str(DESK)))
    for name, (old, new) in changed.items():
        file = {"flow": FLOW, "script": "desk.spds.xml", "settings": "situ.toml"}[name]
        text = found[file].decode()
        assert old in text
        found[file] = text.replace(old, new).encode()
    return found


def project(folder: Path, **changed: tuple[str, str]) -> Path:
    """The same as a folder."""
    for path, data in files(**changed).items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_bytes(data)
    return folder


LONGER = ('<timeout next="1">3000</timeout>', '<timeout next="1">4000</timeout>')


def operator(desk: Runtime, user: str = "ann") -> Board:
    person = Person(role="operator", user=user)
    return Board(Driver(Link(desk.endpoint, person)), DEADLINE)


def until(board: Board, ready: Callable[[Deployment], bool]) -> Deployment:
    end = time.monotonic() + DEADLINE
    while True:
        state = board.progress()
        if ready(state):
            return state
        assert time.monotonic() < end, state


def runs(version: int) -> Callable[[Deployment], bool]:
    return lambda state: state.version == version and state.stands != "checking"


class Follower:
    """An editor: all trace events, in the order in which they came."""

    def __init__(self, board: Board) -> None:
        self.events: list[dict[str, Any]] = []
        self._more = threading.Condition()
        self._following = board.trace(1, self._heard)

    def _heard(self, event: dict[str, Any]) -> None:
        with self._more:
            self.events.append(event)
            self._more.notify_all()

    def wait(self, **fields: Any) -> dict[str, Any]:
        """The first event with these fields."""

        def found() -> dict[str, Any] | None:
            for event in self.events:
                if all(event.get(name) == value for name, value in fields.items()):
                    return event
            return None

        with self._more:
            assert self._more.wait_for(lambda: found() is not None, DEADLINE), fields
            event = found()
        assert event is not None
        return event

    def check_whole(self) -> None:
        seqs = [event["seq"] for event in self.events]
        assert seqs == list(range(1, len(seqs) + 1))


def test_a_version_waits_for_what_is_said_or_is_forced_and_the_state_is_kept(
    desk: Runtime, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    record = tmp_path / "run.mcap"
    desk.start("--record", str(record))
    with operator(desk, "ann") as board:
        editor = Follower(board)
        board.publish("talk")
        editor.wait(kind="enter", state="2")
        first = board.deploy(files(flow=LONGER), "situ.toml")
        assert (first.version, first.asked) == (0, 1)
        waiting = until(board, lambda state: state.stands == "waiting")
        (waits,) = waiting.waits
        assert (waits.application, waits.state, waits.action) == ("desk", "2", "speech")
        assert waiting.forced is None
        assert board.documents().files[FLOW] == (desk.project / FLOW).read_text()

        # What was waiting is replaced, and this one does not wait for ever.
        board.deploy(files(flow=("is said", "was said")), "situ.toml", force_after=0.2)
        state = until(board, runs(2))
        assert state.minute is not None
        assert "was said" in board.documents().files[FLOW]
        deployed = editor.wait(kind="deployed")
        assert (deployed["version"], deployed["writer"]) == (2, "operator:ann")
        assert deployed["files"] == [FLOW]
        assert board.get("application/desk")["state"] == "2"
        assert not [e for e in editor.events if e["kind"] == "exit" and e["seq"] > deployed["seq"]]

        board.publish("hush")
        editor.wait(kind="transition", to="1")
        back = ["rollback", "--to", desk.endpoint]
        assert cli.main(back) == 0
        assert "version 0 runs" in capsys.readouterr().out
        assert cli.main(["history", "--to", desk.endpoint]) == 0
        told = capsys.readouterr().out
        assert "version 2 deployed by operator:ann" in told
        assert "was said" in told
        assert "back to version 0 by operator:" in told
        assert "version 0 runs; 1, 2 can be gone back to" in told
        board.publish("count")
        editor.wait(kind="data", tag="rounds", value=1)
        editor.check_whole()
    assert desk.stop() == 0
    assert cli.main(["replay", str(record), "--decide"]) == 0


def test_a_module_notices_nothing_of_a_script_that_is_deployed_alone(
    desk: Runtime, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    desk.start(*CORE)
    mine = project(
        tmp_path / "mine",
        script=('<module name="nod" priority="10"/>', '<module name="nod" priority="20"/>'),
    )
    # What else is beside it stays at home.
    (mine / FLOW).write_text('<application name="desk"><state no="1" final="true"/></application>')
    with (
        operator(desk) as board,
        situ.connect(desk.endpoint, "nod", ["head"], timeout=DEADLINE) as nod,
        nod.authority("head") as head,
    ):
        editor = Follower(board)
        assert head.wait(DEADLINE)
        head.command({"yaw": 5})
        editor.wait(kind="mapping", resource="head")
        deploy = ["deploy", str(mine), "--spds", "--to", desk.endpoint]
        assert cli.main(deploy) == 0
        assert "priority of nod: 10 → 20" in capsys.readouterr().out
        since = editor.wait(kind="deployed")
        assert since["files"] == ["desk.spds.xml"]
        assert head.held
        board.set("seen", True)
        editor.wait(kind="data", tag="seen")
        after = [e["kind"] for e in editor.events if e["seq"] > since["seq"]]
        assert set(after) <= {"data", "situation", "condition"}
        assert board.get("robot/head") == {"yaw": 5}
        assert 'no="2"' in board.documents().files[FLOW]
    # What was deployed runs again.
    assert desk.stop() == 0
    desk.start(*CORE)
    with operator(desk) as board:
        assert board.progress().version == 1
        assert 'priority="20"' in board.documents().files["desk.spds.xml"]


COUNTED = '<when><data tag="rounds" above="0"/></when></event>'
LOOP = (
    '<event name="talk" next="2"/>',
    '<event name="talk" next="2"/><event next="2">' + COUNTED,
)
BACK = (
    '<event name="hush" next="1"/>',
    '<event name="hush" next="1"/><event next="1">' + COUNTED,
)


def test_a_version_that_fails_in_its_first_minute_is_left_by_itself(
    desk: Runtime, capsys: pytest.CaptureFixture[str]
) -> None:
    desk.start(*CORE)
    found = files(flow=LOOP)
    found[FLOW] = found[FLOW].decode().replace(*BACK).encode()
    with operator(desk) as board:
        board.deploy(found, "situ.toml")
        until(board, runs(1))
        board.publish("count")
        state = until(board, lambda state: state.stands == "returned")
        assert state.version == 0
        assert "version 1 failed" in state.problems[0]
        assert 'above="0"' not in board.documents().files[FLOW]
        assert board.get("application/desk") is not None
    assert cli.main(["history", "--to", desk.endpoint]) == 0
    assert "back to version 0 by itself: version 1 failed" in capsys.readouterr().out


def test_a_core_that_dies_in_a_versions_first_minute_goes_back_and_its_state_stays(
    desk: Runtime,
) -> None:
    desk.supervised = True
    desk.start(*CORE)
    with operator(desk) as board:
        editor = Follower(board)
        board.publish("count")
        board.deploy(files(flow=LONGER), "situ.toml")
        until(board, runs(1))
        desk.kill_part("core")
        state = until(board, lambda state: state.version == 0)
        assert state.stands == "returned"
        assert "died in its first minute" in state.problems[0]
        assert board.get("rounds") == 1
        editor.wait(kind="deployed", version=0)
        editor.check_whole()


def test_a_version_that_waits_waits_on_where_the_core_was_killed(desk: Runtime) -> None:
    desk.start(*CORE)
    with operator(desk) as board:
        board.publish("talk")
        board.deploy(files(flow=LONGER), "situ.toml")
        until(board, lambda state: state.stands == "waiting")
    for _ in range(2):
        desk.kill()
        desk.start(*CORE)
    with operator(desk, "bob") as board:
        editor = Follower(board)
        state = board.progress()
        assert (state.version, state.asked, state.stands) == (0, 1, "waiting")
        assert [one.action for one in state.waits] == ["speech"]
        board.publish("hush")
        until(board, runs(1))
        assert editor.wait(kind="deployed")["writer"] == "operator:ann"
        (turn,) = board.history().turns
        assert (turn.version, turn.who) == (1, "operator:ann")
        editor.check_whole()
    assert desk.stop() == 0
    desk.start(*CORE)
    with operator(desk) as board:
        assert board.progress().version == 1


def test_wherever_the_core_is_killed_in_a_deploy_the_old_or_the_new_version_runs(
    desk: Runtime, chance: random.Random, often: Callable[[int, int], int]
) -> None:
    desk.start(*CORE)
    for kill in range(often(2, 50)):
        number = 4000 + kill
        new = files(flow=(LONGER[0], f'<timeout next="1">{number}</timeout>'))
        with operator(desk) as board:
            board.publish("count")
            old = board.documents().files
            if chance.random() < 0.5:
                board.deploy(new, "situ.toml", force_after=0)
            else:
                # Somewhere while it comes.
                staged = board._ask(lambda dialog: sending.stage(dialog, new, "situ.toml"))  # noqa: B023
                assert staged.wanted
        desk.kill()
        desk.start(*CORE)
        with operator(desk) as board:
            found = board.documents().files
            wanted = [old, {path: new[path].decode() for path in old}]
            assert found in wanted
            assert board.get("rounds") == kill + 1
        assert not (desk.state / "versions" / "staging").exists()


def picture(screen: str, name: str) -> bytes | None:
    """What a page of the screen at this address shows there; None: nothing."""
    page = urllib.request.build_opener(urllib.request.HTTPCookieProcessor())
    page.open(screen, timeout=DEADLINE).close()
    try:
        with page.open(f"{screen.partition('?')[0]}media/{name}", timeout=DEADLINE) as answer:
            return bytes(answer.read())
    except urllib.error.HTTPError as refused:
        refused.close()
        return None


def test_a_screen_on_another_machine_gets_the_pictures_of_what_is_deployed(
    desk: Runtime, tmp_path: Path, make_runtime: Callable[[Path], Runtime]
) -> None:
    desk.start(*CORE)
    # With a copy of the project of its own, and a state folder of its own.
    face = make_runtime(shutil.copytree(DESK, tmp_path / "face"))
    face.start("--services", "screen", "--endpoint", desk.endpoint)
    try:
        with operator(desk) as board:
            screen = board.addresses.http
            assert screen is not None
            large = bytes(range(256)) * 4000
            board.deploy({**files(), "media/nurse.png": large}, "situ.toml")
            until(board, runs(1))
            until(board, lambda _: picture(screen, "nurse.png") == large)
            board.rollback()
            until(board, runs(0))
            until(board, lambda _: picture(screen, "nurse.png") is None)
    finally:
        face.kill()


HASH = "0" * 64


@pytest.mark.parametrize(
    ("path", "size", "why"),
    [
        ("../situ.toml", 5, "leads out of the project"),
        ("/etc/passwd", 5, "leads out of the project"),
        ("media/con.png", 5, "the name of a device"),
        ("media/x.bin", 10_000_000_000, "too much"),
        ("robot.local.toml", 5, "belongs to the robot"),
        ("situ.toml/x", 5, "a file and a folder at once"),
        ("SITU.toml", 5, "the same name"),
    ],
)
def test_a_bundle_that_would_do_harm_is_refused_before_anything_of_it_comes(
    robot: Runtime, path: str, size: int, why: str
) -> None:
    with operator(robot) as board:
        announced = {"situ.toml": Sent(5, HASH), path: Sent(size, HASH)}
        with pytest.raises(Refused, match=why):
            board._ask(
                lambda dialog: dialog.ask(
                    Stage(id=dialog.next_id(), files=announced, main="situ.toml"), _same, False
                )
            )
        assert board.progress().version == 0


def test_other_bytes_than_were_announced_are_refused(robot: Runtime) -> None:
    with operator(robot) as board:
        found = files()

        def piece(data: bytes, offset: int = 0) -> None:
            board._ask(
                lambda dialog: dialog.ask(
                    Piece(id=dialog.next_id(), path=FLOW, offset=offset, data=data), _same, False
                )
            )

        board._ask(lambda dialog: sending.stage(dialog, found, "situ.toml"))
        with pytest.raises(Refused, match="begins at 0, not at 7"):
            piece(b"x", 7)
        with pytest.raises(Refused, match="more than the"):
            piece(found[FLOW] + b" ")
        with pytest.raises(Refused, match="has not come whole"):
            board._ask(lambda dialog: sending.deploy(dialog, None))
        with pytest.raises(Refused, match="other bytes"):
            piece(found[FLOW].replace(b"talk", b"walk"))
        with pytest.raises(Refused, match="send it again from its start"):
            board._ask(lambda dialog: sending.deploy(dialog, None))
        assert board.documents().files[FLOW] == (robot.project / FLOW).read_text()


def test_a_flow_with_errors_is_refused_with_them_and_the_old_version_runs_on(
    robot: Runtime, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    wrong = files(flow=('next="2"', 'next="7"'))
    with operator(robot) as board:
        board.deploy(wrong, "situ.toml")
        state = until(board, lambda state: state.stands == "refused")
        assert state.version == 0
        assert state.problems[0].startswith(f"{FLOW}:")
        assert "7" in state.problems[0]
    # situ deploy finds it before anything is sent.
    assert (
        cli.main(
            [
                "deploy",
                str(project(tmp_path, flow=('next="2"', 'next="7"'))),
                "--to",
                robot.endpoint,
            ]
        )
        == 2
    )
    den = project(tmp_path / "den", settings=('name = "desk"', 'name = "den"'))
    assert cli.main(["deploy", str(den), "--to", robot.endpoint]) == 2
    assert "is the project den, and this robot runs desk" in capsys.readouterr().err
    assert cli.main(["history", "--to", robot.endpoint, "--json"]) == 0
    turns = json.loads(capsys.readouterr().out)["turns"]
    assert [turn["did"] for turn in turns] == ["refused"]


def test_only_operators_deploy_and_one_at_a_time(robot: Runtime) -> None:
    with situ.connect(robot.endpoint, "nod", timeout=DEADLINE) as nod:
        with pytest.raises(Refused, match="only an operator deploys"):
            nod.deploy(files(), "situ.toml")
        assert nod.progress().version == 0
    with operator(robot, "ann") as ann, operator(robot, "bob") as bob:
        ann._ask(lambda dialog: sending.stage(dialog, files(), "situ.toml"))
        with pytest.raises(Refused, match="operator:ann is sending a version"):
            bob.deploy(files(), "situ.toml")
    # Of a client that is gone half-way the same operator may begin again.
    with operator(robot, "ann") as ann:
        ann.deploy(files(settings=('name = "desk"', 'name = "den"')), "situ.toml")
        state = until(ann, lambda state: state.stands == "refused")
        assert state.problems[0].startswith("this robot runs desk")


def _same(reply: Any) -> Any:
    return reply


@pytest.fixture(scope="module")
def robot(
    tmp_path_factory: pytest.TempPathFactory, make_runtime: Callable[[Path], Runtime]
) -> Runtime:
    """One robot for all that must change nothing."""
    made = make_runtime(shutil.copytree(DESK, tmp_path_factory.mktemp("desk") / "desk"))
    made.start(*CORE)
    return made
