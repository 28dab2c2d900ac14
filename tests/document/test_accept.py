"""``ed:accept``: what it silences, what it never does, and when it has become useless."""

from __future__ import annotations

from pathlib import Path

import pytest

from situ.document import codec, mend
from situ.document.check import check, merge, structure
from situ.document.folder import load
from situ.document.problem import Problem
from situ.document.project import Project

HEAD = '<application name="a" xmlns:ed="urn:situ:editor"{}>'
SPDS = (
    '<spds name="a" xmlns:ed="urn:situ:editor">'
    '<situation name="s"{}><condition><data tag="a" is="1"/></condition></situation>'
    '<situation name="t"/></spds>'
)


def found_in(folder: Path, text: str, *, whole: bool = True) -> tuple[Project, list[Problem]]:
    name = "a.spds.xml" if text.startswith("<spds") else "a.rbd.xml"
    (folder / name).write_text(text)
    key = f'spds = "{name}"' if "spds" in name else f'applications = ["{name}"]'
    if whole:
        (folder / "situ.toml").write_text(f"[project]\n{key}\n")
    project, read = load(folder if whole else folder / name)
    assert project is not None
    return project, merge(read, check(project))


def codes(problems: list[Problem]) -> list[str]:
    return [problem.code for problem in problems]


STATES = '<state no="1"{}><timeout next="2">5</timeout></state><state no="2"{}/></application>'


@pytest.mark.parametrize(
    "text",
    [
        HEAD.format("") + STATES.format("", ' ed:accept="dead-end"'),
        HEAD.format(' ed:accept="dead-end"') + STATES.format("", ""),
        HEAD.format("") + STATES.format("", ' ed:accept="dead-end dead-end"'),
    ],
)
def test_a_warning_is_accepted_at_its_element_or_further_out(tmp_path: Path, text: str) -> None:
    assert codes(found_in(tmp_path, text)[1]) == []


def test_a_warning_that_needs_no_search_is_accepted_too(tmp_path: Path) -> None:
    assert codes(found_in(tmp_path, SPDS.format(""))[1]) == ["unobserved-tag"]
    assert codes(found_in(tmp_path, SPDS.format(' ed:accept="unobserved-tag"'))[1]) == []


def test_a_warning_elsewhere_or_of_another_kind_is_not_accepted(tmp_path: Path) -> None:
    text = HEAD.format("") + STATES.format(' ed:accept="dead-end"', ' ed:accept="tie"')
    assert sorted(codes(found_in(tmp_path, text)[1])) == [
        "accept-unused",
        "accept-unused",
        "dead-end",
    ]


def test_an_error_is_never_accepted(tmp_path: Path) -> None:
    text = HEAD.format("") + STATES.format(' ed:accept="dangling-next"', "")
    project, _ = found_in(tmp_path, text.replace('next="2"', 'next="7"'))
    assert codes(structure(project)) == ["dangling-next"]


def test_what_is_accepted_in_vain_is_told_and_safely_mended(tmp_path: Path) -> None:
    text = HEAD.format("") + "<!-- kept -->" + STATES.format("", ' ed:accept="tie dead-end tie"')
    project, (problem,) = found_in(tmp_path, text)
    assert (problem.code, problem.severity, problem.place) == (
        "accept-unused",
        "warning",
        ("state", "2"),
    )
    assert '"tie"' in problem.message
    assert "dead-end" not in problem.message
    after, done = mend.safe(project, [problem])
    assert done == [problem]
    assert check(after) == []
    document = after.applications["a.rbd.xml"]
    assert b'ed:accept="dead-end"' in codec.write(document)
    assert b"<!-- kept -->" in codec.write(document)


def test_an_accept_that_names_nothing_goes_wholly(tmp_path: Path) -> None:
    text = HEAD.format("") + '<state no="1" final="true" ed:accept=" " ed:x="1"/></application>'
    project, problems = found_in(tmp_path, text)
    assert codes(problems) == ["accept-unused"]
    after, _ = mend.safe(project, problems)
    assert b"accept" not in codec.write(after.applications["a.rbd.xml"])
    assert b'ed:x="1"' in codec.write(after.applications["a.rbd.xml"])


def test_on_what_only_groups_others_it_has_no_effect_and_says_so(tmp_path: Path) -> None:
    text = HEAD.format("") + (
        '<state no="1"><screen><components/></screen><backgroundactions ed:x="1"/>'
        '<expectedevents ed:x="1" ed:accept="dead-end"/>'
        "</state></application>"
    )
    _, problems = found_in(tmp_path, text)
    assert sorted(codes(problems)) == ["accept-unused", "dead-end"]
    (problem,) = [one for one in problems if one.code == "accept-unused"]
    assert "<expectedevents>" in problem.message
    assert (problem.line, problem.column) == (1, text.index("<expectedevents") + 1)
    assert problem.mend is None


def test_that_it_is_accepted_in_vain_can_be_accepted(tmp_path: Path) -> None:
    head = HEAD.format(' ed:accept="accept-unused"')
    text = head + STATES.format("", ' final="true" ed:accept="tie"')
    assert codes(found_in(tmp_path, text)[1]) == []


@pytest.mark.parametrize(
    ("old", "new", "whole"),
    [
        ("", "", False),
        ('next="2"', 'next="7"', True),
        ("<timeout", "<timeout nxt=''", True),
    ],
    ids=["a single file", "an error", "an error of reading"],
)
def test_nothing_is_said_to_be_in_vain_where_not_all_was_looked_at(
    tmp_path: Path, old: str, new: str, whole: bool
) -> None:
    text = HEAD.format("") + STATES.format("", ' final="true" ed:accept="tie"')
    _, problems = found_in(tmp_path, text.replace(old, new) if old else text, whole=whole)
    assert "accept-unused" not in codes(problems)


def test_nothing_is_said_to_be_in_vain_where_a_search_was_broken_off(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("situ.document.analysis_search.ALLOWANCE", 0)
    text = SPDS.format("").replace('urn:situ:editor"', 'urn:situ:editor" ed:accept="tie"')
    found = codes(found_in(tmp_path, text)[1])
    assert "undecided" in found
    assert "accept-unused" not in found


def test_a_mend_of_what_has_changed_since_is_stale(tmp_path: Path) -> None:
    text = HEAD.format("") + STATES.format("", ' final="true" ed:accept="tie"')
    _, problems = found_in(tmp_path, text)
    changed, _ = found_in(tmp_path, text.replace("tie", "livelock"))
    assert mend.mends(changed, problems[0]) == []
