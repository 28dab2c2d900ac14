"""What the robot decides, beside the plainest code that could and beside known libraries.

The workloads and the floors are those of ``decisions``.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from tests.benchmarks import decisions
from tests.benchmarks.harness import CPU, Bench, Goal, Row, Sample, each, library, rate

SIZES = (10, 100, 1_000, 10_000)
LARGEST = SIZES[-1]

TOLD: dict[decisions.Kind, str] = {
    "own": "a few flip",
    "thresholds": "all at one tag, thresholds",
    "equality": "all at one tag, equality",
    "half": "half of them hold",
}


def _ours(kind: decisions.Kind, size: int) -> str:
    return f"N = {size:,}, {TOLD[kind]}"


def _situation_rows() -> Iterator[Row]:
    for kind in decisions.KINDS:
        name = f"situations, {TOLD[kind]}"
        ours = _ours(kind, LARGEST)
        small = _ours(kind, SIZES[0])
        yield Row(f"{name}: N = 10,000 beside 10", "situations", ours, small, "µs", Goal(2.0))
        goal = Goal(10.0, of="ours")
        yield Row(f"{name}: N = 10,000", "situations", ours, "tag index, heap", "µs", goal)
    for size in SIZES[1:-1]:
        ours, small = _ours("own", size), _ours("own", SIZES[0])
        yield Row(
            f"situations, a few flip: N = {size:,} beside 10", "situations", ours, small, "µs"
        )
    for other in ("py_trees", "CLIPS"):
        ours, goal = _ours("own", LARGEST), Goal(1.0)
        yield Row(f"situations: N = 10,000 beside {other}", "situations", ours, other, "µs", goal)


@contextlib.contextmanager
def _situations() -> Iterator[Mapping[str, Sample]]:
    samples: dict[str, Sample] = {}
    for kind in decisions.KINDS:
        for size in SIZES if kind == "own" else (SIZES[0], LARGEST):
            samples[_ours(kind, size)] = each(_deciding(kind, size), CPU)
    samples["tag index, heap"] = each(decisions.situations_floor(LARGEST), CPU)
    samples["py_trees"] = each(_tree(LARGEST), CPU)
    with _rules(LARGEST) as rules:
        samples["CLIPS"] = each(rules, CPU)
        yield samples


def _deciding(kind: decisions.Kind, size: int) -> Callable[[int], None]:
    robot, given = decisions.situations_robot(kind, size), decisions.flips(kind, size)
    return lambda times: decisions.situations_ours(robot, given, times)


def _tree(size: int) -> Callable[[int], None]:
    """A selector over as many conditions, which py_trees ticks from the first to one that holds."""
    py_trees = library("py_trees")
    base: Any = py_trees.behaviour.Behaviour
    status = py_trees.common.Status
    board: dict[str, bool] = {}

    class Holds(base):  # type: ignore[misc]  # library() is untyped
        def update(self) -> Any:
            return status.SUCCESS if board.get(self.name) else status.FAILURE

    root = py_trees.composites.Selector(
        "script", memory=False, children=[Holds(f"t{number}") for number in range(size)]
    )
    root.add_child(py_trees.behaviours.Success("rest"))
    tag = f"t{size // 2}"

    def flips(times: int) -> None:
        for time in range(times):
            board[tag] = time % 2 == 0
            root.tick_once()

    return flips


@contextlib.contextmanager
def _rules(size: int) -> Iterator[Callable[[int], None]]:
    """A rule a situation, the salience its precedence; a fact that comes and goes."""
    environment = library("clips").Environment()
    environment.build("(defglobal ?*current* = -1)")
    for number in range(size):
        environment.build(f"(deftemplate t{number} (slot on))")
        environment.build(
            f"(defrule s{number} (declare (salience {size // 2 - number})) (t{number} (on TRUE)) "
            f"=> (bind ?*current* {number}))"
        )
    tags = [f"(t{number} (on TRUE))" for number in (size // 2, size // 2 + 1)]

    def flips(times: int) -> None:
        fact = None
        for time in range(times):
            if fact is None:
                fact = environment.assert_string(tags[time // 2 % 2])
            else:
                fact = fact.retract()
            environment.run()
        if fact is not None:
            fact.retract()

    yield flips
    environment.clear()


# -- event -> transition -----------------------------------------------------

LOOP = "a dict loop"


@contextlib.contextmanager
def _transitions() -> Iterator[Mapping[str, Sample]]:
    robot = decisions.flow_robot()
    yield {
        "Robot.step": rate(lambda times: decisions.flow_ours(robot, times), CPU),
        LOOP: rate(decisions.flow_loop, CPU),
        "transitions": rate(_transitions_library(), CPU),
        "python-statemachine": rate(_statemachine(), CPU),
    }


def _transitions_library() -> Callable[[int], None]:
    class Model:
        go: Callable[[], bool]

        def __init__(self) -> None:
            self.board: dict[str, Any] = {"ready": True}

        def ready(self) -> bool:
            return self.board["ready"] is True

        def to_one(self) -> None:
            self.board["last"] = 1

        def to_two(self) -> None:
            self.board["last"] = 2

    model = Model()
    machine = library("transitions").Machine(
        model, states=["1", "2"], initial="1", auto_transitions=False
    )
    machine.add_transition("go", "1", "2", conditions="ready", before="to_two")
    machine.add_transition("go", "2", "1", conditions="ready", before="to_one")

    def go(times: int) -> None:
        for _ in range(times):
            model.go()

    return go


def _statemachine() -> Callable[[int], None]:
    statemachine = library("statemachine")
    base: Any = statemachine.StateMachine
    board: dict[str, Any] = {"ready": True}

    class Flow(base):  # type: ignore[misc]  # library() is untyped
        one = statemachine.State(initial=True)
        two = statemachine.State()
        go = one.to(two, cond="ready", on="to_two") | two.to(one, cond="ready", on="to_one")

        def ready(self) -> bool:
            return board["ready"] is True

        def to_one(self) -> None:
            board["last"] = 1

        def to_two(self) -> None:
            board["last"] = 2

    flow = Flow()

    def go(times: int) -> None:
        for _ in range(times):
            flow.send("go")

    return go


BENCHES = (
    Bench("situations", tuple(_situation_rows()), _situations),
    Bench(
        "fsm",
        (
            Row(
                "event to transition, guard, action, trace",
                "transitions",
                "Robot.step",
                LOOP,
                "k/s",
                Goal(0.1, least=True),
            ),
            *(
                Row(
                    f"event to transition beside {other}",
                    "transitions",
                    "Robot.step",
                    other,
                    "k/s",
                    Goal(1.0, least=True),
                )
                for other in ("transitions", "python-statemachine")
            ),
        ),
        _transitions,
    ),
)
