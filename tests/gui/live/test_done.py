"""Issue 10's end: six questions about robots that run, each answered within three clicks.

The robots are real processes over real sockets, and so are the examples' own modules and sensors;
no file of theirs is changed. The clicks are counted by the hand that makes them.
"""

from __future__ import annotations

import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from msgspec.structs import replace
from PySide6.QtCore import QPoint, QTimer
from tests.gui.live.test_link import connect
from tests.gui.live.test_why import FLOW, SCRIPT, Clicks, seen

from situ.blackboard.client import connect as operator

MOST = 3
MODULES = {"chase-face", "nod", "gaze-sound", "face-caller", "transfer"}
PUT_FORWARD = (str(Path(__file__).with_name("put_forward.py")),)
"""A robot that may be told that a minute has passed."""
OFTEN = 100
"""Milliseconds between two of these."""


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


@contextmanager
def alive(project: Path, endpoint: str) -> Iterator[Callable[[str], None]]:
    """The example's modules run, and its sensors: they perceive each line that is given."""
    programs = project / "modules"
    modules = subprocess.Popen([sys.executable, str(programs / "start_all.py"), endpoint])
    sensors = subprocess.Popen(
        [sys.executable, str(programs / "sensors.py"), endpoint],
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        text=True,
    )
    assert sensors.stdin is not None

    def perceive(line: str) -> None:
        assert sensors.stdin is not None
        sensors.stdin.write(line + "\n")
        sensors.stdin.flush()

    try:
        yield perceive
    finally:
        sensors.stdin.close()
        modules.send_signal(signal.SIGTERM)
        for process in (sensors, modules):
            process.wait(10)


def test_of_the_conversation(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    window = it.window
    link = connect(it, there.endpoint, until)
    panel, viewing = window.why.panel, window.robot.follower.viewing
    now = link.log.now
    until(link.moment_changed, lambda: "converse" in now.applications)
    with alive(there.project, there.endpoint) as perceive:
        until(link.moment_changed, lambda: now.connected >= MODULES)
        # Somebody touches YES.
        with operator(there.endpoint, role="operator") as board:
            board.publish("clickYes")
        until(link.moment_changed, lambda: now.applications["converse"].state == "2")
        show(it)

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
        perceive("slap 40")
        until(link.moment_changed, lambda: now.robot.get("head") == {"yaw": 40, "pitch": 0})
        show(it)
        with Carer(it) as carer:
            carer.panel("authority")
            carer.row_menu(window.robot.authority, "head")
            carer.choose(window.why.menus.shown, "Why did head move?")
        assert "gaze-sound moves head" in panel.title.text()
        assert seen(it)[0].startswith("you set sound.slap to 40")
        assert any(words.startswith("situation sound") for words in seen(it))
        assert any("sound.slap 40" in link.values for link in panel.links)

        # Why does the nod module not nod, though what was said can be accepted?
        perceive("call -60")
        until(link.moment_changed, lambda: now.situation == "called")
        perceive("say yes")
        until(link.moment_changed, lambda: "nod" in now.asking)
        until(link.moment_changed, lambda: "nod" not in now.asking)
        window.views[FLOW].current_view().setFocus()
        canvas_of(it, SCRIPT)
        show(it)
        with Carer(it) as carer:
            carer.tab(SCRIPT)
            carer.card_menu(window.views[SCRIPT].canvas, "module", "nod")
            carer.choose(window.context_menus.shown, "Why not?")
        until(window.why._asking.answered, lambda: panel.title.text().startswith("Why does nod"))
        assert panel.title.text() == "Why does nod not hold head?"
        asked, stood = seen(it)
        assert asked.startswith("nod asked for head from ")
        assert "nod has no priority in situation called" in stood

        # What was on the blackboard when it stopped?
        perceive("face 12")
        perceive("stop")
        until(link.moment_changed, lambda: now.applications["converse"].suspended)
        perceive("face 50")
        until(link.moment_changed, lambda: now.board["face.direction"].value == 50)
        window.open_file(FLOW)
        window.select(())
        show(it)
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
    window.robot.disconnect_robot()


def test_of_the_reception(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("reception"), program=PUT_FORWARD)
    it = studio(there.project)
    window = it.window
    link = connect(it, there.endpoint, until)
    until(link.documents_came, lambda: window.robot.follower.same is True)
    now = link.log.now

    def gave_up() -> int:
        taken = now.applications["reception"].crossed
        return sum(n for (source, _, _, timeout), n in taken.items() if timeout and source == "2")

    # What it says must end first, then comes the minute in which nobody does anything.
    minutes = QTimer()
    minutes.setInterval(OFTEN)
    minutes.timeout.connect(lambda: there.process.send_signal(signal.SIGUSR1))
    with operator(there.endpoint, role="operator") as board:
        for times in (1, 2):
            # Somebody touches the screen, and goes away.
            board.publish("screenTouched")
            until(link.moment_changed, lambda: now.applications["reception"].state == "2")
            minutes.start()
            until(link.moment_changed, lambda times=times: gave_up() == times)
            minutes.stop()
    # How often did people give up in this state?
    show(it)
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
    assert any("timeout 60 → 30 s" in words for words in told), told
    window.deploying.dialog.close()
    window.robot.disconnect_robot()


def show(it: Any) -> None:
    """What has come is drawn now, not in a little while."""
    it.window.robot.follower.refresh()
    it.settle()


def canvas_of(it: Any, file: str) -> None:
    """The tab has been looked at before, as a person's would."""
    current = it.window.current_file
    it.window.open_file(file)
    it.settle()
    it.window.open_file(current)
    it.settle()
