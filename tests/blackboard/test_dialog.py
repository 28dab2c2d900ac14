"""The client's half against the core's, over a network that loses what it likes."""

from __future__ import annotations

import itertools
import random
from collections import deque
from collections.abc import Callable
from typing import Any

import pytest

from situ.blackboard import notices, replies, topics, wire
from situ.blackboard.calls import Call, Person
from situ.blackboard.dialog import Dialog
from situ.blackboard.feeds import KEPT
from situ.blackboard.subscriptions import Subscriptions
from situ.errors import Refused, Unreachable


class Net:
    """One dialog and a core, joined by hand; ``lose(frame)`` says which notices get lost."""

    def __init__(self, hand: Any, person: Person | None = None) -> None:
        self.hand = hand
        self.dialog = Dialog(person or Person(role="operator", user="ann"))
        self.lose: Callable[[bytes], bool] = lambda frame: False
        self.cut = False
        self.peer = "here-0"
        self._topics: list[bytes] = []
        self._wire: deque[bytes] = deque()

    def beat(self, times: int = 1) -> Net:
        """Lets a quarter of a second pass, so many times."""
        for _ in range(times):
            self.hand.at(self.hand.now / 1e6 + 0.25)
            self.turn()
        return self

    def turn(self) -> Net:
        """Carries messages until nobody has anything to say."""
        dialog, now = self.dialog, self.hand.now / 1e6
        dialog.tick(now)
        busy = True
        while busy:
            busy = False
            while dialog.subscribing:
                topic, on = dialog.subscribing.popleft()
                if on:
                    self._topics.append(topic)
                    if topic.startswith(topics.ECHO) and not self.cut:
                        echo = wire.notice(topic + b"\n", notices.Echo())
                        self._wire.append(echo)
                elif topic in self._topics:
                    self._topics.remove(topic)
            while dialog.outgoing and not self.cut:
                busy = True
                dialog.receive(self.hand.raw(self.peer, dialog.outgoing.popleft()), now)
            self._carry()
            while self._wire:
                busy = True
                dialog.hear(self._wire.popleft(), now)
        return self

    def _carry(self) -> None:
        notices, self.hand.notices = self.hand.notices, []
        for frame in notices:
            fits = any(frame.startswith(topic) for topic in self._topics)
            if fits and not self.cut and not self.lose(frame):
                self._wire.append(frame)

    def get(self, call: Call[Any]) -> Any:
        self.turn()
        assert call.finished
        return call.result()

    def reconnect(self) -> None:
        """The connection is there again, as another one."""
        self.cut = False
        self.peer = self.peer[:-1] + str(int(self.peer[-1]) + 1)


@pytest.fixture
def net(hand: Any) -> Net:
    return Net(hand).turn()


def is_connected(net: Net) -> bool:
    return net.dialog.connected


def is_ready(feed: Any) -> bool:
    return bool(feed.ready)


def taken(feed: Any) -> list[Any]:
    return list(iter(feed.take, None))


def test_it_says_hello_by_itself_and_is_connected(net: Net) -> None:
    assert is_connected(net)
    assert net.dialog.welcome is not None
    assert net.dialog.welcome.project == "lab"


def test_what_was_asked_before_the_connection_stood_is_asked_then(hand: Any) -> None:
    net = Net(hand)
    call = net.dialog.set({"x": 1})
    assert net.get(call) == {"x": 1}


def test_what_is_refused_raises_what_the_core_said(net: Net) -> None:
    with pytest.raises(Refused, match="only the priority management writes there"):
        net.get(net.dialog.set({"robot/head": 1}))


def test_a_value_that_is_no_json_is_told_at_once(net: Net) -> None:
    call = net.dialog.set({"x": object()})
    with pytest.raises(Exception, match="no JSON value"):
        net.get(call)


def test_a_watch_tells_what_stands_there_then_every_change(net: Net) -> None:
    net.get(net.dialog.set({"face.visible": True, "other": 1}))
    watch = net.dialog.watch("face.*")
    net.turn()
    net.get(net.dialog.set({"face.visible": False, "face.direction": 3}))
    net.get(net.dialog.set({"face.direction": None}))
    assert [(c.tag, c.value, c.version, c.missed) for c in taken(watch)] == [
        ("face.visible", True, 1, 0),
        ("face.visible", False, 2, 0),
        ("face.direction", 3, 1, 0),
        ("face.direction", None, 2, 0),
    ]


