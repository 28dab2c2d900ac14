"""What applications ask of modules (``board:module/request``), at the core."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from situ.blackboard import notices, wire
from situ.blackboard.core import Core
from situ.blackboard.replies import Addresses
from situ.blackboard.services import PATIENCE
from situ.blackboard.session import Sessions
from situ.decide.robot import Robot
from situ.document.project import Project
from situ.document.ready import load_ready

if TYPE_CHECKING:
    from tests.blackboard.conftest import Hand

APPLICATION = """<application name="desk" start="1">
  <state no="1"><expectedevents><event name="go" next="2"/></expectedevents></state>
  <state no="2">
    <backgroundactions>
      <service name="pressure" url="board:cuff/measure" done="measured" failed="nothing">
        <param name="arm">left</param><result tag="bp.systolic" path="systolic"/>
      </service>
    </backgroundactions>
    <expectedevents>
      <event name="measured" next="3"/><event name="nothing" next="4"/>
      <event name="back" next="1"/>
    </expectedevents>
  </state>
  <state no="3" final="true"/><state no="4" final="true"/>
</application>"""


@pytest.fixture
def ward(tmp_path: Path) -> Project:
    """Measures when it is told to go; where it is then says how that ended."""
    (tmp_path / "situ.toml").write_text('[project]\nname = "x"\napplications = ["desk.rbd.xml"]\n')
    (tmp_path / "desk.rbd.xml").write_text(APPLICATION)
    return load_ready(tmp_path)


@pytest.fixture
def hand(ward: Project, make_hand: Callable[..., Hand]) -> Hand:
    made = make_hand(project=ward)
    made.hello("ann", role="operator", user="ann")
    return made


def serve(hand: Hand, peer: str = "cuff", *requests: str) -> Any:
    return hand.ask(peer, "serve", requests=list(requests) or ["measure"])


def go(hand: Hand) -> None:
    hand.ask("ann", "publish", event="go")
    hand.at(hand.now / 1e6)


def state(hand: Hand) -> str:
    (entry,) = hand.ask("ann", "get", names=["application/desk"])["entries"].values()
    return str(entry["value"]["state"])


def error(hand: Hand) -> str:
    (entry,) = hand.ask("ann", "get", names=["service/pressure"])["entries"].values()
    return str(entry["value"]["error"])


def asked(hand: Hand) -> list[int]:
    """The counts told under ``q:cuff`` since the last call."""
    frames, hand.notices = hand.notices, []
    return [
        notice.count
        for frame in frames
        if frame.startswith(b"q:cuff\n")
        and isinstance(notice := wire.read_notice(frame), notices.Asked)
    ]


def test_a_module_is_asked_and_its_answer_is_the_services_result(hand: Hand) -> None:
    hand.hello("cuff")
    assert serve(hand)["questions"] == []
    go(hand)
    assert asked(hand) == [1]
    told = serve(hand)
    (question,) = told["questions"]
    assert question == {
        "id": question["id"],
        "request": "measure",
        "params": {"arm": "left"},
        "application": "desk",
    }
    assert told["count"] == 1
    hand.ask("cuff", "answer", asked=question["id"], result={"systolic": 120})
    assert state(hand) == "3"
    entries = hand.ask("ann", "get", names=["bp.systolic", "service/pressure"])["entries"]
    assert entries["bp.systolic"]["value"] == 120
    assert entries["service/pressure"]["value"] == {"ok": True, "status": None, "error": None}
    assert serve(hand)["questions"] == []


def test_a_module_may_say_what_went_wrong(hand: Hand) -> None:
    hand.hello("cuff")
    serve(hand)
    go(hand)
    (question,) = serve(hand)["questions"]
    said = "the cuff\n is not on"
    hand.ask("cuff", "answer", asked=question["id"], ok=False, error=said)
    assert (state(hand), error(hand)) == ("4", "cuff: the cuff is not on")


def test_what_a_module_is_asked_no_service_carries_out(hand: Hand) -> None:
    hand.hello("cuff")
    hand.hello("services", role="service", services=["engine", "robot", "screen"])
    hand.ask("services", "perform")
    go(hand)
    assert hand.ask("services", "perform")["effects"] == []
    hand.ask("services", "bye")
    assert state(hand) == "2"


def test_a_module_that_is_not_there_fails_the_action_at_once(hand: Hand) -> None:
    go(hand)
    assert state(hand) == "4"
    assert error(hand) == "cuff is not connected, so it can not be asked to measure"


def test_so_does_a_request_that_the_module_does_not_know(hand: Hand) -> None:
    hand.hello("cuff")
    serve(hand, "cuff", "inflate", "deflate")
    go(hand)
    assert (state(hand), error(hand)) == (
        "4",
        "cuff has no request measure; it has deflate, inflate",
    )


def test_and_one_that_it_does_not_name_when_it_comes_to_serve(hand: Hand) -> None:
    hand.hello("cuff")
    go(hand)
    assert state(hand) == "2"
    assert serve(hand, "cuff", "inflate")["questions"] == []
    hand.at(hand.now / 1e6)
    assert state(hand) == "4"


def test_a_module_that_is_lost_fails_what_it_was_asked(hand: Hand) -> None:
    hand.hello("cuff")
    serve(hand)
    go(hand)
    hand.ask("cuff", "bye")
    hand.at(hand.now / 1e6)
    assert state(hand) == "4"
    assert "cuff was lost before it answered measure" in error(hand)


def test_a_module_that_never_answers_fails_it_in_the_end(hand: Hand) -> None:
    hand.hello("cuff")
    serve(hand)
    go(hand)
    for beat in range(1, int(PATIENCE) * 2):
        hand.at(beat / 2)
        hand.ask("cuff", "heartbeat")
        hand.ask("ann", "heartbeat")
    assert state(hand) == "2"
    hand.at(PATIENCE)
    assert (state(hand), error(hand)) == ("4", "cuff did not answer measure within 30 s")


def test_what_is_left_is_taken_back_and_a_late_answer_passed_over(hand: Hand) -> None:
    hand.hello("cuff")
    serve(hand)
    go(hand)
    (question,) = serve(hand)["questions"]
    asked(hand)
    hand.ask("ann", "publish", event="back")
    assert asked(hand) == [2]
    assert serve(hand)["questions"] == []
    reply = hand.ask("cuff", "answer", asked=question["id"], result={"systolic": 120})
    assert reply["re"] == "done"
    assert state(hand) == "1"


def test_a_heartbeat_tells_what_a_lost_notice_did_not(hand: Hand) -> None:
    hand.hello("cuff")
    count = serve(hand)["count"]
    assert hand.ask("cuff", "heartbeat")["asked"] == count
    go(hand)
    assert hand.ask("cuff", "heartbeat")["asked"] == count + 1


def test_nobody_answers_for_another_module(hand: Hand) -> None:
    hand.hello("cuff")
    hand.hello("nod")
    serve(hand)
    go(hand)
    (question,) = serve(hand)["questions"]
    assert hand.ask("nod", "answer", asked=question["id"])["code"] == "refused"
    for do, fields in (("serve", {"requests": ["x"]}), ("answer", {"asked": 1})):
        assert hand.ask("ann", do, **fields)["code"] == "role"
    assert state(hand) == "2"


def test_where_a_scenario_gives_the_time_modules_are_asked_and_end_nothing(
    ward: Project, make_hand: Callable[..., Hand]
) -> None:
    hand = make_hand(project=ward, scripted=True)
    hand.hello("ann", role="operator", user="ann")
    hand.hello("cuff")
    serve(hand)
    go(hand)
    (question,) = serve(hand)["questions"]
    hand.ask("cuff", "answer", asked=question["id"], result={"systolic": 120})
    hand.ask("cuff", "bye")
    hand.at(0.5)
    assert state(hand) == "2"


def test_a_core_that_comes_back_still_asks(ward: Project) -> None:
    def made() -> tuple[Robot, Sessions]:
        robot = Robot(ward)
        addresses = Addresses("tcp://127.0.0.1:1", "tcp://127.0.0.1:2")
        return robot, Sessions(Core(robot, ward), addresses)

    def ask(sessions: Sessions, peer: str, body: bytes, now: int = 0) -> Any:
        sessions.receive(peer, body, now)
        return wire.read_reply(sessions.take().replies[-1][1])

    robot, sessions = made()
    sessions.start()
    hello = b'{"do":"hello","id":1,"version":1,"module":"cuff"}'
    welcome = ask(sessions, "cuff", hello)
    ask(sessions, "ann", b'{"do":"hello","id":1,"version":1,"role":"operator"}')
    ask(sessions, "ann", b'{"do":"publish","id":2,"event":"go"}')
    snapshot, kept = robot.snapshot(), sessions.state()
    robot, sessions = made()
    robot.restore(snapshot)
    sessions.restore(kept, [], 10)
    again = hello.replace(b"}", b',"session":"%s"}' % welcome.session.encode())
    assert ask(sessions, "new", again, 20).resumed
    told = ask(sessions, "new", b'{"do":"serve","id":2,"requests":["measure"]}', 20)
    (question,) = told.questions
    ask(sessions, "new", b'{"do":"answer","id":3,"asked":%d,"result":{}}' % question.id, 20)
    assert robot.board.look("application/desk.state") == "3"
