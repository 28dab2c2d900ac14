"""What the table of ``make bench`` says: the arithmetic, with samples that cost no time."""

from __future__ import annotations

import contextlib
import json
import re
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

import pytest
from tests.benchmarks import __main__ as program
from tests.benchmarks.harness import (
    LONG,
    Bench,
    Goal,
    Missing,
    Row,
    Sample,
    each,
    library,
    measure,
    rate,
    table,
)

DOCUMENT = Path(__file__).resolve().parents[2] / "docs" / "performance.md"


class Figures:
    """A sample that gives one figure after the other, and notes when it was asked."""

    def __init__(self, name: str, figures: list[float], asked: list[str]) -> None:
        self.name = name
        self.left = list(figures)
        self.asked = asked

    def __call__(self) -> float:
        self.asked.append(self.name)
        return self.left.pop(0)


def bench(
    ours: list[float], beside: list[float], goal: Goal | None = None, asked: list[str] | None = None
) -> Bench:
    """A bench of one row; the first figure of each is that of the time before the rounds."""
    asked = asked if asked is not None else []

    @contextlib.contextmanager
    def opened() -> Iterator[Mapping[str, Sample]]:
        yield {"ours": Figures("ours", ours, asked), "floor": Figures("floor", beside, asked)}

    return Bench("one", (Row("a row", "get", "ours", "floor", "µs", goal),), opened)


class Clock:
    """Time that only passes while work is done."""

    def __init__(self) -> None:
        self.now = 100.0

    def __call__(self) -> float:
        return self.now

    def work(self, seconds: float, done: list[int]) -> Callable[[int], None]:
        def work(times: int) -> None:
            done.append(times)
            self.now += seconds * times

        return work


def test_the_ratio_is_that_of_the_medians_and_the_spread_that_of_the_rounds() -> None:
    (result,) = measure(bench([0, 2, 4, 6, 8, 100], [0, 1, 4, 2, 2, 10]), 5)
    assert (result.ours, result.beside, result.ratio) == (6, 2, 3)
    assert (result.minimum, result.median, result.maximum) == (1, 3, 10)
    assert result.rounds == 5
    assert (result.goal, result.met) == (None, None)


def test_what_is_measured_before_the_rounds_does_not_count() -> None:
    (result,) = measure(bench([1e9, *[3] * 5], [1e-9, *[1] * 5]), 5)
    assert (result.ratio, result.maximum) == (3, 3)


def test_all_are_measured_in_every_round_in_turning_order() -> None:
    asked: list[str] = []
    measure(bench([1] * 6, [1] * 6, asked=asked), 5)
    assert asked == ["ours", "floor"] + ["ours", "floor", "floor", "ours"] * 2 + ["ours", "floor"]


def test_fewer_than_five_rounds_are_refused() -> None:
    with pytest.raises(ValueError, match="at least 5"):
        measure(bench([1] * 5, [1] * 5), 4)


@pytest.mark.parametrize(
    ("goal", "ours", "beside", "met", "told"),
    [
        (Goal(1.25), 125, 100, True, "≤ 1.25 ×"),
        (Goal(1.25), 126, 100, False, "≤ 1.25 ×"),
        (Goal(0.5, least=True), 50, 100, True, "≥ 0.5 ×"),
        (Goal(0.5, least=True), 49, 100, False, "≥ 0.5 ×"),
        (Goal(10, of="ours"), 10, 0.1, True, "≤ 10 µs"),
        (Goal(10, of="ours"), 11, 100, False, "≤ 10 µs"),
        (Goal(30, of="more"), 50, 20, True, "≤ beside + 30 µs"),
        (Goal(30, of="more"), 51, 20, False, "≤ beside + 30 µs"),
    ],
)
def test_a_goal_bounds_the_ratio_ours_or_what_ours_is_more(
    goal: Goal, ours: float, beside: float, met: bool, told: str
) -> None:
    (result,) = measure(bench([ours] * 6, [beside] * 6, goal), 5)
    assert (result.met, result.goal) == (met, told)


def test_as_many_are_done_in_every_round_as_take_long_enough() -> None:
    clock, done = Clock(), list[int]()
    sample = each(clock.work(0.001, done), clock)
    assert sample() == pytest.approx(1000)
    assert done[:-1] == [1, 2, 4, 8]
    assert LONG <= done[-1] * 0.001 < 1.1 * LONG
    sample()
    sample()
    assert done[-3:] == [done[-1]] * 3


