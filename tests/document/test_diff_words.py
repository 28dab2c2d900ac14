"""What tells two documents apart, in plain words: each difference is one line."""

from __future__ import annotations

import pytest
from tests.document.described import EVENTS, SCRIPT, application, differences, pills, read_document

from situ.document import condition as conditions
from situ.document import rbd
from situ.document.condition import Condition
from situ.document.diff import compare


@pytest.mark.parametrize(
    ("after", "told"),
    [
        (pills(seconds="60"), "state Take pills: timeout 30 → 60 s"),
        (pills(text="Later"), "state Take pills, speech: “Now” → “Later”"),
        (
            pills(events=EVENTS.replace('above="1"', 'above="2.5"')),
            "state Take pills, event no, guard: a above 1 → above 2.5",
        ),
        (
            pills(events=EVENTS.replace('<data tag="b" exists="true"/>', "")),
            "state Take pills, event no: guard a above 1 and b exists → a above 1",
        ),
        (
            pills(events=EVENTS.replace('name="yes" next="2"', 'name="yes" next="1"')),
            "state Take pills, event yes: leads to 2 done → 1 Take pills",
        ),
        (
            pills(events=EVENTS.replace('<event name="yes" next="2"/>', "")),
            "state Take pills: event yes, leads to 2 done gone",
        ),
        (
            pills(events=EVENTS + '<event name="maybe"/>'),
            "state Take pills: event maybe added",
        ),
        (
            pills().replace("<speech>", '<speech bargein="true">'),
            "state Take pills, speech: may be interrupted by speech no → yes",
        ),
        (
            pills().replace("</backgroundactions>", '<clear tag="a"/></backgroundactions>'),
            "state Take pills: clear a added",
        ),
        (pills().replace('name="a"', 'name="b"'), "name a → b"),
        (
            pills().replace("<application", "<application start='2'"),
            "starts in 1 Take pills → 2 done",
        ),
    ],
)  # fmt: skip
def test_a_change_is_one_line_in_plain_words(after: str, told: str) -> None:
    assert differences(pills(), after) == [told]


def test_of_a_long_text_what_differs_is_shown() -> None:
    long = "Good morning, this is a rather long text of which nearly all stays as it is, {}, always"
    (line,) = differences(pills(text=long.format("here")), pills(text=long.format("there")))
    assert "“…all stays as it is, here, always” → “…all stays as it is, there, always”" in line


def test_a_renamed_state_is_known_by_its_number() -> None:
    after = pills().replace("Take pills", "Take tablets")
    assert differences(pills(), after) == ["state Take pills: name “Take pills” → “Take tablets”"]


def test_a_renumbered_state_is_known_by_its_content_and_what_leads_to_it_is_unchanged() -> None:
    after = pills().replace('no="2"', 'no="7"').replace('next="2"', 'next="7"')
    assert differences(pills(), after) == ["state done: number 2 → 7"]


def test_a_state_put_in_before_others_renumbers_them_without_other_changes() -> None:
    states = '<state no="{}"><expectedevents><event name="{}" next="{}"/></expectedevents></state>'
    before = application(states.format(1, "a", 2) + states.format(2, "b", 1))
    after = application(
        states.format(1, "new", 2) + states.format(2, "a", 3) + states.format(3, "b", 2)
    )
    assert set(differences(before, after)) == {
        "state 1: added",
        "state 1: number 1 → 2",
        "state 2: number 2 → 3",
        "starts in 1 → 1",
    }


def test_the_order_of_events_counts_where_they_compete() -> None:
    one, other, same = '<event name="x" next="1"/>', '<event name="y"/>', '<event name="x"/>'
    told = compare(
        read_document(pills(events=one + other)), read_document(pills(events=other + one))
    )
    assert [change.behaviour for change in told] == [False]
    told = compare(read_document(pills(events=one + same)), read_document(pills(events=same + one)))
    assert [(c.behaviour, c.kind) for c in told] == [(True, "order")]
    assert told[0].text == "state Take pills: event x (1) now comes first"


