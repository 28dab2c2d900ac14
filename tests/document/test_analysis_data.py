"""Data that nobody writes and modules that nobody provides, beside runs of the robot."""

from __future__ import annotations

from pathlib import Path
from random import Random
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from situ.decide import inputs, trace
from situ.decide.robot import Robot
from situ.document import codec, mend
from situ.document.analysis_data import Data, kind_of
from situ.document.check import check
from situ.document.folder import load
from situ.document.modules import Module, Modules, Provides, Requires
from situ.document.problem import Problem
from situ.document.project import Mqtt, Project, Setting
from situ.document.rbd import (
    Action,
    Add,
    Append,
    Application,
    Button,
    Clear,
    Event,
    Input,
    List,
    Result,
    Screen,
    Service,
    Set,
    State,
    Take,
)
from situ.document.spds import Declaration, Entry, Observed, Situation, Spds
from situ.document.value_sets import ANY, NOTHING_EVER

FILE, SCRIPT, INFORMATION = "a.rbd.xml", "a.spds.xml", "modules.xml"
CODES = ("unwritten-data", "unprovided-module")
SHAPE = 'x="1" y="1" width="9" height="9"'


def application(text: str) -> Application:
    document, problems = codec.read(f'<application name="a">{text}</application>'.encode(), FILE)
    assert isinstance(document, Application), problems
    assert not problems
    return document


def project(
    states: str = "",
    *,
    modules: Modules | None = None,
    observe: tuple[str, ...] | None = None,
    whole: bool = True,
    **more: Any,
) -> Project:
    script = None
    if observe is not None:
        script = Spds(
            "s",
            tuple(Observed(tag) for tag in observe),
            (Declaration("eyes", ("head",)),),
            (Situation("s", entries=(Entry("a", 1), Entry("eyes", 2))),),
        )
    return Project(
        root="nowhere",
        name="a",
        toml="situ.toml" if whole else None,
        applications={FILE: application(states or '<state no="1" final="true"/>')},
        spds=script,
        spds_file=None if script is None else SCRIPT,
        modules=modules,
        modules_file=None if modules is None else INFORMATION,
        **more,
    )


def does(actions: str) -> str:
    return f'<state no="1" final="true"><backgroundactions>{actions}</backgroundactions></state>'


def shows(components: str, more: str = "") -> str:
    return f"<screen{more}><components>{components}</components></screen>"


def on(screen: str) -> str:
    return f'<state no="1" final="true">{screen}</state>'


def expects(inside: str) -> str:
    event = f'<event name="e" next="1">{inside}</event>'
    return f'<state no="1"><expectedevents>{event}</expectedevents></state>'


def when(test: str) -> str:
    return expects(f"<when>{test}</when>")


def found(source: Project) -> list[Problem]:
    return [one for one in check(source) if one.code in CODES]


def told(source: Project) -> list[tuple[str, ...]]:
    return [(one.code, *one.place) for one in found(source)]


SAYS = does("<speech>Hello {user.name}</speech>")
ACTION = ("unwritten-data", "state", "1", "action", "0")
BLIND = Modules((Module("eyes", ("head",)),))
"""Module information of one that writes nothing."""

