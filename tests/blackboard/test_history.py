"""A core that comes back: its snapshot with the history since is the core that was."""

from __future__ import annotations

from typing import Any

import msgspec
import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from situ.blackboard.history import AnySessionEvent, Past, SessionsState
from situ.decide.inputs import AnyInput, Attend, Finish, Raise

PEERS = ("chase", "nod", "ann")
ASKED: list[tuple[str, dict[str, Any]]] = [
    ("hello", {}),
    ("hello", {"session": "the one before"}),
    ("bye", {}),
    ("heartbeat", {}),
    ("set", {"tags": {"x": 1, "y.z": [1, {"a": None}]}}),
    ("set", {"tags": {"person.calling": True}}),
    ("set", {"tags": {"x": None, "robot/head": 1}}),
    ("watch", {"patterns": ["x", "y.*", "application/**"]}),
    ("unwatch", {"patterns": ["x", "y.*"]}),
    ("trace", {"since": 1}),
    ("acquire", {"resources": ["head"]}),
    ("abandon", {}),
    ("command", {"resource": "head", "value": {"yaw": 3}, "for": 0.4}),
    ("disclose", {"description": "Nods.", "requires": [{"data": "x"}]}),
    ("publish", {"event": "go"}),
    ("use", {"component": "go"}),
]
deeds = st.one_of(
    st.tuples(st.sampled_from(PEERS), st.sampled_from(ASKED)),
    st.sampled_from([0, 1, 200_000, 1_100_000, 5_500_000]),
    st.sampled_from([Attend(), Finish(action="service", name="ask", result={"n": [1]})]),
)


class Life:
    """A core whose history is written down as it goes, in the bytes that a file would hold."""

    def __init__(self, hand: Any) -> None:
        self.hand = hand
        self.sessions: dict[str, str] = {}
        self.past: list[bytes] = []
        hand.core.remembers = True

    def do(self, deed: Any) -> list[bytes]:
        """One deed; the replies to it. What left before it was written down is lost to a kill."""
        hand = self.hand
        if isinstance(deed, int):
            hand.now += deed
            hand.sessions.advance(hand.now)
        elif isinstance(deed, tuple):
            peer, (do, fields) = deed
            fields = dict(fields)
            if do == "hello":
                fields |= {"version": 1}
                who = {"role": "operator", "user": peer} if peer == "ann" else {"module": peer}
                fields |= who if peer == "ann" else {**who, "resources": ["head"]}
                if "session" in fields:
                    fields["session"] = self.sessions.get(peer, "none")
            body = msgspec.json.encode({"do": do, "id": 1, **fields})
            hand.sessions.receive(peer, body, hand.now)
        else:
            hand.sessions.submit(deed, hand.now)
        out = hand.sessions.take()
        self.past.append(msgspec.json.encode(out.past))
        for peer, body in out.replies:
            reply = msgspec.json.decode(body)
            if reply["re"] == "welcome":
                self.sessions[peer] = reply["session"]
        return [body for _, body in out.replies]

    def kept(self) -> tuple[bytes, bytes]:
        """A snapshot; the history begins anew."""
        self.past.clear()
        return self.hand.robot.snapshot(), msgspec.msgpack.encode(self.hand.sessions.state())

    def state(self) -> tuple[bytes, list[Any], SessionsState]:
        """All that it is, as values that can be compared; sessions in any order."""
        found = self.hand.sessions.state()
        sessions = sorted(found.sessions, key=lambda one: one.id)
        return (
            self.hand.robot.snapshot(),
            self.hand.robot.outstanding(),
            msgspec.structs.replace(found, sessions=sessions),
        )


def come_back(make_hand: Any, kept: tuple[bytes, bytes], past: list[bytes], now: int) -> Life:
    again = Life(make_hand(begin=False))
    again.hand.robot.restore(kept[0])
    state = msgspec.msgpack.decode(kept[1], type=SessionsState)
    events: list[Past] = []
    for body in past:
        kind = list[tuple[int, AnyInput | AnySessionEvent | None]]
        events += msgspec.json.decode(body, type=kind)
    again.hand.core.remembers = False
    again.hand.sessions.restore(state, events, now)
    again.hand.core.remembers = True
    again.hand.now = now
    return again


