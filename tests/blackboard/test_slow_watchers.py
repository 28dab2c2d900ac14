"""A user who does not take changes as fast as they come is told what was passed over."""

from __future__ import annotations

import pytest

import situ.testing
from situ.blackboard.client import Change

SETS = 40


@pytest.fixture(autouse=True)
def few_are_held(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("situ.blackboard.feeds.KEPT", 3)


def write(robot: situ.testing.Robot) -> None:
    for count in range(1, SETS + 1):
        robot.set({"face.x": count, "face.y": -count})


def is_whole(changes: list[Change]) -> None:
    """Every version was told or counted as missed, and the last was told."""
    for tag, last in (("face.x", SETS), ("face.y", -SETS)):
        told = [change for change in changes if change.tag == tag]
        version = 0
        for change in told:
            assert change.version == version + 1 + change.missed
            version = change.version
        assert (version, told[-1].value) == (SETS, last)
    assert any(change.missed for change in changes)
    # What is held is bounded: 3, and 2 for each tag.
    assert len(changes) <= 3 + 2 * 2 + 1


def test_who_iterates_slowly_is_told_by_missed() -> None:
    with (
        situ.testing.robot() as robot,
        robot.connect() as board,
        board.watch("face.*") as slow,
    ):
        write(robot)
        is_whole([change for _ in range(SETS) if (change := slow.next(0.0))])
        assert board.get("face.x") == SETS


def test_in_asyncio_too() -> None:
    async def go(robot: situ.testing.Robot) -> list[Change]:
        async with robot.connect_async() as board, board.watch("face.*") as slow:
            await board.set("face.x", None)
            write(robot)
            await board.sleep(1.0)
            return [change for _ in range(SETS) if (change := await slow.next(0.0))]

    with situ.testing.robot() as robot:
        is_whole(robot.run(go(robot)))


def test_other_watchers_are_told_everything() -> None:
    with (
        situ.testing.robot() as robot,
        robot.connect() as board,
        robot.connect() as other,
        board.watch("face.*"),
        other.watch("face.x") as quick,
    ):
        seen = []
        for count in range(1, SETS + 1):
            robot.set({"face.x": count, "face.y": -count})
            change = quick.next(0.0)
            assert change is not None
            seen.append((change.value, change.missed))
        assert seen == [(count, 0) for count in range(1, SETS + 1)]
