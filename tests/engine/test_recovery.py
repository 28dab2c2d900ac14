"""A robot that goes on after its core was killed: what lies in its state folder, and what begins
again (docs/architecture.md, *How the core comes back*)."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Iterable
from pathlib import Path
from typing import Any

import msgspec
import pytest

from situ.blackboard.backlog import Backlog
from situ.blackboard.client import connect_async
from situ.blackboard.history import Ended, Past, SessionsState
from situ.blackboard.journal import DurableTags
from situ.decide import inputs
from situ.decide.effects import AnyEffect, Begin, Changed, Map
from situ.decide.robot import Robot
from situ.document import codec
from situ.document.project import Project
from situ.document.rbd import Application, Set, State
from situ.document.ready import load_ready
from situ.engine.deciding import Setup
from situ.engine.folder import StateFolder
from situ.engine.live import Live
from situ.engine.recovery import AGAIN, INPUTS, Recovery, identity
from situ.errors import Refused, UsageError

DEADLINE = 20.0
LAB = Path(__file__).parent.parent / "blackboard" / "lab"
BOOT = "this boot"
SESSIONS = SessionsState("rrrr", [], {}, {}, {}, 0)
PAST: list[Past] = [
    (10, inputs.Set({"x": 1.0, "y": [True, None]}, "nod")),
    (20, None),
    (30, Ended("s")),
    (40, inputs.Command("nod", "head", {"yaw": 3}, 0.5)),
]


@pytest.fixture
def project() -> Project:
    return load_ready(LAB)


def killed(folder: Path, project: Project, *turns: list[Past]) -> Robot:
    """Leaves behind what a core does that was killed after these turns; its robot at the start."""
    robot = Robot(project)
    events, _ = robot.step(inputs.Start(everyone=False), 0)
    recovery = Recovery(folder, project, boot=BOOT)
    backlog = Backlog()
    backlog.add(events, 0.0)
    recovery.snapshot(0.0, robot, SESSIONS, backlog)
    for turn in turns:
        recovery.append(turn)
    return robot


def found(folder: Path, project: Project, boot: str = BOOT) -> list[Past] | None:
    """What happened after the snapshot, as the next core finds it."""
    left = Recovery(folder, project, boot=boot).found
    return None if left is None else left[1]


def test_what_was_written_down_is_found(tmp_path: Path, project: Project) -> None:
    robot = killed(tmp_path, project, PAST[:3], PAST[3:])
    left = Recovery(tmp_path, project, boot=BOOT).found
    assert left is not None
    kept, past = left
    assert past == PAST
    assert (kept.robot, kept.seq, kept.sessions) == (robot.snapshot(), robot.seq, SESSIONS)


def test_integers_of_any_size_are_written_down(tmp_path: Path) -> None:
    large = {"x": [2**64, -(10**100)]}
    state = State(no="1", actions=(Set(tag="y", text="1" * 30),))
    applications = {"a.rbd.xml": Application(name="a", states=(state,))}
    project = Project(name="a", root="", applications=applications, tags=large)
    robot = killed(tmp_path, project, [(1, inputs.Set(large, "nod"))])
    left = Recovery(tmp_path, project, boot=BOOT).found
    assert left is not None
    other = Robot(project)
    other.restore(left[0].robot)
    assert other.board.look("x") == robot.board.look("x") == large["x"]
    assert other.board.look("y") == int("1" * 30)
    assert left[1] == [(1, inputs.Set(large, "nod"))]


@pytest.mark.parametrize("cut", [1, 7, 12])
def test_a_turn_that_is_not_whole_did_not_happen(
    tmp_path: Path, project: Project, cut: int, caplog: pytest.LogCaptureFixture
) -> None:
    killed(tmp_path, project, PAST[:3], PAST[3:])
    journal = tmp_path / "core" / "journal"
    journal.write_bytes(journal.read_bytes()[:-cut])
    assert found(tmp_path, project) == PAST[:3]
    assert f"{journal} breaks off" in caplog.text


def test_nothing_is_read_behind_a_garbled_byte(
    tmp_path: Path, project: Project, caplog: pytest.LogCaptureFixture
) -> None:
    killed(tmp_path, project, PAST[:1], PAST[1:3], PAST[3:])
    journal = tmp_path / "core" / "journal"
    data = bytearray(journal.read_bytes())
    second = data.index(b"session ended")
    data[second] ^= 0x20
    journal.write_bytes(data)
    assert found(tmp_path, project) == PAST[:1]
    assert "breaks off" in caplog.text


def test_it_may_lie_in_memory(tmp_path: Path, project: Project) -> None:
    memory, state = tmp_path / "memory", tmp_path / "state"
    state.mkdir()
    (state / "core").symlink_to(memory / "core")
    killed(state, project, PAST)
    assert found(state, project) == PAST
    assert {"snapshot", "journal"} <= {file.name for file in (memory / "core").iterdir()}


def test_an_older_journal_beside_a_newer_snapshot_is_passed_over(
    tmp_path: Path, project: Project
) -> None:
    killed(tmp_path, project, PAST)
    journal = tmp_path / "core" / "journal"
    old = journal.read_bytes()
    killed(tmp_path, project)
    journal.write_bytes(old)
    assert found(tmp_path, project) == []


def test_another_project_or_another_boot_starts_anew(tmp_path: Path, project: Project) -> None:
    killed(tmp_path, project, PAST)
    other = msgspec.structs.replace(project, tags={**project.tags, "x": 1})
    assert found(tmp_path, other) is None
    assert found(tmp_path, project, "the next boot") is None
    assert found(tmp_path, project) == PAST


def test_the_same_project_is_the_same_wherever_it_lies(project: Project) -> None:
    assert identity(msgspec.structs.replace(project, root="elsewhere")) == identity(project)


def test_after_a_good_end_nothing_is_left(tmp_path: Path, project: Project) -> None:
    robot = Robot(project)
    recovery = Recovery(tmp_path, project, boot=BOOT)
    recovery.snapshot(0.0, robot, SESSIONS, Backlog())
    recovery.append(PAST)
    recovery.forget()
    assert found(tmp_path, project) is None
    assert list((tmp_path / "core").iterdir()) == []


def test_a_snapshot_that_can_not_be_read_is_set_aside(
    tmp_path: Path, project: Project, caplog: pytest.LogCaptureFixture
) -> None:
    killed(tmp_path, project, PAST)
    snapshot = tmp_path / "core" / "snapshot"
    snapshot.write_bytes(snapshot.read_bytes()[:-1])
    assert found(tmp_path, project) is None
    assert "it is set aside, the robot starts anew" in caplog.text
    assert snapshot.with_name("snapshot.broken").exists()
    assert found(tmp_path, project) is None


def test_what_can_not_be_written_down_leaves_nothing_old_behind(
    tmp_path: Path, project: Project, caplog: pytest.LogCaptureFixture
) -> None:
    robot = Robot(project)
    recovery = Recovery(tmp_path, project, boot=BOOT)
    recovery.snapshot(0.0, robot, SESSIONS, Backlog())
    recovery.append([(1, inputs.Set({"x": 10**5000}, "nod"))])
    recovery.append(PAST)
    # Else the next core would go on without having heard of x.
    assert found(tmp_path, project) is None
    assert len(caplog.messages) == 1
    recovery.snapshot(0.0, robot, SESSIONS, Backlog())
    recovery.append(PAST)
    assert found(tmp_path, project) == PAST


def test_when_there_is_room_again_it_is_soon_written_down_again(
    tmp_path: Path, project: Project
) -> None:
    recovery = Recovery(tmp_path, project, boot=BOOT)
    (tmp_path / "core").write_text("in the way")
    recovery.snapshot(0.0, Robot(project), SESSIONS, Backlog())
    assert found(tmp_path, project) is None

    (tmp_path / "core").unlink()
    wanted = []
    for turn in (PAST[:1] * (AGAIN - 1), PAST[:1]):
        recovery.append(turn)
        wanted.append(recovery.wanted)
    assert wanted == [False, True]
    recovery.snapshot(0.0, Robot(project), SESSIONS, Backlog())
    assert found(tmp_path, project) == []
    recovery.append(PAST[:1] * AGAIN)
    assert not recovery.wanted


def test_a_new_snapshot_is_wanted_when_much_has_happened(tmp_path: Path, project: Project) -> None:
    robot = Robot(project)
    recovery = Recovery(tmp_path, project, boot=BOOT)
    recovery.snapshot(0.0, robot, SESSIONS, Backlog())
    wanted = []
    for turn in (PAST[:1] * (INPUTS - 1), PAST[:1]):
        recovery.append(turn)
        wanted.append(recovery.wanted)
    recovery.snapshot(0.0, robot, SESSIONS, Backlog())
    wanted.append(recovery.wanted)
    recovery.append([(1, inputs.Set({"x": "x" * 5_000_000}, "nod"))])
    assert [*wanted, recovery.wanted] == [False, True, False, True]


def test_one_state_folder_is_one_core_s(tmp_path: Path) -> None:
    first = StateFolder(tmp_path / "state")
    with pytest.raises(UsageError, match="another situ run keeps its state there"):
        StateFolder(tmp_path / "state")
    first.close()
    StateFolder(tmp_path / "state").close()
    (tmp_path / "file").touch()
    with pytest.raises(UsageError, match="can not be kept there"):
        StateFolder(tmp_path / "file")


# -- a robot that goes on ------------------------------------------------------------

ERRAND = """
<application name="errand">
  <state no="1">
    <backgroundactions>
      <speech>Where is Ann?</speech>
      <robot resource="head" command="look"><param name="yaw">3</param></robot>
      <service name="look" url="http://127.0.0.1:9/look"/>
      <service name="book" method="POST" url="http://127.0.0.1:9/book" failed="unsure"/>
      <launch program="game"/>
    </backgroundactions>
    <expectedevents><event name="unsure" next="2"/></expectedevents>
  </state>
  <state no="2"><backgroundactions><set tag="pill.asked">1</set></backgroundactions>
    <timeout next="3">0.05</timeout></state>
  <state no="3"/>