# -- what is read --------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("states", "place"),
    [
        (SAYS, ("action", "0")),
        (does('<sound src="{user.name}.ogg"/>'), ("action", "0")),
        (does('<set tag="b">{user.name}</set>'), ("action", "0")),
        (does('<add tag="b">{user.name}</add>'), ("action", "0")),
        (does('<append tag="b">{user.name}</append>'), ("action", "0")),
        (does('<take from="user.name" tag="b"/>'), ("action", "0")),
        (does('<message topic="{user.name}"/>'), ("action", "0")),
        (does('<message topic="t">{user.name}</message>'), ("action", "0")),
        (does('<message topic="t"><param name="p">{user.name}</param></message>'), ("action", "0")),
        (does('<service name="s" url="{user.name}"/>'), ("action", "0")),
        (
            does('<robot resource="r" command="c"><param name="p">{user.name}</param></robot>'),
            ("action", "0"),
        ),
        (
            does('<launch program="c"><param name="p">{user.name}</param></launch>'),
            ("action", "0"),
        ),
        (on(shows(f'<text id="t" {SHAPE}>{{user.name}}</text>')), ("screen", "t")),
        (on(shows(f'<button id="t" {SHAPE}>{{user.name}}</button>')), ("screen", "t")),
        (on(shows(f'<button id="t" {SHAPE} tag="b" value="{{user.name}}"/>')), ("screen", "t")),
        (on(shows(f'<image id="t" {SHAPE} src="{{user.name}}"/>')), ("screen", "t")),
        (on(shows(f'<movie id="t" {SHAPE} src="{{user.name}}"/>')), ("screen", "t")),
        (on(shows(f'<list id="t" {SHAPE} items="user.name"/>')), ("screen", "t")),
        (on(shows("", ' background="{user.name}"')), ("screen",)),
        (when('<data tag="user.name" is="1"/>'), ("event", "0", "when", "0")),
        (
            when('<any><data tag="user.name" is="1"/><data tag="listen.0" is="a"/></any>'),
            ("event", "0", "when", "0", "0"),
        ),
        (when('<data tag="listen.0" is="{user.name}"/>'), ("event", "0", "when", "0")),
        (
            expects("<say>{user.name}</say>"),
            ("event", "0", "say", "0"),
        ),
        (
            expects('<set tag="b">{user.name}</set>'),
            ("event", "0", "action", "0"),
        ),
    ],
)
def test_what_is_read_must_be_written(states: str, place: tuple[str, ...]) -> None:
    assert told(project(states)) == [("unwritten-data", "state", "1", *place)]
    assert told(project(states, tags={"user.name": "Ann"})) == []
    assert told(project(states, tags={"user": {"name": "Ann"}})) == []
    assert told(project(states, tags={"user.name.first": "Ann"})) != []


def test_a_list_reads_its_entries_beside_what_its_label_names() -> None:
    one = f'<list id="t" {SHAPE} items="b" label="{{item}} {{item.name}} {{user.name}}"/>'
    place = ("unwritten-data", "state", "1", "screen", "t")
    assert told(project(on(shows(one)), tags={"b": []})) == [place]


def test_a_message_with_params_does_not_send_its_text() -> None:
    text = '<message topic="t">{user.name}<param name="p">1</param></message>'
    assert told(project(does(text))) == []


def test_the_screen_of_always_reads_too() -> None:
    text = f'<always>{shows(f"""<text id="t" {SHAPE}>{{b}}</text>""")}</always>'
    assert told(project(text + '<state no="1" final="true"/>')) == [
        ("unwritten-data", "always", "screen", "t")
    ]


# -- who writes ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    "writer",
    [
        does('<set tag="b">1</set>'),
        does('<set tag="b">{b}</set>'),
        does('<add tag="b">1</add>'),
        does('<append tag="b">1</append>'),
        does('<set tag="c">[1]</set><take from="c" tag="b"/>'),
        does('<service name="s" url="http://a/"><result tag="b"/></service>'),
        on(shows(f'<button id="t" {SHAPE} tag="b"/>')),
        on(shows(f'<input id="t" {SHAPE} tag="b"/>')),
        on(shows(f'<input id="t" {SHAPE} tag="b" kind="number"/>')),
        on(shows(f'<list id="t" {SHAPE} items="listen" tag="b"/>')),
    ],
)
def test_what_writes_in_an_application(writer: str) -> None:
    reads = '<state no="2" final="true"><backgroundactions><speech>{b} {b.c}</speech>'
    assert told(project(writer + reads + "</backgroundactions></state>")) == []


def test_what_writes_beside_the_applications() -> None:
    reads = does("<speech>{b}</speech>")
    assert told(project(reads)) == [ACTION]
    assert told(project(reads, tags={"b": 1})) == []
    assert told(project(reads, settings=(Setting("b"),))) == []
    assert told(project(reads, mqtt=Mqtt(incoming={"t": "tag:b"}))) == []
    assert told(project(reads, mqtt=Mqtt(incoming={"t": "event:b"}))) == [ACTION]
    provides = Modules((Module("eyes", ("head",), provides=(Provides("b"),)),))
    assert told(project(reads, modules=provides)) == []


