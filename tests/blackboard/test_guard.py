"""Sessions of a core with keys, by hand: who they are, what they may do, what is written down."""

from __future__ import annotations

import logging
from collections.abc import Callable
from typing import Any

import msgspec
import pytest

from situ.blackboard.audit import AGAIN, LONGEST, MOST, Audit
from situ.blackboard.guard import Guard
from situ.blackboard.identity import ROBOT, Identity
from situ.blackboard.replies import Addresses
from situ.blackboard.rights import Rights
from situ.blackboard.session import Sessions

ANN = Identity("ann", "operator")
BOB = Identity("bob", "operator")
FACE = Identity("face", "module", ("face.*",))
NOD = Identity("nod", "module")
TABLET = Identity("tablet", "viewer")


class House:
    """A core with keys. Every message comes by somebody's key."""

    def __init__(self, core: Any) -> None:
        self.now = 0
        self.seconds = 0.0
        audit = Audit(lambda: self.seconds)
        addresses = Addresses("tcp://127.0.0.1:1", "tcp://127.0.0.1:2")
        guard = Guard(Rights(core.project), audit)
        self.sessions = Sessions(core, addresses, guard=guard)
        self.sessions.start()
        self.sessions.take()

    def ask(self, peer: str, who: Identity | None, do: str, **fields: Any) -> dict[str, Any]:
        body = msgspec.json.encode({"do": do, "id": 1, **fields})
        self.sessions.receive(peer, body, self.now, who)
        ((to, reply),) = self.sessions.take().replies
        assert to == peer
        read: dict[str, Any] = msgspec.json.decode(reply)
        return read

    def hello(self, peer: str, who: Identity | None, **fields: Any) -> dict[str, Any]:
        return self.ask(peer, who, "hello", version=1, **fields)

    def module(self, who: Identity, **fields: Any) -> dict[str, Any]:
        return self.hello(who.name, who, module=who.name, **fields)


@pytest.fixture
def house(make_hand: Callable[..., Any], caplog: pytest.LogCaptureFixture) -> House:
    caplog.set_level(logging.INFO, "situ.audit")
    return House(make_hand(begin=False).core)


def told(caplog: pytest.LogCaptureFixture) -> list[str]:
    lines = [record.getMessage() for record in caplog.records if record.name == "situ.audit"]
    caplog.clear()
    return lines


def test_without_a_known_key_nothing_is_answered_but_no(house: House) -> None:
    assert house.hello("x", None, role="viewer")["code"] == "denied"
    assert house.ask("x", None, "get", names=["user.name"])["code"] == "session"


def test_an_operator_writes_in_the_name_of_his_key(house: House) -> None:
    assert house.hello("a", ANN, role="operator")["re"] == "welcome"
    house.ask("a", ANN, "set", tags={"user.name": "Ann"})
    entry = house.ask("a", ANN, "get", names=["user.name"])["entries"]["user.name"]
    assert entry["writer"] == "operator:ann"


def test_who_says_he_is_another_is_refused_and_written_down(
    house: House, caplog: pytest.LogCaptureFixture
) -> None:
    assert house.hello("a", ANN, role="operator", user="bob")["code"] == "denied"
    assert house.hello("f", FACE, module="nod")["code"] == "denied"
    first, second = told(caplog)
    assert first == ('refused name=ann do=hello what=bob why="the key of ann is not bob\'s"')
    assert second.startswith("refused name=face do=hello what=nod")


def test_what_a_role_or_a_right_does_not_allow_is_not_done_but_written_down(
    house: House, caplog: pytest.LogCaptureFixture
) -> None:
    house.hello("t", TABLET, role="viewer")
    house.module(FACE)
    house.module(NOD, provides=[{"data": "user.name"}])
    assert house.ask("t", TABLET, "set", tags={"user.name": "x"})["code"] == "denied"
    for tag in ("user.name", "robot/head", "module/nod/head", "situation"):
        assert house.ask("face", FACE, "set", tags={"face.visible": 1, tag: 1})["code"] == "denied"
    assert house.ask("nod", NOD, "set", tags={"user.name": "x"})["code"] == "denied"
    assert house.ask("face", FACE, "use", component="yes")["code"] == "denied"
    assert house.ask("face", FACE, "get", names=["face.visible"])["entries"] == {
        "face.visible": {"value": None, "version": 0, "writer": None, "time": 0}
    }
    lines = told(caplog)
    assert [line.partition(" why=")[0] for line in lines] == [
        "refused name=tablet do=set what=user.name",
        "refused name=face do=set what=face.visible,user.name",
        "refused name=face do=set what=face.visible,robot/head",
        "refused name=face do=set what=face.visible,module/nod/head",
        "refused name=face do=set what=face.visible,situation",
        "refused name=nod do=set what=user.name",
        "refused name=face do=use what=yes",
    ]


