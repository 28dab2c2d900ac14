"""The dialog *Connect to a robot*: robots found in the network for real, by multicast over the
loopback interface, and which one a person takes."""

from __future__ import annotations

import uuid
import weakref
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import shiboken6
from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QAccessible
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget
from tests.gui.live.test_looking_only import known

from situ.blackboard import keys
from situ.blackboard.announced import Announced, fingerprint
from situ.blackboard.keys import RobotKey, new_pair
from situ.engine.announcing import Announcement, Announcing
from situ_studio.live.connecting_dialog import Chosen, ConnectDialog
from situ_studio.live.nearby import Found, NearbyRobots
from situ_studio.looks.theme import LIGHT
from situ_studio.window.dialogs import Dialogs

CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
HERE = "127.0.0.1"
USUAL = "tcp://127.0.0.1:5570"


class Told(NearbyRobots):
    """In the place of the process: what is found is said by the test."""

    def start(self) -> None: ...

    def stop(self) -> None: ...

    def tell(self, *robots: Found) -> None:
        self.robots.update({one.name: one for one in robots})
        self.changed.emit()

    def fail(self, why: str) -> None:
        self.failed = why
        self.changed.emit()


def asking(nearby: NearbyRobots, over: QWidget) -> ConnectDialog:
    dialog = ConnectDialog(USUAL, nearby, LIGHT, over)
    dialog.show()
    dialog.activateWindow()
    QApplication.processEvents()
    return dialog


def row(dialog: ConnectDialog, name: str) -> list[str] | None:
    found = dialog.list.findItems(name, Qt.MatchFlag.MatchStartsWith)
    return [found[0].text(at) for at in range(3)] if found else None


def press(key: Qt.Key, modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier) -> None:
    at = QApplication.focusWidget()
    assert at is not None
    QTest.keyClick(at, key, modifiers)


# -- for real ------------------------------------------------------------------