def test_what_is_only_cleared_never_has_a_value() -> None:
    assert told(project(does('<clear tag="b"/><speech>{b}</speech>'))) == [
        ("unwritten-data", "state", "1", "action", "1")
    ]


def test_another_application_and_its_parts_write_for_all() -> None:
    flow = '<state no="2"><flow src="p.rbd.xml"/></state>'
    part = application(does('<set tag="user.name">1</set>'))
    assert told(project(SAYS + flow, parts={"p.rbd.xml": part})) == []


@pytest.mark.parametrize(
    ("name", "is_kept"),
    [
        ("clock.time", True),
        ("clock.hour", False),
        ("situation.name", True),
        ("situation.priorities.a", True),
        ("situation", True),
        ("situation.since", False),
        ("application/a", True),
        ("application/a.state", True),
        ("application/a.suspended", True),
        ("application/a.speed", False),
        ("application/b.state", False),
        ("service/find", True),
        ("service/find.ok", True),
        ("service/find.body", False),
        ("service/lose.ok", False),
        ("robot/head.yaw", True),
        ("robot/speech", True),
        ("robot/neck", False),
        ("module/a/note", True),
        ("module/eyes/head", True),
        ("module/ears/head", False),
        ("listen", True),
        ("heard.text", True),
    ],
)
def test_what_the_runtime_keeps_is_written(name: str, is_kept: bool) -> None:
    text = f'<speech>{{{name}}}</speech><service name="find" url="http://a/"/>'
    assert told(project(does(text), observe=())) == ([] if is_kept else [ACTION])


def test_without_a_script_there_is_no_situation() -> None:
    text = does("<speech>{situation.name}</speech>")
    assert told(project(text)) == [ACTION]


# -- what is known -------------------------------------------------------------------------


def test_a_file_without_a_project_says_nothing_of_the_others() -> None:
    assert told(project(SAYS, whole=False)) == []


def test_without_module_information_modules_write_what_is_observed() -> None:
    assert told(project(SAYS, observe=("user.name",))) == []
    assert told(project(SAYS, observe=("user",))) == []
    assert told(project(SAYS, observe=("face",))) == [ACTION]
    assert told(project(SAYS, observe=("user.name",), modules=BLIND)) == [
        ACTION,
        ("unwritten-data", "data", "user.name"),
    ]


def test_what_a_script_looks_at_is_judged_by_the_module_information() -> None:
    source = project(observe=(), modules=BLIND)
    text = (
        '<spds name="s"><situation name="t"><condition><data tag="face" is="1"/></condition>'
        '<until><data tag="hand" is="1"/></until></situation><situation name="u"/></spds>'
    )
    script, _ = codec.read(text.encode(), SCRIPT)
    assert isinstance(script, Spds)
    places = [
        ("unwritten-data", "situation", "t", "condition", "0"),
        ("unwritten-data", "situation", "t", "until", "0"),
    ]
    assert told(Project(**{**_fields(source), "spds": script})) == places
    without = {"spds": script, "modules": None, "modules_file": None}
    assert told(Project(**{**_fields(source), **without})) == []


def _fields(source: Project) -> dict[str, Any]:
    return {name: getattr(source, name) for name in source.__struct_fields__}


@pytest.mark.parametrize("lost", ["spds_file", "modules_file"])
def test_nothing_is_said_where_a_document_could_not_be_read(lost: str) -> None:
    assert told(Project(**{**_fields(project(SAYS)), lost: "a.xml"})) == []
    assert told(project(SAYS + '<state no="2"><flow src="p.rbd.xml"/></state>')) == []


# -- modules -------------------------------------------------------------------------------


