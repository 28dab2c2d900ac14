"""Every problem: its code, its place in the file, and words that name the mend.

A snippet marks with ``@`` where the problem must be; the mark itself is no part of it.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from situ.document.check import check, merge, structure
from situ.document.folder import load
from situ.document.problem import Problem
from situ.document.project import Project
from situ.document.rbd import Application
from situ.document.spds import Spds

STATE = '<application name="a"><state no="1">{}</state></application>'
ACTIONS = STATE.format("<backgroundactions>\n{}</backgroundactions>")
EVENTS = STATE.format("<expectedevents>\n{}</expectedevents>")
SCREEN = STATE.format("<screen><components>\n{}</components></screen>")
AT = 'x="0" y="0" width="1" height="1"'
SITUATION = '<spds name="a"><situation name="s">{}</situation><situation name="t"/></spds>'
CONDITION = SITUATION.format("<condition>\n{}</condition>")

READING = [
    # what XML itself refuses
    ("malformed-xml", "@", "empty"),
    ("malformed-xml", "<application name='a'>@", "end tag is missing"),
    ("malformed-xml", "<application name='a'>\n <state no='1'></@application>", "<state> is still"),
    ("malformed-xml", "<application name='a' @name='b'/>", "stands twice"),
    ("malformed-xml", "<application name='a'>@&nbsp;</application>", "&amp;"),
    ("malformed-xml", "<application name='a'/>\n@<b/>", "behind the end"),
    ("malformed-xml", "<application name='a'>\n @<state no='1' q:x='1'/></application>", '"q"'),
    ("malformed-xml", "<application name='a'>\n @<ed:note/></application>", "urn:situ:editor"),
    # what the table does not know
    ("unknown-element", "@<applikation/>", "did you mean <application>?"),
    ("unknown-element", STATE.format("\n  @<timout>5</timout>"), "did you mean <timeout>?"),
    ("unknown-element", ACTIONS.format(" @<Speech>a</Speech>"), "did you mean <speech>?"),
    ("unknown-element", ACTIONS.format("<speech>a @<b/></speech>"), "nothing can stand in it"),
    ("misplaced-element", STATE.format("@<speech>a</speech>"), "in <backgroundactions>"),
    ("unknown-attribute", STATE.format("@<timeout nxt='1'>5</timeout>"), 'mean "next"?'),
    ("unknown-namespace", "@<application xmlns='urn:x' name='a'/>", "xmlns"),
    ("unexpected-text", "@<application name='a'>hello</application>", '"hello"'),
    ("missing-attribute", "@<application/>", '"name"'),
    ("missing-attribute", ACTIONS.format("@<take from='a'/>"), '"tag"'),
    ("missing-attribute", SCREEN.format(f"@<image id='i' {AT}/>"), '"src"'),
    ("duplicate-element", STATE.format("<screen/>\n@<screen/>"), "two <screen>"),
    ("duplicate-element", STATE.format("<expectedevents/>@<expectedevents/>"), "only one"),
    # values of the wrong type
    ("bad-value", SCREEN.format('@<text id="t" x="abc" y="0" width="1" height="1"/>'), '"abc"'),
    (
        "bad-value",
        SCREEN.format(f'@<text id="t" x="{"9" * 400}" y="0" width="1" height="1"/>'),
        "too large",
    ),
    ("unknown-attribute", STATE.format("@<expectedevents a='1'/>"), 'no attribute "a"'),
    ("bad-value", SCREEN.format('@<text id="t" x="nan" y="0" width="1" height="1"/>'), "number"),
    ("bad-value", SCREEN.format(f'@<text id="t" {AT} align="middle"/>'), '"left", "center"'),
    ("bad-value", SCREEN.format(f'@<input id="t" {AT} tag="a" max="1.5"/>'), "whole number"),
    ("bad-value", STATE.format("@<timeout>soon</timeout>"), '"soon"'),
    ("bad-value", STATE.format("@<timeout/>"), "empty"),
    ("bad-value", ACTIONS.format('@<speech wait="yes">a</speech>'), '"true" nor "false"'),
    ("bad-value", ACTIONS.format('@<take from="a" tag="b" order="last"/>'), '"first" or "random"'),
    ("bad-value", SITUATION.format('@<module name="m" priority="high"/>'), '"none"'),
    (
        "bad-value",
        '<spds name="a"><observe>@<data tag="a" type="int"/></observe><situation name="s"/></spds>',
        "text",
    ),
    ("one-test", CONDITION.format('@<data tag="a"/>'), "tests nothing"),
    ("one-test", CONDITION.format('@<data tag="a" is="1" above="0"/>'), "2 tests (is, above)"),
]

CHECKING = [
    # names, numbers and times that a value can hold but must not
    ("bad-name", '@<application name=""><state no="1"/></application>', "name"),
    ("bad-name", '@<application name="a/b"><state no="1"/></application>', "without /"),
    ("bad-value", '<application name="a">@<state no="a b"/></application>', "blanks"),
    ("bad-value", '<application name="a">@<state no="#back"/></application>', "#"),
    ("bad-time", STATE.format("@<timeout>0</timeout>"), "above 0"),
    ("bad-time", STATE.format("@<timeout>-1.5</timeout>"), "-1.5"),
    ("bad-value", SCREEN.format(f'@<input id="t" {AT} tag="a" max="-1"/>'), "at least 1"),
    ("bad-value", SCREEN.format('@<text id="t" x="0" y="0" width="-1" height="1"/>'), "below 0"),
    ("bad-tag", ACTIONS.format('@<set tag="A b">1</set>'), "a-z"),
    ("bad-tag", ACTIONS.format('@<clear tag="a*"/>'), "pattern"),
    ("bad-name", CONDITION.format('@<data tag="A" is="1"/>'), "patient.room"),
    ("bad-time", CONDITION.format('@<data tag="a" is="1" within="0"/>'), "within"),
    ("bad-time", CONDITION.format('@<data tag="a" is="1" for="-1"/>'), "for"),
    ("bad-value", CONDITION.format('@<data tag="a" exists="yes"/>'), '"true" or "false"'),
    ("bad-value", CONDITION.format('@<data tag="a" in="1, 2"/>'), "needs a list"),
    ("bad-value", CONDITION.format('@<data tag="a" in="[NaN]"/>'), "needs a list"),
    ("bad-value", EVENTS.format('<event name="a" next="1">@<say> </say></event>'), "<say>"),
    ("bad-value", ACTIONS.format('@<sound src=""/>'), "src"),
    # states
    ("no-state", '@<application name="a"/>', "add one"),
    ("dangling-start", '@<application name="a" start="2"><state no="1"/></application>', '"2"'),
    ("double-state", '<application name="a"><state no="1"/>@<state no="1"/></application>', "two"),
    (
        "dangling-next",
        EVENTS.format('@<event name="a" next="7"/>'),
        'state "7", which does not exist; the states are 1',
    ),
    ("dangling-next", STATE.format('@<timeout next="7">5</timeout>'), '"7"'),
    (
        "dangling-next",
        (
            '<application name="a"><always><expectedevents>@<event name="a" next="7"/>'
            '</expectedevents></always><state no="1"/></application>'
        ),
        '"7"',
    ),
    (
        "double-component",
        SCREEN.format(f'<text id="t" {AT}>a</text>@<button id="t" {AT} event="a"/>'),
        '"t"',
    ),
    (
        "double-component",
        (
            f'<application name="a"><always><screen><components><text id="t" {AT}/></components>'
            f'</screen></always><state no="1"><screen><components>@<text id="t" {AT}/></components>'
            "</screen></state></application>"
        ),
        "every state",
    ),
    # events and actions
    ("event-without-next", EVENTS.format("@<event/>"), "let it lead to a state"),
    ("say-without-name", EVENTS.format('<event next="1">@<say>go</say></event>'), "name"),
    ("visible-action", EVENTS.format('<event name="a">@<speech>hi</speech></event>'), "A speech"),
    ("visible-action", EVENTS.format('<event name="a">@<sound src="http://a"/></event>'), "state"),
    (
        "visible-action",
        EVENTS.format('<event name="a">@<robot resource="base" command="stop"/></event>'),
        "A robot",
    ),
    ("misplaced-repeat", EVENTS.format('<event name="a" next="1">@<repeat/></event>'), "say again"),
    ("misplaced-repeat", ACTIONS.format("@<repeat/>"), "event"),
    ("reserved-tag", ACTIONS.format('@<set tag="robot/head">1</set>'), '"robot/head"'),
    ("reserved-tag", ACTIONS.format('@<append tag="module/b/head">1</append>'), "another tag"),
    ("bad-url", ACTIONS.format('@<service name="f" url="ftp://x"/>'), "http://"),
    ("bad-url", ACTIONS.format('@<service name="f" url="board:x"/>'), "board:module/request"),
    # conditions
    (
        "empty-condition",
        EVENTS.format('<event name="a" next="1">@<when/></event>'),
        "is empty",
    ),
    ("empty-condition", SITUATION.format("@<condition/>"), "is empty"),
    ("empty-condition", SITUATION.format("@<until/>"), "is empty"),
    ("empty-condition", CONDITION.format("@<none/>"), "is empty"),
    ("reference-in-script", CONDITION.format('@<data tag="a" is="{b}"/>'), '"{b}"'),
    # situations
    ("no-situation", '@<spds name="a"/>', "add one"),
    (
        "double-situation",
        '<spds name="a"><situation name="s"/>@<situation name="s"/></spds>',
        '"s"',
    ),
    ("unknown-situation", '<spds name="a">@<situation name="s" extends="t"/></spds>', '"t"'),
    ("circular-extends", '<spds name="a">@<situation name="s" extends="s"/></spds>', "itself"),
    (
        "last-situation",
        (
            '<spds name="a"><situation name="s">@<condition><data tag="a" is="1"/></condition>'
            "</situation></spds>"
        ),
        "always hold",
    ),
    ("last-situation", '<spds name="a">@<situation name="s" limit="5"/></spds>', "limit"),
    (
        "dwell-with-until",
        '<spds name="a">@<situation name="s" dwell="1" limit="2"/><situation name="t"/></spds>',
        "dwell",
    ),
    ("bad-time", '<spds name="a">@<situation name="s" dwell="0"/></spds>', "dwell"),
    ("undeclared-module", SITUATION.format('@<module name="m" priority="1"/>'), "declared"),
    (
        "double-module",
        (
            '<spds name="a"><modules><module name="m" resources=""/>'
            '@<module name="m" resources="head"/></modules><situation name="s"/></spds>'
        ),
        "twice",
    ),
    (
        "double-module",
        (
            '<spds name="a"><modules><module name="m" resources=""/></modules><situation name="s">'
            '<module name="m" priority="1"/>@<module name="m" priority="2"/></situation></spds>'
        ),
        "two priorities",
    ),
    (
        "bad-value",
        (
            '<spds name="a"><modules>@<module name="m" resources="head head"/></modules>'
            '<situation name="s"/></spds>'
        ),
        "twice",
    ),
    (
        "bad-value",
        (
            '<spds name="a"><modules>@<module name="m" resources="left/head"/></modules>'
            '<situation name="s"/></spds>'
        ),
        "without /",
    ),
    (
        "double-data",
        (
            '<spds name="a"><observe><data tag="a"/>@<data tag="a"/></observe>'
            '<situation name="s"/></spds>'
        ),
        "twice",
    ),
    # module information
    ("bad-requires", '<modules><module name="m">@<requires/></module></modules>', "exactly one"),
    (
        "bad-requires",
        '<modules><module name="m">@<requires data="a" module="b"/></module></modules>',
        "exactly one",
    ),
    ("double-module", '<modules><module name="m"/>@<module name="m"/></modules>', '"m"'),
    # what leaves the project
    ("path-outside", ACTIONS.format('@<sound src="../a.ogg"/>'), "inside"),
    ("path-outside", ACTIONS.format('@<sound src="/etc/passwd"/>'), "inside"),
    ("path-outside", STATE.format('@<flow src="../b.rbd.xml"/>'), "lie"),
    ("missing-file", STATE.format('@<flow src="b.rbd.xml"/>'), "b.rbd.xml"),
    ("circular-parts", STATE.format('@<flow src="file.rbd.xml"/>'), "itself"),
]

WARNINGS = [
    ("unobserved-tag", CONDITION.format('@<data tag="a.b" is="1"/>'), "data observed"),
    ("reserved-tag", ACTIONS.format('@<clear tag="robot/**"/>'), "never cleared"),
    (
        "text-and-params",
        ACTIONS.format('@<message topic="t">a<param name="b">1</param></message>'),
        "values",
    ),
]


def problems_of(folder: Path, marked: str) -> tuple[list[Problem], int, int]:
    """The problems of a snippet as a single file, and line and column of its mark."""
    before, mark, after = marked.partition("@")
    assert mark
    root = after if before == "" else before
    kind = next((k for k in ("spds", "modules") if root.lstrip().startswith(f"<{k}")), "rbd")
    file = folder / ("modules.xml" if kind == "modules" else f"file.{kind}.xml")
    file.write_bytes((before + after).encode())
    project, found = load(file)
    if project is not None:
        found = merge(found, structure(project))
    assert all(problem.file == str(file) for problem in found)
    return found, before.count("\n") + 1, len(before) - before.rfind("\n")


@pytest.mark.parametrize(
    ("code", "marked", "words"),
    [*READING, *CHECKING],
    ids=[f"{code}-{i}" for i, (code, _, _) in enumerate([*READING, *CHECKING])],
)
def test_an_error_names_code_place_and_mend(
    tmp_path: Path, code: str, marked: str, words: str
) -> None:
    found, line, column = problems_of(tmp_path, marked)
    assert [(p.code, p.line, p.column) for p in found if p.severity == "error"] == [
        (code, line, column)
    ], [str(p) for p in found]
    (message,) = [p.message for p in found if p.severity == "error"]
    assert words in message
    assert "\n" not in str(found[0])


def test_a_number_may_not_be_the_path_of_a_state_of_a_part(tmp_path: Path) -> None:
    (tmp_path / "b.rbd.xml").write_text('<application name="b"><state no="1"/></application>')
    found, line, column = problems_of(
        tmp_path,
        '<application name="a"><state no="5"><flow src="b.rbd.xml"/></state>'
        '@<state no="5/1"/></application>',
    )
    errors = [(p.code, p.line, p.column) for p in found if p.severity == "error"]
    assert errors == [("double-state", line, column)]


@pytest.mark.parametrize(
    ("code", "marked", "words"), WARNINGS, ids=[f"{code}" for code, _, _ in WARNINGS]
)
def test_a_warning_is_no_error(tmp_path: Path, code: str, marked: str, words: str) -> None:
    found, line, column = problems_of(tmp_path, marked)
    assert [(p.severity, p.code, p.line, p.column) for p in found] == [
        ("warning", code, line, column)
    ], [str(p) for p in found]
    assert words in found[0].message


GOOD = [
    EVENTS.format('<event name="a" next="#again"/><event name="b" next="#back"/>'),
    EVENTS.format('<event name="a"><set tag="b">1</set><repeat/></event>'),
    EVENTS.format('<event next="1"><when><data tag="a" above="{b.c}" for="1"/></when></event>'),
    EVENTS.format('<event name="a" next="1"><when><data tag="a" in="{b}"/></when></event>'),
    ACTIONS.format('<set tag="module/a/note">1</set>'),
    ACTIONS.format('<sound src="{chosen}"/><sound src="https://example.org/a.ogg"/>'),
    ACTIONS.format('<service name="f" url="{base}/x"/><service name="g" url="board:m/q"/>'),
    SCREEN.format(f'<text id="t" {AT}/>').replace("<screen>", '<screen background="#fff">'),
    CONDITION.format('<data tag="clock.time" atleast="08:00"/><data tag="situation.name" is="s"/>'),
    CONDITION.format('<data tag="robot/head.yaw" above="1"/>'),
    (
        '<spds name="a"><observe><data tag="a"/></observe><situation name="s"><condition>'
        '<data tag="a.0.B" is="1"/></condition></situation><situation name="t"/></spds>'
    ),
]


@pytest.mark.parametrize("text", GOOD)
def test_what_formats_allows_has_no_problem(tmp_path: Path, text: str) -> None:
    found, _, _ = problems_of(tmp_path, "@" + text)
    assert [str(p) for p in found] == []


def test_every_problem_of_a_file_is_told_in_its_order(tmp_path: Path) -> None:
    found, _, _ = problems_of(
        tmp_path,
        '@<application name="a">\n<state no="1" a="1"/>\n<state no="1"/>\n'
        '<state no="2"><timeout next="9">0</timeout></state></application>',
    )
    assert [(p.code, p.line) for p in found] == [
        ("unknown-attribute", 2),
        ("double-state", 3),
        ("bad-time", 4),
        ("dangling-next", 4),
    ]


@pytest.mark.parametrize(
    ("marked", "place"),
    [
        (EVENTS.format('@<event name="a" next="7"/>'), ("state", "1", "event", "0")),
        (STATE.format('@<timeout next="7">5</timeout>'), ("state", "1", "timeout")),
        (ACTIONS.format('<speech>a</speech>@<set tag="A">1</set>'), ("state", "1", "action", "1")),
        (
            SCREEN.format(f'@<input id="t" {AT} tag="a" max="-1"/>'),
            ("state", "1", "screen", "t"),
        ),
        (
            EVENTS.format('<event name="a" next="1"><when><all>@<any/></all></when></event>'),
            ("state", "1", "event", "0", "when", "0", "0"),
        ),
        (SITUATION.format('@<module name="m" priority="1"/>'), ("situation", "s", "entry", "0")),
        (CONDITION.format("@<any/>"), ("situation", "s", "condition", "0")),
        (STATE.format("@<timout/>"), ("state", "1")),
        (
            '<modules><module name="m">@<requires/></module></modules>',
            ("module", "m", "requires", "0"),
        ),
    ],
)
def test_a_problem_names_the_place_that_an_editor_selects(
    tmp_path: Path, marked: str, place: tuple[str, ...]
) -> None:
    found, _, _ = problems_of(tmp_path, marked)
    assert [p.place for p in found if p.severity == "error"] == [place]


@given(seed=st.integers(0, 2**64))
@settings(max_examples=100, deadline=None)
def test_checking_never_raises_whatever_the_document(
    make_document: Callable[[int], Any], seed: int
) -> None:
    document = make_document(seed)
    project = Project(root="nowhere", name="a", toml="situ.toml", languages=("en", "ja"))
    if isinstance(document, Application):
        project = replace(project, applications={"a.rbd.xml": document}, texts={"ja": {}})
    elif isinstance(document, Spds):
        project = replace(project, spds_file="a.spds.xml", spds=document)
    else:
        project = replace(project, modules_file="modules.xml", modules=document)
    for problem in check(project):
        assert (problem.line, problem.column) == (0, 0)
        assert "\n" not in str(problem)