def test_a_watched_tag_is_known_without_asking(net: Net) -> None:
    net.dialog.watch("face.*")
    net.turn()
    net.get(net.dialog.set({"face.visible": True}))
    entry = net.dialog.known("face.visible")
    assert entry is not None
    assert entry.value is True
    assert net.dialog.known("other") is None
    net.cut = True
    net.beat(5)
    assert net.dialog.known("face.visible") is None


def test_a_change_lost_in_between_is_found_by_the_version(net: Net) -> None:
    watch = net.dialog.watch("x")
    net.turn()
    net.get(net.dialog.set({"x": 1}))
    net.lose = lambda frame: True
    net.get(net.dialog.set({"x": 2}))
    net.lose = lambda frame: False
    net.get(net.dialog.set({"x": 3}))
    assert [(c.value, c.version, c.missed) for c in taken(watch)] == [(1, 1, 0), (3, 3, 1)]


def test_messages_are_heard_as_they_are_sent_and_only_those_asked_for(net: Net) -> None:
    heard, other = net.dialog.messages("desk/*"), net.dialog.messages("nurse/call")
    assert not is_ready(heard)
    net.turn()
    assert is_ready(heard)
    net.get(net.dialog.publish("go"))
    (message,) = taken(heard)
    assert (message.topic, message.application) == ("desk/busy", "desk")
    assert not taken(other)
    net.dialog.unlisten(heard)
    net.beat(20)
    net.get(net.dialog.publish("go"))
    assert heard.ended
    assert not taken(heard)


def test_messages_are_heard_again_after_a_loss_of_the_connection(net: Net) -> None:
    heard = net.dialog.messages("**")
    net.turn()
    net.cut = True
    net.beat(6)
    assert not net.dialog.connected
    assert not is_ready(heard)
    net.reconnect()
    net.beat(4)
    assert is_ready(heard)
    net.get(net.dialog.publish("go"))
    assert [message.topic for message in taken(heard)] == ["desk/busy"]


def test_of_messages_that_nobody_takes_the_last_are_kept(net: Net) -> None:
    heard = net.dialog.messages("**")
    net.turn()
    for number in range(KEPT + 5):
        frame = notices.Message(topic="x", value=number, application="desk")
        net.dialog.hear(wire.notice(topics.message("x"), frame), 0.0)
    assert [message.value for message in taken(heard)] == list(range(5, KEPT + 5))


def test_a_last_change_that_was_lost_is_found_by_the_heartbeat(net: Net) -> None:
    watch = net.dialog.watch("x")
    net.turn()
    net.lose = lambda frame: frame.startswith(b"t:x")
    net.get(net.dialog.set({"x": 1}))
    assert taken(watch) == []
    net.lose = lambda frame: False
    net.beat(3)
    assert [(c.value, c.version) for c in taken(watch)] == [(1, 1)]


def test_an_echo_that_was_lost_is_asked_for_again(net: Net) -> None:
    net.get(net.dialog.set({"x": 1}))
    watch = net.dialog.watch("x")
    heard, net.dialog.hear = net.dialog.hear, lambda frame, now: None  # type: ignore[method-assign]
    net.turn()
    assert not watch.ready
    net.dialog.hear = heard  # type: ignore[method-assign]
    net.beat(12)
    assert [c.value for c in taken(watch)] == [1]


def test_no_echo_counts_that_was_asked_for_before_the_connection_stood() -> None:
    # What was subscribed to by then arrives in any order, a topic after its own echo too.
    asked: list[tuple[str, ...]] = []

    class Connected:
        connected = True

        def next_id(self) -> int:
            return next(count)

        def ask(self, request: Any, read: Callable[[Any], Any], again: bool) -> Call[Any]:
            asked.append(request.patterns)
            return Call(request, read, again)

    count = itertools.count(1)
    subscriptions = Subscriptions(Connected())

    def echoes() -> list[bytes]:
        wanted = [t for t, on in subscriptions.topics if on and t.startswith(topics.ECHO)]
        subscriptions.topics.clear()
        return wanted

    subscriptions.watch("a")
    subscriptions.watch("b")
    for topic in echoes():
        subscriptions.hear(notices.Echo(), topic + b"\n")
    assert asked == []
    for topic in echoes():
        subscriptions.hear(notices.Echo(), topic + b"\n")
    assert asked == [("a",), ("b",)]


