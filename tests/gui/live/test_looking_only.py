"""A robot that knows a person as a viewer: the editor shows it and offers nothing it would refuse.

A process of its own with keys of its own, over real sockets (docs/security.md).
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import Qt

import situ
from situ.blackboard import keys
from situ.blackboard.identity import KeyRole
from situ.blackboard.keys import KnownKey, RobotKey
from situ_studio.actions import command

HANDS = (
    "operate.pause",
    "operate.break",
    "operate.while",
    "operate.goto",
    "operate.raise",
    "operate.set",
    "deploy",
)
REASON = "only an operator may: your key lets you look only"


def known(state: Path, name: str, role: KeyRole, addresses: tuple[str, ...] = ()) -> Path:
    """A folder with the keys of somebody whom the robot knows. addresses: where it was met."""
    folder, pair = state.parent.parent / name, keys.new_pair(name)
    keys.add_known(state, name, KnownKey(pair.public, role))
    public = keys.RobotKeys(state).public.decode()
    keys.new_client(folder, pair, "ward", RobotKey(public, addresses, role))
    return folder


def test_who_may_only_look_finds_what_the_robot_would_refuse_greyed_with_the_reason(
    studio: Callable[..., Any],
    project: Callable[[str], Path],
    robot: Any,
    until: Any,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    state = tmp_path / "state" / "keys"
    state.parent.mkdir()
    keys.new_robot(state)
    own, ann = known(state, "tablet", "viewer"), known(state, "ann", "operator")
    monkeypatch.setenv("SITU_KEYS", str(own))
    there = robot(project("conversation"))
    it = studio(there.project)
    window, link = it.window, it.window.robot.link
    window.robot.connect_robot(there.endpoint)
    until(link.documents_came, lambda: link.files is not None)
    until(link.moment_changed, lambda: "converse" in link.log.now.applications)
    with situ.connect(there.endpoint, keys=ann, role="operator") as board:
        board.debug("break", application="converse", state="3")
        until(link.moment_changed, lambda: bool(link.log.now.breakpoints))
        flow = it.session.document(window.current_file)
        first = replace(flow.states[0], name="greeting")
        changed = replace(flow, states=(first, *flow.states[1:]))
        it.session.commit(window.current_file, changed, "Rename")
        it.select("state", "2")
        it.settle()
        actions = window.actions_
        for id in HANDS:
            assert actions.actions[id].isVisible(), id
            assert not actions.actions[id].isEnabled(), id
            assert actions.reason(command(id)) == REASON, id
        assert REASON in actions.actions["operate.pause"].toolTip()
        status = window.status
        assert "you can look only" in status.link.text()
        # No key gets through either: the robot is asked for nothing.
        it.key(Qt.Key.Key_F9)
        table = window.operating.panel.table
        window.bottom.choose("breakpoints")
        it.settle()
        it.click_row(table, table.model().index(0, 0))
        table.setFocus()
        it.key(Qt.Key.Key_Delete)
        assert status.said.text() == REASON
        assert not window.operating.panel.add.isEnabled()
        # What was deployed he may read, and why he can not go back stands there.
        assert actions.actions["versions"].isEnabled()
        actions.actions["versions"].trigger()
        deploying, dialog = window.deploying.deploying, window.deploying.dialog
        until(deploying.changed, lambda: deploying.turns is not None)
        assert not dialog.deploy.isEnabled()
        assert not dialog.back.isEnabled()
        assert "Only an operator may deploy" in dialog.hindered.text()
        dialog.close()
        # What others do comes as ever.
        board.debug("pause", application="converse")
        until(link.moment_changed, lambda: link.log.now.applications["converse"].paused)
        it.settle()
        assert not actions.actions["operate.resume"].isEnabled()
        assert [one["state"] for one in link.log.now.breakpoints] == ["3"]
    window.robot.disconnect_robot()