def test_a_module_requires_what_is_there() -> None:
    needs = (Requires(module="camera"), Requires(data="image"))
    eyes = Module("eyes", ("head",), requires=needs)
    at = ("module", "eyes", "requires")
    both = [("unprovided-module", *at, "0"), ("unwritten-data", *at, "1")]
    assert told(project(modules=Modules((eyes,)))) == both
    assert told(project(modules=Modules((eyes, Module("camera"))))) == both[1:]
    camera = Module("camera", provides=(Provides("image"),))
    assert told(project(modules=Modules((eyes, camera)))) == []
    assert told(project(modules=Modules((eyes,)), tags={"image": "a"})) == both[:1]
    other = Module("b", requires=(Requires(module="a"), Requires(module="eyes")))
    assert told(project(modules=Modules((other,)), observe=())) == []


def test_a_service_asks_a_module_that_is_declared() -> None:
    asks = does('<service name="s" url="board:{}/next"/>')
    at = ("unprovided-module", "state", "1", "action", "0")
    assert told(project(asks.format("ears"))) == [at]
    assert told(project(asks.format("eyes"), observe=())) == []
    assert told(project(asks.format("eyes"), modules=BLIND)) == []
    assert told(project(asks.format("{b}"), tags={"b": "ears"})) == []
    both = does('<service name="t" url="http://a/"/><service name="s" url="BOARD:ears/next"/>')
    assert told(project(both)) == [("unprovided-module", "state", "1", "action", "1")]


def test_a_module_that_nobody_declares_is_declared_where_modules_are() -> None:
    asks = does('<service name="s" url="board:cuff/measure"/>')
    nobody = Modules((Module("eyes", ("head",)),))
    for source, file in (
        (project(asks, observe=()), SCRIPT),
        (project(asks, modules=nobody), INFORMATION),
        (project(asks, modules=nobody, observe=()), INFORMATION),
    ):
        (one,) = found(source)
        assert one.mend is not None
        assert (one.mend.file, one.mend.words) == (file, "Declare “cuff”")
        ((_, document),) = mend.mends(source, one)
        after = mend.put(source, file, document)
        assert found(after) == []
        assert after.resources("cuff") == ()
        assert codec.read(codec.write(document), "x") == (document, [])
    (one,) = found(project(asks))
    assert one.mend is None


# -- words and mends -----------------------------------------------------------------------


def test_a_name_is_told_once_a_file_with_how_often_it_is_used() -> None:
    (one,) = found(project(does("<speech>{b}</speech><speech>{b}, {b}</speech>")))
    assert "“b” (used 3 times here), so it never has a value" in one.message


def after(source: Project) -> tuple[Problem, list[Problem]]:
    (one,) = found(source)
    assert one.mend is not None
    assert not one.mend.safe
    ((_, document),) = mend.mends(source, one)
    return one, found(mend.put(source, one.mend.file, document))


@pytest.mark.parametrize(
    "states",
    [
        does("<speech>Hello {user.nmae}</speech>"),
        does('<take from="user.nmae" tag="b"/>'),
        on(shows(f'<list id="t" {SHAPE} items="user.nmae"/>')),
        when('<data tag="user.nmae" is="1"/>'),
    ],
)
def test_a_name_that_is_nearly_written_was_meant(states: str) -> None:
    one, left = after(project(states, tags={"user.name": "Ann"}))
    assert "did you mean “user.name”?" in one.message
    assert left == []


def test_among_very_many_names_none_is_looked_for() -> None:
    tags = {f"user.n{number}": 1 for number in range(400)}
    (one,) = found(project(does("<speech>{user.nn1}</speech>"), tags=tags))
    assert "did you mean" not in one.message


def test_a_name_in_a_param_is_left_to_the_designer() -> None:
    text = does('<message topic="t"><param name="p">{user.nmae}</param></message>')
    (one,) = found(project(text, tags={"user.name": "Ann"}))
    assert one.mend is None


def test_of_two_states_of_one_number_nothing_is_mended() -> None:
    text = '<state no="1"/>' + does("<speech>Hello {user.nmae}</speech>")
    problems = check(project(text, tags={"user.name": "Ann"}))
    assert "double-state" in [one.code for one in problems]
    assert [one.mend for one in problems if one.code in CODES] == [None]


