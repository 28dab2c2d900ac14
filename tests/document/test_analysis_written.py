"""What a step writes, followed into loops of unnamed events: a loop goes on only while it holds."""

from __future__ import annotations

import pytest

from situ.document import codec
from situ.document.check import check
from situ.document.project import Project
from situ.document.rbd import Application

LOOP = ("livelock", ("state", "1", "event", "0"))
UNDECIDED = ("undecided", ("state", "1", "event", "0"))


def told(test: str, writes: str, other: str = "") -> list[tuple[str, tuple[str, ...]]]:
    """Two states that lead to each other where a test holds, the way back writing something."""
    when = f"<when>{test}</when>"
    text = (
        '<application name="a"><state no="1"><expectedevents>'
        f'<event next="2">{when}</event><event name="e" next="2"/></expectedevents></state>'
        '<state no="2"><expectedevents>'
        f'<event next="1">{other or when}{writes}</event><event name="e" next="1"/>'
        "</expectedevents></state></application>"
    )
    document, problems = codec.read(text.encode(), "a.rbd.xml")
    assert isinstance(document, Application)
    assert not problems
    source = Project(root="nowhere", name="a", applications={"a.rbd.xml": document})
    return [(p.code, p.place) for p in check(source) if p.code in ("livelock", "undecided")]


DEEP = '<data tag="x.0.n" is="1"/>'
TAG = '<data tag="x.n" is="1"/>'


@pytest.mark.parametrize(
    ("test", "writes", "problems"),
    [
        (DEEP, "", [LOOP]),
        (DEEP, '<set tag="x">[{"n": 1}]</set>', [LOOP]),
        (DEEP, '<set tag="x">[{"n": 2}]</set>', []),
        (DEEP, '<set tag="x">7</set>', []),
        (DEEP, '<set tag="x">{y}</set>', [UNDECIDED]),
        # What is set at x may be hidden by what stands at the tag x.n.
        (TAG, '<set tag="x">{"n": 2}</set>', [UNDECIDED]),
        (TAG, '<set tag="x.n">2</set>', []),
        (TAG, '<set tag="x.n">null</set>', [UNDECIDED]),
        (TAG, '<clear tag="x.n"/>', [UNDECIDED]),
        (TAG, '<clear tag="x.**"/>', []),
        (TAG, '<clear tag="y.**"/>', [LOOP]),
        (TAG, '<take from="x" tag="y"/>', [UNDECIDED]),
        (TAG, '<take from="y" tag="x.n"/>', [UNDECIDED]),
        (TAG, '<add tag="x.n">1</add>', [UNDECIDED]),
        (TAG, '<append tag="x">1</append>', [UNDECIDED]),
        (TAG, '<message topic="t">1</message>', [LOOP]),
        ('<data tag="x" is="1" for="2"/>', '<set tag="x">2</set>', []),
        ('<data tag="x" is="1" for="2"/>', '<set tag="x">{y}</set>', [UNDECIDED]),
        ('<data tag="x" is="1" for="2"/>', '<set tag="x">1</set>', [LOOP]),
        ('<data tag="x" is="{y}"/>', '<set tag="x">1</set>', [UNDECIDED]),
        (f'{TAG}<data tag="z" is="1"/>', '<set tag="x.n">1</set>', [LOOP]),
        ('<data tag="x" is="1" within="2"/>', '<set tag="x">1</set>', [LOOP]),
    ],
)
def test_a_loop_is_told_where_what_it_writes_lets_it_go_on(
    test: str, writes: str, problems: list[tuple[str, tuple[str, ...]]]
) -> None:
    assert told(test, writes) == problems


def test_the_state_that_the_runtime_tells_of_is_known_on_the_way() -> None:
    one = '<data tag="application/a.state" is="1"/>'
    two = '<when><data tag="application/a.state" is="{}"/></when>'
    assert told(one, "", two.format("2")) == [LOOP]
    assert told(one, "", two.format("1")) == []
    named = '<data tag="application/a.name" exists="true"/>'
    assert told(named, "") == [UNDECIDED]