@settings(
    max_examples=40,
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)
@given(before=st.lists(deeds, max_size=12), since=st.lists(deeds, max_size=25))
@example(
    before=[
        ("chase", ASKED[0]),
        ("chase", ASKED[7]),
        ("ann", ASKED[0]),
        ("ann", ASKED[9]),
        ("ann", ASKED[4]),
    ],
    since=[
        ("chase", ASKED[10]),
        ("chase", ASKED[12]),
        ("ann", ASKED[14]),
        200_000,
        ("ann", ASKED[4]),
        ("nod", ASKED[0]),
        ("nod", ASKED[13]),
        5_500_000,
    ],
)
def test_snapshot_and_history_are_the_core_that_was(
    make_hand: Any, before: list[Any], since: list[Any]
) -> None:
    first = Life(make_hand())
    for deed in before:
        first.do(deed)
    kept = first.kept()
    for deed in since:
        first.do(deed)
    again = come_back(make_hand, kept, first.past, first.hand.now)
    # That nothing happened since the last line of the history stands nowhere, and looking whether
    # anything has drops timers that nobody waits for any more.
    for life in (first, again):
        life.hand.core.move(first.hand.now)
    assert again.hand.sessions.take().effects == []
    assert again.state() == first.state()
    assert again.hand.robot.due() == first.hand.robot.due()
    for life in (first, again):
        life.do(Raise("go"))
    assert again.state() == first.state()


@pytest.fixture
def killed(make_hand: Any) -> Any:
    """A core that came back; before it was killed chase held the head and watched x."""
    first = Life(make_hand())
    kept = first.kept()
    for deed in (
        ("chase", ASKED[0]),
        ("chase", ASKED[7]),
        ("chase", ASKED[10]),
        ("chase", ASKED[12]),
        ("ann", ASKED[0]),
        ("ann", ASKED[4]),
    ):
        first.do(deed)
    again = come_back(make_hand, kept, first.past, 300_000)
    again.sessions = first.sessions
    return again


def hello(life: Any, peer: str, session: str) -> dict[str, Any]:
    return dict(life.hand.hello(peer, module="chase", resources=["head"], session=session))


def test_a_session_is_taken_up_again_with_what_it_held_and_watched(killed: Any) -> None:
    welcome = hello(killed, "another connection", killed.sessions["chase"])
    assert (welcome["re"], welcome["resumed"], welcome["time"]) == ("welcome", True, 300_000)
    alive = killed.hand.ask("another connection", "heartbeat")
    assert alive["holds"] == ["head"]
    assert alive["changes"] == {"application/**": 0, "x": 1, "y.*": 1}
    killed.hand.ask("another connection", "set", tags={"x": 5})
    assert killed.hand.changes() == [("x", 5, 2)]


def test_who_does_not_come_back_within_the_lease_is_lost(killed: Any) -> None:
    held = "module/chase/head"
    killed.hand.at(1.299)
    assert killed.hand.core.holds("chase") == ("head",)
    killed.hand.at(1.3)
    assert killed.hand.core.holds("chase") == ()
    assert killed.hand.core.board.get(held) is None


def test_what_fell_due_meanwhile_rings_in_order_when_it_comes_back(make_hand: Any) -> None:
    first = Life(make_hand())
    kept = first.kept()
    first.do(("ann", ASKED[0]))
    first.do(("ann", ASKED[5]))
    first.do(("ann", ASKED[14]))
    again = come_back(make_hand, kept, first.past, 60_000_000)
    assert again.hand.robot.due() is not None
    again.hand.sessions.advance(60_000_000)
    told = [msgspec.json.decode(one) for one in again.hand.core.backlog.since(1, 1000)]
    rang = [(e["t"], e["kind"]) for e in told if e["kind"] in ("situation", "transition")]
    # Both five seconds after what began them: what a condition ends comes first.
    assert rang[-2:] == [(5.0, "situation"), (5.0, "transition")]
