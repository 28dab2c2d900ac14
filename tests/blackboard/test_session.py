"""Sessions and leases round a robot, time and messages by hand (docs/protocol.md)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import msgspec
import pytest

from situ.blackboard import notices, requests, session
from situ.decide.effects import Begin, Map


def traced(hand: Any, since: int = 1) -> list[dict[str, Any]]:
    """The trace from a seq on, as the peer ``looker`` gets it, page by page."""
    found: list[dict[str, Any]] = []
    page = hand.ask("looker", "trace", since=since)
    while page["events"]:
        found += page["events"]
        page = hand.ask("looker", "trace", since=page["next"])
    return found


def test_a_module_is_lost_when_its_lease_ends(hand: Any) -> None:
    hand.hello("looker", role="viewer")
    hand.at(0.5).hello("chase", resources=["head"])
    hand.ask("chase", "acquire", resources=["head"])
    hand.at(0.9).ask("looker", "heartbeat")
    hand.at(1.499999).ask("looker", "heartbeat")
    assert hand.ask("chase", "heartbeat")["holds"] == ["head"]
    hand.at(2.4).ask("looker", "heartbeat")
    hand.at(2.5)
    lost = [event for event in traced(hand) if event["kind"] == "lost"]
    assert [(event["module"], event["t"]) for event in lost] == [("chase", 2.499999)]


@pytest.mark.parametrize("role", ["viewer", "operator"])
def test_who_holds_nothing_of_the_robot_s_is_believed_for_ten_seconds(hand: Any, role: str) -> None:
    assert hand.hello("desk", role=role)["lease"] == 10.0
    assert hand.at(9.9).ask("desk", "heartbeat")["re"] == "alive"
    # A module that comes meanwhile is lost after its own second all the same.
    assert hand.at(12.0).hello("nod")["lease"] == 1.0
    hand.at(12.9)
    assert hand.core.modules
    hand.at(13.0)
    assert not hand.core.modules
    hand.at(19.8)
    assert hand.sessions.clients == 1
    hand.at(19.9)
    assert hand.sessions.clients == 0
    assert hand.ask("desk", "heartbeat")["code"] == "session"


def test_every_request_keeps_the_lease(hand: Any) -> None:
    hand.hello("nod")
    for tenths in range(5, 50, 5):
        assert hand.at(tenths / 10).ask("nod", "get", names=["x"])["re"] == "values"


def test_a_core_that_stood_still_hears_what_was_said_meanwhile_first(hand: Any) -> None:
    hand.hello("nod", resources=["head"])
    # Its process was stopped, or its machine busy: nothing was received, nothing done.
    hand.now = 5_000_000
    hand.sessions.advance(hand.now)
    assert hand.ask("nod", "heartbeat")["re"] == "alive"
    # Who says nothing then either is lost, a moment later.
    hand.at(5.9)
    hand.now = 9_000_000
    hand.sessions.advance(hand.now)
    hand.at(9.24)
    assert hand.core.modules
    hand.at(9.25)
    assert not hand.core.modules


def test_hand_over_happens_in_the_step_in_which_the_holder_is_lost(hand: Any) -> None:
    hand.hello("looker", role="viewer")
    hand.hello("chase", resources=["head"])
    hand.hello("carry", resources=["base", "head"])
    hand.ask("chase", "acquire", resources=["head"])
    assert hand.ask("carry", "acquire", resources=["base", "head"])["holds"] == []
    hand.at(0.9).ask("carry", "heartbeat")
    hand.ask("looker", "heartbeat")
    hand.heard()
    hand.at(1.0)
    passed = [n for n in hand.heard() if isinstance(n, notices.Authority)]
    assert [(n.resource, n.source, n.to) for n in passed] == [
        ("base", None, "carry"),
        ("head", "chase", "carry"),
    ]
    assert hand.ask("carry", "heartbeat")["holds"] == ["base", "head"]
    moments = {e["t"] for e in traced(hand) if e["kind"] in ("lost", "authority") and e["t"] > 0.5}
    assert moments == {1.0}


def test_the_name_of_a_lost_module_is_free_again(hand: Any) -> None:
    hand.hello("nod")
    assert hand.at(0.9).ask("other", "hello", version=1, module="nod")["code"] == "name"
    assert hand.at(1.0).ask("other", "hello", version=1, module="nod")["re"] == "welcome"


def test_a_client_that_was_cut_off_takes_its_session_up_again(hand: Any) -> None:
    session = hand.hello("nod", resources=["head"])["session"]
    hand.ask("nod", "watch", patterns=["face.*"])
    hand.ask("nod", "acquire", resources=["head"])
    hand.at(0.8)
    again = hand.ask("nod-2", "hello", version=1, module="nod", session=session)
    assert (again["re"], again["resumed"], again["session"]) == ("welcome", True, session)
    hand.at(1.5)
    assert list(hand.ask("nod-2", "heartbeat")["changes"]) == ["face.*"]
    assert hand.ask("nod", "heartbeat")["code"] == "session"


def test_a_session_that_has_ended_is_not_taken_up_again(hand: Any) -> None:
    session = hand.hello("nod")["session"]
    hand.at(1.0)
    again = hand.ask("nod-2", "hello", version=1, module="nod", session=session)
    assert again["resumed"] is False
    assert again["session"] != session


def test_a_greeting_said_twice_does_no_harm(hand: Any) -> None:
    first = hand.hello("nod")
    again = hand.ask("nod", "hello", version=1, module="nod")
    assert (again["session"], again["resumed"]) == (first["session"], True)


def test_connections_are_traced_and_modules_count_as_present(hand: Any) -> None:
    hand.hello("looker", role="viewer")
    hand.hello("chase", resources=["head"])
    hand.ask("chase", "acquire", resources=["head"])
    kinds = [(e["kind"], e.get("module"), e.get("message")) for e in traced(hand)]
    assert ("connected", "chase", None) in kinds
    # chase requires eyes, who are not there.
    assert ("warning", None, "chase needs eyes, which is absent") in kinds


def test_who_watches_gets_a_snapshot_then_every_change_numbered(hand: Any) -> None:
    hand.hello("looker", role="viewer")
    hand.hello("eyes")
    hand.ask("eyes", "set", tags={"face.direction": 1, "face.gone": 1})
    hand.ask("eyes", "set", tags={"face.gone": None})
    assert hand.changes() == []
    snapshot = hand.ask("looker", "watch", patterns=["face.*"])
    assert [(tag, e["value"], e["version"]) for tag, e in snapshot["entries"].items()] == [
        ("face.direction", 1, 1),
        ("face.gone", None, 2),
    ]
    hand.ask("eyes", "set", tags={"face.direction": 2, "other": 1})
    hand.ask("eyes", "set", tags={"face.direction": 2, "face.gone": 5})
    heard = [n for n in hand.heard() if isinstance(n, notices.Change)]
    assert [(n.tag, n.value, n.version) for n in heard] == [
        ("face.direction", 2, 2),
        ("face.direction", 2, 3),
        ("face.gone", 5, 3),
    ]
    counted = hand.ask("looker", "heartbeat")["changes"]["face.*"]
    assert counted - snapshot["changes"]["face.*"] == len(heard)


def test_nothing_is_noticed_for_who_no_longer_watches(hand: Any) -> None:
    hand.hello("looker", role="viewer")
    hand.hello("eyes")
    hand.ask("looker", "watch", patterns=["face.*", "x"])
    hand.ask("looker", "unwatch", patterns=["face.*"])
    hand.ask("eyes", "set", tags={"face.direction": 2, "x": 1})
    assert hand.changes() == [("x", 1, 1)]
    # Nor for who is taken for dead.
    hand.at(10.5).hello("nose")
    hand.ask("nose", "set", tags={"x": 2})
    assert hand.changes() == []


def test_what_the_runtime_keeps_can_be_watched_and_a_deletion_is_a_change(hand: Any) -> None:
    hand.hello("looker", role="viewer")
    hand.hello("chase", resources=["head"])
    hand.ask("looker", "watch", patterns=["robot/head", "situation", "application/**"])
    hand.ask("chase", "acquire", resources=["head"])
    hand.ask("chase", "command", resource="head", value={"yaw": 5}, **{"for": 0.5})
    assert hand.changes() == [("robot/head", {"yaw": 5}, 1)]
    hand.at(0.6)
    assert hand.changes() == [("robot/head", None, 2)]
    hand.ask("chase", "set", tags={"person.calling": True})
    assert [tag for tag, _, _ in hand.changes()] == ["situation"]
    hand.ask("chase", "publish", event="go")
    assert [tag for tag, _, _ in hand.changes()] == ["application/desk"]


def test_the_trace_is_given_from_any_seq_and_goes_on_without_a_gap(hand: Any) -> None:
    hand.hello("looker", role="viewer")
    hand.hello("eyes")
    for count in range(600):
        hand.ask("eyes", "set", tags={"x": count})
    backlog = traced(hand)
    assert [event["seq"] for event in backlog] == list(range(1, backlog[-1]["seq"] + 1))
    hand.heard()
    hand.at(0.5).ask("eyes", "set", tags={"x": -1, "y": -1})
    (events,) = [n for n in hand.heard() if isinstance(n, notices.Events)]
    live = [msgspec.json.decode(line) for line in events.events]
    last = backlog[-1]["seq"]
    assert [(e["seq"], e["tag"]) for e in live] == [(last + 1, "x"), (last + 2, "y")]
    assert live[0]["time"] == "2026-01-02T03:04:05.500000Z"
    assert traced(hand, since=last + 1) == live
    assert hand.ask("looker", "heartbeat")["seq"] == last + 2


def test_a_trace_that_is_too_old_begins_with_the_oldest_kept(
    make_hand: Callable[..., Any],
) -> None:
    hand = make_hand(keep=10)
    hand.hello("looker", role="viewer")
    hand.hello("eyes")
    for count in range(50):
        hand.ask("eyes", "set", tags={"x": count})
    page = hand.ask("looker", "trace", since=1)
    assert page["first"] == page["last"] - 9 == page["events"][0]["seq"]


def test_nobody_who_did_not_ask_gets_the_trace(hand: Any) -> None:
    hand.hello("eyes")
    hand.ask("eyes", "set", tags={"x": 1})
    assert not [n for n in hand.heard() if isinstance(n, notices.Events)]


def test_effects_go_to_who_carries_them_out_and_a_message_to_who_listens(hand: Any) -> None:
    hand.hello("eyes")
    hand.effects.clear()
    hand.ask("eyes", "publish", event="go")
    (message,) = [n for n in hand.heard() if isinstance(n, notices.Message)]
    assert (message.topic, message.value, message.application) == (
        "desk/busy",
        {"user": "Ann"},
        "desk",
    )
    assert [e.resource for e in hand.effects if isinstance(e, Map)] == ["screen"]
    service = next(e for e in hand.effects if isinstance(e, Begin) and e.action == "service")
    hand.ask("eyes", "finish", action_id=service.id, result=[1])
    assert (
        hand.ask("eyes", "get", names=["application/desk"])["entries"]["application/desk"]["value"][
            "state"
        ]
        == "1"
    )


def test_people_use_the_screen_over_the_blackboard(hand: Any) -> None:
    hand.hello("page", role="operator", user="ann")
    hand.ask("page", "watch", patterns=["application/desk"])
    assert hand.ask("page", "touch")["re"] == "done"
    assert hand.ask("page", "use", component="go")["re"] == "done"
    ((_, value, _),) = hand.changes()
    assert value["state"] == "2"


def test_writers_are_named_as_in_the_trace(hand: Any) -> None:
    hand.hello("looker", role="viewer")
    hand.hello("ann", role="operator", user="ann")
    hand.ask("ann", "set", tags={"x": 1})
    hand.hello("nod")
    hand.ask("nod", "set", tags={"y": 1})
    written = {e["tag"]: e["writer"] for e in traced(hand) if e["kind"] == "data"}
    assert written == {"user.name": "project", "x": "operator:ann", "y": "nod"}


def test_what_falls_due_is_done_before_a_request(hand: Any) -> None:
    hand.hello("looker", role="viewer")
    hand.hello("eyes")
    hand.ask("eyes", "publish", event="go")
    # No call of ``at``: the timeout of 5 s is found by the request itself.
    hand.now = 6_000_000
    hand.ask("eyes", "heartbeat")
    hand.hello("looker-2", role="viewer")
    value = hand.ask("looker-2", "get", names=["application/desk"])["entries"]
    assert value["application/desk"]["value"]["state"] == "1"


def test_modules_and_what_is_wanted_are_listed(hand: Any) -> None:
    hand.hello("looker", role="viewer")
    hand.hello("chase", resources=["head"])
    hand.hello("guest", description="New.", provides=[{"data": "guest.here"}])
    told = hand.ask("looker", "modules")
    states = {one["name"]: one for one in told["modules"]}
    assert list(states) == ["carry", "chase", "desk", "eyes", "guest", "nod"]
    assert [n for n, one in states.items() if one["present"]] == ["chase", "desk", "guest"]
    assert states["desk"]["application"]
    assert states["desk"]["holds"] == ["screen"]
    assert not states["guest"]["declared"]
    assert states["chase"]["requires"] == [{"data": "face.direction"}, {"module": "eyes"}]
    wanted = [(one["data"], one["module"], one["by"]) for one in told["wanted"]]
    assert wanted == [
        ("camera.left", None, ["eyes"]),
        ("face.direction", None, ["chase"]),
        (None, "eyes", ["chase"]),
    ]
    hand.hello("eyes")
    hand.ask("eyes", "disclose", requires=[], provides=[{"data": "face.direction"}])
    hand.ask("guest", "set", tags={"camera.left": "http://127.0.0.1/left"})
    assert hand.ask("looker", "modules")["wanted"] == []


def test_only_a_scenario_tells_the_time_and_plays_modules(make_hand: Callable[..., Any]) -> None:
    hand = make_hand(scripted=True)
    hand.hello("looker", role="viewer")
    hand.hello("play", role="scenario")
    hand.hello("eyes")
    hand.ask("play", "acquire", at=2_000_000, module="chase", resources=["head"])
    hand.ask("play", "command", at=2_000_000, module="chase", resource="head", value=1)
    hand.ask("play", "publish", at=3_000_000, event="go")
    assert hand.ask("play", "heartbeat", at=9_000_000)["time"] == 9_000_000
    hand.ask("play", "bye", at=9_500_000, module="chase")
    assert hand.ask("play", "set", at=9_400_000, tags={"x": 1})["code"] == "clock"
    assert hand.ask("eyes", "set", at=9_600_000, tags={"x": 1})["code"] == "clock"
    # What others do counts at the time to which the scenario has come.
    hand.ask("eyes", "set", tags={"y": 1})
    events = [(e["t"], e["kind"]) for e in traced(hand)]
    assert (2.0, "acquire") in events
    assert (8.0, "transition") in events
    assert (9.5, "lost") in events
    assert (9.5, "data") in events
    assert not any(kind == "warning" for _, kind in events)


def test_leases_run_by_the_clock_though_the_scenario_has_its_own_time(
    make_hand: Callable[..., Any],
) -> None:
    hand = make_hand(scripted=True)
    hand.hello("play", role="scenario")
    hand.ask("play", "heartbeat", at=60_000_000)
    assert hand.at(0.9).ask("play", "heartbeat")["time"] == 60_000_000
    assert hand.at(1.9).ask("play", "heartbeat")["code"] == "session"


def test_names_have_an_end(hand: Any) -> None:
    assert hand.hello("m" * 501)["code"] == "name"
    hand.hello("eyes")
    refused = hand.ask("eyes", "publish", event="e" * 501)
    assert refused["code"] == "invalid"
    assert len(refused["message"]) < 600
    assert hand.ask("eyes", "publish", event="e" * 500)["re"] == "done"


@pytest.mark.parametrize("do", ["set", "publish", "use", "touch", "finish", "acquire", "command"])
def test_a_viewer_changes_nothing(hand: Any, do: str) -> None:
    hand.hello("looker", role="viewer")
    every: dict[str, dict[str, Any]] = {
        "set": {"tags": {"x": 1}},
        "publish": {"event": "go"},
        "use": {"component": "go"},
        "acquire": {"resources": ["head"]},
        "command": {"resource": "head", "value": 1},
    }
    assert hand.ask("looker", do, **every.get(do, {}))["code"] == "role"
    assert [e["kind"] for e in traced(hand) if e["t"] > 0] == []


def test_an_operator_debugs_and_the_trace_tells_who(hand: Any) -> None:
    hand.hello("looker", role="viewer")
    hand.hello("desk", role="operator", user="ann")
    hand.hello("eyes")
    hand.ask("desk", "break", application="desk", state="2")
    hand.ask("eyes", "publish", event="go")
    names = ["debugger.breakpoints", "debugger.paused", "application/desk"]
    found = hand.ask("desk", "get", names=names)["entries"]
    (breakpoint,) = found["debugger.breakpoints"]["value"]
    assert (breakpoint["id"], breakpoint["state"]) == (1, "2")
    assert found["debugger.paused"]["value"] == {"desk": 1}
    for do in ("unbreak", "resume", "pause"):
        assert hand.ask("desk", do)["re"] == "done"
    hand.ask("desk", "goto", application="desk", state="1")
    assert hand.ask("desk", "goto", application="desk", state="9")["code"] == "refused"
    told = [(e["kind"], e.get("writer")) for e in traced(hand) if "writer" in e]
    assert told[-4:] == [
        ("data", "operator:ann"),
        ("resumed", "operator:ann"),
        ("paused", "operator:ann"),
        ("transition", "operator:ann"),
    ]


@pytest.mark.parametrize("do", ["break", "unbreak", "pause", "resume", "step", "goto"])
def test_only_an_operator_debugs(hand: Any, do: str) -> None:
    hand.hello("eyes")
    fields = {"state": "1"} if do in ("break", "goto") else {}
    assert hand.ask("eyes", do, **fields)["code"] == "role"


def test_what_an_operator_who_is_lost_paused_stays_paused(hand: Any) -> None:
    hand.hello("desk", role="operator", user="ann")
    hand.ask("desk", "pause")
    hand.at(60.0).hello("eyes")
    hand.ask("eyes", "publish", event="go")
    entries = hand.ask("eyes", "get", names=["debugger.paused", "application/desk.state"])[
        "entries"
    ]
    assert entries["debugger.paused"]["value"] == {"desk": None}
    assert entries["application/desk.state"]["value"] == "1"


def test_a_fault_of_ours_leaves_nobody_waiting(hand: Any, monkeypatch: Any) -> None:
    hand.hello("nod")
    monkeypatch.setattr(hand.core, "step", lambda given: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        hand.sessions.receive("nod", b'{"do":"set","id":7,"tags":{"x":1}}', hand.now)
    ((peer, body),) = hand.sessions.take().replies
    assert peer == "nod"
    assert msgspec.json.decode(body)["id"] == 7
    assert "please report it" in msgspec.json.decode(body)["message"]


# -- limits ------------------------------------------------------------------


def test_too_many_sessions_are_refused_and_an_ended_one_makes_room(
    hand: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(session, "MOST", 3)
    for number in range(3):
        assert hand.hello(f"v{number}", role="viewer")["re"] == "welcome"
    refused = hand.hello("v3", role="viewer")
    assert (refused["code"], "3 clients" in refused["message"]) == ("limit", True)
    # Who has a session already may say hello as often as he likes.
    assert hand.hello("v0", role="viewer")["resumed"]
    hand.ask("v1", "bye")
    assert hand.hello("v3", role="viewer")["re"] == "welcome"


def test_too_many_patterns_are_refused_and_none_of_them_is_watched(
    hand: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(requests, "PATTERNS", 3)
    hand.hello("v", role="viewer")
    hand.ask("v", "watch", patterns=["a", "b"])
    assert hand.ask("v", "watch", patterns=["c", "d"])["code"] == "limit"
    assert hand.ask("v", "watch", patterns=["a", "b", "c", "c"])["re"] == "snapshot"
    assert set(hand.ask("v", "heartbeat")["changes"]) == {"a", "b", "c"}
    hand.ask("v", "unwatch", patterns=["a"])
    assert hand.ask("v", "watch", patterns=["d"])["re"] == "snapshot"


def test_too_many_tags_are_refused_and_those_that_are_there_may_change(
    hand: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    hand.hello("nod")
    hand.ask("nod", "set", tags={"a": 1})
    monkeypatch.setattr(requests, "TAGS", len(hand.core.board.state) + 1)
    assert hand.ask("nod", "set", tags={"a": 2, "b": 1, "c": 1})["code"] == "limit"
    assert hand.ask("nod", "get", names=["a"])["entries"]["a"]["value"] == 1
    assert hand.ask("nod", "set", tags={"a": 2, "b": 1})["re"] == "written"
    assert hand.ask("nod", "set", tags={"c": 1})["code"] == "limit"
    assert hand.ask("nod", "set", tags={"a": 3, "b": None})["re"] == "written"
    # A deleted one counts on: so do its versions.
    assert hand.ask("nod", "set", tags={"c": 1})["code"] == "limit"
