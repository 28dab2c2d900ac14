"""Programs: only those on the robot's list, ended with the state that started them."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Callable, Coroutine
from pathlib import Path
from typing import Any

import pytest

from situ.decide.effects import Begin, Cancel

Program = Callable[[str, str], Path]


def begin(name: str = "game", **params: Any) -> Begin:
    return Begin(7, "reception", "launch", name, {"program": name, "params": params})


def allow(situation: Any, *argv: str | Path) -> None:
    listed = json.dumps([str(part) for part in argv])
    (situation.state / "launch.toml").write_text(f"game = {listed}\n", "utf-8")


def run(situation: Any, effect: Begin) -> Any:
    async def scenario() -> Any:
        async with situation.side() as side:
            side.performer.perform(effect)
            return await side.answers.finish(7)

    return asyncio.run(scenario())


def test_a_listed_program_gets_its_params_and_is_done_when_it_ends(
    situation: Any, program: Program
) -> None:
    game = program("game", 'printf "%s|" "$@" > "$0.args"')
    allow(situation, game, "--full", "--level={level}", "{who}", "{missing}")
    finish = run(situation, begin(level=2, who="Ann; rm -rf /", unlisted="x"))
    assert finish.ok
    assert Path(f"{game}.args").read_text("utf-8") == "--full|--level=2|Ann; rm -rf /||"


@pytest.mark.parametrize(
    ("script", "words"), [("exit 3", "exit status 3"), ("kill -9 $$", "SIGKILL")]
)
def test_a_program_that_ends_badly_fails(
    situation: Any, program: Program, script: str, words: str
) -> None:
    allow(situation, program("game", script))
    finish = run(situation, begin())
    assert not finish.ok
    assert words in str(finish.error)


def test_a_program_that_is_not_on_the_list_fails(situation: Any) -> None:
    assert "launch.toml" in str(run(situation, begin()).error)
    allow(situation, "/bin/true")
    finish = run(situation, begin("/bin/true"))
    assert not finish.ok
    assert "is not listed" in str(finish.error)


def test_without_a_state_folder_nothing_may_be_launched(situation: Any) -> None:
    async def scenario() -> None:
        async with situation.side(state_dir=None) as side:
            side.performer.perform(begin())
            assert "may not be started" in str((await side.answers.finish(7)).error)

    asyncio.run(scenario())


@pytest.mark.parametrize("value", ["--evil", "a\x00b"])
def test_a_param_never_becomes_an_option(situation: Any, value: str) -> None:
    allow(situation, "/bin/true", "{level}")
    assert "may not be" in str(run(situation, begin(level=value)).error)


@pytest.mark.parametrize("listed", ["game = 3", "game = [", 'game = [""]', "game = []"])
def test_a_broken_list_fails_in_one_line(situation: Any, listed: str) -> None:
    (situation.state / "launch.toml").write_text(listed, "utf-8")
    finish = run(situation, begin())
    assert not finish.ok
    assert "\n" not in str(finish.error)


@pytest.mark.parametrize("how", ["cancel", "close"])
@pytest.mark.parametrize("stubborn", ["nobody", "child", "all"])
def test_a_cancelled_program_is_ended_with_all_that_it_started(
    situation: Any,
    program: Program,
    monkeypatch: pytest.MonkeyPatch,
    started: Any,
    ended: Callable[[int], Coroutine[Any, Any, None]],
    how: str,
    stubborn: str,
) -> None:
    monkeypatch.setattr("situ.engine.actions.launch.GRACE", 0.1)
    deaf = "trap '' TERM;"
    starts = f"({deaf if stubborn == 'child' else ''} exec sleep 1000) & echo $! > $0.child"
    told = f"echo $$ > {started.path}; wait; wait; wait"
    game = program("game", f"{deaf if stubborn == 'all' else ''} {starts}; {told}")
    allow(situation, game)
    pids: list[int] = []

    async def scenario() -> None:
        async with situation.side() as side:
            side.performer.perform(begin())
            pids.append(await started.pid())
            if how == "cancel":
                side.performer.perform(Cancel(7))
        assert side.answers.inputs == []

    asyncio.run(scenario())
    pids.append(int(Path(f"{game}.child").read_text("utf-8")))
    for pid in pids:
        asyncio.run(ended(pid))