@pytest.mark.parametrize("seed", range(30))
def test_whatever_is_lost_watch_and_trace_end_up_whole(
    make_hand: Callable[..., Any], seed: int
) -> None:
    chance = random.Random(seed)
    # Of a module's sessions many end meanwhile.
    person = Person(role="module", module="eyes") if seed % 2 else None
    net = Net(make_hand(), person).turn()
    watches = [net.dialog.watch(pattern) for pattern in ("a.*", "**", "b", "a.x")]
    feed = net.dialog.trace(since=1)
    told: list[list[Any]] = [[] for _ in watches]
    events: list[dict[str, Any]] = []
    rate = chance.choice([0.0, 0.1, 0.5, 0.9])
    net.lose = lambda frame: chance.random() < rate

    def take() -> None:
        for watch, so_far in zip(watches, told, strict=True):
            so_far += taken(watch)
        events.extend(taken(feed))

    for _ in range(60):
        tags = chance.sample(["a.x", "a.y", "b", "c"], chance.randint(1, 3))
        net.dialog.set({tag: chance.choice([None, 1, 2, 3]) for tag in tags})
        doing = chance.random()
        if doing < 0.1:
            net.cut = True
            net.beat(chance.randint(1, 8))
            net.reconnect()
        elif doing < 0.3:
            net.beat()
        elif doing < 0.9:
            net.turn()
        if chance.random() < 0.3:
            take()
    net.lose = lambda frame: False
    net.beat(16)
    take()
    board = net.hand.core.board.state
    for watch, so_far in zip(watches, told, strict=True):
        assert watch.ready
        standing = {t: e.version for t, e in board.items() if watch.fits(t)}
        assert {t: e.version for t, e in watch.known.items()} == standing
        last: dict[str, int] = {}
        for change in so_far:
            if change.tag in last:
                assert change.version == last[change.tag] + 1 + change.missed
            last[change.tag] = change.version
        present = {t for t, e in board.items() if e.value is not None and watch.fits(t)}
        assert {t: standing[t] for t in present} == {t: last[t] for t in present}
    assert [e["seq"] for e in events] == list(range(1, net.hand.core.backlog.last + 1))


def test_a_cut_connection_is_noticed_and_taken_up_again(net: Net) -> None:
    watch = net.dialog.watch("x")
    net.turn()
    net.cut = True
    net.beat(5)
    assert not is_connected(net)
    late = net.dialog.set({"x": 1})
    again = net.dialog.get("x")
    net.reconnect()
    net.beat(2)
    assert is_connected(net)
    assert late.result() == {"x": 1}
    assert again.result() in (None, 1)
    assert [c.value for c in taken(watch)] == [1]


def test_a_core_that_was_started_anew_is_told_everything_again(
    make_hand: Callable[..., Any],
) -> None:
    net = Net(make_hand(), Person(role="module", module="chase", resources=("head",))).turn()
    watch = net.dialog.watch("*")
    feed = net.dialog.trace()
    net.turn()
    net.get(net.dialog.acquire("me", ("head",)))
    net.get(net.dialog.set({"x": 1, "y": 1}))
    assert net.dialog.holds == {"head"}
    taken(watch)
    first = taken(feed)
    now = net.hand.now
    net.hand = make_hand()
    net.hand.now = now
    net.hand.ask("someone", "hello", version=1, role="operator")
    net.hand.ask("someone", "set", tags={"x": 2})
    net.beat(8)
    assert is_connected(net)
    assert net.dialog.holds == {"head"}
    changes = {c.tag: c.value for c in taken(watch)}
    assert changes["x"] == 2
    assert changes["y"] is None
    events = taken(feed)
    assert [e["seq"] for e in events] == list(range(1, net.hand.core.backlog.last + 1))
    assert feed.restarts == 1
    assert first


def test_what_may_have_been_done_is_not_done_twice(net: Net) -> None:
    publish = net.dialog.publish("go")
    # It arrives, but the answer does not.
    net.hand.raw(net.peer, net.dialog.outgoing.popleft())
    net.cut = True
    net.beat(5)
    with pytest.raises(Unreachable, match="whether publish was done is not known"):
        publish.result()
    net.reconnect()
    net.beat(3)
    board = net.hand.core.board
    assert board.get("application/desk").value["state"] == "2"


