"""The blackboard as a table."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from tests.gui.live.test_timeline import shown

from situ.document.names import RESERVED_ROOTS


def test_the_projects_own_data_stands_before_what_the_runtime_keeps(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    file = tmp_path / "run.mcap"
    it, _ = shown(studio, project("conversation"), file, "conversation", "fig5.jsonl")
    robot = it.window.robot
    viewing = robot.follower.viewing
    # As a robot tells it to who connects.
    stands = {"state": "1", "name": "hello", "suspended": False}
    viewing.log.stand({"application/converse": (stands, "situ", 0.0)})
    it.click(it.window.bottom.button("blackboard"))
    viewing.follow()
    it.settle()
    model = robot.blackboard.model()
    tags = [model.index(n, 0).data() for n in range(model.rowCount())]
    kept = [tag.startswith(RESERVED_ROOTS) for tag in tags]
    assert "sound.slap" in tags
    assert "application/converse" in tags
    assert kept == sorted(kept)
    own = kept.index(True)
    assert tags[:own] == sorted(tags[:own])
    assert tags[own:] == sorted(tags[own:])