def test_actions_in_another_order_are_behaviour_states_are_not() -> None:
    actions = ["<set tag='a'>1</set>", "<set tag='b'>2</set>", "<set tag='c'>3</set>"]
    state = '<state no="1"><backgroundactions>{}</backgroundactions></state><state no="2"/>'
    before = application(state.format("".join(actions)))
    after = application(state.format("".join(actions[1:] + actions[:1])))
    (change,) = compare(read_document(before), read_document(after))
    assert (change.text, change.behaviour) == ("state 1: set a now comes after set c", True)
    states = ['<state no="1"/>', '<state no="2"/>']
    first, then = (
        f'<application name="a" start="1">{"".join(s)}</application>'
        for s in (states, states[::-1])
    )
    (change,) = compare(read_document(first), read_document(then))
    assert (change.kind, change.behaviour) == ("order", False)


def test_situations_their_order_and_priorities() -> None:
    after = SCRIPT.replace('priority="9"', 'priority="90"')
    assert differences(SCRIPT, after) == ["situation a, priority of m: 9 → 90"]
    after = SCRIPT.replace('name="a"', 'name="first"').replace('extends="a"', 'extends="first"')
    assert differences(SCRIPT, after) == ["situation a: name a → first"]
    a, b = SCRIPT.index('<situation name="a"'), SCRIPT.index('<situation name="b"')
    c = SCRIPT.index('<situation name="c"')
    swapped = SCRIPT[:a] + SCRIPT[b:c] + SCRIPT[a:b] + SCRIPT[c:]
    (change,) = compare(read_document(SCRIPT), read_document(swapped))
    assert change.text == "situation b now comes first"
    assert (change.behaviour, change.place) == (True, ("situation", "b"))
    (change,) = compare(read_document(SCRIPT[:b] + SCRIPT[c:]), read_document(SCRIPT))
    assert change.text == "situation b: added, goes before c"


def test_conditions_of_another_shape_are_told_whole() -> None:
    def guard(inner: str) -> str:
        return pills(events=f'<event name="e"><when>{inner}</when></event>')

    flat = '<data tag="a" is="1"/>'
    grouped = f'<any>{flat}<data tag="b" exists="false"/></any>'
    assert differences(guard(flat), guard(grouped)) == [
        "state Take pills, event e: guard a is 1 → a is 1 or b is missing"
    ]
    other = grouped.replace('is="1"', 'is="2" for="0.5"')
    (change,) = compare(read_document(guard(grouped)), read_document(guard(other)))
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
    before, after = application(MORE), application(MORE.replace(gone, ""))
    assert differences(before, after) == [f"state x{told}"]
    assert differences(after, before) == [f"state x{told.replace('gone', 'added')}"]


def test_timeouts_screens_guards_and_always_that_came() -> None:
    bare = application('<state no="1"/>')
    came = {
        '<timeout next="1">5</timeout>': "state 1: timeout 5 s, leads to 1 added",
        "<timeout>5</timeout>": "state 1: timeout 5 s added",
        "<screen/>": "state 1: empty screen added",
    }
    for element, told in came.items():
        assert differences(bare, application(f'<state no="1">{element}</state>')) == [told]
    whole = '<always><timeout>5</timeout></always><state no="1"/>'
    assert differences(bare, application(whole)) == ["always added"]
    longer = whole.replace("5", "6")
    assert differences(application(whole), application(longer)) == ["always: timeout 5 → 6 s"]
    event = '<state no="1"><expectedevents><event name="e">{}</event></expectedevents></state>'
    when = '<when><data tag="a" in=\'[1, "b"]\' within="2"/></when>'
    assert differences(application(event.format("")), application(event.format(when))) == [
        "state 1, event e: guard a is one of 1, b, within 2 s added"
    ]


