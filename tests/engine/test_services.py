"""Services apart: what is carried out when a core comes, goes, comes back or is another one."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Any, cast

import pytest

from situ.blackboard import notices, protocol, replies, topics, wire
from situ.blackboard.asynchronous import AsyncBoard
from situ.blackboard.calls import Call, Person
from situ.blackboard.dialog import Dialog
from situ.blackboard.protocol import LEASE
from situ.blackboard.replies import Addresses
from situ.blackboard.services import SERVICES
from situ.decide import inputs
from situ.decide.effects import Begin, Cancel, Map
from situ.document.project import Project
from situ.engine.services import ServicesApart

HELLO = {"text": "hello", "lang": "en"}


class Recorder:
    """Carries out nothing, and knows what it was told."""

    screen_url = "http://127.0.0.1:9/?token=x"

    def __init__(self, submit: Callable[[inputs.AnyInput], None], tag: Any) -> None:
        self.submit = submit
        self.tag = tag
        self.told: list[Any] = []

    async def start(self) -> None:
        pass

    def open_door(self, addresses: Addresses, keys: Any) -> None:
        self.door = addresses

    def turn_to(self, project: Project) -> None:
        pass

    def perform(self, effect: Any) -> None:
        self.told.append(effect)

    def hold(self) -> None:
        self.told.append("hold")

    def caption(self, said: Any) -> None:
        self.told.append(("caption", said))

    async def close(self) -> None:
        self.told.append("closed")

    def take(self) -> list[Any]:
        told, self.told = self.told, []
        return told


class FarBoard:
    """A board whose core is the test: ``said`` is what the core was asked, ``now`` the time."""

    def __init__(self, *services: str) -> None:
        self.link = self
        self.endpoint = "tcp://192.0.2.1:5570"
        self.dialog = Dialog(Person(role="service", services=services or SERVICES))
        self.now = 0.0
        self.said: list[Any] = []
        self._runtime = "a"
        self._turn()

    def perform(self, http: str | None, callback: Any) -> FarBoard:
        self._callback = callback
        self._effects = self.dialog.perform(self.dialog.person.services, http, None)
        return self

    def tell(self, request: Callable[[int], Any], *, again: bool = True) -> Call[Any]:
        call = self.dialog.give(request, again)
        self._turn()
        return call

    async def __aenter__(self) -> FarBoard:
        return self

    async def close(self) -> None:
        pass

    # -- the core ------------------------------------------------------------

    def _turn(self) -> None:
        self.dialog.tick(self.now)
        while self.dialog.outgoing or self.dialog.subscribing:
            while self.dialog.outgoing:
                self.said.append(wire.read_request(self.dialog.outgoing.popleft()))
            while self.dialog.subscribing:
                topic, on = self.dialog.subscribing.popleft()
                if on and topic.startswith(topics.ECHO) and self.dialog.connected:
                    self.dialog.hear(topic + b'\n{"on":"echo"}', self.now)

    def reply(self, kind: type[Any], **fields: Any) -> None:
        """Answers the last request of that kind."""
        asked = [one for one in self.said if replies.REPLIES[type(one)] is kind][-1]
        self.dialog.receive(wire.encode(kind(id=asked.id, **fields)), self.now)
        self._turn()

    def come(self, *effects: Any, runtime: str = "a", resumed: bool = False) -> None:
        """The core is there and tells what is outstanding."""
        self.now += 1
        self._turn()
        self.reply(
            replies.Welcome,
            session="s",
            resumed=resumed,
            runtime=runtime,
            version=1,
            heartbeat=0.25,
            lease=LEASE,
            project="x",
            addresses=Addresses("tcp://0.0.0.0:5570", "tcp://0.0.0.0:5571"),
            time=0,
            seq=0,
        )
        watches = [one for one in self.said if isinstance(one, protocol.Watch)]
        entry = replies.Entry("de", 1, "ann", 0)
        for watch in watches[-1:]:
            reply = replies.Snapshot(id=watch.id, entries={"language": entry}, changes={})
            self.dialog.receive(wire.encode(reply), self.now)
        self.reply(replies.Outstanding, effects=effects, next=dict.fromkeys(SERVICES, 1))
        self.deliver()

    def change(self, tag: str, value: Any, version: int) -> None:
        notice = notices.Change(tag=tag, value=value, version=version, writer="desk", time=0)
        self.dialog.hear(wire.notice(topics.change(tag), notice), self.now)
        self.deliver()

    def give(self, service: str, number: int, does: Any) -> None:
        notice = notices.Effect(service=service, number=number, does=does)
        self.dialog.hear(wire.notice(topics.effect(service), notice), self.now)
        self._turn()
        self.deliver()

    def deliver(self) -> None:
        while (item := self._effects.take()) is not None:
            self._callback(item)
        for feed in self.dialog.following():
            callback: Callable[[Any], None] | None = feed.callback
            while callback is not None and (change := feed.take()) is not None:
                callback(change)

    def go(self) -> None:
        """Nothing is heard of the core for a lease."""
        self.now += LEASE
        self._turn()


class Far:
    def __init__(self, *services: str) -> None:
        self.board = FarBoard(*services)
        self.recorders: list[Recorder] = []
        self.apart = ServicesApart(cast(AsyncBoard, self.board), services or SERVICES, self._make)
        asyncio.run(self.apart.start())

    def _make(self, submit: Any, tag: Any) -> Recorder:
        self.recorders.append(Recorder(submit, tag))
        return self.recorders[-1]

    @property
    def recorder(self) -> Recorder:
        return self.recorders[0]


@pytest.fixture
def far(monkeypatch: pytest.MonkeyPatch) -> Far:
    # The addresses are those of the core's greeting, which comes later here.
    monkeypatch.setattr(ServicesApart, "_addresses", lambda self: Addresses("", ""))
    return Far()


def base(value: Any, *actions: int) -> Map:
    return Map("base", "nod", value, actions)


def speech(value: Any, *actions: int) -> Map:
    return Map("speech", "desk", value, actions)


def begin(number: int, action: str = "service") -> Begin:
    return Begin(number, "desk", action, "ask", {"url": "http://x/"})


def test_what_is_outstanding_is_carried_out_and_then_each_effect(far: Far) -> None:
    far.board.come(base({"vx": 1}), speech(HELLO, 4), begin(5))
    assert far.recorder.take() == [base({"vx": 1}), speech(HELLO, 4), begin(5)]
    far.board.give("robot", 1, base(None))
    far.board.give("engine", 1, Cancel(5))
    assert far.recorder.take() == [base(None), Cancel(5)]
    assert far.recorder.tag("language") == "de"
    assert far.recorder.tag("speech.rate") is None


def test_what_runs_goes_on_when_an_effect_was_lost(far: Far) -> None:
    far.board.come(speech(HELLO, 4), begin(5), begin(6))
    far.recorder.take()
    far.board.give("robot", 2, base({"vx": 1}))
    assert far.recorder.take() == []
    far.board.reply(
        replies.Outstanding,
        effects=(speech(HELLO, 4), base({"vx": 1}), begin(6), begin(7)),
        next={"engine": 3, "robot": 3, "screen": 1},
    )
    far.board.deliver()
    assert far.recorder.take() == [Cancel(5), base({"vx": 1}), begin(7)]


def test_a_robot_that_hears_nothing_of_its_core_holds_and_goes_on_when_it_is_back(
    far: Far,
) -> None:
    far.board.come(base({"vx": 1}), speech(HELLO, 4))
    far.recorder.take()
    far.board.go()
    assert far.recorder.take() == ["hold"]
    far.board.come(base({"vx": 1}), speech(HELLO, 4), resumed=True)
    assert far.recorder.take() == [base({"vx": 1})]


def test_a_core_that_stops_holds_the_robot_at_once(far: Far) -> None:
    far.board.come(base({"vx": 1}))
    far.recorder.take()
    far.board.dialog.hear(topics.END + wire.encode(notices.End()), far.board.now)
    assert far.recorder.take() == ["hold"]
    # What was still on its way is no longer meant.
    far.board._callback(base({"vx": 2}))
    assert far.recorder.take() == []


def test_a_core_that_refuses_is_told_of_once_and_the_robot_holds_once(
    far: Far, caplog: pytest.LogCaptureFixture
) -> None:
    far.board.come(base({"vx": 1}))
    far.recorder.take()
    for _ in range(3):
        far.board.go()
        hello = [one for one in far.board.said if isinstance(one, protocol.Hello)][-1]
        refused = replies.Refused(id=hello.id, code="name", message="robot is taken")
        far.board.dialog.receive(wire.encode(refused), far.board.now)
    assert far.recorder.take() == ["hold"]
    told = [record.getMessage() for record in caplog.records]
    assert told == [
        "tcp://192.0.2.1:5570: without the core: it does not answer",
        "tcp://192.0.2.1:5570: without the core: robot is taken",
    ]
    far.board.come(base({"vx": 1}))
    assert far.recorder.take() == [base({"vx": 1})]


def test_without_a_robot_nothing_is_held(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ServicesApart, "_addresses", lambda self: Addresses("", ""))
    far = Far("engine")
    far.board.come(speech(HELLO, 4))
    far.recorder.take()
    far.board.go()
    assert far.recorder.take() == []


def test_of_a_core_that_began_anew_nothing_of_before_is_left(far: Far) -> None:
    far.board.come(base({"vx": 1}), begin(5))
    far.board.go()
    far.recorder.take()
    far.recorder.submit(inputs.Finish(id=5))
    far.board.said.clear()
    far.board.come(base({"vx": 1}), begin(5), runtime="b")
    assert far.recorder.take() == [Cancel(5), base({"vx": 1}), begin(5)]
    # The end of the old action would be taken for that of the new one.
    assert not [one for one in far.board.said if isinstance(one, protocol.Finish)]


def test_ends_wait_for_the_core_and_touches_do_not(far: Far) -> None:
    far.board.come(begin(5))
    far.board.go()
    far.recorder.submit(inputs.Finish(id=5, ok=False, error="no", status=None))
    far.recorder.submit(inputs.Set({"pose.base": [0, 0, 0]}, "sim"))
    far.recorder.submit(inputs.Touch())
    far.recorder.submit(inputs.Attend())
    far.recorder.submit(inputs.Use("go"))
    far.board.said.clear()
    far.board.come(begin(5), resumed=True)
    told = [type(one) for one in far.board.said]
    assert told.count(protocol.Finish) == told.count(protocol.Set) == 1
    assert not {protocol.Touch, protocol.Attend, protocol.Use}.intersection(told)
    (finish,) = [one for one in far.board.said if isinstance(one, protocol.Finish)]
    assert (finish.action_id, finish.ok, finish.error, finish.status) == (5, False, "no", None)
    # It had ended here already: it is not begun again.
    assert begin(5) not in far.recorder.take()[1:]


def test_what_people_do_is_told(far: Far) -> None:
    far.board.come()
    far.board.said.clear()
    for given in (inputs.Use("go"), inputs.Use("name", "Ann"), inputs.Touch(), inputs.Attend()):
        far.recorder.submit(given)
    assert [type(one) for one in far.board.said if not isinstance(one, protocol.Heartbeat)] == [
        protocol.Use,
        protocol.Use,
        protocol.Touch,
        protocol.Attend,
    ]


def test_the_end_of_what_was_never_given_is_passed_over(far: Far) -> None:
    far.board.come(begin(5))
    far.board.said.clear()
    far.recorder.submit(inputs.Finish(id=6))
    assert [one for one in far.board.said if isinstance(one, protocol.Finish)] == []


def test_a_screen_whose_engine_is_elsewhere_tells_what_is_being_said(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(ServicesApart, "_addresses", lambda self: Addresses("", ""))
    far = Far("screen")
    far.board.come()
    far.board.change("robot/speech", HELLO, 1)
    far.board.change("robot/speech", None, 2)
    assert far.recorder.take() == [("caption", HELLO), ("caption", None)]
