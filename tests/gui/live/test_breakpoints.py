"""Breakpoints with conditions, in parts, kept per project: on a real robot."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QSettings, Qt
from tests.gui.live.test_link import connect

from situ.document import when_text
from situ.document.condition import Condition, Group
from situ.document.condition import Test as One
from situ.document.ready import load_ready
from situ_studio.live.breaking import MOST, KeptBreakpoints, points_at

SHIFT = Qt.KeyboardModifier.ShiftModifier
FLOW, PART = "reception.rbd.xml", "register.rbd.xml"

CONDITIONS = (
    Condition((One("a.b", "is", "true"),)),
    Condition((One("word", "is", 'say "<no>" & go'), One("n", "above", "3", within=2.0))),
    Condition((Group("any", (One("a", "exists", "true"), Group("none", (One("b", "is", "1"),)))),)),
)


@pytest.mark.parametrize("condition", CONDITIONS)
def test_a_condition_is_read_as_it_was_written(condition: Condition) -> None:
    assert when_text.read(when_text.write(condition)) == condition


def test_what_is_kept_of_a_project_stands_once_and_only_so_many_projects(tmp_path: Path) -> None:
    settings = QSettings(str(tmp_path / "kept.ini"), QSettings.Format.IniFormat)
    kept = KeptBreakpoints(settings)
    assert kept.of("a") == []
    kept.add("a", {"situation": "s"})
    kept.add("a", {"situation": "s", "when": "<x/>"})
    assert KeptBreakpoints(settings).of("a") == [{"situation": "s", "when": "<x/>"}]
    kept.remove("a", {"situation": "s"})
    assert kept.of("a") == []
    for number in range(MOST + 1):
        kept.add(f"p{number}", {"situation": "s"})
    assert kept.of("p0") == []
    assert kept.of("p1") != []
    settings.setValue("breakpoints", "{")
    assert kept.of("p1") == []


def test_a_place_in_a_part_means_every_state_that_runs_it(project: Callable[[str], Path]) -> None:
    whole = load_ready(project("reception"))
    part = whole.parts[PART]
    assert points_at(whole, PART, part, ("state", "2")) == [
        {"application": "reception", "state": "16/2"}
    ]
    event = part.state("2").events[0]  # type: ignore[union-attr]
    (point,) = points_at(whole, PART, part, ("state", "2", "event", "0"))
    assert (point["from"], point["to"]) == ("16/2", f"16/{event.next}")


def test_a_breakpoint_with_a_condition_pauses_only_while_it_holds_and_is_kept(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("reception"))
    it = studio(there.project)
    window = it.window
    link = connect(it, there.endpoint, until)
    until(link.moment_changed, lambda: "reception" in link.log.now.applications)
    window.open_file(PART)
    it.select("state", "2")
    it.key(Qt.Key.Key_F9, SHIFT)
    until(link.moment_changed, lambda: any(b.get("when") for b in link.log.now.breakpoints))
    until(link.moment_changed, lambda: len(link.log.now.breakpoints) == 1)
    panel = window.operating.panel
    assert panel.isVisible()
    (standing,) = link.log.now.breakpoints
    assert standing["state"] == "16/2"
    # It is shown on the part's own card, and on the one that runs it.
    window.robot.follower.refresh()
    assert window.views[PART].canvas.look.live.breakpoints == {"2"}
    window.open_file(FLOW)
    window.robot.follower.refresh()
    assert window.views[FLOW].canvas.look.live.breakpoints == {"16"}
    # The condition is edited as a guard is.
    it.settle()
    box = panel.condition.box(0)
    it.fill(box.tag, "robot.stop")
    until(
        link.moment_changed,
        lambda: (
            [b["when"] for b in link.log.now.breakpoints]
            == ['<data tag="robot.stop" exists="true"/>']
        ),
    )
    it.settle()
    assert panel.table.rows.rows[0].cells[1].endswith("while robot.stop exists")
    now = link.log.now.applications["reception"]

    def go() -> None:
        window.open_file(PART)
        it.select("state", "2")
        window.actions_.actions["operate.goto"].trigger()

    go()
    until(link.moment_changed, lambda: now.state == "16/2")
    assert not now.paused
    it.answers.put("name", "robot.stop = false")
    window.actions_.actions["operate.set"].trigger()
    until(link.moment_changed, lambda: "robot.stop" in link.log.now.board)
    go()
    until(link.moment_changed, lambda: now.paused)
    assert window.operating.waiting.text().startswith("reception is paused at 16 ")
    window.robot.follower.refresh()
    assert window.views[PART].canvas.look.live.paused == {"2"}
    # What can not be judged at a moment is refused in words, and nothing is another.
    it.settle()
    hold = panel.condition.box(0).hold
    it.fill(hold, "3")
    until(window.operating.refused, lambda: "for" in window.status.said.text())
    assert link.log.now.breakpoints[0]["when"] == '<data tag="robot.stop" exists="true"/>'
    window.disconnect_robot()
    # Another robot has none: those of this project are offered, and nothing is set unasked.
    there.stop()
    other = robot(there.project, state="other")
    connect(it, other.endpoint, until)
    until(link.moment_changed, lambda: "reception" in link.log.now.applications)
    window.bottom.choose("breakpoints")
    it.settle()
    assert link.log.now.breakpoints == ()
    assert panel.table.rows.rows[0].cells[3] == "not on this robot"
    it.click(panel.again)
    until(link.moment_changed, lambda: bool(link.log.now.breakpoints))
    it.settle()
    assert link.log.now.breakpoints[0]["when"] == '<data tag="robot.stop" exists="true"/>'
    assert not panel.again.isVisible()
    # Taken away, it is not offered again.
    panel.table.setFocus()
    panel.table.setCurrentIndex(panel.table.rows.index(0, 0))
    it.key(Qt.Key.Key_Delete)
    until(link.moment_changed, lambda: not link.log.now.breakpoints)
    it.settle()
    assert window.operating._earlier == []
    window.disconnect_robot()
