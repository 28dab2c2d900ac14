"""The versions in a robot's state folder, and which of them a robot that starts runs."""

from __future__ import annotations

import hashlib
import os
import shutil
from collections.abc import Mapping
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from situ.blackboard.protocol import Sent
from situ.blackboard.replies import Turn
from situ.document.export import deployable
from situ.document.ready import load_ready
from situ.engine import staging
from situ.engine.staging import Staging
from situ.engine.versions import Current, Version, Versions, before, fingerprint, version_to_run
from situ.errors import ProjectError, Refused, UsageError

DESK = Path(__file__).parent.parent / "faults" / "desk"
FLOW = "desk.rbd.xml"


@pytest.fixture
def versions(tmp_path: Path) -> Versions:
    home = shutil.copytree(DESK, tmp_path / "desk")
    (tmp_path / "state").mkdir()
    return Versions(tmp_path / "state", load_ready(home))


def sent(files: Mapping[str, bytes]) -> dict[str, Sent]:
    return {path: Sent(len(d), hashlib.sha256(d).hexdigest()) for path, d in files.items()}


def add(versions: Versions, number: int, files: Mapping[str, bytes]) -> None:
    """A version that came whole."""
    coming = Staging(versions.staging, sent(files), versions.contents())
    for path in coming.wanted:
        coming.piece(path, 0, files[path])
    coming.check_whole()
    coming.complete()
    coming.keep()
    versions.add(
        number, coming.folder, Version("situ.toml", "operator:ann", 5.0, dict(coming.files))
    )


def longer(versions: Versions, seconds: int) -> dict[str, bytes]:
    found = deployable(versions.given)
    found[FLOW] = found[FLOW].replace(b">3000<", b">%d<" % seconds)
    return found


# -- a version -----------------------------------------------------------------------


def test_a_version_has_what_was_sent_and_what_is_the_robots_own(versions: Versions) -> None:
    home = Path(versions.given.root)
    (home / "robot.local.toml").write_text('[tags]\nrounds = 7\n[robot]\nadapter = "pybullet"\n')
    robot = Versions(versions.folder.parent, load_ready(home))
    files = longer(robot, 4000)
    files["situ.toml"] += b'\n[robot]\nendpoint = "tcp://elsewhere:1"\nannounce = false\n'
    add(robot, 1, files)
    project = robot.project(1)
    timeout = project.applications[FLOW].states[0].timeout
    assert timeout is not None
    assert timeout.seconds == 4000
    assert project.tags["rounds"] == 7
    assert (project.endpoint, project.adapter) == (robot.given.endpoint, "pybullet")
    assert project.announce
    assert robot.texts(project)["robot.local.toml"].startswith("[tags]")
    (home / "robot.local.toml").unlink()
    robot = Versions(versions.folder.parent, load_ready(home))
    assert robot.project(1).tags["rounds"] == 0


def test_what_an_older_version_has_need_not_come_again(versions: Versions) -> None:
    add(versions, 1, longer(versions, 4000))
    coming = Staging(versions.staging, sent(longer(versions, 5000)), versions.contents())
    assert coming.wanted == [FLOW]


