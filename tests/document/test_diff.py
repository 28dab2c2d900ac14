"""``situ diff``: by meaning, in plain words, what only moved told apart (issue 3, point 3)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from random import Random
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec import Struct
from msgspec.structs import fields, replace

from situ.cli import main
from situ.document import codec, rbd
from situ.document import condition as conditions
from situ.document.aside import Aside
from situ.document.condition import Condition, Group
from situ.document.diff import compare
from situ.document.diff_media import compare_media
from situ.document.folder import load
from situ.document.project import Mqtt, Project, Setting
from situ.errors import UsageError

Place = tuple[str, ...]

# -- laws --------------------------------------------------------------------

SEEDS = st.integers(0, 10**9)


@given(seed=SEEDS)
@settings(max_examples=60, deadline=None)
def test_a_document_does_not_differ_from_itself(
    make_document: Callable[[int], Any], seed: int
) -> None:
    document = make_document(seed)
    assert compare(document, _copied(document)) == []


@given(seed=SEEDS)
@settings(max_examples=150, deadline=None)
def test_every_edit_of_one_field_is_told_at_its_place(
    make_document: Callable[[int], Any], seed: int
) -> None:
    document, random = make_document(seed), Random(seed)
    every = list(_edits(document))
    if not every:  # an empty <modules/>
        return
    place, path, edited = random.choice(every)
    assert edited != document
    for before, after in ((document, edited), (edited, document)):
        changes = compare(before, after)
        assert any(_names(change.place, place) for change in changes), (path, place, changes)
        assert all(len(change.text.splitlines()) == 1 for change in changes)


@given(seed=SEEDS, other=SEEDS)
@settings(max_examples=60, deadline=None)
def test_any_two_documents_are_told_apart_where_they_differ(
    make_document: Callable[[int], Any], seed: int, other: int
) -> None:
    before, after = make_document(seed), make_document(other)
    if type(before) is not type(after):
        assert [change.behaviour for change in compare(before, after)] == [True]
        return
    changes = compare(before, after)
    assert bool([c for c in changes if c.kind not in ("moved", "drawing")]) == (before != after)


@given(seed=SEEDS)
@settings(max_examples=60, deadline=None)
def test_what_only_moved_is_no_change_of_behaviour(
    make_document: Callable[[int], Any], seed: int
) -> None:
    document = make_document(seed)
    moved = _moved(document)
    changes = compare(document, moved)
    assert changes
    assert {change.kind for change in changes} == {"moved"}
    assert not any(change.behaviour for change in changes)


def _copied(value: Any) -> Any:
    """An equal value that is nowhere the same object."""
    if isinstance(value, tuple):
        return tuple(_copied(one) for one in value)
    if isinstance(value, Struct):
        return replace(value, **{f.name: _copied(getattr(value, f.name)) for f in fields(value)})
    return value


def _moved(value: Any) -> Any:
    """With another position at every element."""
    if isinstance(value, Aside):
        x, y = value.position or (0.0, 0.0)
        return value.at(x + 1, y)
    if isinstance(value, tuple):
        return tuple(_moved(one) for one in value)
    if isinstance(value, Struct):
        return replace(value, **{f.name: _moved(getattr(value, f.name)) for f in fields(value)})
    return value


_WORDS = {
    "states": ("state", "no"), "actions": ("action", ""), "events": ("event", ""),
    "says": ("say", ""), "params": ("param", ""), "results": ("result", ""),
    "components": (None, "id"), "children": (None, ""), "observe": ("data", "tag"),
    "modules": ("module", "name"), "situations": ("situation", "name"), "entries": ("entry", ""),
    "requires": ("requires", ""), "provides": ("provides", ""),
}  # fmt: skip
_OTHER = {
    "kind": ("text", "pin"), "align": ("left", "right"), "order": ("first", "random"),
    "test": ("is", "isnot"), "type": ("text", "number"),
}  # fmt: skip


def _edits(value: Any, place: Place = (), path: str = "") -> Iterator[tuple[Place, str, Any]]:
    """Every edit of one field of a document: its place, its path, the document edited."""
    for field in fields(value):
        name, held = field.name, getattr(value, field.name)
        if isinstance(held, Aside) or held is None:
            continue
        if name in _WORDS and isinstance(held, tuple) and (name != "resources"):
            word, key = _WORDS[name]
            for index, one in enumerate(held):
                last = getattr(one, key) if key else str(index)
                inner = (*place, *([word] if word else []), last)
                rest = (held[:index], held[index + 1 :])
                yield inner, f"{path}.-{name}", replace(value, **{name: (*rest[0], *rest[1])})
                for where, way, edited in _edits(one, inner, f"{path}.{name}"):
                    whole = (*rest[0], edited, *rest[1])
                    yield where, way, replace(value, **{name: whole})
        elif isinstance(held, Struct):
            inner = (*place, name)
            if field.default is None:
                yield inner, f"{path}.-{name}", replace(value, **{name: None})
            for where, way, edited in _edits(held, inner, f"{path}.{name}"):
                yield where, way, replace(value, **{name: edited})
        else:
            yield place, f"{path}.{name}", replace(value, **{name: _changed(name, held, value)})


def _changed(name: str, held: Any, value: Any) -> Any:
    if name in _OTHER and not (name == "kind" and isinstance(value, Group)):
        first, second = _OTHER[name]
        return second if held == first else first
    if name == "kind":
        return "any" if held != "any" else "none"
    if isinstance(held, bool):
        return not held
    if isinstance(held, tuple):
        return (*held, "tail")
    return held + (1 if isinstance(held, (int, float)) else "z")


def _names(told: Place, place: Place) -> bool:
    """Whether a change's place names an edit's: it, or a condition or a group around it; the
    last word may be another where the edit is of the name itself or of the order.
    """
    if told == place[: len(told)] and len(told) >= min(len(place), 2):
        return True
    return len(told) == len(place) and told[:-1] == place[:-1]


# -- words -------------------------------------------------------------------


def _read(text: str, name: str = "a") -> Any:
    document, problems = codec.read(text.encode(), name)
    assert not problems
    return document


def _told(before: str, after: str) -> list[str]:
    return [change.text for change in compare(_read(before), _read(after))]


def _application(states: str) -> str:
    return f'<application name="a">{states}</application>'


PILLS = """<state no="1" name="Take pills"><timeout next="2">{seconds}</timeout>
<backgroundactions><speech>{text}</speech></backgroundactions>
<expectedevents>{events}</expectedevents></state><state no="2" name="done"/>"""
EVENTS = """<event name="yes" next="2"/><event name="no" next="1"><when>
<data tag="a" above="1"/><data tag="b" exists="true"/></when></event>"""


def _pills(seconds: str = "30", text: str = "Now", events: str = EVENTS) -> str:
    return _application(PILLS.format(seconds=seconds, text=text, events=events))


@pytest.mark.parametrize(
    ("after", "told"),
    [
        (_pills(seconds="60"), "state Take pills: timeout 30 → 60 s"),
        (_pills(text="Later"), "state Take pills, speech: “Now” → “Later”"),
        (
            _pills(events=EVENTS.replace('above="1"', 'above="2.5"')),
            "state Take pills, event no, guard: a above 1 → above 2.5",
        ),
        (
            _pills(events=EVENTS.replace('<data tag="b" exists="true"/>', "")),
            "state Take pills, event no: guard a above 1 and b exists → a above 1",
        ),
        (
            _pills(events=EVENTS.replace('name="yes" next="2"', 'name="yes" next="1"')),
            "state Take pills, event yes: leads to 2 done → 1 Take pills",
        ),
        (
            _pills(events=EVENTS.replace('<event name="yes" next="2"/>', "")),
            "state Take pills: event yes, leads to 2 done gone",
        ),
        (
            _pills(events=EVENTS + '<event name="maybe"/>'),
            "state Take pills: event maybe added",
        ),
        (
            _pills().replace("<speech>", '<speech bargein="true">'),
            "state Take pills, speech: may be interrupted by speech no → yes",
        ),
        (
            _pills().replace("</backgroundactions>", '<clear tag="a"/></backgroundactions>'),
            "state Take pills: clear a added",
        ),
        (_pills().replace('name="a"', 'name="b"'), "name a → b"),
        (
            _pills().replace("<application", "<application start='2'"),
            "starts in 1 Take pills → 2 done",
        ),
    ],
)  # fmt: skip
def test_a_change_is_one_line_in_plain_words(after: str, told: str) -> None:
    assert _told(_pills(), after) == [told]


def test_of_a_long_text_what_differs_is_shown() -> None:
    long = "Good morning, this is a rather long text of which nearly all stays as it is, {}, always"
    (line,) = _told(_pills(text=long.format("here")), _pills(text=long.format("there")))
    assert "“…all stays as it is, here, always” → “…all stays as it is, there, always”" in line


def test_a_renamed_state_is_known_by_its_number() -> None:
    after = _pills().replace("Take pills", "Take tablets")
    assert _told(_pills(), after) == ["state Take pills: name “Take pills” → “Take tablets”"]


def test_a_renumbered_state_is_known_by_its_content_and_what_leads_to_it_is_unchanged() -> None:
    after = _pills().replace('no="2"', 'no="7"').replace('next="2"', 'next="7"')
    assert _told(_pills(), after) == ["state done: number 2 → 7"]


def test_a_state_put_in_before_others_renumbers_them_without_other_changes() -> None:
    states = '<state no="{}"><expectedevents><event name="{}" next="{}"/></expectedevents></state>'
    before = _application(states.format(1, "a", 2) + states.format(2, "b", 1))
    after = _application(
        states.format(1, "new", 2) + states.format(2, "a", 3) + states.format(3, "b", 2)
    )
    assert set(_told(before, after)) == {
        "state 1: added",
        "state 1: number 1 → 2",
        "state 2: number 2 → 3",
        "starts in 1 → 1",
    }


def test_the_order_of_events_counts_where_they_compete() -> None:
    one, other, same = '<event name="x" next="1"/>', '<event name="y"/>', '<event name="x"/>'
    told = compare(_read(_pills(events=one + other)), _read(_pills(events=other + one)))
    assert [change.behaviour for change in told] == [False]
    told = compare(_read(_pills(events=one + same)), _read(_pills(events=same + one)))
    assert [(c.behaviour, c.kind) for c in told] == [(True, "order")]
    assert told[0].text == "state Take pills: event x (1) now comes first"


def test_actions_in_another_order_are_behaviour_states_are_not() -> None:
    actions = ["<set tag='a'>1</set>", "<set tag='b'>2</set>", "<set tag='c'>3</set>"]
    state = '<state no="1"><backgroundactions>{}</backgroundactions></state><state no="2"/>'
    before = _application(state.format("".join(actions)))
    after = _application(state.format("".join(actions[1:] + actions[:1])))
    (change,) = compare(_read(before), _read(after))
    assert (change.text, change.behaviour) == ("state 1: set a now comes after set c", True)
    states = ['<state no="1"/>', '<state no="2"/>']
    first, then = (
        f'<application name="a" start="1">{"".join(s)}</application>'
        for s in (states, states[::-1])
    )
    (change,) = compare(_read(first), _read(then))
    assert (change.kind, change.behaviour) == ("order", False)


SCRIPT = """<spds name="s"><modules><module name="m" resources="head"/></modules>
<situation name="a"><condition><data tag="x" is="1"/></condition><module name="m" priority="9"/>
</situation>
<situation name="b" extends="a"><condition><data tag="y" is="1"/></condition></situation>
<situation name="c"><module name="m" priority="1"/></situation></spds>"""


def test_situations_their_order_and_priorities() -> None:
    after = SCRIPT.replace('priority="9"', 'priority="90"')
    assert _told(SCRIPT, after) == ["situation a, priority of m: 9 → 90"]
    after = SCRIPT.replace('name="a"', 'name="first"').replace('extends="a"', 'extends="first"')
    assert _told(SCRIPT, after) == ["situation a: name a → first"]
    a, b = SCRIPT.index('<situation name="a"'), SCRIPT.index('<situation name="b"')
    c = SCRIPT.index('<situation name="c"')
    swapped = SCRIPT[:a] + SCRIPT[b:c] + SCRIPT[a:b] + SCRIPT[c:]
    (change,) = compare(_read(SCRIPT), _read(swapped))
    assert change.text == "situation b now comes first"
    assert (change.behaviour, change.place) == (True, ("situation", "b"))
    (change,) = compare(_read(SCRIPT[:b] + SCRIPT[c:]), _read(SCRIPT))
    assert change.text == "situation b: added, goes before c"


def test_conditions_of_another_shape_are_told_whole() -> None:
    def guard(inner: str) -> str:
        return _pills(events=f'<event name="e"><when>{inner}</when></event>')

    flat = '<data tag="a" is="1"/>'
    grouped = f'<any>{flat}<data tag="b" exists="false"/></any>'
    assert _told(guard(flat), guard(grouped)) == [
        "state Take pills, event e: guard a is 1 → a is 1 or b is missing"
    ]
    other = grouped.replace('is="1"', 'is="2" for="0.5"')
    (change,) = compare(_read(guard(grouped)), _read(guard(other)))
    assert change.text == "state Take pills, event e, guard: a is 1 → is 2, for 0.5 s"
    assert change.place == ("state", "1", "event", "0", "when", "0", "0")


def test_differences_that_no_words_show_are_shown_as_they_stand() -> None:
    before = Condition((conditions.Test("a", "exists", "true"),))
    after = Condition((conditions.Test("a", "exists", "1"),))
    states = [rbd.State("1", events=(rbd.Event("e", when=w),)) for w in (before, after)]
    first, then = (rbd.Application("a", states=(state,)) for state in states)
    assert [c.text for c in compare(first, then)] == [
        'state 1, event e, guard: a exists="true" → a exists="1"'
    ]
    one, two = (rbd.Application("a", states=(rbd.State("1", name=n),)) for n in ("x y", "x  y"))
    (change,) = compare(one, two)
    assert '"x y" → "x  y"' in change.text


MORE = """<state no="1" name="x"><backgroundactions>
<robot resource="base" command="goto"><param name="place">lobby</param></robot>
<service name="find" url="u"><result tag="a" path="p"/></service>
<message topic="t">hi</message><message topic="u"><param name="p">1</param></message>
<launch program="game"/><sound src="s.ogg"/><add tag="a">1</add><append tag="l">2</append>
<take from="l" tag="b"/></backgroundactions>
<screen><components><button id="b" x="1" y="1" width="9" height="9">Go</button>
<image id="i" x="1" y="1" width="9" height="9" src="i.png"/></components></screen>
<expectedevents><event name="e"><say>hey</say><repeat/></event></expectedevents></state>"""


@pytest.mark.parametrize(
    ("gone", "told"),
    [
        ('<param name="place">lobby</param>', ", robot base: param place “lobby” gone"),
        ('<result tag="a" path="p"/>', ", service find: result a from “p” gone"),
        ('<message topic="t">hi</message>', ": message t “hi” gone"),
        ('<message topic="u"><param name="p">1</param></message>', ": message u gone"),
        ('<launch program="game"/>', ": launch game gone"),
        ('<sound src="s.ogg"/>', ": sound s.ogg gone"),
        ('<add tag="a">1</add>', ": add a + 1 gone"),
        ('<append tag="l">2</append>', ": append 2 to l gone"),
        ('<take from="l" tag="b"/>', ": take b from l gone"),
        ('<image id="i" x="1" y="1" width="9" height="9" src="i.png"/>', ": image i gone"),
        ("<repeat/>", ", event e: repeat gone"),
        ("<say>hey</say>", ", event e: phrase “hey” gone"),
        (MORE[MORE.index("<screen>") : MORE.index("<expected")], ": screen gone"),
    ],
)
def test_what_went_is_named_by_what_it_was(gone: str, told: str) -> None:
    assert gone in MORE
    before, after = _application(MORE), _application(MORE.replace(gone, ""))
    assert _told(before, after) == [f"state x{told}"]
    assert _told(after, before) == [f"state x{told.replace('gone', 'added')}"]


def test_timeouts_screens_guards_and_always_that_came() -> None:
    bare = _application('<state no="1"/>')
    came = {
        '<timeout next="1">5</timeout>': "state 1: timeout 5 s, leads to 1 added",
        "<timeout>5</timeout>": "state 1: timeout 5 s added",
        "<screen/>": "state 1: empty screen added",
    }
    for element, told in came.items():
        assert _told(bare, _application(f'<state no="1">{element}</state>')) == [told]
    whole = '<always><timeout>5</timeout></always><state no="1"/>'
    assert _told(bare, _application(whole)) == ["always added"]
    longer = whole.replace("5", "6")
    assert _told(_application(whole), _application(longer)) == ["always: timeout 5 → 6 s"]
    event = '<state no="1"><expectedevents><event name="e">{}</event></expectedevents></state>'
    when = '<when><data tag="a" in=\'[1, "b"]\' within="2"/></when>'
    assert _told(_application(event.format("")), _application(event.format(when))) == [
        "state 1, event e: guard a is one of 1, b, within 2 s added"
    ]


def test_where_a_timeout_or_a_situation_leads_and_a_start_that_is_written_out() -> None:
    after = _pills().replace('<timeout next="2">', '<timeout next="1">')
    assert _told(_pills(), after) == ["state Take pills: timeout leads to 2 done → 1 Take pills"]
    ends = {"#again": "the same state anew", "#back": "back"}
    for target, told in ends.items():
        after = _pills().replace('<timeout next="2">', f'<timeout next="{target}">')
        assert _told(_pills(), after) == [f"state Take pills: timeout leads to 2 done → {told}"]
    other = SCRIPT.replace(' extends="a"', "")
    assert _told(SCRIPT, other) == ["situation b: extends a → none"]
    (change,) = compare(
        _read(_pills()), _read(_pills().replace("<application", "<application start='1'"))
    )
    assert (change.behaviour, change.text[:14]) == (False, "the same start")


def test_a_test_of_another_tag() -> None:
    before = _pills(events='<event name="e"><when><data tag="a" is="1"/></when></event>')
    assert _told(before, before.replace('tag="a"', 'tag="b"')) == [
        "state Take pills, event e, guard: a is 1 → b is 1"
    ]


def test_what_leads_to_a_number_that_is_another_state_now() -> None:
    back = '<event name="b" next="1"/>'
    state = '<state no="{}"><expectedevents><event name="{}"/>{}</expectedevents></state>'
    before = _application(state.format(1, "a", "") + state.format(2, "c", back))
    after = _application(
        state.format(1, "new", "") + state.format(3, "a", "") + state.format(2, "c", back)
    )
    assert "state 2, event b: leads to another 1" in _told(before, after)


def test_module_information() -> None:
    before = """<modules><module name="m" resources=""><description>Old</description>
