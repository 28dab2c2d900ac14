"""Mends of ``situ.toml``: what is wrong there is taken away, all else stays as it is written."""

from __future__ import annotations

from pathlib import Path

import pytest

from situ.document import folder
from situ.document.beside import Toml
from situ.document.check import check, merge
from situ.document.fix import fix
from situ.document.mend import Stale
from situ.document.mend_toml import apply, every
from situ.document.problem import Problem

APPLICATION = '<application name="a"><state no="1" final="true"/></application>'
BEGIN = '[project]\nname = "p" # ours\n'
TABLE = (
    ("unknown-key", 'nam = "p"', 'name = "p"'),
    ("unknown-key", '[robt]\nadapter = "sim"', '[robot]\nadapter = "sim"'),
    ("unknown-key", '[colours]\nwall = "blue"', ""),
    ("unknown-key", '[[settings]]\ntag = "a.b"', '[[setting]]\ntag = "a.b"'),
    ("bad-value", '[durable]\ntags = "a.*"', '[durable]\ntags = ["a.*"]'),
    ("bad-value", "[robot]\nadapter = 3", '[robot]\nadapter = "3"'),
    ("bad-value", '[robot]\nannounce = "false"', "[robot]\nannounce = false"),
    (
        "bad-value",
        '[[setting]]\ntag = "a"\ntype = "dat"',
        '[[setting]]\ntag = "a"\ntype = "date"',
    ),
    (
        "bad-value",
        '[[setting]]\ntag = "a"\nchoices = ["x", "y"]',
        '[[setting]]\ntag = "a"\nchoices = ["x", "y"]\ntype = "choice"',
    ),
    (
        "bad-value",
        '[[setting]]\ntag = "a"\ntype = "choice"\nchoices = ["x", "y", "x"]',
        '[[setting]]\ntag = "a"\ntype = "choice"\nchoices = ["x", "y"]',
    ),
    ("bad-value", '[[setting]]\ntag = "a"\ntype = "choice"', '[[setting]]\ntag = "a"'),
    (
        "bad-value",
        '[[setting]]\ntag = "a"\ntype = "choice"\nchoices = ["x", "x"]',
        '[[setting]]\ntag = "a"',
    ),
    (
        "bad-value",
        '[[setting]]\ntag = "a"\nchoices = ["x", "y", "x"]',
        '[[setting]]\ntag = "a"\nchoices = ["x", "y"]\ntype = "choice"',
    ),
    ("bad-value", '[[setting]]\ntag = "a"\nchoices = ["x"]', '[[setting]]\ntag = "a"'),
    ("bad-value", '[mqtt]\nin = { "a/b" = "fall" }', '[mqtt]\nin = { "a/b" = "event:fall" }'),
    ("bad-tag", '[tags]\n"User Name" = 1', "[tags]\nuser-name = 1"),
    ("bad-tag", '[privacy]\nprivate = ["User.**", "a"]', '[privacy]\nprivate = ["user.**", "a"]'),
    ("missing-file", 'applications = ["a.rbd.xml", "no.rbd.xml"]', 'applications = ["a.rbd.xml"]'),
    ("path-outside", 'media = "../pictures"', ""),
    (
        "duplicate-file",
        'applications = ["a.rbd.xml", "a.rbd.xml"]',
        'applications = ["a.rbd.xml"]',
    ),
)
"""Code, what stands below ``[project]``, and what stands there when it is mended."""


def found(ward: Path) -> list[Problem]:
    project, read = folder.load(ward)
    assert project is not None
    return merge(read, check(project))


@pytest.fixture
def ward(tmp_path: Path) -> Path:
    (tmp_path / "a.rbd.xml").write_text(APPLICATION)
    return tmp_path


@pytest.mark.parametrize(("code", "wrong", "right"), TABLE)
def test_a_mend_of_situ_toml_changes_what_is_wrong_and_nothing_else(
    ward: Path, code: str, wrong: str, right: str
) -> None:
    begin = BEGIN.replace('name = "p"', 'spds = "p"') if wrong.startswith("nam ") else BEGIN
    (ward / "situ.toml").write_text(f"# Ours\n{begin}{wrong}\n")
    (problem,) = [one for one in found(ward) if one.code == code]
    assert problem.mend is not None
    after = apply(Toml((ward / "situ.toml").read_text()), problem.mend)
    assert after.text.rstrip() == f"# Ours\n{begin}{right}".rstrip()
    (ward / "situ.toml").write_text(after.text)
    assert [one for one in found(ward) if one.code == code] == []


