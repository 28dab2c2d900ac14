"""Mends of the settings' files where one of them can not be made, or is made already."""

from __future__ import annotations

from pathlib import Path

import pytest

from situ.document import fix as fixing
from situ.document import folder
from situ.document.beside import Toml
from situ.document.check import check, merge
from situ.document.fix import fix
from situ.document.mend import Stale
from situ.document.mend_toml import apply, every
from situ.document.problem import Mend, Problem

BEGIN = '[project]\nname = "p"\n'
SPEAKING = (
    '<application name="{0}"><state no="1" final="true"><backgroundactions>'
    '<set tag="language">ja</set></backgroundactions></state></application>'
)


def found(ward: Path) -> list[Problem]:
    project, read = folder.load(ward)
    assert project is not None
    return merge(read, check(project))


def speaking(ward: Path, languages: str) -> list[Problem]:
    """What is said where two applications choose a language that the project does not have."""
    for name in "ab":
        (ward / f"{name}.rbd.xml").write_text(SPEAKING.format(name))
    named = 'applications = ["a.rbd.xml", "b.rbd.xml"]\n'
    (ward / "situ.toml").write_text(f"{BEGIN}{named}{languages}")
    return [one for one in found(ward) if one.code == "language-without-texts"]


def mend_of(problem: Problem) -> Mend:
    assert problem.mend is not None
    return problem.mend


def test_what_two_documents_ask_of_the_settings_is_done_once(tmp_path: Path) -> None:
    asked = speaking(tmp_path, 'languages = ["en"]\n')
    assert len(asked) == 2
    before = Toml((tmp_path / "situ.toml").read_text())
    after, mended = every({"situ.toml": before}, asked)
    assert mended == asked
    assert 'languages = ["en", "ja"]\n' in after["situ.toml"].text


def test_an_entry_is_put_in_only_where_it_is_not_yet_and_its_position_is(tmp_path: Path) -> None:
    mend = mend_of(speaking(tmp_path, 'languages = ["en", "fr"]\n')[0])
    for shorter in ('languages = ["de"]\n', ""):
        with pytest.raises(Stale):
            apply(Toml(BEGIN + shorter), mend)
    there = Toml(f'{BEGIN}languages = ["ja", "en"]\n')
    assert apply(there, mend) == there


def test_of_two_keys_that_mean_the_same_one_takes_its_name_and_the_other_stays(
    tmp_path: Path,
) -> None:
    (tmp_path / "situ.toml").write_text(f'{BEGIN}langauges = ["en"]\nlanguagess = ["fr"]\n')
    before = Toml((tmp_path / "situ.toml").read_text())
    first, second = found(tmp_path)
    after, mended = every({"situ.toml": before}, [first, second])
    assert mended == [second]
    assert after["situ.toml"].text == f'{BEGIN}langauges = ["en"]\nlanguages = ["fr"]\n'


def test_what_has_no_mend_and_what_is_in_another_file_is_passed_over(tmp_path: Path) -> None:
    (tmp_path / "situ.toml").write_text(f"{BEGIN}[places]\nbed = 1\n[robt]\nadapter = 'sim'\n")
    told = found(tmp_path)
    assert [one.mend is None for one in sorted(told, key=lambda one: one.line)] == [True, False]
    other = {"robot.local.toml": Toml("")}
    assert every(other, told) == (other, [])


def test_settings_that_make_room_for_ever_new_mends_come_to_an_end(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # The table has its name after one round; only then are its keys looked at.
    (tmp_path / "situ.toml").write_text(f'{BEGIN}[robt]\nadaptr = "sim"\n')
    monkeypatch.setattr(fixing, "ROUNDS", 1)
    assert len(fix(tmp_path).mended) == 1
    assert (tmp_path / "situ.toml").read_text() == f'{BEGIN}[robot]\nadaptr = "sim"\n'
    assert len(fix(tmp_path).mended) == 1
    assert fix(tmp_path).mended == []


def test_settings_that_may_not_be_written_are_one_line_and_the_others_are_mended(
    tmp_path: Path,
) -> None:
    wrong, right = '[robt]\nadapter = "sim"\n', '[robot]\nadapter = "sim"\n'
    (tmp_path / "situ.toml").write_text(BEGIN + wrong)
    (tmp_path / "robot.local.toml").write_text(wrong)
    (tmp_path / "situ.toml").chmod(0o444)
    fixed = fix(tmp_path)
    assert [Path(one.file).name for one in fixed.mended] == ["robot.local.toml"]
    assert [Path(one.file).name for one in fixed.left] == ["situ.toml"]
    (line,) = fixed.refused
    assert "situ.toml: is read-only" in line
    assert (tmp_path / "situ.toml").read_text() == BEGIN + wrong
    assert (tmp_path / "robot.local.toml").read_text() == right