def test_what_was_never_sent_is_sent_later(net: Net) -> None:
    net.cut = True
    publish = net.dialog.publish("go")
    net.beat(5)
    assert not publish.finished
    net.reconnect()
    net.beat(2)
    assert publish.result() is None
    assert net.hand.core.board.get("application/desk").value["state"] == "2"


def test_an_operator_who_stood_still_for_a_moment_has_lost_nothing(net: Net) -> None:
    told: list[bool] = []
    net.dialog.changed = lambda: told.append(is_connected(net))
    session = net.dialog.welcome
    net.hand.at(9.0)
    assert net.get(net.dialog.publish("go")) is None
    assert net.hand.core.board.get("application/desk").value["state"] == "2"
    assert told == []
    assert net.dialog.welcome is session
    # The core was asked, and has as long to answer as ever.
    net.cut = True
    net.hand.at(12.0)
    net.turn()
    net.beat(3)
    assert is_connected(net)
    net.beat()
    assert told == [False]


NOT_ASKED = Unreachable("the robot is another")


def test_what_is_meant_for_the_robot_that_is_there_is_done_once_though_we_stood_still(
    net: Net,
) -> None:
    session = net.dialog.welcome.session if net.dialog.welcome is not None else ""
    net.hand.at(30.0)
    call = net.dialog.publish("go")
    call.otherwise = NOT_ASKED
    net.beat(2)
    assert call.result() is None
    assert net.dialog.welcome is not None
    assert net.dialog.welcome.session != session
    assert net.hand.core.board.get("application/desk").value["state"] == "2"
    # So is what reached a core that had taken us for dead, for the time is not the same everywhere.
    net.hand.raw(net.peer, b'{"do":"bye","id":1}')
    set_call = net.dialog.set({"x": 1}, versions={"x": 0})
    set_call.otherwise = NOT_ASKED
    net.beat(2)
    assert set_call.result() == {"x": 1}


def test_what_is_meant_for_the_robot_that_is_there_is_none_of_the_next_one_s(
    net: Net, make_hand: Callable[..., Any]
) -> None:
    now = net.hand.at(30.0).now
    net.hand = make_hand()
    net.hand.now = now
    call = net.dialog.publish("go")
    call.otherwise = NOT_ASKED
    net.beat(2)
    assert is_connected(net)
    assert call.error is NOT_ASKED
    assert net.hand.core.board.get("application/desk").value["state"] == "1"


def test_what_is_meant_for_the_robot_that_is_there_waits_a_second_for_it_to_be_found_again(
    net: Net,
) -> None:
    net.hand.at(30.0)
    net.cut = True
    call = net.dialog.publish("go")
    call.otherwise = NOT_ASKED
    net.turn()
    net.beat(3)
    assert not call.finished
    net.beat()
    assert call.error is NOT_ASKED
    # What came to nothing stays so, though it answers again.
    net.reconnect()
    net.beat(2)
    assert is_connected(net)
    assert net.hand.core.board.get("application/desk").value["state"] == "1"


def test_what_is_meant_for_a_robot_that_falls_silent_is_given_up_at_once(net: Net) -> None:
    call = net.dialog.publish("go")
    call.otherwise = NOT_ASKED
    net.cut = True
    net.beat(4)
    assert call.error is NOT_ASKED


def test_a_command_without_a_connection_is_left_out(hand: Any) -> None:
    net = Net(hand, Person(role="module", module="chase", resources=("head",))).turn()
    net.get(net.dialog.acquire("me", ("head",)))
    net.cut = True
    sent = net.dialog.command("head", {"yaw": 1})
    net.beat(5)
    late = net.dialog.command("head", {"yaw": 2})
    assert sent.result() is late.result() is None
    net.reconnect()
    net.beat(8)
    assert net.dialog.holds == {"head"}
    assert net.hand.core.board.get("robot/head") is None


def test_several_requests_for_authority_of_one_module_are_one(hand: Any) -> None:
    net = Net(hand, Person(role="module", module="carry", resources=("base", "head"))).turn()
    net.get(net.dialog.acquire("arm", ("base",)))
    net.get(net.dialog.acquire("look", ("head",)))
    assert net.dialog.holds == {"base", "head"}
    net.get(net.dialog.abandon("arm"))
    assert net.dialog.holds == {"head"}
    net.get(net.dialog.abandon("look"))
    assert net.dialog.holds == set()