@pytest.mark.parametrize("target", ['"evnt:fall"', '"tag:Not A Tag"', '" "', "3"])
def test_what_a_message_means_is_mended_only_where_a_plain_name_says_which_event(
    ward: Path, target: str
) -> None:
    (ward / "situ.toml").write_text(f'{BEGIN}[mqtt]\nin = {{ "a/b" = {target} }}\n')
    (problem,) = found(ward)
    assert (problem.code, problem.place) == ("bad-value", ("mqtt", "in", "a/b"))
    assert problem.mend is None


def test_a_mend_for_another_text_than_stands_there_is_stale(ward: Path) -> None:
    (ward / "situ.toml").write_text(f"{BEGIN}[robot]\nadapter = 3\n[colours]\n")
    for problem in found(ward):
        assert problem.mend is not None
        for other in (BEGIN, f"{BEGIN}[robot]\nadapter = 4\n", "[project", f"{BEGIN}robot = 1\n"):
            with pytest.raises(Stale):
                apply(Toml(other), problem.mend)


def test_all_mends_of_a_file_are_made_at_once_and_the_same_one_once(ward: Path) -> None:
    settings = "".join(f'[[setting]]\ntag = "a.{n}"\ntype = "tme"\n' for n in "xyy")
    (ward / "situ.toml").write_text(f'{BEGIN}{settings}[[setting]]\ntag = "b"\ntyp = "text"\n')
    before = found(ward)
    after, mended = every({"situ.toml": Toml((ward / "situ.toml").read_text())}, before)
    assert mended == before
    (ward / "situ.toml").write_text(after["situ.toml"].text)
    assert found(ward) == []
    assert after["situ.toml"].text.count('type = "time"') == 3


def test_check_fix_writes_what_is_sure_into_situ_toml_and_leaves_the_rest(
    ward: Path,
) -> None:
    text = (
        f'{BEGIN}langauges = ["en"]  # two\ncolour = "blue"\n[[setting]]\ntag = "a"\ntyp = "date"\n'
    )
    (ward / "situ.toml").write_text(text)
    fixed = fix(ward)
    assert [one.code for one in fixed.mended] == ["unknown-key", "unknown-key"]
    assert [one.place for one in fixed.left] == [("project", "colour")]
    now = (ward / "situ.toml").read_text()
    assert now == text.replace("langauges", "languages").replace("typ =", "type =")


def test_a_language_that_a_button_chooses_is_added_to_the_project(ward: Path) -> None:
    (ward / "situ.toml").write_text(f'{BEGIN}applications = ["a.rbd.xml"]\nlanguages = ["en"]\n')
    (ward / "a.rbd.xml").write_text(
        '<application name="a"><state no="1" final="true"><backgroundactions>'
        '<set tag="language">ja</set></backgroundactions></state></application>'
    )
    (problem,) = [one for one in found(ward) if one.code == "language-without-texts"]
    assert problem.mend is not None
    after = apply(Toml((ward / "situ.toml").read_text()), problem.mend)
    assert 'languages = ["en", "ja"]' in after.text


def test_a_word_that_is_no_code_of_a_language_is_told_but_not_added(ward: Path) -> None:
    (ward / "situ.toml").write_text(f'{BEGIN}applications = ["a.rbd.xml"]\nlanguages = ["en"]\n')
    (ward / "a.rbd.xml").write_text(
        '<application name="a"><state no="1" final="true"><backgroundactions>'
        '<set tag="language">Japanese</set></backgroundactions></state></application>'
    )
    (problem,) = [one for one in found(ward) if one.code == "language-without-texts"]
    assert problem.mend is None


def test_a_setting_and_its_problem_have_the_same_place(ward: Path) -> None:
    (ward / "situ.toml").write_text(
        f'{BEGIN}[[setting]]\ntag = "A"\n[[setting]]\ntag = "b"\ntype = "colour"\n'
    )
    places = {one.code: one.place for one in found(ward)}
    assert places == {
        "bad-tag": ("setting", "0", "tag"),
        "bad-value": ("setting", "1", "type"),
    }
