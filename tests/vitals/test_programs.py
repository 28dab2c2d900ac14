"""The video program of examples/vitals, and that the robot may start it."""

from __future__ import annotations

import random
import runpy
import sys
import tomllib
from pathlib import Path

import pytest

VITALS = Path(__file__).resolve().parents[2] / "examples" / "vitals"


def test_a_call_ends_in_each_way_and_by_its_seed() -> None:
    called = runpy.run_path(str(VITALS / "programs" / "video_call.py"))["called"]
    every = [called(random.Random(seed)) for seed in range(60)]
    assert every == [called(random.Random(seed)) for seed in range(60)]
    assert {answer.value for answer, _ in every} == {"taken", "busy", "nobody"}
    assert all(0 < seconds <= 40 for _, seconds in every)


def test_nobody_else_looks_into_the_robots_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    main = runpy.run_path(str(VITALS / "start.py"))["main"]
    state = tmp_path / "new" / "vitals"

    class Begun(Exception):
        """The records are the first to make something there."""

    class Records:
        def __enter__(self) -> Records:
            return self

        def __exit__(self, *_: object) -> None: ...

        def python(self, *_: object) -> None:
            (state / "records").mkdir(parents=True, exist_ok=True, mode=0o700)
            raise Begun

    monkeypatch.setitem(main.__globals__, "Programs", Records)
    monkeypatch.setattr(sys, "argv", ["start.py", "--state", str(state)])
    with pytest.raises(Begun):
        main()
    assert state.stat().st_mode & 0o077 == 0


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
