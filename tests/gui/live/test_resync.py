"""The link through the worst of days: killed, started again, deployed to meanwhile."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from msgspec.structs import replace
from PySide6.QtCore import Qt

from situ.blackboard.client import connect as operator
from situ.document import codec
from situ.document.export import deployable, without_editor
from situ.document.ready import load_ready

CONTROL = Qt.KeyboardModifier.ControlModifier


def test_a_robot_that_is_killed_and_comes_back_with_another_flow_is_followed_without_gap_or_double(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    window, link = it.window, it.window.robot.link
    states: list[str] = []
    link.state_changed.connect(lambda: states.append(link.state.kind))
    it.answers.put("robot", there.endpoint)
    window.setFocus()
    it.key(Qt.Key.Key_R, CONTROL)
    until(link.documents_came, lambda: link.files is not None)
    with operator(there.endpoint, role="operator") as board:
        board.set("spo2", 97)
    until(link.moment_changed, lambda: "spo2" in link.log.now.board)

    def seen() -> list[Any]:
        return [(e["seq"], e["t"], e["kind"]) for e in link.log]

    before = seen()
    there.kill()
    until(link.state_changed, lambda: link.state.kind == "lost")
    assert window.status.link.text().startswith("lost")
    # While we still look for it, somebody else has it run another flow.
    again = robot(there.project, there.endpoint)
    files = deployable(load_ready(there.project))
    file = window.current_file
    script = it.session.document(file)
    other = replace(script, states=(replace(script.states[0], name="other"), *script.states[1:]))
    files[file] = codec.write(without_editor(other))
    with operator(again.endpoint, role="operator") as board:
        board.deploy(files, "situ.toml", force_after=0)
        board.set("spo2", 80)
    until(link.documents_came, lambda: 'name="other"' in link.files[file])
    until(link.moment_changed, lambda: link.log.now.board["spo2"].value == 80)
    # The same runtime went on: what was seen stands, and each event after it is there once.
    after = seen()
    assert after[: len(before)] == before
    assert [seq for seq, _, _ in after] == list(range(1, len(after) + 1))
    assert [e["version"] for e in link.log if e["kind"] == "deployed"] == [1]
    # All that was said of the link was so, once each: not with every event.
    assert states == ["connecting", "live", "lost", "live"]
    assert link.state.behind is not None
    assert "differs here" in window.status.link.text()
    window.robot.disconnect_robot()
