"""Issue 10's end: six questions about robots that run, each answered within three clicks.

The robots are real processes over real sockets, the modules those of a test that plays them. The
clicks are counted by the hand that makes them.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from msgspec.structs import replace
from PySide6.QtCore import QPoint
from tests.gui.live.test_link import connect
from tests.gui.live.test_why import FLOW, SCRIPT, Clicks, seen

import situ
from situ.blackboard.client import connect as operator

MOST = 3
IDLE = '<timeout next="1" idle="true">60</timeout>'


class Carer(Clicks):
    """Asks one question at a time."""

    def __enter__(self) -> Carer:
        self.count = 0
        return self

    def __exit__(self, *_: object) -> None:
        assert self.count <= MOST, f"it took {self.count} clicks"

    def click(self, widget: Any, at: QPoint | None = None) -> None:
        self.it.click(widget, at)
        self.count += 1

    def row(self, table: Any, row: int) -> None:
        self.it.click_row(table, table.rows.index(row, 1))
        self.count += 1

    def panel(self, name: str) -> None:
        self.click(self.it.window.bottom.button(name))

    def tab(self, file: str) -> None:
        tabs = self.it.window.tabs
        index = tabs.files().index(file)
        self.click(tabs.bar, tabs.bar.tabRect(index).center())

    def command(self, name: str) -> None:
        """A button of the toolbar."""
        window = self.it.window
        button = window.toolbar.widgetForAction(window.actions_.actions[name])
        self.click(button)


def test_of_the_conversation(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    window = it.window
    link = connect(it, there.endpoint, until)
    panel, viewing = window.why.panel, window.robot.follower.viewing
    until(link.moment_changed, lambda: "converse" in link.log.now.applications)
    now = link.log.now
    with operator(there.endpoint, role="operator") as board:
        board.publish("clickYes")
        until(link.moment_changed, lambda: now.applications["converse"].state == "2")
        window.robot.follower.refresh()
        it.settle()

        # Which state, since when, how did it get there?
        with Carer(it) as carer:
            carer.command("why")
        assert panel.title.text() == "converse enters 2 sleep"
        assert panel.more.text().startswith(
            f"at {viewing.written(viewing.log.now.applications['converse'].since)}"
        )
        assert seen(it)[0].startswith("event clickYes comes to converse")
        assert any("goes from 1 hello to 2 sleep" in words for words in seen(it))
        # Its card says so without a click.
        assert window.views[FLOW].canvas.look.live.active == {"2"}

        # Why did the robot turn its head?
        with (
            situ.connect(there.endpoint, module="gaze-sound", resources=["head"]) as gaze,
            gaze.authority("head") as head,
        ):
            gaze.set("sound.slap", 40)
            until(link.moment_changed, lambda: "head" in now.holders)
            head.command({"yaw": 40}, valid=5)
            until(link.moment_changed, lambda: now.robot.get("head") == {"yaw": 40})
            window.robot.follower.refresh()
            it.settle()
            with Carer(it) as carer:
                carer.panel("authority")
                carer.row_menu(window.robot.authority, "head")
                carer.choose(window.why.menus.shown, "Why did head move?")
            assert "gaze-sound moves head" in panel.title.text()
            assert seen(it)[0].startswith("gaze-sound sets sound.slap to 40")
            assert any(words.startswith("situation sound") for words in seen(it))
            assert any("sound.slap 40" in link.values for link in panel.links)

        # Why does the nod module not nod?
        with (
            situ.connect(there.endpoint, module="nod", resources=["head"]) as nod,
            nod.authority("head"),
        ):
            until(link.moment_changed, lambda: "nod" in now.asking)
            until(link.moment_changed, lambda: now.situation == "conversation")
            window.views[FLOW].current_view().setFocus()
            canvas_of(it, SCRIPT)
            with Carer(it) as carer:
                carer.tab(SCRIPT)
                carer.card_menu(window.views[SCRIPT].canvas, "module", "nod")
                carer.choose(window.context_menus.shown, "Why not?")
            assert panel.title.text() == "Why does nod not hold head?"
            assert seen(it)[0] == "nod has no priority in situation conversation"

        # What was on the blackboard when it stopped?
        board.set("face.direction", 12)
        board.set("robot.stop", True)
        until(link.moment_changed, lambda: now.applications["converse"].suspended)
        board.set("face.direction", 50)
        until(link.moment_changed, lambda: now.board["face.direction"].value == 50)
        window.open_file(FLOW)
        window.select(())
        window.robot.follower.refresh()
        it.settle()
        with Carer(it) as carer:
            carer.command("why")
            assert panel.title.text().startswith("converse is suspended")
            assert seen(it)[0].startswith("you set robot.stop to true")
            carer.row(panel.table, len(panel.links) - 1)
            carer.panel("blackboard")
        then = {one.key: one.cells[1] for one in window.robot.blackboard.rows.rows}
        assert then["robot.stop"] == "true"
        assert then["face.direction"] == "12"
        viewing.follow()
    window.disconnect_robot()


def test_of_the_reception(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    where = project("reception")
    file = where / "reception.rbd.xml"
    text = file.read_text()
    assert IDLE in text
    # A test has no minute: people here give up at once.
    file.write_text(text.replace(IDLE, '<timeout next="1">0.2</timeout>'))
    there = robot(where)
    it = studio(where)
    window = it.window
    link = connect(it, there.endpoint, until)
    until(link.documents_came, lambda: window.robot.follower.same is True)
    now = link.log.now

    def gave_up() -> int:
        taken = now.applications["reception"].crossed
        return sum(n for (source, _, _, timeout), n in taken.items() if timeout and source == "2")

    with operator(there.endpoint, role="operator") as board:
        for times in (1, 2):
            board.debug("goto", application="reception", state="2")
            until(link.moment_changed, lambda times=times: gave_up() == times)
    # How often did people give up in this state?
    window.robot.follower.refresh()
    it.settle()
    canvas = window.views["reception.rbd.xml"].canvas
    with Carer(it) as carer:
        card = canvas.graph.nodes[canvas._find(("state", "2"))[0]].view
    assert "The time ran out 2×: nobody went on." in card.toolTip()
    assert canvas.look.live.gave_up == {"2": 2}
    # Which state, since when, how did it get there: the time ran out.
    with Carer(it) as carer:
        carer.command("why")
    assert window.why.panel.title.text() == "reception enters 1 start"
    assert any("timeout" in words for words in seen(it)), seen(it)
    # What differs between the robot's flow and mine?
    script = it.session.document("reception.rbd.xml")
    states = tuple(
        replace(one, timeout=replace(one.timeout, seconds=30.0)) if one.no == "2" else one
        for one in script.states
    )
    it.session.commit("reception.rbd.xml", replace(script, states=states), "Change timeout")
    it.settle()
    assert "differs here" in window.status.link.text()
    with Carer(it) as carer:
        carer.command("deploy")
    told = [
        window.deploying.dialog.changes.item(n).text()
        for n in range(window.deploying.dialog.changes.count())
    ]
    assert any("timeout 0.2 → 30 s" in words for words in told), told
    window.deploying.dialog.close()
    window.disconnect_robot()


def canvas_of(it: Any, file: str) -> None:
    """The tab has been looked at before, as a person's would."""
    current = it.window.current_file
    it.window.open_file(file)
    it.settle()
    it.window.open_file(current)
    it.settle()
