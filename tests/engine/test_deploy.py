"""Deploying to one robot, with a clock that is moved by hand (docs/deploying.md)."""

from __future__ import annotations

import hashlib
import queue
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from situ.blackboard import protocol, replies
from situ.decide import inputs, trace
from situ.decide.deployment import Waits
from situ.decide.effects import Refuse
from situ.decide.robot import Robot
from situ.document.export import deployable
from situ.document.project import Project
from situ.document.ready import load_ready
from situ.engine.deploy import Deployer
from situ.engine.versions import Current, Versions, fingerprint, version_to_run
from situ.errors import Refused, UsageError

DESK = Path(__file__).parent.parent / "faults" / "desk"
FLOW = "desk.rbd.xml"
DEADLINE = 20.0


class Desk:
    """A robot that takes versions; what is done beside it is done when ``checked`` is called."""

    def __init__(self, folder: Path) -> None:
        home = folder / "desk"
        if not home.exists():
            shutil.copytree(DESK, home)
        (folder / "state").mkdir(exist_ok=True)
        self.versions = Versions(folder / "state", load_ready(home))
        self.now = 0.0
        self.runs: list[Project] = []
        number, _ = version_to_run(self.versions, None)
        self.deployer = Deployer(
            self.versions, number, clock=lambda: self.now, wall=lambda: 1e9 + self.now
        )
        project = self.versions.project(number)
        self.robot = Robot(project, number, self.deployer.texts(project))
        self._beside: queue.Queue[Callable[[], None]] = queue.Queue()
        self.step(inputs.Start())
        self.deployer.begin(
            self.robot, self.step, self._beside.put, self._us, lambda p, _: self.runs.append(p)
        )
        self.deployer.settle()

    def _us(self) -> int:
        return int(self.now * 1e6)

    def step(self, given: inputs.AnyInput | None) -> str | None:
        events, effects = self.robot.step(given, self._us())
        if any(isinstance(event, trace.Deployed) for event in events):
            self.deployer.swapped(events)
        return next((e.message for e in effects if isinstance(e, Refuse)), None)

    def later(self, seconds: float) -> None:
        end = self.now + seconds
        while (due := self.robot.due()) is not None and due <= end * 1e6:
            self.now = due / 1e6
            self.step(None)
            self.deployer.settle()
        self.now = end
        self.deployer.tend(self.now)

    def checked(self) -> None:
        """Waits for what is done beside, and does what follows."""
        self._beside.get(timeout=DEADLINE)()
        self.deployer.settle()

    def ask(
        self, request: protocol.Deploying, who: str = "operator:ann", session: str = "a"
    ) -> Any:
        reply = self.deployer.answer(request, who, session)
        self.deployer.settle()
        return reply

    def send(self, files: dict[str, bytes], main: str | None = "situ.toml", **of: Any) -> None:
        who, session = of.get("who", "operator:ann"), of.get("session", "a")
        sent = {p: protocol.Sent(len(d), hashlib.sha256(d).hexdigest()) for p, d in files.items()}
        wanted = self.ask(protocol.Stage(id=1, files=sent, main=main), who, session).wanted
        for path in wanted:
            self.ask(protocol.Piece(id=2, path=path, offset=0, data=files[path]), who, session)

    def deploy(self, files: dict[str, bytes], force_after: float | None = None) -> None:
        self.send(files)
        assert self.ask(protocol.Deploy(id=3, force_after=force_after)).stands == "checking"
        self.checked()

    @property
    def progress(self) -> replies.Deployment:
        found = self.ask(protocol.Progress(id=4))
        assert isinstance(found, replies.Deployment)
        return found

    def files(self, seconds: int) -> dict[str, bytes]:
        found = deployable(load_ready(DESK))
        found[FLOW] = found[FLOW].replace(b">3000<", b">%d<" % seconds)
        return found


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    return Desk(tmp_path)


def test_after_its_first_minute_a_version_counts(desk: Desk, tmp_path: Path) -> None:
    desk.deploy(desk.files(4000))
    assert desk.progress.minute == 60.0
    desk.later(59)
    assert desk.versions.current.former == 0
    desk.later(3)
    after = desk.progress
    assert after.minute is None
    assert desk.versions.current == Current(1, fingerprint(desk.versions.given))
    assert Desk(tmp_path).robot.version == 1


