"""Problems while one draws: from an edit to the list, and how long the window then waits."""

from __future__ import annotations

import contextlib
import time
from collections.abc import Iterator, Mapping
from typing import Any

from tests.benchmarks import documents
from tests.benchmarks.drawing import qt
from tests.benchmarks.editing import PROJECT
from tests.benchmarks.harness import CPU, Bench, Goal, Row, Sample, each

SIZE = 1_000
WITHIN, FRAME = 200.0, 16.0
"""Milliseconds: studio.md, *Problems while you draw*; a frame at 60 a second."""


@contextlib.contextmanager
def _problems() -> Iterator[Mapping[str, Sample]]:
    """Alternately of two values of a project, so that each is an edit of the one before."""
    from msgspec.structs import replace

    from situ.document.check import check
    from situ.document.folder import load_texts
    from situ_studio.problems.checking import Checker

    data = documents.dialogue(SIZE).decode()
    project, _ = load_texts({"situ.toml": PROJECT, "dialogue.rbd.xml": data})
    assert project is not None
    (file, application), *_ = project.applications.items()
    state = replace(application.states[7], name="another")
    states = (*application.states[:7], state, *application.states[8:])
    other = replace(project, applications={file: replace(application, states=states)})
    values = [project, other]

    def alone(times: int) -> None:
        for turn in range(times):
            check(values[turn % 2])

    with qt() as app:
        checker = Checker()
        found: list[object] = []
        checker.found.connect(lambda *_: found.append(1))

        def longest(work: Any) -> float:
            """The longest turn of the loop, ms, until the problems are there."""
            found.clear()
            most, last = 0.0, time.perf_counter()
            work()
            while not found:
                app.processEvents()
                now = time.perf_counter()
                most, last = max(most, now - last), now
            return 1e3 * most

        def ask(turn: int) -> float:
            return longest(lambda: checker.ask(values[turn % 2]))

        def shown(times: int) -> None:
            for turn in range(times):
                ask(turn)

        ask(1)
        turns = iter(range(1_000_000))
        yield {
            "check": each(alone, CPU, unit=1e-3),
            "shown": each(shown, time.perf_counter, unit=1e-3),
            "longest": lambda: ask(next(turns)),
        }


BENCHES = (
    Bench(
        "problems",
        (
            Row(
                f"editor: problems of {SIZE:,} states after an edit",
                "problems",
                "shown",
                "check",
                "ms",
                Goal(WITHIN, of="ours"),
            ),
            Row(
                f"editor: the window waits for them, {SIZE:,} states",
                "problems",
                "longest",
                "check",
                "ms",
                Goal(FRAME, of="ours"),
            ),
        ),
        _problems,
    ),
)