def test_what_the_blackboard_refuses_an_operator_is_written_down_too(
    house: House, caplog: pytest.LogCaptureFixture
) -> None:
    house.hello("a", ANN, role="operator")
    assert house.ask("a", ANN, "set", tags={"robot/head": 1})["code"] == "refused"
    (line,) = told(caplog)
    assert line.startswith("refused name=ann do=set what=robot/head why=")


def test_what_people_change_is_written_down_without_its_values(
    house: House, caplog: pytest.LogCaptureFixture
) -> None:
    house.hello("a", ANN, role="operator")
    house.ask("a", ANN, "set", tags={"user.name": "Ann", "user.room": 12})
    house.ask("a", ANN, "publish", event="alarm name=bob")
    house.ask("a", ANN, "get", names=["user.name"])
    house.module(FACE)
    house.ask("face", FACE, "set", tags={"face.visible": True})
    assert told(caplog) == [
        "changed name=ann do=set what=user.name,user.room",
        'changed name=ann do=publish what="alarm name=bob"',
    ]


def test_what_an_operator_does_to_applications_is_written_down(
    house: House, caplog: pytest.LogCaptureFixture
) -> None:
    house.hello("ann", ANN, role="operator")
    caplog.clear()
    house.ask("ann", ANN, "break", application="desk", **{"from": "1", "to": "2"})
    house.ask("ann", ANN, "pause")
    house.ask("ann", ANN, "goto", state="2")
    house.ask("ann", ANN, "resume", application="desk")
    house.ask("ann", ANN, "unbreak")
    assert told(caplog) == [
        "changed name=ann do=break what=desk,1,2",
        'changed name=ann do=pause what=""',
        "changed name=ann do=goto what=2",
        "changed name=ann do=resume what=desk",
        'changed name=ann do=unbreak what=""',
    ]


def test_nobody_takes_up_the_session_of_another(house: House) -> None:
    session = house.hello("a", ANN, role="operator")["session"]
    assert house.hello("b", BOB, role="operator", session=session)["code"] == "name"
    assert house.hello("c", ANN, role="operator", session=session)["resumed"]


def test_a_connection_of_the_same_name_by_another_key_has_no_session(house: House) -> None:
    house.hello("same", ANN, role="operator")
    assert house.ask("same", BOB, "set", tags={"user.name": "x"})["code"] == "session"
    assert house.ask("same", ANN, "get", names=["x"])["code"] == "session"


def test_who_is_known_no_longer_or_for_less_has_no_session(house: House) -> None:
    house.module(FACE)
    assert house.ask("face", None, "set", tags={"face.visible": 1})["code"] == "session"
    house.module(FACE)
    less = Identity("face", "module", ())
    assert house.ask("face", less, "set", tags={"face.visible": 1})["code"] == "session"
    assert house.module(less)["re"] == "welcome"
    assert house.ask("face", less, "set", tags={"face.visible": 1})["code"] == "denied"


def test_a_scenario_is_the_robots_own(house: House) -> None:
    assert house.hello("a", ANN, role="scenario")["code"] == "denied"
    # The same as without keys: this robot plays none.
    assert house.hello("s", Identity(ROBOT, "service"), role="scenario")["code"] == "role"


# -- the lines ---------------------------------------------------------------


def test_nobody_forges_a_line_or_a_field(caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.INFO, "situ.audit")
    Audit(lambda: 0.0).tell("changed", name='a"\n b=c\x1b', what="")
    assert told(caplog) == ['changed name="a\\"\\n b=c\\u001b" what=""']


def test_a_line_stays_short(caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.INFO, "situ.audit")
    Audit(lambda: 0.0).tell("changed", what="x" * 10_000)
    (line,) = told(caplog)
    assert len(line) < LONGEST + 20


def test_the_same_refusal_is_told_once_a_minute(caplog: pytest.LogCaptureFixture) -> None:
    now = 0.0
    audit = Audit(lambda: now)
    for tenths in range(601):
        now = tenths / 10
        audit.refuse("refused", address="10.0.0.7")
        audit.refuse("refused", address="10.0.0.8")
    assert told(caplog) == [
        "refused address=10.0.0.7",
        "refused address=10.0.0.8",
        "refused address=10.0.0.7 times=599",
        "refused address=10.0.0.8 times=599",
    ]
    assert now == AGAIN


def test_a_flood_of_different_refusals_is_bounded(caplog: pytest.LogCaptureFixture) -> None:
    now = 0.0
    audit = Audit(lambda: now)
    for number in range(2 * MOST):
        audit.refuse("refused", address=str(number))
    assert len(told(caplog)) == MOST
    now = AGAIN
    audit.refuse("refused", address="again")
    assert told(caplog) == ["refused address=again"]
