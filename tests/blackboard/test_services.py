"""Services apart, at the core: who they are, what they are told, what they may answer."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from situ.blackboard import notices, replies, wire
from situ.blackboard.backlog import Backlog
from situ.blackboard.core import Core
from situ.blackboard.feeds import Effects
from situ.blackboard.replies import Addresses
from situ.blackboard.session import Sessions
from situ.decide.effects import Begin, Cancel, Map
from situ.decide.robot import Robot
from situ.document.project import Project
from situ.document.ready import load_ready

if TYPE_CHECKING:
    from tests.blackboard.conftest import Hand

ALL = ["engine", "robot", "screen"]
APPLICATION = """<application name="desk" start="1">
  <state no="1"><expectedevents><event name="go" next="2"/></expectedevents></state>
  <state no="2">
    <backgroundactions>
      <service name="order" method="POST" url="http://127.0.0.1:9/order"/>
      <service name="ask" url="http://127.0.0.1:9/ask"/>
    </backgroundactions>
    <expectedevents><event name="back" next="1"/></expectedevents>
  </state>
</application>"""


@pytest.fixture
def orders(tmp_path: Path) -> Project:
    """A project that orders (POST) and asks (GET) when it is told to go."""
    (tmp_path / "situ.toml").write_text('[project]\nname = "x"\napplications = ["desk.rbd.xml"]\n')
    (tmp_path / "desk.rbd.xml").write_text(APPLICATION)
    return load_ready(tmp_path)


def serve(hand: Hand, peer: str = "services", *services: str) -> dict[str, Any]:
    """The reply to ``perform`` of a client that carries these out."""
    hand.hello(peer, role="service", services=list(services) or ALL)
    return hand.ask(peer, "perform")


def given(hand: Hand) -> list[notices.Effect]:
    return [one for one in hand.heard() if isinstance(one, notices.Effect)]


def test_a_service_is_told_what_is_outstanding_and_then_each_effect(hand: Hand) -> None:
    hand.hello("ann", role="operator", user="ann")
    told = serve(hand)
    assert [one["resource"] for one in told["effects"]] == ["screen"]
    hand.heard()
    hand.ask("ann", "publish", event="go")
    effects = given(hand)
    assert {(e.service, type(e.does)) for e in effects} == {("engine", Begin), ("screen", Map)}
    for service in ALL:
        numbers = [one.number for one in effects if one.service == service]
        begin = told["next"][service]
        assert numbers == list(range(begin, begin + len(numbers)))
        assert hand.ask("services", "heartbeat")["effects"][service] == begin + len(numbers) - 1
    begun = next(one.does for one in effects if isinstance(one.does, Begin))
    again = hand.ask("services", "perform")["effects"]
    assert [one["id"] for one in again if one["effect"] == "begin"] == [begun.id]
    # It goes on from where the service says that it has ended.
    hand.ask("services", "finish", action_id=begun.id, result={"names": []}, status=200)
    assert "begin" not in {one["effect"] for one in hand.ask("services", "perform")["effects"]}


def test_what_begins_while_a_service_is_away_waits_for_it(orders: Project, make_hand: Any) -> None:
    hand = make_hand(project=orders)
    hand.hello("ann", role="operator", user="ann")
    hand.ask("ann", "publish", event="go")
    assert given(hand) == []
    assert [one["name"] for one in serve(hand)["effects"]] == ["order", "ask"]


def test_of_what_a_lost_engine_ran_only_what_may_be_done_twice_waits_for_the_next(
    orders: Project, make_hand: Any
) -> None:
    hand = make_hand(project=orders)
    hand.hello("ann", role="operator", user="ann")
    serve(hand)
    hand.ask("ann", "publish", event="go")
    for beat in range(1, 5):
        hand.at(beat * 0.25)
        hand.ask("ann", "heartbeat")
    hand.at(1.0)
    entry = hand.ask("ann", "get", names=["service/order"])["entries"]["service/order"]
    assert entry["value"]["ok"] is False
    assert entry["value"]["error"] == (
        "the service engine was lost while order was under way; whether it was done is not known"
    )
    assert [one["name"] for one in serve(hand, "next")["effects"]] == ["ask"]


@pytest.mark.parametrize(
    ("hello", "code"),
    [
        ({"role": "service"}, "role"),
        ({"role": "viewer", "services": ["engine"]}, "role"),
        ({"role": "service", "services": ["legs"]}, "name"),
        ({"role": "service", "services": ["robot", "screen"]}, "name"),
    ],
)
def test_a_service_is_one_that_there_is_and_is_carried_out_once(
    hand: Hand, hello: dict[str, Any], code: str
) -> None:
    serve(hand, "first", "engine", "screen")
    assert hand.hello("second", **hello)["code"] == code


def test_what_the_core_itself_carries_out_no_client_does(lab: Project) -> None:
    core = Core(Robot(lab), lab)
    sessions = Sessions(core, Addresses("tcp://127.0.0.1:1", "tcp://127.0.0.1:2"), own=["screen"])
    sessions.start()
    body = b'{"do":"hello","id":1,"version":1,"role":"service","services":["screen"]}'
    sessions.receive("x", body, 0)
    ((_, reply),) = sessions.take().replies
    assert b'"code":"name"' in reply
    assert b"in the core's own process" in reply


@pytest.mark.parametrize(
    ("do", "fields"),
    [
        ("set", {"tags": {"x": 1}}),
        ("set", {"tags": {"x": 1}, "writer": "screen"}),
        ("use", {"component": "go"}),
        ("touch", {}),
        ("attend", {}),
        ("publish", {"event": "go"}),
        ("perform", {"http": "http://127.0.0.1:1/"}),
    ],
)
def test_a_service_does_only_what_is_its_own(hand: Hand, do: str, fields: dict[str, Any]) -> None:
    serve(hand, "arms", "robot")
    assert hand.ask("arms", do, **fields)["code"] == "role"


def test_only_a_service_carries_out_and_writes_for_others(hand: Hand) -> None:
    hand.hello("ann", role="operator", user="ann")
    assert hand.ask("ann", "perform")["code"] == "role"
    assert hand.ask("ann", "set", tags={"x": 1}, writer="screen")["code"] == "role"


def test_a_service_writes_as_the_adapter_and_as_the_screen(hand: Hand) -> None:
    serve(hand)
    for writer in ("sim", "screen"):
        hand.ask("services", "set", tags={"x": writer}, writer=writer)
        assert hand.ask("services", "get", names=["x"])["entries"]["x"]["writer"] == writer
    assert hand.ask("services", "attend")["re"] == "done"


def test_where_a_scenario_gives_the_time_services_end_and_measure_nothing(
    make_hand: Callable[..., Hand],
) -> None:
    hand = make_hand(scripted=True)
    hand.hello("play", role="scenario")
    serve(hand)
    hand.ask("play", "publish", event="go")
    begun = next(one.does for one in given(hand) if isinstance(one.does, Begin))
    assert hand.ask("services", "finish", action_id=begun.id)["re"] == "done"
    assert hand.ask("services", "set", tags={"x": 1}, writer="sim")["versions"] == {}
    outstanding = hand.ask("services", "perform")["effects"]
    assert [one["id"] for one in outstanding if one["effect"] == "begin"] == [begun.id]
    assert hand.ask("play", "get", names=["x"])["entries"]["x"]["version"] == 0


def test_the_screens_address_is_told_for_as_long_as_it_is_there(hand: Hand) -> None:
    hand.hello("tablet", role="service", services=["screen"])
    hand.ask("tablet", "perform", http="http://127.0.0.1:3/")
    assert hand.hello("a", role="viewer")["addresses"]["http"] == "http://127.0.0.1:3/"
    hand.ask("tablet", "bye")
    assert hand.hello("b", role="viewer")["addresses"]["http"] is None


def test_a_core_that_comes_back_counts_on_and_knows_its_services(lab: Project) -> None:
    def made() -> tuple[Robot, Core, Sessions]:
        robot = Robot(lab)
        core = Core(robot, lab, backlog=Backlog())
        return robot, core, Sessions(core, Addresses("tcp://127.0.0.1:1", "tcp://127.0.0.1:2"))

    def ask(sessions: Sessions, peer: str, body: bytes, now: int) -> Any:
        sessions.receive(peer, body, now)
        out = sessions.take()
        return wire.read_reply(out.replies[-1][1]), out

    robot, core, sessions = made()
    sessions.start()
    hello = b'{"do":"hello","id":1,"version":1,"role":"service","services":["screen"]}'
    welcome, _ = ask(sessions, "s", hello, 0)
    snapshot, state = robot.snapshot(), sessions.state()
    core.remembers = True
    _, out = ask(sessions, "s", b'{"do":"perform","id":2}', 0)
    ask(sessions, "o", b'{"do":"hello","id":1,"version":1,"role":"operator"}', 0)
    past = [*out.past, *sessions.take().past]
    before = core.effects["screen"]
    robot, core, sessions = made()
    robot.restore(snapshot)
    sessions.restore(state, past, 10)
    assert core.effects["screen"] == before
    _, out = ask(sessions, "o", b'{"do":"hello","id":1,"version":1,"role":"operator"}', 10)
    _, out = ask(sessions, "o", b'{"do":"publish","id":2,"event":"go"}', 10)
    (notice,) = [n for n in map(wire.read_notice, out.notices) if isinstance(n, notices.Effect)]
    assert notice.number == before + 1
    again = hello.replace(b"}", b',"session":"%s"}' % welcome.session.encode())
    assert ask(sessions, "t", again, 11)[0].resumed


def test_effects_that_are_lost_are_found_by_the_next_or_by_a_heartbeat() -> None:
    def notice(number: int) -> notices.Effect:
        return notices.Effect(service="robot", number=number, does=Cancel(number))

    effects = Effects(("robot",), None)
    effects.asking = True
    # What comes before the reply that it is in is not done twice.
    assert effects.hear(notice(4))
    assert effects.hear(notice(5))
    outstanding = replies.Outstanding(id=1, effects=(), next={"robot": 5})
    effects.stands(outstanding)
    assert effects.hear(notice(4))
    assert [effects.take(), effects.take(), effects.take()] == [outstanding, Cancel(5), None]
    assert not effects.behind({"robot": 6})
    assert effects.hear(notice(6))
    assert not effects.behind({"robot": 7})
    assert effects.behind({"robot": 7})
    assert not effects.hear(notice(8))
    assert not effects.ready
