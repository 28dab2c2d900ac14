"""Mends: what one click, or ``situ check --fix``, does about a problem, code by code.

What the panel of the editor offers is ``mends``; it is tested here without a window.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from msgspec.structs import replace

from situ.document import codec
from situ.document.check import check
from situ.document.folder import load
from situ.document.mend import Stale, apply, mends, of, put, safe
from situ.document.problem import Change, Mend, Problem
from situ.document.project import Project
from situ.document.rbd import Application, State

APPLICATION = '<application name="a">\n{}</application>\n'
STATE = APPLICATION.format('<state no="1">{}</state><state no="2" name="end" final="true"/>')
EVENTS = STATE.format("<expectedevents>{}</expectedevents>")
ACTIONS = STATE.format('<timeout next="2">5</timeout><backgroundactions>{}</backgroundactions>')
BOX = 'x="0" y="0" width="9" height="9"'
SCRIPT = '<spds name="s">{}<situation name="day">{}</situation></spds>'
OBSERVED = '<observe><data tag="t"/></observe>'
ASKS = '<condition><data tag="t" is="1"/></condition>'
SPEAKS = ACTIONS.format("<speech>Hi</speech>")

TABLE: list[tuple[str, dict[str, str], str, bool]] = [
    # what leads nowhere
    (
        "dangling-next",
        {"a.rbd.xml": EVENTS.format('<event name="e" next="end"/>')},
        'Lead to state "2"',
        False,
    ),
    (
        "dangling-next",
        {"a.rbd.xml": STATE.replace('no="2"', 'no="20"').format('<timeout next="200">5</timeout>')},
        'Lead to state "20"',
        False,
    ),
    (
        "dangling-next",
        {
            "a.rbd.xml": APPLICATION.format(
                '<always><expectedevents><event name="e" next="11"/></expectedevents></always>'
                '<state no="1"/>'
            )
        },
        'Lead to state "1"',
        False,
    ),
    (
        "dangling-start",
        {"a.rbd.xml": STATE.format("").replace('name="a"', 'name="a" start="x"')},
        'Start in state "1"',
        False,
    ),
    (
        "double-state",
        {"a.rbd.xml": STATE.format("").replace('"2"', '"1"')},
        "Give it the number 2",
        False,
    ),
    # screens and actions
    (
        "double-component",
        {
            "a.rbd.xml": STATE.format(
                f'<screen><components><text id="t" {BOX}>a</text><text id="t" {BOX}>b</text>'
                "</components></screen>"
            )
        },
        'Call it "t-2"',
        False,
    ),
    (
        "visible-action",
        {
            "a.rbd.xml": EVENTS.format(
                '<event name="e" next="2"><robot resource="head" command="nod">'
                '<param name="times">2</param></robot></event>'
            )
        },
        'Move it to state "2"',
        False,
    ),
    (
        "misplaced-repeat",
        {"a.rbd.xml": EVENTS.format('<event name="e" next="2"><repeat/></event>')},
        "Take out what says it again",
        False,
    ),
    (
        "misplaced-repeat",
        {"a.rbd.xml": ACTIONS.format("<repeat/>")},
        "Take out what says it again",
        False,
    ),
    (
        "reserved-tag",
        {"a.rbd.xml": ACTIONS.format('<clear tag="robot/**"/>')},
        "Take it out",
        False,
    ),
    (
        "text-and-params",
        {"a.rbd.xml": ACTIONS.format('<message topic="m">x<param name="p">1</param></message>')},
        "Take the text out",
        False,
    ),
    # conditions
    (
        "empty-condition",
        {"a.rbd.xml": EVENTS.format('<event name="e" next="2"><when/></event>')},
        "Take the empty condition out",
        False,
    ),
    (
        "empty-condition",
        {
            "a.rbd.xml": EVENTS.format(
                '<event name="e" next="2"><when><any/><data tag="t" is="1"/></when></event>'
            )
        },
        "Take the empty condition out",
        False,
    ),
    # scripts
    ("no-situation", {"s.spds.xml": '<spds name="s"/>'}, 'Add the situation "otherwise"', False),
    (
        "last-situation",
        {"s.spds.xml": SCRIPT.format(OBSERVED, ASKS)},
        'Add the situation "otherwise"',
        False,
    ),
    (
        "last-situation",
        {"s.spds.xml": SCRIPT.format(OBSERVED, ASKS).replace('"day"', '"otherwise"')},
        'Add the situation "otherwise-2"',
        False,
    ),
    (
        "last-situation",
        {"s.spds.xml": '<spds name="s"><situation name="day" limit="5"/></spds>'},
        "Let it always hold",
        False,
    ),
    (
        "double-situation",
        {
            "s.spds.xml": SCRIPT.format(
                OBSERVED + f'<situation name="day">{ASKS}</situation>',
                "",
            )
        },
        'Call it "day-2"',
        False,
    ),
    (
        "unknown-situation",
        {"s.spds.xml": '<spds name="s"><situation name="day" extends="x"/></spds>'},
        "Take extends out",
        False,
    ),
    (
        "unknown-situation",
        {
            "s.spds.xml": SCRIPT.format(
                OBSERVED + f'<situation name="call" extends="dya">{ASKS}</situation>', ""
            )
        },
        'Extend "day"',
        False,
    ),
    (
        "circular-extends",
        {"s.spds.xml": '<spds name="s"><situation name="day" extends="day"/></spds>'},
        "Take extends out here",
        False,
    ),
    (
        "dwell-with-until",
        {
            "s.spds.xml": SCRIPT.format(
                OBSERVED + f'<situation name="call" dwell="1" limit="9">{ASKS}</situation>', ""
            )
        },
        "Take dwell out",
        False,
    ),
    (
        "double-data",
        {"s.spds.xml": SCRIPT.format('<observe><data tag="t"/><data tag="t"/></observe>', "")},
        "Take this one out",
        True,
    ),
    (
        "double-data",
        {
            "s.spds.xml": SCRIPT.format(
                '<observe><data tag="t"/><data tag="t" type="text"/></observe>', ""
            )
        },
        "Take this one out",
        False,
    ),
    (
        "double-module",
        {
            "s.spds.xml": SCRIPT.format(
                '<modules><module name="m" resources="head"/><module name="m" resources="head"/>'
                "</modules>",
                '<module name="m" priority="1"/>',
            )
        },
        "Take this one out",
        True,
    ),
    (
        "double-module",
        {
            "s.spds.xml": SCRIPT.format(
                '<modules><module name="m" resources="head"/></modules>',
                '<module name="m" priority="1"/><module name="m" priority="2"/>',
            )
        },
        "Take this one out",
        False,
    ),
    (
        "bad-value",
        {
            "s.spds.xml": SCRIPT.format(
                '<modules><module name="m" resources="head base head"/></modules>',
                '<module name="m" priority="1"/>',
            )
        },
        "Name each once",
        True,
    ),
    (
        "unobserved-tag",
        {
            "s.spds.xml": SCRIPT.replace("day", "call")
            .format("", ASKS)
            .replace("</spds>", '<situation name="day"/></spds>')
        },
        'Observe "t"',
        False,
    ),
    (
        "unobserved-tag",
        {
            "s.spds.xml": SCRIPT.replace("day", "call")
            .format("", ASKS.replace('"t"', '"t.room.Name"'))
            .replace("</spds>", '<situation name="day"/></spds>'),
            "modules.xml": '<modules><module name="m"><provides data="t.room" type="text"/>'
            "</module></modules>",
        },
        'Observe "t.room"',
        True,
    ),
    # priorities and modules
    (
        "application-without-priority",
        {"a.rbd.xml": SPEAKS, "s.spds.xml": SCRIPT.format("", "")},
        'Give it the priority 1 in "day"',
        False,
    ),
    (
        "application-without-priority",
        {
            "a.rbd.xml": SPEAKS,
            "s.spds.xml": SCRIPT.format(
                '<modules><module name="a" resources="speech"/>'
                '<module name="m" resources="speech"/></modules>',
                '<module name="m" priority="1"/>',
            ),
        },
        'Give it the priority 0 in "day"',
        False,
    ),
    (
        "undeclared-module",
        {
            "a.rbd.xml": SPEAKS,
            "s.spds.xml": SCRIPT.format("", '<module name="a" priority="1"/>'),
        },
        'Declare "a" with "speech"',
        False,
    ),
    (
        "undeclared-resource",
        {
            "a.rbd.xml": SPEAKS,
            "s.spds.xml": SCRIPT.format(
                '<modules><module name="a" resources="head"/></modules>',
                '<module name="a" priority="1"/>',
            ),
        },
        'Give it "speech"',
        False,
    ),
    (
        "undeclared-resource",
        {
            "a.rbd.xml": SPEAKS,
            "s.spds.xml": SCRIPT.format("", '<module name="a" priority="1"/>'),
            "modules.xml": '<modules><module name="a" resources="head"/></modules>',
        },
        'Give it "speech"',
        False,
    ),
    (
        "undeclared-resource",
        {
            "a.rbd.xml": SPEAKS,
            "modules.xml": '<modules><module name="b"/><module name="a"/></modules>',
        },
        'Give it "speech"',
        False,
    ),
    (
        "contradiction",
        {
            "s.spds.xml": SCRIPT.format(
                '<modules><module name="m" resources="head"/></modules>',
                '<module name="m" priority="1"/>',
            ),
            "modules.xml": '<modules><module name="m" resources="base"/></modules>',
        },
        "Say here what modules.xml says",
        False,
    ),
    (
        "contradiction",
        {
            "s.spds.xml": SCRIPT.format('<observe><data tag="t" unit="m"/></observe>', ""),
            "modules.xml": '<modules><module name="m"><provides data="t" unit="cm"/></module>'
            "</modules>",
        },
        "Say here what modules.xml says",
        False,
    ),
    # searches
    (
        "dead-end",
        {"a.rbd.xml": STATE.format('<timeout next="2">5</timeout>').replace(' final="true"', "")},
        "Say that it is meant to be the end",
        False,
    ),
    (
        "event-never-taken",
        {
            "a.rbd.xml": EVENTS.format(
                '<event name="e" next="2"/><event name="e" next="1"><when>'
                '<data tag="t" is="1"/></when></event>'
            )
        },
        "Put it before event 1",
        False,
    ),
]


def project_of(folder: Path, files: dict[str, str]) -> Project:
    lines = ["[project]"]
    for name, text in files.items():
        (folder / name).write_text(text)
        key = {"rbd": "applications", "spds": "spds"}.get(name.split(".")[1], "modules")
        lines.append(f'{key} = ["{name}"]' if key == "applications" else f'{key} = "{name}"')
    (folder / "situ.toml").write_text("\n".join(lines) + "\n")
    project, read = load(folder)
    assert project is not None
    assert read == []
    return project


@pytest.mark.parametrize(
    ("code", "files", "words", "is_safe"),
    TABLE,
    ids=[f"{row[0]}-{number}" for number, row in enumerate(TABLE)],
)
def test_a_mend_takes_its_problem_away(
    tmp_path: Path, code: str, files: dict[str, str], words: str, is_safe: bool
) -> None:
    project = project_of(tmp_path, files)
    (problem,) = [one for one in check(project) if one.code == code]
    assert problem.mend is not None
    assert problem.mend.safe is is_safe
    ((said, document),) = mends(project, problem)
    assert words in said
    assert "\n" not in said
    after = put(project, problem.mend.file, document)
    assert code not in {one.code for one in check(after)}
    errors = {one.code for one in check(project) if one.severity == "error"}
    assert {one.code for one in check(after) if one.severity == "error"} <= errors - {code}
    # What was put in can be written and read.
    assert codec.read(codec.write(document), "x") == (document, [])


@pytest.mark.parametrize(
    ("code", "files"),
    [
        (
            "visible-action",
            {"a.rbd.xml": EVENTS.format('<event name="e"><speech>Hi</speech></event>')},
        ),
        (
            "undeclared-module",
            {"s.spds.xml": SCRIPT.format("", '<module name="m" priority="1"/>')},
        ),
        (
            "dangling-next",
            {"a.rbd.xml": STATE.format('<timeout next="elsewhere">5</timeout>')},
        ),
        (
            "application-without-priority",
            {"a.rbd.xml": SPEAKS, "s.spds.xml": '<spds name="s"/>'},
        ),
        (
            "empty-condition",
            {
                "a.rbd.xml": APPLICATION.format(
                    '<state no="1"/><state no="1"><expectedevents><event name="e"><when/></event>'
                    "</expectedevents></state>"
                )
            },
        ),
        (
            "bad-value",
            {
                "s.spds.xml": SCRIPT.format(
                    '<modules><module name="m" resources="head"/>'
                    '<module name="m" resources="head head"/></modules>',
                    '<module name="m" priority="1"/>',
                )
            },
        ),
    ],
)
def test_nothing_is_offered_where_nothing_sensible_is_known(
    tmp_path: Path, code: str, files: dict[str, str]
) -> None:
    project = project_of(tmp_path, files)
    (problem,) = [one for one in check(project) if one.code == code]
    assert problem.mend is None
    assert mends(project, problem) == []


def test_what_is_not_touched_stays_the_very_object(tmp_path: Path) -> None:
    project = project_of(tmp_path, {"a.rbd.xml": EVENTS.format('<event name="e" next="end"/>')})
    (problem,) = [one for one in check(project) if one.code == "dangling-next"]
    ((_, after),) = mends(project, problem)
    before = project.applications["a.rbd.xml"]
    assert isinstance(after, Application)
    assert after.states[1] is before.states[1]
    assert after.states[0] is not before.states[0]


def test_a_comment_before_what_is_taken_out_stays(tmp_path: Path) -> None:
    files = {
        "s.spds.xml": SCRIPT.format(
            '<observe><data tag="t"/><!-- why --><data tag="t"/><!-- u --><data tag="u"/>'
            "</observe>",
            "",
        )
    }
    project = project_of(tmp_path, files)
    after, done = safe(project, check(project))
    assert [one.code for one in done] == ["double-data"]
    assert after.spds is not None
    assert [data.tag for data in after.spds.observe] == ["t", "u"]
    assert after.spds.observe[1].aside.before == ("<!-- why -->", "<!-- u -->")


def test_several_safe_mends_of_one_file_are_all_applied(tmp_path: Path) -> None:
    data = '<data tag="t"/>' * 4 + '<data tag="u"/>' * 3
    project = project_of(tmp_path, {"s.spds.xml": SCRIPT.format(f"<observe>{data}</observe>", "")})
    after, done = safe(project, check(project))
    assert len(done) == 5
    assert after.spds is not None
    assert [one.tag for one in after.spds.observe] == ["t", "u"]


APPLIED = Application("a", states=(State("1"), State("2")))


@pytest.mark.parametrize(
    "change",
    [
        Change(("states", 0, "name"), "set", '"x"', '"y"'),
        Change(("states", 5, "name"), "set", '"x"', '""'),
        Change(("states", 0, "nonsense"), "set", '"x"', '""'),
        Change(("nothing", 0, "name"), "set", '"x"', '""'),
        Change(("states", 3), "insert", "{}"),
        Change(("states", 0), "remove", was='{"struct": "State", "no": "7"}'),
        Change(("states", 7), "remove", was="null"),
        Change(("states", 0, "ed:accept"), "set", "null", '"tie"'),
    ],
)
def test_a_mend_whose_place_has_changed_is_stale(change: Change) -> None:
    with pytest.raises(Stale):
        apply(APPLIED, Mend("a.rbd.xml", "Do it", (change,)))
    project = Project(root=".", name="a", applications={"a.rbd.xml": APPLIED})
    problem = Problem(
        file="a", code="c", message="m", mend=Mend("a.rbd.xml", "Do", (change,), True)
    )
    assert mends(project, problem) == []
    assert safe(project, [problem]) == (project, [])


def test_a_mend_of_a_file_that_the_project_has_not_is_nothing() -> None:
    project = Project(root=".", name="a", applications={"a.rbd.xml": APPLIED})
    mend = Mend("b.rbd.xml", "Do it", (), safe=True)
    problem = Problem(file="b", code="c", message="m", mend=mend)
    assert of(project, "b.rbd.xml") is None
    assert mends(project, problem) == []
    assert safe(project, [problem]) == (project, [])


def test_a_part_is_put_back_as_a_part() -> None:
    project = Project(root=".", name="a", parts={"p.rbd.xml": APPLIED})
    other = replace(APPLIED, name="b")
    assert put(project, "p.rbd.xml", other).parts == {"p.rbd.xml": other}
    assert of(put(project, "p.rbd.xml", other), "p.rbd.xml") is other
