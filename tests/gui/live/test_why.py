"""Why? is answered within three clicks, from anything, by mouse and by keys."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu
from tests.gui.live.test_link import connect
from tests.gui.live.test_log import played
from tests.gui.live.test_recordings import opened

import situ
from situ.rehearse.why import chain
from situ_studio.live.log import TraceLog
from situ_studio.live.why import Thing, latest, trail

LEFT, RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton
SLAP = {"yaw": 40, "pitch": 0}
SCRIPT, FLOW = "conversation.spds.xml", "converse.rbd.xml"


class Clicks:
    """A person who counts what they press."""

    def __init__(self, it: Any) -> None:
        self.it = it
        self.count = 0

    def menu(self, widget: Any, at: QPoint) -> None:
        QTest.mouseClick(widget, RIGHT, pos=at)
        event = QContextMenuEvent(QContextMenuEvent.Reason.Mouse, at, widget.mapToGlobal(at))
        QApplication.sendEvent(widget, event)
        self.count += 1
        self.it.settle()

    def row_menu(self, table: Any, key: str) -> None:
        row = next(n for n, one in enumerate(table.rows.rows) if one.key == key)
        index = table.rows.index(row, 1)
        table.scrollTo(index)
        self.menu(table.viewport(), table.visualRect(index).center())

    def choose(self, menu: QMenu, words: str) -> None:
        action = next(a for a in menu.actions() if a.text() == words)
        QTest.mouseClick(menu, LEFT, pos=menu.actionGeometry(action).center())
        self.count += 1
        self.it.settle()

    def card_menu(self, canvas: Any, *place: str) -> None:
        canvas.zoom_to_fit()
        self.it.settle()
        middle = canvas.card_area(canvas._find(place)[0]).center()
        self.menu(canvas.viewer.viewport(), canvas.viewer.mapFromScene(middle))


def seen(it: Any) -> list[str]:
    return [link.words for link in it.window.why.panel.links]


@pytest.fixture
def replayed(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> Callable[[], tuple[Any, list[dict[str, Any]]]]:
    """A window in which a run of the conversation is looked at."""

    def start() -> tuple[Any, list[dict[str, Any]]]:
        where, file = project("conversation"), tmp_path / "run.mcap"
        return opened(studio, where, file, "conversation", "fig5.jsonl")

    return start


def found(log: TraceLog, project: Any, thing: Thing, t: float) -> Any:
    place = [one for one in latest(log, project, thing, t) if one is not None]
    return log[place[0]] if place else None


# -- the laws -----------------------------------------------------------------------------


def test_every_event_hangs_on_its_causes_and_on_what_gave_the_resource() -> None:
    _, _, events = played("conversation", "fig5.jsonl")
    log = TraceLog(block=7)
    log.add(events)
    by_seq = {event["seq"]: event for event in events}
    for place, event in enumerate(events):
        assert log.place(event["seq"]) == place
        seqs = [log[one]["seq"] for one in trail(log, place)]
        assert seqs == sorted(seqs)
        assert seqs[-1] == event["seq"]
        assert {one["seq"] for one in chain(events, event["seq"])} <= set(seqs)
        if event["kind"] == "mapping" and event["cause"] is None and event["value"]:
            gave = [e for e in map(by_seq.get, seqs) if e and e["kind"] == "authority"]
            assert (gave[-1]["to"], gave[-1]["resource"]) == (event["module"], event["resource"])
            assert any(by_seq[seq]["kind"] == "situation" for seq in seqs)


def test_events_are_found_by_seq_where_some_are_missing() -> None:
    _, _, events = played("conversation", "fig5.jsonl")
    log = TraceLog(block=7)
    log.add(events[3::3])
    kept = {event["seq"]: place for place, event in enumerate(log)}
    for event in events:
        assert log.place(event["seq"]) == kept.get(event["seq"])


@pytest.mark.parametrize(
    ("thing", "fits"),
    [
        (Thing("tag", "sound.slap"), lambda e: (e["kind"], e.get("tag")) == ("data", "sound.slap")),
        (
            Thing("held", "head"),
            lambda e: (e["kind"], e.get("resource")) == ("authority", "head"),
        ),
        (
            Thing("resource", "head"),
            lambda e: (e["kind"], e.get("resource")) == ("mapping", "head") and e["value"],
        ),
        (
            Thing("module", "nod"),
            lambda e: (
                (e["kind"] == "mapping" and e["module"] == "nod" and e["value"])
                or (e["kind"] == "authority" and e["to"] == "nod")
            ),
        ),
        (
            Thing("situation", "sound"),
            lambda e: (e["kind"], e.get("to")) == ("situation", "sound"),
        ),
        (
            Thing("condition", "sound"),
            lambda e: (e["kind"], e.get("situation")) == ("condition", "sound"),
        ),
        (
            Thing("application", "converse"),
            lambda e: (e["kind"], e.get("application")) == ("enter", "converse"),
        ),
        (
            Thing("state", "3", FLOW),
            lambda e: (e["kind"], e.get("state")) == ("enter", "3"),
        ),
        (
            Thing("transition", "clickYes", FLOW, "1"),
            lambda e: e["kind"] == "transition" and (e["from"], e["event"]) == ("1", "clickYes"),
        ),
    ],
)
def test_what_is_asked_for_is_the_last_of_it_up_to_the_cursor(thing: Thing, fits: Any) -> None:
    project, _, events = played("conversation", "fig5.jsonl")
    log = TraceLog(block=7)
    log.add(events)
    times = sorted({event["t"] for event in events})
    answers = set()
    for t in times:
        expected = [event for event in events if event["t"] <= t and fits(event)]
        answer = found(log, project, thing, t)
        assert answer == (expected[-1] if expected else None)
        answers.add(None if answer is None else answer["seq"])
    assert len(answers) > 1, "it happens in the middle of the run"


def test_looking_ends_where_the_robot_is_started_again_meanwhile() -> None:
    project, _, events = played("conversation", "fig5.jsonl")
    log = TraceLog()
    many = [{**event, "seq": n, "t": n / 100} for n, event in enumerate(events * 20, 1)]
    log.add(many)
    looking = latest(log, project, Thing("transition", "nothing", FLOW, "1"), many[-1]["t"])
    assert next(looking) is None
    log.clear()
    log.add(events[:5])
    assert list(looking) == []


def test_a_state_with_a_part_was_entered_when_the_part_was_begun() -> None:
    project, _, events = played("reception", "new-user.jsonl")
    log = TraceLog()
    log.add(events)
    inside = [e for e in events if e["kind"] == "enter" and "/" in e["state"]]
    holder = inside[0]["state"].partition("/")[0]
    assert len(inside) > 1
    file = next(iter(project.applications))
    answer = found(log, project, Thing("state", holder, file), inside[-1]["t"])
    assert answer["seq"] == inside[0]["seq"]


# -- in the window ------------------------------------------------------------------------


def test_the_panels_rows_answer_in_two_clicks_and_a_third_goes_there(replayed: Any) -> None:
    it, events = replayed()
    window = it.window
    robot, panel = window.robot, window.why.panel
    viewing = robot.follower.viewing
    turned = next(e for e in events if e["kind"] == "mapping" and e["value"] == SLAP)
    viewing.seek(turned["t"])
    window.bottom.choose("authority")
    it.settle()
    # Why did the robot turn its head?
    hand = Clicks(it)
    hand.row_menu(robot.authority, "head")
    hand.choose(window.why.menus.shown, "Why did head move?")
    assert hand.count == 2
    assert panel.isVisible()
    assert "gaze-sound moves head" in panel.title.text()
    assert seen(it)[0] == "scenario sets sound.slap to 40 (from outside)"
    assert seen(it)[-1].startswith("gaze-sound moves head")
    assert any("situation sound" in words for words in seen(it))
    gave = next(link for link in panel.links if link.words.startswith("gaze-sound gets head"))
    assert gave.values == "gaze-sound has priority 60, chase-face has priority 20"
    # The third click: to the situation, its moment, its card.
    row = next(n for n, words in enumerate(seen(it)) if words.startswith("situation sound"))
    it.click_row(panel.table, panel.table.rows.index(row, 1))
    assert viewing.t == panel.links[row].t
    assert window.current_file == SCRIPT
    assert window.current_view.selected == (("situation", "sound"),)
    assert "sound.slap 40" in panel.links[row].values
    # What stood on the blackboard when it was stopped: three clicks from the trace.
    stopped = next(e for e in events if e["kind"] == "suspend")
    window.bottom.choose("trace")
    it.settle()
    hand = Clicks(it)
    hand.row_menu(robot.trace, str(stopped["seq"]))
    hand.choose(window.why.menus.shown, "Why?")
    assert hand.count == 2
    assert "hand.waving" in seen(it)[0]
    it.click_row(panel.table, panel.table.rows.index(len(panel.links) - 1, 1))
    assert viewing.t == stopped["t"]
    board = {one.key: one.cells for one in robot.blackboard.rows.rows}
    assert board["hand.waving"][1] == "true"
    # Who set a value, and why is somebody given a resource.
    window.bottom.choose("blackboard")
    it.settle()
    hand.row_menu(robot.blackboard, "person.calling")
    hand.choose(window.why.menus.shown, "Why?")
    assert seen(it) == ["scenario sets person.calling to true (from outside)"]
    window.bottom.choose("authority")
    it.settle()
    hand.row_menu(robot.authority, "base")
    hand.choose(window.why.menus.shown, "Why is base held so?")
    assert seen(it)[-1].startswith("transfer gets base")


def test_the_timeline_answers_of_the_moment_under_the_hand(replayed: Any) -> None:
    it, events = replayed()
    window = it.window
    viewing = window.robot.follower.viewing
    window.bottom.choose("timeline")
    it.settle()
    chart = window.robot.timeline.chart
    chart.show_all()
    it.settle()
    called = next(e for e in events if e["kind"] == "situation" and e["to"] == "called")
    spots = {(row.kind, row.name): int(top) + row.height // 2 for row, top in chart._tops()}
    x = int(chart.axis.x(called["t"] + 1)) + chart.viewport().width() - int(chart.axis.width)
    for row, words in (
        (("situation", ""), "situation called"),
        (("state", "converse"), "converse enters 5"),
        (("resource", "head"), "face-caller gets head"),
    ):
        window.bottom.choose("timeline")
        it.settle()
        hand = Clicks(it)
        hand.menu(chart.viewport(), QPoint(x, spots[row]))
        hand.choose(window.why.menus.shown, "Why?")
        assert hand.count == 2
        assert seen(it)[-1].startswith(words)
        assert called["t"] < viewing.t < called["t"] + 2
    window.bottom.choose("timeline")
    it.settle()
    before = window.why.menus.shown
    Clicks(it).menu(chart.viewport(), QPoint(x, 2))
    assert window.why.menus.shown is before


def test_cards_and_arrows_answer_by_menu_and_by_keys(replayed: Any) -> None:
    it, events = replayed()
    window = it.window
    panel = window.why.panel
    viewing = window.robot.follower.viewing
    entered = next(e for e in events if e["kind"] == "enter" and e["state"] == "3")
    viewing.seek(entered["t"])
    window.open_file(FLOW)
    it.settle()
    # Which state, since when, how did it get there: nothing is selected.
    window.select(())
    window.views[FLOW].current_view().setFocus()
    it.key(Qt.Key.Key_F7)
    assert seen(it)[-1] == "converse enters 3 glad"
    assert panel.title.text() == "converse enters 3 glad"
    assert panel.more.text().startswith(f"at {viewing.written(entered['t'])}")
    assert panel.table.hasFocus()
    assert panel.table.currentIndex().row() == len(panel.links) - 1
    # By keys to the first link, and there.
    for _ in panel.links:
        it.key(Qt.Key.Key_Up)
    it.key(Qt.Key.Key_Return)
    assert viewing.t == panel.links[0].t
    assert panel.table.hasFocus()
    # A card, in two clicks.
    viewing.seek(entered["t"])
    hand = Clicks(it)
    hand.card_menu(window.views[FLOW].canvas, "state", "1")
    hand.choose(window.context_menus.shown, "Why?")
    assert hand.count == 2
    assert seen(it)[-1].startswith("converse enters 1")
    # An arrow.
    it.select("state", "1", "event", "0")
    window.views[FLOW].current_view().setFocus()
    it.key(Qt.Key.Key_F7)
    assert "goes from 1" in seen(it)[-1]
    window.open_file(SCRIPT)
    for place, words in (
        (("module", "gaze-sound"), "gaze-sound moves head"),
        (("data", "sound.slap"), "scenario sets sound.slap"),
        (("situation", "sound"), "situation sound"),
        (("situation", "sound", "condition"), "the condition of situation sound holds"),
    ):
        it.select(*place)
        window.views[SCRIPT].current_view().setFocus()
        it.key(Qt.Key.Key_F7)
        assert seen(it)[-1].startswith(words)
    # What never was says so, and has no links.
    it.select("situation", "stopped")
    window.views[SCRIPT].current_view().setFocus()
    it.key(Qt.Key.Key_F7)
    assert seen(it) == []
    assert panel.title.text() == "It has not happened up to this moment."
    # Without a trace there is nothing to ask, and no panel.
    window.commands.close_recording()
    assert not window.actions_.actions["why"].isEnabled()
    assert not window.bottom.button("why").isVisible()


def test_a_running_robot_is_asked_while_it_goes_on(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    window = it.window
    link = connect(it, there.endpoint, until)
    with (
        situ.connect(there.endpoint, module="gaze-sound", resources=["head"]) as board,
        board.authority("head") as head,
    ):
        board.set("sound.slap", 40)
        head.command({"yaw": 40}, valid=5)
        until(link.moment_changed, lambda: link.log.now.robot.get("head") == {"yaw": 40})
        window.robot.follower.refresh()
        assert window.bottom.button("why").isVisible()
        window.bottom.choose("authority")
        it.settle()
        # Why did the robot turn its head?
        hand = Clicks(it)
        hand.row_menu(window.robot.authority, "head")
        hand.choose(window.why.menus.shown, "Why did head move?")
        assert hand.count == 2
        assert "gaze-sound sets sound.slap to 40 (from outside)" in seen(it)
        assert seen(it)[-1].startswith("gaze-sound moves head")
        # The same from the module's card, and which state it is in, and how it came there.
        window.open_file(SCRIPT)
        it.settle()
        hand = Clicks(it)
        hand.card_menu(window.views[SCRIPT].canvas, "module", "gaze-sound")
        hand.choose(window.context_menus.shown, "Why?")
        assert hand.count == 2
        assert seen(it)[-1].startswith("gaze-sound moves head")
        window.open_file(FLOW)
        it.settle()
        hand = Clicks(it)
        hand.card_menu(window.views[FLOW].canvas, "state", "1")
        hand.choose(window.context_menus.shown, "Why?")
        assert seen(it)[-1] == "converse enters 1 hello (the start)"
    # What was done from here, who sits here did.
    link.set(window, {"spo2": 97}, lambda why: None)
    until(link.moment_changed, lambda: "spo2" in link.log.now.board)
    window.robot.follower.refresh()
    window.bottom.choose("blackboard")
    it.settle()
    hand.row_menu(window.robot.blackboard, "spo2")
    hand.choose(window.why.menus.shown, "Why?")
    assert seen(it) == ["you set spo2 to 97 (from outside)"]
    # A link goes to its moment: the robot goes on, and the window stays there.
    assert window.robot.follower.viewing.follows
    it.click_row(window.why.panel.table, window.why.panel.table.rows.index(0, 1))
    assert not window.robot.follower.viewing.follows
    assert window.robot.follower.viewing.t == window.why.panel.links[0].t
    it.window.robot.disconnect_robot()
    assert not window.bottom.button("why").isVisible()
