"""What a search could not decide in the time given is told as that, and nothing is guessed."""

from __future__ import annotations

from pathlib import Path

import pytest

from situ.document.check import check
from situ.document.folder import load
from situ.document.problem import Problem

APPLICATION = """\
<application name="a"><state no="1"><timeout next="2">5</timeout><expectedevents>
<event name="e" next="2"><when><data tag="x" above="3"/><data tag="x" below="{y}"/></when></event>
<event next="2"><when><data tag="x" above="3"/><data tag="x" below="1"/></when></event>
</expectedevents></state><state no="2" final="true"/></application>
"""
SCRIPT = """\
<spds name="s"><observe><data tag="x"/></observe>
<situation name="far"><condition><data tag="x" above="3"/></condition></situation>
<situation name="farther"><condition><data tag="x" above="5"/></condition></situation>
<situation name="ends"><condition><data tag="x" is="1"/></condition>
<until><data tag="x" exists="true"/></until></situation>
<situation name="day"/></spds>
"""
CLAIMS = {"never-holds", "event-never-taken", "shadowed-situation", "livelock"}


@pytest.fixture
def problems(tmp_path: Path) -> list[Problem]:
    return found(tmp_path)


def found(folder: Path) -> list[Problem]:
    (folder / "a.rbd.xml").write_text(APPLICATION)
    (folder / "s.spds.xml").write_text(SCRIPT)
    listed = []
    for name in ("a.rbd.xml", "s.spds.xml"):
        project, read = load(folder / name)
        assert project is not None
        listed += [*read, *check(project)]
    return listed


def test_with_time_enough_all_of_it_is_decided(problems: list[Problem]) -> None:
    codes = {problem.code for problem in problems}
    assert {"never-holds", "shadowed-situation"} <= codes
    assert "undecided" not in codes


def test_without_time_nothing_is_claimed_and_every_open_question_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("situ.document.analysis_search.ALLOWANCE", 0)
    problems = found(tmp_path)
    assert not CLAIMS & {problem.code for problem in problems}
    open_ = [problem for problem in problems if problem.code == "undecided"]
    places = {problem.place for problem in open_}
    assert ("state", "1", "event", "0", "when") in places
    assert ("situation", "farther", "condition") in places
    assert ("situation", "ends", "until") in places
    assert all(problem.severity == "warning" and problem.line > 0 for problem in open_)


def test_it_says_what_is_not_known_and_what_to_do(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("situ.document.analysis_search.ALLOWANCE", 0)
    said = [problem.message for problem in found(tmp_path) if problem.code == "undecided"]
    assert all(one.startswith("It is not known whether ") for one in said)
    assert all(one.endswith("or try it out with situ simulate") for one in said)
    assert any("whether this can ever hold" in one for one in said)
    assert any("whether this situation is ever current" in one for one in said)
