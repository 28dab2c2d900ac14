"""formats.md, *Values, references, conditions*: tags, names, references, templates."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING
from xml.sax.saxutils import escape

import pytest

if TYPE_CHECKING:
    from tests.decide.conftest import Play


def setting(text: str) -> str:
    return (
        '<state no="1"><backgroundactions><set tag="out">'
        f"{escape(text)}</set></backgroundactions></state>"
    )


# -- tags --------------------------------------------------------------------


@pytest.mark.parametrize("tag", ["a", "a.b", "a1.b-c.d_e", "a_b", "service/x", "module/app/head"])
def test_a_tag_is_dotted_words_or_a_path_under_a_reserved_root(play: Play, tag: str) -> None:
    writer = {"at": 1, "set": {tag: 1}}
    trace = play(setting("1"), [writer])
    refused = tag.startswith("module/")  # the scenario is not that module
    assert len(trace.of("error")) == refused


@pytest.mark.parametrize("tag", ["A", "1a", "a b", "", "a.", ".a", "a..b", "a/b", "é", "a.1", "_a"])
def test_what_is_no_tag_can_not_be_set(play: Play, tag: str) -> None:
    trace = play(setting("1"), [{"at": 1, "set": {tag: 1, "fine": 1}}])
    (error,) = [e for e in trace if e["t"] == 1]
    assert error["kind"] == "error"
    assert error["message"].startswith(f"{tag} is no tag" if tag else "'' is no tag")


def test_a_tag_set_to_null_is_deleted(play: Play) -> None:
    trace = play(setting("{x}"), [{"at": 1, "set": {"x": None}}], tags={"x": 1})
    assert trace.lines("data", since=1) == ["1 data x null scenario v2 <-"]


def test_deleting_what_is_missing_changes_nothing(play: Play) -> None:
    lines = [
        {"at": 1, "set": {"x": None}},
        {"at": 2, "set": {"x": 1}},
        {"at": 3, "set": {"x": None}},
        {"at": 4, "set": {"x": None}},
        {"at": 5, "set": {"x": 2}},
    ]
    assert play(setting("1"), lines).lines("data", since=1) == [
        "2 data x 1 scenario v1 <-",
        "3 data x null scenario v2 <-",
        "5 data x 2 scenario v3 <-",
    ]


# -- names -------------------------------------------------------------------

TAGS = {
    "patient": {"room": 7, "roomNumber": "7b", "Ward-A": {"x_1": True}, "0": "zero"},
    "patients": [{"name": "Ann"}, {"name": "Bo"}],
    "a": {"b": {"c": 1, "d": 2}},
    "a.b": {"c": 3},
}


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("patient.room", 7),
        ("patient.roomNumber", "7b"),
        ("patient.Ward-A.x_1", True),
        ("patient.0", "zero"),
        ("patients.1.name", "Bo"),
        ("patients.0", {"name": "Ann"}),
        # The longest tag that begins the name counts, and only that.
        ("a.b.c", 3),
        ("a.b", {"c": 3}),
        ("a.b.d", None),
        ("patients.2", None),
        ("patients.-1", None),
        ("patients.name", None),
        ("patient.room.x", None),
        ("nobody.room", None),
    ],
)
def test_a_name_is_the_longest_tag_that_begins_it_then_fields_and_places(
    play: Play, name: str, value: object
) -> None:
    trace = play(setting(f"{{{name}}}"), [], tags=TAGS)
    assert trace.of("action")[0]["value"] == value
    assert len(trace.of("warning")) == (value is None)


def test_paths_under_reserved_roots_are_names_too(play: Play) -> None:
    rbd = (
        '<state no="1" name="hall"><backgroundactions><robot resource="head" command="nod"/>'
        '<set tag="out">{application/app.name} {robot/head.command} {module/app/head.command}'
        "</set></backgroundactions></state>"
    )
    assert play(rbd, []).values("out") == ["hall nod nod"]


# -- templates ---------------------------------------------------------------

FILL = {
    "n": 2.0,
    "half": 0.5,
    "s": "Ann",
    "t": "true",
    "l": [1.0, "x"],
    "o": {"a": None},
    "b": True,
}


@pytest.mark.parametrize(
    ("text", "value"),
    [
        # What reads as JSON is that value.
        ("3", 3),
        ("-0.5", -0.5),
        ("true", True),
        ("null", None),
        ('"3"', "3"),
        ('[1, "a", {"b": null}]', [1, "a", {"b": None}]),
        # References are filled in inside its strings only.
        ('["{s}", "{n} of {l}"]', ["Ann", '2 of [1,"x"]']),
        ('{"who": "{s}", "deep": {"n": ["{n}"]}}', {"who": "Ann", "deep": {"n": ["2"]}}),
        ('"{n}"', "2"),
        ("[{n}]", "[2]"),
        # Exactly one reference copies the value with its type.
        ("{n}", 2.0),
        ("{s}", "Ann"),
        ("{t}", "true"),
        ("{l}", [1.0, "x"]),
        ("{o}", {"a": None}),
        ("{b}", True),
        # All else is a string.
        ("three", "three"),
        ("{s}!", "Ann!"),
        ("{n}{n}", "22"),
        ("{n} {half} {l} {o} {b}", '2 0.5 [1,"x"] {"a":null} true'),
        ("NaN", "NaN"),
        ("01", "01"),
        ("", ""),
        # Braces.
        ("{{s}}", "{s}"),
        ("{{{s}}}", "{Ann}"),
        ("a}}b{{c", "a}b{c"),
        ("{no name}", "{no name}"),
        ("{}", {}),
        ("{S}", "{S}"),
        ("{ s }", "{ s }"),
        ("x {", "x {"),
        # White space at both ends does not count.
        ("  {n}\n ", 2.0),
        ("  3 ", 3),
        ("  two  words ", "two  words"),
    ],
)
def test_what_a_text_in_a_set_means(play: Play, text: str, value: object) -> None:
    (action,) = play(setting(text), [], tags=FILL).of("action")
    assert json.dumps(action["value"]) == json.dumps(value)


def test_a_param_is_read_like_a_set(play: Play) -> None:
    rbd = (
        '<state no="1"><backgroundactions><robot resource="head" command="nod">'
        '<param name="a">{n}</param><param name="b"> [1, "{s}"] </param>'
        '<param name="c">{s}!</param>'
        "</robot></backgroundactions></state>"
    )
    params = play(rbd, [], tags=FILL).of("action")[0]["params"]
    assert json.dumps(params) == json.dumps({"a": 2.0, "b": [1, "Ann"], "c": "Ann!"})


def test_a_text_is_always_a_string(play: Play) -> None:
    rbd = (
        '<state no="1"><backgroundactions><speech>{n}</speech><sound src="{s}.ogg"/>'
        '<service name="x" url="{s}/{n}"/></backgroundactions></state>'
    )
    trace = play(rbd, [{"at": 1, "finish": {"action": "speech"}}], tags=FILL)
    texts = [e.get("text", e.get("src", e.get("url"))) for e in trace.of("action")]
    assert texts == ["2", "Ann/2", "Ann.ogg"]


@pytest.mark.parametrize(("text", "value"), [("Hi {gone}!", "Hi !"), ("{gone}", None)])
def test_a_missing_value_is_nothing_with_a_warning_and_alone_null(
    play: Play, text: str, value: object
) -> None:
    trace = play(setting(text), [], tags={"out": 1})
    assert trace.lines("warning", "action") == [
        "0 warning gone has no value <enter",
        f'0 action app 1 set - tag="out" value={json.dumps(value)} <enter',
    ]
    assert trace.values("out") == [1, value]


def test_what_is_missing_twice_in_a_text_is_warned_of_once(play: Play) -> None:
    trace = play(setting("{gone} {gone} {lost}"), [])
    assert [e["message"] for e in trace.of("warning")] == [
        "gone has no value", "lost has no value",
    ]  # fmt: skip
