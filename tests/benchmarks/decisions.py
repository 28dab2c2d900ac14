"""The robot's decisions, and the plain floors beside them (quality.md, *Speed and scale*).

Every function here makes or drives a workload and measures nothing: whoever calls it
brings the clock. ``ours`` always goes through ``Robot.step`` with its whole trace.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable
from typing import Any, Literal

from situ.decide.inputs import Acquire, AnyInput, Raise, Start
from situ.decide.inputs import Set as SetInput
from situ.decide.robot import Robot
from situ.document.condition import Condition, Test
from situ.document.project import Project
from situ.document.rbd import Application, Event, Set, State
from situ.document.spds import Declaration, Entry, Situation, Spds

# -- event -> transition with guard, action and trace ------------------------

READY = Condition((Test("ready", "is", "true"),))


def flow_robot() -> Robot:
    """Two states that ``go`` leads between, guarded by a tag; each way sets another tag."""

    def state(no: str, to: str) -> State:
        went = Event("go", to, when=READY, actions=(Set(tag="last", text=to),))
        return State(no=no, events=(went,))

    application = Application("app", "1", None, (state("1", "2"), state("2", "1")))
    robot = Robot(
        Project(
            root=".",
            name="flow",
            applications={"app.rbd.xml": application},
            tags={"ready": True},
        )
    )
    robot.step(Start(), 0)
    return robot


def flow_ours(robot: Robot, count: int) -> None:
    """``count`` events, each a transition with its guard, its action and its trace."""
    step, go = robot.step, Raise("go")
    for now in range(1, count + 1):
        step(go, now)


def flow_loop(count: int) -> dict[str, Any]:
    """The same guard and action in a loop over a dict, without any trace."""
    board: dict[str, Any] = {"ready": True, "last": 0}

    def ready() -> bool:
        return board["ready"] is True

    def to_one() -> None:
        board["last"] = 1

    def to_two() -> None:
        board["last"] = 2

    table = {"1": {"go": (ready, to_two, "2")}, "2": {"go": (ready, to_one, "1")}}
    at = "1"
    for _ in range(count):
        guard, action, to = table[at]["go"]
        if guard():
            action()
            at = to
    return board


# -- changed datum -> situation -> authority ---------------------------------

Kind = Literal["own", "thresholds", "equality", "half"]
"""What N situations look at: each at a tag of its own; all at one tag, as thresholds or as
values; each at a tag of its own with half of them holding.
"""

KINDS: tuple[Kind, ...] = ("own", "thresholds", "equality", "half")


def situations_robot(kind: Kind, count: int) -> Robot:
    """A robot of ``count`` situations and one that always holds. ``a`` may have the arm in
    every second one, ``b`` in the others, so that most changes hand the arm over. ``flips`` have
    been given once.
    """
    made = [_situation(kind, number, count) for number in range(count)]
    rest = Situation("rest", entries=(Entry("rest", 1),))
    modules = tuple(Declaration(name, ("arm",)) for name in ("a", "b", "rest"))
    tags = {f"t{number}": True for number in range(1, count, 2)} if kind == "half" else {}
    robot = Robot(
        Project(
            root=".",
            name="situations",
            spds=Spds("script", (), modules, (*made, rest)),
            tags=tags,
        )
    )
    robot.step(Start(), 0)
    for name in ("a", "b", "rest"):
        robot.step(Acquire(name, ("arm",)), 1)
    # The first value flips half of all thresholds; what is measured flips one or two.
    for given in flips(kind, count):
        robot.step(given, 1)
    return robot


def _situation(kind: Kind, number: int, count: int) -> Situation:
    if kind == "thresholds":
        # The highest first: the situation whose threshold was passed last is current.
        test = Test("x", "above", str(count - number))
    elif kind == "equality":
        test = Test("x", "is", str(number))
    else:
        test = Test(f"t{number}", "is", "true")
    entry = Entry("a" if number % 2 else "b", 1)
    return Situation(f"s{number}", condition=Condition((test,)), entries=(entry,))


def flips(kind: Kind, count: int) -> list[AnyInput]:
    """Inputs of which each changes the truth of one or two conditions, and with it the
    situation and who has the arm; repeated from the first, they go on doing so.
    """
    middle = count // 2
    if kind == "thresholds":
        return [SetInput({"x": x}, "m") for x in (middle + 0.5, middle + 1.5)]
    if kind == "equality":
        return [SetInput({"x": x}, "m") for x in (middle, middle + 1)]
    if kind == "half":
        # The first that holds, and one of the rest further on, both ways.
        first, later = "t1", f"t{middle | 1}"
        return [SetInput({tag: on}, "m") for on in (False, True) for tag in (first, later)]
    tags = [f"t{number}" for number in (middle, middle + 1)]
    return [SetInput({tag: on}, "m") for tag in tags for on in (True, False)]


def situations_ours(robot: Robot, given: list[AnyInput], count: int) -> None:
    """``count`` inputs, one after the other, over and over."""
    step, many = robot.step, len(given)
    for number in range(count):
        step(given[number % many], 2 + number)


def situations_floor(count: int) -> Callable[[int], None]:
    """A tag index with a heap of what holds, without trace, board or authority.

    Gives a function that flips one of ``count`` situations as often as it is told.
    """
    holds = [False] * count
    listed = [False] * count
    index = {f"t{number}": number for number in range(count)}
    heap: list[int] = []
    tags = [f"t{number}" for number in (count // 2, count // 2 + 1)]
    writes = [(tag, on) for tag in tags for on in (True, False)]

    def flip(times: int) -> None:
        for time in range(times):
            tag, on = writes[time % 4]
            number = index[tag]
            holds[number] = on
            if on and not listed[number]:
                listed[number] = True
                heapq.heappush(heap, number)
            while heap and not holds[heap[0]]:
                listed[heapq.heappop(heap)] = False

    return flip
