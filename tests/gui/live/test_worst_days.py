"""What goes wrong with a running robot is told in one true sentence, and mends itself."""

from __future__ import annotations

import signal
import subprocess
import sys
from collections.abc import Callable
from datetime import UTC, datetime, timedelta
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.gui.live.test_deploying import connect, listed, press, rename

from situ.blackboard.client import connect as operator
from situ_studio.live.delay import APART, Delays


@given(
    st.lists(st.floats(0, 90), min_size=1),
    st.sampled_from((0.0, 0.5, 3600.0, -3600.0, 86400.0)),
    st.floats(0, 1e6),
)
def test_what_differs_from_event_to_event_is_delay_and_what_stays_is_the_clocks(
    late: list[float], slow: float, begun: float
) -> None:
    """slow: how far the robot's clock is behind; late: how much later than at once each came."""
    delays = Delays()
    for n, seconds in enumerate((0.0, *late)):
        t = float(n)
        came = begun + t + seconds
        found = delays.take(t, came, 1e9 + t - slow, 1e9 + t + seconds)
        assert found.behind == pytest.approx(seconds + (slow if abs(slow) < APART else 0), abs=1e-4)
        assert found.apart == pytest.approx(0 if abs(slow) < APART else slow, abs=1e-4)


def test_a_version_that_waits_for_what_is_paused_says_so_and_runs_once_that_goes_on(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    link = connect(it, there.endpoint, until)
    window, now = it.window, link.log.now
    until(link.moment_changed, lambda: "converse" in now.applications)
    with operator(there.endpoint, role="operator") as board:
        board.debug("break", application="converse", state="2")
        board.publish("clickYes")
    until(link.moment_changed, lambda: now.applications["converse"].paused)
    file = rename(it, "greeting")
    window.deploying.ask()
    dialog, deploying = window.deploying.dialog, window.deploying.deploying
    press(it, dialog.deploy)
    until(deploying.changed, lambda: deploying.stands == "waiting")
    assert dialog.stands.text().endswith("converse is paused: let it go on.")
    dialog.force.setChecked(False)
    window.operating.resume()
    until(link.moment_changed, lambda: not now.applications["converse"].paused)
    until(deploying.changed, lambda: "paused" not in dialog.stands.text())
    # Nobody waits for what it says.
    with operator(there.endpoint, role="operator") as board:
        board.publish("clickNo")
    until(deploying.changed, lambda: deploying.stands == "running")
    until(link.documents_came, lambda: "greeting" in link.files[file])
    assert "same as the robot" in window.status.link.text()
    dialog.close()
    window.robot.disconnect_robot()


def test_a_robot_that_is_frozen_goes_or_comes_back_as_another_projects_is_told_as_that(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    link = connect(it, there.endpoint, until)
    window = it.window
    told: list[str] = []
    link.state_changed.connect(lambda: told.append(window.status.link.text()))
    # Clocks on walls need not agree: what differs is no delay.
    link._now = lambda: datetime.now(UTC) - timedelta(hours=1)
    with operator(there.endpoint, role="operator") as board:
        board.set("spo2", 96)
    until(link.moment_changed, lambda: "spo2" in link.log.now.board)
    window.robot.follower.refresh()
    assert ", its clock is 60 min ahead" in window.status.link.text()
    assert link.state.behind < 60
    link._now = lambda: datetime.now(UTC)
    # Its computer sleeps, and wakes: it is followed on, with every event once.
    there.process.send_signal(signal.SIGSTOP)
    until(link.state_changed, lambda: link.state.kind == "lost")
    there.process.send_signal(signal.SIGCONT)
    until(link.state_changed, lambda: link.connected)
    with operator(there.endpoint, role="operator") as board:
        board.set("spo2", 97)
    until(link.moment_changed, lambda: link.log.now.board["spo2"].value == 97)
    assert [event["seq"] for event in link.log] == list(range(1, len(link.log) + 1))
    assert told[0].startswith("lost ")
    assert told[1].startswith("live")
    # This computer sleeps for five minutes: it looks for the robot at once, and finds it.
    inner = link._link
    clock, slept = inner.clock, len(told)
    inner.clock = lambda: clock() + 300.0
    with operator(there.endpoint, role="operator") as board:
        board.set("spo2", 98)
    until(link.moment_changed, lambda: link.log.now.board["spo2"].value == 98)
    until(link.state_changed, lambda: link.connected)
    assert [event["seq"] for event in link.log] == list(range(1, len(link.log) + 1))
    assert [words.partition(" ")[0] for words in told[slept:]] in ([], ["lost", "live,"])
    # While somebody looks at what would be deployed it is killed.
    rename(it, "greeting")
    window.deploying.ask()
    dialog = window.deploying.dialog
    assert listed(dialog.changes)[0].startswith("state ")
    there.kill()
    until(link.state_changed, lambda: link.state.kind == "lost")
    assert listed(dialog.changes) == ["The robot is not there: what differs is told when it is."]
    assert not dialog.deploy.isEnabled()
    # In its place another robot answers: nothing of this one goes to it.
    robot(project("reception"), there.endpoint, "another")
    until(link.documents_came, lambda: "reception.rbd.xml" in (link.files or {}))
    window.robot.follower.refresh()
    assert ", project reception, not conversation" in window.status.link.text()
    assert "it is another robot's" in dialog.hindered.text()
    assert not dialog.deploy.isEnabled()
    assert "spo2" not in link.log.now.board
    dialog.close()
    # The project is exchanged for the one that runs: the link stays, and it is the same.
    window.open_project(it.session.root.parent / "reception")
    it.settle()
    window.robot.follower.refresh()
    assert ", same as the robot" in window.status.link.text()
    window.robot.disconnect_robot()


FLOOD = """
import sys
from situ.blackboard.client import connect
with connect(sys.argv[1], role="operator") as board:
    n = 0
    while True:
        n += 1
        board.set({f"flood.t{tag}": n for tag in range(200)})
"""
"""Who sets as many tags as the robot takes."""


def test_a_robot_that_is_killed_in_a_flood_of_events_is_followed_on_and_what_was_missed_is_counted(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    link = connect(it, there.endpoint, until)
    flood = subprocess.Popen([sys.executable, "-c", FLOOD, there.endpoint])
    try:
        until(link.came, lambda: len(link.log) > 2000)
        there.kill()
        until(link.state_changed, lambda: link.state.kind == "lost")
        assert it.window.status.link.text().startswith("lost ")
    finally:
        flood.kill()
        flood.wait(10)
    robot(there.project, there.endpoint)
    until(link.state_changed, lambda: link.connected)
    with operator(there.endpoint, role="operator") as board:
        board.set("spo2", 97)
    until(link.moment_changed, lambda: "spo2" in link.log.now.board)
    seqs = [event["seq"] for event in link.log]
    missed = sum(gap.count for gap in link.log.gaps)
    assert seqs[0] == 1
    assert all(one < next_ for one, next_ in pairwise(seqs))
    assert len(seqs) + missed == seqs[-1]
    it.window.robot.follower.refresh()
    told = f"{missed:,} events missed"
    assert (told in it.window.status.link.text()) == bool(missed)
    it.window.robot.disconnect_robot()