def test_a_robot_that_is_told_to_end_has_not_failed(desk: Desk, tmp_path: Path) -> None:
    desk.deploy(desk.files(4000))
    desk.deployer.end()
    assert Desk(tmp_path).robot.version == 1


def test_a_robot_whose_process_died_in_the_first_minute_begins_with_the_version_before(
    desk: Desk, tmp_path: Path
) -> None:
    desk.deploy(desk.files(4000))
    again = Desk(tmp_path)
    assert again.robot.version == 0
    assert again.versions.turns()[-1].why.startswith("version 1 failed")


def test_what_waits_is_told_and_forced(desk: Desk) -> None:
    desk.step(inputs.Raise("talk"))
    desk.deploy(desk.files(4000), force_after=5.0)
    state = desk.progress
    assert (state.stands, state.forced) == ("waiting", 5.0)
    assert state.waits == (Waits("desk", "2", "speech", None),)
    desk.later(6)
    assert (desk.progress.stands, desk.progress.version) == ("running", 1)
    assert desk.runs[-1].root == str(desk.versions.folder / "1" / "project")
    assert desk.versions.turns()[-1].changed == (f"{FLOW}: state waiting: timeout 3000 → 4000 s",)


def test_another_operators_version_is_in_the_way_until_nothing_of_it_comes(desk: Desk) -> None:
    files = desk.files(4000)
    desk.send(files)
    desk.later(9)
    with pytest.raises(Refused, match="operator:ann is sending a version"):
        desk.send(files, who="operator:bob")
    desk.later(2)
    desk.send(files, who="operator:bob")
    with pytest.raises(Refused, match="nothing of yours"):
        desk.ask(protocol.Deploy(id=1))


def test_two_editors_of_one_operator_do_not_send_between_each_others_pieces(desk: Desk) -> None:
    files, others = desk.files(4000), desk.files(5000)
    desk.send(files)
    with pytest.raises(Refused, match="operator:ann is sending a version"):
        desk.send(others, session="b")
    with pytest.raises(Refused, match="nothing of yours"):
        desk.ask(protocol.Deploy(id=1), session="b")
    # What the end of another session leaves alone, that of its own gives to the next one.
    desk.deployer.left("b")
    with pytest.raises(Refused, match="operator:ann is sending a version"):
        desk.send(others, session="c")
    desk.deployer.left("a")
    with pytest.raises(Refused, match="operator:ann is sending a version"):
        desk.send(others, who="operator:bob", session="d")
    assert desk.ask(protocol.Deploy(id=1), session="c").stands == "checking"
    desk.checked()
    assert desk.progress.version == 1


def test_one_version_is_checked_at_a_time(desk: Desk) -> None:
    desk.send(desk.files(4000))
    desk.ask(protocol.Deploy(id=1))
    with pytest.raises(Refused, match="is being checked"):
        desk.ask(protocol.Rollback(id=2))
    desk.checked()


@pytest.mark.parametrize("seconds", [-1.0, float("inf")])
def test_a_time_that_is_none_is_refused(desk: Desk, seconds: float) -> None:
    desk.send(desk.files(4000))
    with pytest.raises(Refused, match="number of seconds"):
        desk.ask(protocol.Deploy(id=1, force_after=seconds))


def test_going_back_takes_the_version_before_or_the_one_that_is_named(desk: Desk) -> None:
    with pytest.raises(Refused, match="nothing ran before version 0"):
        desk.ask(protocol.Rollback(id=1))
    for seconds in (4000, 5000):
        desk.deploy(desk.files(seconds))
    assert desk.ask(protocol.Rollback(id=1)).asked == 1
    desk.checked()
    assert desk.robot.version == 1
    with pytest.raises(Refused, match="version 1 runs already"):
        desk.ask(protocol.Rollback(id=1, version=1))
    with pytest.raises(Refused, match="no version 7"):
        desk.ask(protocol.Rollback(id=1, version=7))
    desk.ask(protocol.Rollback(id=1, version=0))
    desk.checked()
    told = desk.ask(protocol.History(id=1))
    assert [(turn.version, turn.did) for turn in told.turns] == [
        (1, "deployed"),
        (2, "deployed"),
        (1, "rolled back"),
        (0, "rolled back"),
    ]
    assert (told.version, told.kept) == (0, (0, 1, 2))


