"""formats.md, *Values, references, conditions*: conditions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any
from xml.sax.saxutils import quoteattr

import pytest

if TYPE_CHECKING:
    from tests.decide.conftest import Play, Trace

END: dict[str, Any] = {"at": 100, "end": True}
MISSING = object()


def holds(play: Play, condition: str, value: object, **tags: Any) -> bool:
    """Whether the condition holds at 0, the tag ``x`` having the value."""
    given = tags if value is MISSING else {"x": value, **tags}
    rbd = (
        f'<state no="1"><expectedevents><event next="2"><when>{condition}</when></event>'
        '</expectedevents></state><state no="2"/>'
    )
    return play(rbd, [], tags=given).states()[-1][1] == "2"


def script(condition: str) -> str:
    return (
        f'<situation name="a"><condition>{condition}</condition></situation><situation name="b"/>'
    )


def watched(play: Play, condition: str, lines: list[dict[str, Any]], **tags: Any) -> Trace:
    """The run of a script with the situation ``a`` where the condition holds, else ``b``."""
    return play((), [*lines, END], spds=script(condition), tags=tags)


def changes(play: Play, condition: str, lines: list[dict[str, Any]], **tags: Any) -> list[float]:
    """The times at which the condition changed, beginning with false."""
    return [e["t"] for e in watched(play, condition, lines, **tags).of("condition")]


# -- tests -------------------------------------------------------------------


@pytest.mark.parametrize(
    ("test", "value", "expected"),
    [
        # is: equal, deeply; numbers by value.
        ('is="1"', 1, True),
        ('is="1"', 1.0, True),
        ('is="1.0"', 1, True),
        ('is="1"', 2, False),
        ('is="1"', True, False),
        ('is="true"', True, True),
        ('is="true"', 1, False),
        ('is="0"', False, False),
        ('is="false"', False, True),
        ('is="[1, 2]"', [1.0, 2], True),
        ('is="[1, 2]"', [1, True], False),
        ('is="[1]"', [1, 2], False),
        ("""is='{"a": [1]}'""", {"a": [1.0]}, True),
        ("""is='{"a": 1}'""", {"a": 1, "b": 2}, False),
        ("""is='{"a": true}'""", {"a": 1}, False),
        # A string value also equals the test's text as written.
        ('is="Ann"', "Ann", True),
        ('is="Ann"', "ann", False),
        ("""is='"Ann"'""", "Ann", True),
        ("""is='"Ann"'""", '"Ann"', True),
        ('is="1"', "1", True),
        ('is="1.0"', "1.0", True),
        ('is="1.0"', "1", False),
        ('is="true"', "true", True),
        ('is="null"', "null", True),
        ('is="null"', MISSING, False),
        ('is=""', "", True),
        ('is=""', MISSING, False),
        # isnot is the opposite, so it holds on a missing tag.
        ('isnot="1"', 1.0, False),
        ('isnot="1"', "1", False),
        ('isnot="1"', True, True),
        ('isnot="1"', 2, True),
        ('isnot="1"', MISSING, True),
        # in: equals one member.
        ("in='[1, \"a\"]'", 1.0, True),
        ("in='[1, \"a\"]'", "a", True),
        ("in='[1, \"a\"]'", "1", False),
        ("in='[1, \"a\"]'", True, False),
        ("in='[1, \"a\"]'", MISSING, False),
        ("in='[[1]]'", [1], True),
        ("in='[]'", 1, False),
        ("in='[null]'", MISSING, False),
        # The four orders.
        ('above="1.5"', 2, True),
        ('above="1.5"', 1.5, False),
        ('atleast="1.5"', 1.5, True),
        ('atleast="1.5"', 1, False),
        ('below="1.5"', 1, True),
        ('below="1.5"', 1.5, False),
        ('atmost="1.5"', 1.5, True),
        ('atmost="1.5"', 2, False),
        ('above="1"', "2", False),
        ('above="1"', True, False),
        ('above="0"', True, False),
        ('above="1"', MISSING, False),
        ('below="1"', MISSING, False),
        ('above="08:00"', "08:01", True),
        ('above="08:00"', "08:00", False),
        ('atleast="08:00"', "08:00", True),
        ('below="08:00"', "07:59", True),
        ('atmost="08:00"', "10:00", False),
        ('above="08:00"', 9, False),
        ('above="Z"', "a", True),
        ('above="a"', "Z", False),
        ('above="z"', "é", True),
        ('above="a"', ["b"], False),
        # exists.
        ('exists="true"', 0, True),
        ('exists="true"', False, True),
        ('exists="true"', MISSING, False),
        ('exists="false"', MISSING, True),
        ('exists="false"', "", False),
    ],
)
def test_what_a_test_holds_of(play: Play, test: str, value: object, expected: bool) -> None:
    assert holds(play, f'<data tag="x" {test}/>', value) is expected
    # The same in a script.
    tags = {} if value is MISSING else {"x": value}
    first = play((), [], spds=script(f'<data tag="x" {test}/>'), tags=tags)
    assert first.situations() == [(0, "a" if expected else "b")]


@pytest.mark.parametrize(
    ("test", "value", "other", "expected"),
    [
        ('is="{y}"', 1, 1.0, True),
        ('is="{y}"', "1", 1, False),
        ('is="{y}"', {"a": [1]}, {"a": [1]}, True),
        ('is="{y}"', "{y}", "z", False),
        ('isnot="{y}"', 1, 2, True),
        ('isnot="{y}"', 1, 1.0, False),
        ('above="{y}"', 2, 1, True),
        ('above="{y}"', "b", "a", True),
        ('above="{y}"', "10", "9", False),
        ('above="{y}"', 2, "1", False),
        ('above="{y}"', "2", 1, False),
        ('above="{y}"', True, False, False),
        ('atmost="{y}"', 2, 2, True),
        ('below="{y.limit}"', 2, {"limit": 3}, True),
        ('in="{y}"', 2, [1, 2], True),
        ('in="{y}"', 2, 2, False),
        # A missing one makes every test but isnot false.
        ('is="{y}"', 1, MISSING, False),
        ('is="{y}"', MISSING, 1, False),
        ('is="{y}"', MISSING, MISSING, False),
        ('in="{y}"', 1, MISSING, False),
        ('above="{y}"', 1, MISSING, False),
        ('below="{y}"', MISSING, 1, False),
        ('isnot="{y}"', 1, MISSING, True),
        ('isnot="{y}"', MISSING, 1, True),
        ('isnot="{y}"', MISSING, MISSING, True),
    ],
)
def test_a_test_may_be_one_reference(
    play: Play, test: str, value: object, other: object, expected: bool
) -> None:
    tags = {} if other is MISSING else {"y": other}
    assert holds(play, f'<data tag="x" {test}/>', value, **tags) is expected


def test_the_value_referred_to_is_followed_too(play: Play) -> None:
    rbd = (
        '<state no="1"><expectedevents><event next="2"><when><data tag="x" above="{y}"/></when>'
        '</event></expectedevents></state><state no="2"/>'
    )
    trace = play(rbd, [{"at": 1, "set": {"y": 1}}], tags={"x": 2, "y": 3})
    assert trace.lines("transition") == ["1 transition app 1 2 - <data"]


def test_a_test_looks_into_values(play: Play) -> None:
    assert holds(play, '<data tag="x.0.name" is="Ann"/>', [{"name": "Ann"}])
    assert not holds(play, '<data tag="x.1.name" exists="true"/>', [{"name": "Ann"}])


# -- groups ------------------------------------------------------------------

YES, NO = '<data tag="x" is="1"/>', '<data tag="x" is="2"/>'


@pytest.mark.parametrize(
    ("condition", "expected"),
    [
        (YES + YES, True),
        (YES + NO, False),
        (f"<all>{YES}{YES}</all>", True),
        (f"<all>{YES}{NO}</all>", False),
        (f"<any>{NO}{YES}</any>", True),
        (f"<any>{NO}{NO}</any>", False),
        (f"<none>{NO}{NO}</none>", True),
        (f"<none>{NO}{YES}</none>", False),
        (f"<none>{YES}</none>", False),
        (f"<none><any>{NO}<all>{YES}{NO}</all></any></none>", True),
        (f"<any><none>{YES}</none><all>{YES}<any>{NO}{YES}</any></all></any>", True),
        (f"{YES}<any>{NO}{NO}</any>", False),
    ],
)
def test_groups_hold_over_any_mix(play: Play, condition: str, expected: bool) -> None:
    assert holds(play, condition, 1) is expected
    first = play((), [], spds=script(condition), tags={"x": 1})
    assert first.situations() == [(0, "a" if expected else "b")]


# -- within ------------------------------------------------------------------

CALLED = '<data tag="x" is="true" within="3"/>'


def test_within_ends_so_long_after_the_tag_was_last_set(play: Play) -> None:
    assert changes(play, CALLED, [{"at": 1, "set": {"x": True}}]) == [1, 4]


def test_within_counts_from_a_set_with_the_same_value_too(play: Play) -> None:
    lines = [{"at": t, "set": {"x": True}} for t in (1, 3, 5.5)]
    assert changes(play, CALLED, lines) == [1, 8.5]


def test_within_has_ended_at_the_moment_itself(play: Play) -> None:
    # At 4 the end comes first, then the set.
    lines = [{"at": 1, "set": {"x": True}}, {"at": 4, "set": {"x": True}}]
    assert changes(play, CALLED, lines) == [1, 4, 4, 7]


def test_the_end_of_within_changes_nothing_where_nothing_is_left_to_count_from(play: Play) -> None:
    test = '<data tag="x.y" is="1" within="3"/>'
    lines = [{"at": 1, "set": {"x": {"y": 1}}}, {"at": 2, "set": {"x": None}}]
    assert changes(play, test, lines) == [1, 2]


def test_the_end_of_within_is_caused_by_the_data_that_began_it(play: Play) -> None:
    lines = [{"at": t, "set": {"x": True}} for t in (1, 3)]
    assert watched(play, CALLED, lines).lines(since=1) == [
        "1 data x true scenario v1 <-",
        "1 condition a true <data",
        "1 situation b a <condition",
        "3 data x true scenario v2 <-",
        "6 condition a false <data",
        "6 situation a b <condition",
    ]


def test_within_needs_the_test_to_hold(play: Play) -> None:
    lines = [{"at": 1, "set": {"x": True}}, {"at": 2, "set": {"x": False}}]
    assert changes(play, CALLED, lines) == [1, 2]


def test_within_of_a_tag_that_was_never_set_does_not_hold(play: Play) -> None:
    assert changes(play, '<data tag="x" isnot="1" within="3"/>', [{"at": 5, "set": {"x": 2}}]) == [
        5, 8,
    ]  # fmt: skip


def test_a_deletion_is_a_set_that_within_counts_from(play: Play) -> None:
    gone = '<data tag="x" exists="false" within="3"/>'
    assert changes(play, gone, [{"at": 1, "set": {"x": None}}], x=1) == [1, 4]


def test_within_counts_from_the_tag_that_a_name_reads(play: Play) -> None:
    near = '<data tag="face.size" above="1" within="2"/>'
    assert changes(play, near, [{"at": 1, "set": {"face": {"size": 2}}}]) == [1, 3]


def test_a_deleted_tag_gives_way_to_the_shorter_one_that_a_name_reads(play: Play) -> None:
    """``face.size`` is then a field of ``face``, which was set long ago."""
    near = '<data tag="face.size" above="1" within="3"/>'
    lines: list[dict[str, Any]] = [
        {"at": 1, "set": {"face": {"size": 2}}},
        {"at": 6, "set": {"face.size": 3}},
        {"at": 7, "set": {"face.size": None}},
    ]
    assert changes(play, near, lines) == [1, 4, 6, 7]


def test_within_under_none_comes_to_hold_when_it_ends(play: Play) -> None:
    quiet = f"<none>{CALLED}</none>"
    assert changes(play, quiet, [{"at": 1, "set": {"x": True}}]) == [0, 1, 4]


def test_within_counts_from_the_tags_of_the_project_too(play: Play) -> None:
    assert changes(play, CALLED, [], x=True) == [0, 3]


def test_ends_at_one_moment_are_judged_together(play: Play) -> None:
    """At that moment neither holds any longer: ``b`` is never current."""
    spds = f"""<situation name="a"><condition>{CALLED}</condition></situation>
      <situation name="b"><condition>{CALLED}</condition></situation><situation name="c"/>"""
    trace = play((), [{"at": 1, "set": {"x": True}}, END], spds=spds)
    assert trace.lines("condition", "situation", since=1) == [
        "1 condition a true <data",
        "1 condition b true <data",
        "1 situation c a <condition^1",
        "4 condition a false <data",
        "4 condition b false <data",
        "4 situation a c <condition^1",
    ]


# -- for ---------------------------------------------------------------------

STEADY = '<data tag="x" is="true" for="2"/>'


def test_for_holds_when_the_test_has_held_so_long(play: Play) -> None:
    lines = [{"at": 1, "set": {"x": True}}, {"at": 5, "set": {"x": False}}]
    assert watched(play, STEADY, lines).lines(since=1) == [
        "1 data x true scenario v1 <-",
        "3 condition a true <data",
        "3 situation b a <condition",
        "5 data x false scenario v2 <-",
        "5 condition a false <data",
        "5 situation a b <condition",
    ]


def test_a_write_that_keeps_the_test_true_does_not_break_for(play: Play) -> None:
    lines = [{"at": t, "set": {"x": True}} for t in (1, 2, 2.5)]
    assert changes(play, STEADY, lines) == [3]


def test_every_write_can_break_for(play: Play) -> None:
    lines = [{"at": 1, "set": {"x": True}}, {"at": 2, "set": {"x": 0}}]
    assert changes(play, STEADY, lines) == []
    lines.append({"at": 2, "set": {"x": True}})
    assert changes(play, STEADY, lines) == [4]


def test_two_writes_in_one_step_break_for_too(play: Play) -> None:
    rbd = (
        '<state no="1"><timeout next="2">4</timeout><expectedevents><event name="blink">'
        '<set tag="x">false</set><set tag="x">true</set></event></expectedevents></state>'
        '<state no="2"><expectedevents><event next="3"><when><data tag="x" is="true" for="3"/>'
        '</when></event></expectedevents></state><state no="3"/>'
    )
    lines = [{"at": 1, "set": {"x": True}}, {"at": 3, "event": "blink"}, END]
    assert play(rbd, lines).states() == [(0, "1"), (4, "2"), (6, "3")]


def test_the_tags_of_one_set_are_one_write(play: Play) -> None:
    rbd = (
        '<state no="1"><expectedevents><event next="2"><when><data tag="x" above="{y}" for="2"/>'
        '</when></event></expectedevents></state><state no="2"/>'
    )
    lines = [{"at": 1, "set": {"x": 1, "y": 0}}, {"at": 2, "set": {"y": 5, "x": 6}}, END]
    assert play(rbd, lines).states() == [(0, "1"), (3, "2")]


def test_for_is_followed_from_the_start_whatever_state_is_current(play: Play) -> None:
    rbd = (
        '<state no="1"><timeout next="2">9</timeout></state><state no="2"><expectedevents>'
        '<event next="3"><when><data tag="x" exists="false" for="5"/></when></event>'
        '</expectedevents></state><state no="3"/>'
    )
    trace = play(rbd, [END])
    assert trace.states() == [(0, "1"), (9, "2"), (9, "3")]
    # Also where it is an answer's guard.
    rbd = rbd.replace('event next="3"', 'event name="go" next="3"')
    assert play(rbd, [{"at": 9, "event": "go"}, END]).states()[-1] == (9, "3")
    rbd = rbd.replace("9", "4")
    assert play(rbd, [{"at": 4.5, "event": "go"}, END]).states()[-1] == (4, "2")


def test_for_with_within_needs_both(play: Play) -> None:
    both = '<data tag="x" is="true" within="3" for="2"/>'
    assert changes(play, both, [{"at": 1, "set": {"x": True}}]) == [3, 4]
    lines = [{"at": t, "set": {"x": True}} for t in (1, 2, 3)]
    assert changes(play, both, lines) == [3, 6]


def test_for_under_none_holds_until_the_time_is_over(play: Play) -> None:
    assert changes(play, f"<none>{STEADY}</none>", [{"at": 1, "set": {"x": True}}]) == [0, 3]


def test_within_ends_and_for_begins_at_one_moment_together(play: Play) -> None:
    lines = [{"at": 1, "set": {"x": True}}]
    both = '<any><data tag="x" is="true" within="2"/><data tag="x" is="true" for="2"/></any>'
    assert changes(play, both, lines) == [1]


# -- the rest ----------------------------------------------------------------


def test_a_condition_that_stays_is_not_traced(play: Play) -> None:
    trace = watched(play, '<data tag="x" above="1"/>', [{"at": 1, "set": {"x": 3}}], x=2)
    assert trace.lines(since=1) == ["1 data x 3 scenario v2 <-"]


def test_of_several_tags_of_one_set_the_last_is_the_cause(play: Play) -> None:
    both = '<data tag="x" is="1"/><data tag="y" is="1"/>'
    trace = watched(play, both, [{"at": 1, "set": {"y": 1, "x": 1, "z": 1}}])
    assert trace.lines("condition") == ["1 condition a true <data^1"]


def test_a_condition_may_look_at_what_the_runtime_keeps(play: Play) -> None:
    rbd = (
        '<state no="1"><expectedevents><event name="go" next="2"/></expectedevents></state>'
        '<state no="2"/>'
    )
    spds = """<modules><module name="app" resources=""/></modules>
      <situation name="a"><condition><data tag="application/app.state" is="2"/></condition>
      </situation><situation name="b"><module name="app" priority="1"/></situation>"""
    trace = play(rbd, [{"at": 1, "event": "go"}], spds=spds)
    assert trace.lines("condition", "situation", since=1) == [
        "1 condition a true <enter",
        "1 situation b a <condition",
    ]


@pytest.mark.parametrize("value", ["__import__('os')", "{x}", "1+1", "$x"])
def test_a_file_never_runs_code_by_being_read(play: Play, value: str) -> None:
    """Nothing but the value itself is compared."""
    test = f'<data tag="x" is={quoteattr(value)}/>'
    assert holds(play, test, 2) is (value == "{x}")  # one reference: itself
    assert holds(play, test, value)
