"""Why not? tells what stood in the way at the cursor, within three clicks, by mouse and by keys."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QObject, Qt
from tests.gui.live.test_link import connect
from tests.gui.live.test_log import played
from tests.gui.live.test_why import FLOW, SCRIPT, Clicks, replayed, seen

import situ
from situ_studio.live.by_clock import by_clock
from situ_studio.live.log import TraceLog
from situ_studio.live.viewing import Viewing
from situ_studio.live.why_not import Question, answered, events_until, wanted_at
from situ_studio.live.why_not_asking import AskingWhyNot

SHIFT = Qt.KeyboardModifier.ShiftModifier
HEAD = {"kind": "authority", "to": "nod", "resource": "head"}
ASKED: tuple[dict[str, Any], ...] = (
    HEAD,
    {"kind": "authority", "to": "chase-face", "resource": "head"},
    {"kind": "authority", "to": "transfer", "resource": "base"},
    {"kind": "situation", "to": "invited"},
    {"kind": "situation", "to": "sound"},
    {"kind": "enter", "application": "converse", "state": "5"},
)

__all__ = ["replayed"]


@pytest.mark.parametrize("wanted", ASKED, ids=lambda one: f"{one['kind']} {one.get('to', '')}")
def test_the_last_events_and_what_was_before_them_give_the_whole_answer(
    wanted: dict[str, Any],
) -> None:
    project, _, events = played("conversation", "fig5.jsonl")
    log = TraceLog(block=7)
    log.add(events)
    for t in sorted({event["t"] for event in events})[2:]:
        whole = answered(Question(project, tuple(events[: log.count(t)]), wanted, t))
        few = answered(Question(project, events_until(log, t, 9), wanted, t))
        assert not isinstance(whole, str)
        assert not isinstance(few, str)
        assert (few.happened is None) == (whole.happened is None)
        assert [one.code for one in few.reasons] == [one.code for one in whole.reasons]


def test_every_place_that_can_be_asked_of_gets_an_answer() -> None:
    project, _, events = played("reception", "new-user.jsonl")
    log = TraceLog()
    log.add(events)
    t = events[len(events) // 2]["t"]
    kinds = set()
    for file, document in project.flows.items():
        for state in document.states:
            inner: list[tuple[str, ...]] = [("event", str(n)) for n, _ in enumerate(state.events)]
            inner += [("action", str(n)) for n, _ in enumerate(state.actions)]
            inner += [("timeout",)] if state.timeout is not None else []
            for place in ((), *inner):
                where = ("state", state.no, *place)
                wanted = wanted_at(project, file, document, where, log.at(t))
                assert wanted is not None
                kinds.add(wanted["kind"])
                answer = answered(Question(project, events_until(log, t), wanted, t))
                assert not isinstance(answer, str), (where, answer)
                assert answer.reasons or answer.happened
    assert {"enter", "transition", "action"} <= kinds


def test_what_kept_a_module_a_situation_and_a_state(replayed: Any) -> None:
    it, events = replayed()
    window = it.window
    panel, viewing = window.why.panel, window.robot.follower.viewing
    slap = next(e for e in events if e["kind"] == "situation" and e["to"] == "sound")
    viewing.seek(slap["t"])
    window.open_file(SCRIPT)
    it.settle()
    # Why does the nod module not nod?
    hand = Clicks(it)
    hand.card_menu(window.views[SCRIPT].canvas, "module", "nod")
    hand.choose(window.context_menus.shown, "Why not?")
    assert hand.count == 2
    assert panel.title.text() == "Why does nod not hold head?"
    assert panel.more.text() == f"at {viewing.written(slap['t'])}"
    (gave,) = [e for e in events if e["kind"] == "abandon" and e["module"] == "nod"]
    (asked,) = [e for e in events if e["kind"] == "acquire" and e["module"] == "nod"]
    began, ended = viewing.written(asked["t"]), viewing.written(gave["t"])
    assert seen(it)[0].startswith(f"nod asked for head from {began} to {ended} in vain")
    # The third click goes to the moment of it.
    it.click_row(panel.table, panel.table.rows.index(0, 1))
    assert viewing.t == gave["t"]
    assert window.current_view.selected == (("module", "nod"),)
    # Of somebody else it was the priority, asked of a row.
    invited = next(e for e in events if e["kind"] == "situation" and e["to"] == "invited")
    viewing.seek(invited["t"])
    window.bottom.choose("authority")
    it.settle()
    hand = Clicks(it)
    hand.row_menu(window.robot.authority, "head")
    hand.choose(window.why.menus.shown, "Why not chase-face?")
    assert hand.count == 2
    assert "no priority" in seen(it)[0]
    # By keys: the situation with the values of its condition, the state with what did not come.
    window.open_file(SCRIPT)
    it.select("situation", "stopped")
    window.views[SCRIPT].current_view().setFocus()
    it.key(Qt.Key.Key_F7, SHIFT)
    assert panel.title.text() == "Why is stopped not the situation?"
    assert "robot.stop" in panel.links[0].values
    window.open_file(FLOW)
    it.select("state", "2")
    window.views[FLOW].current_view().setFocus()
    it.key(Qt.Key.Key_F7, SHIFT)
    assert panel.title.text().startswith("Why is converse not in 2")
    assert panel.links
    # What did happen at this moment is answered with its chain.
    window.open_file(SCRIPT)
    it.select("situation", "invited")
    window.views[SCRIPT].current_view().setFocus()
    it.key(Qt.Key.Key_F7, SHIFT)
    assert seen(it)[-1].startswith("situation invited")
    # What is neither happens nor does not.
    it.select("data", "robot.stop")
    window.views[SCRIPT].current_view().setFocus()
    before = seen(it)
    it.key(Qt.Key.Key_F7, SHIFT)
    assert seen(it) == before


def test_a_long_trace_of_a_running_robot_is_asked_beside_the_window(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    window = it.window
    link = connect(it, there.endpoint, until)
    side = window.why
    side._asking._at_once = 0
    with (
        situ.connect(there.endpoint, module="nod", resources=["head"]) as board,
        board.authority("head"),
    ):
        until(link.moment_changed, lambda: "nod" in link.log.now.asking)
        window.open_file(SCRIPT)
        it.settle()
        hand = Clicks(it)
        hand.card_menu(window.views[SCRIPT].canvas, "module", "nod")
        hand.choose(window.context_menus.shown, "Why not?")
        assert hand.count == 2
        until(side._asking.answered, lambda: bool(side.panel.links))
        assert seen(it) == ["nod has no priority in situation conversation"]
    # Where the robot is already: the state by its name, the moment by the clock of all the others.
    now = link.log.now.applications["converse"]
    window.open_file(FLOW)
    it.select("state", now.state)
    window.views[FLOW].current_view().setFocus()
    it.key(Qt.Key.Key_F7, SHIFT)
    until(side._asking.answered, lambda: "already" in " ".join(seen(it)))
    state = window.robot.state_name("converse", now.state)
    assert state != now.state
    (link_,) = side.panel.links
    assert link_.words == f"converse was in {state} already, since {link_.at}"
    assert link_.at == window.robot.follower.viewing.written(now.since)
    it.window.robot.disconnect_robot()


def test_moments_in_a_sentence_are_written_by_the_clock_but_not_what_a_person_wrote() -> None:
    log = TraceLog()
    log.add(
        [
            {
                "kind": "data",
                "seq": 1,
                "t": 0.0,
                "cause": None,
                "tag": "a",
                "value": 1,
                "writer": "a",
                "time": "2026-03-02T10:00:00+00:00",
            }
        ]
    )
    viewing = Viewing(log)
    text = "heard at 2.5 s as “open at 5 s”; its timeout of 10 s, since 3 s: not at 4 seconds"
    first, second = viewing.written(2.5), viewing.written(3)
    assert first.endswith(":02.500")
    assert by_clock(text, viewing) == (
        f"heard at {first} as “open at 5 s”; its timeout of 10 s, since {second}: not at 4 seconds"
    )
    # Without a clock they are seconds of the trace, as the runtime wrote them.
    assert by_clock(text, Viewing(TraceLog())) == text


def test_a_process_that_ends_without_an_answer_is_told(qt: Any, until: Any) -> None:
    project, _, events = played("conversation", "fig5.jsonl")
    owner = QObject()
    asking = AskingWhyNot(owner, 0, (sys.executable, "-c", "raise SystemExit(3)"))
    gone: list[bool] = []
    asking.gone.connect(lambda: gone.append(True))
    asking.ask(Question(project, tuple(events), HEAD, 5.0))
    until(asking.gone, lambda: bool(gone))