def test_going_back_to_what_runs_takes_the_place_of_one_that_waits(desk: Desk) -> None:
    desk.step(inputs.Raise("talk"))
    desk.deploy(desk.files(4000))
    assert desk.progress.stands == "waiting"
    desk.ask(protocol.Rollback(id=1, version=0))
    desk.checked()
    assert (desk.progress.stands, desk.progress.waits) == ("running", ())
    desk.step(inputs.Raise("hush"))
    assert desk.robot.version == 0
    with pytest.raises(Refused, match="version 0 runs already"):
        desk.ask(protocol.Rollback(id=1, version=0))


def test_where_only_media_changed_the_death_of_the_process_returns_too(
    desk: Desk, tmp_path: Path
) -> None:
    desk.deploy({**desk.files(3000), "media/chime.txt": b"another"})
    assert (desk.progress.minute, desk.progress.former) == (60.0, 0)
    desk.later(30)
    # The same once more does not end its minute.
    desk.deploy({**desk.files(3000), "media/chime.txt": b"another"})
    assert (desk.progress.minute, desk.progress.former) == (30.0, 0)
    again = Desk(tmp_path)
    assert again.robot.version == 0
    assert again.versions.turns()[-1].why.startswith("version 2 failed")


def test_where_only_media_changed_it_counts_after_a_minute_too(desk: Desk, tmp_path: Path) -> None:
    desk.deploy({**desk.files(3000), "media/chime.txt": b"another"})
    desk.later(62)
    assert (desk.progress.minute, desk.progress.former) == (None, None)
    assert Desk(tmp_path).robot.version == 1


def test_what_counts_only_at_a_start_is_told(desk: Desk) -> None:
    files = desk.files(4000)
    files["situ.toml"] += b'\n[durable]\ntags = ["rounds"]\n[places]\nlobby = [1.0, 2.0, 0.0]\n'
    desk.deploy(files)
    assert desk.progress.restart == ("[durable]", "[places]")


def test_files_alone_go_into_the_version_that_runs(desk: Desk) -> None:
    script = deployable(load_ready(DESK))["desk.spds.xml"]
    other = script.replace(b'name="nod" priority="10"', b'name="nod" priority="3"')
    assert other != script
    desk.send({"desk.spds.xml": other}, main=None)
    desk.ask(protocol.Deploy(id=1))
    desk.checked()
    texts = desk.deployer.texts(desk.runs[-1])
    assert texts["desk.spds.xml"] == other.decode()
    assert texts[FLOW] == (DESK / FLOW).read_text()
    assert (Path(desk.runs[-1].root) / "media" / "chime.txt").read_text() == "a chime"


def test_what_can_not_be_kept_is_told_and_runs_all_the_same(
    desk: Desk, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def full(_: Current) -> None:
        raise UsageError("versions/current: cannot be written: No space left on device")

    monkeypatch.setattr(desk.versions, "choose", full)
    desk.deploy(desk.files(4000))
    assert desk.robot.version == 1
    assert "No space left on device" in caplog.text


@pytest.mark.parametrize(
    ("error", "told"),
    [
        (OSError(28, "No space left on device"), "No space left on device): make room"),
        (OSError(30, "Read-only file system"), "Read-only file system): it must be able to write"),
    ],
)
def test_a_disk_that_does_not_take_a_version_is_told_in_one_line(
    desk: Desk, monkeypatch: pytest.MonkeyPatch, error: OSError, told: str
) -> None:
    def add(*_: object) -> None:
        raise error

    monkeypatch.setattr(desk.versions, "add", add)
    desk.deploy(desk.files(4000))
    assert (desk.progress.stands, desk.progress.version) == ("refused", 0)
    (line,) = desk.progress.problems
    assert told in line


def test_a_fault_of_ours_in_checking_refuses_and_leaves_the_old_version(
    desk: Desk, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(desk.versions, "load", lambda *_: 1 / 0)
    desk.deploy(desk.files(4000))
    assert (desk.progress.stands, desk.progress.version) == ("refused", 0)
    assert "could not be checked" in caplog.text
    assert not desk.versions.staging.exists()