</application>
"""


class Carrying:
    """Notes what is to be carried out."""

    screen_url = None

    def __init__(self) -> None:
        self.performed: list[AnyEffect] = []

    async def start(self) -> None:
        pass

    def open_door(self, addresses: object, keys: object) -> None:
        pass

    def turn_to(self, project: Project) -> None:
        pass

    def perform(self, effect: AnyEffect) -> None:
        self.performed.append(effect)

    async def close(self) -> None:
        pass


@pytest.fixture
def errand() -> Project:
    document, problems = codec.read(ERRAND.encode(), "errand.rbd.xml")
    assert isinstance(document, Application)
    assert not problems
    applications = {"errand.rbd.xml": document}
    return Project(root=".", name="errand", applications=applications, durable=("pill.*",))


def go(test: Callable[[], Awaitable[None]]) -> None:
    async def within() -> None:
        async with asyncio.timeout(DEADLINE):
            await test()

    asyncio.run(within())


def robot_of(project: Project, folder: Path, carrying: Carrying, **more: Any) -> Live:
    return Live(
        project,
        Setup(
            recovery=Recovery(folder, project, boot=BOOT),
            durable=DurableTags(folder, project.durable),
            **more,
        ),
        lambda submit, tag: carrying,
    )


class Slow(DurableTags):
    """A disk that has everything kept only when it is told so."""

    def keep(self, changes: Iterable[Changed], done: Callable[[str | None], None]) -> None:
        self.done = done


@pytest.mark.parametrize("why", [None, "disk I/O error"])
def test_a_durable_tag_is_acknowledged_when_it_is_kept_and_others_do_not_wait(
    tmp_path: Path, errand: Project, why: str | None
) -> None:
    store = Slow(tmp_path, errand.durable)

    async def test() -> None:
        robot = Live(errand, Setup(durable=store))
        addresses = await robot.start()
        async with (
            connect_async(addresses.requests) as board,
            connect_async(addresses.requests, "nod") as other,
            other.watch("pill.*") as changes,
        ):
            acknowledged = asyncio.create_task(board.set("pill.a", 1))
            change = await changes.next(DEADLINE)
            assert change is not None
            assert (await board.set("x", 1), await other.set("x", 2)) == ({"x": 1}, {"x": 2})
            assert not acknowledged.done()
            store.done(why)
            if why is None:
                assert await acknowledged == {"pill.a": 1}
            else:
                with pytest.raises(Refused, match="disk I/O error"):
                    await acknowledged
        await robot.stop()

    go(test)


def test_what_was_cut_off_begins_again_and_what_must_not_fails(
    tmp_path: Path, errand: Project
) -> None:
    killed(tmp_path, errand, [(5, inputs.Set({"x": 1}, "nod"))])
    carrying = Carrying()

    async def test() -> None:
        robot = robot_of(errand, tmp_path, carrying)
        addresses = await robot.start()
        async with connect_async(addresses.requests) as board, board.trace(since=1) as events:
            told: list[dict[str, Any]] = []
            while not told or (told[-1]["kind"], told[-1].get("state")) != ("enter", "3"):
                event = await events.next(DEADLINE)
                assert event is not None
                told.append(event)
            assert await board.get("x") == 1
        await robot.stop()
        # From the first event on, of which none comes twice.
        assert [event["seq"] for event in told] == list(range(1, len(told) + 1))
        (failed,) = [e for e in told if e["kind"] == "finished" and e["name"] == "book"]
        assert not failed["ok"]
        assert (
            "killed while book was under way; whether it was done is not known" in failed["error"]
        )

    go(test)
    mapped = {e.resource: e.value for e in carrying.performed[:2] if isinstance(e, Map)}
    assert mapped["head"]["params"] == {"yaw": 3}
    assert mapped["speech"]["text"] == "Where is Ann?"
    begun = [effect.name for effect in carrying.performed if isinstance(effect, Begin)]
    assert begun == ["look", "game"]
    with_durable = DurableTags(tmp_path, errand.durable)
    assert with_durable.restored == {"pill.asked": (1, 1, "errand")}
    with_durable.close()


def test_a_history_that_can_not_be_done_again_costs_the_history_only(
    tmp_path: Path, errand: Project, caplog: pytest.LogCaptureFixture
) -> None:
    killed(tmp_path, errand, [(5, inputs.Set({"x": 1}, "nod")), (6, Ended("nobody's"))])

    async def test() -> None:
        robot = robot_of(errand, tmp_path, Carrying())
        addresses = await robot.start()
        async with connect_async(addresses.requests) as board:
            assert await board.get("x") is None
            assert (await board.get("application/errand"))["state"] == "1"
        await robot.stop()

    go(test)
    assert "is set aside, the robot starts anew" in caplog.text


def test_durable_tags_that_are_newer_go_before_a_history(
    tmp_path: Path, errand: Project, caplog: pytest.LogCaptureFixture
) -> None:
    killed(tmp_path, errand, [(5, inputs.Set({"pill.a": "08:00"}, "nod"))])
    store = DurableTags(tmp_path, errand.durable)
    store.keep([Changed("pill.a", "09:00", 2, "ann", 0)], lambda why: None)
    store.close()

    async def test() -> None:
        robot = robot_of(errand, tmp_path, Carrying())
        addresses = await robot.start()
        async with connect_async(addresses.requests) as board:
            entry = (await board.entries("pill.a"))["pill.a"]
            assert (entry.value, entry.version, entry.writer) == ("09:00", 2, "ann")
        await robot.stop()

    go(test)
    assert "durable tags were set since" in caplog.text


def test_what_was_set_and_not_yet_kept_is_kept_by_the_core_that_goes_on(
    tmp_path: Path, errand: Project
) -> None:
    killed(tmp_path, errand, [(5, inputs.Set({"pill.a": "08:00", "lamp": 1}, "nod"))])

    async def test() -> None:
        robot = robot_of(errand, tmp_path, Carrying())
        await robot.start()
        await robot.stop()

    go(test)
    store = DurableTags(tmp_path, errand.durable)
    assert store.restored["pill.a"] == ("08:00", 1, "nod")
    store.close()