def test_authority_that_passes_on_is_told_at_once(hand: Any) -> None:
    net = Net(hand, Person(role="module", module="chase", resources=("head",))).turn()
    net.get(net.dialog.acquire("me", ("head",)))
    told: list[bool] = []
    net.dialog.changed = lambda: told.append("head" in net.dialog.holds)
    hand.hello("nod", resources=["head"])
    hand.ask("nod", "acquire", resources=["head"])
    hand.ask("nod", "set", tags={"person.calling": True})
    net.turn()
    assert told == [False]
    hand.ask("nod", "abandon")
    net.turn()
    assert told == [False, True]


def test_authority_that_passes_on_while_the_session_is_lost_is_not_held_before_it_is_found_again(
    hand: Any,
) -> None:
    net = Net(hand, Person(role="module", module="chase", resources=("head",))).turn()
    net.get(net.dialog.acquire("me", ("head",)))
    hand.hello("nod", resources=["head"])
    hand.ask("nod", "acquire", resources=["head"])
    hand.ask("nod", "set", tags={"person.calling": True})
    net.turn()
    # Nothing was heard for a lease of ours; the core's is not over, and its notices come still.
    net.dialog.tick(hand.now / 1e6 + 1.0)
    assert not is_connected(net)
    hand.ask("nod", "abandon")
    for frame in hand.notices:
        net.dialog.hear(frame, hand.now / 1e6 + 1.0)
    assert net.dialog.holds == set()
    net.beat(8)
    assert is_connected(net)
    assert net.dialog.holds == {"head"}


def test_a_name_that_is_taken_is_waited_for_as_long_as_a_lease(
    make_hand: Callable[..., Any],
) -> None:
    hand = make_hand()
    hand.hello("dead")
    net = Net(hand, Person(role="module", module="dead")).turn()
    assert not net.dialog.ended
    net.beat(4)
    assert is_connected(net)
    other = Net(hand, Person(role="module", module="dead"))
    other.peer = "there-0"
    for _ in range(6):
        net.beat()
        other.turn()
    assert other.dialog.ended
    with pytest.raises(Refused, match="a module dead is connected already"):
        other.dialog.get("x").result()


def test_of_changes_that_nobody_takes_the_last_is_kept(net: Net, monkeypatch: Any) -> None:
    monkeypatch.setattr("situ.blackboard.feeds.KEPT", 10)
    watch = net.dialog.watch("*")
    net.turn()
    for count in range(100):
        net.get(net.dialog.set({"x": count}))
    assert len(watch) < 20
    changes = taken(watch)
    assert changes[-1].value == 99
    xs = [c for c in changes if c.tag == "x"]
    assert sum(c.missed + 1 for c in xs) == 100


def test_a_trace_that_nobody_takes_waits_at_the_core(net: Net, monkeypatch: Any) -> None:
    monkeypatch.setattr("situ.blackboard.feeds.KEPT", 10)
    feed = net.dialog.trace(since=1)
    net.turn()
    for count in range(100):
        net.get(net.dialog.set({"x": count}))
    assert len(feed) < 20
    events: list[dict[str, Any]] = []
    for _ in range(30):
        events += taken(feed)
        net.beat()
    assert [e["seq"] for e in events] == list(range(1, net.hand.core.backlog.last + 1))


def test_rubbish_from_the_wire_is_passed_over(net: Net) -> None:
    for junk in (b"", b"{}", b"\xff" * 9, b'{"re":"done"}', b'{"re":"done","id":999}'):
        net.dialog.receive(junk, 0.0)
        net.dialog.hear(junk, 0.0)
        net.dialog.hear(b"t:x\n" + junk, 0.0)
    assert net.get(net.dialog.set({"x": 1})) == {"x": 1}


def test_a_request_that_is_answered_with_something_else_fails(net: Net) -> None:
    call = net.dialog.get("x")
    number = call.request.id
    net.dialog.receive(wire.encode(replies.Done(id=number)), 0.0)
    with pytest.raises(Exception, match="answered with Done"):
        call.result()