<requires data="a"/><requires module="k"/><provides data="b" type="number"/></module></modules>"""
    after = """<modules><module name="m" resources="head"><description>New</description>
<provides data="b" type="text"/><provides data="c"/></module><module name="n" resources=""/>
</modules>"""
    changes = compare(_read(before), _read(after))
    assert [(c.text, c.behaviour) for c in changes] == [
        ("module n: added", True),
        ("module m: resources none → head", True),
        ("module m: description “Old” → “New”", False),
        ("module m: need of data a gone", True),
        ("module m: need of module k gone", True),
        ("module m: provided data c added", True),
        ("module m, provided data b: type number → text", True),
    ]
    assert _told(SCRIPT, SCRIPT.replace('<module name="m" resources="head"/>', "")) == [
        "module m (head) gone"
    ]
    observed = SCRIPT.replace(
        "<modules>", '<observe><data tag="x" unit="m"/></observe><modules>', 1
    )
    assert _told(SCRIPT, observed) == ["data x added"]
    assert _told(observed, observed.replace('unit="m"', 'unit="cm"')) == ["data x: unit m → cm"]
    assert _told(observed, observed.replace('unit="m"', "")) == ["data x: unit “m” gone"]


# -- projects ----------------------------------------------------------------


def _project(**more: Any) -> Project:
    document = _read(_pills())
    given: dict[str, Any] = {
        "root": ".", "name": "p", "toml": "situ.toml", "applications": {"a.rbd.xml": document},
        "spds_file": "s.spds.xml", "spds": _read(SCRIPT), "languages": ("en", "ja"),
        "texts": {"ja": {"Now": "今"}}, "tags": {"a": 1}, "places": {"lobby": (1.0, 2.0, 0.0)},
        "private": ("user.**",), "settings": (Setting("a", "A"),), "durable": ("a",),
        "mqtt": Mqtt("mqtt://here", {"x": "event:y"}),
    }  # fmt: skip
    return Project(**{**given, **more})


@pytest.mark.parametrize(
    ("more", "told", "behaviour"),
    [
        ({"name": "q"}, "project's name “p” → “q”", False),
        ({"languages": ("ja", "en")}, "order of languages en, ja → ja, en", True),
        ({"languages": ("en",)}, "language ja gone", True),
        ({"texts": {"ja": {"Now": "いま"}}}, "in ja, “Now”: “今” → “いま”", True),
        ({"tags": {"a": True}}, "tag at the start a 1 → yes", True),
        ({"tags": {"a": 1, "b": [2]}}, "tag at the start b added: [2]", True),
        ({"places": {}}, "place lobby gone, was [1.0, 2.0, 0.0]", True),
        ({"private": ()}, "private tags user.** gone", True),
        ({"durable": ("a", "b")}, "durable tags b added", True),
        ({"settings": ()}, "setting a gone", True),
        ({"settings": (Setting("a", "B"),)}, "setting a: label “A” → “B”", False),
        (
            {"settings": (Setting("a", "A", "text", ("b", "c")),)},
            "setting a: choices “” → “b, c”",
            True,
        ),
        ({"media": "pictures"}, "folder of media none → “pictures”", True),
        ({"announce": False}, "announced in the network yes → no", False),
        ({"adapter": "ros2"}, "adapter “sim” → “ros2”", True),
        ({"mqtt": Mqtt("mqtt://here", {})}, "mqtt x gone, was “event:y”", True),
        ({"applications": {}}, "application a gone", True),
        ({"spds": None, "spds_file": None}, "s.spds.xml gone", True),
        (
            {"spds": _read(SCRIPT), "spds_file": "t.spds.xml"},
            "its file is t.spds.xml, was s.spds.xml",
            False,
        ),
        ({"modules": _read("<modules/>"), "modules_file": "m.xml"}, "m.xml added", True),
        (
            {"texts": {"ja": {"Now": "今", "New": "新" * 61}}},
            f"in ja, “New”: none → “{'新' * 59}…”",
            True,
        ),
        ({"parts": {"p.rbd.xml": _read(_pills())}}, "part a added", True),
        (
            {"applications": {"b.rbd.xml": _read(_pills())}},
            "application a: its file is b.rbd.xml, was a.rbd.xml",
            False,
        ),
    ],
)
def test_projects(more: dict[str, Any], told: str, behaviour: bool) -> None:
    (change,) = compare(_project(), _project(**more))
    assert (change.text, change.behaviour) == (told, behaviour)


def test_parts_and_texts_that_stayed_or_changed_where_it_can_not_be_seen() -> None:
    part, other = _read(_pills()), _read(_pills(seconds="60"))
    before = _project(parts={"p": part})
    assert compare(before, _project(parts={"p": _read(_pills())})) == []
    (change,) = compare(before, _project(parts={"p": other}))
    assert (change.file, change.text) == ("p", "state Take pills: timeout 30 → 60 s")
    long = "a" * 70
    before = _project(texts={"ja": {"Now": long}})
    (change,) = compare(before, _project(texts={"ja": {"Now": long + "b"}}))
    assert change.text == f"in ja, “Now”: {long} → {long}b"


DAY = """<application name="day"><state no="1" name="hall"/>
  <state no="2" name="ask"><backgroundactions><speech>Who?</speech></backgroundactions>
  <expectedevents><event name="ok" next="3"/></expectedevents></state>
  <state no="3" name="thanks"><backgroundactions><speech>Thanks</speech></backgroundactions>
  <expectedevents><event name="ok" next="1"/></expectedevents></state></application>"""
WITH_PART = """<application name="day"><state no="1" name="hall"/>
  <state no="2" name="learn"><flow src="ask.rbd.xml"/></state></application>"""
ASK = """<application name="ask">
  <state no="a" name="ask"><backgroundactions><speech>Who?</speech></backgroundactions>
  <expectedevents><event name="ok" next="b"/></expectedevents></state>
  <state no="b" name="thanks"><backgroundactions><speech>Thanks</speech></backgroundactions>
  <expectedevents><event name="ok" next="end"/></expectedevents></state>
  <state no="end" final="true"/></application>"""


def _days(text: str, **parts: str) -> Project:
    read = {f"{name}.rbd.xml": _read(part) for name, part in parts.items()}
    return _project(applications={"day.rbd.xml": _read(text)}, parts=read)


def _lines(before: Project, after: Project) -> list[str]:
    return [f"{change.file}: {change.text}" for change in compare(before, after)]


def test_states_that_went_into_a_part_are_told_as_that_and_so_is_the_way_back() -> None:
    before, after = _days(DAY), _days(WITH_PART, ask=ASK)
    assert _lines(before, after) == [
        "day.rbd.xml: state 2 ask: now in ask.rbd.xml, as a ask",
        "day.rbd.xml: state 3 thanks: now in ask.rbd.xml, as b thanks",
        "day.rbd.xml: state learn: added, runs the part ask.rbd.xml",
        "ask.rbd.xml: part ask added",
    ]
    assert _lines(after, before) == [
        "day.rbd.xml: state learn: gone, ran the part ask.rbd.xml",
        "ask.rbd.xml: part ask gone",
        "ask.rbd.xml: state a ask: now in day.rbd.xml, as 2 ask",
        "ask.rbd.xml: state b thanks: now in day.rbd.xml, as 3 thanks",
    ]


def test_a_state_that_is_gone_or_new_is_told_where_its_like_stands_in_no_other_file() -> None:
    more = ASK.replace("</application>", '<state no="c" name="again"/></application>')
    assert _lines(_days(WITH_PART, ask=more), _days(WITH_PART, ask=ASK)) == [
        "ask.rbd.xml: state again: gone"
    ]
    assert _lines(_days(WITH_PART, ask=ASK), _days(WITH_PART, ask=more)) == [
        "ask.rbd.xml: state again: added"
    ]


def test_a_part_in_a_file_of_another_name_is_the_same_part() -> None:
    renamed = WITH_PART.replace("ask.rbd.xml", "who.rbd.xml")
    changes = compare(_days(WITH_PART, ask=ASK), _days(renamed, who=ASK))
    assert [(change.file, change.text, change.behaviour) for change in changes] == [
        ("day.rbd.xml", "state learn: part ask.rbd.xml → who.rbd.xml", True),
        ("who.rbd.xml", "part ask: its file is who.rbd.xml, was ask.rbd.xml", False),
    ]


def test_a_guard_that_reads_the_same_is_told_as_it_stands_in_the_file() -> None:
    guard = '<data tag="t" is="1"/>'
    text = '<application name="a"><state no="1"><expectedevents><event name="e"><when>{}</when>'
    text += "</event></expectedevents></state></application>"
    changes = compare(_read(text.format(guard)), _read(text.format(f"<all>{guard}</all>")))
    assert [change.text for change in changes] == [
        'state 1, event e: guard t is="1" → all(t is="1")'
    ]


def test_a_number_that_was_not_written_before() -> None:
    at = 'id="i" x="1" y="1" width="9" height="9"'
    text = f'<application name="a"><state no="1"><screen><components><text {at}{{}}>Hi</text>'
    text += "</components></screen></state></application>"
    before, after = _read(text.format("")), _read(text.format(' size="9"'))
    assert [change.text for change in compare(before, after)] == [
        "state 1, text i: text size now 9"
    ]


def test_a_component_of_another_kind_is_another_component() -> None:
    at = 'x="1" y="1" width="9" height="9"'
    screen = f'<application name="a"><state no="1"><screen><components>{{}} id="i" {at}'
    button = screen.format("<button") + "/></components></screen></state></application>"
    image = screen.format("<image") + ' src="a.png"/></components></screen></state></application>'
    changes = compare(_read(button), _read(image))
    assert [change.kind for change in changes] == ["gone", "new"]


def test_a_document_alone_is_compared_without_what_only_a_project_has() -> None:
    alone = Project(root=".", name="q", applications={"other.rbd.xml": _read(_pills(seconds="9"))})
    before = Project(root=".", name="p", applications={"a.rbd.xml": _read(_pills())})
    assert [c.text for c in compare(before, alone)] == ["state Take pills: timeout 30 → 9 s"]
    assert compare(_read(SCRIPT), _read(_pills()))[0].text == "a script → an application"


def test_the_order_of_applications_counts() -> None:
    a, b = _read(_pills()), _read(_pills().replace('name="a"', 'name="b"'))
    before = _project(applications={"a": a, "b": b})
    (change,) = compare(before, _project(applications={"b": b, "a": a}))
    assert (change.text, change.behaviour) == ("application b now comes first", True)
    assert compare(before, _project(applications={"a": a, "b": b})) == []


# -- the command -------------------------------------------------------------


def _saved(folder: Path, text: str) -> str:
    folder.mkdir(exist_ok=True)
    file = folder / "a.rbd.xml"
    file.write_text(text, encoding="utf-8")
    return str(file)


def test_exit_0_where_nothing_differs_or_things_only_moved(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    one = _saved(tmp_path / "one", _pills())
    namespace = 'xmlns:ed="urn:situ:editor" name="a"'
    moved = _pills().replace('name="a"', namespace).replace('no="2"', 'no="2" ed:x="1" ed:y="2"')
    two = _saved(tmp_path / "two", moved)
    assert main(["diff", one, one]) == 0
    assert capsys.readouterr().out == "No differences.\n"
    assert main(["diff", one, two]) == 0
    assert capsys.readouterr().out.splitlines() == [
        "The robot acts the same; only what people see of the project changed:",
        "state done: moved in the drawing",
    ]


def test_exit_1_where_the_robot_may_act_differently(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    one, two = (_saved(tmp_path / n, _pills(seconds=n)) for n in ("30", "60"))
    assert main(["diff", one, two]) == 1
    assert capsys.readouterr().out == "state Take pills: timeout 30 → 60 s\n"
    assert main(["diff", "--json", one, two]) == 1
    out = capsys.readouterr().out
    assert '"place": [\n      "state",\n      "1",\n      "timeout"\n    ]' in out
    assert '"behaviour": true' in out


@pytest.mark.parametrize("broken", [None, "<application", "<application name='a'><stat/>"])
def test_exit_2_where_one_can_not_be_read(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], broken: str | None
) -> None:
    one = _saved(tmp_path / "one", _pills())
    two = str(tmp_path / "none") if broken is None else _saved(tmp_path / "two", broken)
    assert main(["diff", one, two]) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.count("\n") == 1


def test_many_moved_things_are_summed_up(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    states = "".join(f'<state no="{n}" ed:x="{{x}}" ed:y="1"/>' for n in range(5))
    text = f'<application name="a" xmlns:ed="urn:situ:editor">{states}</application>'
    one, two = (_saved(tmp_path / x, text.format(x=x)) for x in ("1", "2"))
    assert main(["diff", one, two]) == 0
    assert capsys.readouterr().out.splitlines()[1:] == ["5 things moved in the drawing"]


def test_media_without_a_folder_or_that_can_not_be_read(tmp_path: Path) -> None:
    (tmp_path / "media").mkdir()
    (tmp_path / "media" / "a.png").symlink_to(tmp_path / "nowhere")
    whole = Project(root=str(tmp_path), name="p", toml="situ.toml", media="media")
    bare = Project(root=str(tmp_path), name="p", toml="situ.toml")
    assert [c.text for c in compare_media(bare, whole)] == ["media a.png added"]
    assert compare_media(bare, Project(root=".", name="p")) == []
    with pytest.raises(UsageError, match="cannot be read"):
        compare_media(whole, whole)


def test_media_with_other_content_are_told(tmp_path: Path) -> None:
    projects = []
    for name, content in (("one", b"1"), ("two", b"2")):
        folder = tmp_path / name
        (folder / "media").mkdir(parents=True)
        (folder / "media" / "a.png").write_bytes(content)
        (folder / "media" / f"{name}.png").write_bytes(content)
        (folder / "media" / "same.png").write_bytes(b"same")
        (folder / "a.rbd.xml").write_text(_pills(), encoding="utf-8")
        text = '[project]\nname = "p"\napplications = ["a.rbd.xml"]\nmedia = "media"\n'
        (folder / "situ.toml").write_text(text, encoding="utf-8")
        projects.append(str(folder))
    assert main(["diff", *projects]) == 1
    loaded = [load(path)[0] for path in projects]
    assert loaded[0] is not None
    assert loaded[1] is not None
    assert [c.text for c in compare_media(loaded[0], loaded[1])] == [
        "media a.png has other content",
        "media one.png gone",
        "media two.png added",
    ]
