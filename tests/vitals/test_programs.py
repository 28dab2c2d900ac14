"""The video program of examples/vitals, and that the robot may start it."""

from __future__ import annotations

import random
import runpy
import tomllib
from pathlib import Path

VITALS = Path(__file__).resolve().parents[2] / "examples" / "vitals"


def test_a_call_ends_in_each_way_and_by_its_seed() -> None:
    called = runpy.run_path(str(VITALS / "programs" / "video_call.py"))["called"]
    every = [called(random.Random(seed)) for seed in range(60)]
    assert every == [called(random.Random(seed)) for seed in range(60)]
    assert {answer.value for answer, _ in every} == {"taken", "busy", "nobody"}
    assert all(0 < seconds <= 40 for _, seconds in every)


def test_the_robot_may_start_it_and_a_list_that_is_there_stays(tmp_path: Path) -> None:
    allow = runpy.run_path(str(VITALS / "start.py"))["allow"]
    file = tmp_path / "launch.toml"
    allow(tmp_path)
    (program,) = tomllib.loads(file.read_text("utf-8")).values()
    assert Path(program[1]).is_file()
    assert program[2:] == ["{address}"]
    file.write_text("other = []\n", "utf-8")
    allow(tmp_path)
    assert file.read_text("utf-8") == "other = []\n"
