"""Connected to a real robot: a process of its own, over real sockets."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import Qt

import situ
from situ.blackboard.client import connect as operator
from situ.document import codec
from situ.document.export import deployable, without_editor
from situ.document.ready import load_ready
from situ_studio.live import link_state

CONTROL = Qt.KeyboardModifier.ControlModifier


def connect(studio: Any, endpoint: str, until: Any) -> Any:
    """By the keyboard, as a person would."""
    link = studio.window.robot.link
    studio.answers.put("robot", endpoint)
    studio.window.setFocus()
    studio.key(Qt.Key.Key_R, CONTROL)
    until(link.state_changed, lambda: link.connected)
    return link


def rows(table: Any) -> dict[str, tuple[str, ...]]:
    return {row.key: row.cells for row in table.rows.rows}


def test_graphs_and_tables_show_what_the_robot_does(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    assert it.window.status.link.text() == "no robot"
    link = connect(it, there.endpoint, until)
    until(link.moment_changed, lambda: link.log.now.situation == "conversation")
    window = it.window
    with (
        situ.connect(there.endpoint, module="gaze-sound", resources=["head"]) as board,
        board.authority("head") as head,
    ):
        board.set("sound.slap", 40)
        until(link.moment_changed, lambda: link.log.now.robot.get("head") is None)
        head.command({"yaw": 40}, valid=5)
        until(link.moment_changed, lambda: link.log.now.robot.get("head") == {"yaw": 40})
        assert link.log.now.situation == "sound"
        window.robot.follower.refresh()
        assert rows(window.robot.authority)["head"][1] == "gaze-sound"
        assert rows(window.robot.blackboard)["sound.slap"][1:3] == ("40", "gaze-sound")
    until(link.moment_changed, lambda: "head" not in link.log.now.holders)
    window.robot.follower.refresh()
    assert rows(window.robot.authority)["screen"][1] == "converse"
    shown = window.views[window.current_file]
    assert shown.canvas.look.live.active == {"1"}
    assert "same as the robot" in window.status.link.text()
    # The trace has begun with the robot's, not with us.
    assert link.log[0]["seq"] == 1
    # An edit here makes the documents differ, and says so; undone they are the same again.
    file = window.current_file
    script = it.session.document(file)
    it.session.commit(file, replace(script, states=script.states[1:]), "Delete state 1")
    assert "differs here" in window.status.link.text()
    it.session.undo()
    assert "same as the robot" in window.status.link.text()
    it.window.robot.disconnect_robot()
    assert window.status.link.text() == "no robot"
    assert shown.canvas.look.live is None
    # What that robot runs is not what the next one does.
    it.session.commit(file, replace(script, states=script.states[1:]), "Delete state 1")
    assert window.robot.follower.same is None


def test_a_lost_robot_is_told_at_once_and_found_again(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("reception"))
    it = studio(there.project)
    link = connect(it, there.endpoint, until)
    until(link.moment_changed, lambda: "reception" in link.log.now.applications)
    first = link.log[-1]["seq"]
    there.kill()
    until(link.state_changed, lambda: link.state.kind == "lost")
    assert it.window.status.link.text().startswith("lost")
    again = robot(there.project, there.endpoint)
    until(link.state_changed, lambda: link.connected)
    until(link.moment_changed, lambda: link.log.seq >= 1)
    assert again.endpoint == there.endpoint
    seqs = [event["seq"] for event in link.log]
    assert seqs == list(range(1, len(seqs) + 1))
    assert first >= 1
    it.window.robot.disconnect_robot()


def test_where_the_robot_begins_anew_no_view_stays_at_a_moment_that_is_gone(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("reception"))
    it = studio(there.project)
    link = connect(it, there.endpoint, until)
    until(link.moment_changed, lambda: "reception" in link.log.now.applications)
    viewing, bookmarks = it.window.robot.follower.viewing, it.window.robot.timeline.bookmarks
    viewing.pause()
    bookmarks.add(viewing.t, "here")
    assert not viewing.follows
    there.stop()
    until(link.state_changed, lambda: link.state.kind == "lost")
    assert bookmarks.every
    robot(there.project, there.endpoint)
    until(link.began_anew, lambda: viewing.follows)
    assert bookmarks.every == []
    until(link.moment_changed, lambda: "reception" in link.log.now.applications)
    it.window.robot.disconnect_robot()


def test_what_is_deployed_meanwhile_is_what_the_documents_are_compared_with(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    link = connect(it, there.endpoint, until)
    follower = it.window.robot.follower
    until(link.documents_came, lambda: follower.same is True)
    files = deployable(load_ready(there.project))
    file = it.window.current_file
    script = it.session.document(file)
    greeting = replace(script.states[0], name="greeting")
    it.session.commit(file, replace(script, states=(greeting, *script.states[1:])), "Rename")
    assert "differs here" in it.window.status.link.text()
    files[file] = codec.write(without_editor(it.session.document(file)))
    with operator(there.endpoint, role="operator") as board:
        board.deploy(files, "situ.toml", force_after=0)
    until(link.documents_came, lambda: follower.same is True)
    assert "same as the robot" in it.window.status.link.text()
    assert [e["version"] for e in link.log if e["kind"] == "deployed"] == [1]
    seqs = [event["seq"] for event in link.log]
    assert seqs == list(range(1, len(seqs) + 1))
    it.window.robot.disconnect_robot()


def test_an_address_where_nobody_answers_is_tried_and_can_be_given_up(
    studio: Callable[..., Any], project: Callable[[str], Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    # However slow this machine is.
    monkeypatch.setattr(link_state, "QUIET", 60.0)
    it = studio(project("reception"))
    it.answers.put("robot", "tcp://127.0.0.1:9")
    it.window.setFocus()
    it.key(Qt.Key.Key_R, CONTROL)
    link, status = it.window.robot.link, it.window.status.link
    assert status.text() == "connecting to tcp://127.0.0.1:9"
    # It may be a wrong address; whoever waits is told so.
    begun = link.state.since
    link._link.clock = lambda: begun + 75.0
    it.window.robot.follower.refresh()
    assert status.text() == "nobody answers at tcp://127.0.0.1:9 for 75 s; still trying"
    refusals: list[str] = []
    link.set(it.window, {"x": 1}, refusals.append)
    assert refusals == ["No robot is connected."]
    it.window.robot.disconnect_robot()
    assert it.window.status.link.text() == "no robot"


def test_what_is_no_address_gets_one_line(
    studio: Callable[..., Any], project: Callable[[str], Path]
) -> None:
    it = studio(project("reception"))
    it.answers.put("robot", "the robot in the lobby")
    it.window.setFocus()
    it.key(Qt.Key.Key_R, CONTROL)
    assert len(it.answers.told) == 1
    assert "the robot in the lobby" in it.answers.told[0]
    assert it.window.status.link.text() == "no robot"