def test_what_takes_longer_than_a_sample_is_done_once() -> None:
    clock, done = Clock(), list[int]()
    assert each(clock.work(2.5, done), clock, 1e-3)() == pytest.approx(2500)
    assert set(done) == {1}


def test_a_rate_is_thousands_a_second() -> None:
    clock = Clock()
    assert rate(clock.work(0.001, []), clock)() == pytest.approx(1)
    assert rate(clock.work(0.001, []), clock, 5000)() == pytest.approx(5000)


def test_what_is_missing_is_named() -> None:
    with pytest.raises(Missing, match="nothing_of_that_name is not installed; make bench"):
        library("nothing_of_that_name")


def test_the_table_has_units_ratio_goal_and_whether_it_is_met() -> None:
    one = measure(bench([2500] * 6, [1000] * 6, Goal(1.25)), 5)
    other = measure(bench([0.25] * 6, [1000] * 6), 5)
    assert table([*one, *other]).splitlines()[2:] == [
        "| a row | 2,500 µs | 1,000 µs: floor | 2.5 (2.5 to 2.5) | ≤ 1.25 × | no |",
        "| a row | 0.25 µs | 1,000 µs: floor | 0.00025 (0.00025 to 0.00025) |  |  |",
    ]


def run(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, benches: list[Bench], *arguments: str
) -> tuple[int, list[dict[str, object]]]:
    """The exit status of the program with these benches, and what it wrote."""
    monkeypatch.setattr(program, "BENCHES", tuple(benches))
    file = tmp_path / "bench.json"
    status = program.main(["--json", str(file), "--rounds", "5", *arguments])
    return status, json.loads(file.read_bytes())


def test_bench_json_is_a_list_of_results(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    status, (result,) = run(monkeypatch, tmp_path, [bench([3] * 6, [2] * 6, Goal(1.25))])
    assert status == 0
    assert result == {
        "name": "a row",
        "ours": 3,
        "beside": 2,
        "ratio": 1.5,
        "goal": "≤ 1.25 ×",
        "met": False,
        "min": 1.5,
        "median": 1.5,
        "max": 1.5,
        "rounds": 5,
        "unit": "µs",
        "against": "floor",
    }
    assert "| a row | 3 µs |" in capsys.readouterr().out


def broken(error: Exception | None) -> Bench:
    @contextlib.contextmanager
    def opened() -> Iterator[Mapping[str, Sample]]:
        if error is not None:
            raise error
        yield {}

    return Bench("two", (Row("another row", "get", "ours", "floor", "µs"),), opened)


def test_what_is_missing_is_left_out_with_its_reason(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    benches = [broken(Missing("there is no redis-server")), bench([3] * 6, [2] * 6)]
    status, results = run(monkeypatch, tmp_path, benches)
    assert (status, [result["name"] for result in results]) == (0, ["a row"])
    assert "two: left out: there is no redis-server" in capsys.readouterr().err


def test_what_fails_is_told_and_the_others_are_measured(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    benches = [broken(RuntimeError("says nothing")), bench([3] * 6, [2] * 6)]
    status, results = run(monkeypatch, tmp_path, benches)
    assert (status, [result["name"] for result in results]) == (1, ["a row"])
    assert "two: RuntimeError: says nothing" in capsys.readouterr().err


def test_a_word_selects_by_the_names_of_benches_and_rows(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    benches = [broken(RuntimeError("not to be opened")), bench([3] * 6, [2] * 6)]
    status, results = run(monkeypatch, tmp_path, benches, "-k", "A row")
    assert (status, len(results)) == (0, 1)


def test_every_figure_has_a_row_or_is_named_as_not_built() -> None:
    rows = [row for bench in program.BENCHES for row in bench.rows]
    assert {row.of for row in rows} | program.UNBUILT.keys() == set(program.FIGURES)
    assert not {row.of for row in rows} & program.UNBUILT.keys()
    names = [row.name for row in rows]
    assert len(set(names)) == len(names)


def test_the_page_has_every_row_and_names_what_is_not_built() -> None:
    text = DOCUMENT.read_text("utf-8")
    told = [re.sub(r" \(situ run[^)]*\)", "", line) for line in text.splitlines()]
    for bench in program.BENCHES:
        for row in bench.rows:
            name = re.sub(r" \(situ run[^)]*\)", "", row.name)
            assert any(line.startswith(f"| {name} |") for line in told), row.name
    for unbuilt in program.UNBUILT.values():
        assert unbuilt in text