def test_where_a_timeout_or_a_situation_leads_and_a_start_that_is_written_out() -> None:
    after = pills().replace('<timeout next="2">', '<timeout next="1">')
    assert differences(pills(), after) == [
        "state Take pills: timeout leads to 2 done → 1 Take pills"
    ]
    ends = {"#again": "the same state anew", "#back": "back"}
    for target, told in ends.items():
        after = pills().replace('<timeout next="2">', f'<timeout next="{target}">')
        assert differences(pills(), after) == [
            f"state Take pills: timeout leads to 2 done → {told}"
        ]
    other = SCRIPT.replace(' extends="a"', "")
    assert differences(SCRIPT, other) == ["situation b: extends a → none"]
    (change,) = compare(
        read_document(pills()),
        read_document(pills().replace("<application", "<application start='1'")),
    )
    assert (change.behaviour, change.text[:14]) == (False, "the same start")


def test_a_test_of_another_tag() -> None:
    before = pills(events='<event name="e"><when><data tag="a" is="1"/></when></event>')
    assert differences(before, before.replace('tag="a"', 'tag="b"')) == [
        "state Take pills, event e, guard: a is 1 → b is 1"
    ]


def test_what_leads_to_a_number_that_is_another_state_now() -> None:
    back = '<event name="b" next="1"/>'
    state = '<state no="{}"><expectedevents><event name="{}"/>{}</expectedevents></state>'
    before = application(state.format(1, "a", "") + state.format(2, "c", back))
    after = application(
        state.format(1, "new", "") + state.format(3, "a", "") + state.format(2, "c", back)
    )
    assert "state 2, event b: leads to another 1" in differences(before, after)


def test_module_information() -> None:
    before = """<modules><module name="m" resources=""><description>Old</description>
<requires data="a"/><requires module="k"/><provides data="b" type="number"/></module></modules>"""
    after = """<modules><module name="m" resources="head"><description>New</description>
<provides data="b" type="text"/><provides data="c"/></module><module name="n" resources=""/>
</modules>"""
    changes = compare(read_document(before), read_document(after))
    assert [(c.text, c.behaviour) for c in changes] == [
        ("module n: added", True),
        ("module m: resources none → head", True),
        ("module m: description “Old” → “New”", False),
        ("module m: need of data a gone", True),
        ("module m: need of module k gone", True),
        ("module m: provided data c added", True),
        ("module m, provided data b: type number → text", True),
    ]
    assert differences(SCRIPT, SCRIPT.replace('<module name="m" resources="head"/>', "")) == [
        "module m (head) gone"
    ]
    observed = SCRIPT.replace(
        "<modules>", '<observe><data tag="x" unit="m"/></observe><modules>', 1
    )
    assert differences(SCRIPT, observed) == ["data x added"]
    assert differences(observed, observed.replace('unit="m"', 'unit="cm"')) == [
        "data x: unit m → cm"
    ]
    assert differences(observed, observed.replace('unit="m"', "")) == ["data x: unit “m” gone"]


def test_a_guard_that_reads_the_same_is_told_as_it_stands_in_the_file() -> None:
    guard = '<data tag="t" is="1"/>'
    text = '<application name="a"><state no="1"><expectedevents><event name="e"><when>{}</when>'
    text += "</event></expectedevents></state></application>"
    changes = compare(
        read_document(text.format(guard)), read_document(text.format(f"<all>{guard}</all>"))
    )
    assert [change.text for change in changes] == [
        'state 1, event e: guard t is="1" → all(t is="1")'
    ]


def test_a_number_that_was_not_written_before() -> None:
    at = 'id="i" x="1" y="1" width="9" height="9"'
    text = f'<application name="a"><state no="1"><screen><components><text {at}{{}}>Hi</text>'
    text += "</components></screen></state></application>"
    before, after = read_document(text.format("")), read_document(text.format(' size="9"'))
    assert [change.text for change in compare(before, after)] == [
        "state 1, text i: text size now 9"
    ]


def test_a_component_of_another_kind_is_another_component() -> None:
    at = 'x="1" y="1" width="9" height="9"'
    screen = f'<application name="a"><state no="1"><screen><components>{{}} id="i" {at}'
    button = screen.format("<button") + "/></components></screen></state></application>"
    image = screen.format("<image") + ' src="a.png"/></components></screen></state></application>'
    changes = compare(read_document(button), read_document(image))
    assert [change.kind for change in changes] == ["gone", "new"]