def test_without_module_information_it_can_be_observed_at_a_click() -> None:
    one, left = after(project(SAYS, observe=()))
    assert "or observe it in the script" in one.message
    assert left == []
    (one,) = found(project(does("<speech>{robot/neck}</speech>"), observe=()))
    assert one.mend is None
    assert "observe" not in one.message


def test_a_warning_stands_where_the_name_is_written_and_can_be_accepted(tmp_path: Path) -> None:
    told_at = [("a.rbd.xml", 5, 38, "unwritten-data"), ("modules.xml", 3, 3, "unprovided-module")]
    written = (
        '<application name="a" xmlns:ed="urn:situ:editor">\n<state no="1" final="true">\n'
        "<backgroundactions>\n<speech>Hello</speech>\n"
        '<robot resource="head" command="nod"><param name="who">{user.name}</param></robot>\n'
        "</backgroundactions></state></application>"
    )
    modules = (
        '<modules>\n<module name="eyes" resources="">\n  <requires module="b"/></module></modules>'
    )
    (tmp_path / "situ.toml").write_text(
        '[project]\napplications = ["a.rbd.xml"]\nmodules = "modules.xml"\n'
    )
    (tmp_path / "a.rbd.xml").write_text(written)
    (tmp_path / "modules.xml").write_text(modules)

    def places() -> list[tuple[str, int, int, str]]:
        source, problems = load(tmp_path)
        assert source is not None
        assert not problems
        return [(Path(p.file).name, p.line, p.column, p.code) for p in found(source)]

    assert places() == told_at
    accepted = written.replace("<robot ", '<robot ed:accept="unwritten-data" ')
    (tmp_path / "a.rbd.xml").write_text(accepted)
    assert places() == told_at[1:]


@pytest.mark.parametrize(
    "source",
    [
        project(does('<service name="s" url="board:eye/next"/>'), modules=BLIND),
        project(modules=Modules((Module("eyes"), Module("b", requires=(Requires(module="eye"),))))),
        project(
            tags={"image.left": 1},
            modules=Modules((Module("b", requires=(Requires(data="image.lfet"),)),)),
        ),
    ],
)
def test_a_module_that_is_nearly_there_was_meant(source: Project) -> None:
    one, left = after(source)
    assert "did you mean" in one.message
    assert left == []


# -- what is known of values ---------------------------------------------------------------


def test_the_type_of_a_name_is_known_where_all_who_write_it_agree() -> None:
    provides = Modules(
        (
            Module(
                "eyes",
                provides=(Provides("b", "number"), Provides("c")),
            ),
        )
    )
    number = Data(project(modules=provides)).domain("b")
    assert number.kinds == {"number"}
    assert Data(project(modules=provides, tags={"b": 1})).domain("b") == number
    assert Data(project(modules=provides, tags={"b": "a"})).domain("b") == ANY
    assert Data(project(does('<set tag="b">{c}</set>'), modules=provides)).domain("b") == ANY
    assert Data(project(modules=provides)).domain("c") == ANY
    observed = Spds("s", (Observed("c", "text"), Observed("b", "text")))
    looked_at = Data(Project(root="nowhere", name="a", spds=observed, modules=provides))
    assert looked_at.domain("c").kinds == {"text"}
    assert looked_at.domain("b") == ANY
    values: list[Any] = [True, 1, "a", [], {}, None]
    assert [kind_of(value) for value in values] == [
        "boolean",
        "number",
        "text",
        "list",
        "object",
        None,
    ]


def test_what_the_runtime_keeps_has_the_values_that_it_writes() -> None:
    data = Data(project(does('<service name="find" url="http://a/"/>'), observe=()))
    assert data.domain("situation.name").words == ("s",)
    assert data.domain("application/a.state").words == ("1",)
    assert data.domain("application/a.suspended").kinds == {"boolean"}
    assert data.domain("application/a.name") == ANY
    assert data.domain("application/b.state") == NOTHING_EVER
    assert data.domain("service/find.status").kinds == {"number"}
    assert data.domain("service/find") == ANY
    assert data.domain("service/lose.ok") == NOTHING_EVER
    words = data.domain("clock.time").words
    assert words is not None
    assert (words[0], words[-1]) == ("00:00", "23:59")
    assert Data(project()).domain("situation.name") == NOTHING_EVER


