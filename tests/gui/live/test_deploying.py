"""Deploying to a real robot from its dialog: a process of its own, over real sockets."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from situ.blackboard.replies import Turn, Turns
from situ_studio.live.deploying import Deploying
from situ_studio.live.deploying_dialog import DeployDialog
from situ_studio.live.link import RobotLink
from situ_studio.looks.theme import LIGHT

CONTROL = Qt.KeyboardModifier.ControlModifier


def connect(it: Any, endpoint: str, until: Any) -> Any:
    link = it.window.robot.link
    it.answers.put("robot", endpoint)
    it.window.setFocus()
    it.key(Qt.Key.Key_R, CONTROL)
    until(link.documents_came, lambda: link.files is not None)
    return link


def rename(it: Any, name: str) -> str:
    """The first state of the current application gets another name."""
    file: str = it.window.current_file
    script = it.session.document(file)
    first = replace(script.states[0], name=name)
    it.session.commit(file, replace(script, states=(first, *script.states[1:])), "Rename")
    return file


def listed(rows: Any) -> list[str]:
    return [rows.item(at).text() for at in range(rows.count())]


def versions(dialog: Any) -> list[str]:
    rows = dialog.versions
    return [rows.topLevelItem(at).text(1) for at in range(rows.topLevelItemCount())]


def press(it: Any, button: Any) -> None:
    """As a person does, once it can be pressed."""
    assert button.isEnabled()
    it.click(button)


def test_what_differs_is_told_deployed_and_taken_back(
    studio: Callable[..., Any],
    project: Callable[[str], Path],
    robot: Any,
    until: Any,
    tmp_path: Path,
) -> None:
    where = project("conversation")
    # The robot still speaks when it is deployed to, however slow this machine is.
    flow = where / "converse.rbd.xml"
    flow.write_text(flow.read_text().replace("<speech>Hello.", "<speech>" + "Hello. " * 200))
    there = robot(where)
    it = studio(there.project)
    link = connect(it, there.endpoint, until)
    side, actions = it.window.deploying, it.window.actions_.actions
    deploying = side.deploying
    # Nothing differs: there is no button, but the versions can be looked at.
    assert not actions["deploy"].isVisible()
    assert actions["versions"].isEnabled()
    file = rename(it, "greeting")
    button = it.window.toolbar.widgetForAction(actions["deploy"])
    it.settle()
    it.click(button)
    dialog = side.dialog
    until(deploying.changed, lambda: deploying.turns is not None)
    assert any("greeting" in line for line in listed(dialog.changes))
    assert not dialog.hindered.isVisible()
    # An edit while it is open is an edit of what would be sent.
    rename(it, "welcome")
    assert any("welcome" in line for line in listed(dialog.changes))
    # While the robot speaks it waits, says for what, and can be told not to.
    press(it, dialog.deploy)
    until(deploying.changed, lambda: deploying.stands == "waiting")
    assert "speech in state 1 of converse" in dialog.stands.text()
    assert not dialog.deploy.isEnabled()
    press(it, dialog.stop)
    until(deploying.changed, lambda: deploying.stands == "running")
    assert dialog.stands.text() == "Version 0 runs."
    it.click(dialog.force)
    dialog.seconds.setValue(0)
    press(it, dialog.deploy)
    until(deploying.changed, lambda: deploying.is_on_trial)
    assert "Version 2 runs." in dialog.stands.text()
    assert "goes back to version 0 by itself" in dialog.stands.text()
    until(link.documents_came, lambda: not actions["deploy"].isVisible())
    assert "welcome" in link.files[file]
    until(deploying.changed, lambda: "Version 2 deployed" in versions(dialog))
    # In one click it is as it was, and who did it stands in the trace.
    press(it, dialog.back)
    until(deploying.changed, lambda: deploying.stands == "running" and deploying.number == 0)
    until(link.documents_came, lambda: "welcome" not in link.files[file])
    until(deploying.changed, lambda: versions(dialog)[0] == "Rolled back to version 0")
    assert actions["deploy"].isVisible()
    assert [e["version"] for e in link.log if e["kind"] == "deployed"][-2:] == [2, 0]
    # A certain one: the row that is chosen.
    it.click_row(
        dialog.versions, it.row_with(dialog.versions, "Version 2 deployed", 1).siblingAtColumn(0)
    )
    assert dialog.back.text() == "Roll back to version 2"
    press(it, dialog.back)
    until(link.documents_came, lambda: "welcome" in link.files[file])
    # What the robot runs opens beside mine, which stays as it is.
    rename(it, "again")
    it.answers.put("new_folder", str(tmp_path / "theirs"))
    press(it, dialog.theirs)
    other = it.window.windows.windows[-1]
    assert other is not it.window
    assert other.session.document(file).states[0].name == "welcome"
    assert it.session.document(file).states[0].name == "again"
    # A second time there is something in its way.
    it.answers.put("new_folder", str(tmp_path / "theirs"))
    press(it, dialog.theirs)
    assert "is there already" in it.answers.told[-1]
    dialog.close()
    it.window.robot.disconnect_robot()
    assert deploying.stands == "idle"


def test_what_is_wrong_is_not_sent(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    connect(it, there.endpoint, until)
    file = it.window.current_file
    script = it.session.document(file)
    twice = (script.states[0], *script.states)
    it.session.commit(file, replace(script, states=twice), "Two of one number")
    it.window.commands.deploy()
    dialog = it.window.deploying.dialog
    assert dialog.hindered.isVisible()
    assert dialog.hindered.text()
    assert not dialog.deploy.isEnabled()
    it.session.undo()
    assert dialog.deploy.isEnabled()
    assert not dialog.hindered.isVisible()
    # What the robot itself refuses is told in its words.
    deploying = it.window.deploying.deploying
    deploying.rollback(99)
    until(deploying.changed, lambda: deploying.stands == "failed")
    assert dialog.stands.text().startswith("The robot did not take it: ")
    assert "99" in dialog.stands.text()
    assert dialog.deploy.isEnabled()
    # Without a robot there is nothing to send it to.
    it.window.robot.disconnect_robot()
    assert not dialog.deploy.isEnabled()
    dialog.close()


def test_a_history_that_is_as_long_as_before_is_shown_as_it_is_now(qt: Any) -> None:
    # A robot tells no more than so many lines of it.
    deploying = Deploying(RobotLink())
    parent = QWidget()
    dialog = DeployDialog(deploying, lambda: None, LIGHT, parent)
    for version in (1, 2):
        turn = Turn(0.0, version, "operator:ann", "deployed")
        deploying.turns = Turns(id=1, turns=(turn,), version=version, kept=(0, version))
        deploying.changed.emit()
        assert versions(dialog) == [f"Version {version} deployed"]
    parent.deleteLater()


def test_a_version_that_fails_in_its_first_minute_is_told_of_though_the_dialog_is_closed(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    link = connect(it, there.endpoint, until)
    rename(it, "greeting")
    it.window.commands.deploy()
    side = it.window.deploying
    it.click(side.dialog.force)
    side.dialog.seconds.setValue(0)
    press(it, side.dialog.deploy)
    until(side.deploying.changed, lambda: side.deploying.is_on_trial)
    side.dialog.close()
    # Whoever killed it: a version whose process dies in its first minute has failed.
    there.kill()
    until(link.state_changed, lambda: link.state.kind == "lost")
    robot(there.project, there.endpoint)
    until(side.deploying.ended, lambda: bool(it.answers.told))
    assert it.answers.told[0].startswith("The robot has gone back to version 0 by itself: ")
    it.window.robot.disconnect_robot()