def test_a_robot_in_the_network_is_found_stands_as_it_does_and_is_seen_going(
    over: QWidget, until: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    mine, robot = new_pair("ann"), new_pair("robot").public
    keys.new_client(tmp_path, mine, "ward", RobotKey(robot, ("tcp://10.0.0.5:5570",)))
    monkeypatch.setenv("SITU_KEYS", str(tmp_path))
    names = [f"{kind}-{uuid.uuid4().hex[:10]}" for kind in "abc"]
    told = zip(names, (fingerprint(robot), fingerprint(new_pair("x").public), ""), strict=True)
    every = [Announcing() for _ in names]
    nearby = NearbyRobots([HERE])
    dialog = asking(nearby, over)
    try:
        for at, (announcing, (name, key)) in enumerate(zip(every, told, strict=True)):
            announcing.begin(Announcement(Announced(name, "rob", 5570 + at, key=key), HERE))
        until(nearby.changed, lambda: all(row(dialog, name) for name in names))
        assert [row(dialog, name) for name in names] == [
            [f"{names[0]} at rob", "tcp://127.0.0.1:5570", "You have its key"],
            [f"{names[1]} at rob", "tcp://127.0.0.1:5571", "Needs a key you do not have"],
            [f"{names[2]} at rob", "tcp://127.0.0.1:5572", "Open to everybody"],
        ]
        every[0].close()
        until(nearby.changed, lambda: row(dialog, names[0])[2] == "Gone")  # type: ignore[index]
        press(Qt.Key.Key_Escape)
        assert dialog.result() == ConnectDialog.DialogCode.Rejected
        # It is followed no longer.
        assert nearby._process is None
    finally:
        nearby.stop()
        for announcing in every:
            announcing.close()


def test_without_the_program_that_looks_the_dialog_says_so_and_an_address_can_be_given(
    over: QWidget, until: Any
) -> None:
    nearby = NearbyRobots(["no address"])
    dialog = asking(nearby, over)
    until(nearby.changed, lambda: bool(nearby.failed))
    assert dialog.told.text().startswith("Robots can not be looked for: ")
    QTest.keyClicks(dialog.address, "tcp://10.0.0.5:5570")
    press(Qt.Key.Key_Return)
    assert dialog.result() == ConnectDialog.DialogCode.Accepted
    assert dialog.chosen == Chosen("tcp://10.0.0.5:5570")


# -- choosing ------------------------------------------------------------------


def test_a_robot_is_taken_from_the_list_by_keys_with_the_key_that_it_announced(
    over: QWidget,
) -> None:
    nearby = Told()
    dialog = asking(nearby, over)
    assert "Looking for robots" in dialog.told.text()
    assert dialog.chosen == Chosen(USUAL)
    nearby.tell(
        Found("ward at rob1", "ready", "tcp://10.0.0.5:5570", "ab"),
        Found("Desk at rob2", "open", "tcp://10.0.0.6:5570"),
    )
    # Nothing is taken before somebody does.
    assert dialog.address.text() == USUAL
    assert [dialog.list.topLevelItem(at).text(0) for at in range(2)] == [  # type: ignore[union-attr]
        "Desk at rob2",
        "ward at rob1",
    ]
    press(Qt.Key.Key_Tab, SHIFT)
    assert dialog.list.hasFocus()
    press(Qt.Key.Key_Down)
    assert dialog.chosen == Chosen("tcp://10.0.0.6:5570")
    assert "without keys" in dialog.told.text()
    press(Qt.Key.Key_Down)
    assert dialog.chosen == Chosen("tcp://10.0.0.5:5570", "ab")
    # The robot gets another address: so does who has taken it.
    nearby.tell(Found("ward at rob1", "ready", "tcp://10.0.0.7:5570", "ab"))
    assert dialog.chosen == Chosen("tcp://10.0.0.7:5570", "ab")
    press(Qt.Key.Key_Return)
    assert dialog.result() == ConnectDialog.DialogCode.Accepted


def test_an_address_that_a_person_gives_is_no_robot_of_the_list(over: QWidget) -> None:
    nearby = Told()
    dialog = asking(nearby, over)
    nearby.tell(Found("ward at rob1", "no-key", "tcp://10.0.0.5:5570", "ab"))
    (item,) = dialog.list.findItems("ward", Qt.MatchFlag.MatchStartsWith)
    dialog.list.setCurrentItem(item)
    assert "situ keys add" in dialog.told.text()
    dialog.address.setFocus()
    press(Qt.Key.Key_End)
    press(Qt.Key.Key_Backspace)
    assert dialog.chosen == Chosen("tcp://10.0.0.5:557")
    assert dialog.told.text() == ""
    # What somebody types stays, whatever the robot does.
    nearby.tell(Found("ward at rob1", "no-key", "tcp://10.0.0.9:5570", "ab"))
    assert dialog.chosen == Chosen("tcp://10.0.0.5:557")
    dialog.address.clear()
    assert not dialog.connect_button.isEnabled()
    dialog.reject()


def test_what_strangers_wrote_is_text_and_everything_is_named(over: QWidget) -> None:
    nearby = Told()
    dialog = asking(nearby, over)
    nearby.tell(
        *(
            Found(f"<b>{standing}</b>", standing, "tcp://10.0.0.5:5570")
            for standing in ("ready", "open", "no-key", "other-key", "other-version", "gone")
        )
    )
    rows = dialog.list.findItems("<b>", Qt.MatchFlag.MatchStartsWith)
    assert "<p>&lt;b&gt;open&lt;/b&gt;</p>" in {item.toolTip(0) for item in rows}
    advice = set()
    for item in rows:
        dialog.list.setCurrentItem(item)
        advice.add(dialog.told.text())
    assert len(advice) == 6
    tree = QAccessible.queryAccessibleInterface(dialog.list)
    assert tree.text(QAccessible.Text.Name) == "Robots found in the network"
    field = QAccessible.queryAccessibleInterface(dialog.address)
    assert field.text(QAccessible.Text.Name) == "Address"
    dialog.list.clearSelection()
    nearby.fail("no network")
    assert dialog.told.text() == "Robots can not be looked for: no network"
    dialog.reject()


# -- in the window -------------------------------------------------------------


def test_the_window_asks_so_and_nothing_is_left_of_the_dialog(studio: Callable[..., Any]) -> None:
    it = studio()
    seen: list[weakref.ref[Any]] = []

    def answer() -> None:
        dialog = QApplication.activeModalWidget()
        if isinstance(dialog, ConnectDialog):
            seen.append(weakref.ref(dialog))
            QTest.keyClicks(dialog.address, "tcp://10.0.0.5:5570")
            QTest.keyClick(dialog.address, Qt.Key.Key_Return)

    QTimer.singleShot(0, it.window, answer)
    dialogs = Dialogs(it.window)
    assert dialogs.robot(USUAL) == Chosen("tcp://10.0.0.5:5570")
    dialogs.deleteLater()
    it.settle()
    left = seen[0]()
    assert left is None or not shiboken6.isValid(left)


def test_a_robot_that_was_found_is_spoken_to_by_its_key_and_none_without(
    studio: Callable[..., Any],
    project: Callable[[str], Path],
    robot: Any,
    until: Any,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    folder = tmp_path / "state" / "keys"
    public = keys.new_robot(folder).public
    # It is known at another address than it has now; and so is another robot.
    client = known(folder, "ann", "operator", ("tcp://10.0.0.5:5570",))
    other = f'public = "{new_pair("robot").public}"\naddresses = ["tcp://10.0.0.6:5570"]\n'
    (client / "robots" / "desk.toml").write_text(other)
    monkeypatch.setenv("SITU_KEYS", str(client))
    there = robot(project("reception"))
    it = studio(there.project)
    link = it.window.robot.link
    it.answers.put("robot", Chosen(there.endpoint, "0" * 32))
    it.window.setFocus()
    it.key(Qt.Key.Key_R, CONTROL)
    assert "there is no key for this robot here" in it.answers.told[0]
    assert not it.window.robot.connected
    it.answers.put("robot", Chosen(there.endpoint, fingerprint(public)))
    it.key(Qt.Key.Key_R, CONTROL)
    until(link.state_changed, lambda: link.connected)
    it.window.robot.disconnect_robot()