# -- beside the robot ----------------------------------------------------------------------

TAGS = ("a", "a.b", "a.b.c", "d", "d.e")


class Maker:
    """Applications of one state in which a few tags are written in all ways that there are."""

    def __init__(self, seed: int) -> None:
        self.random = Random(seed)

    def project(self) -> Project:
        random = self.random
        actions = tuple(self.action() for _ in range(random.choice([1, 2, 3])))
        shown = tuple(self.component(n) for n in range(random.choice([0, 1])))
        reads = tuple(Set(tag="read", text=f"{{{name}}}") for name in (*TAGS, "a.b.c.f", "d.e.0"))
        states = (
            State(
                "1", screen=Screen(None, None, shown), actions=actions, events=(Event("e", "2"),)
            ),
            State("2", actions=reads, final=True),
        )
        return Project(
            root="nowhere",
            name="a",
            toml="situ.toml",
            applications={FILE: Application("a", None, None, states)},
            tags={random.choice(TAGS): 1} if random.random() < 0.3 else {},
        )

    def action(self) -> Action:
        random, tag = self.random, self.random.choice(TAGS)
        match random.randrange(6):
            case 0:
                return Set(tag=tag, text='{"b": {"c": {"f": 1}, "e": [1]}}')
            case 1:
                return Add(tag=tag, text="1")
            case 2:
                return Append(tag=tag, text="1")
            case 3:
                return Clear(tag=tag)
            case 4:
                return Take(source="list", tag=tag)
            case _:
                return Service(name="s", url="http://a/", results=(Result(tag),))

    def component(self, number: int) -> Button | Input | List:
        shape: dict[str, Any] = {"id": f"c{number}", "x": 1.0, "y": 1.0}
        shape.update(width=9.0, height=9.0)
        tag = self.random.choice(TAGS)
        match self.random.randrange(3):
            case 0:
                return Button(**shape, tag=tag, value="1")
            case 1:
                return Input(**shape, tag=tag)
            case _:
                return List(**shape, items="list", tag=tag)


@given(seed=st.integers(0, 2**64))
@settings(max_examples=50, deadline=None)
def test_what_is_told_has_no_value_in_any_run_and_what_has_a_tag_is_not_told(seed: int) -> None:
    source = Maker(seed).project()
    names = (*TAGS, "a.b.c.f", "d.e.0")
    robot = Robot(source)
    valued: set[str] = set()
    stood: set[str] = set()
    for given_ in (
        inputs.Start(),
        inputs.Use("c0", "1"),
        inputs.Use("c0"),
        inputs.Finish("service", result={"b": {"c": {"f": 1}}}),
        inputs.Finish("service", result=[1]),
        inputs.Finish("service", result=1),
        inputs.Set({"list": [1]}, "m"),
        inputs.Use("c0", {"b": {"c": {"f": 1}}}),
        inputs.Raise("e"),
    ):
        events, _ = robot.step(given_, 0)
        writes = [one for one in events if isinstance(one, trace.Data)]
        stood |= {one.tag for one in writes if one.value is not None}
        valued |= {name for name in names if robot.board.look(name) is not None}
    quoted = [one.message.split("“")[1].split("”")[0] for one in found(source)]
    unwritten = set(quoted) & set(names)
    assert not unwritten & valued
    # Nothing is taken out of a list that nobody fills.
    takes = {
        one.tag for one in source.applications[FILE].states[0].actions if isinstance(one, Take)
    }
    for name in set(names) - unwritten:
        parts = name.split(".")
        tags = {".".join(parts[:count]) for count in range(1, len(parts) + 1)}
        assert tags & (stood | takes)