def test_the_oldest_versions_go_but_not_those_that_are_needed(
    versions: Versions, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("situ.engine.versions.KEPT", 2)
    for number in range(1, 6):
        add(versions, number, longer(versions, number))
    versions.forget_old({2, 5})
    assert versions.numbers() == [2, 4, 5]
    assert not versions.has(1)
    with pytest.raises(UsageError, match="the robot has no version 1"):
        versions.project(1)
    # What was hard-linked from one that has gone is still whole.
    assert versions.project(5).applications[FLOW].states[0].timeout is not None


def test_a_disk_without_room_refuses_and_leaves_nothing(
    versions: Versions, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(staging, "ROOM", 10**18)
    with pytest.raises(Refused, match="what runs goes on"):
        Staging(versions.staging, sent(deployable(versions.given)), {})
    assert not versions.staging.exists()


def test_a_disk_that_is_full_while_it_comes_refuses_and_leaves_nothing(
    versions: Versions, monkeypatch: pytest.MonkeyPatch
) -> None:
    files = deployable(versions.given)
    coming = Staging(versions.staging, sent(files), {})

    def full(*_: object) -> int:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "write", full)
    with pytest.raises(Refused, match="No space left on device"):
        coming.piece(FLOW, 0, files[FLOW])
    assert not versions.staging.exists()


def test_a_piece_that_comes_twice_counts_once(versions: Versions) -> None:
    files = deployable(versions.given)
    coming = Staging(versions.staging, sent(files), {})
    half = len(files[FLOW]) // 2
    for _ in range(2):
        coming.piece(FLOW, 0, files[FLOW][:half])
    for _ in range(2):
        coming.piece(FLOW, half, files[FLOW][half:])
    assert (coming.folder / FLOW).read_bytes() == files[FLOW]


def test_what_is_announced_is_made_beside_the_robot_not_while_it_waits(versions: Versions) -> None:
    add(versions, 1, deployable(versions.given))
    files = {**deployable(versions.given), "media/empty.txt": b"", "media/new.txt": b"new"}
    coming = Staging(versions.staging, sent(files), versions.contents())
    assert coming.wanted == ["media/empty.txt", "media/new.txt"]
    assert list(coming.folder.iterdir()) == []

    coming.piece("media/new.txt", 0, b"new")
    coming.check_whole()
    coming.complete()
    assert {path: (coming.folder / path).read_bytes() for path in files} == files


def test_what_an_older_version_no_longer_has_is_refused_and_leaves_nothing(
    versions: Versions,
) -> None:
    add(versions, 1, deployable(versions.given))
    coming = Staging(versions.staging, sent(deployable(versions.given)), versions.contents())
    (versions.folder / "1" / "project" / FLOW).unlink()
    with pytest.raises(Refused, match="send all of it again"):
        coming.complete()
    assert not versions.staging.exists()


def test_a_link_in_the_way_is_not_written_through(versions: Versions, tmp_path: Path) -> None:
    files = deployable(versions.given)
    coming = Staging(versions.staging, sent(files), {})
    (tmp_path / "outside").write_text("mine")
    (coming.folder / FLOW).symlink_to(tmp_path / "outside")
    with pytest.raises(Refused):
        coming.piece(FLOW, 0, files[FLOW])
    assert (tmp_path / "outside").read_text() == "mine"


@given(st.dictionaries(st.text(max_size=20), st.integers(-5, 10**10), max_size=5))
def test_whatever_is_announced_stays_in_its_folder_or_is_refused(names: dict[str, int]) -> None:
    try:
        staging.check({name: Sent(size, "0" * 64) for name, size in names.items()})
    except Refused:
        return
    for name in names:
        assert os.path.normpath(name) == name
        assert not name.startswith(("/", ".."))


# -- which one runs ------------------------------------------------------------------


def test_what_was_deployed_runs_again(versions: Versions) -> None:
    add(versions, 1, longer(versions, 4000))
    versions.choose(Current(1, fingerprint(versions.given)))
    again = Versions(versions.folder.parent, versions.given)
    assert version_to_run(again, None) == (1, True)
    assert version_to_run(again, 1) == (1, True)


def test_a_project_that_was_changed_on_the_robot_since_runs(
    versions: Versions, caplog: pytest.LogCaptureFixture
) -> None:
    add(versions, 1, longer(versions, 4000))
    versions.choose(Current(1, fingerprint(versions.given)))
    flow = Path(versions.given.root, FLOW)
    flow.write_text(flow.read_text().replace("3000", "2000"))
    changed = Versions(versions.folder.parent, load_ready(versions.given.root))
    assert version_to_run(changed, 1) == (0, False)
    assert "not version 1, which was deployed: it was changed since" in caplog.text
    assert Versions(versions.folder.parent, changed.given).current.version == 0
    assert changed.turns()[-1].did == "given"


def test_the_project_as_given_runs_where_that_is_asked_for(versions: Versions) -> None:
    add(versions, 1, longer(versions, 4000))
    versions.choose(Current(1, fingerprint(versions.given)))
    assert version_to_run(versions, None, anew=True) == (0, True)
    assert versions.current.version == 0


def test_a_core_that_died_in_a_versions_first_minute_goes_on_with_it_once(
    versions: Versions,
) -> None:
    add(versions, 1, longer(versions, 4000))
    versions.choose(Current(1, fingerprint(versions.given), 0))
    assert version_to_run(versions, 1) == (1, True)
    # It died of it again: without what it left.
    assert version_to_run(versions, 1) == (0, False)
    assert versions.turns()[-1].did == "returned"
    assert version_to_run(versions, 0) == (0, True)


def test_without_anything_to_go_on_from_a_version_in_its_first_minute_is_left(
    versions: Versions,
) -> None:
    add(versions, 1, longer(versions, 4000))
    versions.choose(Current(1, fingerprint(versions.given), 0))
    assert version_to_run(versions, None) == (0, False)


def test_a_core_that_was_killed_before_its_version_was_written_down_goes_on_with_it(
    versions: Versions,
) -> None:
    add(versions, 1, longer(versions, 4000))
    assert version_to_run(versions, 1) == (1, True)


def test_a_version_with_errors_can_not_be_read(versions: Versions) -> None:
    files = longer(versions, 4000)
    files[FLOW] = files[FLOW].replace(b'next="2"', b'next="9"')
    add(versions, 1, files)
    with pytest.raises(ProjectError, match=rf"^{FLOW}:\d+:\d+: error"):
        versions.project(1)


def test_the_project_as_given_is_as_it_was_read(versions: Versions) -> None:
    texts = versions.texts(versions.given)
    Path(versions.given.root, FLOW).write_text("<application/>")
    assert versions.texts(versions.given) == texts


# -- history -------------------------------------------------------------------------


def turn(version: int, did: str) -> Turn:
    return Turn(1.0, version, "operator:ann", did)  # type: ignore[arg-type]


def test_a_line_that_was_torn_is_passed_over(versions: Versions) -> None:
    versions.note(turn(1, "deployed"))
    file = versions.folder / "deployed.jsonl"
    file.write_bytes(file.read_bytes() + b'{"time":1.0,"ver')
    versions.note(turn(2, "deployed"))
    assert [one.version for one in versions.turns()] == [1, 2]
    assert versions.next() == 3


@pytest.mark.parametrize(
    ("done", "running", "wanted"),
    [
        ([], 0, None),
        (["deployed 1"], 1, 0),
        (["deployed 1", "deployed 2"], 2, 1),
        (["deployed 1", "deployed 2", "rolled back 1"], 1, 0),
        (["deployed 1", "deployed 2", "rolled back 1", "deployed 3"], 3, 1),
        (["deployed 1", "refused 2"], 1, 0),
        (["deployed 1", "deployed 2", "returned 1"], 1, 0),
        (["deployed 1", "given 0", "deployed 2"], 2, 0),
        (["deployed 1", "rolled back 0", "rolled back 1"], 1, 0),
    ],
)
def test_going_back_goes_further_back_each_time(
    done: list[str], running: int, wanted: int | None
) -> None:
    turns = [turn(int(one.rsplit(" ", 1)[1]), one.rsplit(" ", 1)[0]) for one in done]
    assert before(turns, running) == wanted
