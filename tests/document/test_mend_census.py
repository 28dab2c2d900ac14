"""Every code of docs/problems.md has a mend, or a reason for which it has none; and what holds of
each mend, of all of a kind, and of accepting a warning, over all examples of the page.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from msgspec.structs import replace
from tests.document.test_docs_problems import EXAMPLES, NUMBERED, Example, checked, sections
from tests.document.test_mends import TABLE, project_of
from tests.document.test_mends_toml import TABLE as MENDED

from situ.document import codec
from situ.document.accepting import accepting
from situ.document.beside import Toml
from situ.document.check import check, merge
from situ.document.folder import called, load
from situ.document.mend import mends, of, put
from situ.document.mend_alike import mend_alike
from situ.document.mend_toml import FILES as SETTINGS
from situ.document.mend_toml import apply
from situ.document.problem import Problem
from situ.document.project import Project

UNREAD = "what can not be read is in no document that could be changed"
MEANT = "only its author knows what is meant"
MISSING = "something must be made that is not there"

WITHOUT = {
    "bad-name": "the name is used elsewhere too: it is renamed there",
    "bad-requires": MEANT,
    "bad-time": MEANT,
    "bad-url": MEANT,
    "circular-parts": MEANT,
    "doctype": UNREAD,
    "double-application": MEANT,
    "duplicate-element": UNREAD,
    "event-without-next": MEANT,
    "flow-with-content": "what it holds belongs before the part or after it",
    "language-without-voice": MISSING,
    "livelock": MEANT,
    "malformed-po": UNREAD,
    "malformed-toml": UNREAD,
    "malformed-xml": UNREAD,
    "misplaced-element": UNREAD,
    "missing-attribute": UNREAD,
    "missing-media": MISSING,
    "missing-text": MISSING,
    "missing-texts": MISSING,
    "never-holds": MEANT,
    "not-utf-8": UNREAD,
    "one-test": UNREAD,
    "private-copied": "what is private is the author's to move",
    "private-shown": "what is private is the author's to move",
    "private-spoken": "what is private is the author's to move",
    "reference-in-script": MEANT,
    "say-without-name": MEANT,
    "spds-needed": MISSING,
    "suspended-call": "it takes another application",
    "too-deep": UNREAD,
    "too-large": UNREAD,
    "too-long": UNREAD,
    "too-many": UNREAD,
    "undecided": "nothing is known to be wrong",
    "unexpected-text": UNREAD,
    "unknown-attribute": UNREAD,
    "unknown-element": UNREAD,
    "unknown-namespace": UNREAD,
    "unprovided-module": MISSING,
    "unreachable-state": "a way to it, or away with it: nobody knows",
    "unreadable-file": UNREAD,
}
"""By code, why no mend can be had."""

ELSEWHERE = {"bad-tag", "bad-value", "missing-file", "path-outside", "undeclared-module"}
"""Codes with a mend in some cases, of which the page shows none: ``test_mends`` and
``test_mends_toml`` do."""


def found_in(folder: Path, example: Example) -> tuple[Project | None, list[Problem]]:
    project, found = checked(folder, example.failing)
    return project, [one for one in found if one.code == example.code]


def found_everywhere(folder: Path) -> list[Problem]:
    project, read = load(folder)
    assert project is not None
    return merge(read, check(project))


def errors(problems: list[Problem]) -> set[tuple[str, tuple[str, ...]]]:
    return {(one.code, one.place) for one in problems if one.severity == "error"}


def test_every_code_has_a_mend_or_a_reason_for_none(tmp_path: Path) -> None:
    with_one = set(ELSEWHERE)
    for number, example in enumerate(EXAMPLES):
        folder = tmp_path / str(number)
        folder.mkdir()
        _, found = found_in(folder, example)
        with_one |= {one.code for one in found if one.mend is not None}
    assert {code for code, *_ in (*TABLE, *MENDED)} >= ELSEWHERE
    assert sorted(with_one & set(WITHOUT)) == [], "they have a mend"
    assert sorted(set(sections()) - with_one - set(WITHOUT)) == [], "no mend, and no reason"
    assert sorted(set(WITHOUT) - set(sections())) == [], "no such codes"


@pytest.mark.parametrize("example", EXAMPLES, ids=NUMBERED)
def test_a_mend_takes_its_problem_away_and_brings_no_error(
    tmp_path: Path, example: Example
) -> None:
    project, found = found_in(tmp_path, example)
    for problem in [one for one in found if one.mend is not None]:
        assert project is not None
        assert problem.mend is not None
        if problem.mend.file in SETTINGS:
            before = errors(found_everywhere(tmp_path))
            file = tmp_path / problem.mend.file
            file.write_text(apply(Toml(file.read_text()), problem.mend).text)
            left = found_everywhere(tmp_path)
            assert (problem.code, problem.place) not in {(p.code, p.place) for p in left}
            assert errors(left) <= before, problem.mend.words
            continue
        ((words, document),) = mends(project, problem)
        after = check(put(project, problem.mend.file, document))
        assert (problem.code, problem.place) not in {(p.code, p.place) for p in after}, words
        assert errors(after) <= errors(check(project)), words
        # It can be written, and read again.
        assert codec.read(codec.write(document), "x") == (document, [])


@pytest.mark.parametrize("example", EXAMPLES, ids=NUMBERED)
def test_all_of_a_kind_go_at_once_and_bring_no_error(tmp_path: Path, example: Example) -> None:
    project, found = found_in(tmp_path, example)
    documents = [one for one in found if one.mend and one.mend.file not in SETTINGS]
    if project is None or not documents:
        return
    before = check(project)
    after, left = mend_alike(project, before, example.code)
    assert after is not project
    assert left == check(after)
    assert [p for p in left if p.code == example.code and p.mend is not None] == []
    assert errors(left) <= errors(before)


@pytest.mark.parametrize("example", EXAMPLES, ids=NUMBERED)
def test_a_warning_that_is_accepted_is_told_no_more_and_no_error_can_be(
    tmp_path: Path, example: Example
) -> None:
    project, found = found_in(tmp_path, example)
    for problem in found if project is not None else []:
        assert project is not None
        files = [*project.flows, project.spds_file or "", project.modules_file or ""]
        named = {called(project.root, file): file for file in files if file}
        file = named.get(problem.file, "")
        mend = accepting(project, file, problem)
        may = problem.severity == "warning" and file != "" and problem.code != "accept-unused"
        assert (mend is not None) is may
        if mend is None:
            continue
        ((_, document),) = mends(project, replace(problem, mend=mend))
        after = put(project, file, document)
        left = check(after)
        assert (problem.code, problem.place) not in {(p.code, p.place) for p in left}
        assert "accept-unused" not in {one.code for one in left}
        assert accepting(after, file, problem) is None, "it is accepted already"
        # But for that, the document is the same; it stays when it is written.
        assert of(after, file) == of(project, file)
        again, _ = codec.read(codec.write(document), "x")
        assert again is not None
        assert codec.write(again) == codec.write(document)


def test_what_is_accepted_before_stays_accepted(tmp_path: Path) -> None:
    text = (
        '<application name="a" xmlns:ed="urn:situ:editor">'
        '<state no="1" ed:accept="tie"/></application>'
    )
    project = project_of(tmp_path, {"a.rbd.xml": text})
    problem = Problem(
        file="a", severity="warning", code="dead-end", message="", place=("state", "1")
    )
    mend = accepting(project, "a.rbd.xml", problem)
    ((_, document),) = mends(project, replace(problem, mend=mend))
    assert b'ed:accept="tie dead-end"' in codec.write(document)
    gone = replace(problem, place=("state", "7"))
    assert accepting(project, "a.rbd.xml", gone) is None


def test_mends_that_collide_are_looked_for_again(tmp_path: Path) -> None:
    """Three states of one number would all take the next free one."""
    states = '<state no="1"/>' * 4
    project = project_of(tmp_path, {"a.rbd.xml": f'<application name="a">{states}</application>'})
    before = check(project)
    assert len({one.mend for one in before if one.code == "double-state"}) == 3
    after, left = mend_alike(project, before, "double-state")
    assert sorted(one.no for one in after.applications["a.rbd.xml"].states) == ["1", "2", "3", "4"]
    assert errors(left) == set()


def test_what_two_problems_have_as_their_mend_is_done_once(tmp_path: Path) -> None:
    """Two buttons raise the same event."""
    box = 'y="10" width="30" height="20" event="go"'
    text = (
        '<application name="a"><state no="1"><screen><components>'
        f'<button id="a" x="5" {box}>A</button><button id="b" x="55" {box}>B</button>'
        "</components></screen></state></application>"
    )
    project = project_of(tmp_path, {"a.rbd.xml": text})
    before = check(project)
    assert [one.code for one in before].count("unexpected-event") == 2
    after, _ = mend_alike(project, before, "unexpected-event")
    assert [one.name for one in after.applications["a.rbd.xml"].states[0].events] == ["go"]


def test_where_mending_takes_nothing_away_nothing_is_done(tmp_path: Path) -> None:
    project = project_of(tmp_path, {"a.rbd.xml": '<application name="a"/>'})
    before = check(project)
    assert mend_alike(project, before, "dead-end") == (project, before)


def test_mends_that_take_nothing_away_end(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    states = '<state no="1"/>' * 2
    project = project_of(tmp_path, {"a.rbd.xml": f'<application name="a">{states}</application>'})
    before = check(project)
    monkeypatch.setattr("situ.document.mend_alike.every", lambda one, mends: (one, [*mends]))
    assert mend_alike(project, before, "double-state") == (project, before)


def test_after_so_many_rounds_what_is_left_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("situ.document.mend_alike.ROUNDS", 1)
    states = '<state no="1"/>' * 4
    project = project_of(tmp_path, {"a.rbd.xml": f'<application name="a">{states}</application>'})
    after, left = mend_alike(project, check(project), "double-state")
    assert left == check(after)
    assert "double-state" in {one.code for one in left}
